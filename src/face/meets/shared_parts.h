// SPDX-License-Identifier: MIT
// The parts of a face inside of regions that its surface shares with another surface.
#pragma once

#include "face/arrange/inside_parts.h"
#include "face/meets/shared_curve.h"

#include <optional>
#include <vector>

namespace nrb::face {

// Arranges the loops of a face and of shared regions in the domain of one of two surfaces that coincide.
class SharedParts {
public:
    // Loops have the regions to their left in the domain of surface k. Throws Status::gap for a face with
    // gaps, not_converged where regions lie on each other, or rounding would have to decide what is inside.
    SharedParts(const SharedGrounds &grounds, size_t k, const Face &face, std::vector<SharedLoops> regions);

    // The connected parts of what is in the face and in a region, as loops that have it to their left. Throws
    // what check_area() throws.
    [[nodiscard]] std::vector<SharedLoops> parts() const;
    // Curves along which borders of both coincide, without anything beside them that is in both. They have
    // the direction of the loops of the face.
    [[nodiscard]] std::vector<SharedCurve> edges() const;
    // A part as a face of surface k. Throws what the constructor of a face throws.
    [[nodiscard]] static FacePtr face_of(const SharedGrounds &grounds, size_t k, const SharedLoops &loops);

private:
    void add(const Face &face, int32_t owner, size_t region);
    void add(const Run &run, SharedLoop &loop) const;
    [[nodiscard]] SharedLoop loop_of(const EdgeLoop &loop) const;

    struct Source {
        size_t region, loop;
    };
    const SharedGrounds &grounds_;
    size_t k_;
    std::vector<SharedLoops> regions_;
    std::vector<ArrangedLoop> loops_;
    std::vector<std::optional<Source>> sources_; // for each loop; none for loops of the face
    std::optional<Arrangement> arrangement_;
    std::optional<InsideParts> inside_;
};

} // namespace nrb::face
