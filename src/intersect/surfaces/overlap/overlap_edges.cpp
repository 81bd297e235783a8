// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_edges.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/overlap/overlap_trace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr double least_cosine = 0.99; // between the normals of surfaces that overlap

// The part of a run between two nodes next to each other on it, or all of a closed run.
struct Part {
    size_t run = 0;
    std::array<CrossPlace, 2> ends{};
    std::array<size_t, 2> nodes{};
    bool closed = false;
};

std::array<Interval, 4> hull_of(const CrossPlace &a, const CrossPlace &b) noexcept {
    std::array<Interval, 4> hull;
    for (size_t i = 0; i < 4; ++i) {
        hull[i] = {std::min(a[i], b[i]), std::max(a[i], b[i])};
    }
    return hull;
}

class EdgeMaker {
public:
    EdgeMaker(const OverlapGround &ground, const ContactTracer &tracer, const OverlapBorders &borders,
              double near)
        : ground_(ground), tracer_(ground, tracer, near), borders_(borders), follower_(ground), near_(near) {}

    std::optional<OverlapEdges> run() {
        for (const OverlapRun &run : borders_.runs) {
            for (const CrossPlace &end : run.ends) {
                if (!run.closed) {
                    add_node(end);
                }
            }
        }
        for (size_t i = 0; i < borders_.runs.size(); ++i) {
            divide(i);
        }
        for (const CrossPlace &single : borders_.single) {
            if (!is_node(single)) {
                result_.loose.push_back(hull_of(single, single));
            }
        }
        if (!keep_edges()) {
            return std::nullopt;
        }
        prune();
        for (size_t i = 0; i < kept_.size(); ++i) {
            if (work_ended() || !set_segments(kept_[i], result_.edges[i])) {
                return std::nullopt;
            }
        }
        return std::move(result_);
    }

private:
    struct Kept {
        Part part;
        bool forward;
        const OverlapSide *along; // the side of the other surface along which it runs; null: it runs inside
    };

    [[nodiscard]] const OverlapSide &side_of(const Part &part) const noexcept {
        return borders_.sides[borders_.runs[part.run].side];
    }

    size_t add_node(const CrossPlace &at) {
        for (size_t i = 0; i < result_.nodes.size(); ++i) {
            if (ground_.apart(result_.nodes[i], at) <= near_) {
                return i;
            }
        }
        CrossPlace node = at;
        for (size_t i = 0; i < 4; ++i) {
            const Interval domain = ground_.domain(i / 2, i % 2);
            if (ground_.borders(i / 2).wraps(i % 2)) {
                const double period = ground_.borders(i / 2).period(i % 2);
                node[i] -= period * std::floor((node[i] - domain.lower) / period);
            }
            node[i] = std::clamp(node[i], domain.lower, domain.upper);
        }
        result_.nodes.push_back(node);
        return result_.nodes.size() - 1;
    }
    [[nodiscard]] bool is_node(const CrossPlace &at) const {
        return std::ranges::any_of(
            result_.nodes, [&](const CrossPlace &node) { return ground_.apart(node, at) <= 4 * near_; });
    }
    // The coordinates of a node, in the periods in which it is next to a place.
    [[nodiscard]] CrossPlace at_node(size_t node, const CrossPlace &beside) const {
        CrossPlace at = result_.nodes[node];
        for (size_t i = 0; i < 4; ++i) {
            if (ground_.borders(i / 2).wraps(i % 2)) {
                const double period = ground_.borders(i / 2).period(i % 2),
                             turns = std::round((beside[i] - at[i]) / period);
                at[i] += turns == 0 ? 0 : turns * period;
            }
        }
        return at;
    }

