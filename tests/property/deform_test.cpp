// Deformations against their formulas, and against what the calls say of themselves.
#include "property/influences.h"
#include "reference/definition.h"

using namespace support;

namespace {

Recipe calm_recipe(Random &random, int axes, int max_degree, int dim) {
    Recipe recipe;
    recipe.dim = dim;
    recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
    for (int k = 0; k < axes; ++k) {
        AxisRecipe axis = random_axis(random, random.whole(1, max_degree));
        axis.form = random.chance(60)   ? KnotForm::clamped
                    : random.chance(50) ? KnotForm::unclamped
                                        : KnotForm::periodic;
        axis.spacing = random.chance(50) ? Spacing::integers : Spacing::few_bits;
        axis.placement = Placement::origin;
        axis.spans = random.whole(1, 5);
        recipe.axes.push_back(axis);
    }
    return recipe;
}

std::vector<double> direction_of(Random &random, int dim) {
    std::vector<double> direction;
    for (int c = 0; c < dim; ++c) {
        direction.push_back(random.between(-1, 1));
    }
    direction[0] += 2;
    return direction;
}

std::vector<double> any_range(Random &random, const SplineData &data) {
    std::vector<double> range;
    for (int k = 0; k < data.axes(); ++k) {
        const double lower = data.lower(k), length = data.upper(k) - lower;
        const double a = random.chance(25) ? 0 : random.whole(1, 3) / 8.0,
                     b = random.chance(25) ? 1 : random.whole(5, 7) / 8.0;
        range.push_back(lower + a * length);
        range.push_back(b == 1 ? data.upper(k) : lower + b * length);
    }
    return range;
}

Point step_between(const nurbs *before, const nurbs *after, const std::vector<double> &param) {
    return minus(point_at(read_back(after), param), point_at(read_back(before), param));
}

// The B-spline over even knots at t, without rounding of the knots, and over its value in the middle.
long double bump(double lower, double upper, int degree, double t) {
    const long double n = degree + 1, x = (static_cast<long double>(t) - lower) /
                                          (static_cast<long double>(upper) - lower) * n;
    const auto cardinal = [degree](long double at) { // sum (-1)^j binomial(d + 1, j) (x - j)_+^d, d! apart
        long double sum = 0;
        for (int j = 0; j <= degree + 1; ++j) {
            const long double part = std::max<long double>(at - j, 0);
            sum += (j % 2 == 0 ? 1 : -1) * static_cast<long double>(binomial(degree + 1, j)) *
                   std::pow(part, degree);
        }
        return sum;
    };
    return x <= 0 || x >= n ? 0 : cardinal(x) / cardinal(n / 2);
}

TEST(Warp, adds_the_bump) {
    for_each_case(1510000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data =
            random_spline(random, calm_recipe(random, axes, axes == 1 ? 5 : 3, random.whole(1, 3)));
        const std::vector<double> range = any_range(random, data), direction = direction_of(random, data.dim);
        const int order = random.whole(0, 3);
        const double distance = random.between(-2, 2);
        const Handle g = create(data);
        nurbs *out = nullptr;
        const nurbs_status status =
            nurbs_warp(g.get(), range.data(), direction.data(), distance, order, &out);
        const Handle h(out);
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const SplineData after = read_back(h.get());
        for (int k = 0; k < axes; ++k) {
            ASSERT_EQ(after.periodic(k), data.periodic(k)) << where(seed, data);
        }
        long double length = 0;
        for (const double x : direction) {
            length = std::hypot(length, static_cast<long double>(x));
        }
        for (int n = 0; n < 6; ++n) {
            const std::vector<double> param = random_params(random, data, 1);
            bool knot = false; // where the limits of jumps differ
            long double height = distance;
            for (int k = 0; k < axes; ++k) {
                const auto at = static_cast<size_t>(k);
                height *= bump(range[2 * at], range[2 * at + 1], order + 1, param[at]);
                knot = knot ||
                       std::count(data.knots[at].begin(), data.knots[at].end(), param[at]) > data.degrees[at];
            }
            const Point step = step_between(g.get(), h.get(), param);
            // The products and sums of degrees up to p + order + 1 on each axis, knots rounded relative to
            // spans of at least 1 / 64 of the domain's size.
            const long double bound = 1 << 14,
                              unit = eps * (extent(data) + std::fabs(distance)) * (data.rational() ? 25 : 1);
            for (size_t c = 0; c < step.size() && !knot; ++c) {
                ASSERT_LE(std::fabs(as_long_double(step[c]) - height * direction[c] / length), bound * unit)
                    << where(seed, data) << hex(range) << " at " << hex(param);
            }
        }
    });
}

