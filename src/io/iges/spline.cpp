// SPDX-License-Identifier: MIT
#include "io/iges/spline.h"

#include "base/error.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cstring>

namespace nrb::io::iges {
namespace {

// One common weight cancels. Common zeros do not: they stay and are refused.
bool weights_matter(const SplineData &data) {
    const double first = data.weights.front();
    return first == 0 ||
           std::any_of(data.weights.begin(), data.weights.end(), [&](double w) { return w != first; });
}

std::array<double, 3> placed(const double *point, const Placement &placement) {
    std::array<double, 3> x = {point[0], point[1], point[2]};
    if (placement.transform != nullptr) {
        x = placement.transform->apply(x);
    }
    for (double &value : x) {
        value *= placement.factor;
    }
    return x;
}

std::vector<double> place_points(const std::vector<double> &points, const Placement &placement) {
    const size_t dim = placement.parameter_plane ? 2 : 3;
    std::vector<double> result;
    result.reserve(points.size() / 3 * dim);
    for (size_t i = 0; i < points.size(); i += 3) {
        const std::array<double, 3> x = placed(points.data() + i, placement);
        result.insert(result.end(), x.begin(), x.begin() + static_cast<std::ptrdiff_t>(dim));
    }
    return result;
}

// Records of `width` doubles of a spline of the given axes: whether the last `degree` layers along one axis
// equal the first ones bit for bit.
bool wraps(const std::vector<double> &values, size_t width, const SplineData &data, size_t along) {
    const SplineData::Axis &axis = data.axes[along];
    size_t inner = width;
    for (size_t k = along + 1; k < data.axes.size(); ++k) {
        inner *= static_cast<size_t>(data.axes[k].count);
    }
    const size_t slab = inner * static_cast<size_t>(axis.count);
    const size_t wrapped = inner * static_cast<size_t>(axis.degree);
    for (size_t start = 0; start < values.size(); start += slab) {
        const double *first = values.data() + start;
        if (std::memcmp(first, first + slab - wrapped, wrapped * sizeof(double)) != 0) {
            return false;
        }
    }
    return true;
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

// Precondition: the knots are valid.
bool wraps_as_stated(const SplineData &data, const std::vector<double> &points, size_t dim, size_t along) {
    const SplineData::Axis &axis = data.axes[along];
    return axis.periodic && first_not_repeated(axis.degree, axis.knots) < 0 &&
           wraps(points, dim, data, along) && wraps(data.weights, 1, data, along);
}

Spline::Axes make_axes(const SplineData &data, const std::vector<double> &points, size_t dim) {
    Spline::Axes axes;
    for (size_t k = 0; k < data.axes.size(); ++k) {
        const SplineData::Axis &axis = data.axes[k];
        const int name = data.axes.size() == 1 ? -1 : static_cast<int>(k);
        check_knots(axis.degree, axis.knots, name, 0);
        axes.push_back(std::make_shared<const KnotVector>(axis.degree, axis.knots,
                                                          wraps_as_stated(data, points, dim, k)));
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
    const size_t dim = placement.parameter_plane ? 2 : 3;
    std::vector<double> points = place_points(data.points, placement);
    if (!weights_matter(data)) {
        data.weights.clear();
    }
    Spline::Axes axes = make_axes(data, points, dim);
    const Form form = data.weights.empty() ? Form::polynomial : Form::rational;
    SplinePtr whole =
        make_spline(std::move(axes), static_cast<int>(dim), form, std::move(points), std::move(data.weights));
    return cut_to_ranges(std::move(whole), data.axes);
}

} // namespace nrb::io::iges
