// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/normal_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/blocks.h"
#include "eval/kernels/normal_kernel.h"
#include "eval/kernels/rows-inl.h"
#include "numeric/vector3.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// Three-dimensional vectors of several points of a block, one point per lane.
struct Vectors {
    using V = hn::Vec<Vec8>;

    explicit HWY_INLINE Vectors(const double *rows)
        : x(hn::LoadU(Vec8(), rows)), y(hn::LoadU(Vec8(), rows + block_size)),
          z(hn::LoadU(Vec8(), rows + 2 * block_size)) {}
    HWY_INLINE Vectors(V x_value, V y_value, V z_value) : x(x_value), y(y_value), z(z_value) {}

    [[nodiscard]] HWY_INLINE V square() const {
        return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    }
    HWY_INLINE void store(double *rows) const {
        hn::StoreU(x, Vec8(), rows);
        hn::StoreU(y, Vec8(), rows + block_size);
        hn::StoreU(z, Vec8(), rows + 2 * block_size);
    }

    V x;
    V y;
    V z;
};

HWY_INLINE Vectors cross_product(const Vectors &a, const Vectors &b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

// Multiplications and additions are not fused, since the scalar formulas for points that are examined one by
// one are not. The bound (a + b)^2 <= 2 (a^2 + b^2) saves the square roots for |S_u| and |S_v|. The result
// has a bit for each point of the block.
uint64_t unit_normals_of_rows(const double *du, const double *dv, int64_t count, double error_u,
                              double error_v, double *HWY_RESTRICT normals) {
    const Vec8 d;
    const auto factor_u = hn::Set(d, 2 * error_v * error_v);
    const auto factor_v = hn::Set(d, 2 * error_u * error_u);
    uint64_t doubtful = 0;
    for (int64_t i = 0; i < count; i += vec8_lanes) {
        const Vectors u(du + i);
        const Vectors v(dv + i);
        const Vectors n = cross_product(u, v);
        const auto squared = n.square();
        const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Sqrt(squared));
        Vectors(hn::Mul(n.x, inverse), hn::Mul(n.y, inverse), hn::Mul(n.z, inverse)).store(normals + i);
        const auto noise = hn::Add(hn::Mul(u.square(), factor_u), hn::Mul(v.square(), factor_v));
        const auto certain =
            hn::And(hn::And(hn::Gt(squared, noise), hn::Gt(squared, hn::Set(d, least_square))),
                    hn::Lt(squared, hn::Set(d, largest_square)));
        uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Not(certain), bits);
        doubtful |= uint64_t{bits[0]} << i;
    }
    return count == block_size ? doubtful : doubtful & ((uint64_t{1} << count) - 1);
}

void write_rows_of_block(const double *rows, int64_t first, int64_t count, const Records &out) {
    if (out.stride == 1 || out.component_stride != 1) {
        for (int64_t c = 0; c < out.width; ++c, rows += block_size) {
            double *target = out.record(first) + c * out.component_stride;
            for (int64_t i = 0; i < count; ++i) {
                target[i * out.stride] = rows[i];
            }
        }
        return;
    }
    for (int64_t i = 0; i < count; i += vec8_lanes) {
        const double *row = rows + i;
        const auto next = [&row] { return std::exchange(row, row + block_size); };
        store_records(next, out.width, static_cast<int>(std::min<int64_t>(vec8_lanes, count - i)),
                      out.record(first + i), out.stride);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

static_assert(block_size == 64); // one bit each

NURBS_FORMS(unit_normals_of_rows);
NURBS_FORMS(write_rows_of_block);

uint64_t unit_normals(const double *du, const double *dv, int64_t count, double error_u, double error_v,
                      double *normals) noexcept {
    return NURBS_BEST(unit_normals_of_rows)(du, dv, count, error_u, error_v, normals);
}

void write_rows(const double *rows, int64_t first, int64_t count, const Records &out) noexcept {
    if (out.data != nullptr) {
        NURBS_BEST(write_rows_of_block)(rows, first, count, out);
    }
}

} // namespace nrb::eval
#endif
