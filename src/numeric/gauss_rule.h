// SPDX-License-Identifier: MIT
// The rules of Gauss and Legendre.
#pragma once

#include <vector>

namespace nrb::inline numeric {

inline constexpr int most_gauss_nodes = 64;

// On [0, 1], nodes rising. Each value is within 2 eps of its own.
struct GaussRule {
    std::vector<double> places;  // of the nodes
    std::vector<double> rests;   // how far they are from 1
    std::vector<double> weights; // which add up to 1
};

// Exact up to degree 2 size - 1. Newton's method on the Legendre polynomial, in twice the precision. Precondition: 1 <= size <=
// most_gauss_nodes. Cost: quadratic in the size.
GaussRule gauss_rule(int size);

} // namespace nrb::inline numeric
