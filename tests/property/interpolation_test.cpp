// Interpolation: data are met in exact arithmetic, splines come back, and laws of scale, order and energy.
#include "property/products.h"

#include <cstdint>
#include <numeric>

namespace interpolation_test {

using namespace support;
using namespace support::products;
using reference::eps;

namespace {

// Points on a grid, and all that nurbs_interpolate() takes besides.
struct Data {
    std::vector<int32_t> degrees, ends;
    std::vector<int64_t> counts;
    std::vector<double> params, points;
    int32_t dim = 2;
    uint32_t flags = 0;

    [[nodiscard]] bool periodic(size_t k) const { return (flags & NURBS_ON_AXIS(k, NURBS_PERIODIC)) != 0; }
    [[nodiscard]] std::vector<double> params_of(size_t k) const {
        const auto first =
            params.begin() +
            std::accumulate(counts.begin(), counts.begin() + static_cast<int64_t>(k), int64_t{0});
        return {first, first + counts[k]};
    }
};

// The layers of an axis in turn: `first` repeats as the last one.
void close(Data &data, size_t k) {
    int64_t outer = 1, inner = data.dim;
    for (size_t i = 0; i < data.counts.size(); ++i) {
        (i < k ? outer : inner) *= i == k ? 1 : data.counts[i];
    }
    for (int64_t o = 0; o < outer; ++o) {
        const auto first = data.points.begin() + o * data.counts[k] * inner;
        std::copy(first, first + inner, first + (data.counts[k] - 1) * inner);
    }
}

Data random_data(Random &random, int axes, int highest) {
    Data data;
    data.dim = random.whole(1, 3);
    int64_t total = data.dim;
    for (int k = 0; k < axes; ++k) {
        const int p = random.whole(0, highest);
        const bool periodic = random.chance(30);
        const int end = periodic ? 0 : p % 2 == 1 ? random.whole(0, 2) : 2 * random.whole(0, 1);
        data.degrees.push_back(p);
        data.ends.insert(data.ends.end(), 2, end);
        data.flags |= periodic ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
        data.counts.push_back((periodic || end == 1 ? 2 : std::max(p + 1, 2)) +
                              random.whole(0, axes == 1 ? 12 : 4));
        double t = random.between(-2, 2);
        for (int64_t i = 0; i < data.counts.back(); ++i) {
            data.params.push_back(t);
            t += random.chance(20) ? random.magnitude(0.05, 1) : random.between(0.5, 1);
        }
        total *= data.counts.back();
    }
    for (int64_t i = 0; i < total; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    for (size_t k = 0; k < data.counts.size(); ++k) {
        if (data.periodic(k)) {
            close(data, k);
        }
    }
    return data;
}

Handle interpolated(const Data &data, double *residual = nullptr) {
    nurbs *out = nullptr;
    require_ok(nurbs_interpolate(static_cast<int32_t>(data.counts.size()), data.degrees.data(),
                                 data.counts.data(), data.params.data(), data.dim, data.points.data(), 0, 0,
                                 data.ends.data(), data.flags, residual, &out));
    return Handle(out);
}

// Calls body(parameters, index of the point).
template <class Body>
void for_each_point(const Data &data, Body &&body) {
    const auto count = static_cast<int64_t>(data.points.size()) / data.dim;
    for (int64_t i = 0; i < count; ++i) {
        std::vector<double> param(data.counts.size());
        int64_t rest = i;
        for (size_t k = data.counts.size(); k-- > 0; rest /= data.counts[k]) {
            param[k] = data.params_of(k)[static_cast<size_t>(rest % data.counts[k])];
        }
        body(param, i);
    }
}

// In the periods of the domain.
double wrapped(const SplineData &spline, int k, double t) {
    const double period = spline.upper(k) - spline.lower(k);
    return spline.periodic(k) && t > spline.upper(k) ? t - period : t;
}

TEST(Interpolation, meets_the_data_in_exact_arithmetic) {
    WorstErrors worst("interpolation by degree of axis 0, unit eps * largest control point");
    for_each_case(880000, 500, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(70) ? 1 : random.whole(2, 3);
        const Data data = random_data(random, axes, axes == 1 ? 15 : axes == 2 ? 5 : 3);
        double residual = -1;
        const Handle made = interpolated(data, &residual);
        const SplineData spline = read_back(made.get());
        const long double unit = eps * std::max(extent(spline), 1e-300);
        constexpr long double bound = 4;
        double largest = 0;
        for_each_point(data, [&](std::vector<double> param, int64_t i) {
            reference::Sides left{};
            for (int k = 0; k < axes; ++k) {
                const auto at = static_cast<size_t>(k);
                if (data.periodic(at) && param[at] == data.params_of(at).back()) {
                    return; // the first layer again
                }
                param[at] = wrapped(spline, k, param[at]);
                left[at] = param[at] == spline.upper(k);
            }
            const Point value = exact_record(made.get(), param, left);
            for (int c = 0; c < data.dim; ++c) {
                const long double error =
                    size_of(value[static_cast<size_t>(c)] -
                            reference::exact(data.points[static_cast<size_t>(i * data.dim + c)]));
                largest = std::max(largest, static_cast<double>(error));
                worst.add(data.degrees[0], error / (bound * unit), error / unit);
                ASSERT_LE(error, bound * unit)
                    << "seed " << seed << " point " << i << ' ' << describe(spline);
            }
        });
        ASSERT_GE(residual * 1.01 + 20 * degree_sum(spline) * static_cast<double>(unit), largest)
            << "seed " << seed;
    });
}

// Over the knots of any polynomial spline, in all forms, at Greville's abscissae or beside them.
TEST(Interpolation, over_knots_gives_splines_back) {
    WorstErrors worst("splines given back by degree of axis 0, unit eps * largest control point, at points");
    for_each_case(882000, 1500, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(70) ? 1 : 2;
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 15 : 5);
        recipe.weights = Weights::none;
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = random.chance(50) ? Spacing::full : Spacing::few_bits;
            axis.placement = Placement::origin;
        }
        const SplineData data = random_spline(random, recipe);
        const auto g = create(data);
        Data given{data.degrees, {}, {}, {}, {}, data.dim, data.flags};
        std::vector<std::vector<double>> sites;
        for (int k = 0; k < axes; ++k) {
            const auto at = static_cast<size_t>(k);
            std::vector<double> greville(static_cast<size_t>(data.counts[at]));
            require_ok(nurbs_greville(g.get(), k, data.counts[at], greville.data()));
            std::vector<double> own;
            for (double t : greville) {
                t = std::clamp(t, data.lower(k), data.upper(k));
                own.push_back(t);
            }
            if (data.periodic(k)) {
                return; // see the next test
            }
            std::sort(own.begin(), own.end());
            if (std::adjacent_find(own.begin(), own.end()) != own.end()) {
                return; // several at an end that is not clamped, or at a jump
            }
            given.counts.push_back(std::ssize(own));
            given.params.insert(given.params.end(), own.begin(), own.end());
            sites.push_back(own);
        }
        std::vector<double> values(data.points.size());
        if (axes == 1) {
            require_ok(nurbs_eval(g.get(), given.counts[0], sites[0].data(), 0, 0, values.data(), 0, 0, 0));
        } else {
            require_ok(
                nurbs_eval_grid(g.get(), given.counts.data(), given.params.data(), values.data(), 0, 0, 0));
        }
        nurbs *out = nullptr;
        const auto knots = data.all_knots();
        const nurbs_status status = nurbs_interpolate_over_knots(
            axes, data.degrees.data(), given.counts.data(), given.params.data(), knots.data(),
            std::ssize(knots), data.dim, values.data(), 0, 0, data.flags, &out);
        const Handle back(out);
        if (status == NURBS_ERROR_SCHOENBERG_WHITNEY) {
            return;
        }
        require_ok(status);
        const long double unit = eps * extent(data);
        for (int i = 0; i < 8; ++i) {
            const auto param = random_params(random, data, 1);
            std::vector<double> a(static_cast<size_t>(data.dim)), b(a);
            require_ok(nurbs_eval(g.get(), 1, param.data(), 0, 0, a.data(), 0, 0, 0));
            require_ok(nurbs_eval(back.get(), 1, param.data(), 0, 0, b.data(), 0, 0, 0));
            for (size_t c = 0; c < a.size(); ++c) {
                const long double error = std::fabs(a[c] - b[c]);
                constexpr long double bound = 100;
                worst.add(data.degrees[0], error / (unit * bound), error / unit);
                ASSERT_LE(error, bound * unit) << where(seed, data) << hex(param);
            }
        }
    });
}

