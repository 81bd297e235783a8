// SPDX-License-Identifier: MIT
#include "face/arrange/parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nrb::face {

namespace {

// The half-edge over a piece that has to its left what is below the piece.
DirectedEdge left_below(const TrimPiece &piece) noexcept {
    return {static_cast<size_t>(piece.loop), piece.start[0] < piece.end[0]};
}

} // namespace

PartsWithin::PartsWithin(const Arrangement &arrangement, const std::vector<DirectedEdge> &border)
    : arrangement_(arrangement), ways_(ways_around(arrangement, border)), at_seam_(ways_.size(), false) {
    for (size_t i = 0; i < ways_.size(); ++i) {
        for (const DirectedEdge edge : ways_[i]) {
            way_of_.emplace(edge, i);
        }
        shapes_.push_back(shape_of(ways_[i]));
    }
    set_seams();
    DisjointSets sets(seams_[1].first + seams_[1].contacts.size() + 1);
    join_seam(0, sets);
    join_seam(1, sets);
    if (seams_[0].round) {
        sets.join(seams_[0].first, seams_[1].first);
    }
    join_holes(sets);
    for (size_t i = 0; i < ways_.size(); ++i) {
        names_.push_back(sets.find(i));
    }
    corner_name_ = sets.find(seams_[0].first);
}

void PartsWithin::set_seams() {
    const Covering &covering = arrangement_.covering();
    size_t next = ways_.size();
    for (const int k : {0, 1}) {
        Seam &seam = seams_[static_cast<size_t>(k)];
        std::ranges::copy_if(arrangement_.contacts(k), std::back_inserter(seam.contacts),
                             [&](const SeamContact &contact) { return is_of_border(contact.chain); });
        seam.first = next;
        seam.round = covering.closed(0) && covering.closed(1);
        next += seam.contacts.size() + 1;
    }
}

size_t PartsWithin::Seam::at(double place) const noexcept {
    const auto next = std::ranges::upper_bound(contacts, place, {}, &SeamContact::at);
    const auto count = static_cast<size_t>(next - contacts.begin());
    return first + (round && count == contacts.size() ? 0 : count);
}

// A way that crosses the seam belongs to the stretch on its left: that with larger v if it crosses the seam
// of axis 0 to larger u, that with smaller u if it crosses the seam of axis 1 to larger v.
void PartsWithin::join_seam(int k, DisjointSets &sets) {
    const Seam &seam = seams_[static_cast<size_t>(k)];
    for (size_t i = 0; i < seam.contacts.size(); ++i) {
        const SeamContact &contact = seam.contacts[i];
        for (const bool back : {false, true}) {
            const auto way = way_of_.find({static_cast<size_t>(contact.chain), back});
            if (way != way_of_.end()) {
                const bool ahead = contact.forward != back;
                sets.join(way->second, (k == 0) == ahead ? seam.above(i) : seam.below(i));
                at_seam_[way->second] = true;
            }
        }
    }
}

void PartsWithin::join_holes(DisjointSets &sets) const {
    for (size_t i = 0; i < ways_.size(); ++i) {
        if (is_hole(i)) {
            sets.join(i, element_above(ways_[i]));
        }
    }
}

std::vector<PartLoops> PartsWithin::list(bool around_corner) const {
    std::map<size_t, PartLoops> parts;
    if (around_corner && seams_[0].round) {
        parts[corner_name_];
    }
    for (size_t i = 0; i < ways_.size(); ++i) {
        if (!is_nothing(i)) {
            std::ranges::move(simple_loops(arrangement_, ways_[i]), std::back_inserter(parts[names_[i]]));
        }
    }
    std::vector<PartLoops> result;
    result.reserve(parts.size());
    for (auto &[name, loops] : parts) {
        result.push_back(std::move(loops));
    }
    return result;
}

// The area to the left of a way, and whether it ends in another copy of the domain than it begins in.
LoopShape PartsWithin::shape_of(const EdgeLoop &way) const {
    const Point2 &origin = arrangement_.nodes()[arrangement_.from(way.front())];
    LoopShape shape;
    std::array<int, 2> turns{};
    for (const DirectedEdge edge : way) {
        const std::array<int, 2> next = turned_by(arrangement_, turns, edge);
        const Point2 move = arrangement_.move_of(edge.back ? next : turns);
        for (const TrimPiece &piece : arrangement_.plane_pieces(edge.edge)) {
            add_area(arrangement_.plane(), piece, edge.back ? -1 : 1,
                     {origin[0] - move[0], origin[1] - move[1]}, shape);
        }
        turns = next;
    }
    shape.around = turns != std::array<int, 2>{};
    return shape;
}

bool PartsWithin::is_nothing(size_t way) const noexcept {
    return !shapes_[way].around && std::abs(shapes_[way].area) <= shapes_[way].noise;
}

// A way that crosses a seam, or goes around a closed axis, gets its part from the seam instead.
bool PartsWithin::is_hole(size_t way) const noexcept {
    return !is_nothing(way) && shapes_[way].area < 0 && !shapes_[way].around && !at_seam_[way];
}

Point2 PartsWithin::top_of(const EdgeLoop &way) const {
    Point2 top = arrangement_.pieces(way.front().edge).front().start;
    for (const DirectedEdge edge : way) {
        for (const TrimPiece &piece : arrangement_.pieces(edge.edge)) {
            for (const Point2 &end : {piece.start, piece.end}) {
                top = end[1] > top[1] ? end : top;
            }
        }
    }
    return top;
}

// What bounds, from above, the part right above the highest place of a way: the way of the lowest piece of
// the border above that place in its column, where pieces that end at the place do not count; or, if there is
// no such piece, the stretch of the seam of axis 1.
size_t PartsWithin::element_above(const EdgeLoop &way) const {
    const Point2 top = top_of(way);
    const TrimPieces &all = arrangement_.columns().pieces();
    const TrimPiece *lowest = nullptr;
    arrangement_.columns().in_column(top[0], [&](const TrimPiece &piece) {
        const bool above =
            is_of_border(piece.loop) &&
            (piece.lower[1] > top[1] || (piece.upper[1] >= top[1] && all.side(piece, top) > 0));
        if (above && (lowest == nullptr || all.order(piece, *lowest) > 0)) {
            lowest = &piece;
        }
    });
    if (lowest == nullptr && arrangement_.covering().closed(1)) {
        return seams_[1].at(top[0]);
    }
    const auto found = lowest == nullptr ? way_of_.end() : way_of_.find(left_below(*lowest));
    if (found == way_of_.end()) {
        fail_undecided(top);
    }
    return found->second;
}

bool PartsWithin::is_of_border(int32_t chain) const {
    const auto edge = static_cast<size_t>(chain);
    return way_of_.contains({edge, false}) || way_of_.contains({edge, true});
}

} // namespace nrb::face
