// SPDX-License-Identifier: MIT
// Lines of a domain at which a surface closes up or may have a kink: what is near them counts as on them.
#pragma once

#include "face/face.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::mesh {

class SnapLines {
public:
    // For meshes within a distance.
    SnapLines(const face::Face &face, double chord);

    // About the tolerance of the face, along an axis: for seams, and ends beyond which there is no surface.
    [[nodiscard]] double near(size_t k) const noexcept { return near_[k]; }
    // For other lines: no more than a part of the distance, since what is moved in the domain is off in space.
    [[nodiscard]] double close(size_t k) const noexcept { return close_[k]; }
    // Inside the domain, rising.
    [[nodiscard]] const std::vector<double> &inner(size_t k) const noexcept { return inner_[k]; }
    [[nodiscard]] bool closed(size_t k) const noexcept { return closed_[k]; }
    [[nodiscard]] Interval domain(size_t k) const noexcept { return domain_[k]; }
    // A place, on all lines that it is near to.
    [[nodiscard]] face::Point2 snapped(face::Point2 x) const noexcept;
    // Whether a place is on a seam of an axis, and the same place on its other side.
    [[nodiscard]] bool on_seam(size_t k, const face::Point2 &x) const noexcept;
    [[nodiscard]] face::Point2 other_side(size_t k, face::Point2 x) const noexcept;

private:
    std::array<Interval, 2> domain_;
    std::array<bool, 2> closed_{};
    std::array<double, 2> near_{}, close_{};
    std::array<std::vector<double>, 2> inner_;
};

// Where pieces of a loop pass a line: a place from 0 to 1 of a piece, and of the domain.
struct LinePassage {
    const face::TrimPiece *piece;
    double place;
    face::Point2 at;
};

// Of the pieces of one loop, in their order. Those that only touch a line, or run along it, do not pass it.
std::vector<LinePassage> passages_of(const face::Face &face, const SnapLines &lines,
                                     std::span<const face::TrimPiece> loop);

} // namespace nrb::mesh
