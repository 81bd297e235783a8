// SPDX-License-Identifier: MIT
#include "basis/knot_vector.h"

#include "base/error.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nrb::inline basis {

namespace {

// " on axis 1", or an empty text if the call has no axes.
struct AxisText {
    explicit AxisText(int axis) noexcept : text{} {
        if (axis >= 0) {
            static_cast<void>(std::snprintf(text, sizeof text, " on axis %d", axis));
        }
    }
    char text[24];
};

void check_multiplicities(int degree, std::span<const double> knots, int axis, int64_t offset) {
    const auto limit = static_cast<size_t>(degree) + 1;
    for (size_t i = 0; i + limit < knots.size(); ++i) {
        if (knots[i] != knots[i + limit]) {
            continue;
        }
        const bool end = knots[i] == knots.front() || knots[i] == knots.back();
        fail(end ? Status::end_multiplicity : Status::multiplicity,
             "knots[%lld] = %s%s is the same knot as knots[%lld]; degree %d allows %d equal %s knots",
             static_cast<long long>(i + limit) + offset, Number(knots[i]).text, AxisText(axis).text,
             static_cast<long long>(i) + offset, degree, degree + 1, end ? "end" : "interior");
    }
}

} // namespace

KnotVector::KnotVector(int degree, std::vector<double> knots, bool periodic) noexcept
    : degree_(degree), periodic_(periodic), knots_(std::move(knots)) {}

// The function of layer i is nonzero between its knots i and i + degree + 1. In copies of a knot vector
// scaled by a power of two, the domain may have collapsed.
KnotVector::Layers KnotVector::active_layers() const noexcept {
    const auto [lower, upper] = domain();
    Layers layers{0, count()};
    if (periodic_ || !(lower < upper)) {
        return layers;
    }
    while ((*this)[layers.first + degree_ + 1] <= lower) {
        ++layers.first;
    }
    while ((*this)[layers.end - 1] >= upper) {
        --layers.end;
    }
    return layers;
}

const SpanTable &KnotVector::spans() const {
    return spans_.get([this] { return SpanTable(degree_, knots_); });
}

const SpanTable *KnotVector::spans_after(int64_t uses) const {
    return spans_.peek() != nullptr || searches_.pay(uses, count() / 4) ? &spans() : nullptr;
}

const PowerSpans *KnotVector::power_spans_after(int64_t uses) const {
    if (power_spans_.peek() != nullptr || evaluations_.pay(uses, count() / 4)) {
        return &power_spans_.get([this] { return basis_power_spans(*this); });
    }
    return nullptr;
}

bool KnotVector::has_power_span(int64_t span) const noexcept {
    if (!power_span_degree(degree_)) {
        return false;
    }
    constexpr double shortest = 0x1p-100;
    constexpr double largest_ratio = 0x1p500;
    // The middle of a span only a few ulps long may be off by half an ulp, and at an end of the span the
    // powers amplify rounding by 3^p.
    constexpr double fewest_units = 32 * eps;
    const double length = (*this)[span + 1] - (*this)[span];
    const double position = std::max(std::abs((*this)[span]), std::abs((*this)[span + 1]));
    const double extent = (*this)[span + degree_] - (*this)[span + 1 - degree_];
    return length >= shortest && length >= fewest_units * position && extent <= largest_ratio &&
           extent <= largest_ratio * length;
}

int64_t KnotVector::find_span(double t, bool left) const noexcept {
    const SpanTable *table = spans_.peek();
    return table != nullptr ? table->find(t, left) : nrb::find_span(degree_, knots_, t, left);
}

void check_degree(int degree, int axis) {
    if (degree < 0 || degree > max_degree) {
        fail(Status::degree, "degrees[%d] = %d, expected 0 to %d", axis < 0 ? 0 : axis, degree, max_degree);
    }
}

void check_count(int degree, int64_t count, int axis) {
    const int index = axis < 0 ? 0 : axis;
    if (count <= 0) {
        fail(Status::count, "counts[%d] = %lld, expected at least 1", index, static_cast<long long>(count));
    }
    if (count <= degree) {
        fail(Status::too_few_points, "counts[%d] = %lld, degree %d needs at least %d control points", index,
             static_cast<long long>(count), degree, degree + 1);
    }
}

void check_knot_total(int64_t knot_count, int degree, int64_t count) {
    if (knot_count < 0 || knot_count - degree - 1 != count) { // neither side overflows
        fail(Status::size, "knot_count = %lld, expected count + degree + 1 = %llu",
             static_cast<long long>(knot_count),
             static_cast<unsigned long long>(count) + static_cast<unsigned long long>(degree) + 1);
    }
}