// The same over periodic knots, of which nurbs_interpolate() makes some: without the layer that repeats the first.
TEST(Interpolation, over_periodic_knots_gives_splines_back) {
    int64_t periodic = 0;
    for_each_case(883000, 400, [&](Random &random, uint64_t seed) {
        Data data = random_data(random, 1, 11);
        if (!data.periodic(0)) {
            return;
        }
        ++periodic;
        const auto one = read_back(interpolated(data).get());
        const auto knots = one.all_knots();
        const int64_t distinct = data.counts[0] - 1;
        nurbs *out = nullptr;
        require_ok(nurbs_interpolate_over_knots(1, data.degrees.data(), &distinct, data.params.data(),
                                                knots.data(), std::ssize(knots), data.dim, data.points.data(),
                                                0, 0, data.flags, &out));
        const Handle over(out);
        ASSERT_TRUE(same_bits(read_back(over.get()).points, one.points)) << "seed " << seed;
        require_ok(nurbs_curve_interpolate(data.degrees[0], distinct, data.params.data(), nullptr, data.dim,
                                           data.points.data(), 0, 0, knots.data(), std::ssize(knots),
                                           data.flags, &out));
        const Handle curve(out);
        ASSERT_TRUE(same_bits(read_back(curve.get()).points, one.points)) << "seed " << seed;
    });
    EXPECT_GE(periodic, of_whole_run(50));
}

