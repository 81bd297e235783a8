/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
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

/// Kinds of extrema, any sum of which may be asked for.
inline constexpr std::uint32_t extremum_minimum = NURBS_EXTREMUM_MINIMUM;
inline constexpr std::uint32_t extremum_maximum = NURBS_EXTREMUM_MAXIMUM;
inline constexpr std::uint32_t extremum_saddle = NURBS_EXTREMUM_SADDLE;
inline constexpr std::uint32_t extremum_plateau = NURBS_EXTREMUM_PLATEAU;
inline constexpr std::uint32_t extremum_undecided = NURBS_EXTREMUM_UNDECIDED;

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
    std::vector<double> params;       ///< In rising order.
    std::vector<std::uint32_t> found; ///< One of the feature_ constants each.
    std::vector<double> values;       ///< Curvature, turning angle or width there.
    bool complete;                    ///< Whether nothing was missed.
};

/// The features along a curve of these kinds, a sum of feature_ constants.
inline Returned<CurveFeatures> features(const Spline &g, std::uint32_t kinds) {
    CurveFeatures found{};
    std::vector<std::int32_t> found_bits;
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_features, g.get(), kinds, cap, found.params.data(), found_bits.data(),
                     found.values.data(), &count, &complete);
    };
    ask(0);
    found.params = detail::room(count);
    found_bits = detail::room<std::int32_t>(count);
    found.values = detail::room(count);
    ask(count);
    found.found.assign(found_bits.begin(), found_bits.end());
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<CurveFeatures> features(const Spline &g, std::uint32_t kinds, const CallOptions &call) {
    CurveFeatures found{};
    const detail::Watch watch(call);
    std::vector<std::int32_t> found_bits;
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_features_with, g.get(), kinds, cap, found.params.data(), found_bits.data(),
                     found.values.data(), &count, &complete, watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found_bits = detail::room<std::int32_t>(count);
    found.values = detail::room(count);
    ask(count);
    found.found.assign(found_bits.begin(), found_bits.end());
    found.complete = complete != 0;
    return found;
}

/// Parameters [n][axes], the values there, a sum of extremum_ constants each, and the boxes [n][axes][2]
/// outside of which there is nothing.
struct Extrema {
    std::vector<double> params;       ///< [n][axes], in rising order of the first axis, then the second.
    std::vector<double> values;       ///< Of the spline there.
    std::vector<std::uint32_t> found; ///< A sum of extremum_ constants each.
    std::vector<double> boxes;        ///< Ranges of parameters, [n][axes] of lower and upper ends.
    bool complete;                    ///< Whether nothing is undecided.
};

/// Local extrema, saddles and plateaus of a scalar spline that have one of these kinds, a sum of extremum_
/// constants.
inline Returned<Extrema> extrema(const Spline &g, std::uint32_t kinds) {
    Extrema found{};
    std::vector<std::int32_t> found_bits;
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_extrema, g.get(), kinds, cap, found.params.data(), found.values.data(),
                     found_bits.data(), found.boxes.data(), &count, &complete);
    };
    ask(0);
    const std::int64_t axes = detail::axes(g.get());
    found.params = detail::room(count, axes);
    found.values = detail::room(count);
    found_bits = detail::room<std::int32_t>(count);
    found.boxes = detail::room(count, axes, 2);
    ask(count);
    found.found.assign(found_bits.begin(), found_bits.end());
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Extrema> extrema(const Spline &g, std::uint32_t kinds, const CallOptions &call) {
    Extrema found{};
    const detail::Watch watch(call);
    std::vector<std::int32_t> found_bits;
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_extrema_with, g.get(), kinds, cap, found.params.data(), found.values.data(),
                     found_bits.data(), found.boxes.data(), &count, &complete, watch.get());
    };
    ask(0);
    const std::int64_t axes = detail::axes(g.get());
    found.params = detail::room(count, axes);
    found.values = detail::room(count);
    found_bits = detail::room<std::int32_t>(count);
    found.boxes = detail::room(count, axes, 2);
    ask(count);
    found.found.assign(found_bits.begin(), found_bits.end());
    found.complete = complete != 0;
    return found;
}

/// Lower ends of pieces, and 1, -1 or 0 where the curve rises, falls or stays.
struct MonotonePieces {
    std::vector<double> starts;      ///< Lower ends.
    std::vector<std::int32_t> signs; ///< 1, -1 or 0 where the curve rises, falls or stays.
    bool complete;                   ///< Whether nothing was missed.
};

/// The pieces of a curve on which it runs one way along a direction [dim].
inline Returned<MonotonePieces> monotone_pieces(const Spline &g, View<double> direction) {
    detail::require(direction, detail::dimension(g.get()), "direction");
    MonotonePieces found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_monotone_pieces, g.get(), direction.data(), cap, found.starts.data(),
                     found.signs.data(), &count, &complete);
    };
    ask(0);
    found.starts = detail::room(count);
    found.signs = detail::room<std::int32_t>(count);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// One of the convexity_ constants, of a curve in the plane.
inline Returned<std::int32_t> convexity(const Spline &g) {
    return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_curve_convexity(g.get(), v); });
}

