// SPDX-License-Identifier: MIT
#include "modify/deform/snap_boundary.h"

#include "base/representable.h"
#include "bounds/deviation.h"
#include "numeric/norm.h"
#include "reduce/layers.h"
#include "refine/algebra/common_knots.h"
#include "refine/algebra/product.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/parametrization.h"
#include "refine/forms/transform.h"
#include "refine/knots/axis_table.h"
#include "refine/parts/cut.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace nrb::modify {

namespace {

void check_boundaries(const Spline &spline, Boundary boundary, const Spline &other, Boundary other_boundary) {
    if (spline.axes() > 2 || spline.axes() != other.axes()) {
        fail(Status::axes, "g has %d axes and other %d, expected two curves or two surfaces", spline.axes(),
             other.axes());
    }
    if (spline.dim() != other.dim()) {
        fail(Status::incompatible, "dimension %d of other, expected %d as of g", other.dim(), spline.dim());
    }
    if (spline.axis(boundary.axis).periodic() || other.axis(other_boundary.axis).periodic()) {
        fail(Status::periodic, "axis %d of %s is periodic: it has no boundary",
             spline.axis(boundary.axis).periodic() ? boundary.axis : other_boundary.axis,
             spline.axis(boundary.axis).periodic() ? "g" : "other");
    }
}

SplinePtr clamped_at(const SplinePtr &spline, Boundary boundary) {
    const KnotVector &axis = spline->axis(boundary.axis);
    return (boundary.upper ? axis.clamped_end() : axis.clamped_start())
               ? spline
               : refine::clamp_ends(spline, boundary.axis, {!boundary.upper, boundary.upper});
}

// Two surfaces with one degree and one knot vector along their boundaries.
struct Pair {
    SplinePtr g;
    SplinePtr other;
};
Pair compatible_along(const SplinePtr &g, int along, SplinePtr other, int other_along, bool reversed) {
    if (reversed) {
        other = refine::reverse(*other, other_along, true);
    }
    other = refine::reparametrize(other, other_along, g->axis(along).domain());
    const KnotVector &a = g->axis(along), &b = other->axis(other_along);
    const refine::CommonKnots joint(std::max(a.degree(), b.degree()), {&a, &b}, 0);
    const auto raised = [&joint](const SplinePtr &spline, int k, int member) {
        const KnotVector &old = spline->axis(k);
        const bool same = old.degree() == joint.axis()->degree() &&
                          old.periodic() == joint.axis()->periodic() &&
                          std::ranges::equal(old.knots(), joint.axis()->knots());
        return same ? spline : refine::with_axis(*spline, k, {joint.axis(), joint.raising(member)});
    };
    SplinePtr fine = raised(g, along, 0);
    return {std::move(fine), raised(other, other_along, 1)};
}

// The homogeneous records of a spline by layers, counted from a boundary: layer 0 is the boundary itself, and
// record i of a layer is the i-th one along the boundary.
class Layers {
public:
    Layers(const Spline &spline, Boundary boundary)
        : width_(static_cast<size_t>(spline.dim()) + 1), records_(refine::homogeneous_points(spline)),
          view_(axis_view(spline, boundary.axis, 1)), upper_(boundary.upper),
          slope_(end_slope(spline.axis(boundary.axis), boundary.upper)) {}

    [[nodiscard]] size_t width() const noexcept { return width_; }
    [[nodiscard]] int64_t size() const noexcept { return view_.outer * view_.inner; }
    [[nodiscard]] int64_t layers() const noexcept { return view_.count; }
    [[nodiscard]] double *record(int64_t layer, int64_t i) noexcept {
        const int64_t at = upper_ ? view_.count - 1 - layer : layer;
        const int64_t point = (i / view_.inner * view_.count + at) * view_.inner + i % view_.inner;
        return records_.data() + static_cast<size_t>(point) * width_;
    }
    [[nodiscard]] double weight_sum(int64_t layer) noexcept {
        double sum = 0;
        for (int64_t i = 0; i < size(); ++i) {
            sum += record(layer, i)[width_ - 1];
        }
        return sum;
    }
    // The derivative across the boundary is a difference of the first two layers times this: the degree over
    // a difference of knots.
    [[nodiscard]] double slope() const noexcept { return slope_; }
    // The sum over the control points of slope |w_1 / w_0 (P_1 - P_0)|.
    [[nodiscard]] double speed() {
        double sum = 0;
        for (int64_t i = 0; i < size(); ++i) {
            const double *const a = record(0, i), *const b = record(1, i);
            const double w = a[width_ - 1], v = b[width_ - 1];
            sum += w == 0 ? 0 : norm_of(static_cast<int>(width_) - 1, [&](int c) {
                return (b[c] - v * (a[c] / w)) / w;
            });
        }
        return slope_ * sum;
    }
    [[nodiscard]] std::vector<double> take() noexcept { return std::move(records_); }

private:
    static double end_slope(const KnotVector &axis, bool upper) noexcept {
        const int64_t n = axis.count(), p = axis.degree();
        return static_cast<double>(p) / (upper ? axis[n] - axis[n - 1] : axis[p + 1] - axis[p]);
    }

