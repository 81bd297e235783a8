// SPDX-License-Identifier: MIT
#include "intersect/levels/seen_normals.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/surface_levels.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

RoundedPolynomial row_of(const std::array<double, 3> &d) {
    return side_by_side({constant(d[0]), constant(d[1]), constant(d[2])});
}

RoundedPolynomial seen_from(const pieces::HomogeneousPiece &piece, const std::array<double, 3> &place) {
    std::vector<RoundedPolynomial> components;
    for (int c = 0; c < 3; ++c) {
        const auto at = static_cast<size_t>(c);
        RoundedPolynomial shift = constant(times_power_of_two(piece.centre[at] - place[at], -piece.exponent));
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

int degree_of_normal(bool weighted, int p) noexcept {
    return std::max(weighted ? 3 * p - 1 : 2 * p - 1, 0);
}

Meet levels_of_functions(const Spline &surface, size_t count,
                         const std::function<LevelFunction(size_t i)> &function, double tolerance) {
    const LimitedSearch whole; // by a limit of the caller; each level has the usual one of its own
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    Meet all;
    Steps steps(static_cast<int64_t>(count));
    for (size_t i = 0; i < count; ++i, steps.next()) {
        const UsualLimit usual(usual_work(surface.point_count(), 200000));
        const LimitedSearch limited;
        LevelFunction own = function(i);
        PieceField field(surface, grid, std::move(own.function), std::move(own.sign));
        all.append(SurfaceLevels(field, tolerance).find(static_cast<int64_t>(i)));
    }
    return all;
}

} // namespace nrb::intersect
