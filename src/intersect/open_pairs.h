// SPDX-License-Identifier: MIT
// A work-list search over pairs of parts that may have something in common.
#pragma once

#include "base/watch.h"

#include <utility>
#include <vector>

namespace nrb::intersect {

// Calls look(pair) for each pair on the stack, to which look() may push further pairs, until the stack is
// empty or the work limit is reached; then calls give_up(pair) for the pairs that are left. Returns whether
// all were looked at.
template <class Pair, class Look, class GiveUp>
bool look_at_all(std::vector<Pair> &stack, Look &&look, GiveUp &&give_up) {
    SearchSteps steps;
    for (; !stack.empty() && !work_ended(); steps.next(stack.size())) {
        const Pair pair = stack.back();
        stack.pop_back();
        look(pair);
    }
    const std::vector<Pair> rest = std::exchange(stack, {});
    for (const Pair &pair : rest) {
        give_up(pair);
    }
    return rest.empty();
}

} // namespace nrb::intersect
