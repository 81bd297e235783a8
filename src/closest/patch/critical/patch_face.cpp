// SPDX-License-Identifier: MIT
#include "closest/patch/critical/patch_face.h"

#include <algorithm>

namespace nrb::closest {

namespace {

// Whether a piece has points on the face that are in the range of the query.
bool touches(const PieceGrid &pieces, const Query &query, const PatchFace &face, int64_t piece) noexcept {
    const PieceGrid::Index index = pieces.index(piece);
    std::array<int, max_axes> side{};
    side.fill(-1);
    for (int k = 0; k < pieces.shape().axes; ++k) {
        side[static_cast<size_t>(pieces.spline_axis(k))] = face.side[static_cast<size_t>(k)];
    }
    for (int axis = 0; axis < pieces.spline_axes(); ++axis) {
        const auto at = static_cast<size_t>(axis);
        const double first = pieces.break_at(axis, index[at]), last = pieces.break_at(axis, index[at] + 1);
        const Interval whole{pieces.break_at(axis, 0), pieces.break_at(axis, pieces.count(axis))};
        const Interval range = query.range != nullptr ? query.range[axis] : whole;
        const bool holds_side = side[at] < 0 || (side[at] == 0 ? first <= range.lower : last >= range.upper);
        if (!(first < range.upper && last > range.lower) || !holds_side) {
            return false;
        }
    }
    return true;
}

} // namespace

AxisValues PatchFace::in_piece(const AxisValues &at) const noexcept {
    AxisValues result{};
    for (size_t k = 0; k < side.size(); ++k) {
        result[k] = std::max(0, side[k]);
    }
    for (int k = 0; k < shape.axes; ++k) {
        result[shape_axis(k)] = at[static_cast<size_t>(k)];
    }
    return result;
}

int face_count(const PatchShape &shape) noexcept {
    int count = 1;
    for (int k = 0; k < shape.axes; ++k) {
        count *= 3;
    }
    return count;
}

PatchFace face_of(const PatchShape &shape, int code) noexcept {
    PatchFace face;
    face.shape = shape;
    face.shape.axes = 0;
    for (int k = 0; k < shape.axes; ++k, code /= 3) {
        const auto at = static_cast<size_t>(k);
        face.side[at] = code % 3 - 1;
        if (face.side[at] < 0) {
            face.axis[static_cast<size_t>(face.shape.axes)] = k;
            face.shape.degrees[static_cast<size_t>(face.shape.axes++)] = shape.degree(k);
        }
    }
    return face;
}

bool is_boundary(const PieceGrid &pieces, const Query &query, const PatchFace &face) noexcept {
    for (int k = 0; k < pieces.shape().axes; ++k) {
        const bool seam = pieces.periodic(pieces.spline_axis(k)) && query.range == nullptr;
        if (face.side[static_cast<size_t>(k)] >= 0 && seam) {
            return false;
        }
    }
    return true;
}

std::vector<int64_t> pieces_at(const PieceGrid &pieces, const Query &query, const PatchFace &face) {
    std::vector<int64_t> result;
    for (int64_t piece = 0; piece < pieces.count(); ++piece) {
        if (touches(pieces, query, face, piece)) {
            result.push_back(piece);
        }
    }
    return result;
}

void copy_face(const PatchShape &shape, const PatchFace &face, const double *patch, double *out) noexcept {
    for (int64_t i = 0; i < shape.coefficients(); ++i) {
        bool on_face = true;
        int64_t rest = i;
        for (int k = shape.axes; k-- > 0; rest /= shape.degree(k) + 1) {
            const int side = face.side[static_cast<size_t>(k)];
            const auto place = static_cast<int>(rest % (shape.degree(k) + 1));
            on_face = on_face && (side < 0 || place == (side == 0 ? 0 : shape.degree(k)));
        }
        if (on_face) {
            out = std::copy_n(patch + i * shape.lanes, shape.lanes, out);
        }
    }
}

} // namespace nrb::closest
