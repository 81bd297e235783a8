// SPDX-License-Identifier: MIT
#include "mesh/domain/domain_mesher.h"

#include "base/watch.h"
#include "mesh/cells/cell_shape.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Maximum number of rounds in which triangles of the strip are divided for an angle.
constexpr int most_angle_rounds = 10;
// In multiples of the chord: up to this distance a vertex in the middle of the cell may suffice.
constexpr double most_centred = 2;
// Maximum number of changes of the border for other reasons than distances.
constexpr int most_changes = 12;
// Shares of the extent of the domain. A cell or side no larger than the first one is not divided, even where
// that would help; a segment of the border no longer than the second one is not if it is short in space, too,
// and no distance is known.
constexpr double least_share = 0x1p-26, least_unknown = 0x1p-12;
// Rounds after which triangles beside divided ones of the strip are divided too, and in how many rings at
// most.
constexpr int slow_rounds = 8, most_rings = 64;
// Range of the size of a split, relative to that of a divided triangle, in which triangles count as equally
// large.
constexpr double least_size = 0.9, most_size = 1.5;

} // namespace

double DomainMesher::longest_side(const SiteTriangle &triangle) const noexcept {
    double longest = 0;
    for (size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, length(sites_.position(triangle.sites[k]) -
                                           sites_.position(triangle.sites[(k + 1) % 3])));
    }
    return longest;
}

// Where a triangle of the strip is best divided: on a side that is at a pole, unless that is narrow already, else on
// the side over which the surface is longest, of those that can be divided.
DomainMesher::Split DomainMesher::split_of(const SiteTriangle &triangle) const {
    constexpr double narrow = 0.25;
    std::array<double, 3> shares{};
    for (size_t k = 0; k < 3; ++k) {
        shares[k] = cells_.share(sites_[triangle.sites[(k + 1) % 3]].param,
                                 sites_[triangle.sites[(k + 2) % 3]].param);
    }
    Split best;
    for (size_t k = 0; k < 3; ++k) {
        const int32_t from = triangle.sites[(k + 1) % 3], to = triangle.sites[(k + 2) % 3];
        const Site &a = sites_[from], &b = sites_[to];
        const bool pole = a.point == b.point, wide = shares[k] >= narrow * *std::ranges::max_element(shares);
        const double size = !pole ? sites_.way(from, to) : wide ? infinity : 0;
        const bool can = pole || !triangle.fixed[k] || triangle.border[k] >= 0;
        if (can && size > best.size) {
            best = {size, {(a.param[0] + b.param[0]) / 2, (a.param[1] + b.param[1]) / 2}, triangle.border[k]};
            best.share = shares[k];
        }
    }
    return best;
}

// The largest difference of unit normals at the corners. Corners without a normal do not count.
double DomainMesher::normals_apart(const SiteTriangle &triangle) const noexcept {
    double most = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double apart =
            length(sites_.normal(triangle.sites[k]) - sites_.normal(triangle.sites[(k + 1) % 3]));
        most = apart > most ? apart : most;
    }
    return most;
}

// By the bound of its cell; 0 in the strip.
double DomainMesher::turn_over(const SiteTriangle &triangle) const {
    return triangle.cell < 0 ? 0 : turn_of(cells_.tree().box(triangle.cell), least_).both;
}

double DomainMesher::corners_off(size_t triangle) const noexcept {
    double off = 0;
    for (const int32_t site : triangles_[triangle].sites) {
        off = std::max(off, length(sites_.point(sites_[site].point) - sites_.position(site)));
    }
    return off;
}

// Whether a corner that is a point of an edge is so far from the surface that parts of the triangle would be
// as far from it as the triangle is, up to a factor.
bool DomainMesher::is_held(size_t triangle) const noexcept {
    constexpr double factor = 2;
    const double off = corners_off(triangle);
    return off > chord_ && distances(triangle).most() <= factor * off;
}

// For an angle, a triangle of a cell is divided only if the bound over the cell shows a turn: otherwise parts
// of it would do no better.
bool DomainMesher::is_to_divide(size_t triangle) const {
    if (is_large(triangle)) {
        return is_long(triangle) || !is_held(triangle);
    }
    const SiteTriangle own = triangles_[triangle];
    return is_turned(own) && (own.cell < 0 ? round_ < most_angle_rounds
                                           : turn_of(cells_.tree().box(own.cell), least_).both > angle_ / 2);
}

// Sides that are no longer than this are not divided.
double DomainMesher::least_split(size_t triangle) const noexcept {
    return !is_large(triangle) ? grid_.unscaled(least_)
           : longest_ > 0      ? std::min(chord_, longest_) / 4
                               : chord_ / 4;
}

