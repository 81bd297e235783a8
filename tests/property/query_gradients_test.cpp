// Gradients of closest points and lengths: differences of the queries themselves, and the laws of moved, scaled
// and turned shapes.
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace query_gradients_test {

using namespace support;

namespace {

// Splines of moderate sizes.
SplineData tame_spline(Random &random, int axes, int dim, int least_degree) {
    Recipe recipe;
    for (int k = 0; k < axes; ++k) {
        AxisRecipe axis{random.whole(least_degree, 4)};
        axis.form = KnotForm::clamped;
        axis.spacing = Spacing::integers;
        axis.spans = 2;
        recipe.axes.push_back(axis);
    }
    recipe.weights = random.chance(60) ? Weights::moderate : Weights::none;
    recipe.dim = dim;
    SplineData data = random_spline(random, recipe);
    std::generate(data.points.begin(), data.points.end(), [&] { return random.between(-1, 1); });
    return data;
}

struct Feet {
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> distances;
};

constexpr int64_t queries = 4;

Feet feet_from(const SplineData &data, const std::vector<double> &points,
               const std::vector<double> *guesses) {
    const auto g = create(data);
    Feet feet{std::vector<double>(static_cast<size_t>(queries * data.axes())),
              std::vector<double>(points.size()), std::vector<double>(queries)};
    require_ok(guesses == nullptr
                   ? nurbs_closest_points(g.get(), queries, points.data(), 0, 0, nullptr, 0, 0,
                                          feet.params.data(), 0, 0, feet.points.data(), 0, 0,
                                          feet.distances.data(), 0, nullptr, 0)
                   : nurbs_closest_local(g.get(), queries, points.data(), 0, 0, guesses->data(), 0, 0,
                                         feet.params.data(), 0, 0, feet.points.data(), 0, 0,
                                         feet.distances.data(), 0, nullptr, 0));
    return feet;
}

// A function of feet with random coefficients, and its cotangents.
struct Loss {
    Feet cotangents;

    Loss(Random &random, const Feet &feet) : cotangents(feet) {
        for (std::vector<double> *part : {&cotangents.params, &cotangents.points, &cotangents.distances}) {
            std::generate(part->begin(), part->end(), [&] { return random.between(-1, 1); });
        }
    }
    [[nodiscard]] double operator()(const Feet &feet) const {
        const auto sum = [](const std::vector<double> &a, const std::vector<double> &b) {
            return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
        };
        return sum(feet.params, cotangents.params) + sum(feet.points, cotangents.points) +
               sum(feet.distances, cotangents.distances);
    }
};

struct Gradients {
    std::vector<double> points;
    std::vector<double> weights;
    std::vector<double> queries;
    std::vector<int32_t> status;
};

Gradients closest_adjoint(const SplineData &data, const std::vector<double> &points, const Feet &feet,
                          const Loss &loss) {
    Gradients out{std::vector<double>(data.points.size()),
                  std::vector<double>(static_cast<size_t>(data.point_count())),
                  std::vector<double>(points.size()), std::vector<int32_t>(queries)};
    require_ok(nurbs_closest_adjoint(create(data).get(), queries, points.data(), feet.params.data(),
                                     loss.cotangents.params.data(), loss.cotangents.points.data(),
                                     loss.cotangents.distances.data(), out.points.data(), out.weights.data(),
                                     out.queries.data(), out.status.data(), 0));
    return out;
}

// The difference quotient of the loss, for a change of the data by a step of a direction.
double difference(const std::function<double(double)> &loss) {
    const double step = 1e-5;
    return (loss(step) - loss(-step)) / (2 * step);
}

std::vector<double> random_vector(Random &random, size_t n) {
    std::vector<double> out(n);
    std::generate(out.begin(), out.end(), [&] { return random.between(-1, 1); });
    return out;
}

std::vector<double> moved(std::vector<double> values, double step, const std::vector<double> &direction) {
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] += step * direction[i];
    }
    return values;
}

