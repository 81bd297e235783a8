// SPDX-License-Identifier: MIT
#include "closest/pair/parameter_map.h"

#include "closest/locator.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::closest {

namespace {

using Followers = std::array<ParameterMap::Follower, max_axes>;

// The linear map between two intervals. Ends map exactly to ends, and an interval to itself without rounding.
double moved(double t, Interval from, Interval to) noexcept {
    if (from.lower == to.lower && from.upper == to.upper) {
        return t;
    }
    const double fraction = (t - from.lower) / (from.upper - from.lower);
    return to.lower + fraction * (to.upper - to.lower);
}

} // namespace

pieces::LocalParam ParameterMap::operator()(const pieces::LocalParam &params) const noexcept {
    pieces::LocalParam image{};
    for (int k = 0; k < to_.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const auto &[axis, range] = followers_[at];
        const Interval domain = to_.axis(k).domain();
        const double t = axis < 0
                             ? range.lower
                             : moved(params[static_cast<size_t>(axis)], from_.axis(axis).domain(), range);
        image[at] = std::clamp(t, domain.lower, domain.upper);
    }
    return image;
}

std::vector<double> ParameterMap::breaks(int k) const {
    const Interval domain = from_.axis(k).domain();
    std::vector<double> breaks;
    for (int l = 0; l < to_.axes(); ++l) {
        const auto &[axis, range] = followers_[static_cast<size_t>(l)];
        if (axis != k || range.lower == range.upper) {
            continue;
        }
        for (const double t : refine::breaks_of(to_.axis(l))) {
            const double back = moved(t, range, domain);
            if (back > domain.lower && back < domain.upper) {
                breaks.push_back(back);
            }
        }
    }
    return breaks;
}

ParameterMap straight_map(const Spline &from, const Spline &to) {
    Followers followers;
    for (int k = 0; k < to.axes(); ++k) {
        followers[static_cast<size_t>(k)] = {k, to.axis(k).domain()};
    }
    return {from, to, followers};
}

namespace {

constexpr int samples = 3;
// Relative positions in the domain that no symmetry of the domain maps to each other.
constexpr double sample_shares[samples][max_axes] = {
    {0.31, 0.42, 0.58}, {0.77, 0.13, 0.36}, {0.08, 0.91, 0.65}};

// Tries candidate maps and keeps the one under which the sample points are nearest to their images.
class MapSearch {
public:
    // `rounding`: a misfit that cannot be distinguished from 0. `tolerance`: a map with a larger misfit is
    // useless.
    MapSearch(const Spline &from, const Spline &to, double rounding, double tolerance)
        : from_(from), to_(to), rounding_(rounding), misfit_(tolerance),
          image_(static_cast<size_t>(to.dim())) {
        for (size_t i = 0; i < samples; ++i) {
            params_[i] = at_shares(sample_shares[i]);
            points_[i].resize(static_cast<size_t>(from.dim()));
            evaluate(from, params_[i], points_[i]);
        }
    }

    [[nodiscard]] bool perfect() const noexcept { return best_ && misfit_ <= rounding_; }
    [[nodiscard]] std::optional<ParameterMap> best() const {
        return best_ ? std::optional<ParameterMap>(std::in_place, from_, to_, *best_) : std::nullopt;
    }

    // Tries the identity of parameters, which holds for parts extracted from a spline.
    void try_same_parameters() {
        Followers followers;
        for (int k = 0; k < to_.axes(); ++k) {
            const Interval own = from_.axis(k).domain(), other = to_.axis(k).domain();
            if (own.lower < other.lower || own.upper > other.upper) {
                return;
            }
            followers[static_cast<size_t>(k)] = {k, own};
        }
        offer(followers);
    }

    // Tries all maps from domain to domain.
    void try_whole() {
        std::array<int, max_axes> order{};
        std::iota(order.begin(), order.end(), 0);
        auto *const end = order.data() + from_.axes();
        do {
            for (unsigned turned = 0; turned < 1U << from_.axes() && !perfect(); ++turned) {
                offer(whole_followers(order, turned));
            }
        } while (std::next_permutation(order.data(), end));
    }

    // Tries a map onto a part of the other domain.
    void try_part(int64_t budget) {
        std::array<pieces::LocalParam, max_axes + 1> feet; // of a point, and of its neighbours on each axis
        for (int k = -1; k < from_.axes(); ++k) {
            std::array<double, max_axes> shares{nearer, nearer, nearer};
            if (k >= 0) {
                shares[static_cast<size_t>(k)] = farther;
            }
            if (!find_foot(at_shares(shares.data()), budget, feet[static_cast<size_t>(k + 1)])) {
                return;
            }
        }
        offer(part_followers(feet));
    }

private:
    static constexpr double nearer = 0.25, farther = 0.75;
    // Changes of a parameter up to this fraction of the domain count as rounding.
    static constexpr double standstill = 0x1p-30;

