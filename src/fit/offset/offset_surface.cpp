// SPDX-License-Identifier: MIT
#include "fit/offset/offset_surface.h"

#include "base/error.h"
#include "eval/evaluate.h"
#include "fit/offset/offset_jet.h"
#include "fit/offset/offset_proof.h"
#include "fit/offset/patch_axis.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

using PatchAxes = std::array<PatchAxis, 2>;

// Bezier patches side by side, with the layers between them once.
class PatchNet {
public:
    PatchNet(const Spline &surface, double distance, const PatchAxes &axes)
        : axes_(axes), columns_(3 * axes[1].count() + 1),
          points_(static_cast<size_t>((3 * axes[0].count() + 1) * columns_)) {
        for (const bool upper_u : {false, true}) {
            for (const bool upper_v : {false, true}) {
                add_corners(
                    offset_jets(surface, distance, {axes[0].breaks, axes[1].breaks}, {upper_u, upper_v}),
                    upper_u, upper_v);
            }
        }
    }

    [[nodiscard]] SplinePtr spline() const {
        const std::vector<int64_t> rows = kept(axes_[0]), columns = kept(axes_[1]);
        std::vector<double> points;
        for (const int64_t row : rows) {
            for (const int64_t column : columns) {
                const Vector3 &x = points_[static_cast<size_t>(row * columns_ + column)];
                points.insert(points.end(), {x.x, x.y, x.z});
            }
        }
        return make_result({knots_of(axes_[0]), knots_of(axes_[1])}, space_dim, Form::polynomial,
                           std::move(points));
    }
    // The largest distance of two corners of neighbours that are one.
    [[nodiscard]] double jump() const noexcept { return jump_; }

private:
    // The corners of all patches at one of their four ends.
    void add_corners(const std::vector<OffsetJet> &jets, bool upper_u, bool upper_v) {
        for (int64_t i = 0; i < axes_[0].count(); ++i) {
            for (int64_t j = 0; j < axes_[1].count(); ++j) {
                const int64_t row = i + (upper_u ? 1 : 0), column = j + (upper_v ? 1 : 0);
                const OffsetJet &jet = jets[static_cast<size_t>(row * (axes_[1].count() + 1) + column)];
                const double h = third(axes_[0], i) * (upper_u ? -1 : 1),
                             k = third(axes_[1], j) * (upper_v ? -1 : 1);
                const int64_t inner_row = 3 * row + (upper_u ? -1 : 1),
                              inner_column = 3 * column + (upper_v ? -1 : 1);
                set(3 * row, 3 * column, jet.point);
                at(inner_row, 3 * column) = jet.point + h * jet.u;
                at(3 * row, inner_column) = jet.point + k * jet.v;
                at(inner_row, inner_column) = jet.point + h * jet.u + k * jet.v + h * k * jet.uv;
            }
        }
    }
    void set(int64_t row, int64_t column, const Vector3 &point) {
        Vector3 &known = at(row, column);
        if (set_.size() != points_.size()) {
            set_.assign(points_.size(), false);
        }
        const auto place = static_cast<size_t>(row * columns_ + column);
        jump_ = set_[place] ? std::max(jump_, length(point - known)) : jump_;
        set_[place] = true;
        known = point;
    }
    static double third(const PatchAxis &axis, int64_t i) noexcept {
        const auto at = static_cast<size_t>(i);
        return (axis.breaks[at + 1] - axis.breaks[at]) / 3;
    }
    Vector3 &at(int64_t row, int64_t column) { return points_[static_cast<size_t>(row * columns_ + column)]; }
    // A layer between patches with equal derivatives follows from its neighbours.
    static std::vector<int64_t> kept(const PatchAxis &axis) {
        std::vector<int64_t> layers;
        for (int64_t layer = 0; layer <= 3 * axis.count(); ++layer) {
            if (layer % 3 != 0 || !axis.smooth[static_cast<size_t>(layer / 3)]) {
                layers.push_back(layer);
            }
        }
        return layers;
    }

    const PatchAxes &axes_;
    int64_t columns_;
    std::vector<Vector3> points_;
    std::vector<bool> set_;
    double jump_ = 0;
};

// In how many parts each interval of both axes is to be cut.
using Parts = std::array<std::vector<int>, 2>;

