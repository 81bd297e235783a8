// SPDX-License-Identifier: MIT
#include "face/arrange/arrangement.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/pairs/periods.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// In units of about a period. Solvers and places have the rounding of the largest parameters.
double near_of(const Covering &covering, double tolerance) {
    constexpr double rounding = 0x1p-38;
    double share = 1;
    for (const int k : {0, 1}) {
        const Interval domain = covering.domain(k);
        share =
            std::max(share, std::max(std::abs(domain.lower), std::abs(domain.upper)) / covering.period(k));
    }
    const double given = covering.extent() > 0 ? tolerance / covering.extent() : 0;
    return std::max(rounding * share, given);
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

void check_open(const Covering &covering) {
    for (const int k : {0, 1}) {
        if (covering.closed(k)) {
            fail(Status::incompatible, "the surface closes up along axis %d", k);
        }
        if (covering.collapsed(k, 0) || covering.collapsed(k, 1)) {
            fail(Status::incompatible, "an end of axis %d of the surface is a point", k);
        }
    }
}

Arrangement::Arrangement(const Covering &covering, std::span<const ArrangedLoop> loops, double tolerance)
    : loops_(loops.begin(), loops.end()), near_(near_of(covering, tolerance)),
      hits_(covering, smooth_parts(), near_), cuts_(hits_, near_) {
    set_edges();
    set_pieces(covering);
}

// Where a curve has a kink two parts of it come as near as that all the way to it: as one curve it would be searched for meets with
// itself around each.
std::vector<ClosedLoop> Arrangement::smooth_parts() {
    std::vector<ClosedLoop> result;
    for (size_t i = 0; i < loops_.size(); ++i) {
        PlacedLoop &parts = result.emplace_back().placed;
        parts.turn = loops_[i].placed.turn;
        for (size_t j = 0; j < loops_[i].placed.curves.size(); ++j) {
            const PlacedCurve &whole = loops_[i].placed.curves[j];
            const refine::PartedSpline split =
                refine::split_axis(whole.curve, 0, refine::rough_knots(whole.curve->axis(0), 1));
            for (int64_t part = 0; part < split.size(); ++part) {
                smooth_.push_back({split.part(part), whole.shift});
                parts.curves.push_back(smooth_.back());
                origins_.push_back({i, j});
            }
        }
    }
    return result;
}

// What pairs join, each with its direction along the first of them.
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
        const int32_t owner = loops_[origin(cuts_.edges()[member.cut]).loop].owner;
        if (owner >= 0) {
            steps.push_back({owner, member.against ? -1 : 1});
        }
    }
    edge.steps = summed(std::move(steps));
    std::erase_if(edge.steps, [](const PassedSum &step) { return step.value == 0; });
}

void Arrangement::set_pieces(const Covering &covering) {
    FoldedPieces folded;
    Steps steps(std::ssize(edges_));
    for (size_t i = 0; i < edges_.size(); ++i) {
        const CutEdge &cut = cuts_.edges()[edges_[i].members.front().cut];
        const PlacedCurve &whole = smooth_[cut.curve];
        const SplinePtr part = refine::restrict_axis(whole.curve, 0, cut.range.lower, cut.range.upper);
        first_pieces_.push_back(folded.pieces.all().size());
        append_between({part, whole.shift}, static_cast<int32_t>(i), nodes()[cut.from], nodes()[cut.to],
                       folded.pieces);
        steps.next();
    }
    first_pieces_.push_back(folded.pieces.all().size());
    columns_.emplace(std::move(folded), covering);
}

double Arrangement::rounding() const noexcept {
    constexpr double share = 0x1p-44;
    return share / std::max(hits_.distance({0, 0}, {1, 0}), hits_.distance({0, 0}, {0, 1}));
}

void Arrangement::fail_undecided(const Point2 &x) const {
    fail(Status::not_converged, "curves come undecidably near each other at (%s, %s)", Number(x[0]).text,
         Number(x[1]).text);
}

} // namespace nrb::face
