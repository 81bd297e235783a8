// SPDX-License-Identifier: MIT
#include "intersect/levels/fields/seen_normals.h"

#include "base/numbers.h"
#include "numeric/power_of_two.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

RoundedPolynomial row_of(const std::array<double, 3> &d) {
    return side_by_side({constant(d[0]), constant(d[1]), constant(d[2])});
}

RoundedPolynomial seen_from(const pieces::HomogeneousPiece &piece, std::span<const double> place) {
    std::vector<RoundedPolynomial> components;
    for (size_t c = 0; c < place.size(); ++c) {
        RoundedPolynomial shift = constant(times_power_of_two(piece.centre[c] - place[c], -piece.exponent));
        shift.errors[0] = 2 * eps * std::abs(shift.values[0]);
        components.push_back(component(piece.points, static_cast<int>(c)) + piece.weight * shift);
    }
    return side_by_side(components);
}

int degree_of_normal(bool weighted, int p) noexcept {
    return std::max(weighted ? 3 * p - 1 : 2 * p - 1, 0);
}

} // namespace nrb::intersect
