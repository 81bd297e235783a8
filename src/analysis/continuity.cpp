// SPDX-License-Identifier: MIT
#include "analysis/continuity.h"

#include "base/numbers.h"
#include "eval/frames/jet.h"
#include "numeric/norm.h"
#include "refine/parts/iso.h"
#include "spline/kind.h"
#include "spline/near_one.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::analysis {

namespace {

std::vector<double> scaled(const double *x, int n, double factor) {
    std::vector<double> result(x, x + n);
    std::transform(result.begin(), result.end(), result.begin(), [factor](double c) { return c * factor; });
    return result;
}

// The angle between unit vectors, accurate for angles near 0 and near pi (W. Kahan).
double angle_between(const std::vector<double> &a, const std::vector<double> &b) noexcept {
    const int n = static_cast<int>(a.size());
    const double along =
        norm_of(n, [&](int c) { return a[static_cast<size_t>(c)] + b[static_cast<size_t>(c)]; });
    return 2 * std::atan2(distance(a.data(), b.data(), n), along);
}

int parametric_order(const closest::CurveSide &before, const closest::CurveSide &after,
                     const ContinuityRule &rule) {
    for (int k = 0; k <= before.order(); ++k) {
        const double allowed =
            k == 0 ? rule.position : rule.derivative * std::max(before.length(k), after.length(k));
        const double gap = distance(before.at(k), after.at(k), before.dim());
        if (!(gap <= allowed + before.error(k) + after.error(k))) {
            return k - 1;
        }
    }
    return before.order();
}

// The limit of the unit tangent at an end of a piece, from the first derivative that does not vanish, and the
// order of that derivative. On the side before the place, derivatives of even order point against the
// tangent. Empty for a constant piece.
struct Tangent {
    std::vector<double> unit;
    int order = 0;
    double error = 0;
};

Tangent tangent_of(const closest::CurveSide &side, bool before) {
    for (int k = 1; k <= side.order(); ++k) {
        const double length = side.length(k);
        if (length > side.error(k)) {
            const double sign = before && k % 2 == 0 ? -1 : 1;
            return {scaled(side.at(k), side.dim(), sign / length), k, side.error(k) / length + 4 * eps};
        }
    }
    return {};
}

struct Curvature {
    std::vector<double> vector;
    double error;
};

// The curvature vector (C'' - (C'' . T) T) / |C'|^2.
Curvature curvature_of(const closest::CurveSide &side, const Tangent &tangent) {
    const int n = side.dim();
    const double speed = side.length(1);
    const double along = dot(side.at(2), tangent.unit.data(), n);
    std::vector<double> vector(static_cast<size_t>(n));
    for (int c = 0; c < n; ++c) {
        vector[static_cast<size_t>(c)] =
            (side.at(2)[c] - along * tangent.unit[static_cast<size_t>(c)]) / speed / speed;
    }
    const double error = (side.error(2) + 4 * side.length(2) * tangent.error) / speed / speed;
    return {std::move(vector), error};
}

// Tests G2 for two curves with regular tangents that agree. Along a length l, a difference d of the
// curvatures turns the tangent by at most d l, and a curvature k turns it by k l. With the longer span as l,
// the difference counts as 0 if d l is at most the tolerance times the larger of k l and 1. Rounding thus
// does not break a straight line, at any scale.
void compare_curvatures(const closest::CurveSide &before, const Tangent &tangent_before,
                        const closest::CurveSide &after, const Tangent &tangent_after,
                        const ContinuityRule &rule, Continuity &found) {
    const Curvature a = curvature_of(before, tangent_before), b = curvature_of(after, tangent_after);
    const int n = before.dim();
    found.curvature_gap = distance(a.vector.data(), b.vector.data(), n);
    const double longer = std::max(before.span_length(), after.span_length());
    const double scale = std::max({norm(a.vector.data(), n), norm(b.vector.data(), n), 1 / longer});
    if (found.geometric == 1 && found.curvature_gap <= rule.derivative * scale + a.error + b.error) {
        found.geometric = 2;
    }
}

} // namespace

Continuity continuity(const closest::CurveSide &before, const closest::CurveSide &after,
                      const ContinuityRule &rule) {
    Continuity found{parametric_order(before, after, rule), -1,
                     distance(before.at(0), after.at(0), before.dim()), nan_value, nan_value};
    found.geometric = std::min(found.order, 0);
    const Tangent a = tangent_of(before, true), b = tangent_of(after, false);
    if (a.order == 0 || b.order == 0) {
        return found;
    }
    found.angle = angle_between(a.unit, b.unit);
    if (found.geometric == 0 && found.angle <= rule.angle + a.error + b.error) {
        found.geometric = 1;
    }
    if (a.order == 1 && b.order == 1) {
        compare_curvatures(before, a, after, b, rule, found);
    }
    return found;
}

