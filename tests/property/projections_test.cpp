// Reflections and projections against exact rational arithmetic on the homogeneous control points.
#include "property/same_shape.h"

namespace projections_test {

using namespace support;

namespace {

using reference::exact;
using reference::Rational;

std::vector<double> random_vector(Random &random, int dim) {
    std::vector<double> x;
    for (int c = 0; c < dim; ++c) {
        x.push_back(random.chance(20) ? 0 : random.between(-2, 2));
    }
    x[static_cast<size_t>(random.whole(0, dim - 1))] = random.chance(50) ? 1 : -1.5;
    return x;
}

Rational dot(const std::vector<double> &a, const std::vector<Rational> &b) {
    Rational sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum += exact(a[c]) * b[c];
    }
    return sum;
}

long double size_of(const std::vector<double> &x) {
    long double largest = 0;
    for (const double c : x) {
        largest = std::max<long double>(largest, std::fabs(c));
    }
    return largest;
}

// x - factor d (n . (x - p)) / (n . d), exactly.
std::vector<Rational> sheared(const std::vector<double> &x, const std::vector<double> &p,
                              const std::vector<double> &n, const std::vector<double> &d, int factor) {
    std::vector<Rational> from_plane, direction;
    for (size_t c = 0; c < x.size(); ++c) {
        from_plane.push_back(exact(x[c]) - exact(p[c]));
        direction.push_back(exact(d[c]));
    }
    const Rational step = factor * dot(n, from_plane) / dot(n, direction);
    std::vector<Rational> image;
    for (size_t c = 0; c < x.size(); ++c) {
        image.push_back(exact(x[c]) - step * direction[c]);
    }
    return image;
}

TEST(Projections, control_points_are_exact_to_rounding) {
    for_each_case(330000, 600, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 3);
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const auto p = random_vector(random, data.dim), n = random_vector(random, data.dim);
        auto d = random_vector(random, data.dim);
        const int kind = random.whole(0, 2);
        if (kind < 2) {
            d = n;
        }
        std::vector<Rational> exact_d;
        for (const double x : d) {
            exact_d.push_back(exact(x));
        }
        const Rational along = dot(n, exact_d);
        const long double slope = std::fabs(along.convert_to<double>());
        if (slope < 1e-3L) {
            return;
        }
        nurbs *out = nullptr;
        const nurbs_status status = kind == 0 ? nurbs_mirror(g.get(), p.data(), n.data(), &out)
                                              : nurbs_project_to_plane(g.get(), p.data(), n.data(),
                                                                       kind == 1 ? nullptr : d.data(), &out);
        ASSERT_EQ(status, NURBS_OK) << where(seed, data) << last_error();
        const SplineData image = read_back(Handle(out).get());
        ASSERT_TRUE(same_bits(image.weights, data.weights)) << where(seed, data);
        const auto dim = static_cast<size_t>(data.dim);
        for (size_t i = 0; i < data.points.size(); i += dim) {
            const std::vector<double> x(data.points.begin() + static_cast<int64_t>(i),
                                        data.points.begin() + static_cast<int64_t>(i + dim));
            const auto want = sheared(x, p, n, d, kind == 0 ? 2 : 1);
            const long double unit = size_of(n) * size_of(d) / slope * static_cast<long double>(dim);
            const long double bound =
                8 * (dim + 2) * reference::eps * unit * unit * (size_of(x) + size_of(p));
            for (size_t c = 0; c < dim; ++c) {
                ASSERT_LE(reference::distance(image.points[i + c], reference::fraction(want[c])), bound)
                    << where(seed, data);
            }
        }
    });
}

// The image of a point lies in the plane and on the line from the eye.
TEST(Projections, a_perspective_image_lies_on_rays_and_in_the_plane) {
    for_each_case(331000, 400, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 4);
        recipe.dim = 3;
        recipe.short_numbers = false;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.axes[0].placement = Placement::origin;
        SplineData data = random_spline(random, recipe);
        data = scaled(data, 1 / (extent(data) + 1));
        const Handle g = create(data);
        const std::vector<double> eye{random.unit(), random.unit(), -4}, point{0.5, 0.25, 2},
            n{0.125, -0.25, 3};
        nurbs *out = nullptr;
        require_ok(nurbs_project_from(g.get(), eye.data(), point.data(), n.data(), &out));
        const Handle image(out);
        const auto params = random_params(random, data, 5);
        const auto before = eval(g.get(), params), after = eval(out, params);
        for (size_t i = 0; i < before.size(); i += 3) {
            double height = 0, ray[3], seen[3];
            for (size_t c = 0; c < 3; ++c) {
                height += n[c] * (after[i + c] - point[c]);
                ray[c] = before[i + c] - eye[c];
                seen[c] = after[i + c] - eye[c];
            }
            ASSERT_NEAR(height, 0, 1e-13) << where(seed, data);
            for (size_t c = 0; c < 3; ++c) {
                const size_t e = (c + 1) % 3;
                ASSERT_NEAR(ray[c] * seen[e], ray[e] * seen[c], 1e-12) << where(seed, data);
            }
        }
    });
}

} // namespace

} // namespace projections_test
