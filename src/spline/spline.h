// SPDX-License-Identifier: MIT
// The spline: an immutable tensor-product value of 1 to 3 axes.
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

// How the control points are stored. They are kept as the caller gave them.
enum class Form {
    polynomial,  // points of dim coordinates
    rational,    // points of dim coordinates, and weights apart
    homogeneous, // records of dim + 1: (w x, w y, ..., w)
};

class Spline;
using SplinePtr = std::shared_ptr<const Spline>;

class Spline {
public:
    using Axes = std::vector<KnotVectorPtr>;
    static constexpr size_t padding = 3; // doubles after the points and records

    // Preconditions: sizes agree (points: product of counts times record width; weights: product of counts
    // for Form::rational, else empty) and the values satisfy check_spline(): use make_spline() for data from
    // outside.
    Spline(Axes axes, int dim, Form form, std::vector<double> points, std::vector<double> weights);

    [[nodiscard]] int axes() const noexcept { return axis_count_; }
    [[nodiscard]] const KnotVector &axis(int k) const noexcept { return *axes_[static_cast<size_t>(k)]; }
    [[nodiscard]] const Axes &knot_vectors() const noexcept { return axes_; }
    [[nodiscard]] int64_t count(int k) const noexcept { return axis(k).count(); }
    [[nodiscard]] int64_t point_count() const noexcept { return point_count_; }
    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] Form form() const noexcept { return form_; }
    [[nodiscard]] bool rational() const noexcept { return form_ != Form::polynomial; }

    // The stored values. Width of a stored point record: dim, or dim + 1 when homogeneous.
    [[nodiscard]] std::span<const double> points() const noexcept {
        return std::span(points_).first(points_.size() - padding);
    }
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    [[nodiscard]] int stored_width() const noexcept { return form_ == Form::homogeneous ? dim_ + 1 : dim_; }

    // The records that kernels contract: (w x, w y, ..., w) if rational, (x, y, ...) if not. For
    // Form::rational they are a derived table, built at first use, in which all weights may be scaled by one
    // power of two. `padding` doubles after them may be read, so that vectors of four can begin at any
    // record.
    [[nodiscard]] std::span<const double> records() const;
    // The power of two by which the weights are divided in the records.
    [[nodiscard]] int records_exponent() const noexcept { return weight_exponent_; }
    [[nodiscard]] int width() const noexcept { return rational() ? dim_ + 1 : dim_; }

    // Components [first, first + size) of record i, without the table.
    void record_part(int64_t i, int first, int size, double *out) const noexcept;
    // `count` records from `first` on, without the table.
    void copy_records(int64_t first, int64_t count, double *out) const noexcept;
    // The table if it exists, or if `uses` more evaluations make it worth having; else null.
    [[nodiscard]] const double *records_after(int64_t uses) const;

    [[nodiscard]] double weight(int64_t i) const noexcept {
        return form_ == Form::polynomial ? 1 : weight_data()[i * weight_step()];
    }
    struct WeightRange {
        double smallest = 1;
        double largest = 1;
    };
    [[nodiscard]] WeightRange all_weights() const noexcept { return all_weights_; }
    // Whether all stored values are finite and so far from overflow that differences of records are, too.
    [[nodiscard]] bool moderate() const noexcept;
    // Coordinate c of Cartesian control point i; homogeneous points are divided by their weight.
    [[nodiscard]] double coordinate(int64_t i, int c) const noexcept {
        const double stored = points_[static_cast<size_t>(i * stored_width() + c)];
        return form_ == Form::homogeneous ? stored / weight(i) : stored;
    }

    // The same shape, in which control points without influence are moved onto others that have some. They
    // are those whose function vanishes on the domain, and those of weight 0 that are not at infinity. Every
    // function that takes a scale, a hull or a bound of rounding from control points takes it from this
    // spline. It is kept with the stored spline, and usually is the stored spline itself.
    [[nodiscard]] const Spline &effective() const;

    // Whether span `span` of a curve, or every span of an axis of any spline, is evaluated from polynomial
    // power spans. The degree has to be at most max_power_span_degree. The weights (of an axis: the weights
    // that have influence) have to be positive with a ratio of at most 4, so that rounding relative to the
    // largest weight is harmless. For a curve, no difference of its records may overflow. Other spans use the
    // recurrences, whose basis functions are accurate relative to themselves.
    [[nodiscard]] bool has_power_span(int64_t span) const noexcept;
    [[nodiscard]] bool has_power_spans(int k) const noexcept {
        return even_weights_ && power_span_degree(axis(k).degree());
    }

    // The power spans of a curve, if they exist or if `uses` more evaluations make them worth having; else
    // null. Component c < width() of a power span is that of the records. A span without a power span has NaN
    // bounds; it has a Bernstein span if has_bernstein_span().
    [[nodiscard]] const PowerSpans *power_spans_after(int64_t uses) const;
    // The power span of one span without the table, with the same bits; points: [degree + 1][lanes], working
    // memory. Precondition: has_power_span(span).
    void curve_power_span(int64_t span, double *points, double *power_span) const noexcept;
    // Whether a span of a curve that has no power span has a Bernstein span: no weight may be negative, and
    // products may not overflow.
    [[nodiscard]] bool has_bernstein_span(int64_t span) const noexcept;
    // The same for a Bernstein span.
    void curve_bernstein_span(int64_t span, double *points, double *bernstein_span) const noexcept;
    // Components of the spans of a curve, rounded up: of records for power spans, of records with a weight for
    // Bernstein spans, which all spans are of degrees too high for power spans.
    [[nodiscard]] int span_lanes() const noexcept {
        return PowerSpan::lanes(power_span_degree(axis(0).degree()) ? width() : dim_ + 1);
    }

    // What other rooms keep with a spline. Only those rooms know the types; each thing is made at first use.
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
    // Whether such a thing is worth its cost, in evaluations, after `uses` more of them.
    [[nodiscard]] bool pays(int64_t uses, int64_t cost) const noexcept { return uses_.pay(uses, cost); }
    // What make() returns a std::shared_ptr of, for a slot that is never empty.
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
    bool even_weights_ = true; // of the control points that have influence
    bool inert_ = false;       // some control points have no influence
    Lazy<std::vector<double>> records_;
    Lazy<PowerSpans> power_spans_;
    Lazy<SplinePtr> effective_;
    std::array<Lazy<AnyCache>, static_cast<size_t>(Cache::count)> slots_;
    Uses uses_;
    mutable std::atomic<bool> moderate_{false}; // known to be
};

// 1 <= axes <= max_axes, else Status::axes.
void check_axes(int axes);
// 1 <= dim, and a homogeneous record still has a width; else Status::dimension.
void check_dimension(int dim);

// Points and weights that are not finite are either a mistake of the caller, with statuses of their own, or
// overflow of computed values: Status::not_representable.
enum class Values { given, computed };

// Checks finiteness, weights (w(t) > 0 on the closed domain, or some w_i != 0 in every support when
// homogeneous) and the wrapping of periodic axes; throws Error naming the array, the index and the value.
void check_spline(const Spline &spline, Values values);

// What of this concerns single values, of Cartesian points and their weights, if any: before they become those of a spline,
// in whose order others would be named.
void check_values(int dim, std::span<const double> points, std::span<const double> weights);

// A checked spline from validated axes and packed data; throws Status::size when sizes disagree.
SplinePtr make_spline(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                      std::vector<double> weights = {});
// The same for computed data.
SplinePtr make_result(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                      std::vector<double> weights = {});
// Null where make_result() would throw Status::weight_negative or weights_vanish.
SplinePtr make_result_if_valid(Spline::Axes axes, int dim, Form form, std::vector<double> points,
                               std::vector<double> weights = {});

} // namespace nrb::inline spline
