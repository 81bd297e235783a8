// SPDX-License-Identifier: MIT
// Parts of two surfaces whose common points are a graph over one of their four parameters.
#pragma once

#include "intersect/contraction.h"
#include "intersect/surfaces/cross_cell.h"

#include <span>

namespace nrb::intersect {

// Places in a pair of parts: u, v of the first one, s, t of the second one.
using CrossPlace = Place<4>;

// F(u, v, s, t) = A(u, v) - B(s, t), three equations in four unknowns. M is the inverse of its derivative in the middle without
// the column k for which the determinant is largest. Over the box of both wide parts let |row i of I - M F'| <= rho_i, all
// columns but k summed, and row i of M F'_k be in S_i. If rho < 1, the mean value theorem for the segment between two
// places z and z0 of the box, y their coordinates but k, makes of M (F(z) - F(z0))
//     |(y - y0) - M (F(z) - F(z0)) + S (z_k - z0_k)|_i <= rho_i |y - y0|
// in the maximum norm (R. Krawczyk 1969). So for each value of coordinate k there is one zero at most: the zeros in the box
// are a graph over k, of which neither loops nor ends can be inside. Any two of them differ by (y - y0)_i in D_i (z_k - z0_k)
// with D_i = -S_i +- rho_i max |S| / (1 - rho).
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

    [[nodiscard]] size_t axis() const noexcept { return axis_; } // k
    [[nodiscard]] double rho(size_t i) const noexcept { return rho_[i]; }
    [[nodiscard]] double rho() const noexcept { return most_rho_; }
    [[nodiscard]] double norm(size_t i) const noexcept { return norms_[i]; } // of row i of M
    [[nodiscard]] double norm() const noexcept { return most_norm_; }
    [[nodiscard]] const Interval &shift(size_t i) const noexcept { return shifts_[i]; } // S
    [[nodiscard]] const Interval &rise(size_t i) const noexcept { return rises_[i]; }   // D; 1 for k
    // M F; 0 for k.
    [[nodiscard]] CrossPlace step(const Vector3 &difference) const noexcept;
    // Whether rho < 1 on what is beyond sides of both parts, too.
    [[nodiscard]] bool goes_on(const CrossCell &a, const CrossCell &b,
                               std::span<const CrossCell::Beyond> beyond_a,
                               std::span<const CrossCell::Beyond> beyond_b) const noexcept;
    // Whether M exists.
    [[nodiscard]] bool has_rows() const noexcept { return has_rows_; }
    // If so: whether the first part bends more than the second one.
    [[nodiscard]] bool first_bends_more() const noexcept { return bends_[0] > bends_[1]; }
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
    void set_rises() noexcept;
    [[nodiscard]] double off(size_t i, size_t surface, const CrossCell &cell,
                             const std::array<double, 2> &factors) const noexcept;

    size_t axis_ = 0;
    std::array<Vector3, 4> rows_{};
    std::array<double, 4> rho_{}, norms_{};
    std::array<Interval, 4> shifts_{}, rises_{};
    double most_rho_ = infinity, most_norm_ = 0, near_ = 0;
    int direction_ = 0;
    std::array<double, 2> bends_{}; // of both parts: what they add to rho
    bool has_rows_ = false;
};

// The null vector (u', v', s', t') of (a_0, a_1, -b_0, -b_1) for which a_0 u' + a_1 v' = N_b x N_a.
CrossPlace common_direction(const std::array<Vector3, 2> &a, const std::array<Vector3, 2> &b) noexcept;

// The columns but one, with the place of each: what solves them for a vector; false: they are all but in a plane.
bool solve_columns(const std::array<Vector3, 4> &columns, size_t fixed, const Vector3 &of,
                   CrossPlace &solution) noexcept;

} // namespace nrb::intersect
