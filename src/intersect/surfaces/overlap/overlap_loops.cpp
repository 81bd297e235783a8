// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_loops.h"

#include "base/numbers.h"
#include "intersect/surfaces/curves/cubic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::intersect {

namespace {

using Place2 = std::array<double, 2>;
using Polygon = std::vector<Place2>;

constexpr size_t none = static_cast<size_t>(-1);
constexpr double least_angle = 1e-6; // between edges at a node in which several loops meet
constexpr size_t parts_of_segments = 8;

double area_of(const Polygon &polygon) noexcept {
    double area = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Place2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        area += ((a[0] - polygon[0][0]) * (b[1] - polygon[0][1]) -
                 (b[0] - polygon[0][0]) * (a[1] - polygon[0][1])) /
                2;
    }
    return area;
}

// The crossings of a polygon with the ray from a place along the second axis (up), or along the first: 1 for
// each that has the place on its left, -1 for each that has it on its right. closes: whether the last vertex
// is joined to the first; the polygon of a loop around an axis that closes is open instead, and has a vertex
// at both ends.
int crossings_of(const Polygon &polygon, const Place2 &at, bool up, bool closes) noexcept {
    const size_t x = up ? 1 : 0, y = 1 - x;
    int turns = 0;
    for (size_t i = 0; i + (closes ? 0 : 1) < polygon.size(); ++i) {
        const Place2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double side = (b[x] - a[x]) * (at[y] - a[y]) - (at[x] - a[x]) * (b[y] - a[y]);
        if (a[y] <= at[y] && b[y] > at[y] && side > 0) {
            ++turns;
        } else if (a[y] > at[y] && b[y] <= at[y] && side < 0) {
            --turns;
        }
    }
    return up ? -turns : turns;
}

// The crossings of a polygon with rays as of crossings_of(), from a place and its copies in other periods.
int crossings_around(const Polygon &polygon, const Place2 &at, const SurfaceBorders &borders) noexcept {
    const bool up = borders.wraps(0) && !borders.wraps(1); // along an axis that does not close, if any
    const Place2 &first = polygon.front(), &last = polygon.back();
    const bool closes = std::abs(last[0] - first[0]) < borders.period(0) / 2 &&
                        std::abs(last[1] - first[1]) < borders.period(1) / 2;
    const std::array<int, 2> most{borders.wraps(0) ? 2 : 0, borders.wraps(1) ? 2 : 0};
    int turns = 0;
    for (int i = -most[0]; i <= most[0]; ++i) {
        for (int j = -most[1]; j <= most[1]; ++j) {
            const Place2 moved{at[0] + i * borders.period(0), at[1] + j * borders.period(1)};
            turns += crossings_of(polygon, moved, up, closes);
        }
    }
    return turns;
}

class LoopFinder {
public:
    LoopFinder(const OverlapGround &ground, const OverlapEdges &edges) : ground_(ground), edges_(edges) {
        for (size_t k = 0; k < 2; ++k) {
            wraps_[k] = ground.borders(0).wraps(k);
            periods_[k] = ground.borders(0).period(k);
        }
    }

    std::optional<OverlapRegions> run() {
        if (!link()) {
            return std::nullopt;
        }
        find_loops();
        if (loops_.empty()) {
            return OverlapRegions{{OverlapRegion{}}, true}; // the whole surface
        }
        return make_regions() ? std::optional(OverlapRegions{std::move(regions_), far_inside_})
                              : std::nullopt;
    }

private:
    struct Loop {
        OverlapLoop edges;
        Polygon polygon;
        std::array<int, 2> turns{}; // how often it goes around each axis that closes
        double area = 0;
    };

