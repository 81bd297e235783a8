// SPDX-License-Identifier: MIT
// The spline: an immutable tensor product of 1 to 3 parametric axes.
#pragma once

#include "base/error.h"
#include "base/lazy.h"
#include "base/limits.h"
#include "basis/knot_vector.h"
#include "basis/power_spans.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace nrb::inline spline {

// The form in which control points are stored, which is the one in which they were given.
enum class Form {
    polynomial,  // points of dim coordinates
    rational,    // points of dim coordinates, and separate weights
    homogeneous, // records of dim + 1: (w x, w y, ..., w)
};

class Spline;
using SplinePtr = std::shared_ptr<const Spline>;

class Spline {
public:
    using Axes = std::vector<KnotVectorPtr>;
    static constexpr size_t padding = 3; // doubles after the points and records

    // Preconditions: the sizes agree (points: product of counts times stored width; weights: product of
    // counts for Form::rational, else empty), and check_spline() accepts the values. Use make_spline() for
    // data from outside.
    Spline(Axes axes, int dim, Form form, std::vector<double> points, std::vector<double> weights);

    [[nodiscard]] int axes() const noexcept { return axis_count_; }
    [[nodiscard]] const KnotVector &axis(int k) const noexcept { return *axes_[static_cast<size_t>(k)]; }
    [[nodiscard]] const Axes &knot_vectors() const noexcept { return axes_; }
    [[nodiscard]] int64_t count(int k) const noexcept { return axis(k).count(); }
    [[nodiscard]] int64_t point_count() const noexcept { return point_count_; }
    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] Form form() const noexcept { return form_; }
    [[nodiscard]] bool rational() const noexcept { return form_ != Form::polynomial; }

    // The stored values. A stored record has dim values, or dim + 1 in Form::homogeneous.
    [[nodiscard]] std::span<const double> points() const noexcept {
        return std::span(points_).first(points_.size() - padding);
    }
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    [[nodiscard]] int stored_width() const noexcept { return form_ == Form::homogeneous ? dim_ + 1 : dim_; }

    // The records that kernels combine: (w x, w y, ..., w) if rational, (x, y, ...) if not. For
    // Form::rational they are a derived table, made at first use, in which all weights may be scaled by one
    // power of two. The `padding` doubles after them may be read, so that a vector of four doubles can be
    // loaded from any record on.
    [[nodiscard]] std::span<const double> records() const;
    // The exponent of the power of two by which the weights are divided in the records.
    [[nodiscard]] int records_exponent() const noexcept { return weight_exponent_; }
    [[nodiscard]] int width() const noexcept { return rational() ? dim_ + 1 : dim_; }

    // Writes components first, ..., first + size - 1 of record i, without using the table.
    void record_part(int64_t i, int first, int size, double *out) const noexcept;
    // Writes `count` records from `first` on, without using the table.
    void copy_records(int64_t first, int64_t count, double *out) const noexcept;
    // The table if it exists, or if `uses` further evaluations make it worth building; else null.
    [[nodiscard]] const double *records_after(int64_t uses) const;

    [[nodiscard]] double weight(int64_t i) const noexcept {
        return form_ == Form::polynomial ? 1 : weight_data()[i * weight_step()];
    }
    struct WeightRange {
        double smallest = 1;
        double largest = 1;
    };
    [[nodiscard]] WeightRange all_weights() const noexcept { return all_weights_; }
    // Whether all stored values are finite, and small enough that differences of records do not overflow.
    [[nodiscard]] bool moderate() const noexcept;
    // Coordinate c of Cartesian control point i. A homogeneous point is divided by its weight.
    [[nodiscard]] double coordinate(int64_t i, int c) const noexcept {
        const double stored = points_[static_cast<size_t>(i * stored_width() + c)];
        return form_ == Form::homogeneous ? stored / weight(i) : stored;
    }

    // The same shape, in which control points without influence have been moved to others that have
    // influence. A control point has no influence if its function vanishes on the domain, or if its weight is
    // 0 and it is not at infinity. Every function that derives a scale, a hull or a bound of rounding errors
    // from control points uses this spline. It is kept with the stored spline, and usually is the stored
    // spline itself.
    [[nodiscard]] const Spline &effective() const;

    // Whether span `span` of a curve, or every span of axis k of any spline, is evaluated from a power span.
    // The degree must be from 1 to max_power_span_degree. The weights (for an axis: those that have
    // influence) must be positive with a ratio of at most 4, so that rounding relative to the largest weight
    // is harmless. For a span of a curve, moreover, KnotVector::has_power_span() must hold, and differences
    // of its records must not overflow. Other spans are evaluated from Bernstein spans (curves) or by the
    // recurrences, whose basis functions have small relative errors.
    [[nodiscard]] bool has_power_span(int64_t span) const noexcept;
    [[nodiscard]] bool has_power_spans(int k) const noexcept {
        return even_weights_ && power_span_degree(axis(k).degree());
    }

    // The power spans of a curve, if they exist or if `uses` further evaluations make them worth building;
    // else null. Component c < width() of a power span is that of the records. The bounds of a span without a
    // power span are NaN; it has a Bernstein span if has_bernstein_span() says so.
    [[nodiscard]] const PowerSpans *power_spans_after(int64_t uses) const;
    // Computes a single power span without the table, with the same bits. points: working memory, [degree +
    // 1][lanes]. Precondition: has_power_span(span).
    void curve_power_span(int64_t span, double *points, double *power_span) const noexcept;
    // Whether a span of a curve that has no power span has a Bernstein span. No weight may be negative, and
    // neither products of control points nor inverse lengths of supports may overflow.
    [[nodiscard]] bool has_bernstein_span(int64_t span) const noexcept;
    // The same as curve_power_span() for a Bernstein span. Precondition: has_bernstein_span(span).
    void curve_bernstein_span(int64_t span, double *points, double *bernstein_span) const noexcept;
    // The number of components for spans of a curve, rounded up to whole vectors: those of records for power
    // spans, those of records with a weight for Bernstein spans, the only ones at degrees too high for power
    // spans.
    [[nodiscard]] int span_lanes() const noexcept {
        return PowerSpan::lanes(power_span_degree(axis(0).degree()) ? width() : dim_ + 1);
    }

    // What other rooms keep with a spline. Only they know the types. Each item is made at first use.
    enum class Cache {
        single_frame,
        single,
        derivative_errors,
        at_origin,
        grid,
        pieces,
        locator,
        lengths,
        magnitude,
        rays,
        count
    };
    using AnyCache = std::shared_ptr<const void>;
    [[nodiscard]] const Lazy<AnyCache> &slot(Cache cache) const noexcept {
        return slots_[static_cast<size_t>(cache)];
    }
    // Whether such an item, which costs as much as `cost` evaluations, is worth making after `uses` further
    // ones.
    [[nodiscard]] bool pays(int64_t uses, int64_t cost) const noexcept { return uses_.pay(uses, cost); }
    // The item in a slot that is never empty once filled; make() returns it as a std::shared_ptr.
    template <class T, class Make>
    [[nodiscard]] const T &kept(Cache cache, Make &&make) const {
        const AnyCache &found = slot(cache).get([&] { return AnyCache(std::shared_ptr<const T>(make())); });
        return *static_cast<const T *>(found.get());
    }

