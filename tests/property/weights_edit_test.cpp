// Weights and control points changed so that a point goes where it is wanted: against the formulas and the
// exact points of what comes out.
#include "property/influences.h"

namespace weights_edit_test {

using namespace support;

namespace {

Recipe edit_recipe(Random &random) {
    const int axes = random.chance(60) ? 1 : random.whole(2, 3);
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : axes == 2 ? 4 : 2);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = random.whole(1, 4); // on periodic axes a control point may be active more than once
    }
    return recipe;
}

// A spline, a parameter, and some of the control points that act there, with what they contribute.
struct Scene {
    SplineData data;
    Handle g;
    std::vector<double> param;
    std::map<int64_t, Influence> all;
    std::vector<int64_t> chosen;
    Rational weight = 0; // of those chosen
    Rational rest = 0;
    Point centre;
    Point offset; // sum over the others of N w (P - centre)

    Scene(Random &random, size_t most)
        : data(random_spline(random, edit_recipe(random))), g(create(data)),
          param(away_from_underflow(random_params(random, data, 1))), all(exact_influences(data, param)) {
        for (const auto &[point, influence] : all) {
            const bool first = chosen.empty() && &influence == &all.rbegin()->second;
            if (influence.weight != 0 && chosen.size() < most && (first || random.chance(50))) {
                chosen.push_back(point);
            }
        }
        if (!chosen.empty()) {
            split();
        }
    }
    [[nodiscard]] bool is_chosen(int64_t point) const {
        return std::find(chosen.begin(), chosen.end(), point) != chosen.end();
    }
    void split() {
        centre.assign(static_cast<size_t>(data.dim), Rational(0));
        offset = centre;
        for (const auto &[point, influence] : all) {
            (is_chosen(point) ? weight : rest) += influence.weight;
            for (size_t c = 0; c < centre.size() && is_chosen(point); ++c) {
                centre[c] += influence.weight * place_of(data, point)[c];
            }
        }
        for (Rational &x : centre) {
            x /= weight;
        }
        for (const auto &[point, influence] : all) {
            for (size_t c = 0; c < centre.size() && !is_chosen(point); ++c) {
                offset[c] += influence.weight * (place_of(data, point)[c] - centre[c]);
            }
        }
    }
    // The exact point at other weights: sum N_i w_i of those chosen.
    [[nodiscard]] Point at(const Rational &other) const {
        Point point = centre;
        for (size_t c = 0; c < point.size(); ++c) {
            point[c] += offset[c] / (other + rest);
        }
        return point;
    }
    // Whether other weights move the point, and not by less than can be told.
    [[nodiscard]] bool movable() const {
        return !chosen.empty() && rest != 0 && reach() > 0 &&
               as_long_double(Rational(weight / rest)) > 1e-200L;
    }
    [[nodiscard]] Point now() const { return at(weight); }
    [[nodiscard]] long double reach() const { return length(minus(now(), centre)); }
    [[nodiscard]] std::string place(uint64_t seed) const { return where(seed, data) + " at " + hex(param); }
};

// Everything between the place at weight 0 and the centre, and close to both.
double any_distance(Random &random, const Scene &scene) {
    const long double reach = scene.reach(), part = as_long_double(Rational(scene.weight / scene.rest));
    const long double near =
        random.chance(30) ? std::ldexp(1.0L, -random.whole(1, 20)) : 1 - random.unit() * 0.9L;
    return static_cast<double>(random.chance(50) ? reach * (1 - near) : -reach * part * (1 - near));
}

// How far the exact point of the result is from where it should be, towards the centre by a distance.
long double missed(const Scene &scene, const nurbs *moved, double distance) {
    const Point now = scene.now(), got = point_at(read_back(moved), scene.param);
    const long double part = distance / scene.reach();
    long double sum = 0;
    for (size_t c = 0; c < now.size(); ++c) {
        const long double step = as_long_double(Rational(got[c] - now[c])),
                          wanted = part * as_long_double(Rational(scene.centre[c] - now[c]));
        sum += (step - wanted) * (step - wanted);
    }
    return std::sqrt(sum);
}