double dot(const std::vector<double> &a, const std::vector<double> &b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

TEST(QueryGradients, closest_points_move_as_their_gradients_say) {
    int64_t compared = 0;
    for_each_case(111000000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2), dim = random.whole(axes + 1, 3);
        const SplineData data = tame_spline(random, axes, dim, 2);
        const std::vector<double> points = random_vector(random, static_cast<size_t>(queries * dim));
        const Feet feet = feet_from(data, points, nullptr);
        const Loss loss(random, feet);
        const Gradients got = closest_adjoint(data, points, feet, loss);
        // Where the equations are nearly singular, or a foot leaves its end, differences say nothing.
        const double size = std::sqrt(dot(got.points, got.points) + dot(got.queries, got.queries));
        if (size > 30 ||
            std::any_of(got.status.begin(), got.status.end(), [](int32_t s) { return s != 0; })) {
            return;
        }
        const auto at = [&](const SplineData &changed, const std::vector<double> &where) {
            return loss(feet_from(changed, where, &feet.params));
        };
        const std::vector<double> v = random_vector(random, points.size());
        const std::vector<double> p = random_vector(random, data.points.size());
        const double of_queries = difference([&](double h) { return at(data, moved(points, h, v)); });
        const double of_points = difference([&](double h) {
            SplineData changed = data;
            changed.points = moved(data.points, h, p);
            return at(changed, points);
        });
        ASSERT_NEAR(dot(got.queries, v), of_queries, 1e-4 * (1 + size)) << where(seed, data);
        ASSERT_NEAR(dot(got.points, p), of_points, 1e-4 * (1 + size)) << where(seed, data);
        if (data.rational()) {
            const std::vector<double> w = random_vector(random, data.weights.size());
            const double of_weights = difference([&](double h) {
                SplineData changed = data;
                changed.weights = moved(data.weights, h, w);
                return at(changed, points);
            });
            ASSERT_NEAR(dot(got.weights, w), of_weights, 1e-4 * (1 + size)) << where(seed, data);
        }
        ++compared;
    });
    EXPECT_GE(compared, of_whole_run(40));
}

// At an end of the domain the foot is the end point, whatever the equations say.
TEST(QueryGradients, feet_at_ends_move_with_the_end) {
    const SplineData line{{1}, {2}, {{0, 0, 1, 1}}, 2, {0, 0, 2, 0}, {}, 0};
    const double point[] = {-3, 4}, param[] = {0}, one[] = {1};
    double points[4], queries_out[2];
    int32_t status = 0;
    require_ok(nurbs_closest_adjoint(create(line).get(), 1, point, param, one, nullptr, one, points, nullptr,
                                     queries_out, &status, 0));
    EXPECT_EQ(status, NURBS_CLOSEST_BOUNDARY);
    const std::vector<double> expected{0.6, -0.8, 0, 0};
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(points[i], expected[i], 1e-15);
    }
    EXPECT_NEAR(queries_out[0], -0.6, 1e-15);
    EXPECT_NEAR(queries_out[1], 0.8, 1e-15);
}

// A kink is the foot of all points of a cone, whichever side its derivative is taken from.
TEST(QueryGradients, feet_at_kinks_stay_there) {
    const SplineData corner{{1}, {3}, {{0, 0, 0.5, 1, 1}}, 2, {0, 0, 1, 0, 1, -1}, {}, 0};
    const double point[] = {2, 1}, param[] = {0.5}, along[] = {1, 1}, one[] = {1};
    for (const uint32_t side : {0U, uint32_t{NURBS_LEFT}}) {
        double points[6], queries_out[2];
        int32_t status = 0;
        require_ok(nurbs_closest_adjoint(create(corner).get(), 1, point, param, one, along, nullptr, points,
                                         nullptr, queries_out, &status, side));
        EXPECT_EQ(status, NURBS_CLOSEST_BOUNDARY);
        EXPECT_EQ(queries_out[0], 0);
        EXPECT_EQ(queries_out[1], 0);
        const double expected[] = {0, 0, 1, 1, 0, 0};
        for (size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(points[i], expected[i]) << i;
        }
    }
}

