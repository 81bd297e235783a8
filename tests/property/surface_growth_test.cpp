// The work that surfaces take to meet grows with the pairs of pieces that cross, not with the pieces that there are.
#include "crossings.h"

#include <numbers>

namespace surface_growth_test {

using namespace surface_crossings;
using std::numbers::pi;

namespace {

// n x n pieces over [0, 1]^2, which cross those of level() in two curves for each wave, each of about n pairs of pieces.
SplineData waves_of(int n, int waves) {
    return net_of({n + 3, n + 3}, {3, 3}, true, [=](double u, double v) {
        return std::array<double, 4>{u, v, 0.1 * std::sin(2 * pi * waves * u) + 0.02 * std::cos(7 * v),
                                     1 + 0.3 * std::sin(5 * u + 4 * v)};
    });
}
SplineData level(int n) {
    return net_of({n + 3, n + 3}, {3, 3}, true, [](double u, double v) {
        return std::array<double, 4>{1.2 * u - 0.1, 1.2 * v - 0.1, 0.03 + 0.01 * std::sin(6 * u + 4 * v),
                                     1 + 0.3 * std::cos(5 * u - 4 * v)};
    });
}

// Whether all is told, as well as it is without a limit.
bool is_enough(const nurbs *a, const nurbs *b, int64_t work, int64_t branches) {
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    const Crossing crossing = crossing_of(a, b, 1e-4, &call);
    return crossing.found.complete && std::ssize(crossing.found.branches) == branches &&
           std::ranges::all_of(crossing.found.branches,
                               [](const Branch &branch) { return branch.deviation <= 1e-4; });
}

// The least limit of work that is enough, to 6 %.
double least_work(const nurbs *a, const nurbs *b, int64_t branches) {
    double high = 1e6;
    while (high < 1e12 && !is_enough(a, b, static_cast<int64_t>(high), branches)) {
        high *= 2;
    }
    double low = high / 2;
    while (high > 1.06 * low) {
        const double middle = (low + high) / 2;
        (is_enough(a, b, static_cast<int64_t>(middle), branches) ? high : low) = middle;
    }
    return high;
}

double work_of(int n, int waves) {
    const Handle a = create(waves_of(n, waves)), b = create(level(n));
    const double work = least_work(a.get(), b.get(), 2 * waves);
    std::printf("%d x %d pieces, %d curves: %.3g multiply-adds\n", n, n, 2 * waves, work);
    return work;
}

constexpr double about = 1.5;

// Eight times as many pairs cross, of 64 times as many pieces.
TEST(SurfaceGrowth, WorkFollowsThePairsThatCross) {
    EXPECT_LE(work_of(128, 1), about * 8 * work_of(16, 1));
}
TEST(SurfaceGrowth, WorkFollowsTheNumberOfCurves) {
    EXPECT_LE(work_of(64, 8), about * 8 * work_of(64, 1));
}

} // namespace

} // namespace surface_growth_test
