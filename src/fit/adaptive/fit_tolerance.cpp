// SPDX-License-Identifier: MIT
#include "fit/adaptive/fit_tolerance.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "fit/adaptive/chosen_data.h"
#include "fit/adaptive/find_breaks.h"
#include "fit/adaptive/knot_density.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::fit {

namespace {

using Axes = std::vector<KnotVectorPtr>;

// The breaks, and those simple knots that are not near a break.
std::vector<Break> with_breaks(const std::vector<double> &inner, const std::vector<Break> &breaks) {
    constexpr double near = 0.25; // of the distance to the next knot
    std::vector<Break> all = breaks;
    for (size_t i = 0; i < inner.size(); ++i) {
        const double before = i > 0 ? inner[i] - inner[i - 1] : INFINITY;
        const double after = i + 1 < inner.size() ? inner[i + 1] - inner[i] : INFINITY;
        const double reach = near * std::min(before, after);
        if (std::ranges::none_of(breaks, [&](const Break &b) {
                return std::abs(b.param - inner[i]) <= (reach < INFINITY ? reach : 0);
            })) {
            all.push_back({inner[i], 1});
        }
    }
    std::ranges::sort(all, {}, &Break::param);
    return all;
}

std::vector<double> even_knots(Interval domain, int64_t spans) {
    std::vector<double> knots;
    for (int64_t i = 1; i < spans; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(spans);
        const double knot = domain.lower * (1 - part) + domain.upper * part;
        if (knot > (knots.empty() ? domain.lower : knots.back()) && knot < domain.upper) {
            knots.push_back(knot);
        }
    }
    return knots;
}

// The number of control points, periodic copies included.
int64_t count_of(const Axes &axes) noexcept {
    int64_t count = 1;
    for (const KnotVectorPtr &axis : axes) {
        count *= axis->count();
    }
    return count;
}

int64_t unknowns_of(const Axes &axes) noexcept {
    int64_t count = 1;
    for (const KnotVectorPtr &axis : axes) {
        count *= axis->distinct_layers();
    }
    return count;
}

class ToleranceSearch {
public:
    ToleranceSearch(const Data &data, const FitDomain &domain, double tolerance, int64_t max_count,
                    const FitWishes &wishes)
        : all_(data), domain_(domain), tolerance_(tolerance), max_count_(max_count), wishes_(wishes),
          breaks_(domain.breaks) {
        wishes_.regularise = true;
        if (count_of(even_axes(1)) > max_count) { // there is no room for the known breaks
            breaks_ = {};
            domain_.seams = FitDomain{}.seams;
        }
    }

    // If the limit of work ends the search, all data are fitted once over the best knots found so far, unless
    // that takes longer than `seconds_for_one`. A limit of the caller counts instead of these seconds.
    ToleranceFit fit(double seconds_for_one) {
        {
            const PartOfWork half;
            (void)attempted([&] { search(); });
        }
        if (best_.rounds == 0) {
            const NeededWork needed;
            const bool counted = !needed.is_free(); // against a limit of the caller, then the only one
            Axes axes = met_.axes.empty() ? even_axes(1) : met_.axes;
            if (!counted && !takes(seconds_for_one, axes)) {
                axes = even_axes(1);
            }
            if (counted || takes(seconds_for_one, axes)) {
                keep_better(fit_points(all_, rules_, axes, wishes_, true));
            }
        }
        return std::move(best_);
    }

private:
    // The number of data that are looked at first.
    [[nodiscard]] int64_t some() const noexcept { return domain_.degrees.size() == 1 ? 2000 : 20000; }
    static constexpr int64_t most_of_grid = 8100; // control points of grids, whose equations take longest

