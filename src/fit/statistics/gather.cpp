// SPDX-License-Identifier: MIT
#include "fit/statistics/gather.h"

#include "base/error.h"
#include "base/watch.h"
#include "fit/statistics/cell_slots.h"
#include "fit/statistics/fixed_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace nrb::fit {

double checked_weight(const ConstRecords &weights, int64_t i) {
    const double weight = weights.data == nullptr ? 1 : weights(i, 0);
    if (!std::isfinite(weight)) {
        fail(Status::weight_not_finite, "weights[%lld] = %s is not finite", static_cast<long long>(i),
             Number(weight).text);
    }
    if (weight < 0) {
        fail(Status::weight_negative, "weights[%lld] = %s is negative", static_cast<long long>(i),
             Number(weight).text);
    }
    return weight;
}

namespace {

// The number of terms for which 128-bit sums have room: a weight times a function is below 2^115.
constexpr int32_t most_pending = 1 << 11;

class Gathering {
public:
    Gathering(const StatisticsForm &form, const Data &data, const eval::AxisRules &rules)
        : form_(form), data_(data), rules_(rules), layout_(form), of_values_(form.value_exponent),
          of_weights_(form.weight_exponent), slots_(cell_count(form), data.params.count),
          weighted_(data.weights.data != nullptr || form.weight_exponent != 0) {
        for (const KnotVectorPtr &breaks : form.breaks) {
            finders_.push_back(breaks->spans().finder());
        }
        for (size_t k = 0; k < form.degrees.size(); ++k) {
            high_[k].resize(static_cast<size_t>(2 * form.degrees[k] + 1));
            low_[k].resize(static_cast<size_t>(form.degrees[k] + 1));
        }
        places_.resize(batch * form.degrees.size());
        values_.resize(batch * static_cast<size_t>(form.dim));
    }

    void add_all() {
        const int64_t n = data_.params.count;
        Steps steps(n / block + 1);
        for (int64_t first = 0; first < n; first += block) {
            const int64_t end = std::min(n, first + block);
            for (int64_t some = first; some < end; some += batch) {
                add_batch(some, std::min(end, some + batch));
            }
            steps.next((end - first) * layout_.entries());
        }
    }

    // Makes the same checks without adding anything.
    void check_all() {
        const int64_t n = data_.params.count;
        for (int64_t i = 0; i < n; ++i) {
            const int64_t weight = weighted_ ? weight_of(i) : int64_t{1} << value_bits;
            if (weight != 0 && is_placed(i)) {
                read_value(i, weight, values_.data());
            }
        }
        count_work(4 * n);
    }

    Statistics result(std::shared_ptr<const StatisticsForm> form) {
        const std::vector<int64_t> &cells = slots_.cells();
        std::vector<size_t> order(cells.size());
        std::iota(order.begin(), order.end(), size_t{0});
        std::ranges::sort(order, {}, [&](size_t slot) { return cells[slot]; });
        Statistics made(std::move(form));
        made.reserve(cells.size());
        for (const size_t slot : order) {
            settle(slot);
            made.append(cells[slot], counts_[slot], std::span(sums_).subspan(slot * entries(), entries()));
        }
        return made;
    }

private:
    static constexpr int64_t block = 1024, batch = 32;

    // A value in units of the scale, and the same times its weight.
    struct Value {
        int64_t units;
        int64_t weighted;
    };
    // A point that counts, and where in a batch its places and its value are.
    struct Point {
        int64_t cell, weight;
        const CellPlace *places;
        const Value *values;
    };

    static int64_t cell_count(const StatisticsForm &form) noexcept {
        int64_t cells = 1;
        for (const KnotVectorPtr &breaks : form.breaks) {
            cells *= breaks->count();
        }
        return cells;
    }
    [[nodiscard]] size_t entries() const noexcept { return static_cast<size_t>(layout_.entries()); }

