// SPDX-License-Identifier: MIT
#include "io/iges/geometry/spline.h"

#include "base/error.h"
#include "refine/parts/cut.h"
#include "refine/periodic/unwrapped.h"

#include <algorithm>
#include <cstring>

namespace nrb::io::iges {
namespace {

// A common nonzero weight cancels. If all weights are 0, they are kept, and refused later.
bool weights_matter(const SplineData &data) {
    const double first = data.weights.front();
    return first == 0 ||
           std::any_of(data.weights.begin(), data.weights.end(), [&](double w) { return w != first; });
}

std::vector<double> place_points(const std::vector<double> &points, const Placement &placement) {
    const size_t dim = placement.parameter_plane ? 2 : 3;
    std::vector<double> result;
    result.reserve(points.size() / 3 * dim);
    for (size_t i = 0; i < points.size(); i += 3) {
        const std::array<double, 3> x = placement.point({points[i], points[i + 1], points[i + 2]});
        result.insert(result.end(), x.begin(), x.begin() + static_cast<std::ptrdiff_t>(dim));
    }
    return result;
}

// The control points, while axes are made periodic.
struct PlacedNet {
    int64_t dim;
    std::vector<int64_t> counts;
    std::vector<double> points;
    std::vector<double> weights;

    [[nodiscard]] AxisView view(size_t along, int64_t width) const {
        AxisView view{1, counts[along], width};
        for (size_t k = 0; k < counts.size(); ++k) {
            (k < along ? view.outer : view.inner) *= k == along ? 1 : counts[k];
        }
        return view;
    }
};

// Whether the layers from index `period` on equal the first ones bit for bit.
bool repeats(const std::vector<double> &values, const AxisView &view, int64_t period) {
    const auto slab = static_cast<size_t>(view.count * view.inner);
    const auto later = static_cast<size_t>(period * view.inner);
    for (size_t start = 0; start < values.size(); start += slab) {
        const double *first = values.data() + start;
        if (std::memcmp(first, first + later, (slab - later) * sizeof(double)) != 0) {
            return false;
        }
    }
    return true;
}

bool repeats(const PlacedNet &net, size_t along, int64_t period) {
    return repeats(net.points, net.view(along, net.dim), period) &&
           repeats(net.weights, net.view(along, 1), period);
}

Interval domain_of(const SplineData::Axis &axis) {
    return {axis.knots[static_cast<size_t>(axis.degree)], axis.knots[static_cast<size_t>(axis.count)]};
}

// The part of the domain inside the stated range. Precondition: the knots are valid.
Interval clipped_range(const SplineData::Axis &axis) {
    const Interval domain = domain_of(axis);
    if (axis.whole) {
        return domain;
    }
    if (!(axis.lower < axis.upper)) {
        fail(Status::empty_domain, "parameter range [%s, %s] is empty", Number(axis.lower).text,
             Number(axis.upper).text);
    }
    if (axis.lower >= domain.upper || axis.upper <= domain.lower) {
        fail(Status::outside_domain, "parameter range [%s, %s] outside the domain [%s, %s]",
             Number(axis.lower).text, Number(axis.upper).text, Number(domain.lower).text,
             Number(domain.upper).text);
    }
    return {std::max(axis.lower, domain.lower), std::min(axis.upper, domain.upper)};
}

bool cuts(const SplineData::Axis &axis, const Interval &range) {
    const Interval domain = domain_of(axis);
    return range.lower > domain.lower || range.upper < domain.upper;
}

// Whether the axis is periodic as stored. Precondition: the knots are valid.
bool wraps(const SplineData::Axis &axis, const PlacedNet &net, size_t along) {
    return first_not_repeated(axis.degree, axis.knots) < 0 && repeats(net, along, axis.count - axis.degree);
}

// The knots of a period, if the axis is closed but not wrapped: up to the last copy of the end of the domain
// on which functions on the domain depend. A clamped axis has `degree` such copies.
std::span<const double> period_of(const SplineData::Axis &axis) {
    const auto first = static_cast<size_t>(axis.degree), end = static_cast<size_t>(axis.count);
    size_t last = end;
    while (last + 1 < end + first && axis.knots[last + 1] == axis.knots[end]) {
        ++last;
    }
    return std::span(axis.knots).subspan(first, last + 1 - first);
}

// All knots of the wrapped axis; empty if they cannot be made.
std::vector<double> wrapped_if_possible(int degree, std::span<const double> period) {
    try {
        return refine::wrapped_knots(degree, period);
    } catch (const Error &) {
        return {};
    }
}

// Converts a closed axis to a wrapped one, provided that every knot and control point with influence on the
// domain stays unchanged. Precondition: the knots are valid.
bool wrap(const SplineData::Axis &axis, PlacedNet &net, size_t along, std::vector<double> &knots) {
    const std::span<const double> period = period_of(axis);
    const int64_t distinct = std::ssize(period) - 1, count = distinct + axis.degree;
    if (axis.degree == 0 || !repeats(net, along, distinct)) {
        return false;
    }
    std::vector<double> all = wrapped_if_possible(axis.degree, period);
    if (all.empty() || !std::equal(axis.knots.begin() + 1, axis.knots.end() - 1, all.begin() + 1)) {
        return false;
    }
    const auto wrapped = [&](const std::vector<double> &values, int64_t width) {
        return refine::wrapped_layers(values, net.view(along, width), distinct, count);
    };
    net.points = wrapped(net.points, net.dim);
    net.weights = net.weights.empty() ? net.weights : wrapped(net.weights, 1);
    net.counts[along] = count;
    knots = std::move(all);
    return true;
}

Spline::Axes make_axes(const SplineData &data, PlacedNet &net) {
    Spline::Axes axes;
    for (size_t k = 0; k < data.axes.size(); ++k) {
        const SplineData::Axis &axis = data.axes[k];
        const int name = data.axes.size() == 1 ? -1 : static_cast<int>(k);
        check_knots(axis.degree, axis.knots, name, 0);
        std::vector<double> knots = axis.knots;
        const bool periodic = axis.periodic && (wraps(axis, net, k) || wrap(axis, net, k, knots));
        axes.push_back(std::make_shared<const KnotVector>(axis.degree, std::move(knots), periodic));
    }
    return axes;
}

SplinePtr cut_to_ranges(SplinePtr spline, const std::vector<SplineData::Axis> &axes) {
    for (size_t k = 0; k < axes.size(); ++k) {
        const Interval range = clipped_range(axes[k]);
        if (cuts(axes[k], range)) {
            spline = refine::restrict_axis(spline, static_cast<int>(k), range.lower, range.upper);
        }
    }
    return spline;
}

} // namespace

SplinePtr build_spline(SplineData data, const Placement &placement) {
    PlacedNet net{placement.parameter_plane ? 2 : 3, {}, place_points(data.points, placement), {}};
    for (const SplineData::Axis &axis : data.axes) {
        net.counts.push_back(axis.count);
    }
    if (weights_matter(data)) {
        net.weights = std::move(data.weights);
    }
    Spline::Axes axes = make_axes(data, net);
    const Form form = net.weights.empty() ? Form::polynomial : Form::rational;
    SplinePtr whole = make_spline(std::move(axes), static_cast<int>(net.dim), form, std::move(net.points),
                                  std::move(net.weights));
    return cut_to_ranges(std::move(whole), data.axes);
}

} // namespace nrb::io::iges