    // Divides a run at the nodes that are on it.
    void divide(size_t index) {
        const OverlapRun &run = borders_.runs[index];
        const OverlapSide &side = borders_.sides[run.side];
        const size_t free = side.free();
        std::vector<std::pair<double, CrossPlace>> cuts;
        std::vector<size_t> nodes;
        for (size_t node = 0; node < result_.nodes.size(); ++node) {
            for (const double shift : {0.0, side.period, -side.period}) {
                const double t = result_.nodes[node][free] + shift;
                const auto at = is_on(side, run, node, t);
                if (at) {
                    cuts.emplace_back(t, *at);
                    nodes.push_back(node);
                }
                if (!side.closes) {
                    break;
                }
            }
        }
        if (run.closed && cuts.empty()) {
            parts_.push_back({index, {run.places.front(), run.places.back()}, {}, true});
            return;
        }
        std::vector<size_t> order(cuts.size());
        for (size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::ranges::sort(order, {}, [&](size_t i) { return cuts[i].first; });
        if (run.closed) {
            go_round(side, run, cuts, nodes, order);
        }
        for (size_t i = 0; i + 1 < order.size(); ++i) {
            const size_t from = order[i], to = order[i + 1];
            parts_.push_back({index,
                              {at_node(nodes[from], cuts[from].second), at_node(nodes[to], cuts[to].second)},
                              {nodes[from], nodes[to]},
                              false});
        }
    }
    // Adds the first node of a closed run once more, at its end.
    void go_round(const OverlapSide &side, const OverlapRun &run,
                  std::vector<std::pair<double, CrossPlace>> &cuts, std::vector<size_t> &nodes,
                  std::vector<size_t> &order) {
        const size_t first = order.front();
        const double t = cuts[first].first + side.period;
        if (nodes[order.back()] == nodes[first] && order.size() > 1) {
            return; // that node is where the side closes: it is on the run at both of its ends
        }
        if (const std::optional<CrossPlace> at = follower_.at(side, run, t)) {
            order.push_back(cuts.size());
            nodes.push_back(nodes[first]);
            cuts.emplace_back(t, *at);
        } else {
            open_ = true;
        }
    }
    // The place of a run with the free parameter t, if the node is there.
    [[nodiscard]] std::optional<CrossPlace> is_on(const OverlapSide &side, const OverlapRun &run, size_t node,
                                                  double t) const {
        const double first = run.ends[0][side.free()], last = run.ends[1][side.free()],
                     room = 0x1p-20 * (last - first);
        if (!(t >= first - room && t <= last + room)) {
            return std::nullopt;
        }
        const std::optional<CrossPlace> at = follower_.at(side, run, std::clamp(t, first, last));
        return at && ground_.apart(result_.nodes[node], *at) <= 2 * near_ ? at : std::nullopt;
    }

    // How a side would bound a region.
    struct Sense {
        bool forward;          // whether the region is on its left in the domain of the first surface
        Vector3 inside;        // from the side into its own surface
        Vector3 along, normal; // along the side; of the first surface
    };
    // None: the surfaces are not tangent there, or a derivative is not known.
    [[nodiscard]] std::optional<Sense> sense_at(const OverlapSide &side, const CrossPlace &at) const {
        const std::array<std::optional<OverlapGround::Point>, 2> points{ground_.point(0, at.data()),
                                                                        ground_.point(1, at.data() + 2)};
        if (!points[0] || !points[1]) {
            return std::nullopt;
        }
        const Vector3 of_a = cross(points[0]->slope[0], points[0]->slope[1]),
                      of_b = cross(points[1]->slope[0], points[1]->slope[1]);
        const double product = dot(of_a, of_b), size = length(of_a) * length(of_b);
        if (!(std::abs(product) >= least_cosine * size && size > 0)) {
            return std::nullopt;
        }
        const bool left = side.surface == 0 || product > 0 ? side.is_left() : !side.is_left();
        const Vector3 &across = points[side.surface]->slope[side.axis];
        return Sense{left, side.end == 0 ? across : -1 * across, points[side.surface]->slope[1 - side.axis],
                     of_a};
    }

    // False: sides of both surfaces run along each other, but their parts do not end in the same nodes.
    bool keep_edges() {
        if (open_) {
            return false;
        }
        std::vector<bool> told(parts_.size(), false);
        for (size_t i = 0; i < parts_.size(); ++i) {
            if (!told[i] && !keep_edge(i, told)) {
                return false;
            }
        }
        return true;
    }
    bool keep_edge(size_t i, std::vector<bool> &told) {
        const Part &part = parts_[i];
        const OverlapSide &side = side_of(part);
        const double middle = part.ends[0][side.free()] / 2 + part.ends[1][side.free()] / 2;
        const auto at = follower_.at(side, borders_.runs[part.run], middle);
        const auto sense = at ? sense_at(side, *at) : std::nullopt;
        bool keeps = sense.has_value();
        const OverlapSide *along = nullptr;
        for (size_t j = i + 1; keeps && j < parts_.size(); ++j) {
            if (told[j] || side_of(parts_[j]).surface == side.surface || !runs_along(*at, parts_[j])) {
                continue;
            }
            if (!has_same_ends(part, parts_[j])) {
                return false;
            }
            told[j] = true;
            along = &side_of(parts_[j]);
            const auto other = sense_at(*along, *at);
            keeps = other && is_inside_same(*sense, *other);
        }
        keeps ? keep(part, *at, sense->forward, along) : leave(part);
        return true;
    }
    void keep(const Part &part, const CrossPlace &middle, bool forward, const OverlapSide *along) {
        OverlapEdge edge{part.nodes, part.closed, middle, {}};
        if (!forward) {
            std::swap(edge.nodes[0], edge.nodes[1]);
        }
        result_.edges.push_back(std::move(edge));
        kept_.push_back({part, forward, along});
    }
    void leave(const Part &part) {
        const std::vector<CrossPlace> &places = borders_.runs[part.run].places;
        for (size_t i = 0; i + 1 < places.size(); ++i) {
            result_.loose.push_back(hull_of(places[i], places[i + 1]));
        }
    }
    // Whether a place of a border is on this part of a border of the other surface.
    [[nodiscard]] bool runs_along(const CrossPlace &at, const Part &part) const {
        const OverlapSide &side = side_of(part);
        const auto point = ground_.point(side.surface, &at[2 * side.surface]);
        if (!point || std::abs(at[side.fixed()] - side.at) * length(point->slope[side.axis]) > 2 * near_) {
            return false;
        }
        const double first = part.ends[0][side.free()], last = part.ends[1][side.free()];
        for (const double shift : {0.0, side.period, -side.period}) {
            const double t = at[side.free()] + shift;
            if (t > first && t < last) {
                return true;
            }
            if (!side.closes) {
                break;
            }
        }
        return false;
    }
    static bool has_same_ends(const Part &a, const Part &b) noexcept {
        return a.closed == b.closed &&
               (a.closed || a.nodes == b.nodes || (a.nodes[0] == b.nodes[1] && a.nodes[1] == b.nodes[0]));
    }
    static bool is_inside_same(const Sense &a, const Sense &b) noexcept {
        const Vector3 left = cross(a.normal, a.along);
        return (dot(left, a.inside) > 0) == (dot(left, b.inside) > 0);
    }

    // Removes edges that begin where no edge ends, or end where none begins, as long as there are any: they
    // bound nothing.
    void prune() {
        for (bool any = true; any;) {
            any = false;
            std::vector<std::array<int, 2>> counts(result_.nodes.size());
            for (const OverlapEdge &edge : result_.edges) {
                if (!edge.closed) {
                    ++counts[edge.nodes[0]][0];
                    ++counts[edge.nodes[1]][1];
                }
            }
            for (size_t i = 0; i < result_.edges.size() && !any; ++i) {
                const OverlapEdge &edge = result_.edges[i];
                if (!edge.closed && (counts[edge.nodes[0]][1] == 0 || counts[edge.nodes[1]][0] == 0)) {
                    leave(kept_[i].part);
                    result_.edges.erase(result_.edges.begin() + static_cast<std::ptrdiff_t>(i));
                    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
                    any = true;
                }
            }
        }
    }

    bool set_segments(const Kept &kept, OverlapEdge &edge) const {
        auto segments = tracer_.trace(side_of(kept.part), kept.along, kept.part.ends[0], kept.part.ends[1]);
        if (!segments) {
            return false;
        }
        edge.segments = std::move(*segments);
        if (!kept.forward) {
            reverse(edge.segments);
        }
        return true;
    }

    const OverlapGround &ground_;
    OverlapTracer tracer_;
    const OverlapBorders &borders_;
    OverlapFollower follower_;
    double near_;
    bool open_ = false; // whether a run could not be divided
    std::vector<Part> parts_;
    std::vector<Kept> kept_; // in the order of the edges
    OverlapEdges result_;
};

} // namespace

std::optional<OverlapEdges> overlap_edges(const OverlapGround &ground, const ContactTracer &tracer,
                                          const OverlapBorders &borders, double near) {
    return EdgeMaker(ground, tracer, borders, near).run();
}

} // namespace nrb::intersect
