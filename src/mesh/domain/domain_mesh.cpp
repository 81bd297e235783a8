// SPDX-License-Identifier: MIT
#include "mesh/domain/domain_mesh.h"

#include "base/watch.h"
#include "mesh/cells/cell_shape.h"
#include "mesh/cells/cell_triangles.h"
#include "mesh/domain/dropped_triangles.h"
#include "mesh/domain/triangle_pool.h"
#include "mesh/extent.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace nrb::mesh {

namespace {

// What is left for the differences of an estimate and a proof.
constexpr double share_of_estimate = 0.97;
constexpr int most_rounds = 16;
// Of the size of all: what is no longer is not divided for an angle, which may be reached nowhere near a place.
constexpr double least_for_angles = 1e-5;
// Rounds in which the strip is divided for an angle.
constexpr int most_angle_rounds = 10;

// Rounds: triangles of cells and of the strip, proofs, and more cells and places where these fail. What a round does not change stays.
class DomainMesher {
public:
    DomainMesher(const MeshDomain &domain, const MeshRule &rule)
        : domain_(domain), rule_(rule), grid_(pieces::piece_grid_of(*domain.surface)), index_(domain.border),
          chord_(within_reach(rule.chord, 1e-3)), longest_(within_reach(rule.longest, 1e-2)),
          angle_(domain.surface->dim() == 3 && rule.angle < std::numbers::pi ? angle_within_reach(rule.angle)
                                                                             : 0),
          most_apart_(angle_ > 0 ? 2 * std::sin(angle_ / 2) - 8 * eps : infinity),
          least_(least_for_angles * grid_.size()), cells_(domain, grid_, cell_rule()), sites_(domain, cells_),
          proof_(domain, cells_, sites_, grid_.scaled(chord_)) {}

    DomainMesh run() {
        for (;; ++round_) {
            triangles_.drop_strip();
            make_cells();
            make_strip();
            sites_.evaluate();
            prove();
            if (round_ == most_rounds || work_ended() || !improve() ||
                (domain_.border_grows && (is_weak() || !united_.empty() || !touched_.empty()))) {
                return output();
            }
        }
    }

private:
    // Of the triangles of a cell, side by side.
    struct CellState {
        std::array<int32_t, 4> corners{-1, -1, -1, -1}; // places; -1: not known
        int32_t places = 0;                             // on its border
        TrianglePool::Range triangles;
    };

    [[nodiscard]] CellRule cell_rule() const;
    [[nodiscard]] Side side_of(const Rectangle &part) const;
    void make_cells();
    void make_strip();
    [[nodiscard]] double rounding(double least_weight) const noexcept;
    [[nodiscard]] double rounding() const noexcept;
    [[nodiscard]] double within_reach(double length, double share) const noexcept;
    void prove();
    [[nodiscard]] Distances distances(size_t triangle) const noexcept;
    [[nodiscard]] MeshTriangle mesh_triangle(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] bool is_border(const Site &site) const noexcept;
    [[nodiscard]] std::array<int32_t, 3> points_of(const SiteTriangle &triangle) const noexcept {
        return {sites_[triangle.sites[0]].point, sites_[triangle.sites[1]].point,
                sites_[triangle.sites[2]].point};
    }
    // Whether two corners are at one point.
    [[nodiscard]] bool is_at_point(const SiteTriangle &triangle) const noexcept {
        const auto p = points_of(triangle);
        return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    }
    struct Split {
        double size = 0;
        std::array<double, 2> place{};
        int32_t border = -1; // segment of the border
    };
    [[nodiscard]] Split split_of(const SiteTriangle &triangle) const;
    [[nodiscard]] bool is_large(size_t triangle) const noexcept {
        const bool far = !(distances(triangle).most() <= chord_);
        return far || (longest_ > 0 && !(longest_side(triangles_[triangle]) <= longest_));
    }
    [[nodiscard]] bool is_over(size_t triangle) const noexcept {
        return triangles_.has(triangle) && (is_large(triangle) || is_turned(triangles_[triangle]));
    }
    [[nodiscard]] double longest_side(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] double normals_apart(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] double turn_over(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] bool is_turned(const SiteTriangle &triangle) const noexcept {
        return angle_ > 0 && !is_at_point(triangle) &&
               (normals_apart(triangle) > most_apart_ || turn_over(triangle) > angle_);
    }
    [[nodiscard]] bool is_to_divide(size_t triangle) const noexcept;
    [[nodiscard]] double least_split(size_t triangle) const noexcept;
    [[nodiscard]] int parts_for(size_t triangle) const noexcept;
    [[nodiscard]] bool is_pair(size_t triangle) const noexcept;
    [[nodiscard]] bool is_weak() const;
    void cut(const std::vector<int32_t> &cells);
    void add_place(const std::array<double, 2> &place, std::vector<std::array<double, 2>> &places) const;
    [[nodiscard]] bool improve();
    [[nodiscard]] bool is_whole() const;
    [[nodiscard]] DomainMesh output();

