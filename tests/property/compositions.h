// Splines to compose, the exact composition, and how far a result may be off.
#pragma once

#include "property/same_shape.h"
#include "reference/definition.h"

#include <optional>

namespace support::compositions {

using reference::Rational;

using Point = std::vector<Rational>;

inline Handle compose(const nurbs *g, const nurbs *f) {
    nurbs *out = nullptr;
    require_ok(nurbs_compose(g, f, &out));
    return Handle(out);
}

inline double size_of(const Rational &x) {
    return std::fabs(static_cast<double>(reference::quotient(numerator(x), denominator(x))));
}

// The non-empty span of the domain of an axis that holds t.
inline int64_t span_of(const std::vector<double> &knots, int degree, const Rational &t) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    int64_t span = count - 1;
    while (span > degree && (reference::exact(knots[static_cast<size_t>(span)]) > t ||
                             knots[static_cast<size_t>(span)] == knots[static_cast<size_t>(span) + 1])) {
        --span;
    }
    while (knots[static_cast<size_t>(span)] == knots[static_cast<size_t>(span) + 1]) {
        ++span;
    }
    return span;
}

// The value at exact parameters, by de Boor's algorithm along the axes from k on; `base` counts points.
inline Point value_at(const SplineData &data, const Point &params, size_t k = 0, int64_t base = 0) {
    if (k == params.size()) {
        Point point;
        for (int c = 0; c < data.dim; ++c) {
            point.push_back(reference::exact(data.coordinate(base, c)));
        }
        return point;
    }
    const int p = data.degrees[k];
    const int64_t span = span_of(data.knots[k], p, params[k]);
    std::vector<Point> active;
    for (int64_t i = span - p; i <= span; ++i) {
        active.push_back(value_at(data, params, k + 1, base * data.counts[k] + i));
    }
    return reference::blossom_at(data.knots[k], p, span, std::move(active),
                                 Point(static_cast<size_t>(p), params[k]));
}

// The largest control point of the derivative along an axis, and that of the spline.
inline double largest_slope(const SplineData &data, int axis) {
    const Layers layers(data, axis);
    const auto &t = data.knots[static_cast<size_t>(axis)];
    const int p = data.degrees[static_cast<size_t>(axis)];
    double largest = 0;
    for (int64_t o = 0; o < layers.outer; ++o) {
        for (int64_t l = 0; l + 1 < layers.count; ++l) {
            const double length = t[static_cast<size_t>(l + p + 1)] - t[static_cast<size_t>(l + 1)];
            for (int64_t i = 0; i < layers.inner * data.dim && length > 0; ++i) {
                const auto at = [&](int64_t layer) {
                    return data.points[static_cast<size_t>(
                        (o * layers.count + layer) * layers.inner * data.dim + i)];
                };
                largest = std::max(largest, p * std::fabs(at(l + 1) - at(l)) / length);
            }
        }
    }
    return largest;
}

inline double largest_point(const SplineData &data) {
    double largest = 0;
    for (const double x : data.points) {
        largest = std::max(largest, std::fabs(x));
    }
    return largest;
}

// The same for a curve with weights, over all spans.
inline double rational_uncertainty(const SplineData &f, int k) {
    const int q = f.degrees[0];
    const auto &t = f.knots[0];
    double lowest = f.coordinate(0, k), highest = lowest, largest = 0, way = 0;
    const double least = *std::min_element(f.weights.begin(), f.weights.end());
    for (int64_t i = 0; i < f.point_count(); ++i) {
        lowest = std::min(lowest, f.coordinate(i, k));
        highest = std::max(highest, f.coordinate(i, k));
        largest = std::max(largest, std::fabs(f.coordinate(i, k)));
    }
    for (int64_t i = 0; i + 1 < f.point_count(); ++i) {
        const double length = t[static_cast<size_t>(i + q + 1)] - t[static_cast<size_t>(i + 1)];
        way = length > 0
                  ? std::max(way, q * (f.weight(i) + f.weight(i + 1)) / least * (highest - lowest) / length)
                  : way;
    }
    const double end = std::max(std::fabs(f.lower(0)), std::fabs(f.upper(0)));
    return static_cast<double>(eps) * (8 * (q + 2) * largest + end * way);
}

