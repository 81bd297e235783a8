// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/minimum_norm.h"

#include "base/representable.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace nrb::inline numeric {

namespace {

constexpr int64_t work_of_a_rotation = 250; // it is found in a queue
constexpr int64_t none = -1;

// Order by the last unknown, then by the first.
std::vector<int64_t> order_of(const SparseRows &rows) {
    std::vector<int64_t> order(static_cast<size_t>(rows.size()));
    std::iota(order.begin(), order.end(), 0);
    const auto ends = [&rows](int64_t row) {
        const std::span<const int64_t> columns = rows.columns(row);
        return columns.empty() ? std::tuple(none, none, row)
                               : std::tuple(columns.back(), columns.front(), row);
    };
    std::sort(order.begin(), order.end(), [&](int64_t a, int64_t b) { return ends(a) < ends(b); });
    return order;
}

} // namespace

// Reduces one equation after the other.
class MinimumNorm::Reduction {
public:
    Reduction(MinimumNorm &result, double threshold)
        : result_(result), threshold_(threshold), row_(static_cast<size_t>(result.unknowns_)),
          marks_(row_.size()), number_of_(row_.size(), none), turned_(row_.size()) {}

    void add(int64_t row, std::span<const int64_t> columns, std::span<const double> values) {
        count_work(work_of_a_rotation * std::ssize(columns));
        for (size_t i = 0; i < columns.size(); ++i) {
            meet(columns[i], none);
            row_[static_cast<size_t>(columns[i])] = values[i];
        }
        apply_rotations();
        std::sort(seen_.begin(), seen_.end());
        finish(row);
        for (const int64_t column : seen_) {
            row_[static_cast<size_t>(column)] = 0;
            marks_[static_cast<size_t>(column)] = false;
        }
        seen_.clear();
    }

private:
    // Registers an unknown of the row, to which the rotations after `last` are still to be applied.
    void meet(int64_t column, int64_t last) {
        const auto at = static_cast<size_t>(column);
        if (!marks_[at]) {
            marks_[at] = true;
            seen_.push_back(column);
            const std::vector<int64_t> &own = turned_[at];
            const auto next = std::upper_bound(own.begin(), own.end(), last);
            if (next != own.end()) {
                queue_.push({*next, column});
            }
        }
    }

    void apply_rotations() {
        while (!queue_.empty()) {
            const int64_t number = queue_.top().first;
            count_work(work_of_a_rotation);
            const Rotation &by = result_.rotations_[static_cast<size_t>(number)];
            meet(by.a, number);
            meet(by.b, number);
            while (!queue_.empty() && queue_.top().first == number) {
                const int64_t met = queue_.top().second;
                queue_.pop();
                const std::vector<int64_t> &own = turned_[static_cast<size_t>(met)];
                const auto next = std::upper_bound(own.begin(), own.end(), number);
                if (next != own.end()) {
                    queue_.push({*next, met});
                }
            }
            double &a = row_[static_cast<size_t>(by.a)], &b = row_[static_cast<size_t>(by.b)];
            const double turned = by.cosine * a - by.sine * b;
            b = by.sine * a + by.cosine * b;
            a = turned;
        }
    }

    // The components along earlier equations become a row of L; the remainder is rotated into its last
    // unknown.
    void finish(int64_t row) {
        rest_.clear();
        std::vector<double> values;
        for (const int64_t column : seen_) {
            if (number_of_[static_cast<size_t>(column)] == none) {
                rest_.push_back(column);
                values.push_back(row_[static_cast<size_t>(column)]);
            }
        }
        if (!(norm(values.data(), static_cast<int>(values.size())) > threshold_)) {
            return;
        }
        for (const int64_t column : seen_) {
            const auto at = static_cast<size_t>(column);
            if (number_of_[at] != none && row_[at] != 0) {
                result_.before_.push_back(number_of_[at]);
                result_.lower_.push_back(row_[at]);
            }
        }
        result_.starts_.push_back(result_.lower_.size());
        for (size_t i = 0; i + 1 < rest_.size(); ++i) {
            rotate(rest_[i], rest_[i + 1]);
        }
        number_of_[static_cast<size_t>(rest_.back())] = result_.rank();
        result_.diagonal_.push_back(row_[static_cast<size_t>(rest_.back())]);
        result_.pivots_.push_back(rest_.back());
        result_.row_of_.push_back(row);
    }

