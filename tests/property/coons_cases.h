// Boundaries of surfaces at random: curves of any form that meet at the corners.
#pragma once

#include "property/same_shape.h"
#include "reference/boundary_blend.h"
#include "reference/quotients.h"

#include <array>

namespace support {

using Corner = std::array<double, 3>;

inline nurbs_status coons(const std::vector<Handle> &curves, double tolerance, Handle &out) {
    std::array<const nurbs *, 4> handles{};
    std::transform(curves.begin(), curves.end(), handles.begin(), [](const Handle &h) { return h.get(); });
    nurbs *made = nullptr;
    const nurbs_status status = nurbs_surface_coons(handles.data(), tolerance, &made);
    out.reset(made);
    return status;
}

inline std::vector<Handle> handles_of(const std::vector<SplineData> &curves) {
    std::vector<Handle> handles;
    for (const SplineData &curve : curves) {
        handles.push_back(create(curve));
    }
    return handles;
}

inline std::vector<const nurbs *> pointers(const std::vector<Handle> &handles) {
    std::vector<const nurbs *> result;
    for (const Handle &handle : handles) {
        result.push_back(handle.get());
    }
    return result;
}

inline Corner end_of(const SplineData &curve, bool upper) {
    const std::vector<double> point = eval(create(curve).get(), {upper ? curve.upper(0) : curve.lower(0)});
    return {point[0], point[1], point[2]};
}

// Moves a curve by an affine map, which takes its ends to two places: x + (start - its start) + the rest of
// the way in proportion to the place along the chord. Clamped ends are bit for bit there.
inline void move_ends(SplineData &curve, const Corner &start, const Corner &end) {
    const Corner from = end_of(curve, false), to = end_of(curve, true);
    double square = 0;
    for (size_t c = 0; c < 3; ++c) {
        square += (to[c] - from[c]) * (to[c] - from[c]);
    }
    for (size_t i = 0; i < curve.points.size(); i += 3) {
        double along = 0;
        for (size_t c = 0; c < 3 && square > 0; ++c) {
            along += (curve.points[i + c] - from[c]) * (to[c] - from[c]) / square;
        }
        for (size_t c = 0; c < 3; ++c) {
            curve.points[i + c] += start[c] - from[c] + along * ((end[c] - start[c]) - (to[c] - from[c]));
        }
    }
    const std::vector<double> &t = curve.knots[0];
    const auto p = static_cast<size_t>(curve.degrees[0]), n = static_cast<size_t>(curve.counts[0]);
    if (t[0] == t[p]) {
        std::copy(start.begin(), start.end(), curve.points.begin());
    }
    if (t[n] == t[n + p]) {
        std::copy(end.begin(), end.end(), curve.points.end() - 3);
    }
}

// A curve over [0, 8] with knots that are multiples of 1/8; it may jump at some.
inline SplineData random_boundary(Random &random, int degree, KnotForm form, Weights weights) {
    SplineData curve;
    curve.dim = 3;
    curve.degrees = {degree};
    const int inner = random.whole(0, 4), p = degree;
    std::vector<double> inside;
    for (int i = 0; i < inner; ++i) {
        inside.push_back(random.whole(1, 63) / 8.0);
    }
    std::sort(inside.begin(), inside.end());
    if (!inside.empty() && random.chance(20)) {
        inside.insert(inside.begin(), static_cast<size_t>(p), inside[0]);
    }
    for (size_t i = inside.size(); i-- > 0;) { // none more often than allowed
        if (std::count(inside.begin(), inside.end(), inside[i]) > p + 1) {
            inside.erase(inside.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    std::vector<double> knots{0};
    knots.insert(knots.end(), inside.begin(), inside.end());
    knots.push_back(8);
    const bool loose_start = form == KnotForm::unclamped, loose_end = form != KnotForm::clamped;
    for (int i = 1; i <= p; ++i) {
        knots.insert(knots.begin(), loose_start ? -0.5 * i : 0);
        knots.push_back(loose_end ? 8 + 0.25 * i : 8);
    }
    curve.counts = {static_cast<int64_t>(knots.size()) - p - 1};
    curve.knots = {std::move(knots)};
    for (int64_t i = 0; i < 3 * curve.counts[0]; ++i) {
        curve.points.push_back(random.between(-1, 1));
    }
    for (int64_t i = 0; i < curve.counts[0] && weights != Weights::none; ++i) {
        curve.weights.push_back(random.between(0.2, 5));
    }
    return curve;
}

// The same over [lower, lower + 2], exactly.
inline SplineData mapped(SplineData curve, double lower) {
    for (double &t : curve.knots[0]) {
        t = t / 4 + lower;
    }
    return curve;
}

inline double size_of(const reference::Rational &x) {
    return static_cast<double>(std::fabs(
        reference::quotient(boost::multiprecision::numerator(x), boost::multiprecision::denominator(x))));
}

// Largest difference of a coordinate of an exact point.
inline double difference(const reference::Point &a, const reference::Point &b) {
    double largest = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        largest = std::max(largest, size_of(a[c] - b[c]));
    }
    return largest;
}

// Largest error of a surface at places of its domain, which few bits name.
inline double formula_error(const SplineData &surface, const reference::BoundaryBlend &formula,
                            Random &random) {
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
        const double u = random.whole(0, 256) / 32.0, v = random.whole(0, 256) / 32.0;
        largest = std::max(largest, difference(reference::exact_value(surface, {u, v}), formula.value(u, v)));
    }
    return largest;
}

struct Boundaries {
    std::vector<SplineData> curves;
    double gap = 0; // largest, of any corner
};

inline double largest_gap(const std::vector<Handle> &curves) {
    const std::vector<const nurbs *> handles = pointers(curves);
    double gaps[4];
    require_ok(nurbs_coons_gaps(handles.data(), nullptr, gaps, nullptr, nullptr));
    return *std::max_element(gaps, gaps + 4);
}

// Four curves that meet at random corners; clamped ones exactly.
inline Boundaries random_boundaries(Random &random, int max_degree, bool rational, bool clamped) {
    std::array<Corner, 4> corners{};
    for (Corner &corner : corners) {
        for (double &x : corner) {
            x = random.between(-1, 1);
        }
    }
    static constexpr std::array<std::array<size_t, 2>, 4> ends{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
    Boundaries result;
    for (const auto &[start, end] : ends) {
        const KnotForm form = clamped
                                  ? KnotForm::clamped
                                  : std::array{KnotForm::clamped, KnotForm::half_clamped,
                                               KnotForm::unclamped}[static_cast<size_t>(random.whole(0, 2))];
        const Weights weights = rational && random.chance(70) ? Weights::moderate : Weights::none;
        SplineData curve = random_boundary(random, random.whole(1, max_degree), form, weights);
        move_ends(curve, corners[start], corners[end]);
        result.curves.push_back(std::move(curve));
    }
    result.gap = largest_gap(handles_of(result.curves));
    return result;
}

} // namespace support
