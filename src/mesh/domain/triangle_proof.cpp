// SPDX-License-Identifier: MIT
#include "mesh/domain/triangle_proof.h"

#include "base/watch.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace nrb::mesh {

namespace {

// Triangles of the strip over more pieces than this are bounded by the boxes of the cells that they meet.
constexpr int64_t most_pieces = 64;
// Multiply-adds, estimated: of the box of a triangle of the strip, and of finding one that is known.
constexpr int64_t work_of_a_box = 3000, work_of_a_known_one = 300;

// How far places between a segment of the border and its curve are from the segment, in space.
double move_over(const BorderSegment &segment, const HessianBox &box, const Rectangle &cell,
                 double most) noexcept {
    const double u = segment.over[0] / cell.side(0), v = segment.over[1] / cell.side(1);
    if (!segment.across || !(std::max(std::abs(u), std::abs(v)) < infinity)) {
        return box.move(std::clamp(u, -most, most), 0) + box.move(0, std::clamp(v, -most, most));
    }
    const double longer = std::max(std::abs(u), std::abs(v)), part = longer > most ? most / longer : 1;
    return box.move(part * u, part * v); // the part of the step that fits into the cell
}

// Intersects a rectangle with a block. The result has a positive width along both axes.
Rectangle in_block(const Rectangle &part, const Rectangle &block) noexcept {
    Rectangle result;
    for (size_t k = 0; k < 2; ++k) {
        result.lower[k] = std::max(part.lower[k], block.lower[k]);
        result.upper[k] = std::min(part.upper[k], block.upper[k]);
        if (!(result.lower[k] < result.upper[k])) { // a rectangle on a line
            const double step = 1e-9 * block.side(k), lower = result.lower[k];
            result.lower[k] = std::max(block.lower[k], std::min(lower, result.upper[k]) - step);
            result.upper[k] = std::min(block.upper[k], std::max(lower, result.upper[k]) + step);
        }
    }
    return result;
}

bool is_in(const Rectangle &part, const Rectangle &block) noexcept {
    return part.lower[0] >= block.lower[0] && part.lower[1] >= block.lower[1] &&
           part.upper[0] <= block.upper[0] && part.upper[1] <= block.upper[1];
}

void take_better(double other, double &bound) noexcept {
    bound = std::min(bound, other);
}

// Both are bounds of the same triangle, so that the smaller ones hold.
void take_better(const TriangleBound &other, TriangleBound &bound) noexcept {
    take_better(other.height, bound.height);
    take_better(other.out, bound.out);
    take_better(other.beside, bound.beside);
    take_better(other.whole, bound.whole);
    for (size_t k = 0; k < 3; ++k) {
        take_better(other.sides[k], bound.sides[k]);
        take_better(other.outs[k], bound.outs[k]);
        take_better(other.nears[k], bound.nears[k]);
    }
}

} // namespace

TriangleProof::TriangleProof(const MeshDomain &domain, const CellGrid &cells, const Sites &sites,
                             double chord)
    : domain_(domain), cells_(cells), sites_(sites), grid_(pieces::piece_grid_of(*domain.surface)),
      chord_(chord), nets_(grid_), by_pieces_(*domain.surface, nets_) {
    take_border();
}

size_t TriangleProof::Hash::operator()(const Key &key) const noexcept {
    uint64_t hash = 0x9e3779b97f4a7c15U;
    for (const int32_t x : key) {
        hash = (hash ^ static_cast<uint32_t>(x)) * 0xff51afd7ed558ccdU;
        hash ^= hash >> 32;
    }
    return hash;
}

ProvenTriangle TriangleProof::of(const SiteTriangle &triangle) {
    if (triangle.cell >= 0) {
        return keeps_ ? known_in_cell(triangle) : in_cell(triangle);
    }
    const auto &s = triangle.sites;
    Key key{s[0], s[1], s[2]};
    for (size_t k = 0; k < 3; ++k) {
        const int32_t border = triangle.border[k];
        key[3 + k] = border < 0 ? -1 : own_numbers_[static_cast<size_t>(border)];
    }
    const auto [known, fresh] = known_.try_emplace(key);
    count_work(fresh ? work_of_a_box : work_of_a_known_one);
    if (fresh) {
        known->second = in_strip(triangle);
    }
    return known->second;
}

