// SPDX-License-Identifier: MIT
// Pairs of curve pieces that run side by side.
#pragma once

#include "pieces/slopes.h"

#include <optional>

namespace nrb::intersect {

// Let d be a unit vector along which neither derivative has a zero: then each value of x . d is at no more
// than one place of each piece. Places of equal values are matched. Where |A(s) - B(t)| <= near, the values
// differ by at most near.
class Beside {
public:
    void set(const pieces::BezierPiece &a, const pieces::Slopes &slopes_a, const pieces::BezierPiece &b,
             const pieces::Slopes &slopes_b);

    // Whether there is such a vector: the direction of the mean derivative of a. All other members presume
    // it.
    [[nodiscard]] bool proven() const noexcept { return direction_ != 0; }
    // 1, or -1 if b runs against a.
    [[nodiscard]] int direction() const noexcept { return direction_; }

    [[nodiscard]] const double *vector() const noexcept { return d_.data(); }
    // In the plane: the slopes of both, as graphs over x . d.
    [[nodiscard]] Interval slopes_of_a() const noexcept { return slopes(*of_a_, least_a_); }
    [[nodiscard]] Interval slopes_of_b() const noexcept { return slopes(*of_b_, least_b_); }

    // Local parameters. Those on b descend if it runs against a.
    struct Places {
        Interval a, b;
        [[nodiscard]] Interval rising_b() const noexcept {
            return {std::min(b.lower, b.upper), std::max(b.lower, b.upper)};
        }
    };
    // The smallest ranges that hold all near places; none if there can be none.
    [[nodiscard]] std::optional<Places> near(double near);
    // How far near places may be from the matched places, on a and on b.
    [[nodiscard]] double reach_a(double near) const noexcept { return near / least_a_; }
    [[nodiscard]] double reach_b(double near) const noexcept { return near / least_b_; }
    // The length along d of the parts that match; negative if they are apart.
    [[nodiscard]] double length() const noexcept { return common().upper - common().lower; }
    // The matched parts, and matched places in the middle of them.
    struct Match {
        Places ends;
        double middle_a, middle_b;
    };
    // Precondition: length() > 0.
    [[nodiscard]] Match match();

private:
    [[nodiscard]] Interval slopes(const pieces::Slopes &of, double least) const noexcept;
    // The values of x . d that both have, and a bound on the rounding of such values.
    [[nodiscard]] Interval common() const noexcept;
    [[nodiscard]] double rounding() const noexcept;
    [[nodiscard]] Places at(Interval values);
    [[nodiscard]] double place(const pieces::BezierPiece &piece, int direction, double value);

    const pieces::BezierPiece *a_ = nullptr, *b_ = nullptr;
    const pieces::Slopes *of_a_ = nullptr, *of_b_ = nullptr;
    std::vector<double> d_, given_, f_;
    Interval values_a_{}, values_b_{};
    double least_a_ = 1, least_b_ = 1; // least derivatives along d
    int direction_ = 0;
};

} // namespace nrb::intersect