// The uncertainty of a coordinate of f of the header, over all spans.
inline double uncertainty(const SplineData &f, int k) {
    if (f.rational()) {
        return rational_uncertainty(f, k);
    }
    SplineData one = f;
    one.dim = 1;
    one.points.clear();
    for (int64_t i = 0; i < f.point_count(); ++i) {
        one.points.push_back(f.coordinate(i, k));
    }
    const double t = std::max(std::fabs(f.lower(0)), std::fabs(f.upper(0)));
    return static_cast<double>(eps) *
           (4 * (f.degrees[0] + 1) * largest_point(one) + t * largest_slope(one, 0));
}

inline int degree_total(const SplineData &g) {
    int total = 0;
    for (const int32_t p : g.degrees) {
        total += p;
    }
    return total;
}

// What control points of the composition may be off by, in homogeneous space, with the constants of the
// header; where f has weights, in parts of the product of those that the control point is multiplied by.
inline double allowed(const SplineData &g, const SplineData &f) {
    const int weights = f.rational() ? degree_total(g) * (4 * f.degrees[0] + 6) : 0;
    double bound = (2 * g.axes() + 1 + weights) * static_cast<double>(eps) * largest_point(g);
    for (int k = 0; k < g.axes(); ++k) {
        bound += uncertainty(f, k) * largest_slope(g, k);
    }
    return bound;
}

// Whether f is so near a knot at which g jumps that either side may be meant.
inline bool near_jump(const SplineData &g, const SplineData &f, const Point &value) {
    for (int k = 0; k < g.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const auto &t = g.knots[at];
        const auto p = static_cast<size_t>(g.degrees[at]);
        for (size_t i = 0; i + p + 1 < t.size(); ++i) {
            if ((t[i] == t[i + p] && size_of(value[at] - reference::exact(t[i])) <= 4 * uncertainty(f, k))) {
                return true;
            }
        }
    }
    return false;
}

struct Made {
    SplineData g; // homogeneous, several periods where f needs them
    SplineData f;
    SplineData h; // homogeneous
};

// The value of f, and by what the result there is multiplied: the weight of f, divided by the power of two in
// the largest one, once for each degree of g.
inline Point inner_value(const SplineData &f, double t) {
    Point u;
    for (const reference::Fraction &x : reference::exact_point(f, &t)) {
        u.emplace_back(x.numerator, x.denominator);
    }
    return u;
}
inline Rational multiplier(const SplineData &g, const SplineData &f, double t) {
    SplineData weights = f;
    weights.dim = 1;
    weights.points = f.weights;
    weights.weights.clear();
    Rational factor = 1;
    for (int i = 0; i < degree_total(g) && f.rational(); ++i) {
        const double largest = *std::max_element(f.weights.begin(), f.weights.end());
        factor *=
            value_at(weights, {reference::exact(t)})[0] / reference::exact(std::exp2(std::ilogb(largest)));
    }
    return factor;
}

// Compares at parameters of the result; `factor` multiplies the bound.
inline void expect_composed(const Made &made, Random &random, double factor, WorstErrors &worst,
                            const std::string &place) {
    const double bound = allowed(made.g, made.f);
    for (int n = 0; n < 3; ++n) {
        const double t = random_params(random, made.h, 1)[0];
        const Point u = inner_value(made.f, t);
        if (near_jump(made.g, made.f, u)) {
            continue;
        }
        const Point want = value_at(made.g, u), got = value_at(made.h, {reference::exact(t)});
        const Rational factor_there = multiplier(made.g, made.f, t);
        for (size_t c = 0; c < want.size(); ++c) {
            const double error = size_of(got[c] / factor_there - want[c]);
            if (error != 0) {
                worst.add(made.h.degrees[0], error / (factor * bound), error / (factor * bound));
            }
            ASSERT_LE(error, factor * bound) << place << " at " << hex(t);
        }
    }
}