    // Finds the edge that follows each edge; false: at some node this is left open.
    bool link() {
        const size_t n = edges_.edges.size();
        next_.assign(n, none);
        for (size_t i = 0; i < n; ++i) {
            if (edges_.edges[i].closed) {
                next_[i] = i;
            }
        }
        for (size_t node = 0; node < edges_.nodes.size(); ++node) {
            std::vector<size_t> in, out;
            for (size_t i = 0; i < n; ++i) {
                const OverlapEdge &edge = edges_.edges[i];
                if (!edge.closed && edge.nodes[1] == node) {
                    in.push_back(i);
                }
                if (!edge.closed && edge.nodes[0] == node) {
                    out.push_back(i);
                }
            }
            if (in.size() != out.size() || !link(in, out)) {
                return false;
            }
        }
        return std::ranges::find(next_, none) == next_.end();
    }
    // At a node, the region lies between an edge that leaves and the next one, anticlockwise, that arrives.
    // So an edge that arrives is followed by the one that leaves next to it, clockwise.
    bool link(const std::vector<size_t> &in, std::vector<size_t> out) {
        for (const size_t from : in) {
            const double back = angle_at(from, true);
            size_t best = none;
            double least = infinity;
            for (const size_t to : out) {
                double between = back - angle_at(to, false);
                between -= 2 * std::numbers::pi * std::floor(between / (2 * std::numbers::pi));
                if (in.size() > 1 &&
                    (between < least_angle || between > 2 * std::numbers::pi - least_angle)) {
                    return false;
                }
                if (between < least) {
                    least = between;
                    best = to;
                }
            }
            std::erase(out, best);
            next_[from] = best;
        }
        return true;
    }
    // The direction in which an edge leaves its first node, or that in which it is seen from its last one
    // (end).
    [[nodiscard]] double angle_at(size_t edge, bool end) const noexcept {
        const std::vector<CrossSegment> &segments = edges_.edges[edge].segments;
        const std::array<Place2, 4> &cubic = (end ? segments.back() : segments.front()).on[0];
        const Place2 &from = end ? cubic[3] : cubic[0];
        double x = 0, y = 0;
        for (int i = 1; i <= 3 && x == 0 && y == 0; ++i) {
            const Place2 &to = cubic[static_cast<size_t>(end ? 3 - i : i)];
            x = (to[0] - from[0]) / periods_[0];
            y = (to[1] - from[1]) / periods_[1];
        }
        return std::atan2(y, x);
    }

    void find_loops() {
        std::vector<bool> taken(next_.size(), false);
        for (size_t i = 0; i < next_.size(); ++i) {
            Loop loop;
            for (size_t at = i; !taken[at]; at = next_[at]) {
                taken[at] = true;
                loop.edges.push_back(at);
                add(edges_.edges[at], loop.polygon);
            }
            if (!loop.edges.empty()) {
                finish(loop);
                loops_.push_back(std::move(loop));
            }
        }
    }
    // A place moved by whole periods next to the last one, where the surface closes.
    [[nodiscard]] Place2 beside(const Place2 &at, const Place2 &last) const noexcept {
        Place2 moved = at;
        for (size_t k = 0; k < 2; ++k) {
            moved[k] += wraps_[k] ? periods_[k] * std::round((last[k] - at[k]) / periods_[k]) : 0;
        }
        return moved;
    }
    void add(const OverlapEdge &edge, Polygon &polygon) const {
        for (const CrossSegment &segment : edge.segments) {
            for (size_t i = 0; i < parts_of_segments; ++i) {
                const double t = static_cast<double>(i) / parts_of_segments;
                const Cubic cubic(segment.on[0]);
                const Place2 at{cubic.coordinate(0, t), cubic.coordinate(1, t)};
                polygon.push_back(polygon.empty() ? at : beside(at, polygon.back()));
            }
        }
    }
    void finish(Loop &loop) const {
        const Place2 end =
            beside(edges_.edges[loop.edges.back()].segments.back().on[0][3], loop.polygon.back());
        for (size_t k = 0; k < 2; ++k) {
            loop.turns[k] =
                wraps_[k] ? static_cast<int>(std::lround((end[k] - loop.polygon.front()[k]) / periods_[k]))
                          : 0;
        }
        if (loop.turns != std::array<int, 2>{}) {
            loop.polygon.push_back(end);
        }
        loop.area = area_of(loop.polygon);
    }

    static void add_to(OverlapRegion &region, const Loop &loop) {
        region.loops.push_back(loop.edges);
        region.polygons.push_back(loop.polygon);
    }