    size_t width_;
    std::vector<double> records_;
    AxisView view_;
    bool upper_;
    double slope_;
};

// The power of two nearest to a ratio of weights.
double weight_factor(Layers &own, Layers &other) {
    const double ratio = own.weight_sum(0) / other.weight_sum(0);
    return ratio > 0 && std::isfinite(ratio) ? std::exp2(std::round(std::log2(ratio))) : 1;
}

void check_orders(const Spline &g, const Spline &other, Boundary boundary, Boundary other_boundary) {
    for (const auto &[spline, axis, name] :
         {std::tuple(&g, boundary.axis, "g"), std::tuple(&other, other_boundary.axis, "other")}) {
        if (spline->axis(axis).degree() == 0) {
            fail(Status::degree, "degree 0 of %s across the boundary, expected at least 1 for tangents",
                 name);
        }
    }
}

// Sets A_1, the layer next to the boundary. A weight may be 0 where that on the boundary is; only homogeneous
// records may have a negative one.
void set_second_layer(Layers &own, Layers &other, double factor, Form form) {
    const double speed = own.speed(), other_speed = other.speed();
    if (!(speed > 0) || !(other_speed > 0)) {
        fail(Status::tangent, "the derivative of %s across the boundary vanishes", speed > 0 ? "other" : "g");
    }
    const double s = speed / other_speed * (other.slope() / own.slope());
    const double first = other.weight_sum(0), second = other.weight_sum(1);
    const double c = (own.weight_sum(1) / factor - first - s * (first - second)) / first;
    for (int64_t i = 0; i < own.size(); ++i) {
        const double *const a = other.record(0, i), *const b = other.record(1, i);
        double *const out = own.record(1, i);
        for (size_t k = 0; k < own.width(); ++k) {
            out[k] = factor * ((1 + c) * a[k] + s * (a[k] - b[k]));
        }
        const double weight = out[own.width() - 1];
        if ((!(weight > 0) && a[own.width() - 1] > 0) || (weight < 0 && form != Form::homogeneous)) {
            fail(Status::weight_sign, "weight %s of a control point next to the boundary, expected > 0",
                 Number(weight).text);
        }
    }
}

void set_first_layer(Layers &own, Layers &other, double factor) {
    for (int64_t i = 0; i < own.size(); ++i) {
        const double *const from = other.record(0, i);
        std::transform(from, from + own.width(), own.record(0, i), [factor](double x) { return factor * x; });
    }
}

// The spline of the changed records; the first `changed` layers from the boundary have changed. Cartesian
// coordinates of the other layers are kept, and those of the boundary are copied from the other spline.
SplinePtr assembled(const Spline &g, Boundary boundary, const Spline &other, Boundary other_boundary,
                    std::vector<double> records, int64_t changed) {
    const Form form = std::max(g.form(), other.form());
    if (form == Form::homogeneous) {
        require_representable(records, "control points");
        return make_result(g.knot_vectors(), g.dim(), form, std::move(records));
    }
    const auto dim = static_cast<size_t>(g.dim());
    const AxisView view = axis_view(g, boundary.axis, 1), edge = axis_view(other, other_boundary.axis, 1);
    std::vector<double> points(g.points().begin(), g.points().end()), weights;
    for (int64_t i = 0; i < g.point_count(); ++i) {
        const int64_t layer = i / view.inner % view.count,
                      depth = boundary.upper ? view.count - 1 - layer : layer;
        const double *const record = records.data() + static_cast<size_t>(i) * (dim + 1);
        const int64_t across = i / view.inner / view.count * view.inner + i % view.inner;
        const int64_t at = other_boundary.upper ? edge.count - 1 : 0;
        const int64_t stored = (across / edge.inner * edge.count + at) * edge.inner + across % edge.inner;
        for (size_t c = 0; c < dim && depth < changed; ++c) {
            points[static_cast<size_t>(i) * dim + c] =
                depth == 0 ? other.points()[static_cast<size_t>(stored) * dim + c] : record[c] / record[dim];
        }
        weights.push_back(record[dim]);
    }
    require_representable(points, "control points");
    return make_result(g.knot_vectors(), g.dim(), form, std::move(points),
                       form == Form::rational ? std::move(weights) : std::vector<double>());
}

} // namespace

SnappedBoundary snap_boundary(const SplinePtr &spline, Boundary boundary, const SplinePtr &other,
                              Boundary other_boundary, int order, bool reversed) {
    check_boundaries(*spline, boundary, *other, other_boundary);
    Pair pair{clamped_at(spline, boundary), clamped_at(other, other_boundary)};
    if (spline->axes() == 2) {
        pair = compatible_along(pair.g, 1 - boundary.axis, pair.other, 1 - other_boundary.axis, reversed);
    }
    if (order > 0) {
        check_orders(*pair.g, *pair.other, boundary, other_boundary);
    }
    Layers own(*pair.g, boundary), from(*pair.other, other_boundary);
    const double factor = weight_factor(own, from);
    if (order > 0) {
        set_second_layer(own, from, factor, std::max(pair.g->form(), pair.other->form()));
    }
    set_first_layer(own, from, factor);
    SplinePtr snapped = assembled(*pair.g, boundary, *pair.other, other_boundary, own.take(), order + 1);
    const double bound = bounds::deviation(*spline, *snapped).upper;
    return {std::move(snapped), bound};
}

} // namespace nrb::modify
