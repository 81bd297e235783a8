// What the tests of exact operations share: recipes without periodic axes, layers of control points, and two
// splines compared without rounding.
#pragma once

#include "reference/magnitudes.h"
#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace support {

using reference::eps;

inline Recipe open_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        if (axis.form == KnotForm::periodic) {
            axis.form = KnotForm::unclamped;
        }
    }
    return recipe;
}

struct Layers {
    int64_t outer = 1;
    int64_t inner = 1;
    int64_t count = 1;

    Layers(const SplineData &data, int axis) : count(data.counts[static_cast<size_t>(axis)]) {
        for (int k = 0; k < data.axes(); ++k) {
            (k < axis ? outer : inner) *= k == axis ? 1 : data.counts[static_cast<size_t>(k)];
        }
    }
    [[nodiscard]] int64_t place(int64_t o, int64_t layer, int64_t i) const {
        return (o * count + layer) * inner + i;
    }
};

// The homogeneous records of a spline as a polynomial spline of one dimension more.
inline SplineData homogeneous(const nurbs *g) {
    SplineData data = read_back(g);
    data.points = homogeneous_points(g);
    data.weights.clear();
    data.dim += 1;
    return data;
}

// On a periodic axis the copies of layers are made equal bit for bit, while knots repeat to within their
// rounding only: control points move by that rounding relative to the spans. 0 where knots of few bits repeat
// exactly.
inline long double wrapping(const SplineData &data, int axis, double knot) {
    const auto &t = data.knots[static_cast<size_t>(axis)];
    const double size = std::max(std::fabs(t.front()), std::fabs(t.back()));
    bool exact = reference::lowest_bit(knot) >= -12 && size < 0x1p30;
    double shortest = t.back() - t.front();
    for (size_t i = 0; i + 1 < t.size(); ++i) {
        exact = exact && reference::lowest_bit(t[i]) >= -12;
        shortest = t[i] < t[i + 1] ? std::min(shortest, t[i + 1] - t[i]) : shortest;
    }
    return exact || !data.periodic(axis)
               ? 0
               : 4 * (data.degrees[static_cast<size_t>(axis)] + 1) * size / shortest;
}

// Exact points of the refined records against exact points of the old ones: only the control points' own
// errors remain. `moved` is what control points may have moved by, in eps * hull.
inline void expect_same_shape(const nurbs *before, const nurbs *after, long double moved, Random &random,
                              const std::string &place) {
    const auto old = homogeneous(before);
    const auto fresh = homogeneous(after);
    for (int i = 0; i < 6; ++i) {
        const auto param = random_params(random, fresh, 1);
        reference::Sides left{};
        for (int k = 0; k < fresh.axes(); ++k) { // of the whole, a part has the limits inside it
            const auto at = static_cast<size_t>(k);
            left[at] = param[at] == fresh.upper(k) || (param[at] != fresh.lower(k) && random.chance(30));
        }
        const auto want = reference::exact_point(old, param.data(), left);
        const auto got = reference::exact_point(fresh, param.data(), left);
        const double hull = reference::exact_hull(old, param.data(), left);
        for (size_t c = 0; c < want.size(); ++c) {
            const reference::Integer difference = abs(reference::Integer(
                got[c].numerator * want[c].denominator - want[c].numerator * got[c].denominator));
            const long double error =
                reference::quotient(difference, got[c].denominator * want[c].denominator);
            ASSERT_LE(error, (moved + 1) * eps * hull) << place << " at " << hex(param);
        }
    }
}

// The same spline, built of homogeneous points.
inline Handle homogeneous_form(const nurbs *g) {
    nurbs *records = nullptr, *out = nullptr;
    require_ok(nurbs_to_homogeneous(g, &records));
    const Handle holder(records);
    require_ok(nurbs_from_homogeneous(records, &out));
    return Handle(out);
}

} // namespace support
