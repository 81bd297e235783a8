// SPDX-License-Identifier: MIT
#include "face/arrange/regions.h"

#include "base/error.h"
#include "base/numbers.h"
#include "bounds/box.h"
#include "eval/curve_point.h"
#include "face/arrange/face_loops.h"
#include "face/arrange/inside_parts.h"
#include "face/arrange/plane_map.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

namespace nrb::face {

namespace {

// The plane z = 0 over a rectangle, with the coordinates as parameters.
SplinePtr plane_over(const Interval &x, const Interval &y) {
    std::vector<double> points;
    for (const double u : {x.lower, x.upper}) {
        for (const double v : {y.lower, y.upper}) {
            points.insert(points.end(), {u, v, 0});
        }
    }
    const auto axis = [](const Interval &range) {
        return std::make_shared<const KnotVector>(
            1, std::vector<double>{range.lower, range.lower, range.upper, range.upper});
    };
    return make_result({axis(x), axis(y)}, 3, Form::polynomial, std::move(points));
}

// The plane over a square somewhat larger than a box; a square, so that distances count alike along both
// axes. Null for a box that is one point.
SplinePtr plane_around(const Point2 &lower, const Point2 &upper) {
    const double size = std::max(upper[0] - lower[0], upper[1] - lower[1]);
    if (!(size > 0)) {
        return nullptr;
    }
    std::array<Interval, 2> sides;
    for (size_t k = 0; k < 2; ++k) {
        const double beyond = (size - (upper[k] - lower[k])) / 2 + size / 32;
        sides[k] = {lower[k] - beyond, upper[k] + beyond};
    }
    return plane_over(sides[0], sides[1]);
}

bool is_region_plane(const Spline &surface) {
    if (surface.dim() != 3 || !plane_map(surface)) {
        return false;
    }
    const Interval x = surface.axis(0).domain(), y = surface.axis(1).domain();
    const auto expected = plane_over(x, y);
    return std::ranges::equal(surface.points(), expected->points());
}

bool are_equal(const Spline &a, const Spline &b) {
    const auto equal_axes = [&](int k) {
        return a.axis(k).degree() == b.axis(k).degree() &&
               std::ranges::equal(a.axis(k).knots(), b.axis(k).knots());
    };
    return a.dim() == b.dim() && a.form() == b.form() && equal_axes(0) && equal_axes(1) &&
           std::ranges::equal(a.points(), b.points()) && std::ranges::equal(a.weights(), b.weights());
}

// Makes the faces of what is inside, by a rule for the values of owners.
class RegionMaker {
public:
    // tolerance: of the faces; near: the distance in space that counts as none.
    RegionMaker(SplinePtr surface, double tolerance, double near)
        : surface_(std::move(surface)), tolerance_(tolerance), near_(near), covering_(*surface_, tolerance),
          map_(plane_map(*surface_)) {}

    [[nodiscard]] double reach() const noexcept { return std::max(covering_.reach(0), covering_.reach(1)); }
    void add(const FacePtr &face, int32_t owner) {
        std::ranges::move(loops_of(*face, owner), std::back_inserter(loops_));
        faces_.emplace_back(face, owner);
    }
    void add(const Loop &loop, int32_t owner) {
        loops_.push_back({placed(*surface_, covering_, loop, tolerance_), owner});
    }
    [[nodiscard]] std::vector<FacePtr> make(const Inside &inside) const {
        std::vector<FacePtr> faces;
        if (loops_.empty() && faces_.empty()) {
            return faces;
        }
        const Arrangement arrangement(covering_, loops_, near_);
        AtCorner corner(arrangement);
        for (const auto &[face, owner] : faces_) {
            corner.add(*face, owner);
        }
        const InsideParts parts(arrangement, corner.sums(), inside);
        for (const PartLoops &part : parts.list()) {
            faces.push_back(face_of(arrangement, part));
        }
        parts.check(faces);
        return faces;
    }

private:
    [[nodiscard]] FacePtr face_of(const Arrangement &arrangement, const PartLoops &part) const {
        FaceParts parts{surface_, {}, tolerance_, true};
        for (const EdgeLoop &loop : part) {
            Loop own;
            for (const Run &run : runs_of(arrangement, loop, RunRule::longest)) {
                own.push_back({curve_of(arrangement, run), nullptr});
                own.back().edge = map_ ? map_->image(*own.back().curve) : nullptr;
            }
            if (!own.empty()) { // loops around poles are
                parts.tolerance = std::max(parts.tolerance, largest_gap(*surface_, covering_, own));
                parts.loops.push_back(std::move(own));
            }
        }
        return std::make_shared<const Face>(std::move(parts), nullptr);
    }
    SplinePtr surface_;
    double tolerance_, near_;
    Covering covering_;
    std::optional<PlaneMap> map_;
    std::vector<ArrangedLoop> loops_;
    std::vector<std::pair<FacePtr, int32_t>> faces_; // with their owners
};

int value_of(const PassedSums &values) noexcept {
    return values.empty() ? 0 : values.front().value;
}

Inside inside_by(FillRule rule) {
    switch (rule) {
    case FillRule::even_odd:
        return [](const PassedSums &values) { return value_of(values) % 2 != 0; };
    case FillRule::positive:
        return [](const PassedSums &values) { return value_of(values) > 0; };
    default:
        return [](const PassedSums &values) { return value_of(values) != 0; };
    }
}

// The faces of a have the owner 0, those of b the owner 1. Owners whose value is 0 are not listed; where
// faces of one owner overlap its value is the number of these.
Inside inside_by(RegionRule rule) {
    const auto holds = [](const PassedSums &values, int32_t owner) {
        return std::ranges::find(values, owner, &PassedSum::loop) != values.end();
    };
    switch (rule) {
    case RegionRule::both:
        return [=](const PassedSums &values) { return holds(values, 0) && holds(values, 1); };
    case RegionRule::difference:
        return [=](const PassedSums &values) { return holds(values, 0) && !holds(values, 1); };
    case RegionRule::one:
        return [=](const PassedSums &values) { return holds(values, 0) != holds(values, 1); };
    default:
        return [=](const PassedSums &values) { return holds(values, 0) || holds(values, 1); };
    }
}

SplinePtr plane_of(std::span<const SplinePtr> curves) {
    Point2 lower{infinity, infinity}, upper{-infinity, -infinity};
    for (const SplinePtr &curve : curves) {
        const bounds::Box box = bounds::bounding_box(*curve, whole_domain(*curve), 0x1p-20);
        for (size_t k = 0; k < 2; ++k) {
            lower[k] = std::min(lower[k], box.lower[k]);
            upper[k] = std::max(upper[k], box.upper[k]);
        }
    }
    return plane_around(lower, upper);
}

// Curves in sequence, grouped into loops: a loop ends with the curve that comes back to its start.
class Chains {
public:
    Chains(std::span<const SplinePtr> curves, double near) : curves_(curves), near_(near) {}

