#include "modify/constrain/constrain.h"

#include "modify/constrain/equations.h"
#include "modify/constrain/linear_constraints.h"
#include "modify/constrain/programming.h"

#include <algorithm>

namespace nrb {

Constrained constrain(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule,
                      double tolerance) {
    const Columns columns = make_columns(spline, conditions, rule);
    NetState state(spline, columns);
    if (columns.point_costs.empty() && columns.weight_costs.empty()) {
        check_influence(state, all_equations(state, conditions, tolerance)); // which none has
    }
    const bool linear = std::all_of(conditions.begin(), conditions.end(),
                                    [](const Condition &condition) { return condition.linear(); });
    return linear && columns.weight_costs.empty() ? solve_linear(state, conditions, tolerance)
                                                  : solve_by_programming(state, conditions, tolerance);
}

} // namespace nrb