void TriangleProof::take_border() {
    const FaceBorder &border = domain_.border;
    own_numbers_.clear();
    kept_.clear();
    kept_at_.clear();
    for (const BorderSegment &segment : border.segments) {
        const face::Point2 &a = border.points[static_cast<size_t>(segment.from)].param,
                           &b = border.points[static_cast<size_t>(segment.to)].param;
        const auto bits = [](double x) { return std::bit_cast<uint64_t>(x); };
        const SegmentKey key{bits(a[0]),
                             bits(a[1]),
                             bits(b[0]),
                             bits(b[1]),
                             bits(segment.over[0]),
                             bits(segment.over[1]),
                             segment.across ? 1U : 0U};
        own_numbers_.push_back(
            numbers_.try_emplace(key, static_cast<int32_t>(numbers_.size())).first->second);
    }
}

TriangleProof::Placed TriangleProof::placed(const SiteTriangle &triangle) const {
    Placed result;
    for (size_t k = 0; k < 3; ++k) {
        const int32_t site = triangle.sites[k];
        const Vector3 &x = sites_.point(sites_[site].point), &own = sites_.position(site);
        const std::array<double, 3> given{x.x, x.y, x.z};
        std::array<double, 4> in_grid{};
        grid_.place(given.data(), in_grid.data());
        TriangleCorner &corner = result.corners[k];
        corner = {sites_[site].param, {in_grid[0], in_grid[1], domain_.surface->dim() == 3 ? in_grid[2] : 0}};
        if (&x != &own) { // else the point is the position of the site
            result.moved = std::max(result.moved, grid_.scaled(length(x - own)));
        }
        for (size_t axis = 0; axis < 2; ++axis) {
            const double t = corner.param[axis];
            result.part.lower[axis] = k == 0 ? t : std::min(result.part.lower[axis], t);
            result.part.upper[axis] = k == 0 ? t : std::max(result.part.upper[axis], t);
        }
    }
    return result;
}

// Let e_i be the vectors by which the corners of the triangle are off the surface A / w, w_i the weights
// there, and l_i the barycentric coordinates in the domain. The triangle is inscribed in the surface (A + sum
// l_i w_i e_i) / w, whose second derivatives are the same. It is moved by e_i at the corners, and between
// them by no more than the largest |e_i| times (sum l_i w_i) / w. bound.weighed bounds this factor.
double TriangleProof::moved_between(const Placed &placed, const TriangleBound &bound) noexcept {
    return placed.moved > 0 ? placed.moved * bound.weighed : 0;
}

// A triangle may reach a little beyond a line at which the surface may have a kink, since rounding moves its
// corners. There the surface, and its continuation without the kink, are both no farther from that line than
// they can move on the way.
double TriangleProof::moved_beyond(const Rectangle &part, const Rectangle &block) const noexcept {
    constexpr double room = 1e-6;
    double moved = 0;
    for (size_t k = 0; k < 2; ++k) {
        const double beyond = std::max({0.0, block.lower[k] - part.lower[k], part.upper[k] - block.upper[k]});
        moved += beyond > room * block.side(k) ? infinity : 2 * beyond * cells_.tree().speed(k);
    }
    return moved;
}

ProvenTriangle TriangleProof::known_in_cell(const SiteTriangle &triangle) {
    constexpr size_t most_kept = 8192;
    const auto &s = triangle.sites;
    const Rectangle cell = cells_.tree().rectangle(cells_.tree().cells()[static_cast<size_t>(triangle.cell)]);
    kept_at_.resize(most_kept, -1);
    int32_t &at = kept_at_[Hash{}({s[0], s[1], s[2]}) % most_kept];
    if (at < 0) {
        at = static_cast<int32_t>(kept_.size());
        kept_.emplace_back();
    }
    Kept &own = kept_[static_cast<size_t>(at)];
    if (own.sites != s || own.cell != cell) {
        own = {s, cell, in_cell(triangle)};
    }
    return own.proven;
}

ProvenTriangle TriangleProof::in_cell(const SiteTriangle &triangle) {
    const Placed place = placed(triangle);
    const Cell &cell = cells_.tree().cells()[static_cast<size_t>(triangle.cell)];
    const CellPart here{&cells_.tree().box(triangle.cell), cells_.tree().rectangle(cell)};
    TriangleBound bound = triangle_bound(place.corners, {&here, 1});
    if (!(std::max(bound.from_shape(), bound.from_mesh()) <= chord_)) {
        const PieceRange pieces = nets_.pieces_in(place.part);
        if (pieces.count() > 1 && pieces.count() <= most_pieces) {
            take_better(by_pieces_.bound(place.corners, pieces, cells_.tree().block(cell.block), chord_),
                        bound);
        }
    }
    const double moved = moved_between(place, bound);
    return {bound, moved, moved};
}

