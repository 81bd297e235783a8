// SPDX-License-Identifier: MIT
// Long calls of the C++ wrapper: progress, exceptions of the callback, limits of work.
#include "expect.hpp"

#include <stdexcept>
#include <string>

using libnurbs::CallOptions;
using libnurbs::Spline;

// A curve that runs to and fro, so that its length takes a while.
static Spline winding(std::int64_t count) {
    std::vector<double> points, knots = libnurbs::knots_open_uniform(3, count, 0, 1);
    for (std::int64_t i = 0; i < count; ++i) {
        points.push_back(std::sin(static_cast<double>(i * i)));
        points.push_back(std::cos(static_cast<double>(3 * i * i)));
    }
    return Spline::create({3}, {count}, knots, 2, points);
}

static void progress(const Spline &curve) {
    const double alone = libnurbs::length(curve, 1e-9).value;
    double last = 0;
    int calls = 0;
    CallOptions call;
    call.progress = [&](double done) {
        EXPECT(done >= last && done <= 1);
        last = done;
        ++calls;
        return true;
    };
    EXPECT(libnurbs::length(curve, 1e-9, {}, call).value == alone);
    EXPECT(calls > 0);
}

static void ends(const Spline &curve) {
    CallOptions call;
    call.progress = [](double) { return false; };
    EXPECT(status_of([&] { libnurbs::length(curve, 1e-9, {}, call); }) == libnurbs::Status::cancelled);
    call.progress = [](double) -> bool { throw std::runtime_error("own"); };
    bool thrown = false;
    try {
        libnurbs::length(curve, 1e-9, {}, call);
    } catch (const std::runtime_error &error) {
        thrown = std::string(error.what()) == "own";
    }
    EXPECT(thrown);
    call = {};
    call.work = 1;
    EXPECT(status_of([&] { libnurbs::length(curve, 1e-9, {}, call); }) == libnurbs::Status::work);
    EXPECT(libnurbs::length(curve, 1e-9).value > 0);
}

int main() {
    const Spline curve = winding(200000);
    progress(curve);
    ends(curve);
    return failures == 0 ? 0 : 1;
}
