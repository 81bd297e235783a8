// SPDX-License-Identifier: MIT
// Parts of three surfaces that have one point in common at most.
#pragma once

#include "intersect/contraction.h"
#include "intersect/extrema/fields/krawczyk.h"
#include "intersect/surfaces/cross_cell.h"

namespace nrb::intersect {

// In the parts, u and v of each of the three.
using TriplePlace = Place<6>;
using TripleParts = std::array<CrossCell *, 3>;

// F = (A - B, A - C), six equations in six unknowns, each of them a sum of terms in two. M is the inverse of its derivative in
// the middle. Row i of M is a pair of vectors (r, s), and that of M F is (r + s) . A - r . B - s . C: what bounds it, and its
// derivatives over the wide parts, are products of control points and vectors. If the largest row sum of |I - M F'| is below 1,
// there is one common point at most in the wide parts (Contraction).
class TripleChart {
public:
    enum class Verdict {
        apart, // a row of M F is nowhere 0
        chart,
        bent, // neither
        flat, // M does not exist
    };
    // Precondition: all are prepared.
    Verdict set(const TripleParts &parts);

    // Of a chart: near its common point, and where that is if there is one.
    struct Found {
        TriplePlace at{};
        Box<6> range{};
    };
    [[nodiscard]] Found solution() const;
    // Which of the parts bends most.
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