    const MeshDomain &domain_;
    const MeshRule &rule_;
    const pieces::PieceGrid &grid_;
    SegmentIndex index_;
    double chord_, longest_, angle_; // that triangles are made for
    double most_apart_;              // of unit normals
    double least_;                   // in the units of the grid
    CellGrid cells_;
    Sites sites_;
    TriangleProof proof_;
    std::vector<std::array<double, 2>> extra_; // places of the strip besides
    int round_ = 0;
    std::vector<CellState> states_;
    TrianglePool triangles_;
    double slack_ = 0;                                // what rounding adds to distances
    std::vector<int32_t> crossed_;                    // segments of the border
    std::vector<std::array<int32_t, 2>> united_;      // points of the border
    std::vector<std::pair<int32_t, double>> touched_; // segments
    std::map<int32_t, int> weak_;                     // these, and into how many parts they are to be divided
};

CellRule DomainMesher::cell_rule() const {
    CellRule rule;
    rule.chord = grid_.scaled(chord_) * share_of_estimate;
    rule.longest = grid_.scaled(longest_);
    rule.angle = angle_;
    rule.least = least_;
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
    if (index_.any_in(around) || domain_.cut(part)) {
        return Side::border;
    }
    return domain_.inside({part.lower[0] / 2 + part.upper[0] / 2, part.lower[1] / 2 + part.upper[1] / 2})
               ? Side::inside
               : Side::outside;
}

// Cells with as many places on their border as before have the triangles that they had.
void DomainMesher::make_cells() {
    CellTriangles maker(cells_.tree());
    std::vector<int32_t> border;
    std::vector<std::array<int32_t, 3>> made;
    const auto &all = cells_.tree().cells();
    states_.resize(all.size());
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
        if (state.places == count) {
            continue;
        }
        triangles_.remove(state.triangles);
        cells_.table().border(state.corners, border);
        made.clear();
        maker.make(cells_.table(), all[i], border, made);
        state.places = count;
        state.triangles = {triangles_.size(), made.size()};
        for (const auto &places : made) {
            const SiteTriangle triangle{
                {sites_.of_place(places[0]), sites_.of_place(places[1]), sites_.of_place(places[2])},
                static_cast<int32_t>(i)};
            triangles_.add(triangle, mesh_triangle(triangle));
        }
    }
}

void DomainMesher::make_strip() {
    triangles_.begin_strip();
    if (!domain_.inside) {
        return;
    }
    const BorderStrip strip(domain_, index_, cells_, extra_);
    crossed_ = strip.crossed();
    united_ = strip.united();
    touched_ = strip.touched();
    for (const BorderStrip::Piece &piece : strip.triangles(sites_)) {
        const SiteTriangle triangle{piece.sites, -1, piece.border, piece.fixed};
        triangles_.add(triangle, mesh_triangle(triangle));
    }
}

// Whether a site is where the surface ends: at an end of the domain, or where it jumps.
bool DomainMesher::is_border(const Site &site) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        const auto axis = static_cast<int>(k);
        if (site.param[k] == ends.front() || site.param[k] == ends.back()) {
            const bool upper = site.param[k] == ends.back();
            if (!domain_.closed[k] && !domain_.collapsed[k][upper ? 1 : 0]) {
                return true;
            }
        } else if (std::ranges::binary_search(ends, site.param[k]) &&
                   grid_.jumps(axis, grid_.find(axis, site.param[k]))) {
            return true;
        }
    }
    return false;
}

