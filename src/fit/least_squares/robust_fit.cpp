// SPDX-License-Identifier: MIT
#include "fit/least_squares/robust_fit.h"

#include "base/error.h"
#include "base/watch.h"
#include "fit/least_squares/data_distances.h"
#include "numeric/power_of_two.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr double huber_width = 1.345, tukey_width = 4.685; // 95 % of the efficiency of least squares
constexpr int most_rounds = 50;
constexpr double farthest =
    0x1p30; // x from which data are left out: beside their values others would be rounded

// The median length of a vector of `dim` standard normal numbers. Its square has the chi-squared
// distribution; from four numbers on, the median of that is approximated (E. Wilson, M. Hilferty, Proc. Nat.
// Acad. Sci. 17 (1931)).
double median_length(int64_t dim) noexcept {
    constexpr double exact[] = {0.67448975019608171, 1.1774100225154747, 1.5381722544550526};
    if (dim <= 3) {
        return exact[dim - 1];
    }
    const double part = 1 - 2 / (9 * static_cast<double>(dim));
    return std::sqrt(static_cast<double>(dim) * part * part * part);
}

double factor(Robust rule, double x) noexcept {
    if (rule == Robust::huber) {
        return x <= 1 ? 1 : x <= farthest ? 1 / x : 0;
    }
    return x < 1 ? (1 - x * x) * (1 - x * x) : 0;
}

class RobustFit {
public:
    RobustFit(const Data &data, const eval::AxisRules &rules, const std::vector<KnotVectorPtr> &axes,
              const FitWishes &wishes)
        : data_(data), rules_(rules), axes_(axes), wishes_(wishes),
          weights_(static_cast<size_t>(data.params.count)), factors_(weights_.size(), 1.0),
          residuals_(weights_.size()) {}

    FittedPoints fit() {
        found_ = fit_points(data_, rules_, axes_, wishes_, false);
        const int64_t count = found_.data_count;
        given_ = found_.fit.misfit;
        int rounds = 1;
        bool converged = iterate(Robust::huber, rounds);
        if (wishes_.robust == Robust::tukey) {
            wishes_.smoothing = wishes_.smoothing == Smoothing::none ? Smoothing::none : Smoothing::given;
            wishes_.value = found_.fit.lambda;
            converged = redescend(rounds);
        }
        found_.data_count = count;
        found_.rounds = rounds;
        found_.converged = converged;
        found_.fit.misfit = given_;
        found_.scale = std::ldexp(found_.scale, exponent());
        compare(data_, rules_, found_);
        return found_;
    }

private:
    // Tukey's rounds. Huber's fit stays where only outliers determine a control point.
    bool redescend(int &rounds) {
        const FittedPoints huber = found_;
        try {
            return iterate(Robust::tukey, rounds);
        } catch (const Error &error) {
            if (error.status() != Status::rank) {
                throw;
            }
            found_ = huber;
            return false;
        }
    }
    bool iterate(Robust rule, int &rounds) {
        constexpr double enough = 1e-6;
        const double width = rule == wishes_.robust && wishes_.width > 0 ? wishes_.width
                             : rule == Robust::huber                     ? huber_width
                                                                         : tukey_width;
        Steps steps(most_rounds);
        double scale = 0;
        for (int i = 0; i < most_rounds; ++i, steps.next()) {
            measure();
            scale = rule == Robust::tukey && i > 0 ? scale : found_.scale; // fixed, so that the sum descends
            if (!(reweigh(rule, width * scale) > enough)) {
                return true;
            }
            refit();
            ++rounds;
        }
        return false;
    }

    // The exponent of the unit of residuals, chosen so that they do not overflow when multiplied by weights;
    // 0 where values are within half of the exponent range.
    [[nodiscard]] int exponent() const noexcept {
        constexpr int half = 400;
        const int own = given_.value_exponent;
        return own > half ? own - half : std::min(own + half, 0);
    }

