// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_proofs.h"

#include "base/watch.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr double share_of_first = 0.75; // of the work, for the proof that is tried first

template <class T>
std::array<T, 4> exchanged(const std::array<T, 4> &of_both) noexcept {
    return {of_both[2], of_both[3], of_both[0], of_both[1]};
}

int degrees_of(const Spline &surface) noexcept {
    return surface.axis(0).degree() + surface.axis(1).degree();
}

// Whether the normals of both surfaces have the same direction at a place of both; none: a normal is not
// known there.
std::optional<bool> are_alike(const OverlapGround &ground, const CrossPlace &at) {
    const auto a = ground.point(0, at.data()), b = ground.point(1, at.data() + 2);
    if (!a || !b) {
        return std::nullopt;
    }
    const double cosine = dot(cross(a->slope[0], a->slope[1]), cross(b->slope[0], b->slope[1]));
    return cosine == 0 ? std::nullopt : std::optional(cosine > 0);
}

// The edges with both surfaces exchanged. Those along which the normals are opposite are reversed, so that
// regions are again on the left in the domain of the first surface. None: normals are not known.
std::optional<OverlapEdges> exchanged(const OverlapGround &ground, OverlapEdges edges) {
    std::ranges::for_each(edges.nodes, [](CrossPlace &node) { node = exchanged(node); });
    std::ranges::for_each(edges.loose, [](auto &ranges) { ranges = exchanged(ranges); });
    for (OverlapEdge &edge : edges.edges) {
        const std::optional<bool> alike = are_alike(ground, edge.middle);
        if (!alike) {
            return std::nullopt;
        }
        if (!*alike) {
            std::swap(edge.nodes[0], edge.nodes[1]);
            reverse(edge.segments);
        }
        edge.middle = exchanged(edge.middle);
        for (CrossSegment &segment : edge.segments) {
            std::swap(segment.on[0], segment.on[1]);
            segment.slopes = exchanged(segment.slopes);
        }
    }
    return edges;
}

} // namespace

struct OverlapProofs::Exchanged {
    ContactSolver solver;
    OverlapGround ground;
    OverlapEdges edges;
    OverlapRegions regions;
    std::optional<OverlapProof> proof;

    Exchanged(const OverlapGround &own, OverlapEdges of_exchanged)
        : solver(own.pieces(1), own.pieces(0)), ground(own.spline(1), own.spline(0), own.frame(), solver),
          edges(std::move(of_exchanged)) {}
    bool prove(double near) {
        std::optional<OverlapRegions> found = overlap_regions(ground, edges);
        if (!found) {
            return false;
        }
        regions = std::move(*found);
        proof.emplace(ground, edges, regions, near);
        return proof->prove();
    }
};

OverlapProofs::OverlapProofs(const OverlapGround &ground, const OverlapEdges &edges,
                             const OverlapRegions &regions, double near)
    : ground_(ground), edges_(edges), near_(near),
      exchanged_first_(degrees_of(ground.spline(0)) < degrees_of(ground.spline(1))),
      proof_(ground, edges, regions, near) {}

OverlapProofs::~OverlapProofs() = default;

bool OverlapProofs::prove_exchanged() {
    if (std::optional<OverlapEdges> edges = exchanged(ground_, edges_)) {
        exchanged_ = std::make_unique<Exchanged>(ground_, std::move(*edges));
        return exchanged_->prove(near_);
    }
    return false;
}

bool OverlapProofs::is_proven(bool exchange) {
    if (!proven_[exchange]) {
        proven_[exchange] = exchange ? prove_exchanged() : proof_.prove();
    }
    return *proven_[exchange];
}

bool OverlapProofs::prove() {
    {
        const PartOfWork most(share_of_first);
        if (is_proven(exchanged_first_)) {
            return true;
        }
    }
    return is_proven(!exchanged_first_);
}

void OverlapProofs::take_out_of(CrossParts &found, OverlapProof &proof, bool exchange) {
    const auto of_proof = [exchange](const std::array<Interval, 4> &ranges) {
        return exchange ? exchanged(ranges) : ranges;
    };
    std::erase_if(found.clusters,
                  [&](const CrossCluster &cluster) { return proof.covers(of_proof(cluster.ranges)); });
    std::erase_if(found.contacts,
                  [&](const CrossContact &contact) { return proof.is_along(of_proof(contact.ranges)); });
    std::erase_if(found.arcs,
                  [&](const CrossArc &arc) { return proof.is_along(of_proof(ranges_of(arc.box))); });
}

void OverlapProofs::take_out_of(CrossParts &found) {
    for (const bool exchange : {exchanged_first_, !exchanged_first_}) {
        const bool known = proven_[exchange].value_or(!found.clusters.empty());
        if (known && is_proven(exchange)) {
            take_out_of(found, exchange ? *exchanged_->proof : proof_, exchange);
        }
    }
}

} // namespace nrb::intersect