/// A line, and a proven bound of the distance from it.
struct Straightness {
    std::vector<double> origin;    ///< A point of the line, [dim].
    std::vector<double> direction; ///< Its direction, [dim].
    double bound;                  ///< A proven bound of the distance from it.
};

/// How far a spline is from a straight line.
inline Returned<Straightness> straightness(const Spline &g) {
    const std::int64_t dim = detail::dimension(g.get());
    Straightness found{detail::room(dim), detail::room(dim), 0};
    detail::call(nurbs_straightness, g.get(), found.origin.data(), found.direction.data(), &found.bound);
    return found;
}

/// A plane, and a proven bound of the distance from it.
struct Planarity {
    std::array<double, 3> origin; ///< A point of the plane.
    std::array<double, 3> normal; ///< Its unit normal.
    double bound;                 ///< A proven bound of the distance from it.
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
    std::vector<std::int32_t> closed;    ///< Of each axis, whether it closes.
    std::vector<double> gaps;            ///< Of each axis, a bound of the gap.
    std::vector<std::int32_t> collapsed; ///< Of each boundary, by axis, then by end, whether it is a point.
    std::vector<double> sizes;           ///< Of each boundary, its size.
};

/// Which axes close, and which boundaries collapse.
inline Returned<BoundaryContacts> boundary_contacts(const Spline &g, double tolerance = 0) {
    const std::int64_t axes = detail::axes(g.get());
    BoundaryContacts found{detail::room<std::int32_t>(axes), detail::room(axes),
                           detail::room<std::int32_t>(2 * axes), detail::room(2 * axes)};
    detail::call(nurbs_boundary_contacts, g.get(), tolerance, found.closed.data(), found.gaps.data(),
                 found.collapsed.data(), found.sizes.data());
    return found;
}

/// Parameters [n][axes], and the boxes [n][axes][2] in which the singular sets lie.
struct SingularPoints {
    std::vector<double> params; ///< [n][axes]
    std::vector<double> boxes;  ///< Boxes in which the singular sets lie, [n][axes] of lower and upper ends.
    bool complete;              ///< Whether nothing was missed.
};

/// Places where a curve or surface is singular; the tolerance is a part of the domain.
inline Returned<SingularPoints> singular_points(const Spline &g, double tolerance) {
    SingularPoints found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_singular_points, g.get(), tolerance, cap, found.params.data(), found.boxes.data(),
                     &count, &complete);
    };
    ask(0);
    const std::int64_t axes = detail::axes(g.get());
    found.params = detail::room(count, axes);
    found.boxes = detail::room(count, axes, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Which polynomial pieces of a surface or volume fold over.
struct FoldPieces {
    std::vector<std::int32_t> folds; ///< A fold_ constant for each piece.
    /// 1 or -1: the sign of J where it is not 0, if there is no fold; else 0.
    std::vector<std::int32_t> signs;
};

/// Which polynomial pieces fold over, each by itself, in the order of the Bezier pieces; reference as for
/// fold_test.
inline Returned<FoldPieces> fold_pieces(const Spline &g, View<double> reference = {}) {
    detail::require_given(reference, 3, "reference");
    FoldPieces found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_fold_pieces, g.get(), detail::pointer(reference), cap, found.folds.data(),
                     found.signs.data(), &count);
    };
    ask(0);
    found.folds = detail::room<std::int32_t>(count);
    found.signs = detail::room<std::int32_t>(count);
    ask(count);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<FoldPieces> fold_pieces(const Spline &g, View<double> reference, const CallOptions &call) {
    detail::require_given(reference, 3, "reference");
    FoldPieces found{};
    const detail::Watch watch(call);
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_fold_pieces_with, g.get(), detail::pointer(reference), cap, found.folds.data(),
                     found.signs.data(), &count, watch.get());
    };
    ask(0);
    found.folds = detail::room<std::int32_t>(count);
    found.signs = detail::room<std::int32_t>(count);
    ask(count);
    return found;
}

/// One of the fold_ constants, and parameters [axes] of either sign, NaN if none are known.
struct Fold {
    std::int32_t result;          ///< One of the fold_ constants.
    std::vector<double> positive; ///< Parameters [axes] where the sign is positive, NaN if none are known.
    std::vector<double> negative; ///< Parameters [axes] where the sign is negative, NaN if none are known.
};

/// Whether a surface or volume folds over; reference [3] is the direction that normals are compared with, if
/// any.
inline Returned<Fold> fold_test(const Spline &g, View<double> reference = {}) {
    detail::require_given(reference, 3, "reference");
    const std::int64_t axes = detail::axes(g.get());
    Fold found{0, detail::room(axes), detail::room(axes)};
    detail::call(nurbs_fold_test, g.get(), detail::pointer(reference), &found.result, found.positive.data(),
                 found.negative.data());
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Fold> fold_test(const Spline &g, View<double> reference, const CallOptions &call) {
    detail::require_given(reference, 3, "reference");
    const std::int64_t axes = detail::axes(g.get());
    Fold found{0, detail::room(axes), detail::room(axes)};
    const detail::Watch watch(call);
    detail::call(nurbs_fold_test_with, g.get(), detail::pointer(reference), &found.result,
                 found.positive.data(), found.negative.data(), watch.get());
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_ANALYSIS_HPP