MeshTriangle DomainMesher::mesh_triangle(const SiteTriangle &triangle) const noexcept {
    MeshTriangle result{points_of(triangle)};
    for (size_t k = 0; k < 3; ++k) {
        result.border[k] = triangle.border[k] >= 0 || (is_border(sites_[triangle.sites[(k + 1) % 3]]) &&
                                                       is_border(sites_[triangle.sites[(k + 2) % 3]]));
    }
    return result;
}

// What moves the pieces, and points that are evaluated. Where weights have either sign, that is relative to the least of the
// surface.
double DomainMesher::rounding(double least_weight) const noexcept {
    constexpr int divisions = 64; // no cell is the result of more
    return grid_.moved() + grid_.moved_by_weights(grid_.radius(), least_weight, divisions) +
           8 * grid_.value_error() * grid_.radius() * (grid_.positive() ? 1 : 1 / least_weight) +
           4 * eps * grid_.size();
}

double DomainMesher::rounding() const noexcept {
    double least = 1;
    for (const Cell &cell : cells_.tree().cells()) {
        least = cell.box.certain() ? std::min(least, cell.box.least_weight()) : least;
    }
    return rounding(least);
}

// No triangles are nearer, or smaller, than rounding allows, however many there are. Then a mesh for the eye is made: for a
// share of the size.
double DomainMesher::within_reach(double length, double share) const noexcept {
    const bool wanted = length > 0 && length < infinity;
    return wanted && !(grid_.scaled(length) > rounding(1)) ? grid_.unscaled(share * grid_.size()) : length;
}

void DomainMesher::prove() {
    triangles_.prove(proof_, static_cast<size_t>(sites_.point_count()));
    slack_ = rounding();
}

Distances DomainMesher::distances(size_t triangle) const noexcept {
    const Distances d = triangles_.distances(triangle);
    return {grid_.unscaled(d.from_shape + slack_) * (1 + 4 * eps),
            grid_.unscaled(d.from_mesh + slack_) * (1 + 4 * eps)};
}

double DomainMesher::longest_side(const SiteTriangle &triangle) const noexcept {
    double longest = 0;
    for (size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, length(sites_.position(triangle.sites[k]) -
                                           sites_.position(triangle.sites[(k + 1) % 3])));
    }
    return longest;
}

// Where a triangle of the strip is best divided: at a pole on that side, else on the longest one that can be.
DomainMesher::Split DomainMesher::split_of(const SiteTriangle &triangle) const {
    Split best;
    for (size_t k = 0; k < 3; ++k) {
        const int32_t from = triangle.sites[(k + 1) % 3], to = triangle.sites[(k + 2) % 3];
        const Site &a = sites_[from], &b = sites_[to];
        const bool pole = a.point == b.point;
        const double size = pole ? infinity : length(sites_.position(from) - sites_.position(to));
        const bool can = pole || !triangle.fixed[k] || triangle.border[k] >= 0;
        if (can && size > best.size) {
            best = {size, {(a.param[0] + b.param[0]) / 2, (a.param[1] + b.param[1]) / 2}, triangle.border[k]};
        }
    }
    return best;
}

// Of the corners; those without a normal do not count.
double DomainMesher::normals_apart(const SiteTriangle &triangle) const noexcept {
    double most = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double apart =
            length(sites_.normal(triangle.sites[k]) - sites_.normal(triangle.sites[(k + 1) % 3]));
        most = apart > most ? apart : most;
    }
    return most;
}

// By the bound of its cell.
double DomainMesher::turn_over(const SiteTriangle &triangle) const noexcept {
    return triangle.cell < 0
               ? 0
               : turn_of(cells_.tree().cells()[static_cast<size_t>(triangle.cell)].box, least_).both;
}

