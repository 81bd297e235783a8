// SPDX-License-Identifier: MIT
// Where curves of a domain turn back.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::face {

// The parameters, in their order, at which both coordinates of a curve turn at once, as at the tip of a fold: what comes there and
// what leaves it are two curves to those that search for meets. Both may turn in two places that hardly differ.
std::vector<double> places_of_return(const Spline &curve);

} // namespace nrb::face
