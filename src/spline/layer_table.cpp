#include "spline/layer_table.h"

#include "base/checked.h"
#include "spline/contract.h"

#include <algorithm>
#include <cmath>

namespace nrb {

void LayerTable::add_row(int64_t first, const double *coefficients, int size) {
    while (size > 1 && coefficients[size - 1] == 0) {
        --size;
    }
    while (size > 1 && coefficients[0] == 0) {
        ++first;
        ++coefficients;
        --size;
    }
    if (size == 1 && coefficients[0] == 1) {
        return add_copy(first);
    }
    rows_.push_back({first, size, coefficients_.size()});
    coefficients_.insert(coefficients_.end(), coefficients, coefficients + size);
}

namespace {

// One array of records and its view along the axis.
struct Layers {
    const double *data;
    AxisView view;

    [[nodiscard]] const double *at(int64_t outer, int64_t layer) const noexcept {
        return data + (outer * view.count + layer) * view.inner;
    }
};

void check_representable(const double *values, int64_t n) {
    if (!std::all_of(values, values + n, [](double x) { return std::isfinite(x); })) {
        fail(NURBS_ERROR_NOT_REPRESENTABLE, "a new control point overflows double precision");
    }
}

void combine(const LayerTable &table, const LayerTable::Row &row, const Layers &layers, int64_t outer,
             double *out) {
    const int64_t inner = layers.view.inner;
    if (row.size == 0) {
        std::copy_n(layers.at(outer, row.first), inner, out);
        return;
    }
    contract(table.coefficients(row), row.size, layers.at(outer, row.first), inner, inner, out);
    check_representable(out, inner);
}

std::vector<double> combine_all(const LayerTable &table, const Layers &layers) {
    const int64_t inner = layers.view.inner;
    const int64_t size = checked_product(layers.view.outer * inner, table.rows(), "points");
    std::vector<double> result;
    result.reserve(static_cast<size_t>(size) + Spline::padding); // what a spline made of them will append
    result.resize(static_cast<size_t>(size));
    for (int64_t o = 0; o < layers.view.outer; ++o) {
        for (int64_t r = 0; r < table.rows(); ++r) {
            combine(table, table.row(r), layers, o, result.data() + (o * table.rows() + r) * inner);
        }
    }
    return result;
}

// Overwrites one layer of Cartesian points by the quotients of the homogeneous sums, wherever their weight
// allows.
void project(const std::vector<double> &sums, int dim, double *points) {
    const int64_t width = dim + 1;
    const auto count = static_cast<int64_t>(sums.size()) / width;
    for (int64_t i = 0; i < count; ++i) {
        const double *sum = sums.data() + i * width;
        if (sum[dim] != 0) {
            std::transform(sum, sum + dim, points + i * dim, [w = sum[dim]](double x) { return x / w; });
        }
    }
}

Net apply_rational(const Spline &spline, int axis, const LayerTable &table) {
    const int dim = spline.dim();
    const Layers records{spline.records().data(), axis_view(spline, axis, dim + 1)};
    const Layers weights{spline.weights().data(), axis_view(spline, axis, 1)};
    Net net{combine_all(table, {spline.points().data(), axis_view(spline, axis, dim)}),
            combine_all(table, weights)};
    std::vector<double> sums(static_cast<size_t>(records.view.inner));
    for (int64_t o = 0; o < records.view.outer; ++o) {
        for (int64_t r = 0; r < table.rows(); ++r) {
            if (table.row(r).size == 0) {
                continue;
            }
            combine(table, table.row(r), records, o, sums.data());
            const int64_t target = (o * table.rows() + r) * weights.view.inner;
            project(sums, dim, net.points.data() + target * dim);
        }
    }
    check_representable(net.points.data(), static_cast<int64_t>(net.points.size()));
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
