// SPDX-License-Identifier: MIT
// Parts of two surfaces that run along each other at a small angle, in sheared coordinates: the bending that
// they have in common cancels, and it can be seen how they come apart.
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <array>
#include <optional>

namespace nrb::intersect {

// Let x_0 and y_0 be places of the parts X and Y (the start) whose points are about the same, and n the
// normal of Y at y_0. The unknown y is replaced by its difference sigma from a linear image of x,
//     y = y_0 + L (x - x_0) + sigma,
// where L is such that X' - Y' L has no component in the tangent plane of Y at the start. Where X and Y
// coincide, sigma is of second order. In the unknowns x and sigma, the derivatives of G = X(x) - Y(y) are
// C = X'(x) - Y'(y) L and -Y'(y). For any vector d, what both surfaces bend alike cancels in the change of
// d . C: with intervals of d . X'' and d . Y'' over both wide parts,
//     d . C_j = d . C_j(x_0, y_0) + sum_l H_jl (x - x_0)_l - sum_m P_jm sigma_m,
//     d . Y_m = d . Y_m(y_0) + sum_i d . Y_mi (y - y_0)_i,
//     H = d . X'' - L^T (d . Y'') L,  P = L^T (d . Y'').
// So parts need not be so small that each of them is flat; it is enough that they bend alike. d is n or one
// of the dual vectors N_0 and N_1 in the tangent plane of Y at y_0: there N_i . Y_m is 1 if i = m, otherwise
// 0.
class CrossShear {
public:
    enum class Verdict {
        apart,
        bounded, // what follows is known
        open,    // the parts are too large
        useless, // the surfaces do not bend alike along any axis of X, nor do smaller parts
    };
    // Precondition: both parts are prepared. Parts that coincide to within a sixteenth of the tolerance,
    // judged by the start and the tangent planes there, are left open at once.
    Verdict set(const CrossCell &x, const CrossCell &y, double tolerance);

    [[nodiscard]] const std::array<double, 2> &start_x() const noexcept { return starts_[0]; }
    [[nodiscard]] const std::array<double, 2> &start_y() const noexcept { return starts_[1]; }
    [[nodiscard]] const std::array<Vector3, 2> &slopes_of_x() const noexcept { return slopes_of_x_; }
    [[nodiscard]] const std::array<Vector3, 2> &slopes_of_y() const noexcept { return slopes_of_y_; }
    [[nodiscard]] const Vector3 &normal() const noexcept { return vectors_[2]; }          // n
    [[nodiscard]] const Vector3 &dual(size_t i) const noexcept { return vectors_[i]; }    // N
    [[nodiscard]] double lean(size_t i, size_t j) const noexcept { return leans_[i][j]; } // L
    // Bounds of n . C_j and n . Y_m.
    [[nodiscard]] const Interval &slope(size_t j) const noexcept { return slopes_[2][j]; }
    [[nodiscard]] const Interval &tilt(size_t m) const noexcept { return owns_[2][m]; }
    // Bounds of N_i . C_j and N_i . Y_m.
    [[nodiscard]] const Interval &along(size_t i, size_t j) const noexcept { return slopes_[i][j]; }
    [[nodiscard]] const Interval &own(size_t i, size_t m) const noexcept { return owns_[i][m]; }
    // These bounds hold where |sigma_m| <= most_aside(m) for both m. Zeros have a smaller sigma, and so have
    // all places of both parts where |N_i . G| <= free() for both i.
    [[nodiscard]] double most_aside(size_t m) const noexcept { return most_aside_[m]; }
    [[nodiscard]] double free() const noexcept { return free_; }

    // Intervals of the places of all zeros of the box.
    [[nodiscard]] const Interval &range_of_x(size_t j) const noexcept { return ranges_of_x_[j]; }
    [[nodiscard]] const Interval &range_of_y(size_t m) const noexcept { return ranges_of_y_[m]; }

