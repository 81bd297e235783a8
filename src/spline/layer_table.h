// Banded tables of coefficients, and their one application along an axis. Refinement, iso-surfaces and
// everything else that makes new layers of control points from old ones is such a table.
#pragma once

#include "spline/axis_view.h"

#include <algorithm>
#include <vector>

namespace nrb {

// New layer r is the sum of coefficient[offset + i] * old layer (first + i), i < size. A row of the single
// coefficient 1 is a copy and costs no coefficient.
class LayerTable {
public:
    struct Row {
        int64_t first;
        int size; // 0: a copy of layer `first`
        size_t offset;
    };

    // Room for rows of up to `width` coefficients.
    void reserve(int64_t rows, int width = 0) {
        rows_.reserve(static_cast<size_t>(rows));
        coefficients_.resize(used_ + static_cast<size_t>(rows * width));
    }
    void add_copy(int64_t layer) { rows_.push_back({layer, 0, 0}); }
    // Precondition: there is a row.
    void repeat_row() { rows_.push_back(rows_.back()); }
    // Zeros at both ends are dropped; a single 1 becomes a copy.
    void add_row(int64_t first, const double *coefficients, int size) {
        while (size > 1 && coefficients[size - 1] == 0) {
            --size;
        }
        for (; size > 1 && coefficients[0] == 0; --size, ++first) {
            ++coefficients;
        }
        std::copy_n(coefficients, size, room(size));
        add_written(first, size);
    }
    // Where the coefficients of the next row may be written before add_written(), which makes it a row.
    double *room(int size) {
        const size_t end = used_ + static_cast<size_t>(size);
        if (coefficients_.size() < end) {
            coefficients_.resize(2 * end);
        }
        return coefficients_.data() + used_;
    }
    void add_written(int64_t first, int size) {
        if (size == 1 && coefficients_[used_] == 1) {
            return add_copy(first);
        }
        rows_.push_back({first, size, used_});
        used_ += static_cast<size_t>(size);
    }

    // Whether every row is a copy, so that no value is computed.
    [[nodiscard]] bool copies_only() const noexcept {
        return std::all_of(rows_.begin(), rows_.end(), [](const Row &row) { return row.size == 0; });
    }
    [[nodiscard]] int64_t rows() const noexcept { return static_cast<int64_t>(rows_.size()); }
    [[nodiscard]] const Row &row(int64_t r) const noexcept { return rows_[static_cast<size_t>(r)]; }
    [[nodiscard]] const double *coefficients(const Row &row) const noexcept {
        return coefficients_.data() + row.offset;
    }

private:
    std::vector<Row> rows_;
    std::vector<double> coefficients_; // the first used_ are in use
    size_t used_ = 0;
};

struct Net {
    std::vector<double> points;
    std::vector<double> weights;
};

// Applies a table along an axis of a spline. The result has the form of the spline; copied layers keep their
// stored bits. Sums are formed in homogeneous space; where all weights of a sum are 0 the Cartesian points
// are combined in their place, so that a point of weight 0 keeps a position. Throws
// NURBS_ERROR_NOT_REPRESENTABLE when a value overflows, and _OVERFLOW.
Net apply_along(const Spline &spline, int axis, const LayerTable &table);

} // namespace nrb
