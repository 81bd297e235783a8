// SPDX-License-Identifier: MIT
#include "spline/layer_table.h"

#include "base/checked.h"
#include "base/representable.h"
#include "base/watch.h"
#include "spline/contract.h"
#include "spline/short_layers.h"

#include <algorithm>
#include <optional>

namespace nrb::inline spline {

namespace {

// An array of records, and its view along an axis.
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

// Space for the layers of a new spline, followed by padding.
std::vector<double> new_layers(const AxisView &view, int64_t layers) {
    const int64_t size = checked_product(view.outer * view.inner, layers, "points");
    constexpr auto padding = static_cast<int64_t>(Spline::padding);
    std::vector<double> room;
    grow_watched(room, static_cast<size_t>(checked_sum(size, padding, "points")));
    return room;
}

// The finished layers, checked and without the padding.
std::vector<double> finished(std::vector<double> layers) {
    layers.resize(layers.size() - Spline::padding);
    require_representable(layers, "control points");
    return layers;
}

// Calls combine(rows, index of the first) for parts of a table, and counts their work.
template <class Combine>
void for_parts(const LayerTable &table, int64_t inner, Combine &&combine) {
    constexpr size_t part = size_t{1} << 16;
    const std::span<const LayerTable::Row> all = table.all();
    for (size_t first = 0; first < all.size(); first += part) {
        const auto rows = all.subspan(first, std::min(part, all.size() - first));
        count_work(std::ssize(rows) * inner * 2);
        combine(LayerRows{rows, table.coefficients()}, static_cast<int64_t>(first));
    }
}

// Computes the layers of a table for every outer index, where the result has `total` layers.
void combine_all(const LayerTable &table, const Layers &layers, int64_t total, double *out) {
    const int64_t inner = layers.view.inner;
    for (int64_t o = 0; o < layers.view.outer; ++o, out += total * inner) {
        if (layers.padded && inner <= longest_short_layer) {
            for_parts(table, inner, [&](const LayerRows &rows, int64_t first) {
                combine_short(rows, layers.at(o, 0), static_cast<int>(inner), out + first * inner);
            });
            continue;
        }
        count_work(table.rows() * inner * 2);
        for (int64_t r = 0; r < table.rows(); ++r) {
            combine(table, table.row(r), layers, o, out + r * inner);
        }
    }
}

// Whether all `count` homogeneous sums have a weight other than 0.
bool weighted(const double *sums, int64_t count, int dim) noexcept {
    bool all = true;
    for (int64_t i = 0; i < count; ++i) {
        all = all && sums[i * (dim + 1) + dim] != 0;
    }
    return all;
}

// Divides homogeneous sums by their weights. Where the weight is 0, `points` stays as it is.
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

    void combine(const LayerTable &table, int64_t total, double *points, double *weights) {
        const bool short_ones =
            weights_.view.inner == 1 && records_.view.inner <= longest_short_layer && unscaled_;
        if (!short_ones || !combine_short_ones(table, total, points, weights)) {
            combine_long_ones(table, total, points);
            combine_all(table, weights_, total, weights);
        }
    }

private:
    bool combine_short_ones(const LayerTable &table, int64_t total, double *points, double *weights) const {
        bool weighted = true;
        for (int64_t o = 0; o < records_.view.outer && weighted; ++o) {
            const ShortNet net{records_.at(o, 0), points_.at(o, 0), weights_.at(o, 0), dim_};
            for_parts(table, records_.view.inner, [&](const LayerRows &rows, int64_t first) {
                const int64_t at = o * total + first;
                weighted = combine_short(rows, net, points + at * dim_, weights + at) && weighted;
            });
        }
        return weighted;
    }

    void combine_long_ones(const LayerTable &table, int64_t total, double *points) {
        const int64_t inner = points_.view.inner;
        for (int64_t o = 0; o < records_.view.outer; ++o, points += total * inner) {
            count_work(table.rows() * inner * 2);
            for (int64_t r = 0; r < table.rows(); ++r) {
                combine_points(table, table.row(r), o, points + r * inner);
            }
        }
    }

    void combine_points(const LayerTable &table, const LayerTable::Row &row, int64_t outer,
                        double *out) noexcept {
        if (row.size == 0) {
            std::copy_n(points_.at(outer, row.first), points_.view.inner, out);
            return;
        }
        nrb::combine(table, row, records_, outer, sums_.data());
        if (!weighted(sums_.data(), weights_.view.inner, dim_)) {
            nrb::combine(table, row, points_, outer, out);
        }
        project(sums_.data(), weights_.view.inner, dim_, out);
    }

    int dim_;
    Layers points_;
    Layers weights_;
    Layers records_;
    bool unscaled_; // records contain the stored weights
    std::vector<double> sums_;
};

} // namespace

struct LayerMaker::Sources {
    Layers plain;
    std::optional<RationalLayers> rational;
};

LayerMaker::LayerMaker(const Spline &spline, int axis, int64_t rows)
    : view_(axis_view(spline, axis, spline.stored_width())), rows_(rows),
      sources_(std::make_unique<Sources>(Sources{{spline.points().data(), view_, true}, {}})) {
    net_.points = new_layers(view_, rows);
    if (spline.form() == Form::rational) {
        sources_->rational.emplace(spline, axis);
        net_.weights = new_layers(axis_view(spline, axis, 1), rows);
    }
}

LayerMaker::~LayerMaker() = default;

void LayerMaker::append(const LayerTable &table) {
    double *points = net_.points.data() + done_ * view_.inner;
    if (sources_->rational.has_value()) {
        const int64_t records = std::ssize(net_.weights) - static_cast<int64_t>(Spline::padding);
        double *weights = net_.weights.data() + done_ * (records / (view_.outer * rows_));
        sources_->rational->combine(table, rows_, points, weights);
    } else {
        combine_all(table, sources_->plain, rows_, points);
    }
    done_ += table.rows();
}

Net LayerMaker::finish() {
    return {finished(std::move(net_.points)),
            sources_->rational.has_value() ? finished(std::move(net_.weights)) : std::vector<double>()};
}

Net apply_along(const Spline &spline, int axis, const LayerTable &table) {
    LayerMaker maker(spline, axis, table.rows());
    maker.append(table);
    return maker.finish();
}

} // namespace nrb::inline spline
