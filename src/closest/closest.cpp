// SPDX-License-Identifier: MIT
#include "closest/closest.h"

#include "base/watch.h"
#include "closest/curve/curve_locator.h"
#include "closest/patch/patch_locator.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int64_t block = 64;
constexpr int64_t work_of_a_point = 1000, work_of_a_descent = 15000; // not counted by the searches

// PatchLocator could answer queries for curves as well, but takes 1.8 times as long as CurveLocator.
std::shared_ptr<const Locator> make_locator(const Spline &spline) {
    if (spline.axes() == 1) {
        return std::make_shared<CurveLocator>(spline);
    }
    return std::make_shared<PatchLocator>(spline);
}

// Copies a record; returns whether it is finite.
bool copy(const ConstRecords &from, int64_t i, std::vector<double> &to) noexcept {
    bool finite = true;
    for (size_t c = 0; c < to.size(); ++c) {
        to[c] = from(i, static_cast<int64_t>(c));
        finite = finite && std::isfinite(to[c]);
    }
    return finite;
}

// The answer to a local search for which no work is left: its initial guess.
Foot where_it_began(const std::vector<double> &guess) {
    Foot foot;
    std::copy(guess.begin(), guess.end(), foot.params.begin());
    foot.status = closest_budget;
    return foot;
}

// Converts the locators' answers into results, in blocks. The points and distances that are reported are
// those of the rounded parameters, evaluated on the spline.
class Feet {
public:
    // query: null for local searches, which prove nothing.
    Feet(const Spline &spline, const ConstRecords &points, const Query *query, const FeetOutputs &out)
        : spline_(spline), points_(points), query_(query), out_(out),
          params_(static_cast<size_t>(block * spline.axes())),
          feet_(static_cast<size_t>(block * spline.dim())), found_(static_cast<size_t>(block)) {}

    void set(int64_t i, const Foot &foot) {
        found_[static_cast<size_t>(i % block)] = foot;
        if (i % block == block - 1 || i == points_.count - 1) {
            write(i - i % block, i % block + 1);
        }
    }
    void set_invalid(int64_t i) {
        Foot foot;
        foot.params.fill(nan);
        foot.distance = nan;
        foot.status = closest_invalid;
        set(i, foot);
    }

private:
    void write(int64_t first, int64_t count) {
        evaluate(count);
        for (int64_t k = 0; k < count; ++k) {
            Foot &foot = found_[static_cast<size_t>(k)];
            finish(foot, distance(first + k, point(k)));
            for (int64_t c = 0; out_.params.data != nullptr && c < spline_.axes(); ++c) {
                out_.params(first + k, c) = foot.params[static_cast<size_t>(c)];
            }
            for (int64_t c = 0; out_.feet.data != nullptr && c < spline_.dim(); ++c) {
                out_.feet(first + k, c) = point(k)[c];
            }
            if (out_.distances.data != nullptr) {
                out_.distances(first + k, 0) = foot.distance;
            }
            if (out_.status != nullptr) {
                out_.status[first + k] = foot.status;
            }
        }
    }
    // The proof holds for the place that the search found. The distance evaluated at its rounded parameter
    // may be worse than what was proven, or overflow; the answer then is coarse, not certified.
    void finish(Foot &foot, double distance) const {
        settle(foot, distance, (foot.status & closest_certified) != 0 && keeps(foot, distance));
    }
    [[nodiscard]] bool keeps(const Foot &foot, double distance) const noexcept {
        const double worse = query_->farthest ? foot.distance - distance : distance - foot.distance;
        return std::isfinite(distance) && std::isfinite(foot.noise) &&
               worse <= query_->tolerance + foot.noise;
    }
    [[nodiscard]] double *point(int64_t k) noexcept { return feet_.data() + k * spline_.dim(); }
    [[nodiscard]] double distance(int64_t i, const double *foot) const noexcept {
        return norm_of(spline_.dim(), [&](int c) { return foot[c] - points_(i, c); });
    }

    void evaluate(int64_t count) {
        eval::AxisRules rules;
        for (eval::AxisRule &rule : rules) {
            rule.nan = true;
        }
        const int axes = spline_.axes(), dim = spline_.dim();
        for (int64_t k = 0; k < count; ++k) {
            std::copy_n(found_[static_cast<size_t>(k)].params.data(), axes, params_.data() + k * axes);
        }
        eval::evaluate_points(spline_, rules, 0, {params_.data(), count, axes, axes, 1},
                              {feet_.data(), count, dim, dim, 1});
        for (int64_t k = 0; k < count; ++k) {
            const uint32_t left = found_[static_cast<size_t>(k)].left;
            if (left == 0) {
                continue;
            }
            for (int a = 0; a < axes; ++a) {
                rules[static_cast<size_t>(a)].left = (left >> a & 1) != 0;
            }
            eval::evaluate_points(spline_, rules, 0, {params_.data() + k * axes, 1, axes, axes, 1},
                                  {point(k), 1, dim, dim, 1});
        }
    }

    const Spline &spline_;
    const ConstRecords &points_;
    const Query *query_;
    const FeetOutputs &out_;
    std::vector<double> params_;
    std::vector<double> feet_;
    std::vector<Foot> found_;
};

} // namespace

const Locator &locator_of(const Spline &spline) {
    return spline.kept<Locator>(Spline::Cache::locator, [&] { return make_locator(spline); });
}

int64_t usual_budget(const Spline &spline) {
    constexpr int64_t looks = 16, most = 2000000;
    int64_t pieces = 1;
    for (int k = 0; k < spline.axes(); ++k) {
        pieces = std::min(most, pieces * spline.axis(k).spans().size());
    }
    return std::clamp(looks * pieces, nrb::pieces::default_budget, most);
}

void closest_points(const Spline &spline, const ConstRecords &points, const Query &common,
                    const FeetOutputs &out) {
    const Locator &locator = locator_of(spline);
    std::vector<double> point(static_cast<size_t>(spline.dim()));
    Query query = common;
    query.point = point.data();
    Feet feet(spline, points, &common, out);
    const LimitedSearch search;
    Steps steps(points.count);
    for (int64_t i = 0; i < points.count; ++i, steps.next(work_of_a_point)) {
        if (copy(points, i, point)) {
            feet.set(i, locator.nearest(query));
        } else {
            feet.set_invalid(i);
        }
    }
}

void closest_local(const Spline &spline, const ConstRecords &points, const ConstRecords &guesses,
                   const FeetOutputs &out) {
    const Locator &locator = locator_of(spline);
    std::vector<double> point(static_cast<size_t>(spline.dim())), guess(static_cast<size_t>(spline.axes()));
    Feet feet(spline, points, nullptr, out);
    const LimitedSearch search;
    Steps steps(points.count);
    for (int64_t i = 0; i < points.count; ++i, steps.next(work_of_a_descent)) {
        copy(guesses, i, guess);
        if (!copy(points, i, point)) {
            feet.set_invalid(i);
        } else if (work_ended()) {
            feet.set(i, where_it_began(guess));
        } else {
            feet.set(i, locator.local(point.data(), guess.data()));
        }
    }
}

} // namespace nrb::closest