// A point on the curve, to rounding, has no direction to its foot; foot and parameter move as if nothing were asked of
// the distance.
TEST(QueryGradients, distances_of_rounding_size_have_no_direction) {
    int64_t moved_off = 0;
    for_each_case(114000000, 200, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2), dim = random.whole(axes + 1, 3);
        const SplineData data = tame_spline(random, axes, dim, 2);
        std::vector<double> params(static_cast<size_t>(queries * axes)),
            points(static_cast<size_t>(queries * dim));
        for (size_t i = 0; i < params.size(); ++i) {
            const std::vector<double> &knots = data.knots[i % static_cast<size_t>(axes)];
            params[i] = random.between(knots.front(), knots.back());
        }
        require_ok(nurbs_eval(create(data).get(), queries, params.data(), 0, 0, points.data(), 0, 0, 0));
        const Feet feet = feet_from(data, points, nullptr);
        const Loss loss(random, feet);
        Loss rest = loss;
        std::fill(rest.cotangents.distances.begin(), rest.cotangents.distances.end(), 0.0);
        const Gradients got = closest_adjoint(data, points, feet, loss);
        const Gradients expected = closest_adjoint(data, points, feet, rest);
        for (size_t i = 0; i < queries; ++i) {
            moved_off += feet.distances[i] > 0 ? 1 : 0;
            ASSERT_EQ(got.status[i], expected.status[i] | NURBS_CLOSEST_SINGULAR) << where(seed, data) << i;
        }
        ASSERT_EQ(got.points, expected.points) << where(seed, data);
        ASSERT_EQ(got.weights, expected.weights) << where(seed, data);
        ASSERT_EQ(got.queries, expected.queries) << where(seed, data);
    });
    EXPECT_GE(moved_off, of_whole_run(100)); // by rounding
}

// A distance a hundred times as long as its rounding has a direction within a few hundredths of the normal.
TEST(QueryGradients, short_distances_have_the_direction_of_the_normal) {
    const SplineData line{{1}, {2}, {{0, 0, 1, 1}}, 2, {0, 0, 3, 4}, {}, 0};
    const double d = 100 * 9 * std::sqrt(2) * 4 * 0x1p-52, param = 0.5, one = 1;
    const double point[] = {1.5 - 0.8 * d, 2 + 0.6 * d};
    double points[4], of_query[2];
    int32_t status = 0;
    require_ok(nurbs_closest_adjoint(create(line).get(), 1, point, &param, nullptr, nullptr, &one, points,
                                     nullptr, of_query, &status, 0));
    EXPECT_EQ(status, 0);
    EXPECT_NEAR(of_query[0], -0.8, 0.03);
    EXPECT_NEAR(of_query[1], 0.6, 0.03);
}

// Everything is measured in another unit: points of the same gradients, weights and queries of scaled ones.
TEST(QueryGradients, closest_points_of_shapes_of_any_size) {
    for_each_case(115000000, 100, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2), dim = random.whole(axes + 1, 3);
        const SplineData data = tame_spline(random, axes, dim, 2);
        const std::vector<double> points = random_vector(random, static_cast<size_t>(queries * dim));
        const Feet feet = feet_from(data, points, nullptr);
        const Loss loss(random, feet);
        const Gradients one = closest_adjoint(data, points, feet, loss);
        for (const double unit : {0x1p-664, 0x1p664}) {
            const auto scaled = [&](std::vector<double> x) {
                std::transform(x.begin(), x.end(), x.begin(), [&](double value) { return unit * value; });
                return x;
            };
            SplineData other = data;
            other.points = scaled(data.points);
            Loss same = loss;
            same.cotangents.params = scaled(loss.cotangents.params);
            const Gradients got = closest_adjoint(other, scaled(points), feet, same);
            ASSERT_EQ(got.status, one.status) << where(seed, data) << unit;
            const auto compare = [&](const std::vector<double> &a, const std::vector<double> &b,
                                     double size) {
                for (size_t i = 0; i < a.size(); ++i) {
                    // Equations that are nearly singular make more of roundings.
                    ASSERT_NEAR(a[i] / size, b[i], 1e-9 * (1 + std::sqrt(dot(b, b))))
                        << where(seed, data) << i;
                }
            };
            compare(got.points, one.points, 1);
            compare(got.weights, one.weights, unit);
            compare(got.queries, one.queries, 1);
        }
    });
}