void check_finite_and_sorted(std::span<const double> knots, int axis, int64_t offset) {
    for (size_t i = 0; i < knots.size(); ++i) {
        const long long index = static_cast<long long>(i) + offset;
        if (!std::isfinite(knots[i])) {
            fail(Status::knot_not_finite, "knots[%lld] = %s%s is not finite", index, Number(knots[i]).text,
                 AxisText(axis).text);
        }
        if (i > 0 && knots[i] < knots[i - 1]) {
            fail(Status::knots_decreasing, "knots[%lld] = %s%s is smaller than knots[%lld] = %s", index,
                 Number(knots[i]).text, AxisText(axis).text, index - 1, Number(knots[i - 1]).text);
        }
    }
    if (!std::isfinite(knots.back() - knots.front())) {
        fail(Status::knot_not_finite,
             "knots%s: the range from knots[%lld] = %s to knots[%lld] = %s overflows", AxisText(axis).text,
             static_cast<long long>(offset), Number(knots.front()).text,
             static_cast<long long>(offset) + static_cast<long long>(knots.size()) - 1,
             Number(knots.back()).text);
    }
}

void check_knots(int degree, std::span<const double> knots, int axis, int64_t offset) {
    check_finite_and_sorted(knots, axis, offset);
    const auto first = static_cast<size_t>(degree);
    const size_t last = knots.size() - first - 1;
    if (knots[first] == knots[last]) {
        fail(Status::empty_domain, "knots[%lld] = knots[%lld] = %s%s: the domain is empty",
             static_cast<long long>(first) + offset, static_cast<long long>(last) + offset,
             Number(knots[first]).text, AxisText(axis).text);
    }
    check_multiplicities(degree, knots, axis, offset);
}

int64_t first_not_repeated(int degree, std::span<const double> knots) noexcept {
    const auto p = static_cast<size_t>(degree);
    const size_t count = knots.size() - p - 1;
    const size_t distinct = count - p;
    const double period = knots[count] - knots[p];
    // Each of the sums and differences below may be off by half an ulp of the largest knot.
    const double rounding = 4 * eps * std::max(std::abs(knots.front()), std::abs(knots.back()));
    for (size_t i = 0; i + distinct < knots.size(); ++i) {
        if (!(std::abs(knots[i + distinct] - knots[i] - period) <= rounding)) {
            return static_cast<int64_t>(i);
        }
    }
    return -1;
}

void check_periodic_knots(int degree, std::span<const double> knots, int axis, int64_t offset) {
    const int64_t wrong = first_not_repeated(degree, knots);
    if (wrong >= 0) {
        const auto i = static_cast<size_t>(wrong), p = static_cast<size_t>(degree);
        const size_t count = knots.size() - p - 1, distinct = count - p;
        const double period = knots[count] - knots[p];
        fail(Status::periodic_knots,
             "knots[%lld] = %s%s, expected knots[%lld] + period = %s on a periodic axis",
             static_cast<long long>(i + distinct) + offset, Number(knots[i + distinct]).text,
             AxisText(axis).text, static_cast<long long>(i) + offset, Number(knots[i] + period).text);
    }
}

KnotVectorPtr make_knot_vector(int degree, std::vector<double> knots, bool periodic, int axis,
                               int64_t offset) {
    check_degree(degree, axis);
    check_count(degree, static_cast<int64_t>(knots.size()) - degree - 1, axis);
    check_knots(degree, knots, axis, offset);
    if (periodic) {
        check_periodic_knots(degree, knots, axis, offset);
    }
    return std::make_shared<const KnotVector>(degree, std::move(knots), periodic);
}

constexpr int64_t work_of_a_group = 8; // for its memory

std::vector<KnotGroup> distinct_knots(std::span<const double> knots) {
    std::vector<KnotGroup> groups;
    for (const double knot : knots) {
        if (groups.empty() || groups.back().knot != knot) {
            count_work(work_of_a_group);
            groups.push_back({knot, 0});
        }
        ++groups.back().multiplicity;
    }
    return groups;
}

int multiplicity(std::span<const double> knots, double knot) noexcept {
    const auto [first, last] = std::equal_range(knots.begin(), knots.end(), knot);
    return static_cast<int>(last - first);
}

double greville(const KnotVector &axis, int64_t i) noexcept {
    const int p = axis.degree();
    if (p == 0) {
        return axis[i] + (axis[i + 1] - axis[i]) / 2;
    }
    double offset = 0;
    for (int j = 2; j <= p; ++j) {
        offset += axis[i + j] - axis[i + 1];
    }
    return axis[i + 1] + offset / p;
}

} // namespace nrb::inline basis