private:
    static bool even(WeightRange range) noexcept;
    void set_weights() noexcept;
    [[nodiscard]] WeightRange weight_range(int64_t first, int64_t count) const noexcept;
    [[nodiscard]] WeightRange active_weight_range() const noexcept;
    [[nodiscard]] bool moderate_window(int64_t span) const noexcept;
    [[nodiscard]] bool window_below(int64_t span, double points, double products) const noexcept;
    [[nodiscard]] SplinePtr without_inert_points() const;
    [[nodiscard]] PowerSpans curve_power_spans() const;
    void fill_power_spans(PowerSpans &power_spans, std::vector<double> &points) const;
    void copy_window(int64_t span, int lanes, double *weights, double *points) const noexcept;
    void low_power_span_of(int64_t span, double *points, double *power_span) const noexcept;
    void combine(int64_t span, const double *basis, const double *rests, double *points,
                 double *power_span) const noexcept;
    [[nodiscard]] const double *weight_data() const noexcept {
        return form_ == Form::rational ? weights_.data() : points_.data() + dim_;
    }
    [[nodiscard]] int64_t weight_step() const noexcept { return form_ == Form::rational ? 1 : dim_ + 1; }
    [[nodiscard]] double scaled_weight(int64_t i) const noexcept;

    Axes axes_;
    int axis_count_;
    int64_t point_count_;
    int dim_;
    Form form_;
    std::vector<double> points_; // and padding
    std::vector<double> weights_;
    int weight_exponent_ = 0;
    WeightRange all_weights_;
    bool even_weights_ = true; // for control points with influence
    bool inert_ = false;       // some control points have no influence
    Lazy<std::vector<double>> records_;
    Lazy<PowerSpans> power_spans_;
    Lazy<SplinePtr> effective_;
    std::array<Lazy<AnyCache>, static_cast<size_t>(Cache::count)> slots_;
    Uses uses_;
    mutable std::atomic<bool> moderate_{false}; // known to be true
};

// Throws Status::axes unless 1 <= axes <= max_axes.
void check_axes(int axes);
// Throws Status::dimension unless dim >= 1 and dim + 1, the width of a homogeneous record, fits an int32_t.
void check_dimension(int dim);

// Where values come from: those given by a caller have statuses of their own if they are not finite, computed
// ones have overflowed (Status::not_representable).
enum class Values { given, computed };

// Checks that all values are finite; that w(t) > 0 on the closed domain, or, for homogeneous weights, that
// some weight is not 0 in the support of every span; and that periodic axes wrap around. Throws Error naming
// the array, the index and the value.
void check_spline(const Spline &spline, Values values);

// The part of these checks that concerns single values, for Cartesian points and their weights, if any. It is
// for values that are rearranged before they become those of a spline, so that messages name the caller's
// indices.
void check_values(int dim, std::span<const double> points, std::span<const double> weights);

// A checked spline from validated axes and packed data. Throws Status::size if sizes disagree, and what
// check_spline() throws.
SplinePtr make_spline(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                      std::vector<double> weights = {});
// The same for computed values.
SplinePtr make_result(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                      std::vector<double> weights = {});
// The same, but null where make_result() would throw Status::weight_negative or weights_vanish.
SplinePtr make_result_if_valid(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                               std::vector<double> weights = {});

} // namespace nrb::inline spline
