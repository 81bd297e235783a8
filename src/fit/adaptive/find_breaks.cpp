// SPDX-License-Identifier: MIT
#include "fit/adaptive/find_breaks.h"

#include "eval/evaluate.h"
#include "fit/least_squares/fit_points.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::fit {

namespace {

// Data [first, end).
Data part(const Data &data, int64_t first, int64_t end) noexcept {
    const auto of = [&](ConstRecords records) {
        if (records.data != nullptr) {
            records.data += first * records.stride;
            records.count = end - first;
        }
        return records;
    };
    return {of(data.params), of(data.values), of(data.weights)};
}

// The polynomial closest to data, with what it misses of them.
FittedPoints polynomial(const Data &data, int degree) {
    const auto order = static_cast<size_t>(degree) + 1;
    std::vector<double> knots(2 * order, data.params(data.params.count - 1, 0));
    std::fill_n(knots.begin(), order, data.params(0, 0));
    FitWishes wishes;
    wishes.regularise = true;
    return fit_points(data, {}, {std::make_shared<const KnotVector>(degree, std::move(knots))}, wishes, true);
}

// Points of a polynomial, anywhere.
std::vector<double> continued(const Spline &spline, std::span<const double> params) {
    std::vector<double> points(params.size() * static_cast<size_t>(spline.dim()));
    eval::AxisRules rules{};
    rules[0].outside = eval::Outside::extrapolate;
    eval::evaluate_points(spline, rules, 0, {params.data(), std::ssize(params), 1, 1, 1},
                          {points.data(), std::ssize(params), spline.dim(), spline.dim(), 1});
    return points;
}

double gap(const Spline &a, const Spline &b, double t) {
    const std::vector<double> x = continued(a, {&t, 1}), y = continued(b, {&t, 1});
    return norm_of(a.dim(), [&](int c) { return x[static_cast<size_t>(c)] - y[static_cast<size_t>(c)]; });
}

// Where two polynomials are nearest to each other.
double nearest(const Spline &a, const Spline &b, double lower, double upper) {
    constexpr double golden = 0.6180339887498949;
    constexpr int steps = 60;
    double x = upper - golden * (upper - lower), y = lower + golden * (upper - lower);
    double at_x = gap(a, b, x), at_y = gap(a, b, y);
    for (int i = 0; i < steps; ++i) {
        if (at_x < at_y) {
            upper = y;
            y = x;
            at_y = at_x;
            x = upper - golden * (upper - lower);
            at_x = gap(a, b, x);
        } else {
            lower = x;
            x = y;
            at_x = at_y;
            y = lower + golden * (upper - lower);
            at_y = gap(a, b, y);
        }
    }
    return lower + (upper - lower) / 2;
}

// How far data are from the splines before and after a place.
struct Split {
    int64_t at;      // how many data belong to the first one
    double distance; // the largest one
};
Split best_split(const Spline &before, const Spline &after, std::span<const double> params,
                 std::span<const double> values) {
    const std::vector<double> a = continued(before, params), b = continued(after, params);
    const auto dim = static_cast<size_t>(before.dim());
    const auto distance = [&](const std::vector<double> &points, size_t i) {
        return norm_of(before.dim(), [&](int c) {
            const size_t at = i * dim + static_cast<size_t>(c);
            return points[at] - values[at];
        });
    };
    std::vector<double> later(params.size() + 1, 0.0);
    for (size_t i = params.size(); i-- > 0;) {
        later[i] = std::max(later[i + 1], distance(b, i));
    }
    Split best{0, later[0]};
    double earlier = 0;
    for (size_t i = 0; i < params.size(); ++i) {
        earlier = std::max(earlier, distance(a, i));
        if (const double both = std::max(earlier, later[i + 1]); both < best.distance) {
            best = {static_cast<int64_t>(i) + 1, both};
        }
    }
    return best;
}

// Data with parameters in an interval, sorted.
struct Between {
    std::vector<double> params, values;
};
Between data_between(const Data &all, double lower, double upper) {
    std::vector<int64_t> indices;
    for (int64_t i = 0; i < all.params.count; ++i) {
        const double t = all.params(i, 0);
        if (t >= lower && t <= upper && (all.weights.data == nullptr || all.weights(i, 0) > 0)) {
            indices.push_back(i);
        }
    }
    std::ranges::stable_sort(indices, {}, [&](int64_t i) { return all.params(i, 0); });
    Between found;
    for (const int64_t i : indices) {
        found.params.push_back(all.params(i, 0));
        for (int64_t c = 0; c < all.values.width; ++c) {
            found.values.push_back(all.values(i, c));
        }
    }
    return found;
}

} // namespace

