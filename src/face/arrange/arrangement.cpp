// SPDX-License-Identifier: MIT
#include "face/arrange/arrangement.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "face/arrange/returns.h"
#include "intersect/pairs/periods.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

constexpr double rounding_share = 0x1p-44; // of the reach of an axis

// The distance that counts as none, in units of about a period: the share that the tolerance has of the
// extent of the surface, but no less than a bound on the rounding of solvers and of stored places, which is
// that of the largest parameters.
double near_of(const Covering &covering, double tolerance) {
    constexpr double rounding = 0x1p-38;
    constexpr double largest = 0x1p480; // products of two parameters are representable
    double share = 1;
    for (const int k : {0, 1}) {
        if (!(covering.period(k) <= largest && covering.period(k) >= 1 / largest)) {
            fail(Status::not_representable, "the domain is %s wide on axis %d, expected 2^-480 to 2^480",
                 Number(covering.period(k)).text, k);
        }
        share = std::max(share, covering.reach(k) / covering.period(k));
    }
    const double given = covering.extent() > 0 ? tolerance / covering.extent() : 0;
    return std::max(rounding * share, given);
}

// The knots at which a curve may have kinks, and the parameters at which it turns back.
std::vector<double> breaks_of(const Spline &curve) {
    std::vector<double> breaks = refine::rough_knots(curve.axis(0), 1);
    const std::vector<double> turns = places_of_return(curve);
    const double room = 0x1p-30 * (breaks.back() - breaks.front());
    for (const double t : turns) {
        const auto above = std::ranges::lower_bound(breaks, t);
        if (above != breaks.begin() && above != breaks.end() && *above - t > room &&
            t - *std::prev(above) > room) {
            breaks.insert(above, t);
        }
    }
    return breaks;
}

} // namespace

void check_border_curves(std::span<const SplinePtr> curves) {
    for (size_t i = 0; i < curves.size(); ++i) {
        const Spline::WeightRange weights = curves[i]->all_weights();
        if (curves[i]->rational() && !(weights.smallest > 0)) {
            fail(Status::weight_sign, "curves[%zu] has the weight %s; its weights must be positive", i,
                 Number(weights.smallest).text);
        }
        if (const std::vector<double> jumps = intersect::jumps_of(*curves[i]); !jumps.empty()) {
            fail(Status::gap, "curves[%zu] jumps at %s", i, Number(jumps.front()).text);
        }
    }
}

Arrangement::Arrangement(const Covering &covering, std::span<const ArrangedLoop> loops, double tolerance)
    : given_(covering), covering_(covering), loops_(loops.begin(), loops.end()),
      near_(near_of(covering, tolerance)), hits_(given_, smooth_parts(), near_), cuts_(given_, hits_, near_) {
    set_edges();
    set_pieces();
}

// On both sides of a kink, or of a place where a curve turns back, the curve comes arbitrarily near itself.
// As one curve it would be searched for self-intersections there; as two curves it has a common end instead.
std::vector<ClosedLoop> Arrangement::smooth_parts() {
    std::vector<ClosedLoop> result;
    for (size_t i = 0; i < loops_.size(); ++i) {
        PlacedLoop &parts = result.emplace_back().placed;
        parts.turn = loops_[i].placed.turn;
        for (size_t j = 0; j < loops_[i].placed.curves.size(); ++j) {
            const PlacedCurve &whole = loops_[i].placed.curves[j];
            const refine::PartedSpline split = refine::split_axis(whole.curve, 0, breaks_of(*whole.curve));
            for (int64_t part = 0; part < split.size(); ++part) {
                smooth_.push_back({split.part(part), whole.shift});
                parts.curves.push_back(smooth_.back());
                origins_.push_back({i, j});
            }
        }
    }
    return result;
}

// The connected components of the graph whose vertices are the edges of the cuts and whose edges are the
// pairs. Each member has its direction relative to the first one.
void Arrangement::set_edges() {
    const auto &all = cuts_.edges();
    std::vector<std::vector<Member>> beside(all.size());
    for (const EdgePair &pair : cuts_.pairs()) {
        beside[pair.a].push_back({pair.b, pair.against});
        beside[pair.b].push_back({pair.a, pair.against});
    }
    std::vector<bool> taken(all.size(), false);
    for (size_t first = 0; first < all.size(); ++first) {
        if (taken[first]) {
            continue;
        }
        Edge edge{all[first].from, all[first].to, {{first, false}}, {}};
        taken[first] = true;
        for (size_t i = 0; i < edge.members.size(); ++i) {
            const Member from = edge.members[i];
            for (const Member &next : beside[from.cut]) {
                if (!taken[next.cut]) {
                    taken[next.cut] = true;
                    edge.members.push_back({next.cut, next.against != from.against});
                }
            }
        }
        add_steps(edge);
        edges_.push_back(std::move(edge));
    }
}

