// SPDX-License-Identifier: MIT
#include "modify/constrain/net_state.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "base/watch.h"
#include "modify/edit/kept_layers.h"
#include "modify/edit/net_editor.h"
#include "numeric/norm.h"
#include "refine/forms/homogeneous.h"

#include <algorithm>
#include <cmath>

namespace nrb::modify {

namespace {

eval::Orders highest_of(const Condition &condition) noexcept {
    eval::Orders highest{};
    for (const eval::Orders &a : condition.derivatives()) {
        for (size_t k = 0; k < highest.size(); ++k) {
            highest[k] = std::max(highest[k], a[k]);
        }
    }
    return highest;
}

// The originals of the control points that act on a condition.
std::vector<int64_t> acting_points(const Spline &spline, const std::vector<Condition> &conditions) {
    std::vector<int64_t> acting;
    for (const Condition &condition : conditions) {
        eval::ActivePoints active(spline.knot_vectors(), {});
        static_cast<void>(active.locate({condition.param(), 1, spline.axes(), spline.axes(), 1}, 0));
        active.for_each([&](int64_t point, double) { acting.push_back(original_of(spline, point)); });
    }
    std::sort(acting.begin(), acting.end());
    acting.erase(std::unique(acting.begin(), acting.end()), acting.end());
    return acting;
}

// Numbers the columns in the order of the originals. The cost of one that stays is infinite.
template <class Cost>
void number(const Spline &spline, const std::vector<int64_t> &acting, Cost &&cost,
            std::vector<int64_t> &columns, std::vector<double> &costs) {
    columns.assign(static_cast<size_t>(spline.point_count()), -1);
    for (const int64_t point : acting) {
        if (const double value = cost(point); std::isfinite(value)) {
            columns[static_cast<size_t>(point)] = std::ssize(costs);
            costs.push_back(value);
        }
    }
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        columns[static_cast<size_t>(i)] = columns[static_cast<size_t>(original_of(spline, i))];
    }
}

// Counts the work of a sum over all multi-indices b <= a. Without these sums there is no answer.
void count_sum(const eval::Orders &a, int64_t work_of_a_term) {
    const NeededWork needed;
    count_work(work_of_a_term * (a[0] + 1) * (a[1] + 1) * (a[2] + 1));
}

} // namespace

Columns make_columns(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule) {
    const std::vector<char> stays = kept_points(spline, rule.keep);
    const std::vector<int64_t> acting = acting_points(spline, conditions);
    const auto cost = [&](const double *costs, double usual) {
        return [&stays, costs, usual](int64_t point) {
            const double given = costs == nullptr ? usual : costs[point];
            return stays[static_cast<size_t>(point)] != 0 ? infinity : given;
        };
    };
    Columns columns;
    number(spline, acting, cost(rule.costs, 1), columns.points, columns.point_costs);
    number(spline, acting, cost(rule.weight_costs, infinity), columns.weights, columns.weight_costs);
    return columns;
}

NetState::NetState(const Spline &spline, const Columns &columns)
    : spline_(spline), columns_(columns), start_(refine::cartesian_points(spline)) {
    const auto dim = static_cast<size_t>(spline.dim());
    for (int64_t i = 0; spline.form() == Form::homogeneous && i < spline.point_count(); ++i) {
        if (spline.weight(i) != 0) {
            continue;
        }
        const size_t at = static_cast<size_t>(i) * dim;
        const double *record = spline.points().data() + i * spline.stored_width();
        if (largest_magnitude({record, dim}) > 0) {
            fail(Status::point_not_finite, "g: control point %lld is at infinity", static_cast<long long>(i));
        }
        std::fill_n(start_.begin() + static_cast<int64_t>(at), dim, 0.0); // has no effect
    }
    points_ = start_;
    for (int64_t i = 0; (spline.rational() || !columns.weight_costs.empty()) && i < spline.point_count();
         ++i) {
        weights_.push_back(spline.weight(i));
    }
}

void NetState::set(const std::vector<double> &moves, const std::vector<double> &changes) noexcept {
    const auto dim = static_cast<size_t>(spline_.dim());
    for (size_t i = 0; i < columns_.points.size(); ++i) {
        if (const int64_t column = columns_.points[i]; column >= 0) {
            for (size_t c = 0; c < dim; ++c) {
                points_[i * dim + c] = start_[i * dim + c] + moves[static_cast<size_t>(column) * dim + c];
            }
        }
        if (const int64_t column = columns_.weights[i]; column >= 0) {
            weights_[i] =
                spline_.weight(static_cast<int64_t>(i)) * (1 + changes[static_cast<size_t>(column)]);
        }
    }
}

