// SPDX-License-Identifier: MIT
#include "face/arrange/parts.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nrb::face {

namespace {

DirectedEdge left_below(const TrimPiece &piece) noexcept {
    return {static_cast<size_t>(piece.loop), piece.start[0] < piece.end[0]};
}

} // namespace

PartsWithin::PartsWithin(const Arrangement &arrangement, const std::vector<DirectedEdge> &border)
    : arrangement_(arrangement), ways_(ways_around(arrangement, border)) {
    DisjointSets sets(ways_.size());
    for (size_t i = 0; i < ways_.size(); ++i) {
        for (const DirectedEdge edge : ways_[i]) {
            way_of_.emplace(edge, i);
        }
        shapes_.push_back(shape_of(ways_[i]));
    }
    for (size_t i = 0; i < ways_.size(); ++i) {
        if (!is_nothing(i) && shapes_[i].area < 0) {
            sets.join(i, way_above(ways_[i]));
        }
    }
    for (size_t i = 0; i < ways_.size(); ++i) {
        names_.push_back(sets.find(i));
    }
}

std::vector<PartLoops> PartsWithin::list() const {
    std::map<size_t, PartLoops> parts;
    for (size_t i = 0; i < ways_.size(); ++i) {
        if (!is_nothing(i)) {
            std::ranges::move(simple_loops(arrangement_, ways_[i]), std::back_inserter(parts[names_[i]]));
        }
    }
    std::vector<PartLoops> result;
    for (auto &[name, loops] : parts) {
        result.push_back(std::move(loops));
    }
    return result;
}

LoopShape PartsWithin::shape_of(const EdgeLoop &way) const {
    const Point2 &origin = arrangement_.nodes()[arrangement_.from(way.front())];
    LoopShape shape;
    for (const DirectedEdge edge : way) {
        for (const TrimPiece &piece : arrangement_.pieces(edge.edge)) {
            add_area(arrangement_.columns().pieces(), piece, edge.back ? -1 : 1, origin, shape);
        }
    }
    return shape;
}

bool PartsWithin::is_nothing(size_t way) const noexcept {
    return std::abs(shapes_[way].area) <= shapes_[way].noise;
}

Point2 PartsWithin::top_of(const EdgeLoop &way) const {
    Point2 top = arrangement_.nodes()[arrangement_.from(way.front())];
    for (const DirectedEdge edge : way) {
        for (const TrimPiece &piece : arrangement_.pieces(edge.edge)) {
            for (const Point2 &end : {piece.start, piece.end}) {
                top = end[1] > top[1] ? end : top;
            }
        }
    }
    return top;
}

// The way that bounds what is above the highest place of another one, from above: what comes to that place is not above it.
size_t PartsWithin::way_above(const EdgeLoop &way) const {
    const Point2 top = top_of(way);
    const TrimPieces &all = arrangement_.columns().pieces();
    const TrimPiece *lowest = nullptr;
    arrangement_.columns().in_column(top[0], [&](const TrimPiece &piece) {
        const bool above =
            bounds_something(piece) &&
            (piece.lower[1] > top[1] || (piece.upper[1] >= top[1] && all.side(piece, top) > 0));
        if (above && (lowest == nullptr || all.order(piece, *lowest) > 0)) {
            lowest = &piece;
        }
    });
    const auto found = lowest == nullptr ? way_of_.end() : way_of_.find(left_below(*lowest));
    if (found == way_of_.end()) {
        arrangement_.fail_undecided(top);
    }
    return found->second;
}

bool PartsWithin::bounds_something(const TrimPiece &piece) const {
    const auto edge = static_cast<size_t>(piece.loop);
    return way_of_.contains({edge, false}) || way_of_.contains({edge, true});
}

} // namespace nrb::face
