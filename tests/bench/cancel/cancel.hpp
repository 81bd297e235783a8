// SPDX-License-Identifier: MIT
// How long a call lets its callback wait, and how soon it returns when it is cancelled.
#pragma once

#include <nurbs/nurbs.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

inline double now() { // milliseconds
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

struct Meter {
    explicit Meter(double moment) : stop(start + moment) {}

    // Whether the call is to go on.
    bool operator()(double) {
        const double time = now();
        gap = std::max(gap, time - last);
        last = time;
        if (time >= stop && stopped == 0) {
            stopped = time;
        }
        return stopped == 0;
    }
    static int32_t progress(double done, void *user) { return (*static_cast<Meter *>(user))(done) ? 0 : 1; }

    double start = now(), last = start, gap = 0, stop, stopped = 0;
};

struct Output {
    nurbs *out = nullptr, *other = nullptr;
    nurbs_list *list = nullptr;
    double values[16384];
    float singles[64];
    int64_t spans[64];
    int32_t states[1024];
    char text[128];
};

inline const std::string big = [] {
    std::ifstream file("big.igs", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}();

inline void good(nurbs_status status) {
    if (status != NURBS_OK) {
        char text[500];
        nurbs_last_error(text, sizeof text);
        std::printf("%s: %s\n", nurbs_status_name(status), text);
        std::exit(1);
    }
}

#ifdef NURBS_HPP
#endif
template <class Body>
nurbs_status status_of(Body &&body) {
    try {
        body();
        return NURBS_OK;
    } catch (const std::exception &) {
        return NURBS_ERROR_CANCELLED;
    }
}

// A whole call, then five that end at random moments. Prints: name, milliseconds of the call, the longest wait of the
// callback, the longest time from a callback that ends the call to its return.
template <class Call>
void measure(const char *name, const Call &call, Output &o) {
    const auto run = [&](Meter &meter) {
        const nurbs_status status = call(meter);
        const double end = now();
        nurbs_destroy(std::exchange(o.out, nullptr));
        nurbs_list_destroy(std::exchange(o.list, nullptr));
        meter.gap = std::max(meter.gap, end - meter.last);
        if (meter.stopped > 0 && status != NURBS_ERROR_CANCELLED) {
            std::printf("%s is not cancelled: %s\n", name, nurbs_status_name(status));
        }
        return end;
    };
    Meter whole(std::numeric_limits<double>::infinity());
    const double time = run(whole) - whole.start;
    double back = 0, gap = whole.gap;
    for (int i = 1; i <= 5; ++i) {
        Meter meter(time * std::fmod(0.6180339887498949 * i, 1.0) * 0.95);
        const double end = run(meter);
        back = meter.stopped > 0 ? std::max(back, end - meter.stopped) : back;
        gap = std::max(gap, meter.gap);
    }
    std::printf("%s %.1f %.1f %.1f\n", name, time, gap, back);
    std::fflush(stdout);
}
