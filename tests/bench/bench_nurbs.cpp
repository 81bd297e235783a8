// This library, through its C interface, as a user calls it.
#include "bench/nurbs_work.h"

namespace {

bool offers(const bench::Job &) {
    return true;
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(argc, argv, {{"nurbs", offers, bench::nurbs_work}}, 1.0);
}
