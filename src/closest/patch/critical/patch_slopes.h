// SPDX-License-Identifier: MIT
// Bounds of the derivatives of the distance on a patch, from the Bernstein coefficients of |Q|^2 and w^2.
#pragma once

#include "closest/patch/patch_item.h"

namespace nrb::closest {

// With phi = |Q|^2 / w^2: w^2 d_k phi = d_k |Q|^2 - phi d_k w^2, whose coefficients are differences, and
// linear in phi.
class PatchSlopes {
public:
    // moved: how far rounding may have moved the points.
    PatchSlopes(const PatchShape &shape, const pieces::PatchSquares &squares, const double *patch,
                double moved, PatchMemory &memory);

    // Whether all weights are > 0; all else presumes it.
    [[nodiscard]] bool sound() const noexcept { return least_weight_ > 0x1p-200; }
    // Whether the distance rises or falls throughout along some axis: then it has no critical point here.
    [[nodiscard]] bool monotone() noexcept;
    // The same by the tangents alone, for a patch that is small beside the distance: near a point to which
    // an edge has collapsed, rounding is as small as they are.
    [[nodiscard]] bool slanted() const noexcept;
    // The smallest distance, or less.
    [[nodiscard]] double least() const noexcept;
    // The largest distance less the smallest one, or more.
    [[nodiscard]] double spread() const noexcept;
    // How far the patch reaches from a point.
    [[nodiscard]] double extent(const double *point) const noexcept;

    // Whether the matrix of the second derivatives is regular throughout: then there is one critical point at
    // most. After monotone().
    enum class Matrix { regular, unknown, singular };
    [[nodiscard]] Matrix matrix() noexcept;
    // The axis along which the distance bends most; after matrix().
    [[nodiscard]] int widest_axis() const noexcept { return widest_; }

private:
    struct Range {
        double low, high;
        void add(double x) noexcept;
        [[nodiscard]] double size() const noexcept;
    };
    void measure(const double *patch) noexcept;
    [[nodiscard]] bool slanted_along(int axis, const double *centre, const Range &heights,
                                     double radius) const noexcept;
    template <class Visit>
    void for_products(const std::array<int, max_axes> &shrink, Visit &&visit) const;
    [[nodiscard]] int64_t step(int axis) const noexcept;
    [[nodiscard]] Range second(int k, int l) const;

    const PatchShape &shape_;
    const double *patch_;
    double *squares_;
    double *weights_;
    double *centre_;
    double moved_;
    double least_ = 0, most_ = 0; // of phi
    double reach_ = 0;
    double least_weight_ = 0, most_weight_ = 0;
    double error_ = 0;                    // of a coefficient of |Q|^2 - phi w^2
    std::array<Range, max_axes> first_{}; // of w^2 d_k phi
    AxisValues weight_slopes_{};          // of d_k w^2 / w^2
    int widest_ = 0;
};

} // namespace nrb::closest
