// Grids with derivatives at the ends of axes: they are met, splines come back, and mixed derivatives may be unknown.
#include "property/products.h"

#include <cstdint>
#include <numeric>

namespace interpolation_derivatives_test {

using namespace support;
using namespace support::products;
constexpr double eps = 0x1p-52;

namespace {

struct Axis {
    int32_t degree = 3;
    std::vector<double> sites;
    std::vector<int32_t> at_start, at_end; // orders of derivatives
    bool periodic = false;
    int32_t ends[2] = {NURBS_ENDS_NOT_A_KNOT, NURBS_ENDS_NOT_A_KNOT};

    [[nodiscard]] std::vector<double> params() const {
        std::vector<double> result(at_start.size(), sites.front());
        result.insert(result.end(), sites.begin(), sites.end());
        result.insert(result.end(), at_end.size(), sites.back());
        return result;
    }
    [[nodiscard]] std::vector<int32_t> orders() const {
        std::vector<int32_t> result{0};
        result.insert(result.end(), at_start.begin(), at_start.end());
        result.insert(result.end(), sites.size() - 1, 0);
        result.insert(result.end(), at_end.begin(), at_end.end());
        return result;
    }
    // Those of interpolation, for the knots of a spline that is to be found again.
    [[nodiscard]] std::vector<double> knots() const {
        const auto p = static_cast<size_t>(degree);
        std::vector<double> places(sites.begin() + 1, sites.end() - 1);
        if (p % 2 == 0) {
            places.clear();
            for (size_t i = 0; i + 1 < sites.size(); ++i) {
                places.push_back(sites[i] + (sites[i + 1] - sites[i]) / 2);
            }
        }
        std::vector<double> result(p + 1, sites.front());
        result.insert(result.end(), places.begin() + static_cast<int64_t>(p / 2 - at_start.size()),
                      places.end() - static_cast<int64_t>(p / 2 - at_end.size()));
        result.insert(result.end(), p + 1, sites.back());
        return result;
    }
};

struct Grid {
    std::vector<Axis> axes;
    int32_t dim = 1;
    std::vector<double> values;

