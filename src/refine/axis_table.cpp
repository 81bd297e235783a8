#include "refine/axis_table.h"

#include "refine/periodic.h"

#include <algorithm>
#include <iterator>

namespace nrb {

LayerTable rows_of(const Refinement &refinement, int64_t first, int64_t end) {
    LayerTable table;
    table.reserve(end - first, refinement.width());
    for (int64_t j = first; j < end; ++j) {
        if (j > first && refinement.repeats(j)) {
            table.repeat_row();
            continue;
        }
        const auto [layer, size] = refinement.row(j, table.room(refinement.width()));
        table.add_written(layer, size);
    }
    return table;
}

std::vector<double> merged(std::span<const double> knots, std::span<const double> more) {
    std::vector<double> result;
    result.reserve(knots.size() + more.size());
    std::merge(knots.begin(), knots.end(), more.begin(), more.end(), std::back_inserter(result));
    return result;
}

AxisTable refine_axis(const KnotVector &axis, std::span<const double> knots) {
    if (axis.periodic()) {
        return refine_periodic(axis, knots);
    }
    std::vector<double> fine = merged(axis.knots(), knots);
    const Refinement refinement(axis.degree(), axis.knots(), fine);
    LayerTable table = rows_of(refinement, 0, refinement.rows());
    return {std::make_shared<const KnotVector>(axis.degree(), std::move(fine)), std::move(table)};
}

Spline::Axes with_axis(const Spline &spline, int k, KnotVectorPtr axis) {
    Spline::Axes axes = spline.knot_vectors();
    axes[static_cast<size_t>(k)] = std::move(axis);
    return axes;
}

SplinePtr with_axis(const Spline &spline, int k, const AxisTable &made) {
    Net net = apply_along(spline, k, made.table);
    return make_spline(with_axis(spline, k, made.axis), spline.dim(), spline.form(), std::move(net.points),
                       std::move(net.weights));
}

} // namespace nrb
