// SPDX-License-Identifier: MIT
// Conditions on a spline's points and weights.
#include "base/checked.h"
#include "base/finite.h"
#include "base/limits.h"
#include "spline/axis_view.h"
#include "spline/spline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

namespace nrb::inline spline {

void check_axes(int axes) {
    if (axes < 1 || axes > max_axes) {
        fail(Status::axes, "axes = %d, expected 1 to %d", axes, max_axes);
    }
}

void check_dimension(int dim) {
    constexpr int largest =
        std::numeric_limits<int32_t>::max() - 1; // a homogeneous record has one more value
    if (dim < 1 || dim > largest) {
        fail(Status::dimension, "dim = %d, expected 1 to %d", dim, largest);
    }
}

namespace {

// The values to be checked one by one.
struct GivenValues {
    Form form;
    size_t dim;
    std::span<const double> points;
    std::span<const double> weights;
};

GivenValues values_of(const Spline &spline) noexcept {
    return {spline.form(), static_cast<size_t>(spline.dim()), spline.points(), spline.weights()};
}

void check_points(const GivenValues &given, Values values) {
    const std::span<const double> points = given.points;
    const size_t width = given.form == Form::homogeneous ? given.dim + 1 : given.dim;
    for (size_t i = all_finite(points) ? points.size() : 0; i < points.size(); ++i) {
        if (std::isfinite(points[i])) {
            continue;
        }
        if (values == Values::computed) {
            fail(Status::not_representable, "points[%zu][%zu] of the result overflows", i / width, i % width);
        }
        fail(i % width == given.dim ? Status::weight_not_finite : Status::point_not_finite,
             "points[%zu][%zu] = %s is not finite", i / width, i % width, Number(points[i]).text);
    }
}

void check_points(const Spline &spline, Values values) {
    if (!spline.moderate()) {
        check_points(values_of(spline), values);
    }
}

void check_weight(double weight, size_t i, Values values) {
    if (!std::isfinite(weight) && values == Values::computed) {
        fail(Status::not_representable, "weights[%zu] of the result overflows", i);
    }
    if (!std::isfinite(weight)) {
        fail(Status::weight_not_finite, "weights[%zu] = %s is not finite", i, Number(weight).text);
    }
    if (weight < 0) {
        fail(Status::weight_negative, "weights[%zu] = %s, expected >= 0", i, Number(weight).text);
    }
}

// Checks weights 0, ..., end - 1, and their products with the points.
void check_weight_values(const GivenValues &given, Values values, size_t end) {
    for (size_t i = 0; i < end; ++i) {
        const double weight = given.weights[i];
        check_weight(weight, i, values);
        for (size_t c = 0; c < given.dim; ++c) {
            const double point = given.points[i * given.dim + c];
            if (!std::isfinite(weight * point)) {
                fail(Status::not_representable, "weights[%zu] * points[%zu][%zu] = %s * %s overflows", i, i,
                     c, Number(weight).text, Number(point).text);
            }
        }
    }
}

// A sufficient condition for check_weight_values() to accept all weights, without a branch for each of them.
bool harmless_weights(const Spline &spline) noexcept {
    const auto [smallest, largest] = spline.all_weights();
    return all_finite(spline.weights()) && smallest >= 0 &&
           std::isfinite(largest * largest_magnitude(spline.points()));
}

void check_weight_values(const Spline &spline, Values values, size_t end) {
    if (!harmless_weights(spline)) {
        check_weight_values(values_of(spline), values, end);
    }
}

// The index of the first negative weight; the number of weights if there is none.
size_t first_negative(const Spline &spline) noexcept {
    const std::span<const double> weights = spline.weights();
    const auto found = std::find_if(weights.begin(), weights.end(), [](double weight) { return weight < 0; });
    return static_cast<size_t>(found - weights.begin());
}

// A run of layers along one axis, at least one of which must have a weight other than 0, and the parameter at
// which this is required.
struct Window {
    int64_t first;
    int64_t last;
    double parameter;
};

// The windows that ensure w(t) > 0: for both ends of every span, the functions that do not vanish there.
// These are among the functions of the open span, so the inside of a span needs no window of its own.
std::vector<Window> support_windows(const KnotVector &axis) {
    const int p = axis.degree();
    const SpanTable &table = axis.spans();
    std::vector<Window> windows;
    for (size_t k = 0; k < table.indices().size(); ++k) {
        const int64_t s = table.indices()[k];
        int at_start = 1;
        while (at_start < p && axis[s - at_start] == axis[s]) {
            ++at_start;
        }
        int at_end = 1;
        while (at_end < p && axis[s + 1 + at_end] == axis[s + 1]) {
            ++at_end;
        }
        windows.push_back({s - p, s - std::min(at_start, p), axis[s]});
        windows.push_back({s - p + std::min(at_end, p), s, axis[s + 1]});
    }
    return windows;
}

// The windows for homogeneous weights, one for each span. Since they may have any sign, only spans all of
// whose weights are 0 can be excluded.
std::vector<Window> span_windows(const KnotVector &axis) {
    std::vector<Window> windows;
    for (const int64_t s : axis.spans().indices()) {
        windows.push_back({s - axis.degree(), s, axis[s]});
    }
    return windows;
}

// Replaces the layers of an axis by its windows. A window carries a weight if any of its layers does.
std::vector<char> merge_layers(const std::vector<char> &carried, const AxisView &view,
                               const std::vector<Window> &windows) {
    const auto layers = static_cast<int64_t>(windows.size());
    std::vector<char> merged(static_cast<size_t>(checked_product(view.outer * view.inner, layers, "weights")),
                             0);
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t l = 0; l < layers; ++l) {
            char *target = merged.data() + (o * layers + l) * view.inner;
            for (int64_t i = windows[static_cast<size_t>(l)].first; i <= windows[static_cast<size_t>(l)].last;
                 ++i) {
                const char *source = carried.data() + (o * view.count + i) * view.inner;
                std::transform(source, source + view.inner, target, target, std::bit_or<>());
            }
        }
    }
    return merged;
}

