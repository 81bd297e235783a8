// SPDX-License-Identifier: MIT
#include "face/covering.h"

#include "analysis/contacts.h"
#include "base/numbers.h"
#include "bounds/box.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// Along each end of an axis, so many points are compared before anything is proven.
constexpr int samples = 4;

// Points along both ends of an axis: those of the lower end, then those of the upper one.
std::vector<double> end_points(const Spline &surface, int k) {
    std::vector<double> params;
    for (const bool upper : {false, true}) {
        for (int i = 0; i < samples; ++i) {
            const Interval across = surface.axis(k).domain(), along = surface.axis(1 - k).domain();
            const double place = i / (samples - 1.0);
            Point2 x;
            x[static_cast<size_t>(k)] = upper ? across.upper : across.lower;
            x[static_cast<size_t>(1 - k)] =
                std::clamp(along.lower * (1 - place) + along.upper * place, along.lower, along.upper);
            params.insert(params.end(), x.begin(), x.end());
        }
    }
    const int dim = surface.dim();
    std::vector<double> points(static_cast<size_t>(2 * samples * dim));
    eval::AxisRules rules{};
    eval::evaluate_points(surface, rules, 0, {params.data(), 2 * samples, 2, 2, 1},
                          {points.data(), 2 * samples, dim, dim, 1});
    return points;
}

// What the samples do not rule out. They allow for the rounding of evaluation, a small multiple of their
// magnitude.
struct Suspicion {
    bool closed = true;
    std::array<bool, 2> collapsed{true, true};
};

Suspicion suspicion(const Spline &surface, int k, double tolerance) {
    const std::vector<double> points = end_points(surface, k);
    const int dim = surface.dim();
    double magnitude = 0;
    for (const double x : points) {
        magnitude = std::max(magnitude, std::abs(x));
    }
    const double most = 2 * tolerance + 1e-12 * magnitude;
    const auto point = [&](int end, int i) { return points.data() + (end * samples + i) * dim; };
    Suspicion result;
    for (int i = 0; i < samples; ++i) {
        result.closed = result.closed && distance(point(0, i), point(1, i), dim) <= most;
        for (const int end : {0, 1}) {
            bool &collapsed = result.collapsed[static_cast<size_t>(end)];
            collapsed = collapsed && distance(point(end, 0), point(end, i), dim) <= most;
        }
    }
    return result;
}

// The exponent is limited, because the period may be denormal, or its reciprocal may overflow.
double unit_of(double period) noexcept {
    constexpr int most = 1000;
    return std::exp2(-std::clamp(std::ilogb(period), -most, most));
}

} // namespace

std::vector<double> point_at(const Spline &surface, const Point2 &x) {
    std::vector<double> point(static_cast<size_t>(surface.dim()));
    eval::evaluate_points(surface, {}, 0, {x.data(), 1, 2, 2, 1},
                          {point.data(), 1, surface.dim(), surface.dim(), 1});
    return point;
}

Covering::Covering(const Spline &surface, double tolerance)
    : domain_{surface.axis(0).domain(), surface.axis(1).domain()}, extent_(bounds::extent(surface)) {
    for (const int k : {0, 1}) {
        const Suspicion possible = suspicion(surface, k, tolerance);
        for (const int end : {0, 1}) {
            if (possible.collapsed[static_cast<size_t>(end)] &&
                analysis::boundary_size(surface, k, end == 1, tolerance).collapsed) {
                add_pole(surface, k, end);
            }
        }
        // Two poles in one place, or an axis of no extent, do not make an axis closed.
        closed_[static_cast<size_t>(k)] = possible.closed && !(collapsed(k, 0) && collapsed(k, 1)) &&
                                          analysis::axis_contact(surface, k, tolerance).closed;
    }
}

double Covering::reach(int k) const noexcept {
    return std::max({period(k), std::abs(domain(k).lower), std::abs(domain(k).upper)});
}

Point2 Covering::in_domain(Point2 x) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const Interval range = domain_[k];
        if (closed_[k] && !(range.lower <= x[k] && x[k] <= range.upper)) {
            const double period = range.upper - range.lower;
            x[k] -= std::floor((x[k] - range.lower) / period) * period;
        }
        x[k] = std::clamp(x[k], range.lower, range.upper);
    }
    return x;
}

Point2 Covering::canonical(Point2 x) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const Interval range = domain_[k];
        if (closed_[k] && !(range.lower <= x[k] && x[k] < range.upper)) {
            const double length = period(static_cast<int>(k));
            x[k] -= std::floor((x[k] - range.lower) / length) * length;
            x[k] = x[k] < range.upper ? std::max(x[k], range.lower) : range.lower;
        }
    }
    return x;
}

Covering Covering::begun_at(const Point2 &lower) const {
    Covering result = *this;
    for (size_t k = 0; k < 2; ++k) {
        if (closed_[k]) {
            result.domain_[k] = {lower[k], lower[k] + period(static_cast<int>(k))};
        }
    }
    return result;
}

Covering Covering::over_moved(const Spline &surface) const {
    Covering result = *this;
    result.extent_ = bounds::extent(surface);
    result.poles_.clear();
    for (const PolePoint &pole : poles_) {
        result.add_pole(surface, pole.pole.axis, pole.pole.end);
    }
    return result;
}

Point2 Covering::units() const noexcept {
    return {unit_of(period(0)), unit_of(period(1))};
}

Point2 Covering::nearest_copy(Point2 x, const Point2 &to) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        if (closed_[k]) {
            const double length = period(static_cast<int>(k));
            x[k] += std::round((to[k] - x[k]) / length) * length;
        }
    }
    return x;
}

void Covering::add_pole(const Spline &surface, int k, int end) {
    collapsed_[static_cast<size_t>(k)][static_cast<size_t>(end)] = true;
    Point2 x{domain_[0].lower, domain_[1].lower};
    x[static_cast<size_t>(k)] = end == 0 ? domain(k).lower : domain(k).upper;
    poles_.push_back({{k, end}, point_at(surface, x)});
}

std::vector<std::vector<double>> Covering::pole_points() const {
    std::vector<std::vector<double>> points;
    for (const PolePoint &pole : poles_) {
        points.push_back(pole.point);
    }
    return points;
}

Covering::Pole Covering::pole_near(const double *point, double distance) const noexcept {
    for (const PolePoint &pole : poles_) {
        if (nrb::distance(point, pole.point.data(), static_cast<int>(pole.point.size())) <= distance) {
            return pole.pole;
        }
    }
    return {};
}

SplinePtr scaled_copy(const Spline &curve, const Point2 &scale, const Point2 &move) {
    const double matrix[] = {scale[0], 0, 0, scale[1]};
    return refine::transform(curve, {2, 2, matrix}, move.data());
}

double gap_between(const Spline &surface, const Covering &covering, const Point2 &a, const Point2 &b) {
    const std::vector<double> from = point_at(surface, covering.in_domain(a)),
                              to = point_at(surface, covering.in_domain(b));
    return distance(from.data(), to.data(), surface.dim());
}

} // namespace nrb::face
