// SPDX-License-Identifier: MIT
#include "mesh/polyline/polyline.h"

#include "base/watch.h"
#include "mesh/polyline/segments.h"

#include <algorithm>
#include <utility>

namespace nrb::mesh {

namespace {

class Builder {
public:
    Builder(const Spline &curve, const PolylineRule &rule) : parts_(curve, rule) {}

    Polyline build(std::span<const double> fixed) {
        const Interval domain = parts_.curve().axis(0).domain();
        std::vector<Corner> stops = parts_.corners();
        for (const double t : fixed) {
            stops.push_back({t, false});
        }
        stops.push_back({domain.upper, true});
        std::ranges::stable_sort(stops, {}, &Corner::t);
        chain_.vertices.push_back(parts_.vertex(domain.lower, false));
        for (const Corner &stop : stops) {
            if (stop.t > chain_.vertices.back().t) {
                go_to(stop, stop.t < domain.upper);
            }
        }
        open_up();
        return polyline();
    }

private:
    // With the limit from the right as a vertex, if the curve jumps there and goes on.
    void go_to(const Corner &stop, bool goes_on) {
        append(chain_, spread_evenly(parts_, greedy(parts_, chain_.vertices.back(), end_at(stop))));
        if (stop.jump && goes_on) {
            chain_.vertices.push_back(parts_.vertex(stop.t, false));
            chain_.segments.push_back({});
        }
    }
    // A periodic curve ends where it began, bit for bit.
    [[nodiscard]] Vertex end_at(const Corner &stop) const {
        const KnotVector &axis = parts_.curve().axis(0);
        Vertex end = parts_.vertex(stop.t, stop.jump);
        if (axis.periodic() && stop.t == axis.domain().upper) {
            end.point = chain_.vertices.front().point;
            end.in_frame = chain_.vertices.front().in_frame;
        }
        return end;
    }
    // A closed curve is no polygon of two sides, unless it is a point.
    void open_up() {
        const size_t count = chain_.segments.size();
        if (count >= 3 || !parts_.closed()) {
            return;
        }
        const Run old = std::exchange(chain_, {{chain_.vertices.front()}, {}});
        for (size_t i = 0; i < count; ++i) {
            append(chain_, divided(parts_, old.vertices[i], old.vertices[i + 1], count == 1 ? 3 : 2));
        }
    }

    [[nodiscard]] Polyline polyline() {
        Polyline made;
        for (const Vertex &vertex : chain_.vertices) {
            made.params.push_back(vertex.t);
            made.points.insert(made.points.end(), vertex.point.begin(), vertex.point.end());
        }
        for (const Segment &segment : chain_.segments) {
            made.bounds.push_back(segment.bound);
            made.reached = made.reached && segment.proven;
        }
        return made;
    }

    CurveParts parts_;
    Run chain_; // so far; segments at jumps are empty
};

} // namespace

Polyline polyline_of(const Spline &curve, const PolylineRule &rule, std::span<const double> fixed) {
    const UsualLimit usual(usual_work(curve.point_count()));
    const LimitedSearch limited;
    return Builder(curve, rule).build(fixed);
}

} // namespace nrb::mesh