// w* = w (1 + d / (R (|P S| - d))).
long double formula(const Scene &scene, double distance) {
    const long double influence = as_long_double(Rational(scene.weight / (scene.weight + scene.rest)));
    return 1 + distance / (influence * (scene.reach() - distance));
}

TEST(PullWeight, moves_the_point_by_the_distance) {
    WorstErrors worst("points moved by weights, by degree; unit eps * spread");
    int cases = 0, at_rest = 0;
    for_each_case(1210000, 900, [&](Random &random, uint64_t seed) {
        const Scene scene(random, random.chance(60) ? 1 : 3);
        ++cases;
        if (!scene.movable()) {
            ++at_rest;
            return;
        }
        const double distance = any_distance(random, scene);
        double value = 0;
        nurbs *out = nullptr;
        const bool one = scene.chosen.size() == 1;
        require_ok(one ? nurbs_pull_weight(scene.g.get(), scene.chosen[0], scene.param.data(), distance,
                                           &value, &out)
                       : nurbs_pull_weights(scene.g.get(), static_cast<int64_t>(scene.chosen.size()),
                                            scene.chosen.data(), scene.param.data(), distance, &value, &out));
        const Handle moved(out);
        const SplineData got = read_back(moved.get());
        for (int64_t i = 0; i < scene.data.point_count(); ++i) {
            const bool changed = scene.is_chosen(original_of(scene.data, i));
            const double old = scene.data.weight(i);
            ASSERT_EQ(got.weight(i), !changed ? old : one ? value : old * value) << scene.place(seed);
        }
        ASSERT_EQ(got.points, scene.data.points);
        const long double unit = eps * spread(scene.data, scene.all, scene.centre);
        const long double bound = sum_roundings(scene.data), error = missed(scene, moved.get(), distance);
        worst.add(scene.data.degrees[0], error / unit / bound, error / unit);
        ASSERT_LE(error, bound * unit) << scene.place(seed) << " distance " << hex(distance);
        const long double factor = formula(scene, distance),
                          given = one ? value / scene.data.weight(scene.chosen[0]) : value;
        if (scene.reach() > 1e-3L * spread(scene.data, scene.all, scene.centre) &&
            std::fabs(distance) < 0.9 * scene.reach() && factor > 0.1L) {
            ASSERT_NEAR(static_cast<double>(given / factor), 1, 1e-9) << scene.place(seed);
        }
    });
    ASSERT_LE(at_rest, cases / 2);
}

TEST(PullWeight, refuses_what_no_weight_can_do) {
    for_each_case(1220000, 300, [&](Random &random, uint64_t seed) {
        const Scene scene(random, 1);
        if (!scene.movable()) {
            return;
        }
        const auto up = static_cast<double>(scene.reach()),
                   part = static_cast<double>(as_long_double(Rational(scene.weight / scene.rest)));
        const auto status_at = [&](double distance) {
            nurbs *out = nullptr;
            const nurbs_status status = nurbs_pull_weight(scene.g.get(), scene.chosen[0], scene.param.data(),
                                                          distance, nullptr, &out);
            nurbs_destroy(out);
            return status;
        };
        const double room = static_cast<double>(spread(scene.data, scene.all, scene.centre)) / up;
        if (room < 1e9 && part > 1e-9) {
            ASSERT_EQ(status_at(up * 1.001), NURBS_ERROR_LENGTH) << scene.place(seed);
            ASSERT_EQ(status_at(-up * part * 1.001), NURBS_ERROR_WEIGHT_SIGN) << scene.place(seed);
        }
        for (int64_t i = 0; i < scene.data.point_count(); ++i) {
            const auto found = scene.all.find(original_of(scene.data, i));
            if (found == scene.all.end()) {
                nurbs *out = nullptr;
                ASSERT_EQ(nurbs_pull_weight(scene.g.get(), i, scene.param.data(), 0, nullptr, &out),
                          NURBS_ERROR_INFLUENCE)
                    << scene.place(seed);
                break;
            }
        }
    });
}