    bool make_regions() {
        std::vector<const Loop *> around, outer, holes;
        for (const Loop &loop : loops_) {
            const bool goes_round = loop.turns != std::array<int, 2>{};
            (goes_round ? around : loop.area > 0 ? outer : holes).push_back(&loop);
        }
        if (!add_strips(around)) {
            return false;
        }
        const size_t strips = regions_.size();
        for (const Loop *loop : outer) {
            add_to(regions_.emplace_back(), *loop);
        }
        size_t rest = none; // the region that is all of a surface without borders, except for holes
        for (const Loop *loop : holes) {
            const size_t in = region_around(*loop, outer, strips);
            if (in != none) {
                add_to(regions_[in], *loop);
                continue;
            }
            if (!(wraps_[0] || wraps_[1]) || strips > 0) {
                return false;
            }
            if (rest == none) {
                rest = regions_.size();
                regions_.emplace_back();
                far_inside_ = true;
            }
            add_to(regions_[rest], *loop);
        }
        return true;
    }
    // The smallest region that contains a hole. A hole is in the strip between the loops below it and those
    // above it.
    [[nodiscard]] size_t region_around(const Loop &hole, const std::vector<const Loop *> &outer,
                                       size_t strips) const {
        size_t best = none;
        double least = infinity;
        for (size_t i = 0; i < outer.size(); ++i) {
            if (outer[i]->area < least && is_in(place_on(hole), outer[i]->polygon)) {
                least = outer[i]->area;
                best = strips + i;
            }
        }
        const auto strip = std::ranges::find(strips_, loops_below(hole));
        return best == none && strip != strips_.end() ? static_cast<size_t>(strip - strips_.begin()) : best;
    }
    // In the middle of a segment, because loops may meet at nodes.
    [[nodiscard]] static const Place2 &place_on(const Loop &loop) noexcept {
        return loop.polygon[parts_of_segments / 2];
    }
    // Loops that go around undulate, but do not cross each other: one is below all of another loop if it is
    // below one place of it.
    [[nodiscard]] size_t loops_below(const Loop &loop) const noexcept {
        return static_cast<size_t>(std::ranges::count_if(loops_, [&](const Loop &other) {
            const bool goes_round = other.turns != std::array<int, 2>{};
            return &other != &loop && goes_round &&
                   crossings_around(other.polygon, place_on(loop), ground_.borders(0)) == 0;
        }));
    }
    [[nodiscard]] bool is_in(const Place2 &at, const Polygon &polygon) const noexcept {
        for (const int i : {0, 1, -1}) {
            for (const int j : {0, 1, -1}) {
                if ((i == 0 || wraps_[0]) && (j == 0 || wraps_[1]) &&
                    winding_of(polygon, {at[0] + i * periods_[0], at[1] + j * periods_[1]}) != 0) {
                    return true;
                }
            }
        }
        return false;
    }
    // Adds regions of a surface that closes along one axis which are strips around it: from a loop that goes
    // around once to the next one, or to a pole. False: it is left open what the loops bound.
    bool add_strips(std::vector<const Loop *> around) {
        if (around.empty()) {
            return true;
        }
        if (wraps_[0] == wraps_[1]) {
            return false;
        }
        const size_t along = wraps_[0] ? 0 : 1;
        std::ranges::sort(around, {}, [&](const Loop *loop) { return loops_below(*loop); });
        bool is_open = false;
        for (size_t i = 0; i < around.size(); ++i) {
            const Loop &loop = *around[i];
            if (std::abs(loop.turns[along]) != 1) {
                return false;
            }
            const bool above = (loop.turns[along] > 0) == (along == 0);
            if (above == is_open && (is_open || i > 0)) {
                return false;
            }
            if (above || i == 0) {
                regions_.emplace_back();
                strips_.push_back(above ? i + 1 : 0);
            }
            add_to(regions_.back(), loop);
            is_open = above;
        }
        far_inside_ = is_open;
        return true;
    }

    const OverlapGround &ground_;
    const OverlapEdges &edges_;
    std::array<bool, 2> wraps_{};
    std::array<double, 2> periods_{};
    std::vector<size_t> next_;
    std::vector<Loop> loops_;
    std::vector<OverlapRegion> regions_; // strips first
    std::vector<size_t> strips_;         // the numbers of loops below them
    bool far_inside_ = false;
};

} // namespace

int winding_of(const std::vector<std::array<double, 2>> &polygon, const std::array<double, 2> &at) noexcept {
    return crossings_of(polygon, at, false, true);
}

bool OverlapRegions::hold(const OverlapGround &ground, const std::array<double, 2> &at) const noexcept {
    int turns = far_inside ? 1 : 0;
    for (const OverlapRegion &region : list) {
        for (const Polygon &polygon : region.polygons) {
            turns += crossings_around(polygon, at, ground.borders(0));
        }
    }
    return turns > 0;
}

std::optional<OverlapRegions> overlap_regions(const OverlapGround &ground, const OverlapEdges &edges) {
    return LoopFinder(ground, edges).run();
}

} // namespace nrb::intersect
