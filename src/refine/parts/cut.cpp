// SPDX-License-Identifier: MIT
#include "refine/parts/cut.h"

#include "base/checked.h"
#include "base/watch.h"
#include "refine/knots/bezier_rows.h"
#include "refine/periodic/seam.h"

#include <algorithm>
#include <array>

namespace nrb::refine {

std::vector<double> saturated(int degree, std::span<const double> knots, std::span<const double> breaks) {
    const size_t order = static_cast<size_t>(degree) + 1;
    std::vector<double> fine;
    fine.reserve(knots.size() + breaks.size() * order);
    auto from = knots.begin();
    for (const double knot : breaks) {
        count_work(2 * (degree + 1));
        const auto first = std::find_if(from, knots.end(), [knot](double t) { return t >= knot; });
        fine.insert(fine.end(), from, first);
        fine.insert(fine.end(), order, knot);
        from = std::find_if(first, knots.end(), [knot](double t) { return t > knot; });
    }
    fine.insert(fine.end(), from, knots.end());
    return fine;
}

namespace {

// An axis cut at breaks: the refined axis with its table, and the layer at which each part begins (the last
// element is the end of the last part).
struct CutAxis {
    AxisTable whole;
    std::vector<int64_t> bounds;
};

// The bounds of the parts: a part begins at the layer whose index is that of the first copy of its break.
std::vector<int64_t> part_bounds(const std::vector<double> &fine, std::span<const double> breaks) {
    std::vector<int64_t> bounds;
    bounds.reserve(breaks.size());
    int64_t i = 0;
    for (const double knot : breaks) {
        while (fine[static_cast<size_t>(i)] < knot) {
            ++i;
        }
        bounds.push_back(i);
    }
    return bounds;
}

KnotVectorPtr part_axis(std::span<const double> fine, int degree, int64_t first, int64_t end) {
    const auto from = fine.begin() + first;
    return std::make_shared<const KnotVector>(degree,
                                              std::vector<double>(from, from + (end - first) + degree + 1));
}

CutAxis cut_at(const KnotVector &axis, std::span<const double> breaks, AxisEnds ends) {
    const int p = axis.degree();
    const std::vector<double> fine = saturated(
        p, axis.knots(),
        breaks.subspan(ends.lower ? 0 : 1, breaks.size() - (ends.lower ? 0 : 1) - (ends.upper ? 0 : 1)));
    const Refinement refinement(p, axis.knots(), fine);
    std::vector<int64_t> bounds = part_bounds(fine, breaks);
    const int64_t first = ends.lower ? bounds.front() : 0;
    const int64_t end = ends.upper ? bounds.back() : refinement.rows();
    bounds.front() = first;
    bounds.back() = end;
    for (int64_t &bound : bounds) {
        bound -= first;
    }
    return {{part_axis(fine, p, first, end), rows_of(refinement, first, end)}, std::move(bounds)};
}

// The spline with its axis cut, not yet separated into parts.
SplinePtr apply(const Spline &spline, int k, const CutAxis &cut) {
    return with_axis(spline, k, cut.whole);
}

// The layers of one axis that belong to a part, and the number of all layers.
struct Range {
    int64_t first;
    int64_t count;
    int64_t total;
};

// Copies the block of an array that belongs to one part on each axis.
std::vector<double> block(std::span<const double> values, const std::array<Range, max_axes> &ranges,
                          int64_t width) {
    const auto &[i, j, k] = ranges;
    std::vector<double> result;
    result.reserve(static_cast<size_t>(i.count * j.count * k.count * width) + Spline::padding);
    for (int64_t outer = i.first; outer < i.first + i.count; ++outer) {
        for (int64_t middle = j.first; middle < j.first + j.count; ++middle) {
            const auto from = values.begin() + ((outer * j.total + middle) * k.total + k.first) * width;
            result.insert(result.end(), from, from + k.count * width);
        }
    }
    return result;
}

} // namespace

SplinePtr cut_axis(const SplinePtr &spline, int axis, double lower, double upper, AxisEnds ends) {
    const Interval domain = spline->axis(axis).domain();
    const double breaks[] = {lower, upper};
    return apply(*spline, axis,
                 cut_at(spline->axis(axis), breaks,
                        {ends.lower || lower != domain.lower, ends.upper || upper != domain.upper}));
}

SplinePtr clamp_ends(const SplinePtr &spline, int axis, AxisEnds ends) {
    const KnotVector &knots = spline->axis(axis);
    ends = {ends.lower && !knots.clamped_start(), ends.upper && !knots.clamped_end()};
    const auto [lower, upper] = knots.domain();
    return ends.lower || ends.upper ? cut_axis(spline, axis, lower, upper, ends) : open_axis(spline, axis);
}

SplinePtr restrict_axis(const SplinePtr &spline, int axis, double lower, double upper) {
    const Interval domain = spline->axis(axis).domain();
    return lower == domain.lower && upper == domain.upper
               ? spline
               : cut_axis(spline, axis, lower, upper, {false, false});
}

PartedSpline::PartedSpline(SplinePtr whole, Bounds bounds)
    : whole_(std::move(whole)), bounds_(std::move(bounds)), size_(1) {
    for (int k = 0; k < axes(); ++k) {
        size_ = checked_product(size_, parts(k), "parts");
    }
}

SplinePtr PartedSpline::part(int64_t index) const {
    if (size_ == 1) {
        return whole_;
    }
    std::array<Range, max_axes> ranges{};
    ranges.fill({0, 1, 1}); // missing axes come first
    Spline::Axes axes = whole_->knot_vectors();
    for (int k = this->axes(); k-- > 0;) {
        const auto *bound = &bounds_[static_cast<size_t>(k)][static_cast<size_t>(index % parts(k))];
        index /= parts(k);
        ranges[static_cast<size_t>(max_axes - this->axes() + k)] = {bound[0], bound[1] - bound[0],
                                                                    whole_->count(k)};
        if (parts(k) > 1) {
            const KnotVector &axis = whole_->axis(k);
            axes[static_cast<size_t>(k)] = part_axis(axis.knots(), axis.degree(), bound[0], bound[1]);
        }
    }
    std::vector<double> weights;
    if (whole_->form() == Form::rational) {
        weights = block(whole_->weights(), ranges, 1);
    }
    return make_result(std::move(axes), whole_->dim(), whole_->form(),
                       block(whole_->points(), ranges, whole_->stored_width()), std::move(weights));
}

PartedSpline split_axis(const SplinePtr &spline, int axis, std::span<const double> breaks) {
    PartedSpline::Bounds bounds;
    for (int k = 0; k < spline->axes(); ++k) {
        bounds[static_cast<size_t>(k)] = {0, spline->count(k)};
    }
    if (breaks.size() == 2) {
        return {spline, bounds};
    }
    CutAxis cut = cut_at(spline->axis(axis), breaks, {false, false});
    bounds[static_cast<size_t>(axis)] = std::move(cut.bounds);
    return {apply(*spline, axis, cut), bounds};
}

std::vector<double> rough_knots(const KnotVector &axis, int order) {
    const auto [lower, upper] = axis.domain();
    std::vector<double> breaks{lower};
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (group.knot > lower && group.knot < upper && axis.degree() - group.multiplicity < order) {
            breaks.push_back(group.knot);
        }
    }
    breaks.push_back(upper);
    return breaks;
}

PartedSpline bezier_pieces(const SplinePtr &spline) {
    PartedSpline::Bounds bounds;
    SplinePtr whole = spline;
    for (int k = 0; k < spline->axes(); ++k) {
        const KnotVector &axis = spline->axis(k);
        const std::vector<double> breaks = breaks_of(axis);
        const int64_t order = axis.degree() + 1;
        whole =
            with_axis(*whole, k, bezier_knots(axis.degree(), breaks), order, [&](int64_t first, int64_t end) {
                return bezier_rows(axis, first / order, end / order);
            });
        std::vector<int64_t> &bound = bounds[static_cast<size_t>(k)];
        for (size_t e = 0; e < breaks.size(); ++e) {
            bound.push_back(static_cast<int64_t>(e) * (axis.degree() + 1));
        }
    }
    return {std::move(whole), std::move(bounds)};
}

} // namespace nrb::refine
