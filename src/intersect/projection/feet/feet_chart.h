// SPDX-License-Identifier: MIT
// Parts of a surface and of a curve in which feet are a graph over one of the three parameters.
#pragma once

#include "base/numbers.h"
#include "intersect/coupling.h"
#include "intersect/graph_arc.h"
#include "intersect/projection/feet/feet_cell.h"

namespace nrb::intersect {

// Places in a pair of parts: u, v of the surface, t of the curve.
using FeetPlace = Place<3>;

// F' by places.
using FeetSlopes = std::array<FeetPlace, 2>;

// Coefficients of F over a pair of wide parts, [t][u][v], and room for combinations of them.
class FeetNets {
public:
    void set(FeetCell &patch, FeetCell &span);
    [[nodiscard]] const std::vector<double> &of(size_t equation) const noexcept { return nets_[equation]; }
    // a F_0 + b F_1.
    const std::vector<double> &combined(double a, double b);
    [[nodiscard]] double near(size_t equation) const noexcept { return near_[equation]; } // rounding
    // Of a net with these degrees: between which numbers it is, and its derivative along an axis.
    [[nodiscard]] static Interval range_of(const std::vector<double> &net) noexcept;
    [[nodiscard]] Interval slopes_of(const std::vector<double> &net, size_t axis) const noexcept;
    // Of F, the mean derivatives.
    [[nodiscard]] FeetSlopes mean_slopes() const noexcept;
    // How much the derivatives of a net change along each axis, by second differences.
    [[nodiscard]] FeetPlace bends_of(const std::vector<double> &net) const noexcept;
    [[nodiscard]] int degree(size_t axis) const noexcept { return degrees_[axis]; }

private:
    [[nodiscard]] AxisLayers layers(size_t axis) const noexcept;
    [[nodiscard]] double largest_second_difference(const std::vector<double> &net, size_t a,
                                                   size_t b) const noexcept;
    [[nodiscard]] double factor(size_t axis) const noexcept; // of differences, to derivatives

    std::array<int, 3> degrees_{}; // of u, v, t
    std::array<std::vector<double>, 2> nets_;
    std::vector<double> combined_;
    std::array<double, 2> near_{};
};

// F(u, v, t), two equations in three unknowns. M is the inverse of the mean derivative without the column k for which the
// determinant is largest; the rest is as for CrossChart.
class FeetChart {
public:
    enum class Verdict {
        apart, // F_0, F_1 or a row of M F is nowhere 0
        chart,
        bent, // neither
        flat, // M does not exist
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
    // How far places where |M F| is no larger are from zeros with the same coordinate k.
    [[nodiscard]] FeetPlace off_at(const FeetPlace &step) const noexcept;
    // M F; 0 for k.
    [[nodiscard]] FeetPlace step(const std::array<double, 2> &value) const noexcept;
    // Bounds of |M F|, of those of |F|.
    [[nodiscard]] FeetPlace largest_step(const std::array<double, 2> &bound) const noexcept;
    // Along which axis it pays to halve a part with these lengths in space.
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

// A pair of parts, as GraphArc asks for it.
struct FeetBox {
    FeetCell *patch = nullptr, *span = nullptr;
    FeetChart chart;

    struct Value {
        std::array<double, 2> difference; // F
        FeetSlopes slopes;
    };
    [[nodiscard]] Value at(const FeetPlace &z) const noexcept;
    struct Contact {
        Vector3 surface, curve;        // S, C
        std::array<Vector3, 2> slopes; // of S
        Vector3 slope, normal;         // of C; S_u x S_v, of length 1, or 0
        double distance;               // with C + distance normal = S at a foot
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
