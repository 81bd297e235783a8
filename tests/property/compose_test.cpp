// Composition: g(f(t)) against exact values, knots against the continuity, laws.
#include "property/same_shape.h"
#include "reference/definition.h"

#include <optional>

using namespace support;
using reference::Rational;

namespace {

using Point = std::vector<Rational>;

Handle compose(const nurbs *g, const nurbs *f) {
    nurbs *out = nullptr;
    require_ok(nurbs_compose(g, f, &out));
    return Handle(out);
}

double size_of(const Rational &x) {
    return std::fabs(static_cast<double>(reference::quotient(numerator(x), denominator(x))));
}

// The non-empty span of the domain of an axis that holds t.
int64_t span_of(const std::vector<double> &knots, int degree, const Rational &t) {
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
Point value_at(const SplineData &data, const Point &params, size_t k = 0, int64_t base = 0) {
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
double largest_slope(const SplineData &data, int axis) {
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

double largest_point(const SplineData &data) {
    double largest = 0;
    for (const double x : data.points) {
        largest = std::max(largest, std::fabs(x));
    }
    return largest;
}

// The uncertainty of a coordinate of f of the header, over all spans.
double uncertainty(const SplineData &f, int k) {
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

// What control points of the composition may be off by, in homogeneous space, with the constant of the header.
double allowed(const SplineData &g, const SplineData &f) {
    double bound = (2 * g.axes() + 1) * static_cast<double>(eps) * largest_point(g);
    for (int k = 0; k < g.axes(); ++k) {
        bound += uncertainty(f, k) * largest_slope(g, k);
    }
    return bound;
}

// Whether f is so near a knot at which g jumps that either side may be meant.
bool near_jump(const SplineData &g, const SplineData &f, const Point &value) {
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

// Compares at parameters of the result; `factor` multiplies the bound.
void expect_composed(const Made &made, Random &random, double factor, WorstErrors &worst,
                     const std::string &place) {
    const double bound = allowed(made.g, made.f);
    for (int n = 0; n < 3; ++n) {
        const double t = random_params(random, made.h, 1)[0];
        const Point u = value_at(made.f, {reference::exact(t)});
        if (near_jump(made.g, made.f, u)) {
            continue;
        }
        const Point want = value_at(made.g, u), got = value_at(made.h, {reference::exact(t)});
        for (size_t c = 0; c < want.size(); ++c) {
            const double error = size_of(got[c] - want[c]);
            if (error != 0) {
                worst.add(made.h.degrees[0], error / (factor * bound), error / (factor * bound));
            }
            ASSERT_LE(error, factor * bound) << place << " at " << hex(t);
        }
    }
}

// A plain curve of degree q with knots of its own and no points yet.
SplineData parameter_curve(Random &random, int q, int dim) {
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
std::vector<double> rising_values(Random &random, int64_t n, double lower, double upper,
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
SplineData outer_spline(Random &random, int axes, int max_degree) {
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

int degree_total(const SplineData &g) {
    int total = 0;
    for (const int32_t p : g.degrees) {
        total += p;
    }
    return total;
}

// Coordinates of f that rise or fall, each within the domain of its axis.
void set_monotone_points(Random &random, const SplineData &g, SplineData &f) {
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

// The same spline, built of homogeneous points.
Handle homogeneous_form(const nurbs *g) {
    nurbs *records = nullptr, *out = nullptr;
    require_ok(nurbs_to_homogeneous(g, &records));
    const Handle holder(records);
    require_ok(nurbs_from_homogeneous(records, &out));
    return Handle(out);
}

TEST(Compose, is_the_composition_at_every_point) {
    WorstErrors worst("compositions by degree, unit the bound");
    for_each_case(910000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        const SplineData data = outer_spline(random, axes, axes == 1 ? 6 : axes == 2 ? 3 : 2);
        const int total = degree_total(data);
        const int most = total == 0 ? 3 : std::min(axes == 1 ? 5 : 3, (axes == 1 ? 16 : 12) / total);
        SplineData f = parameter_curve(random, random.whole(1, std::max(1, most)), axes);
        set_monotone_points(random, data, f);
        auto g = create(data);
        if (data.rational() && random.chance(30)) {
            g = homogeneous_form(g.get());
        }
        const auto curve = create(f);
        const auto made = compose(g.get(), curve.get());
        const SplineData h = homogeneous(made.get());
        ASSERT_EQ(h.degrees[0], total * f.degrees[0]);
        ASSERT_EQ(h.lower(0), f.lower(0));
        ASSERT_EQ(h.upper(0), f.upper(0));
        expect_composed({homogeneous(g.get()), f, h}, random, 1, worst, where(seed, data) + where(seed, f));
    });
}

// An outer spline over whole numbers, and inner curves whose control points are multiples of 1/4: they touch knot
// lines, run along them and pass through their corners.
SplineData whole_knots(Random &random, int axes, int degree) {
    Recipe recipe = random_recipe(random, axes, degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spacing = Spacing::integers;
        axis.placement = Placement::origin;
        axis.form = random.chance(50) ? KnotForm::clamped : KnotForm::unclamped;
        axis.spans = 3;
    }
    recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
    recipe.dim = 2;
    return random_spline(random, recipe);
}

SplineData wandering_curve(Random &random, const SplineData &g, int q) {
    SplineData f;
    f.degrees = {q};
    f.dim = g.axes();
    const int pieces = random.whole(1, 3);
    const bool closed = random.chance(25);
    std::vector<double> &knots = f.knots.emplace_back();
    for (int i = closed ? -q : 0; i <= (closed ? pieces + q : pieces); ++i) {
        const bool end = i == 0 || i == pieces;
        knots.insert(knots.end(),
                     closed ? 1
                     : end  ? static_cast<size_t>(q) + 1
                            : random.bits() % static_cast<size_t>(q) + 1,
                     i);
    }
    f.counts = {static_cast<int64_t>(knots.size()) - q - 1};
    f.flags = closed ? NURBS_PERIODIC : 0;
    for (int64_t i = 0; i < f.counts[0]; ++i) {
        for (int k = 0; k < f.dim; ++k) {
            const double length = g.upper(k) - g.lower(k);
            const double free = g.lower(k) + std::floor(4 * length * random.unit() + 0.5) / 4;
            f.points.push_back(closed && i >= pieces ? f.coordinate(i - pieces, k) : free);
        }
    }
    return f;
}

// The polar values of f lie in the box of its control points, R shortest spans long: then both coefficients of a step
// of de Boor's algorithm have magnitudes of at most 1 + 2 R together.
double largest_factor(const SplineData &g, const SplineData &f) {
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

TEST(Compose, curves_may_touch_knot_lines_and_turn_back) {
    WorstErrors worst("curves on surfaces and in volumes by degree, unit the bound");
    for_each_case(920000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(80) ? 2 : 3;
        const SplineData data = whole_knots(random, axes, 2);
        const SplineData f = wandering_curve(random, data, random.whole(1, 3));
        const auto g = create(data), curve = create(f);
        const auto made = compose(g.get(), curve.get());
        expect_composed({homogeneous(g.get()), f, homogeneous(made.get())}, random, largest_factor(data, f),
                        worst, where(seed, data) + where(seed, f));
    });
}

// A polynomial spline over whole numbers from 0 to 16.
SplineData up_to_sixteen(Random &random, int axes, int max_degree) {
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
SplineData diagonal(int axes, int q, double lower, double upper) {
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

TEST(Compose, where_f_is_exact_control_points_are_within_2_eps) {
    WorstErrors worst("points for exact f by degree, unit eps * hull");
    for_each_case(930000, 500, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data = up_to_sixteen(random, axes, axes == 1 ? 7 : 3);
        const SplineData f =
            diagonal(axes, random.whole(0, 1) + 1, 0, 16); // all its polar values are multiples of 1/4
        const SplineData h = read_back(compose(create(data).get(), create(f).get()).get());
        for (int n = 0; n < 4; ++n) {
            const double t = random.whole(0, 15) + random.unit() / 2 + 0.25; // between knots
            const Point want = value_at(data, Point(static_cast<size_t>(axes), reference::exact(t)));
            const Point got = value_at(h, {reference::exact(t)});
            for (size_t c = 0; c < want.size(); ++c) {
                const double unit = static_cast<double>(eps) * largest_point(data);
                const double error = size_of(got[c] - want[c]);
                if (error != 0) {
                    worst.add(h.degrees[0], error / unit / (2 * axes), error / unit);
                    ASSERT_LE(error, 2 * axes * unit) << where(seed, data);
                }
            }
        }
    });
}

// Knots inside occur as often as the continuity asks for, and nowhere else.
TEST(Compose, keeps_the_continuity) {
    for_each_case(940000, 400, [](Random &random, uint64_t seed) {
        const SplineData data = whole_knots(random, 1, 5);
        const int p = data.degrees[0], q = random.whole(1, std::max(1, 12 / std::max(p, 1)));
        const SplineData f = diagonal(1, q, data.lower(0), data.upper(0));
        const auto got = read_back(compose(create(data).get(), create(f).get()).get());
        std::vector<double> wanted(static_cast<size_t>(p * q) + 1, data.lower(0));
        const auto &t = data.knots[0];
        for (const double knot : t) {
            if (data.lower(0) < knot && knot < data.upper(0) &&
                std::count(wanted.begin(), wanted.end(), knot) == 0) {
                const auto copies = p * q - p + static_cast<int>(std::count(t.begin(), t.end(), knot));
                wanted.insert(wanted.end(), static_cast<size_t>(copies), knot);
            }
        }
        wanted.insert(wanted.end(), static_cast<size_t>(p * q) + 1, data.upper(0));
        ASSERT_EQ(got.knots[0].size(), wanted.size()) << where(seed, data) << " degree " << q;
        for (size_t i = 0; i < wanted.size(); ++i) { // to the last place: crossings are found from values
            ASSERT_NEAR(got.knots[0][i], wanted[i], 8 * static_cast<double>(eps) * std::fabs(wanted[i]));
        }
    });
}

TEST(Compose, with_the_identity_gives_the_same_bits) {
    for_each_case(950000, 300, [](Random &random, uint64_t seed) {
        const SplineData data = up_to_sixteen(random, 1, 9), f = diagonal(1, 1, 0, 16);
        const auto got = read_back(compose(create(data).get(), create(f).get()).get());
        ASSERT_TRUE(same_bits(got.knots[0], data.knots[0])) << where(seed, data);
        ASSERT_TRUE(same_bits(got.points, data.points)) << where(seed, data);
    });
}

// A line along an axis of the parameter plane traces the iso-curve.
TEST(Compose, with_a_line_of_the_plane_gives_the_iso_curve) {
    for_each_case(960000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = whole_knots(random, 2, 3);
        const int along = random.whole(0, 1), across = 1 - along;
        const double at =
            data.lower(across) + (data.upper(across) - data.lower(across)) * random.whole(0, 8) / 8;
        SplineData f;
        f.degrees = {1};
        f.dim = 2;
        f.counts = {2};
        f.knots = {{0, 0, 1, 1}};
        f.points = {at, at, at, at};
        f.points[static_cast<size_t>(along)] = data.lower(along);
        f.points[static_cast<size_t>(2 + along)] = data.upper(along);
        const auto g = create(data);
        const auto traced = compose(g.get(), create(f).get()), wanted = iso(g.get(), across, at);
        const double hull = largest_point(data);
        for (int n = 0; n < 5; ++n) {
            const double t = random.whole(0, 64) / 64.0;
            const auto got = eval(traced.get(), {t});
            const auto want =
                eval(wanted.get(), {data.lower(along) + (data.upper(along) - data.lower(along)) * t});
            for (size_t c = 0; c < got.size(); ++c) { // weights of a ratio of at most 100
                ASSERT_NEAR(got[c], want[c], 2e-12 * hull) << where(seed, data) << " at " << at << ", " << t;
            }
        }
    });
}

// A polynomial curve whose knots and period are whole.
SplineData whole_period(Random &random, int max_degree) {
    Recipe recipe = random_recipe(random, 1, max_degree);
    recipe.axes[0].form = KnotForm::periodic;
    recipe.axes[0].spacing = Spacing::integers;
    recipe.axes[0].placement = Placement::origin;
    recipe.weights = Weights::none;
    return random_spline(random, recipe);
}

TEST(Compose, runs_around_periodic_axes) {
    for_each_case(970000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = whole_period(random, 5);
        const double length = data.upper(0) - data.lower(0);
        SplineData f;
        f.degrees = {2};
        f.dim = 1;
        f.counts = {3};
        f.knots = {{0, 0, 0, 1, 1, 1}};
        const double from = data.lower(0) - random.whole(0, 12) * length / 4,
                     by = (random.chance(50) ? 1 : -1) * random.whole(1, 12) * length / 4;
        f.points = {from, from + by / 4, from + by};
        const auto g = create(data), curve = create(f);
        const auto h = compose(g.get(), curve.get());
        for (int n = 0; n < 5; ++n) {
            const double t = random.whole(1, 1023) / 1024.0;
            const double u = eval(curve.get(), {t})[0];
            const double turn = (u - data.lower(0)) / length;
            const auto &knots = data.knots[0];
            const double place = data.lower(0) + (turn - std::floor(turn)) * length;
            const bool at_knot = std::any_of(knots.begin(), knots.end(), [&](double knot) {
                return std::fabs(knot - place) < 1e-9 * length;
            });
            const auto got = eval(h.get(), {t});
            const auto want = eval(g.get(), {u}, NURBS_WRAP);
            for (size_t c = 0; c < got.size() && !at_knot; ++c) {
                ASSERT_NEAR(got[c], want[c],
                            1e-13 * (largest_point(data) + largest_slope(data, 0) * (std::fabs(u) + length)))
                    << where(seed, data) << hex(f.points) << " at " << t;
            }
        }
    });
}

// At the middle of a cell, from either side.
TEST(Compose, curves_touch_knot_lines_from_either_side) {
    WorstErrors worst("curves that touch knot lines by degree, unit the bound");
    for_each_case(990000, 200, [&](Random &random, uint64_t seed) {
        const SplineData data = whole_knots(random, 2, 3);
        const int across = random.whole(0, 1), along = 1 - across;
        const double length = data.upper(across) - data.lower(across);
        const double knot = data.lower(across) + random.whole(0, static_cast<int>(length));
        const double room = std::min(knot - data.lower(across), data.upper(across) - knot);
        const double depth = random.chance(50) ? room : -room;
        SplineData f;
        f.degrees = {2};
        f.dim = 2;
        f.counts = {3};
        f.knots = {{0, 0, 0, 1, 1, 1}};
        f.points.resize(6);
        for (size_t i = 0; i < 3; ++i) {
            f.points[2 * i + static_cast<size_t>(across)] = i == 1 ? knot - depth : knot + depth;
            f.points[2 * i + static_cast<size_t>(along)] =
                data.lower(along) + (data.upper(along) - data.lower(along)) * random.whole(0, 8) / 8;
        }
        const auto made = compose(create(data).get(), create(f).get());
        expect_composed({homogeneous(create(data).get()), f, homogeneous(made.get())}, random,
                        largest_factor(data, f), worst, where(seed, data) + where(seed, f));
    });
}

// The largest control point of the derivative, of differences over `shortest` at least.
double slope_over(const SplineData &data, double shortest) {
    const int p = data.degrees[0];
    double largest = 0;
    for (int64_t i = 0; i + 1 < data.counts[0]; ++i) {
        const auto at = static_cast<size_t>(i);
        const double length = data.knots[0][at + static_cast<size_t>(p) + 1] - data.knots[0][at + 1];
        for (int c = 0; c < data.dim && length >= shortest; ++c) {
            largest =
                std::max(largest, p * std::fabs(data.coordinate(i + 1, c) - data.coordinate(i, c)) / length);
        }
    }
    return largest;
}

// A polynomial curve over [0, 3] with `copies` knots within a few ulps of 1 and of 2, some of them equal.
SplineData clustered(Random &random, int p) {
    SplineData data;
    data.degrees = {p};
    data.dim = 1;
    std::vector<double> &knots = data.knots.emplace_back(static_cast<size_t>(p) + 1, 0);
    for (double knot : {1.0, 2.0}) {
        for (int copies = random.whole(0, p + 2), times = 0; copies > 0; --copies) {
            const bool next = times > p || random.chance(60);
            knot = next ? std::nextafter(knot, 3) : knot;
            times = next ? 1 : times + 1;
            knots.push_back(knot);
        }
    }
    knots.insert(knots.end(), static_cast<size_t>(p) + 1, 3);
    data.counts = {static_cast<int64_t>(knots.size()) - p - 1};
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return data;
}

// What a value of f in a long span, exact at its ends, is known to, and what that comes to in g; twice, as f may
// stand for a knot from either side.
double allowed_over(const SplineData &g, const SplineData &f, double shortest) {
    const double t = std::max(std::fabs(f.lower(0)), std::fabs(f.upper(0)));
    const double known =
        static_cast<double>(eps) * (4 * (f.degrees[0] + 1) * largest_point(f) + t * slope_over(f, shortest));
    return 2 * (3 * static_cast<double>(eps) * largest_point(g) + known * slope_over(g, shortest));
}

void expect_composed_at(const SplineData &g, const SplineData &f, const SplineData &h, double t, double bound,
                        WorstErrors &worst, const std::string &place) {
    const Point want = value_at(g, value_at(f, {reference::exact(t)}));
    const Point got = value_at(h, {reference::exact(t)});
    const double error = size_of(got[0] - want[0]);
    if (error != 0) {
        worst.add(h.degrees[0], error / bound, error / bound);
    }
    ASSERT_LE(error, bound) << place << " at " << hex(t);
}

TEST(Compose, knots_may_be_nearer_to_each_other_than_values_are_known) {
    WorstErrors worst("curves over clusters of knots by degree, unit the bound");
    for_each_case(991000, 500, [&](Random &random, uint64_t seed) {
        const SplineData g = clustered(random, random.whole(1, 4));
        const SplineData f = diagonal(1, random.whole(1, 3), 0, 3);
        const SplineData h = read_back(compose(create(g).get(), create(f).get()).get());
        for (int span = 0; span < 3; ++span) {
            const double t = span + random.whole(1, 1023) / 1024.0;
            expect_composed_at(g, f, h, t, allowed_over(g, f, 0.5), worst, where(seed, g) + where(seed, f));
        }
    });
}

// f rises by much within an ulp, so that no crossing could be told apart there; the spans beside are not touched.
TEST(Compose, steep_pieces_do_not_reach_their_neighbours) {
    WorstErrors worst("curves beside steep pieces by degree, unit the bound");
    for_each_case(992000, 500, [&](Random &random, uint64_t seed) {
        const SplineData g = up_to_sixteen(random, 1, 3);
        SplineData one = g; // its first coordinate
        one.dim = 1;
        one.points.clear();
        for (int64_t i = 0; i < g.counts[0]; ++i) {
            one.points.push_back(g.coordinate(i, 0));
        }
        const int q = random.whole(1, 3);
        SplineData f;
        f.degrees = {q};
        f.dim = 1;
        f.knots = {std::vector<double>(static_cast<size_t>(q) + 1, 1000)};
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q), 1001);
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q), std::nextafter(1001.0, 1002));
        f.knots[0].insert(f.knots[0].end(), static_cast<size_t>(q) + 1, 1002);
        f.counts = {3 * q + 1};
        const double step = random.between(7, 8), rise = random.chance(50) ? 0.4 : random.between(0, 1);
        for (int i = 0; i <= 3 * q; ++i) {
            f.points.push_back(i <= q       ? step * i / q
                               : i <= 2 * q ? step + rise * (i - q) / q
                                            : step + rise + (16 - step - rise) * (i - 2 * q) / q);
        }
        const SplineData h = read_back(compose(create(one).get(), create(f).get()).get());
        for (int n = 0; n < 6; ++n) {
            const double t = 1000 + n % 2 + random.whole(1, 1023) / 1024.0;
            const Point u = value_at(f, {reference::exact(t)});
            if (!near_jump(one, f, u)) {
                expect_composed_at(one, f, h, t, allowed_over(one, f, 0.5), worst,
                                   where(seed, one) + where(seed, f));
            }
        }
    });
}

// Whole periods, of whole length, so that places in the first period are known exactly.
TEST(Compose, far_away_costs_and_loses_no_more_than_the_place) {
    for_each_case(993000, 100, [](Random &random, uint64_t seed) {
        const SplineData data = whole_period(random, 4);
        const double length = data.upper(0) - data.lower(0);
        const double away = std::ldexp(random.chance(50) ? -length : length, random.whole(10, 30));
        SplineData near;
        near.degrees = {1};
        near.dim = 1;
        near.counts = {2};
        near.knots = {{0, 0, 1, 1}};
        near.points = {data.lower(0) + length / 4, data.lower(0) + length};
        SplineData far = near;
        far.points = {near.points[0] + away, near.points[1] + away};
        const auto g = create(data);
        const auto got = read_back(compose(g.get(), create(far).get()).get());
        const auto want = read_back(compose(g.get(), create(near).get()).get());
        ASSERT_EQ(got.counts[0], want.counts[0]) << where(seed, data);
        for (size_t i = 0; i < want.points.size(); ++i) {
            ASSERT_NEAR(got.points[i], want.points[i],
                        static_cast<double>(eps) *
                            (16 * std::fabs(away) * largest_slope(data, 0) + 4 * largest_point(data)))
                << where(seed, data) << hex(far.points);
        }
    });
}

// Powers of two, so that every bit stays: models in micrometres, parameters in milliseconds.
TEST(Compose, is_scale_free) {
    for_each_case(980000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = outer_spline(random, 1, 4);
        SplineData f = parameter_curve(random, 2, 1);
        set_monotone_points(random, data, f);
        const auto got = read_back(compose(create(data).get(), create(f).get()).get());
        SplineData scaled = data, inner = f;
        const auto times = [](std::vector<double> &values, double factor) {
            std::for_each(values.begin(), values.end(), [factor](double &x) { x *= factor; });
        };
        times(scaled.knots[0], 0x1p-30);
        times(inner.points, 0x1p-30);
        times(inner.knots[0], 0x1p20);
        times(scaled.points, 0x1p-20);
        auto back = read_back(compose(create(scaled).get(), create(inner).get()).get());
        times(back.knots[0], 0x1p-20);
        times(back.points, 0x1p20);
        ASSERT_TRUE(same_bits(got.points, back.points)) << where(seed, data) << where(seed, f);
        ASSERT_TRUE(same_bits(got.knots[0], back.knots[0])) << where(seed, data) << where(seed, f);
    });
}

} // namespace
