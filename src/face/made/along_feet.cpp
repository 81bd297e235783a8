// SPDX-License-Identifier: MIT
#include "face/made/along_feet.h"

#include "base/error.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "bounds/deviation.h"
#include "closest/closest.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"
#include "refine/compose/compose.h"
#include "spline/part.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::face {

namespace {

constexpr int cubic = 3;
constexpr size_t most_ordinates = 1536; // Bezier ordinates of a map

// Parameters of both curves that correspond.
struct Node {
    double from, to;
};

std::vector<double> inner_knots(const KnotVector &axis) {
    const Interval domain = axis.domain();
    std::vector<double> found;
    for (const double knot : axis.knots()) {
        if (knot > domain.lower && knot < domain.upper && (found.empty() || knot > found.back())) {
            found.push_back(knot);
        }
    }
    return found;
}

// Makes the map phi from foot points.
class FootMap {
public:
    FootMap(const Spline &a, const Spline &b, double tolerance)
        : a_(a), b_(b), from_(a.axis(0).domain()), to_(b.axis(0).domain()), tolerance_(tolerance) {
        nodes_.push_back({from_.lower, to_.lower});
        for (const double knot : inner_knots(a.axis(0))) {
            nodes_.push_back({knot, foot(a, knot, b, to_)});
        }
        for (const double knot : inner_knots(b.axis(0))) {
            nodes_.push_back({foot(b, knot, a, from_), knot});
        }
        nodes_.push_back({from_.upper, to_.upper});
        for (const bool upper : {false, true}) {
            apart_ = std::max(apart_, distance(eval::end_point(a, upper).data(),
                                               eval::end_point(b, upper).data(), a.dim()));
        }
        std::ranges::sort(nodes_, {}, &Node::from);
        leave_out_near();
    }

    // The map as a scalar spline over the domain of a. Cubics are halved until the distance at a few places
    // of each is at most d + share (tolerance - d), where d is the largest distance of a foot. Null where
    // that takes too many cubics, or where a cubic has to be halved although d exceeds the tolerance.
    [[nodiscard]] SplinePtr map(double share) {
        std::vector<Node> waiting(nodes_.rbegin(), nodes_.rend() - 1);
        std::vector<double> knots(cubic + 1, from_.lower), points{to_.lower};
        for (Node before = nodes_.front(); !waiting.empty();) {
            const Node next = waiting.back();
            const std::array<double, 4> ordinates = cubic_between(before, next);
            const double middle = parameter_in({before.from, next.from}, 0.5);
            if (is_near(before, next, ordinates, share) || !(before.from < middle && middle < next.from)) {
                points.insert(points.end(), ordinates.begin() + 1, ordinates.end());
                knots.insert(knots.end(), cubic, next.from);
                before = next;
                waiting.pop_back();
            } else if (points.size() + waiting.size() > most_ordinates || apart_ > tolerance_) {
                return nullptr;
            } else {
                waiting.push_back({middle, foot(a_, middle, b_, {before.to, next.to})});
            }
        }
        knots.push_back(from_.upper);
        return make_spline({make_knot_vector(cubic, std::move(knots))}, 1, Form::polynomial,
                           std::move(points), {});
    }

private:
    double foot(const Spline &curve, double t, const Spline &other, Interval range) {
        if (!(range.lower < range.upper)) {
            return range.lower;
        }
        const std::vector<double> x = eval::curve_point(curve, t, false);
        const Interval part[] = {range};
        const closest::Foot found = closest::locator_of(other).nearest(
            {x.data(), part, tolerance_ / 64, closest::usual_budget(other), false, true});
        apart_ = std::max(apart_, found.distance);
        return found.params[0];
    }

    // Leaves out nodes so that both parameters rise from each to the next by at least 2^-20 of their domains.
    void leave_out_near() {
        const auto apart = [this](const Node &a, const Node &b) {
            constexpr double room = 0x1p-20;
            return b.from - a.from > room * (from_.upper - from_.lower) &&
                   b.to - a.to > room * (to_.upper - to_.lower);
        };
        std::vector<Node> kept{nodes_.front()};
        for (const Node &node : nodes_) {
            if (apart(kept.back(), node) && apart(node, nodes_.back())) {
                kept.push_back(node);
            }
        }
        kept.push_back(nodes_.back());
        nodes_ = std::move(kept);
    }

    // The cubic through the feet at one and two thirds, with its Bezier ordinates clamped to the domain of b.
    std::array<double, 4> cubic_between(const Node &start, const Node &end) {
        std::array<double, 4> v{start.to, 0, 0, end.to};
        for (const size_t k : {size_t{1}, size_t{2}}) {
            const double t = parameter_in({start.from, end.from}, static_cast<double>(k) / cubic);
            v[k] = foot(a_, t, b_, {v[k - 1], end.to});
        }
        return {v[0], inside((-5 * v[0] + 18 * v[1] - 9 * v[2] + 2 * v[3]) / 6),
                inside((2 * v[0] - 9 * v[1] + 18 * v[2] - 5 * v[3]) / 6), v[3]};
    }
    // Whether the curves are near each other at samples between the places that the cubic interpolates.
    [[nodiscard]] bool is_near(const Node &start, const Node &end, const std::array<double, 4> &c,
                               double share) const {
        const double near = apart_ + share * (tolerance_ - apart_);
        return std::ranges::all_of(std::array{0.125, 0.5, 0.875}, [&](double x) {
            const double y = 1 - x;
            const double s = y * y * y * c[0] + 3 * y * x * (y * c[1] + x * c[2]) + x * x * x * c[3];
            const std::vector<double> p =
                eval::curve_point(a_, parameter_in({start.from, end.from}, x), false);
            const std::vector<double> q = eval::curve_point(b_, inside(s), false);
            return distance(p.data(), q.data(), a_.dim()) <= near;
        });
    }
    [[nodiscard]] double inside(double s) const noexcept { return std::clamp(s, to_.lower, to_.upper); }

    const Spline &a_, &b_;
    Interval from_, to_;
    double tolerance_, apart_ = 0; // the largest distance of a foot
    std::vector<Node> nodes_;
};

} // namespace

double distance_along_feet(const SplinePtr &a, const SplinePtr &b, double tolerance) {
    if (cubic * b->axis(0).degree() > max_degree) {
        return infinity;
    }
    try {
        FootMap feet(*a, *b, tolerance);
        double best = infinity;
        for (const double share : {0.5, 0.0625}) {
            const SplinePtr map = best > tolerance ? feet.map(share) : nullptr;
            if (map != nullptr) {
                best = std::min(best, bounds::deviation_below(*a, *refine::compose(b, map), tolerance));
            }
        }
        return best;
    } catch (const Error &) { // knots would merge, or curves jump
        return infinity;
    }
}

} // namespace nrb::face
