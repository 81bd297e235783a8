// SPDX-License-Identifier: MIT
// Lines of a domain to which nearby places are snapped: the ends of the domain, where a surface may close up
// in a seam, and lines at which it may have a kink.
#pragma once

#include "face/face.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::mesh {

class SnapLines {
public:
    // `chord`: the chord error of the mesh.
    SnapLines(const face::Face &face, double chord);

    // The snapping distance along axis k for seams, and for places beyond an end of the domain, where there
    // is no surface: about the tolerance of the face.
    [[nodiscard]] double near(size_t k) const noexcept { return near_[k]; }
    // The snapping distance for all else: also limited to a part of the chord error, since moving a place in
    // the domain moves its point in space.
    [[nodiscard]] double close(size_t k) const noexcept { return close_[k]; }
    // Lines inside the domain at which the surface may have a kink, rising.
    [[nodiscard]] const std::vector<double> &inner(size_t k) const noexcept { return inner_[k]; }
    [[nodiscard]] bool closed(size_t k) const noexcept { return closed_[k]; }
    [[nodiscard]] Interval domain(size_t k) const noexcept { return domain_[k]; }
    // Moves a place to the lines that it is near.
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

// Where a loop crosses a line.
struct LinePassage {
    const face::TrimPiece *piece;
    double place;    // on the piece, from 0 to 1
    face::Point2 at; // in the domain
};

// All crossings of one loop. `loop`: its pieces in their order. A piece that only touches a line, or runs
// along it, does not cross it.
std::vector<LinePassage> passages_of(const face::Face &face, const SnapLines &lines,
                                     std::span<const face::TrimPiece> loop);

} // namespace nrb::mesh
