// SPDX-License-Identifier: MIT
// The status returned by a call of the public interface; the manual (nurbs/nurbs.h) says what each one means.
// The core has its own enum, so that it does not depend on the text of the manual; capi/constants.cpp
// compares its values with the public ones.
#pragma once

#include <cstdint>

namespace nrb::inline base {

enum class Status : int32_t {
    ok = 0,
    // arguments
    null = 1,
    axes = 2,
    axis = 3,
    degree = 4,
    count = 5,
    too_few_points = 6,
    overflow = 7,
    size = 8,
    dimension = 9,
    stride = 10,
    overlap = 11,
    flags = 12,
    order = 13,
    knot_not_finite = 14,
    knots_decreasing = 15,
    end_multiplicity = 16,
    multiplicity = 17,
    empty_domain = 18,
    point_not_finite = 19,
    weight_not_finite = 20,
    weight_negative = 21,
    weights_vanish = 22,
    parameter_not_finite = 23,
    periodic_knots = 24,
    periodic_points = 25,
    times = 26,
    options = 27,
    index = 28,
    direction = 29,
    end_knot = 30,
    not_a_knot = 31,
    matrix = 32,
    rational = 33,
    incompatible = 40,
    gap = 41,
    tolerance = 42,
    not_periodic = 43,
    end_weights = 44,
    factor = 45,
    continuity = 46,
    weight_sign = 47,
    periodic = 48,
    end = 49,
    basis = 50,
    not_monotone = 51,
    angle = 52,
    length = 53,
    collinear = 54,
    conic = 55,
    form = 56,
    tangent = 57,
    twist = 58,
    twist_rule = 59,
    influence = 60,
    contradiction = 61,
    constraint = 62,
    off_polygon = 63,
    rule = 64,
    schoenberg_whitney = 65,
    rank = 66,
    scale = 67,
    orientation = 68,
    same = 69,
    crossing = 70,
    // domain
    outside_domain = 100,
    // numbers
    not_representable = 200,
    knots_merge = 202,
    not_converged = 203,
    // resources
    memory = 300,
    file = 301,
    too_large = 302,
    cancelled = 303,
    work = 304,
    // contents of files
    format = 400,
    truncated = 401,
    syntax = 402,
    unsupported = 403,
    checksum = 404,
    version = 405,
    cycle = 406,
    // internal
    internal = 900,
};

} // namespace nrb::inline base