    // Whether a fit of all data takes at most about `seconds`: the fill-in of the factors of its equations
    // grows with the number of axes.
    [[nodiscard]] bool takes(double seconds, const Axes &axes) const noexcept {
        constexpr std::array<double, max_axes> unknowns_in_a_second{1e6, 20000, 6000};
        constexpr double sums_in_a_second = 5e8;
        double functions = 1, products = 1;
        for (const KnotVectorPtr &axis : axes) {
            functions *= axis->degree() + 1;
            products *= 2 * axis->degree() + 1;
        }
        const double sums = static_cast<double>(all_.params.count) *
                            (products + functions * static_cast<double>(all_.values.width));
        return sums <= seconds * sums_in_a_second &&
               static_cast<double>(unknowns_of(axes)) <= seconds * unknowns_in_a_second[axes.size() - 1];
    }

    // With more and more of the data, until knots that are enough for them are enough for all.
    void search() {
        constexpr int64_t for_each_unknown = 12, more = 8;
        int64_t size = std::min(all_.params.count, some());
        for (;;) {
            const PackedData subset = some_of(all_, size);
            const bool reached = find_densities(subset.data());
            const bool whole = size == all_.params.count;
            if (!reached && !whole) {
                size = std::min(all_.params.count, 4 * size);
                continue;
            }
            const Counts counts = fewest(subset.data());
            const int64_t wanted = for_each_unknown * unknowns_of(axes_with(counts));
            if (!whole && size < wanted) {
                size = std::min(all_.params.count, 2 * wanted);
                continue;
            }
            finish(counts);
            if (whole || best_.reached) {
                return;
            }
            size = std::min(all_.params.count, more * size);
        }
    }

    // Finds the knot densities by a fit over uniform spans, with the breaks that it shows. Returns whether
    // that fit is within the tolerance of `data`, some of all data. Where that takes many spans, fewer may be
    // enough with the breaks shown by the last fit that was not within the tolerance.
    bool find_densities(const Data &data) {
        even_ = even_fit(data);
        while (domain_.find_breaks && domain_.degrees.size() == 1 && even_.missed != nullptr &&
               improved_by_breaks(data)) {
        }
        densities_.clear();
        for (size_t k = 0; k < domain_.degrees.size(); ++k) {
            densities_.emplace_back(even_.spline, static_cast<int>(k));
        }
        return even_.largest <= tolerance_;
    }
    bool improved_by_breaks(const Data &data) {
        const std::vector<Break> before = breaks_[0];
        if (!add_breaks(data)) {
            return false;
        }
        EvenFit with = even_fit(data);
        const bool does = with.largest <= tolerance_, did = even_.largest <= tolerance_;
        const bool better = does != did ? does
                            : did       ? with.unknowns < even_.unknowns
                                        : with.largest < even_.largest;
        if (did && !better) {
            breaks_[0] = before;
            return false;
        }
        even_ = std::move(with);
        return better;
    }
    bool add_breaks(const Data &data) {
        const double span =
            (domain_.domains[0].upper - domain_.domains[0].lower) / static_cast<double>(even_.missed_spans);
        const BreakSearch search(data, distances(data, *even_.missed), domain_.degrees[0], span, tolerance_);
        const std::vector<Break> found = search.breaks(all_), known = breaks_[0];
        for (const Break &one : found) {
            std::erase_if(breaks_[0],
                          [&](const Break &old) { return std::abs(old.param - one.param) <= span; });
            breaks_[0].push_back(one);
        }
        if (count_of(even_axes(1)) > max_count_) {
            breaks_[0] = known;
            return false;
        }
        return !found.empty();
    }
    [[nodiscard]] std::vector<double> distances(const Data &data, const Spline &spline) const {
        const int64_t n = data.params.count, dim = spline.dim();
        std::vector<double> points(static_cast<size_t>(n * dim)), result;
        eval::AxisRules rules = rules_;
        rules[0].nan = true;
        eval::evaluate_points(spline, rules, 0, data.params, {points.data(), n, dim, dim, 1});
        for (int64_t i = 0; i < n; ++i) {
            result.push_back(norm_of(static_cast<int>(dim), [&](int c) {
                return points[static_cast<size_t>(i * dim + c)] - data.values(i, c);
            }));
        }
        return result;
    }
    // The numbers of inner knots on each axis.
    using Counts = std::vector<int64_t>;

