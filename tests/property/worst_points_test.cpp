// The bound for points is for every spline, not for average ones: a search that climbs towards the largest
// error. The sum of the errors of the basis functions is the error of the curve whose control points are +1
// and -1 with the signs of those errors.
#include "reference/exact_basis.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace worst_points_test {

using namespace support;
using reference::eps;

namespace {

struct Trial {
    SplineData data; // hull 1
    double t = 0;
    long double error = -1; // of the basis functions together, in eps
};

Trial measure(const std::vector<double> &knots, int degree, double t) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    Trial trial;
    trial.t = t;
    trial.error = 0;
    trial.data = {{degree}, {count}, {knots}, 1, std::vector<double>(static_cast<size_t>(count), 1), {}, 0};
    std::vector<double> values(static_cast<size_t>(degree) + 1);
    require_ok(nurbs_basis(degree, count, knots.data(), static_cast<int64_t>(knots.size()), 0, 1, &t, 0,
                           nullptr, values.data(), 0, 0, 0));
    const auto want = reference::exact_basis(knots, degree, t, 0);
    for (size_t j = 0; j < values.size(); ++j) {
        const reference::Fraction exact = {want.numerators[0][j], want.denominator};
        trial.error += reference::distance(values[j], exact) / eps;
        const bool above = values[j] > reference::quotient(exact.numerator, exact.denominator);
        trial.data.points[static_cast<size_t>(want.span - degree) + j] = above ? 1 : -1;
    }
    return trial;
}

// The parameter or some of the knots moved a little; a trial that loses if that leaves no domain.
Trial neighbour(Random &random, const Trial &trial) {
    const int degree = trial.data.degrees[0];
    auto knots = trial.data.knots[0];
    double t = trial.t;
    const double step = (trial.data.upper(0) - trial.data.lower(0)) * random.magnitude(1e-15, 0.1);
    if (random.chance(50)) {
        t += step * random.between(-1, 1);
    } else {
        for (double &knot : knots) {
            knot += random.chance(30) ? step * random.between(-1, 1) : 0;
        }
        std::sort(knots.begin(), knots.end());
    }
    const double lower = knots[static_cast<size_t>(degree)];
    const double upper = knots[knots.size() - static_cast<size_t>(degree) - 1];
    return lower < upper ? measure(knots, degree, std::clamp(t, lower, upper)) : Trial{};
}

long double point_error(const Trial &trial) {
    const double value = eval(create(trial.data).get(), {trial.t})[0];
    return reference::error_ratio(value, reference::exact_point(trial.data, &trial.t)[0], eps);
}

TEST(WorstPoints, climbing_stays_within_the_bound) {
    WorstErrors worst("climbing to the worst polynomial curve, unit eps * hull");
    for (int degree = 1; degree <= 15; ++degree) {
        for_each_case(7000000 + 100 * static_cast<uint64_t>(degree), 3, [&](Random &random, uint64_t seed) {
            Trial best;
            for (int i = 0; i < 900; ++i) {
                const bool fresh = i < 400;
                Trial next;
                if (fresh) {
                    const auto knots = random_knots(random, random_axis(random, degree));
                    next = measure(knots, degree, random_param(random, knots, degree));
                } else {
                    next = neighbour(random, best);
                }
                best = next.error > best.error ? next : best;
            }
            const long double error = point_error(best);
            worst.add(degree, error / reference::c_of(degree), error);
            EXPECT_LE(error, reference::c_of(degree)) << where(seed, best.data) << "at " << hex(best.t);
        });
    }
}

// Constant curves: the exact value is 1 whatever the knots are.
TEST(WorstPoints, known_hard_knots) {
    struct Case {
        int degree;
        double t;
        std::vector<double> knots; // the 2 p knots that shape the span, and one at either end
    };
    const Case cases[] = {
        {5,
         0x1.9c510a1d78d67p-28,
         {0x1.be33e306c3492p-39, 0x1.be33e306c3492p-39, 0x1.fd9fa8f6b3a3ep-37, 0x1.3a673947062a7p-32,
          0x1.b513a7df2bb04p-31, 0x1.12e0be826a8c1p-29, 0x1.9c511c201dcc4p-28, 0x1.9c511dc3a41ep-28,
          0x1.9c511dc3a41ep-28, 0x1.9c511dc3a41ep-28, 0x1.9c511dc3a41ep-28, 0x1.9c511dc3a41ep-28}},
        {7,
         0x1.9c506ffeaaa77p-29,
         {0x1.e30af86cee564p-43, 0x1.e30af86cee564p-43, 0x1.d660c9c1a927ep-35, 0x1.0ed20d4f05c6p-33,
          0x1.12ce85225aa61p-30, 0x1.12daaa60aa5b9p-30, 0x1.12e0bc1f4f851p-30, 0x1.12e0be826d695p-30,
          0x1.9c511dc3a41ep-29, 0x1.9c511dc3a41ep-29, 0x1.9c511dc3a41ep-29, 0x1.9c511dc3a41ep-29,
          0x1.9c511dc3a41ep-29, 0x1.9c511dc3a41ep-29, 0x1.9eeae305f2b6cp-29, 0x1.9eeae305f2b6cp-29}},
    };
    for (const Case &one : cases) {
        const auto count = static_cast<int64_t>(one.knots.size()) - one.degree - 1;
        const SplineData data = {
            {one.degree}, {count}, {one.knots}, 1, std::vector<double>(static_cast<size_t>(count), 1), {}, 0};
        const double value = eval(create(data).get(), {one.t})[0];
        EXPECT_LE(std::fabs(static_cast<long double>(value) - 1), reference::c_of(one.degree) * eps)
            << describe(data) << "at " << hex(one.t) << " is " << hex(value);
    }
}

} // namespace

} // namespace worst_points_test
