// SPDX-License-Identifier: MIT
#include "io/binary/statistics_bytes.h"

#include "base/checked.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/watch.h"

#include <memory>

namespace nrb::io {

namespace {

[[noreturn]] void fail_number(const char *what, int64_t value) {
    fail(Status::syntax, "%s = %lld, which no statistics have", what, static_cast<long long>(value));
}

int64_t checked(int64_t value, int64_t least, int64_t most, const char *what) {
    if (value < least || value > most) {
        fail_number(what, value);
    }
    return value;
}

// Reads the breaks of an axis. Throws Status::syntax unless each is larger than the one before.
KnotVectorPtr breaks_from(ByteReader &reader, int64_t count, int axis) {
    reader.need(static_cast<uint64_t>(count));
    std::vector<double> breaks;
    breaks.reserve(static_cast<size_t>(count));
    for (int64_t i = 0; i < count; ++i) {
        breaks.push_back(reader.take_double());
        if (i > 0 && !(breaks[static_cast<size_t>(i)] > breaks[static_cast<size_t>(i) - 1])) {
            fail(Status::syntax, "break %lld of axis %d does not increase", static_cast<long long>(i), axis);
        }
    }
    return make_knot_vector(0, std::move(breaks), false, axis);
}

struct Sizes {
    int64_t cells, entries;
    std::vector<int64_t> break_counts;
};

// Reads the sizes, and stores the degrees in the form.
Sizes sizes_from(ByteReader &reader, int axes, fit::StatisticsForm &form) {
    Sizes sizes{reader.take_integer(), reader.take_integer(), {}};
    for (int k = 0; k < axes; ++k) {
        form.degrees.push_back(static_cast<int>(checked(reader.take_integer(), 0, max_degree, "degree")));
        sizes.break_counts.push_back(checked(reader.take_integer(), 2, max_doubles, "number of breaks"));
    }
    return sizes;
}

void check_cells(const std::vector<int64_t> &cells, const std::vector<int64_t> &counts, int64_t all) {
    uint64_t sum = 0;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] < 0 || cells[i] >= all || (i > 0 && cells[i] <= cells[i - 1])) {
            fail_number("a cell", cells[i]);
        }
        sum += static_cast<uint64_t>(counts[i]);
        if (counts[i] <= 0 || counts[i] > max_doubles || sum > static_cast<uint64_t>(max_doubles)) {
            fail_number("a count", counts[i]);
        }
    }
}

} // namespace

size_t size_in_bytes(const fit::Statistics &statistics) noexcept {
    const fit::StatisticsForm &form = statistics.form();
    const size_t cells = statistics.cells().size();
    size_t breaks = 0;
    for (const KnotVectorPtr &axis : form.breaks) {
        breaks += axis->knots().size();
    }
    return header_size + aligned(8 * (2 + 2 * form.degrees.size())) + aligned(8 * breaks) +
           aligned(16 * cells) + 24 * cells * static_cast<size_t>(fit::CellLayout(form).entries());
}

void write_bytes(const fit::Statistics &statistics, std::span<unsigned char> out) noexcept {
    const fit::StatisticsForm &form = statistics.form();
    ByteWriter writer(Kind::statistics, {form.axes(), form.dim, form.value_exponent, form.weight_exponent},
                      out);
    writer.put(std::ssize(statistics.cells()));
    writer.put(fit::CellLayout(form).entries());
    for (size_t k = 0; k < form.degrees.size(); ++k) {
        writer.put(int64_t{form.degrees[k]});
        writer.put(std::ssize(form.breaks[k]->knots()));
    }
    writer.align();
    for (const KnotVectorPtr &axis : form.breaks) {
        for (const double knot : axis->knots()) {
            writer.put(knot + 0.0); // -0 is the same break
        }
    }
    writer.align();
    for (const int64_t cell : statistics.cells()) {
        writer.put(cell);
    }
    for (const int64_t count : statistics.counts()) {
        writer.put(count);
    }
    writer.align();
    for (int64_t i = 0; i < std::ssize(statistics.cells()); ++i) {
        for (const ExactSum &sum : statistics.sums(i)) {
            for (const uint64_t limb : sum.limbs()) {
                writer.put(limb);
            }
        }
    }
    writer.finish();
}

fit::Statistics statistics_from(std::span<const unsigned char> bytes) {
    ByteReader reader(bytes, Kind::statistics);
    const auto [axes, dim, value_exponent, weight_exponent, a, b, c, d] = reader.numbers();
    checked(axes, 1, max_axes, "axes");
    checked(dim, 1, std::numeric_limits<int32_t>::max() - 1, "dim");
    constexpr int smallest = -1074, largest = 1024;
    checked(value_exponent, smallest, largest, "exponent of values");
    checked(weight_exponent, smallest, largest, "exponent of weights");
    fit::StatisticsForm form{{}, {}, dim, value_exponent, weight_exponent};
    const Sizes sizes = sizes_from(reader, axes, form);
    reader.align();
    int64_t all = 1;
    for (int k = 0; k < axes; ++k) {
        form.breaks.push_back(breaks_from(reader, sizes.break_counts[static_cast<size_t>(k)], k));
        all = checked_product(all, form.breaks.back()->count(), "cells");
    }
    const int64_t entries = fit::CellLayout(form).entries();
    checked(sizes.entries, entries, entries, "number of sums");
    reader.align();
    const int64_t cells = checked(sizes.cells, 0, all, "number of cells");
    const std::vector<int64_t> indices = reader.take_integers(cells), counts = reader.take_integers(cells);
    check_cells(indices, counts, all);
    reader.align();
    reader.need(static_cast<uint64_t>(checked_product(cells, 3 * entries, "sums")));
    fit::Statistics made(std::make_shared<const fit::StatisticsForm>(std::move(form)));
    made.reserve(static_cast<size_t>(cells));
    std::vector<ExactSum> sums(cells > 0 ? static_cast<size_t>(entries) : 0);
    for (size_t i = 0; i < indices.size(); ++i) {
        for (ExactSum &sum : sums) {
            sum = ExactSum({reader.take(), reader.take(), reader.take()});
        }
        if (sums.back().negative()) {
            fail(Status::syntax, "the sum of the weights of cell %lld is negative",
                 static_cast<long long>(indices[i]));
        }
        made.append(indices[i], counts[i], sums);
    }
    reader.end();
    return made;
}

} // namespace nrb::io
