#include "spline/layer_table.h"

#include "base/checked.h"
#include "base/finite.h"
#include "spline/contract.h"

#include <algorithm>

namespace nrb {

namespace {

// An array of records and its view along the axis.
struct Layers {
    const double *data;
    AxisView view;

    [[nodiscard]] const double *at(int64_t outer, int64_t layer) const noexcept {
        return data + (outer * view.count + layer) * view.inner;
    }
};

void check_representable(std::span<const double> values) {
    if (!all_finite(values)) {
        fail(NURBS_ERROR_NOT_REPRESENTABLE, "a new control point overflows double precision");
    }
}

inline void combine(const LayerTable &table, const LayerTable::Row &row, const Layers &layers, int64_t outer,
                    double *out) noexcept {
    const int64_t inner = layers.view.inner;
    const double *from = layers.at(outer, row.first);
    if (row.size == 0) {
        std::copy_n(from, inner, out);
    } else {
        contract(table.coefficients(row), row.size, from, inner, inner, out);
    }
}

// Room for the layers of a new spline, which needs its padding too.
std::vector<double> new_layers(const AxisView &view, int64_t layers) {
    const int64_t size = checked_product(view.outer * view.inner, layers, "points");
    std::vector<double> result;
    result.reserve(static_cast<size_t>(checked_sum(size, static_cast<int64_t>(Spline::padding), "points")));
    result.resize(static_cast<size_t>(size));
    return result;
}

std::vector<double> combine_all(const LayerTable &table, const Layers &layers) {
    std::vector<double> result = new_layers(layers.view, table.rows());
    double *out = result.data();
    for (int64_t o = 0; o < layers.view.outer; ++o) {
        for (int64_t r = 0; r < table.rows(); ++r, out += layers.view.inner) {
            combine(table, table.row(r), layers, o, out);
        }
    }
    check_representable(result);
    return result;
}

// Whether every homogeneous sum of a layer has a weight.
bool weighted(const double *sums, int64_t count, int dim) noexcept {
    bool all = true;
    for (int64_t i = 0; i < count; ++i) {
        all = all && sums[i * (dim + 1) + dim] != 0;
    }
    return all;
}

// The quotients of one layer of homogeneous sums, wherever their weight allows.
void project(const double *sums, int64_t count, int dim, double *points) noexcept {
    for (int64_t i = 0; i < count; ++i, sums += dim + 1, points += dim) {
        if (sums[dim] != 0) {
            std::transform(sums, sums + dim, points, [w = sums[dim]](double x) { return x / w; });
        }
    }
}

Net apply_rational(const Spline &spline, int axis, const LayerTable &table) {
    const int dim = spline.dim();
    const Layers points{spline.points().data(), axis_view(spline, axis, dim)};
    const Layers weights{spline.weights().data(), axis_view(spline, axis, 1)};
    const Layers records{spline.records().data(), axis_view(spline, axis, dim + 1)};
    Net net{new_layers(points.view, table.rows()), combine_all(table, weights)};
    std::vector<double> sums(static_cast<size_t>(records.view.inner));
    double *out = net.points.data();
    for (int64_t o = 0; o < records.view.outer; ++o) {
        for (int64_t r = 0; r < table.rows(); ++r, out += points.view.inner) {
            const LayerTable::Row &row = table.row(r);
            if (row.size == 0) {
                std::copy_n(points.at(o, row.first), points.view.inner, out);
                continue;
            }
            combine(table, row, records, o, sums.data());
            if (!weighted(sums.data(), weights.view.inner, dim)) {
                combine(table, row, points, o, out);
            }
            project(sums.data(), weights.view.inner, dim, out);
        }
    }
    check_representable(net.points);
    return net;
}

} // namespace

Net apply_along(const Spline &spline, int axis, const LayerTable &table) {
    if (spline.form() == Form::rational) {
        return apply_rational(spline, axis, table);
    }
    return {combine_all(table, {spline.points().data(), axis_view(spline, axis, spline.stored_width())}), {}};
}

} // namespace nrb
