// SPDX-License-Identifier: MIT
// Bezier pieces of curves and surfaces as polynomials with errors.
#pragma once

#include "bernstein/rounded_polynomial.h"
#include "pieces/bernstein_net.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// A curve or a surface on one piece: w (x - c), and w.
struct HomogeneousPiece {
    RoundedPolynomial points, weight;
};

// All between breaks, which hold all knots between the first and the last of them; c is the same for all.
class HomogeneousPieces {
public:
    HomogeneousPieces(const Spline &spline, const pieces::BernsteinNet::Breaks &breaks)
        : HomogeneousPieces(spline, breaks, pieces::centre_of(spline)) {}
    HomogeneousPieces(const Spline &spline, const pieces::BernsteinNet::Breaks &breaks,
                      const std::vector<double> &centre);

    [[nodiscard]] int64_t count() const noexcept { return net_.pieces(); }
    [[nodiscard]] bool weighted() const noexcept { return net_.weighted(); }
    [[nodiscard]] bool positive() const noexcept { return net_.positive(); }
    [[nodiscard]] HomogeneousPiece piece(int64_t i) const;

private:
    pieces::BernsteinNet net_;
};

} // namespace nrb::fit