// The windows of each axis, and for each combination of them whether it carries a weight, the last axis
// fastest.
struct Supports {
    std::vector<std::vector<Window>> windows;
    std::vector<char> carried;
};

// Both are empty if all weights are positive.
Supports weight_supports(const Spline &spline) {
    Supports supports;
    if (spline.all_weights().smallest > 0) {
        return supports;
    }
    std::vector<char> &carried = supports.carried;
    carried.resize(static_cast<size_t>(spline.point_count()));
    for (size_t i = 0; i < carried.size(); ++i) {
        carried[i] = spline.weight(static_cast<int64_t>(i)) != 0 ? 1 : 0;
    }
    AxisView view = axis_view(spline, 0, 1);
    for (int k = 0; k < spline.axes(); ++k) {
        const KnotVector &axis = spline.axis(k);
        supports.windows.push_back(spline.form() == Form::homogeneous ? span_windows(axis)
                                                                      : support_windows(axis));
        const auto layers = static_cast<int64_t>(supports.windows.back().size());
        carried = merge_layers(carried, view, supports.windows.back());
        if (k + 1 < spline.axes()) {
            view = {view.outer * layers, spline.count(k + 1), view.inner / spline.count(k + 1)};
        }
    }
    return supports;
}

// The index of the first combination of windows without a weight; -1 if there is none.
int64_t first_hole(const Supports &supports) noexcept {
    const auto hole = std::find(supports.carried.begin(), supports.carried.end(), 0);
    return hole == supports.carried.end() ? -1 : hole - supports.carried.begin();
}

[[noreturn]] void fail_vanishing(const Supports &supports, int64_t index) {
    const size_t axes = supports.windows.size();
    char where[120] = "";
    size_t used = 0;
    for (size_t k = 0; k < axes; ++k) {
        int64_t inner = 1;
        for (size_t j = k + 1; j < axes; ++j) {
            inner *= std::ssize(supports.windows[j]);
        }
        const Window &window = supports.windows[k][static_cast<size_t>(index / inner)];
        index %= inner;
        used += static_cast<size_t>(std::snprintf(where + used, sizeof where - used, "%s%s",
                                                  k == 0 ? "" : ", ", Number(window.parameter).text));
    }
    fail(Status::weights_vanish, "weights: every weight that is active at parameter (%s) is 0", where);
}