BreakSearch::BreakSearch(const Data &sorted, std::vector<double> distances, int degree, double span,
                         double tolerance)
    : data_(sorted), distances_(std::move(distances)), degree_(degree), span_(span), tolerance_(tolerance) {}

// Of what is missed, two spans apart.
std::vector<BreakSearch::Cluster> BreakSearch::clusters() const {
    std::vector<Cluster> found;
    for (int64_t i = 0; i < std::ssize(distances_); ++i) {
        if (!(distances_[static_cast<size_t>(i)] > tolerance_)) {
            continue;
        }
        if (!found.empty() && param(i) - param(found.back().last) <= 2 * span_) {
            found.back().last = i;
        } else {
            found.push_back({i, i});
        }
    }
    return found;
}

std::vector<Break> BreakSearch::breaks(const Data &all) const {
    constexpr double widest = 128, narrowest = 4; // spans
    constexpr size_t most_breaks = 64;            // more are noise
    const std::vector<Cluster> places = clusters();
    std::vector<Break> found;
    for (size_t i = 0; i < places.size() && places.size() <= most_breaks; ++i) {
        const Cluster room{i == 0 ? 0 : places[i - 1].last + 1,
                           i + 1 == places.size() ? data_.params.count - 1 : places[i + 1].first - 1};
        Break one{};
        for (double window = widest; window >= narrowest; window /= 2) { // a long one sees through noise
            if (find(places[i], room, window * span_, all, one)) {
                found.push_back(one);
                break;
            }
        }
    }
    return found;
}

// The polynomials on either side are first found from data outside the cluster, and continued far into it; then from data ever
// nearer to the place where they part.
bool BreakSearch::find(const Cluster &cluster, const Cluster &room, double window, const Data &all,
                       Break &found) const {
    Cluster core = cluster; // what belongs to neither side
    for (;;) {
        const int64_t first = first_from(param(core.first) - window, room.first, core.first);
        const int64_t end = end_at(param(core.last) + window, core.last + 1, room.last + 1);
        if (core.first - first <= degree_ + 1 || end - core.last <= degree_ + 2 ||
            !(param(first) < param(core.first - 1)) || !(param(core.last + 1) < param(end - 1))) {
            return false;
        }
        const FittedPoints left = polynomial(part(data_, first, core.first), degree_);
        const FittedPoints right = polynomial(part(data_, core.last + 1, end), degree_);
        if (left.largest > tolerance_ || right.largest > tolerance_) {
            return false;
        }
        const Spline &a = *left.fit.spline, &b = *right.fit.spline;
        const bool last = core.last - core.first < 4;
        const Between own = last ? data_between(all, param(core.first - 1), param(core.last + 1))
                                 : data_between(data_, param(core.first - 1), param(core.last + 1));
        const Split split = best_split(a, b, own.params, own.values);
        if (last) {
            return split.distance <= tolerance_ && meet(a, b, own.params, split.at, found);
        }
        const int64_t half = (core.last - core.first) / 4; // of a core that is half as long
        const int64_t middle = std::clamp(core.first - 1 + split.at, core.first + half, core.last - half);
        core = {middle - half, middle + half};
    }
}

// The first datum in [from, end) not before a parameter, and the first one in [first, end) after it.
int64_t BreakSearch::first_from(double t, int64_t from, int64_t end) const noexcept {
    int64_t i = end;
    while (i > from && param(i - 1) >= t) {
        --i;
    }
    return i;
}
int64_t BreakSearch::end_at(double t, int64_t first, int64_t end) const noexcept {
    int64_t i = first;
    while (i < end && param(i) <= t) {
        ++i;
    }
    return i;
}

// The break between data number `at` - 1 and `at`.
bool BreakSearch::meet(const Spline &a, const Spline &b, const std::vector<double> &params, int64_t at,
                       Break &found) const {
    if (at == 0 || at == std::ssize(params)) {
        return false;
    }
    const double lower = params[static_cast<size_t>(at) - 1], upper = params[static_cast<size_t>(at)];
    if (!(lower < upper)) {
        return false;
    }
    const double meeting = nearest(a, b, std::max(lower - (upper - lower), params.front()),
                                   std::min(upper + (upper - lower), params.back()));
    const bool kink = degree_ > 0 && gap(a, b, meeting) <= tolerance_;
    found = kink ? Break{meeting, degree_} : Break{lower + (upper - lower) / 2, degree_ + 1};
    return true;
}

} // namespace nrb::fit
