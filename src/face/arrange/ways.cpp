// SPDX-License-Identifier: MIT
#include "face/arrange/ways.h"

#include "face/arrange/node_order.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace nrb::face {

namespace {

constexpr size_t none = std::numeric_limits<size_t>::max();

DirectedEdge turned(DirectedEdge edge) noexcept {
    return {edge.edge, !edge.back};
}

// What follows each edge.
class Turns {
public:
    Turns(const Arrangement &arrangement, const std::vector<DirectedEdge> &edges)
        : arrangement_(arrangement), edges_(edges), next_(edges.size(), none) {
        std::vector<std::vector<size_t>> ins(arrangement.nodes().size()), outs(ins.size());
        for (size_t i = 0; i < edges.size(); ++i) {
            ins[arrangement.to(edges[i])].push_back(i);
            outs[arrangement.from(edges[i])].push_back(i);
        }
        for (size_t node = 0; node < ins.size(); ++node) {
            if (ins[node].size() == 1 && outs[node].size() == 1) {
                next_[ins[node].front()] = outs[node].front();
            } else {
                set_next(node, ins[node], outs[node]);
            }
        }
    }

    [[nodiscard]] size_t next(size_t i) const noexcept { return next_[i]; }

private:
    // All that leaves the node, or comes to it seen from there, counterclockwise. From one that comes the part to its left lies
    // clockwise.
    void set_next(size_t node, const std::vector<size_t> &ins, const std::vector<size_t> &outs) {
        if (ins.size() != outs.size()) {
            arrangement_.fail_undecided(arrangement_.nodes()[node]);
        }
        std::map<DirectedEdge, size_t> out_of, in_of;
        std::vector<DirectedEdge> around;
        for (const size_t i : outs) {
            out_of.emplace(edges_[i], i);
            around.push_back(edges_[i]);
        }
        for (const size_t i : ins) {
            const DirectedEdge seen = turned(edges_[i]);
            in_of.emplace(seen, i);
            if (!out_of.contains(seen)) {
                around.push_back(seen);
            }
        }
        if (!around.empty()) {
            sort_around_node(arrangement_, around);
        }
        for (size_t i = 0; i < around.size(); ++i) {
            if (const auto in = in_of.find(around[i]); in != in_of.end()) {
                const auto out = out_of.find(around[(i + around.size() - 1) % around.size()]);
                if (out == out_of.end()) {
                    arrangement_.fail_undecided(arrangement_.nodes()[node]);
                }
                next_[in->second] = out->second;
            }
        }
    }

    const Arrangement &arrangement_;
    const std::vector<DirectedEdge> &edges_;
    std::vector<size_t> next_;
};

// A part of a curve that edges one after the other run over.
struct Run {
    size_t first, last; // of the cuts, as the loop runs
    bool back;
};

class Runs {
public:
    explicit Runs(const Arrangement &arrangement) : arrangement_(arrangement) {}

    [[nodiscard]] std::vector<Run> of(const EdgeLoop &loop) const {
        std::vector<Run> runs;
        for (const DirectedEdge edge : loop) {
            if (runs.empty() || !extend(runs.back(), edge)) {
                const auto &first = arrangement_.edges()[edge.edge].members.front();
                runs.push_back({first.cut, first.cut, edge.back});
            }
        }
        if (runs.size() > 1 && follows(runs.back().last, runs.front().first, runs.front().back) &&
            runs.back().back == runs.front().back) {
            runs.front().first = runs.back().first;
            runs.pop_back();
        }
        return runs;
    }

private:
    [[nodiscard]] bool follows(size_t cut, size_t next, bool back) const {
        const auto &cuts = arrangement_.cuts().edges();
        return (back ? next + 1 == cut : next == cut + 1) && cuts[cut].curve == cuts[next].curve;
    }
    bool extend(Run &run, DirectedEdge edge) const {
        for (const Arrangement::Member &member : arrangement_.edges()[edge.edge].members) {
            const bool back = member.against != edge.back;
            if (back == run.back && follows(run.last, member.cut, back)) {
                run.last = member.cut;
                return true;
            }
        }
        return false;
    }

