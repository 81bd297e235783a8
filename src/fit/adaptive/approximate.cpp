// SPDX-License-Identifier: MIT
#include "fit/adaptive/approximate.h"

#include "analysis/continuity.h"
#include "base/error.h"
#include "base/representable.h"
#include "base/watch.h"
#include "bounds/deviation.h"
#include "eval/evaluate.h"
#include "fit/adaptive/fit_tolerance.h"
#include "refine/degree/elevate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace nrb::fit {

namespace {

// Values of g at several places of every span, and at the ends of the domain.
class GridSamples {
public:
    // At least `least` on each axis; more where it has more spans.
    GridSamples(const Spline &g, const std::vector<int> &degrees, int64_t least) {
        const auto axes = static_cast<size_t>(g.axes());
        std::array<ConstRecords, max_axes> places{};
        for (size_t k = 0; k < axes; ++k) {
            const KnotVector &axis = g.axis(static_cast<int>(k));
            const int64_t for_a_span =
                std::max<int64_t>(std::max(axis.degree(), degrees[k]) + 2,
                                  (least + axis.spans().size() - 1) / axis.spans().size());
            add_places(axis, for_a_span, sites_[k]);
            places[k] = {sites_[k].data(), std::ssize(sites_[k]), 1, 1, 1};
            count_ *= std::ssize(sites_[k]);
        }
        values_.resize(static_cast<size_t>(count_ * g.dim()));
        eval::evaluate_grid(g, {}, 0, places, {values_.data(), count_, g.dim(), g.dim(), 1});
        require_representable(values_, "points");
        list_params(axes);
        const auto width = static_cast<int64_t>(axes);
        data_.params = {params_.data(), count_, width, width, 1};
        data_.values = {values_.data(), count_, g.dim(), g.dim(), 1};
    }
    GridSamples(const GridSamples &) = delete;
    GridSamples &operator=(const GridSamples &) = delete;

    [[nodiscard]] const Data &data() const noexcept { return data_; }
    [[nodiscard]] int64_t along(size_t axis) const noexcept { return std::ssize(sites_[axis]); }

private:
    static void add_places(const KnotVector &axis, int64_t count, std::vector<double> &sites) {
        const auto breaks = axis.spans().breaks();
        sites.push_back(breaks.front());
        for (size_t s = 0; s + 1 < breaks.size(); ++s) {
            for (int64_t j = 0; j < count; ++j) {
                const double angle = (static_cast<double>(j) + 0.5) / static_cast<double>(count);
                const double part = (1 - std::cos(std::numbers::pi * angle)) / 2;
                const double site = breaks[s] + part * (breaks[s + 1] - breaks[s]);
                if (site > sites.back() && site < breaks.back()) {
                    sites.push_back(site);
                }
            }
        }
        sites.push_back(breaks.back());
    }
    void list_params(size_t axes) {
        params_.reserve(static_cast<size_t>(count_) * axes);
        for (int64_t i = 0; i < count_; ++i) {
            const size_t first = params_.size();
            params_.resize(first + axes);
            int64_t rest = i;
            for (size_t k = axes; k-- > 0; rest /= std::ssize(sites_[k])) {
                params_[first + k] = sites_[k][static_cast<size_t>(rest % std::ssize(sites_[k]))];
            }
        }
    }

    std::array<std::vector<double>, max_axes> sites_;
    int64_t count_ = 1;
    std::vector<double> params_, values_;
    Data data_;
};

// The knots where a derivative of g of order at most `order` jumps along an axis; the last one may be the
// seam of a periodic axis, at the upper end.
std::vector<Break> breaks_of(const SplinePtr &g, int k, int degree, int order) {
    std::vector<Break> breaks;
    for (const analysis::KnotContinuity &knot : analysis::continuity(g, k, {0, 1e-9, 1e-9})) {
        if (knot.found.order < std::min(order, degree)) {
            breaks.push_back({knot.knot, std::max(1, degree - knot.found.order)});
        }
    }
    return breaks;
}

FitDomain domain_of(const SplinePtr &g, const std::vector<int> &degrees, int order) {
    FitDomain domain;
    domain.degrees = degrees;
    domain.find_breaks = false;
    for (int k = 0; k < g->axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        domain.domains.push_back(g->axis(k).domain());
        domain.periodic[at] = g->axis(k).periodic();
        domain.breaks[at] = breaks_of(g, k, degrees[at], order);
        if (!domain.breaks[at].empty() && domain.breaks[at].back().param == domain.domains[at].upper) {
            domain.seams[at] = domain.breaks[at].back().multiplicity;
            domain.breaks[at].pop_back();
        }
    }
    return domain;
}

// Conditions that keep the corners; none if an axis is periodic.
std::vector<FitCondition> corners(const Spline &g, const FitDomain &domain) {
    std::vector<FitCondition> conditions;
    for (int corner = 0; corner < 1 << g.axes(); ++corner) {
        FitCondition one{};
        eval::AxisRules rules{};
        for (int k = 0; k < g.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            if (domain.periodic[at]) {
                return {};
            }
            const bool upper = (corner >> k & 1) != 0;
            one.place[at] = upper ? domain.domains[at].upper : domain.domains[at].lower;
            rules[at].left = upper;
        }
        one.target.resize(static_cast<size_t>(g.dim()));
        eval::evaluate_points(g, rules, 0, {one.place.data(), 1, g.axes(), g.axes(), 1},
                              {one.target.data(), 1, g.dim(), g.dim(), 1});
        require_representable(one.target, "points");
        conditions.push_back(std::move(one));
    }
    return conditions;
}

// g itself, raised to the degrees, if it is polynomial and of no higher degrees.
std::optional<SplinePtr> same_spline(const SplinePtr &g, const std::vector<int> &degrees) {
    if (g->rational()) {
        return std::nullopt;
    }
    SplinePtr result = g;
    for (int k = 0; k < g->axes(); ++k) {
        const int more = degrees[static_cast<size_t>(k)] - g->axis(k).degree();
        if (more < 0) {
            return std::nullopt;
        }
        result = refine::elevate(result, k, more);
    }
    return result;
}

bool meets(const Approximation &found, double tolerance) noexcept {
    return found.spline != nullptr && found.bound <= tolerance;
}

class ApproximationSearch {
public:
    // Knots where a derivative of g of order at most `order` jumps are kept, as multiple ones. `needed`:
    // there is no other answer, so that the fit may take longer.
    ApproximationSearch(const SplinePtr &g, const std::vector<int> &degrees, double tolerance,
                        int64_t max_count, int order, bool needed)
        : g_(g), degrees_(degrees), tolerance_(tolerance), max_count_(max_count),
          domain_(domain_of(g, degrees, order)), needed_(needed) {
        wishes_.conditions = corners(*g, domain_);
    }

