/* SPDX-License-Identifier: MIT */
// The memory that calls need for their work: the same for a thousand points and for a million, so that there
// is no hidden copy of parameters or results; for grids it may follow the number of parameters on an axis,
// but not that of the grid's points.
#include "check.h"

#include "allocations.h"
#include "shapes.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr int64_t thousand = 1000, million = 1000000;
constexpr int64_t most_values = 24; // values that a call below writes for each point

struct Memory {
    int64_t allocations;
    int64_t peak; // bytes at once
};

template <class Call>
Memory memory_of(Call &&call) {
    allocations::begin();
    allocations::fail(0, false);
    CHECK_INT(call(), NURBS_OK);
    allocations::end();
    return {allocations::log.count, static_cast<int64_t>(allocations::log.peak)};
}

// Arrays for a million points, shared by all calls; parameters spread over (lower, upper).
struct Arrays {
    std::vector<double> params, values;
    std::vector<float> singles;
    std::vector<int32_t> states;

    Arrays() : params(3 * million), values(most_values * million), singles(4 * million), states(million) {}

    void spread(double lower, double upper) {
        for (size_t i = 0; i < params.size(); ++i) {
            const double part = std::fmod(static_cast<double>(i) * 0.6180339887498949, 1.0);
            params[i] = lower + (upper - lower) * part;
        }
    }
};

struct Call {
    const char *name;
    int axes; // that it is for; 0: any number
    nurbs_status (*run)(const nurbs *g, int64_t n, Arrays &arrays);
};

const Call calls[] = {
    {"eval", 0,
     [](const nurbs *g, int64_t n, Arrays &a) {
         return nurbs_eval(g, n, a.params.data(), 0, 0, a.values.data(), 0, 0, 0);
     }},
    {"eval with strides", 1,
     [](const nurbs *g, int64_t n, Arrays &a) {
         return nurbs_eval(g, n, a.params.data(), 3, 0, a.values.data(), 1, n, 0);
     }},
    {"eval_f32", 0,
     [](const nurbs *g, int64_t n, Arrays &a) {
         return nurbs_eval_f32(g, n, a.params.data(), 0, 0, a.singles.data(), 0, 0, 0);
     }},
    {"eval_derivs 1", 0,
     [](const nurbs *g, int64_t n, Arrays &a) {
         return nurbs_eval_derivs(g, 1, n, a.params.data(), 0, 0, a.values.data(), 0, 0, 0);
     }},
    {"eval_derivs 2", 1,
     [](const nurbs *g, int64_t n, Arrays &a) {
         return nurbs_eval_derivs(g, 2, n, a.params.data(), 0, 0, a.values.data(), 0, 0, 0);
     }},
    {"hull_size", 0,
     [](const nurbs *g, int64_t n, Arrays &a) {
         return nurbs_hull_size(g, n, a.params.data(), 0, 0, a.values.data(), 0, 0);
     }},
    {"surface_eval_frames", 2,
     [](const nurbs *g, int64_t n, Arrays &a) {
         double *v = a.values.data();
         return nurbs_surface_eval_frames(g, n, a.params.data(), 0, 0, v, 12, 0, v + 3, 12, 0, v + 6, 12, 0,
                                          v + 9, 12, 0, a.states.data(), 0);
     }},
    {"surface_eval_curvatures", 2,
     [](const nurbs *g, int64_t n, Arrays &a) {
         double *v = a.values.data();
         return nurbs_surface_eval_curvatures(g, n, a.params.data(), 0, 0, v, 2, 0, v + 2 * n, 6, 0,
                                              v + 8 * n, 1, v + 9 * n, 1, a.states.data(), 0);
     }},
    {"curve_eval_frames", 1,
     [](const nurbs *g, int64_t n, Arrays &a) {
         double *v = a.values.data();
         return nurbs_curve_eval_frames(g, n, a.params.data(), 0, v, 3, 0, v + 3 * n, 3, 0, v + 6 * n, 3, 0,
                                        nullptr, 0, 0, v + 9 * n, 1, nullptr, 0, a.states.data(), 0);
     }},
};

void check_call(const Call &call, const SplineArgs &shape, Arrays &arrays) {
    nurbs *fresh_for_few = make(shape), *fresh_for_many = make(shape);
    const Memory few = memory_of([&] { return call.run(fresh_for_few, thousand, arrays); });
    const Memory many = memory_of([&] { return call.run(fresh_for_many, million, arrays); });
    const Memory again = memory_of([&] { return call.run(fresh_for_many, million, arrays); });
    std::printf("%-24s %d axes: %lld bytes, then %lld\n", call.name, static_cast<int>(shape.axes),
                static_cast<long long>(many.peak), static_cast<long long>(again.peak));
    CHECK_INT(many.allocations, few.allocations);
    CHECK_INT(many.peak, few.peak);
    CHECK(again.allocations <= many.allocations && again.peak <= many.peak);
    nurbs_destroy(fresh_for_few);
    nurbs_destroy(fresh_for_many);
}