// Where the bound of a cell sees no turn, parts of it would not do better.
bool DomainMesher::is_to_divide(size_t triangle) const noexcept {
    if (is_large(triangle)) {
        return true;
    }
    const SiteTriangle &own = triangles_[triangle];
    return is_turned(own) &&
           (own.cell < 0 ? round_ < most_angle_rounds
                         : turn_of(cells_.tree().cells()[static_cast<size_t>(own.cell)].box, least_).both >
                               angle_ / 2);
}

// What is no longer stays as it is.
double DomainMesher::least_split(size_t triangle) const noexcept {
    return !is_large(triangle) ? grid_.unscaled(least_)
           : longest_ > 0      ? std::min(chord_, longest_) / 4
                               : chord_ / 4;
}

// What is beside a segment shrinks with the square of its length, and normals turn with the length.
int DomainMesher::parts_for(size_t triangle) const noexcept {
    constexpr double most = 8;
    const double turn = angle_ > 0 ? normals_apart(triangles_[triangle]) / most_apart_ : 0;
    const double parts = std::ceil(std::max(turn, std::sqrt(distances(triangle).most() / chord_)));
    return static_cast<int>(parts >= 2 ? std::min(parts, most) : 2);
}

// Whether there are segments that can be divided.
bool DomainMesher::is_weak() const {
    const auto divides = [&](int32_t segment) {
        return domain_.border.segments[static_cast<size_t>(segment)].line >= 0;
    };
    return std::ranges::any_of(weak_, [&](const auto &weak) { return divides(weak.first); }) ||
           std::ranges::any_of(crossed_, divides);
}

void DomainMesher::cut(const std::vector<int32_t> &cells) {
    if (cells.empty()) {
        return;
    }
    const std::vector<int32_t> places = cells_.cut(cells);
    sites_.renumber(places);
    for (CellState &state : states_) {
        for (int32_t &corner : state.corners) {
            corner = corner < 0 ? corner : places[static_cast<size_t>(corner)];
        }
    }
    for (const int32_t cell : cells) {
        if (static_cast<size_t>(cell) < states_.size()) {
            triangles_.remove(states_[static_cast<size_t>(cell)].triangles);
            states_[static_cast<size_t>(cell)] = {};
        }
    }
}

// On both sides of a seam.
void DomainMesher::add_place(const std::array<double, 2> &place,
                             std::vector<std::array<double, 2>> &places) const {
    places.push_back(place);
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        if (domain_.closed[k] && (place[k] == ends.front() || place[k] == ends.back())) {
            std::array<double, 2> other = place;
            other[k] = place[k] == ends.front() ? ends.back() : ends.front();
            places.push_back(other);
        }
    }
}

// Cells over the tolerance are cut, triangles of the strip get a new place.
bool DomainMesher::improve() {
    std::vector<int32_t> over;
    std::vector<std::array<double, 2>> more;
    weak_.clear();
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (!triangles_.has(i) || !is_to_divide(i)) {
            continue;
        }
        const SiteTriangle &triangle = triangles_[i];
        if (triangle.cell >= 0) { // without any bound they are as small as is sensible
            if (distances(i).from_shape < infinity) {
                over.push_back(triangle.cell);
            }
            continue;
        }
        const Split split = split_of(triangle);
        const bool tiny = split.size <= least_split(i);
        if (split.border >= 0 && (is_large(i) || !tiny)) {
            int &parts = weak_.try_emplace(split.border, 2).first->second;
            parts = std::max(parts, parts_for(i));
        } else if (split.border < 0 && !tiny) {
            add_place(split.place, more);
        }
    }
    std::ranges::sort(over);
    over.erase(std::unique(over.begin(), over.end()), over.end());
    std::ranges::sort(more);
    more.erase(std::unique(more.begin(), more.end()), more.end());
    extra_.insert(extra_.end(), more.begin(), more.end());
    const auto before = static_cast<int32_t>(cells_.tree().cells().size());
    cut(over);
    if (round_ >= 4 && !over.empty()) { // few are left, and every round takes its time: across both axes
        for (auto cell = before; cell < static_cast<int32_t>(cells_.tree().cells().size()); ++cell) {
            over.push_back(cell);
        }
        cut(over);
    }
    return !over.empty() || !more.empty();
}