    // The smallest numbers of inner knots that are enough for the data, or the largest ones that are allowed:
    // first on all axes at once, then on one after the other, because a density found where an axis needs no
    // knots is noise.
    [[nodiscard]] Counts fewest(const Data &data) {
        const int64_t most = largest_level(data);
        int64_t above = std::min(even_.spans, most), below = -1;
        while (above < most && !enough(counts_at(above), data)) { // uniform spans were better
            below = above;
            above = std::min(most, above + above / 4 + 1);
        }
        above = smallest(below, above, [&](int64_t level) { return enough(counts_at(level), data); });
        Counts counts = counts_at(above);
        for (size_t k = 0; counts.size() > 1 && k < counts.size(); ++k) {
            counts[k] = smallest(-1, counts[k], [&](int64_t count) {
                Counts fewer = counts;
                fewer[k] = count;
                return enough(fewer, data);
            });
        }
        return counts;
    }
    // Bisection for the smallest number above `below` that passes the test; `above` is taken to pass it.
    template <class Test>
    static int64_t smallest(int64_t below, int64_t above, Test &&test) {
        while (below + 1 < above) {
            const int64_t middle = below + (above - below) / 2;
            (test(middle) ? above : below) = middle;
        }
        return above;
    }
    // The fit over the first of 1, 2, 4, ... uniform spans that are enough, or over the largest number that
    // is allowed.
    struct EvenFit {
        int64_t spans, unknowns;
        SplinePtr spline;
        double largest;
        SplinePtr missed; // the last fit that was not within the tolerance
        int64_t missed_spans;
    };
    [[nodiscard]] EvenFit even_fit(const Data &data) {
        EvenFit found{};
        int64_t before = 0;
        for (int64_t spans = 1;; spans *= 2) {
            const Axes axes = even_axes(spans);
            const bool no_more_doubles = unknowns_of(axes) == before;
            if (no_more_doubles || (spans > 1 && too_many(axes, data))) {
                if (found.spline == nullptr) { // the conditions contradict each other: report it
                    (void)fit_points(data, rules_, even_axes(spans / 2), wishes_, true);
                }
                return found;
            }
            before = unknowns_of(axes);
            const FittedPoints fine = attempt(data, axes);
            found.spans = spans;
            found.unknowns = before;
            found.spline = fine.fit.spline;
            found.largest = fine.largest;
            if (fine.largest <= tolerance_) {
                return found;
            }
            found.missed = fine.fit.spline;
            found.missed_spans = spans;
        }
    }
    [[nodiscard]] bool enough(const Counts &counts, const Data &data) {
        return attempt(data, axes_with(counts)).largest <= tolerance_;
    }
    // Returns no spline where there are too few control points for the conditions. Its distance is then NaN,
    // which is within no tolerance, even an infinite one.
    [[nodiscard]] FittedPoints attempt(const Data &data, const Axes &axes) {
        try {
            FittedPoints made = fit_points(data, rules_, axes, wishes_, true);
            note(axes, made.largest);
            return made;
        } catch (const Error &error) {
            if (error.status() != Status::contradiction) {
                throw;
            }
            return {{}, 0, NAN, -1};
        }
    }
    // Keeps the axes with the fewest knots that are enough, or else those that miss the data least.
    void note(const Axes &axes, double largest) {
        const bool does = largest <= tolerance_, did = met_.largest <= tolerance_;
        const bool better = does != did ? does
                            : does      ? unknowns_of(axes) < unknowns_of(met_.axes)
                                        : largest < met_.largest;
        if (better || met_.axes.empty()) {
            met_ = {axes, largest};
        }
    }
    [[nodiscard]] int64_t largest_level(const Data &data) const {
        const auto allowed = [&](int64_t level) { return !too_many(axes_with(counts_at(level)), data); };
        int64_t below = 0, above = 1;
        while (above <= data.params.count && allowed(above)) {
            below = above;
            above *= 2;
        }
        return smallest(below, above, [&](int64_t level) { return !allowed(level); }) - 1;
    }

