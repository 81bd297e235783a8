// SPDX-License-Identifier: MIT
#include "mesh/domain/part_proof.h"

#include <algorithm>
#include <numeric>

namespace nrb::mesh {

PartProof::PartProof(TriangleProof &proof, size_t points, std::span<const MeshTriangle> triangles,
                     std::span<const int32_t> wanted, TriangleOf triangle_of)
    : proof_(proof), all_(triangles), fans_(points, triangles, wanted), triangle_of_(std::move(triangle_of)),
      own_points_(points, -1), own_triangles_(triangles.size(), -1) {}

int32_t PartProof::local_point(int32_t point) {
    int32_t &own = own_points_[static_cast<size_t>(point)];
    if (own < 0) {
        own = static_cast<int32_t>(points_.size());
        points_.push_back(point);
    }
    return own;
}

void PartProof::add_triangle(int32_t triangle) {
    int32_t &own = own_triangles_[static_cast<size_t>(triangle)];
    if (own >= 0) {
        return;
    }
    own = static_cast<int32_t>(triangles_.size());
    triangles_.push_back(triangle);
    MeshTriangle meshed = all_[static_cast<size_t>(triangle)];
    for (int32_t &point : meshed.points) {
        point = local_point(point);
    }
    meshed_.push_back(meshed);
}

// Collects the part: the wanted triangles first, in their order, then those around them.
void PartProof::gather(std::span<const int32_t> wanted) {
    for (const int32_t point : points_) {
        own_points_[static_cast<size_t>(point)] = -1;
    }
    for (const int32_t triangle : triangles_) {
        own_triangles_[static_cast<size_t>(triangle)] = -1;
    }
    points_.clear();
    triangles_.clear();
    meshed_.clear();
    std::ranges::for_each(wanted, [&](int32_t triangle) { add_triangle(triangle); });
    for (size_t i = 0, count = points_.size(); i < count; ++i) {
        std::ranges::for_each(fans_.of(points_[i]), [&](int32_t triangle) { add_triangle(triangle); });
    }
}

void PartProof::bound() {
    bounds_.resize(triangles_.size());
    offs_.resize(triangles_.size());
    for (size_t i = 0; i < triangles_.size(); ++i) {
        const ProvenTriangle proven = proof_.of(triangle_of_(static_cast<size_t>(triangles_[i])));
        bounds_[i] = proven.bound;
        offs_[i] = {proven.moved, proven.over};
    }
}

void PartProof::Off::add(const Off &other) noexcept {
    moved = std::max(moved, other.moved);
    over = std::max(over, other.over);
}

// At each point, the maximum over the triangles around it: the neighbours of a triangle count like itself.
void PartProof::set_offs() {
    point_offs_.assign(points_.size(), {});
    for (size_t i = 0; i < triangles_.size(); ++i) {
        for (const int32_t point : meshed_[i].points) {
            point_offs_[static_cast<size_t>(point)].add(offs_[i]);
        }
    }
}

// The face may end before the surface over its triangles does, or go on beyond it. The region between counts
// either by itself, as the `edge` of the bounds, or on top of everything, as part of `over`; the smaller
// result is taken.
void PartProof::prove(std::span<const int32_t> wanted, double enough, double allowed,
                      std::vector<Distances> &out) {
    gather(wanted);
    bound();
    set_offs();
    std::vector<int32_t> own(wanted.size()); // the first ones of the part
    std::iota(own.begin(), own.end(), 0);
    MeshBound mesh(points_.size(), meshed_, bounds_, own);
    out.resize(wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) {
        Off around;
        for (const int32_t point : meshed_[i].points) {
            around.add(point_offs_[static_cast<size_t>(point)]);
        }
        const auto off = [](double distance, double edge, const Off &by) {
            return std::min(std::max(distance, edge) + by.moved, distance + by.over);
        };
        const TriangleBound &alone = bounds_[i];
        const Distances all = mesh.distances(i, enough - around.over, allowed - around.over);
        const double about = around.over > around.moved ? mesh.edge_about(i, all.from_mesh) : 0;
        out[i] = {
            std::min(off(alone.from_shape(), alone.edge, offs_[i]), off(all.from_shape, alone.edge, around)),
            std::min(off(alone.from_mesh(), alone.edge, offs_[i]), off(all.from_mesh, about, around))};
    }
}

} // namespace nrb::mesh
