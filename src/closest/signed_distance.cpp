// SPDX-License-Identifier: MIT
#include "closest/signed_distance.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "eval/frames/curve_limit.h"
#include "eval/frames/jet.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::closest {

namespace {

using Plane = std::array<double, 2>;

// Positive if b is to the left of a.
double cross(const Plane &a, const Plane &b) noexcept {
    return a[0] * b[1] - a[1] * b[0];
}

class Sides {
public:
    explicit Sides(const Spline &curve)
        : curve_(curve), axis_(curve.axis(0)), domain_(axis_.domain()), closed_(ends_meet()) {
        eval::Jet::prepare(curve);
    }

    // 1 if the query point x = C(t) + offset, whose nearest point is C(t), is to the left of the curve, else
    // -1. `speed` is C'(t). Between knots the sign of C'(t) x offset decides if the offset is clearly not
    // along the tangent.
    [[nodiscard]] double sign(double t, const Plane &offset, const Plane &speed) const {
        const bool between = t > domain_.lower && t < domain_.upper && !is_knot(t);
        const double side = cross(speed, offset);
        if (between && std::abs(side) > 0.5 * norm(speed.data(), 2) * norm(offset.data(), 2)) {
            return side < 0 ? -1 : 1;
        }
        return sign_at_corner(t, offset);
    }

private:
    [[nodiscard]] Plane point(double t, bool left) const {
        Plane x{};
        eval::AxisRules rules;
        rules[0].left = left;
        eval::evaluate_points(curve_, rules, 0, {&t, 1, 1, 1, 1}, {x.data(), 1, 2, 2, 1});
        return x;
    }
    [[nodiscard]] bool ends_meet() const {
        const Plane a = point(domain_.lower, false), b = point(domain_.upper, true);
        const double size = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(b[0]), std::abs(b[1])});
        return distance(a.data(), b.data(), 2) <= 64 * std::numeric_limits<double>::epsilon() * size;
    }
    [[nodiscard]] bool is_knot(double t) const {
        const auto knots = axis_.knots();
        return std::binary_search(knots.begin(), knots.end(), t);
    }

    // The unit tangent on one side; zero if there is none.
    [[nodiscard]] Plane tangent(double t, bool left) const {
        eval::AxisRules rules;
        rules[0].left = left;
        const eval::CurveTangent found = eval::curve_tangent(curve_, rules, t);
        return found.kind > 0 ? Plane{found.direction.x, found.direction.y} : Plane{};
    }

    // The sum of the unit tangents on both sides decides, which is the pseudonormal test for curves
    // (Baerentzen & Aanaes, "Signed distance computation using the angle weighted pseudonormal", 2005). If
    // the curve turns back on itself, the sum vanishes and the side to which the curve turns decides: a point
    // whose nearest point is the corner lies on the outer side of the turn.
    [[nodiscard]] double sign_at_corner(double t, const Plane &offset) const {
        const bool first = t == domain_.lower, last = t == domain_.upper;
        const Plane before = first ? (closed_ ? tangent(domain_.upper, true) : Plane{}) : tangent(t, true);
        const Plane after = last ? (closed_ ? tangent(domain_.lower, false) : Plane{}) : tangent(t, false);
        const Plane sum{before[0] + after[0], before[1] + after[1]};
        constexpr double turned_back =
            1e-6; // in radians from a full turn back; below it, the turn is the better guide
        if (norm(sum.data(), 2) > turned_back) {
            return cross(sum, offset) < 0 ? -1 : 1;
        }
        return turn(t) > 0 ? -1 : 1;
    }

    // The side to which the curve turns at t: the cross product of the chords to nearby points before and
    // after it; positive if it turns left.
    [[nodiscard]] double turn(double t) const {
        const bool first = t == domain_.lower, last = t == domain_.upper;
        constexpr double part = 1.0 / 1024;
        const double below = first ? domain_.upper : t, above = last ? domain_.lower : t;
        const int64_t lower = axis_.find_span(below, true), upper = axis_.find_span(above, false);
        const Plane from = point(below - part * (axis_[lower + 1] - axis_[lower]), true);
        const Plane to = point(above + part * (axis_[upper + 1] - axis_[upper]), false);
        const Plane at = point(t, last);
        return cross({at[0] - from[0], at[1] - from[1]}, {to[0] - at[0], to[1] - at[1]});
    }

    const Spline &curve_;
    const KnotVector &axis_;
    Interval domain_;
    bool closed_;
};

// The answers and derivatives of one block of queries.
struct Block {
    static constexpr int64_t size = 64;
    std::array<double, size> params;
    std::array<double, size> distances;
    std::array<int32_t, size> status;
    std::array<double, 2 * size> feet;
    std::array<double, 4 * size> derivs;
};

} // namespace

void signed_distances(const Spline &curve, const ConstRecords &points, const Query &query,
                      const FeetOutputs &out) {
    const Sides sides(curve);
    eval::AxisRules rules;
    rules[0].nan = true;
    Block block;
    Steps steps((points.count + Block::size - 1) / Block::size);
    for (int64_t first = 0; first < points.count; first += Block::size, steps.next()) {
        ConstRecords part = points;
        part.data += first * points.stride;
        part.count = std::min(Block::size, points.count - first);
        FeetOutputs found{{block.params.data(), part.count, 1, 1, 1},
                          {block.feet.data(), part.count, 2, 2, 1},
                          {block.distances.data(), part.count, 1, 1, 1},
                          block.status.data()};
        closest_points(curve, part, query, found);
        eval::evaluate_points(curve, rules, 1, {block.params.data(), part.count, 1, 1, 1},
                              {block.derivs.data(), part.count, 4, 4, 1});
        for (int64_t i = 0; i < part.count; ++i) {
            const auto at = static_cast<size_t>(i);
            const Plane offset{part(i, 0) - found.feet(i, 0), part(i, 1) - found.feet(i, 1)};
            const Plane speed{block.derivs[4 * at + 2], block.derivs[4 * at + 3]};
            const bool valid = (block.status[at] & closest_invalid) == 0;
            const double sign = valid ? sides.sign(block.params[at], offset, speed) : 1;
            out.distances(first + i, 0) = sign * block.distances[at];
            if (out.params.data != nullptr) {
                out.params(first + i, 0) = block.params[at];
            }
            if (out.status != nullptr) {
                out.status[first + i] = block.status[at];
            }
        }
    }
}

} // namespace nrb::closest
