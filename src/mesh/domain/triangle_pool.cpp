// SPDX-License-Identifier: MIT
#include "mesh/domain/triangle_pool.h"

#include "base/watch.h"
#include "mesh/domain/part_proof.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Triangles whose bounds are in memory at once.
constexpr size_t triangles_of_a_part = 4096;
// Of fewer triangles, all distances are bounded as tightly as possible: that takes next to no time.
constexpr size_t least_to_hurry = 1024;
// Of up to so many triangles, bounds are kept from round to round.
constexpr size_t most_kept = 10000;

float rounded_up(double x) noexcept {
    const auto near = static_cast<float>(x);
    return static_cast<double>(near) >= x ? near
                                          : std::nextafter(near, std::numeric_limits<float>::infinity());
}

} // namespace

void TrianglePool::make_room(size_t count) {
    sites_.reserve(sites_.size() + count);
    meshed_.reserve(meshed_.size() + count);
}

SiteTriangle TrianglePool::operator[](size_t i) const noexcept {
    SiteTriangle result{sites_[i].sites, sites_[i].cell};
    if (i >= strip_) {
        result.border = borders_[i - strip_].border;
        result.fixed = borders_[i - strip_].fixed;
    }
    return result;
}

void TrianglePool::touch(size_t i) {
    for (const int32_t point : meshed_[i].points) {
        const auto at = static_cast<size_t>(point);
        if (at >= touched_.size()) {
            touched_.resize(std::max(at + 1, touched_.size() + touched_.size() / 2));
        }
        touched_[at] = 1;
    }
}

void TrianglePool::add(const SiteTriangle &triangle, const MeshTriangle &meshed) {
    sites_.push_back({triangle.sites, triangle.cell});
    meshed_.push_back(meshed);
    if (triangle.cell < 0) {
        borders_.push_back({triangle.border, triangle.fixed});
    }
    touch(meshed_.size() - 1);
}

void TrianglePool::remove(const Range &range) {
    const auto first = static_cast<size_t>(range.first);
    for (size_t i = first; i < first + static_cast<size_t>(range.count); ++i) {
        touch(i);
        sites_[i].sites[0] = -1;
        meshed_[i] = {};
    }
}

void TrianglePool::drop_strip() {
    for (size_t i = strip_; i < sites_.size(); ++i) {
        touch(i);
    }
    sites_.resize(strip_);
    meshed_.resize(strip_);
    borders_.clear();
}

std::vector<int32_t> TrianglePool::beside_touched(size_t points) {
    touched_.resize(points);
    std::vector<int32_t> result;
    for (size_t i = 0; i < sites_.size(); ++i) {
        const auto is_touched = [&](int32_t point) { return touched_[static_cast<size_t>(point)] != 0; };
        if (has(i) && std::ranges::any_of(meshed_[i].points, is_touched)) {
            result.push_back(static_cast<int32_t>(i));
        }
    }
    touched_.assign(points, 0);
    return result;
}

void TrianglePool::prove(TriangleProof &proof, size_t points, double enough, double allowed) {
    proof.keep(meshed_.size() <= most_kept);
    const std::vector<int32_t> wanted = beside_touched(points);
    distances_.reserve(sites_.size());
    distances_.resize(sites_.size());
    PartProof parts(proof, points, meshed_, wanted, [this](size_t i) { return (*this)[i]; });
    std::vector<Distances> found;
    // From the last one on: the boxes of the cells that were made last are still kept.
    for (auto rest = std::span(std::as_const(wanted)); !rest.empty();) {
        const auto part = rest.last(std::min(triangles_of_a_part, rest.size()));
        rest = rest.first(rest.size() - part.size());
        parts.prove(part, wanted.size() < least_to_hurry ? 0 : enough, allowed, found);
        for (size_t i = 0; i < part.size(); ++i) {
            distances_[static_cast<size_t>(part[i])] = {rounded_up(found[i].from_shape),
                                                        rounded_up(found[i].from_mesh)};
        }
        count_work(work_of_triangle * std::ssize(part));
    }
}

} // namespace nrb::mesh
