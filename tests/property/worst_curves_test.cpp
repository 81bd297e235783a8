// The bound for points is for every spline: a search that climbs towards the largest error of one span,
// moving its knots, control points, weights and the parameter, with rational arithmetic as the judge of every
// step. worst_points_test.cpp climbs on the basis functions; here products with points and weights, sums and
// the division take part.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace worst_curves_test {

using namespace support;
using reference::eps;

namespace {

// Weights within the ratio of 4, to which spans are evaluated in centred powers, just beyond it, or far beyond it.
enum class Balance { polynomial, within_4, beyond_4, far_apart };

struct Trial {
    SplineData data; // a span alone: degree + 1 points along each axis
    std::vector<double> param;
    long double ratio = -1; // of the largest error to the published bound
};

constexpr int dim = 3;

void measure(Trial &trial) {
    const auto values = eval(create(trial.data).get(), trial.param);
    const double *param = trial.param.data();
    const auto want = reference::exact_point(trial.data, param);
    const long double bound = reference::c_of(trial.data) * reference::weight_factor(trial.data, param) *
                              eps * reference::exact_hull(trial.data, param);
    trial.ratio = 0;
    for (size_t c = 0; c < want.size(); ++c) {
        trial.ratio = std::max(trial.ratio, reference::error_ratio(values[c], want[c], bound));
    }
}

// The same for the derivative of a curve, whose bound has its own magnitudes.
void measure_derivative(Trial &trial, int order) {
    const auto values = eval_derivs(create(trial.data).get(), order, trial.param);
    const double *param = trial.param.data();
    const auto want = reference::exact_derivatives(trial.data, order, param).back();
    const auto sizes = reference::magnitudes(trial.data, order, param).back();
    const long double factor = 2 * (reference::c_of(trial.data) + 2 * order) * eps;
    trial.ratio = 0;
    for (size_t c = 0; c < want.size(); ++c) {
        const double value = values[values.size() - want.size() + c];
        trial.ratio = std::max(trial.ratio, reference::error_ratio(value, want[c], factor * sizes[c]));
    }
}

// Mostly the extremes, whose errors all count in full.
double random_point(Random &random) {
    const double size = random.chance(50) ? 1 : random.between(random.chance(80) ? 0.5 : 0, 1);
    return random.chance(50) ? size : -size;
}

double random_weight(Random &random, Balance balance) {
    if (balance == Balance::far_apart) {
        return random.chance(40) ? 1 : random.magnitude(1e-12, 1e12);
    }
    return random.chance(60) ? (random.chance(50) ? 1 : 4) : random.between(1, 4);
}

// One weight 1; one at most 4, or one step above.
void hold_ratio(std::vector<double> &weights, Balance balance) {
    if (balance == Balance::within_4 || balance == Balance::beyond_4) {
        *std::min_element(weights.begin(), weights.end()) = 1;
    }
    if (balance == Balance::beyond_4) {
        *std::max_element(weights.begin(), weights.end()) = std::nextafter(4.0, 5.0);
    }
}

// The span that holds a random parameter of a random knot vector.
void add_random_axis(Random &random, int degree, Trial &trial) {
    const auto knots = random_knots(random, random_axis(random, degree));
    const double t = random_param(random, knots, degree);
    const auto size = static_cast<int64_t>(knots.size());
    int64_t span = 0;
    require_ok(nurbs_find_spans(degree, size - degree - 1, knots.data(), size, 1, &t, 0, &span, 0));
    const auto first = knots.begin() + (span - degree);
    trial.data.degrees.push_back(degree);
    trial.data.counts.push_back(degree + 1);
    trial.data.knots.emplace_back(first, first + 2 * (degree + 1));
    trial.param.push_back(t);
}

Trial random_trial(Random &random, const std::vector<int> &degrees, Balance balance) {
    Trial trial;
    trial.data.dim = dim;
    for (const int degree : degrees) {
        add_random_axis(random, degree, trial);
    }
    for (int64_t i = 0; i < trial.data.point_count() * dim; ++i) {
        trial.data.points.push_back(random_point(random));
    }
    for (int64_t i = 0; i < trial.data.point_count() && balance != Balance::polynomial; ++i) {
        trial.data.weights.push_back(random_weight(random, balance));
    }
    hold_ratio(trial.data.weights, balance);
    return trial;
}

// Some of the knots moved, unless that closes the span.
void move_knots(Random &random, int degree, std::vector<double> &knots) {
    auto moved = knots;
    const double step = (knots.back() - knots.front()) * random.magnitude(1e-16, 0.3);
    for (double &knot : moved) {
        knot += random.chance(30) ? step * random.between(-1, 1) : 0;
    }
    std::sort(moved.begin(), moved.end());
    if (moved[static_cast<size_t>(degree)] < moved[static_cast<size_t>(degree) + 1]) {
        knots = std::move(moved);
    }
}

Trial neighbour(Random &random, Trial trial, Balance balance) {
    const int axis = random.whole(0, trial.data.axes() - 1);
    const auto k = static_cast<size_t>(axis);
    const int kind = random.whole(0, 9);
    if (kind < 3) {
        const double length = trial.data.upper(axis) - trial.data.lower(axis);
        trial.param[k] += length * random.magnitude(1e-16, 0.5) * (random.chance(50) ? 1 : -1);
    } else if (kind < 5) {
        move_knots(random, trial.data.degrees[k], trial.data.knots[k]);
    } else if (kind < 8 || trial.data.weights.empty()) {
        for (double &x : trial.data.points) {
            x = random.chance(10) ? random_point(random) : x;
        }
    } else {
        trial.data.weights[random.bits() % trial.data.weights.size()] = random_weight(random, balance);
        hold_ratio(trial.data.weights, balance);
    }
    trial.param[k] = std::clamp(trial.param[k], trial.data.lower(axis), trial.data.upper(axis));
    return trial;
}

// Order 0 is the point.
void climb(const std::vector<int> &degrees, int order, uint64_t seed_base, Balance balance, int seeds,
           int steps, WorstErrors &worst) {
    for_each_case(seed_base, seeds, [&](Random &random, uint64_t seed) {
        Trial best;
        for (int i = 0; i < steps; ++i) {
            const bool fresh = i < steps / 5;
            Trial next = fresh ? random_trial(random, degrees, balance) : neighbour(random, best, balance);
            order == 0 ? measure(next) : measure_derivative(next, order);
            if (next.ratio >= best.ratio) {
                best = std::move(next);
            }
        }
        const long double c = reference::c_of(best.data);
        worst.add(degrees[0], best.ratio, best.ratio * (order == 0 ? c : 2 * (c + 2 * order)));
        EXPECT_LT(best.ratio, 1) << where(seed, best.data) << "at " << hex(best.param);
    });
}

void climb_curves(const char *title, uint64_t base, Balance balance) {
    WorstErrors worst(title);
    for (const int degree : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 23, 31}) {
        climb({degree}, 0, base + 1000 * static_cast<uint64_t>(degree), balance, degree > 20 ? 1 : 4, 700,
              worst);
    }
}

