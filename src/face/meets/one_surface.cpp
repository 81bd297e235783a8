// SPDX-License-Identifier: MIT
#include "face/meets/one_surface.h"

#include "closest/closest.h"
#include "eval/curve_point.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// How far beside the edge, as a share of the domain: less than the ground extends beyond edges.
constexpr double step = 1.0 / 128;

// The cost of proving a region grows with the number of pieces, and neighbours with many pieces are hardly
// ever parts of one surface.
constexpr size_t most_pieces = 64;

size_t pieces_of(const Spline &surface) {
    return (surface.axis(0).spans().breaks().size() - 1) * (surface.axis(1).spans().breaks().size() - 1);
}

double distance_from(const Spline &surface, const std::vector<double> &x, double tolerance) {
    return closest::locator_of(surface)
        .nearest({x.data(), nullptr, tolerance / 4, closest::usual_budget(surface), false, true})
        .distance;
}

// Tries a place on either side of the edge, because only one of them need be on both grounds.
bool goes_on(const std::array<SplinePtr, 2> &grounds, const Covering &covering, const CommonEdge &edge,
             double tolerance) {
    const Interval domain = edge.branch.on->axis(0).domain();
    const auto place = [&](double share) {
        return eval::curve_point(*edge.branch.on, parameter_in(domain, share), false);
    };
    const std::vector<double> from = place(0.46), on = place(0.5), to = place(0.54);
    const std::array<Interval, 2> ranges{grounds[0]->axis(0).domain(), grounds[0]->axis(1).domain()};
    const Point2 sizes{ranges[0].upper - ranges[0].lower, ranges[1].upper - ranges[1].lower},
        way{(to[0] - from[0]) / sizes[0], (to[1] - from[1]) / sizes[1]};
    const double length = std::hypot(way[0], way[1]);
    return std::ranges::any_of(std::array{-step, step}, [&](double by) {
        Point2 at{on[0] - by * way[1] / length * sizes[0], on[1] + by * way[0] / length * sizes[1]};
        bool inside = true; // false for edges that stand still
        for (const size_t k : {size_t{0}, size_t{1}}) {
            at[k] = covering.closed(static_cast<int>(k)) ? covering.in_domain(at)[k] : at[k];
            inside = inside && at[k] >= ranges[k].lower && at[k] <= ranges[k].upper;
        }
        return inside && distance_from(*grounds[1], point_at(*grounds[0], at), tolerance) <= tolerance;
    });
}

} // namespace

bool may_be_one(const std::array<SplinePtr, 2> &grounds, const Face &a, std::span<const CommonEdge> edges,
                double tolerance) {
    if (pieces_of(*grounds[0]) > most_pieces || pieces_of(*grounds[1]) > most_pieces) {
        return false;
    }
    return std::ranges::any_of(edges, [&](const CommonEdge &edge) {
        return edge.branch.kind == intersect::BranchKind::contact &&
               goes_on(grounds, a.covering(), edge, tolerance);
    });
}

} // namespace nrb::face
