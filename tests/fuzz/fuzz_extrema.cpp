// SPDX-License-Identifier: MIT
// Extrema of scalar splines: what is listed where, and that nothing lies beyond the least and the largest of them.
#include "fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using fuzz::Input;

constexpr uint32_t all_kinds = NURBS_EXTREMUM_MINIMUM | NURBS_EXTREMUM_MAXIMUM | NURBS_EXTREMUM_SADDLE |
                               NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_UNDECIDED;

struct Extrema {
    std::vector<double> params, values, ranges;
    std::vector<int32_t> found;
    int64_t count = 0;
    int32_t complete = -1;

    void make_room(size_t axes) {
        const auto n = static_cast<size_t>(count);
        params.resize(n * axes);
        values.resize(n);
        found.resize(n);
        ranges.resize(2 * n * axes);
    }
};

void check_place(const nurbs *g, const Extrema &e, size_t i, size_t axes) {
    for (size_t k = 0; k < axes; ++k) {
        double domain[2];
        FUZZ_REQUIRE(nurbs_domain(g, static_cast<int32_t>(k), domain) == NURBS_OK);
        const double at = e.params[i * axes + k], lower = e.ranges[2 * (i * axes + k)],
                     upper = e.ranges[2 * (i * axes + k) + 1], period = domain[1] - domain[0],
                     off = 16 * fuzz::eps * std::max(std::abs(domain[0]), std::abs(domain[1]));
        FUZZ_REQUIRE(at >= domain[0] && at <= domain[1] && lower <= upper);
        const auto holds = [&](double t) { return t >= lower - off && t <= upper + off; };
        FUZZ_REQUIRE(holds(at) || holds(at + period) || holds(at - period));
    }
}

void check(const nurbs *g, const Extrema &e, size_t axes) {
    bool undecided = false;
    for (size_t i = 0; i < e.values.size(); ++i) {
        const auto kinds = static_cast<uint32_t>(e.found[i]);
        FUZZ_REQUIRE(kinds != 0 && (kinds & ~all_kinds) == 0);
        undecided = undecided || (kinds & NURBS_EXTREMUM_UNDECIDED) != 0;
        check_place(g, e, i, axes);
        for (size_t k = 0; k < axes && i > 0; ++k) { // in order
            if (e.params[i * axes + k] != e.params[(i - 1) * axes + k]) {
                FUZZ_REQUIRE(e.params[i * axes + k] > e.params[(i - 1) * axes + k]);
                break;
            }
        }
    }
    FUZZ_REQUIRE(e.complete == (undecided ? 0 : 1));
}

// Of a continuous function all values lie between the least and the largest extremum.
void check_values(Input &in, const nurbs *g, const fuzz::Spline &s, const Extrema &e) {
    FUZZ_REQUIRE(!e.values.empty());
    const auto [least, most] = std::minmax_element(e.values.begin(), e.values.end());
    const double off = 4096 * fuzz::accuracy(s.degrees) * fuzz::eps * s.size();
    for (int n = 0; n < 20; ++n) {
        double at[3], value = 0;
        for (int32_t k = 0; k < s.axes32(); ++k) {
            at[k] = fuzz::any_param(in, g, k, true);
        }
        FUZZ_REQUIRE(nurbs_eval(g, 1, at, 0, 0, &value, 0, 0, 0) == NURBS_OK);
        FUZZ_REQUIRE(value >= *least - off && value <= *most + off);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    fuzz::Spline s;
    fuzz::add_axes(in, s, std::min(3, 1 + in.below(5) / 2));
    fuzz::add_values(in, s, in.rarely() ? 2 : 1);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = int64_t{1} << (10 + in.below(16));
    const auto axes = static_cast<size_t>(s.axes());
    const uint32_t kinds = in.rarely() ? static_cast<uint32_t>(in.bits()) : all_kinds;
    Extrema e;
    if (!FUZZ_OK(nurbs_extrema_with(g.get(), kinds, 0, nullptr, nullptr, nullptr, nullptr, &e.count,
                                    &e.complete, &call))) {
        return 0;
    }
    e.make_room(axes);
    FUZZ_REQUIRE(nurbs_extrema_with(g.get(), kinds, e.count, e.params.data(), e.values.data(), e.found.data(),
                                    e.ranges.data(), &e.count, &e.complete, &call) == NURBS_OK);
    if (kinds != all_kinds) {
        return 0;
    }
    check(g.get(), e, axes);
    if (e.complete == 1) {
        int64_t count = -1;
        int32_t complete = -1;
        FUZZ_REQUIRE(nurbs_extrema(g.get(), kinds, 0, nullptr, nullptr, nullptr, nullptr, &count,
                                   &complete) == NURBS_OK);
        FUZZ_REQUIRE(count == e.count && complete == 1);
        if (s.weights.empty()) {
            check_values(in, g.get(), s, e);
        }
    }
    return 0;
}
