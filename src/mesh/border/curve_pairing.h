// SPDX-License-Identifier: MIT
// The correspondence of parameters between a curve in the domain of a face and the edge in space that it maps
// to.
#pragma once

#include "face/face.h"
#include "numeric/vector3.h"

#include <vector>

namespace nrb::mesh {

// If a linear map of the parameters keeps the image of the curve within `near` of the edge, as samples show,
// it is used; it usually does where one curve was made from the other. Otherwise equal shares of both arc
// lengths give a first guess, and Gauss-Newton steps lead from it to the foot point.
class CurvePairing {
public:
    // `against`: whether curve and edge run in opposite directions.
    CurvePairing(const face::Face &face, const Spline &curve, const Spline &edge, bool against, double near);

    // The parameter of the edge for one of the curve, and the other way round. Foot points of places that are
    // near each other may be in the wrong order where curve and edge are apart: see put_in_order().
    [[nodiscard]] double on_edge(double s) const;
    [[nodiscard]] double on_curve(double t) const;
    // The point of the surface at a parameter of the curve.
    [[nodiscard]] Vector3 image(double s) const;

private:
    struct Jet {
        Vector3 point, derivative;
    };
    [[nodiscard]] double by_line(double x, Interval from, Interval to) const noexcept;
    [[nodiscard]] Jet image_jet(double s) const;
    [[nodiscard]] Jet edge_jet(double t) const;
    [[nodiscard]] bool is_near(double distance) const;
    void make_tables();
    [[nodiscard]] static Interval around(double guess, Interval domain) noexcept;

    const face::Face &face_;
    const Spline &curve_;
    const Spline &edge_;
    bool against_;
    Interval curve_domain_, edge_domain_;
    // Parameters of curve and edge at equal shares of their arc lengths, in the order of s_, which rises.
    // Empty: the map is linear.
    std::vector<double> s_, t_;
};

// A parameter of one curve, and what was found for it on the other.
struct PairedParam {
    double given, found;
    bool fixed = false; // whether it has to stay
};

// Puts those of the found parameters that are out of order between their neighbours, in proportion to the
// given ones. Preconditions: the given ones rise, the first and the last pair are fixed, and the fixed ones
// are in order, from the first to the last. All may be equal.
void put_in_order(std::vector<PairedParam> &pairs) noexcept;

} // namespace nrb::mesh