// A plain curve of degree q with knots of its own and no points yet.
inline SplineData parameter_curve(Random &random, int q, int dim) {
    AxisRecipe axis = random_axis(random, q);
    axis.form = random.chance(70) ? KnotForm::clamped : KnotForm::unclamped;
    axis.spacing = random.chance(50) ? Spacing::few_bits : Spacing::full;
    axis.placement = random.chance(70) ? Placement::origin : Placement::small;
    axis.spans = random.whole(1, 3);
    SplineData f;
    f.degrees = {q};
    f.dim = dim;
    f.knots = {random_knots(random, axis)};
    f.counts = {static_cast<int64_t>(f.knots[0].size()) - q - 1};
    return f;
}

// n rising values in [lower, upper], some of them knots.
inline std::vector<double> rising_values(Random &random, int64_t n, double lower, double upper,
                                         const std::vector<double> &knots) {
    for (;;) {
        std::vector<double> values;
        for (int64_t i = 0; i < n; ++i) {
            const double knot = knots[random.bits() % knots.size()];
            const bool inside = lower <= knot && knot <= upper;
            values.push_back(random.chance(30) && inside ? knot : random.between(lower, upper));
        }
        if (n > 1 && random.chance(50)) {
            values.front() = lower;
            values.back() = upper;
        }
        std::sort(values.begin(), values.end());
        if (std::adjacent_find(values.begin(), values.end()) == values.end()) {
            return values;
        }
    }
}

// g with spans that are not too unequal, so that the bound says something.
inline SplineData outer_spline(Random &random, int axes, int max_degree) {
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spacing = random.chance(50)   ? Spacing::integers
                       : random.chance(50) ? Spacing::full
                                           : Spacing::few_bits;
        axis.placement = random.chance(70) ? Placement::origin : Placement::small;
        axis.spans = random.whole(1, axes == 1 ? 6 : 3);
    }
    if (recipe.weights == Weights::extreme) {
        recipe.weights = Weights::moderate;
    }
    recipe.dim = random.whole(1, 3);
    return random_spline(random, recipe);
}

// Coordinates of f that rise or fall, each within the domain of its axis.
inline void set_monotone_points(Random &random, const SplineData &g, SplineData &f) {
    const auto n = static_cast<size_t>(f.counts[0]);
    f.points.resize(n * static_cast<size_t>(f.dim));
    for (int k = 0; k < f.dim; ++k) {
        auto values =
            rising_values(random, f.counts[0], g.lower(k), g.upper(k), g.knots[static_cast<size_t>(k)]);
        if (random.chance(40)) {
            std::reverse(values.begin(), values.end());
        }
        for (size_t i = 0; i < n; ++i) {
            f.points[i * static_cast<size_t>(f.dim) + static_cast<size_t>(k)] = values[i];
        }
    }
}

// A spline and a monotone curve over its domain, of degrees whose product stays within exact arithmetic's
// patience.
struct MonotoneCase {
    SplineData g, f;
};

inline MonotoneCase monotone_case(Random &random) {
    const int axes = random.chance(60) ? 1 : random.whole(2, 3);
    MonotoneCase made;
    made.g = outer_spline(random, axes, axes == 1 ? 6 : axes == 2 ? 3 : 2);
    const int total = degree_total(made.g);
    const int most = total == 0 ? 3 : std::min(axes == 1 ? 5 : 3, (axes == 1 ? 16 : 12) / total);
    made.f = parameter_curve(random, random.whole(1, std::max(1, most)), axes);
    set_monotone_points(random, made.g, made.f);
    return made;
}