    // Measures the residuals sqrt(w) |y - s(t)| and their scale, which is at least the rounding error of the
    // better half of the values.
    void measure() {
        constexpr double rounding = 0x1p-44;
        std::vector<double> counted;
        for_each_distance(data_, rules_, given_.weight_exponent, *found_.fit.spline,
                          [&](int64_t first, std::span<const double> distances) {
                              for (size_t i = 0; i < distances.size(); ++i) {
                                  const int64_t at = first + static_cast<int64_t>(i);
                                  const double residual = std::sqrt(weight_of(data_, at)) *
                                                          times_power_of_two(distances[i], -exponent());
                                  residuals_[static_cast<size_t>(at)] = residual;
                                  if (!std::isnan(residual)) {
                                      counted.push_back(residual);
                                  }
                              }
                          });
        found_.scale = 0;
        if (!counted.empty()) {
            const auto middle = counted.begin() + std::ssize(counted) / 2;
            std::ranges::nth_element(counted, middle);
            const double n = static_cast<double>(counted.size());
            const double lost =
                n / std::max(1.0, n - found_.fit.freedom); // a fit makes residuals smaller than errors
            found_.scale = std::max(*middle / median_length(data_.values.width) * std::sqrt(lost),
                                    rounding * largest_value(*middle));
        }
    }

    // The largest weighted magnitude among the data with residuals up to a limit.
    [[nodiscard]] double largest_value(double limit) const noexcept {
        double largest = 0;
        for (int64_t i = 0; i < std::ssize(residuals_); ++i) {
            for (int64_t c = 0; c < data_.values.width && residuals_[static_cast<size_t>(i)] <= limit; ++c) {
                largest =
                    std::max(largest, std::sqrt(weight_of(data_, i)) *
                                          std::abs(times_power_of_two(data_.values(i, c), -exponent())));
            }
        }
        return largest;
    }

    // Returns the largest change of a factor; for Huber's rule relative to the factor, which may tend to 0.
    double reweigh(Robust rule, double width) {
        const double unit = width * std::sqrt(static_cast<double>(data_.values.width));
        double change = 0;
        found_.outliers = 0;
        for (size_t i = 0; i < factors_.size(); ++i) {
            const double x = residuals_[i] > 0 ? residuals_[i] / unit : 0;
            found_.outliers += x > 1 ? 1 : 0;
            const double next = factor(rule, x);
            const double moved = std::abs(next - factors_[i]);
            const double size = rule == Robust::huber ? std::max(next, factors_[i]) : 1;
            change = std::max(change, moved > 0 ? moved / size : 0);
            factors_[i] = next;
        }
        return change;
    }

    void refit() {
        for (int64_t i = 0; i < std::ssize(weights_); ++i) {
            weights_[static_cast<size_t>(i)] = weight_of(data_, i) * factors_[static_cast<size_t>(i)];
        }
        Data weighted = data_;
        weighted.weights = {weights_.data(), std::ssize(weights_), 1, 1};
        found_.fit = fit_points(weighted, rules_, axes_, wishes_, false).fit;
    }

    const Data &data_;
    const eval::AxisRules &rules_;
    const std::vector<KnotVectorPtr> &axes_;
    FitWishes wishes_;
    std::vector<double> weights_, factors_, residuals_;
    FittedPoints found_{};
    Misfit given_; // of the data with the weights that were given
};

// The fit with weights in units of 2^exponent; the exponent is even.
FittedPoints in_weights_of(int exponent, const Data &data, const eval::AxisRules &rules,
                           const std::vector<KnotVectorPtr> &axes, FitWishes wishes) {
    std::vector<double> weights;
    for (int64_t i = 0; i < data.weights.count; ++i) {
        weights.push_back(std::ldexp(checked_weight(data.weights, i), -exponent));
    }
    Data other = data;
    other.weights = {weights.data(), std::ssize(weights), 1, 1};
    wishes.value = std::ldexp(wishes.value, -exponent); // lambda or the target of squares
    FittedPoints found = RobustFit(other, rules, axes, wishes).fit();
    found.fit.lambda = std::ldexp(found.fit.lambda, exponent);
    found.fit.misfit.weight_exponent += exponent;
    found.scale = std::ldexp(found.scale, exponent / 2);
    return found;
}

} // namespace

FittedPoints robust_fit(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes) {
    constexpr int least = -900; // of weights that keep their digits when multiplied by factors
    const int exponent = exponent_above(largest_weight(data));
    return exponent > least ? RobustFit(data, rules, axes, wishes).fit()
                            : in_weights_of(exponent + (exponent & 1), data, rules, axes, wishes);
}

} // namespace nrb::fit