struct GridCall {
    const char *name;
    int axes; // 0: any number
    nurbs_status (*run)(const nurbs *g, const int64_t *counts, Arrays &arrays);
};

const GridCall grid_calls[] = {
    {"eval_grid", 0,
     [](const nurbs *g, const int64_t *counts, Arrays &a) {
         return nurbs_eval_grid(g, counts, a.params.data(), a.values.data(), 0, 0, 0);
     }},
    {"eval_grid_derivs 1", 0,
     [](const nurbs *g, const int64_t *counts, Arrays &a) {
         return nurbs_eval_grid_derivs(g, 1, counts, a.params.data(), a.values.data(), 0, 0, 0);
     }},
    {"eval_grid_f32", 0,
     [](const nurbs *g, const int64_t *counts, Arrays &a) {
         return nurbs_eval_grid_f32(g, counts, a.params.data(), a.singles.data(), 0, 0, 0);
     }},
    {"surface_eval_grid_frames", 2,
     [](const nurbs *g, const int64_t *counts, Arrays &a) {
         double *v = a.values.data();
         return nurbs_surface_eval_grid_frames(g, counts, a.params.data(), v, 12, 0, v + 3, 12, 0, v + 6, 12,
                                               0, v + 9, 12, 0, a.states.data(), 0);
     }},
};

// From `small` to `large` parameters on each axis the memory grows no faster than their number.
void check_grid(const GridCall &call, const SplineArgs &shape, int64_t small, int64_t large, Arrays &arrays) {
    const int64_t small_counts[] = {small, small, small}, large_counts[] = {large, large, large};
    nurbs *g = make(shape);
    const Memory first = memory_of([&] { return call.run(g, small_counts, arrays); });
    const Memory few = memory_of([&] { return call.run(g, small_counts, arrays); });
    const Memory many = memory_of([&] { return call.run(g, large_counts, arrays); });
    std::printf("%-24s %d axes: %lld bytes with %lld parameters on each, %lld with %lld\n", call.name,
                static_cast<int>(shape.axes), static_cast<long long>(few.peak), static_cast<long long>(small),
                static_cast<long long>(many.peak), static_cast<long long>(large));
    CHECK(few.peak <= first.peak);
    CHECK(many.peak * small <= few.peak * large);
    nurbs_destroy(g);
}

// A bend that no net of a bearable size approximates does not try larger ones.
void check_bend() {
    constexpr int32_t degrees[] = {3, 3, 3};
    constexpr int64_t counts[] = {10, 10, 10};
    constexpr double origin[] = {0, 0, 0}, along[] = {1, 0, 0}, across[] = {0, 1, 0};
    constexpr int64_t most = 500000000;
    std::vector<double> knots, points;
    for (int i = 0; i < 3 * 14; ++i) {
        knots.push_back(std::fmin(std::fmax(i % 14 - 3, 0), 7));
    }
    for (int i = 0; i < 3000; ++i) {
        points.push_back(std::fmod(i * 0.6180339887498949, 1.0));
    }
    nurbs *g = nullptr, *bent = nullptr;
    CHECK_INT(nurbs_create(3, degrees, counts, knots.data(), std::ssize(knots), 3, points.data(), 0, 0,
                           nullptr, 0, 0, &g),
              NURBS_OK);
    allocations::begin();
    allocations::fail(0, false);
    CHECK_INT(nurbs_bend(g, origin, along, across, 2, -0.5, 0.5, 1e-9, nullptr, nullptr, &bent),
              NURBS_ERROR_NOT_CONVERGED);
    allocations::end();
    std::printf("bend %lld bytes\n", static_cast<long long>(allocations::log.peak));
    CHECK(static_cast<int64_t>(allocations::log.peak) < most);
    nurbs_destroy(g);
}

} // namespace

int main() {
    if (allocations_belong_to_a_sanitizer) {
        std::puts("skipped: the sanitizer replaces malloc itself");
        return 77;
    }
    check_bend();
    Arrays arrays;
    for (const SplineArgs &shape : {circle(), arch(), loop(), trough(), cube()}) {
        const bool periodic = shape.flags != 0;
        arrays.spread(periodic ? shape.knots[shape.degrees[0]] : 0,
                      periodic ? shape.knots[shape.counts[0]] : 1);
        for (const Call &call : calls) {
            if (call.axes == 0 || call.axes == shape.axes) {
                check_call(call, shape, arrays);
            }
        }
        for (const GridCall &call : grid_calls) {
            if (shape.axes > 1 && (call.axes == 0 || call.axes == shape.axes)) {
                check_grid(call, shape, shape.axes == 2 ? 32 : 10, shape.axes == 2 ? 1000 : 100, arrays);
            }
        }
    }
    return check_summary("working_memory");
}
