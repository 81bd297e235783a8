// SPDX-License-Identifier: MIT
#include "mesh/domain/domain_mesher.h"
#include "mesh/domain/dropped_triangles.h"

#include <algorithm>

namespace nrb::mesh {

// Whether the mesh has no gaps: each side of a triangle is at the border or belongs to two triangles, and no
// two triangles have a side in the same direction.
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

// Whether a triangle and the next one make up a cell, with no places on its border but its corners.
bool DomainMesher::is_pair(size_t triangle) const noexcept {
    const int32_t cell = triangles_[triangle].cell;
    const CellState none, &state = cell < 0 ? none : states_[static_cast<size_t>(cell)];
    return state.places == 4 && state.triangles.count == 2 &&
           state.triangles.first == static_cast<int32_t>(triangle) && !is_at_point(triangles_[triangle]) &&
           !is_at_point(triangles_[triangle + 1]);
}

std::vector<std::array<int32_t, 3>> DomainMesher::all_points() const {
    std::vector<std::array<int32_t, 3>> all;
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (triangles_.has(i)) {
            all.push_back(triangles_.meshed(i).points);
        }
    }
    return all;
}

// Collects the distances and the pairs of all triangles. Returns whether all triangles are within the limits
// that they are made for.
bool DomainMesher::judge(DomainMesh &result) const {
    bool over = false;
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (!triangles_.has(i)) {
            continue;
        }
        const Distances d = distances(i);
        result.from_shape = std::max(result.from_shape, d.from_shape);
        result.from_mesh = std::max(result.from_mesh, d.from_mesh);
        over = over || is_over(i);
        if (!is_at_point(triangles_[i])) {
            result.paired.push_back(is_pair(i));
        }
    }
    return !over;
}

// Leaves out sites and points that no triangle has, and degenerate triangles, which have two corners at one
// point. Returns whether there are degenerate ones.
bool DomainMesher::add_triangles(DomainMesh &result) const {
    std::vector<int32_t> sites(sites_.all().size(), -1),
        points(static_cast<size_t>(sites_.point_count()), -1);
    const auto vertex = [&](int32_t site) {
        int32_t &own = sites[static_cast<size_t>(site)];
        if (own < 0) {
            own = static_cast<int32_t>(result.vertices.size());
            int32_t point = sites_.border_of(sites_[site].point);
            if (point < 0) {
                int32_t &number = points[static_cast<size_t>(sites_[site].point)];
                if (number < 0) {
                    number = static_cast<int32_t>(result.points.size());
                    result.points.push_back(sites_.point(sites_[site].point));
                }
                point = -1 - number;
            }
            result.vertices.push_back({point, sites_[site].param, sites_.normal(site)});
        }
        return own;
    };
    result.points.reserve(static_cast<size_t>(sites_.point_count()));
    result.vertices.reserve(sites_.all().size());
    result.triangles.reserve(result.paired.size());
    bool drops = false;
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (!triangles_.has(i)) {
            continue;
        }
        const SiteTriangle triangle = triangles_[i];
        if (is_at_point(triangle)) {
            drops = true;
            continue;
        }
        const auto &s = triangle.sites;
        result.triangles.push_back({vertex(s[0]), vertex(s[1]), vertex(s[2])});
    }
    return drops;
}

// The distance from the shape is infinite where parts of the face may be missing.
void DomainMesher::finish(bool good, DomainMesh &result) const {
    const bool drops = add_triangles(result);
    const bool whole = crossed_.empty() && !result.triangles.empty() &&
                       (!drops || have_all_dropped(all_points())) && is_whole();
    const bool as_asked = chord_ <= rule_.chord && longest_ <= rule_.longest && angle_ <= rule_.angle;
    result.reached = whole && good && as_asked && !has_small_angles_;
    result.from_shape = whole ? result.from_shape : infinity;
}

DomainMesh DomainMesher::output(bool last) {
    if (before_angles_) {
        return std::move(*before_angles_);
    }
    DomainMesh result;
    const bool good = judge(result);
    if (last) { // the result takes as much memory
        std::vector<CellState>().swap(states_);
        cells_.clear();
    }
    finish(good, result);
    return result;
}

} // namespace nrb::mesh
