// SPDX-License-Identifier: MIT
// Parts of two surfaces whose common points are a graph over one of their four parameters.
#pragma once

#include "intersect/coupling.h"
#include "intersect/surfaces/cross_cell.h"
#include "intersect/surfaces/shear/cross_shear.h"

#include <span>

namespace nrb::intersect {

// Places in a pair of parts: u, v of the first one, s, t of the second one.
using CrossPlace = Place<4>;

// F(u, v, s, t) = A(u, v) - B(s, t), three equations in four unknowns. M is the inverse of its derivative in the middle without
// the column k for which the determinant is largest. Over the box of both wide parts let R be bounds of |I - M F'|, all columns
// but k, and row i of M F'_k be in S_i. If the spectral radius of R is less than 1, the mean value theorem for the segment
// between two places z and z0 of the box, y their coordinates but k, makes (Coupling)
//     |(y - y0) - M (F(z) - F(z0)) + S (z_k - z0_k)| <= R |y - y0|,   |y - y0| <= (I - R)^-1 |M (F(z) - F(z0)) - S (z_k - z0_k)|
// (R. Krawczyk 1969, without a norm). So for each value of coordinate k there is one zero at most: the zeros in the box
// are a graph over k, of which neither loops nor ends can be inside. Any two of them differ by (y - y0)_i in D_i (z_k - z0_k)
// with D = -S +- R (I - R)^-1 max |S|.
//
// Where both surfaces run along each other all of this holds of smaller parts only than where they come apart is seen in: there
// M, R and S are those of the unknowns x and sigma of a CrossShear, of which one x is k. With the other one, j, of coordinate i of
// Y = sigma_i + L_ij x_j + L_ik x_k it is told what follows for y.
class CrossChart {
public:
    enum class Verdict {
        apart, // a row of M F is nowhere 0
        chart,
        bent, // neither
        flat, // M does not exist: the tangent planes are all but parallel, or a derivative all but vanishes
    };
    // Precondition: both are prepared.
    Verdict set(CrossCell &a, CrossCell &b);
    // The same in a shear that is set; the surface with index `base` is X.
    Verdict set_sheared(size_t base, const CrossShear &shear);

    [[nodiscard]] size_t axis() const noexcept { return axis_; } // k
    // A place from which zeros are found, and whether what is said of places holds at one in both wide parts.
    [[nodiscard]] const CrossPlace &start() const noexcept { return start_; }
    [[nodiscard]] bool holds_at(const CrossPlace &z) const noexcept;
    // In which of its places zeros of the box are, as far as that is known.
    [[nodiscard]] const Interval &range(size_t i) const noexcept { return ranges_[i]; }
    [[nodiscard]] const Interval &shift(size_t i) const noexcept { return shifts_[i]; } // S
    [[nodiscard]] const Interval &rise(size_t i) const noexcept { return rises_[i]; }   // D; 1 for k
    // How far y - y0 may be from -M F(z0) - S (z_k - z0_k) for a zero z, with the step M F(z0), off by `off` times its noise, and z no
    // farther from z0 than by far in coordinate k, and by these in the others.
    [[nodiscard]] CrossPlace drift(const CrossPlace &step, double off, double far,
                                   const CrossPlace &farthest) const noexcept;
    // How far places where |F| is no larger are from zeros with the same coordinate k.
    [[nodiscard]] CrossPlace off_at(double difference) const noexcept;
    // M F; 0 for k.
    [[nodiscard]] CrossPlace step(const Vector3 &difference) const noexcept;
    // Whether the same M makes a chart with what is beyond sides of both parts, too.
    [[nodiscard]] bool goes_on(const CrossCell &a, const CrossCell &b,
                               std::span<const CrossCell::Beyond> beyond_a,
                               std::span<const CrossCell::Beyond> beyond_b) const;
    // Whether M exists.
    [[nodiscard]] bool has_rows() const noexcept { return has_rows_; }
    // If so: whether the first part bends more than the second one.
    [[nodiscard]] bool first_bends_more() const noexcept { return bends_[0] > bends_[1]; }
    // Whether the spectral radius of R is less than 1, by far.
    [[nodiscard]] bool is_coupled() const noexcept { return coupled_; }
    // How far M F may be off by that of F.
    [[nodiscard]] double noise(size_t i) const noexcept { return norms_[i] * near_; }
    [[nodiscard]] double noise() const noexcept { return most_norm_ * near_; }
    // How far values of F may be off.
    [[nodiscard]] double near() const noexcept { return near_; }
    // 1 if the way along N_b x N_a has a rising coordinate k, else -1.
    [[nodiscard]] int direction() const noexcept { return direction_; }

private:
    bool set_rows(const CrossCell &a, const CrossCell &b);
    bool set_row(size_t i, const CrossCell &a, const CrossCell &b);
    void set_lean(const CrossShear &shear, size_t base);
    void couple(const CrossShear &shear);
    void set_norms() noexcept;
    [[nodiscard]] bool has_narrow_rises() const noexcept;
    [[nodiscard]] double of_own(size_t i, const CrossPlace &z) const noexcept {
        return z[i] - leans_[i] * z[across_];
    }
    [[nodiscard]] CrossPlace reach_of(const CrossPlace &size) const noexcept;
    [[nodiscard]] CrossPlace from_own(CrossPlace bounds) const noexcept;
    void set_rises() noexcept;
    void add_offs(size_t i, size_t surface, const CrossCell &cell, const std::array<double, 2> &factors,
                  Coupling<4> &coupling) const noexcept;

    size_t axis_ = 0;
    std::array<Vector3, 4> rows_{};
    CrossPlace norms_{}, own_norms_{}; // of rows of M, and of those for sigma
    Coupling<4> coupling_;
    std::array<Interval, 4> shifts_{}, own_shifts_{}, rises_{};
    CrossPlace start_{};
    std::array<Interval, 4> ranges_{};
    bool coupled_ = false, sheared_ = false;
    size_t across_ = 0; // j
    CrossPlace leans_{}, leans_along_{},
        aside_{};                // L_ij, L_ik, and the largest sigma; 0 for what is no sigma
    double most_difference_ = 0; // for which off_at() is known
    double most_norm_ = 0, near_ = 0;
    int direction_ = 0;
    std::array<double, 2> bends_{}; // of both parts: what they add to R, and to how wide S is
    bool has_rows_ = false;
};

// The null vector (u', v', s', t') of (a_0, a_1, -b_0, -b_1) for which a_0 u' + a_1 v' = N_b x N_a.
CrossPlace common_direction(const std::array<Vector3, 2> &a, const std::array<Vector3, 2> &b) noexcept;

// The columns but one, with the place of each: what solves them for a vector; false: they are all but in a plane.
bool solve_columns(const std::array<Vector3, 4> &columns, size_t fixed, const Vector3 &of,
                   CrossPlace &solution) noexcept;

} // namespace nrb::intersect
