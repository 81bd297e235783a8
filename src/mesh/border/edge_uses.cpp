// SPDX-License-Identifier: MIT
#include "mesh/border/edge_uses.h"

#include "base/watch.h"
#include "build/polylines.h"
#include "eval/curve_point.h"
#include "face/border_pieces.h"
#include "face/deviation.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Relative to a domain: parameters that are closer are one place, up to rounding.
constexpr double least_share = 0x1p-36;

// The break of an axis within `room` of a parameter, or the parameter itself if there is none.
double at_break(const KnotVector &axis, double t, double room) noexcept {
    const auto knots = axis.knots();
    const auto next = std::ranges::lower_bound(knots, t - room);
    return next != knots.end() && *next <= t + room ? *next : t;
}

using FixedUse = std::pair<FixedPlace *, size_t>; // a place and the use that it is of

// Whether no other place of the same use is within `room`. The places are sorted.
bool is_alone(const std::vector<FixedUse> &all, size_t i, double room) {
    const auto is_other = [&](size_t k) { return all[k].second != all[i].second; };
    const auto is_near = [&](size_t k) { return std::abs(all[i].first->edge - all[k].first->edge) <= room; };
    bool alone = true;
    for (size_t k = i; k > 0 && is_near(k - 1); --k) {
        alone = alone && is_other(k - 1);
    }
    for (size_t k = i + 1; k < all.size() && is_near(k); ++k) {
        alone = alone && is_other(k);
    }
    return alone;
}

} // namespace

// Linear maps of parameters are good enough if they keep images and edges within a small part of the chord
// error.
EdgeUses::EdgeUses(const model::Model &model, double chord) : model_(model), chord_(chord), borders_(model) {
    const double near = std::isfinite(chord) ? chord / 32 : 0;
    set_uses();
    set_curves();
    pair_from(0, near);
    const size_t count = uses_.size();
    for (int64_t number = 0; number < std::ssize(model_.faces); ++number) {
        if (face(number).has_gaps()) {
            add_gaps(number);
        }
    }
    pair_from(count, near);
    for (int64_t number = 0; number < std::ssize(model_.faces); ++number) {
        add_fixed(number);
    }
    for (EdgeUse &use : uses_) {
        if (use.fixed.size() > 1) {
            put_fixed_in_order(use);
        }
    }
}

void EdgeUses::set_uses() {
    for (int64_t number = 0; number < std::ssize(model_.faces); ++number) {
        const auto &loops = face(number).loops();
        for (int32_t loop = 0; loop < static_cast<int32_t>(loops.size()); ++loop) {
            for (int32_t i = 0; i < static_cast<int32_t>(loops[static_cast<size_t>(loop)].size()); ++i) {
                uses_.push_back({number, loop, i, curves_.max_size()});
            }
        }
    }
}

size_t EdgeUses::add_line(const SplinePtr &curve, std::vector<size_t> users) {
    for (const size_t use : users) {
        uses_[use].line = curves_.size();
    }
    curves_.push_back(curve);
    users_.push_back(std::move(users));
    return curves_.size() - 1;
}

// The edges of the model, and then those that faces have for themselves.
void EdgeUses::set_curves() {
    for (const model::Edge &edge : model_.edges) {
        std::vector<size_t> users;
        for (const model::EdgeUse &use : edge.uses) {
            users.push_back(at(use.face, static_cast<int32_t>(use.loop), static_cast<int32_t>(use.index)));
        }
        add_line(edge.curve, std::move(users));
    }
    for (size_t use = 0; use < uses_.size(); ++use) {
        if (uses_[use].line == curves_.max_size()) {
            add_line(face::edge_of(face_of(uses_[use]), coedge_of(uses_[use])), {use});
        }
    }
}

void EdgeUses::pair_from(size_t first, double near) {
    for (size_t i = first; i < uses_.size(); ++i) {
        EdgeUse &use = uses_[i];
        use.pairing = std::make_unique<CurvePairing>(face_of(use), curve_of(use), curve(use.line),
                                                     is_against(use), near);
        count_work(1 << 12);
    }
}