// Nothing moves along an axis of degree 0: steps, and a surface of segments.
TEST(QueryGradients, feet_on_axes_of_degree_0_stay) {
    const SplineData steps{{0}, {2}, {{0, 1, 2}}, 2, {0, 0, 4, 0}, {}, 0};
    const double point[] = {4, 3}, param = 1.5, one = 1, along[] = {5, 7};
    double points[4], of_query[2];
    int32_t status = 0;
    require_ok(nurbs_closest_adjoint(create(steps).get(), 1, point, &param, &one, along, &one, points,
                                     nullptr, of_query, &status, 0));
    EXPECT_EQ(status, NURBS_CLOSEST_BOUNDARY);
    EXPECT_EQ(std::vector<double>(points, points + 4), (std::vector<double>{0, 0, 5, 6}));
    EXPECT_EQ(std::vector<double>(of_query, of_query + 2), (std::vector<double>{0, 1}));

    const SplineData segments{{0, 1}, {2, 2}, {{0, 1, 2}, {0, 0, 1, 1}}, 2, {0, 9, 1, 9, 0, 0, 2, 0}, {}, 0};
    const double above[] = {0.5, 1}, at[] = {1.5, 0.25}, of_params[] = {1, 1};
    double net[8];
    require_ok(nurbs_closest_adjoint(create(segments).get(), 1, above, at, of_params, nullptr, &one, net,
                                     nullptr, of_query, &status, 0));
    EXPECT_EQ(status, NURBS_CLOSEST_BOUNDARY);
    const double expected[] = {0, 0, 0, 0, -0.375, -1, -0.125, 0};
    for (size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR(net[i], expected[i], 1e-15) << i;
    }
    EXPECT_NEAR(of_query[0], 0.5, 1e-15);
    EXPECT_NEAR(of_query[1], 1, 1e-15);
}

struct LengthGradients {
    std::vector<double> points;
    std::vector<double> weights;
    double error = 0;
};

LengthGradients length_adjoint(const SplineData &curve, double tolerance = 1e-10) {
    LengthGradients out{std::vector<double>(curve.points.size()),
                        std::vector<double>(static_cast<size_t>(curve.point_count()))};
    require_ok(nurbs_length_adjoint(create(curve).get(), nullptr, tolerance, 1, out.points.data(), 0, 0,
                                    out.weights.data(), 0, &out.error, 0));
    return out;
}

double length(const SplineData &curve) {
    double value = 0;
    require_ok(nurbs_curve_length(create(curve).get(), nullptr, 1e-13, &value, nullptr));
    return value;
}

TEST(QueryGradients, lengths_change_as_their_gradients_say) {
    for_each_case(112000000, 150, [&](Random &random, uint64_t seed) {
        const SplineData curve = tame_spline(random, 1, random.whole(2, 3), 1);
        const LengthGradients got = length_adjoint(curve);
        EXPECT_LE(got.error, 1e-9);
        const std::vector<double> p = random_vector(random, curve.points.size());
        const double of_points = difference([&](double h) {
            SplineData changed = curve;
            changed.points = moved(curve.points, h, p);
            return length(changed);
        });
        ASSERT_NEAR(dot(got.points, p), of_points, 1e-5) << where(seed, curve);
        if (curve.rational()) {
            const std::vector<double> w = random_vector(random, curve.weights.size());
            const double of_weights = difference([&](double h) {
                SplineData changed = curve;
                changed.weights = moved(curve.weights, h, w);
                return length(changed);
            });
            ASSERT_NEAR(dot(got.weights, w), of_weights, 1e-5) << where(seed, curve);
        }
    });
}

