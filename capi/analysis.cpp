// SPDX-License-Identifier: MIT
// Analysis of shapes: features of curves, monotone pieces, convexity, straightness and planarity, closed and
// collapsed boundaries, singular points, folds.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "analysis/contacts.h"
#include "analysis/convexity.h"
#include "analysis/features.h"
#include "analysis/flatness.h"
#include "analysis/folds.h"
#include "analysis/monotone.h"
#include "analysis/singular.h"
#include "base/tolerance.h"
#include "build/placement.h"
#include "refine/parts/piece_arrays.h"
#include "spline/kind.h"

#include <algorithm>
#include <limits>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr uint32_t all_features = NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CURVATURE_MAXIMUM |
                                  NURBS_FEATURE_CURVATURE_MINIMUM | NURBS_FEATURE_CUSP | NURBS_FEATURE_KINK |
                                  NURBS_FEATURE_JUMP | NURBS_FEATURE_TORSION;

uint32_t checked_kinds(uint32_t kinds, int dim) {
    if ((kinds & ~all_features) != 0) {
        fail(Status::flags, "kinds = 0x%x, expected a sum of NURBS_FEATURE_ constants", kinds);
    }
    if (dim != 3 && (kinds & NURBS_FEATURE_TORSION) != 0) {
        fail(Status::dimension, "kinds = 0x%x: NURBS_FEATURE_TORSION needs dimension 3, not %d", kinds, dim);
    }
    return kinds;
}

// The reference direction of a fold test. Only surfaces in space may have one; for others it has to be NULL.
const double *checked_reference(const Spline &spline, const double *reference) {
    if (reference == nullptr) {
        return nullptr;
    }
    if (spline.axes() != 2 || spline.dim() != 3) {
        fail(Status::direction, "reference is for surfaces in space, expected NULL");
    }
    build::check_direction(reference, 3, "reference");
    return reference;
}

void check_folding(const Spline &spline) {
    if (spline.axes() == 1) {
        fail(Status::axes, "g has 1 axis, expected a surface or volume");
    }
    check_dimension(spline, spline.axes(), 3);
}

void put_place(const std::optional<std::array<double, max_axes>> &place, int axes, double *out) {
    for (size_t k = 0; k < static_cast<size_t>(axes); ++k) {
        put(out, k, place ? (*place)[k] : std::numeric_limits<double>::quiet_NaN());
    }
}

} // namespace

nurbs_status nurbs_curve_features(const nurbs *g, uint32_t kinds, int64_t cap, double *params, int32_t *found,
                                  double *values, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_dimension(curve, 2, 3);
        const uint32_t wanted = checked_kinds(kinds, curve.dim());
        check_length(cap, "cap");
        const analysis::Features features = analysis::curve_features(curve, wanted);
        const int64_t filled = checked_cap(cap, std::ssize(features.list));
        check_apart({memory("params", params, filled), memory("found", found, filled),
                     memory("values", values, filled), memory("count", count, 1),
                     memory("complete", complete, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(params, i, features.list[i].at);
            put(found, i, features.list[i].kind);
            put(values, i, features.list[i].value);
        }
        put(count, int64_t{std::ssize(features.list)});
        put(complete, int32_t{features.complete});
    });
}

nurbs_status nurbs_curve_monotone_pieces(const nurbs *g, const double *direction, int64_t cap, double *starts,
                                         int32_t *signs, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        require(direction, "direction");
        build::check_direction(direction, curve.dim(), "direction");
        check_length(cap, "cap");
        const analysis::MonotonePieces found = analysis::monotone_pieces(curve, direction);
        const int64_t filled = checked_cap(cap, std::ssize(found.pieces));
        check_apart({memory("starts", starts, filled), memory("signs", signs, filled),
                     memory("count", count, 1), memory("complete", complete, 1)},
                    {memory("direction", direction, curve.dim())});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(starts, i, found.pieces[i].start);
            put(signs, i, int32_t{found.pieces[i].sign});
        }
        put(count, int64_t{std::ssize(found.pieces)});
        put(complete, int32_t{found.complete});
    });
}

nurbs_status nurbs_curve_convexity(const nurbs *g, int32_t *result) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_dimension(curve, 2, 2);
        require(result, "convexity");
        *result = analysis::convexity(curve);
    });
}

