// SPDX-License-Identifier: MIT
// Splitting, extracting, decomposing into Bezier pieces and joining; clamping the ends of axes and moving
// their seams.
#include "checks.h"
#include "guard.h"
#include "lists.h"
#include "outputs.h"

#include "base/checked.h"
#include "base/tolerance.h"
#include "refine/parts/cut.h"
#include "refine/parts/join.h"
#include "refine/parts/piece_arrays.h"
#include "refine/periodic/seam.h"

#include <cmath>
#include <memory>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_range(const Spline &spline, int k, double lower, double upper) {
    const Interval domain = spline.axis(k).domain();
    check_place(lower, domain, "lower", k);
    check_place(upper, domain, "upper", k);
    if (!(lower < upper)) {
        fail(Status::empty_domain, "lower = %s on axis %d, expected less than upper = %s", Number(lower).text,
             k, Number(upper).text);
    }
}

} // namespace

nurbs_status nurbs_split(const nurbs *g, int32_t axis, double param, nurbs **lower, nurbs **upper) {
    return guard([&] {
        if (upper != nullptr) {
            *upper = nullptr;
        }
        require(lower, "lower");
        *lower = nullptr;
        require(upper, "upper");
        if (lower == upper) {
            fail(Status::overlap, "output upper overlaps lower");
        }
        check_axis(spline_of(g), axis);
        const Interval domain = g->spline->axis(axis).domain();
        check_place(param, domain, "param", axis);
        if (param == domain.lower || param == domain.upper) {
            fail(Status::empty_domain, "param = %s is an end of [%s, %s], the domain of axis %d",
                 Number(param).text, Number(domain.lower).text, Number(domain.upper).text, axis);
        }
        const double breaks[] = {domain.lower, param, domain.upper};
        const refine::PartedSpline parts = refine::split_axis(g->spline, axis, breaks);
        auto first = std::make_unique<nurbs>(nurbs{parts.part(0)});
        give(parts.part(1), upper);
        *lower = first.release();
    });
}

nurbs_status nurbs_extract(const nurbs *g, const double *lower, const double *upper, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        require(lower, "lower");
        require(upper, "upper");
        for (int k = 0; k < spline.axes(); ++k) {
            check_range(spline, k, lower[k], upper[k]);
        }
        SplinePtr part = g->spline;
        for (int k = 0; k < spline.axes(); ++k) {
            part = refine::restrict_axis(part, k, lower[k], upper[k]);
        }
        give(std::move(part), out);
    });
}

nurbs_status nurbs_decompose(const nurbs *g, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        *out = new nurbs_list{Parts{refine::bezier_pieces(g->spline), true}};
    });
}

nurbs_status nurbs_bezier_pieces(const nurbs *g, int64_t cap, double *points, double *weights,
                                 double *domains, int64_t *piece_counts, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        require(count, "count");
        const int64_t pieces = refine::count_pieces(spline), filled = checked_cap(cap, pieces);
        const int64_t records = checked_product(filled, refine::points_of_piece(spline), "control points");
        check_apart({memory("points", points, checked_product(records, spline.dim(), "points")),
                     memory("weights", weights, records),
                     memory("domains", domains, checked_product(filled, 2 * spline.axes(), "domains")),
                     memory("piece_counts", piece_counts, spline.axes()), memory("count", count, 1)},
                    {});
        if (filled > 0) {
            refine::write_pieces(g->spline, {points, weights, domains});
        }
        for (int k = 0; k < spline.axes(); ++k) {
            put(piece_counts, static_cast<size_t>(k), spline.axis(k).spans().size());
        }
        *count = pieces;
    });
}

nurbs_status nurbs_split_at_knots(const nurbs *g, int32_t axis, int32_t order, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        check_order(order);
        const std::vector<double> breaks = refine::rough_knots(g->spline->axis(axis), order);
        *out = new nurbs_list{Parts{refine::split_axis(g->spline, axis, breaks), false}};
    });
}

nurbs_status nurbs_clamp_ends(const nurbs *g, int32_t axis, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::clamp_ends(g->spline, axis, decode_ends(flags)), out);
    });
}

nurbs_status nurbs_move_seam(const nurbs *g, int32_t axis, double param, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        const KnotVector &old = g->spline->axis(axis);
        if (!old.periodic()) {
            fail(Status::not_periodic, "axis %d is not periodic: it has no seam to be moved", axis);
        }
        check_place(param, old.domain(), "param", axis);
        give(refine::move_seam(g->spline, axis, param), out);
    });
}

nurbs_status nurbs_join(int64_t count, const nurbs *const *parts, int32_t axis, double tolerance,
                        uint32_t flags, double *gap, nurbs **out) {
    return guard([&] {
        require_out(out);
        const std::vector<SplinePtr> splines = splines_of(count, parts, "parts");
        check_axis(*splines.front(), axis);
        check_tolerance(tolerance);
        if ((flags & ~NURBS_KEEP_GAPS) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_KEEP_GAPS or 0", flags);
        }
        const refine::Joined joined = refine::join(splines, axis, {tolerance, flags != 0});
        give(joined.spline, out);
        if (gap != nullptr) {
            *gap = joined.gap;
        }
    });
}
