// Distances of two splines.
#include "checks.h"
#include "guard.h"

#include "base/tolerance.h"
#include "query/closest/hausdorff.h"
#include "query/closest/pair_search.h"

#include <algorithm>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t default_budget = 200000;

const Spline &named(const nurbs *g, const char *name) {
    require(g, name);
    return *g->spline;
}

int64_t checked_budget(int64_t budget) {
    check_length(budget, "budget");
    return budget == 0 ? default_budget : budget;
}

void copy(const std::array<double, max_axes> &params, int axes, double *out) noexcept {
    if (out != nullptr) {
        std::copy_n(params.begin(), axes, out);
    }
}

} // namespace

nurbs_status nurbs_distance(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                            double *at_least, double *at_most, double *params_a, double *params_b,
                            int32_t *status) {
    return guard([&] {
        const Spline &first = named(a, "a"), &second = named(b, "b");
        check_tolerance(tolerance);
        const int64_t most = checked_budget(budget);
        check_apart({memory("at_least", at_least, 1), memory("at_most", at_most, 1),
                     memory("params_a", params_a, first.axes()), memory("params_b", params_b, second.axes()),
                     memory("status", status, 1)},
                    {});
        const PairDistance found = pair_distance(first, second, tolerance, most);
        copy(found.params_a, first.axes(), params_a);
        copy(found.params_b, second.axes(), params_b);
        if (at_least != nullptr) {
            *at_least = found.at_least;
        }
        if (at_most != nullptr) {
            *at_most = found.at_most;
        }
        if (status != nullptr) {
            *status = found.certified ? NURBS_CLOSEST_CERTIFIED : NURBS_CLOSEST_BUDGET;
        }
    });
}

nurbs_status nurbs_hausdorff_distance(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                                      double *at_least, double *at_most, double *params_a, double *params_b,
                                      int32_t *status) {
    return guard([&] {
        const Spline &first = named(a, "a"), &second = named(b, "b");
        check_tolerance(tolerance);
        const int64_t most = checked_budget(budget);
        check_apart({memory("at_least", at_least, 2), memory("at_most", at_most, 2),
                     memory("params_a", params_a, first.axes()), memory("params_b", params_b, second.axes()),
                     memory("status", status, 1)},
                    {});
        const FarthestPoint there = one_sided_distance(first, second, tolerance, most);
        const FarthestPoint back = one_sided_distance(second, first, tolerance, most);
        copy(there.params, first.axes(), params_a);
        copy(back.params, second.axes(), params_b);
        if (at_least != nullptr) {
            at_least[0] = there.at_least;
            at_least[1] = back.at_least;
        }
        if (at_most != nullptr) {
            at_most[0] = there.at_most;
            at_most[1] = back.at_most;
        }
        if (status != nullptr) {
            *status = there.certified && back.certified ? NURBS_CLOSEST_CERTIFIED : NURBS_CLOSEST_BUDGET;
        }
    });
}
