// SPDX-License-Identifier: MIT
// How the domain of a surface closes up, and the plane that covers it.
#pragma once

#include "spline/spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nrb::face {

using Point2 = std::array<double, 2>;

inline Point2 moved(const Point2 &x, const Point2 &by) noexcept {
    return {x[0] + by[0], x[1] + by[1]};
}

// An axis of a surface is closed if both of its ends are one curve in space. Then curves in the domain may
// run across an end into the next copy of the domain. All copies together form the plane that covers the
// domain. An end of an axis that is collapsed to a single point of space is a pole, as those of a globe.
class Covering {
public:
    // An axis is closed if its two ends are nowhere farther apart than the tolerance; an end is a pole if it
    // is no larger than the tolerance. Precondition: a surface.
    Covering(const Spline &surface, double tolerance);

    [[nodiscard]] Interval domain(int k) const noexcept { return domain_[static_cast<size_t>(k)]; }
    [[nodiscard]] double period(int k) const noexcept { return domain(k).upper - domain(k).lower; }
    // The period, or the largest magnitude of a parameter in the domain if that is larger: what the rounding
    // of parameters is a share of.
    [[nodiscard]] double reach(int k) const noexcept;
    [[nodiscard]] bool closed(int k) const noexcept { return closed_[static_cast<size_t>(k)]; }
    // The largest side of the box of the control points.
    [[nodiscard]] double extent() const noexcept { return extent_; }
    // End 0 or 1 of axis k.
    [[nodiscard]] bool collapsed(int k, int end) const noexcept {
        return collapsed_[static_cast<size_t>(k)][static_cast<size_t>(end)];
    }

    // The place of the domain that a place of the plane stands for; on axes that are not closed, the nearest
    // one.
    [[nodiscard]] Point2 in_domain(Point2 x) const noexcept;
    // The copy of a place that is in [lower, upper) of the domain on closed axes. A place that lies there
    // already stays as it is, bit for bit.
    [[nodiscard]] Point2 canonical(Point2 x) const noexcept;
    // The same plane, covered by copies of a domain that begins at another place on closed axes.
    [[nodiscard]] Covering begun_at(const Point2 &lower) const;
    // The same axes and poles for a surface that is this one moved in space.
    [[nodiscard]] Covering over_moved(const Spline &surface) const;
    // Reciprocals of powers of two that are about as large as the periods: in such units distances along both
    // axes are comparable, and scaling rounds nothing.
    [[nodiscard]] Point2 units() const noexcept;
    // The copy of a place that is nearest to another place.
    [[nodiscard]] Point2 nearest_copy(Point2 x, const Point2 &to) const noexcept;
    // Calls visit(move) for the moves by -1, 0 or 1 periods of closed axes that bring a box of the plane to
    // the domain, until it returns true. A box at one end of a closed axis is brought to the other end, too.
    template <class Visit>
    bool any_move(const Point2 &lower, const Point2 &upper, Visit &&visit) const {
        const auto inside = [&](int k, double move) {
            const auto at = static_cast<size_t>(k);
            return (move == 0 || closed(k)) && upper[at] + move >= domain(k).lower &&
                   lower[at] + move <= domain(k).upper;
        };
        for (const double i : {0.0, -1.0, 1.0}) {
            for (const double j : {0.0, -1.0, 1.0}) {
                const Point2 move{i * period(0), j * period(1)};
                if (inside(0, move[0]) && inside(1, move[1]) && visit(move)) {
                    return true;
                }
            }
        }
        return false;
    }
    [[nodiscard]] bool has_poles() const noexcept { return !poles_.empty(); }
    [[nodiscard]] std::vector<std::vector<double>> pole_points() const; // points of space [dim]
    // A pole within a distance of a point of space [dim]. axis: -1 if there is none.
    struct Pole {
        int axis = -1;
        int end = 0;
    };
    [[nodiscard]] Pole pole_near(const double *point, double distance) const noexcept;

private:
    void add_pole(const Spline &surface, int k, int end);

    struct PolePoint {
        Pole pole;
        std::vector<double> point;
    };
    std::array<Interval, 2> domain_;
    double extent_;
    std::array<bool, 2> closed_{};
    std::array<std::array<bool, 2>, 2> collapsed_{};
    std::vector<PolePoint> poles_;
};

// Precondition: x is in the domain.
std::vector<double> point_at(const Spline &surface, const Point2 &x);
// A new curve, even without a move, so that two curves that are compared are never the same object.
SplinePtr scaled_copy(const Spline &curve, const Point2 &scale, const Point2 &move);
// Calls visit(x) for the copies x = at + n period, n = ..., -1, 0, 1, ..., in a range that is not empty, rising.
template <class Visit>
void for_each_copy(double at, double period, const Interval &range, Visit &&visit) {
    constexpr double most = 0x1p31; // no curve of a face runs through so many
    const double first = std::ceil((range.lower - at) / period);
    const double count = std::floor((range.upper - at) / period) - first + 1;
    for (int64_t i = 0; range.lower < range.upper && static_cast<double>(i) < std::min(count, most); ++i) {
        visit(at + (first + static_cast<double>(i)) * period);
    }
}
// The distance in space of two places of the plane.
double gap_between(const Spline &surface, const Covering &covering, const Point2 &a, const Point2 &b);

} // namespace nrb::face
