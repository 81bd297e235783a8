// SPDX-License-Identifier: MIT
#include "mesh/cells/piece_bound.h"

#include "eval/evaluate.h"
#include "mesh/proof/distance.h"

#include <algorithm>

namespace nrb::mesh {

TriangleBound PieceBound::bound(const std::array<TriangleCorner, 3> &corners, const PieceRange &pieces,
                                const Rectangle &block, double enough) {
    block_ = block;
    enough_ = enough;
    const pieces::PieceGrid &grid = nets_.grid();
    std::array<std::array<double, 2>, 3> params;
    double longest = 0;
    for (size_t k = 0; k < 3; ++k) {
        params[k] = corners[k].param;
        points_[k] = corners[k].point;
        longest = std::max(longest, length(corners[(k + 1) % 3].point - corners[k].point));
    }
    noise_ = 8 * eps * (longest + grid.radius()) + 4 * grid.value_error() * grid.radius();
    TriangleBound result;
    for (int64_t u = pieces.lower[0]; u < pieces.upper[0]; ++u) {
        for (int64_t v = pieces.lower[1]; v < pieces.upper[1]; ++v) {
            const Rectangle part{{grid.break_at(0, u), grid.break_at(1, v)},
                                 {grid.break_at(0, u + 1), grid.break_at(1, v + 1)}};
            const CutPolygon polygon = cut_triangle(params, part);
            if (polygon.places().size() >= 3) {
                add(polygon, {u, v}, result);
            }
        }
    }
    result.out = result.whole = result.height; // a distance, whatever the direction
    result.outs.fill(result.height);
    return result;
}

void PieceBound::place_corners(const CutPolygon &polygon) {
    const std::span<const CutPlace> places = polygon.places();
    const auto n = std::ssize(places);
    params_.clear();
    for (const CutPlace &place : places) {
        for (size_t k = 0; k < 2; ++k) {
            params_.push_back(std::clamp(place.at[k], block_.lower[k], block_.upper[k]));
        }
    }
    values_.assign(static_cast<size_t>(n * 3), 0);
    for (int64_t first = 0, end = 0; first < n; first = end) {
        const auto from_left = ends_at(first);
        for (end = first + 1; end < n && ends_at(end) == from_left; ++end) {
        }
        evaluate(first, end, from_left);
    }
    corners_.clear();
    for (size_t i = 0; i < places.size(); ++i) {
        std::array<double, 8> placed{};
        nets_.grid().place(values_.data() + 3 * i, placed.data());
        corners_.push_back({places[i].at, {placed[0], placed[1], surface_.dim() == 3 ? placed[2] : 0}});
    }
}

// Along which axes a place is at the upper end of the block. The surface is continuous in a block, so that limits from
// both sides agree at breaks inside. At its ends the limits are those from inside: the surface may jump at both ends.
std::array<bool, 2> PieceBound::ends_at(int64_t place) const noexcept {
    const double *param = params_.data() + 2 * place;
    return {param[0] >= block_.upper[0], param[1] >= block_.upper[1]};
}

void PieceBound::evaluate(int64_t first, int64_t end, const std::array<bool, 2> &from_left) {
    eval::AxisRules rules{};
    for (size_t k = 0; k < 2; ++k) {
        rules[k].left = from_left[k];
    }
    eval::evaluate_points(surface_, rules, 0, {params_.data() + 2 * first, end - first, 2, 2, 1},
                          {values_.data() + 3 * first, end - first, surface_.dim(), 3, 1});
}

// The box of the polygon in the domain, with the whole piece along an axis along which it has no extent.
Rectangle PieceBound::around(const std::array<int64_t, 2> &piece) const noexcept {
    Rectangle result{corners_.front().param, corners_.front().param};
    for (size_t k = 0; k < 2; ++k) {
        for (const TriangleCorner &corner : corners_) {
            result.lower[k] = std::min(result.lower[k], corner.param[k]);
            result.upper[k] = std::max(result.upper[k], corner.param[k]);
        }
        if (!(result.lower[k] < result.upper[k])) {
            result.lower[k] = nets_.grid().break_at(static_cast<int>(k), piece[k]);
            result.upper[k] = nets_.grid().break_at(static_cast<int>(k), piece[k] + 1);
        }
    }
    return result;
}

void PieceBound::add(const CutPolygon &polygon, const std::array<int64_t, 2> &piece, TriangleBound &result) {
    place_corners(polygon);
    double off = 0;
    for (const TriangleCorner &corner : corners_) {
        off = std::max(off, distance_from_triangle(corner.point, points_));
    }
    if (!is_enough(whole_piece(piece), enough_ - off - noise_)) {
        const Rectangle part = around(piece);
        const HessianBox box = nets_.box(part, {piece, {piece[0] + 1, piece[1] + 1}});
        bound_parts({&box, part});
    }
    add_parts(polygon, off, result);
}

// Whether no triangle of the polygon is farther from the surface at equal parameters than allowed. That
// distance bounds all others.
bool PieceBound::is_enough(const CellPart &cell, double allowed) {
    double most = 0;
    for (size_t i = 1; i + 1 < corners_.size() && most <= allowed; ++i) {
        most = std::max(most, equal_parameter_bound(part(i), {&cell, 1}));
    }
    TriangleBound bound;
    bound.height = bound.beside = bound.whole = most;
    bound.sides.fill(most);
    bounds_.assign(corners_.size() - 2, bound);
    return most <= allowed;
}

void PieceBound::bound_parts(const CellPart &cell) {
    for (size_t i = 1; i + 1 < corners_.size(); ++i) {
        bounds_[i - 1] = triangle_bound(part(i), {&cell, 1}, true);
    }
}

void PieceBound::add_parts(const CutPolygon &polygon, double off, TriangleBound &result) const {
    const std::span<const CutPlace> places = polygon.places();
    const size_t n = places.size();
    for (size_t i = 1; i + 1 < n; ++i) {
        const std::array<TriangleCorner, 3> own = part(i);
        const TriangleBound &bound = bounds_[i - 1];
        result.height = std::max(result.height, off + bound.from_shape() + noise_);
        const std::array<int, 3> sides{places[i].side, i + 2 == n ? places[n - 1].side : -1,
                                       i == 1 ? places[0].side : -1};
        for (size_t k = 0; k < 3; ++k) {
            if (sides[k] >= 0) {
                add_side(static_cast<size_t>(sides[k]), own[(k + 1) % 3].point, own[(k + 2) % 3].point,
                         bound.sides[k], result);
            }
        }
    }
}

// The bound over a whole piece, which is kept. Where there are several pieces they are small, so that it is
// mostly enough, and many triangles ask for it.
CellPart PieceBound::whole_piece(const std::array<int64_t, 2> &piece) {
    constexpr size_t most_kept = 4096;
    if (boxes_.size() >= most_kept) {
        boxes_.clear();
    }
    const pieces::PieceGrid &grid = nets_.grid();
    const Rectangle part{{grid.break_at(0, piece[0]), grid.break_at(1, piece[1])},
                         {grid.break_at(0, piece[0] + 1), grid.break_at(1, piece[1] + 1)}};
    const auto [known, fresh] = boxes_.try_emplace(grid.piece({piece[0], piece[1], 0}));
    if (fresh) {
        known->second = nets_.box(part, {piece, {piece[0] + 1, piece[1] + 1}});
    }
    return {&known->second, part};
}

void PieceBound::add_side(size_t side, const Vector3 &from, const Vector3 &to, double beside,
                          TriangleBound &result) const {
    const Vector3 &a = points_[(side + 1) % 3], &b = points_[(side + 2) % 3];
    const double off = std::max(distance_from_segment(from, a, b), distance_from_segment(to, a, b));
    result.sides[side] = std::max(result.sides[side], off + beside + noise_);
    result.beside = std::max(result.beside, result.sides[side]);
}

} // namespace nrb::mesh
