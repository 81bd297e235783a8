// SPDX-License-Identifier: MIT
// Generators of knot vectors: uniform, open uniform, Bezier, averaged and periodic. All functions fill the
// whole vector, and throw Error if the arguments do not admit a knot vector.
#pragma once

#include <cstdint>
#include <span>

namespace nrb::inline basis {

// Each function first checks that `knots` has the size its rule requires (Status::size); nothing is written
// before.
void uniform_knots(int degree, int64_t count, double a, double b, std::span<double> knots);
void open_uniform_knots(int degree, int64_t count, double a, double b, std::span<double> knots);
// `breaks`: pieces + 1 values, or null for equally spaced ones on [0, 1].
void bezier_knots(int degree, int64_t pieces, const double *breaks, std::span<double> knots);
void averaged_knots(int degree, std::span<const double> params, std::span<double> knots);
// `multiplicities`: one for each break, or null if all are 1.
void periodic_knots(int degree, std::span<const double> breaks, const int32_t *multiplicities,
                    std::span<double> knots);

// Sizes of the vectors above; throw if they overflow.
int64_t bezier_knot_count(int degree, int64_t pieces);

} // namespace nrb::inline basis
