/* SPDX-License-Identifier: MIT */
// Every function with its allocations failing, one after the other: the memory status, no handle, no leak, nothing
// written, inputs intact, and the same call succeeds afterwards. Then: what evaluation allocates, and what a
// handle costs.
#include "calls/calls.h"

#include "allocations.h"
#include "shapes.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

using calls::Call, calls::Inputs, calls::Output;

namespace {

void scalars_allocate_nothing() {
    const Inputs in = calls::make_inputs();
    for (const Call &call : calls::scalar_calls()) {
        Output o;
        allocations::begin();
        allocations::fail(1, true);
        CHECK_INT(call.run(in, o), NURBS_OK);
        CHECK(!allocations::log.failed);
        allocations::fail(0, false);
        allocations::end();
    }
    calls::destroy(in);
}

// The call after one that was refused.
void check_recovery(const Call &call, const Inputs &in) {
    Output again;
    CHECK_INT(call.run(in, again), NURBS_OK);
    calls::destroy(again);
}

// One attempt with allocation k failing; returns whether there was one.
bool attempt(const Call &call, int64_t k, bool on) {
    const int before = check_failures;
    allocations::begin();
    const Inputs in = calls::make_inputs();
    Output o;
    check_forget();
    allocations::fail(k, on);
    const nurbs_status status = call.run(in, o);
    const bool failed = allocations::log.failed;
    allocations::fail(0, false);
    if (failed && !(call.can_do_without && status == NURBS_OK)) {
        CHECK_INT(status, NURBS_ERROR_MEMORY);
        calls::check_nothing_written(o);
        calls::check_intact(in);
        check_recovery(call, in);
    } else {
        CHECK_INT(status, NURBS_OK);
        calls::destroy(o);
    }
    calls::destroy(in);
    CHECK_INT(allocations::log.live, 0);
    allocations::end();
    if (check_failures != before) {
        std::fprintf(stderr, "    ... in %s, allocation %lld%s\n", call.name, static_cast<long long>(k),
                     on ? " and all that follow" : "");
    }
    return failed;
}

bool all_of_them = false;

// The first thirty-two, and of later ones, which are made in loops, fewer and fewer, unless all are asked for.
int64_t next_one(int64_t k) {
    return k + (all_of_them ? 1 : 1 + k / 32);
}

void every_allocation_fails(const Call &call) {
    int64_t k = 1;
    while (attempt(call, k, false) && attempt(call, k, true)) {
        k = next_one(k);
    }
    std::printf("%-24s %lld allocations, or fewer\n", call.name, static_cast<long long>(k - 1));
}

// Batches of more than one block, so that memory may run out when others are done.
constexpr int64_t many = 70;
using Places = std::array<double, static_cast<size_t>(3 * many)>;

// `width` coordinates of each place, between 0 and 1; a third coordinate is `height`.
template <size_t width>
const double *places(double height = 0) {
    static Places values;
    for (size_t i = 0; i < static_cast<size_t>(many); ++i) {
        for (size_t c = 0; c < width; ++c) {
            values[i * width + c] = c == 2 ? height : static_cast<double>((i + 1) * (c + 7) % 29) / 29;
        }
    }
    return values.data();
}

const double *downwards() {
    static Places values;
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] = i % 3 == 2 ? -1 : 0.01 * static_cast<double>(i % 5);
    }
    return values.data();
}

const Call long_batches[] = {
    {"closest_points, many",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_points(in.curve, many, places<2>(), 0, 0, nullptr, 0, 0, o.values, 0, 0,
                                     o.values + many, 0, 0, o.values + 3 * many, 0, nullptr, 0);
     }},
    {"face_classify, many",
     [](const Inputs &in, Output &o) {
         return nurbs_face_classify(in.face, many, places<2>(), 0, 0, 1e-2,
                                    reinterpret_cast<int32_t *>(o.values));
     }},
    {"surface_rays, many",
     [](const Inputs &in, Output &o) {
         return nurbs_surface_rays(in.surface, many, places<3>(9), 0, 0, downwards(), 0, 0, o.values,
                                   o.values + 2 * many, nullptr);
     }},
    {"face_rays, many",
     [](const Inputs &in, Output &o) {
         return nurbs_face_rays(in.face, many, places<3>(9), 0, 0, downwards(), 0, 0, o.values,
                                o.values + 2 * many, nullptr);
     }},
};

