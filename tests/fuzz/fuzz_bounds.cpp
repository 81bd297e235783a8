// Boxes, cones and extreme points: what is claimed of a shape holds at points of it.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Places {
    std::vector<double> params, points;
    int n = 0;
};

// Points of g in a range, or of all of it.
Places places(Input &in, const nurbs *g, const fuzz::Spline &s, const std::vector<double> &range) {
    Places at;
    at.n = 6;
    for (int i = 0; i < at.n; ++i) {
        for (int32_t k = 0; k < s.axes32(); ++k) {
            const auto low = range[static_cast<size_t>(2 * k)], high = range[static_cast<size_t>(2 * k + 1)];
            // not the upper end, where a jump may be
            at.params.push_back(std::clamp(low + 0.999 * in.unit() * (high - low), low, high));
        }
    }
    at.points.resize(static_cast<size_t>(at.n * s.dim));
    FUZZ_REQUIRE(nurbs_eval(g, at.n, at.params.data(), 0, 0, at.points.data(), 0, 0, 0) == NURBS_OK);
    return at;
}

std::vector<double> any_range(Input &in, const nurbs *g, const fuzz::Spline &s) {
    std::vector<double> range;
    for (int32_t k = 0; k < s.axes32(); ++k) {
        double domain[2];
        FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
        double a = domain[0], b = domain[1];
        if (in.coin()) {
            a = fuzz::any_param(in, g, k, true);
            b = fuzz::any_param(in, g, k, true);
        }
        range.insert(range.end(), {std::min(a, b), std::max(a, b)});
    }
    return range;
}

void box(const nurbs *g, const fuzz::Spline &s, const std::vector<double> &range, const Places &at,
         double tolerance) {
    const auto dim = static_cast<size_t>(s.dim);
    std::vector<double> lower(dim), upper(dim);
    double gap = -1;
    if (!FUZZ_OK(nurbs_box(g, range.data(), tolerance, lower.data(), upper.data(), &gap))) {
        return;
    }
    FUZZ_REQUIRE(gap >= 0);
    const double off = 64 * fuzz::accuracy(s.degrees) * fuzz::eps * s.size();
    for (size_t i = 0; i < at.points.size(); ++i) {
        const double x = at.points[i];
        FUZZ_REQUIRE(!std::isfinite(x) || (x >= lower[i % dim] - off && x <= upper[i % dim] + off));
    }
}

void oriented(const nurbs *g, const fuzz::Spline &s, double tolerance) {
    const auto dim = static_cast<size_t>(s.dim);
    std::vector<double> center(dim), axes(dim * dim), half(dim);
    if (FUZZ_OK(nurbs_oriented_box(g, tolerance, center.data(), axes.data(), half.data()))) {
        FUZZ_REQUIRE(std::all_of(half.begin(), half.end(), [](double x) { return x >= 0; }));
    }
}

void cones(Input &in, const nurbs *g, const fuzz::Spline &s, const std::vector<double> &range,
           double tolerance) {
    std::vector<double> direction(static_cast<size_t>(s.dim));
    double angle = -1;
    if (FUZZ_OK(nurbs_tangent_cone(g, in.rarely() ? in.bad_int() : in.below(s.axes()), range.data(),
                                   tolerance, direction.data(), &angle))) {
        FUZZ_REQUIRE(angle >= 0 && angle <= 3.1415926535897936);
    }
    std::vector<double> normal(3);
    if (FUZZ_OK(nurbs_normal_cone(g, range.data(), tolerance, normal.data(), &angle))) {
        FUZZ_REQUIRE(angle >= 0 && angle <= 3.1415926535897936);
    }
}

void extreme(Input &in, const nurbs *g, const fuzz::Spline &s, const std::vector<double> &range,
             const Places &at, double tolerance) {
    std::vector<double> direction(static_cast<size_t>(s.dim)), params(static_cast<size_t>(s.axes()));
    double length = 0, value = 0, bound = 0;
    for (double &x : direction) {
        x = in.rarely() ? in.anything() : in.number();
        length += std::fabs(x);
    }
    if (!FUZZ_OK(nurbs_extreme_point(g, direction.data(), range.data(), tolerance, params.data(), &value,
                                     &bound))) {
        return;
    }
    FUZZ_REQUIRE(value <= bound);
    for (size_t k = 0; k < params.size(); ++k) {
        FUZZ_REQUIRE(params[k] >= range[2 * k] && params[k] <= range[2 * k + 1]);
    }
    const double off = 64 * fuzz::accuracy(s.degrees) * fuzz::eps * s.size() * length;
    for (size_t i = 0; i < at.points.size(); i += direction.size()) {
        double along = 0;
        for (size_t c = 0; c < direction.size(); ++c) {
            along += direction[c] * at.points[i + c];
        }
        FUZZ_REQUIRE(!std::isfinite(along) || !std::isfinite(off) || along <= bound + off);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    int64_t degrees = 1;
    for (const int32_t p : s.degrees) {
        degrees *= p + 1;
    }
    if (!g || degrees > 64) { // the time of halvings grows with the square of this
        return 0;
    }
    const std::vector<double> range = any_range(in, g.get(), s);
    bool interval = true;
    for (size_t k = 0; k < range.size(); k += 2) {
        interval = interval && range[k] < range[k + 1];
    }
    const Places at = interval ? places(in, g.get(), s, range) : Places{};
    const double tolerance = in.rarely() ? in.anything() : std::ldexp(s.size() + 1e-30, -in.below(8));
    box(g.get(), s, range, at, tolerance);
    oriented(g.get(), s, tolerance);
    cones(in, g.get(), s, range, 0.125 + in.unit());
    extreme(in, g.get(), s, range, at, tolerance);
    return 0;
}
