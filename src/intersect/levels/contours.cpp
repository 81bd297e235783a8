// SPDX-License-Identifier: MIT
#include "intersect/levels/contours.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/piece_field.h"
#include "intersect/levels/surface_levels.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

using pieces::HomogeneousPiece;
using Vector = std::array<double, 3>;

RoundedPolynomial row_of(const Vector &d) {
    return side_by_side({constant(d[0]), constant(d[1]), constant(d[2])});
}

// w (x - eye), in the unit of the piece.
RoundedPolynomial seen_from(const HomogeneousPiece &piece, const Vector &eye) {
    std::vector<RoundedPolynomial> components;
    for (int c = 0; c < 3; ++c) {
        const auto at = static_cast<size_t>(c);
        RoundedPolynomial shift = constant(times_power_of_two(piece.centre[at] - eye[at], -piece.exponent));
        shift.errors[0] = 2 * eps * std::abs(shift.values[0]);
        components.push_back(component(piece.points, c) + piece.weight * shift);
    }
    return side_by_side(components);
}

RoundedPolynomial cross(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    std::vector<RoundedPolynomial> components;
    for (int c = 0; c < 3; ++c) {
        const int x = (c + 1) % 3, y = (c + 2) % 3;
        components.push_back(component(a, x) * component(b, y) - component(a, y) * component(b, x));
    }
    return side_by_side(components);
}

// With homogeneous H = (A, w) the second fundamental form has the entries det(H, H_u, H_v, H_ij), but for a common factor;
// the determinant is N . A_ij - (A . A_u x A_v) w_ij.
class Bending {
public:
    explicit Bending(const HomogeneousPiece &piece)
        : piece_(piece), normal_(pieces::normal_numerator(piece)),
          volume_(dot(piece.points, cross(derivative(piece.points, piece.axis(0)),
                                          derivative(piece.points, piece.axis(1))))) {}

    // The Gaussian curvature, but for a factor that is positive.
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

// Bounds of the degree of f on an axis of degree p: N is of degree 2 p - 1, or 3 p - 1 with weights.
int degree_of(ContourKind kind, bool weighted, int p) noexcept {
    const int normal = std::max(weighted ? 3 * p - 1 : 2 * p - 1, 0);
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

// Of the two signs of N . d that the squares do not tell, zeros have that of the cosine.
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
    const LimitedSearch whole; // by a limit of the caller; each level has the usual one of its own
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    const size_t levels = kind == ContourKind::isophote ? cosines.size() : 1;
    Meet all;
    Steps steps(static_cast<int64_t>(levels));
    for (size_t i = 0; i < levels; ++i, steps.next()) {
        const double cosine = kind == ContourKind::isophote ? cosines[i] : 0;
        const UsualLimit usual(usual_work(surface.point_count(), 200000));
        const LimitedSearch limited;
        PieceField field(surface, grid, function_of(kind, d, cosine), sign_of(d, cosine));
        all.append(SurfaceLevels(field, tolerance).find(static_cast<int64_t>(i)));
    }
    return all;
}

} // namespace nrb::intersect
