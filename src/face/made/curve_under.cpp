// SPDX-License-Identifier: MIT
#include "face/made/curve_under.h"

#include "base/error.h"
#include "base/numbers.h"
#include "bounds/deviation.h"
#include "closest/closest.h"
#include "eval/evaluate.h"
#include "face/made/curve_fit.h"
#include "face/made/plane_chart.h"
#include "face/made/seam_parts.h"
#include "face/made/speeds.h"
#include "face/trims/monotone.h"
#include "numeric/norm.h"
#include "refine/compose/compose.h"
#include "refine/parts/cut.h"
#include "refine/parts/join.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace nrb::face {

namespace {

// Coordinates count as equal if their difference moves a point by less than this share of the tolerance.
constexpr double share_of_same = 1e-3;
// The most copies of the domain, crossed by a monotone piece of a curve, in which rough lines are looked for.
constexpr double most_crossed_copies = 4096;

std::vector<double> points_at(const Spline &spline, std::span<const double> params) {
    const auto count = std::ssize(params) / spline.axes();
    std::vector<double> points(static_cast<size_t>(count * spline.dim()));
    eval::evaluate_points(spline, {}, 0, {params.data(), count, spline.axes(), spline.axes(), 1},
                          {points.data(), count, spline.dim(), spline.dim(), 1});
    return points;
}

// Points of the surface at places of the plane.
std::vector<double> points_over(const Spline &surface, const Covering &covering, std::vector<double> places) {
    for (size_t i = 0; i < places.size(); i += 2) {
        const Point2 x = covering.in_domain({places[i], places[i + 1]});
        std::copy(x.begin(), x.end(), places.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return points_at(surface, places);
}

void distances(const std::vector<double> &a, const std::vector<double> &b, int dim, double *out) {
    for (size_t i = 0; i < a.size(); i += static_cast<size_t>(dim)) {
        *out++ = distance(a.data() + i, b.data() + i, dim);
    }
}

// A bound on the number of spans of a surface between two places of the plane, at least 1.
int64_t spans_between(const Spline &surface, const Covering &covering, const double *a, const double *b) {
    int64_t spans = 1;
    for (const int k : {0, 1}) {
        const KnotVector &axis = surface.axis(k);
        const double low = std::min(a[k], b[k]), high = std::max(a[k], b[k]);
        const std::span<const double> knots = axis.knots();
        if (covering.closed(k) && high - low >= covering.period(k)) {
            spans += axis.count();
            continue;
        }
        const Interval domain = axis.domain();
        const auto passed = [&](double from, double to) {
            return std::upper_bound(knots.begin(), knots.end(), to) -
                   std::lower_bound(knots.begin(), knots.end(), from);
        };
        spans += low >= domain.lower && high <= domain.upper ? passed(low, high) : axis.count();
    }
    return spans;
}

// The foot points of an edge on the surface, as places of the plane that covers the domain.
class Projection : public CurveModel {
public:
    Projection(const Spline &surface, const Covering &covering, const Spline &edge, const UnderRule &rule,
               Effort &effort)
        : surface_(surface), covering_(covering), edge_(edge), rule_(rule), effort_(effort) {}

    [[nodiscard]] int dim() const noexcept override { return 2; }
    void place(double t, const double *near, double *out) const override {
        const std::vector<double> point = points_at(edge_, {&t, 1});
        const closest::Foot foot = foot_of(point.data(), near);
        if (!(foot.distance <= rule_.tolerance)) {
            fail(Status::gap,
                 "the edge is %s from the surface at its parameter %s, expected at most the tolerance %s",
                 Number(foot.distance).text, Number(t).text, Number(rule_.tolerance).text);
        }
        off_ = std::max(off_, foot.distance);
        Point2 x{foot.params[0], foot.params[1]};
        if (near != nullptr) {
            x = covering_.nearest_copy(x, {near[0], near[1]});
            const int open = open_at(point.data());
            if (open >= 0) {
                x[static_cast<size_t>(open)] = near[open];
            }
        }
        std::copy(x.begin(), x.end(), out);
    }
    void errors(const Spline &candidate, std::span<const double> params, double *errors) const override {
        distances(points_over(surface_, covering_, points_at(candidate, params)), points_at(edge_, params),
                  edge_.dim(), errors);
        // What exceeds twice the distance of the edge from the surface: that distance may be larger between
        // the places than at them.
        std::transform(errors, errors + params.size(), errors,
                       [this](double error) { return std::max(error - 2 * off_, 0.0); });
    }
    [[nodiscard]] int64_t pieces_between(double, const double *a, double, const double *b) const override {
        return spans_between(surface_, covering_, a, b);
    }
    // On a closed surface short steps tell copies apart. A polynomial piece of an edge goes around a part of
    // the surface only, so that a few steps and one for each break in between are enough.
    [[nodiscard]] int64_t steps_between(double t, double u) const override {
        if (edge_.axis(0).degree() < 2 || !(covering_.closed(0) || covering_.closed(1))) {
            return 1;
        }
        constexpr int64_t least_steps = 3;
        const std::span<const double> breaks = edge_.axis(0).spans().breaks();
        return least_steps + (std::lower_bound(breaks.begin(), breaks.end(), std::max(t, u)) -
                              std::upper_bound(breaks.begin(), breaks.end(), std::min(t, u)));
    }
    [[nodiscard]] bool may_be_copy(const double *a, const double *b) const override {
        constexpr double share = 0.25; // of a period
        return std::ranges::any_of(std::array{0, 1}, [&](int k) {
            return covering_.closed(k) && std::abs(a[k] - b[k]) > share * covering_.period(k) &&
                   open_coordinate(a) != k && open_coordinate(b) != k;
        });
    }
    [[nodiscard]] int open_coordinate(const double *x) const override {
        return open_at(point_at(surface_, covering_.in_domain({x[0], x[1]})).data());
    }

private:
    // At a pole the parameter along it is arbitrary.
    [[nodiscard]] int open_at(const double *point) const {
        const Covering::Pole pole = covering_.pole_near(point, rule_.tolerance);
        return pole.axis < 0 ? -1 : 1 - pole.axis;
    }
    [[nodiscard]] closest::Foot foot_of(const double *point, const double *near) const {
        if (rule_.nearest) {
            closest::Foot foot;
            const Point2 x = rule_.nearest(point);
            std::copy(x.begin(), x.end(), foot.params.begin());
            foot.distance = distance(point_at(surface_, x).data(), point, edge_.dim());
            if (foot.distance <= rule_.tolerance) {
                return foot;
            }
        }
        return searched_foot(point, near);
    }
    // A descent from the neighbouring place comes first: it stays on the same part of the surface where
    // another part is as near, and makes a search of the whole surface seldom necessary.
    [[nodiscard]] closest::Foot searched_foot(const double *point, const double *near) const {
        const Point2 guess = near != nullptr ? covering_.in_domain({near[0], near[1]}) : place_near(point);
        const closest::Locator &locator = closest::locator_of(surface_);
        const closest::Foot local = locator.local(point, guess.data());
        if (local.distance <= std::max(rule_.precision / 4, 2 * least_off_)) {
            return local;
        }
        const closest::Foot foot = locator.nearest(
            {point, nullptr, rule_.precision / 16, closest::usual_budget(surface_), false, true});
        effort_.spend(foot.examined);
        least_off_ = std::max(least_off_, foot.distance);
        return foot;
    }

    // The Greville abscissae of the control point nearest to a point: about where it has most influence.
    [[nodiscard]] Point2 place_near(const double *point) const {
        int64_t best = 0;
        double least = infinity;
        for (int64_t i = 0; i < surface_.point_count(); ++i) {
            const double away =
                norm_of(surface_.dim(), [&](int c) { return surface_.coordinate(i, c) - point[c]; });
            if (away < least) {
                least = away;
                best = i;
            }
        }
        const int64_t columns = surface_.count(1);
        return covering_.in_domain(
            {greville(surface_.axis(0), best / columns), greville(surface_.axis(1), best % columns)});
    }

    const Spline &surface_;
    const Covering &covering_;
    const Spline &edge_;
    const UnderRule &rule_;
    Effort &effort_;
    mutable double off_ = 0;       // the largest distance of a place of the edge from the surface
    mutable double least_off_ = 0; // the largest one found by a search of the whole surface
};

// The points of the surface over a curve in the plane that covers its domain.
class Image : public CurveModel {
public:
    Image(const Spline &surface, const Covering &covering, const Spline &curve)
        : surface_(surface), covering_(covering), curve_(curve) {}

    [[nodiscard]] int dim() const noexcept override { return surface_.dim(); }
    void place(double t, const double *, double *out) const override {
        const std::vector<double> point = points_over(surface_, covering_, points_at(curve_, {&t, 1}));
        std::copy(point.begin(), point.end(), out);
    }
    void errors(const Spline &candidate, std::span<const double> params, double *errors) const override {
        distances(points_over(surface_, covering_, points_at(curve_, params)), points_at(candidate, params),
                  dim(), errors);
    }

    [[nodiscard]] int64_t pieces_between(double t, const double *, double u, const double *) const override {
        const std::vector<double> places = points_at(curve_, std::array{t, u});
        return spans_between(surface_, covering_, places.data(), places.data() + 2);
    }

private:
    const Spline &surface_;
    const Covering &covering_;
    const Spline &curve_;
};

bool inside(const Covering &covering, const Spline &curve) noexcept {
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        for (const int k : {0, 1}) {
            const double x = curve.coordinate(i, k);
            if (!(covering.domain(k).lower <= x && x <= covering.domain(k).upper)) {
                return false;
            }
        }
    }
    return true;
}

std::vector<double> breaks_of(const Spline &curve) {
    return refine::rough_knots(curve.axis(0), 2);
}

// The coordinates on axis k, inside an interval and in all copies of the domain that it reaches, of the
// knot lines at which derivatives of a surface up to the second may jump. None if there are so many copies
// that kinks are everywhere.
std::vector<double> rough_lines(const Spline &surface, const Covering &covering, int k, double low,
                                double high) {
    std::vector<double> knots = refine::rough_knots(surface.axis(k), 2), lines;
    knots.pop_back();
    const bool closed = covering.closed(k);
    const auto copy_of = [&](double x) {
        return closed ? std::floor((x - covering.domain(k).lower) / covering.period(k)) : 0;
    };
    const double first = copy_of(low), more = copy_of(high) - first;
    if (!(more <= most_crossed_copies)) {
        return {};
    }
    for (int copy = 0; copy <= static_cast<int>(more); ++copy) {
        for (const double knot : knots) {
            const double line = knot + (first + copy) * (closed ? covering.period(k) : 0);
            if (low < line && line < high) {
                lines.push_back(line);
            }
        }
    }
    return lines;
}

// The breaks of a curve, and where it crosses rough lines of the surface: a fit across a kink would halve
// intervals until the bits of a parameter are used up.
std::vector<double> breaks_over_kinks(const Spline &surface, const Covering &covering,
                                      const SplinePtr &curve) {
    std::vector<double> all = breaks_of(*curve), breaks;
    const Interval domain = curve->axis(0).domain();
    TrimPieces pieces;
    append_monotone({{curve}}, 0, {0, 0}, pieces);
    for (const TrimPiece &piece : pieces.all()) {
        const bool closes = piece.range.lower == piece.range.upper; // a segment, not a part of the curve
        for (int k = 0; k < 2 && !closes; ++k) {
            const auto at = static_cast<size_t>(k);
            for (const double line : rough_lines(surface, covering, k, piece.lower[at], piece.upper[at])) {
                const double t = parameter_at(piece, pieces.place_of(piece, k, line));
                all.push_back(std::clamp(t, domain.lower, domain.upper));
            }
        }
    }
    std::ranges::sort(all);
    const double room = 0x1p-40 * (all.back() - all.front());
    for (const double t : all) {
        if (breaks.empty() || (t - breaks.back() > room && all.back() - t > room)) {
            breaks.push_back(t);
        }
    }
    breaks.push_back(all.back());
    return breaks;
}

// Where an edge is nearest to a pole that it passes, each time.
std::vector<double> places_at_pole(const Spline &edge, const std::vector<double> &pole,
                                   const UnderRule &rule) {
    const closest::Locator &locator = closest::locator_of(edge);
    const int64_t budget = closest::usual_budget(edge);
    std::vector<double> places;
    if (locator.nearest({pole.data(), nullptr, rule.precision / 16, budget, false, true}).distance >
        rule.tolerance) {
        return places;
    }
    for (const closest::CriticalPoint &point :
         locator.minima({pole.data(), nullptr, rule.tolerance, budget}).points) {
        places.push_back(point.foot.params[0]);
    }
    return places;
}

// The breaks of an edge and, wherever it passes a pole between breaks, the parameter nearest to the pole: on
// the other side of a pole the places of the edge are elsewhere in the domain.
std::vector<double> breaks_over(const Covering &covering, const Spline &edge, const UnderRule &rule) {
    std::vector<double> breaks = breaks_of(edge);
    for (const std::vector<double> &pole : covering.pole_points()) {
        const auto passes = [&](double t) {
            return distance(points_at(edge, {&t, 1}).data(), pole.data(), edge.dim()) <= rule.tolerance;
        };
        const auto is_same = [&](double t, double u) { return passes(u) && passes(t / 2 + u / 2); };
        for (const double t : places_at_pole(edge, pole, rule)) {
            const auto above = std::ranges::lower_bound(breaks, t);
            const bool inner = above != breaks.begin() && above != breaks.end();
            if (inner && passes(t) && !is_same(t, *above) && !is_same(t, *std::prev(above))) {
                breaks.insert(above, t);
            }
        }
    }
    return breaks;
}

// Steps along each axis that move points, on average over the domain, by less than a share of the tolerance.
std::array<double, 2> same_places(const Covering &covering, double tolerance) {
    const double size = covering.extent();
    const double share = size > 0 ? std::min(share_of_same * tolerance / size, 1e-3) : 0;
    return {share * covering.period(0), share * covering.period(1)};
}

// The distance in space at equal parameters; infinite where the surface cannot be composed with the curve.
double composed_distance(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                         const Spline &edge) {
    const SplinePtr over = composed_edge(surface, covering, curve);
    return over == nullptr ? infinity : bounds::deviation(*over, edge).upper;
}

// The chart of a plane parallelogram, if an edge is in the hull of its control points: if none of these is
// infinite or has a negative weight.
std::optional<PlaneChart> chart_for(const Spline &surface, const Spline &edge) {
    const bool in_hull = edge.form() != Form::homogeneous || edge.all_weights().smallest > 0;
    return in_hull ? PlaneChart::of(surface) : std::nullopt;
}

// How far a surface moves points, at most, whose parameters move so far.
double moved_by(const Spline &surface, const Point2 &off) {
    if (off == Point2{}) {
        return 0;
    }
    const std::array<double, 2> speeds = fastest(surface);
    return (off[0] > 0 ? speeds[0] * off[0] : 0) + (off[1] > 0 ? speeds[1] * off[1] : 0);
}

// The surface composed with the parts of a curve between seams, joined; none where that is not possible. Its
// distance is what setting the parts into the domain and joining them moves: each part but the first begins
// where the one before ends. By the hull of control points the latter is a bound where weights are positive.
std::optional<MadeCurve> composed_over_seams(const SplinePtr &surface, const Covering &covering,
                                             const SplinePtr &curve) {
    constexpr double rounding = 0x1p-36; // of the extent of the surface: how far seams may be open
    if (!covering.closed(0) && !covering.closed(1)) {
        return std::nullopt;
    }
    const SeamParts own = seam_parts(covering, curve);
    std::vector<SplinePtr> edges;
    for (const SplinePtr &part : own.parts) {
        edges.push_back(composed_edge(surface, covering, part));
        if (edges.back() == nullptr) {
            return std::nullopt;
        }
    }
    if (edges.empty()) {
        return std::nullopt;
    }
    const refine::Joined joined = refine::join(edges, 0, {infinity, false});
    if (!(joined.gap <= rounding * covering.extent())) {
        return std::nullopt;
    }
    const double distance = joined.gap + moved_by(*surface, own.off);
    const bool bounded =
        std::isfinite(distance) && (joined.gap == 0 || joined.spline->all_weights().smallest > 0);
    return MadeCurve{joined.spline, distance, bounded};
}

} // namespace

SplinePtr composed_edge(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve) {
    if (!inside(covering, *curve)) {
        return nullptr;
    }
    const bool plain = curve->form() != Form::homogeneous && !curve->axis(0).periodic();
    if (const auto chart = plain ? PlaneChart::of(*surface) : std::nullopt) {
        return chart->edge_over(*curve);
    }
    const int degrees = surface->axis(0).degree() + surface->axis(1).degree();
    return degrees * curve->axis(0).degree() > max_degree ? nullptr : refine::compose(surface, curve);
}

MadeCurve curve_under(const SplinePtr &surface, const Covering &covering, const SplinePtr &edge,
                      const UnderRule &rule, Effort &effort) {
    if (const auto chart = chart_for(*surface, *edge)) {
        return chart->curve_under(*edge, rule.tolerance);
    }
    const Projection model(*surface, covering, *edge, rule, effort);
    const FittedCurve fitted = fit_curve(model, breaks_over(covering, *edge, rule),
                                         same_places(covering, rule.precision), rule.precision, effort);
    const double found = rule.prove ? composed_distance(surface, covering, fitted.spline, *edge) : infinity;
    return std::isfinite(found) ? MadeCurve{fitted.spline, found, true}
                                : MadeCurve{fitted.spline, fitted.error, false};
}

double proven_distance(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                       const Spline &edge) {
    const auto chart = chart_for(*surface, edge);
    return chart ? chart->distance_between(*curve, edge) : composed_distance(surface, covering, curve, edge);
}

MadeCurve edge_over(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                    double tolerance) {
    if (SplinePtr exact = composed_edge(surface, covering, curve)) {
        return {std::move(exact), 0, true};
    }
    if (auto joined = composed_over_seams(surface, covering, curve)) {
        return *std::move(joined);
    }
    const std::vector<double> same(static_cast<size_t>(surface->dim()), 0);
    Effort effort;
    effort.allow(*curve);
    const FittedCurve fitted =
        fit_curve(Image(*surface, covering, *curve), breaks_over_kinks(*surface, covering, curve), same,
                  share_of_fit * tolerance, effort);
    return {fitted.spline, fitted.error, false};
}

} // namespace nrb::face
