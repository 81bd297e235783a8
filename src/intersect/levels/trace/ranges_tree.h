// SPDX-License-Identifier: MIT
// Parts of two surfaces, found by where they are.
#pragma once

#include "base/watch.h"
#include "intersect/levels/fields/surface_borders.h"
#include "intersect/rays/box_tree.h"

#include <array>
#include <vector>

namespace nrb::intersect {

// Ranges of parameters of two surfaces, found by where they are, across seams too.
class RangesTree {
public:
    using Ranges = std::array<Interval, 4>;
    RangesTree(const SurfaceBorders &a, const SurfaceBorders &b, const std::vector<Ranges> &ranges);

    // Calls visit(number) for those that others may meet, some of them again.
    template <class Visit>
    void visit(const Ranges &others, Visit &&visit) const {
        std::array<int, 3> turns{};
        for (turns[0] = -turns_[0]; turns[0] <= turns_[0]; ++turns[0]) {
            for (turns[1] = -turns_[1]; turns[1] <= turns_[1]; ++turns[1]) {
                for (turns[2] = -turns_[2]; turns[2] <= turns_[2]; ++turns[2]) {
                    tree_.walk_box(box_of(others, turns), [&](int32_t number) {
                        count_work(20);
                        visit(static_cast<size_t>(number));
                    });
                }
            }
        }
    }

private:
    // Of three parameters: what agrees in these is little.
    [[nodiscard]] Box3 box_of(const Ranges &ranges, const std::array<int, 3> &turns) const noexcept;

    std::array<double, 3> periods_{};
    std::array<int, 3> turns_{}; // 1: along what closes
    BoxTree tree_;
};

} // namespace nrb::intersect