    // Fits all data, with more knots if these are not enough.
    void finish(Counts counts) {
        constexpr int most_rounds = 4;
        for (int round = 1; round <= most_rounds; ++round) {
            const Axes axes = axes_with(counts);
            if (round > 1 && too_many(axes, all_)) {
                break;
            }
            keep_better(round == 1 ? fit_points(all_, rules_, axes, wishes_, true) : attempt(all_, axes));
            if (best_.reached) {
                break;
            }
            for (int64_t &count : counts) {
                count += std::max<int64_t>(1, count / 50) * (int64_t{1} << round) / 2;
            }
        }
    }
    void keep_better(FittedPoints one) {
        if (best_.rounds == 0 || one.largest < best_.points.largest) {
            best_.points = std::move(one);
        }
        ++best_.rounds;
        best_.reached = best_.points.largest <= tolerance_;
    }

    [[nodiscard]] Axes even_axes(int64_t spans) const {
        Axes axes;
        for (size_t k = 0; k < domain_.degrees.size(); ++k) {
            axes.push_back(
                axis_over(domain_, k, with_breaks(even_knots(domain_.domains[k], spans), breaks_[k])));
        }
        return axes;
    }
    // `level` inner knots along the axis that needs most; along others fewer, in proportion to what they
    // need.
    [[nodiscard]] Counts counts_at(int64_t level) const {
        double most = 0;
        for (const KnotDensity &density : densities_) {
            most = std::max(most, density.content());
        }
        Counts counts;
        for (const KnotDensity &density : densities_) {
            counts.push_back(
                static_cast<int64_t>(std::ceil(density.content() / most * static_cast<double>(level))));
        }
        return counts;
    }
    [[nodiscard]] Axes axes_with(const Counts &counts) const {
        Axes axes;
        for (size_t k = 0; k < counts.size(); ++k) {
            axes.push_back(axis_over(domain_, k, with_breaks(densities_[k].knots(counts[k]), breaks_[k])));
        }
        return axes;
    }
    // Also true where knots are nearly as close together as data: with many data the fit would follow noise,
    // and with some of the data others lie between.
    [[nodiscard]] bool too_many(const Axes &axes, const Data &data) const noexcept {
        const int64_t for_each_unknown = all_.params.count > some() ? 3 : 1;
        const int64_t told = data.params.count + std::ssize(wishes_.conditions);
        return count_of(axes) > max_count_ || for_each_unknown * unknowns_of(axes) > told ||
               (axes.size() > 1 && unknowns_of(axes) > most_of_grid);
    }

    const Data &all_;
    eval::AxisRules rules_{}; // none: the data are clean
    FitDomain domain_;
    double tolerance_;
    int64_t max_count_;
    FitWishes wishes_;
    EvenFit even_{};
    std::array<std::vector<Break>, max_axes> breaks_;
    std::vector<KnotDensity> densities_;
    struct {
        Axes axes;
        double largest;
    } met_{}; // the best so far, for some of the data
    ToleranceFit best_{};
};

} // namespace

ToleranceFit fit_to_tolerance(const Data &data, const eval::AxisRules &rules, const FitDomain &domain,
                              double tolerance, int64_t max_count, const FitWishes &wishes,
                              double seconds_for_one) {
    // Checks all data, so that an error in one is reported with its index.
    check_data(*form_for(data, rules, simplest_axes(domain)), data, rules);
    const UsualLimit usual(usual_work(data.params.count, 200000));
    const auto search = [&](const Data &clean) {
        return ToleranceSearch(clean, domain, tolerance, max_count, wishes).fit(seconds_for_one);
    };
    if (is_clean(data, rules)) {
        return search(data);
    }
    const CleanData clean(data, rules, domain.domains);
    ToleranceFit found = search(clean.packed.data());
    int64_t &largest = found.points.largest_index; // index in the caller's data
    largest = largest < 0 ? largest : clean.indices[static_cast<size_t>(largest)];
    return found;
}

} // namespace nrb::fit
