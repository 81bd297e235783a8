// SPDX-License-Identifier: MIT
#include "fit/least_squares/stencil_matrix.h"

#include "base/watch.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace nrb::fit {

StencilMatrix::StencilMatrix(const std::vector<KnotVectorPtr> &axes, const Index &least_reach)
    : pattern_(axes, least_reach) {
    grow_watched(values_, static_cast<size_t>(pattern_.elements()));
}

void StencilMatrix::add(const Index &first, const Index &second, const DoubleDouble &value) noexcept {
    const int64_t place = pattern_.start(pattern_.unknown(first)) + pattern_.step(first, second);
    DoubleDouble &element = values_[static_cast<size_t>(place)];
    element = element + value;
}

void StencilMatrix::add_multiple(double factor, const StencilMatrix &other) noexcept {
    for (size_t i = 0; i < values_.size(); ++i) {
        values_[i] = values_[i] + DoubleDouble(factor) * other.values_[i];
    }
}

DoubleDouble StencilMatrix::trace() const noexcept {
    DoubleDouble sum;
    pattern_.for_each_element([&](int64_t row, int64_t other, int64_t place) {
        if (other == row) {
            const DoubleDouble &value = values_[static_cast<size_t>(place)];
            sum = sum + (place == pattern_.start(row) ? value : value + value);
        }
    });
    return sum;
}

DoubleDouble StencilMatrix::mean() const noexcept {
    const DoubleDouble sum = trace();
    return sum.high > 0 ? sum / DoubleDouble(static_cast<double>(size())) : DoubleDouble(1);
}

namespace {

// An element of a column.
struct Element {
    int32_t row;
    int64_t place;
    auto operator<=>(const Element &) const = default;
};

constexpr int64_t work_of_a_sort = 128; // of an element

struct Elements {
    std::vector<size_t> starts; // of columns
    std::vector<Element> all;
};

// The elements of all columns, mirrored ones included, for unknowns that are renumbered.
Elements by_columns(const StencilPattern &pattern, const std::vector<int32_t> &number) {
    const auto for_each = [&](auto &&visit) { // calls visit(column, row, place)
        count_work(16 * pattern.elements());
        pattern.for_each_element([&](int64_t first, int64_t second, int64_t place) {
            const int32_t i = number[static_cast<size_t>(first)], j = number[static_cast<size_t>(second)];
            visit(static_cast<size_t>(i), j, place);
            if (place != pattern.start(first)) {
                visit(static_cast<size_t>(j), i, place);
            }
        });
    };
    Elements made{std::vector<size_t>(number.size() + 1, 0), {}};
    for_each([&](size_t column, int32_t, int64_t) { ++made.starts[column + 1]; });
    std::partial_sum(made.starts.begin(), made.starts.end(), made.starts.begin());
    made.all.resize(made.starts.back());
    std::vector<size_t> next(made.starts.begin(), made.starts.end() - 1);
    for_each([&](size_t column, int32_t row, int64_t place) { made.all[next[column]++] = {row, place}; });
    return made;
}

} // namespace

ColumnsOf<DoubleDouble> StencilMatrix::columns(const std::vector<int64_t> &order) const {
    std::vector<int32_t> number(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        number[static_cast<size_t>(order[i])] = static_cast<int32_t>(i);
    }
    Elements elements = by_columns(pattern_, number);
    ColumnsOf<DoubleDouble> result;
    result.rows.reserve(elements.all.size());
    result.values.reserve(elements.all.size());
    result.starts.push_back(0);
    count_work(work_of_a_sort * std::ssize(elements.all));
    for (size_t j = 0; j < order.size(); ++j) {
        const std::span column =
            std::span(elements.all).subspan(elements.starts[j], elements.starts[j + 1] - elements.starts[j]);
        std::sort(column.begin(), column.end());
        for (size_t e = 0; e < column.size(); ++e) { // on a short periodic axis some occur twice
            const DoubleDouble &value = values_[static_cast<size_t>(column[e].place)];
            if (e > 0 && column[e].row == column[e - 1].row) {
                result.values.back() = result.values.back() + value;
            } else {
                result.rows.push_back(column[e].row);
                result.values.push_back(value);
            }
        }
        result.starts.push_back(std::ssize(result.rows));
    }
    return result;
}

} // namespace nrb::fit