// A control point of weight 0 has a gradient by its weight from where it lies.
TEST(QueryGradients, lengths_change_with_a_weight_of_0) {
    const SplineData arch{
        {4}, {5}, {{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}}, 2, {0, 0, 0, 1, 0.25, 7, 2, 1, 3, 0}, {1, 1, 0, 1, 1}, 0};
    const LengthGradients got = length_adjoint(arch);
    const auto grown = [&](double w) {
        SplineData curve = arch;
        curve.weights[2] = w;
        return length(curve);
    };
    EXPECT_GT(got.weights[2], 0.5);
    // By three values, since no weight is negative: errors h^2, and roundings over h.
    const double h = 1e-5, expected = (4 * grown(h) - 3 * grown(0) - grown(2 * h)) / (2 * h);
    EXPECT_NEAR(got.weights[2], expected, 1e-7);
}

// Moved and turned curves have the same length, scaled ones one in proportion; all weights times a number
// change nothing.
void check_length_laws(const SplineData &curve, double tolerance, const std::string &message) {
    const LengthGradients got = length_adjoint(curve, tolerance);
    const auto dim = static_cast<size_t>(curve.dim);
    const double size = length(curve), bound = 64 * std::max(tolerance, 1e-14) * (1 + size);
    for (size_t c = 0; c < dim; ++c) {
        double sum = 0;
        for (size_t i = c; i < got.points.size(); i += dim) {
            sum += got.points[i];
        }
        ASSERT_NEAR(sum, 0, bound) << message;
    }
    double turned = 0;
    for (size_t i = 0; i < got.points.size(); i += dim) {
        turned += curve.points[i] * got.points[i + 1] - curve.points[i + 1] * got.points[i];
    }
    ASSERT_NEAR(turned, 0, bound) << message;
    ASSERT_NEAR(dot(curve.points, got.points), size, bound) << message;
    if (curve.rational()) {
        ASSERT_NEAR(dot(curve.weights, got.weights), 0, bound) << message;
    }
}

TEST(QueryGradients, lengths_of_moved_scaled_and_turned_curves) {
    for_each_case(113000000, 200, [](Random &random, uint64_t seed) {
        const SplineData curve = tame_spline(random, 1, random.whole(2, 3), 1);
        check_length_laws(curve, 1e-11, where(seed, curve));
    });
}

// A tangent that turns within some e^2 of the domain lies between the nodes of every rule, and is not missed.
TEST(QueryGradients, lengths_of_curves_that_nearly_have_a_cusp) {
    for (const double e : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        const SplineData curve{{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 2, {0, 0, 1, 1, 0, 1 + e, 1, 0}, {}, 0};
        const LengthGradients best = length_adjoint(curve, 0);
        ASSERT_LE(best.error, 1e-11) << e;
        for (const double tolerance : {1e-3, 1e-4, 1e-8}) {
            const LengthGradients got = length_adjoint(curve, tolerance);
            ASSERT_LE(got.error, tolerance) << e;
            for (size_t i = 0; i < got.points.size(); ++i) {
                ASSERT_NEAR(got.points[i], best.points[i], got.error + best.error) << e << ' ' << tolerance;
            }
        }
    }
}

TEST(QueryGradients, lengths_of_curves_of_any_size) {
    for (const double e : {0.25, 1e-5}) {
        const SplineData curve{{3},          {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 2, {0, 0, 1, 1, 0, 1 + e, 1, 0},
                               {1, 2, 3, 1}, 0};
        const LengthGradients one = length_adjoint(curve, 1e-4);
        for (const double unit : {0x1p-664, 0x1p664}) {
            SplineData other = curve;
            for (double &x : other.points) {
                x *= unit;
            }
            const LengthGradients got = length_adjoint(other, 1e-4);
            for (size_t i = 0; i < got.points.size(); ++i) {
                ASSERT_NEAR(got.points[i], one.points[i], 1e-13) << e << ' ' << unit;
            }
            for (size_t i = 0; i < got.weights.size(); ++i) {
                ASSERT_NEAR(got.weights[i] / unit, one.weights[i], 1e-13) << e << ' ' << unit;
            }
        }
    }
}

// The tangent of a curve with a cusp jumps.
TEST(QueryGradients, lengths_of_curves_with_a_cusp) {
    const SplineData cusp{{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 2, {0, 0, 1, 1, 0, 1, 1, 0}, {}, 0};
    check_length_laws(cusp, 1e-9, "cusp");
}

} // namespace

} // namespace query_gradients_test
