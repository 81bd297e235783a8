// Boehm's knot insertion as a table: W. Boehm, "Inserting new knots into B-spline curves", Computer-Aided
// Design 12 (1980).
#pragma once

#include "spline/layer_table.h"

#include <span>
#include <vector>

namespace nrb {

// The knots with `times` more copies of `knot` behind the last knot that is not greater.
std::vector<double> insert_into_knots(std::span<const double> knots, double knot, int times);

// Appends the rows that give the control points over insert_into_knots(knots, knot, times) from those over
// `knots`: copies, except for at most p - s + times - 1 rows of convex combinations, s the multiplicity of
// the knot before. All factors lie in [0, 1], so that an entry of a row is accurate to 3 times eps relative
// to itself (6 roundings for each step). Preconditions: knots[p] <= knot <= knots[count], 0 < times <=
// p + 1 - s.
void append_insertion_rows(int degree, std::span<const double> knots, double knot, int times,
                           LayerTable &table);

} // namespace nrb
