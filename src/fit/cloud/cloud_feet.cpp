// SPDX-License-Identifier: MIT
#include "fit/cloud/cloud_feet.h"

#include "base/finite.h"
#include "base/watch.h"
#include "closest/closest.h"
#include "closest/stops.h"
#include "eval/evaluate.h"
#include "fit/least_squares/fit_points.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::fit {

namespace {

constexpr int order = 2; // of derivatives
constexpr int64_t block = 64;
// Pieces that are looked at for a foot: in a round; and for the last proofs, on the average of all points, or
// of `few` points if there are fewer.
constexpr int64_t usual_pieces = 24, proving_pieces = 100;
constexpr int64_t few = 1000; // points, whose proofs cost next to nothing

bool is_left(int32_t status, size_t axis) noexcept {
    return (status & closest::closest_left << axis) != 0;
}

// Derivatives at the feet, evaluated block by block, on that side of a jump on which the foot lies.
class FootDerivatives {
public:
    FootDerivatives(const Spline &spline, const CloudFeet &feet)
        : spline_(spline), feet_(feet), record_(eval::slot_count(spline.axes(), order) * spline.dim()),
          values_(static_cast<size_t>(block * record_)) {}

    // The derivatives at foot i, which has to run through 0, 1, 2, ... in turn.
    const double *at(int64_t i) {
        if (i % block == 0) {
            evaluate(i, std::min(block, std::ssize(feet_.distances) - i), {});
        }
        double *const own = values_.data() + i % block * record_;
        eval::AxisRules rules;
        bool left = false;
        for (size_t k = 0; k < static_cast<size_t>(spline_.axes()); ++k) {
            rules[k].left = is_left(feet_.status[static_cast<size_t>(i)], k);
            left = left || rules[k].left;
        }
        if (left) {
            evaluate(i, 1, rules);
        }
        return own;
    }

private:
    void evaluate(int64_t first, int64_t count, const eval::AxisRules &rules) {
        const int64_t axes = spline_.axes();
        eval::evaluate_points(spline_, rules, order,
                              {feet_.params.data() + first * axes, count, axes, axes, 1},
                              {values_.data() + first % block * record_, count, record_, record_, 1});
    }

    const Spline &spline_;
    const CloudFeet &feet_;
    int64_t record_;
    std::vector<double> values_;
};

// The rounding error of a distance, for coordinates of size 1.
double relative_noise(const Spline &spline) noexcept {
    double functions = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        functions += spline.axis(k).degree() + 1;
    }
    return 2 * (64 * functions + 2 * spline.dim()) * std::numeric_limits<double>::epsilon();
}

} // namespace

CloudFeet::CloudFeet(const Spline &spline, const Cloud &cloud) : CloudFeet(spline, cloud, usual_pieces) {}

CloudFeet::CloudFeet(const Spline &spline, const Cloud &cloud, int64_t pieces)
    : params(static_cast<size_t>(cloud.size() * spline.axes())), distances(static_cast<size_t>(cloud.size())),
      status(static_cast<size_t>(cloud.size())), exponent(cloud.exponent) {
    const int64_t n = cloud.size(), axes = spline.axes(), dim = cloud.dim;
    const closest::Query query{nullptr, nullptr, 0, pieces, false, true};
    closest::closest_points(
        spline, {cloud.points.data(), n, dim, dim, 1}, query,
        {{params.data(), n, axes, axes, 1}, {}, {distances.data(), n, 1, 1, 1}, status.data()});
    require_work();
    set_squares(cloud);
}

void CloudFeet::set_squares(const Cloud &cloud) {
    DoubleDouble sum;
    for (size_t i = 0; i < distances.size(); ++i) {
        sum = sum + DoubleDouble(cloud.weights[i] * distances[i] * distances[i]);
    }
    squares = sum.high;
    count_work(8 * cloud.size());
}

std::vector<int64_t> CloudFeet::without_proof() const {
    std::vector<int64_t> open;
    for (size_t i = 0; i < status.size(); ++i) {
        if ((status[i] & closest::closest_certified) == 0) {
            open.push_back(static_cast<int64_t>(i));
        }
    }
    return open;
}

