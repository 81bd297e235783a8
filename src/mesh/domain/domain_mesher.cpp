// SPDX-License-Identifier: MIT
#include "mesh/domain/domain_mesher.h"

#include "base/watch.h"
#include "mesh/cells/cell_density.h"
#include "mesh/cells/cell_triangles.h"
#include "mesh/extent.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::mesh {

namespace {

// Cells are cut until the estimated distance is within this share of the chord: the rest is room for what a
// proof adds to an estimate.
constexpr double share_of_estimate = 0.97;
// The part of it that cells inside use where small angles are refined: vertices are then placed by the planes of
// triangles, which must not bend much. The border is the same as without.
constexpr double inner_for_least_angle = 0.7;
// Maximum number of rounds where edges are off the surface by more than the chord, which then is out of
// reach.
constexpr int most_rounds_off = 16;

} // namespace

DomainMesher::DomainMesher(const MeshDomain &domain, const MeshRule &rule)
    : domain_(domain), rule_(rule), grid_(pieces::piece_grid_of(*domain.surface)),
      index_(std::in_place, domain.border), chord_(within_reach(rule.chord, 1e-3)),
      longest_(rule.longest > 0 ? within_reach(rule.longest, 1e-2) : 0),
      angle_(domain.surface->dim() == 3 && rule.angle < std::numbers::pi ? angle_within_reach(rule.angle)
                                                                         : 0),
      least_(least_for_angles * grid_.size()), cells_(domain, grid_, cell_rule()), most_apart_(infinity),
      sites_(domain, cells_),
      proof_(domain, cells_, sites_, grid_.scaled(chord_) * cells_.tree().coarsening()) {
    coarsen(cells_.tree().coarsening());
    most_apart_ = angle_ > 0 ? 2 * std::sin(std::min(angle_, std::numbers::pi) / 2) - 8 * eps : infinity;
    if (domain.inside && !domain.in_space) {
        density_ = cell_density(cells_.tree());
    }
    known_points_ = domain.points != nullptr ? static_cast<int32_t>(domain.points->size()) : 0;
}

// Enlarges the limits where the work is not enough for those that were asked for.
void DomainMesher::coarsen(double factor) noexcept {
    chord_ *= factor;
    longest_ *= std::sqrt(factor);
    angle_ *= std::sqrt(factor);
}

bool DomainMesher::run() {
    for (bool more = true; more;) {
        triangles_.drop_strip();
        make_cells();
        make_strip();
        sites_.evaluate();
        prove();
        weak_.clear();
        more = !work_ended() && !(is_off_ && all_rounds_ >= most_rounds_off) && improve();
        ++round_;
        ++all_rounds_;
        if (change_border()) {
            more = true;
            if (!take_border()) {
                return false;
            }
        }
    }
    weak_.clear();
    return !keep_least_angle() || !change_border();
}

CellRule DomainMesher::cell_rule() const {
    CellRule rule;
    rule.chord = grid_.scaled(chord_) * share_of_estimate;
    rule.inner = rule_.least_angle > 0 ? inner_for_least_angle : 1;
    rule.longest = grid_.scaled(longest_);
    rule.angle = angle_;
    rule.least = least_;
    // A cell has two triangles, and proving one of them takes as long as the cell itself. Where triangles are
    // small for the sake of another limit than the chord, their distances are bounded as tightly as possible,
    // which takes longer.
    rule.work_behind = longest_ > 0 || angle_ > 0 ? 2 * work_of_triangle : work_of_triangle;
    for (size_t k = 0; k < 2; ++k) {
        const Interval axis = domain_.surface->axis(static_cast<int>(k)).domain();
        const double parts = domain_.closed[k]                                    ? 3
                             : domain_.collapsed[k][0] || domain_.collapsed[k][1] ? 2
                                                                                  : 1;
        rule.most_sides[k] = (axis.upper - axis.lower) / parts * (1 + 1e-9);
    }
    if (domain_.inside) {
        rule.side = [this](const Rectangle &part) { return side_of(part); };
    }
    return rule;
}

Side DomainMesher::side_of(const Rectangle &part) const {
    Rectangle around = part;
    for (size_t k = 0; k < 2; ++k) {
        around.lower[k] -= near_border * part.side(k);
        around.upper[k] += near_border * part.side(k);
    }
    if (index_->any_in(around) || domain_.cut(part)) {
        return Side::border;
    }
    return domain_.inside(part.middle()) ? Side::inside : Side::outside;
}

// Finds the corners of cells inside, and makes room for the triangles of those that have more places on their
// border than before. Cells that are no longer inside lose their triangles.
void DomainMesher::look_at_cells() {
    const auto &all = cells_.tree().cells();
    states_.reserve(all.size());
    states_.resize(all.size());
    size_t more = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        CellState &state = states_[i];
        if (all[i].side != Side::inside) {
            triangles_.remove(state.triangles);
            state = {};
            continue;
        }
        if (state.corners[0] < 0) {
            state.corners = cells_.table().corners(all[i]);
        }
        const int32_t count = cells_.table().border_count(state.corners);
        more += state.places == count ? 0 : static_cast<size_t>(count) - (state.centred ? 0 : 2);
    }
    triangles_.make_room(more);
}