namespace {

// The parameters on the two sides of a place on the axis.
struct Sides {
    double below;
    double above;
};

// Parameters of the other axes, in the order of the axes: degree + 1 inside each span of each axis.
std::vector<std::array<double, 2>> samples_of(const Spline &spline, int axis) {
    std::vector<std::array<double, 2>> samples{{0, 0}};
    size_t place = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        if (k == axis) {
            continue;
        }
        const KnotVector &knots = spline.axis(k);
        const int n = knots.degree() + 1;
        std::vector<std::array<double, 2>> more;
        for (const std::array<double, 2> &sample : samples) {
            for (const int64_t s : knots.spans().indices()) {
                for (int i = 0; i < n; ++i) {
                    more.push_back(sample);
                    more.back()[place] = knots[s] + (knots[s + 1] - knots[s]) * ((i + 0.5) / n);
                }
            }
        }
        samples = std::move(more);
        ++place;
    }
    return samples;
}

// The curve along the axis at given parameters of the other axes.
SplinePtr line_at(SplinePtr spline, int axis, const std::array<double, 2> &params) {
    size_t place = 0;
    for (int k = 0, left = spline->axes(); left > 1; --left) {
        k = k == axis ? k + 1 : k;
        spline = refine::iso(*spline, k, params[place++], {});
        axis = k < axis ? axis - 1 : axis;
    }
    return spline;
}

double accuracy_of(const Spline &spline) {
    double sum = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        sum += eval::accuracy_factor(spline.axis(k).degree());
    }
    return sum;
}

int order_of(const Spline &curve) {
    return std::max(curve.axis(0).degree(), 2);
}

// Derivatives above the degree are used for the curvature only.
Continuity limited(Continuity found, int degree) {
    found.order = std::min(found.order, degree);
    return found;
}

// Takes the worse of both values; NaN does not count as a gap.
void worsen(Continuity &worst, const Continuity &found) {
    worst.order = std::min(worst.order, found.order);
    worst.geometric = std::min(worst.geometric, found.geometric);
    worst.position_gap = std::max(worst.position_gap, found.position_gap);
    worst.angle = std::fmax(worst.angle, found.angle);
    worst.curvature_gap = std::fmax(worst.curvature_gap, found.curvature_gap);
}

struct Normal {
    std::vector<double> unit; // empty if it is not defined
    double error;
};

Normal normal_of(const closest::CurveSide &u, const closest::CurveSide &v) {
    const double *a = u.at(1), *b = v.at(1);
    const double n[] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    const double error =
        u.error(1) * v.length(1) + v.error(1) * u.length(1) + 4 * eps * u.length(1) * v.length(1);
    return length > error ? Normal{scaled(n, 3, 1 / length), error / length} : Normal{{}, 0};
}

// For surfaces: replaces the angle between the tangents by that between the normals.
void compare_normals(const Normal &a, const Normal &b, const ContinuityRule &rule, Continuity &found) {
    found.geometric = std::min(found.order, 0);
    found.angle = found.curvature_gap = nan_value;
    if (a.unit.empty() || b.unit.empty()) {
        return;
    }
    found.angle = angle_between(a.unit, b.unit);
    if (found.geometric == 0 && found.angle <= rule.angle + a.error + b.error) {
        found.geometric = 1;
    }
}

// Compares both sides of all places, one sample of the other axes at a time.
class Inspection {
public:
    Inspection(const SplinePtr &spline, int axis, const ContinuityRule &rule, std::vector<Sides> places)
        : spline_(spline), axis_(axis), rule_(rule), places_(std::move(places)),
          accuracy_(accuracy_of(*spline)) {
        for (const Sides &place : places_) {
            worst_.push_back({spline->axis(axis).degree(), 2, 0, nan_value, nan_value});
            if (has_normals()) {
                below_.push_back(refine::iso(*spline, axis, place.below, {.left = true}));
                above_.push_back(refine::iso(*spline, axis, place.above, {}));
            }
        }
    }

    [[nodiscard]] std::vector<Continuity> run() {
        for (const std::array<double, 2> &sample : samples_of(*spline_, axis_)) {
            const SplinePtr line = line_at(spline_, axis_, sample);
            for (size_t i = 0; i < places_.size(); ++i) {
                worsen(worst_[i], at(*line, i, sample[0]));
            }
        }
        return worst_;
    }

private:
    [[nodiscard]] bool has_normals() const noexcept { return spline_->axes() == 2 && spline_->dim() == 3; }

    [[nodiscard]] Continuity at(const Spline &line, size_t i, double other) const {
        const int order = order_of(line);
        const closest::CurveSide before(line, places_[i].below, true, order, accuracy_),
            after(line, places_[i].above, false, order, accuracy_);
        Continuity found = limited(continuity(before, after, rule_), line.axis(0).degree());
        if (has_normals()) {
            const closest::CurveSide left(*below_[i], other, false, 1, accuracy_),
                right(*above_[i], other, false, 1, accuracy_);
            compare_normals(normal_of(before, left), normal_of(after, right), rule_, found);
        } else if (spline_->axes() > 1) {
            compare_normals({{}, 0}, {{}, 0}, rule_, found);
        }
        return found;
    }