SplinePtr NetState::spline() const {
    require_representable(points_, "control points");
    if (spline_.form() != Form::homogeneous) {
        return make_result(spline_.knot_vectors(), spline_.dim(),
                           rational() ? Form::rational : Form::polynomial, points_, weights_);
    }
    std::vector<double> records(spline_.points().begin(), spline_.points().end());
    const auto dim = static_cast<size_t>(spline_.dim());
    for (size_t i = 0; i < weights_.size(); ++i) {
        double *const record = records.data() + i * (dim + 1);
        if (columns_.points[i] >= 0 || columns_.weights[i] >= 0) {
            std::transform(point(static_cast<int64_t>(i)), point(static_cast<int64_t>(i)) + dim, record,
                           [w = weights_[i]](double x) { return w * x; });
            record[dim] = weights_[i];
        }
    }
    require_representable(records, "control points");
    return make_result(spline_.knot_vectors(), spline_.dim(), spline_.form(), std::move(records));
}

LocalBasis::LocalBasis(const NetState &state, const Condition &condition)
    : state_(state), active_(state.start().knot_vectors(), {}, highest_of(condition)) {
    const int axes = state.start().axes();
    static_cast<void>(active_.locate({condition.param(), 1, axes, axes, 1}, 0));
    active_.for_each([&](int64_t point, double) { points_.push_back(point); });
    if (state.rational()) {
        const eval::Orders highest = highest_of(condition);
        reciprocal_.emplace(axes, highest[0] + highest[1] + highest[2]);
        eval::for_each_lower(highest, [&](const eval::Orders &b) {
            constexpr int64_t work_of_a_term = 4;
            count_sum(b, work_of_a_term);
            double weight = 0;
            active_.for_each(b, [&](int64_t point, double value) { weight += value * state.weight(point); });
            reciprocal_->add(b, weight);
        });
    }
}

std::vector<double> LocalBasis::functions(const eval::Orders &a) const {
    std::vector<double> values(points_.size(), 0.0);
    if (!reciprocal_) {
        auto next = values.begin();
        active_.for_each(a, [&next](int64_t, double value) { *next++ = value; });
        return values;
    }
    count_sum(a, std::ssize(points_));
    reciprocal_->leibniz().for_each(a, [&](const eval::Orders &b, const eval::Orders &rest, double binomial) {
        const double factor = binomial * (*reciprocal_)[rest];
        auto next = values.begin();
        active_.for_each(
            b, [&](int64_t point, double value) { *next++ += factor * (value * state_.weight(point)); });
    });
    return values;
}

std::vector<double> LocalBasis::value(const eval::Orders &a, const std::vector<double> &functions) const {
    const auto dim = static_cast<size_t>(state_.start().dim());
    const auto most = std::max_element(functions.begin(), functions.end(),
                                       [](double x, double y) { return std::abs(x) < std::abs(y); });
    const double *const from = state_.point(points_[static_cast<size_t>(most - functions.begin())]);
    std::vector<double> sum(dim, 0.0);
    for (size_t i = 0; i < points_.size(); ++i) {
        const double *const point = state_.point(points_[i]);
        for (size_t c = 0; c < dim; ++c) {
            sum[c] += functions[i] * (point[c] - from[c]);
        }
    }
    for (size_t c = 0; c < dim && a == eval::Orders{}; ++c) {
        sum[c] += from[c];
    }
    return sum;
}

double LocalBasis::magnitude(const std::vector<double> &functions) const noexcept {
    double sum = 0;
    for (size_t i = 0; i < points_.size(); ++i) {
        sum += std::abs(functions[i]) * norm(state_.point(points_[i]), state_.start().dim());
    }
    return sum;
}

std::vector<double> LocalBasis::weight_slopes(const eval::Orders &a) const {
    const auto dim = static_cast<size_t>(state_.start().dim());
    std::vector<double> slopes(points_.size() * dim, 0.0);
    reciprocal_->leibniz().for_each(a, [&](const eval::Orders &b, const eval::Orders &rest, double binomial) {
        const std::vector<double> lower = functions(b);
        const std::vector<double> other = value(rest, functions(rest));
        for (size_t i = 0; i < points_.size(); ++i) {
            const double *const point = state_.point(points_[i]);
            for (size_t c = 0; c < dim; ++c) {
                const double constant = rest == eval::Orders{} ? point[c] : 0;
                slopes[i * dim + c] += binomial * lower[i] * (constant - other[c]);
            }
        }
    });
    for (size_t i = 0; i < points_.size(); ++i) {
        const double start = state_.start().weight(points_[i]);
        const double ratio = start == 0 ? 0 : start / state_.weight(points_[i]);
        for (size_t c = 0; c < dim; ++c) {
            slopes[i * dim + c] *= ratio;
        }
    }
    return slopes;
}

} // namespace nrb::modify
