// SPDX-License-Identifier: MIT
// Banded tables of coefficients, and their one application along an axis. Refinement, iso-surfaces, and every
// other operation that makes new layers of control points from old ones, use such a table.
#pragma once

#include "spline/axis_view.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace nrb::inline spline {

// New layer r is the sum of coefficient[offset + i] * old layer (first + i), i < size. A row of the single
// coefficient 1 is a copy and costs no coefficient.
class LayerTable {
public:
    struct Row {
        int64_t first;
        int size; // 0: a copy of layer `first`
        size_t offset;

        // Whether both have the same coefficients. Precondition: they are not copies.
        [[nodiscard]] bool repeats(const Row &other) const noexcept {
            return offset == other.offset && other.size != 0;
        }
    };

    // Room for rows of up to `width` coefficients, and for the coefficients of `more` rows.
    void reserve(int64_t rows, int width = 0, int64_t more = 0) {
        rows_.reserve(static_cast<size_t>(rows));
        room((rows + more) * width);
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
    // Where the coefficients of the next row may be written before add_written() makes it a row.
    double *room(int64_t size) {
        const size_t end = used_ + static_cast<size_t>(size);
        if (capacity_ < end) {
            grow(used_ == 0 ? end : 2 * end);
        }
        return coefficients_.get() + used_;
    }
    void add_written(int64_t first, int size) {
        if (size == 1 && coefficients_[used_] == 1) {
            return add_copy(first);
        }
        rows_.push_back({first, size, used_});
        used_ += static_cast<size_t>(size);
    }

    // Adds a row whose coefficients are written at the returned place before the next room() and before the
    // table is used. Precondition: reserve() made room for it.
    double *add_later(int64_t first, int size) {
        rows_.push_back({first, size, used_});
        used_ += static_cast<size_t>(size);
        return coefficients_.get() + rows_.back().offset;
    }
    // Adds rows that repeat `count` times, `stride` layers and `pitch` coefficients further on each time.
    // Their offsets count from room(), where the coefficients have been written; copies have none.
    void add_pattern(std::span<const Row> pattern, int64_t count, int64_t stride, int64_t pitch) {
        const size_t rows = rows_.size();
        rows_.resize(rows + static_cast<size_t>(count) * pattern.size());
        Row *row = rows_.data() + rows;
        for (int64_t i = 0; i < count; ++i) {
            for (const Row &next : pattern) {
                *row++ = {next.first + i * stride, next.size,
                          used_ + static_cast<size_t>(i * pitch) + next.offset};
            }
        }
        used_ += static_cast<size_t>(count * pitch);
    }

    // Whether every row is a copy, so that no value is computed.
    [[nodiscard]] bool copies_only() const noexcept {
        return std::all_of(rows_.begin(), rows_.end(), [](const Row &row) { return row.size == 0; });
    }
    [[nodiscard]] int64_t rows() const noexcept { return static_cast<int64_t>(rows_.size()); }
    [[nodiscard]] const Row &row(int64_t r) const noexcept { return rows_[static_cast<size_t>(r)]; }
    [[nodiscard]] std::span<const Row> all() const noexcept { return rows_; }
    // All coefficients; the offsets refer to them.
    [[nodiscard]] const double *coefficients() const noexcept { return coefficients_.get(); }
    [[nodiscard]] const double *coefficients(const Row &row) const noexcept {
        return coefficients_.get() + row.offset;
    }

private:
    void grow(size_t capacity) {
        auto grown = std::make_unique_for_overwrite<double[]>(capacity);
        std::copy_n(coefficients_.get(), used_, grown.get());
        coefficients_ = std::move(grown);
        capacity_ = capacity;
    }

    std::vector<Row> rows_;
    std::unique_ptr<double[]> coefficients_; // the first used_ are in use
    size_t used_ = 0;
    size_t capacity_ = 0;
};

struct Net {
    std::vector<double> points;
    std::vector<double> weights;
};

// Makes the layers of a new net from tables, one after another. The result has the form of the spline; copied
// layers keep their stored bits. Sums are formed in homogeneous space. If all weights of a sum are 0, the
// Cartesian points are combined instead, so that a point of weight 0 keeps a position.
class LayerMaker {
public:
    // For `rows` layers in all. The spline must outlive this. Throws Status::overflow.
    LayerMaker(const Spline &spline, int axis, int64_t rows);
    LayerMaker(const LayerMaker &) = delete;
    LayerMaker &operator=(const LayerMaker &) = delete;
    ~LayerMaker();

    // Whether the layers may come in more than one table, which saves memory for large curves. The layers
    // then follow each other.
    [[nodiscard]] bool in_parts() const noexcept { return view_.outer == 1; }
    void append(const LayerTable &table);
    // Call when all layers have been appended. Throws Status::not_representable when a value overflows.
    Net finish();

private:
    struct Sources;

    AxisView view_;
    int64_t rows_;
    int64_t done_ = 0;
    Net net_;
    std::unique_ptr<Sources> sources_;
};

// The same with one table.
Net apply_along(const Spline &spline, int axis, const LayerTable &table);

} // namespace nrb::inline spline
