// SPDX-License-Identifier: MIT
#include "measure/closed_chains.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::measure {

namespace {

constexpr int64_t work_of_a_pair = 16;
constexpr int64_t none = -1;

struct CurveEnd {
    int64_t curve;
    std::vector<double> place;
};

// Appends the starts and ends of the parts between jumps. A periodic curve has no end at its seam.
void add_ends(const Spline &curve, int64_t number, std::vector<CurveEnd> &starts,
              std::vector<CurveEnd> &ends) {
    const KnotVector &axis = curve.axis(0);
    const auto [lower, upper] = axis.domain();
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        const bool jump = group.multiplicity > axis.degree(),
                   outer = group.knot == lower || group.knot == upper;
        if (group.knot < lower || group.knot > upper || !(jump || (outer && !axis.periodic()))) {
            continue;
        }
        if (group.knot > lower) {
            ends.push_back({number, eval::curve_point(curve, group.knot, true)});
        }
        if (group.knot < upper) {
            starts.push_back({number, eval::curve_point(curve, group.knot, false)});
        }
    }
}

double gap_between(const CurveEnd &a, const CurveEnd &b) noexcept {
    return distance(a.place.data(), b.place.data(), 2);
}

// Gives each end a start of its own, by augmenting paths (H. W. Kuhn, "The Hungarian method for the
// assignment problem", 1955): an end may take the start of another one that can take a third.
class ChainMatch {
public:
    ChainMatch(std::vector<CurveEnd> starts, std::vector<CurveEnd> ends, double tolerance)
        : starts_(std::move(starts)), ends_(std::move(ends)), tolerance_(tolerance) {
        std::erase_if(starts_, [](const CurveEnd &start) { return !all_finite(start.place); });
        std::ranges::sort(starts_, {}, x_of);
        owners_.assign(starts_.size(), none);
        askers_.assign(starts_.size(), none);
        taken_.assign(ends_.size(), none);
        count_work(work_of_a_pair * std::ssize(ends_));
    }

    void check() {
        for (int64_t end = 0; end < std::ssize(ends_); ++end) {
            if (!give_start(end)) {
                refuse(ends_[static_cast<size_t>(end)]);
            }
        }
    }

private:
    static double x_of(const CurveEnd &end) noexcept { return end.place[0]; }

    // Searches breadth first over the ends that would have to take another start.
    bool give_start(int64_t end) {
        asked_.clear();
        std::vector<int64_t> waiting{end};
        int64_t found = none;
        for (size_t i = 0; i < waiting.size() && found == none; ++i) {
            found = ask_starts(waiting[i], waiting);
        }
        for (int64_t start = found; start != none;) {
            const int64_t asker = askers_[static_cast<size_t>(start)];
            owners_[static_cast<size_t>(start)] = asker;
            std::swap(start, taken_[static_cast<size_t>(asker)]);
        }
        for (const size_t start : asked_) {
            askers_[start] = none;
        }
        return found != none;
    }

    // Returns a start within the tolerance that is free, or appends the ends that have those starts.
    int64_t ask_starts(int64_t asker, std::vector<int64_t> &waiting) {
        const CurveEnd &end = ends_[static_cast<size_t>(asker)];
        const double x = x_of(end);
        const auto first = std::ranges::partition_point(
            starts_, [&](const CurveEnd &start) { return x - x_of(start) > tolerance_; });
        for (auto start = first; start != starts_.end() && x_of(*start) - x <= tolerance_; ++start) {
            count_work(work_of_a_pair);
            const auto at = static_cast<size_t>(start - starts_.begin());
            if (askers_[at] != none || !(gap_between(*start, end) <= tolerance_)) {
                continue;
            }
            askers_[at] = asker;
            asked_.push_back(at);
            if (owners_[at] == none) {
                return static_cast<int64_t>(at);
            }
            waiting.push_back(owners_[at]);
        }
        return none;
    }

    [[noreturn]] void refuse(const CurveEnd &end) const {
        double gap = infinity;
        for (const CurveEnd &start : starts_) {
            gap = std::min(gap, gap_between(start, end));
        }
        if (gap <= tolerance_) {
            fail(Status::gap, "curves[%lld] ends where more curves end than start within tolerance = %s",
                 static_cast<long long>(end.curve), Number(tolerance_).text);
        }
        fail(Status::gap, "curves[%lld] ends %s from the nearest start, expected at most tolerance = %s",
             static_cast<long long>(end.curve), Number(gap).text, Number(tolerance_).text);
    }

    std::vector<CurveEnd> starts_, ends_; // the starts by x
    double tolerance_;
    std::vector<int64_t> owners_; // of each start: the end that it has been given to
    std::vector<int64_t> taken_;  // of each end: its start
    std::vector<int64_t> askers_; // of each start: the end that asked for it in this search
    std::vector<size_t> asked_;
};

} // namespace

void check_closed(const std::vector<SplinePtr> &curves, double tolerance) {
    std::vector<CurveEnd> starts, ends;
    for (int64_t i = 0; i < std::ssize(curves); ++i) {
        add_ends(*curves[static_cast<size_t>(i)], i, starts, ends);
    }
    ChainMatch(std::move(starts), std::move(ends), tolerance).check();
}

} // namespace nrb::measure
