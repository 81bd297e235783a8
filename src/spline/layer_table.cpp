#include "spline/layer_table.h"

#include "base/checked.h"
#include "base/representable.h"
#include "spline/contract.h"
#include "spline/short_layers.h"

#include <algorithm>

namespace nrb {

namespace {

// An array of records and its view along the axis.
struct Layers {
    const double *data;
    AxisView view;
    bool padded;

    [[nodiscard]] const double *at(int64_t outer, int64_t layer) const noexcept {
        return data + (outer * view.count + layer) * view.inner;
    }
};

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

// Room for the layers of a new spline, and its padding.
std::vector<double> new_layers(const AxisView &view, int64_t layers) {
    const int64_t size = checked_product(view.outer * view.inner, layers, "points");
    constexpr auto padding = static_cast<int64_t>(Spline::padding);
    return std::vector<double>(static_cast<size_t>(checked_sum(size, padding, "points")));
}

// The same without the padding, once the layers are made.
std::vector<double> finished(std::vector<double> layers) {
    layers.resize(layers.size() - Spline::padding);
    require_representable(layers, "control points");
    return layers;
}

std::vector<double> combine_all(const LayerTable &table, const Layers &layers) {
    std::vector<double> result = new_layers(layers.view, table.rows());
    double *out = result.data();
    for (int64_t o = 0; o < layers.view.outer; ++o) {
        if (layers.padded && layers.view.inner <= longest_short_layer) {
            combine_short(table, layers.at(o, 0), static_cast<int>(layers.view.inner), out);
            out += table.rows() * layers.view.inner;
            continue;
        }
        for (int64_t r = 0; r < table.rows(); ++r, out += layers.view.inner) {
            combine(table, table.row(r), layers, o, out);
        }
    }
    return finished(std::move(result));
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
        const double weight = sums[dim] != 0 ? sums[dim] : 1;
        for (int c = 0; c < dim; ++c) {
            points[c] = sums[dim] != 0 ? sums[c] / weight : points[c];
        }
    }
}

class RationalLayers {
public:
    RationalLayers(const Spline &spline, int axis)
        : dim_(spline.dim()), points_{spline.points().data(), axis_view(spline, axis, dim_), true},
          weights_{spline.weights().data(), axis_view(spline, axis, 1), false},
          records_{spline.records().data(), axis_view(spline, axis, dim_ + 1), true},
          unscaled_(spline.records_exponent() == 0), sums_(static_cast<size_t>(records_.view.inner)) {}

    Net apply(const LayerTable &table) {
        if (weights_.view.inner == 1 && records_.view.inner <= longest_short_layer && unscaled_) {
            std::vector<double> points = new_layers(points_.view, table.rows());
            std::vector<double> weights = new_layers(weights_.view, table.rows());
            if (apply_short(table, points.data(), weights.data())) {
                return {finished(std::move(points)), finished(std::move(weights))};
            }
        }
        return apply_long(table);
    }

private:
    bool apply_short(const LayerTable &table, double *points, double *weights) noexcept {
        bool weighted = true;
        for (int64_t o = 0; o < records_.view.outer && weighted; ++o) {
            const ShortNet net{records_.at(o, 0), points_.at(o, 0), weights_.at(o, 0), dim_};
            weighted =
                combine_short(table, net, points + o * table.rows() * dim_, weights + o * table.rows());
        }
        return weighted;
    }

    Net apply_long(const LayerTable &table) {
        std::vector<double> points = new_layers(points_.view, table.rows());
        double *out = points.data();
        for (int64_t o = 0; o < records_.view.outer; ++o) {
            for (int64_t r = 0; r < table.rows(); ++r, out += points_.view.inner) {
                combine_points(table, table.row(r), o, out);
            }
        }
        return {finished(std::move(points)), combine_all(table, weights_)};
    }

    void combine_points(const LayerTable &table, const LayerTable::Row &row, int64_t outer,
                        double *out) noexcept {
        if (row.size == 0) {
            std::copy_n(points_.at(outer, row.first), points_.view.inner, out);
            return;
        }
        combine(table, row, records_, outer, sums_.data());
        if (!weighted(sums_.data(), weights_.view.inner, dim_)) {
            combine(table, row, points_, outer, out);
        }
        project(sums_.data(), weights_.view.inner, dim_, out);
    }

    int dim_;
    Layers points_;
    Layers weights_;
    Layers records_;
    bool unscaled_; // records hold the weights themselves
    std::vector<double> sums_;
};

} // namespace

Net apply_along(const Spline &spline, int axis, const LayerTable &table) {
    if (spline.form() == Form::rational) {
        return RationalLayers(spline, axis).apply(table);
    }
    return {
        combine_all(table, {spline.points().data(), axis_view(spline, axis, spline.stored_width()), true}),
        {}};
}

} // namespace nrb
