// SPDX-License-Identifier: MIT
#include "intersect/levels/level_trace.h"

#include "base/numbers.h"
#include "intersect/levels/edge_roots.h"

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
    const double near = std::max(near_, 16 * net.noise.of(net.largest_weight()));
    BoxSearch(found_, near).run(piece, domain, std::move(net), std::move(border));
}

LevelBorder LevelTrace::border(int64_t piece, const PieceDomain &domain, const LevelNet &net) {
    LevelBorder border;
    const pieces::PieceGrid &grid = field_.grid();
    const std::array<std::array<Line, 2>, 2> on{lines(piece, 0), lines(piece, 1)};
    for (size_t i = 0; i < 2; ++i) {
        for (size_t j = 0; j < 2; ++j) {
            const bool above = net.is_above(i * (net.rows() - 1), j * (net.columns() - 1));
            border.above[i][j] = corners_.try_emplace({on[0][i], on[1][j]}, above).first->second;
        }
    }
    for (size_t axis = 0; axis < 2; ++axis) {
        for (int end = 0; end < 2; ++end) {
            const size_t side = 2 * axis + static_cast<size_t>(end);
            border.edges[side] = edge(piece, axis, end, domain, net, border);
            const int64_t i = grid.index(piece)[axis];
            border.sides[side] = borders_.goes_on(axis, i, end == 1) ? LevelSide::joined : LevelSide::open;
            border.collapsed[side] = borders_.is_collapsed(axis, i, end == 1);
        }
    }
    return border;
}

const std::vector<EdgeRoot> &LevelTrace::edge(int64_t piece, size_t axis, int end, const PieceDomain &domain,
                                              const LevelNet &net, const LevelBorder &border) {
    const auto at_end = static_cast<size_t>(end);
    const size_t other = 1 - axis;
    const EdgeKey key{axis, lines(piece, axis)[at_end], field_.grid().index(piece)[other]};
    const auto [known, is_new] = edges_.try_emplace(key);
    if (is_new) {
        const bool from = axis == 0 ? border.above[at_end][0] : border.above[0][at_end],
                   to = axis == 0 ? border.above[at_end][1] : border.above[1][at_end];
        for (const double place : edge_roots(net.edge(axis, end), from, to)) {
            std::array<double, 2> at{};
            at[axis] = domain.parameter(axis, end);
            at[other] = domain.parameter(other, place);
            known->second.push_back({found_.add_root(at), place});
        }
    }
    return known->second;
}

} // namespace nrb::intersect
