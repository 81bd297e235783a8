// SPDX-License-Identifier: MIT
#include "fit/adaptive/find_breaks.h"

#include "eval/evaluate.h"
#include "fit/adaptive/chosen_data.h"
#include "fit/least_squares/fit_points.h"
#include "numeric/golden_section.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

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

// The least-squares polynomial of data, compared with them.
FittedPoints polynomial(const Data &data, int degree) {
    FitWishes wishes;
    wishes.regularise = true;
    const Interval domain{data.params(0, 0), data.params(data.params.count - 1, 0)};
    return fit_points(data, {}, simplest_axes({.degrees = {degree}, .domains = {domain}}), wishes, true);
}

// Points of a polynomial, extrapolated outside its domain.
std::vector<double> continued(const Spline &spline, const ConstRecords &params) {
    std::vector<double> points(static_cast<size_t>(params.count * spline.dim()));
    eval::AxisRules rules{};
    rules[0].outside = eval::Outside::extrapolate;
    eval::evaluate_points(spline, rules, 0, params,
                          {points.data(), params.count, spline.dim(), spline.dim(), 1});
    return points;
}

double gap(const Spline &a, const Spline &b, double t) {
    const ConstRecords at{&t, 1, 1, 1, 1};
    const std::vector<double> x = continued(a, at), y = continued(b, at);
    return norm_of(a.dim(), [&](int c) { return x[static_cast<size_t>(c)] - y[static_cast<size_t>(c)]; });
}

// A split of data between the splines before and after a place.
struct Split {
    int64_t at;      // number of data that belong to the first spline
    double distance; // the largest distance of a datum from its spline
};
Split best_split(const Spline &before, const Spline &after, const Data &data) {
    const std::vector<double> a = continued(before, data.params), b = continued(after, data.params);
    const auto dim = static_cast<size_t>(before.dim());
    const auto distance = [&](const std::vector<double> &points, size_t i) {
        return norm_of(before.dim(), [&](int c) {
            return points[i * dim + static_cast<size_t>(c)] - data.values(static_cast<int64_t>(i), c);
        });
    };
    const auto n = static_cast<size_t>(data.params.count);
    std::vector<double> later(n + 1, 0.0);
    for (size_t i = n; i-- > 0;) {
        later[i] = std::max(later[i + 1], distance(b, i));
    }
    Split best{0, later[0]};
    double earlier = 0;
    for (size_t i = 0; i < n; ++i) {
        earlier = std::max(earlier, distance(a, i));
        if (const double both = std::max(earlier, later[i + 1]); both < best.distance) {
            best = {static_cast<int64_t>(i) + 1, both};
        }
    }
    return best;
}

} // namespace

BreakSearch::BreakSearch(const Data &sorted, std::vector<double> distances, int degree, double span,
                         double tolerance)
    : data_(sorted), distances_(std::move(distances)), degree_(degree), span_(span), tolerance_(tolerance) {}

// Groups of data that the fit misses; they are more than two spans apart.
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
    constexpr int widest = 128, narrowest = 4; // spans
    constexpr size_t most_breaks = 64;         // more are noise
    const std::vector<Cluster> places = clusters();
    std::vector<Break> found;
    for (size_t i = 0; i < places.size() && places.size() <= most_breaks; ++i) {
        const Cluster room{i == 0 ? 0 : places[i - 1].last + 1,
                           i + 1 == places.size() ? data_.params.count - 1 : places[i + 1].first - 1};
        Break one{};
        for (int window = widest; window >= narrowest; window /= 2) { // a long window sees through noise
            if (find(places[i], room, window * span_, all, one)) {
                found.push_back(one);
                break;
            }
        }
    }
    return found;
}

// The polynomials on either side are first fitted to data outside the cluster and extrapolated far into it;
// then, step by step, to data ever nearer to the place where they part.
bool BreakSearch::find(const Cluster &cluster, const Cluster &room, double window, const Data &all,
                       Break &found) const {
    Cluster core = cluster; // data that belong to neither side yet
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
        const PackedData between =
            data_between(last ? all : data_, param(core.first - 1), param(core.last + 1));
        const Data own = between.data();
        const Split split = best_split(a, b, own);
        if (last) {
            return split.distance <= tolerance_ && meet(a, b, own.params, split.at, found);
        }
        const int64_t half = (core.last - core.first) / 4; // of a core that is half as long
        const int64_t middle = std::clamp(core.first - 1 + split.at, core.first + half, core.last - half);
        core = {middle - half, middle + half};
    }
}

// first_from() is the first datum in [from, end) at or after a parameter, end_at() the first one in
// [first, end) after it. Both return `end` if there is none.
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

// Finds the break between data `at` - 1 and `at`.
bool BreakSearch::meet(const Spline &a, const Spline &b, const ConstRecords &params, int64_t at,
                       Break &found) const {
    constexpr int sections = 60;
    if (at == 0 || at == params.count) {
        return false;
    }
    const double lower = params(at - 1, 0), upper = params(at, 0);
    if (!(lower < upper)) {
        return false;
    }
    const double meeting = golden_section(std::max(lower - (upper - lower), params(0, 0)),
                                          std::min(upper + (upper - lower), params(params.count - 1, 0)),
                                          sections, [&](double t) { return gap(a, b, t); });
    const bool kink = degree_ > 0 && gap(a, b, meeting) <= tolerance_;
    found = kink ? Break{meeting, degree_} : Break{lower + (upper - lower) / 2, degree_ + 1};
    return true;
}

} // namespace nrb::fit
