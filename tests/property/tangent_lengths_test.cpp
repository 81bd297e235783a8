// Tangents of known direction: their lengths are those of least energy, and depend on nothing else.
#include "property/products.h"

#include <cstdint>

namespace tangent_lengths_test {

using namespace support;
using namespace support::products;

namespace {

// What nurbs_curve_interpolate() takes.
struct Conditions {
    int32_t degree = 3, dim = 2;
    std::vector<double> params, targets, knots;
    std::vector<int32_t> orders;
    uint32_t flags = 0;

    [[nodiscard]] int64_t n() const { return std::ssize(params); }
    [[nodiscard]] bool is_direction(int64_t i) const {
        return orders[static_cast<size_t>(i)] == NURBS_ORDER_DIRECTION;
    }
    void add(double t, int32_t order, const std::vector<double> &target) {
        params.push_back(t);
        orders.push_back(order);
        targets.insert(targets.end(), target.begin(), target.end());
    }
};

nurbs_status try_curve(const Conditions &given, Handle &made) {
    nurbs *out = nullptr;
    const nurbs_status status = nurbs_curve_interpolate(
        given.degree, given.n(), given.params.data(), given.orders.data(), given.dim, given.targets.data(), 0,
        0, given.knots.data(), std::ssize(given.knots), given.flags, &out);
    made.reset(out);
    return status;
}

Handle curve(const Conditions &given) {
    Handle made;
    require_ok(try_curve(given, made));
    return made;
}

nurbs_status try_lengths(const Conditions &given, std::vector<double> &lengths) {
    lengths.assign(given.params.size(), -7);
    return nurbs_tangent_lengths(given.degree, given.n(), given.params.data(), given.orders.data(), given.dim,
                                 given.targets.data(), 0, 0, given.knots.data(), std::ssize(given.knots),
                                 given.flags, lengths.data());
}

std::vector<double> lengths_of(const Conditions &given) {
    std::vector<double> lengths;
    require_ok(try_lengths(given, lengths));
    return lengths;
}

// The same with derivatives instead of directions.
Conditions as_derivatives(Conditions given, const std::vector<double> &lengths) {
    for (size_t i = 0; i < given.targets.size(); ++i) {
        given.targets[i] *= lengths[i / static_cast<size_t>(given.dim)];
    }
    std::ranges::replace(given.orders, NURBS_ORDER_DIRECTION, 1);
    return given;
}

// With directions that least energy goes along.
Conditions turned(Conditions given, const std::vector<double> &lengths) {
    for (size_t i = 0; i < given.targets.size(); ++i) {
        given.targets[i] *= lengths[i / static_cast<size_t>(given.dim)] < 0 ? -1 : 1;
    }
    return given;
}

double energy(const nurbs *g) {
    const Handle second = made([&](nurbs **out) { return nurbs_derivative(g, 0, 2, out); });
    const Handle square = product(second.get(), second.get(), NURBS_PRODUCT_DOT);
    const Handle sum = made([&](nurbs **out) { return nurbs_antiderivative(square.get(), 0, out); });
    double domain[2], ends[2];
    require_ok(nurbs_domain(g, 0, domain));
    require_ok(nurbs_eval(sum.get(), 2, domain, 0, 0, ends, 0, 0, NURBS_CLAMP));
    return ends[1] - ends[0];
}

std::vector<double> random_vector(Random &random, int dim) {
    std::vector<double> result;
    for (int c = 0; c < dim; ++c) {
        result.push_back(random.between(-1, 1));
    }
    return result;
}

// Points, and at some of them derivatives or directions.
Conditions random_conditions(Random &random) {
    Conditions given;
    given.degree = random.whole(2, 7);
    given.dim = random.whole(1, 3);
    double t = random.between(-1, 1);
    bool any = false;
    const int64_t least = given.degree + random.whole(1, 12);
    while (given.n() < least || !any) {
        given.add(t, 0, random_vector(random, given.dim));
        const int kind = random.whole(0, 3);
        if (kind > 0) {
            given.add(t, kind == 1 ? 1 : NURBS_ORDER_DIRECTION, random_vector(random, given.dim));
            any = any || kind > 1;
        }
        if (kind == 3 && given.degree > 3) {
            given.add(t, 2, random_vector(random, given.dim));
        }
        t += random.between(0.5, 1);
    }
    return given;
}

// A closed curve, over as many knots as it has conditions.
Conditions random_loop(Random &random) {
    Conditions given;
    given.degree = random.whole(2, 5);
    given.flags = NURBS_PERIODIC;
    const int count = random.whole(2, 12);
    std::vector<double> breaks;
    for (int i = 0; i < count; ++i) {
        given.add(i, 0, random_vector(random, 2));
        given.add(i, random.chance(70) || i == 0 ? NURBS_ORDER_DIRECTION : 1, random_vector(random, 2));
        breaks.insert(breaks.end(), {i - 0.3, i + 0.2});
    }
    breaks.push_back(breaks.front() + count);
    given.knots.resize(breaks.size() + 2 * static_cast<size_t>(given.degree));
    require_ok(nurbs_knots_periodic(given.degree, std::ssize(breaks), breaks.data(), nullptr,
                                    std::ssize(given.knots), given.knots.data()));
    // Parameters lie in the domain, by rising ones.
    const double start = breaks.front(), period = count;
    for (double &param : given.params) {
        param += param < start ? period : 0;
    }
    return given;
}

// Calls body(given, lengths, random, seed) where conditions determine a curve.
template <class Body>
void for_each_conditions(uint64_t base, int count, Body &&body) {
    int64_t met = 0;
    for_each_case(base, count, [&](Random &random, uint64_t seed) {
        const Conditions given = random.chance(25) ? random_loop(random) : random_conditions(random);
        std::vector<double> lengths;
        const nurbs_status status = try_lengths(given, lengths);
        if (status == NURBS_ERROR_RANK || status == NURBS_ERROR_END_MULTIPLICITY ||
            status == NURBS_ERROR_EMPTY_DOMAIN) {
            return;
        }
        require_ok(status);
        ++met;
        body(given, lengths, random, seed);
    });
    EXPECT_GE(met, of_whole_run(count / 2));
}

TEST(TangentLengths, make_derivatives_of_the_same_curve) {
    for_each_conditions(
        960000, 400,
        [](const Conditions &given, const std::vector<double> &lengths, Random &, uint64_t seed) {
            for (int64_t i = 0; i < given.n(); ++i) {
                ASSERT_TRUE(given.is_direction(i) || lengths[static_cast<size_t>(i)] == 1) << "seed " << seed;
            }
            const Conditions along = turned(given, lengths);
            const std::vector<double> again = lengths_of(along);
            const auto one = read_back(curve(along).get()),
                       other = read_back(curve(as_derivatives(along, again)).get());
            ASSERT_TRUE(same_bits(one.points, other.points)) << "seed " << seed;
            ASSERT_TRUE(same_bits(one.all_knots(), other.all_knots())) << "seed " << seed;
        });
}

TEST(TangentLengths, have_the_least_energy) {
    for_each_conditions(
        961000, 300,
        [](const Conditions &given, const std::vector<double> &lengths, Random &random, uint64_t seed) {
            const double least = energy(curve(as_derivatives(given, lengths)).get());
            for (int i = 0; i < 5; ++i) {
                std::vector<double> others(lengths);
                const double step = random.magnitude(1e-3, 1);
                for (int64_t j = 0; j < given.n(); ++j) {
                    others[static_cast<size_t>(j)] +=
                        given.is_direction(j) ? step * random.between(-1, 1) : 0;
                }
                ASSERT_GE(energy(curve(as_derivatives(given, others)).get()), least * (1 - 1e-9))
                    << "seed " << seed << " step " << step;
            }
        });
}

// Powers of two are exact: of directions, of all targets, of parameters.
TEST(TangentLengths, are_free_of_scale) {
    for_each_conditions(
        962000, 200,
        [](const Conditions &given, const std::vector<double> &lengths, Random &random, uint64_t seed) {
            Conditions other = given;
            std::vector<double> wanted = lengths;
            const double size = std::ldexp(1.0, random.whole(-40, 40)),
                         speed = std::ldexp(1.0, random.whole(-30, 30));
            for (int64_t i = 0; i < given.n(); ++i) {
                const auto at = static_cast<size_t>(i);
                const int own = given.is_direction(i) ? random.whole(-30, 30) : 0;
                const double factor =
                    given.is_direction(i) ? std::ldexp(1.0, own) : size * std::pow(speed, -given.orders[at]);
                for (int c = 0; c < given.dim; ++c) {
                    other.targets[at * static_cast<size_t>(given.dim) + static_cast<size_t>(c)] *= factor;
                }
                wanted[at] *= given.is_direction(i) ? size / speed / factor : 1;
                other.params[at] *= speed;
            }
            std::ranges::for_each(other.knots, [speed](double &t) { t *= speed; });
            ASSERT_TRUE(same_bits(lengths_of(other), wanted)) << "seed " << seed;
        });
}

// Moved as far as coordinates stay exact.
TEST(TangentLengths, do_not_depend_on_the_place) {
    for_each_conditions(
        966000, 200, [](Conditions given, const std::vector<double> &, Random &random, uint64_t seed) {
            std::ranges::for_each(given.targets, [](double &x) { x = (std::round(x * 64) + 0.5) / 64; });
            const auto wanted = lengths_of(given);
            Conditions moved = given;
            for (size_t c = 0; c < static_cast<size_t>(given.dim); ++c) {
                const double offset = std::ldexp(1.0, random.whole(10, 40));
                for (size_t i = 0; i < given.params.size(); ++i) {
                    moved.targets[i * static_cast<size_t>(given.dim) + c] +=
                        given.orders[i] == 0 ? offset : 0;
                }
            }
            ASSERT_TRUE(same_bits(lengths_of(moved), wanted)) << "seed " << seed;
        });
}

// The natural spline has the least energy of all curves through its points, so that directions of its own tangents, also
// where there are no other knots than its own, change nothing.
TEST(TangentLengths, give_natural_splines_back) {
    for_each_case(963000, 200, [](Random &random, uint64_t seed) {
        const int32_t degree = 3;
        const int64_t count = random.whole(2, 12);
        const int32_t ends[2] = {NURBS_ENDS_NATURAL, NURBS_ENDS_NATURAL};
        std::vector<double> params{random.between(-1, 1)}, points;
        while (std::ssize(params) < count) {
            params.push_back(params.back() + random.magnitude(0.1, 1));
        }
        for (int64_t i = 0; i < 2 * count; ++i) {
            points.push_back(random.between(-1, 1));
        }
        const Handle natural = made([&](nurbs **out) {
            return nurbs_interpolate(1, &degree, &count, params.data(), 2, points.data(), 0, 0, ends, 0,
                                     nullptr, out);
        });
        Conditions given;
        for (int64_t i = 0; i < count; ++i) {
            const auto at = static_cast<size_t>(i);
            given.add(params[at], 0, {points[2 * at], points[2 * at + 1]});
            if (i == 0 || i == count - 1 || random.chance(50)) { // another condition: a double knot
                const auto jet = eval_derivs(natural.get(), 1, {params[at]});
                given.add(params[at], NURBS_ORDER_DIRECTION, {jet[2], jet[3]});
            }
        }
        for (size_t i = 0; i < given.params.size(); ++i) {
            const size_t times =
                given.params[i] == params.front() || given.params[i] == params.back() ? 2 : 1;
            given.knots.insert(given.knots.end(), times, given.params[i]);
        }
        const auto lengths = lengths_of(given);
        // Energies near the least one differ by the square: half of the digits are sure.
        for (const double length : lengths) {
            ASSERT_NEAR(length, 1, 1e-7) << "seed " << seed;
        }
        const Handle back = curve(given);
        for (int i = 0; i < 10; ++i) {
            const std::vector<double> t{random.between(params.front(), params.back())};
            const auto a = eval(natural.get(), t), b = eval(back.get(), t);
            ASSERT_NEAR(a[0], b[0], 1e-10) << "seed " << seed;
            ASSERT_NEAR(a[1], b[1], 1e-10) << "seed " << seed;
        }
    });
}

// Points of a line at a constant speed, and directions along it: that speed costs nothing.
TEST(TangentLengths, give_lines_back) {
    for_each_case(964000, 200, [](Random &random, uint64_t seed) {
        Conditions given = random_conditions(random);
        const auto origin = random_vector(random, given.dim), velocity = random_vector(random, given.dim);
        const double offset = random.chance(30) ? 1e6 : 0;
        for (size_t i = 0; i < given.params.size(); ++i) {
            for (size_t c = 0; c < origin.size(); ++c) {
                const int order = given.orders[i];
                given.targets[i * origin.size() + c] =
                    order == 0 ? offset + origin[c] + given.params[i] * velocity[c]
                               : (order > 1 ? 0 : velocity[c] * (order == 1 ? 1 : 0.5));
            }
        }
        std::vector<double> lengths;
        const nurbs_status status = try_lengths(given, lengths);
        if (status == NURBS_ERROR_RANK || status == NURBS_ERROR_END_MULTIPLICITY ||
            status == NURBS_ERROR_EMPTY_DOMAIN) {
            return;
        }
        require_ok(status);
        for (int64_t i = 0; i < given.n(); ++i) {
            const double wanted = given.is_direction(i) ? 2 : 1;
            ASSERT_NEAR(lengths[static_cast<size_t>(i)], wanted, offset > 0 ? 1e-6 : 1e-9) << "seed " << seed;
        }
    });
}

// The least energy of one free cubic piece after the other would go backwards here: a tangent that points back.
TEST(TangentLengths, refuse_tangents_that_go_back) {
    for_each_case(965000, 100, [](Random &random, uint64_t seed) {
        Conditions given;
        for (int i = 0; i < 6; ++i) {
            given.add(i, 0, {static_cast<double>(i), random.between(-0.1, 0.1)});
            given.add(i, NURBS_ORDER_DIRECTION, {1, random.between(-0.1, 0.1)});
        }
        const auto lengths = lengths_of(given);
        ASSERT_GT(*std::min_element(lengths.begin(), lengths.end()), 0) << "seed " << seed;
        const auto back = static_cast<size_t>(2 * random.whole(0, 5) + 1);
        given.targets[2 * back] *= -1;
        given.targets[2 * back + 1] *= -1;
        auto wanted = lengths;
        wanted[back] *= -1;
        ASSERT_TRUE(same_bits(lengths_of(given), wanted)) << "seed " << seed;
        Handle made;
        ASSERT_EQ(try_curve(given, made), NURBS_ERROR_TANGENT) << "seed " << seed;
        ASSERT_NE(last_error().find("targets[" + std::to_string(back) + "]"), std::string::npos)
            << last_error();
    });
}

} // namespace

} // namespace tangent_lengths_test
