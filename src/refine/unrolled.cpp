#include "refine/unrolled.h"

#include "base/checked.h"
#include "refine/axis_table.h"
#include "refine/period.h"

namespace nrb {

SplinePtr unrolled(const SplinePtr &spline, int axis, int64_t periods) {
    const KnotVector &knots = spline->axis(axis);
    const int64_t distinct = knots.distinct_layers();
    const int64_t lead = checked_product(distinct, periods, "knots");
    std::vector<double> more = extended_knots(knots, lead);
    const auto limit = static_cast<size_t>(knots.degree()) + 1;
    for (size_t i = 0; i + limit < more.size(); ++i) {
        if (more[i] == more[i + limit]) {
            fail(NURBS_ERROR_PERIODIC_KNOTS, "knots: rounding makes more than %zu copies equal at %s", limit,
                 Number(more[i]).text);
        }
    }
    LayerTable table;
    table.reserve(knots.count() + 2 * lead);
    for (int64_t layer = 0; layer < knots.count() + 2 * lead; ++layer) {
        table.add_copy(layer % distinct); // lead is a multiple of the period
    }
    return with_axis(*spline, axis,
                     {std::make_shared<const KnotVector>(knots.degree(), std::move(more)), std::move(table)});
}

} // namespace nrb
