// Lengths, areas and moments by name, and shapes to measure.
#pragma once

#include "length_oracle.h"
#include "support/cases.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace support::measures {

inline constexpr double double_eps = 0x1p-52;
inline constexpr double pi = std::numbers::pi;
inline constexpr double origin[] = {0, 0, 0}, up[] = {0, 0, 1}, right[] = {1, 0, 0};

struct Measured {
    double value = 0;
    double error = 0;
};

inline Measured length(const nurbs *g, double tolerance = 0, const std::vector<double> &range = {}) {
    Measured m;
    require_ok(nurbs_curve_length(g, range.empty() ? nullptr : range.data(), tolerance, &m.value, &m.error));
    return m;
}

inline Measured area(const nurbs *g, double tolerance = 0, const std::vector<double> &range = {}) {
    Measured m;
    require_ok(nurbs_surface_area(g, range.empty() ? nullptr : range.data(), tolerance, &m.value, &m.error));
    return m;
}

struct Body {
    double content = 0, error = 0, openness = 0;
    std::vector<double> centroid, inertia;
};

inline Body moments(const nurbs *g, int dim, double tolerance = 1e-12) {
    Body b;
    b.centroid.resize(static_cast<size_t>(dim));
    b.inertia.resize(static_cast<size_t>(dim * dim));
    require_ok(nurbs_moments(g, tolerance, &b.content, b.centroid.data(), b.inertia.data(), &b.error));
    return b;
}

inline Body enclosed_volume(const std::vector<const nurbs *> &surfaces, double tolerance = 1e-12) {
    Body b;
    b.centroid.resize(3);
    b.inertia.resize(9);
    require_ok(nurbs_enclosed_volume(static_cast<int64_t>(surfaces.size()), surfaces.data(), tolerance,
                                     &b.content, b.centroid.data(), b.inertia.data(), &b.openness, &b.error));
    return b;
}

inline Body enclosed_area(const std::vector<const nurbs *> &curves, double tolerance = 1e-12) {
    Body b;
    b.centroid.resize(2);
    b.inertia.resize(4);
    require_ok(nurbs_enclosed_area(static_cast<int64_t>(curves.size()), curves.data(), 1e-9, tolerance,
                                   &b.content, b.centroid.data(), b.inertia.data(), &b.error));
    return b;
}

inline std::vector<double> lengths_at(const nurbs *g, const std::vector<double> &params) {
    std::vector<double> out(params.size());
    require_ok(
        nurbs_curve_lengths(g, static_cast<int64_t>(params.size()), params.data(), 0, 1e-12, out.data(), 0));
    return out;
}

inline std::vector<double> params_at(const nurbs *g, const std::vector<double> &lengths, uint32_t flags = 0) {
    std::vector<double> out(lengths.size());
    require_ok(nurbs_curve_params_at_lengths(g, static_cast<int64_t>(lengths.size()), lengths.data(), 0,
                                             1e-12, out.data(), 0, flags));
    return out;
}

inline Handle ellipse(double a, double b, int32_t form = 0) {
    return made([&](nurbs **out) {
        return nurbs_curve_ellipse(2, origin, nullptr, right, a, b, 0, 2 * pi, form, out);
    });
}
inline Handle ellipsoid(double a, double b, double c, int32_t form = 0) {
    return made([&](nurbs **out) { return nurbs_surface_ellipsoid(origin, up, right, a, b, c, form, out); });
}
inline Handle torus(double major, double minor, int32_t form = 0) {
    return made([&](nurbs **out) {
        return nurbs_surface_torus(origin, up, right, major, minor, 0, 2 * pi, 0, 2 * pi, form, out);
    });
}

inline SplineData bezier(int dim, const std::vector<double> &points,
                         const std::vector<double> &weights = {}) {
    SplineData data;
    const auto n = static_cast<int>(points.size()) / dim;
    data.degrees = {n - 1};
    data.counts = {n};
    data.knots = {std::vector<double>(static_cast<size_t>(n), 0.0)};
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(n), 1.0);
    data.dim = dim;
    data.points = points;
    data.weights = weights;
    return data;
}

// A curve that wanders, of spans of which none is much longer than another.
inline SplineData tangle(Random &random, int degree, int count, int dim, bool rational) {
    SplineData data;
    data.degrees = {degree};
    data.counts = {count};
    data.knots = {std::vector<double>(static_cast<size_t>(degree) + 1, 0.0)};
    for (int i = degree + 1; i < count; ++i) {
        data.knots[0].push_back(data.knots[0].back() + random.between(0.3, 2));
    }
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(degree) + 1, data.knots[0].back() + 1);
    data.dim = dim;
    for (int i = 0; i < count * dim; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    for (int i = 0; rational && i < count; ++i) {
        data.weights.push_back(random.magnitude(0.3, 3));
    }
    return data;
}

} // namespace support::measures
