// SPDX-License-Identifier: MIT
// Proofs of regions from either surface: what cannot be told along one of them often can along the other one.
#pragma once

#include "intersect/surfaces/overlap/overlap_proof.h"

#include <memory>

namespace nrb::intersect {

class OverlapProofs {
public:
    // As for OverlapProof.
    OverlapProofs(const OverlapGround &ground, const OverlapEdges &edges, const OverlapRegions &regions,
                  double near);
    ~OverlapProofs();
    OverlapProofs(const OverlapProofs &) = delete;
    OverlapProofs &operator=(const OverlapProofs &) = delete;

    // Of all that is on the left of edges, from one of the surfaces.
    [[nodiscard]] bool prove();
    // What is in regions. Precondition: they are proven.
    void take_out_of(CrossParts &found);

private:
    struct Exchanged;
    [[nodiscard]] bool is_proven(bool exchange);
    bool prove_exchanged();
    static void take_out_of(CrossParts &found, OverlapProof &proof, bool exchange);

    const OverlapGround &ground_;
    const OverlapEdges &edges_;
    double near_;
    // Over a surface of lower degree places are nearer to polynomials.
    bool exchanged_first_;
    OverlapProof proof_;
    std::unique_ptr<Exchanged> exchanged_;
    std::array<std::optional<bool>, 2> proven_{}; // by each; none: it was not tried
};

} // namespace nrb::intersect