// The derivatives of the difference at the ends of the range vanish up to the order, and outside there is
// none.
TEST(Warp, keeps_derivatives_at_the_ends) {
    for_each_case(1520000, 150, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 5, 2);
        recipe.weights = Weights::none;
        const SplineData data = random_spline(random, recipe);
        const std::vector<double> range = any_range(random, data), direction = {0, 1};
        const int order = random.whole(0, 4);
        const Handle g = create(data);
        nurbs *out = nullptr;
        require_ok(nurbs_warp(g.get(), range.data(), direction.data(), 1, order, &out));
        const Handle h(out);
        const SplineData after = read_back(h.get());
        for (const int end : {0, 1}) {
            const double t = range[static_cast<size_t>(end)];
            const reference::Sides left{end == 1};
            const auto a = reference::exact_derivatives(data, order, &t, left),
                       b = reference::exact_derivatives(after, order, &t, left);
            for (int k = 0; k <= order; ++k) {
                const auto at = static_cast<size_t>(k);
                for (size_t c = 0; c < 2; ++c) {
                    const Rational gap = Rational(a[at][c].numerator, a[at][c].denominator) -
                                         Rational(b[at][c].numerator, b[at][c].denominator);
                    const long double spans =
                        std::pow(static_cast<long double>(64 * 32) / (data.upper(0) - data.lower(0)), k);
                    ASSERT_LE(std::fabs(as_long_double(gap)), 64 * eps * spans * 1024 * (extent(data) + 1))
                        << where(seed, data) << hex(range) << " derivative " << k;
                }
            }
        }
    });
}

TEST(Flatten, makes_the_middle_flat_and_keeps_the_outside) {
    for_each_case(1530000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data =
            random_spline(random, calm_recipe(random, axes, axes == 1 ? 5 : 3, random.whole(2, 3)));
        std::vector<double> range = any_range(random, data);
        const std::vector<double> point = direction_of(random, data.dim),
                                  normal = direction_of(random, data.dim);
        const Handle g = create(data);
        double moved = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_flatten(g.get(), range.data(), point.data(), normal.data(), nullptr, &moved, &out));
        const Handle h(out);
        const SplineData after = read_back(h.get());
        const long double rounding = 4096 * eps * (extent(data) + 4) * (data.rational() ? 25 : 1);
        for (int n = 0; n < 6; ++n) {
            std::vector<double> param = random_params(random, data, 1);
            bool outside = false;
            for (int k = 0; k < axes; ++k) {
                const auto at = static_cast<size_t>(k);
                outside = outside || param[at] < range[2 * at] || param[at] > range[2 * at + 1];
            }
            const long double gap = length(step_between(g.get(), h.get(), param));
            ASSERT_LE(gap, outside ? rounding : moved + rounding)
                << where(seed, data) << hex(range) << hex(param);
            for (size_t k = 0; k < param.size(); ++k) {
                param[k] = (range[2 * k] + range[2 * k + 1]) / 2;
            }
            const Point middle = point_at(after, param);
            long double height = 0, size = 0;
            for (size_t c = 0; c < middle.size(); ++c) {
                height += as_long_double(Rational(middle[c] - exact(point[c]))) * normal[c];
                size = std::hypot(size, static_cast<long double>(normal[c]));
            }
            ASSERT_LE(std::fabs(height) / size, rounding) << where(seed, data) << hex(range);
        }
    });
}

struct BendCase {
    std::vector<double> origin, along, across;
    double curvature, lower, upper;
};

