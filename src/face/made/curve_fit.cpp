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
// How often a step is halved after which a copy of a place may be meant. At a pole that would never end.
constexpr int most_fit_halvings = 8;
// The numbers of errors that are sampled between two places: one and two more for each piece that is passed,
// so that there are always samples on both sides of the middle.
constexpr int64_t least_looks = 3, most_looks = 4096;

struct Place {
    double t;
    std::vector<double> x;
};

class IntervalFit {
public:
    IntervalFit(const CurveModel &model, std::span<const double> same, double tolerance, Effort &effort)
        : model_(model), dim_(static_cast<size_t>(model.dim())), same_(same), tolerance_(tolerance),
          effort_(effort) {}

    // start: the last place of the interval before; empty for the first interval.
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
    // The first interval begins in its middle, because its ends may be poles or lie on a seam.
    void begin(Interval range, const std::vector<double> &start) {
        const double middle = range.lower / 2 + range.upper / 2;
        if (start.empty()) {
            places_ = {{middle, std::vector<double>(dim_)}};
            model_.place(middle, nullptr, places_.front().x.data());
            walk_to(range.lower);
            std::ranges::reverse(places_);
        } else {
            places_ = {{range.lower, start}};
            walk_to(middle);
        }
        walk_to(range.upper);
    }
    // Goes from the last place to t, in steps short enough to tell copies of places apart. The places in
    // between are kept only if the curve goes so far around that a copy of one may be meant.
    void walk_to(double t) {
        const auto first = std::ssize(places_);
        const Place from = places_.back();
        const int64_t steps = model_.steps_between(from.t, t);
        for (int64_t i = 1; i <= steps; ++i) {
            step_to(i == steps
                        ? t
                        : from.t + (t - from.t) * (static_cast<double>(i) / static_cast<double>(steps)),
                    most_fit_halvings);
        }
        const auto passed = places_.begin() + first;
        if (std::none_of(passed, places_.end(), [&](const Place &place) {
                return model_.may_be_copy(from.x.data(), place.x.data());
            })) {
            places_.erase(passed, places_.end() - 1);
        }
    }
    void step_to(double t, int halvings) {
        const Place from = places_.back();
        std::vector<double> x(dim_);
        model_.place(t, from.x.data(), x.data());
        if (halvings > 0 && model_.may_be_copy(from.x.data(), x.data())) {
            step_to(from.t / 2 + t / 2, halvings - 1);
            step_to(t, halvings - 1);
        } else {
            places_.push_back({t, std::move(x)});
        }
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

    // Extrapolates open coordinates of the ends from their neighbours, and makes equal what agrees to same_.
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

    [[nodiscard]] int64_t looks(const Place &a, const Place &b) const {
        const int64_t pieces = model_.pieces_between(a.t, a.x.data(), b.t, b.x.data());
        return std::clamp(2 * pieces + 1, least_looks, most_looks);
    }
    // Between two parameters without a double in between nothing can be sampled, and a jump by a whole turn
    // there causes no error in space.
    void check_step(const Place &a, const Place &b) const {
        const double middle = a.t / 2 + b.t / 2;
        if ((middle == a.t || middle == b.t) && model_.may_be_copy(a.x.data(), b.x.data())) {
            fail(Status::not_converged, "the places beside the parameter %s are on different sides",
                 Number(a.t).text);
        }
    }
    // The middles of the intervals between places in which the error is too large; of all of them if the
    // candidate is a line whose error is too large. Sets the error of the candidate.
    [[nodiscard]] std::vector<double> too_far(FittedCurve &candidate) const {
        std::vector<double> params, more;
        std::vector<int64_t> counts;
        for (size_t i = 0; i + 1 < places_.size(); ++i) {
            const Place &a = places_[i], &b = places_[i + 1];
            counts.push_back(looks(a, b));
            for (int64_t j = 1; j <= counts.back(); ++j) {
                params.push_back(a.t + (b.t - a.t) *
                                           (static_cast<double>(j) / static_cast<double>(counts.back() + 1)));
            }
        }
        std::vector<double> errors(params.size());
        effort_.spend(std::ssize(params));
        model_.errors(*candidate.spline, params, errors.data());
        candidate.error = *std::max_element(errors.begin(), errors.end());
        auto first = errors.begin();
        for (size_t i = 0; i < counts.size(); ++i) {
            const double largest = *std::max_element(first, first + counts[i]);
            first += counts[i];
            check_step(places_[i], places_[i + 1]);
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
    Effort &effort_;
    std::vector<Place> places_;
};

} // namespace

FittedCurve fit_curve(const CurveModel &model, std::span<const double> breaks, std::span<const double> same,
                      double tolerance, Effort &effort) {
    IntervalFit interval(model, same, tolerance, effort);
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
