// Sets of splines made compatible, and knots snapped together: what is exact keeps the shape, what is not
// stays within the bound returned.
#include "property/same_shape.h"

namespace compatible_test {

using namespace support;

namespace {

struct Made {
    std::vector<Handle> splines;
    double deviation = -1;
};

Made compatible(const std::vector<Handle> &given, double tolerance, uint32_t flags = 0) {
    std::vector<const nurbs *> handles;
    for (const Handle &g : given) {
        handles.push_back(g.get());
    }
    nurbs_list *list = nullptr;
    Made made;
    require_ok(nurbs_make_compatible(static_cast<int64_t>(handles.size()), handles.data(), tolerance, flags,
                                     &made.deviation, &list));
    for (size_t i = 0; i < given.size(); ++i) {
        nurbs *g = nullptr;
        require_ok(nurbs_list_get(list, static_cast<int64_t>(i), &g));
        made.splines.emplace_back(g);
    }
    nurbs_list_destroy(list);
    return made;
}

Handle clamped(const Handle &g, int axis, uint32_t flags) {
    nurbs *out = nullptr;
    require_ok(nurbs_clamp_ends(g.get(), axis, flags, &out));
    return Handle(out);
}

// The same domain, other knots, degree and form, and points of its own on the axes that stay periodic too.
Handle relative(Random &random, const Handle &base) {
    Handle g = insert(base.get(), 0, read_back(base.get()).lower(0), 0);
    const int axes = read_back(g.get()).axes();
    for (int k = 0; k < axes; ++k) {
        if (random.chance(30)) {
            g = clamped(g, k, static_cast<uint32_t>(random.whole(0, 3)));
        }
        g = elevate(g.get(), k, random.whole(0, 2));
        for (int i = random.whole(0, 3); i > 0; --i) {
            const SplineData data = read_back(g.get());
            const double t = random_new_knot(random, data, k);
            const auto &knots = data.knots[static_cast<size_t>(k)];
            const auto present = std::count(knots.begin(), knots.end(), t);
            if (t > data.lower(k) && t < data.upper(k) && present <= data.degrees[static_cast<size_t>(k)]) {
                g = insert(g.get(), k, t, 1);
            }
        }
    }
    if (random.chance(30)) {
        nurbs *rational = nullptr;
        require_ok(nurbs_make_rational(g.get(), &rational));
        g.reset(rational);
    }
    return g;
}

void expect_one_form(const std::vector<Handle> &splines, const std::string &place) {
    const SplineData first = read_back(splines.front().get());
    for (const Handle &g : splines) {
        const SplineData data = read_back(g.get());
        ASSERT_EQ(data.degrees, first.degrees) << place;
        ASSERT_EQ(data.counts, first.counts) << place;
        ASSERT_EQ(data.flags, first.flags) << place;
        ASSERT_EQ(data.rational(), first.rational()) << place;
        for (size_t k = 0; k < data.knots.size(); ++k) {
            ASSERT_TRUE(same_bits(data.knots[k], first.knots[k])) << place;
        }
    }
}

TEST(Compatible, exact_without_a_tolerance) {
    for_each_case(300000, 400, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 7 : 5 - axes);
        long double moved = 1;
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = axis.form == KnotForm::periodic ? Spacing::few_bits : axis.spacing;
            axis.placement = axis.form == KnotForm::periodic ? Placement::origin : axis.placement;
            moved += 4 * (axis.degree + 2) + 4;
        }
        const SplineData data = random_spline(random, recipe);
        const Handle base = create(data);
        std::vector<Handle> given;
        for (int i = random.whole(1, 4); i >= 0; --i) {
            given.push_back(relative(random, base));
        }
        const Made made = compatible(given, 0);
        const std::string place = where(seed, data);
        expect_one_form(made.splines, place);
        ASSERT_TRUE(made.deviation == 0 || data.flags != 0) << place << hex(made.deviation);
        for (size_t i = 0; i < given.size(); ++i) {
            const SplineData old = read_back(given[i].get());
            long double wrapped = 0;
            for (int k = 0; k < old.axes(); ++k) {
                wrapped += old.periodic(k) ? 64 * wrapping(old, k, 1.0 / 3) : 0;
            }
            expect_same_shape(given[i].get(), made.splines[i].get(), moved + wrapped, random,
                              place + " number " + std::to_string(i));
        }
    });
}