// Adds a segment after each curve whose end is farther from the start of the next one than the tolerance of
// the face.
void EdgeUses::add_gaps(int64_t number) {
    const auto &loops = face(number).loops();
    const auto end_of = [&](const EdgeUse &use, bool upper) {
        const Interval domain = curve_of(use).axis(0).domain();
        return use.pairing->image(upper ? domain.upper : domain.lower);
    };
    for (int32_t loop = 0; loop < static_cast<int32_t>(loops.size()); ++loop) {
        for (int32_t i = 0; i < static_cast<int32_t>(loops[static_cast<size_t>(loop)].size()); ++i) {
            const size_t own = at(number, loop, i), next = at(number, loop, next_index(number, loop, i));
            if (length(end_of(uses_[own], true) - end_of(uses_[next], false)) > face(number).tolerance()) {
                add_gap(own, next);
            }
        }
    }
}

void EdgeUses::add_gap(size_t own, size_t next) {
    const face::Face &face = face_of(uses_[own]);
    face::Point2 from{}, to{};
    eval::end_point(curve_of(uses_[own]), true, from.data());
    eval::end_point(curve_of(uses_[next]), false, to.data());
    to = face.covering().nearest_copy(to, from);
    EdgeUse use{uses_[own].face, uses_[own].loop, uses_[own].index};
    use.own = build::polyline(2, {from[0], from[1], to[0], to[1]}, {0, 1});
    const SplinePtr edge = face::edge_over(face.surface(), face.covering(), use.own, face.tolerance()).curve;
    gaps_[own] = uses_.size();
    uses_.push_back(std::move(use));
    add_line(edge, {uses_.size() - 1});
}

std::optional<size_t> EdgeUses::behind(int64_t face, int32_t loop, int32_t index) const noexcept {
    const auto found = gaps_.find(at(face, loop, index));
    return found == gaps_.end() ? std::nullopt : std::optional(found->second);
}

int32_t EdgeUses::next_index(int64_t face, int32_t loop, int32_t index) const noexcept {
    const auto count = static_cast<int32_t>(
        model_.faces[static_cast<size_t>(face)].face->loops()[static_cast<size_t>(loop)].size());
    return (index + 1) % count;
}

const Spline &EdgeUses::curve_of(const EdgeUse &use) const noexcept {
    return use.own ? *use.own : *coedge_of(use).curve;
}

bool EdgeUses::is_against(const EdgeUse &use) const noexcept {
    return !use.own && coedge_of(use).against;
}

// Fixes the places where the border crosses a seam, or a line at which the surface may have a kink. What is
// near such a line counts as on it.
void EdgeUses::add_fixed(int64_t number) {
    const face::BorderPieces border(face(number));
    const SnapLines lines(face(number), chord_);
    const auto &all = face(number).trims().pieces().all();
    for (size_t first = 0, last = 0; first < all.size(); first = last) {
        for (last = first; last < all.size() && all[last].loop == all[first].loop; ++last) {
        }
        const auto loop = std::span(all).subspan(first, last - first);
        for (const face::TrimPiece &piece : loop) {
            fix_jump(number, border, piece);
        }
        for (const LinePassage &passage : passages_of(face(number), lines, loop)) {
            if (passage.piece->range.lower == passage.piece->range.upper) {
                fix_behind(number, border, passage);
            } else {
                fix(number, border, passage);
            }
        }
    }
}

// Puts the fixed places of a use in one order on curve and edge.
void EdgeUses::put_fixed_in_order(EdgeUse &use) const {
    const Interval domain = curve_of(use).axis(0).domain();
    std::vector<FixedPlace *> places;
    for (FixedPlace &place : use.fixed) {
        places.push_back(&place);
    }
    std::ranges::sort(places, {}, &FixedPlace::curve);
    std::vector<PairedParam> pairs{{domain.lower, use.pairing->on_edge(domain.lower), true}};
    for (const FixedPlace *place : places) {
        pairs.push_back({place->curve, place->edge});
    }
    pairs.push_back({domain.upper, use.pairing->on_edge(domain.upper), true});
    put_in_order(pairs);
    for (size_t i = 0; i < places.size(); ++i) {
        places[i]->edge = pairs[i + 1].found;
    }
}

