// SPDX-License-Identifier: MIT
#include "face/made/curve_fit.h"

#include "base/error.h"
#include "build/polylines.h"
#include "fit/interpolate.h"
#include "refine/parts/join.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::face {

namespace {

constexpr size_t most_places = 4096;
// Where errors are looked at between two places.
constexpr std::array<double, 3> between{0.25, 0.5, 0.75};

struct Place {
    double t;
    std::vector<double> x;
};

class IntervalFit {
public:
    IntervalFit(const CurveModel &model, std::span<const double> same, double tolerance)
        : model_(model), dim_(static_cast<size_t>(model.dim())), same_(same), tolerance_(tolerance) {}

    // The place at the start is that of the interval before, if there is one.
    FittedCurve fit(Interval range, const std::vector<double> &start) {
        begin(range, start);
        for (;;) {
            settle();
            FittedCurve candidate{spline(), 0};
            const std::vector<double> more = too_far(candidate);
            if (more.empty()) {
                return candidate;
            }
            if (places_.size() + more.size() > most_places) {
                fail(Status::not_converged, "%zu places leave an error of %s, expected at most %s",
                     places_.size(), Number(candidate.error).text, Number(tolerance_).text);
            }
            std::for_each(more.begin(), more.end(), [this](double t) { add(t); });
        }
    }
    [[nodiscard]] const std::vector<double> &end() const noexcept { return places_.back().x; }

private:
    // The middle first, because ends may be poles or lie on a seam.
    void begin(Interval range, const std::vector<double> &start) {
        places_.clear();
        const double middle = range.lower / 2 + range.upper / 2;
        std::vector<double> x(dim_);
        model_.place(middle, start.empty() ? nullptr : start.data(), x.data());
        places_ = {{range.lower, start}, {middle, x}, {range.upper, std::vector<double>(dim_)}};
        if (start.empty()) {
            places_.front().x.resize(dim_);
            model_.place(range.lower, x.data(), places_.front().x.data());
        }
        model_.place(range.upper, x.data(), places_.back().x.data());
    }
    void add(double t) {
        const auto after = std::upper_bound(places_.begin(), places_.end(), t,
                                            [](double a, const Place &b) { return a < b.t; });
        const Place &a = *(after - 1), &b = *after;
        std::vector<double> near(dim_), x(dim_);
        for (size_t k = 0; k < dim_; ++k) {
            near[k] = a.x[k] + (b.x[k] - a.x[k]) * ((t - a.t) / (b.t - a.t));
        }
        model_.place(t, near.data(), x.data());
        places_.insert(after, {t, x});
    }

    // Open coordinates go on as those of the neighbours do; coordinates that are the same are so bit for bit.
    void settle() {
        const size_t n = places_.size();
        for (const size_t i : {size_t{0}, n - 1}) {
            const int k = model_.open_coordinate(places_[i].x.data());
            if (k >= 0) {
                const Place &a = places_[i == 0 ? 1 : n - 2], &b = places_[i == 0 ? 2 : n - 3];
                const auto c = static_cast<size_t>(k);
                const double slope = n > 3 ? (a.x[c] - b.x[c]) / (a.t - b.t) : 0;
                places_[i].x[c] = a.x[c] + slope * (places_[i].t - a.t);
            }
        }
        for (size_t k = 0; k < dim_; ++k) {
            const auto less = [k](const Place &a, const Place &b) { return a.x[k] < b.x[k]; };
            const auto [low, high] = std::minmax_element(places_.begin(), places_.end(), less);
            const double lowest = low->x[k];
            if (high->x[k] - lowest <= same_[k]) {
                const double value = places_.front().x[k];
                std::for_each(places_.begin(), places_.end(), [&](Place &place) { place.x[k] = value; });
            }
        }
    }

    [[nodiscard]] SplinePtr spline() const {
        std::vector<double> params, points;
        for (const Place &place : places_) {
            if (places_.size() == 3 && &place == &places_[1]) {
                continue; // a line is tried first
            }
            params.push_back(place.t);
            points.insert(points.end(), place.x.begin(), place.x.end());
        }
        if (params.size() == 2) {
            return build::polyline(model_.dim(), points, params);
        }
        const std::vector<int64_t> counts{std::ssize(params)};
        fit::PointGrid grid;
        grid.counts = counts;
        grid.dim = model_.dim();
        grid.points = points;
        return fit::interpolate({3}, fit::layers_by_axis(counts, params), std::move(grid),
                                {{fit::End::not_a_knot, fit::End::not_a_knot}});
    }

    // Middles of the intervals between places in which the error is too large.
    [[nodiscard]] std::vector<double> too_far(FittedCurve &candidate) const {
        std::vector<double> params, more;
        for (size_t i = 0; i + 1 < places_.size(); ++i) {
            for (const double share : between) {
                params.push_back(places_[i].t + share * (places_[i + 1].t - places_[i].t));
            }
        }
        std::vector<double> errors(params.size());
        model_.errors(*candidate.spline, params, errors.data());
        for (size_t i = 0; i + 1 < places_.size(); ++i) {
            const auto first = errors.begin() + static_cast<std::ptrdiff_t>(i * between.size());
            const double largest = *std::max_element(first, first + between.size());
            candidate.error = std::max(candidate.error, largest);
            if (!(largest <= tolerance_) || (places_.size() == 3 && candidate.error > tolerance_)) {
                more.push_back(places_[i].t / 2 + places_[i + 1].t / 2);
            }
        }
        return more;
    }

    const CurveModel &model_;
    size_t dim_;
    std::span<const double> same_;
    double tolerance_;
    std::vector<Place> places_;
};

} // namespace

FittedCurve fit_curve(const CurveModel &model, std::span<const double> breaks, std::span<const double> same,
                      double tolerance) {
    IntervalFit interval(model, same, tolerance);
    std::vector<SplinePtr> parts;
    std::vector<double> start;
    double error = 0;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        const FittedCurve part = interval.fit({breaks[i], breaks[i + 1]}, start);
        parts.push_back(part.spline);
        error = std::max(error, part.error);
        start = interval.end();
    }
    return {parts.size() == 1 ? parts.front() : refine::join(parts, 0, {0, true}).spline, error};
}

} // namespace nrb::face