// Whether it has the degree and domain of the composition.
inline void expect_frame(const MonotoneCase &made, const SplineData &h) {
    ASSERT_EQ(h.degrees[0], degree_total(made.g) * made.f.degrees[0]);
    ASSERT_EQ(h.lower(0), made.f.lower(0));
    ASSERT_EQ(h.upper(0), made.f.upper(0));
}

// An outer spline over whole numbers, and inner curves whose control points are multiples of 1/4: they touch
// knot lines, run along them and pass through their corners.
inline SplineData with_whole_knots(Random &random, Recipe recipe, int spans) {
    for (AxisRecipe &axis : recipe.axes) {
        axis.spacing = Spacing::integers;
        axis.placement = Placement::origin;
        axis.form = random.chance(50) ? KnotForm::clamped : KnotForm::unclamped;
        axis.spans = spans;
    }
    recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
    recipe.dim = 2;
    return random_spline(random, recipe);
}

inline SplineData whole_knots(Random &random, int axes, int degree) {
    return with_whole_knots(random, random_recipe(random, axes, degree), 3);
}

inline SplineData whole_knots(Random &random, const std::vector<int> &degrees, int spans) {
    Recipe recipe = random_recipe(random, static_cast<int>(degrees.size()), 1);
    for (size_t k = 0; k < degrees.size(); ++k) {
        recipe.axes[k].degree = degrees[k];
    }
    return with_whole_knots(random, recipe, spans);
}

// The polar values of f lie in the box of its control points, R shortest spans long: then both coefficients
// of a step of de Boor's algorithm have magnitudes of at most 1 + 2 R together.
inline double largest_factor(const SplineData &g, const SplineData &f) {
    double factor = 1;
    for (int k = 0; k < g.axes(); ++k) {
        double least = f.coordinate(0, k), greatest = least, shortest = g.upper(k) - g.lower(k);
        for (int64_t i = 0; i < f.counts[0]; ++i) {
            least = std::min(least, f.coordinate(i, k));
            greatest = std::max(greatest, f.coordinate(i, k));
        }
        const auto &t = g.knots[static_cast<size_t>(k)];
        for (size_t i = 0; i + 1 < t.size(); ++i) {
            shortest = t[i] < t[i + 1] ? std::min(shortest, t[i + 1] - t[i]) : shortest;
        }
        factor *= std::pow(1 + 2 * (greatest - least) / shortest, g.degrees[static_cast<size_t>(k)]);
    }
    return factor;
}

// A polynomial spline over whole numbers from 0 to 16.
inline SplineData up_to_sixteen(Random &random, int axes, int max_degree) {
    SplineData data;
    data.dim = 2;
    for (int k = 0; k < axes; ++k) {
        const int p = random.whole(0, max_degree);
        std::vector<double> &knots = data.knots.emplace_back(static_cast<size_t>(p) + 1, 0);
        for (int knot = 1; knot < 16; ++knot) {
            const int times = random.chance(50) ? 0 : random.whole(1, p + 1);
            knots.insert(knots.end(), static_cast<size_t>(times), knot);
        }
        knots.insert(knots.end(), static_cast<size_t>(p) + 1, 16);
        data.degrees.push_back(p);
        data.counts.push_back(static_cast<int64_t>(knots.size()) - p - 1);
    }
    for (int64_t i = 0; i < 2 * data.point_count(); ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return data;
}

// t, raised to degree q, on all axes.
inline SplineData diagonal(int axes, int q, double lower, double upper) {
    SplineData f;
    f.degrees = {q};
    f.dim = axes;
    f.counts = {q + 1};
    f.knots = {std::vector<double>(static_cast<size_t>(q) + 1, lower)};
    f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q) + 1, upper);
    for (int i = 0; i <= q; ++i) {
        f.points.insert(f.points.end(), static_cast<size_t>(axes), lower + (upper - lower) * i / q);
    }
    return f;
}

} // namespace support::compositions
