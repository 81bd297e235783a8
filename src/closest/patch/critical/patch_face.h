// SPDX-License-Identifier: MIT
// The faces of a domain, or of the range of a query: its inside, sides, edges and corners.
#pragma once

#include "closest/foot.h"
#include "closest/patch/patch_names.h"

#include <vector>

namespace nrb::closest {

// side[k] of axis k of the shape is 0 or 1 where the face is at that end of the axis, -1 where it has all of
// the axis.
struct PatchFace {
    std::array<int, max_axes> side{};
    std::array<int, max_axes> axis{}; // of the shape, for each axis of the face
    PatchShape shape;                 // of the face

    [[nodiscard]] size_t shape_axis(int k) const noexcept {
        return static_cast<size_t>(axis[static_cast<size_t>(k)]);
    }
    // A place on the face as a place of the piece; `at` has the axes of the face.
    [[nodiscard]] AxisValues in_piece(const AxisValues &at) const noexcept;
};

// 3^axes.
int face_count(const PatchShape &shape) noexcept;
// The face of which side k is digit k of `code` to the base 3, less 1.
PatchFace face_of(const PatchShape &shape, int code) noexcept;
// False for sides where a periodic spline goes on.
bool is_boundary(const PieceGrid &pieces, const Query &query, const PatchFace &face) noexcept;
// The pieces that have points on the face in the range of the query.
std::vector<int64_t> pieces_at(const PieceGrid &pieces, const Query &query, const PatchFace &face);
// The coefficients on a face of a patch of this shape.
void copy_face(const PatchShape &shape, const PatchFace &face, const double *patch, double *out) noexcept;

} // namespace nrb::closest
