#include "modify/edit/pull_point.h"

#include "base/finite.h"
#include "base/norm.h"
#include "modify/edit/influence.h"
#include "modify/edit/net_editor.h"

#include <cmath>

namespace nrb {

namespace {

// Scaled by a power of two first, so that no length over- or underflows.
std::vector<double> unit_vector(const double *direction, int dim) {
    std::vector<double> unit(direction, direction + dim);
    const int exponent = -std::ilogb(largest_magnitude(unit));
    for (double &x : unit) {
        x = std::ldexp(x, exponent);
    }
    const double length = norm(unit.data(), dim);
    for (double &x : unit) {
        x /= length;
    }
    return unit;
}

} // namespace

PointEdit pull_point(const Spline &spline, int64_t original, const double *param, const double *direction,
                     double distance) {
    const Contribution sums = contribution_of(spline, {&original, 1}, param);
    const double moved = distance / sums.influence();
    NetEditor editor(spline);
    editor.move(original, unit_vector(direction, spline.dim()).data(), moved);
    return {moved, editor.finish()};
}

} // namespace nrb
