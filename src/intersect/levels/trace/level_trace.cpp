// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/level_trace.h"

#include "base/numbers.h"
#include "intersect/levels/trace/edge_roots.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

PieceDomain domain_of(const pieces::PieceGrid &grid, int64_t piece) {
    const auto part = grid.part(piece);
    return {{part[0].lower, part[1].lower}, {part[0].upper, part[1].upper}};
}

LevelTrace::LevelTrace(LevelField &field, const SurfaceBorders &borders, double tolerance)
    : field_(field), borders_(borders), near_(field.resolution(tolerance)) {
    for (size_t k = 0; k < 2; ++k) {
        const int axis = static_cast<int>(k);
        if (borders.wraps(k)) {
            found_.closed[k] = {field.grid().break_at(axis, 0),
                                field.grid().break_at(axis, field.grid().count(axis))};
        }
    }
}

std::array<LevelTrace::Line, 2> LevelTrace::lines(int64_t piece, size_t axis) const {
    const pieces::PieceGrid &grid = field_.grid();
    const int k = static_cast<int>(axis);
    const int64_t i = grid.index(piece)[axis];
    const bool goes_down = borders_.goes_on(axis, i, false), goes_up = borders_.goes_on(axis, i, true);
    const int64_t upper = goes_up && i + 1 == grid.count(k) ? 0 : i + 1;
    return {goes_down ? 2 * i : 2 * i + 1, 2 * upper};
}

void LevelTrace::add(int64_t piece) {
    LevelNet net = field_.net(piece);
    if (net.side(4) != 0) {
        return;
    }
    const PieceDomain domain = domain_of(field_.grid(), piece);
    LevelBorder border = this->border(piece, domain, net);
    // More than what tells signs, so that boxes end at one of both.
    const double near = std::max(near_, 6 * net.noise.of(net.largest_weight()));
    BoxSearch(found_, near).run(piece, domain, std::move(net), std::move(border));
}

// A sign that is certain and another one is that of a function that jumps.
bool LevelTrace::corner(const Corner &at, const LevelNet &net, size_t row, size_t column) {
    const bool above = net.is_above(row, column), first = corners_.try_emplace(at, above).first->second;
    const size_t i = row * net.columns() + column;
    const bool certain = std::abs(net.values[i]) > 4 * net.noise.of(net.weight(i));
    return field_.may_jump() && certain ? above : first;
}

LevelBorder LevelTrace::border(int64_t piece, const PieceDomain &domain, const LevelNet &net) {
    LevelBorder border;
    const pieces::PieceGrid &grid = field_.grid();
    const std::array<std::array<Line, 2>, 2> on{lines(piece, 0), lines(piece, 1)};
    for (size_t i = 0; i < 2; ++i) {
        for (size_t j = 0; j < 2; ++j) {
            border.above[i][j] =
                corner({on[0][i], on[1][j]}, net, i * (net.rows() - 1), j * (net.columns() - 1));
        }
    }
    for (size_t axis = 0; axis < 2; ++axis) {
        for (int end = 0; end < 2; ++end) {
            const size_t side = 2 * axis + static_cast<size_t>(end);
            const int64_t i = grid.index(piece)[axis];
            border.sides[side] = borders_.goes_on(axis, i, end == 1) ? LevelSide::joined : LevelSide::open;
            border.collapsed[side] = borders_.is_collapsed(axis, i, end == 1);
            border.edges[side] = edge({piece, axis, end}, domain, net, border);
        }
    }
    return border;
}

namespace {

// Whether the roots that one side sees are those of the other, as far as rounding can tell.
bool are_one(const std::vector<EdgeRoot> &a, const std::vector<double> &b, const LevelNet::Edge &edge) {
    const double known = 16 * edge.largest_known();
    return std::ranges::equal(a, b, [&](const EdgeRoot &x, double y) {
        return std::abs(x.place - y) <= 64 * eps || std::abs(edge.value(x.place)) <= known;
    });
}

} // namespace

std::vector<EdgeRoot> LevelTrace::edge(const Side &side, const PieceDomain &domain, const LevelNet &net,
                                       LevelBorder &border) {
    const auto at_end = static_cast<size_t>(side.end);
    const EdgeKey key{side.axis, lines(side.piece, side.axis)[at_end],
                      field_.grid().index(side.piece)[1 - side.axis]};
    const auto [known, is_new] = edges_.try_emplace(key, SharedEdge{side, {}});
    SharedEdge &shared = known->second;
    shared.again = !is_new;
    if (!is_new && !field_.may_jump()) {
        return shared.roots;
    }
    const bool from = side.axis == 0 ? border.above[at_end][0] : border.above[0][at_end],
               to = side.axis == 0 ? border.above[at_end][1] : border.above[1][at_end];
    const LevelNet::Edge own_edge = net.edge(side.axis, side.end);
    const std::vector<double> places = edge_roots(own_edge, from, to);
    if (is_new) {
        shared.roots = add_roots(side, domain, places);
        return shared.roots;
    }
    if (are_one(shared.roots, places, own_edge)) {
        return shared.roots;
    }
    border.sides[2 * side.axis + at_end] = LevelSide::open;
    end_at(shared.roots);
    std::vector<EdgeRoot> own = add_roots(side, domain, places);
    end_at(own);
    return own;
}

std::vector<EdgeRoot> LevelTrace::add_roots(const Side &side, const PieceDomain &domain,
                                            const std::vector<double> &places) {
    std::vector<EdgeRoot> roots;
    for (const double place : places) {
        std::array<double, 2> at{};
        at[side.axis] = domain.parameter(side.axis, side.end);
        at[1 - side.axis] = domain.parameter(1 - side.axis, place);
        roots.push_back({found_.add_root(at), place});
    }
    return roots;
}

void LevelTrace::end_at(const std::vector<EdgeRoot> &roots) {
    for (const EdgeRoot &root : roots) {
        found_.roots[static_cast<size_t>(root.root)].is_end = true;
    }
}

// The piece beyond has no zeros of its own: f has a sign there, for certain, if it jumps.
void LevelTrace::end_at_jump(const SharedEdge &edge) {
    const auto &[piece, axis, end] = edge.side;
    const pieces::PieceGrid &grid = field_.grid();
    pieces::PieceGrid::Index index = grid.index(piece);
    const int64_t count = grid.count(static_cast<int>(axis));
    index[axis] = (index[axis] + (end == 1 ? 1 : count - 1)) % count;
    if (borders_.goes_on(axis, grid.index(piece)[axis], end == 1) &&
        (!field_.may_vanish(grid.piece(index)) || field_.net(grid.piece(index)).side(4) != 0)) {
        end_at(edge.roots);
    }
}

LevelPieces LevelTrace::take() {
    for (const auto &[key, edge] : edges_) {
        if (field_.may_jump() && !edge.again && !edge.roots.empty()) {
            end_at_jump(edge);
        }
    }
    return std::move(found_);
}

} // namespace nrb::intersect