std::vector<long double> bent(const BendCase &rule, const Point &point) {
    const size_t dim = point.size();
    std::vector<long double> e(rule.along.begin(), rule.along.end()),
        n(rule.across.begin(), rule.across.end());
    const auto dot = [dim](const auto &a, const auto &b) {
        long double sum = 0;
        for (size_t c = 0; c < dim; ++c) {
            sum += a[c] * b[c];
        }
        return sum;
    };
    const auto unit = [&](std::vector<long double> &x) {
        const long double size = std::sqrt(dot(x, x));
        for (long double &value : x) {
            value /= size;
        }
    };
    unit(e);
    const long double part = dot(e, n);
    for (size_t c = 0; c < dim; ++c) {
        n[c] -= part * e[c];
    }
    unit(n);
    std::vector<long double> x;
    for (size_t c = 0; c < dim; ++c) {
        x.push_back(as_long_double(Rational(point[c] - exact(rule.origin[c]))));
    }
    const long double k = rule.curvature, a = dot(x, e), b = dot(x, n),
                      u = std::clamp<long double>(a, rule.lower, rule.upper), far = a - u;
    const long double to_a = (1 / k + b) * std::sin(k * u) + far * std::cos(k * u),
                      to_b = (1 / k + b) * std::cos(k * u) - 1 / k - far * std::sin(k * u);
    std::vector<long double> image;
    for (size_t c = 0; c < dim; ++c) {
        image.push_back(rule.origin[c] + x[c] + (to_a - a) * e[c] + (to_b - b) * n[c]);
    }
    return image;
}

long double gap_between(const Point &point, const std::vector<long double> &image) {
    long double sum = 0;
    for (size_t c = 0; c < point.size(); ++c) {
        sum = std::hypot(sum, as_long_double(point[c]) - image[c]);
    }
    return sum;
}

TEST(Bend, is_within_the_tolerance_of_the_exact_image) {
    int proofs = 0;
    for_each_case(1540000, 60, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(70) ? 1 : 2;
        const SplineData data = random_spline(random, calm_recipe(random, axes, 4, random.whole(2, 3)));
        const double size = extent(data);
        BendCase rule{{},
                      direction_of(random, data.dim),
                      direction_of(random, data.dim),
                      random.between(0.2, 2) / size,
                      -HUGE_VAL,
                      HUGE_VAL};
        rule.across[0] -= 4; // not along it
        rule.origin.assign(static_cast<size_t>(data.dim), 0.1 * size);
        if (axes == 1 && random.chance(50)) {
            rule.lower = -0.3 * size;
            rule.upper = 0.4 * size;
        }
        const double tolerance = size * (axes == 1 ? random.magnitude(1e-9, 1e-3) : 1e-3);
        const Handle g = create(data);
        double deviation = -1;
        int32_t proven = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_bend(g.get(), rule.origin.data(), rule.along.data(), rule.across.data(),
                              rule.curvature, rule.lower, rule.upper, tolerance, &deviation, &proven, &out));
        const Handle h(out);
        proofs += proven;
        ASSERT_LE(deviation, tolerance);
        const SplineData after = read_back(h.get());
        for (int n = 0; n < 20; ++n) {
            const std::vector<double> param = random_params(random, after, 1);
            const long double gap = gap_between(point_at(after, param), bent(rule, point_at(data, param)));
            ASSERT_LE(gap, (proven == 1 ? deviation : tolerance) + 64 * eps * size)
                << where(seed, data) << hex(param);
        }
    });
    std::printf("%d bounds proven\n", proofs);
}

// A polyline at integers, its corners on the line through origin and (1, 1 / 4) if it is straight.
SplineData polyline(int corners, bool straight, KnotForm form) {
    SplineData data;
    data.dim = 2;
    data.degrees = {1};
    const bool periodic = form == KnotForm::periodic;
    std::vector<double> knots;
    for (int i = 0; i < corners + 2; ++i) {
        knots.push_back(form == KnotForm::clamped ? std::clamp(i, 1, corners) : i);
        if (i < corners) {
            const double x = i % (periodic ? corners - 1 : corners);
            data.points.insert(data.points.end(),
                               {x / corners, straight ? 0.25 * x / corners : 0.1 * ((i * 7) % 3)});
        }
    }
    data.points[data.points.size() - 1] = periodic ? data.points[1] : data.points.back();
    data.counts = {corners};
    data.knots = {knots};
    data.flags = periodic ? NURBS_PERIODIC : 0;
    return data;
}