TEST(Interpolation, is_free_of_scale) {
    for_each_case(884000, 300, [](Random &random, uint64_t seed) {
        Data data = random_data(random, random.whole(1, 2), 7);
        const auto one = read_back(interpolated(data).get());
        const double size = std::ldexp(1.0, random.whole(-40, 40)),
                     speed = std::ldexp(1.0, random.whole(-30, 30));
        std::ranges::for_each(data.points, [size](double &x) { x *= size; });
        std::ranges::for_each(data.params, [speed](double &t) { t *= speed; });
        const auto other = read_back(interpolated(data).get());
        const auto wanted = scaled(one, size, speed);
        ASSERT_TRUE(same_bits(wanted.all_knots(), other.all_knots())) << "seed " << seed;
        ASSERT_TRUE(same_bits(wanted.points, other.points)) << "seed " << seed;
    });
}

// Of all curves through the points the natural spline has the least integral of the squared second derivative: any
// other one, such as that with not-a-knot ends or a few cubics between, has more.
TEST(Interpolation, natural_cubics_have_the_least_energy) {
    const auto energy = [](const nurbs *g) {
        nurbs *out = nullptr, *square = nullptr, *integral = nullptr;
        require_ok(nurbs_derivative(g, 0, 2, &out));
        const Handle second(out);
        require_ok(nurbs_product(second.get(), second.get(), NURBS_PRODUCT_DOT, &square));
        const Handle product(square);
        require_ok(nurbs_antiderivative(product.get(), 0, &integral));
        const Handle sum(integral);
        double domain[2], ends[2];
        require_ok(nurbs_domain(g, 0, domain));
        require_ok(nurbs_eval(sum.get(), 2, domain, 0, 0, ends, 0, 0, 0));
        return ends[1] - ends[0];
    };
    for_each_case(886000, 200, [&](Random &random, uint64_t seed) {
        Data data = random_data(random, 1, 0);
        data.degrees = {3};
        data.flags = 0;
        while (data.counts[0] < 4) {
            return;
        }
        data.ends = {1, 1};
        const double least = energy(interpolated(data).get());
        data.ends = {random.whole(0, 1), 0};
        ASSERT_GE(energy(interpolated(data).get()), least * (1 - 1e-9)) << "seed " << seed;
        data.ends = {2, 2};
        ASSERT_GE(energy(interpolated(data).get()), least * (1 - 1e-9)) << "seed " << seed;
    });
}

