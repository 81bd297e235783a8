// Of how many curves the zeros of a polynomial in a square consist, in exact arithmetic.
#pragma once

#include "reference/number.h"

#include <array>
#include <string>
#include <vector>

namespace reference {

struct ZeroCount {
    std::string
        doubt; // empty: counts are exact; else what is left open, as where zeros are singular, or near it
    int64_t open = 0, closed = 0;
};

// f(x, y) = sum of c_ij B_i(x) B_j(y) over [0, 1]^2, c by rising i, then j; counts have degree + 1 coefficients along each axis.
// Squares are divided into four until f or one of its derivatives has coefficients of one sign: where f rises along y its zeros are
// a graph over x, which begins and ends where zeros on the lower or upper side are, or at the other two. These are
// isolated by Descartes' rule and halved to 2^-40, which tells who they are for the neighbour.
ZeroCount count_zeros(const std::vector<Integer> &coefficients, const std::array<int, 2> &counts);

} // namespace reference
