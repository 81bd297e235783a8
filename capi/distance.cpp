// SPDX-License-Identifier: MIT
// Smallest distances and Hausdorff distances of two splines.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "base/tolerance.h"
#include "base/watch.h"
#include "closest/pair/hausdorff.h"
#include "closest/pair/pair_search.h"

#include <array>
#include <limits>
#include <span>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t default_budget = 200000;
constexpr int64_t default_far_budget = 2000000; // in each direction, pieces of both splines

// The limit of work if the caller sets none; a budget replaces it. Each of the two searches for Hausdorff
// distances, which go in small steps, gets a third of it.
int64_t work_of(int64_t budget, const Spline &a, const Spline &b) noexcept {
    return budget == 0 ? usual_work(a.point_count() + b.point_count())
                       : std::numeric_limits<int64_t>::max() / 2;
}

closest::FarthestPoint farthest(const Spline &from, const Spline &to, double tolerance, int64_t budget) {
    const UsualLimit usual(work_of(budget, from, to) / 3);
    return closest::one_sided_distance(from, to, tolerance, checked_budget(budget, default_far_budget));
}

// The same with half of the work that the caller's limit leaves; the rest is for the opposite direction.
closest::FarthestPoint farthest_with_half(const Spline &from, const Spline &to, double tolerance,
                                          int64_t budget) {
    const PartOfWork half;
    return farthest(from, to, tolerance, budget);
}

// Stores one parameter for each axis of the spline.
void put_params(double *out, const std::array<double, max_axes> &params, const Spline &spline) noexcept {
    put_all(out, std::span(params).first(static_cast<size_t>(spline.axes())));
}

} // namespace

nurbs_status nurbs_distance(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                            double *at_least, double *at_most, double *params_a, double *params_b,
                            int32_t *status) {
    return guard([&] {
        const Spline &first = named(a, "a"), &second = named(b, "b");
        check_tolerance(tolerance);
        const int64_t most = checked_budget(budget, default_budget);
        check_apart({memory("at_least", at_least, 1), memory("at_most", at_most, 1),
                     memory("params_a", params_a, first.axes()), memory("params_b", params_b, second.axes()),
                     memory("status", status, 1)},
                    {});
        const UsualLimit usual(work_of(budget, first, second));
        const closest::PairDistance found = closest::pair_distance(first, second, tolerance, most);
        put_params(params_a, found.params_a, first);
        put_params(params_b, found.params_b, second);
        put(at_least, found.at_least);
        put(at_most, found.at_most);
        put(status, bounds_status(found.certified));
    });
}

nurbs_status nurbs_hausdorff_distance(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                                      double *at_least, double *at_most, double *params_a, double *params_b,
                                      int32_t *status) {
    return guard([&] {
        const Spline &first = named(a, "a"), &second = named(b, "b");
        check_tolerance(tolerance);
        (void)checked_budget(budget, default_far_budget);
        check_apart({memory("at_least", at_least, 2), memory("at_most", at_most, 2),
                     memory("params_a", params_a, first.axes()), memory("params_b", params_b, second.axes()),
                     memory("status", status, 1)},
                    {});
        const closest::FarthestPoint there = farthest_with_half(first, second, tolerance, budget);
        const closest::FarthestPoint back = farthest(second, first, tolerance, budget);
        put_params(params_a, there.params, first);
        put_params(params_b, back.params, second);
        put_all(at_least, std::array{there.at_least, back.at_least});
        put_all(at_most, std::array{there.at_most, back.at_most});
        put(status, bounds_status(there.certified && back.certified));
    });
}