    // Whether n . C is nowhere 0 along one of the axes: then tangent planes are nowhere the same.
    [[nodiscard]] bool touch_nowhere() const noexcept;
    // Whether the surfaces come apart: touch_nowhere(), or zeros are in two separate intervals.
    [[nodiscard]] bool come_apart() const noexcept { return parts_ == 2 || touch_nowhere(); }
    // A bound of |n . G| for x_j = (x_0)_j, where j is the axis of X along which n . G changes more: how far
    // apart both may be along the other axis.
    [[nodiscard]] double height() const noexcept { return height_; }
    // What to halve where the bounds are not enough: X (first) or Y; X along which axis, if that matters.
    struct Cut {
        bool first;
        std::optional<size_t> axis;
    };
    [[nodiscard]] const Cut &cut() const noexcept { return cut_; }
    // Or what is left of both parts, with some margin, if that is far less than all of them: one or two parts
    // of X, and one of Y; otherwise count is 0.
    struct Parts {
        size_t count = 0;
        double left = 1; // the share of all, in four dimensions
        std::array<std::array<Interval, 2>, 2> of_x{};
        std::array<Interval, 2> of_y{};
    };
    [[nodiscard]] Parts parts() const noexcept;

private:
    using Pair = std::array<double, 2>;
    using Ranges = std::array<Interval, 2>;

    // Second derivatives along a vector d, one of n, N_0 and N_1: 00, 01 and 11.
    struct Bends {
        std::array<Interval, 3> of_x, of_y, leaning; // d . X'', d . Y'' and L^T (d . Y'') L
        std::array<Interval, 3> both;                // H
        std::array<Ranges, 2> mixed;                 // P
    };
    // A region of both parts: intervals of x - x_0 and y - y_0, and bounds of |sigma|.
    struct Away {
        Ranges x, y;
        Pair aside;
    };

    bool set_vectors(const Vector3 &along_0, const Vector3 &along_1) noexcept;
    void set_leans() noexcept;
    bool set_start(const CrossCell &x, const CrossCell &y, double beside);
    bool move_foot(const Pair &step, double beside) noexcept;
    [[nodiscard]] bool are_beside(const CrossCell &x, const CrossCell &y) const;
    [[nodiscard]] bool is_along(double tolerance) const noexcept;
    void set_bends(size_t d, const CrossCell &x, const CrossCell &y);
    [[nodiscard]] bool is_useful() const noexcept;
    void set_errors(const CrossCell &x, const CrossCell &y) noexcept;
    [[nodiscard]] Interval slope_in(size_t d, size_t j, const Away &away, double share) const noexcept;
    [[nodiscard]] Interval own_in(size_t d, size_t m, const Away &away, double share) const noexcept;
    bool set_aside(Away &away);
    bool narrow(Away &away) const noexcept;
    bool give_room(Away &away);
    [[nodiscard]] Interval height_beside(size_t j, const Away &away) const noexcept;
    void set_zeros(const Away &away) noexcept;
    void set_ranges(const Away &away) noexcept;
    void set_slopes(const Away &away) noexcept;
    void set_cut(const CrossCell &x, const CrossCell &y, const Away &away) noexcept;

    std::array<Pair, 2> starts_{}, leans_{}, inverse_leans_{};
    bool has_inverse_ = false; // whether L can be inverted
    std::array<Vector3, 2> slopes_of_x_{}, slopes_of_y_{};
    Vector3 between_; // X - Y at the start
    double error_ = 0;
    Pair slope_errors_{}, own_errors_{}; // error bounds of C and Y' at the start
    std::array<Vector3, 3> vectors_{};   // N_0, N_1 and n
    std::array<double, 3> lengths_{};
    std::array<Bends, 3> bends_{};
    std::array<Ranges, 3> slopes_{}, owns_{}; // d . C and d . Y'
    Ranges ranges_of_x_{}, ranges_of_y_{};
    Pair most_aside_{};
    double free_ = 0, grows_ = 0; // grows_: how fast |sigma| grows with |N . G|
    double height_ = 0;
    size_t across_ = 0; // the axis of X along which n . G changes more
    // The intervals of places along it that contain all zeros, two at most.
    size_t parts_ = 0;
    Ranges places_{};
    Cut cut_{};
};

} // namespace nrb::intersect