void EdgeUses::fix(int64_t number, const face::BorderPieces &border, const LinePassage &passage) {
    const face::BorderPlace place = border.place_of(*passage.piece, passage.place);
    fix_at(uses_[at(number, place.loop, place.index)], place.param, passage.at);
}

// Adds a fixed place unless there is one up to rounding, as where a curve jumps over several lines.
void EdgeUses::fix_at(EdgeUse &use, double param, const face::Point2 &place) const {
    const Interval domain = curve_of(use).axis(0).domain();
    const double room = least_share * (domain.upper - domain.lower);
    const auto is_there = [&](const FixedPlace &own) { return std::abs(own.curve - param) <= room; };
    if (std::ranges::none_of(use.fixed, is_there)) {
        use.fixed.push_back({param, use.pairing->on_edge(param), place});
    }
}

// Fixes the place where a curve jumps in the domain, as along a pole that its edge passes: both ends of the
// jump are at one vertex.
void EdgeUses::fix_jump(int64_t number, const face::BorderPieces &border, const face::TrimPiece &piece) {
    if (piece.range.lower != piece.range.upper) {
        return;
    }
    const face::BorderPlace place = border.place_of(piece, 0);
    EdgeUse &use = uses_[at(number, place.loop, place.index)];
    const Interval domain = curve_of(use).axis(0).domain();
    if (domain.lower < place.param && place.param < domain.upper) {
        fix_at(use, place.param, piece.start);
    }
}

// Fixes a place on the segment that follows a curve, if it closes a gap.
void EdgeUses::fix_behind(int64_t number, const face::BorderPieces &border, const LinePassage &passage) {
    const face::BorderPlace place = border.place_of(*passage.piece, 0);
    const bool turned = border.is_turned(*passage.piece);
    const auto count = static_cast<int32_t>(face(number).loops()[static_cast<size_t>(place.loop)].size());
    const int32_t before = turned ? (place.index + count - 1) % count : place.index;
    if (const std::optional<size_t> found = behind(number, place.loop, before)) {
        const Interval part = border.part_behind(*passage.piece);
        const double share = parameter_in(part, passage.place);
        fix_at(uses_[*found], turned ? 1 - share : share, passage.at);
    }
}

void EdgeUses::align_fixed(size_t line) {
    const KnotVector &axis = curve(line).axis(0);
    const Interval domain = axis.domain();
    const double room = least_share * (domain.upper - domain.lower);
    std::vector<FixedUse> all;
    for (const size_t use : users_[line]) {
        for (FixedPlace &fixed : uses_[use].fixed) {
            all.emplace_back(&fixed, use);
        }
    }
    std::ranges::sort(all, {}, [](const FixedUse &own) { return own.first->edge; });
    double before = domain.lower;
    size_t by = uses_.size(); // the use that `before` is of: at the lower end of the domain, none
    for (size_t i = 0; i < all.size(); ++i) {
        const auto [fixed, use] = all[i];
        if (fixed->edge - before <= room && use != by) {
            fixed->edge = before;
        } else if (domain.upper - fixed->edge <= room) {
            fixed->edge = domain.upper;
        } else {
            fixed->edge = is_alone(all, i, 2 * room) ? at_break(axis, fixed->edge, room) : fixed->edge;
            before = fixed->edge;
            by = use;
        }
    }
}

std::vector<double> EdgeUses::fixed_params(size_t line) const {
    const Interval domain = curve(line).axis(0).domain();
    std::vector<double> result;
    for (const size_t use : users_[line]) {
        for (const FixedPlace &fixed : uses_[use].fixed) {
            if (fixed.edge > domain.lower && fixed.edge < domain.upper) {
                result.push_back(fixed.edge);
            }
        }
    }
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace nrb::mesh