    // The places of several points are found before these are added: the divisions for them need not wait for
    // each other, and a processor has most of them under way at once.
    void add_batch(int64_t first, int64_t end) {
        std::array<Point, batch> points;
        size_t count = 0;
        for (int64_t i = first; i < end; ++i) {
            Point &point = points[count];
            point = {0, int64_t{1} << value_bits, &places_[count * finders_.size()],
                     &values_[count * static_cast<size_t>(form_.dim)]};
            if ((weighted_ && (point.weight = weight_of(i)) == 0) ||
                !find(i, point.cell, &places_[count * finders_.size()])) {
                continue;
            }
            read_value(i, point.weight, &values_[count * static_cast<size_t>(form_.dim)]);
            ++count;
        }
        for (size_t j = 0; j < count; ++j) {
            add(points[j]);
        }
    }

    void add(const Point &point) {
        const auto slot = static_cast<size_t>(slots_.of(point.cell));
        if (slot == counts_.size()) {
            counts_.push_back(0);
            pending_.push_back(0);
            recent_.resize(recent_.size() + entries());
            sums_.resize(sums_.size() + entries());
        }
        if (pending_[slot] == most_pending) {
            settle(slot);
        }
        ++pending_[slot];
        add_to(recent_.data() + slot * entries(), point);
    }

    [[nodiscard]] int64_t weight_of(int64_t i) const {
        const double weight = checked_weight(data_.weights, i);
        if (weight > of_weights_.scale()) {
            fail_scale(weight, of_weights_, "weights", i);
        }
        return of_weights_(weight);
    }
    [[noreturn]] static void fail_scale(double x, const ScaledUnits &units, const char *name, int64_t i) {
        fail(Status::scale, "%s[%lld] = %s, expected at most the scale %s", name, static_cast<long long>(i),
             Number(x).text, Number(units.scale()).text);
    }

    // Finds the cell of a point, and its place in the cell; false if the point is left out.
    bool find(int64_t i, int64_t &cell, CellPlace *places) const {
        for (size_t k = 0; k < finders_.size(); ++k) {
            const double given = data_.params(i, static_cast<int64_t>(k));
            const KnotVector &breaks = *form_.breaks[k];
            const Interval domain = breaks.domain();
            const bool wraps = rules_[k].outside == eval::Outside::wrap; // ends are wrapped, too
            const bool inside = wraps ? given > domain.lower && given < domain.upper
                                      : given >= domain.lower && given <= domain.upper;
            if (!inside) {
                check_parameter(i, k, domain);
            }
            const double t = inside ? given : eval::place(given, rules_[k], domain);
            if (!(t == t)) {
                return false;
            }
            const int64_t span = rules_[k].left ? finders_[k].number<true>(t) : finders_[k].number<false>(t);
            cell = cell * breaks.count() + span;
            places[k] = place_in_cell(t, breaks[span], breaks[span + 1]);
        }
        return true;
    }
    [[nodiscard]] bool is_placed(int64_t i) const {
        for (size_t k = 0; k < finders_.size(); ++k) {
            const double t = data_.params(i, static_cast<int64_t>(k));
            const Interval domain = form_.breaks[k]->domain();
            if (t >= domain.lower && t <= domain.upper) {
                continue;
            }
            check_parameter(i, k, domain);
            if (std::isnan(eval::place(t, rules_[k], domain))) {
                return false;
            }
        }
        return true;
    }
    void check_parameter(int64_t i, size_t k, const Interval &domain) const {
        char name[64];
        std::snprintf(name, sizeof name, "params[%lld][%zu]", static_cast<long long>(i), k);
        eval::check_parameter(data_.params(i, static_cast<int64_t>(k)), rules_[k], domain, name);
    }
    // Degrees known at compile time halve the time.
    void set_functions(size_t k, const CellPlace &place) noexcept {
        using std::integral_constant;
        switch (form_.degrees[k]) {
        case 1:
            return fill(k, place, integral_constant<int, 1>());
        case 2:
            return fill(k, place, integral_constant<int, 2>());
        case 3:
            return fill(k, place, integral_constant<int, 3>());
        case 5:
            return fill(k, place, integral_constant<int, 5>());
        default:
            return fill(k, place, form_.degrees[k]);
        }
    }
    template <class Degree>
    void fill(size_t k, const CellPlace &place, Degree p) noexcept {
        int64_t values[2 * max_degree + 1];
        values[0] = function_unit;
        raise_functions(0, p, place.distance, values);
        put(values, p, place.from_end, low_[k].data());
        raise_functions(p, 2 * p, place.distance, values);
        put(values, 2 * p, place.from_end, high_[k].data());
    }
    static void put(const int64_t *values, int degree, bool reversed, int64_t *out) noexcept {
        reversed ? std::reverse_copy(values, values + degree + 1, out) : std::copy_n(values, degree + 1, out);
    }