TEST(WorstCurves, polynomial) {
    climb_curves("climbing to the worst polynomial span, unit eps * hull", 7100000, Balance::polynomial);
}

TEST(WorstCurves, weights_within_a_ratio_of_4) {
    climb_curves("climbing to the worst span of even weights, unit eps * hull * ratio of weights", 7200000,
                 Balance::within_4);
}

TEST(WorstCurves, weights_just_beyond_a_ratio_of_4) {
    climb_curves("climbing to the worst span of uneven weights, unit eps * hull", 7300000, Balance::beyond_4);
}

TEST(WorstCurves, weights_far_apart) {
    climb_curves("climbing to the worst span of weights from 1e-12 to 1e12, unit eps * hull", 7700000,
                 Balance::far_apart);
}

TEST(WorstCurves, derivatives) {
    for (const int order : {1, 2}) {
        WorstErrors worst("climbing to the worst derivative of order " + std::to_string(order) +
                          ", unit eps * E");
        uint64_t base = 7600000 + 100000 * static_cast<uint64_t>(order);
        for (const int degree : {1, 2, 3, 5, 9, 12}) {
            for (const Balance balance :
                 {Balance::polynomial, Balance::within_4, Balance::beyond_4, Balance::far_apart}) {
                climb({degree}, order, base += 1000, balance, 1, 500, worst);
            }
        }
    }
}

// Steps of none, a few or many units of rounding around a span of `units` of them that starts at 1.
std::vector<double> knots_in_units(Random &random, int degree, int units) {
    std::vector<double> knots = {1, 1 + units * static_cast<double>(eps)};
    const auto step = [&] {
        const double size = random.chance(60) ? 0 : std::floor(random.magnitude(1, 1e6));
        return size * static_cast<double>(eps);
    };
    for (int i = 0; i < degree; ++i) {
        knots.insert(knots.begin(), knots.front() - step());
        knots.push_back(knots.back() + step());
    }
    return knots;
}

// The middle of a span of an odd number of units is half a unit off.
TEST(WorstCurves, spans_of_few_units_of_rounding) {
    WorstErrors worst("worst of all parameters of spans of 1 to 200 units of rounding, unit eps * hull");
    for (int degree = 1; degree <= 10; ++degree) {
        for_each_case(7500000 + 1000 * static_cast<uint64_t>(degree), 60, [&](Random &random, uint64_t seed) {
            Trial trial = random_trial(random, {degree}, Balance::polynomial);
            const int units = random.chance(50) ? random.whole(1, 9) : random.whole(1, 200);
            trial.data.knots[0] = knots_in_units(random, degree, units);
            for (int i = 0; i <= units; i += 1 + units / 10) {
                trial.param[0] = 1 + i * static_cast<double>(eps);
                measure(trial);
                worst.add(degree, trial.ratio, trial.ratio * reference::c_of(degree));
                EXPECT_LT(trial.ratio, 1) << where(seed, trial.data) << "at " << hex(trial.param);
            }
        });
    }
}

TEST(WorstSurfaces, of_every_balance) {
    WorstErrors worst("climbing to the worst patch by degree of axis 0, unit eps * hull * ratio of weights");
    uint64_t base = 7400000;
    for (const auto &degrees : {std::vector{1, 1}, std::vector{2, 3}, std::vector{3, 3}, std::vector{5, 2}}) {
        for (const Balance balance : {Balance::polynomial, Balance::within_4, Balance::beyond_4}) {
            climb(degrees, 0, base += 1000, balance, 2, 400, worst);
        }
    }
}

} // namespace

} // namespace worst_curves_test