SplineData bent_by_one(const SplineData &data, double tolerance, int32_t &proven, int places = 200) {
    const double origin[] = {0.1, 0}, along[] = {1, 0}, across[] = {0, 1};
    double deviation = -1;
    nurbs *out = nullptr;
    const nurbs_status status = nurbs_bend(create(data).get(), origin, along, across, 3, -HUGE_VAL, HUGE_VAL,
                                           tolerance, &deviation, &proven, &out);
    EXPECT_EQ(status, NURBS_OK) << last_error();
    const Handle h(out);
    const SplineData after = read_back(h.get());
    EXPECT_LE(deviation, tolerance);
    const BendCase rule{{0.1, 0}, {1, 0}, {0, 1}, 3, -HUGE_VAL, HUGE_VAL};
    for (int i = 0; i <= places; ++i) {
        const double t = data.lower(0) + (data.upper(0) - data.lower(0)) * i / places;
        EXPECT_LE(gap_between(point_at(after, {t}), bent(rule, point_at(data, {t}))), deviation);
    }
    return after;
}

// Of 1e-9^(-1 / 4) = 178 cubic pieces to each unit of length times curvature; of degree 1 it takes 10^4.
TEST(Bend, polylines_become_cubic) {
    for (const KnotForm form : {KnotForm::clamped, KnotForm::unclamped, KnotForm::periodic}) {
        int32_t proven = -1;
        const SplineData line = bent_by_one(polyline(5, form != KnotForm::periodic, form), 1e-9, proven);
        EXPECT_EQ(proven, 1);
        EXPECT_EQ(line.degrees[0], 3);
        EXPECT_LE(line.point_count(), 600);
        EXPECT_EQ(line.periodic(0), form == KnotForm::periodic);
    }
}

// Corners are knots of multiplicity degree, where values are met; all others are smooth.
TEST(Bend, corners_stay_corners) {
    int32_t proven = -1;
    const SplineData before = polyline(6, false, KnotForm::clamped),
                     after = bent_by_one(before, 1e-7, proven);
    const std::vector<double> &knots = after.knots[0];
    ASSERT_EQ(after.degrees[0], 3);
    for (size_t i = 4; i + 4 < knots.size(); ++i) {
        const auto copies = std::count(knots.begin(), knots.end(), knots[i]);
        const bool corner = std::floor(knots[i]) == knots[i];
        ASSERT_EQ(copies, corner ? 3 : 1) << knots[i];
        const BendCase rule{{0.1, 0}, {1, 0}, {0, 1}, 3, -HUGE_VAL, HUGE_VAL};
        const long double gap =
            gap_between(point_at(after, {knots[i]}), bent(rule, point_at(before, {knots[i]})));
        ASSERT_TRUE(!corner || gap <= 16 * eps) << static_cast<double>(gap);
    }
}

TEST(Bend, degrees_stay_where_they_suffice) {
    int32_t proven = -1;
    const SplineData loose = bent_by_one(polyline(40, false, KnotForm::clamped), 0.05, proven);
    ASSERT_EQ(loose.degrees[0], 1);
    ASSERT_EQ(loose.point_count(), 40);
}

// On even knots, where a control point of a high degree is ill-conditioned from one span.
TEST(Bend, high_degrees_are_met) {
    for (const int degree : {9, 17, 31}) {
        for (const KnotForm form : {KnotForm::clamped, KnotForm::unclamped, KnotForm::periodic}) {
            for (const int spans : {1, 2, 20}) {
                Random random(static_cast<uint64_t>(1545000 + degree * 100 + spans));
                Recipe recipe;
                recipe.dim = 2;
                recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
                AxisRecipe axis = random_axis(random, degree);
                axis.form = form;
                axis.spacing = Spacing::integers;
                axis.placement = Placement::origin;
                axis.spans = spans;
                recipe.axes = {axis};
                SplineData data = random_spline(random, recipe);
                const double size = extent(data);
                std::transform(data.points.begin(), data.points.end(), data.points.begin(),
                               [size](double x) { return 0.1 * x / size; });
                int32_t proven = -1;
                const SplineData after = bent_by_one(data, 1e-10, proven, 30);
                ASSERT_LE(after.point_count(), 256) << where(static_cast<uint64_t>(degree), data);
            }
        }
    }
}