TEST(Compatible, no_knot_is_inserted_that_none_has) {
    for_each_case(301000, 300, [](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, open_recipe(random, 1, 5));
        const Handle base = create(data);
        std::vector<Handle> given;
        for (int i = 0; i < 3; ++i) {
            given.push_back(clamped(relative(random, base), 0, 3));
        }
        const Made made = compatible(given, 0);
        const SplineData result = read_back(made.splines[0].get());
        for (const double t : result.knots[0]) {
            int64_t most = 0;
            for (const Handle &g : given) {
                const SplineData old = read_back(g.get());
                const auto times = std::count(old.knots[0].begin(), old.knots[0].end(), t);
                most = std::max<int64_t>(most, times == 0 ? 0 : times + result.degrees[0] - old.degrees[0]);
            }
            ASSERT_EQ(std::count(result.knots[0].begin(), result.knots[0].end(), t), most)
                << where(seed, data) << hex(t);
        }
    });
}

// Largest exact distance of two splines at the parameters given, from both sides.
long double exact_distance(const SplineData &a, const SplineData &b, const std::vector<double> &params) {
    long double worst = 0;
    const auto axes = static_cast<size_t>(a.axes());
    for (size_t i = 0; i < params.size(); i += axes) {
        for (const bool left : {false, true}) {
            const reference::Sides sides{left, left, left};
            const auto p = reference::exact_point(a, params.data() + i, sides);
            const auto q = reference::exact_point(b, params.data() + i, sides);
            long double sum = 0;
            for (size_t c = 0; c < p.size(); ++c) {
                const long double d = reference::quotient(
                    reference::Integer(p[c].numerator * q[c].denominator - q[c].numerator * p[c].denominator),
                    p[c].denominator * q[c].denominator);
                sum += d * d;
            }
            worst = std::max(worst, std::sqrt(sum));
        }
    }
    return worst;
}

// Parameters where a moved knot shows: both of its places, and what lies around.
std::vector<double> telling(Random &random, const SplineData &a, const SplineData &b) {
    std::vector<double> params;
    for (const SplineData *data : {&a, &b}) {
        for (const double t : data->knots[0]) {
            if (t >= a.lower(0) && t <= a.upper(0)) {
                params.push_back(t);
            }
        }
    }
    std::sort(params.begin(), params.end());
    params.erase(std::unique(params.begin(), params.end()), params.end());
    const size_t n = params.size();
    for (size_t i = 0; i + 1 < n; ++i) {
        for (const double part : {0.25, 0.5, 0.75, random.unit()}) {
            params.push_back(params[i] + part * (params[i + 1] - params[i]));
        }
    }
    return params;
}

// A spline whose spans are long against the moves, and the same one with knots moved by up to `part` of the
// domain.
SplineData jittered(Random &random, SplineData data, double part) {
    auto &knots = data.knots[0];
    const double length = data.upper(0) - data.lower(0), lower = data.lower(0), upper = data.upper(0);
    double last = lower, place = lower;
    for (double &t : knots) {
        if (t > lower && t < upper) {
            if (t != last) {
                last = t;
                place = t + random.between(-part, part) * length;
            }
            t = place;
        }
    }
    return data;
}

double shortest_span(const SplineData &data) {
    const auto &t = data.knots[0];
    double least = 1;
    for (size_t i = 0; i + 1 < t.size(); ++i) {
        least =
            t[i] < t[i + 1] ? std::min(least, (t[i + 1] - t[i]) / (data.upper(0) - data.lower(0))) : least;
    }
    return least;
}

