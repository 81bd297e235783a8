// SPDX-License-Identifier: MIT
#include "evaluation_flags.h"

#include <nurbs/nurbs.h>

namespace nrb::capi {

namespace {

constexpr uint32_t axis_bits = 0xffu;
constexpr uint32_t known_bits = NURBS_LEFT | NURBS_CLAMP | NURBS_EXTRAPOLATE | NURBS_WRAP | NURBS_NAN;
constexpr uint32_t mode_bits = NURBS_CLAMP | NURBS_EXTRAPOLATE | NURBS_WRAP;

eval::AxisRule decode_rule(uint32_t bits, uint32_t flags, int axis) {
    if ((bits & ~known_bits) != 0) {
        fail(Status::flags, "flags = 0x%x: unknown bits 0x%x for axis %d", flags, bits & ~known_bits, axis);
    }
    eval::AxisRule rule{(bits & NURBS_LEFT) != 0, (bits & NURBS_NAN) != 0, eval::Outside::refuse};
    switch (bits & mode_bits) {
    case 0:
        return rule;
    case NURBS_CLAMP:
        rule.outside = eval::Outside::clamp;
        return rule;
    case NURBS_EXTRAPOLATE:
        rule.outside = eval::Outside::extrapolate;
        return rule;
    case NURBS_WRAP:
        rule.outside = eval::Outside::wrap;
        return rule;
    default:
        fail(Status::flags,
             "flags = 0x%x: NURBS_CLAMP, NURBS_EXTRAPOLATE and NURBS_WRAP exclude each other (axis %d)",
             flags, axis);
    }
}

} // namespace

eval::AxisRules decode_rules(uint32_t flags, int axes) {
    const uint32_t allowed = 0xffffffu >> (8 * (max_axes - axes));
    if ((flags & ~allowed) != 0) {
        fail(Status::flags, "flags = 0x%x: unknown bits 0x%x for %d axes", flags, flags & ~allowed, axes);
    }
    eval::AxisRules rules;
    for (int k = 0; k < axes; ++k) {
        rules[static_cast<size_t>(k)] = decode_rule((flags >> (8 * k)) & axis_bits, flags, k);
    }
    return rules;
}

} // namespace nrb::capi