nurbs_status nurbs_straightness(const nurbs *g, double *origin, double *direction, double *bound) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        require(bound, "bound");
        const int64_t dim = spline.dim();
        check_apart(
            {memory("origin", origin, dim), memory("direction", direction, dim), memory("bound", bound, 1)},
            {});
        const analysis::Flatness found = analysis::straightness(spline);
        put_all(origin, found.origin);
        put_all(direction, found.direction);
        *bound = found.bound;
    });
}

nurbs_status nurbs_planarity(const nurbs *g, double *origin, double *normal, double *bound) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_dimension(spline, 3, 3);
        require(bound, "bound");
        check_apart({memory("origin", origin, 3), memory("normal", normal, 3), memory("bound", bound, 1)},
                    {});
        const analysis::Flatness found = analysis::planarity(spline);
        put_all(origin, found.origin);
        put_all(normal, found.direction);
        *bound = found.bound;
    });
}

nurbs_status nurbs_boundary_contacts(const nurbs *g, double tolerance, int32_t *closed, double *gaps,
                                     int32_t *collapsed, double *sizes) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_tolerance(tolerance);
        const int64_t axes = spline.axes();
        check_apart({memory("closed", closed, axes), memory("gaps", gaps, axes),
                     memory("collapsed", collapsed, 2 * axes), memory("sizes", sizes, 2 * axes)},
                    {});
        const analysis::Contacts found = analysis::boundary_contacts(spline, tolerance);
        for (size_t k = 0; k < found.axes.size(); ++k) {
            put(closed, k, int32_t{found.axes[k].closed});
            put(gaps, k, found.axes[k].gap);
        }
        for (size_t i = 0; i < found.boundaries.size(); ++i) {
            put(collapsed, i, int32_t{found.boundaries[i].collapsed});
            put(sizes, i, found.boundaries[i].size);
        }
    });
}

nurbs_status nurbs_singular_points(const nurbs *g, double tolerance, int64_t cap, double *params,
                                   double *boxes, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        if (spline.axes() > 2) {
            fail(Status::axes, "g has %d axes, expected a curve or surface", spline.axes());
        }
        check_positive_tolerance(tolerance);
        check_length(cap, "cap");
        const analysis::SingularPlaces found = analysis::singular_places(spline, tolerance);
        const int64_t filled = checked_cap(cap, std::ssize(found.places));
        const auto axes = static_cast<size_t>(spline.axes());
        check_apart({memory("params", params, filled * spline.axes()),
                     memory("boxes", boxes, filled * 2 * spline.axes()), memory("count", count, 1),
                     memory("complete", complete, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            for (size_t k = 0; k < axes; ++k) {
                put(params, i * axes + k, found.places[i].at[k]);
                put(boxes, 2 * (i * axes + k), found.places[i].box[k].lower);
                put(boxes, 2 * (i * axes + k) + 1, found.places[i].box[k].upper);
            }
        }
        put(count, int64_t{std::ssize(found.places)});
        put(complete, int32_t{found.complete});
    });
}

nurbs_status nurbs_fold_test(const nurbs *g, const double *reference, int32_t *result, double *positive,
                             double *negative) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_folding(spline);
        require(result, "result");
        const double *direction = checked_reference(spline, reference);
        check_apart({memory("result", result, 1), memory("positive", positive, spline.axes()),
                     memory("negative", negative, spline.axes())},
                    {memory("reference", reference, reference == nullptr ? 0 : 3)});
        const analysis::FoldTest test = analysis::fold_test(spline, direction);
        *result = test.result;
        put_place(test.positive, spline.axes(), positive);
        put_place(test.negative, spline.axes(), negative);
    });
}

nurbs_status nurbs_fold_pieces(const nurbs *g, const double *reference, int64_t cap, int32_t *folds,
                               int32_t *signs, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_folding(spline);
        const double *direction = checked_reference(spline, reference);
        const int64_t filled = checked_cap(cap, refine::count_pieces(spline));
        check_apart(
            {memory("folds", folds, filled), memory("signs", signs, filled), memory("count", count, 1)},
            {memory("reference", reference, reference == nullptr ? 0 : 3)});
        if (filled > 0) {
            const std::vector<analysis::FoldTest> tests = analysis::fold_tests(spline, direction);
            for (size_t i = 0; i < tests.size(); ++i) {
                put(folds, i, tests[i].result);
                put(signs, i, int32_t{analysis::sign_of(tests[i])});
            }
        }
        put(count, refine::count_pieces(spline));
    });
}
