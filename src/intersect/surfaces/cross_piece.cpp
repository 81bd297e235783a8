// SPDX-License-Identifier: MIT
#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "intersect/surfaces/cross_cell.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

std::vector<double> widening_of(int degree) {
    return part_matrix(degree, -widening, 1 + widening);
}

} // namespace

CrossGround::CrossGround(const Spline &surface, const pieces::Frame &frame, const SurfaceBorders &ends,
                         const SideShifts &of_axes)
    : grid(pieces::piece_grid_of(surface)), borders(ends),
      shifts(of_axes), widenings{widening_of(surface.axis(0).degree()),
                                 widening_of(surface.axis(1).degree())},
      pieces_(pieces::piece_tree_of(surface), frame) {}

CrossGround::~CrossGround() = default;

const CrossPiece *CrossGround::piece(const pieces::PieceGrid::Index &index) {
    const int64_t at = grid.piece(index);
    const auto known = made_.find(at);
    if (known != made_.end()) {
        return known->second.get();
    }
    pieces::BezierPiece made = pieces_.piece(at);
    count_work(16 * made.coefficients());
    std::unique_ptr<const CrossPiece> piece;
    if (made.positive()) {
        piece = std::make_unique<const CrossPiece>(std::move(made), *this);
    }
    return made_.emplace(at, std::move(piece)).first->second.get();
}

CrossPiece::CrossPiece(pieces::BezierPiece made, CrossGround &of)
    : ground(&of), piece(std::move(made)), degrees{piece.degree(0), piece.degree(1)}, shift(of.shifts) {
    const pieces::LocalParam first = piece.parameter({0, 0}), last = piece.parameter({1, 1});
    for (size_t k = 0; k < 2; ++k) {
        range[k] = {first[k], last[k]};
    }
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        largest_weight = std::max(largest_weight, piece.weight(i));
    }
    // Bernstein functions have relative errors of 3 / 2 eps for each degree, which move a mean of control
    // points by as much times their distance; sums and quotients add one rounding for each of their terms.
    const int degrees_of_both = degrees[0] + degrees[1];
    error = piece.moved() + 1.5 * degrees_of_both * eps * (std::sqrt(3.0) * piece.size()) +
            (degrees_of_both + 6) * eps * piece.reach();
    set_sides(of.grid, of.borders);
}

void CrossPiece::set_sides(const pieces::PieceGrid &grid, const SurfaceBorders &borders) {
    for (size_t k = 0; k < 2; ++k) {
        const int axis = static_cast<int>(k);
        const int64_t i = grid.find(axis, range[k].lower / 2 + range[k].upper / 2), n = grid.count(axis);
        const auto length = [&](int64_t at) {
            const int64_t piece_at = (at + n) % n;
            return grid.break_at(axis, piece_at + 1) - grid.break_at(axis, piece_at);
        };
        index[k] = i;
        const double start = grid.break_at(axis, i), whole = length(i),
                     part = range[k].upper - range[k].lower;
        within[k] = {range[k].lower == start ? 0 : (range[k].lower - start) / whole,
                     range[k].upper == grid.break_at(axis, i + 1) ? 1 : (range[k].upper - start) / whole};
        const double of_axis = shift[k];
        shift[k] *= whole / part;
        for (size_t end = 0; end < 2; ++end) {
            const bool up = end == 1, is_break = (up ? within[k].upper : within[k].lower) == (up ? 1 : 0);
            open[k][end] = is_break && !borders.goes_on(k, i, up);
            poles[k][end] = is_break && borders.is_collapsed(k, i, up);
            const double next = is_break && !open[k][end] ? length(up ? i + 1 : i - 1) : whole;
            const double by = of_axis * std::min(next, whole) / part;
            shifts[k][end] = open[k][end] && !up ? -by : by;
            rooms[k][end] = poles[k][end] ? 0 : by / of_axis * room_along_sides;
        }
    }
    const auto is_whole = [](const Interval &places) { return places.lower == 0 && places.upper == 1; };
    if (!is_whole(within[0]) || !is_whole(within[1])) {
        rooms = {};
    }
}

CrossPiece::Point CrossPiece::evaluate(const std::array<double, 2> &place) const noexcept {
    constexpr size_t stride = max_degree + 1;
    std::array<std::array<double, 2 * stride>, 2> b;
    for (size_t k = 0; k < 2; ++k) {
        bernstein_functions(degrees[k], place[k], 1, stride, b[k].data());
    }
    std::array<double, 4> value{}, by_u{}, by_v{};
    const double *record = piece.record(0);
    for (int i = 0; i <= degrees[0]; ++i) {
        std::array<double, 4> row{}, row_v{};
        for (int j = 0; j <= degrees[1]; ++j, record += 4) {
            const double f = b[1][static_cast<size_t>(j)], g = b[1][stride + static_cast<size_t>(j)];
            for (size_t c = 0; c < 4; ++c) {
                row[c] += f * record[c];
                row_v[c] += g * record[c];
            }
        }
        const double f = b[0][static_cast<size_t>(i)], g = b[0][stride + static_cast<size_t>(i)];
        for (size_t c = 0; c < 4; ++c) {
            value[c] += f * row[c];
            by_u[c] += g * row[c];
            by_v[c] += f * row_v[c];
        }
    }
    const double inverse = 1 / value[3];
    const Vector3 at{value[0] * inverse, value[1] * inverse, value[2] * inverse};
    const auto quotient = [&](const std::array<double, 4> &by) {
        return inverse * (Vector3{by[0], by[1], by[2]} - by[3] * at);
    };
    return {at, {quotient(by_u), quotient(by_v)}, {by_u[3] * inverse, by_v[3] * inverse}};
}

} // namespace nrb::intersect
