// SPDX-License-Identifier: MIT
#include "measure/length/length_table.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/scratch.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"
#include "numeric/sum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::measure {

namespace {

constexpr int most_steps = 100;
constexpr int64_t work_of_a_leaf = 30; // for storing it in the table
constexpr size_t max_row = max_product_degree + 1;

double value_of(const double *row, const double *basis, int degree) noexcept {
    double sum = row[0] * basis[0];
    for (int i = 1; i <= degree; ++i) {
        sum += row[i] * basis[i];
    }
    return sum;
}

} // namespace

LengthTable::LengthTable(const Spline &curve) : pieces_(curve, curve.axis(0).domain()) {
    const Integral whole = integrate(pieces_, 0, &leaves_, &nets_);
    error_ = whole.error;
    CompensatedSum sum;
    starts_.reserve(leaves_.size() + 1);
    params_.reserve(leaves_.size());
    end_speeds_.reserve(leaves_.size());
    for (const LengthLeaf &leaf : leaves_) {
        count_work(work_of_a_leaf);
        const Interval part = pieces_.interval(leaf.piece);
        params_.push_back(part.lower + leaf.lower * (part.upper - part.lower));
        starts_.push_back(sum.value());
        sum.add(leaf.length);
    }
    starts_.push_back(sum.value());
    std::vector<double> work(work_size());
    for (size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
        count_work(work_of_a_place());
        end_speeds_.push_back({speed(leaf, 0, work.data()), speed(leaf, 1, work.data())});
    }
}

const LengthTable &LengthTable::of(const Spline &curve) {
    return curve.kept<LengthTable>(Spline::Cache::lengths,
                                   [&] { return std::make_shared<const LengthTable>(curve); });
}

// The length over [lower, upper] of a leaf.
double LengthTable::part_length(size_t leaf, double lower, double upper, double *work) const noexcept {
    const SpeedForm &form = pieces_.form();
    std::copy_n(net(leaf), form.size(), work);
    double *row = work;
    for (int c = 0; c < form.dim; ++c, row += form.degree + 1) {
        restrict_to(form.degree, lower, upper, row);
    }
    if (form.weight_degree >= 0) {
        restrict_to(form.weight_degree, lower, upper, row);
    }
    return (upper - lower) * rule_length(form, work, leaves_[leaf].level);
}

double LengthTable::from_start(size_t leaf, double x, double *work) const noexcept {
    return x <= 0.5 ? part_length(leaf, 0, x, work) : leaves_[leaf].length - part_length(leaf, x, 1, work);
}

double LengthTable::speed(size_t leaf, double x, double *work) const noexcept {
    const SpeedForm &form = pieces_.form();
    const double *row = net(leaf);
    bernstein_functions(form.degree, x, work);
    double square = 0;
    for (int c = 0; c < form.dim; ++c, row += form.degree + 1) {
        const double y = value_of(row, work, form.degree);
        square += y * y;
    }
    if (form.weight_degree < 0) {
        return std::sqrt(square);
    }
    bernstein_functions(form.weight_degree, x, work);
    const double w = value_of(row, work, form.weight_degree);
    return std::sqrt(square) / (w * w);
}

size_t LengthTable::work_size() const noexcept {
    return static_cast<size_t>(pieces_.form().size()) + max_row;
}

int64_t LengthTable::work_of_a_place() const noexcept {
    return 16 * int64_t{pieces_.form().size()};
}

double LengthTable::length_at(double t, double *work) const noexcept {
    const auto next = std::upper_bound(params_.begin() + 1, params_.end(), t);
    const auto leaf = static_cast<size_t>(next - params_.begin() - 1);
    const LengthLeaf &at = leaves_[leaf];
    const Interval part = pieces_.interval(at.piece);
    const double u = (t - part.lower) / (part.upper - part.lower);
    const double x = std::clamp((u - at.lower) / (at.upper - at.lower), 0.0, 1.0);
    // At the end of a leaf, the tabulated sum is returned, and never exceeded before: that sum is rounded
    // differently.
    const double end = starts_[leaf + 1];
    return x == 1 ? end : std::min(starts_[leaf] + from_start(leaf, x, work), end);
}

double LengthTable::param_at(double length, double *work) const noexcept {
    // The first leaf that ends at or beyond the length.
    const auto end = std::lower_bound(starts_.begin() + 1, starts_.end() - 1, length);
    const auto leaf = static_cast<size_t>(end - starts_.begin() - 1);
    const LengthLeaf &at = leaves_[leaf];
    const double x = length <= starts_[leaf]       ? 0
                     : length >= starts_[leaf + 1] ? 1
                                                   : solve(leaf, length - starts_[leaf], work);
    const Interval part = pieces_.interval(at.piece);
    const double u = at.lower + x * (at.upper - at.lower);
    return u >= 1 ? part.upper : std::min(part.lower + u * (part.upper - part.lower), part.upper);
}

