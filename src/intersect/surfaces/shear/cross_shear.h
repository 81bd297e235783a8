// SPDX-License-Identifier: MIT
// Parts of two surfaces that run along each other, in coordinates in which it is seen how they come apart.
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <array>
#include <optional>

namespace nrb::intersect {

// Places x of the part X and y of the part Y by their differences from a place in each, at which the points are about one:
//     y = y_0 + L (x - x_0) + sigma,
// with X' - Y' L = 0 across the normal n of Y there. Where X and Y are one, sigma is of second order. In the unknowns x and sigma the
// derivatives of G = X(x) - Y(y) are C = X'(x) - Y'(y) L and -Y'(y). Along any vector d all is gone of C that both surfaces
// bend alike, as with intervals of d . X'' and d . Y'' over both wide parts
//     d . C_j = d . C_j(x_0, y_0) + sum_l H_jl (x - x_0)_l - sum_m P_jm sigma_m,  H = d . X'' - L^T (d . Y'') L,  P = L^T (d . Y''),
//     d . Y_m = d . Y_m(y_0) + sum_i d . Y_mi (y - y_0)_i:
// parts need not be so small that each of them is flat, but so that they bend alike. d is n, or one of N_0 and N_1, along which
// Y_0 and Y_1 are 1 and 0, or 0 and 1, at y_0.
class CrossShear {
public:
    enum class Verdict {
        apart,
        bounded, // what follows is known
        open,    // the parts are too large
        useless, // as in all smaller parts: the surfaces do not bend alike along any axis of X
    };
    // Precondition: both are prepared. What is along each other within a sixteenth of the tolerance is
    // left open at once.
    Verdict set(const CrossCell &x, const CrossCell &y, double tolerance);

    [[nodiscard]] const std::array<double, 2> &start_x() const noexcept { return starts_[0]; }
    [[nodiscard]] const std::array<double, 2> &start_y() const noexcept { return starts_[1]; }
    [[nodiscard]] const std::array<Vector3, 2> &slopes_of_x() const noexcept { return slopes_of_x_; }
    [[nodiscard]] const std::array<Vector3, 2> &slopes_of_y() const noexcept { return slopes_of_y_; }
    [[nodiscard]] const Vector3 &normal() const noexcept { return vectors_[2]; }          // n
    [[nodiscard]] const Vector3 &dual(size_t i) const noexcept { return vectors_[i]; }    // N
    [[nodiscard]] double lean(size_t i, size_t j) const noexcept { return leans_[i][j]; } // L
    // n . C_j and n . Y_m.
    [[nodiscard]] const Interval &slope(size_t j) const noexcept { return slopes_[2][j]; }
    [[nodiscard]] const Interval &tilt(size_t m) const noexcept { return owns_[2][m]; }
    // N_i . C_j and N_i . Y_m.
    [[nodiscard]] const Interval &along(size_t i, size_t j) const noexcept { return slopes_[i][j]; }
    [[nodiscard]] const Interval &own(size_t i, size_t m) const noexcept { return owns_[i][m]; }
    // All of this holds where |sigma| is no larger, and that of zeros is less. So is that of places of both parts where |N_i . G| is no
    // larger than free().
    [[nodiscard]] double most_aside(size_t m) const noexcept { return most_aside_[m]; }
    [[nodiscard]] double free() const noexcept { return free_; }

    // In which places zeros of the box are.
    [[nodiscard]] const Interval &range_of_x(size_t j) const noexcept { return ranges_of_x_[j]; }
    [[nodiscard]] const Interval &range_of_y(size_t m) const noexcept { return ranges_of_y_[m]; }

    // Whether n . C is not 0 along one of the axes: they touch nowhere.
    [[nodiscard]] bool touch_nowhere() const noexcept;
    // Or they come apart on both sides of where they may.
    [[nodiscard]] bool come_apart() const noexcept { return parts_ == 2 || touch_nowhere(); }
    // How far apart both may be along n at most where n . C along one of the axes is as at the start.
    [[nodiscard]] double height() const noexcept { return height_; }
    // What to halve, where that is not enough: X or Y, of X along which axis.
    struct Cut {
        bool first;
        std::optional<size_t> axis;
    };
    [[nodiscard]] const Cut &cut() const noexcept { return cut_; }
    // Or what is left of both, with some room, if that is far less than all: places in X, one or two, and in Y.
    struct Parts {
        size_t count = 0;
        double left = 1; // share of all
        std::array<std::array<Interval, 2>, 2> of_x{};
        std::array<Interval, 2> of_y{};
    };
    [[nodiscard]] Parts parts() const noexcept;

private:
    using Pair = std::array<double, 2>;
    using Ranges = std::array<Interval, 2>;

    // Second derivatives along one of the vectors: 00, 01 and 11.
    struct Bends {
        std::array<Interval, 3> of_x, of_y, leaning; // d . X'', d . Y'' and L^T (d . Y'') L
        std::array<Interval, 3> both;                // H
        std::array<Ranges, 2> mixed;                 // P
    };
    // Where zeros are in one of both parts, as differences from the start.
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
    bool has_inverse_ = false; // L
    std::array<Vector3, 2> slopes_of_x_{}, slopes_of_y_{};
    Vector3 between_; // X - Y at the start
    double error_ = 0;
    Pair slope_errors_{}, own_errors_{}; // of C and Y' at the start
    std::array<Vector3, 3> vectors_{};   // N_0, N_1 and n
    std::array<double, 3> lengths_{};
    std::array<Bends, 3> bends_{};
    std::array<Ranges, 3> slopes_{}, owns_{}; // d . C and d . Y'
    Ranges ranges_of_x_{}, ranges_of_y_{};
    Pair most_aside_{};
    double free_ = 0, grows_ = 0; // grows_: how fast sigma does with N . G
    double height_ = 0;
    size_t across_ = 0; // the axis of X along which n . G changes more
    // Where along it zeros are, in up to two parts.
    size_t parts_ = 0;
    Ranges places_{};
    Cut cut_{};
};

} // namespace nrb::intersect
