// SPDX-License-Identifier: MIT
// Bilinear maps of pairs of records.
#pragma once

#include <vector>

namespace nrb::refine {

// One term of a bilinear map B. Component c of B(x, y) is the sum, over the terms with out == c, of factor *
// (x[a] y[b] + ... + x[a + size - 1] y[b + size - 1]). An index one past the last component of a record
// stands for the constant 1; such a term has size 1.
struct BilinearTerm {
    int out;
    int a;
    int b;
    double factor = 1;
    int size = 1;
};
using Bilinear = std::vector<BilinearTerm>;

} // namespace nrb::refine
