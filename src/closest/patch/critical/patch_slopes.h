// SPDX-License-Identifier: MIT
// Bounds on the first and second derivatives of the squared distance on a patch, from the Bernstein
// coefficients of |Q|^2 and w^2.
#pragma once

#include "closest/patch/patch_item.h"

namespace nrb::closest {

// With phi = |Q|^2 / w^2, the squared distance: w^2 d_k phi = d_k |Q|^2 - phi d_k w^2. The coefficients of
// the right-hand side are differences of coefficients, and linear in phi, so that the extremes of phi bound
// it.
class PatchSlopes {
public:
    // moved: how far rounding may have moved the points.
    PatchSlopes(const PatchShape &shape, const pieces::PatchSquares &squares, const double *patch,
                double moved, PatchMemory &memory);

    // Whether all weights are positive; all other members presume it.
    [[nodiscard]] bool sound() const noexcept { return least_weight_ > 0x1p-200; }
    // Whether the distance increases or decreases throughout along some axis, so that the patch has no
    // critical point.
    [[nodiscard]] bool monotone() noexcept;
    // The same test by the tangents alone, for a patch that is small compared to its distance. Near a pole
    // the coefficients of |Q|^2 differ by no more than their rounding, and monotone() decides nothing.
    [[nodiscard]] bool slanted() const noexcept;
    // Bounds on the distance.
    [[nodiscard]] double least() const noexcept;
    [[nodiscard]] double most() const noexcept;
    // An upper bound, up to rounding, on the largest distance minus the smallest one.
    [[nodiscard]] double spread() const noexcept;
    // The largest distance of a control point from a point.
    [[nodiscard]] double extent(const double *point) const noexcept;

    // Whether the matrix of the second derivatives of phi is regular on the whole patch, which then has at
    // most one critical point. To be called after monotone().
    enum class Matrix { regular, unknown, singular };
    [[nodiscard]] Matrix matrix() noexcept;
    // The axis along which the second derivative is largest; after matrix().
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
    // The error of the quotients of coefficients.
    [[nodiscard]] double off() const noexcept;
    [[nodiscard]] Range second(int k, int l) const;

    const PatchShape &shape_;
    const double *patch_;
    double *squares_;
    double *weights_;
    double *centre_;
    double moved_;
    double least_ = 0, most_ = 0; // of the coefficients' quotients, which bound phi
    double reach_ = 0;
    double least_weight_ = 0, most_weight_ = 0;
    double error_ = 0;                    // of a coefficient of |Q|^2 - phi w^2
    std::array<Range, max_axes> first_{}; // range of w^2 d_k phi
    AxisValues weight_slopes_{};          // bound on |d_k w^2| / w^2
    int widest_ = 0;
};

} // namespace nrb::closest
