// SPDX-License-Identifier: MIT
// The shape operator (Weingarten map) of a surface at one point, with its eigenvalues and their directions.
#pragma once

#include "eval/derivative_errors.h"
#include "numeric/vector3.h"

namespace nrb::eval {

struct SurfaceDerivatives {
    Vector3 u;
    Vector3 v;
    Vector3 uu;
    Vector3 uv;
    Vector3 vv;
};

// The shape operator as a symmetric matrix W in the orthonormal basis e1 = S_u / |S_u|, e2 = N x e1 of the
// tangent plane. The second fundamental form (l, m, n) is J^T W J with J = (a, a b; 0, c), where S_u = a e1
// and S_v = a b e1 + c e2.
class ShapeOperator {
public:
    // If S_u x S_v is 0, results are NaN or infinite.
    explicit ShapeOperator(const SurfaceDerivatives &d) noexcept;

    [[nodiscard]] const Vector3 &e1() const noexcept { return e1_; }
    [[nodiscard]] const Vector3 &normal() const noexcept { return normal_; }
    [[nodiscard]] double mean() const noexcept { return 0.5 * (w11_ + w22_); }
    [[nodiscard]] double gaussian() const noexcept;
    // Half the difference of the principal curvatures: D of nurbs_surface_eval_curvatures().
    [[nodiscard]] double spread() const noexcept { return spread_; }
    // A first-order bound of the error of spread(), if the derivatives d, which are those of the constructor,
    // have the given errors.
    [[nodiscard]] double spread_error(const SurfaceDerivatives &d,
                                      const DerivativeErrors &errors) const noexcept;
    // The unit vector along which the curvature is the larger principal curvature, on the side of e1 (or of
    // e2, if it is perpendicular to e1).
    [[nodiscard]] Vector3 direction() const noexcept;

private:
    Vector3 e1_;
    Vector3 normal_;
    double a_;
    double b_;
    double c_;
    double l_;
    double m_;
    double n_;
    double w11_;
    double w12_;
    double w22_;
    double spread_;
};

// Whether the surface is regular there: S_u x S_v exceeds the bound of its error.
bool regular(const SurfaceDerivatives &d, const DerivativeErrors &errors) noexcept;

} // namespace nrb::eval
