// SPDX-License-Identifier: MIT
// Gauss-Legendre quadrature rules.
#pragma once

#include <vector>

namespace nrb::inline numeric {

inline constexpr int most_gauss_nodes = 64;

// On [0, 1], nodes increasing. Each value has a relative error within 2 eps.
struct GaussRule {
    std::vector<double> places;  // the nodes
    std::vector<double> rests;   // 1 - node
    std::vector<double> weights; // sum to 1
};

// The rule with `size` nodes, exact up to degree 2 size - 1. The nodes are found by Newton's method on the
// Legendre polynomial in twice the precision. Precondition: 1 <= size <= most_gauss_nodes. Cost: quadratic in
// the size.
GaussRule gauss_rule(int size);

} // namespace nrb::inline numeric
