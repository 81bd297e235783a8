// SPDX-License-Identifier: MIT
// Roots of scalar curves, and meets of curves with implicit sets, with each other and with themselves.
#include "fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using fuzz::Input;

constexpr int64_t most = 256;

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

void check_pairs(int64_t count, int32_t complete, const double *a, const double *b) {
    FUZZ_REQUIRE(count >= 0 && (complete == 0 || complete == 1));
    FUZZ_REQUIRE(std::is_sorted(a, a + std::min(count, most)));
    for (int64_t i = 0; i < std::min(count, most); ++i) {
        FUZZ_REQUIRE(std::isfinite(a[i]) && std::isfinite(b[i]));
    }
}

// With itself turned around: overlaps, and everything near them.
void pairs(Input &in, const nurbs *g) {
    const double tolerance = std::abs(in.number()) * 0x1p-20;
    double a[most], b[most];
    int64_t count = 0;
    int32_t complete = -1;
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = 2000000;
    nurbs *out = nullptr;
    if (!FUZZ_OK(nurbs_reverse(g, 0, 0, &out))) {
        return;
    }
    const fuzz::Handle other(out);
    if (FUZZ_OK(nurbs_curve_intersections_with(g, other.get(), tolerance, most, a, b, nullptr, nullptr,
                                               nullptr, &count, &complete, &call))) {
        check_pairs(count, complete, a, b);
    }
    if (FUZZ_OK(nurbs_curve_self_intersections_with(g, tolerance, most, a, b, nullptr, nullptr, nullptr,
                                                    &count, &complete, &call))) {
        check_pairs(count, complete, a, b);
        if (complete == 1) {
            FUZZ_REQUIRE(nurbs_curve_self_intersections(g, tolerance, most, a, b, nullptr, nullptr, nullptr,
                                                        &count, &complete) == NURBS_OK);
        }
    }
    call.work = 1;
    FUZZ_OK(nurbs_curve_intersections(g, g, tolerance, 0, nullptr, nullptr, nullptr, nullptr, nullptr, &count,
                                      &complete));
    FUZZ_OK(nurbs_curve_self_intersections_with(g, tolerance, 0, nullptr, nullptr, nullptr, nullptr, nullptr,
                                                &count, &complete, &call));
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
    pairs(in, g.get());
    if (s.degrees[0] <= 9) {
        level(in, g.get(), s.dim);
    }
    return 0;
}
