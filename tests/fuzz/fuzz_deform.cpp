// Deformations: what a call promises of its result holds where it is evaluated.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

std::vector<double> any_vector(Input &in, int32_t dim) {
    std::vector<double> x;
    for (int32_t c = 0; c < dim; ++c) {
        x.push_back(in.rarely() ? in.anything() : in.number());
    }
    return x;
}

std::vector<double> any_range(Input &in, const nurbs *g, const fuzz::Spline &s) {
    std::vector<double> range;
    for (int k = 0; k < s.axes(); ++k) {
        double a = fuzz::any_param(in, g, k, !in.rarely()), b = fuzz::any_param(in, g, k, !in.rarely());
        range.push_back(std::min(a, b));
        range.push_back(std::max(a, b));
    }
    return range;
}

std::vector<double> point_of(const nurbs *g, const std::vector<double> &param, int32_t dim) {
    std::vector<double> point(static_cast<size_t>(dim));
    FUZZ_REQUIRE(nurbs_eval(g, 1, param.data(), 0, 0, point.data(), 0, 0, 0) == NURBS_OK);
    return point;
}

double distance(const std::vector<double> &a, const std::vector<double> &b) {
    double sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum = std::hypot(sum, a[c] - b[c]);
    }
    return sum;
}

bool calm(const fuzz::Spline &s) {
    const double ratio = s.weight_ratio();
    return ratio > 0 && ratio < 1e3 && s.size() < 1e6;
}

void warp(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> range = any_range(in, g, s), direction = any_vector(in, s.dim);
    const double length = in.rarely() ? in.anything() : in.number();
    const int32_t order = in.rarely() ? in.bad_int() : in.below(4);
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_warp(g, in.coin() ? range.data() : nullptr, direction.data(), length, order, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h && calm(s)) {
        const std::vector<double> param = fuzz::any_params(in, g, s.axes(), 1, true);
        const double moved = distance(point_of(g, param, s.dim), point_of(h.get(), param, s.dim));
        FUZZ_REQUIRE(moved <= std::fabs(length) * (1 + 1e-9) + 1e-6 * (s.size() + std::fabs(length)));
    }
}

void flatten(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> range = any_range(in, g, s), point = any_vector(in, s.dim),
                              normal = any_vector(in, s.dim), direction = any_vector(in, s.dim);
    double moved = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_flatten(g, in.coin() ? range.data() : nullptr, point.data(), normal.data(),
                      in.coin() ? direction.data() : nullptr, &moved, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? moved >= 0 : moved == -7);
    if (h && calm(s)) {
        const std::vector<double> param = fuzz::any_params(in, g, s.axes(), 1, true);
        const double gap = distance(point_of(g, param, s.dim), point_of(h.get(), param, s.dim));
        FUZZ_REQUIRE(gap <= moved * (1 + 1e-9) + 1e-6 * (s.size() + moved));
    }
}

void bend(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> origin = any_vector(in, s.dim), along = any_vector(in, s.dim),
                              across = any_vector(in, s.dim);
    const double curvature = (4 * in.unit() - 2) / (s.size() + 1); // a turn or two
    const double lower = in.coin() ? -HUGE_VAL : in.number(), upper = in.coin() ? HUGE_VAL : in.number();
    const double tolerance = in.rarely() ? in.anything() : 0.05 * s.size();
    double deviation = -7;
    int32_t proven = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_bend(g, origin.data(), along.data(), across.data(), curvature, lower,
                                           upper, tolerance, &deviation, &proven, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? deviation <= tolerance && (proven == 0 || proven == 1)
                   : deviation == -7 && proven == -7);
}

// A box around the control points, mapped by a volume with a few moved corners.
void free_form(Input &in, const nurbs *g, const fuzz::Spline &s) {
    if (s.dim > 3) {
        return;
    }
    const auto axes = static_cast<size_t>(s.dim);
    const std::vector<int32_t> degrees(axes, 1 + in.below(2));
    std::vector<double> points, lower(axes, -s.size() - 1), upper(axes, s.size() + 1);
    int64_t count = 1;
    for (const int32_t degree : degrees) {
        count *= degree + 1;
    }
    for (int64_t i = 0; i < count; ++i) {
        int64_t rest = i;
        std::vector<double> point(axes);
        for (size_t k = axes; k-- > 0;) {
            point[k] = static_cast<double>(rest % (degrees[k] + 1)) / degrees[k] + 0.2 * in.unit();
            rest /= degrees[k] + 1;
        }
        points.insert(points.end(), point.begin(), point.end());
    }
    nurbs *made = nullptr;
    FUZZ_REQUIRE(nurbs_create_bezier(s.dim, degrees.data(), s.dim, points.data(), 0, 0, nullptr, 0, &made) ==
                 NURBS_OK);
    const fuzz::Handle volume(made);
    const double tolerance = in.rarely() ? in.anything() : 0.01;
    double deviation = -7;
    int32_t proven = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_free_form_deform(g, volume.get(), lower.data(), upper.data(), tolerance,
                                                       &deviation, &proven, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? deviation <= tolerance : deviation == -7 && proven == -7);
}

void fair(Input &in, const nurbs *g, const fuzz::Spline &s) {
    std::vector<int32_t> keep;
    for (int i = 0; i < 2 * s.axes(); ++i) {
        keep.push_back(in.rarely() ? in.bad_int() : in.below(4) - 1);
    }
    double energies[2] = {-7, -7}, bound = -7;
    const double tolerance = in.rarely() ? in.anything() : s.size() * in.unit() * 0.1;
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_fair(g, in.rarely() ? in.below(5) : 1 + in.below(3), in.coin() ? keep.data() : nullptr,
                   tolerance, energies, &bound, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? energies[1] <= energies[0] && bound <= tolerance && bound >= 0 : bound == -7);
}

void snap(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const fuzz::Spline t = in.coin() ? s : fuzz::any_spline(in); // often one that suits
    const fuzz::Handle other(fuzz::create(t));
    if (!other || t.total > 200) {
        return;
    }
    double bound = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_snap_boundary(g, in.below(s.axes()), in.below(2), other.get(), in.below(t.axes()), in.below(2),
                            in.below(2), in.coin() && s.axes() == 2 ? NURBS_REVERSED : 0, &bound, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? bound >= 0 : bound == -7);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    int64_t active = 1;
    for (const int32_t p : s.degrees) {
        active *= p + 1;
    }
    if (g && s.total <= 100 && active <= 40) {
        warp(in, g.get(), s);
        flatten(in, g.get(), s);
        fair(in, g.get(), s);
        snap(in, g.get(), s);
        if (s.total <= 12) { // sums over many samples
            bend(in, g.get(), s);
            free_form(in, g.get(), s);
        }
    }
    return 0;
}