    void read_value(int64_t i, int64_t weight, Value *values) const {
        for (int c = 0; c < form_.dim; ++c) {
            const double value = data_.values(i, c);
            if (!(std::abs(value) <= of_values_.scale())) {
                fail_value(i, c, value);
            }
            const int64_t units = of_values_(value);
            values[c] = {units, weighted_ ? Int128::product(units, weight).rounded_shift(value_bits) : units};
        }
    }
    [[noreturn]] void fail_value(int64_t i, int c, double value) const {
        char name[64];
        std::snprintf(name, sizeof name, "values[%lld]", static_cast<long long>(i));
        if (!std::isfinite(value)) {
            fail(Status::point_not_finite, "%s[%d] = %s is not finite", name, c, Number(value).text);
        }
        fail_scale(value, of_values_, name, c);
    }

    // Sums of cubic curves of dimension 1 to 3 without weights, whose sizes are known at compile time, take
    // two thirds of the time.
    void add_to(Int128 *sums, const Point &point) noexcept {
        using std::integral_constant;
        const bool cubic = form_.axes() == 1 && form_.degrees[0] == 3 && !weighted_;
        switch (cubic ? form_.dim : 0) {
        case 1:
            return add_cubic(sums, point, integral_constant<int, 1>());
        case 2:
            return add_cubic(sums, point, integral_constant<int, 2>());
        case 3:
            return add_cubic(sums, point, integral_constant<int, 3>());
        default:
            return add_any(sums, point);
        }
    }
    template <class Dimension>
    void add_cubic(Int128 *sums, const Point &point, Dimension dim) noexcept {
        constexpr int p = 3;
        const CellPlace place = point.places[0];
        const std::ptrdiff_t step = place.from_end ? -1 : 1; // functions are numbered from the nearer end
        Int128 *const moments = sums + (place.from_end ? 2 * p : 0);
        Int128 *const right = sums + (2 * p + 1) + (place.from_end ? p * dim : 0);
        Int128 *const squares = sums + (2 * p + 1) + (p + 1) * dim;
        const Value *const values = point.values; // without weights
        int64_t functions[2 * p + 1];
        functions[0] = function_unit;
        raise_functions(0, p, place.distance, functions);
        for (int j = 0; j <= p; ++j) {
            for (int c = 0; c < dim; ++c) {
                right[j * step * dim + c] += Int128::product(functions[j], values[c].units);
            }
        }
        raise_functions(p, 2 * p, place.distance, functions);
        for (int j = 0; j <= 2 * p; ++j) {
            moments[j * step] += Int128::of(static_cast<uint64_t>(functions[j]));
        }
        for (int c = 0; c < dim; ++c) {
            squares[c] += Int128::product(values[c].units, values[c].units);
        }
        squares[dim] += Int128::of(1);
    }
    // Without weights, the sums that a weight would multiply get its factor only when they are settled.
    void add_any(Int128 *sums, const Point &point) noexcept {
        for (size_t k = 0; k < finders_.size(); ++k) {
            set_functions(k, point.places[k]);
        }
        const std::span<const Value> values(point.values, static_cast<size_t>(form_.dim));
        for_each_row(high_, [&](std::span<const int64_t> products) {
            sums = weighted_ ? add_times(sums, products, point.weight) : add_all_of(sums, products);
        });
        for_each_row(low_, [&](std::span<const int64_t> products) {
            for (const int64_t product : products) {
                for (const Value &value : values) {
                    *sums++ += Int128::product(product, value.weighted);
                }
            }
        });
        for (const Value &value : values) {
            *sums++ += Int128::product(value.units, value.weighted);
        }
        *sums += Int128::of(weighted_ ? static_cast<uint64_t>(point.weight) : 1);
    }
    static Int128 *add_all_of(Int128 *sums, std::span<const int64_t> products) noexcept {
        for (const int64_t product : products) {
            *sums++ += Int128::of(static_cast<uint64_t>(product));
        }
        return sums;
    }
    static Int128 *add_times(Int128 *sums, std::span<const int64_t> products, int64_t weight) noexcept {
        for (const int64_t product : products) {
            *sums++ += Int128::product(product, weight);
        }
        return sums;
    }
    // Visits the products of the functions of all axes, row by row along the last axis; `factor` is the
    // product of those of the axes before.
    using Functions = std::array<std::vector<int64_t>, max_axes>;
    template <class Visit>
    void for_each_row(const Functions &functions, const Visit &visit, size_t k = 0,
                      int64_t factor = 0) const {
        const auto with_own = [=](int64_t own) { return k == 0 ? own : function_product(factor, own); };
        if (k + 1 < finders_.size()) {
            for (const int64_t own : functions[k]) {
                for_each_row(functions, visit, k + 1, with_own(own));
            }
            return;
        }
        std::array<int64_t, 2 * max_degree + 1> products;
        std::ranges::transform(functions[k], products.begin(), with_own);
        visit(std::span<const int64_t>(products.data(), functions[k].size()));
    }