// At weight 0 the point is that of the others, and at infinity the control point.
TEST(Weights, limits_are_those_of_theory) {
    WorstErrors worst("points at weights 0, 1 and the present one, by degree; unit eps * spread");
    for_each_case(1230000, 600, [&](Random &random, uint64_t seed) {
        const Scene scene(random, 1);
        if (scene.chosen.empty()) {
            return;
        }
        const auto dim = static_cast<size_t>(scene.data.dim);
        const int64_t point = scene.chosen[0];
        std::vector<double> zero(dim), one(dim), present(dim);
        require_ok(nurbs_weight_points(scene.g.get(), point, scene.param.data(), zero.data(), one.data(),
                                       present.data()));
        const Rational function = scene.all.at(point).function;
        const long double largest = std::max<long double>(extent(scene.data), 0),
                          unit = eps * (spread(scene.data, scene.all, scene.centre) + largest);
        const auto check = [&](const std::vector<double> &got, const Rational &weight) {
            const Point want = scene.at(weight);
            for (size_t c = 0; c < dim; ++c) {
                const long double error = std::fabs(as_long_double(Rational(exact(got[c]) - want[c])));
                worst.add(scene.data.degrees[0], unit == 0 ? 0 : error / unit / sum_roundings(scene.data), 0);
                ASSERT_LE(error, sum_roundings(scene.data) * unit) << scene.place(seed);
            }
        };
        check(one, function);
        check(present, scene.weight);
        if (scene.rest == 0) {
            ASSERT_TRUE(std::isnan(zero[0]));
            return;
        }
        check(zero, 0);
        const double weights[] = {0, 0x1p500};
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_set_weights(scene.g.get(), 1, &point, weights, &out);
        const Handle dropped(out);
        if (status != NURBS_ERROR_WEIGHTS_VANISH) { // at another parameter, where no other weight acts
            require_ok(status);
            ASSERT_EQ(point_at(read_back(dropped.get()), scene.param), scene.at(0)) << scene.place(seed);
        }
        require_ok(nurbs_set_weights(scene.g.get(), 1, &point, weights + 1, &out));
        const Handle pulled(out);
        const Point near = minus(point_at(read_back(pulled.get()), scene.param), scene.centre);
        const long double share = as_long_double(function) * std::ldexp(1.0L, 500);
        ASSERT_LE(length(near) * share, length(scene.offset) * 1.001L) << scene.place(seed);
    });
}

TEST(WeightThrough, brings_the_point_to_the_target) {
    WorstErrors worst("targets missed, by degree; unit eps * spread");
    for_each_case(1240000, 600, [&](Random &random, uint64_t seed) {
        const Scene scene(random, 1);
        if (!scene.movable()) {
            return;
        }
        const Rational factor = exact(random.magnitude(0.01, 100));
        const Point wanted = scene.at(scene.weight * factor);
        std::vector<double> target, place;
        for (size_t c = 0; c < wanted.size(); ++c) {
            target.push_back(static_cast<double>(as_long_double(wanted[c])));
        }
        double weight = 0;
        nurbs *out = nullptr;
        const long double size = extent(scene.data);
        const double tolerance = static_cast<double>(4 * eps * size * sum_roundings(scene.data));
        if (std::min(length(minus(wanted, scene.centre)), length(minus(wanted, scene.at(0)))) <
            1e-6L * size) {
            return; // rounding of the target hides on which side of an end it lies
        }
        require_ok(nurbs_weight_through(scene.g.get(), scene.chosen[0], scene.param.data(), target.data(),
                                        tolerance, &weight, &out));
        const Handle made(out);
        const Point got = point_at(read_back(made.get()), scene.param);
        const long double error = length(minus(got, wanted)), unit = eps * size;
        worst.add(scene.data.degrees[0], error / unit / sum_roundings(scene.data), error / unit);
        ASSERT_LE(error, 2 * sum_roundings(scene.data) * unit) << scene.place(seed);
    });
}

