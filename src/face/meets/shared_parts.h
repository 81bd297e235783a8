// SPDX-License-Identifier: MIT
// What a face has inside of regions that its surface shares with another one.
#pragma once

#include "face/arrange/inside_parts.h"
#include "face/meets/shared_curve.h"

#include <optional>
#include <vector>

namespace nrb::face {

// In the domain of one of two surfaces that are one: loops of a face of it, and of regions.
class SharedParts {
public:
    // Loops have regions to their left in the domain of surface k. Throws Status::gap for a face with gaps, not_converged where
    // regions lie on each other, or rounding would have to decide what is inside.
    SharedParts(const SharedGrounds &grounds, size_t k, const Face &face, std::vector<SharedLoops> regions);

    // What is in both, each part in one piece, with loops that have it to their left.
    [[nodiscard]] std::vector<SharedLoops> parts() const;
    // Where curves of both run along each other, and there is nothing that is in both beside; as those of the face.
    [[nodiscard]] std::vector<SharedCurve> edges() const;
    // The parts as faces of surface k. Throws what check_area() does.
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
    std::vector<std::optional<Source>> sources_; // of the loops
    std::optional<Arrangement> arrangement_;
    std::optional<InsideParts> inside_;
};

} // namespace nrb::face
