// SPDX-License-Identifier: MIT
#include "intersect/levels/sections.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/plane_field.h"
#include "intersect/levels/surface_levels.h"

#include <cmath>

namespace nrb::intersect {

Meet plane_sections(const Spline &surface, const std::array<double, 3> &normal,
                    std::span<const double> offsets, double tolerance) {
    const UsualLimit usual(usual_work(surface.point_count() + 1000 * std::ssize(offsets)));
    const LimitedSearch limited;
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    PlaneField field(grid, normal);
    SurfaceLevels levels(field, tolerance);
    Meet meet;
    Steps steps(std::ssize(offsets));
    for (size_t i = 0; i < offsets.size(); ++i, steps.next()) {
        double level = offsets[i], size = std::abs(level);
        for (size_t c = 0; c < 3; ++c) {
            level -= normal[c] * grid.frame().centre[c];
            size += std::abs(normal[c] * grid.frame().centre[c]);
        }
        field.set_level(grid.scaled(level), 8 * eps * grid.scaled(size));
        meet.append(levels.find(static_cast<int64_t>(i)));
    }
    return meet;
}

} // namespace nrb::intersect
