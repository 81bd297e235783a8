// SPDX-License-Identifier: MIT
// Lines of a domain at which a surface closes up or may have a kink: what is near them counts as on them.
#pragma once

#include "face/face.h"

#include <array>
#include <vector>

namespace nrb::mesh {

class SnapLines {
public:
    explicit SnapLines(const face::Face &face);

    // About the tolerance of the face, along an axis.
    [[nodiscard]] double near(size_t k) const noexcept { return near_[k]; }
    // Inside the domain, rising.
    [[nodiscard]] const std::vector<double> &inner(size_t k) const noexcept { return inner_[k]; }
    // Whether two pieces, one after the other, pass a line at which both end: a seam of the axis, or another line.
    [[nodiscard]] bool passes(size_t k, const face::TrimPiece &before, const face::TrimPiece &after) const noexcept;
    // A place, on all lines that it is near to.
    [[nodiscard]] face::Point2 snapped(face::Point2 x) const noexcept;
    // Whether a place is on a seam of an axis, and the same place on its other side.
    [[nodiscard]] bool on_seam(size_t k, const face::Point2 &x) const noexcept;
    [[nodiscard]] face::Point2 other_side(size_t k, face::Point2 x) const noexcept;

private:
    std::array<Interval, 2> domain_;
    std::array<bool, 2> closed_{};
    std::array<double, 2> near_{};
    std::array<std::vector<double>, 2> inner_;
};

} // namespace nrb::mesh