// The fewer feet are left, the more pieces each of them may look at. It goes on only while a pass proves a
// quarter of them: there are few passes where whole parameter lines are equally near.
void CloudFeet::prove(const Spline &spline, const Cloud &cloud) {
    std::vector<int64_t> open = without_proof();
    for (size_t before = 2 * open.size(); !open.empty() && 4 * open.size() <= 3 * before;
         open = without_proof()) {
        before = open.size();
        const int64_t share = proving_pieces * std::max(few, cloud.size()) / std::ssize(open);
        if (!attempted([&] {
                take(CloudFeet(spline, cloud.part(open), std::min(share, closest::usual_budget(spline))),
                     open, spline.axes());
            })) {
            break;
        }
    }
    set_squares(cloud);
}

void CloudFeet::take(const CloudFeet &found, const std::vector<int64_t> &places, int axes) {
    for (size_t j = 0; j < places.size(); ++j) {
        const auto i = static_cast<size_t>(places[j]);
        std::copy_n(found.params.begin() + static_cast<int64_t>(j) * axes, axes,
                    params.begin() + places[j] * axes);
        distances[i] = found.distances[j];
        status[i] = found.status[j];
    }
}

void CloudFeet::measure_given(const Spline &spline, const Cloud &cloud) {
    constexpr int widest = 500; // squares of rounding errors of the largest coordinates must not overflow
    FootDerivatives derivatives(spline, *this);
    exponent = std::max(exponent, exponent_above(largest_magnitude(cloud.origin)) - widest);
    for (int64_t i = 0; i < cloud.size(); ++i) {
        const double *const foot = derivatives.at(i), *const point = cloud.point(i);
        distances[static_cast<size_t>(i)] = norm_of(cloud.dim, [&](int c) {
            const auto at = static_cast<size_t>(c);
            return std::ldexp(cloud.given(point[c], at) - foot[c], -exponent);
        });
    }
    set_squares(cloud);
}

double distance_noise(const Spline &spline, const Cloud &cloud) {
    double farthest = 0;
    for (int64_t i = 0; i < cloud.size(); ++i) {
        farthest = std::max(farthest, norm(cloud.point(i), cloud.dim));
    }
    const double size = std::sqrt(cloud.dim) * largest_magnitude(spline.effective().points());
    return relative_noise(spline) * (size + farthest);
}

double given_noise(const Spline &spline, const Cloud &cloud) {
    const double factor = relative_noise(spline) * (1 + std::sqrt(cloud.dim));
    const double of_origin =
        norm_of(cloud.dim, [&](int c) { return factor * cloud.origin[static_cast<size_t>(c)]; });
    return std::ldexp(distance_noise(spline, cloud), cloud.exponent) + of_origin;
}

void add_models(const Spline &spline, const Cloud &cloud, const CloudFeet &feet, CloudEquations &equations) {
    const auto axes = static_cast<size_t>(spline.axes());
    FootDerivatives derivatives(spline, feet);
    ActiveFunctions functions(spline.knot_vectors());
    SquaredDistance model(spline.axes(), cloud.dim);
    std::vector<double> r(static_cast<size_t>(cloud.dim));
    for (int64_t i = 0; i < cloud.size(); ++i) {
        const double *const at = derivatives.at(i);
        for (size_t c = 0; c < r.size(); ++c) {
            r[c] = cloud.point(i)[c] - at[c];
        }
        std::array<bool, max_axes> stays{};
        for (size_t k = 0; k < axes; ++k) {
            const double param = feet.params[static_cast<size_t>(i) * axes + k];
            const KnotVector &axis = spline.axis(static_cast<int>(k));
            stays[k] = closest::may_hold_foot(axis, param);
            functions.set(k, axis.spans().find(param, is_left(feet.status[static_cast<size_t>(i)], k)),
                          param);
        }
        model.set(at, stays, r.data());
        functions.multiply();
        equations.add(functions, cloud.weights[static_cast<size_t>(i)], model);
        count_work(400);
    }
}

} // namespace nrb::fit
