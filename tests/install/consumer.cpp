// The C++ wrapper as installed: it needs nothing but the C library.
#include <nurbs/nurbs.hpp>

#include <cstdio>

int main() {
    const bool same = libnurbs::version() == libnurbs::header_version;
    try {
        (void)libnurbs::Spline().axes();
    } catch (const libnurbs::Error &error) {
        std::printf("%s: %s\n", error.name(), error.what());
        return same && error.status() == libnurbs::Status::null ? 0 : 1;
    }
    return 1;
}
