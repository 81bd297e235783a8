// SPDX-License-Identifier: MIT
#include "refine/periodic/period_rows.h"

#include "base/watch.h"

#include <algorithm>
#include <vector>

namespace nrb::refine {

namespace {

constexpr int64_t work_of_a_row = 100; // mostly for memory

// A row of a table that gives one period of layers, for any layer of the endless sequence.
struct Shifted {
    const double *coefficients;
    int64_t first;
    int size;
};

Shifted shifted(const LayerTable &table, int64_t layer, int64_t period) noexcept {
    static constexpr double copied = 1;
    const int64_t after = layer % table.rows();
    const int64_t place = after < 0 ? after + table.rows() : after;
    const LayerTable::Row &row = table.row(place);
    const int64_t first = row.first + (layer - place) / table.rows() * period;
    return row.size == 0 ? Shifted{&copied, first, 1} : Shifted{table.coefficients(row), first, row.size};
}

int widest_row(const LayerTable &table) noexcept {
    int widest = 1;
    for (const LayerTable::Row &row : table.all()) {
        widest = std::max(widest, row.size);
    }
    return widest;
}

} // namespace

LayerTable composed(const LayerTable &outer, const LayerTable &inner, int64_t period) {
    LayerTable table;
    table.reserve(outer.rows(), widest_row(outer) + widest_row(inner));
    std::vector<double> sum;
    for (int64_t r = 0; r < outer.rows(); ++r) {
        const Shifted row = shifted(outer, r, 0);
        count_work(work_of_a_row + 8 * int64_t{row.size} * row.size);
        int64_t first = shifted(inner, row.first, period).first;
        for (int i = 1; i < row.size; ++i) {
            first = std::min(first, shifted(inner, row.first + i, period).first);
        }
        sum.clear();
        for (int i = 0; i < row.size; ++i) {
            const Shifted part = shifted(inner, row.first + i, period);
            const auto offset = static_cast<size_t>(part.first - first);
            sum.resize(std::max(sum.size(), offset + static_cast<size_t>(part.size)));
            for (int k = 0; k < part.size; ++k) {
                sum[offset + static_cast<size_t>(k)] += row.coefficients[i] * part.coefficients[k];
            }
        }
        table.add_row(first, sum.data(), static_cast<int>(sum.size()));
    }
    return table;
}

LayerTable wrapped_rows(const LayerTable &rows, int64_t shift, int64_t wrapped, int64_t period) {
    LayerTable table;
    table.reserve(rows.rows() + wrapped);
    for (int64_t i = 0; i < rows.rows() + wrapped; ++i) {
        const Shifted row = shifted(rows, i % rows.rows(), 0);
        const int64_t layer = (row.first + shift) % period;
        table.add_row(layer < 0 ? layer + period : layer, row.coefficients, row.size);
    }
    return table;
}

} // namespace nrb::refine
