/* SPDX-License-Identifier: MIT */
/// \file analysis.hpp
/// \brief Features of curves and surfaces; `complete` tells that nothing was missed.
#ifndef NURBS_CPP_ANALYSIS_HPP
#define NURBS_CPP_ANALYSIS_HPP

#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Features of curves, any sum of which may be asked for.
inline constexpr std::uint32_t feature_inflection = NURBS_FEATURE_INFLECTION;
inline constexpr std::uint32_t feature_curvature_maximum = NURBS_FEATURE_CURVATURE_MAXIMUM;
inline constexpr std::uint32_t feature_curvature_minimum = NURBS_FEATURE_CURVATURE_MINIMUM;
inline constexpr std::uint32_t feature_cusp = NURBS_FEATURE_CUSP;
inline constexpr std::uint32_t feature_kink = NURBS_FEATURE_KINK;
inline constexpr std::uint32_t feature_jump = NURBS_FEATURE_JUMP;
inline constexpr std::uint32_t feature_torsion = NURBS_FEATURE_TORSION;

/// Convexity of a curve in the plane.
inline constexpr std::int32_t convexity_none = NURBS_CONVEXITY_NONE;
inline constexpr std::int32_t convexity_left = NURBS_CONVEXITY_LEFT;
inline constexpr std::int32_t convexity_right = NURBS_CONVEXITY_RIGHT;
inline constexpr std::int32_t convexity_straight = NURBS_CONVEXITY_STRAIGHT;
inline constexpr std::int32_t convexity_undecided = NURBS_CONVEXITY_UNDECIDED;

/// Folds.
inline constexpr std::int32_t fold_none = NURBS_FOLD_NONE;
inline constexpr std::int32_t fold_found = NURBS_FOLD_FOUND;
inline constexpr std::int32_t fold_undecided = NURBS_FOLD_UNDECIDED;

/// Parameters in rising order, one feature_ constant each, and curvature, turning angle or width there.
struct CurveFeatures {
    std::vector<double> params;
    std::vector<std::uint32_t> found;
    std::vector<double> values;
    bool complete;
};

/// The features of these kinds along a curve.
inline Returned<CurveFeatures> features(const Spline &g, std::uint32_t kinds) {
    CurveFeatures result{};
    std::vector<std::int32_t> found;
    std::int64_t count = 0;
    std::int32_t complete = 0;
    const auto call = [&](std::int64_t cap) {
        detail::call(nurbs_curve_features, g.get(), kinds, cap, result.params.data(), found.data(),
                     result.values.data(), &count, &complete);
    };
    call(0);
    result.params.resize(detail::to_size(count));
    found.resize(detail::to_size(count));
    result.values.resize(detail::to_size(count));
    call(count);
    result.found.assign(found.begin(), found.end());
    result.complete = complete != 0;
    return result;
}

/// Lower ends of pieces, and 1, -1 or 0 where the curve rises, falls or stays.
struct MonotonePieces {
    std::vector<double> starts;
    std::vector<std::int32_t> signs;
    bool complete;
};

/// The pieces of a curve on which it runs one way along a direction [dim].
inline Returned<MonotonePieces> monotone_pieces(const Spline &g, View<double> direction) {
    const double *along = detail::point_of(g, direction, "direction");
    MonotonePieces found{};
    std::int64_t count = 0;
    std::int32_t complete = 0;
    const auto call = [&](std::int64_t cap) {
        detail::call(nurbs_curve_monotone_pieces, g.get(), along, cap, found.starts.data(),
                     found.signs.data(), &count, &complete);
    };
    call(0);
    found.starts.resize(detail::to_size(count));
    found.signs.resize(detail::to_size(count));
    call(count);
    found.complete = complete != 0;
    return found;
}

/// One of the convexity_ constants.
inline Returned<std::int32_t> convexity(const Spline &g) {
    return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_curve_convexity(g.get(), v); });
}

/// A line, and a proven bound of the distance from it.
struct Straightness {
    std::vector<double> origin;
    std::vector<double> direction;
    double bound;
};

/// How far a spline is from a straight line.
inline Returned<Straightness> straightness(const Spline &g) {
    const auto dim = detail::to_size(detail::dimension(g.get()));
    Straightness found{std::vector<double>(dim), std::vector<double>(dim), 0};
    detail::call(nurbs_straightness, g.get(), found.origin.data(), found.direction.data(), &found.bound);
    return found;
}

/// A plane, and a proven bound of the distance from it.
struct Planarity {
    std::array<double, 3> origin;
    std::array<double, 3> normal;
    double bound;
};

/// How far a spline in space is from a plane.
inline Returned<Planarity> planarity(const Spline &g) {
    Planarity found{};
    detail::call(nurbs_planarity, g.get(), found.origin.data(), found.normal.data(), &found.bound);
    return found;
}

/// Of each axis whether it closes and a bound of the gap; of each boundary, counted by axis, then by end,
/// whether it collapses and its size.
struct BoundaryContacts {
    std::vector<std::int32_t> closed;
    std::vector<double> gaps;
    std::vector<std::int32_t> collapsed;
    std::vector<double> sizes;
};

inline Returned<BoundaryContacts> boundary_contacts(const Spline &g, double tolerance = 0) {
    const auto axes = detail::to_size(detail::axes(g.get()));
    BoundaryContacts found{std::vector<std::int32_t>(axes), std::vector<double>(axes),
                           std::vector<std::int32_t>(2 * axes), std::vector<double>(2 * axes)};
    detail::call(nurbs_boundary_contacts, g.get(), tolerance, found.closed.data(), found.gaps.data(),
                 found.collapsed.data(), found.sizes.data());
    return found;
}

/// Parameters [n][axes], and the boxes [n][axes][2] in which the singular sets lie.
struct SingularPoints {
    std::vector<double> params;
    std::vector<double> boxes;
    bool complete;
};

/// Places where a curve or surface is singular; the tolerance is a part of the domain.
inline Returned<SingularPoints> singular_points(const Spline &g, double tolerance) {
    SingularPoints found{};
    std::int64_t count = 0;
    std::int32_t complete = 0;
    const auto call = [&](std::int64_t cap) {
        detail::call(nurbs_singular_points, g.get(), tolerance, cap, found.params.data(), found.boxes.data(),
                     &count, &complete);
    };
    call(0);
    found.params.resize(detail::to_size(count * detail::axes(g.get())));
    found.boxes.resize(2 * found.params.size());
    call(count);
    found.complete = complete != 0;
    return found;
}

/// One of the fold_ constants, and parameters [axes] of either sign, NaN if none are known.
struct Fold {
    std::int32_t result;
    std::vector<double> positive;
    std::vector<double> negative;
};

/// Whether a surface or volume folds over; reference [3] is the direction that normals are compared with, if
/// any.
inline Returned<Fold> fold_test(const Spline &g, View<double> reference = {}) {
    const auto axes = detail::to_size(detail::axes(g.get()));
    Fold found{0, std::vector<double>(axes), std::vector<double>(axes)};
    detail::call(nurbs_fold_test, g.get(), detail::if_given(std::span(reference), 3, "reference"),
                 &found.result, found.positive.data(), found.negative.data());
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_ANALYSIS_HPP
