// How many curves two surfaces have in common, proven by another way than the library's, of which no code is used.
#pragma once

#include "support/spline_data.h"

#include <array>
#include <string>
#include <vector>

namespace reference {

// Parameters (u, v) of the first surface and (s, t) of the second one.
using PairPlace = std::array<double, 4>;

struct PairCurve {
    bool closed = false;
    PairPlace somewhere{};       // on it
    std::vector<PairPlace> ends; // of an open one: two
};
struct PairCount {
    std::string doubt; // empty: the curves are proven to be all there is; else what is left open
    std::vector<PairCurve> curves;

    [[nodiscard]] bool certain() const { return doubt.empty(); }
    [[nodiscard]] int64_t closed() const;
    [[nodiscard]] int64_t open() const { return static_cast<int64_t>(curves.size()) - closed(); }
};

// F(u, v, s, t) = A(u, v) - B(s, t) is looked at in cells of four parameters, which are divided until
// - F has no zero: boxes are apart, or a component of M F has one sign, M the inverse of F' at the middle without column k;
// - or F is regular: all rows of |I - M F'| have a sum below 1, so that for each value of parameter k there is one zero at most.
// Where zeros of a regular cell leave it through a side is found likewise, in three parameters; sorted by parameter k these
// places are ends of arcs by turns. Arcs that share a place are one curve; axes that close go on at the other end. What touches
// stays open, as do places at corners of cells, and all that takes too much: that is told in `doubt`.
// Preconditions: dimension 3, degrees in [1, 9], weights > 0.
PairCount count_curves(const support::SplineData &a, const support::SplineData &b);

} // namespace reference
