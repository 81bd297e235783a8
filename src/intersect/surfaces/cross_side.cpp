// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_side.h"

#include "base/watch.h"

namespace nrb::intersect {

CrossSide::CrossSide(const Spline &surface, const pieces::Frame &frame, const SurfaceBorders &ends,
                     const SideShifts &shifts_of_axes)
    : ground(surface, frame, ends, shifts_of_axes), cells(surface, frame) {}

CrossCell &CrossSide::root(closest::PairCell &cell) {
    if (cell.mark == 0) {
        pieces.emplace_back(*cell.piece, ground);
        roots.push_back(&parts.emplace_back(pieces.back(), &memory));
        cell.mark = roots.size();
        count_work(work_of_a_kept_part);
    }
    return *roots[cell.mark - 1];
}

} // namespace nrb::intersect
