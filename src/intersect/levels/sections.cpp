// SPDX-License-Identifier: MIT
#include "intersect/levels/sections.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/fields/plane_field.h"
#include "intersect/levels/surface_levels.h"
#include "numeric/norm.h"

#include <cmath>

namespace nrb::intersect {

namespace {

// Planes with a unit normal, whatever the length of the given one.
class Planes {
public:
    explicit Planes(const std::array<double, 3> &normal) : normal_(normal) {
        double largest = 0;
        for (const double x : normal) {
            largest = std::max(largest, std::abs(x));
        }
        exponent_ = std::ilogb(largest);
        for (double &x : normal_) {
            x = std::ldexp(x, -exponent_);
        }
        length_ = norm(normal_.data(), 3);
        for (double &x : normal_) {
            x /= length_;
        }
    }

    [[nodiscard]] const std::array<double, 3> &normal() const noexcept { return normal_; }
    [[nodiscard]] double distance(double offset) const noexcept {
        return std::ldexp(offset / length_, -exponent_);
    }

private:
    std::array<double, 3> normal_;
    int exponent_ = 0;
    double length_ = 1;
};

} // namespace

Meet plane_sections(const Spline &surface, const std::array<double, 3> &normal,
                    std::span<const double> offsets, double tolerance) {
    const LimitedSearch whole; // for a limit set by the caller; each level has its own usual limit
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    const Planes planes(normal);
    PlaneField field(grid, planes.normal());
    SurfaceLevels levels(field, tolerance);
    Meet meet;
    Steps steps(std::ssize(offsets));
    for (size_t i = 0; i < offsets.size(); ++i, steps.next()) {
        double level = planes.distance(offsets[i]), size = std::abs(level);
        for (size_t c = 0; c < 3; ++c) {
            const double part = planes.normal()[c] * grid.frame().centre[c];
            level -= part;
            size += std::abs(part);
        }
        if (std::isfinite(size)) { // otherwise the plane is too far away to be represented
            const UsualLimit usual(usual_work(surface.point_count()));
            const LimitedSearch limited;
            field.set_level(grid.scaled(level), 8 * eps * grid.scaled(size));
            meet.append(levels.find(static_cast<int64_t>(i)));
        }
    }
    return meet;
}

} // namespace nrb::intersect
