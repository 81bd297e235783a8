// SPDX-License-Identifier: MIT
#include "build/coons/corner.h"

#include "numeric/norm.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>

namespace nrb::build {

SplinePtr clamped_over(const SplinePtr &spline, int axis, Interval domain) {
    return refine::reparametrize(refine::clamp_ends(spline, axis), axis, domain);
}

namespace {

void check_curve(const SplinePtr &curve, int dim, const char *name, size_t i) {
    check_kind(*curve, 1, name, static_cast<int64_t>(i));
    if (curve->dim() != dim) {
        fail(Status::dimension, "%s[%zu] has dimension %d, expected %d as boundaries[0]", name, i,
             curve->dim(), dim);
    }
}

void check_ends(const Spline &curve, const char *name, size_t i) {
    for (const int64_t end : {int64_t{0}, curve.point_count() - 1}) {
        if (curve.weight(end) == 0) {
            fail(Status::weights_vanish, "%s[%zu]: its %s lies at infinity", name, i,
                 end == 0 ? "start" : "end");
        }
    }
}

std::vector<SplinePtr> prepared(const std::vector<SplinePtr> &curves, const std::array<Interval, 2> &domains,
                                const char *name) {
    std::vector<SplinePtr> result;
    for (size_t i = 0; i < curves.size(); ++i) {
        result.push_back(clamped_over(curves[i], 0, domains[i < 2 ? 1 : 0]));
        check_ends(*result.back(), name, i);
    }
    return result;
}

} // namespace

PatchCurves make_patch_curves(const std::vector<SplinePtr> &boundaries, const std::vector<SplinePtr> &cross) {
    const int dim = boundaries[0]->dim();
    for (size_t i = 0; i < boundaries.size(); ++i) {
        check_curve(boundaries[i], dim, "boundaries", i);
    }
    for (size_t i = 0; i < cross.size(); ++i) {
        check_curve(cross[i], dim, "cross", i);
    }
    const std::array<Interval, 2> domains{boundaries[2]->axis(0).domain(), boundaries[0]->axis(0).domain()};
    return {prepared(boundaries, domains, "boundaries"), prepared(cross, domains, "cross")};
}

EndJet end_jet(const Spline &curve, bool upper) {
    const KnotVector &axis = curve.axis(0);
    const int p = axis.degree();
    const int64_t n = axis.count(), end = upper ? n - 1 : 0;
    EndJet jet;
    for (int c = 0; c < curve.dim(); ++c) {
        jet.value.push_back(curve.coordinate(end, c));
    }
    jet.slope.assign(jet.value.size(), 0);
    if (p == 0) {
        return jet;
    }
    const int64_t next = upper ? n - 2 : 1;
    const double length = upper ? axis[n + p - 1] - axis[n - 1] : axis[1] - axis[p + 1];
    const double ratio = curve.weight(next) / curve.weight(end);
    for (int c = 0; c < curve.dim(); ++c) {
        const auto at = static_cast<size_t>(c);
        const double moved =
            curve.form() == Form::homogeneous
                ? curve.points()[static_cast<size_t>(next * curve.stored_width() + c)] / curve.weight(end) -
                      ratio * jet.value[at]
                : ratio * (curve.coordinate(next, c) - jet.value[at]);
        jet.slope[at] = -moved * p / length;
    }
    return jet;
}

CornerPair corner_pair(const PatchCurves &curves, int order) {
    CornerPair pair{{order, curves.dim()}, {order, curves.dim()}};
    for (int i = 0; i < order; ++i) { // value at an end of the other axis, or derivative there
        const auto place = static_cast<size_t>(i % 2);
        const std::vector<SplinePtr> &family = i < 2 ? curves.boundaries : curves.cross;
        for (int end = 0; end < 2 && !family.empty(); ++end) {
            const EndJet along1 = end_jet(*family[place], end == 1);
            const EndJet along0 = end_jet(*family[place + 2], end == 1);
            pair.along1.set(i, end, along1.value);
            pair.along0.set(end, i, along0.value);
            if (order == 4) {
                pair.along1.set(i, end + 2, along1.slope);
                pair.along0.set(end + 2, i, along0.slope);
            }
        }
    }
    return pair;
}

namespace {

double gap_at(const CornerPair &pair, int i, int j) {
    const double gap = distance(pair.along1.at(i, j), pair.along0.at(i, j), pair.along1.dim());
    if (!std::isfinite(gap)) {
        fail(Status::not_representable, "corner (u%d, v%d): a difference overflows", i % 2, j % 2);
    }
    return gap;
}

// For messages: the two curves that differ at a corner, and in which of their data.
struct Difference {
    const char *what;
    size_t first;
    const char *other;
    size_t second;
};

void check_corner(double gap, double tolerance, size_t corner, Status status, const Difference &named) {
    if (gap > tolerance) {
        fail(status, "corner (u%zu, v%zu): the %s[%zu] and the %s[%zu] are %s apart, expected at most %s",
             corner / 2, corner % 2, named.what, named.first, named.other, named.second, Number(gap).text,
             Number(tolerance).text);
    }
}

// The two boundaries that meet at a corner: the one along axis 1 and the one along axis 0.
struct Meeting {
    size_t along1;
    size_t along0;
};
Meeting meeting(size_t corner) noexcept {
    return {corner / 2, corner % 2 + 2};
}

} // namespace

CornerGaps corner_gaps(const PatchCurves &curves) {
    const CornerPair pair = corner_pair(curves, 4);
    CornerGaps gaps;
    for (int corner = 0; corner < corner_count; ++corner) {
        const auto at = static_cast<size_t>(corner);
        const int i = corner / 2, j = corner % 2;
        gaps.positions[at] = gap_at(pair, i, j);
        if (!curves.cross.empty()) {
            gaps.tangents[at] = {gap_at(pair, i + 2, j), gap_at(pair, i, j + 2)};
            gaps.twists[at] = gap_at(pair, i + 2, j + 2);
        }
    }
    return gaps;
}

void check_positions(const CornerPair &pair, double tolerance) {
    for (int corner = 0; corner < corner_count; ++corner) {
        const auto at = static_cast<size_t>(corner);
        const Meeting curves = meeting(at);
        check_corner(gap_at(pair, corner / 2, corner % 2), tolerance, at, Status::gap,
                     {"end of boundaries", curves.along1, "end of boundaries", curves.along0});
    }
}

void check_tangents(const CornerGaps &gaps, double tolerance) {
    for (size_t corner = 0; corner < gaps.tangents.size(); ++corner) {
        const Meeting at = meeting(corner);
        check_corner(gaps.tangents[corner][0], tolerance, corner, Status::tangent,
                     {"tangent of boundaries", at.along0, "end of cross", at.along1});
        check_corner(gaps.tangents[corner][1], tolerance, corner, Status::tangent,
                     {"tangent of boundaries", at.along1, "end of cross", at.along0});
    }
}

void check_twists(const CornerGaps &gaps, double tolerance) {
    for (size_t corner = 0; corner < gaps.twists.size(); ++corner) {
        const Meeting at = meeting(corner);
        check_corner(gaps.twists[corner], tolerance, corner, Status::twist,
                     {"derivative of cross", at.along1, "derivative of cross", at.along0});
    }
}

} // namespace nrb::build
