// SPDX-License-Identifier: MIT
// Into how many parts cubics that deviate too much from their curves are divided.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::intersect {

struct Division {
    int parts;
    int depth; // in halvings
};

// The errors of cubics fall with the fourth power of the length. A deviation that is infinite, because
// nothing is proven, says nothing of them: then there are two parts.
inline Division division_for(double deviation, double tolerance) noexcept {
    constexpr int most = 16;
    const double wanted = std::ceil(1.05 * std::sqrt(std::sqrt(deviation / tolerance)));
    const int parts = wanted < most           ? std::max(static_cast<int>(wanted), 2)
                      : std::isfinite(wanted) ? most
                                              : 2;
    return {parts, parts > 4 ? 3 : parts > 2 ? 2 : 1};
}

// Calls fit(from, to) for the parts from a to b, one after the other. node(share) is the node at a share of
// the way; where it finds none, a part is longer.
template <class Node, class Between, class Fit>
void for_each_part(const Node &a, const Node &b, int parts, Between &&node, Fit &&fit) {
    Node from = a;
    for (int i = 1; i <= parts; ++i) {
        const std::optional<Node> to = i < parts ? node(static_cast<double>(i) / parts) : std::optional(b);
        if (to) {
            fit(from, *to);
            from = *to;
        }
    }
}

} // namespace nrb::intersect
