#include "bench/queries/question.h"

#include "support/handle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace bench {

namespace {

using support::SplineData;

class Generator {
public:
    explicit Generator(uint64_t seed) : engine_(seed) {}

    double uniform(double lower, double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(engine_);
    }
    // Clamped and cubic over [0, 1], spans that differ by a factor of at most 4.
    std::vector<double> knots(int64_t count) {
        std::vector<double> inner = {0};
        for (int64_t i = 3; i < count; ++i) {
            inner.push_back(inner.back() + uniform(0.5, 2));
        }
        std::vector<double> all(3, 0.0);
        std::ranges::transform(inner, std::back_inserter(all), [&](double t) { return t / inner.back(); });
        all.insert(all.end(), 3, 1.0);
        return all;
    }
    std::vector<double> weights(int64_t count) {
        std::vector<double> values(static_cast<size_t>(count));
        std::ranges::generate(values, [this] { return uniform(0.5, 2); });
        return values;
    }
    // Control points anywhere in a cube.
    SplineData tangle(int64_t count) {
        SplineData data{.degrees = {3},
                        .counts = {count},
                        .knots = {knots(count)},
                        .dim = 3,
                        .points = cube(count),
                        .weights = weights(count)};
        return data;
    }
    std::vector<double> cube(int64_t count) {
        std::vector<double> values(3 * static_cast<size_t>(count));
        std::ranges::generate(values, [this] { return uniform(-1, 1); });
        return values;
    }
    // A rough sheet over the unit square.
    SplineData sheet(int64_t count) {
        SplineData data{.degrees = {3, 3},
                        .counts = {count, count},
                        .knots = {knots(count), knots(count)},
                        .dim = 3,
                        .points = {},
                        .weights = weights(count * count)};
        const double step = 1 / static_cast<double>(count - 1);
        for (int64_t i = 0; i < count * count; ++i) {
            const double u = static_cast<double>(i / count) * step, v = static_cast<double>(i % count) * step;
            const double noise = 0.2 * step;
            data.points.insert(data.points.end(),
                               {u + uniform(-noise, noise), v + uniform(-noise, noise), uniform(-0.1, 0.1)});
        }
        return data;
    }
    // Points that are 0.001 to 1 away from points of a surface, in any direction.
    std::vector<double> around(const SplineData &surface, int64_t count) {
        std::vector<double> params(2 * static_cast<size_t>(count));
        std::ranges::generate(params, [this] { return uniform(0, 1); });
        std::vector<double> points = support::eval(support::create(surface).get(), params);
        for (size_t i = 0; i < points.size(); i += 3) {
            const std::array<double, 3> v = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double far = std::pow(10, uniform(-3, 0)) / std::hypot(v[0], v[1], v[2]);
            for (size_t c = 0; c < 3; ++c) {
                points[i + c] += far * v[c];
            }
        }
        return points;
    }

private:
    std::mt19937_64 engine_;
};

std::vector<Question> make_questions() {
    Generator random(20261122);
    const SplineData curve = random.tangle(100), surface = random.sheet(20);
    return {{"closest_curve", "nearest point of a tangled curve of 100 points", Kind::closest, curve,
             random.cube(1000)},
            {"closest_surface", "nearest point of a surface of 20 x 20 points", Kind::closest, surface,
             random.around(surface, 200)},
            {"length", "length of a curve of 100 points to 1e-12", Kind::length, curve, {}, 1e-12}};
}

} // namespace

const std::vector<Question> &questions() {
    static const std::vector<Question> list = make_questions();
    return list;
}

} // namespace bench
