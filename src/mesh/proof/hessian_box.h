// SPDX-License-Identifier: MIT
// Bounds on the second derivatives of a surface over a cell of its domain.
#pragma once

#include "base/numbers.h"
#include "numeric/vector3.h"

#include <array>
#include <cmath>

namespace nrb::mesh {

// The hypotenuse. Its squares need no scaling: in the units of a grid of pieces all sizes are near 1.
inline double diagonal(double a, double b) noexcept {
    return std::sqrt(a * a + b * b);
}

// The range of a function over a cell: middle + u x + v y within the radius, for x and y from -1/2 to 1/2.
struct Range {
    double middle = 0, u = 0, v = 0, radius = 0;

    [[nodiscard]] double at(double x, double y) const noexcept { return middle + u * x + v * y; }
    // Half the length of the interval of all values.
    [[nodiscard]] double width() const noexcept { return (std::abs(u) + std::abs(v)) / 2 + radius; }
    [[nodiscard]] double most() const noexcept { return std::abs(middle) + width(); }
};

// The ranges of the second derivatives of a function of two parameters.
struct Hessian {
    Range uu, uv, vv;
    // Over the cell, the function is within `rest` of a polynomial that agrees with it at the corners, and
    // whose second derivatives are those ranges without their radii. Infinity: there is no such polynomial,
    // since the slopes of the ranges do not belong together, or none is known.
    double rest = infinity;

    // along(): the second derivative along (u, v) at a place, without the radii; beside(): the most that these add
    // to it.
    [[nodiscard]] double along(double u, double v, double x = 0, double y = 0) const noexcept {
        return uu.at(x, y) * u * u + 2 * uv.at(x, y) * u * v + vv.at(x, y) * v * v;
    }
    [[nodiscard]] double beside(double u, double v) const noexcept {
        return uu.radius * u * u + 2 * uv.radius * std::abs(u * v) + vv.radius * v * v;
    }
    // anywhere(): the same ranges as constants with larger radii. add(): extends the ranges by those over
    // another cell, and makes them constants. in_units(): the second derivatives by parameters in other
    // units, where u and v are the new units measured in the old ones.
    [[nodiscard]] Hessian anywhere() const noexcept;
    void add(const Hessian &other) noexcept;
    [[nodiscard]] Hessian in_units(double u, double v) const noexcept;
};

struct CoefficientNet;

// Bounds the second derivatives of the homogeneous coordinates (A - w O, w) of a surface A / w over a cell,
// about an origin O. The coordinates are along axes of the cell, of which the last one is normal to its
// middle: since the cell is nearly plane, the sizes of the coordinates differ most in these axes. Parameters
// are measured in sides of the cell.
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
    // A linear function that is nowhere greater than the weight, at a place about the middle of the cell, in
    // sides of it.
    [[nodiscard]] double weight_from_below(const std::array<double, 2> &place) const noexcept;
    [[nodiscard]] double mean_weight() const noexcept { return corner_weight_; } // at the corners
    // Whether the weights are certainly positive.
    [[nodiscard]] bool certain() const noexcept { return least_weight_ > 0; }

    // An upper bound on how far the surface moves on a step of (u, v) sides within the cell.
    [[nodiscard]] double move(double u, double v) const noexcept;

    // The approximate length in space of a side along axis k.
    [[nodiscard]] double speed(size_t k) const noexcept {
        const auto &x = first_[k];
        return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / corner_weight_;
    }

    // Adds a net [u][v] of (x, y, z, w) over a part of the cell. factors: the sides of the cell divided by
    // those of the part; 1 and 1 for the whole cell. noise: the error of a coefficient, relative to the
    // largest weight. steps: whether move() has to be as tight as possible.
    void add(int u_degree, int v_degree, const double *net, const std::array<double, 2> &factors,
             double noise, bool steps = true);

    // The second derivatives of d . (A - w P), for vectors d of length at most 1.
    [[nodiscard]] Hessian along(const Vector3 &d, const Vector3 &p) const noexcept;
    // Bounds on the lengths of the second derivatives of A - w P, and of A - w Q for all points Q within a
    // distance of P, as radii about 0.
    [[nodiscard]] Hessian size(const Vector3 &p) const noexcept;
    [[nodiscard]] Hessian sizes(const Vector3 &p, double distance) const noexcept;
    // Of homogeneous coordinate c, in the axes of the cell and about its origin.
    [[nodiscard]] const Hessian &of(size_t c) const noexcept { return of_[c]; }

private:
    // A first derivative: A' (about the origin) is within `radius` of `middle`, and |w'| is at most `weight`.
    struct First {
        std::array<double, 3> middle{};
        double radius = 0, weight = 0;
    };
    [[nodiscard]] First first(size_t k) const noexcept;
    [[nodiscard]] bool is_coarse() const noexcept;
    void add_second(const std::array<CoefficientNet, 2> &first, const std::array<double, 2> &degrees,
                    const std::array<double, 2> &factors, bool fresh) noexcept;
    void set_rests(const CoefficientNet &net) noexcept;
    void set_sizes() noexcept;
    void add_first(const std::array<CoefficientNet, 2> &first, const std::array<double, 2> &factors) noexcept;
    void add_reach(const CoefficientNet &net) noexcept;
    // An upper bound on |A - w O|.
    [[nodiscard]] double reach() const noexcept;

    Vector3 origin_;
    std::array<Vector3, 3> axes_{};
    std::array<Hessian, coordinates> of_{};
    // Bounds on each of the second derivatives: of all coordinates added up, of |A - w O|, and of w.
    std::array<double, 3> sums_{}, sizes_{}, weights_{};
    double least_weight_ = infinity, largest_weight_ = -infinity;
    std::array<std::array<double, coordinates>, 2> first_{}; // mean first derivatives, from the corners
    double corner_weight_ = 1;                               // the mean of the corners
    double reach_ = 0;                                       // the largest |A - w O| at the corners
    double noise_ = 0;                                       // error of a coefficient
    // Where second derivatives say little about first ones: bounds from Bernstein coefficients on their
    // deviations from the means, on |w'|, and on |A - w O|.
    bool by_coefficients_ = false;
    std::array<double, 2> first_radius_{}, first_weight_{};
    double coefficient_reach_ = 0;
};

} // namespace nrb::mesh
