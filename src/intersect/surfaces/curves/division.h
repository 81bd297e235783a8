// SPDX-License-Identifier: MIT
// How cubics that are too far off their curves are divided.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::intersect {

struct Division {
    int parts;
    int depth; // in halvings
};

// Errors fall with the fourth power of the length. Without a proof nothing is known of them.
inline Division division_for(double deviation, double tolerance) noexcept {
    constexpr int most = 16;
    const double wanted = std::ceil(1.05 * std::sqrt(std::sqrt(deviation / tolerance)));
    const int parts = wanted < most           ? std::max(static_cast<int>(wanted), 2)
                      : std::isfinite(wanted) ? most
                                              : 2;
    return {parts, parts > 4 ? 3 : parts > 2 ? 2 : 1};
}

// Calls fit(from, to) for the parts from a to b; node(share) is what is between them, none where it is not found: then a part is
// longer.
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