// Halving the steps divides the error by 2^(degree + 1), at the ends too.
TEST(Interpolation, converges_with_the_order) {
    for (int32_t degree = 1; degree <= 7; ++degree) {
        const auto error = [&](int64_t count) {
            std::vector<double> params, points;
            for (int64_t i = 0; i < count; ++i) {
                params.push_back(3 * static_cast<double>(i) / static_cast<double>(count - 1));
                points.push_back(std::sin(params.back()));
            }
            nurbs *out = nullptr;
            require_ok(nurbs_interpolate(1, &degree, &count, params.data(), 1, points.data(), 0, 0, nullptr,
                                         0, nullptr, &out));
            const Handle made(out);
            double largest = 0;
            for (int i = 0; i <= 1000; ++i) {
                const double t = 3 * i / 1000.0;
                double value = 0;
                require_ok(nurbs_eval(made.get(), 1, &t, 0, 0, &value, 0, 0, 0));
                largest = std::max(largest, std::fabs(value - std::sin(t)));
            }
            return largest;
        };
        const double order = std::log2(error(21) / error(41));
        EXPECT_GT(order, degree + 0.5) << "degree " << degree;
        EXPECT_LT(order, degree + 2.6) << "degree " << degree;
    }
}

// The derivative of the cubic between two points as a quadratic Bernstein polynomial, exactly: it has no sign but that
// of the data.
TEST(Interpolation, monotone_tangents_make_monotone_cubics) {
    int64_t flat = 0, steep = 0;
    for_each_case(890000, 1500, [&](Random &random, uint64_t seed) {
        std::vector<double> params{random.between(-1, 1)}, points{random.between(-1, 1)};
        for (int i = random.whole(1, 12); i > 0; --i) {
            params.push_back(params.back() + random.magnitude(1e-3, 1));
            const double step =
                random.chance(20) ? 0 : random.magnitude(1e-12, 1e3) * (random.chance(30) ? -1 : 1);
            points.push_back(points.back() + step);
        }
        const auto n = std::ssize(params);
        std::vector<double> tangents(params.size());
        require_ok(nurbs_tangents(NURBS_TANGENTS_MONOTONE, n, params.data(), 1, points.data(), 0, 0, 0,
                                  tangents.data(), 0, 0));
        for (size_t i = 0; i + 1 < params.size(); ++i) {
            const int sign = points[i + 1] > points[i] ? 1 : -1;
            const auto exact = [&](const std::vector<double> &x, size_t j) -> Rational {
                return sign * reference::exact(x[j]);
            };
            const Rational h = reference::exact(params[i + 1]) - reference::exact(params[i]);
            const Rational q0 = h * exact(tangents, i) / 3, q2 = h * exact(tangents, i + 1) / 3;
            const Rational q1 = exact(points, i + 1) - exact(points, i) - q0 - q2;
            flat += points[i + 1] == points[i] ? 1 : 0;
            steep += 2 * q1 < q0 + q2 ? 1 : 0;
            ASSERT_GE(q0, 0) << "seed " << seed << " piece " << i;
            ASSERT_GE(q2, 0) << "seed " << seed << " piece " << i;
            ASSERT_TRUE(q1 >= 0 || q1 * q1 <= q0 * q2) << "seed " << seed << " piece " << i;
            ASSERT_TRUE(points[i + 1] != points[i] || (q0 == 0 && q1 == 0 && q2 == 0)) << "seed " << seed;
        }
    });
    EXPECT_GE(flat, of_whole_run(500));
    EXPECT_GE(steep, of_whole_run(50));
}