TEST(Compatible, near_knots_do_not_multiply_and_the_bound_holds) {
    std::vector<double> ratios;
    for_each_case(302000, 400, [&](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, 1, 6);
        recipe.axes[0].spacing = random.chance(50) ? Spacing::few_bits : Spacing::integers;
        recipe.axes[0].form = KnotForm::clamped;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const double part = random.magnitude(1e-9, 1e-4);
        if (shortest_span(data) < 0.01) {
            return;
        }
        std::vector<Handle> given;
        for (int i = 0; i < 3; ++i) {
            given.push_back(create(jittered(random, data, i == 0 ? 0 : part)));
        }
        const Made made = compatible(given, 4 * part);
        const std::string place = where(seed, data) + hex(part);
        expect_one_form(made.splines, place);
        const SplineData result = read_back(made.splines[0].get());
        ASSERT_EQ(result.counts, data.counts) << place;
        long double worst = 0;
        for (size_t i = 0; i < given.size(); ++i) {
            const SplineData old = read_back(given[i].get()), fresh = read_back(made.splines[i].get());
            worst = std::max(worst, exact_distance(old, fresh, telling(random, old, fresh)));
        }
        ASSERT_LE(worst, made.deviation) << place;
        if (worst > 1e-9) {
            ratios.push_back(static_cast<double>(made.deviation / worst));
        }
    });
    std::sort(ratios.begin(), ratios.end());
    ASSERT_GT(std::ssize(ratios), std::max(int64_t{0}, support::of_whole_run(30)));
    std::printf("bound / true: median %.3g, largest %.3g of %zu\n", ratios[ratios.size() / 2], ratios.back(),
                ratios.size());
    EXPECT_LE(ratios[ratios.size() / 2], 4);
}

// The layers of axis 0 of the one are among those of the other, in their order; clamped ends stay.
bool layers_are_kept(const SplineData &old, const SplineData &kept) {
    const auto length = std::ssize(old.points) / old.counts[0];
    auto at = old.points.begin();
    for (auto layer = kept.points.begin(); layer != kept.points.end(); layer += length, at += length) {
        while (at != old.points.end() && !std::equal(layer, layer + length, at)) {
            at += length;
        }
        if (at == old.points.end()) {
            return false;
        }
    }
    const auto &knots = old.knots[0];
    const bool start = old.degrees[0] > 0 && knots.front() == old.lower(0);
    const bool end = old.degrees[0] > 0 && knots.back() == old.upper(0);
    return (!start || std::equal(old.points.begin(), old.points.begin() + length, kept.points.begin())) &&
           (!end || std::equal(old.points.end() - length, old.points.end(), kept.points.end() - length));
}

TEST(SnapKnots, the_bound_holds_for_every_form) {
    int merged = 0;
    for_each_case(303000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 6 : 3);
        const SplineData data = random_spline(random, recipe);
        const double tolerance = random.magnitude(1e-12, 0.2);
        const Handle g = create(data);
        nurbs *out = nullptr;
        double deviation = -1;
        const nurbs_status status = nurbs_snap_knots(g.get(), 0, tolerance, &deviation, &out);
        const Handle snapped(out);
        const std::string place = where(seed, data) + hex(tolerance);
        if (status == NURBS_ERROR_MULTIPLICITY) {
            ASSERT_EQ(deviation, -1) << place;
            return;
        }
        if (status == NURBS_ERROR_WEIGHTS_VANISH && recipe.weights == Weights::some_zero) {
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << place << last_error();
        const SplineData result = read_back(out);
        ASSERT_TRUE(result.lower(0) == data.lower(0) && result.upper(0) == data.upper(0)) << place;
        ASSERT_EQ(result.flags, data.flags) << place;
        ASSERT_EQ(deviation == 0, same_bits(result.knots[0], data.knots[0])) << place;
        ASSERT_EQ(std::ssize(data.knots[0]) - std::ssize(result.knots[0]), data.counts[0] - result.counts[0]);
        ASSERT_TRUE(layers_are_kept(data, result)) << place;
        merged += result.counts[0] < data.counts[0] ? 1 : 0;
        auto params = telling(random, data, result);
        if (axes == 2) {
            std::vector<double> pairs;
            for (const double u : params) {
                pairs.insert(pairs.end(), {u, random.between(data.lower(1), data.upper(1))});
            }
            params = pairs;
        }
        ASSERT_LE(exact_distance(data, result, params), deviation) << place;
        const SplineData small = scaled(data, 0x1p-40); // by a power of two, which changes no digit
        double less = -1;
        require_ok(nurbs_snap_knots(create(small).get(), 0, tolerance, &less, &out));
        const Handle holder(out);
        ASSERT_EQ(less, 0x1p-40 * deviation) << place;
    });
    std::printf("%d lost knots at their ends\n", merged);
    ASSERT_GT(merged, support::of_whole_run(10));
}

} // namespace

} // namespace compatible_test