// Splits the extent of a part along an axis into intervals of single blocks. The part may reach over seams.
std::vector<Interval> TriangleProof::in_blocks(const Rectangle &part, size_t k) const {
    const auto &ends = cells_.tree().block_ends(k);
    const double period = ends.back() - ends.front();
    const int copies = domain_.closed[k] ? 1 : 0; // at each side
    std::vector<Interval> result;
    for (int copy = -copies; copy <= copies; ++copy) {
        for (size_t i = 0; i + 1 < ends.size(); ++i) {
            const Interval own{std::max(ends[i], part.lower[k] + copy * period),
                               std::min(ends[i + 1], part.upper[k] + copy * period)};
            if (own.lower < own.upper) {
                result.push_back(own);
            }
        }
    }
    return result;
}

// For curves that reach into several blocks. The surface has first derivatives of its own in each block, so
// that the moves in all blocks are added up. In each block a step counts up to the extent of the part there.
TriangleProof::Moves TriangleProof::moves_in_blocks(const SiteTriangle &triangle, const Rectangle &part) {
    Moves moves{};
    for (const Interval &u : in_blocks(part, 0)) {
        for (const Interval &v : in_blocks(part, 1)) {
            const Rectangle own{{u.lower, v.lower}, {u.upper, v.upper}};
            const PieceRange pieces = nets_.pieces_in(own);
            const bool few = pieces.count() <= most_pieces;
            const Moves here = few ? moves_over(triangle, nets_.box(own, pieces), own, 1)
                                   : Moves{infinity, infinity, infinity};
            for (size_t k = 0; k < 3; ++k) {
                moves[k] += triangle.border[k] < 0 ? 0 : here[k];
            }
        }
    }
    return moves;
}

// Widens a part by the steps from the sides of the triangle to their curves of the border.
void TriangleProof::widen(const SiteTriangle &triangle, Rectangle &part) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        double beside = 0;
        for (const int32_t border : triangle.border) {
            beside = border < 0
                         ? beside
                         : std::max(beside,
                                    std::abs(domain_.border.segments[static_cast<size_t>(border)].over[k]));
        }
        part.lower[k] -= beside;
        part.upper[k] += beside;
    }
}

// Bounds how much the barycentric coordinates change on a step from a side to its curve. That of a corner
// changes by the ratio of two areas: that of the parallelogram of the step and the side opposite the corner,
// and twice that of the triangle.
std::array<double, 3> TriangleProof::shares_of_step(const SiteTriangle &triangle, const Placed &placed,
                                                    size_t side) const noexcept {
    const BorderSegment &segment = domain_.border.segments[static_cast<size_t>(triangle.border[side])];
    const auto step = [&](size_t from, size_t to) {
        const auto &a = placed.corners[from % 3].param, &b = placed.corners[to % 3].param;
        return std::array<double, 2>{b[0] - a[0], b[1] - a[1]};
    };
    const auto ab = step(0, 1), ac = step(0, 2);
    const double area = std::abs(ab[0] * ac[1] - ab[1] * ac[0]);
    std::array<double, 3> shares{};
    for (size_t k = 0; k < 3; ++k) {
        const auto along = step(k + 1, k + 2);
        const double one = segment.over[0] * along[1], other = segment.over[1] * along[0],
                     most = std::abs(one) + std::abs(other);
        shares[k] = ((segment.across ? std::abs(one - other) : most) + 16 * eps * most) / area * (1 + 1e-9);
    }
    return shares;
}