    void rotate(int64_t a, int64_t b) {
        double &x = row_[static_cast<size_t>(a)], &y = row_[static_cast<size_t>(b)];
        if (x == 0) {
            return;
        }
        const double length = std::hypot(x, y);
        const auto number = std::ssize(result_.rotations_);
        result_.rotations_.push_back({a, b, y / length, x / length});
        turned_[static_cast<size_t>(a)].push_back(number);
        turned_[static_cast<size_t>(b)].push_back(number);
        x = 0;
        y = length;
    }

    MinimumNorm &result_;
    double threshold_;
    std::vector<double> row_;
    std::vector<char> marks_;
    std::vector<int64_t> seen_; // unknowns of the row
    std::vector<int64_t> rest_;
    std::vector<int64_t> number_of_;           // the equation that ended in each unknown
    std::vector<std::vector<int64_t>> turned_; // the rotations of each unknown
    using Next = std::pair<int64_t, int64_t>;  // a rotation, and an unknown of the row that it affects
    std::priority_queue<Next, std::vector<Next>, std::greater<>> queue_;
};

MinimumNorm::MinimumNorm(const SparseRows &rows, int64_t n, double threshold)
    : unknowns_(n), rows_(rows.size()) {
    require_representable(rows.all_values(), "equations");
    Reduction reduction(*this, threshold);
    for (const int64_t row : order_of(rows)) {
        reduction.add(row, rows.columns(row), rows.values(row));
    }
}

void MinimumNorm::turn(std::vector<double> &x, int64_t width) const {
    for (size_t i = rotations_.size(); i-- > 0;) {
        const Rotation &by = rotations_[i];
        double *a = x.data() + by.a * width, *b = x.data() + by.b * width;
        count_work(width);
        for (int64_t c = 0; c < width; ++c) {
            const double turned = by.cosine * a[c] + by.sine * b[c];
            b[c] = by.cosine * b[c] - by.sine * a[c];
            a[c] = turned;
        }
    }
}

void MinimumNorm::turn_back(std::vector<double> &x, int64_t width) const {
    for (const Rotation &by : rotations_) {
        double *a = x.data() + by.a * width, *b = x.data() + by.b * width;
        count_work(width);
        for (int64_t c = 0; c < width; ++c) {
            const double turned = by.cosine * a[c] - by.sine * b[c];
            b[c] = by.sine * a[c] + by.cosine * b[c];
            a[c] = turned;
        }
    }
}

std::vector<double> MinimumNorm::solve(const std::vector<double> &right, int64_t width) const {
    std::vector<double> x(static_cast<size_t>(unknowns_ * width));
    for (size_t i = 0; i < pivots_.size(); ++i) {
        double *own = x.data() + pivots_[i] * width;
        for (int64_t c = 0; c < width; ++c) {
            double sum = right[static_cast<size_t>(row_of_[i] * width + c)];
            for (size_t j = starts_[i]; j < starts_[i + 1]; ++j) {
                sum -=
                    lower_[j] * x[static_cast<size_t>(pivots_[static_cast<size_t>(before_[j])] * width + c)];
            }
            own[c] = sum / diagonal_[i];
        }
    }
    turn(x, width);
    return x;
}

MinimumNorm::Multipliers MinimumNorm::multipliers(const std::vector<double> &x) const {
    std::vector<double> turned = x;
    turn_back(turned, 1);
    std::vector<double> values(static_cast<size_t>(rows_)), along(pivots_.size());
    for (size_t i = 0; i < pivots_.size(); ++i) {
        double &own = turned[static_cast<size_t>(pivots_[i])];
        along[i] = std::exchange(own, 0.0);
    }
    for (size_t i = pivots_.size(); i-- > 0;) { // L^T lambda = along
        const double value = along[i] / diagonal_[i];
        values[static_cast<size_t>(row_of_[i])] = value;
        for (size_t j = starts_[i]; j < starts_[i + 1]; ++j) {
            along[static_cast<size_t>(before_[j])] -= lower_[j] * value;
        }
    }
    return {std::move(values), norm(turned.data(), static_cast<int>(unknowns_))};
}

std::vector<double> MinimumNorm::kernel_part(const std::vector<double> &x) const {
    std::vector<double> turned = x;
    turn_back(turned, 1);
    for (const int64_t pivot : pivots_) {
        turned[static_cast<size_t>(pivot)] = 0;
    }
    turn(turned, 1);
    return turned;
}

} // namespace nrb::inline numeric