// Whether each side of a triangle is one of two triangles, or at the border, and of two in opposite directions.
bool DomainMesher::is_whole() const {
    if (!domain_.inside) {
        return true;
    }
    std::vector<std::array<int32_t, 2>> sides, directed;
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (!triangles_.has(i)) {
            continue;
        }
        const auto &p = triangles_.meshed(i).points;
        const bool at_pole = is_at_point(triangles_[i]);
        for (size_t k = 0; k < 3; ++k) {
            const int32_t a = p[(k + 1) % 3], b = p[(k + 2) % 3];
            if (!at_pole) {
                directed.push_back({a, b});
            }
            if (a != b && !triangles_.meshed(i).border[k]) {
                sides.push_back({std::min(a, b), std::max(a, b)});
            }
        }
    }
    std::ranges::sort(sides);
    for (size_t i = 0; i < sides.size(); i += 2) {
        if (i + 1 == sides.size() || sides[i] != sides[i + 1]) {
            return false;
        }
    }
    std::ranges::sort(directed);
    return std::ranges::adjacent_find(directed) == directed.end();
}

// Whether it and the next one are all of a cell, without other places on its border.
bool DomainMesher::is_pair(size_t triangle) const noexcept {
    const int32_t cell = triangles_[triangle].cell;
    const CellState none, &state = cell < 0 ? none : states_[static_cast<size_t>(cell)];
    return state.places == 4 && state.triangles.count == 2 && state.triangles.first == triangle &&
           !is_at_point(triangles_[triangle]) && !is_at_point(triangles_[triangle + 1]);
}

// Without sites and points that no triangle has.
DomainMesh DomainMesher::output() {
    DomainMesh result;
    std::vector<int32_t> sites(sites_.all().size(), -1),
        points(static_cast<size_t>(sites_.point_count()), -1);
    const auto vertex = [&](int32_t site) {
        int32_t &own = sites[static_cast<size_t>(site)];
        if (own < 0) {
            own = static_cast<int32_t>(result.vertices.size());
            int32_t point = sites_[site].point;
            if (point >= sites_.first_point()) {
                int32_t &number = points[static_cast<size_t>(point)];
                if (number < 0) {
                    number = static_cast<int32_t>(result.points.size());
                    result.points.push_back(sites_.point(point));
                }
                point = -1 - number;
            }
            result.vertices.push_back({point, sites_[site].param, sites_.normal(site)});
        }
        return own;
    };
    std::vector<std::array<int32_t, 3>> all;
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (!triangles_.has(i)) {
            continue;
        }
        const Distances d = distances(i);
        result.from_shape = std::max(result.from_shape, d.from_shape);
        result.from_mesh = std::max(result.from_mesh, d.from_mesh);
        all.push_back(triangles_.meshed(i).points);
        if (!is_at_point(triangles_[i])) {
            const auto &s = triangles_[i].sites;
            result.paired.push_back(is_pair(i));
            result.triangles.push_back({vertex(s[0]), vertex(s[1]), vertex(s[2])});
        }
    }
    bool over = false;
    for (size_t i = 0; i < triangles_.size() && !over; ++i) {
        over = is_over(i);
    }
    const bool whole = crossed_.empty() && !result.triangles.empty() && have_all_dropped(all) && is_whole();
    const bool as_asked = chord_ <= rule_.chord && longest_ <= rule_.longest && angle_ <= rule_.angle;
    result.reached = whole && !over && as_asked;
    result.from_shape = whole ? result.from_shape : infinity; // parts of the face may be missing
    result.united = united_;
    result.touched = touched_;
    for (const int32_t segment : crossed_) {
        weak_.try_emplace(segment, 2);
    }
    result.weak.assign(weak_.begin(), weak_.end());
    return result;
}

} // namespace

DomainMesh mesh_of(const MeshDomain &domain, const MeshRule &rule) {
    return DomainMesher(domain, rule).run();
}

} // namespace nrb::mesh
