/* SPDX-License-Identifier: MIT */
// Threads end calls at random moments while others ask the same new handles, and get the answers that they would
// get alone. A callback may throw, and may end its thread.
#include "long_calls.h"

#include <array>
#include <atomic>
#include <cstring>
#include <memory>
#include <pthread.h>
#include <random>
#include <stdexcept>
#include <thread>

namespace {

// Threads count their failures apart: check.h is made for one thread.
std::atomic<int> failures{0};

void expect(bool condition, const char *what) {
    if (!condition && failures.fetch_add(1) < 20) {
        std::fprintf(stderr, "in a thread: %s is false\n", what);
    }
}

struct Moment {
    int after;
    bool throws;
};

int32_t end_at(double /*done*/, void *user) {
    Moment &moment = *static_cast<Moment *>(user);
    if (moment.after-- > 0) {
        return 0;
    }
    if (moment.throws) {
        throw std::runtime_error("from the callback");
    }
    return 1;
}

std::unique_ptr<LongResult> fresh() {
    auto result = std::make_unique<LongResult>();
    std::memset(static_cast<void *>(result.get()), 0, sizeof(LongResult));
    return result;
}

// Asks for nearest points again and again; each call builds the tables of the handle if no other has built them.
void cancel(const LongShapes *shapes, unsigned seed) {
    std::mt19937 random(seed);
    for (int i = 0; i < 6; ++i) {
        Moment moment{static_cast<int>(random() % 4), random() % 2 == 0};
        nurbs_call_options call;
        expect(nurbs_call_options_init(&call, sizeof call) == NURBS_OK, "init");
        call.progress = end_at;
        call.user = &moment;
        const auto result = fresh();
        const nurbs_status status = long_closest_points(shapes, 0, &call, result.get());
        expect(status == NURBS_ERROR_CANCELLED || (status == NURBS_OK && moment.after >= 0),
               "cancelled or finished");
    }
}

void ask(const LongShapes *shapes, const LongResult *wanted) {
    const auto result = fresh();
    expect(long_closest_points(shapes, 0, nullptr, result.get()) == NURBS_OK, "the call is good");
    expect(std::memcmp(result->values, wanted->values, sizeof wanted->values) == 0, "the same bits");
}

struct Ending {
    const LongShapes *shapes;
    int told = 0, freed = 0;
};
struct Freed {
    Ending *ending;
    ~Freed() { ++ending->freed; }
};

int32_t end_thread(double /*done*/, void *user) {
    ++static_cast<Ending *>(user)->told;
    pthread_exit(nullptr);
}

void *end_in_callback(void *given) {
    Ending &ending = *static_cast<Ending *>(given);
    const Freed freed{&ending}; // as everything is that the thread holds
    nurbs_call_options call;
    expect(nurbs_call_options_init(&call, sizeof call) == NURBS_OK, "init");
    call.progress = end_thread;
    call.user = &ending;
    const auto result = fresh();
    long_critical_points(ending.shapes, 0, &call, result.get()); // takes some 10 ms times the size
    expect(ending.told == 0, "the thread goes on after its end");
    return nullptr;
}

// Returns whether the callback was called.
bool thread_that_ends(const LongShapes *shapes, const LongResult *wanted) {
    Ending ending{shapes};
    pthread_t thread{};
    CHECK_INT(pthread_create(&thread, nullptr, end_in_callback, &ending), 0);
    CHECK_INT(pthread_join(thread, nullptr), 0);
    CHECK_INT(ending.freed, 1);
    ask(shapes, wanted);
    return ending.told == 1;
}

} // namespace

int main() {
    const char *scale = std::getenv("NURBS_TEST_SCALE");
    const double size = scale != nullptr && std::atof(scale) < 1 ? 1 : 20;
    const auto wanted = fresh();
    LongShapes *shapes = long_shapes(size);
    CHECK(long_closest_points(shapes, 1, nullptr, wanted.get()) == NURBS_OK);
    for (unsigned round = 0; round < 3; ++round) {
        nurbs *again = nullptr; // the same surface, without tables
        CHECK(nurbs_reverse(shapes->rough, 0, 0, &again) == NURBS_OK);
        nurbs *back = nullptr;
        CHECK(nurbs_reverse(again, 0, 0, &back) == NURBS_OK);
        nurbs_destroy(again);
        nurbs_destroy(shapes->rough);
        shapes->rough = back;
        std::array<std::thread, 6> threads;
        for (unsigned i = 0; i < threads.size(); ++i) {
            threads[i] = std::thread(
                [&, i] { i % 2 == 0 ? cancel(shapes, 10 * round + i) : ask(shapes, wanted.get()); });
        }
        for (std::thread &thread : threads) {
            thread.join();
        }
        CHECK(thread_that_ends(shapes, wanted.get()) || size < 20);
    }
    CHECK_INT(failures.load(), 0);
    long_destroy(shapes);
    return check_summary("long_calls_threads");
}