// Allocations of the second call of `run`: the first one may build tables.
template <class Run>
int64_t repeated_cost(Run &&run) {
    run();
    allocations::begin();
    allocations::fail(0, false);
    run();
    const int64_t count = allocations::log.count;
    allocations::end();
    return count;
}

int64_t eval_cost(const nurbs *g, int axes, int64_t n, int32_t order) {
    std::vector<double> at(static_cast<size_t>(n * axes), 0.3), out(static_cast<size_t>(n * 40 * 4));
    return repeated_cost([&] {
        CHECK(order < 0 ? nurbs_eval(g, n, at.data(), 0, 0, out.data(), 0, 0, 0) == NURBS_OK
                        : nurbs_eval_derivs(g, order, n, at.data(), 0, 0, out.data(), 0, 0, 0) == NURBS_OK);
    });
}

int64_t grid_cost(const nurbs *g, int axes, int64_t side, int32_t order) {
    const int64_t counts[] = {side, side, side};
    std::vector<double> at(static_cast<size_t>(side * axes), 0.3),
        out(static_cast<size_t>(side * side * side * 40));
    return repeated_cost([&] {
        CHECK(order < 0
                  ? nurbs_eval_grid(g, counts, at.data(), out.data(), 0, 0, 0) == NURBS_OK
                  : nurbs_eval_grid_derivs(g, order, counts, at.data(), out.data(), 0, 0, 0) == NURBS_OK);
    });
}

int64_t linear_cost(const nurbs *g, int axes, int64_t n) {
    const auto size = static_cast<size_t>(n);
    std::vector<double> at(size * static_cast<size_t>(axes), 0.3), values(size * 8), to_params(at);
    std::vector<double> given(size * 40), net(1024), weights(256);
    std::vector<int64_t> columns(size * 8), rows(size + 1);
    return repeated_cost([&] {
        CHECK(nurbs_rational_collocation(g, nullptr, n, at.data(), 0, 0, 8 * n, values.data(), columns.data(),
                                         rows.data(), nullptr, 0) == NURBS_OK);
        CHECK(nurbs_eval_adjoint(g, 1, n, at.data(), 0, 0, given.data(), 0, 0, net.data(), 0, 0,
                                 weights.data(), 0, to_params.data(), 0, 0, 0) == NURBS_OK);
    });
}

int64_t frame_cost(const nurbs *g, int64_t n) {
    std::vector<double> at(static_cast<size_t>(2 * n), 0.3), out(static_cast<size_t>(n * 3));
    return repeated_cost([&] {
        CHECK(nurbs_surface_eval_frames(g, n, at.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                        out.data(), 0, 0, nullptr, 0) == NURBS_OK);
    });
}

// A call with a new handle, each of its allocations failing: nothing is written. Tables for single points are
// made at the first call.
template <class Make, class Run>
void writes_nothing_without_memory(Make &&make_handle, Run &&run) {
    bool failed = true;
    for (int64_t k = 1; failed; ++k) {
        double out[32];
        nurbs *g = make_handle();
        FILL(out);
        check_forget();
        allocations::begin();
        allocations::fail(k, false);
        const nurbs_status status = run(g, out);
        failed = allocations::log.failed;
        allocations::fail(0, false);
        allocations::end();
        if (status != NURBS_OK) {
            CHECK_INT(status, NURBS_ERROR_MEMORY);
            CHECK_UNTOUCHED(out);
        }
        nurbs_destroy(g);
    }
}

void first_calls_write_nothing_without_memory() {
    static const double at[] = {0.25, 0.5, 0.125};
    const auto point = [](const nurbs *g, double *out) { return nurbs_eval(g, 1, at, 0, 0, out, 0, 0, 0); };
    for (const SplineArgs &a : {arch(), circle(), patch(), cube()}) {
        writes_nothing_without_memory([&] { return make(a); }, point);
    }
    writes_nothing_without_memory([] { return make(patch()); },
                                  [](const nurbs *g, double *out) {
                                      return nurbs_surface_eval_frames(g, 1, at, 0, 0, out, 0, 0, out + 3, 0,
                                                                       0, out + 6, 0, 0, out + 9, 0, 0,
                                                                       nullptr, 0);
                                  });
    const auto homogeneous = [] {
        const int32_t degree = 1;
        const int64_t count = 3;
        const double knots[] = {0, 0, 1, 2, 2}, records[] = {0, 1, 2, 2, 3, 1};
        nurbs *g = nullptr;
        CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 5, 1, records, 0, 0, 0, &g));
        return g;
    };
    writes_nothing_without_memory(homogeneous, [](const nurbs *g, double *out) {
        int64_t count = 0;
        return nurbs_bezier_pieces(g, 2, out, out + 8, out + 16, nullptr, &count);
    });
}

