// SPDX-License-Identifier: MIT
// A Krawczyk test for parts of three surfaces that have at most one common point.
#pragma once

#include "intersect/contraction.h"
#include "intersect/extrema/fields/krawczyk.h"
#include "intersect/surfaces/cross_cell.h"

namespace nrb::intersect {

// Local parameters in the parts: u and v of each of the three.
using TriplePlace = Place<6>;
using TripleParts = std::array<CrossCell *, 3>;

// F = (A - B, A - C) is a system of six equations in six unknowns, whose terms depend on two unknowns each. M
// is the inverse of F' in the middle. Row i of M is a pair of vectors (b, c), and row i of M F is
//     (b + c) . A - b . B - c . C
// The extents of control points and derivatives along these three vectors bound the row and its derivatives
// over the wide parts. If the largest row sum of |I - M F'| is below 1, the wide parts have at most one
// common point (Contraction).
class TripleChart {
public:
    enum class Verdict {
        apart, // a row of M F is nowhere 0
        chart,
        bent, // neither is proven
        flat, // F' is nearly singular in the middle: M does not exist
    };
    // Precondition: all parts are prepared (CrossCell::prepare()).
    Verdict set(const TripleParts &parts);

    // Of a chart: an approximation of its common point, and a range that contains it if it exists.
    struct Found {
        TriplePlace at{};
        Box<6> range{};
    };
    [[nodiscard]] Found solution() const;
    // The index of the part whose derivatives vary most.
    [[nodiscard]] size_t most_bent() const noexcept;

private:
    bool set_row(size_t i, double &sum);

    struct Row {
        Vector3 b, c; // factors of A - B and of A - C
    };
    TripleParts parts_{};
    std::array<Row, 6> rows_{};
    Contraction contraction_;
    double near_ = 0;
    std::array<double, 3> bends_{};
};

} // namespace nrb::intersect
