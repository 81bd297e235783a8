// The shape operator of a surface at one point.
#pragma once

#include "eval/derivative_errors.h"
#include "eval/vector3.h"

namespace nrb {

struct SurfaceDerivatives {
    Vector3 u;
    Vector3 v;
    Vector3 uu;
    Vector3 uv;
    Vector3 vv;
};

// A symmetric matrix in the orthonormal basis e1 = S_u / |S_u|, e2 = N x e1 of the tangent plane.
struct ShapeOperator {
    Vector3 e1;
    Vector3 e2;
    double w11 = 0;
    double w12 = 0;
    double w22 = 0;

    [[nodiscard]] double mean() const noexcept { return 0.5 * (w11 + w22); }
    [[nodiscard]] double gaussian() const noexcept { return w11 * w22 - w12 * w12; }
    // Half the difference of the principal curvatures.
    [[nodiscard]] double spread() const noexcept;
    // The unit vector of the larger principal curvature, on the side of e1 (of e2, if it is perpendicular).
    [[nodiscard]] Vector3 direction() const noexcept;
};

// Precondition: S_u x S_v is not 0.
ShapeOperator shape_operator(const SurfaceDerivatives &d) noexcept;

// Bound of the error of spread() when the derivatives have these errors, to first order.
double spread_error(const SurfaceDerivatives &d, const DerivativeErrors &errors) noexcept;

// Whether S_u x S_v exceeds the bound of its error.
bool regular(const SurfaceDerivatives &d, const DerivativeErrors &errors) noexcept;

} // namespace nrb