    [[nodiscard]] std::vector<int64_t> counts() const {
        std::vector<int64_t> result;
        for (const Axis &axis : axes) {
            result.push_back(std::ssize(axis.orders()));
        }
        return result;
    }
};

nurbs_status try_spline(const Grid &grid, Handle &made) {
    std::vector<int32_t> degrees, orders, ends;
    std::vector<double> params;
    uint32_t flags = 0;
    for (size_t k = 0; k < grid.axes.size(); ++k) {
        const Axis &axis = grid.axes[k];
        const auto own = axis.params();
        const auto own_orders = axis.orders();
        degrees.push_back(axis.degree);
        params.insert(params.end(), own.begin(), own.end());
        orders.insert(orders.end(), own_orders.begin(), own_orders.end());
        ends.insert(ends.end(), {axis.ends[0], axis.ends[1]});
        flags |= axis.periodic ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
    }
    nurbs *out = nullptr;
    const nurbs_status status = nurbs_interpolate_derivatives(
        static_cast<int32_t>(grid.axes.size()), degrees.data(), grid.counts().data(), params.data(),
        orders.data(), grid.dim, grid.values.data(), 0, 0, ends.data(), flags, &out);
    made.reset(out);
    return status;
}

Handle spline(const Grid &grid) {
    Handle made;
    require_ok(try_spline(grid, made));
    return made;
}

// Calls body(parameters, orders, place of the value) for all layers.
template <class Body>
void for_each_value(const Grid &grid, Body &&body) {
    const auto counts = grid.counts();
    const int64_t total = std::accumulate(counts.begin(), counts.end(), int64_t{1}, std::multiplies<>());
    for (int64_t i = 0; i < total; ++i) {
        std::vector<double> param(counts.size());
        std::vector<int> order(counts.size());
        int64_t rest = i;
        for (size_t k = counts.size(); k-- > 0; rest /= counts[k]) {
            const auto at = static_cast<size_t>(rest % counts[k]);
            param[k] = grid.axes[k].params()[at];
            order[k] = grid.axes[k].orders()[at];
        }
        body(param, order, i);
    }
}

// The derivatives of a spline that a grid asks for.
std::vector<double> sampled(const Grid &grid, const nurbs *g) {
    std::vector<double> values;
    for_each_value(grid, [&](const std::vector<double> &param, const std::vector<int> &order, int64_t) {
        const int most = std::accumulate(order.begin(), order.end(), 0);
        const auto jet = eval_derivs(g, most, param);
        const int64_t first = slot_of(order) * grid.dim;
        values.insert(values.end(), jet.begin() + first, jet.begin() + first + grid.dim);
    });
    return values;
}

std::vector<int32_t> random_orders(Random &random, int degree, int most) {
    std::vector<int32_t> orders;
    for (int32_t order = 1; order <= degree && std::ssize(orders) < most; ++order) {
        if (random.chance(70)) {
            orders.push_back(order);
        }
    }
    return orders;
}

Axis random_axis(Random &random, int highest, bool gaps) {
    Axis axis;
    axis.degree = random.whole(1, highest);
    const int most = axis.degree / 2;
    axis.at_start = gaps ? random_orders(random, axis.degree, random.whole(0, most)) : std::vector<int32_t>();
    axis.at_end = gaps ? random_orders(random, axis.degree, random.whole(0, most)) : std::vector<int32_t>();
    if (!gaps) {
        axis.at_start.resize(static_cast<size_t>(random.whole(0, most)));
        axis.at_end.resize(static_cast<size_t>(random.whole(0, most)));
        std::iota(axis.at_start.begin(), axis.at_start.end(), 1);
        std::iota(axis.at_end.begin(), axis.at_end.end(), 1);
    }
    const int left_out = 2 * most - static_cast<int>(axis.at_start.size() + axis.at_end.size());
    const int least = std::max(2, left_out + (axis.degree % 2 == 0 ? 1 : 2));
    double t = random.between(-1, 1);
    for (int i = least + random.whole(0, 5); i > 0; --i, t += random.between(0.5, 1)) {
        axis.sites.push_back(t);
    }
    return axis;
}

Grid random_grid(Random &random, int axes, int highest, bool gaps = true) {
    Grid grid;
    grid.dim = random.whole(1, 3);
    for (int k = 0; k < axes; ++k) {
        grid.axes.push_back(random_axis(random, highest, gaps));
    }
    return grid;
}

// A spline over the knots that interpolation takes.
SplineData random_spline_over(const Grid &grid, Random &random) {
    SplineData data;
    data.dim = grid.dim;
    int64_t total = grid.dim;
    for (const Axis &axis : grid.axes) {
        set_axis(data, axis.degree, axis.knots());
        total *= data.counts.back();
    }
    for (int64_t i = 0; i < total; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return data;
}

// How much larger the control points of data may be than these: each end and each degree has its share. Derivative m of data of
// size 1 is (2 degree)^m or so, with steps of 1/2, and rounded to eps of itself.
double bound_of(const Grid &grid) {
    double bound = 16;
    for (const Axis &axis : grid.axes) {
        bound *= std::pow(4.0, axis.degree);
    }
    return bound;
}

TEST(InterpolationDerivatives, gives_splines_back) {
    WorstErrors worst("control points given back by degree of axis 0, unit eps");
    int64_t met = 0;
    for_each_case(970000, 600, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(50) ? 1 : random.whole(2, 3);
        Grid grid = random_grid(random, axes, axes == 1 ? 9 : axes == 2 ? 5 : 3);
        const SplineData data = random_spline_over(grid, random);
        const Handle g = create(data);
        grid.values = sampled(grid, g.get());
        Handle back;
        const nurbs_status status = try_spline(grid, back);
        if (status == NURBS_ERROR_RANK) {
            return; // Birkhoff's conditions may be dependent
        }
        require_ok(status);
        ++met;
        const SplineData found = read_back(back.get());
        ASSERT_TRUE(same_bits(found.all_knots(), data.all_knots())) << where(seed, data);
        for (size_t i = 0; i < data.points.size(); ++i) {
            const double error = std::fabs(found.points[i] - data.points[i]);
            worst.add(data.degrees[0], error / (bound_of(grid) * eps), error / eps);
            ASSERT_LE(error, bound_of(grid) * eps) << where(seed, data);
        }
    });
    EXPECT_GE(met, of_whole_run(500));
}

// The layers value, slope, value, slope of a cubic between two parameters at distance h, into its control points.
std::vector<Rational> hermite(const std::vector<Rational> &data, const Rational &h) {
    return {data[0], data[0] + h * data[1] / 3, data[2] - h * data[3] / 3, data[2]};
}

// Ferguson's patch: all that is known at four corners, in exact arithmetic.
TEST(InterpolationDerivatives, of_four_corners_are_the_exact_patch) {
    for_each_case(976000, 300, [](Random &random, uint64_t seed) {
        Grid grid;
        std::vector<Rational> steps;
        for (int k = 0; k < 2; ++k) {
            Axis axis;
            const double from = random.between(-1, 1);
            axis.sites = {from, from + random.magnitude(1e-3, 1e3)};
            axis.at_start = axis.at_end = {1};
            steps.push_back(reference::exact(axis.sites[1]) - reference::exact(axis.sites[0]));
            grid.axes.push_back(axis);
        }
        std::vector<std::vector<Rational>> rows(4);
        for (int i = 0; i < 16; ++i) {
            grid.values.push_back(random.between(-1, 1));
            rows[static_cast<size_t>(i / 4)].push_back(reference::exact(grid.values.back()));
        }
        std::ranges::transform(rows, rows.begin(), [&](const auto &row) { return hermite(row, steps[1]); });
        const SplineData found = read_back(spline(grid).get());
        const double unit = eps * extent(found);
        for (size_t j = 0; j < 4; ++j) {
            const auto column = hermite({rows[0][j], rows[1][j], rows[2][j], rows[3][j]}, steps[0]);
            for (size_t i = 0; i < 4; ++i) {
                ASSERT_LE(size_of(reference::exact(found.points[4 * i + j]) - column[i]), 16 * unit)
                    << "seed " << seed << " control point " << i << ' ' << j;
            }
        }
    });
}

// Along one axis it is the curve that nurbs_curve_interpolate() makes of the same conditions, over the same knots.
TEST(InterpolationDerivatives, of_one_axis_are_those_of_curves) {
    for_each_case(971000, 300, [](Random &random, uint64_t seed) {
        Grid grid = random_grid(random, 1, 9, false);
        const Axis &axis = grid.axes[0];
        for (int64_t i = 0; i < grid.counts()[0] * grid.dim; ++i) {
            grid.values.push_back(random.between(-1, 1));
        }
        const SplineData one = read_back(spline(grid).get());
        const auto params = axis.params(), knots = one.all_knots();
        const auto orders = axis.orders();
        const Handle other = made([&](nurbs **out) {
            return nurbs_curve_interpolate(axis.degree, grid.counts()[0], params.data(), orders.data(),
                                           grid.dim, grid.values.data(), 0, 0, knots.data(),
                                           std::ssize(knots), 0, out);
        });
        const SplineData curve = read_back(other.get());
        for (size_t i = 0; i < one.points.size(); ++i) {
            ASSERT_NEAR(one.points[i], curve.points[i], bound_of(grid) * eps * (1 + extent(curve)))
                << "seed " << seed;
        }
    });
}

// Along axis 1 at a site of axis 0 a surface is the curve of that row.
TEST(InterpolationDerivatives, of_rows_are_those_of_curves) {
    for_each_case(972000, 200, [](Random &random, uint64_t seed) {
        Grid grid = random_grid(random, 2, 5, false);
        const auto counts = grid.counts();
        for (int64_t i = 0; i < counts[0] * counts[1] * grid.dim; ++i) {
            grid.values.push_back(random.between(-1, 1));
        }
        const Handle surface = spline(grid);
        const double unit = bound_of(grid) * eps * (1 + extent(read_back(surface.get())));
        for (int64_t i = 0; i < counts[0]; ++i) {
            const auto at = static_cast<size_t>(i);
            if (grid.axes[0].orders()[at] > 0) {
                continue;
            }
            Grid row{{grid.axes[1]}, grid.dim, {}};
            const auto first = grid.values.begin() + i * counts[1] * grid.dim;
            row.values.assign(first, first + counts[1] * grid.dim);
            const SplineData wanted = read_back(spline(row).get()),
                             found = read_back(iso(surface.get(), 0, grid.axes[0].params()[at]).get());
            for (size_t j = 0; j < wanted.points.size(); ++j) {
                ASSERT_NEAR(found.points[j], wanted.points[j], unit) << "seed " << seed << " row " << i;
            }
        }
    });
}

// Polynomials of the degrees need no mixed derivatives.
TEST(InterpolationDerivatives, estimates_of_mixed_ones_keep_polynomials) {
    int64_t unknown = 0;
    for_each_case(973000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(2, 3);
        Grid grid = random_grid(random, axes, axes == 2 ? 5 : 3, false);
        SplineData data = random_spline_over(grid, random);
        data.counts.clear();
        data.points.clear();
        int64_t total = grid.dim;
        for (size_t k = 0; k < data.knots.size(); ++k) {
            const auto p = static_cast<size_t>(data.degrees[k]);
            while (grid.axes[k].sites.size() <= p) { // as many layers as the polynomial has coefficients
                grid.axes[k].sites.push_back(grid.axes[k].sites.back() + random.between(0.5, 1));
            }
            const std::vector<double> &sites = grid.axes[k].sites;
            data.knots[k].assign(p + 1, sites.front());
            data.knots[k].insert(data.knots[k].end(), p + 1, sites.back());
            data.counts.push_back(data.degrees[k] + 1);
            total *= data.counts.back();
        }
        for (int64_t i = 0; i < total; ++i) {
            data.points.push_back(random.between(-1, 1));
        }
        const Handle g = create(data);
        grid.values = sampled(grid, g.get());
        for_each_value(grid, [&](const std::vector<double> &, const std::vector<int> &order, int64_t i) {
            if (std::ranges::count_if(order, [](int m) { return m > 0; }) > 1 && random.chance(80)) {
                std::fill_n(grid.values.begin() + i * grid.dim, grid.dim, std::nan(""));
                ++unknown;
            }
        });
        const Handle back = spline(grid);
        for (int i = 0; i < 8; ++i) {
            std::vector<double> t;
            for (const Axis &axis : grid.axes) {
                t.push_back(random.between(axis.sites.front(), axis.sites.back()));
            }
            const auto a = eval(g.get(), t), b = eval(back.get(), t);
            for (size_t c = 0; c < a.size(); ++c) {
                ASSERT_NEAR(a[c], b[c], 16 * bound_of(grid) * eps) << where(seed, data);
            }
        }
    });
    EXPECT_GE(unknown, of_whole_run(500));
}

// Of sin(x + 2 y + 0.3) from its values on a grid over [0, 3]^2 and its derivatives at the borders, all as far as the degree
// takes them, mixed ones known or not.
double error_on_sine(int32_t degree, int count, bool mixed) {
    Grid grid;
    for (int k = 0; k < 2; ++k) {
        Axis axis;
        axis.degree = degree;
        axis.at_start.resize(static_cast<size_t>(degree / 2));
        std::iota(axis.at_start.begin(), axis.at_start.end(), 1);
        axis.at_end = axis.at_start;
        for (int i = 0; i < count; ++i) {
            axis.sites.push_back(3.0 * i / (count - 1));
        }
        grid.axes.push_back(axis);
    }
    const double right_angle = std::acos(0.0);
    for_each_value(grid, [&](const std::vector<double> &at, const std::vector<int> &order, int64_t) {
        const double angle = at[0] + 2 * at[1] + 0.3 + right_angle * (order[0] + order[1]);
        const bool unknown = !mixed && order[0] > 0 && order[1] > 0;
        grid.values.push_back(unknown ? std::nan("") : std::ldexp(std::sin(angle), order[1]));
    });
    const Handle made = spline(grid);
    double largest = 0;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            const double x = 3 * (i + 0.37) / 40, y = 3 * (j + 0.61) / 40;
            largest = std::max(largest, std::fabs(eval(made.get(), {x, y})[0] - std::sin(x + 2 * y + 0.3)));
        }
    }
    return largest;
}

