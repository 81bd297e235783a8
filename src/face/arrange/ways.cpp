// SPDX-License-Identifier: MIT
#include "face/arrange/ways.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "face/arrange/node_order.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

namespace nrb::face {

namespace {

constexpr size_t none = std::numeric_limits<size_t>::max();

// A node lifted to the covering plane: in one copy of the domain.
struct Lift {
    size_t node;
    std::array<int, 2> turns;
    friend auto operator<=>(const Lift &, const Lift &) = default;
};

DirectedEdge turned(DirectedEdge edge) noexcept {
    return {edge.edge, !edge.back};
}

// The half-edge that follows each half-edge.
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
    // Sorts, counterclockwise, the half-edges that leave the node and the reverses of those that come to it.
    // The part to the left of one that comes lies clockwise from its reverse, so that it continues with the
    // entry before its own.
    void set_next(size_t node, const std::vector<size_t> &ins, const std::vector<size_t> &outs) {
        if (ins.size() != outs.size()) {
            fail_undecided(arrangement_.nodes()[node]);
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
                    fail_undecided(arrangement_.nodes()[node]);
                }
                next_[in->second] = out->second;
            }
        }
    }

    const Arrangement &arrangement_;
    const std::vector<DirectedEdge> &edges_;
    std::vector<size_t> next_;
};

class Runs {
public:
    Runs(const Arrangement &arrangement, RunRule rule, const std::vector<bool> &ends)
        : arrangement_(arrangement), rule_(rule), ends_(ends) {}

    [[nodiscard]] std::vector<Run> of(const EdgeLoop &loop) const {
        std::vector<Run> runs;
        bool behind_point = false;
        for (const DirectedEdge edge : loop) {
            if (arrangement_.edges()[edge.edge].in_a_point) {
                behind_point = true;
                continue;
            }
            const bool goes_on = !std::exchange(behind_point, false) && !runs.empty() && !ends_at(edge);
            if (!goes_on || !extend(runs.back(), edge)) {
                const size_t cut = arrangement_.edges()[edge.edge].members.front().cut;
                runs.push_back({cut, cut, edge.back});
            }
        }
        if (runs.size() < 2 || behind_point || arrangement_.edges()[loop.front().edge].in_a_point) {
            return runs;
        }
        const Run &last = runs.back(), &first = runs.front();
        if (!ends_at(loop.front()) && last.back == first.back &&
            follows(last.last, first.first, first.back)) {
            runs.front().first = last.first;
            runs.pop_back();
        }
        return runs;
    }

private:
    [[nodiscard]] bool ends_at(DirectedEdge edge) const {
        return rule_ == RunRule::shared && ends_[arrangement_.from(edge)];
    }
    [[nodiscard]] bool follows(size_t cut, size_t next, bool back) const {
        const auto &cuts = arrangement_.cuts().edges();
        return (back ? next + 1 == cut : next == cut + 1) &&
               arrangement_.origin(cuts[cut]) == arrangement_.origin(cuts[next]);
    }
    bool extend(Run &run, DirectedEdge edge) const {
        const auto &members = arrangement_.edges()[edge.edge].members;
        for (const Arrangement::Member &member :
             std::span(members).first(rule_ == RunRule::shared ? 1 : members.size())) {
            const bool back = member.against != edge.back;
            if (back == run.back && follows(run.last, member.cut, back)) {
                run.last = member.cut;
                return true;
            }
        }
        return false;
    }

    const Arrangement &arrangement_;
    RunRule rule_;
    const std::vector<bool> &ends_;
};

// The edges of the cuts at the lower and upper end of a run.
struct RunCuts {
    const CutEdge &lower, &upper;

    RunCuts(const Arrangement &arrangement, const Run &run)
        : lower(arrangement.cuts().edges()[run.back ? run.last : run.first]),
          upper(arrangement.cuts().edges()[run.back ? run.first : run.last]) {}
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
    std::vector<Lift> lifts; // where the edges of the way begin
    std::map<Lift, size_t> places;
    Lift at{arrangement.from(loop.front()), {0, 0}};
    for (const DirectedEdge edge : loop) {
        places.emplace(at, way.size());
        way.push_back(edge);
        lifts.push_back(at);
        at = {arrangement.to(edge), turned_by(arrangement, at.turns, edge)};
        const auto again = places.find(at);
        if (again == places.end()) {
            continue;
        }
        const size_t first = again->second;
        result.emplace_back(way.begin() + static_cast<std::ptrdiff_t>(first), way.end());
        for (size_t i = first; i < lifts.size(); ++i) {
            places.erase(lifts[i]);
        }
        way.resize(first);
        lifts.resize(first);
    }
    if (!way.empty()) { // it goes around a closed axis
        result.push_back(std::move(way));
    }
    return result;
}

std::array<int, 2> turned_by(const Arrangement &arrangement, std::array<int, 2> turns,
                             DirectedEdge edge) noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const int own = arrangement.edges()[edge.edge].turns[k];
        turns[k] += edge.back ? -own : own;
    }
    return turns;
}

std::vector<Run> runs_of(const Arrangement &arrangement, const EdgeLoop &loop, RunRule rule,
                         const std::vector<bool> &ends) {
    return Runs(arrangement, rule, ends).of(loop);
}

bool is_whole(const Arrangement &arrangement, const Run &run) {
    const RunCuts cuts(arrangement, run);
    const Interval domain = arrangement.curve(cuts.lower).curve->axis(0).domain();
    return cuts.lower.range.lower == domain.lower && cuts.upper.range.upper == domain.upper;
}

SplinePtr curve_of(const Arrangement &arrangement, const Run &run) {
    const RunCuts cuts(arrangement, run);
    const SplinePtr &whole = arrangement.curve(cuts.lower).curve;
    const Interval domain = whole->axis(0).domain();
    SplinePtr part = whole;
    if (!is_whole(arrangement, run)) {
        const Interval range{cuts.lower.range.lower, cuts.upper.range.upper};
        part = refine::cut_axis(whole, 0, range.lower, range.upper, {true, true});
        const auto ended = [&](bool upper, size_t node) {
            Point2 end;
            eval::end_point(*part, upper, end.data());
            const Point2 at = arrangement.node_near(node, end);
            return arrangement.is_rounding(at, end) ? with_end(part, upper, at, infinity) : part;
        };
        part = range.lower == domain.lower ? part : ended(false, cuts.lower.from);
        part = range.upper == domain.upper ? part : ended(true, cuts.upper.to);
    }
    return run.back ? refine::reverse(*part, 0, false) : part;
}

SplinePtr with_end(const SplinePtr &curve, bool upper, std::span<const double> end, double within) {
    const auto width = static_cast<size_t>(curve->stored_width());
    const int64_t last = upper ? curve->point_count() - 1 : 0;
    const double weight = curve->form() == Form::homogeneous ? curve->weight(last) : 1;
    std::vector<double> points(curve->points().begin(), curve->points().end());
    double farthest = 0;
    for (size_t k = 0; k < end.size(); ++k) {
        farthest = std::max(farthest, std::abs(curve->coordinate(last, static_cast<int>(k)) - end[k]));
        points[static_cast<size_t>(last) * width + k] = end[k] * weight;
    }
    if (farthest == 0 || farthest > within) {
        return curve;
    }
    std::vector<double> weights(curve->weights().begin(), curve->weights().end());
    return make_result(curve->knot_vectors(), curve->dim(), curve->form(), std::move(points),
                       std::move(weights));
}

} // namespace nrb::face