// The triangles of a cell, by their sites.
void DomainMesher::make_cell(int32_t cell, const std::vector<int32_t> &border,
                             std::vector<std::array<int32_t, 3>> &sites) {
    const Cell &own = cells_.tree().cells()[static_cast<size_t>(cell)];
    sites.clear();
    if (!states_[static_cast<size_t>(cell)].centred) {
        CellTriangles(cells_.tree()).make(cells_.table(), own, border, sites);
        for (auto &triangle : sites) {
            std::ranges::transform(triangle, triangle.begin(),
                                   [this](int32_t place) { return sites_.of_place(place); });
        }
        return;
    }
    const int32_t middle = sites_.of_param(cells_.tree().rectangle(own).middle(), own.block, -1);
    for (size_t i = 0; i < border.size(); ++i) {
        const int32_t next = border[(i + 1) % border.size()];
        sites.push_back({sites_.of_place(border[i]), sites_.of_place(next), middle});
    }
}

// Cells with as many places on their border as before keep their triangles.
void DomainMesher::make_cells() {
    look_at_cells();
    std::vector<int32_t> border;
    std::vector<std::array<int32_t, 3>> made;
    for (size_t i = 0; i < states_.size(); ++i) {
        CellState &state = states_[i];
        const int32_t count = state.corners[0] < 0 ? 0 : cells_.table().border_count(state.corners);
        if (state.places == count) {
            continue;
        }
        triangles_.remove(state.triangles);
        cells_.table().border(state.corners, border);
        const auto cell = static_cast<int32_t>(i);
        make_cell(cell, border, made);
        state.places = count;
        state.triangles = {static_cast<int32_t>(triangles_.size()), static_cast<int32_t>(made.size())};
        for (const auto &sites : made) {
            const SiteTriangle triangle{sites, cell};
            triangles_.add(triangle, mesh_triangle(triangle));
        }
    }
}

void DomainMesher::make_strip() {
    triangles_.begin_strip();
    if (!domain_.inside) {
        return;
    }
    const BorderStrip strip(domain_, *index_, cells_, extra_, density_);
    crossed_ = strip.crossed();
    united_ = strip.united();
    touched_ = strip.touched();
    std::vector<std::array<double, 2>> divided;
    for (const BorderStrip::Piece &piece : strip.triangles(sites_, divided)) {
        const SiteTriangle triangle{piece.sites, -1, piece.border, piece.fixed};
        triangles_.add(triangle, mesh_triangle(triangle));
    }
    std::vector<std::array<double, 2>> more;
    for (const auto &place : divided) {
        add_place(place, more);
    }
    extra_.insert(more.begin(), more.end());
}

// Whether a side lies where the surface ends: at an end of the domain that is neither a seam nor a pole, or
// on a line at which the surface jumps.
bool DomainMesher::is_border(const Site &from, const Site &to) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const double t = from.param[k];
        if (t != to.param[k]) {
            continue;
        }
        const auto &ends = cells_.tree().block_ends(k);
        const auto axis = static_cast<int>(k);
        if (t == ends.front() || t == ends.back()) {
            if (!domain_.closed[k] && !domain_.collapsed[k][t == ends.back() ? 1 : 0]) {
                return true;
            }
        } else if (std::ranges::binary_search(ends, t) && grid_.jumps(axis, grid_.find(axis, t))) {
            return true;
        }
    }
    return false;
}

MeshTriangle DomainMesher::mesh_triangle(const SiteTriangle &triangle) const noexcept {
    MeshTriangle result{points_of(triangle)};
    for (size_t k = 0; k < 3; ++k) {
        result.border[k] = triangle.border[k] >= 0 || is_border(sites_[triangle.sites[(k + 1) % 3]],
                                                                sites_[triangle.sites[(k + 2) % 3]]);
    }
    return result;
}

// By how much rounding moves the Bezier pieces and evaluated points, in units of the grid. Where weights have
// both signs, that is relative to the least weight of the surface.
double DomainMesher::rounding(double least_weight) const noexcept {
    constexpr int divisions = 64; // no cell results from more
    return grid_.moved() + grid_.moved_by_weights(grid_.radius(), least_weight, divisions) +
           8 * grid_.value_error() * grid_.radius() * (grid_.positive() ? 1 : 1 / least_weight) +
           4 * eps * grid_.size();
}

// Replaces a limit that rounding keeps out of reach: no triangles are nearer to the surface, or smaller, than
// rounding allows, however many there are. Then a mesh for display is made: the limit is a share of the size
// of the surface, or twice the rounding if that is a point, which has no size.
double DomainMesher::within_reach(double length, double share) const noexcept {
    const double reached = grid_.scaled(length), least = rounding(1);
    return reached > least ? length : grid_.unscaled(std::max(share * grid_.size(), 2 * least));
}

void DomainMesher::prove() {
    slack_ = rounding(cells_.tree().least_weight());
    // Distances within the chord need no tighter bound if the chord is the only limit. Under other limits
    // they are smaller anyway, and where the work is not enough for the chord the bounds are to be as tight
    // as possible.
    const bool by_distance =
        chord_ < infinity && longest_ == 0 && angle_ == 0 && !work_ended() && cells_.tree().coarsening() == 1;
    const double allowed = grid_.scaled(chord_) * (1 - 1e-6) - slack_;
    triangles_.prove(proof_, static_cast<size_t>(sites_.point_count()), by_distance ? allowed : 0, allowed);
}

Distances DomainMesher::distances(size_t triangle) const noexcept {
    const Distances d = triangles_.distances(triangle);
    return {grid_.unscaled(d.from_shape + slack_) * (1 + 4 * eps),
            grid_.unscaled(d.from_mesh + slack_) * (1 + 4 * eps)};
}

DomainMesh mesh_of(const MeshDomain &domain, const MeshRule &rule) {
    DomainMesher mesher(domain, rule);
    static_cast<void>(mesher.run()); // there is a result, since the border is fixed
    return mesher.output(true);
}

} // namespace nrb::mesh
