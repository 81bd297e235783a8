// SPDX-License-Identifier: MIT
#include "fit/offset/offset_surface.h"

#include "base/error.h"
#include "base/numbers.h"
#include "eval/evaluate.h"
#include "fit/offset/band.h"
#include "fit/offset/offset_jet.h"
#include "fit/offset/offset_net.h"
#include "fit/offset/offset_proof.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

// The number of patches that are bounded at once: each takes some kilobytes meanwhile.
constexpr int64_t patches_at_once = 64;
// The share of the tolerance for the error along each of two axes.
constexpr double share_of_axis = 0.5;

// The numbers of parts into which the intervals of both axes are to be cut.
using Parts = std::array<std::vector<int>, 2>;

// A patch that misses the tolerance.
struct Miss {
    std::array<size_t, 2> patch;
    double bound;                // of the whole patch
    std::array<double, 2> along; // the part of it along each axis
};

// The time that a patch takes, as a multiple of that of a bicubic polynomial one: for products with the
// difference, which is of higher degrees.
int64_t cost_of(const Spline &surface) noexcept {
    double cost = surface.rational() ? 2 : 1;
    for (const int k : {0, 1}) {
        const int p = surface.axis(k).degree(), high = std::max(p, patch_degree);
        cost *= (p + 1) * (high + 1 + (surface.rational() ? p : 0)) / 24.0;
    }
    return std::max<int64_t>(1, std::llround(cost));
}

class OffsetFit {
public:
    OffsetFit(const SplinePtr &surface, double distance, const OffsetRule &rule)
        : surface_(*surface), distance_(distance), rule_(rule),
          cost_(cost_of(*surface)), axes_{patch_axis(surface->axis(0)), patch_axis(surface->axis(1))} {}

    OffsetSurface run() {
        if (!affordable(axes_)) {
            fail(Status::not_converged, "no patches are left for the offset surface, which takes %lld",
                 static_cast<long long>(patches(axes_)));
        }
        do {
            look();
        } while (best_.bound > rule_.tolerance && worst_ > rule_.tolerance && refine());
        if (best_.spline == nullptr) {
            fail(Status::not_converged,
                 "how near the offset surface is could not be told with the %lld patches that there may be",
                 static_cast<long long>(patches(axes_)));
        }
        return std::move(best_);
    }

private:
    static int64_t patches(const PatchAxes &axes) noexcept { return axes[0].count() * axes[1].count(); }
    [[nodiscard]] bool affordable(const PatchAxes &axes) const noexcept {
        return patches(axes) <= rule_.most_patches &&
               (rule_.left == nullptr || patches(axes) <= *rule_.left / cost_);
    }

    // Makes the candidate over the axes, and bounds its distance.
    void look() {
        if (rule_.left != nullptr) {
            *rule_.left -= patches(axes_) * cost_;
        }
        candidate_ = offset_candidate(surface_, distance_, axes_);
        find_bounds();
        worst_ = *std::max_element(bounds_.begin(), bounds_.end());
        if (worst_ > rule_.tolerance &&
            candidate_.jump > std::max(rule_.tolerance, least_sine * std::abs(distance_))) {
            fail(Status::unsupported, "the surface has a kink along a knot, where its offset has a gap of %s",
                 Number(candidate_.jump).text);
        }
        if (worst_ < best_.bound) {
            best_ = {candidate_.spline, worst_};
        }
    }
    void find_bounds() {
        bounds_.clear();
        const std::vector<double> &u = axes_[0].breaks;
        const int64_t rows = std::max<int64_t>(1, patches_at_once / axes_[1].count());
        for (int64_t first = 0; first < axes_[0].count(); first += rows) {
            const int64_t end = std::min(first + rows, axes_[0].count());
            const std::vector<double> between(u.begin() + first, u.begin() + end + 1);
            const std::vector<double> found =
                offset_bounds(*band_of(surface_, between), distance_, *band_of(*candidate_.spline, between),
                              {between, axes_[1].breaks});
            bounds_.insert(bounds_.end(), found.begin(), found.end());
        }
    }