// The corners of a box moved a little, and a volume of higher degree.
SplineData random_volume(Random &random, int axes) {
    SplineData volume;
    volume.dim = axes;
    for (int k = 0; k < axes; ++k) {
        const int p = random.whole(1, 2);
        std::vector<double> knots(static_cast<size_t>(p) + 1, 0.0);
        knots.insert(knots.end(), static_cast<size_t>(p) + 1, 2.0);
        volume.degrees.push_back(p);
        volume.counts.push_back(p + 1);
        volume.knots.push_back(std::move(knots));
    }
    for (int64_t i = 0; i < volume.point_count(); ++i) {
        int64_t rest = i;
        std::vector<double> point(static_cast<size_t>(axes));
        for (int k = axes; k-- > 0;) {
            const auto at = static_cast<size_t>(k);
            point[at] = static_cast<double>(rest % volume.counts[at]) / volume.degrees[at] +
                        random.between(-0.2, 0.2);
            rest /= volume.counts[at];
        }
        volume.points.insert(volume.points.end(), point.begin(), point.end());
    }
    return volume;
}

TEST(FreeForm, is_within_the_bound_of_the_exact_image) {
    int proofs = 0;
    for_each_case(1550000, 60, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(1, 3), axes = random.chance(70) ? 1 : 2;
        Recipe recipe = calm_recipe(random, axes, 3, dim);
        const SplineData data = random_spline(random, recipe), volume = random_volume(random, dim);
        const double size = extent(data), tolerance = axes == 1 ? random.magnitude(1e-8, 1e-3) : 1e-3;
        const std::vector<double> lower(static_cast<size_t>(dim), -size),
            upper(static_cast<size_t>(dim), size);
        const Handle g = create(data), v = create(volume);
        double deviation = -1;
        int32_t proven = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_free_form_deform(g.get(), v.get(), lower.data(), upper.data(), tolerance, &deviation,
                                          &proven, &out));
        const Handle h(out);
        ASSERT_LE(deviation, tolerance);
        proofs += proven;
        const SplineData after = read_back(h.get());
        for (int n = 0; n < 20; ++n) {
            const std::vector<double> param = random_params(random, after, 1);
            std::vector<double> inner;
            for (const Rational &x : point_at(data, param)) {
                inner.push_back(std::clamp(1 + static_cast<double>(as_long_double(x)) / size, 0.0, 2.0));
            }
            const Point image = point_at(volume, inner);
            const long double gap = length(minus(point_at(after, param), image));
            ASSERT_LE(gap, (proven == 1 ? deviation : tolerance) + 64 * eps)
                << where(seed, data) << hex(param);
        }
    });
    std::printf("%d bounds proven\n", proofs);
    ASSERT_GT(proofs, support::of_whole_run(5));
}

// The integral of the squared derivative of an order of a polynomial curve, by Gauss' rule of five points on
// each span, which is exact to degree 9.
long double energy_of(const SplineData &data, int order) {
    static const long double nodes[] = {0, 0.538469310105683091036314420700208805L,
                                        0.906179845938663992797626878299392965L};
    static const long double weights[] = {0.568888888888888888888888888888888889L,
                                          0.478628670499366468041291514835638193L,
                                          0.236926885056189087514264040719917363L};
    long double sum = 0;
    const std::vector<double> &t = data.knots[0];
    for (size_t i = 0; i + 1 < t.size(); ++i) {
        if (t[i] < data.lower(0) || t[i + 1] > data.upper(0) || t[i] == t[i + 1]) {
            continue;
        }
        for (int j = -2; j <= 2; ++j) {
            const long double half = (t[i + 1] - t[i]) / 2.0L, x = nodes[std::abs(j)] * (j < 0 ? -1 : 1);
            const auto at = static_cast<double>(t[i] + half + half * x);
            const auto derivatives = reference::exact_derivatives(data, order, &at);
            for (const reference::Fraction &value : derivatives[static_cast<size_t>(order)]) {
                const long double v = reference::quotient(value.numerator, value.denominator);
                sum += half * weights[std::abs(j)] * v * v;
            }
        }
    }
    return sum;
}

