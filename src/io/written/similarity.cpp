// SPDX-License-Identifier: MIT
#include "io/written/similarity.h"

#include "model/model.h"

#include <cmath>

namespace nrb::io {
namespace {

constexpr double rounding = 0x1p-40;

} // namespace

Columns columns_of(const std::array<double, 12> &m) noexcept {
    return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {m[3], m[7], m[11]}};
}

double scale_of(const Columns &m) noexcept {
    const double scale = nrb::length(m.x), most = rounding * scale * scale;
    const bool square = std::fabs(dot(m.x, m.y)) <= most && std::fabs(dot(m.y, m.z)) <= most &&
                        std::fabs(dot(m.z, m.x)) <= most &&
                        std::fabs(nrb::length(m.y) - scale) <= rounding * scale &&
                        std::fabs(nrb::length(m.z) - scale) <= rounding * scale;
    return square && scale > 0 ? std::copysign(scale, dot(cross(m.x, m.y), m.z)) : 0;
}

bool is_one(double scale) noexcept {
    return std::fabs(scale - 1) <= rounding;
}

bool is_identity(const std::array<double, 12> &m) noexcept {
    return m == model::Use().placement;
}

} // namespace nrb::io