    // Cuts patches as much as needed. If that makes too many patches, it cuts as much as is affordable,
    // towards a larger tolerance. Returns whether any were cut.
    bool refine() {
        const std::vector<Miss> misses = misses_of();
        for (int doublings = 0;; ++doublings) {
            const double wanted = std::ldexp(rule_.tolerance, doublings);
            const Parts parts = parts_for_all(misses, wanted);
            PatchAxes next{cut(axes_[0], parts[0]), cut(axes_[1], parts[1])};
            if (patches(next) == patches(axes_) || !rising(next[0]) || !rising(next[1])) {
                return false;
            }
            if (affordable(next)) {
                axes_ = std::move(next);
                return true;
            }
        }
    }
    [[nodiscard]] std::vector<Miss> misses_of() const {
        std::vector<Miss> misses;
        const auto columns = static_cast<size_t>(axes_[1].count());
        for (size_t i = 0; i < bounds_.size(); ++i) {
            if (!(bounds_[i] <= rule_.tolerance)) {
                misses.push_back(miss_of({i / columns, i % columns}, bounds_[i]));
            }
        }
        return misses;
    }
    [[nodiscard]] Parts parts_for_all(const std::vector<Miss> &misses, double wanted) const {
        Parts parts{std::vector<int>(static_cast<size_t>(axes_[0].count()), 1),
                    std::vector<int>(static_cast<size_t>(axes_[1].count()), 1)};
        for (const Miss &miss : misses) {
            for (const size_t k : {size_t{0}, size_t{1}}) {
                if (miss.bound > wanted) {
                    int &own = parts[k][miss.patch[k]];
                    own = std::max(own, parts_for(miss.along[k], share_of_axis * wanted));
                }
            }
        }
        return parts;
    }
    // Divides the bound between the axes in proportion to the errors in the middles of two boundary curves of
    // the patch. Without a bound both axes are cut.
    [[nodiscard]] Miss miss_of(const std::array<size_t, 2> &patch, double bound) const {
        std::array<double, 2> off{};
        for (const size_t k : {size_t{0}, size_t{1}}) {
            std::array<std::vector<double>, 2> params;
            const PatchAxis &along = axes_[k], &across = axes_[1 - k];
            params[k] = {along.breaks[patch[k]] / 2 + along.breaks[patch[k] + 1] / 2};
            params[1 - k] = {across.breaks[patch[1 - k]]};
            off[k] = off_at(params);
        }
        const double all = off[0] + off[1];
        const bool known = std::isfinite(bound) && all > 0;
        const auto part = [&](double own) { return known ? bound * (own / all) : bound; };
        return {patch, bound, {part(off[0]), part(off[1])}};
    }
    [[nodiscard]] double off_at(const std::array<std::vector<double>, 2> &params) const {
        const Vector3 wanted = offset_jets(surface_, distance_, params, {false, false}).front().at(0, 0);
        const double x[2] = {params[0].front(), params[1].front()};
        double found[3];
        eval::evaluate_points(*candidate_.spline, {}, 0, {x, 1, 2, 2, 1}, {found, 1, 3, 3, 1});
        return length(Vector3{found[0], found[1], found[2]} - wanted);
    }

    const Spline &surface_;
    double distance_;
    OffsetRule rule_;
    int64_t cost_;
    PatchAxes axes_;
    OffsetCandidate candidate_{};
    std::vector<double> bounds_; // of the patches of axes_
    double worst_ = infinity;
    OffsetSurface best_{nullptr, infinity};
};

} // namespace

OffsetSurface offset_surface(const SplinePtr &surface, double distance, const OffsetRule &rule) {
    if (std::abs(distance) <= rule.tolerance) {
        return {surface, std::abs(distance)};
    }
    return OffsetFit(surface, distance, rule).run();
}

} // namespace nrb::fit
