// SPDX-License-Identifier: MIT
#include "model/sewing/side_pieces.h"

#include "base/watch.h"
#include "eval/curve_point.h"
#include "face/deviation.h"
#include "refine/parts/cut.h"
#include "spline/part.h"

#include <algorithm>

namespace nrb::model {

namespace {

std::array<double, 3> middle_of(const Spline &curve) {
    std::array<double, 3> middle{};
    eval::curve_point(curve, parameter_in(curve.axis(0).domain(), 0.5), false, middle.data());
    return middle;
}

// Which of several pieces match each other. The piece with the most partners leads. Where several have the
// most, which of them leads may decide how many edges there are, and follows from where they are, so that the
// order of the pieces does not matter.
class MatchTable {
public:
    explicit MatchTable(size_t count) : count_(count), found_(count * count) {}

    void set(size_t a, size_t b, const face::CurveMatch &match) { at(a, b) = at(b, a) = match; }
    [[nodiscard]] const std::optional<face::CurveMatch> &between(size_t a, size_t b) const noexcept {
        return found_[a * count_ + b];
    }
    // Among the pieces not taken yet, one with the most partners; none if no two of them match. Of several
    // with one partner each it is the first one, otherwise that with the least of `middles`.
    [[nodiscard]] std::optional<size_t> leader(const std::vector<bool> &taken,
                                               const std::vector<std::array<double, 3>> &middles) const {
        std::optional<size_t> best;
        int64_t most = 0;
        for (size_t i = 0; i < count_; ++i) {
            const int64_t partners = taken[i] ? 0 : partners_of(i, taken);
            if (partners > most || (partners == most && most > 1 && middles[i] < middles[*best])) {
                most = partners;
                best = i;
            }
        }
        return best;
    }

private:
    [[nodiscard]] int64_t partners_of(size_t i, const std::vector<bool> &taken) const {
        int64_t partners = 0;
        for (size_t j = 0; j < count_; ++j) {
            partners += !taken[j] && between(i, j) ? 1 : 0;
        }
        return partners;
    }
    std::optional<face::CurveMatch> &at(size_t a, size_t b) noexcept { return found_[a * count_ + b]; }

    size_t count_;
    std::vector<std::optional<face::CurveMatch>> found_;
};

void follow(SidePiece &piece, size_t leader, const face::CurveMatch &match) {
    piece.leader = leader;
    piece.against = match.against;
    piece.gap = match.distance;
}

} // namespace

SidePieces::SidePieces(const std::vector<Side> &sides, const std::vector<std::vector<SideCut>> &cuts,
                       Corners &corners, double tolerance) {
    for (size_t i = 0; i < sides.size(); ++i) {
        add_side(sides[i], i, cuts[i], corners, tolerance);
    }
    for (SidePiece &piece : pieces_) { // collapsed pieces have merged vertices since
        piece.vertices = {corners.now(piece.vertices[0]), corners.now(piece.vertices[1])};
    }
    for (const auto &[ends, numbers] : by_ends()) {
        match_pieces(numbers, sides, tolerance);
    }
    set_members();
}

// Groups the pieces by their end vertices. Only pieces of one group can be one edge.
std::map<std::array<size_t, 2>, std::vector<size_t>> SidePieces::by_ends() const {
    std::map<std::array<size_t, 2>, std::vector<size_t>> alike;
    for (size_t i = 0; i < pieces_.size(); ++i) {
        std::array<size_t, 2> ends = pieces_[i].vertices;
        std::ranges::sort(ends);
        if (!pieces_[i].collapsed) {
            alike[ends].push_back(i);
        }
    }
    return alike;
}

void SidePieces::add_side(const Side &side, size_t number, const std::vector<SideCut> &cuts, Corners &corners,
                          double tolerance) {
    const Interval domain = side.image->axis(0).domain();
    SideCut before{domain.lower, corners.at(number, false)};
    for (size_t i = 0; i <= cuts.size(); ++i) {
        const SideCut end = i < cuts.size() ? cuts[i] : SideCut{domain.upper, corners.at(number, true)};
        SidePiece piece{number,        {before.param, end.param},
                        cuts.empty(),  {corners.now(before.vertex), corners.now(end.vertex)},
                        side.image,    false,
                        pieces_.size()};
        if (!piece.whole) {
            piece.image = refine::cut_axis(side.image, 0, before.param, end.param, {true, true});
        }
        piece.collapsed = is_collapsed(*piece.image, tolerance);
        if (piece.collapsed) {
            corners.join(piece.vertices[0], piece.vertices[1]);
        }
        piece.gap = side.off;
        pieces_.push_back(std::move(piece));
        before = end;
    }
}

void SidePieces::match_pieces(const std::vector<size_t> &alike, const std::vector<Side> &sides,
                              double tolerance) {
    MatchTable table(alike.size());
    for (size_t i = 0; i < alike.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
            const SidePiece &a = pieces_[alike[j]], &b = pieces_[alike[i]];
            const double off = sides[a.side].off + sides[b.side].off;
            const auto match =
                off < tolerance ? face::match_within(a.image, b.image, tolerance - off) : std::nullopt;
            if (match) {
                table.set(i, j, {match->distance + off, match->against});
            }
            count_work(1 << 10);
        }
    }
    std::vector<std::array<double, 3>> middles;
    for (const size_t i : alike) {
        middles.push_back(middle_of(*pieces_[i].image));
    }
    std::vector<bool> taken(alike.size(), false);
    while (const std::optional<size_t> leader = table.leader(taken, middles)) {
        taken[*leader] = true;
        for (size_t i = 0; i < alike.size(); ++i) {
            if (const auto &match = table.between(i, *leader); match && !taken[i]) {
                taken[i] = true;
                follow(pieces_[alike[i]], alike[*leader], *match);
            }
        }
    }
}

