// SPDX-License-Identifier: MIT
// What the second derivatives of a surface can be over a cell of its domain.
#pragma once

#include "base/numbers.h"
#include "numeric/vector3.h"

#include <array>
#include <cmath>

namespace nrb::mesh {

// Of a right angle; numbers here have sizes near 1, since everything is in the units of a grid of pieces.
inline double diagonal(double a, double b) noexcept {
    return std::sqrt(a * a + b * b);
}

// A function over a cell: middle + u x + v y, give or take the radius, where x and y go from -1/2 to 1/2.
struct Range {
    double middle = 0, u = 0, v = 0, radius = 0;

    [[nodiscard]] double at(double x, double y) const noexcept { return middle + u * x + v * y; }
    [[nodiscard]] double width() const noexcept {
        return (std::abs(u) + std::abs(v)) / 2 + radius;
    } // half of it
    [[nodiscard]] double most() const noexcept { return std::abs(middle) + width(); }
};

// Of a function of two parameters.
struct Hessian {
    Range uu, uv, vv;

    // H(u, v) at a place, but for the radii, and the most that these add to it.
    [[nodiscard]] double along(double u, double v, double x = 0, double y = 0) const noexcept {
        return uu.at(x, y) * u * u + 2 * uv.at(x, y) * u * v + vv.at(x, y) * v * v;
    }
    [[nodiscard]] double beside(double u, double v) const noexcept {
        return uu.radius * u * u + 2 * uv.radius * std::abs(u * v) + vv.radius * v * v;
    }
    // The same anywhere in the cell, as radii about constants; that of two cells; by parameters in other units: those of the new ones
    // in the old.
    [[nodiscard]] Hessian anywhere() const noexcept;
    void add(const Hessian &constants) noexcept;
    [[nodiscard]] Hessian in_units(double u, double v) const noexcept;
};

struct CoefficientNet;

// The homogeneous coordinates (A - w O, w) of a surface A / w about an origin O, in axes of the cell, along which they differ most in size:
// the middle of the cell is nearly plane, and lies across the last one. Parameters are measured by the sides of the cell.
class HessianBox {
public:
    static constexpr size_t coordinates = 4;

    HessianBox() = default;
    // The axes are orthonormal to rounding. corners: (x, y, z, w) at (0, 0), (1, 0), (1, 1) and (0, 1).
    HessianBox(const Vector3 &origin, const std::array<Vector3, 3> &axes,
               const std::array<const double *, 4> &corners) noexcept;

    [[nodiscard]] const Vector3 &origin() const noexcept { return origin_; }
    [[nodiscard]] const std::array<Vector3, 3> &axes() const noexcept { return axes_; }
    [[nodiscard]] double least_weight() const noexcept { return least_weight_; }
    [[nodiscard]] double largest_weight() const noexcept { return largest_weight_; }
    // Whether weights are positive for certain.
    [[nodiscard]] bool certain() const noexcept { return least_weight_ > 0; }

    // The most that the surface moves by on a step of (u, v) sides of the cell in it.
    [[nodiscard]] double move(double u, double v) const noexcept;

    // About how long a side of the cell is.
    [[nodiscard]] double speed(size_t k) const noexcept {
        const auto &x = first_[k];
        return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / corner_weight_;
    }

    // A net [u][v] of (x, y, z, w) over a part of the cell, whose sides are those of the cell over these factors, all of it if they are
    // 1. `noise`: of a coefficient, relative to the largest weight. `steps`: whether move() is to be as small as can be told.
    void add(int u_degree, int v_degree, const double *net, const std::array<double, 2> &factors,
             double noise, bool steps = true);

    // Of the function d . (A - w P), for vectors d no longer than 1.
    [[nodiscard]] Hessian along(const Vector3 &d, const Vector3 &p) const noexcept;
    // Bounds of the size of A - w P, and of the sizes of A - w Q for all points Q in a distance from P: radii about 0.
    [[nodiscard]] Hessian size(const Vector3 &p) const noexcept;
    [[nodiscard]] Hessian sizes(const Vector3 &p, double distance) const noexcept;
    // Of coordinate c in the axes of the cell, about its origin.
    [[nodiscard]] const Hessian &of(size_t c) const noexcept { return of_[c]; }

private:
    // Of first derivatives: the middle of A' and what there is about it, and the most of w'.
    struct First {
        std::array<double, 3> middle{};
        double radius = 0, weight = 0;
    };
    [[nodiscard]] First first(size_t k) const noexcept;
    [[nodiscard]] bool is_coarse() const noexcept;
    void add_second(const std::array<CoefficientNet, 2> &first, const std::array<double, 2> &degrees,
                    const std::array<double, 2> &factors, bool fresh) noexcept;
    void set_sizes() noexcept;
    void add_first(const std::array<CoefficientNet, 2> &first, const std::array<double, 2> &factors) noexcept;
    void add_reach(const CoefficientNet &net) noexcept;
    // The most of |A - w O|.
    [[nodiscard]] double reach() const noexcept;

    Vector3 origin_;
    std::array<Vector3, 3> axes_{};
    std::array<Hessian, coordinates> of_{};
    // Of each of the second derivatives the most of all coordinates together, of |A - w O|, and of w.
    std::array<double, 3> sums_{}, sizes_{}, weights_{};
    double least_weight_ = infinity, largest_weight_ = -infinity;
    std::array<std::array<double, coordinates>, 2> first_{}; // means of first derivatives, by the corners
    double corner_weight_ = 1;                               // the mean
    double reach_ = 0;                                       // the most of |A - w O| in the corners
    double noise_ = 0;                                       // of a coefficient
    // Where second derivatives tell little of first ones: by coefficients of these, what they differ by from the means.
    bool by_coefficients_ = false;
    std::array<double, 2> first_radius_{}, first_weight_{};
    double coefficient_reach_ = 0;
};

} // namespace nrb::mesh
