// SPDX-License-Identifier: MIT
#include "fit/cloud/cloud_feet.h"

#include "base/finite.h"
#include "base/watch.h"
#include "closest/closest.h"
#include "closest/stops.h"
#include "eval/evaluate.h"
#include "eval/functions/axis_basis.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::fit {

namespace {

constexpr int order = 2; // of derivatives
constexpr int64_t block = 64;

bool is_left(int32_t status, size_t axis) noexcept {
    return (status & closest::closest_left << axis) != 0;
}

// Derivatives at the feet, block by block, on the side of a jump that a foot is meant on.
class FootDerivatives {
public:
    FootDerivatives(const Spline &spline, const CloudFeet &feet)
        : spline_(spline), feet_(feet), record_(eval::slot_count(spline.axes(), order) * spline.dim()),
          values_(static_cast<size_t>(block * record_)) {}

    // Of point i, the points before it in turn.
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

// The functions of each axis at a foot.
class FootFunctions {
public:
    explicit FootFunctions(const Spline &spline) {
        for (int k = 0; k < spline.axes(); ++k) {
            for (const bool left : {false, true}) {
                axes_[static_cast<size_t>(k)].push_back({spline.axis(k), {left}, 0});
            }
            values_[static_cast<size_t>(k)].resize(static_cast<size_t>(spline.axis(k).degree() + 1));
        }
    }

    void set(size_t axis, double param, bool left) noexcept {
        eval::AxisBasis basis;
        basis.values = values_[axis].data();
        (void)axes_[axis][left ? 1 : 0](param, basis);
        first[axis] = basis.first;
        functions[axis] = values_[axis];
    }

    Index first{};
    std::array<std::span<const double>, max_axes> functions;

private:
    std::array<std::vector<eval::AxisEvaluator>, max_axes> axes_; // from the right and from the left
    std::array<std::vector<double>, max_axes> values_;
};

} // namespace

CloudFeet::CloudFeet(const Spline &spline, const Cloud &cloud)
    : params(static_cast<size_t>(cloud.size() * spline.axes())), distances(static_cast<size_t>(cloud.size())),
      status(static_cast<size_t>(cloud.size())) {
    const int64_t n = cloud.size(), axes = spline.axes(), dim = cloud.dim;
    const closest::Query query{nullptr, nullptr, 0, closest::usual_budget(spline)};
    closest::closest_points(
        spline, {cloud.points.data(), n, dim, dim, 1}, query,
        {{params.data(), n, axes, axes, 1}, {}, {distances.data(), n, 1, 1, 1}, status.data()});
    require_work();
    DoubleDouble sum;
    for (size_t i = 0; i < distances.size(); ++i) {
        sum = sum + DoubleDouble(cloud.weights[i] * distances[i] * distances[i]);
    }
    squares = sum.high;
    count_work(8 * n);
}

double distance_noise(const Spline &spline, const Cloud &cloud) noexcept {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    double functions = 0, farthest = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        functions += spline.axis(k).degree() + 1;
    }
    for (int64_t i = 0; i < cloud.size(); ++i) {
        farthest = std::max(farthest, norm(cloud.point(i), cloud.dim));
    }
    const double size = std::sqrt(cloud.dim) * largest_magnitude(spline.effective().points());
    return 2 * (64 * functions + 2 * cloud.dim) * eps * (size + farthest);
}

void add_models(const Spline &spline, const Cloud &cloud, const CloudFeet &feet, CloudEquations &equations) {
    const auto axes = static_cast<size_t>(spline.axes());
    FootDerivatives derivatives(spline, feet);
    FootFunctions functions(spline);
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
            stays[k] = closest::may_hold_foot(spline.axis(static_cast<int>(k)), param);
            functions.set(k, param, is_left(feet.status[static_cast<size_t>(i)], k));
        }
        model.set(at, stays, r.data());
        equations.add(functions.first, functions.functions, cloud.weights[static_cast<size_t>(i)], model);
        count_work(400);
    }
}

} // namespace nrb::fit
