// SPDX-License-Identifier: MIT
#include "fit/statistics/statistics.h"

#include "base/error.h"
#include "base/watch.h"

#include <algorithm>
#include <numeric>

namespace nrb::fit {

bool operator==(const StatisticsForm &a, const StatisticsForm &b) noexcept {
    const auto equal = [](const KnotVectorPtr &x, const KnotVectorPtr &y) {
        return x == y || std::ranges::equal(x->knots(), y->knots());
    };
    return a.degrees == b.degrees && a.dim == b.dim && a.value_exponent == b.value_exponent &&
           a.weight_exponent == b.weight_exponent && std::ranges::equal(a.breaks, b.breaks, equal);
}

CellLayout::CellLayout(const StatisticsForm &form) noexcept : moments(1), functions(1), dim(form.dim) {
    for (const int degree : form.degrees) {
        moments *= 2 * degree + 1;
        functions *= degree + 1;
    }
}

int64_t Statistics::data_count() const noexcept {
    return std::accumulate(counts_.begin(), counts_.end(), int64_t{0});
}

double Statistics::weight() const noexcept {
    ExactSum sum;
    for (int64_t i = 0; i < std::ssize(cells_); ++i) {
        sum += sums(i).back();
    }
    return sum.scaled(form_->weight_exponent - value_bits).high;
}

void Statistics::append(int64_t cell, int64_t count, std::span<const ExactSum> sums) {
    if (count > 0) {
        cells_.push_back(cell);
        counts_.push_back(count);
        sums_.insert(sums_.end(), sums.begin(), sums.end());
        count_work(2 * std::ssize(sums));
    }
}

void Statistics::reserve(size_t cells) {
    cells_.reserve(cells);
    counts_.reserve(cells);
    sums_.reserve(cells * static_cast<size_t>(CellLayout(*form_).entries()));
}

namespace {

void check_forms(std::span<const StatisticsPtr> parts) {
    for (size_t i = 1; i < parts.size(); ++i) {
        if (!(parts[i]->form() == parts[0]->form())) {
            fail(Status::incompatible,
                 "parts[%zu] and parts[0] differ in degrees, breaks, dimension or scales", i);
        }
    }
}

// Merges the cells of the parts in ascending order; next_ has the next cell of each part to be added.
class Merge {
public:
    Merge(std::span<const StatisticsPtr> parts, std::span<const int32_t> signs)
        : parts_(parts), signs_(signs), next_(parts.size(), 0) {}

    Statistics result() {
        Statistics sum(parts_[0]->shared_form());
        sum.reserve(most_cells());
        const auto later = [](const Head &a, const Head &b) { return a.cell > b.cell; };
        for (size_t i = 0; i < parts_.size(); ++i) {
            push(i);
        }
        std::ranges::make_heap(heads_, later);
        std::vector<ExactSum> sums(static_cast<size_t>(CellLayout(parts_[0]->form()).entries()));
        while (!heads_.empty()) {
            const int64_t cell = heads_.front().cell;
            int64_t count = 0;
            std::ranges::fill(sums, ExactSum{});
            while (!heads_.empty() && heads_.front().cell == cell) {
                std::ranges::pop_heap(heads_, later);
                const size_t part = heads_.back().part;
                heads_.pop_back();
                count += add(part, sums);
                ++next_[part];
                if (push(part)) {
                    std::ranges::push_heap(heads_, later);
                }
            }
            check(cell, count, sums);
            sum.append(cell, count, sums);
        }
        return sum;
    }

private:
    struct Head {
        int64_t cell;
        size_t part;
    };

    [[nodiscard]] size_t most_cells() const noexcept {
        size_t cells = 0;
        for (const StatisticsPtr &part : parts_) {
            cells = std::max(cells, part->cells().size());
        }
        return cells;
    }
    [[nodiscard]] bool subtracted(size_t part) const noexcept { return !signs_.empty() && signs_[part] < 0; }
    bool push(size_t part) {
        const auto cells = parts_[part]->cells();
        if (next_[part] == cells.size()) {
            return false;
        }
        heads_.push_back({cells[next_[part]], part});
        return true;
    }
    // Returns the number of data added, negative if they are subtracted.
    int64_t add(size_t part, std::vector<ExactSum> &sums) const {
        const auto at = static_cast<int64_t>(next_[part]);
        const std::span<const ExactSum> own = parts_[part]->sums(at);
        const bool minus = subtracted(part);
        for (size_t e = 0; e < sums.size(); ++e) {
            minus ? sums[e] -= own[e] : sums[e] += own[e];
        }
        count_work(2 * std::ssize(sums));
        const int64_t count = parts_[part]->counts()[next_[part]];
        return minus ? -count : count;
    }
    // Data that were not added before cannot be subtracted: the number of data shows it, or else the sum of
    // weights.
    static void check(int64_t cell, int64_t count, const std::vector<ExactSum> &sums) {
        const bool empty = std::ranges::all_of(sums, &ExactSum::zero);
        if (count < 0 || (count == 0 && !empty) || sums.back().negative()) {
            fail(Status::count, "more is subtracted from cell %lld than was added to it",
                 static_cast<long long>(cell));
        }
    }

    std::span<const StatisticsPtr> parts_;
    std::span<const int32_t> signs_;
    std::vector<size_t> next_;
    std::vector<Head> heads_;
};

} // namespace

Statistics merged(std::span<const StatisticsPtr> parts, std::span<const int32_t> signs) {
    check_forms(parts);
    return Merge(parts, signs).result();
}

} // namespace nrb::fit