void frames_allocate_nothing_per_point() {
    nurbs *g = make(trough());
    CHECK_INT(frame_cost(g, 100), frame_cost(g, 1000));
    nurbs_destroy(g);
}

void evaluation_allocates_nothing_per_point() {
    const SplineArgs shapes[] = {circle(), arch(), loop(), trough(), cube()};
    for (const SplineArgs &a : shapes) {
        SplineArgs b = a;
        static const double shifted[] = {-2, -1, 0, 1, 2, 3, 4, 5, 6};
        b.knots = a.flags != 0 ? shifted : a.knots; /* so that 0.3 lies in every domain */
        nurbs *g = make(b);
        for (int32_t order = -1; order < 3; ++order) {
            CHECK_INT(eval_cost(g, a.axes, 100, order), eval_cost(g, a.axes, 1000, order));
            CHECK_INT(grid_cost(g, a.axes, 10, order), grid_cost(g, a.axes, 20, order));
        }
        CHECK_INT(linear_cost(g, a.axes, 100), linear_cost(g, a.axes, 1000));
        if (a.axes < 3) {
            CHECK_INT(eval_cost(g, a.axes, 1000, -1), 0);
        }
        nurbs_destroy(g);
    }
}

// A handle costs its data once and at most 1 KiB.
void handles_cost_their_data(int64_t count, bool rational) {
    const int32_t degree = 3, dim = 3;
    const int64_t knot_count = count + degree + 1;
    std::vector<double> knots(static_cast<size_t>(knot_count)), points(static_cast<size_t>(count * dim), 0.5);
    const std::vector<double> weights(static_cast<size_t>(count), 1.5);
    CHECK_OK(nurbs_knots_uniform(degree, count, 0, 1, knot_count, knots.data()));
    nurbs *g = nullptr;
    allocations::begin();
    CHECK_OK(nurbs_create(1, &degree, &count, knots.data(), knot_count, dim, points.data(), 0, 0,
                          rational ? weights.data() : nullptr, 0, 0, &g));
    const auto data = static_cast<size_t>(knot_count + count * dim + (rational ? count : 0)) * sizeof(double);
    const size_t bytes = allocations::log.held;
    std::printf("%7lld points, %s: %zu bytes beside %zu of data\n", static_cast<long long>(count),
                rational ? "rational" : "polynomial", bytes - data, data);
    CHECK(bytes >= data && bytes <= data + 1024);
    nurbs *clone = nullptr;
    CHECK_OK(nurbs_clone(g, &clone));
    CHECK(allocations::log.held <= bytes + 256);
    nurbs_destroy(clone);
    nurbs_destroy(g);
    CHECK_INT(allocations::log.live, 0);
    allocations::end();
}

} // namespace

// With the argument "all" every allocation of every call fails once, which takes minutes.
int main(int argc, char **argv) {
    all_of_them = argc > 1 && std::strcmp(argv[1], "all") == 0;
    if (allocations_belong_to_a_sanitizer) {
        std::puts("skipped: the sanitizer replaces malloc itself");
        return 77;
    }
    const char *const path = "allocation_failure_test.igs";
    CHECK(calls::write_files(path));
    scalars_allocate_nothing();
    calls::for_each_allocating(every_allocation_fails);
    for (const Call &call : long_batches) {
        every_allocation_fails(call);
    }
    first_calls_write_nothing_without_memory();
    evaluation_allocates_nothing_per_point();
    frames_allocate_nothing_per_point();
    for (const int64_t count : {10, 100, 1000, 10000, 100000}) {
        handles_cost_their_data(count, false);
        handles_cost_their_data(count, true);
    }
    calls::remove_files();
    return check_summary("allocation_failure");
}