void check_weight_supports(const Spline &spline) {
    const Supports supports = weight_supports(spline);
    const int64_t hole = first_hole(supports);
    if (hole >= 0) {
        fail_vanishing(supports, hole);
    }
}

bool same_bits(double a, double b) noexcept {
    return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

// Checks that wrapped layers repeat the first ones bit for bit. Each control point has `width` values.
void check_wrapping(const Spline &spline, int k, std::span<const double> values, int width,
                    const char *name) {
    const AxisView view = axis_view(spline, k, width);
    const int64_t period = spline.axis(k).distinct_layers() * view.inner;
    const int64_t row = view.count * view.inner;
    for (int64_t o = 0; o < view.outer; ++o) {
        const double *begin = values.data() + o * row;
        const double *end = begin + row - period;
        const double *at = std::mismatch(begin, end, begin + period, same_bits).first;
        if (at != end) {
            const long long original = (at - values.data()) / width;
            fail(Status::periodic_points,
                 "%s[%lld] = %s differs from %s[%lld] = %s, which it repeats on periodic axis %d", name,
                 original + period / width, Number(at[period]).text, name, original, Number(*at).text, k);
        }
    }
}

void check_periodic_axes(const Spline &spline) {
    for (int k = 0; k < spline.axes(); ++k) {
        if (spline.axis(k).periodic()) {
            check_wrapping(spline, k, spline.points(), spline.stored_width(), "points");
            if (spline.form() == Form::rational) {
                check_wrapping(spline, k, spline.weights(), 1, "weights");
            }
        }
    }
}

} // namespace

void check_values(int dim, std::span<const double> points, std::span<const double> weights) {
    const GivenValues given{Form::rational, static_cast<size_t>(dim), points, weights};
    check_points(given, Values::given);
    check_weight_values(given, Values::given, weights.size());
}

void check_spline(const Spline &spline, Values values) {
    check_points(spline, values);
    check_weight_values(spline, values, spline.weights().size());
    if (spline.rational()) {
        check_weight_supports(spline);
    }
    check_periodic_axes(spline);
}

namespace {

SplinePtr make_sized(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                     std::vector<double> weights) {
    auto spline =
        std::make_shared<const Spline>(std::move(axes), dim, form, std::move(points), std::move(weights));
    const int64_t count = spline->point_count();
    if (static_cast<int64_t>(spline->points().size()) != count * spline->stored_width() ||
        static_cast<int64_t>(spline->weights().size()) != (form == Form::rational ? count : 0)) {
        fail(Status::size, "points: %zu values and %zu weights, expected %lld points of %d values",
             spline->points().size(), spline->weights().size(), static_cast<long long>(count),
             spline->stored_width());
    }
    return spline;
}

SplinePtr make_checked(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                       std::vector<double> weights, Values values) {
    SplinePtr spline = make_sized(std::move(axes), dim, form, std::move(points), std::move(weights));
    check_spline(*spline, values);
    return spline;
}

} // namespace

SplinePtr make_spline(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                      std::vector<double> weights) {
    return make_checked(std::move(axes), dim, form, std::move(points), std::move(weights), Values::given);
}

SplinePtr make_result(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                      std::vector<double> weights) {
    return make_checked(std::move(axes), dim, form, std::move(points), std::move(weights), Values::computed);
}

// Makes the checks of check_spline() in the same order, so that an overflow before the first negative weight
// is an error here too.
SplinePtr make_result_if_valid(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                               std::vector<double> weights) {
    SplinePtr spline = make_sized(std::move(axes), dim, form, std::move(points), std::move(weights));
    check_points(*spline, Values::computed);
    const size_t negative = first_negative(*spline);
    check_weight_values(*spline, Values::computed, negative);
    if (negative < spline->weights().size() ||
        (spline->rational() && first_hole(weight_supports(*spline)) >= 0)) {
        return nullptr;
    }
    check_periodic_axes(*spline);
    return spline;
}

} // namespace nrb::inline spline