    const Arrangement &arrangement_;
};

// With another end of a clamped curve.
SplinePtr with_end(const SplinePtr &curve, bool upper, const Point2 &end) {
    std::vector<double> points(curve->points().begin(), curve->points().end());
    std::vector<double> weights(curve->weights().begin(), curve->weights().end());
    const auto width = static_cast<size_t>(curve->stored_width());
    const size_t at = upper ? points.size() - width : 0;
    const double weight = curve->form() == Form::homogeneous ? points[at + width - 1] : 1;
    for (size_t k = 0; k < 2; ++k) {
        points[at + k] = end[k] * weight;
    }
    return make_result(curve->knot_vectors(), curve->dim(), curve->form(), std::move(points),
                       std::move(weights));
}

class RunCurve {
public:
    explicit RunCurve(const Arrangement &arrangement) : arrangement_(arrangement) {}

    [[nodiscard]] SplinePtr of(const Run &run) const {
        const CutEdge &lower = arrangement_.cuts().edges()[run.back ? run.last : run.first],
                      &upper = arrangement_.cuts().edges()[run.back ? run.first : run.last];
        const SplinePtr &whole = arrangement_.curve(lower).curve;
        const Interval domain = whole->axis(0).domain();
        const bool from_start = lower.range.lower == domain.lower, to_end = upper.range.upper == domain.upper;
        SplinePtr part = whole;
        if (!from_start || !to_end) {
            part = refine::cut_axis(whole, 0, lower.range.lower, upper.range.upper, {true, true});
            part = from_start ? part : snapped(part, false, arrangement_.nodes()[lower.from]);
            part = to_end ? part : snapped(part, true, arrangement_.nodes()[upper.to]);
        }
        return run.back ? refine::reverse(*part, 0, false) : part;
    }

private:
    [[nodiscard]] SplinePtr snapped(const SplinePtr &part, bool upper, const Point2 &node) const {
        constexpr double rounding = 0x1p-44;
        const int64_t last = upper ? part->point_count() - 1 : 0;
        const Point2 end{part->coordinate(last, 0), part->coordinate(last, 1)};
        const bool is_near = arrangement_.hits().distance(end, node) <= rounding;
        return is_near && end != node ? with_end(part, upper, node) : part;
    }

    const Arrangement &arrangement_;
};

} // namespace

std::vector<EdgeLoop> ways_around(const Arrangement &arrangement, const std::vector<DirectedEdge> &edges) {
    const Turns turns(arrangement, edges);
    std::vector<bool> taken(edges.size(), false);
    std::vector<EdgeLoop> loops;
    for (size_t first = 0; first < edges.size(); ++first) {
        if (!taken[first]) {
            loops.emplace_back();
            for (size_t i = first; !taken[i]; i = turns.next(i)) {
                taken[i] = true;
                loops.back().push_back(edges[i]);
            }
        }
    }
    return loops;
}

std::vector<EdgeLoop> simple_loops(const Arrangement &arrangement, const EdgeLoop &loop) {
    std::vector<EdgeLoop> result;
    EdgeLoop way;
    std::map<size_t, size_t> places; // on the way, of nodes
    for (const DirectedEdge edge : loop) {
        places.emplace(arrangement.from(edge), way.size());
        way.push_back(edge);
        const auto again = places.find(arrangement.to(edge));
        if (again == places.end()) {
            continue;
        }
        const auto first = way.begin() + static_cast<std::ptrdiff_t>(again->second);
        result.emplace_back(first, way.end());
        std::for_each(first, way.end(), [&](DirectedEdge own) { places.erase(arrangement.from(own)); });
        way.erase(first, way.end());
    }
    return result;
}

Loop loop_of(const Arrangement &arrangement, const EdgeLoop &loop) {
    const RunCurve curves(arrangement);
    Loop result;
    for (const Run &run : Runs(arrangement).of(loop)) {
        result.push_back({curves.of(run), nullptr});
    }
    return result;
}

} // namespace nrb::face
