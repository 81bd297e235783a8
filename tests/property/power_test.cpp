// The power basis and Hermite data: against exact derivatives of the given spline, and round trips.
#include "property/same_shape.h"
#include "reference/exact_spline.h"

namespace power_test {

using namespace support;
using reference::Sides;

namespace {

struct Power {
    std::vector<double> coefficients;
    std::vector<double> breaks;
    std::vector<int64_t> pieces;
    int width = 0;
};

Power power_of(const nurbs *g, const SplineData &data) {
    Power result;
    int64_t count = 0, total = 0;
    result.pieces.resize(static_cast<size_t>(data.axes()));
    require_ok(nurbs_to_power(g, 0, nullptr, nullptr, result.pieces.data(), &count));
    for (const int64_t n : result.pieces) {
        total += n + 1;
    }
    result.coefficients.resize(static_cast<size_t>(count));
    result.breaks.resize(static_cast<size_t>(total));
    require_ok(nurbs_to_power(g, count, result.coefficients.data(), result.breaks.data(), nullptr, nullptr));
    result.width = data.dim + (data.rational() ? 1 : 0);
    return result;
}

Handle from_power(const Power &power, const SplineData &data) {
    nurbs *out = nullptr;
    require_ok(nurbs_create_power(data.axes(), data.degrees.data(), power.pieces.data(), power.breaks.data(),
                                  static_cast<int64_t>(power.breaks.size()), data.dim,
                                  power.coefficients.data(), 0, 0, data.rational() ? NURBS_HOMOGENEOUS : 0,
                                  &out));
    return Handle(out);
}

// Calls body(piece, powers, place) for each record of coefficients: indices along the axes, last one fastest.
template <class Body>
void for_each_record(const SplineData &data, const std::vector<int64_t> &pieces, Body body) {
    const auto axes = static_cast<size_t>(data.axes());
    std::vector<int64_t> sizes = pieces;
    sizes.insert(sizes.end(), data.degrees.begin(), data.degrees.end());
    std::for_each(sizes.begin() + data.axes(), sizes.end(), [](int64_t &n) { ++n; });
    std::vector<int64_t> index(2 * axes, 0);
    for (size_t place = 0;; ++place) {
        MultiIndex powers(axes);
        std::transform(index.begin() + data.axes(), index.end(), powers.begin(),
                       [](int64_t i) { return static_cast<int>(i); });
        body(index, powers, place);
        size_t k = index.size();
        while (k > 0 && ++index[k - 1] == sizes[k - 1]) {
            index[--k] = 0;
        }
        if (k == 0) {
            return;
        }
    }
}

// The largest magnitude of component c of the control points that are active at a place.
double active_size(const SplineData &data, const double *param, size_t c) {
    double size = 0;
    for (const int64_t i : reference::active_points(data, reference::first_active(data, param))) {
        size = std::max(size, std::fabs(data.coordinate(i, static_cast<int>(c))));
    }
    return size;
}

// Breaks of an axis begin here in the list of all.
size_t first_break(const Power &power, size_t axis) {
    size_t first = 0;
    for (size_t k = 0; k < axis; ++k) {
        first += static_cast<size_t>(power.pieces[k]) + 1;
    }
    return first;
}

// 2^k binomial(p, k) / h^k over all axes.
long double amplification(const SplineData &data, const Power &power, const std::vector<int64_t> &index,
                          const MultiIndex &powers) {
    long double factor = 1;
    for (size_t k = 0; k < powers.size(); ++k) {
        const double *a = power.breaks.data() + first_break(power, k) + index[k];
        const long double h = static_cast<long double>(a[1]) - a[0];
        factor *= static_cast<long double>(binomial(data.degrees[k], powers[k])) * std::pow(2 / h, powers[k]);
    }
    return factor;
}

void check_coefficients(const SplineData &data, const SplineData &records, const Power &power,
                        WorstErrors &worst, const std::string &what) {
    int order = 0;
    for (const int32_t p : data.degrees) {
        order += p;
    }
    std::vector<double> corner;
    std::vector<std::vector<reference::Fraction>> derivs;
    for_each_record(data, power.pieces, [&](const auto &index, const MultiIndex &powers, size_t place) {
        long double steps = 0;
        reference::Integer factorials = 1;
        for (size_t k = 0; k < powers.size(); ++k) {
            steps += 2 + 2 * powers[k];
            for (int i = 2; i <= powers[k]; ++i) {
                factorials *= i;
            }
        }
        if (*std::max_element(powers.begin(), powers.end()) == 0) { // a new piece
            corner.clear();
            for (size_t k = 0; k < powers.size(); ++k) {
                corner.push_back(power.breaks[first_break(power, k) + static_cast<size_t>(index[k])]);
            }
            derivs = reference::exact_derivatives(records, order, corner.data());
        }
        const auto width = static_cast<size_t>(power.width);
        const long double factor = amplification(data, power, index, powers);
        for (size_t c = 0; c < width; ++c) {
            reference::Fraction want = derivs[static_cast<size_t>(slot_of(powers))][c];
            want.denominator *= factorials;
            const long double unit = eps * factor * active_size(records, corner.data(), c) + 0x1p-1060L;
            const long double error =
                reference::error_ratio(power.coefficients[place * width + c], want, unit);
            worst.add(data.degrees[0], error / steps, error);
            ASSERT_LE(error, steps) << what << " record " << place << " component " << c;
        }
    });
}

// The records that nurbs_to_power() speaks of.
SplineData records_of(const nurbs *g, const SplineData &data) {
    return data.rational() ? homogeneous(g) : data;
}

TEST(Power, coefficients_are_the_derivatives_at_the_start_of_each_piece) {
    WorstErrors worst("power basis by degree, unit 2^k binomial eps M / h^k");
    for_each_case(93000000, 240, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 4 - axes);
        recipe.dim = random.whole(1, 3);
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const Power power = power_of(g.get(), data);
        check_coefficients(data, records_of(g.get(), data), power, worst, where(seed, data));
    });
}

