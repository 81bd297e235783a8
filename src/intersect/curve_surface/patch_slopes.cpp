// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/patch_slopes.h"

#include "base/watch.h"

namespace nrb::intersect {

// The derivative at the start of a rational curve is n (w_1 / w_0) (P_1 - P_0), and accordingly at its end.
PatchSlopes::PatchSlopes(const pieces::BezierPiece &piece) : piece_(&piece) {
    count_work(64);
    const int degrees[] = {piece.degree(0), piece.degree(1)};
    for (size_t k = 0; k < 2; ++k) {
        double *out = corners_[k].data();
        for (int i = 0; i < 4 && degrees[k] > 0; ++i) {
            const int ends[] = {i / 2, i % 2};
            const int64_t here = int64_t{ends[0] * degrees[0]} * (degrees[1] + 1) + ends[1] * degrees[1],
                          step = (ends[k] == 0 ? 1 : -1) * (k == 0 ? degrees[1] + 1 : 1), next = here + step;
            const double factor =
                (ends[k] == 0 ? 1 : -1) * degrees[k] * (piece.weight(next) / piece.weight(here));
            for (int c = 0; c < 3; ++c) {
                out[3 * i + c] = factor * (piece.point(next)[c] - piece.point(here)[c]);
                out[12 + c] += out[3 * i + c] / 4;
            }
        }
    }
}

const pieces::Slopes &PatchSlopes::along(int axis) {
    std::optional<pieces::Slopes> &slopes = along_[static_cast<size_t>(axis)];
    if (!slopes) {
        slopes.emplace(*piece_, axis);
    }
    return *slopes;
}

} // namespace nrb::intersect