// Corners may be near each other where the surface between them is not. So the length of a side does not
// count while the triangle is too large and its distance is finite and not due to its corners.
bool DomainMesher::is_tiny(size_t triangle, const Split &split) const noexcept {
    const bool known =
        is_large(triangle) && distances(triangle).most() < infinity && !(corners_off(triangle) > chord_);
    return split.share <= least_share || (!known && split.size <= least_split(triangle) &&
                                          (split.border < 0 || split.share <= least_unknown));
}

bool DomainMesher::can_cut(int32_t cell) const noexcept {
    const Rectangle part = cells_.tree().rectangle(cells_.tree().cells()[static_cast<size_t>(cell)]);
    return cells_.share(part.lower, part.upper) > least_share;
}

// The deviation over a segment falls with the square of its length, the turn of normals with its length.
int DomainMesher::parts_for(size_t triangle) const noexcept {
    constexpr double most = 8;
    const double turn = angle_ > 0 ? normals_apart(triangles_[triangle]) / most_apart_ : 0;
    const double parts = std::ceil(std::max(turn, std::sqrt(distances(triangle).most() / chord_)));
    return static_cast<int>(parts >= 2 ? std::min(parts, most) : 2);
}

void DomainMesher::add_weak(int32_t segment, int parts) {
    int &own = weak_.try_emplace(segment, 2).first->second;
    own = std::max(own, parts);
}

// Once the work has ended, no segment is weak any more: then the border changes only so that there is a mesh
// at all.
bool DomainMesher::change_border() {
    if (!domain_.change_border) {
        return false;
    }
    BorderWish wish;
    if (changes_ < most_changes) {
        wish.crossed = crossed_;
        wish.united = united_;
        wish.touched = touched_;
    }
    wish.weak.assign(weak_.begin(), weak_.end());
    const bool crosses = !(wish.crossed.empty() && wish.united.empty() && wish.touched.empty());
    const bool wanted = crosses || !wish.weak.empty();
    changes_ += crosses || (wanted && angle_ > 0) ? 1 : 0;
    return wanted && domain_.change_border(wish);
}

bool DomainMesher::take_border() {
    index_.emplace(domain_.border);
    proof_.take_border();
    leave_border();
    known_points_ = static_cast<int32_t>(domain_.points->size());
    round_ = 0;
    return united_.empty() && sites_.take_border();
}

// New segments follow their curves and run a little beside the old ones: cells that they enter are no longer
// inside.
void DomainMesher::leave_border() {
    const FaceBorder &border = domain_.border;
    const auto point = [&](int32_t i) { return border.points[static_cast<size_t>(i)]; };
    for (const BorderSegment &segment : border.segments) {
        const BorderPoint a = point(segment.from), b = point(segment.to);
        if (std::max(a.point, b.point) < known_points_) {
            continue;
        }
        const Rectangle around{{std::min(a.param[0], b.param[0]), std::min(a.param[1], b.param[1])},
                               {std::max(a.param[0], b.param[0]), std::max(a.param[1], b.param[1])}};
        std::vector<int32_t> entered;
        cells_.tree().for_each_in(around, [&](int32_t number) {
            const Cell &cell = cells_.tree().cells()[static_cast<size_t>(number)];
            if (cell.side == Side::inside && index_->any_in(cells_.tree().rectangle(cell))) {
                entered.push_back(number);
            }
        });
        cells_.leave_to_border(entered);
    }
}