TEST(Fair, lowers_the_energy_within_the_bound) {
    for_each_case(1560000, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 5, random.whole(1, 3));
        recipe.weights = Weights::none;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].spans = random.whole(4, 12);
        const SplineData data = random_spline(random, recipe);
        const int order = random.whole(1, std::min(3, data.degrees[0]));
        const double tolerance = extent(data) * random.magnitude(1e-3, 1);
        const Handle g = create(data);
        double energies[2] = {-1, -1}, bound = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_fair(g.get(), order, nullptr, tolerance, energies, &bound, &out));
        const Handle h(out);
        const SplineData after = read_back(h.get());
        const long double before = energy_of(data, order), rounding = 1e-10L * before;
        ASSERT_NEAR(static_cast<double>(energies[0] / before), 1, 1e-9) << where(seed, data);
        ASSERT_LE(std::fabs(energies[1] - energy_of(after, order)), rounding) << where(seed, data);
        ASSERT_LE(energies[1], energies[0]);
        ASSERT_LE(bound, tolerance);
        ASSERT_EQ(after.knots, data.knots);
        for (int n = 0; n < 10; ++n) {
            ASSERT_LE(length(step_between(g.get(), h.get(), random_params(random, data, 1))),
                      bound * (1 + 1e-12))
                << where(seed, data);
        }
        if (!data.periodic(0)) {
            for (const double end : {data.lower(0), data.upper(0)}) {
                ASSERT_LE(length(step_between(g.get(), h.get(), {end})), 0) << where(seed, data);
            }
        }
    });
}

// Without a limit the least energy is what the derivative of the Lagrangian says: no control point that may
// move has a slope of the energy.
TEST(Fair, finds_the_minimum_where_the_tolerance_allows_it) {
    for_each_case(1570000, 30, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 4, 2);
        recipe.weights = Weights::none;
        recipe.axes[0].form = KnotForm::clamped;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].spans = 6;
        const SplineData data = random_spline(random, recipe);
        const int order = random.whole(1, std::min(2, data.degrees[0]));
        double energies[2] = {-1, -1};
        nurbs *out = nullptr;
        require_ok(
            nurbs_fair(create(data).get(), order, nullptr, 100 * extent(data), energies, nullptr, &out));
        const Handle h(out);
        SplineData after = read_back(h.get());
        for (int64_t i = 1; i + 1 < after.point_count(); ++i) {
            SplineData other = after;
            const double step = 1e-3 * extent(data);
            other.points[static_cast<size_t>(2 * i)] += step;
            const long double up = energy_of(other, order);
            other.points[static_cast<size_t>(2 * i)] -= 2 * step;
            const long double down = energy_of(other, order), least = energy_of(after, order);
            ASSERT_GE(up, least * (1 - 1e-6L)) << where(seed, data);
            // The slope is that between the two, the curvature their sum.
            ASSERT_LE(std::fabs(up - down), 1e-3L * (up + down - 2 * least) + 1e-8L * energies[0])
                << where(seed, data);
        }
    });
}

