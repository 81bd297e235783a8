// SPDX-License-Identifier: MIT
#include "intersect/levels/function_levels.h"

#include "base/error.h"
#include "base/watch.h"
#include "intersect/levels/fields/seen_normals.h"
#include "intersect/levels/surface_levels.h"
#include "refine/knots/insert.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

using pieces::HomogeneousPiece;

void check_domains(const Spline &surface, const Spline &scalar) {
    for (int k = 0; k < 2; ++k) {
        const KnotVector &a = surface.axis(k), &b = scalar.axis(k);
        const Interval of_a = a.domain(), of_b = b.domain();
        if (of_a.lower != of_b.lower || of_a.upper != of_b.upper) {
            fail(Status::incompatible, "axis %d: domain [%s, %s] of the scalar spline, expected [%s, %s]", k,
                 Number(of_b.lower).text, Number(of_b.upper).text, Number(of_a.lower).text,
                 Number(of_a.upper).text);
        }
        if (a.periodic() != b.periodic()) {
            fail(Status::incompatible,
                 "axis %d of the scalar spline is %speriodic, expected the same as of the surface", k,
                 b.periodic() ? "" : "not ");
        }
    }
}

// The spline with the breaks of the other one inserted, so that both have the same pieces.
SplinePtr with_breaks_of(SplinePtr spline, const Spline &other) {
    for (int k = 0; k < 2; ++k) {
        const std::span<const double> own = spline->axis(k).spans().breaks();
        std::vector<double> missing;
        for (const double knot : other.axis(k).spans().breaks()) {
            if (!std::binary_search(own.begin(), own.end(), knot)) {
                missing.push_back(knot);
            }
        }
        if (!missing.empty()) {
            spline = refine::refine(spline, k, missing);
        }
    }
    return spline;
}

} // namespace

Meet implicit_level(const Spline &surface, const ImplicitForm &form, double tolerance) {
    check_function_degree(surface, [&](int p) { return p * form.degree(); });
    const auto function = [&](size_t) {
        return LevelFunction{[&form](const HomogeneousPiece &piece) { return form.on(piece); }, {}};
    };
    return levels_of_functions(surface, surface, 1, function, tolerance);
}

Meet scalar_levels(const SplinePtr &surface, const SplinePtr &scalar, std::span<const double> values,
                   double tolerance) {
    check_domains(*surface, *scalar);
    const LimitedSearch whole; // refinement to the same pieces is a part of the search
    const SplinePtr on = with_breaks_of(surface, *scalar), of = with_breaks_of(scalar, *surface);
    const auto function = [&](size_t i) {
        const std::span<const double> value = values.subspan(i, 1);
        return LevelFunction{[value](const HomogeneousPiece &piece) { return seen_from(piece, value); }, {}};
    };
    return levels_of_functions(*on, *of, values.size(), function, tolerance);
}

} // namespace nrb::intersect
