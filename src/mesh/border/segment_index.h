// SPDX-License-Identifier: MIT
// A spatial index of the segments of the border of a face.
#pragma once

#include "mesh/border/face_border.h"
#include "mesh/proof/triangle_bound.h"

#include <vector>

namespace nrb::mesh {

// A uniform grid of buckets over the bounding box of the segments.
class SegmentIndex {
public:
    explicit SegmentIndex(const FaceBorder &border);

    // Whether a segment meets a rectangle, up to rounding.
    [[nodiscard]] bool any_in(const Rectangle &part) const noexcept;

private:
    [[nodiscard]] size_t column(size_t k, double x) const noexcept;
    [[nodiscard]] bool meets(int32_t number, const Rectangle &part) const noexcept;

    const FaceBorder &border_;
    Rectangle box_;
    size_t columns_ = 1;
    std::vector<std::vector<int32_t>> buckets_;
};

} // namespace nrb::mesh
