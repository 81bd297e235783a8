// SPDX-License-Identifier: MIT
// Which parameters of a curve in the domain of a face and of its edge in space belong together.
#pragma once

#include "face/face.h"
#include "numeric/vector3.h"

#include <vector>

namespace nrb::mesh {

// One parameter follows from the other by a line where that is within a distance, as for curves that were made; else by the lengths
// of both curves, and then from the nearest point.
class CurvePairing {
public:
    CurvePairing(const face::Face &face, const Spline &curve, const Spline &edge, bool against, double near);

    // The parameter of the edge for that of the curve, and the other way round. Both rise or fall all the way.
    [[nodiscard]] double on_edge(double s) const;
    [[nodiscard]] double on_curve(double t) const;
    // Where the surface maps a place of the curve to.
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
    std::vector<double> s_, t_; // at equal shares of the lengths, rising and following; empty: by a line
};

} // namespace nrb::mesh
