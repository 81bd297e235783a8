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

RoundedPolynomial seen_from(const pieces::HomogeneousPiece &piece, std::span<const double> place) {
    std::vector<RoundedPolynomial> components;
    for (size_t c = 0; c < place.size(); ++c) {
        RoundedPolynomial shift = constant(times_power_of_two(piece.centre[c] - place[c], -piece.exponent));
        shift.errors[0] = 2 * eps * std::abs(shift.values[0]);
        components.push_back(component(piece.points, static_cast<int>(c)) + piece.weight * shift);
    }
    return side_by_side(components);
}

int degree_of_normal(bool weighted, int p) noexcept {
    return std::max(weighted ? 3 * p - 1 : 2 * p - 1, 0);
}

Meet levels_of_functions(const Spline &surface, const Spline &spline, size_t count,
                         const std::function<LevelFunction(size_t i)> &function, double tolerance) {
    const LimitedSearch whole; // by a limit of the caller; each level has the usual one of its own
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    Meet all;
    Steps steps(static_cast<int64_t>(count));
    for (size_t i = 0; i < count; ++i, steps.next()) {
        const UsualLimit usual(usual_work(surface.point_count(), 200000));
        const LimitedSearch limited;
        LevelFunction own = function(i);
        PieceField field(spline, grid, std::move(own.function), std::move(own.sign));
        all.append(SurfaceLevels(field, tolerance).find(static_cast<int64_t>(i)));
    }
    return all;
}

} // namespace nrb::intersect