    // Without a spline if the limit of work came before the first fit.
    Approximation best() {
        (void)attempted([&] { search(); });
        return found_;
    }

private:
    // Aims at a smaller tolerance for the samples than for the rest of g.
    void search() {
        constexpr int most_rounds = 6;
        const bool volume = g_->axes() == max_axes;
        const int64_t most_samples = volume ? 400000 : 50000;
        double aim = 0.95 * tolerance_;
        int64_t least = volume ? 32 : 64;
        for (int round = 0; round < most_rounds && !meets(found_, tolerance_); ++round) {
            const GridSamples samples(*g_, degrees_, least);
            const double seconds = needed_ && found_.spline == nullptr ? 1 : 1.0 / 16;
            const ToleranceFit fit =
                fit_to_tolerance(samples.data(), {}, domain_, aim, max_count_, wishes_, seconds);
            const SplinePtr &made = fit.points.fit.spline;
            if (made == nullptr) {
                break;
            }
            const double bound = compare(made);
            const bool more = has_few(samples, *made) && samples.data().params.count < most_samples;
            if (!fit.reached && !more) {
                break;
            }
            least = more ? 2 * least : least;
            aim *= std::clamp(0.9 * tolerance_ / bound, 0.3, 0.9);
        }
    }
    // Keeps the closer spline; returns the bound for the new one.
    double compare(const SplinePtr &made) {
        std::optional<NeededWork> needed;
        if (found_.spline == nullptr) { // without a bound there is no answer
            needed.emplace();
        }
        const double bound = bounds::deviation(*made, *g_).upper;
        if (found_.spline == nullptr || bound < found_.bound) {
            found_ = {made, bound};
        }
        return bound;
    }
    // Whether there are so few samples for each control point that what lies between them is missed.
    [[nodiscard]] static bool has_few(const GridSamples &samples, const Spline &made) noexcept {
        constexpr int64_t few = 6;
        for (int k = 0; k < made.axes(); ++k) {
            if (samples.along(static_cast<size_t>(k)) < few * made.count(k)) {
                return true;
            }
        }
        return false;
    }

    const SplinePtr &g_;
    const std::vector<int> &degrees_;
    double tolerance_;
    int64_t max_count_;
    FitDomain domain_;
    FitWishes wishes_;
    bool needed_;
    Approximation found_{nullptr, INFINITY};
};

bool has_few_knots(const Spline &g) {
    constexpr size_t few = 64;
    size_t spans = 0;
    for (int k = 0; k < g.axes(); ++k) {
        spans += g.axis(k).spans().indices().size();
    }
    return spans > static_cast<size_t>(g.axes()) && spans <= few;
}

bool is_better(const Approximation &a, const Approximation &b, double tolerance) noexcept {
    if (meets(a, tolerance) != meets(b, tolerance)) {
        return meets(a, tolerance);
    }
    return meets(a, tolerance) ? a.spline->point_count() < b.spline->point_count() : a.bound < b.bound;
}

} // namespace

Approximation approximate(const SplinePtr &g, const std::vector<int> &degrees, double tolerance,
                          int64_t max_count) {
    const std::optional<SplinePtr> same = same_spline(g, degrees);
    const auto itself = [&] { // raising degrees causes rounding errors
        return Approximation{*same, *same == g ? 0 : bounds::deviation(**same, *g).upper};
    };
    if (same && tolerance == 0) {
        return itself();
    }
    const UsualLimit usual(5 * usual_work(g->point_count(), 100000) / 8);
    const int64_t own = same ? (*same)->point_count() : max_count;
    const bool itself_will_do = same && own <= max_count;
    int64_t limit = std::min(max_count, own); // a larger result would not be taken
    Approximation found{nullptr, INFINITY};
    const auto search = [&](int order) {
        const bool needed = !itself_will_do && found.spline == nullptr;
        const Approximation other = ApproximationSearch(g, degrees, tolerance, limit, order, needed).best();
        if (found.spline == nullptr || is_better(other, found, tolerance)) {
            found = other;
        }
    };
    if (has_few_knots(*g)) { // keep joints less smooth than those of the result
        const PartOfWork half;
        search(max_degree);
        limit = meets(found, tolerance) ? std::min(limit, found.spline->point_count()) : limit;
    }
    search(1);
    if (itself_will_do && (!meets(found, tolerance) || own <= found.spline->point_count())) {
        return itself();
    }
    if (found.spline == nullptr) { // keeping the kinks takes too many control points
        search(0);
    }
    if (found.spline == nullptr) {
        require_work();
        fail(Status::not_converged, "no approximation within the usual limit of work");
    }
    return found;
}

} // namespace nrb::fit