// Initial guess: the cubic Hermite interpolant of the inverse function on the leaf, with slopes limited so
// that it stays monotone.
double LengthTable::guess(size_t leaf, double part) const noexcept {
    const double whole = leaves_[leaf].length, share = part / whole, rest = 1 - share;
    const double first = std::min(whole / end_speeds_[leaf][0], 3.0);
    const double last = std::min(whole / end_speeds_[leaf][1], 3.0);
    const double x = share * share * (3 - 2 * share) + share * rest * (rest * first - share * last);
    return x > 0 && x < 1 ? x : share;
}

// The length between two places of a leaf. Over short steps, the error of Simpson's rule is at most
// step^5 / 2880 times the fourth derivative of the speed, which is below rounding on a leaf.
double LengthTable::step_length(size_t leaf, double from, double to, double speed_from, double speed_to,
                                double *work) const noexcept {
    constexpr double shortest = 1e-4;
    if (std::abs(to - from) < shortest) {
        return (to - from) * (speed_from + 4 * speed(leaf, from / 2 + to / 2, work) + speed_to) / 6;
    }
    return to > from ? part_length(leaf, from, to, work) : -part_length(leaf, to, from, work);
}

double LengthTable::solve(size_t leaf, double part, double *work) const noexcept {
    const double whole = leaves_[leaf].length;
    double lower = 0, upper = 1, x = guess(leaf, part);
    double length = from_start(leaf, x, work), slope = speed(leaf, x, work);
    for (int step = 0; step < most_steps; ++step) {
        const double rest = part - length;
        (rest > 0 ? lower : upper) = x;
        if (std::abs(rest) <= eps / 2 * (part + whole / 8)) {
            break;
        }
        double next = x + rest / slope;
        const bool newton = next > lower && next < upper;
        next = newton ? next : lower / 2 + upper / 2;
        if (next == x || (newton && std::abs(next - x) <= 1e-10 * x)) {
            return next; // Newton's method converges quadratically
        }
        const double slope_there = speed(leaf, next, work);
        length += step_length(leaf, x, next, slope, slope_there, work);
        x = next;
        slope = slope_there;
    }
    return x;
}

void LengthTable::check(double relative_tolerance, double part) const {
    const Integral result = scaled_result({total(), error_}, exponent(), relative_tolerance, "length");
    if (error_ >
        2 * std::max(relative_tolerance * std::min(part, total()), pieces_.rounding() + 8 * eps * total())) {
        fail(Status::not_converged, "length = %s: the error reached is %s, expected relative_tolerance = %s",
             Number(result.value).text, Number(result.error).text, Number(relative_tolerance).text);
    }
}

void curve_lengths(const Spline &curve, const ConstRecords &params, double relative_tolerance,
                   const Records &out) {
    const LengthTable &table = LengthTable::of(curve);
    table.check(relative_tolerance, table.total());
    Scratch work(table.work_size());
    double *rows = work.take(table.work_size());
    Steps steps(params.count);
    for (int64_t i = 0; i < params.count; ++i, steps.next(table.work_of_a_place())) {
        out(i, 0) = std::ldexp(table.length_at(params(i, 0), rows), table.exponent());
    }
}

void curve_params_at_lengths(const Spline &curve, const ConstRecords &lengths, double relative_tolerance,
                             bool clamp, const Records &out) {
    const LengthTable &table = LengthTable::of(curve);
    table.check(relative_tolerance, table.total());
    const double total = std::ldexp(table.total(), table.exponent());
    const double allowed = total + std::ldexp(table.error(), table.exponent()) + relative_tolerance * total;
    for (int64_t i = 0; i < lengths.count; ++i) {
        const double s = lengths(i, 0);
        if (std::isnan(s) || (!clamp && !(s >= 0 && s <= allowed))) {
            fail(Status::length, "lengths[%lld] = %s, expected a length in [0, %s]",
                 static_cast<long long>(i), Number(s).text, Number(total).text);
        }
    }
    Scratch work(table.work_size());
    double *rows = work.take(table.work_size());
    Steps steps(lengths.count);
    for (int64_t i = 0; i < lengths.count; ++i, steps.next(4 * table.work_of_a_place())) {
        const double s = std::clamp(std::ldexp(lengths(i, 0), -table.exponent()), 0.0, table.total());
        out(i, 0) = table.param_at(s, rows);
    }
}

} // namespace nrb::measure
