/* SPDX-License-Identifier: MIT */
// One good call, or a few, of every function of the library, for the tests whose laws all of them keep: when
// memory runs out, when threads share a handle, when numbers are extreme, and when arrays end where memory
// does. The outputs of two builds are compared for the same calls. README.md describes the table that they
// are generated from.
#ifndef NURBS_TESTS_CAPI_CALLS_H
#define NURBS_TESTS_CAPI_CALLS_H

#include "check.h"

#include "calls/generated/table.h"

#include <span>
#include <utility>
#include <vector>

namespace calls {

// What the calls are given, made afresh, because tables are built at first use.
Inputs make_inputs();
void destroy(const Inputs &in);
void check_intact(const Inputs &in); // they hold what fresh ones hold

// What a spline holds: its homogeneous points and its knots. Empty if it cannot be asked.
std::vector<double> numbers_of(const nurbs *g);
bool same_bits(std::span<const double> a, std::span<const double> b);

// Where a call writes: the arrays are long enough for all. A call makes a handle, or two, or a list, statistics, a face, a model, a meet, a mesh,
// or none.
struct Output {
    Output();
    nurbs *out = check_poison(), *other = check_poison();
    nurbs_list *list = nullptr;
    nurbs_statistics *statistics = nullptr;
    nurbs_face *face = nullptr;
    nurbs_model *model = nullptr;
    nurbs_meet *meet = nullptr;
    nurbs_mesh *mesh = nullptr;
    double values[1024];
    float singles[64];
    int64_t spans[64];
    int32_t states[64];
    char text[128];
};

void destroy(const Output &o);
void check_nothing_written(const Output &o);

struct Call {
    const char *name;
    nurbs_status (*run)(const Inputs &in, Output &o);
    bool can_do_without = false; // buffers of the C library for files, tables of evaluation
};

// All calls but scalar_calls(), for whose answers of a fixed size nothing is allocated.
std::vector<std::span<const Call>> allocating_groups();

template <class Visit>
void for_each_allocating(Visit &&visit) {
    for (const std::span<const Call> group : allocating_groups()) {
        for (const Call &call : group) {
            visit(call);
        }
    }
}

inline void destroy(nurbs *g) {
    nurbs_destroy(g);
}
inline void destroy(nurbs_list *list) {
    nurbs_list_destroy(list);
}
inline void destroy(nurbs_statistics *statistics) {
    nurbs_statistics_destroy(statistics);
}
inline void destroy(nurbs_face *face) {
    nurbs_face_destroy(face);
}
inline void destroy(nurbs_model *model) {
    nurbs_model_destroy(model);
}
inline void destroy(nurbs_meet *meet) {
    nurbs_meet_destroy(meet);
}
inline void destroy(nurbs_mesh *mesh) {
    nurbs_mesh_destroy(mesh);
}

// An input that is made for one call.
template <class Handle>
class Made {
public:
    Made(const Inputs &in, nurbs_status (*make)(const Inputs &, Handle **)) : status_(make(in, &handle_)) {}
    Made(const Made &) = delete;
    Made &operator=(const Made &) = delete;
    ~Made() { destroy(handle_); }
    [[nodiscard]] nurbs_status status() const { return status_; }
    operator const Handle *() const { return handle_; }
    // For a call that destroys it.
    Handle *release() { return std::exchange(handle_, nullptr); }

private:
    Handle *handle_ = nullptr;
    nurbs_status status_;
};

// The first n splines of a list, as an array.
template <int64_t n>
class Items {
public:
    explicit Items(const nurbs_list *list) {
        for (int64_t i = 0; i < n && status_ == NURBS_OK; ++i) {
            status_ = nurbs_list_get(list, i, &items_[i]);
        }
    }
    Items(const Items &) = delete;
    Items &operator=(const Items &) = delete;
    ~Items() {
        for (nurbs *g : items_) {
            nurbs_destroy(g);
        }
    }
    [[nodiscard]] nurbs_status status() const { return status_; }
    operator const nurbs * const *() const { return items_; }

private:
    nurbs *items_[n] = {};
    nurbs_status status_ = NURBS_OK;
};

// The files that nurbs_read_file() and nurbs_read_model_file() are called for, and one to be written over; each program writes its
// own, by names that begin alike.
extern const char *file_path, *solid_path, *replaced_path;
bool write_files(const char *path);
void remove_files();

} // namespace calls

#endif
