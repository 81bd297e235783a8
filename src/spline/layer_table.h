// SPDX-License-Identifier: MIT
// Banded tables of coefficients, and their one application along an axis. Refinement, iso-surfaces, and every
// other operation that makes new layers of control points from old ones, use such a table.
#pragma once

#include "spline/axis_view.h"

#include <algorithm>
#include <memory>
#include <span>

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
    void add_copy(int64_t layer) { rows_.add({layer, 0, 0}); }
    // Precondition: there is a row.
    void repeat_row() { rows_.add(Row(all().back())); }
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
    double *room(int64_t size) { return coefficients_.room(static_cast<size_t>(size)); }
    void add_written(int64_t first, int size) {
        if (size == 1 && *coefficients_.end() == 1) {
            return add_copy(first);
        }
        add_later(first, size);
    }

    // Adds a row whose coefficients are written at the returned place before the next room() and before the
    // table is used. Precondition: reserve() made room for it.
    double *add_later(int64_t first, int size) {
        double *const place = coefficients_.end();
        rows_.add({first, size, coefficients_.size()});
        coefficients_.take(static_cast<size_t>(size));
        return place;
    }
    // Adds rows that repeat `count` times, `stride` layers and `pitch` coefficients further on each time.
    // Their offsets count from room(), where the coefficients have been written; copies have none.
    void add_pattern(std::span<const Row> pattern, int64_t count, int64_t stride, int64_t pitch) {
        const size_t used = coefficients_.size(), rows = static_cast<size_t>(count) * pattern.size();
        Row *row = rows_.room(rows);
        for (int64_t i = 0; i < count; ++i) {
            for (const Row &next : pattern) {
                *row++ = {next.first + i * stride, next.size,
                          used + static_cast<size_t>(i * pitch) + next.offset};
            }
        }
        rows_.take(rows);
        coefficients_.take(static_cast<size_t>(count * pitch));
    }

    // Makes all rows of layers that come so much later.
    void shift(int64_t layers) noexcept {
        std::for_each_n(rows_.data(), rows_.size(), [layers](Row &row) { row.first += layers; });
    }

    // Whether every row is a copy, so that no value is computed.
    [[nodiscard]] bool copies_only() const noexcept {
        return std::ranges::all_of(all(), [](const Row &row) { return row.size == 0; });
    }
    [[nodiscard]] int64_t rows() const noexcept { return static_cast<int64_t>(rows_.size()); }
    [[nodiscard]] const Row &row(int64_t r) const noexcept { return rows_.data()[r]; }
    [[nodiscard]] std::span<const Row> all() const noexcept { return {rows_.data(), rows_.size()}; }
    // All coefficients; the offsets refer to them.
    [[nodiscard]] const double *coefficients() const noexcept { return coefficients_.data(); }
    [[nodiscard]] const double *coefficients(const Row &row) const noexcept {
        return coefficients_.data() + row.offset;
    }

private:
    // An array that grows. What is written at its end counts once it is taken.
    template <class T>
    class Growing {
    public:
        void reserve(size_t size) {
            if (static_cast<size_t>(limit_ - data_.get()) < size) {
                grow(size);
            }
        }
        T *room(size_t more) {
            if (static_cast<size_t>(limit_ - end_) < more) {
                grow(end_ == data_.get() ? more : 2 * (size() + more));
            }
            return end_;
        }
        void take(size_t more) noexcept { end_ += more; }
        void add(const T &value) {
            if (end_ == limit_) {
                grow(2 * size() + 1);
            }
            *end_++ = value;
        }
        [[nodiscard]] T *end() noexcept { return end_; }
        [[nodiscard]] T *data() noexcept { return data_.get(); }
        [[nodiscard]] const T *data() const noexcept { return data_.get(); }
        [[nodiscard]] size_t size() const noexcept { return static_cast<size_t>(end_ - data_.get()); }

    private:
        void grow(size_t capacity) {
            const size_t size = this->size();
            auto grown = std::make_unique_for_overwrite<T[]>(capacity);
            std::copy_n(data_.get(), size, grown.get());
            data_ = std::move(grown);
            end_ = data_.get() + size;
            limit_ = data_.get() + capacity;
        }

        std::unique_ptr<T[]> data_;
        T *end_ = nullptr, *limit_ = nullptr;
    };

    Growing<Row> rows_;
    Growing<double> coefficients_;
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
