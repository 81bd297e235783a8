// SPDX-License-Identifier: MIT
// The faces of a domain, or of the range of a query: its interior, sides, edges and corners.
#pragma once

#include "closest/foot.h"
#include "closest/patch/patch_names.h"

#include <vector>

namespace nrb::closest {

// A face of the parameter box. side[k] is 0 or 1 if the face lies at that end of axis k of the shape, and -1
// if it extends along the whole axis.
struct PatchFace {
    std::array<int, max_axes> side{};
    std::array<int, max_axes> axis{}; // axis of the shape for each axis of the face
    PatchShape shape;                 // of the face

    [[nodiscard]] size_t shape_axis(int k) const noexcept {
        return static_cast<size_t>(axis[static_cast<size_t>(k)]);
    }
    // The place in the piece for a place on the face; `at` is along the axes of the face.
    [[nodiscard]] AxisValues in_piece(const AxisValues &at) const noexcept;
};

// 3^axes.
int face_count(const PatchShape &shape) noexcept;
// The face with side k = (digit k of `code` to the base 3) - 1.
PatchFace face_of(const PatchShape &shape, int code) noexcept;
// False for a side at which a periodic spline continues.
bool is_boundary(const PieceGrid &pieces, const Query &query, const PatchFace &face) noexcept;
// The pieces that have points on the face within the range of the query.
std::vector<int64_t> pieces_at(const PieceGrid &pieces, const Query &query, const PatchFace &face);
// Copies the coefficients of a patch of this shape that belong to the face.
void copy_face(const PatchShape &shape, const PatchFace &face, const double *patch, double *out) noexcept;

} // namespace nrb::closest