    // Adds the pending sums to those that have room for all data.
    void settle(size_t slot) noexcept {
        Int128 *const recent = recent_.data() + slot * entries();
        ExactSum *const sums = sums_.data() + slot * entries();
        for (int64_t e = 0; e < layout_.entries(); ++e) {
            const bool is_weighted = weighted_ || (e >= layout_.right() && e < layout_.weight());
            sums[e].add(recent[e], is_weighted ? 0 : value_bits);
            recent[e] = {};
        }
        counts_[slot] += pending_[slot];
        pending_[slot] = 0;
    }

    const StatisticsForm &form_;
    const Data &data_;
    const eval::AxisRules &rules_;
    CellLayout layout_;
    ScaledUnits of_values_, of_weights_;
    CellSlots slots_;
    bool weighted_;
    std::vector<SpanTable::Finder> finders_;
    // Of a batch.
    std::vector<CellPlace> places_; // [batch][axes]
    std::vector<Value> values_;     // [batch][dim]
    Functions high_, low_;          // functions of degrees 2 p and p at the point
    // Of each slot, a cell that data have reached.
    std::vector<int64_t> counts_;
    std::vector<int32_t> pending_;
    std::vector<Int128> recent_;
    std::vector<ExactSum> sums_;
};

} // namespace

double largest_weight(const Data &data) noexcept {
    double largest = 0;
    for (int64_t i = 0; data.weights.data != nullptr && i < data.weights.count; ++i) {
        const double weight = data.weights(i, 0);
        largest = weight > largest && std::isfinite(weight) ? weight : largest;
    }
    return largest;
}

Statistics gather(std::shared_ptr<const StatisticsForm> form, const Data &data,
                  const eval::AxisRules &rules) {
    Gathering gathering(*form, data, rules);
    gathering.add_all();
    return gathering.result(std::move(form));
}

void check_data(const StatisticsForm &form, const Data &data, const eval::AxisRules &rules) {
    Gathering(form, data, rules).check_all();
}

} // namespace nrb::fit