// Bounds `edge`: how far the surface between a side of the triangle at the border and its curve is from the
// triangle, and the other way round.
//
// Every place x between side k and its curve is within a step of the side, in the domain. Let l_i be the
// barycentric coordinates of x; they may be negative, and `all` bounds the sum of their magnitudes.
// - Across the plane: the height of the surface at x is at most 1/2 sum |l_i l_j| N_ij over the three pairs,
//   where N_ij bounds the second derivative of the heights along side ij (pairs.h). What is affine in the l_i
//   may be larger at x than on the triangle: the factor all (1 + 2 shares[k]) allows for that.
// - In the plane: the surface at x is as far from the side as the image of the side is (`across`), plus as
//   far as the surface moves on the step (`moves`).
// Both bounds also hold on the way from the place of the triangle below x to the curve.
void TriangleProof::set_edge(const SiteTriangle &triangle, const Placed &placed, const Moves &moves,
                             bool one_block, TriangleBound &bound) const noexcept {
    for (size_t k = 0; k < 3; ++k) {
        if (triangle.border[k] < 0) {
            continue;
        }
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const std::array<double, 3> shares = shares_of_step(triangle, placed, k);
        const double all = 1 + shares[k] + 2 * std::max(shares[i], shares[j]);
        const double high = (all * all / 8 * bound.bends[k] +
                             shares[k] * all / 2 * std::max(bound.bends[i], bound.bends[j])) *
                                all * (1 + 2 * shares[k]) +
                            all * bound.flat;
        // In other blocks the second derivatives are not known: there a step may lead in any direction.
        const double up = one_block ? high : high + moves[k];
        const double apart = diagonal(up, bound.across[k] + moves[k]) * (1 + 16 * eps) +
                             (all - 1) * moved_between(placed, bound); // corners count by larger coordinates
        bound.edge = std::max(bound.edge, apart < infinity ? apart : infinity);
    }
}

ProvenTriangle TriangleProof::in_strip(const SiteTriangle &triangle) {
    Placed place = placed(triangle);
    const auto &corners = place.corners;
    const int32_t number =
        cells_.tree().block_at({(corners[0].param[0] + corners[1].param[0] + corners[2].param[0]) / 3,
                                (corners[0].param[1] + corners[1].param[1] + corners[2].param[1]) / 3});
    const Rectangle block = cells_.tree().block(number);
    ProvenTriangle result;
    const double beyond = moved_beyond(place.part, block);
    const auto set_over = [&](const Moves &moves) {
        result.moved = moved_between(place, result.bound) + beyond;
        result.over = result.moved + *std::ranges::max_element(moves);
    };
    widen(triangle, place.part);
    const bool inside = is_in(place.part, block);
    Moves moves = inside ? Moves{} : moves_in_blocks(triangle, place.part);
    place.part = in_block(place.part, block);
    const PieceRange pieces = nets_.pieces_in(place.part);
    if (pieces.count() > most_pieces) {
        result.bound = over_cells(place, number, triangle, moves);
        set_over(moves);
        set_edge(triangle, place, moves, inside, result.bound);
        return result;
    }
    const HessianBox box = nets_.box(place.part, pieces);
    moves = inside ? moves_over(triangle, box, place.part) : moves;
    const CellPart here{&box, place.part};
    result.bound = triangle_bound(corners, {&here, 1});
    set_over(moves);
    if (pieces.count() > 1 &&
        !(std::max(result.bound.from_shape(), result.bound.from_mesh()) + result.over <= chord_)) {
        take_better(by_pieces_.bound(corners, pieces, block, chord_ - result.over), result.bound);
    }
    set_edge(triangle, place, moves, inside, result.bound);
    return result;
}

TriangleProof::Moves TriangleProof::moves_over(const SiteTriangle &triangle, const HessianBox &box,
                                               const Rectangle &cell, double most) const {
    Moves moves{};
    for (size_t k = 0; k < 3; ++k) {
        if (const int32_t border = triangle.border[k]; border >= 0) {
            moves[k] = move_over(domain_.border.segments[static_cast<size_t>(border)], box, cell, most);
        }
    }
    return moves;
}

TriangleBound TriangleProof::over_cells(const Placed &placed, int32_t block, const SiteTriangle &triangle,
                                        Moves &moves) const {
    std::vector<HessianBox> boxes;
    std::vector<CellPart> cells;
    cells_.tree().for_each_in(placed.part, [&](int32_t number) {
        const Cell &cell = cells_.tree().cells()[static_cast<size_t>(number)];
        if (cell.block == block) {
            const Rectangle own = cells_.tree().rectangle(cell);
            boxes.push_back(cells_.tree().box(number));
            cells.push_back({nullptr, own});
            const Moves here = moves_over(triangle, boxes.back(), own);
            for (size_t k = 0; k < 3; ++k) {
                moves[k] = std::max(moves[k], here[k]);
            }
        }
    });
    for (size_t i = 0; i < cells.size(); ++i) {
        cells[i].box = &boxes[i];
    }
    return triangle_bound(placed.corners, cells);
}

} // namespace nrb::mesh