// b_i within (3 p + 1) / 2 eps for each axis of the sum of the terms' magnitudes, and those not above the
// ones of the differences.
TEST(Power, pieces_come_back) {
    for_each_case(94000000, 240, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 7 : 4 - axes);
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const Power power = power_of(g.get(), data);
        const auto back = from_power(power, data);
        const SplineData got = read_back(back.get());
        ASSERT_EQ(got.degrees, data.degrees);
        for (int k = 0; k < axes; ++k) {
            const auto at = static_cast<size_t>(k);
            ASSERT_EQ(got.counts[at], power.pieces[at] * (data.degrees[at] + 1)) << where(seed, data);
            ASSERT_TRUE(got.lower(k) == data.lower(k) && got.upper(k) == data.upper(k));
        }
        long double moved = 0, growth = 1;
        for (const int32_t p : data.degrees) {
            moved += 4 + 5 * p;
            growth *= std::pow(3.0L, p); // sum of binomial(p, k) 2^k
        }
        expect_same_shape(g.get(), back.get(), moved * growth, random, where(seed, data));
    });
}

// Small integers over spans of powers of two: nothing is rounded.
TEST(Power, exact_where_numbers_are_short) {
    const std::vector<int32_t> degrees = {2, 1};
    const std::vector<int64_t> pieces = {2, 1};
    const std::vector<double> breaks = {0, 2, 3, -1, 3};
    std::vector<double> coefficients;
    for (int i = 0; i < 2 * 3 * 2; ++i) {
        coefficients.push_back(i * i - 7);
    }
    nurbs *out = nullptr;
    require_ok(nurbs_create_power(2, degrees.data(), pieces.data(), breaks.data(), 5, 1, coefficients.data(),
                                  0, 0, 0, &out));
    const Handle g(out);
    const Power power = power_of(g.get(), read_back(g.get()));
    EXPECT_EQ(power.coefficients, coefficients);
    EXPECT_EQ(power.breaks, breaks);
    EXPECT_EQ(power.pieces, pieces);
    // piece (1, 0) at (2.5, 1): powers of 0.5 and 2
    const double *c = coefficients.data() + 6;
    EXPECT_EQ(eval(g.get(), {2.5, 1})[0],
              c[0] + 2 * c[1] + 0.5 * (c[2] + 2 * c[3]) + 0.25 * (c[4] + 2 * c[5]));
}