TEST(SnapBoundary, surfaces_meet_with_one_tangent_plane) {
    int refused = 0;
    for_each_case(1580000, 80, [&](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 2, 3, 3);
        for (AxisRecipe &axis : recipe.axes) {
            axis.form = random.chance(70) ? KnotForm::clamped : KnotForm::unclamped;
        }
        const SplineData a = random_spline(random, recipe);
        SplineData b = random_spline(random, calm_recipe(random, 2, 3, 3));
        const double scale = extent(a) / extent(b); // shapes of about one size
        std::transform(b.points.begin(), b.points.end(), b.points.begin(),
                       [scale](double x) { return scale * x; });
        const int axis = random.whole(0, 1), other_axis = random.whole(0, 1), end = random.whole(0, 1),
                  other_end = random.whole(0, 1), order = random.whole(0, 1);
        const bool reversed = random.chance(50);
        const Handle g = create(a), f = create(b);
        double bound = -1;
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_snap_boundary(g.get(), axis, end, f.get(), other_axis, other_end,
                                                        order, reversed ? NURBS_REVERSED : 0, &bound, &out);
        const Handle h(out);
        if (b.periodic(other_axis)) {
            ASSERT_EQ(status, NURBS_ERROR_PERIODIC);
            return;
        }
        if (status == NURBS_ERROR_WEIGHT_SIGN) {
            ++refused;
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, a) << where(seed, b);
        const SplineData after = read_back(h.get());
        const long double size = extent(a) + extent(b);
        long double ratio = -1;
        for (int n = 0; n < 5; ++n) {
            const double part = random.unit();
            const auto along = static_cast<size_t>(1 - axis),
                       other_along = static_cast<size_t>(1 - other_axis);
            std::vector<double> here(2), there(2);
            here[static_cast<size_t>(axis)] = end == 1 ? a.upper(axis) : a.lower(axis);
            here[along] = a.lower(1 - axis) + part * (a.upper(1 - axis) - a.lower(1 - axis));
            there[static_cast<size_t>(other_axis)] =
                other_end == 1 ? b.upper(other_axis) : b.lower(other_axis);
            const double share = reversed ? 1 - part : part;
            there[other_along] =
                b.lower(1 - other_axis) + share * (b.upper(1 - other_axis) - b.lower(1 - other_axis));
            const reference::Sides left{axis == 0 && end == 1, axis == 1 && end == 1},
                other_left{other_axis == 0 && other_end == 1, other_axis == 1 && other_end == 1};
            const auto p = reference::exact_derivatives(after, 1, here.data(), left),
                       q = reference::exact_derivatives(b, 1, there.data(), other_left);
            const auto vector = [](const std::vector<reference::Fraction> &x) {
                std::vector<long double> v;
                for (const reference::Fraction &value : x) {
                    v.push_back(reference::quotient(value.numerator, value.denominator));
                }
                return v;
            };
            const auto on = vector(p[0]), to = vector(q[0]);
            for (size_t c = 0; c < 3; ++c) { // knots along, and parameters, are rounded
                ASSERT_NEAR(static_cast<double>(on[c]), static_cast<double>(to[c]),
                            1e-10 * static_cast<double>(size))
                    << where(seed, a) << where(seed, b);
            }
            if (order == 0) {
                continue;
            }
            const auto across = vector(p[static_cast<size_t>(axis) + 1]),
                       outward = vector(q[static_cast<size_t>(other_axis) + 1]);
            long double dot = 0, own = 0, others = 0;
            for (size_t c = 0; c < 3; ++c) {
                dot += across[c] * outward[c] * (end == 1 ? -1 : 1) * (other_end == 1 ? 1 : -1);
                own += across[c] * across[c];
                others += outward[c] * outward[c];
            }
            ASSERT_GE(dot, std::sqrt(own * others) * (1 - 1e-8L)) << where(seed, a) << where(seed, b);
            const long double here_ratio = std::sqrt(own / others);
            ASSERT_TRUE(ratio < 0 || std::fabs(here_ratio / ratio - 1) < 1e-6L)
                << where(seed, a) << where(seed, b);
            ratio = here_ratio;
        }
        for (int n = 0; n < 5; ++n) {
            const std::vector<double> param = random_params(random, a, 1);
            const std::vector<double> before = eval(g.get(), param), moved = eval(h.get(), param);
            long double gap = 0;
            for (size_t c = 0; c < 3; ++c) {
                gap = std::hypot(gap, static_cast<long double>(before[c]) - moved[c]);
            }
            ASSERT_LE(gap, bound * (1 + 1e-12L) + 1e-12L * size) << where(seed, a) << where(seed, b);
        }
    });
    std::printf("%d refused for their weights\n", refused);
    ASSERT_LE(refused, 20);
}

} // namespace
