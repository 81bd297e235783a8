// SPDX-License-Identifier: MIT
#include "intersect/levels/contours.h"

#include "intersect/levels/fields/seen_normals.h"
#include "intersect/levels/surface_levels.h"

namespace nrb::intersect {

namespace {

using pieces::HomogeneousPiece;
using Vector = std::array<double, 3>;

// The second fundamental form of a piece. With homogeneous points H = (A, w) its entries are, up to a common
// factor, det(H, H_u, H_v, H_ij) = N . A_ij - (A . A_u x A_v) w_ij.
class Bending {
public:
    explicit Bending(const HomogeneousPiece &piece)
        : piece_(piece), normal_(pieces::normal_numerator(piece)),
          volume_(dot(piece.points, cross(derivative(piece.points, piece.axis(0)),
                                          derivative(piece.points, piece.axis(1))))) {}

    // The Gaussian curvature up to a positive factor.
    [[nodiscard]] RoundedPolynomial gauss() const {
        const RoundedPolynomial mixed = entry(0, 1);
        return entry(0, 0) * entry(1, 1) - mixed * mixed;
    }

private:
    [[nodiscard]] RoundedPolynomial entry(int i, int j) const {
        const auto second = [&](const RoundedPolynomial &f) {
            return derivative(derivative(f, piece_.axis(i)), piece_.axis(j));
        };
        return dot(second(piece_.points), normal_) - volume_ * second(piece_.weight);
    }

    const HomogeneousPiece &piece_;
    RoundedPolynomial normal_, volume_;
};

PieceField::Function function_of(ContourKind kind, const Vector &d, double cosine) {
    switch (kind) {
    case ContourKind::perspective:
        return [d](const HomogeneousPiece &piece) {
            return dot(pieces::normal_numerator(piece), seen_from(piece, d));
        };
    case ContourKind::isophote:
        if (cosine != 0) {
            return [d, cosine](const HomogeneousPiece &piece) {
                const RoundedPolynomial normal = pieces::normal_numerator(piece),
                                        along = dot(normal, row_of(d));
                return sum(along * along, -cosine * cosine, dot(normal, normal));
            };
        }
        [[fallthrough]];
    case ContourKind::silhouette:
        return [d](const HomogeneousPiece &piece) { return dot(pieces::normal_numerator(piece), row_of(d)); };
    case ContourKind::parabolic:
        break;
    }
    return [](const HomogeneousPiece &piece) { return Bending(piece).gauss(); };
}

// Bounds on the degree of f along an axis of degree p: N is of degree 2 p - 1, or 3 p - 1 with weights.
int degree_of(ContourKind kind, bool weighted, int p) noexcept {
    const int normal = degree_of_normal(weighted, p);
    switch (kind) {
    case ContourKind::silhouette:
        return normal;
    case ContourKind::perspective:
        return normal + p;
    case ContourKind::isophote:
        return 2 * normal;
    case ContourKind::parabolic:
        break;
    }
    return 2 * (normal + p);
}

// Squaring loses the sign of N . d: only those zeros count at which it is the sign of the cosine.
PieceField::Function sign_of(const Vector &d, double cosine) {
    if (cosine == 0) {
        return {};
    }
    const double sign = cosine > 0 ? 1 : -1;
    return [d = Vector{sign * d[0], sign * d[1], sign * d[2]}](const HomogeneousPiece &piece) {
        return dot(pieces::normal_numerator(piece), row_of(d));
    };
}

} // namespace

Meet surface_contours(const Spline &surface, ContourKind kind, const Vector &d,
                      std::span<const double> cosines, double tolerance) {
    check_function_degree(surface, [&](int p) { return degree_of(kind, surface.rational(), p); });
    const bool lit = kind == ContourKind::isophote;
    const auto function = [&](size_t i) {
        const double cosine = lit ? cosines[i] : 0;
        LevelFunction level;
        level.function = function_of(kind, d, cosine);
        level.sign = sign_of(d, cosine);
        return level;
    };
    return levels_of_functions(surface, surface, lit ? cosines.size() : 1, function, tolerance);
}

} // namespace nrb::intersect