// Halving the steps divides the error by 2^(degree + 1). Estimates of mixed derivatives have a larger error of the same or
// a higher order: it falls at least as fast.
TEST(InterpolationDerivatives, converge_with_the_order) {
    for (int32_t degree = 2; degree <= 7; ++degree) {
        const auto order = [&](bool mixed) {
            return std::log2(error_on_sine(degree, 17, mixed) / error_on_sine(degree, 33, mixed));
        };
        EXPECT_GT(order(true), degree + 0.5) << "degree " << degree;
        EXPECT_LT(order(true), degree + 2.6) << "degree " << degree;
        EXPECT_GT(order(false), degree + 0.5) << "degree " << degree;
        if (degree < 6) { // else there is little but rounding
            EXPECT_LT(error_on_sine(degree, 65, false), 2 * error_on_sine(degree, 65, true))
                << "degree " << degree;
        }
    }
}

// Without derivatives it is nurbs_interpolate(), bit for bit, with periodic axes and natural ends too; and natural ends are
// those whose second derivatives are 0.
TEST(InterpolationDerivatives, go_together_with_other_ends) {
    for_each_case(975000, 200, [](Random &random, uint64_t seed) {
        Grid grid;
        Axis across, along;
        for (int i = 0; i < 5; ++i) {
            across.sites.push_back(i + random.between(0, 0.5));
            along.sites.push_back(i + random.between(0, 0.5));
        }
        along.at_start = along.at_end = {2};
        across.periodic = random.chance(50);
        across.ends[0] = across.ends[1] = across.periodic ? 0 : random.whole(0, 2);
        grid.axes = {across, along};
        for (int i = 0; i < 5 * 7; ++i) {
            const int layer = i % 7;
            grid.values.push_back(layer == 1 || layer == 6 ? 0 : random.between(-1, 1));
        }
        std::copy_n(grid.values.begin(), 7, grid.values.begin() + 28);
        Grid natural = grid;
        natural.axes[1].at_start = natural.axes[1].at_end = {};
        natural.axes[1].ends[0] = natural.axes[1].ends[1] = NURBS_ENDS_NATURAL;
        natural.values.clear();
        for (size_t i = 0; i < grid.values.size(); ++i) {
            if (i % 7 != 1 && i % 7 != 6) {
                natural.values.push_back(grid.values[i]);
            }
        }
        const SplineData one = read_back(spline(grid).get()), other = read_back(spline(natural).get());
        for (size_t i = 0; i < one.points.size(); ++i) {
            ASSERT_NEAR(one.points[i], other.points[i], 100 * eps) << "seed " << seed;
        }
        const int32_t degrees[2] = {3, 3}, ends[4] = {across.ends[0], across.ends[1], 1, 1};
        std::vector<double> params = across.sites;
        params.insert(params.end(), along.sites.begin(), along.sites.end());
        const Handle plain = made([&](nurbs **out) {
            return nurbs_interpolate(2, degrees, natural.counts().data(), params.data(), 1,
                                     natural.values.data(), 0, 0, ends, across.periodic ? NURBS_PERIODIC : 0,
                                     nullptr, out);
        });
        ASSERT_TRUE(same_bits(read_back(plain.get()).points, other.points)) << "seed " << seed;
    });
}

} // namespace

} // namespace interpolation_derivatives_test
