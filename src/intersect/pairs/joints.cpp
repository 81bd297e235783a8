// SPDX-License-Identifier: MIT
#include "intersect/pairs/joints.h"

#include <algorithm>

namespace nrb::intersect {

void JointRange::add(const JointRange &other) noexcept {
    if (empty || other.empty) {
        *this = empty ? other : *this;
        return;
    }
    a = {std::min(a.lower, other.a.lower), std::max(a.upper, other.a.upper)};
    b = {std::min(b.lower, other.b.lower), std::max(b.upper, other.b.upper)};
    turns_back = turns_back || other.turns_back;
}

// Cells that are not tiny (simple, fold) are where a curve follows itself, and so turns back.
Joint::Joint(std::span<const NearCell> cells, const NearGroup &group, double period_a, double period_b,
             bool both_ways) {
    for (const auto &[cell, turns] : group.members) {
        const bool turns_back = both_ways || cells[cell].kind != NearCell::Kind::tiny;
        const JointRange range{turned(cells[cell].a, turns.a, period_a),
                               turned(cells[cell].b, turns.b, period_b), turns_back, false};
        by_lower_.emplace_back(range.a.lower, range);
        by_upper_.emplace_back(range.a.upper, range);
    }
    std::ranges::sort(by_lower_, {}, &Sums::value_type::first);
    std::ranges::sort(by_upper_, {}, &Sums::value_type::first);
    for (size_t i = by_lower_.size(); i-- > 1;) {
        by_lower_[i - 1].second.add(by_lower_[i].second);
    }
    for (size_t i = 1; i < by_upper_.size(); ++i) {
        by_upper_[i].second.add(by_upper_[i - 1].second);
    }
}

JointRange Joint::from(double a) const noexcept {
    const auto first = std::ranges::lower_bound(by_lower_, a, {}, &Sums::value_type::first);
    return first == by_lower_.end() ? JointRange{} : first->second;
}

JointRange Joint::until(double a) const noexcept {
    const auto end = std::ranges::upper_bound(by_upper_, a, {}, &Sums::value_type::first);
    return end == by_upper_.begin() ? JointRange{} : end[-1].second;
}

} // namespace nrb::intersect