// Each function is larger at its parameter than beside it, and the data over the knots determine a curve.
TEST(Interpolation, universal_parameters_are_maxima) {
    for_each_case(892000, 200, [](Random &random, uint64_t seed) {
        const int32_t degree = random.whole(2, 15);
        const int64_t count = degree + random.whole(1, 20);
        std::vector<double> params(static_cast<size_t>(count)),
            knots(static_cast<size_t>(count + degree + 1));
        require_ok(nurbs_params_universal(degree, count, params.data()));
        require_ok(nurbs_knots_open_uniform(degree, count, 0, 1, std::ssize(knots), knots.data()));
        const auto value = [&](int64_t i, double t) {
            std::vector<double> ones(static_cast<size_t>(count));
            ones[static_cast<size_t>(i)] = 1;
            nurbs *g = nullptr;
            require_ok(nurbs_create(1, &degree, &count, knots.data(), std::ssize(knots), 1, ones.data(), 0, 0,
                                    nullptr, 0, 0, &g));
            const Handle function(g);
            double found = 0;
            require_ok(nurbs_eval(g, 1, &t, 0, 0, &found, 0, 0, NURBS_CLAMP));
            return found;
        };
        for (int64_t i = 0; i < count; ++i) {
            const double t = params[static_cast<size_t>(i)], step = 1e-4 / static_cast<double>(count);
            ASSERT_GE(value(i, t), value(i, t - step)) << "seed " << seed << " function " << i;
            ASSERT_GE(value(i, t), value(i, t + step)) << "seed " << seed << " function " << i;
        }
        nurbs *out = nullptr;
        require_ok(nurbs_interpolate_over_knots(1, &degree, &count, params.data(), knots.data(),
                                                std::ssize(knots), 1, params.data(), 0, 0, 0, &out));
        nurbs_destroy(out);
    });
}

// Hermite's and Birkhoff's conditions are met, as derivatives are evaluated.
TEST(Interpolation, meets_conditions_of_any_order) {
    for_each_case(888000, 600, [](Random &random, uint64_t seed) {
        const int32_t degree = random.whole(1, 9);
        std::vector<double> params, targets;
        std::vector<int32_t> orders;
        double t = random.between(-1, 1);
        while (std::ssize(params) <= degree + random.whole(0, 8)) {
            const int most = std::min(degree - 1, random.whole(0, 2)); // Hermite's
            for (int32_t order = 0; order <= most; ++order) {
                params.push_back(t);
                orders.push_back(order);
                targets.push_back(random.between(-1, 1));
            }
            t += random.between(0.5, 1);
        }
        const auto n = std::ssize(params);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_curve_interpolate(degree, n, params.data(), orders.data(), 1,
                                                            targets.data(), 0, 0, nullptr, 0, 0, &out);
        const Handle made(out);
        if (status == NURBS_ERROR_RANK || status == NURBS_ERROR_END_MULTIPLICITY ||
            status == NURBS_ERROR_EMPTY_DOMAIN) {
            return;
        }
        require_ok(status);
        const double size = extent(read_back(made.get()));
        std::vector<double> values(4);
        for (int64_t i = 0; i < n; ++i) {
            const auto at = static_cast<size_t>(i);
            require_ok(nurbs_eval_derivs(made.get(), 3, 1, &params[at], 0, 0, values.data(), 0, 0, 0));
            const double scale = std::pow(4.0 * degree, orders[at]); // of the differences
            ASSERT_NEAR(values[static_cast<size_t>(orders[at])], targets[at],
                        64 * degree * 0x1p-52 * size * scale)
                << "seed " << seed << " condition " << i;
        }
    });
}

} // namespace

} // namespace interpolation_test
