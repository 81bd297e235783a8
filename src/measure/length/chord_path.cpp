// SPDX-License-Identifier: MIT
#include "measure/length/chord_path.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::measure {

namespace {

constexpr int most_corrections = 6;
constexpr int64_t work_of_a_place = 100;
constexpr int64_t most_work = 2'000'000; // in evaluations of a curve of low degree

// The cost of an evaluation relative to that of a curve of low degree; at high degrees, derivatives come from
// recurrences.
int64_t cost_of_place(int degree) noexcept {
    return power_span_degree(degree) ? 1 : 1 + int64_t{degree} * degree / 15;
}
constexpr double shortest_chord = 1e-9; // relative to the chord

double largest(const std::vector<double> &x) noexcept {
    return std::accumulate(x.begin(), x.end(), 0.0,
                           [](double a, double b) { return std::max(a, std::abs(b)); });
}

// Scales x so that its largest component has magnitude 1.
void normalise(std::vector<double> &x) noexcept {
    const double size = largest(x);
    std::for_each(x.begin(), x.end(), [=](double &part) { part /= size; });
}

} // namespace

ChordPath::ChordPath(const Spline &curve, Interval range, std::vector<double> params, double chord,
                     double longest_step)
    : curve_(curve), range_(range), count_(params.size() - 1), params_(std::move(params)), chord_(chord),
      start_(chord), longest_step_(longest_step), length_(chord / 16),
      values_(2 * (count_ + 1) * static_cast<size_t>(curve.dim())), speeds_(count_ + 1), ahead_(count_),
      back_(count_), misses_(count_), tangent_(count_ + 1), change_(count_ + 1), diagonal_(count_),
      upper_(count_), border_(count_), right_(count_) {
    tangent_[0] = 1;
}

// Evaluates the chords and the derivatives of their lengths. False if a chord or a tangent vanishes, or if
// the parameters are not increasing.
bool ChordPath::evaluate() {
    const auto dim = static_cast<size_t>(curve_.dim());
    const auto count = static_cast<int64_t>(count_ + 1);
    eval::AxisRules rules{};
    rules[0].left = true; // the last parameter may be the end of the domain
    eval::evaluate_points(curve_, rules, 1, {params_.data(), count},
                          {values_.data(), count, 2 * curve_.dim(), 2 * curve_.dim()});
    const int64_t cost = count * cost_of_place(curve_.axis(0).degree());
    work_ += cost;
    count_work(work_of_a_place * cost);
    rounding_ = 0;
    for (size_t i = 0; i <= count_; ++i) {
        rounding_ = std::max(rounding_, 8 * eps * norm(values_.data() + 2 * i * dim, curve_.dim()));
        speeds_[i] = norm(values_.data() + (2 * i + 1) * dim, curve_.dim());
        if (!(speeds_[i] > 0) || (i > 0 && !(params_[i] > params_[i - 1]))) {
            return false;
        }
    }
    for (size_t i = 0; i < count_; ++i) {
        const double *from = values_.data() + 2 * i * dim, *to = from + 2 * dim;
        const double length = distance(from, to, curve_.dim());
        if (!(length > 0)) {
            return false;
        }
        double at_start = 0, at_end = 0;
        for (size_t c = 0; c < dim; ++c) {
            const double along = (to[c] - from[c]) / length;
            at_start += along * from[dim + c];
            at_end += along * to[dim + c];
        }
        back_[i] = at_start / speeds_[i];
        ahead_[i] = at_end / speeds_[i + 1];
        misses_[i] = length - chord_;
    }
    return true;
}

