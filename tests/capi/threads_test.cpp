/* SPDX-License-Identifier: MIT */
// Eight threads on one handle: every function, tables built at first use by all at once, handles cloned and
// destroyed meanwhile. Results are those of one thread, bit for bit. Each thread has its own message.
#include "calls/calls.h"

#include "iges_text.h"
#include "shapes.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <pthread.h>
#include <thread>
#include <vector>

namespace {

constexpr int thread_count = 8;

// Threads count their failures apart: check.h is made for one thread.
std::atomic<int> thread_failures{0};

void expect(bool condition, const char *what) {
    if (!condition && thread_failures.fetch_add(1) < 20) {
        std::fprintf(stderr, "in a thread: %s is false\n", what);
    }
}

#define EXPECT(condition) expect(condition, #condition)

// All threads leave the gate at the same moment.
class Gate {
public:
    void wait() {
        ++waiting_;
        while (waiting_.load() < thread_count) {
            std::this_thread::yield();
        }
    }

private:
    std::atomic<int> waiting_{0};
};

template <class Body>
void in_threads(Body &&body) {
    Gate gate;
    std::array<std::thread, thread_count> threads;
    for (int i = 0; i < thread_count; ++i) {
        threads[static_cast<size_t>(i)] = std::thread([&, i] {
            gate.wait();
            body(i);
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
}

// Everything that can be asked about a spline, one number after the other.
class Answers {
public:
    explicit Answers(const nurbs *g) : g_(g) {
        EXPECT(nurbs_axes(g, &axes_) == NURBS_OK && nurbs_dimension(g, &dim_) == NURBS_OK);
        EXPECT(nurbs_point_count(g, &total_) == NURBS_OK);
        inspect();
        places();
        evaluate();
        grids();
        derive();
    }
    [[nodiscard]] bool operator==(const Answers &other) const {
        return values_.size() == other.values_.size() &&
               std::memcmp(values_.data(), other.values_.data(), values_.size() * sizeof(double)) == 0;
    }

private:
    static constexpr int64_t n_ = 40;

    double *more(int64_t n) {
        values_.resize(values_.size() + static_cast<size_t>(n));
        return values_.data() + values_.size() - n;
    }

    void inspect() {
        for (int32_t k = 0; k < axes_; ++k) {
            int32_t degree = 0, form = 0;
            int64_t count = 0, distinct = 0;
            EXPECT(nurbs_degree(g_, k, &degree) == NURBS_OK && nurbs_count(g_, k, &count) == NURBS_OK);
            EXPECT(nurbs_knot_form(g_, k, &form) == NURBS_OK);
            EXPECT(nurbs_knots(g_, k, count + degree + 1, more(count + degree + 1)) == NURBS_OK);
            EXPECT(nurbs_greville(g_, k, count, more(count)) == NURBS_OK);
            EXPECT(nurbs_domain(g_, k, more(2)) == NURBS_OK);
            EXPECT(nurbs_distinct_knots(g_, k, 0, nullptr, nullptr, &distinct) == NURBS_OK);
            EXPECT(nurbs_distinct_knots(g_, k, distinct, more(distinct), nullptr, &distinct) == NURBS_OK);
            active_ *= degree + 1;
        }
        EXPECT(nurbs_points(g_, total_, more(total_ * dim_), 0, 0) == NURBS_OK);
        EXPECT(nurbs_weights(g_, total_, more(total_), 0) == NURBS_OK);
        EXPECT(nurbs_homogeneous_points(g_, total_, more(total_ * (dim_ + 1)), 0, 0) == NURBS_OK);
    }

    void places() {
        for (int64_t i = 0; i < n_ * axes_; ++i) {
            double domain[2] = {0, 1};
            EXPECT(nurbs_domain(g_, static_cast<int32_t>(i % axes_), domain) == NURBS_OK);
            params_.push_back(domain[0] + (domain[1] - domain[0]) * static_cast<double>((i * 17) % 64) / 63);
        }
    }

    void evaluate() {
        int64_t slots = 0;
        std::vector<int64_t> spans(params_.size());
        EXPECT(nurbs_derivative_slots(axes_, 3, &slots) == NURBS_OK);
        EXPECT(nurbs_eval(g_, n_, params_.data(), 0, 0, more(n_ * dim_), 0, 0, 0) == NURBS_OK);
        EXPECT(nurbs_hull_size(g_, n_, params_.data(), 0, 0, more(n_), 0, 0) == NURBS_OK);
        EXPECT(nurbs_eval_derivs(g_, 3, n_, params_.data(), 0, 0, more(n_ * slots * dim_), 0, 0, 0) ==
               NURBS_OK);
        EXPECT(nurbs_rational_basis(g_, n_, params_.data(), 0, 0, spans.data(), more(n_ * active_), 0, 0,
                                    0) == NURBS_OK);
        const std::vector<double> given(static_cast<size_t>(n_ * dim_), 0.75);
        double *to_points = more(total_ * (dim_ + 1));
        EXPECT(nurbs_eval_adjoint(g_, 0, n_, params_.data(), 0, 0, given.data(), 0, 0, to_points, 0, 0,
                                  to_points + total_ * dim_, 0, nullptr, 0, 0, 0) == NURBS_OK);
        EXPECT(nurbs_rational_collocation(g_, nullptr, n_, params_.data(), 0, 0, n_ * active_,
                                          more(n_ * active_), nullptr, nullptr, nullptr, 0) == NURBS_OK);
        for (const int64_t span : spans) {
            *more(1) = static_cast<double>(span);
        }
    }

    // Three parameters an axis; those of all axes lie one axis after the other.
    void grids() {
        const int64_t counts[] = {3, 3, 3};
        std::vector<double> at;
        int64_t total = 1, slots = 0;
        for (int32_t k = 0; k < axes_; ++k) {
            double domain[2] = {0, 1};
            EXPECT(nurbs_domain(g_, k, domain) == NURBS_OK);
            at.insert(at.end(), {domain[1], domain[0], 0.3 * domain[0] + 0.7 * domain[1]});
            total *= 3;
        }
        EXPECT(nurbs_derivative_slots(axes_, 2, &slots) == NURBS_OK);
        EXPECT(nurbs_eval_grid(g_, counts, at.data(), more(total * dim_), 0, 0, 0) == NURBS_OK);
        EXPECT(nurbs_eval_grid_derivs(g_, 2, counts, at.data(), more(total * slots * dim_), 0, 0, 0) ==
               NURBS_OK);
    }

    void keep_points(nurbs *h) {
        int64_t total = 0;
        EXPECT(nurbs_point_count(h, &total) == NURBS_OK);
        EXPECT(nurbs_points(h, total, more(total * dim_), 0, 0) == NURBS_OK);
        EXPECT(nurbs_eval(h, 1, params_.data(), 0, 0, more(dim_), 0, 0, 0) == NURBS_OK);
        nurbs_destroy(h);
    }

    // New handles from the old one, which share what they can.
    void derive() {
        nurbs *h = nullptr;
        EXPECT(nurbs_insert_knot(g_, 0, params_[static_cast<size_t>(axes_)], 1, &h) == NURBS_OK);
        keep_points(h);
        std::vector<double> points(static_cast<size_t>(total_ * dim_));
        EXPECT(nurbs_points(g_, total_, points.data(), 0, 0) == NURBS_OK);
        EXPECT(nurbs_with_points(g_, points.data(), 0, 0, nullptr, 0, &h) == NURBS_OK);
        keep_points(h);
        if (axes_ > 1) {
            EXPECT(nurbs_iso(g_, axes_ - 1, params_[static_cast<size_t>(2 * axes_ - 1)], 0, &h) == NURBS_OK);
            keep_points(h);
        }
    }

    const nurbs *g_;
    int32_t axes_ = 1, dim_ = 1;
    int64_t total_ = 0, active_ = 1;
    std::vector<double> params_, values_;
};

const SplineArgs shapes[] = {arch(), circle(), hill(), loop(), jump(), stairs(), patch(), trough(), cube()};

// A fresh handle each round, so that every round builds its tables in all threads at once.
void first_use_by_all(const SplineArgs &a) {
    nurbs *alone = make(a);
    const Answers expected(alone);
    nurbs_destroy(alone);
    for (int round = 0; round < 20; ++round) {
        nurbs *g = make(a);
        in_threads([&](int) { EXPECT(Answers(g) == expected); });
        nurbs_destroy(g);
    }
}

// Each thread clones, asks its clone, and destroys it; the original dies while clones live.
void clones_come_and_go(const SplineArgs &a) {
    nurbs *g = make(a);
    const Answers expected(g);
    std::array<nurbs *, thread_count> own{};
    for (nurbs *&handle : own) {
        CHECK_OK(nurbs_clone(g, &handle));
    }
    nurbs_destroy(g);
    in_threads([&](int i) {
        nurbs *handle = own[static_cast<size_t>(i)];
        for (int round = 0; round < 30; ++round) {
            nurbs *next = nullptr;
            EXPECT(nurbs_clone(handle, &next) == NURBS_OK);
            nurbs_destroy(handle);
            handle = next;
            EXPECT(round % 10 != 0 || Answers(handle) == expected);
        }
        nurbs_destroy(handle);
    });
}

// The wrong parameter of each thread is in its own message, and nobody else's.
void messages_are_apart() {
    nurbs *g = make(arch());
    check_forget();
    char before[check_text_size], after[check_text_size];
    nurbs_last_error(before, check_text_size);
    in_threads([&](int i) {
        char text[check_text_size] = "x", wanted[64];
        EXPECT(nurbs_last_error(text, check_text_size) == 0 && text[0] == '\0');
        std::snprintf(wanted, sizeof wanted, "params[0] = %d ", i + 2);
        for (int round = 0; round < 500; ++round) {
            const double t = i + 2;
            double point[2];
            EXPECT(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0) == NURBS_ERROR_OUTSIDE_DOMAIN);
            nurbs_last_error(text, check_text_size);
            EXPECT(std::strstr(text, wanted) != nullptr);
        }
    });
    nurbs_last_error(after, check_text_size);
    CHECK(std::strcmp(before, after) == 0);
    nurbs_destroy(g);
}

// One list, read by all; its splines outlive it.
void lists_are_shared() {
    const IgesText file = small_file();
    nurbs_list *list = nullptr;
    CHECK_OK(nurbs_read(file.bytes, file.size, nullptr, &list));
    std::array<nurbs *, thread_count> taken{};
    in_threads([&](int i) {
        char name[16];
        int64_t count = 0;
        nurbs_list *own = nullptr;
        EXPECT(nurbs_list_count(list, &count) == NURBS_OK && count == 2);
        EXPECT(nurbs_list_name(list, 0, name, 16, nullptr) == NURBS_OK && std::strcmp(name, "126#1") == 0);
        EXPECT(nurbs_list_get(list, 0, &taken[static_cast<size_t>(i)]) == NURBS_OK);
        EXPECT(nurbs_read(file.bytes, file.size, nullptr, &own) == NURBS_OK);
        nurbs_list_destroy(own);
    });
    nurbs_list_destroy(list);
    const Answers expected(taken[0]);
    in_threads([&](int i) { EXPECT(Answers(taken[static_cast<size_t>(i)]) == expected); });
    for (nurbs *g : taken) {
        nurbs_destroy(g);
    }
}

// What a call returned and wrote, with the numbers of the splines that it made.
class Outcome {
public:
    Outcome(const calls::Call &call, const calls::Inputs &in) : status_(call.run(in, o_)) {
        int64_t count = 0;
        if (o_.list != nullptr) {
            EXPECT(nurbs_list_count(o_.list, &count) == NURBS_OK);
        }
        for (int64_t i = 0; i < count; ++i) {
            nurbs *g = nullptr;
            EXPECT(nurbs_list_get(o_.list, i, &g) == NURBS_OK);
            add_numbers(g);
            nurbs_destroy(g);
        }
        for (const nurbs *g : {o_.out, o_.other}) {
            if (g != check_poison()) {
                add_numbers(g);
            }
        }
        calls::destroy(o_);
    }
    [[nodiscard]] bool good() const noexcept { return status_ == NURBS_OK; }
    [[nodiscard]] bool operator==(const Outcome &other) const {
        return status_ == other.status_ && same(o_.values, other.o_.values) &&
               same(o_.singles, other.o_.singles) && same(o_.spans, other.o_.spans) &&
               same(o_.states, other.o_.states) && same(o_.text, other.o_.text) &&
               calls::same_bits(numbers_, other.numbers_);
    }

private:
    template <class T, size_t n>
    static bool same(const T (&a)[n], const T (&b)[n]) {
        return std::memcmp(a, b, sizeof a) == 0;
    }

    void add_numbers(const nurbs *g) {
        const std::vector<double> own = calls::numbers_of(g);
        EXPECT(!own.empty());
        numbers_.insert(numbers_.end(), own.begin(), own.end());
    }

    calls::Output o_;
    nurbs_status status_;
    std::vector<double> numbers_;
};

std::vector<calls::Call> all_calls() {
    const auto scalars = calls::scalar_calls();
    std::vector<calls::Call> all(scalars.begin(), scalars.end());
    calls::for_each_allocating([&](const calls::Call &call) { all.push_back(call); });
    return all;
}

void expect_same(const calls::Call &call, const calls::Inputs &in, const Outcome &expected) {
    if (!(Outcome(call, in) == expected)) {
        expect(false, call.name);
    }
}

// Each call by all threads at once over handles that were asked nothing before; then all calls over the same
// handles, each thread beginning with another one.
void every_function() {
    const std::vector<calls::Call> all = all_calls();
    std::vector<Outcome> expected;
    for (const calls::Call &call : all) {
        const calls::Inputs alone = calls::make_inputs(), shared = calls::make_inputs();
        expected.emplace_back(call, alone);
        expect(expected.back().good(), call.name);
        in_threads([&](int) { expect_same(call, shared, expected.back()); });
        calls::destroy(alone);
        calls::destroy(shared);
    }
    const calls::Inputs in = calls::make_inputs();
    in_threads([&](int thread) {
        for (size_t i = 0; i < all.size(); ++i) {
            const size_t at = (i + static_cast<size_t>(thread) * all.size() / thread_count) % all.size();
            expect_same(all[at], in, expected[at]);
        }
    });
    calls::check_intact(in);
    calls::destroy(in);
}

// What the header promises a caller with small threads. Sanitizers have frames of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
void small_stack() {}
#else
void small_stack() {
    const auto run_all = [](void *) -> void * {
        for (const calls::Call &call : all_calls()) {
            const calls::Inputs in = calls::make_inputs();
            const Outcome outcome(call, in);
            expect(outcome.good(), call.name);
            calls::destroy(in);
        }
        return nullptr;
    };
    pthread_attr_t attributes;
    pthread_t thread;
    EXPECT(pthread_attr_init(&attributes) == 0 && pthread_attr_setstacksize(&attributes, 128 << 10) == 0);
    EXPECT(pthread_create(&thread, &attributes, run_all, nullptr) == 0 && pthread_join(thread, nullptr) == 0);
    EXPECT(pthread_attr_destroy(&attributes) == 0);
}
#endif

} // namespace

int main() {
    const char *const path = "threads_test.igs";
    CHECK(calls::write_files(path));
    every_function();
    small_stack();
    calls::remove_files();
    for (const SplineArgs &a : shapes) {
        first_use_by_all(a);
        clones_come_and_go(a);
    }
    messages_are_apart();
    lists_are_shared();
    check_failures += thread_failures.load();
    return check_summary("threads");
}
