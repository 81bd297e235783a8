// The accuracy contract of nurbs.h in numbers: the table c(p) and the magnitudes H_a and E_a.
#pragma once

#include "reference/exact_spline.h"

namespace reference {

inline constexpr long double eps = 0x1p-52L;

// c(p) of the header's table, and its sum over the axes of a spline.
long double c_of(int degree);
long double c_of(const support::SplineData &data);

// What multiplies c for points: the largest ratio of the active weights (of all weights, with several axes)
// where they are even enough for centred powers, whose rounding is relative to the largest weight; else 1.
long double weight_factor(const support::SplineData &data, const double *param, Sides left = {});

// What multiplies 2 (c + 2 |a|) eps in the bound of derivative a of coordinate c: H_a of the preamble for a
// polynomial spline, E_a for a rational one. All terms are positive, so that long double gives them to a few
// of its own units. magnitudes[slot][c], slots as in nurbs_eval_derivs(); slot 0 has the magnitudes of the
// point, which is not seen from O.
std::vector<std::vector<long double>> magnitudes(const support::SplineData &data, int order,
                                                 const double *param, Sides left = {});

// The same of the sum of derivatives of the functions times points, which is what bounds the terms in place
// of the result: of the points as seen from O (the bounds of frames), or of those that are stored.
enum class Terms { seen_from_o, stored };
std::vector<std::vector<long double>> magnitudes(const support::SplineData &data, int order,
                                                 const double *param, Terms terms, Sides left = {});

// O of the preamble.
std::vector<double> origin_of(const support::SplineData &data);

} // namespace reference
