/* SPDX-License-Identifier: MIT */
// The record of all outputs (recorded/), by which builds of the library are compared: it is the same in a
// second run and for handles that were asked before, and another one where the kernels round in another way.
#include "check.h"

#include "recorded/record.h"
#include "recorded/sections.h"
#include "support/simd_targets.h"

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

// 0 if all round alike.
int64_t other_target() {
    const std::vector<int64_t> all = targets::offered_targets();
    const auto place = std::find_if(all.begin(), all.end(), [&](int64_t target) {
        return targets::rounding_class(target) != targets::rounding_class(all.front());
    });
    return place == all.end() ? 0 : *place;
}

} // namespace

int main() {
    const std::string first = record_of(false);
    CHECK(std::count(first.begin(), first.end(), '\n') > 1000);
    check_same(first, record_of(true));
    const int64_t other = other_target();
    if (other == 0 && check_failures == 0) {
        std::puts(
            "all instruction sets of this machine round alike: that differences are noticed is not tested");
        return 77;
    }
    targets::choose(other);
    CHECK(first != record_of(false));
    return check_summary("recorded outputs");
}
