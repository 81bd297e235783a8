// SPDX-License-Identifier: MIT
#include "refine/algebra/product_terms.h"

#include "base/watch.h"
#include "numeric/binomial.h"
#include "spline/contract.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::refine {

int32_t PolarRows::add(const CommonKnots &axis, int member, const BlossomRow &row) {
    rows_.push_back({axis.stored_layer(member, row.first), row.size, coefficients_.size()});
    coefficients_.insert(coefficients_.end(), row.coefficients, row.coefficients + row.size);
    return static_cast<int32_t>(rows_.size() - 1);
}

void PolarRows::contract(int64_t row, const double *layers, int64_t length, double *out) const noexcept {
    const Row &at = rows_[static_cast<size_t>(row)];
    spline::contract(coefficients_.data() + at.offset, at.size, layers + at.layer * length, length, length,
                     out);
}

namespace {

constexpr int64_t most_layers = 32;
constexpr int64_t enough_rows = 96; // if the next layer begins at another knot: it would share few rows
constexpr int64_t work_of_a_choice = 60;

double scale_of(int degree, int degree_a) noexcept {
    return std::ldexp(1.0, -std::ilogb(binomial(degree, degree_a)));
}

// The rows of a factor computed so far, found by the numbers of copies of each knot among their arguments (a
// hash table with open addressing).
class KnownRows {
public:
    explicit KnownRows(int64_t first_group) noexcept : first_group_(first_group) {}

    // The entry for the row with these arguments: its number, or -1, to be replaced by the number of a new
    // row. Null if rows with such arguments are not recorded.
    int32_t *find(const CommonKnots::Window &window, const int *chosen) noexcept {
        const std::optional<uint64_t> key = key_of(window, chosen);
        if (!key || 2 * used_ >= places) {
            return nullptr;
        }
        constexpr uint64_t spread = 0x9e3779b97f4a7c15U;
        size_t at = *key * spread >> (64 - place_bits);
        while (numbers_[at] >= 0 && keys_[at] != *key) {
            at = (at + 1) % places;
        }
        used_ += numbers_[at] < 0 ? 1 : 0;
        keys_[at] = *key;
        return &numbers_[at];
    }

private:
    static constexpr int place_bits = 9;
    static constexpr size_t places = size_t{1} << place_bits;
    static constexpr int copy_bits = 5; // up to 31 copies of each of up to 9 consecutive knots
    static constexpr int most_groups = 9;
    static constexpr int64_t most_offset = 256;

    // A row whose arguments are all one knot is not recorded: its value depends on the side of the knot on
    // which the window lies.
    [[nodiscard]] std::optional<uint64_t> key_of(const CommonKnots::Window &window,
                                                 const int *chosen) const noexcept {
        int low = 0, high = window.size;
        while (low < high && chosen[low] == 0) {
            ++low;
        }
        while (high > low && chosen[high - 1] == 0) {
            --high;
        }
        const int64_t offset = window.group + low - first_group_;
        if (high - low < 2 || high - low > most_groups || offset >= most_offset) {
            return std::nullopt;
        }
        uint64_t key = static_cast<uint64_t>(offset) * (most_groups + 1) + static_cast<uint64_t>(high - low);
        for (int i = low; i < high; ++i) {
            key = key << copy_bits | static_cast<uint64_t>(chosen[i]);
        }
        return key;
    }

    int64_t first_group_;
    size_t used_ = 0;
    std::array<uint64_t, places> keys_{};
    std::array<int32_t, places> numbers_ = [] {
        std::array<int32_t, places> none;
        none.fill(-1);
        return none;
    }();
};

} // namespace

// Appends the terms of one layer after another.
class ProductTerms::Builder {
public:
    Builder(ProductTerms &terms, const CommonKnots &axis, int degree_a)
        : terms_(terms), axis_(axis), degree_a_(degree_a), scale_(scale_of(axis.axis()->degree(), degree_a)),
          known_{KnownRows(axis.window(terms.first_).group), KnownRows(axis.window(terms.first_).group)} {}

    void add_layer(int64_t layer) {
        const CommonKnots::Window window = axis_.window(layer);
        for_each_choice(window, degree_a_, [&](const int *chosen, double times) {
            int rest[max_basis];
            for (int i = 0; i < window.size; ++i) {
                rest[i] = window.copies[static_cast<size_t>(i)] - chosen[i];
            }
            const int32_t a = number_of(0, window, chosen), b = number_of(1, window, rest);
            terms_.terms_.push_back({times * scale_, a, b});
            count_work(work_of_a_choice);
        });
        terms_.ends_.push_back(terms_.terms_.size());
    }

private:
    int32_t number_of(int member, const CommonKnots::Window &window, const int *chosen) {
        const auto at = static_cast<size_t>(member);
        int32_t *known = known_[at].find(window, chosen);
        if (known != nullptr && *known >= 0) {
            return *known;
        }
        BlossomRow row;
        axis_.blossom_row(member, window, chosen, row);
        const int32_t number = terms_.rows_[at].add(axis_, member, row);
        if (known != nullptr) {
            *known = number;
        }
        return number;
    }

    ProductTerms &terms_;
    const CommonKnots &axis_;
    int degree_a_;
    double scale_;
    std::array<KnownRows, 2> known_;
};

ProductTerms::ProductTerms(const CommonKnots &axis, int degree_a, int64_t first) : first_(first) {
    Builder builder(*this, axis, degree_a);
    const int64_t last = std::min(axis.axis()->count(), first + most_layers);
    const auto full = [&] { return std::max(rows_[0].size(), rows_[1].size()) >= enough_rows; };
    do {
        builder.add_layer(end());
    } while (end() < last && (!full() || axis.window(end()).group == axis.window(end() - 1).group));
}

double ProductTerms::total(int degree, int degree_a) noexcept {
    return binomial(degree, degree_a) * scale_of(degree, degree_a);
}

} // namespace nrb::refine
