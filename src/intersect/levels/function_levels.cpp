// SPDX-License-Identifier: MIT
#include "intersect/levels/function_levels.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/piece_field.h"
#include "intersect/levels/surface_levels.h"
#include "refine/knots/insert.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

using pieces::HomogeneousPiece;

// (h - value) w, in the unit of the piece.
RoundedPolynomial above(const HomogeneousPiece &piece, double value) {
    RoundedPolynomial shift = constant(times_power_of_two(piece.centre[0] - value, -piece.exponent));
    shift.errors[0] = 2 * eps * std::abs(shift.values[0]);
    return component(piece.points, 0) + piece.weight * shift;
}

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

// With the breaks of the other one, so that both have the same pieces.
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
    const UsualLimit usual(usual_work(surface.point_count(), 200000));
    const LimitedSearch limited;
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    PieceField field(surface, grid, [&form](const HomogeneousPiece &piece) { return form.on(piece); });
    return SurfaceLevels(field, tolerance).find(0);
}

Meet scalar_levels(const SplinePtr &surface, const SplinePtr &scalar, std::span<const double> values,
                   double tolerance) {
    check_domains(*surface, *scalar);
    const LimitedSearch whole; // by a limit of the caller; each level has the usual one of its own
    const SplinePtr on = with_breaks_of(surface, *scalar), of = with_breaks_of(scalar, *surface);
    const pieces::PieceGrid &grid = pieces::piece_grid_of(*on);
    Meet all;
    Steps steps(std::ssize(values));
    for (size_t i = 0; i < values.size(); ++i, steps.next()) {
        const UsualLimit usual(usual_work(on->point_count(), 200000));
        const LimitedSearch limited;
        PieceField field(*of, grid, [&](const HomogeneousPiece &piece) { return above(piece, values[i]); });
        all.append(SurfaceLevels(field, tolerance).find(static_cast<int64_t>(i)));
    }
    return all;
}

} // namespace nrb::intersect
