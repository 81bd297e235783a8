// SPDX-License-Identifier: MIT
// Charts for feet: pairs of parts of a surface and of a curve in which the feet are a graph over one of the
// three parameters, by the Krawczyk operator.
#pragma once

#include "base/numbers.h"
#include "intersect/coupling.h"
#include "intersect/graph_arc.h"
#include "intersect/projection/feet/feet_cell.h"

namespace nrb::intersect {

// Places in a pair of parts: u, v of the surface, t of the curve.
using FeetPlace = Place<3>;

// The derivative F' by places.
using FeetSlopes = std::array<FeetPlace, 2>;

// Bernstein coefficients of F = (F_0, F_1) (FeetNet) over a pair of wide parts, [t][u][v], with room for one
// linear combination of them.
class FeetNets {
public:
    void set(FeetCell &patch, FeetCell &span);
    [[nodiscard]] const std::vector<double> &of(size_t equation) const noexcept { return nets_[equation]; }
    // a F_0 + b F_1.
    const std::vector<double> &combined(double a, double b);
    // A bound of the rounding of the coefficients.
    [[nodiscard]] double near(size_t equation) const noexcept { return near_[equation]; }
    // The range of the coefficients of a net of these degrees, and that of its derivative along an axis.
    [[nodiscard]] static Interval range_of(const std::vector<double> &net) noexcept;
    [[nodiscard]] Interval slopes_of(const std::vector<double> &net, size_t axis) const noexcept;
    // The means of the derivatives of F over the wide part.
    [[nodiscard]] FeetSlopes mean_slopes() const noexcept;
    // For each axis a bound of the second derivatives that involve it, from second differences of the net.
    [[nodiscard]] FeetPlace bends_of(const std::vector<double> &net) const noexcept;
    [[nodiscard]] int degree(size_t axis) const noexcept { return degrees_[axis]; }

private:
    [[nodiscard]] AxisLayers layers(size_t axis) const noexcept;
    [[nodiscard]] double largest_second_difference(const std::vector<double> &net, size_t a,
                                                   size_t b) const noexcept;
    [[nodiscard]] double factor(size_t axis) const noexcept; // turns differences into derivatives by places

    std::array<int, 3> degrees_{}; // of u, v, t
    std::array<std::vector<double>, 2> nets_;
    std::vector<double> combined_;
    std::array<double, 2> near_{};
};

// F(u, v, t) = 0: two equations in three unknowns. M is the inverse of the mean derivative without column k,
// the one whose removal leaves the largest determinant. Proofs, and members of the same name, are as for
// CrossChart.
class FeetChart {
public:
    enum class Verdict {
        apart, // F_0, F_1 or a row of M F has no zero
        chart, // the feet are a graph over coordinate k
        bent,  // neither is proven
        flat,  // M does not exist
    };
    Verdict set(FeetNets &nets);

    [[nodiscard]] size_t axis() const noexcept { return axis_; } // k
    [[nodiscard]] const Interval &shift(size_t i) const noexcept { return shifts_[i]; }
    [[nodiscard]] const Interval &rise(size_t i) const noexcept { return rises_[i]; }
    [[nodiscard]] double noise(size_t i) const noexcept { return noise_[i]; }
    [[nodiscard]] double noise() const noexcept { return most_noise_; }
    [[nodiscard]] int direction() const noexcept { return direction_; }
    [[nodiscard]] static bool holds_at(const FeetPlace & /*z*/) noexcept { return true; }
    [[nodiscard]] static Interval range(size_t /*i*/) noexcept { return {-infinity, infinity}; }
    [[nodiscard]] FeetPlace drift(const FeetPlace &step, double off, double far,
                                  const FeetPlace &farthest) const noexcept;
    // How far places where |M F| is at most `step` may be from zeros with the same coordinate k.
    [[nodiscard]] FeetPlace off_at(const FeetPlace &step) const noexcept;
    // M F from a value of F; 0 for k.
    [[nodiscard]] FeetPlace step(const std::array<double, 2> &value) const noexcept;
    // Bounds of |M F| from bounds of |F|.
    [[nodiscard]] FeetPlace largest_step(const std::array<double, 2> &bound) const noexcept;
    // The axis along which halving pays most; lengths: of the pair of parts, in space.
    [[nodiscard]] size_t bent_axis(FeetNets &nets, const FeetPlace &lengths) const;

private:
    bool set_rows(const FeetSlopes &slopes) noexcept;
    bool set_row(size_t i, FeetNets &nets);
    void set_rises() noexcept;

    size_t axis_ = 0;
    std::array<std::array<double, 2>, 3> rows_{};
    FeetPlace noise_{};
    Coupling<3> coupling_;
    std::array<Interval, 3> shifts_{}, rises_{};
    double most_noise_ = 0;
    int direction_ = 0;
    bool has_rows_ = false;
};

// A pair of parts with its chart: the `Box` of GraphArc.
struct FeetBox {
    FeetCell *patch = nullptr, *span = nullptr;
    FeetChart chart;

    struct Value {
        std::array<double, 2> difference; // the value of F
        FeetSlopes slopes;
    };
    [[nodiscard]] Value at(const FeetPlace &z) const noexcept;
    struct Contact {
        Vector3 surface, curve;        // S, C
        std::array<Vector3, 2> slopes; // of S
        Vector3 slope, normal;         // derivative of C; unit vector along S_u x S_v, or 0
        double distance;               // signed: C + distance normal = S at a foot
    };
    [[nodiscard]] Contact contact_at(const FeetPlace &z) const noexcept;
    [[nodiscard]] const FeetCell &cell(size_t coordinate) const noexcept {
        return coordinate < 2 ? *patch : *span;
    }
    [[nodiscard]] double side(size_t coordinate, size_t end) const noexcept {
        return cell(coordinate).side(coordinate % 2, end);
    }
    [[nodiscard]] double length(size_t coordinate) const noexcept {
        return cell(coordinate).length(coordinate % 2);
    }
    [[nodiscard]] static FeetPlace start() noexcept { return {0.5, 0.5, 0.5}; }
    [[nodiscard]] FeetPlace step_at(const FeetPlace &z) const noexcept {
        return chart.step(at(z).difference);
    }
    [[nodiscard]] FeetPlace tangent_at(const FeetPlace &z) const noexcept;
    bool solve(size_t fixed, FeetPlace &z) const;
};

} // namespace nrb::intersect
