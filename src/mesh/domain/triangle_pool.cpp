// SPDX-License-Identifier: MIT
#include "mesh/domain/triangle_pool.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// Multiply-adds of a triangle, estimated.
constexpr int64_t work_of_triangle = 3000;

} // namespace

void TrianglePool::touch(size_t i) {
    touched_.insert(touched_.end(), meshed_[i].points.begin(), meshed_[i].points.end());
}

void TrianglePool::add(const SiteTriangle &triangle, const MeshTriangle &meshed) {
    triangles_.push_back(triangle);
    meshed_.push_back(meshed);
    touch(meshed_.size() - 1);
}

void TrianglePool::remove(const Range &range) {
    for (size_t i = range.first; i < range.first + range.count; ++i) {
        touch(i);
        triangles_[i].sites[0] = -1;
        meshed_[i] = {};
    }
}

void TrianglePool::drop_strip() {
    for (size_t i = strip_; i < triangles_.size(); ++i) {
        touch(i);
    }
    triangles_.resize(strip_);
    meshed_.resize(strip_);
    bounds_.resize(std::min(bounds_.size(), strip_));
    overs_.resize(std::min(overs_.size(), strip_));
}

void TrianglePool::prove_new(TriangleProof &proof) {
    bounds_.reserve(triangles_.size());
    for (size_t i = bounds_.size(); i < triangles_.size(); ++i) {
        const ProvenTriangle proven = proof.of(triangles_[i]);
        bounds_.push_back(proven.bound);
        overs_.push_back(proven.over);
        count_work(work_of_triangle);
    }
}

std::vector<char> TrianglePool::beside_touched(size_t points) const {
    std::vector<char> touched(points), result(triangles_.size());
    for (const int32_t point : touched_) {
        touched[static_cast<size_t>(point)] = 1;
    }
    for (size_t i = 0; i < triangles_.size(); ++i) {
        const auto is_touched = [&](int32_t point) { return touched[static_cast<size_t>(point)] != 0; };
        result[i] = has(i) && std::ranges::any_of(meshed_[i].points, is_touched) ? 1 : 0;
    }
    return result;
}

// Of the triangles around each point: distances are bounds for a mesh on the surface, of which the one that there is, and what it stands
// for, are so far off, those beside a triangle as well as itself.
std::vector<double> TrianglePool::overs_around(size_t points) const {
    std::vector<double> result(points);
    for (size_t i = 0; i < triangles_.size(); ++i) {
        for (size_t k = 0; k < 3 && has(i); ++k) {
            double &over = result[static_cast<size_t>(meshed_[i].points[k])];
            over = std::max(over, overs_[i]);
        }
    }
    return result;
}

void TrianglePool::prove(TriangleProof &proof, size_t points) {
    prove_new(proof);
    const std::vector<char> wanted = beside_touched(points);
    const std::vector<double> overs = overs_around(points);
    const MeshBound mesh(points, meshed_, bounds_, wanted);
    distances_.resize(triangles_.size());
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (wanted[i] == 0) {
            continue;
        }
        const Distances alone{bounds_[i].from_shape() + overs_[i], bounds_[i].from_mesh() + overs_[i]},
            all = mesh.distances(i);
        double over = 0;
        for (const int32_t point : meshed_[i].points) {
            over = std::max(over, overs[static_cast<size_t>(point)]);
        }
        distances_[i] = {std::min(alone.from_shape, all.from_shape + over),
                         std::min(alone.from_mesh, all.from_mesh + over)};
    }
    touched_.clear();
}

} // namespace nrb::mesh
