// SPDX-License-Identifier: MIT
#include "fit/least_squares/stencil_matrix.h"

#include "base/watch.h"
#include "numeric/solvers/sparse/grid_order.h"

#include <algorithm>

namespace nrb::fit {

namespace {

template <class Number>
Number number_of(const DoubleDouble &value) noexcept {
    if constexpr (std::is_same_v<Number, double>) {
        return value.high;
    } else {
        return value;
    }
}

} // namespace

StencilMatrix::StencilMatrix(const std::vector<KnotVectorPtr> &axes) : axes_(static_cast<int>(axes.size())) {
    int64_t all = 1;
    for (size_t k = 0; k < axes.size(); ++k) {
        counts_[k] = axes[k]->distinct_layers();
        reach_[k] = axes[k]->degree();
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

void StencilMatrix::add(const StencilMatrix &other, const DoubleDouble &factor) noexcept {
    for (size_t i = 0; i < values_.size(); ++i) {
        values_[i] = values_[i] + factor * other.values_[i];
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

void StencilMatrix::multiply(const std::vector<DoubleDouble> &x, int64_t width,
                             std::vector<DoubleDouble> &y) const {
    y.assign(x.size(), DoubleDouble{});
    const auto add = [&](int64_t to, const DoubleDouble &value, int64_t from) {
        for (int64_t c = 0; c < width; ++c) {
            DoubleDouble &sum = y[static_cast<size_t>(to * width + c)];
            sum = sum + value * x[static_cast<size_t>(from * width + c)];
        }
    };
    for (int64_t row = 0; row < size(); ++row) {
        count_work(16 * width * offsets_);
        for_each_offset(row, [&](int64_t other, int64_t place) {
            const DoubleDouble &value = values_[static_cast<size_t>(place)];
            add(row, value, other);
            if (place != row * offsets_) {
                add(other, value, row);
            }
        });
    }
}

std::vector<int64_t> StencilMatrix::elimination_order() const {
    std::array<GridAxis, 3> axes;
    for (size_t k = 0; k < axes.size(); ++k) {
        axes[k] = {counts_[k], reach_[k], periodic_[k]};
    }
    return grid_order(axes);
}

template <class Number>
ColumnsOf<Number> StencilMatrix::columns(const std::vector<int64_t> &order) const {
    std::vector<int32_t> number(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        number[static_cast<size_t>(order[i])] = static_cast<int32_t>(i);
    }
    struct Element {
        int32_t column, row;
        int64_t place;
        auto operator<=>(const Element &) const = default;
    };
    std::vector<Element> elements;
    elements.reserve(static_cast<size_t>(size() * (2 * offsets_ - 1)));
    for (int64_t row = 0; row < size(); ++row) {
        count_work(32 * offsets_);
        const int32_t own = number[static_cast<size_t>(row)];
        for_each_offset(row, [&](int64_t other, int64_t place) {
            const int32_t second = number[static_cast<size_t>(other)];
            elements.push_back({own, second, place});
            if (place != row * offsets_) {
                elements.push_back({second, own, place});
            }
        });
    }
    std::sort(elements.begin(), elements.end());
    ColumnsOf<Number> result;
    result.starts.assign(order.size() + 1, 0);
    for (size_t e = 0; e < elements.size(); ++e) {
        const auto value = number_of<Number>(values_[static_cast<size_t>(elements[e].place)]);
        if (e > 0 && elements[e].column == elements[e - 1].column && elements[e].row == elements[e - 1].row) {
            result.values.back() = result.values.back() + value;
            continue;
        }
        ++result.starts[static_cast<size_t>(elements[e].column) + 1];
        result.rows.push_back(elements[e].row);
        result.values.push_back(value);
    }
    for (size_t j = 1; j < result.starts.size(); ++j) {
        result.starts[j] += result.starts[j - 1];
    }
    return result;
}

template ColumnsOf<double> StencilMatrix::columns<double>(const std::vector<int64_t> &) const;
template ColumnsOf<DoubleDouble> StencilMatrix::columns<DoubleDouble>(const std::vector<int64_t> &) const;

} // namespace nrb::fit
