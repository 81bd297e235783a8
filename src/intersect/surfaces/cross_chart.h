// SPDX-License-Identifier: MIT
// Parts of two surfaces whose common points are proven to be a graph over one of their four parameters.
#pragma once

#include "intersect/coupling.h"
#include "intersect/surfaces/cross_cell.h"
#include "intersect/surfaces/shear/cross_shear.h"

#include <span>

namespace nrb::intersect {

// A place in a pair of parts: u, v in the first one and s, t in the second one, each from 0 to 1 over the
// part.
using CrossPlace = Place<4>;

// F(u, v, s, t) = A(u, v) - B(s, t) = 0 is a system of three equations in four unknowns z. Let k be the
// column of F' without which the determinant of the other three is largest in the middle of the parts, and M
// the inverse of these three columns. Over the box of both wide parts let R be bounds of |I - M F'|, all
// columns but k, and let S_i be an interval that contains row i of M F'_k. Let z and z0 be two places of the
// box, and y and y0 their coordinates but k. If the spectral radius of R is less than 1, the mean value
// theorem for the segment from z0 to z yields (Coupling)
//     |(y - y0) - M (F(z) - F(z0)) + S (z_k - z0_k)| <= R |y - y0|,
//     |y - y0| <= (I - R)^-1 |M (F(z) - F(z0)) - S (z_k - z0_k)|
// (the Krawczyk operator, R. Krawczyk 1969, row by row instead of in a norm). So each value of coordinate k
// has at most one zero: the zeros in the box are a graph over k, and no loop and no end of it can be inside.
// Any two zeros differ by (y - y0)_i in D_i (z_k - z0_k) with D = -S +- R (I - R)^-1 max |S|.
//
// Where both surfaces run along each other at a small angle, this holds only in parts that are much smaller
// than those in which it can be seen how the surfaces come apart. There M, R and S are those of the unknowns
// x and sigma of a CrossShear: one of the two x is k, the other one is j. Bounds of x_j and sigma give bounds
// of y by y_i = sigma_i + L_ij x_j + L_ik x_k, where all are differences from the start.
class CrossChart {
public:
    enum class Verdict {
        apart, // a row of M F is nowhere 0, so that there are no common points
        chart,
        bent, // neither: the parts bend too much, or noise is too large
        flat, // M does not exist: tangent planes are nearly parallel, or a derivative nearly vanishes
    };
    // Precondition: both parts are prepared.
    Verdict set(CrossCell &a, CrossCell &b);
    // The same, after set(), in the coordinates of a shear of the same parts that is bounded; `base`: which
    // surface is X.
    Verdict set_sheared(size_t base, const CrossShear &shear);

    [[nodiscard]] size_t axis() const noexcept { return axis_; } // k
    // start(): the place at which the search for zeros begins. holds_at(): whether the bounds hold at a place
    // in both wide parts; those of a shear do only where sigma is small enough.
    [[nodiscard]] const CrossPlace &start() const noexcept { return start_; }
    [[nodiscard]] bool holds_at(const CrossPlace &z) const noexcept;
    // An interval that contains coordinate i of all zeros of the box, as far as that is known.
    [[nodiscard]] const Interval &range(size_t i) const noexcept { return ranges_[i]; }
    [[nodiscard]] const Interval &shift(size_t i) const noexcept { return shifts_[i]; } // S
    [[nodiscard]] const Interval &rise(size_t i) const noexcept { return rises_[i]; }   // D; 1 for k
    // Bounds, for a zero z, of the difference between y - y0 and -M F(z0) - S (z_k - z0_k). step: M F(z0),
    // with an error of `off` times its noise; far: a bound of |z_k - z0_k|; farthest: bounds of |y - y0|.
    [[nodiscard]] CrossPlace drift(const CrossPlace &step, double off, double far,
                                   const CrossPlace &farthest) const noexcept;
    // How far places where |F| <= difference are from the zero with the same coordinate k.
    [[nodiscard]] CrossPlace off_at(double difference) const noexcept;
    // M F for a value of F; 0 for k.
    [[nodiscard]] CrossPlace step(const Vector3 &difference) const noexcept;
    // Whether the same M makes a chart also with what is beyond sides of both parts; in a shear always false.
    [[nodiscard]] bool goes_on(const CrossCell &a, const CrossCell &b,
                               std::span<const CrossCell::Beyond> beyond_a,
                               std::span<const CrossCell::Beyond> beyond_b) const;
    // Whether M exists.
    [[nodiscard]] bool has_rows() const noexcept { return has_rows_; }
    // If so: whether the first part adds more than the second one to R and to the width of S.
    [[nodiscard]] bool first_bends_more() const noexcept { return bends_[0] > bends_[1]; }
    // Whether the spectral radius of R is proven to be well below 1.
    [[nodiscard]] bool is_coupled() const noexcept { return coupled_; }
    // Error bounds of M F, row by row and of the largest row, that follow from near().
    [[nodiscard]] double noise(size_t i) const noexcept { return norms_[i] * near_; }
    [[nodiscard]] double noise() const noexcept { return most_norm_ * near_; }
    // Error bound of computed values of F.
    [[nodiscard]] double near() const noexcept { return near_; }
    // 1 if coordinate k rises along N_b x N_a, otherwise -1.
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
    CrossPlace norms_{}, own_norms_{}; // of rows of M, and of those for x and sigma
    Coupling<4> coupling_;
    std::array<Interval, 4> shifts_{}, own_shifts_{}, rises_{};
    CrossPlace start_{};
    std::array<Interval, 4> ranges_{};
    bool coupled_ = false, sheared_ = false;
    size_t across_ = 0; // j
    // L_ij, L_ik, and the bound of |sigma_i|; 0 for coordinates of X.
    CrossPlace leans_{}, leans_along_{}, aside_{};
    double most_difference_ = 0; // the largest |F| for which off_at() is known
    double most_norm_ = 0, near_ = 0;
    int direction_ = 0;
    std::array<double, 2> bends_{}; // what each part adds to R and to the width of S
    bool has_rows_ = false;
};

// The null vector (u', v', s', t') of the columns (a_0, a_1, -b_0, -b_1) for which
// a_0 u' + a_1 v' = N_b x N_a, where N_a = a_0 x a_1 and N_b = b_0 x b_1.
CrossPlace common_direction(const std::array<Vector3, 2> &a, const std::array<Vector3, 2> &b) noexcept;

// Solves the linear system of all columns but `fixed` for the right-hand side `of`; entry `fixed` of the
// solution is 0. False: these columns are nearly coplanar.
bool solve_columns(const std::array<Vector3, 4> &columns, size_t fixed, const Vector3 &of,
                   CrossPlace &solution) noexcept;

} // namespace nrb::intersect
