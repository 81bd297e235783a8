#include "support/generators.h"

#include "reference/exact_spline.h"

#include <algorithm>
#include <cmath>
#include <nurbs/nurbs.h>

namespace support {

int Random::whole(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<uint64_t>(high - low + 1));
}

double Random::magnitude(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
}

namespace {

template <class T, size_t n>
T one_of(Random &random, const T (&choices)[n]) {
    return choices[random.whole(0, static_cast<int>(n) - 1)];
}

double random_gap(Random &random, Spacing spacing) {
    switch (spacing) {
    case Spacing::integers:
        return random.whole(1, 4);
    case Spacing::few_bits:
        return random.whole(1, 255) / 64.0;
    case Spacing::ratio:
        return random.magnitude(1e-8, 1);
    case Spacing::tiny:
        return random.chance(30) ? 1e-9 * random.between(0.5, 1) : random.between(0.5, 1);
    case Spacing::full:
        break;
    }
    return random.between(0.1, 1);
}

double placed(double x, Placement placement) {
    switch (placement) {
    case Placement::offset:
        return x + 1e6;
    case Placement::small:
        return x * 1e-9;
    case Placement::large:
        return x * 1e9;
    case Placement::origin:
        break;
    }
    return x;
}

int random_multiplicity(Random &random, int degree) {
    return random.chance(65) ? 1 : random.whole(1, degree + 1);
}

// `total` increasing values with repetitions, the first at 0.
std::vector<double> random_sequence(Random &random, const AxisRecipe &recipe, int total) {
    std::vector<double> values;
    double at = 0;
    while (static_cast<int>(values.size()) < total) {
        values.insert(values.end(), static_cast<size_t>(random_multiplicity(random, recipe.degree)), at);
        at += random_gap(random, recipe.spacing);
    }
    values.resize(static_cast<size_t>(total));
    return values;
}

std::vector<double> open_knots(Random &random, const AxisRecipe &recipe) {
    const int p = recipe.degree;
    const bool start =
        recipe.form == KnotForm::clamped || (recipe.form == KnotForm::half_clamped && random.chance(50));
    const bool end = recipe.form == KnotForm::clamped || (recipe.form == KnotForm::half_clamped && !start);
    const int inner = recipe.spans - 1;
    const int loose = (start ? 0 : p) + (end ? 0 : p); // knots outside the domain
    std::vector<double> knots = random_sequence(random, recipe, inner + 2 + loose);
    for (double &knot : knots) {
        knot = placed(knot, recipe.placement);
    }
    if (start) {
        knots.insert(knots.begin(), static_cast<size_t>(p), knots.front());
    }
    if (end) {
        knots.insert(knots.end(), static_cast<size_t>(p), knots.back());
    }
    return knots;
}

std::vector<double> periodic_knots(Random &random, const AxisRecipe &recipe) {
    const int p = recipe.degree;
    const int distinct = std::max(recipe.spans, 1);
    std::vector<double> base = random_sequence(random, recipe, distinct);
    const double period = base.back() + random_gap(random, recipe.spacing);
    std::vector<double> knots;
    for (int i = 0; i <= distinct + 2 * p; ++i) {
        knots.push_back(
            placed(base[static_cast<size_t>(i % distinct)] + (i / distinct) * period, recipe.placement));
    }
    return knots;
}

bool acceptable(const std::vector<double> &knots, int degree) {
    const auto count = knots.size() - static_cast<size_t>(degree) - 1;
    if (!std::is_sorted(knots.begin(), knots.end()) || knots[static_cast<size_t>(degree)] >= knots[count]) {
        return false;
    }
    size_t run = 0;
    for (size_t i = 0; i < knots.size(); ++i) {
        run = i > 0 && knots[i] == knots[i - 1] ? run + 1 : 1;
        if (run > static_cast<size_t>(degree) + 1) {
            return false;
        }
    }
    return true;
}

double random_coordinate(Random &random, bool short_numbers) {
    return short_numbers ? random.whole(-64, 64) / 8.0 : random.between(-1, 1);
}

double random_weight(Random &random, Weights weights, bool short_numbers) {
    if (weights == Weights::ones) {
        return 1;
    }
    if (weights == Weights::some_zero && random.chance(20)) {
        return 0;
    }
    if (weights == Weights::extreme) {
        return short_numbers ? std::ldexp(1, random.whole(-20, 20)) : random.magnitude(1e-6, 1e6);
    }
    return short_numbers ? random.whole(1, 16) / 4.0 : random.between(0.2, 5);
}

// Copies the first layers of a periodic axis over its last ones; `width` values per control point.
void wrap_layers(const SplineData &data, int axis, size_t width, std::vector<double> &values) {
    const auto k = static_cast<size_t>(axis);
    size_t inner = width;
    size_t outer = 1;
    for (size_t other = 0; other < data.counts.size(); ++other) {
        (other < k ? outer : inner) *= other == k ? 1 : static_cast<size_t>(data.counts[other]);
    }
    const auto count = static_cast<size_t>(data.counts[k]);
    const size_t distinct = count - static_cast<size_t>(data.degrees[k]);
    for (size_t o = 0; o < outer; ++o) {
        for (size_t place = distinct * inner; place < count * inner; ++place) {
            values[o * count * inner + place] = values[o * count * inner + place - distinct * inner];
        }
    }
}

void wrap_periodic_axes(SplineData &data) {
    for (int axis = 0; axis < data.axes(); ++axis) {
        if (data.periodic(axis)) {
            wrap_layers(data, axis, static_cast<size_t>(data.dim), data.points);
            if (data.rational()) {
                wrap_layers(data, axis, 1, data.weights);
            }
        }
    }
}

} // namespace

