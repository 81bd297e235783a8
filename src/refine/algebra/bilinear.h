// SPDX-License-Identifier: MIT
// Maps of two records that are linear in each of them.
#pragma once

#include <vector>

namespace nrb::refine {

// A map B as the list of its terms: component `out` of B(x, y) is the sum of factor (x[a] y[b] + ... + x[a + size - 1]
// y[b + size - 1]). A component after the last of a record stands for the constant 1; it has a term of its own.
struct BilinearTerm {
    int out;
    int a;
    int b;
    double factor = 1;
    int size = 1;
};
using Bilinear = std::vector<BilinearTerm>;

} // namespace nrb::refine
