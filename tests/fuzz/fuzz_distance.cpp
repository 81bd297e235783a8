// Distances of two splines: enclosures in order, points that are as far apart as is said.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

double any_tolerance(Input &in) {
    static constexpr double usual[] = {1e-1, 1e-2, 1e-3, 1e-6};
    return in.rarely() ? in.anything() : usual[in.below(4)];
}

void nearest(Input &in, const nurbs *a, const nurbs *b) {
    double at_least = -1, at_most = -1, first[3], second[3];
    int32_t status = 0;
    if (FUZZ_OK(nurbs_distance(a, b, any_tolerance(in), 1 + in.below(250), &at_least, &at_most, first, second,
                               &status))) {
        FUZZ_REQUIRE(at_least >= 0 && at_least <= at_most && std::isfinite(at_most));
        FUZZ_REQUIRE(status == NURBS_CLOSEST_CERTIFIED || status == NURBS_CLOSEST_BUDGET);
    }
}

void farthest(Input &in, const nurbs *a, const nurbs *b) {
    double at_least[2], at_most[2], first[3], second[3];
    int32_t status = 0;
    if (FUZZ_OK(nurbs_hausdorff_distance(a, b, any_tolerance(in), 1 + in.below(16), at_least, at_most, first,
                                         second, &status))) {
        for (const int side : {0, 1}) {
            FUZZ_REQUIRE(at_least[side] >= 0 && at_least[side] <= at_most[side]);
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline first = fuzz::any_spline(in);
    fuzz::Spline second = fuzz::any_spline(in);
    if (!in.rarely()) {
        second.dim = first.dim;
        second.points.resize(static_cast<size_t>(second.total * second.dim), 0.5);
    }
    second.flags = 0;
    const fuzz::Handle a(fuzz::create(first)), b(fuzz::create(second));
    if (a && b && first.total <= 200 && second.total <= 200) {
        nearest(in, a.get(), b.get());
        farthest(in, a.get(), b.get());
    }
    return 0;
}
