#include "support/handle.h"

#include <bit>
#include <stdexcept>

namespace support {

void require_ok(nurbs_status status) {
    if (status != NURBS_OK) {
        throw std::runtime_error(std::string(nurbs_status_name(status)) + ": " + last_error());
    }
}

std::string last_error() {
    std::string text(static_cast<size_t>(nurbs_last_error(nullptr, 0)) + 1, '\0');
    nurbs_last_error(text.data(), static_cast<int64_t>(text.size()));
    text.pop_back();
    return text;
}

nurbs_status try_create(const SplineData &data, Handle &out) {
    nurbs *g = nullptr;
    const std::vector<double> knots = data.all_knots();
    const nurbs_status status =
        nurbs_create(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                     static_cast<int64_t>(knots.size()), data.dim, data.points.data(), 0, 0,
                     data.rational() ? data.weights.data() : nullptr, 0, data.flags, &g);
    out.reset(g);
    return status;
}

Handle create(const SplineData &data) {
    Handle g;
    require_ok(try_create(data, g));
    return g;
}

namespace {

int32_t axes_of(const nurbs *g) {
    int32_t axes = 0;
    require_ok(nurbs_axes(g, &axes));
    return axes;
}

int32_t dim_of(const nurbs *g) {
    int32_t dim = 0;
    require_ok(nurbs_dimension(g, &dim));
    return dim;
}

int64_t records_of(const nurbs *g, const std::vector<double> &params) {
    return static_cast<int64_t>(params.size()) / axes_of(g);
}

int64_t slots_of(const nurbs *g, int order) {
    int64_t slots = 0;
    require_ok(nurbs_derivative_slots(axes_of(g), order, &slots));
    return slots;
}

struct Grid {
    std::vector<int64_t> counts;
    std::vector<double> params;
    int64_t size = 1;
};

Grid joined(const std::vector<std::vector<double>> &params) {
    Grid grid;
    for (const auto &axis : params) {
        grid.counts.push_back(static_cast<int64_t>(axis.size()));
        grid.params.insert(grid.params.end(), axis.begin(), axis.end());
        grid.size *= grid.counts.back();
    }
    return grid;
}

void read_axis(const nurbs *g, int32_t axis, SplineData &data) {
    int32_t degree = 0;
    int64_t count = 0;
    int32_t form = 0;
    require_ok(nurbs_degree(g, axis, &degree));
    require_ok(nurbs_count(g, axis, &count));
    require_ok(nurbs_knot_form(g, axis, &form));
    std::vector<double> knots(static_cast<size_t>(count + degree + 1));
    require_ok(nurbs_knots(g, axis, count + degree + 1, knots.data()));
    data.degrees.push_back(degree);
    data.counts.push_back(count);
    data.knots.push_back(std::move(knots));
    data.flags |= (form & NURBS_FORM_PERIODIC) != 0 ? NURBS_ON_AXIS(axis, NURBS_PERIODIC) : 0U;
}

} // namespace

SplineData read_back(const nurbs *g) {
    SplineData data;
    for (int32_t axis = 0; axis < axes_of(g); ++axis) {
        read_axis(g, axis, data);
    }
    data.dim = dim_of(g);
    int64_t count = 0;
    int32_t rational = 0;
    require_ok(nurbs_point_count(g, &count));
    require_ok(nurbs_is_rational(g, &rational));
    data.points.resize(static_cast<size_t>(count * data.dim));
    require_ok(nurbs_points(g, count, data.points.data(), 0, 0));
    if (rational != 0) {
        data.weights.resize(static_cast<size_t>(count));
        require_ok(nurbs_weights(g, count, data.weights.data(), 0));
    }
    return data;
}

std::vector<double> homogeneous_points(const nurbs *g) {
    int64_t count = 0;
    require_ok(nurbs_point_count(g, &count));
    std::vector<double> points(static_cast<size_t>(count * (dim_of(g) + 1)));
    require_ok(nurbs_homogeneous_points(g, count, points.data(), 0, 0));
    return points;
}

std::vector<double> eval(const nurbs *g, const std::vector<double> &params, uint32_t flags) {
    const int64_t n = records_of(g, params);
    std::vector<double> points(static_cast<size_t>(n * dim_of(g)));
    require_ok(nurbs_eval(g, n, params.data(), 0, 0, points.data(), 0, 0, flags));
    return points;
}

std::vector<double> eval_derivs(const nurbs *g, int order, const std::vector<double> &params,
                                uint32_t flags) {
    const int64_t n = records_of(g, params);
    std::vector<double> derivs(static_cast<size_t>(n * slots_of(g, order) * dim_of(g)));
    require_ok(nurbs_eval_derivs(g, order, n, params.data(), 0, 0, derivs.data(), 0, 0, flags));
    return derivs;
}

std::vector<double> hull_sizes(const nurbs *g, const std::vector<double> &params, uint32_t flags) {
    const int64_t n = records_of(g, params);
    std::vector<double> sizes(static_cast<size_t>(n));
    require_ok(nurbs_hull_size(g, n, params.data(), 0, 0, sizes.data(), 0, flags));
    return sizes;
}

std::vector<double> rational_basis(const nurbs *g, const std::vector<double> &params, uint32_t flags) {
    int64_t width = 1;
    for (int32_t axis = 0; axis < axes_of(g); ++axis) {
        int32_t degree = 0;
        require_ok(nurbs_degree(g, axis, &degree));
        width *= degree + 1;
    }
    const int64_t n = records_of(g, params);
    std::vector<double> values(static_cast<size_t>(n * width));
    require_ok(nurbs_rational_basis(g, n, params.data(), 0, 0, nullptr, values.data(), 0, 0, flags));
    return values;
}

std::vector<double> eval_grid(const nurbs *g, const std::vector<std::vector<double>> &params,
                              uint32_t flags) {
    const Grid grid = joined(params);
    std::vector<double> points(static_cast<size_t>(grid.size * dim_of(g)));
    require_ok(nurbs_eval_grid(g, grid.counts.data(), grid.params.data(), points.data(), 0, 0, flags));
    return points;
}

std::vector<double> eval_grid_derivs(const nurbs *g, int order,
                                     const std::vector<std::vector<double>> &params, uint32_t flags) {
    const Grid grid = joined(params);
    std::vector<double> derivs(static_cast<size_t>(grid.size * slots_of(g, order) * dim_of(g)));
    require_ok(
        nurbs_eval_grid_derivs(g, order, grid.counts.data(), grid.params.data(), derivs.data(), 0, 0, flags));
    return derivs;
}

Handle insert(const nurbs *g, int axis, double knot, int times) {
    nurbs *out = nullptr;
    require_ok(nurbs_insert_knot(g, axis, knot, times, &out));
    return Handle(out);
}

Handle elevate(const nurbs *g, int axis, int times) {
    nurbs *out = nullptr;
    require_ok(nurbs_elevate(g, axis, times, &out));
    return Handle(out);
}

Handle iso(const nurbs *g, int axis, double param, uint32_t flags) {
    nurbs *out = nullptr;
    require_ok(nurbs_iso(g, axis, param, flags, &out));
    return Handle(out);
}

bool same_bits(double a, double b) {
    return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
    if (a.size() != b.size()) {
        return false;
    }
    for (size_t i = 0; i < a.size(); ++i) {
        if (!same_bits(a[i], b[i])) {
            return false;
        }
    }
    return true;
}

} // namespace support
