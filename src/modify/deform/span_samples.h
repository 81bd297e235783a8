// Splines sampled at the same places of every span, and control points from samples.
#pragma once

#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb {

// Places in a span, from 0 to 1, where polynomials of a degree are interpolated: Chebyshev's with the ends,
// so that splines meet at knots; the middle for degree 0.
class LocalNodes {
public:
    explicit LocalNodes(int degree);

    [[nodiscard]] const std::vector<double> &nodes() const noexcept { return nodes_; }
    // Nodes, and between them as many places less one at which interpolation errs most, in rising order: node
    // i is number 2 i.
    [[nodiscard]] const std::vector<double> &with_checks() const noexcept { return all_; }
    // The Bernstein coefficients of the interpolating polynomial: [degree + 1][node].
    [[nodiscard]] const std::vector<double> &bernstein() const noexcept { return bernstein_; }

private:
    std::vector<double> nodes_;
    std::vector<double> all_;
    std::vector<double> bernstein_;
};

// Values at places of each non-empty span of the domain, places[k] on axis k: [..][width()], last axis
// fastest, each from the polynomial piece of its span. Throws NURBS_ERROR_NOT_REPRESENTABLE, _OVERFLOW.
// Precondition: polynomial.
using Places = std::array<std::vector<double>, max_axes>;
std::vector<double> sampled(const Spline &spline, const Places &places);

// The control points [..][width] over the axes of the spline from values at nodes[k] of each span on axis k.
// Control point i of an axis is the value of the polar form, at its knots, of the polynomial that
// interpolates on that span of its support which is nearest to its Greville abscissa, so that splines come
// out as they are, and values at knots of multiplicity degree are met (T. Lyche, K. Morken, "Spline methods",
// 2008, 8.3: local projectors).
std::vector<double> control_points(const Spline &spline, const std::vector<LocalNodes> &nodes,
                                   std::vector<double> samples, int width);

// The same along axis k alone, from values [..][width] at the places of with_checks() on that axis and at the
// nodes of the others: what the projected spline is there.
std::vector<double> projected_along(const Spline &spline, int k, const std::vector<LocalNodes> &nodes,
                                    std::vector<double> samples, int width);

} // namespace nrb