std::vector<double> random_knots(Random &random, const AxisRecipe &recipe) {
    for (;;) {
        const auto knots =
            recipe.form == KnotForm::periodic ? periodic_knots(random, recipe) : open_knots(random, recipe);
        if (acceptable(knots, recipe.degree)) {
            return knots;
        }
    }
}

SplineData random_spline(Random &random, const Recipe &recipe) {
    SplineData data;
    data.dim = recipe.dim;
    for (size_t k = 0; k < recipe.axes.size(); ++k) {
        const AxisRecipe &axis = recipe.axes[k];
        data.degrees.push_back(axis.degree);
        data.knots.push_back(random_knots(random, axis));
        data.counts.push_back(static_cast<int64_t>(data.knots.back().size()) - axis.degree - 1);
        if (axis.form == KnotForm::periodic) {
            data.flags |= NURBS_ON_AXIS(k, NURBS_PERIODIC);
        }
    }
    const double size = recipe.short_numbers ? 1 : one_of(random, {1.0, 1.0, 1e-6, 1e6});
    for (int64_t i = 0; i < data.point_count() * data.dim; ++i) {
        data.points.push_back(size * random_coordinate(random, recipe.short_numbers));
    }
    for (int64_t i = 0; i < data.point_count() && recipe.weights != Weights::none; ++i) {
        data.weights.push_back(random_weight(random, recipe.weights, recipe.short_numbers));
    }
    wrap_periodic_axes(data);
    if (recipe.weights == Weights::some_zero && !reference::weights_suit(data)) {
        std::replace(data.weights.begin(), data.weights.end(), 0.0, 0.5);
    }
    return data;
}

AxisRecipe random_axis(Random &random, int degree) {
    AxisRecipe axis;
    axis.degree = degree;
    axis.form =
        one_of(random, {KnotForm::clamped, KnotForm::half_clamped, KnotForm::unclamped, KnotForm::periodic});
    axis.spacing =
        one_of(random, {Spacing::integers, Spacing::few_bits, Spacing::full, Spacing::ratio, Spacing::tiny});
    axis.placement = one_of(random, {Placement::origin, Placement::origin, Placement::origin,
                                     Placement::offset, Placement::small, Placement::large});
    axis.spans = random.whole(1, 6);
    return axis;
}

Recipe random_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe;
    for (int k = 0; k < axes; ++k) {
        recipe.axes.push_back(random_axis(random, random.whole(0, max_degree)));
    }
    recipe.weights = one_of(random, {Weights::none, Weights::none, Weights::ones, Weights::moderate,
                                     Weights::extreme, Weights::some_zero});
    recipe.dim = one_of(random, {1, 2, 3, 3, 6});
    recipe.short_numbers = random.chance(30);
    return recipe;
}

double random_param(Random &random, const std::vector<double> &knots, int degree) {
    const double a = knots[static_cast<size_t>(degree)];
    const double b = knots[knots.size() - static_cast<size_t>(degree) - 1];
    const double knot = std::clamp(knots[random.bits() % knots.size()], a, b);
    switch (random.whole(0, 9)) {
    case 0:
        return knot;
    case 1:
        return std::clamp(std::nextafter(knot, a), a, b);
    case 2:
        return std::clamp(std::nextafter(knot, b), a, b);
    case 3:
        return random.chance(50) ? a : b;
    case 4: {
        const double step = (b - a) * random.magnitude(1e-15, 1e-3);
        return std::clamp(random.chance(50) ? a + step : b - step, a, b);
    }
    case 5: { // inside a random span, however short
        const size_t i = random.bits() % (knots.size() - 1);
        return std::clamp(random.between(knots[i], knots[i + 1]), a, b);
    }
    default:
        return std::clamp(random.between(a, b), a, b);
    }
}

double random_new_knot(Random &random, const SplineData &data, int axis) {
    const auto &knots = data.knots[static_cast<size_t>(axis)];
    const double t = random_param(random, knots, data.degrees[static_cast<size_t>(axis)]);
    const double rounding = 16 * 0x1p-52 * std::max(std::fabs(knots.front()), std::fabs(knots.back()));
    for (const double knot : knots) {
        if (data.periodic(axis) && std::fabs(t - knot) <= rounding) {
            return std::clamp(knot, data.lower(axis), data.upper(axis));
        }
    }
    return t;
}

double away_from_underflow(double t) {
    return std::fabs(t) < 1e-30 ? 0 : t;
}

std::vector<double> away_from_underflow(std::vector<double> params) {
    for (double &t : params) {
        t = away_from_underflow(t);
    }
    return params;
}

std::vector<double> random_params(Random &random, const SplineData &data, int n) {
    std::vector<double> params;
    for (int i = 0; i < n; ++i) {
        for (size_t k = 0; k < data.degrees.size(); ++k) {
            params.push_back(random_param(random, data.knots[k], data.degrees[k]));
        }
    }
    return params;
}

} // namespace support