class OffsetFit {
public:
    OffsetFit(const SplinePtr &surface, double distance, const OffsetRule &rule)
        : surface_(*surface), distance_(distance), tolerance_(rule.tolerance),
          most_patches_(rule.most_patches),
          left_(rule.left), axes_{patch_axis(surface->axis(0)), patch_axis(surface->axis(1))} {}

    OffsetSurface run() {
        for (;;) {
            spend();
            const PatchNet net(surface_, distance_, axes_);
            SplinePtr candidate = net.spline();
            const std::vector<double> bounds =
                offset_bounds(surface_, distance_, *candidate, {axes_[0].breaks, axes_[1].breaks});
            const double worst = *std::max_element(bounds.begin(), bounds.end());
            if (worst <= tolerance_) {
                return {std::move(candidate), worst};
            }
            if (net.jump() > tolerance_) {
                fail(Status::unsupported,
                     "the surface has a kink along a knot, where its offset has a gap of %s",
                     Number(net.jump()).text);
            }
            refine(*candidate, bounds, worst);
        }
    }

private:
    void spend() const {
        const int64_t patches = axes_[0].count() * axes_[1].count();
        if (left_ != nullptr && (*left_ -= patches) < 0) {
            *left_ = 0;
            fail(Status::not_converged, "no patches are left for the offset surface, which takes %lld",
                 static_cast<long long>(patches));
        }
    }
    void refine(const Spline &candidate, const std::vector<double> &bounds, double worst) {
        Parts parts{std::vector<int>(static_cast<size_t>(axes_[0].count()), 1),
                    std::vector<int>(static_cast<size_t>(axes_[1].count()), 1)};
        for (size_t i = 0; i < parts[0].size(); ++i) {
            for (size_t j = 0; j < parts[1].size(); ++j) {
                const double bound = bounds[i * parts[1].size() + j];
                if (!(bound <= tolerance_)) {
                    cut_patch(candidate, {i, j}, bound, parts);
                }
            }
        }
        axes_ = {cut(axes_[0], parts[0]), cut(axes_[1], parts[1])};
        if (axes_[0].count() * axes_[1].count() > most_patches_ || !rising(axes_[0]) || !rising(axes_[1])) {
            fail(Status::not_converged, "the offset surface is known within %s only, expected %s",
                 Number(worst).text, Number(tolerance_).text);
        }
    }
    // Along the axes in which the boundary of the patch is off in the middle, or along both if none is.
    void cut_patch(const Spline &candidate, const std::array<size_t, 2> &patch, double bound,
                   Parts &parts) const {
        std::array<double, 2> off{};
        for (const size_t k : {size_t{0}, size_t{1}}) {
            std::array<std::vector<double>, 2> params;
            const PatchAxis &along = axes_[k], &across = axes_[1 - k];
            params[k] = {along.breaks[patch[k]] / 2 + along.breaks[patch[k] + 1] / 2};
            params[1 - k] = {across.breaks[patch[1 - k]]};
            off[k] = miss(candidate, params);
        }
        const double largest = std::max(off[0], off[1]);
        for (const size_t k : {size_t{0}, size_t{1}}) {
            if (!std::isfinite(bound) || off[k] > tolerance_ / 16 || off[k] >= largest / 2) {
                int &own = parts[k][patch[k]];
                own = std::max(own, parts_for(bound, tolerance_));
            }
        }
    }
    [[nodiscard]] double miss(const Spline &candidate,
                              const std::array<std::vector<double>, 2> &params) const;

    const Spline &surface_;
    double distance_, tolerance_;
    int64_t most_patches_;
    int64_t *left_;
    PatchAxes axes_;
};

double OffsetFit::miss(const Spline &candidate, const std::array<std::vector<double>, 2> &params) const {
    const Vector3 wanted = offset_jets(surface_, distance_, params, {false, false}).front().point;
    const double x[2] = {params[0].front(), params[1].front()};
    double found[3];
    eval::evaluate_points(candidate, {}, 0, {x, 1, 2, 2, 1}, {found, 1, 3, 3, 1});
    return length(Vector3{found[0], found[1], found[2]} - wanted);
}

} // namespace

OffsetSurface offset_surface(const SplinePtr &surface, double distance, const OffsetRule &rule) {
    return OffsetFit(surface, distance, rule).run();
}

} // namespace nrb::fit
