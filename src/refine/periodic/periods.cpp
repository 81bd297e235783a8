// SPDX-License-Identifier: MIT
#include "refine/periodic/periods.h"

#include "base/checked.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

// The knots of a periodic axis as an endless sequence; stored knots keep their numbers.
class EndlessKnots {
public:
    explicit EndlessKnots(const KnotVector &axis) noexcept
        : axis_(axis), step_(axis.distinct_layers()), length_(axis.domain().upper - axis.domain().lower) {}

    [[nodiscard]] int64_t step() const noexcept { return step_; }
    [[nodiscard]] bool stored(int64_t i) const noexcept { return 0 <= i && i < std::ssize(axis_.knots()); }
    [[nodiscard]] double operator[](int64_t i) const noexcept {
        const int64_t base = in_period(i);
        const int64_t periods = (i - base) / step_; // exact
        return stored(i) ? axis_[i] : std::fma(static_cast<double>(periods), length_, axis_[base]);
    }
    [[nodiscard]] bool equals_next(int64_t i) const noexcept {
        const int64_t base = in_period(i);
        return axis_[base] == axis_[base + 1];
    }

private:
    // The index of the same knot within one period, from `degree` on, so that the knot after it is stored
    // too.
    [[nodiscard]] int64_t in_period(int64_t i) const noexcept {
        const int64_t rest = (i - axis_.degree()) % step_;
        return axis_.degree() + (rest < 0 ? rest + step_ : rest);
    }

    const KnotVector &axis_;
    int64_t step_;
    double length_;
};

// Knots begin, begin + 1, ... of the sequence, in order. Those that are stored are taken as they are.
std::vector<double> knots_from(const EndlessKnots &endless, int64_t begin, int64_t size) {
    std::vector<double> knots(static_cast<size_t>(size));
    int64_t known = 0;
    while (known + 1 < size && !endless.stored(begin + known)) {
        ++known;
    }
    known = endless.stored(begin + known) ? known : 0;
    const auto at = [&](int64_t i) -> double & { return knots[static_cast<size_t>(i)]; };
    at(known) = endless[begin + known];
    for (int64_t i = known; i-- > 0;) {
        at(i) = endless.equals_next(begin + i) ? at(i + 1) : std::min(endless[begin + i], at(i + 1));
    }
    for (int64_t i = known + 1; i < size; ++i) {
        const bool equal = !endless.stored(begin + i) && endless.equals_next(begin + i - 1);
        at(i) = equal ? at(i - 1) : std::max(endless[begin + i], at(i - 1));
    }
    return knots;
}

void check_copies(const std::vector<double> &knots, int degree) {
    const auto limit = static_cast<size_t>(degree) + 1;
    for (size_t i = 0; i + limit < knots.size(); ++i) {
        if (knots[i] == knots[i + limit]) {
            fail(Status::periodic_knots, "knots: rounding makes more than %zu copies equal at %s", limit,
                 Number(knots[i]).text);
        }
    }
}

} // namespace

KnotVectorPtr over_periods(const KnotVector &axis, int64_t first, int64_t end) {
    const EndlessKnots endless(axis);
    const int64_t layers = checked_product(endless.step(), end - first, "knots");
    const int64_t size = checked_sum(layers, 2 * int64_t{axis.degree()} + 1, "knots");
    std::vector<double> knots = knots_from(endless, first * endless.step(), size);
    if (!std::isfinite(knots.back() - knots.front())) {
        fail(Status::not_representable, "knots: those of the periods beside the domain overflow");
    }
    check_copies(knots, axis.degree());
    return std::make_shared<const KnotVector>(axis.degree(), std::move(knots));
}

} // namespace nrb::refine