    static void evaluate(const Spline &spline, const pieces::LocalParam &params, std::vector<double> &point) {
        eval::evaluate_points(spline, {}, 0, {params.data(), 1, spline.axes(), spline.axes()},
                              {point.data(), 1, spline.dim(), spline.dim()});
    }

    [[nodiscard]] pieces::LocalParam at_shares(const double *shares) const noexcept {
        pieces::LocalParam params{};
        for (int k = 0; k < from_.axes(); ++k) {
            const auto [lower, upper] = from_.axis(k).domain();
            params[static_cast<size_t>(k)] = std::clamp(lower + shares[k] * (upper - lower), lower, upper);
        }
        return params;
    }

    void offer(const Followers &followers) {
        const ParameterMap map(from_, to_, followers);
        double misfit = 0;
        for (size_t i = 0; i < samples && misfit <= misfit_; ++i) {
            evaluate(to_, map(params_[i]), image_);
            misfit = larger(misfit, distance(image_.data(), points_[i].data(), to_.dim()));
        }
        if (misfit <= misfit_) {
            misfit_ = misfit;
            best_ = followers;
        }
    }
    // The larger number; NaN if either is NaN.
    static double larger(double a, double b) noexcept { return a >= b ? a : b; }

    [[nodiscard]] Followers whole_followers(const std::array<int, max_axes> &order,
                                            unsigned turned) const noexcept {
        Followers followers;
        for (int k = 0; k < to_.axes(); ++k) {
            const auto [lower, upper] = to_.axis(k).domain();
            followers[static_cast<size_t>(k)] = {order[static_cast<size_t>(k)], (turned >> k & 1) != 0
                                                                                    ? Interval{upper, lower}
                                                                                    : Interval{lower, upper}};
        }
        return followers;
    }

    // The nearest point, as exactly as a descent finds it; false if it is not near.
    [[nodiscard]] bool find_foot(const pieces::LocalParam &params, int64_t budget,
                                 pieces::LocalParam &found) {
        std::vector<double> point(static_cast<size_t>(from_.dim()));
        evaluate(from_, params, point);
        if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); })) {
            return false;
        }
        const Locator &locator = locator_of(to_);
        const Foot foot = locator.nearest({point.data(), nullptr, misfit_ / 4, budget});
        found = locator.local(point.data(), foot.params.data()).params;
        return foot.distance <= misfit_;
    }

    // Lets each axis of the image follow the axis of the origin along which it changes most.
    [[nodiscard]] Followers
    part_followers(const std::array<pieces::LocalParam, max_axes + 1> &feet) const noexcept {
        Followers followers;
        for (size_t a = 0; a < static_cast<size_t>(to_.axes()); ++a) {
            const auto [lower, upper] = to_.axis(static_cast<int>(a)).domain();
            ParameterMap::Follower &follower = followers[a];
            follower.image = {feet[0][a], feet[0][a]};
            double most = standstill * (upper - lower);
            for (int k = 0; k < from_.axes(); ++k) {
                const double change = feet[static_cast<size_t>(k) + 1][a] - feet[0][a];
                if (std::abs(change) > most) {
                    most = std::abs(change);
                    const double slope = change / (farther - nearer), start = feet[0][a] - nearer * slope;
                    follower = {k, {snapped(start, {lower, upper}), snapped(start + slope, {lower, upper})}};
                }
            }
        }
        return followers;
    }
    [[nodiscard]] static double snapped(double t, Interval domain) noexcept {
        const double near = standstill * (domain.upper - domain.lower);
        return std::abs(t - domain.lower) <= near   ? domain.lower
               : std::abs(t - domain.upper) <= near ? domain.upper
                                                    : t;
    }

    const Spline &from_, &to_;
    double rounding_;
    double misfit_; // largest distance of a sample from its image under the best map
    std::optional<Followers> best_;
    std::array<pieces::LocalParam, samples> params_{};
    std::array<std::vector<double>, samples> points_;
    std::vector<double> image_;
};

} // namespace

std::optional<ParameterMap> matching_map(const Spline &from, const Spline &to, double rounding,
                                         double tolerance, int64_t budget) {
    MapSearch search(from, to, rounding, rounding + tolerance);
    if (from.axes() == to.axes()) {
        search.try_same_parameters();
        search.try_whole();
    }
    if (!search.perfect()) {
        search.try_part(budget);
    }
    return search.best();
}

} // namespace nrb::closest
