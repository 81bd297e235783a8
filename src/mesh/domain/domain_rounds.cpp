// SPDX-License-Identifier: MIT
#include "mesh/domain/domain_mesher.h"

#include "mesh/cells/cell_shape.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Rounds in which the strip is divided for an angle.
constexpr int most_angle_rounds = 10;

} // namespace

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
double DomainMesher::turn_over(const SiteTriangle &triangle) const {
    return triangle.cell < 0 ? 0 : turn_of(cells_.tree().box(triangle.cell), least_).both;
}

// Whether a corner on an edge is so far from the surface that parts would be as far as the triangle is, by a factor.
bool DomainMesher::is_held(size_t triangle) const noexcept {
    constexpr double factor = 2;
    double off = 0;
    for (const int32_t site : triangles_[triangle].sites) {
        off = std::max(off, length(sites_.point(sites_[site].point) - sites_.position(site)));
    }
    return off > chord_ && distances(triangle).most() <= factor * off;
}

// Where the bound of a cell sees no turn, parts of it would not do better.
bool DomainMesher::is_to_divide(size_t triangle) const {
    if (is_large(triangle)) {
        return is_long(triangle) || !is_held(triangle);
    }
    const SiteTriangle own = triangles_[triangle];
    return is_turned(own) && (own.cell < 0 ? round_ < most_angle_rounds
                                           : turn_of(cells_.tree().box(own.cell), least_).both > angle_ / 2);
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
        const SiteTriangle triangle = triangles_[i];
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

} // namespace nrb::mesh
