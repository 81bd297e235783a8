// SPDX-License-Identifier: MIT
// Proofs of regions over the domain of either surface: what cannot be proven over one often can over the
// other.
#pragma once

#include "intersect/surfaces/overlap/overlap_proof.h"

#include <memory>

namespace nrb::intersect {

class OverlapProofs {
public:
    // See OverlapProof.
    OverlapProofs(const OverlapGround &ground, const OverlapEdges &edges, const OverlapRegions &regions,
                  double near);
    ~OverlapProofs();
    OverlapProofs(const OverlapProofs &) = delete;
    OverlapProofs &operator=(const OverlapProofs &) = delete;

    // Whether all that is on the left of edges is proven, over one of both domains.
    [[nodiscard]] bool prove();
    // Removes from `found` what is in regions. Precondition: prove() returned true.
    void take_out_of(CrossParts &found);

private:
    struct Exchanged;
    [[nodiscard]] bool is_proven(bool exchange);
    bool prove_exchanged();
    static void take_out_of(CrossParts &found, OverlapProof &proof, bool exchange);

    const OverlapGround &ground_;
    const OverlapEdges &edges_;
    double near_;
    // Whether the proof over the second surface is tried first: over the one of lower degree, foot maps are
    // nearer to polynomials.
    bool exchanged_first_;
    OverlapProof proof_;
    std::unique_ptr<Exchanged> exchanged_;
    std::array<std::optional<bool>, 2> proven_{}; // [exchange]: the result of each; none: it was not tried
};

} // namespace nrb::intersect