TEST(CrossRatio, reads_the_weight) {
    for_each_case(1250000, 600, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(1, 4);
        const double w = random.magnitude(0.01, 100), basis = random.between(0.01, 0.99);
        std::vector<double> p, m, n, q;
        for (int c = 0; c < dim; ++c) {
            p.push_back(random.between(-1, 1));
            m.push_back(random.between(2, 3));
            n.push_back((basis * p.back() + (1 - basis) * m.back()));
            q.push_back((w * basis * p.back() + (1 - basis) * m.back()) / (w * basis + 1 - basis));
        }
        double got = 0;
        require_ok(nurbs_weight_cross_ratio(dim, p.data(), m.data(), n.data(), q.data(), &got));
        // Each point is rounded, and the shortest of the four distances is at least 1e-4 of the points.
        ASSERT_NEAR(got / w, 1, 32 * 0x1p-52 * 1e4) << seed;
    });
}

TEST(PullPoint, moves_the_point_by_the_distance) {
    WorstErrors worst("points moved by control points, by degree; unit eps * (distance + R |P|)");
    for_each_case(1260000, 900, [&](Random &random, uint64_t seed) {
        const Scene scene(random, 1);
        if (scene.chosen.empty()) {
            return;
        }
        const auto dim = static_cast<size_t>(scene.data.dim);
        std::vector<double> direction;
        for (size_t c = 0; c < dim; ++c) {
            direction.push_back(random.between(-1, 1) * 1e3);
        }
        direction[0] += direction[0] == 0 ? 1 : 0;
        const double distance = random.between(-1, 1) * random.magnitude(1e-3, 1e3);
        double moved = 0;
        if (scene.weight < total_weight(scene.all) / 1000000) {
            return; // the control point would move out of sight
        }
        nurbs *out = nullptr;
        require_ok(nurbs_pull_point(scene.g.get(), scene.chosen[0], scene.param.data(), direction.data(),
                                    distance, &moved, &out));
        const Handle made(out);
        const SplineData after = read_back(made.get());
        const long double influence = as_long_double(Rational(scene.weight / (scene.weight + scene.rest)));
        ASSERT_LE(std::fabs(moved * influence - distance),
                  sum_roundings(scene.data) * eps * std::fabs(distance))
            << scene.place(seed);
        ASSERT_EQ(after.weights, scene.data.weights);
        const Point step = minus(point_at(after, scene.param), scene.now());
        Point along;
        for (const double x : direction) {
            along.push_back(exact(x));
        }
        const long double unit = eps * (std::fabs(distance) + influence * extent(after)),
                          scale = distance / length(along);
        for (size_t c = 0; c < dim; ++c) {
            const long double error = std::fabs(as_long_double(step[c]) - scale * direction[c]);
            worst.add(scene.data.degrees[0], error / unit / sum_roundings(scene.data), error / unit);
            ASSERT_LE(error, sum_roundings(scene.data) * unit) << scene.place(seed);
        }
    });
}

TEST(MostInfluential, has_the_largest_basis_function) {
    for_each_case(1270000, 600, [&](Random &random, uint64_t seed) {
        const Scene scene(random, 1);
        int64_t index = -1;
        double influence = 0;
        require_ok(nurbs_most_influential(scene.g.get(), 1, scene.param.data(), 0, 0, &index, &influence));
        ASSERT_EQ(index, original_of(scene.data, index)) << scene.place(seed);
        const Rational total = total_weight(scene.all), found = scene.all.at(index).weight / total;
        const long double bound = 2 * sum_roundings(scene.data) * eps;
        ASSERT_LE(std::fabs(influence - as_long_double(found)), bound * as_long_double(found))
            << scene.place(seed);
        for (const auto &[point, other] : scene.all) {
            ASSERT_LE(as_long_double(Rational(other.weight / total)), as_long_double(found) * (1 + bound))
                << scene.place(seed) << point;
        }
    });
}

} // namespace

} // namespace weights_edit_test
