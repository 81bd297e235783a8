// SPDX-License-Identifier: MIT
#include "fit/least_squares/stencil_matrix.h"

#include "base/watch.h"
#include "numeric/solvers/sparse/grid_order.h"

#include <algorithm>
#include <numeric>

namespace nrb::fit {

StencilMatrix::StencilMatrix(const std::vector<KnotVectorPtr> &axes, const Index &least_reach)
    : axes_(static_cast<int>(axes.size())) {
    int64_t all = 1;
    for (size_t k = 0; k < axes.size(); ++k) {
        counts_[k] = axes[k]->distinct_layers();
        reach_[k] = std::max<int64_t>(axes[k]->degree(), least_reach[k]);
        periodic_[k] = axes[k]->periodic();
        all *= 2 * reach_[k] + 1;
    }
    offsets_ = all / 2 + 1; // from no offset on, in the order of their places in a full stencil
    grow_watched(values_, static_cast<size_t>(size() * offsets_));
}

int64_t StencilMatrix::unknown(const Index &layer) const noexcept {
    int64_t number = 0;
    for (size_t k = 0; k < layer.size(); ++k) {
        number = number * counts_[k] + (periodic_[k] ? layer[k] % counts_[k] : layer[k]);
    }
    return number;
}

void StencilMatrix::add(const Index &first, const Index &second, const DoubleDouble &value) noexcept {
    int64_t place = 0;
    for (size_t k = 0; k < first.size(); ++k) {
        place = place * (2 * reach_[k] + 1) + second[k] - first[k];
    }
    DoubleDouble &element = values_[static_cast<size_t>(unknown(first) * offsets_ + place)];
    element = element + value;
}

void StencilMatrix::add_multiple(double factor, const StencilMatrix &other) noexcept {
    for (size_t i = 0; i < values_.size(); ++i) {
        values_[i] = values_[i] + DoubleDouble(factor) * other.values_[i];
    }
}

DoubleDouble StencilMatrix::trace() const noexcept {
    DoubleDouble sum;
    for (int64_t row = 0; row < size(); ++row) {
        for_each_offset(row, [&](int64_t other, int64_t place) {
            if (other == row) {
                const DoubleDouble &value = values_[static_cast<size_t>(place)];
                sum = sum + (place == row * offsets_ ? value : value + value);
            }
        });
    }
    return sum;
}

DoubleDouble StencilMatrix::mean() const noexcept {
    const DoubleDouble sum = trace();
    return sum.high > 0 ? sum / DoubleDouble(static_cast<double>(size())) : DoubleDouble(1);
}

template <class Visit>
void StencilMatrix::for_each_offset(int64_t row, Visit &&visit) const {
    const Index own{row / (counts_[1] * counts_[2]), row / counts_[2] % counts_[1], row % counts_[2]};
    int64_t place = row * offsets_;
    Index offset{};
    // Odometer over the offsets from 0 on.
    for (int64_t i = 0; i < offsets_; ++i, ++place) {
        Index other{};
        bool inside = true;
        for (size_t k = 0; k < own.size(); ++k) {
            other[k] = own[k] + offset[k];
            if (periodic_[k]) {
                other[k] = (other[k] % counts_[k] + counts_[k]) % counts_[k];
            }
            inside = inside && other[k] >= 0 && other[k] < counts_[k];
        }
        if (inside) {
            visit((other[0] * counts_[1] + other[1]) * counts_[2] + other[2], place);
        }
        for (size_t k = own.size(); k-- > 0;) {
            if (++offset[k] <= reach_[k]) {
                break;
            }
            offset[k] = -reach_[k];
        }
    }
}

std::vector<int64_t> StencilMatrix::elimination_order() const {
    std::array<GridAxis, 3> axes;
    for (size_t k = 0; k < axes.size(); ++k) {
        axes[k] = {counts_[k], reach_[k], periodic_[k]};
    }
    return grid_order(axes);
}

ColumnsOf<DoubleDouble> StencilMatrix::columns(const std::vector<int64_t> &order) const {
    std::vector<int32_t> number(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        number[static_cast<size_t>(order[i])] = static_cast<int32_t>(i);
    }
    const auto for_each_element = [&](auto &&visit) { // calls visit(column, row, place)
        for (int64_t row = 0; row < size(); ++row) {
            count_work(16 * offsets_);
            const int32_t own = number[static_cast<size_t>(row)];
            for_each_offset(row, [&](int64_t other, int64_t place) {
                const int32_t second = number[static_cast<size_t>(other)];
                visit(own, second, place);
                if (place != row * offsets_) {
                    visit(second, own, place);
                }
            });
        }
    };
    struct Element {
        int32_t row;
        int64_t place;
        auto operator<=>(const Element &) const = default;
    };
    std::vector<size_t> starts(order.size() + 1, 0);
    for_each_element([&](int32_t column, int32_t, int64_t) { ++starts[static_cast<size_t>(column) + 1]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<Element> elements(starts.back());
    std::vector<size_t> next(starts.begin(), starts.end() - 1);
    for_each_element([&](int32_t column, int32_t row, int64_t place) {
        elements[next[static_cast<size_t>(column)]++] = {row, place};
    });
    ColumnsOf<DoubleDouble> result;
    result.rows.reserve(elements.size());
    result.values.reserve(elements.size());
    result.starts.push_back(0);
    for (size_t j = 0; j < order.size(); ++j) {
        std::sort(elements.begin() + static_cast<int64_t>(starts[j]),
                  elements.begin() + static_cast<int64_t>(starts[j + 1]));
        for (size_t e = starts[j]; e < starts[j + 1]; ++e) { // a short periodic axis has some twice
            const DoubleDouble &value = values_[static_cast<size_t>(elements[e].place)];
            if (e > starts[j] && elements[e].row == elements[e - 1].row) {
                result.values.back() = result.values.back() + value;
            } else {
                result.rows.push_back(elements[e].row);
                result.values.push_back(value);
            }
        }
        result.starts.push_back(std::ssize(result.rows));
    }
    return result;
}

} // namespace nrb::fit
