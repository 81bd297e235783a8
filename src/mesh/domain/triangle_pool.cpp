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

void TrianglePool::prove(TriangleProof &proof, size_t points) {
    prove_new(proof);
    const std::vector<char> wanted = beside_touched(points);
    const MeshBound mesh(points, meshed_, bounds_, wanted);
    distances_.resize(triangles_.size());
    for (size_t i = 0; i < triangles_.size(); ++i) {
        distances_[i] = wanted[i] != 0 ? mesh.distances(i) : distances_[i];
    }
    touched_.clear();
}

} // namespace nrb::mesh
