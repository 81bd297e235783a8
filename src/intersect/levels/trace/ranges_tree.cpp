// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/ranges_tree.h"

namespace nrb::intersect {

RangesTree::RangesTree(const SurfaceBorders &a, const SurfaceBorders &b, const std::vector<Ranges> &ranges) {
    for (size_t i = 0; i < 3; ++i) {
        const SurfaceBorders &borders = i < 2 ? a : b;
        turns_[i] = borders.wraps(i % 2) ? 1 : 0;
        periods_[i] = borders.wraps(i % 2) ? borders.period(i % 2) : 0;
    }
    std::vector<Box3> boxes;
    boxes.reserve(ranges.size());
    for (const Ranges &own : ranges) {
        boxes.push_back(box_of(own, {}));
    }
    count_work(100 * std::ssize(boxes));
    tree_ = BoxTree(boxes);
}

Box3 RangesTree::box_of(const Ranges &ranges, const std::array<int, 3> &turns) const noexcept {
    Box3 box;
    for (size_t i = 0; i < 3; ++i) {
        box.lower[i] = ranges[i].lower + turns[i] * periods_[i];
        box.upper[i] = ranges[i].upper + turns[i] * periods_[i];
    }
    return box;
}

} // namespace nrb::intersect
