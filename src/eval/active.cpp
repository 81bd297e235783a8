// SPDX-License-Identifier: MIT
#include "eval/active.h"

#include "base/numbers.h"
#include "eval/active_points.h"

#include <algorithm>
#include <vector>

namespace nrb::eval {

namespace {

double largest_coordinate(const Spline &spline, int64_t point) noexcept {
    double size = 0;
    for (int c = 0; c < spline.dim(); ++c) {
        size = std::max(size, std::abs(spline.coordinate(point, c)));
    }
    return size;
}

// Collects the quantities of the hull size in homogeneous space: the largest |w_i P_i|, the largest |w_i|,
// and the sum w(t) C(t), w(t), whose dim + 1 components are accumulated in `sums`.
class HomogeneousHull {
public:
    HomogeneousHull(const Spline &spline, std::vector<double> &sums) : spline_(spline), sums_(sums) {
        std::fill(sums_.begin(), sums_.end(), 0.0);
    }

    void add(int64_t point, double value) noexcept {
        const int dim = spline_.dim();
        const double *record = spline_.points().data() + point * (dim + 1);
        double product = 0;
        for (int c = 0; c <= dim; ++c) {
            sums_[static_cast<size_t>(c)] += value * record[c];
            product = c < dim ? std::max(product, std::abs(record[c])) : product;
        }
        largest_product_ = std::max(largest_product_, product);
        largest_weight_ = std::max(largest_weight_, std::abs(record[dim]));
        positive_ = positive_ && (record[dim] > 0 || (record[dim] == 0 && product == 0));
    }

    [[nodiscard]] bool positive() const noexcept { return positive_; }

    // The quotient C = (w C) / w is computed from a numerator with an error of about eps max|w_i P_i| and a
    // denominator with an error of about eps max|w_i|. The latter changes C by eps |C| max|w_i| / |w|.
    [[nodiscard]] double size() const noexcept {
        const double weight = std::abs(sums_.back());
        double point = 0;
        for (auto sum = sums_.begin(); sum + 1 != sums_.end(); ++sum) {
            point = std::max(point, std::abs(*sum) / weight);
        }
        return (largest_product_ + point * largest_weight_) / weight;
    }

private:
    const Spline &spline_;
    std::vector<double> &sums_;
    double largest_product_ = 0;
    double largest_weight_ = 0;
    bool positive_ = true;
};

// The largest |coordinate| of an active control point of positive weight.
double cartesian_hull(const Spline &spline, const ActivePoints &active) noexcept {
    double size = 0;
    active.for_each([&](int64_t point, double) {
        if (spline.weight(point) > 0) {
            size = std::max(size, largest_coordinate(spline, point));
        }
    });
    return size;
}

// The hull size at one parameter. The homogeneous formula is needed only if some active weight is negative or
// some active point lies at infinity.
double hull_size(const Spline &spline, const ActivePoints &active, std::vector<double> &sums) noexcept {
    if (spline.form() == Form::homogeneous) {
        HomogeneousHull hull(spline, sums);
        active.for_each([&](int64_t point, double value) { hull.add(point, value); });
        if (!hull.positive()) {
            return hull.size();
        }
    }
    return cartesian_hull(spline, active);
}

// Writes the products w_i N_i to `functions` and returns what they have to be divided by: w(t), or 1 for a
// polynomial spline.
double weighted_functions(const Spline &spline, const ActivePoints &active, std::vector<double> &functions) {
    double sum = 0;
    auto next = functions.begin();
    active.for_each([&](int64_t point, double value) {
        *next = value * spline.weight(point);
        sum += *next++;
    });
    return spline.rational() ? sum : 1;
}

void store_spans(const ActivePoints &active, int axes, bool valid, int64_t *spans) noexcept {
    for (int k = 0; k < axes; ++k) {
        spans[k] = valid ? active.span(static_cast<size_t>(k)) : -1;
    }
}

} // namespace

void rational_basis(const Spline &spline, const AxisRules &rules, ConstRecords params, int64_t *spans,
                    Records values) {
    ActivePoints active(spline.knot_vectors(), rules);
    std::vector<double> functions(static_cast<size_t>(active.size()));
    for (int64_t i = 0; i < params.count; ++i) {
        const bool valid = active.locate(params, i);
        if (spans != nullptr) {
            store_spans(active, spline.axes(), valid, spans + i * spline.axes());
        }
        const double divisor = valid ? weighted_functions(spline, active, functions) : nan_value;
        for (int64_t j = 0; j < active.size(); ++j) {
            values(i, j) = functions[static_cast<size_t>(j)] / divisor;
        }
    }
}

void hull_sizes(const Spline &spline, const AxisRules &rules, ConstRecords params, Records sizes) {
    ActivePoints active(spline.knot_vectors(), rules);
    std::vector<double> sums(spline.form() == Form::homogeneous ? static_cast<size_t>(spline.width()) : 0);
    for (int64_t i = 0; i < params.count; ++i) {
        sizes(i, 0) = active.locate(params, i) ? hull_size(spline, active, sums) : nan_value;
    }
}

} // namespace nrb::eval
