// SPDX-License-Identifier: MIT
#include "spline/spline.h"

#include "base/finite.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace nrb::inline spline {

namespace {

// The exponent of the power of two by which the weights are divided in the records. A common factor of the
// weights cancels. If the largest weight with influence (`active`) is outside 2^-256 to 2^256, a power of two
// brings it near 1; this is exact unless much smaller weights underflow. `all` is the largest of all weights,
// including those of control points without influence. These are no reason to scale, but must not overflow.
int common_exponent(double active, double all) noexcept {
    constexpr int harmless = 256;
    const int exponent = active > 0 ? std::ilogb(active) : 0;
    if (std::abs(exponent) <= harmless) {
        return 0;
    }
    return exponent > 0 ? exponent : std::min(std::ilogb(all), 0);
}

// Whether the products of weights with moderate points are moderate, too, given the largest weight.
bool moderate_products(double weight, std::span<const double> points) noexcept {
    constexpr double usual = moderate_product / moderate_limit;
    return weight <= usual || weight * largest_magnitude(points) < moderate_product;
}

// Appends the padding, without more capacity than that.
void pad(std::vector<double> &points) {
    if (points.capacity() < points.size() + Spline::padding) {
        points = copied_watched<double>(points, Spline::padding);
    }
    points.resize(points.size() + Spline::padding);
}

// Whether all layers of an axis are active, as those of a periodic axis always are.
bool all_active(const KnotVector &axis) noexcept {
    const auto [lower, upper] = axis.domain();
    return (axis[axis.degree() + 1] > lower && axis[axis.count() - 1] < upper) || axis.periodic();
}

int64_t points_of(const Spline::Axes &axes) noexcept {
    return std::accumulate(
        axes.begin(), axes.end(), int64_t{1},
        [](int64_t product, const KnotVectorPtr &axis) { return product * axis->count(); });
}

} // namespace

Spline::Spline(Axes axes, int dim, Form form, std::vector<double> points, std::vector<double> weights)
    : axes_(std::move(axes)), axis_count_(static_cast<int>(axes_.size())), point_count_(points_of(axes_)),
      dim_(dim), form_(form), points_(std::move(points)), weights_(std::move(weights)) {
    pad(points_);
    inert_ =
        !std::all_of(axes_.begin(), axes_.end(), [](const KnotVectorPtr &axis) { return all_active(*axis); });
    if (rational()) {
        set_weights();
    }
}

void Spline::set_weights() noexcept {
    all_weights_ = weight_range(0, point_count());
    const WeightRange active = inert_ ? active_weight_range() : all_weights_;
    even_weights_ = even(active);
    if (form_ != Form::rational) {
        return;
    }
    inert_ = inert_ || all_weights_.smallest == 0;
    weight_exponent_ = common_exponent(active.largest, all_weights_.largest);
}

bool Spline::moderate() const noexcept {
    if (!moderate_.load(std::memory_order_relaxed)) {
        const double largest = all_weights_.largest;
        const double scaled = weight_exponent_ == 0 ? largest : std::ldexp(largest, -weight_exponent_);
        const bool found =
            all_moderate(points()) && (form_ != Form::rational || moderate_products(scaled, points()));
        moderate_.store(found, std::memory_order_relaxed);
        return found;
    }
    return true;
}

std::span<const double> Spline::records() const {
    if (form_ != Form::rational) {
        return points();
    }
    const auto size = weights_.size() * static_cast<size_t>(width());
    const std::vector<double> &padded = records_.get([this, size] {
        std::vector<double> records(size + padding);
        for (int64_t i = 0; i < std::ssize(weights_); ++i) {
            record_part(i, 0, width(), records.data() + i * width());
        }
        return records;
    });
    return std::span(padded).first(size);
}

const double *Spline::records_after(int64_t uses) const {
    const bool ready = form_ != Form::rational || records_.peek() != nullptr;
    // Without the table, an evaluation computes the records of its own window.
    return ready || uses_.pay(uses, std::ssize(weights_) / 8) ? records().data() : nullptr;
}

void Spline::record_part(int64_t i, int first, int size, double *out) const noexcept {
    const double *point = points_.data() + i * stored_width() + first;
    if (form_ != Form::rational) {
        std::copy_n(point, size, out);
        return;
    }
    const double weight = scaled_weight(i);
    for (int c = 0; c < size; ++c) {
        out[c] = first + c == dim_ ? weight : weight * point[c];
    }
}

void Spline::copy_records(int64_t first, int64_t count, double *out) const noexcept {
    const double *point = points_.data() + first * stored_width();
    if (form_ != Form::rational) {
        std::copy_n(point, count * width(), out);
        return;
    }
    for (int64_t i = first; i < first + count; ++i) {
        const double weight = scaled_weight(i);
        for (int c = 0; c < dim_; ++c) {
            *out++ = weight * *point++;
        }
        *out++ = weight;
    }
}

double Spline::scaled_weight(int64_t i) const noexcept {
    const double stored = weights_[static_cast<size_t>(i)];
    return weight_exponent_ == 0 ? stored : std::ldexp(stored, -weight_exponent_);
}

} // namespace nrb::inline spline