    [[nodiscard]] std::vector<Loop> loops() {
        std::vector<Loop> loops;
        size_t first = 0;
        for (size_t i = 0; i < curves_.size(); ++i) {
            if (first == i) {
                loops.emplace_back();
            } else if (gap(i - 1, i) > near_) {
                fail(Status::gap, "curves[%zu] begins %s from where curves[%zu] ends", i,
                     Number(gap(i - 1, i)).text, i - 1);
            }
            loops.back().push_back({curves_[i], nullptr});
            first = gap(i, first) <= near_ ? i + 1 : first;
        }
        if (first < curves_.size()) {
            fail(Status::gap,
                 "the last of the curves ends %s from where its loop begins, that of curves[%zu]",
                 Number(gap(curves_.size() - 1, first)).text, first);
        }
        return loops;
    }

private:
    // From the end of a curve to the start of another one.
    [[nodiscard]] double gap(size_t a, size_t b) const {
        Point2 end, start;
        eval::end_point(*curves_[a], true, end.data());
        eval::end_point(*curves_[b], false, start.data());
        return std::hypot(end[0] - start[0], end[1] - start[1]);
    }

    std::span<const SplinePtr> curves_;
    double near_;
};

// The surface of all faces; for regions with different planes z = 0, one such plane over all their domains.
class CommonSurface {
public:
    void add(const Face &face, const char *name, size_t number) {
        const SplinePtr &own = face.surface();
        if (surface_ == nullptr) {
            surface_ = own;
        } else if (surface_ != own && !are_equal(*surface_, *own)) {
            if (!is_region_plane(*surface_) || !is_region_plane(*own)) {
                fail(Status::incompatible, "%s[%zu] is of another surface than those before it", name,
                     number);
            }
            Point2 lower, upper;
            for (const int k : {0, 1}) {
                const Interval a = surface_->axis(k).domain(), b = own->axis(k).domain();
                lower[static_cast<size_t>(k)] = std::min(a.lower, b.lower);
                upper[static_cast<size_t>(k)] = std::max(a.upper, b.upper);
            }
            surface_ = plane_around(lower, upper);
        }
        if (face.has_gaps()) {
            fail(Status::gap, "%s[%zu] has gaps larger than its tolerance", name, number);
        }
        tolerance_ = std::max(tolerance_, face.tolerance());
        // For a region of the plane its tolerance, which was asked for; for other faces see largest_gap().
        near_ = std::max(near_, is_region_plane(*own) ? face.tolerance() : largest_gap(face));
    }

    [[nodiscard]] const SplinePtr &get() const noexcept { return surface_; }
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    [[nodiscard]] double near() const noexcept { return near_; }

private:
    SplinePtr surface_;
    double tolerance_ = 0, near_ = 0;
};

} // namespace

std::vector<FacePtr> region_of(std::span<const SplinePtr> curves, FillRule rule, double tolerance) {
    constexpr double rounding = 0x1p-44; // of the largest coordinate or the size: ends so near are one
    check_border_curves(curves);
    const SplinePtr plane = curves.empty() ? nullptr : plane_of(curves);
    if (plane == nullptr) {
        return {};
    }
    RegionMaker maker(plane, tolerance, tolerance);
    for (const Loop &loop : Chains(curves, tolerance + rounding * maker.reach()).loops()) {
        maker.add(loop, 0);
    }
    return maker.make(inside_by(rule));
}

std::vector<FacePtr> combined(std::span<const FacePtr> a, std::span<const FacePtr> b, RegionRule rule,
                              double tolerance) {
    CommonSurface common;
    const auto for_each = [&](auto &&visit) {
        for (size_t i = 0; i < a.size(); ++i) {
            visit(a[i], "a", i, 0);
        }
        for (size_t i = 0; i < b.size(); ++i) {
            visit(b[i], "b", i, 1);
        }
    };
    for_each([&](const FacePtr &face, const char *name, size_t i, int32_t) { common.add(*face, name, i); });
    if (common.get() == nullptr) {
        return {};
    }
    RegionMaker maker(common.get(), std::max(tolerance, common.tolerance()),
                      std::max(tolerance, common.near()));
    for_each([&](const FacePtr &face, const char *, size_t, int32_t owner) { maker.add(face, owner); });
    return maker.make(inside_by(rule));
}

} // namespace nrb::face