void Arrangement::add_steps(Edge &edge) const {
    PassedSums steps;
    for (const Member &member : edge.members) {
        const ArrangedLoop &loop = loops_[origin(cuts_.edges()[member.cut]).loop];
        if (loop.owner >= 0) {
            steps.push_back({loop.owner, member.against ? -1 : 1});
        }
        edge.in_a_point = edge.in_a_point || loop.in_a_point;
    }
    edge.steps = summed(std::move(steps));
    std::erase_if(edge.steps, [](const PassedSum &step) { return step.value == 0; });
}

Point2 Arrangement::node_near(size_t node, const Point2 &x) const noexcept {
    Point2 copy = given_.nearest_copy(nodes()[node], x);
    for (const int k : {0, 1}) {
        const auto [lower, upper] = given_.domain(k);
        double &own = copy[static_cast<size_t>(k)];
        for (const double end : {lower, upper}) {
            const bool moved_to_end = given_.closed(k) && std::abs(own - end) <= 4 * eps * given_.reach(k);
            own = moved_to_end ? end : own;
        }
    }
    return copy;
}

// The part of a curve that an edge of the cuts stands for, moved to the copy of the domain in which it begins
// at its node. Sets the turns of the edge.
PlacedCurve Arrangement::placed_part(const CutEdge &cut, Edge &edge) const {
    const PlacedCurve &whole = smooth_[cut.curve];
    PlacedCurve part{refine::restrict_axis(whole.curve, 0, cut.range.lower, cut.range.upper), whole.shift};
    if (closes()) {
        Point2 first, last;
        eval::end_point(*part.curve, false, first.data());
        eval::end_point(*part.curve, true, last.data());
        const Point2 copy = given_.nearest_copy(first, nodes()[cut.from]), &end = nodes()[cut.to];
        for (size_t k = 0; k < 2; ++k) {
            const auto axis = static_cast<int>(k);
            part.shift[k] = copy[k] - first[k];
            const double far = last[k] + part.shift[k] - end[k];
            edge.turns[k] = given_.closed(axis) ? static_cast<int>(std::round(far / given_.period(axis))) : 0;
        }
    }
    return part;
}

TrimPieces Arrangement::plane_pieces() {
    TrimPieces plane;
    Steps steps(std::ssize(edges_));
    for (size_t i = 0; i < edges_.size(); ++i) {
        const CutEdge &cut = cuts_.edges()[edges_[i].members.front().cut];
        const PlacedCurve part = placed_part(cut, edges_[i]);
        first_plane_.push_back(plane.all().size());
        append_between(part, static_cast<int32_t>(i), nodes()[cut.from],
                       moved(nodes()[cut.to], move_of(edges_[i].turns)), plane);
        steps.next();
    }
    first_plane_.push_back(plane.all().size());
    return plane;
}

void Arrangement::set_pieces() {
    TrimPieces plane = plane_pieces();
    if (closes()) {
        set_folded(std::move(plane));
    } else {
        columns_.emplace(FoldedPieces{std::move(plane), {}}, covering_);
        first_pieces_ = first_plane_;
    }
}

void Arrangement::set_folded(TrimPieces plane) {
    const Point2 least{rounding_share * given_.reach(0), rounding_share * given_.reach(1)};
    plane_ = std::move(plane);
    covering_ = given_.begun_at(seams_for(*plane_, given_, least));
    FoldedPieces folded = fold_chains(*plane_, covering_);
    for (const int k : {0, 1}) {
        if (covering_.closed(k)) {
            contacts_[static_cast<size_t>(k)] =
                seam_contacts(folded, covering_, k, least[static_cast<size_t>(1 - k)]);
        }
    }
    size_t piece = 0;
    for (size_t i = 0; i < edges_.size(); ++i) {
        first_pieces_.push_back(piece);
        while (piece < folded.pieces.all().size() &&
               folded.pieces.all()[piece].loop == static_cast<int32_t>(i)) {
            ++piece;
        }
    }
    first_pieces_.push_back(piece);
    columns_.emplace(std::move(folded), covering_);
}

bool Arrangement::is_rounding(const Point2 &x, const Point2 &y) const noexcept {
    return std::ranges::all_of(std::array{0, 1}, [&](int k) {
        const auto at = static_cast<size_t>(k);
        return std::abs(x[at] - y[at]) <= rounding_share * std::max(given_.reach(k), std::abs(x[at]));
    });
}

void fail_undecided(const Point2 &x) {
    fail(Status::not_converged, "curves come undecidably near each other at (%s, %s)", Number(x[0]).text,
         Number(x[1]).text);
}

} // namespace nrb::face
