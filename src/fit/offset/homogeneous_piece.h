// SPDX-License-Identifier: MIT
// Bezier pieces of curves and surfaces in homogeneous coordinates about a common centre.
#pragma once

#include "pieces/bernstein_net.h"
#include "pieces/derivative_pieces.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

using pieces::HomogeneousPiece;

// The pieces of a curve or a surface between breaks, which include all knots between the first and the last
// of them. The centre c is the same for all pieces; the unit of length is that of the spline.
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
