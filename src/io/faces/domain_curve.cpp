// SPDX-License-Identifier: MIT
#include "io/faces/domain_curve.h"

#include "base/error.h"
#include "build/polylines.h"
#include "fit/fit_image.h"
#include "model/shapes/surface_spline.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {
namespace {

using model::ParameterLaw;

// The tolerance of curves that are fitted, as a share of the domain.
constexpr double share_of_domain = 0x1p-30;
// A curve that goes around an axis more often than this is an error in the file, and would take long to fit.
constexpr double most_turns = 64;
// The uncertainty of a number that is written with seven decimals.
constexpr double share_of_decimals = 0x1p-24;

// The map from the parameters of a shape to those of its spline.
class ParameterChart {
public:
    ParameterChart(const model::SurfaceShape &shape, const Spline &spline) : shape_(shape), spline_(spline) {}

    [[nodiscard]] bool identity() const noexcept { return is_linear(0) && is_linear(1); }
    // The spline parameter for the parameter t of axis k. Beyond the ends of an axis that makes a full turn,
    // copies of the domain follow each other.
    [[nodiscard]] double place(size_t k, double t) const noexcept {
        const KnotVector &knots = spline_.axis(static_cast<int>(k));
        const Interval domain = knots.domain();
        const double length = domain.upper - domain.lower;
        const bool turn = law(k, t) == ParameterLaw::angle && std::abs(length - model::turn) < 1e-9;
        const double shift = turn ? std::floor((t - domain.lower) / length) * length : 0;
        return model::to_spline_parameter(law(k, t - shift), knots, t - shift) + shift;
    }
    void check(const Spline &curve) const {
        for (int64_t i = 0; i < curve.point_count(); ++i) {
            for (const int k : {0, 1}) {
                const Interval domain = spline_.axis(k).domain();
                const double x = curve.coordinate(i, k), most = most_turns * (domain.upper - domain.lower);
                if (!(x >= domain.lower - most && x <= domain.upper + most)) {
                    fail(Status::outside_domain,
                         "a curve runs to %s on axis %d, far outside of the domain [%s, %s]", Number(x).text,
                         k, Number(domain.lower).text, Number(domain.upper).text);
                }
            }
        }
    }
    [[nodiscard]] double precision() const noexcept {
        const Interval u = spline_.axis(0).domain(), v = spline_.axis(1).domain();
        return share_of_domain * std::min(u.upper - u.lower, v.upper - v.lower);
    }

private:
    [[nodiscard]] ParameterLaw law(size_t k, double t) const noexcept {
        return model::law_at(shape_, static_cast<int>(k), t);
    }
    // Whether it is on all spans between knots.
    [[nodiscard]] bool is_linear(size_t k) const noexcept {
        const std::span<const double> knots = spline_.axis(static_cast<int>(k)).knots();
        for (size_t i = 0; i + 1 < knots.size(); ++i) {
            if (knots[i] < knots[i + 1] && law(k, knots[i] / 2 + knots[i + 1] / 2) != ParameterLaw::linear) {
                return false;
            }
        }
        return true;
    }

    const model::SurfaceShape &shape_;
    const Spline &spline_;
};

// Whether the curve is a single segment along one of the axes.
bool straight_along_axis(const Spline &curve) noexcept {
    return curve.point_count() == 2 && (curve.coordinate(0, 0) == curve.coordinate(1, 0) ||
                                        curve.coordinate(0, 1) == curve.coordinate(1, 1));
}

} // namespace

SplinePtr in_spline_parameters(const model::SurfaceShape &shape, const Spline &spline,
                               const SplinePtr &curve) {
    const ParameterChart chart(shape, spline);
    if (chart.identity()) {
        return curve;
    }
    if (straight_along_axis(*curve)) {
        std::vector<double> ends;
        for (int64_t i = 0; i < 2; ++i) {
            for (size_t k = 0; k < 2; ++k) {
                ends.push_back(chart.place(k, curve->coordinate(i, static_cast<int>(k))));
            }
        }
        const Interval domain = curve->axis(0).domain();
        return build::polyline(2, std::move(ends), {domain.lower, domain.upper});
    }
    chart.check(*curve);
    const auto map = [&](const std::vector<double> &points, std::vector<double> &images) {
        images.resize(points.size());
        for (size_t i = 0; i < points.size(); ++i) {
            images[i] = chart.place(i % 2, points[i]);
        }
    };
    return fit::fit_image(curve, map, chart.precision()).spline;
}

SplinePtr snapped_to_ends(const SplinePtr &curve, const Spline &surface) {
    if (curve->form() == Form::homogeneous) {
        return curve;
    }
    std::vector<double> points(curve->points().begin(), curve->points().end());
    bool moved = false;
    for (size_t i = 0; i < points.size(); ++i) {
        const Interval domain = surface.axis(static_cast<int>(i % 2)).domain();
        for (const double end : {domain.lower, domain.upper}) {
            if (points[i] != end &&
                std::abs(points[i] - end) <= share_of_decimals * (domain.upper - domain.lower)) {
                points[i] = end;
                moved = true;
            }
        }
    }
    return moved ? make_spline(curve->knot_vectors(), 2, curve->form(), std::move(points),
                               {curve->weights().begin(), curve->weights().end()})
                 : curve;
}

model::Rectangle range_under(const model::SurfaceShape &shape, const std::vector<SplinePtr> &curves) {
    constexpr double margin = 1.0 / 64;
    model::Rectangle range = model::natural_range(shape);
    for (const int k : {0, 1}) {
        Interval &side = k == 0 ? range.u : range.v;
        double lower = INFINITY, upper = -INFINITY;
        for (const SplinePtr &curve : curves) {
            for (int64_t i = 0; i < curve->point_count(); ++i) {
                lower = std::min(lower, curve->coordinate(i, k));
                upper = std::max(upper, curve->coordinate(i, k));
            }
        }
        const double more = margin * (upper - lower);
        side.lower = std::isfinite(side.lower) ? side.lower : lower - more;
        side.upper = std::isfinite(side.upper) ? side.upper : upper + more;
    }
    return range;
}

} // namespace nrb::io