    const SplinePtr &spline_;
    int axis_;
    const ContinuityRule &rule_;
    std::vector<Sides> places_;
    std::vector<SplinePtr> below_;
    std::vector<SplinePtr> above_;
    std::vector<Continuity> worst_;
    double accuracy_; // each contraction moves control points by at most its own error bound
};

} // namespace

namespace {

// For a spline whose derivatives and their squares are in the range of double precision. The knots are
// reported as in `named`, the knot vector before scaling.
std::vector<KnotContinuity> usual_continuity(const SplinePtr &spline, int axis, const ContinuityRule &rule,
                                             const KnotVector &named) {
    const KnotVector &knots = spline->axis(axis);
    const std::vector<KnotGroup> groups = distinct_knots(knots.knots()),
                                 names = distinct_knots(named.knots());
    const auto [lower, upper] = knots.domain();
    std::vector<KnotContinuity> rows;
    std::vector<Sides> places;
    for (size_t i = 0; i < groups.size(); ++i) {
        const double knot = groups[i].knot;
        if (knot > lower && knot < upper) {
            rows.push_back({names[i].knot, knots.degree() - groups[i].multiplicity, {}});
            places.push_back({knot, knot});
        }
    }
    const int at_seam = knots.periodic() ? knots.degree() - multiplicity(knots.knots(), lower) : -1;
    rows.push_back({named.domain().upper, at_seam, {}});
    places.push_back({upper, lower});
    const std::vector<Continuity> found = Inspection(spline, axis, rule, std::move(places)).run();
    for (size_t i = 0; i < rows.size(); ++i) {
        rows[i].found = found[i];
    }
    if (!knots.periodic() && rows.back().found.order < 0) {
        rows.pop_back();
    }
    return rows;
}

// The rule for lengths multiplied by 2^size, and the result scaled back.
ContinuityRule scaled(ContinuityRule rule, int size) noexcept {
    rule.position = std::ldexp(rule.position, size);
    return rule;
}
Continuity scaled_back(Continuity found, int size) noexcept {
    found.position_gap = std::ldexp(found.position_gap, -size);
    found.curvature_gap = std::ldexp(found.curvature_gap, size);
    return found;
}

// The powers of two that suit both splines: those for the larger size and the shorter axis.
struct CommonPowers {
    int size, knots;
};
CommonPowers common_powers(const Spline &a, const Spline &b) {
    const Powers of_a = powers_near_one(a, 1), of_b = powers_near_one(b, 1);
    return {std::min(of_a.size(a), of_b.size(b)), std::max(of_a.knots[0], of_b.knots[0])};
}
SplinePtr resized(const Spline &spline, const CommonPowers &powers) {
    const int knots = kept_apart(spline.knot_vectors(), powers.knots);
    return near_one(spline, {.coordinates = powers.size, .weights = 0, .knots = {knots}});
}

} // namespace

std::vector<KnotContinuity> continuity(const SplinePtr &spline, int axis, const ContinuityRule &rule) {
    const Powers powers = powers_near_one(*spline, 1);
    if (powers == Powers{}) {
        return usual_continuity(spline, axis, rule, spline->axis(axis));
    }
    const int size = powers.size(*spline);
    std::vector<KnotContinuity> rows =
        usual_continuity(near_one(*spline, powers), axis, scaled(rule, size), spline->axis(axis));
    for (KnotContinuity &row : rows) {
        row.found = scaled_back(row.found, size);
    }
    return rows;
}

namespace {

Continuity usual_continuity_between(const Spline &a, bool upper_a, const Spline &b, bool upper_b,
                                    const ContinuityRule &rule) {
    const int degree = std::max(a.axis(0).degree(), b.axis(0).degree()), order = std::max(degree, 2);
    const Interval of_a = a.axis(0).domain(), of_b = b.axis(0).domain();
    closest::CurveSide before(a, upper_a ? of_a.upper : of_a.lower, upper_a, order, accuracy_of(a));
    closest::CurveSide after(b, upper_b ? of_b.upper : of_b.lower, upper_b, order, accuracy_of(b));
    if (!upper_a) {
        before.reverse();
    }
    if (upper_b) {
        after.reverse();
    }
    return limited(continuity(before, after, rule), degree);
}

} // namespace

Continuity continuity_between(const Spline &a, bool upper_a, const Spline &b, bool upper_b,
                              const ContinuityRule &rule) {
    check_kind(a, 1, "a");
    check_kind(b, 1, "b");
    check_same_dimension(a, b);
    const CommonPowers powers = common_powers(a, b);
    if (powers.size == 0 && powers.knots == 0) {
        return usual_continuity_between(a, upper_a, b, upper_b, rule);
    }
    return scaled_back(usual_continuity_between(*resized(a, powers), upper_a, *resized(b, powers), upper_b,
                                                scaled(rule, powers.size)),
                       powers.size);
}

} // namespace nrb::analysis
