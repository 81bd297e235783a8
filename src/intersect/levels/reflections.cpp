// SPDX-License-Identifier: MIT
#include "intersect/levels/reflections.h"

#include "intersect/levels/fields/seen_normals.h"
#include "intersect/levels/surface_levels.h"

namespace nrb::intersect {

namespace {

using pieces::HomogeneousPiece;
using Vector = std::array<double, 3>;

// A line of sight v is mirrored to r = |N|^2 v - 2 (N . v) N; from S, that meets a + s l where
//     det(r, S - a, l) = 0
PieceField::Function function_of(ReflectionKind kind, const Vector &eye, const Vector &direction,
                                 const Vector &point) {
    return [=](const HomogeneousPiece &piece) {
        const RoundedPolynomial normal = pieces::normal_numerator(piece),
                                moment = cross(seen_from(piece, point), row_of(direction));
        RoundedPolynomial of_normal = dot(normal, moment);
        if (kind == ReflectionKind::highlight) {
            return of_normal;
        }
        const RoundedPolynomial ray = kind == ReflectionKind::along ? row_of(eye) : seen_from(piece, eye);
        return sum(dot(normal, normal) * dot(ray, moment), -2, dot(normal, ray) * of_normal);
    };
}

int degree_of(ReflectionKind kind, bool weighted, int p) noexcept {
    const int normal = degree_of_normal(weighted, p);
    switch (kind) {
    case ReflectionKind::highlight:
        return normal + p;
    case ReflectionKind::along:
        return 2 * normal + p;
    case ReflectionKind::from:
        break;
    }
    return 2 * (normal + p);
}

} // namespace

Meet surface_reflections(const Spline &surface, ReflectionKind kind, const Vector &eye,
                         const Vector &direction, const ConstRecords &points, double tolerance) {
    check_function_degree(surface, [&](int p) { return degree_of(kind, surface.rational(), p); });
    const auto function = [&](size_t i) {
        const auto at = static_cast<int64_t>(i);
        const Vector point{points(at, 0), points(at, 1), points(at, 2)};
        LevelFunction level;
        level.function = function_of(kind, eye, direction, point);
        return level;
    };
    return levels_of_functions(surface, surface, static_cast<size_t>(points.count), function, tolerance);
}

} // namespace nrb::intersect
