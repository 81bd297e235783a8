/* SPDX-License-Identifier: MIT */
// One good call, or a few, of every function of the library, for the tests whose laws all of them keep: when
// memory runs out, when threads share a handle, when numbers are extreme, and when arrays end where memory
// does. The outputs of two builds are compared for the same calls.
#ifndef NURBS_TESTS_CAPI_CALLS_H
#define NURBS_TESTS_CAPI_CALLS_H

#include "check.h"

#include "shapes.h"

#include <span>
#include <vector>

namespace calls {

// What the calls are given, made afresh with make_inputs(), because tables are built at first use.
struct Inputs {
    nurbs *curve, *loop, *surface, *volume, *homogeneous, *twist, *segment;
    nurbs_list *list;
};

Inputs make_inputs();
void destroy(const Inputs &in);
void check_intact(const Inputs &in); // they hold what fresh ones hold

// What a spline holds: its homogeneous points and its knots. Empty if it cannot be asked.
std::vector<double> numbers_of(const nurbs *g);
bool same_bits(std::span<const double> a, std::span<const double> b);

// Where a call writes: the arrays are long enough for all. A call makes a handle, or a list, or neither.
struct Output {
    Output();
    nurbs *out = check_poison();
    nurbs_list *list = nullptr;
    double values[1024];
    float singles[64];
    int64_t spans[64];
    int32_t states[64];
    char text[64];
};

void destroy(const Output &o);
void check_nothing_written(const Output &o);

struct Call {
    const char *name;
    nurbs_status (*run)(const Inputs &in, Output &o);
    bool can_do_without = false; // buffers of the C library for files, tables of evaluation
};

// Those of one kind, each in a file of its own.
std::span<const Call> scalar_calls(); // fixed-size answers, for which nothing is allocated
std::span<const Call> data_calls();
std::span<const Call> evaluation_calls();
std::span<const Call> form_calls();
std::span<const Call> query_calls();
std::span<const Call> shape_calls();
std::span<const Call> edit_calls();

// All of those that may allocate.
template <class Visit>
void for_each_allocating(Visit &&visit) {
    for (const std::span<const Call> group :
         {data_calls(), evaluation_calls(), form_calls(), query_calls(), shape_calls(), edit_calls()}) {
        for (const Call &call : group) {
            visit(call);
        }
    }
}

// The file that nurbs_read_file() is called for; each program writes its own.
extern const char *file_path;
bool write_file(const char *path);

inline constexpr double new_knots[] = {0.3, 0.6};
inline constexpr double params[] = {0.1, 0.9, 0.3, 0.7, 0.2, 0.6};

} // namespace calls

#endif