// Solves the bordered system ahead_i x_i - back_i x_(i-1) - x_0 = -misses_i (or 0), last . x = rhs, where x_0
// belongs to the chord and x_i to point i. Givens rotations turn the bidiagonal rows into upper triangular
// ones, so that pivots that may vanish occur only in the last two equations.
bool ChordPath::solve(const std::vector<double> &last, double rhs, bool residuals, std::vector<double> &out) {
    const size_t n = count_;
    double pivot = ahead_[0], border = -1, right = residuals ? -misses_[0] : 0;
    double factor = last[1], corner = last[0];
    for (size_t i = 0; i + 1 < n; ++i) {
        const double next_right = residuals ? -misses_[i + 1] : 0;
        const double size = std::hypot(pivot, back_[i + 1]);
        if (!(size > 0)) {
            return false;
        }
        const double c = pivot / size, s = -back_[i + 1] / size;
        diagonal_[i] = size;
        upper_[i] = s * ahead_[i + 1];
        border_[i] = c * border - s;
        right_[i] = c * right + s * next_right;
        pivot = c * ahead_[i + 1];
        border = -s * border - c;
        right = -s * right + c * next_right;
        const double share = factor / size;
        factor = last[i + 2] - share * upper_[i];
        corner -= share * border_[i];
        rhs -= share * right_[i];
    }
    const double determinant = pivot * corner - border * factor;
    out[0] = (pivot * rhs - factor * right) / determinant;
    out[n] = (right * corner - border * rhs) / determinant;
    for (size_t i = n - 1; i-- > 0;) {
        out[i + 1] = (right_[i] - upper_[i] * out[i + 2] - border_[i] * out[0]) / diagonal_[i];
    }
    return std::isfinite(largest(out));
}

// Moves the chain; false if a point leaves the range, or the chord is not positive.
bool ChordPath::move(const std::vector<double> &along, double by) {
    chord_ += by * along[0];
    bool inside = chord_ > 0;
    for (size_t i = 1; i <= count_; ++i) {
        params_[i] += by * along[i] / speeds_[i];
        inside = inside && params_[i] > range_.lower && params_[i] <= range_.upper;
    }
    return inside;
}

// Newton's method in the hyperplane last . x = 0. The corrections have to stay within `farthest`, which is
// halved after each one.
bool ChordPath::correct(const std::vector<double> &last, double tolerance, double farthest) {
    for (int i = 0; i < most_corrections; ++i) {
        if (!evaluate()) {
            return false;
        }
        if (largest(misses_) <= tolerance * chord_ + rounding_) {
            return true;
        }
        if (!solve(last, 0, true, change_) || largest(change_) > farthest || !move(change_, 1)) {
            return false;
        }
        farthest /= 2;
    }
    return false;
}

// Computes the direction in which the path goes on, with largest component 1. False if it differs much from
// the previous one: the corrections may then have reached another part of the path, or another path.
bool ChordPath::turn() {
    constexpr double least_cosine = 0.99;
    const std::vector<double> before = tangent_;
    if (!solve(before, 1, false, tangent_)) {
        return false;
    }
    normalise(tangent_);
    const int n = static_cast<int>(count_ + 1);
    const double product = std::inner_product(before.begin(), before.end(), tangent_.begin(), 0.0);
    return product >= least_cosine * norm(before.data(), n) * norm(tangent_.data(), n);
}

// A final step, after which the last point is at the end of the range.
bool ChordPath::finish(double tolerance) {
    std::vector<double> last(count_ + 1, 0.0);
    last[count_] = 1;
    const double by = (range_.upper - params_[count_]) * speeds_[count_] / tangent_[count_];
    move(tangent_, by);
    params_[count_] = range_.upper;
    return correct(last, tolerance, chord_ / 2) && params_[count_] == range_.upper;
}

// One step along the path; false unless the corrections are small compared to it.
bool ChordPath::step() {
    return move(tangent_, length_) && correct(tangent_, 1e-11, length_ / 16);
}

bool ChordPath::run(double relative_tolerance) {
    if (!evaluate() || !solve(tangent_, 1, false, change_)) {
        return false;
    }
    tangent_ = change_;
    normalise(tangent_);
    while (work_ < most_work && length_ > shortest_chord * chord_ && chord_ > start_ / 2) {
        const State before{params_, chord_, tangent_};
        const double to_end = (range_.upper - params_[count_]) * speeds_[count_];
        const bool last = tangent_[count_] > 0 && length_ * tangent_[count_] >= to_end;
        if (last && finish(std::max(relative_tolerance / 8, 16 * eps))) {
            return true;
        }
        if (!last && step() && turn()) {
            length_ = std::min(2 * length_, longest_step_ * chord_);
            continue;
        }
        params_ = before.params;
        chord_ = before.chord;
        tangent_ = before.tangent;
        length_ /= 4;
        if (!evaluate()) {
            return false;
        }
    }
    return false;
}

} // namespace nrb::measure
