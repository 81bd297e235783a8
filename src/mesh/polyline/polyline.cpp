// SPDX-License-Identifier: MIT
#include "mesh/polyline/polyline.h"

#include "base/watch.h"
#include "mesh/polyline/segments.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nrb::mesh {

namespace {

class Builder {
public:
    Builder(const Spline &curve, const PolylineRule &rule)
        : parts_(curve, rule), domain_(curve.axis(0).domain()), periodic_(curve.axis(0).periodic()),
          closed_(parts_.closed()) {}

    Polyline build(std::span<const double> fixed) {
        std::vector<Corner> stops = parts_.corners();
        std::ranges::transform(fixed, std::back_inserter(stops), [](double t) { return Corner{t, false}; });
        std::erase_if(stops, [this](const Corner &stop) { return stop.t >= domain_.upper; });
        stops.push_back({domain_.upper, periodic_ && !closed_});
        std::ranges::stable_sort(stops, {}, &Corner::t);
        chain_.vertices.push_back(parts_.vertex(domain_.lower, false));
        for (const Corner &stop : stops) {
            if (stop.t > chain_.vertices.back().t) {
                go_to(stop);
            }
        }
        open_up();
        return polyline();
    }

private:
    // Continues the chain to a stop. Where the curve jumps, both limits become vertices.
    void go_to(const Corner &stop) {
        const Vertex right = goes_on_from(stop.t);
        const Vertex end = stop.jump ? parts_.vertex(stop.t, true) : right;
        append(chain_, spread_evenly(parts_, greedy(parts_, chain_.vertices.back(), end)));
        if (stop.jump) {
            chain_.vertices.push_back(right);
            chain_.segments.push_back({});
        }
    }
    // The vertex from which the curve goes on. A periodic curve goes on where it began, bit for bit.
    [[nodiscard]] Vertex goes_on_from(double t) const {
        if (!periodic_ || t < domain_.upper) {
            return parts_.vertex(t, false);
        }
        const Vertex &first = chain_.vertices.front();
        return {t, first.point, first.in_frame};
    }
    [[nodiscard]] bool jumps() const noexcept {
        return std::ranges::adjacent_find(chain_.vertices, {}, &Vertex::t) != chain_.vertices.end();
    }
    // A closed curve must not become a polygon with one or two sides.
    void open_up() {
        const size_t count = chain_.segments.size();
        if (count >= 3 || !closed_ || jumps()) {
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
    Interval domain_;
    bool periodic_, closed_;
    Run chain_; // so far; at jumps segments are empty
};

} // namespace

Polyline polyline_of(const Spline &curve, const PolylineRule &rule, std::span<const double> fixed) {
    const UsualLimit usual(usual_work(curve.point_count()));
    const LimitedSearch limited;
    return Builder(curve, rule).build(fixed);
}

} // namespace nrb::mesh
