// SPDX-License-Identifier: MIT
#include "modify/edit/influence.h"

#include "eval/active_points.h"
#include "modify/edit/net_editor.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nrb::modify {

namespace {

// The basis functions at a parameter that has been checked.
class ActiveAt : public eval::ActivePoints {
public:
    ActiveAt(const Spline &spline, const double *param) : eval::ActivePoints(spline.knot_vectors(), {}) {
        static_cast<void>(locate({param, 1, spline.axes(), spline.axes(), 1}, 0));
    }
};

bool among(std::span<const int64_t> originals, const Spline &spline, int64_t point) noexcept {
    const int64_t original = original_of(spline, point);
    return std::find(originals.begin(), originals.end(), original) != originals.end();
}

double scaled_weight(const Spline &spline, int64_t point) noexcept {
    const double weight = spline.weight(point);
    return spline.records_exponent() == 0 ? weight : std::ldexp(weight, -spline.records_exponent());
}

void add_functions(const Spline &spline, const eval::ActivePoints &active, std::span<const int64_t> originals,
                   Contribution &sums) noexcept {
    active.for_each([&](int64_t point, double value) {
        const double term = value * scaled_weight(spline, point);
        if (among(originals, spline, point)) {
            sums.function += value;
            sums.weight += term;
        } else {
            sums.rest += term;
        }
    });
}

// sum N_j w_j (P_j - Q) over the chosen control points or over the others; a point at infinity contributes
// N_j times its direction.
std::vector<double> weighted_offset(const Spline &spline, const eval::ActivePoints &active,
                                    std::span<const int64_t> originals, bool chosen,
                                    const std::vector<double> &centre) {
    std::vector<double> sum(centre.size(), 0.0);
    const bool homogeneous = spline.form() == Form::homogeneous;
    active.for_each([&](int64_t point, double value) {
        if (value == 0 || among(originals, spline, point) != chosen) {
            return;
        }
        const double weight = scaled_weight(spline, point);
        const double *stored = spline.points().data() + point * spline.stored_width();
        for (size_t c = 0; c < sum.size(); ++c) {
            sum[c] += homogeneous ? value * (stored[c] - weight * centre[c])
                                  : value * weight * (stored[c] - centre[c]);
        }
    });
    return sum;
}

std::vector<double> place_of(const Spline &spline, int64_t point) {
    std::vector<double> place(static_cast<size_t>(spline.dim()));
    for (int c = 0; c < spline.dim(); ++c) {
        place[static_cast<size_t>(c)] = spline.coordinate(point, c);
    }
    return place;
}

Contribution started(const Spline &spline, const eval::ActivePoints &active,
                     std::span<const int64_t> originals) {
    Contribution sums;
    sums.unit = std::ldexp(1.0, -spline.records_exponent());
    add_functions(spline, active, originals, sums);
    return sums;
}

// The mean of the originals, computed relative to the first one whose weight is not 0, so that places far
// from the origin lose no accuracy.
std::vector<double> mean_place(const Spline &spline, const eval::ActivePoints &active,
                               std::span<const int64_t> originals, double weight) {
    const auto first = std::find_if(originals.begin(), originals.end(),
                                    [&](int64_t point) { return spline.weight(point) != 0; });
    std::vector<double> centre = place_of(spline, *first);
    if (originals.size() > 1) {
        const std::vector<double> offset = weighted_offset(spline, active, originals, true, centre);
        for (size_t c = 0; c < centre.size(); ++c) {
            centre[c] += offset[c] / weight;
        }
    }
    return centre;
}

// The text of a list of indices, cut off where there is no more space.
class IndexList {
public:
    void add(int64_t index) noexcept {
        if (used_ + 24 > sizeof text_) {
            more_ = true;
            return;
        }
        used_ += static_cast<size_t>(std::snprintf(text_ + used_, sizeof text_ - used_, "%s%lld",
                                                   used_ == 0 ? "" : ", ", static_cast<long long>(index)));
    }
    [[nodiscard]] const char *text() const noexcept { return used_ == 0 ? "none" : text_; }
    [[nodiscard]] const char *rest() const noexcept { return more_ ? " and more" : ""; }

private:
    char text_[120] = "";
    size_t used_ = 0;
    bool more_ = false;
};

struct ParameterText {
    ParameterText(const double *param, int axes) noexcept {
        size_t used = 0;
        for (int k = 0; k < axes; ++k) {
            used += static_cast<size_t>(std::snprintf(text + used, sizeof text - used, "%s%s",
                                                      k == 0 ? "" : ", ", Number(param[k]).text));
        }
    }
    char text[120] = "";
};

// R_i of all active control points; copies are added to their originals and become 0 themselves.
class Influences {
public:
    Influences(const Spline &spline, size_t size) : spline_(spline), points_(size), values_(size) {}

