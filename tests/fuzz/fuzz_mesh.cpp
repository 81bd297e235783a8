// SPDX-License-Identifier: MIT
// Polylines in place of curves: vertices are points of the curve in order, and no point of it is farther than the bound.
#include "fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <vector>

using fuzz::Input;

namespace {

struct Rule {
    double chord, angle, longest;
};

struct Polyline {
    std::vector<double> params, points;
    double bound = -1;
    int32_t reached = -1;
    int64_t count = -1;
};

// Some of the limits are large, or not given, and few of them none that a call can take.
Rule any_rule(Input &in, double size) {
    if (in.rarely()) {
        return {in.anything(), in.anything(), in.rarely() ? in.anything() : 0};
    }
    const double chord = in.below(8) == 0 ? INFINITY : std::ldexp(size + 1e-300, -in.below(14));
    const bool free = std::isinf(chord);
    return {chord, free || in.coin() ? 0.05 + 3 * in.unit() : 0, in.coin() ? size * (0.05 + in.unit()) : 0};
}

// The distance of x from a segment.
double distance(const double *x, const double *a, const double *b, size_t dim) {
    double along = 0, square = 0, sum = 0;
    for (size_t c = 0; c < dim; ++c) {
        along += (x[c] - a[c]) * (b[c] - a[c]);
        square += (b[c] - a[c]) * (b[c] - a[c]);
    }
    const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    for (size_t c = 0; c < dim; ++c) {
        const double off = x[c] - a[c] - share * (b[c] - a[c]);
        sum += off * off;
    }
    return std::sqrt(sum);
}

void check(Input &in, const nurbs *g, const fuzz::Spline &s, const Rule &rule, const Polyline &line) {
    const auto n = line.params.size(), dim = static_cast<size_t>(s.dim);
    double domain[2];
    FUZZ_REQUIRE(nurbs_domain(g, 0, domain) == NURBS_OK);
    FUZZ_REQUIRE(n >= 2 && line.params.front() == domain[0] && line.params.back() == domain[1]);
    FUZZ_REQUIRE(std::is_sorted(line.params.begin(), line.params.end()));
    FUZZ_REQUIRE(line.bound >= 0 && (line.reached == 0 || line.bound <= rule.chord));
    const double off = 64 * fuzz::accuracy(s.degrees) * fuzz::eps * s.size() * std::sqrt(s.dim);
    for (int k = 0; k < 40; ++k) {
        const size_t i = (static_cast<size_t>(in.byte()) * 256 + in.byte()) % (n - 1);
        const double from = line.params[i], to = line.params[i + 1], t = from + in.unit() * (to - from);
        std::vector<double> x(dim);
        FUZZ_REQUIRE(nurbs_eval(g, 1, &t, 0, 0, x.data(), 0, 0, t >= to ? NURBS_LEFT : 0) == NURBS_OK);
        FUZZ_REQUIRE(from == to || !s.weights.empty() ||
                     distance(x.data(), &line.points[i * dim], &line.points[(i + 1) * dim], dim) <=
                         line.bound * (1 + 1e-12) + off);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    fuzz::Spline s;
    fuzz::add_axes(in, s, in.rarely() ? 2 : 1);
    fuzz::add_values(in, s, 1 + in.below(4));
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = int64_t{1} << (8 + in.below(16));
    const Rule rule = any_rule(in, s.size());
    Polyline line;
    if (!FUZZ_OK(nurbs_mesh_curve_with(g.get(), rule.chord, rule.angle, rule.longest, 0, nullptr, nullptr,
                                       &line.bound, &line.reached, &line.count, &call))) {
        return 0;
    }
    line.params.resize(static_cast<size_t>(line.count));
    line.points.resize(static_cast<size_t>(line.count * s.dim));
    FUZZ_REQUIRE(nurbs_mesh_curve_with(g.get(), rule.chord, rule.angle, rule.longest, line.count,
                                       line.params.data(), line.points.data(), &line.bound, &line.reached,
                                       &line.count, &call) == NURBS_OK);
    check(in, g.get(), s, rule, line);
    if (line.reached == 1) { // a call without a limit reaches it, too
        int32_t reached = -1;
        FUZZ_REQUIRE(nurbs_mesh_curve(g.get(), rule.chord, rule.angle, rule.longest, 0, nullptr, nullptr,
                                      nullptr, &reached, nullptr) == NURBS_OK);
        FUZZ_REQUIRE(reached == 1);
    }
    return 0;
}
