/* SPDX-License-Identifier: MIT */
// The record of all outputs (recorded/), by which builds of the library are compared: it is the same in a
// second run and for handles that were asked before, and another one where the kernels round in another way.
#include "check.h"

#include "recorded/record.h"
#include "recorded/sections.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {

std::string record_of(bool again) {
    std::ostringstream out;
    recorded::Plan plan;
    plan.out = &out;
    plan.quick = true;
    plan.again = again;
    recorded::record.start(plan);
    recorded::record_everything(NURBS_SOURCE_DIR, nullptr, "recorded_outputs_test.igs");
    return out.str();
}

// Prints the first lines that differ.
void check_same(const std::string &a, const std::string &b) {
    std::istringstream left(a), right(b);
    int different = 0;
    for (std::string of_a, of_b; std::getline(left, of_a) && std::getline(right, of_b) && different < 5;) {
        if (of_a != of_b) {
            ++different;
            std::fprintf(stderr, "first: %s\nagain: %s\n", of_a.c_str(), of_b.c_str());
        }
    }
    CHECK(a == b);
}

// The record that this program writes where the processor seems to have no fused multiplication, or nothing if
// it has none.
std::string record_without_fused(const char *program) {
#if defined(__x86_64__) && defined(__GLIBC__)
    if (!__builtin_cpu_supports("avx2")) {
        return {};
    }
    const std::string file = "recorded_outputs_test.unfused";
    setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2", 1);
    CHECK(std::system(('"' + std::string(program) + "\" " + file).c_str()) == 0);
    std::ostringstream record;
    record << std::ifstream(file).rdbuf();
    return record.str();
#else
    (void)program;
    return {};
#endif
}

} // namespace

int main(int count, char **arguments) {
    const std::string first = record_of(false);
    if (count > 1) {
        return (std::ofstream(arguments[1]) << first).flush() ? 0 : 1;
    }
    CHECK(std::count(first.begin(), first.end(), '\n') > 1000);
    check_same(first, record_of(true));
    const std::string other = record_without_fused(arguments[0]);
    if (other.empty() && check_failures == 0) {
        std::puts(
            "all instruction sets of this machine round alike: that differences are noticed is not tested");
        return 77;
    }
    CHECK(first != other);
    return check_summary("recorded outputs");
}