struct Hermite {
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> tangents;
};

Hermite hermite_of(const nurbs *g, int dim) {
    int64_t n = 0;
    require_ok(nurbs_to_hermite(g, 0, nullptr, nullptr, nullptr, &n));
    const auto size = static_cast<size_t>(n);
    Hermite result{std::vector<double>(size), {}, {}};
    result.points.resize(size * static_cast<size_t>(dim));
    result.tangents.resize(result.points.size());
    require_ok(
        nurbs_to_hermite(g, n, result.params.data(), result.points.data(), result.tangents.data(), &n));
    return result;
}

// C^1 knots of every form.
SplineData smooth_curve(Random &random) {
    for (;;) {
        Recipe recipe = random_recipe(random, 1, 3);
        recipe.weights = Weights::none;
        SplineData data = random_spline(random, recipe);
        const auto &t = data.knots[0];
        const int p = data.degrees[0];
        bool smooth = true;
        for (const double knot : t) {
            const bool inside = knot > data.lower(0) && knot < data.upper(0);
            smooth = smooth && (!inside || std::count(t.begin(), t.end(), knot) < p);
        }
        if (smooth) {
            return data;
        }
    }
}

TEST(ToHermite, points_and_tangents_are_those_of_the_curve) {
    WorstErrors worst("Hermite tangents by degree, unit eps M / h");
    for_each_case(95000000, 400, [&](Random &random, uint64_t seed) {
        const SplineData data = smooth_curve(random);
        const auto g = create(data);
        const Hermite got = hermite_of(g.get(), data.dim);
        const size_t n = got.params.size();
        for (size_t i = 0; i < n; ++i) {
            const double t = got.params[i];
            const bool left = i + 1 == n || (i > 0 && !(got.params[i + 1] - t > t - got.params[i - 1]));
            const double h = left ? t - got.params[i - 1] : got.params[i + 1] - t;
            const auto want = reference::exact_derivatives(data, 1, &t, {left});
            const double *param = &t;
            for (size_t c = 0; c < static_cast<size_t>(data.dim); ++c) {
                double size = 0;
                for (const bool side : {false, true}) {
                    for (const int64_t j :
                         reference::active_points(data, reference::first_active(data, param, {side}))) {
                        size = std::max(size, std::fabs(data.coordinate(j, static_cast<int>(c))));
                    }
                }
                const size_t at = i * static_cast<size_t>(data.dim) + c;
                ASSERT_LE(reference::error_ratio(got.points[at], want[0][c], eps * size), 2)
                    << where(seed, data);
                const long double error =
                    reference::error_ratio(got.tangents[at], want[1][c], eps * size / h);
                const int p = data.degrees[0];
                worst.add(p, error / (14 * std::max(p, 1)), error);
                ASSERT_LE(error, 14 * p) << where(seed, data);
            }
        }
    });
}

TEST(ToHermite, gives_the_curve_back) {
    for_each_case(96000000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = smooth_curve(random);
        const auto g = create(data);
        const Hermite h = hermite_of(g.get(), data.dim);
        nurbs *out = nullptr;
        require_ok(nurbs_create_hermite(static_cast<int64_t>(h.params.size()), h.params.data(), data.dim,
                                        h.points.data(), 0, 0, h.tangents.data(), 0, 0, &out));
        const Handle back(out);
        // A tangent over a long span, stepped along a shorter one beside it: no span ratio enters.
        expect_same_shape(g.get(), back.get(), 2 + 14 * data.degrees[0], random, where(seed, data));
    });
}

} // namespace

} // namespace power_test
