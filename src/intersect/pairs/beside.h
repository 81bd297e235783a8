// SPDX-License-Identifier: MIT
// Pairs of pieces of curves that run beside each other.
#pragma once

#include "pieces/slopes.h"

#include <optional>

namespace nrb::intersect {

// With a unit vector d along which neither derivative has a zero, each value of x . d is at one place of each piece
// at most. Places of equal values are matched; where |A(s) - B(t)| <= near, the values differ by no more than that.
class Beside {
public:
    void set(const pieces::BezierPiece &a, const pieces::Slopes &slopes_a, const pieces::BezierPiece &b,
             const pieces::Slopes &slopes_b);

    // Whether there is such a vector: the mean derivative of a. The rest presumes it.
    [[nodiscard]] bool proven() const noexcept { return direction_ != 0; }
    // 1, or -1 where b runs against a.
    [[nodiscard]] int direction() const noexcept { return direction_; }

    [[nodiscard]] const double *vector() const noexcept { return d_.data(); }
    // In the plane: as graphs over x . d.
    [[nodiscard]] Interval slopes_of_a() const noexcept { return slopes(*of_a_, least_a_); }
    [[nodiscard]] Interval slopes_of_b() const noexcept { return slopes(*of_b_, least_b_); }

    // Places; those on b fall if it runs against a.
    struct Places {
        Interval a, b;
        [[nodiscard]] Interval rising_b() const noexcept {
            return {std::min(b.lower, b.upper), std::max(b.lower, b.upper)};
        }
    };
    // The smallest ones that hold all places that are near; none if nothing can be.
    [[nodiscard]] std::optional<Places> near(double near);
    // How far from matched places on a, and on b, what is near may be.
    [[nodiscard]] double reach_a(double near) const noexcept { return near / least_a_; }
    [[nodiscard]] double reach_b(double near) const noexcept { return near / least_b_; }
    // The length of the parts that match, along d; negative where they are apart.
    [[nodiscard]] double length() const noexcept { return common().upper - common().lower; }
    // Those parts, and places in their middle.
    struct Match {
        Places ends;
        double middle_a, middle_b;
    };
    // Precondition: length() > 0.
    [[nodiscard]] Match match();

private:
    [[nodiscard]] Interval slopes(const pieces::Slopes &of, double least) const noexcept;
    // Of values of x . d, and what rounding does to them.
    [[nodiscard]] Interval common() const noexcept;
    [[nodiscard]] double rounding() const noexcept;
    [[nodiscard]] Places at(Interval values);
    [[nodiscard]] double place(const pieces::BezierPiece &piece, int direction, double value);

    const pieces::BezierPiece *a_ = nullptr, *b_ = nullptr;
    const pieces::Slopes *of_a_ = nullptr, *of_b_ = nullptr;
    std::vector<double> d_, given_, f_;
    Interval values_a_{}, values_b_{};
    double least_a_ = 1, least_b_ = 1; // slopes along d
    int direction_ = 0;
};

} // namespace nrb::intersect
