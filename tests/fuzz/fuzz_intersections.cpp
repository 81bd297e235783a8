// SPDX-License-Identifier: MIT
// Roots of scalar curves and meets of curves with implicit sets.
#include "fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using fuzz::Input;

struct Hits {
    std::vector<double> params, ranges;
    std::vector<int32_t> kinds;
    int64_t count = 0;
    int32_t complete = -1;

    void make_room() {
        params.resize(static_cast<size_t>(count));
        kinds.resize(params.size());
        ranges.resize(2 * params.size());
    }
    void check(const nurbs *g) const {
        double domain[2];
        FUZZ_REQUIRE(nurbs_domain(g, 0, domain) == NURBS_OK);
        FUZZ_REQUIRE(std::is_sorted(params.begin(), params.end()));
        bool undecided = false;
        for (size_t i = 0; i < params.size(); ++i) {
            FUZZ_REQUIRE(kinds[i] >= NURBS_HIT_CROSSING && kinds[i] <= NURBS_HIT_UNDECIDED);
            FUZZ_REQUIRE(params[i] >= domain[0] && params[i] <= domain[1]);
            FUZZ_REQUIRE(ranges[2 * i] <= ranges[2 * i + 1] && ranges[2 * i] >= domain[0]);
            undecided = undecided || kinds[i] == NURBS_HIT_UNDECIDED;
        }
        FUZZ_REQUIRE(complete == (undecided ? 0 : 1));
    }
};

void roots(Input &in, const nurbs *g) {
    const double value = in.number(), tolerance = std::abs(in.number());
    Hits h;
    if (!FUZZ_OK(nurbs_roots(g, value, tolerance, 0, nullptr, nullptr, nullptr, &h.count, &h.complete))) {
        return;
    }
    h.make_room();
    FUZZ_REQUIRE(nurbs_roots_with(g, value, tolerance, h.count, h.params.data(), h.kinds.data(),
                                  h.ranges.data(), &h.count, &h.complete, nullptr) == NURBS_OK);
    h.check(g);
}

void level(Input &in, const nurbs *g, int32_t dim) {
    const int32_t degree = 1 + static_cast<int32_t>(in.below(3));
    int64_t count = 1;
    for (int32_t i = 1; i <= degree; ++i) {
        count = count * (dim + i) / i;
    }
    std::vector<double> coefficients(static_cast<size_t>(count));
    for (double &c : coefficients) {
        c = in.number();
    }
    const double tolerance = std::abs(in.number());
    Hits h;
    if (!FUZZ_OK(nurbs_curve_level(g, degree, coefficients.data(), tolerance, 0, nullptr, nullptr, nullptr,
                                   &h.count, &h.complete))) {
        return;
    }
    h.make_room();
    FUZZ_REQUIRE(nurbs_curve_level_with(g, degree, coefficients.data(), tolerance, h.count, h.params.data(),
                                        h.kinds.data(), h.ranges.data(), &h.count, &h.complete,
                                        nullptr) == NURBS_OK);
    h.check(g);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g || s.degrees.size() != 1) {
        return 0;
    }
    roots(in, g.get());
    if (s.degrees[0] <= 9) {
        level(in, g.get(), s.dim);
    }
    return 0;
}