// Gives a cell a vertex in its middle where that may suffice: unlike a cut, it puts no place on the border of
// the cell, so that its neighbours stay as they are. Returns whether it does.
bool DomainMesher::centre(int32_t cell) {
    CellState &state = states_[static_cast<size_t>(cell)];
    const auto may_do = [this](size_t i) {
        return !is_long(i) && !is_turned(triangles_[i]) && !is_at_point(triangles_[i]) &&
               distances(i).most() <= most_centred * chord_;
    };
    bool result = !state.centred;
    for (int32_t i = 0; result && i < state.triangles.count; ++i) {
        result = may_do(static_cast<size_t>(state.triangles.first + i));
    }
    if (result) {
        state.centred = true;
        state.places = 0;
    }
    return result;
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

// Adds a place; on a seam, on both sides of it.
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

// Adds a place in a triangle, or asks for parts of its segments of the border. Returns the size of the split
// if a place was added, else 0.
double DomainMesher::divide_in_strip(size_t triangle, std::vector<std::array<double, 2>> &places) {
    const Split split = split_of(triangles_[triangle]);
    if (is_tiny(triangle, split)) {
        return 0;
    }
    if (split.border < 0 && !extra_.contains(split.place)) {
        add_place(split.place, places);
        return split.size;
    }
    if (is_large(triangle) || changes_ < most_changes) { // also if the place fell on the border
        for (const int32_t segment : triangles_[triangle].border) {
            if (segment >= 0 && (split.border < 0 || segment == split.border)) {
                add_weak(segment, parts_for(triangle));
            }
        }
    }
    return 0;
}

// A new place may leave the triangles beside it over the chord, so that along a strip each round would come
// no farther than the next triangle. So triangles of about the same size around divided ones are divided as
// well, in twice as many rings each round. Where triangles become smaller from round to round there are no
// such neighbours.
void DomainMesher::divide_beside(std::vector<std::pair<size_t, double>> front,
                                 std::vector<std::array<double, 2>> &places) {
    std::vector<double> sizes(static_cast<size_t>(sites_.point_count())); // the largest split at each point
    std::vector<bool> done(triangles_.size());
    const int rings = round_ - slow_rounds < 6 ? 1 << (round_ - slow_rounds) : most_rings;
    for (int ring = 0; ring < rings && !front.empty(); ++ring) {
        for (const auto &[i, size] : front) {
            done[i] = true;
            for (const int32_t point : points_of(triangles_[i])) {
                double &own = sizes[static_cast<size_t>(point)];
                own = std::max(own, size);
            }
        }
        front = beside(sizes, done);
        for (const auto &[i, size] : front) {
            add_place(split_of(triangles_[i]).place, places);
        }
    }
}

// Further triangles of the strip that are about as large as the largest divided one at their corners, with
// the size of that.
std::vector<std::pair<size_t, double>> DomainMesher::beside(const std::vector<double> &sizes,
                                                            const std::vector<bool> &done) const {
    std::vector<std::pair<size_t, double>> result;
    for (size_t i = triangles_.strip(); i < triangles_.size(); ++i) {
        double size = 0;
        for (const int32_t point : points_of(triangles_[i])) {
            size = std::max(size, sizes[static_cast<size_t>(point)]);
        }
        if (size == 0 || done[i]) {
            continue;
        }
        const Split split = split_of(triangles_[i]);
        if (split.border < 0 && split.size >= least_size * size && split.size <= most_size * size &&
            !extra_.contains(split.place) && !is_tiny(i, split)) {
            result.emplace_back(i, size);
        }
    }
    return result;
}

// Returns whether there was anything to divide.
bool DomainMesher::divide_cells(std::vector<int32_t> cells) {
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    const bool twice = round_ >= 4; // few are left, and every round takes time: across both axes
    count_work((twice ? 8 : 4) * work_of_triangle * std::ssize(cells)); // of the parts: it may be too much
    if (cells.empty() || work_ended()) {
        return false;
    }
    std::erase_if(cells, [this](int32_t cell) { return centre(cell); });
    const auto before = static_cast<int32_t>(cells_.tree().cells().size());
    cut(cells);
    if (twice) {
        for (auto cell = before; cell < static_cast<int32_t>(cells_.tree().cells().size()); ++cell) {
            cells.push_back(cell);
        }
        cut(cells);
    }
    return true;
}

// Divides cells and triangles of the strip that are over a limit. Returns whether anything is new.
bool DomainMesher::improve() {
    std::vector<int32_t> cells;
    std::vector<std::array<double, 2>> places;
    std::vector<std::pair<size_t, double>> divided;
    for (size_t i = 0; i < triangles_.size(); ++i) {
        is_off_ = is_off_ || (triangles_.has(i) && is_large(i) && corners_off(i) > chord_);
        if (!triangles_.has(i) || !is_to_divide(i)) {
            continue;
        }
        if (const int32_t cell = triangles_[i].cell; cell < 0) {
            if (const double size = divide_in_strip(i, places); size > 0) {
                divided.emplace_back(i, size);
            }
        } else if (distances(i).from_shape < infinity && can_cut(cell)) {
            cells.push_back(cell); // those without any bound are as small as is sensible
        }
    }
    if (round_ >= slow_rounds && !divided.empty()) {
        divide_beside(std::move(divided), places);
    }
    const size_t known = extra_.size();
    extra_.insert(places.begin(), places.end());
    const bool more = divide_cells(std::move(cells));
    return more || extra_.size() > known;
}

} // namespace nrb::mesh
