// The data of one job: a spline, parameters, and exact results at a sample of the points. It is made once and
// written to a file, so that every program, in any language, has the same numbers.
#pragma once

#include "support/spline_data.h"

#include <filesystem>

namespace bench {

struct Case {
    support::SplineData spline;
    std::vector<double> params;   // [points][axes], or the parameters of axis 0, then of axis 1
    std::vector<int64_t> grid;    // number of parameters on each axis; empty: no grid
    std::vector<int64_t> sample;  // indices of the points that are checked
    std::vector<double> expected; // [sample][vectors][dim], exact values rounded once
    std::vector<double> bounds;   // of their errors, as nurbs.h promises them

    [[nodiscard]] int64_t points() const;
};

// The file is a sequence of arrays, each a 64-bit length followed by 64-bit integers or doubles: degrees,
// counts, {dim}, grid, sample; knots, points, weights, params, expected, bounds.
void write(const Case &data, const std::filesystem::path &path);
Case read(const std::filesystem::path &path);

} // namespace bench
