// SPDX-License-Identifier: MIT
// Banded tables of coefficients, and how they are applied along an axis. Refinement, iso-surfaces, and all
// other operations that make new layers of control points from old ones use such a table.
#pragma once

#include "spline/axis_view.h"

#include <algorithm>
#include <memory>
#include <span>

namespace nrb::inline spline {

// Row r says that new layer r is the sum of coefficients[offset + i] * old layer (first + i), i < size. A row
// whose only coefficient is 1 is stored as a copy, without a coefficient.
class LayerTable {
public:
    struct Row {
        int64_t first;
        int size; // 0: a copy of layer `first`
        size_t offset;

        // Whether both rows have the same stored coefficients. Precondition: neither is a copy.
        [[nodiscard]] bool repeats(const Row &other) const noexcept {
            return offset == other.offset && other.size != 0;
        }
    };

    // Reserves space for `rows` rows of up to `width` coefficients, and for the coefficients of `more` rows.
    void reserve(int64_t rows, int width = 0, int64_t more = 0) {
        rows_.reserve(static_cast<size_t>(rows));
        room((rows + more) * width);
    }
    void add_copy(int64_t layer) { rows_.add({layer, 0, 0}); }
    // Adds the last row once more. Precondition: there is one.
    void repeat_row() { rows_.add(Row(all().back())); }
    // Adds a row without the zeros at its ends. A single 1 becomes a copy.
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
    // Space for the coefficients of the next row, which are written there before add_written() adds the row.
    double *room(int64_t size) { return coefficients_.room(static_cast<size_t>(size)); }
    void add_written(int64_t first, int size) {
        if (size == 1 && *coefficients_.end() == 1) {
            return add_copy(first);
        }
        add_later(first, size);
    }

    // Adds a row and returns the place of its coefficients, to be written before the next call of room() and
    // before the table is used. Precondition: reserve() has made space for them.
    double *add_later(int64_t first, int size) {
        double *const place = coefficients_.end();
        rows_.add({first, size, coefficients_.size()});
        coefficients_.take(static_cast<size_t>(size));
        return place;
    }
    // Adds a pattern of rows `count` times, advancing by `stride` layers and `pitch` coefficients each time.
    // The offsets in the pattern count from room(), where the coefficients have been written. Copies have
    // none.
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

    // Adds `layers` to the index of the first old layer of every row.
    void shift(int64_t layers) noexcept {
        std::for_each_n(rows_.data(), rows_.size(), [layers](Row &row) { row.first += layers; });
    }

    // Whether all rows are copies, so that no value is computed.
    [[nodiscard]] bool copies_only() const noexcept {
        return std::ranges::all_of(all(), [](const Row &row) { return row.size == 0; });
    }
    [[nodiscard]] int64_t rows() const noexcept { return static_cast<int64_t>(rows_.size()); }
    [[nodiscard]] const Row &row(int64_t r) const noexcept { return rows_.data()[r]; }
    [[nodiscard]] std::span<const Row> all() const noexcept { return {rows_.data(), rows_.size()}; }
    // All coefficients, to which the offsets refer.
    [[nodiscard]] const double *coefficients() const noexcept { return coefficients_.data(); }
    [[nodiscard]] const double *coefficients(const Row &row) const noexcept {
        return coefficients_.data() + row.offset;
    }

private:
    // An array that grows. What is written into room() belongs to it once it is taken.
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

// Computes the layers of a new net from tables, one after another. The result has the form of the spline.
// Copied layers keep their stored bits. Sums are formed in homogeneous space. Where the weight of a sum is 0,
// the Cartesian points are combined instead, so that a point of weight 0 keeps a position.
class LayerMaker {
public:
    // For a result of `rows` layers in all. The spline must outlive this. Throws Status::overflow.
    LayerMaker(const Spline &spline, int axis, int64_t rows);
    LayerMaker(const LayerMaker &) = delete;
    LayerMaker &operator=(const LayerMaker &) = delete;
    ~LayerMaker();

    // Whether the layers may be given by several tables in turn, which saves memory for large curves. This
    // needs layers that are contiguous in memory.
    [[nodiscard]] bool in_parts() const noexcept { return view_.outer == 1; }
    void append(const LayerTable &table);
    // To be called when all layers have been appended. Throws Status::not_representable if a value overflows.
    Net finish();

private:
    struct Sources;

    AxisView view_;
    int64_t rows_;
    int64_t done_ = 0;
    Net net_;
    std::unique_ptr<Sources> sources_;
};

// The net that results from one table.
Net apply_along(const Spline &spline, int axis, const LayerTable &table);

} // namespace nrb::inline spline
