/* SPDX-License-Identifier: MIT */
/// \file status.hpp
/// \brief Statuses, flags and messages.
#ifndef NURBS_CPP_STATUS_HPP
#define NURBS_CPP_STATUS_HPP

#include <nurbs/nurbs.h>

#include <cstdint>
#include <string>

namespace libnurbs {

/// The statuses of nurbs.h. Values without a name here may occur.
enum class Status : nurbs_status {
    ok = NURBS_OK,
    null = NURBS_ERROR_NULL,
    axes = NURBS_ERROR_AXES,
    axis = NURBS_ERROR_AXIS,
    degree = NURBS_ERROR_DEGREE,
    count = NURBS_ERROR_COUNT,
    too_few_points = NURBS_ERROR_TOO_FEW_POINTS,
    overflow = NURBS_ERROR_OVERFLOW,
    size = NURBS_ERROR_SIZE,
    dimension = NURBS_ERROR_DIMENSION,
    stride = NURBS_ERROR_STRIDE,
    overlap = NURBS_ERROR_OVERLAP,
    flags = NURBS_ERROR_FLAGS,
    order = NURBS_ERROR_ORDER,
    knot_not_finite = NURBS_ERROR_KNOT_NOT_FINITE,
    knots_decreasing = NURBS_ERROR_KNOTS_DECREASING,
    end_multiplicity = NURBS_ERROR_END_MULTIPLICITY,
    multiplicity = NURBS_ERROR_MULTIPLICITY,
    empty_domain = NURBS_ERROR_EMPTY_DOMAIN,
    point_not_finite = NURBS_ERROR_POINT_NOT_FINITE,
    weight_not_finite = NURBS_ERROR_WEIGHT_NOT_FINITE,
    weight_negative = NURBS_ERROR_WEIGHT_NEGATIVE,
    weights_vanish = NURBS_ERROR_WEIGHTS_VANISH,
    parameter_not_finite = NURBS_ERROR_PARAMETER_NOT_FINITE,
    periodic_knots = NURBS_ERROR_PERIODIC_KNOTS,
    periodic_points = NURBS_ERROR_PERIODIC_POINTS,
    times = NURBS_ERROR_TIMES,
    options = NURBS_ERROR_OPTIONS,
    index = NURBS_ERROR_INDEX,
    direction = NURBS_ERROR_DIRECTION,
    end_knot = NURBS_ERROR_END_KNOT,
    not_a_knot = NURBS_ERROR_NOT_A_KNOT,
    matrix = NURBS_ERROR_MATRIX,
    rational = NURBS_ERROR_RATIONAL,
    incompatible = NURBS_ERROR_INCOMPATIBLE,
    gap = NURBS_ERROR_GAP,
    tolerance = NURBS_ERROR_TOLERANCE,
    not_periodic = NURBS_ERROR_NOT_PERIODIC,
    end_weights = NURBS_ERROR_END_WEIGHTS,
    factor = NURBS_ERROR_FACTOR,
    periodic = NURBS_ERROR_PERIODIC,
    end = NURBS_ERROR_END,
    basis = NURBS_ERROR_BASIS,
    not_monotone = NURBS_ERROR_NOT_MONOTONE,
    continuity = NURBS_ERROR_CONTINUITY,
    weight_sign = NURBS_ERROR_WEIGHT_SIGN,
    angle = NURBS_ERROR_ANGLE,
    length = NURBS_ERROR_LENGTH,
    collinear = NURBS_ERROR_COLLINEAR,
    conic = NURBS_ERROR_CONIC,
    form = NURBS_ERROR_FORM,
    tangent = NURBS_ERROR_TANGENT,
    twist = NURBS_ERROR_TWIST,
    twist_rule = NURBS_ERROR_TWIST_RULE,
    influence = NURBS_ERROR_INFLUENCE,
    contradiction = NURBS_ERROR_CONTRADICTION,
    constraint = NURBS_ERROR_CONSTRAINT,
    off_polygon = NURBS_ERROR_OFF_POLYGON,
    rule = NURBS_ERROR_RULE,
    schoenberg_whitney = NURBS_ERROR_SCHOENBERG_WHITNEY,
    rank = NURBS_ERROR_RANK,
    scale = NURBS_ERROR_SCALE,
    orientation = NURBS_ERROR_ORIENTATION,
    same = NURBS_ERROR_SAME,
    crossing = NURBS_ERROR_CROSSING,
    outside_domain = NURBS_ERROR_OUTSIDE_DOMAIN,
    not_representable = NURBS_ERROR_NOT_REPRESENTABLE,
    knots_merge = NURBS_ERROR_KNOTS_MERGE,
    not_converged = NURBS_ERROR_NOT_CONVERGED,
    memory = NURBS_ERROR_MEMORY,
    file = NURBS_ERROR_FILE,
    too_large = NURBS_ERROR_TOO_LARGE,
    cancelled = NURBS_ERROR_CANCELLED,
    work = NURBS_ERROR_WORK,
    format = NURBS_ERROR_FORMAT,
    truncated = NURBS_ERROR_TRUNCATED,
    syntax = NURBS_ERROR_SYNTAX,
    unsupported = NURBS_ERROR_UNSUPPORTED,
    checksum = NURBS_ERROR_CHECKSUM,
    version = NURBS_ERROR_VERSION,
    cycle = NURBS_ERROR_CYCLE,
    internal = NURBS_ERROR_INTERNAL
};

/// Of this header: each file of a program has the one that it was compiled with.
constexpr std::int32_t header_version = NURBS_VERSION;
constexpr std::int32_t version_major = NURBS_VERSION_MAJOR;
constexpr std::int32_t version_minor = NURBS_VERSION_MINOR;
constexpr std::int32_t version_patch = NURBS_VERSION_PATCH;
inline constexpr std::int32_t max_degree = NURBS_MAX_DEGREE;
inline constexpr std::int32_t max_axes = NURBS_MAX_AXES;
inline constexpr std::int32_t max_order = NURBS_MAX_ORDER;

/// Flags of one axis; move them with on_axis() or on_all_axes().
inline constexpr std::uint32_t left = NURBS_LEFT;
inline constexpr std::uint32_t clamp = NURBS_CLAMP;
inline constexpr std::uint32_t extrapolate = NURBS_EXTRAPOLATE;
inline constexpr std::uint32_t wrap = NURBS_WRAP;
inline constexpr std::uint32_t nan = NURBS_NAN;
inline constexpr std::uint32_t periodic = NURBS_PERIODIC;

/// Global flags.
inline constexpr std::uint32_t accumulate = NURBS_ACCUMULATE;
inline constexpr std::uint32_t keep_domain = NURBS_KEEP_DOMAIN;
inline constexpr std::uint32_t keep_gaps = NURBS_KEEP_GAPS;
inline constexpr std::uint32_t as_oriented = NURBS_AS_ORIENTED;
inline constexpr std::uint32_t check_crossings = NURBS_CHECK_CROSSINGS;
inline constexpr std::uint32_t product_dot = NURBS_PRODUCT_DOT;
inline constexpr std::uint32_t product_cross = NURBS_PRODUCT_CROSS;
inline constexpr std::uint32_t homogeneous_records = NURBS_HOMOGENEOUS;
inline constexpr std::uint32_t map_domains = NURBS_MAP_DOMAINS;
inline constexpr std::uint32_t ruled_cartesian = NURBS_RULED_CARTESIAN;
inline constexpr std::uint32_t hemisphere = NURBS_HEMISPHERE;
inline constexpr std::uint32_t two_sheets = NURBS_TWO_SHEETS;
inline constexpr std::uint32_t equal_chords = NURBS_EQUAL_CHORDS;
inline constexpr std::uint32_t reversed = NURBS_REVERSED;
inline constexpr std::uint32_t nan_points = NURBS_NAN_POINTS;
inline constexpr std::int32_t start_of_axis = NURBS_START;
inline constexpr std::int32_t end_of_axis = NURBS_END;

/// Bits of Spline::knot_form().
inline constexpr std::int32_t form_clamped_start = NURBS_FORM_CLAMPED_START;
inline constexpr std::int32_t form_clamped_end = NURBS_FORM_CLAMPED_END;
inline constexpr std::int32_t form_periodic = NURBS_FORM_PERIODIC;

constexpr std::uint32_t on_axis(std::int32_t axis, std::uint32_t flags) {
    return NURBS_ON_AXIS(axis, flags);
}
constexpr std::uint32_t on_all_axes(std::int32_t axes, std::uint32_t flags) {
    return NURBS_ON_ALL_AXES(axes, flags);
}

inline std::int32_t version() noexcept {
    return nurbs_version();
}
inline const char *status_name(Status status) noexcept {
    return nurbs_status_name(static_cast<nurbs_status>(status));
}

/// Message of the last failed call in this thread.
inline std::string last_error() {
    std::string text(static_cast<std::size_t>(nurbs_last_error(nullptr, 0)), '\0');
    nurbs_last_error(text.data(), static_cast<std::int64_t>(text.size()) + 1);
    return text;
}

} // namespace libnurbs

#endif // NURBS_CPP_STATUS_HPP