    void find(const eval::ActivePoints &active) noexcept {
        double sum = 0;
        size_t at = 0;
        active.for_each([&](int64_t point, double value) {
            points_[at] = original_of(spline_, point);
            values_[at] = value * scaled_weight(spline_, point);
            sum += values_[at++];
        });
        for (double &value : values_) {
            value = spline_.rational() ? value / sum : value;
        }
        join_copies();
    }
    // The position of the largest |R_i|; of several, that of the control point with the lowest index.
    [[nodiscard]] size_t largest() const noexcept {
        size_t best = 0;
        for (size_t i = 1; i < values_.size(); ++i) {
            const double here = std::abs(values_[i]), there = std::abs(values_[best]);
            best = here > there || (here == there && points_[i] < points_[best]) ? i : best;
        }
        return best;
    }
    [[nodiscard]] int64_t point(size_t i) const noexcept { return points_[i]; }
    [[nodiscard]] double value(size_t i) const noexcept { return values_[i]; }

private:
    void join_copies() noexcept {
        if (std::none_of(
                spline_.knot_vectors().begin(), spline_.knot_vectors().end(),
                [](const KnotVectorPtr &axis) { return axis->distinct_layers() <= axis->degree(); })) {
            return; // no control point is active twice
        }
        for (size_t i = 0; i < points_.size(); ++i) {
            const size_t first =
                static_cast<size_t>(std::find(points_.begin(), points_.end(), points_[i]) - points_.begin());
            if (first < i) {
                values_[first] += values_[i];
                values_[i] = 0;
            }
        }
    }

    const Spline &spline_;
    std::vector<int64_t> points_;
    std::vector<double> values_;
};

} // namespace

double Contribution::reach() const noexcept {
    return norm(offset.data(), static_cast<int>(offset.size())) / std::abs(weight + rest);
}

void fail_influence(const Spline &spline, int64_t point, const double *param) {
    IndexList acting;
    ActiveAt(spline, param).for_each([&](int64_t i, double value) {
        if (value * spline.weight(i) != 0) {
            acting.add(i);
        }
    });
    const ParameterText place(param, spline.axes());
    if (point < 0) {
        fail(Status::influence, "indices: these control points have no influence at (%s), where %s%s act",
             place.text, acting.text(), acting.rest());
    }
    fail(Status::influence, "control point %lld has no influence at (%s), where %s%s act",
         static_cast<long long>(point), place.text, acting.text(), acting.rest());
}

Contribution contribution_of(const Spline &spline, std::span<const int64_t> originals, const double *param) {
    const ActiveAt active(spline, param);
    Contribution sums = started(spline, active, originals);
    if (sums.weight == 0) {
        fail_influence(spline, originals.size() == 1 ? originals[0] : -1, param);
    }
    sums.centre = mean_place(spline, active, originals, sums.weight);
    sums.offset = weighted_offset(spline, active, originals, false, sums.centre);
    return sums;
}

Contribution contribution_about(const Spline &spline, int64_t original, const double *param) {
    if (spline.form() == Form::homogeneous && spline.weight(original) == 0) {
        fail(Status::point_not_finite, "g: control point %lld is at infinity",
             static_cast<long long>(original));
    }
    const ActiveAt active(spline, param);
    const std::span<const int64_t> chosen(&original, 1);
    Contribution sums = started(spline, active, chosen);
    sums.centre = place_of(spline, original);
    sums.offset = weighted_offset(spline, active, chosen, false, sums.centre);
    return sums;
}

void most_influential(const Spline &spline, ConstRecords params, int64_t *indices, double *influences) {
    eval::ActivePoints active(spline.knot_vectors(), {});
    Influences all(spline, static_cast<size_t>(active.size()));
    for (int64_t i = 0; i < params.count; ++i) {
        static_cast<void>(active.locate(params, i));
        all.find(active);
        const size_t best = all.largest();
        if (indices != nullptr) {
            indices[i] = all.point(best);
        }
        if (influences != nullptr) {
            influences[i] = all.value(best);
        }
    }
}

} // namespace nrb::modify