void SidePieces::set_members() {
    members_.resize(pieces_.size());
    for (size_t i = 0; i < pieces_.size(); ++i) {
        members_[pieces_[i].leader].push_back(i);
    }
}

// The adjoining piece of the same side, beyond the end of a piece at a vertex.
std::optional<size_t> SidePieces::beyond(size_t piece, size_t vertex) const {
    const SidePiece &own = pieces_[piece];
    const bool at_end = own.vertices[1] == vertex;
    const size_t next = at_end ? piece + 1 : piece - 1;
    const bool exists = at_end ? next < pieces_.size() : piece > 0;
    return exists && pieces_[next].side == own.side ? std::optional(next) : std::nullopt;
}

bool SidePieces::goes_on(size_t piece, size_t next, size_t vertex) const {
    const size_t one = pieces_[piece].leader, other = pieces_[next].leader;
    const bool closed = pieces_[piece].vertices[0] == pieces_[piece].vertices[1] ||
                        pieces_[next].vertices[0] == pieces_[next].vertices[1];
    return one != other && !closed && members_[one].size() == members_[other].size() &&
           std::ranges::all_of(members_[one], [&](size_t member) {
               const std::optional<size_t> behind = beyond(member, vertex);
               return behind && pieces_[*behind].leader == other;
           });
}

std::vector<std::vector<SideCut>> SidePieces::needed(std::vector<std::vector<SideCut>> cuts) const {
    std::vector<std::vector<SideCut>> result(cuts.size());
    std::vector<size_t> cut(cuts.size(), 0);
    for (size_t i = 0; i + 1 < pieces_.size(); ++i) {
        const size_t side = pieces_[i].side;
        if (pieces_[i + 1].side == side) {
            const SideCut &own = cuts[side][cut[side]++];
            if (!goes_on(i, i + 1, pieces_[i].vertices[1])) {
                result[side].push_back(own);
            }
        }
    }
    return result;
}

std::vector<bool> SidePieces::fewer_than(const SidePieces &parts, size_t sides) const {
    std::vector<bool> fewer(sides, false);
    auto own = pieces_.begin();
    for (const SidePiece &part : parts.pieces_) {
        while (own->side != part.side || own->range.upper < part.range.upper) {
            ++own;
        }
        fewer[part.side] = fewer[part.side] || size_of_group(*own) < parts.size_of_group(part);
    }
    return fewer;
}

} // namespace nrb::model
