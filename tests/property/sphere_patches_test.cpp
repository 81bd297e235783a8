// The sphere without poles: its net against the algebra that it comes from, its points, edges and normals.
#include "reference/float50.h"
#include "reference/magnitudes.h"
#include "support/generators.h"
#include "surface_integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace sphere_patches_test {

using namespace support;
using reference::eps;
using Real = reference::Float50;

namespace {

struct Face {
    std::string name;
    Handle g;
};

std::vector<Face> faces_of(const double *center, const double *axis, const double *x, double radius,
                           uint32_t flags) {
    nurbs_list *list = nullptr;
    require_ok(nurbs_surface_sphere_patches(center, axis, x, radius, flags, &list));
    int64_t count = 0;
    require_ok(nurbs_list_count(list, &count));
    std::vector<Face> faces;
    for (int64_t i = 0; i < count; ++i) {
        nurbs *g = nullptr;
        require_ok(nurbs_list_get(list, i, &g));
        char name[8] = "";
        require_ok(nurbs_list_name(list, i, name, 8, nullptr));
        faces.push_back({name, Handle(g)});
    }
    nurbs_list_destroy(list);
    return faces;
}

// The records of the product of two biquadratic polynomials.
using Quadratic = std::array<std::array<Real, 3>, 3>;
using Quartic = std::array<std::array<Real, 5>, 5>;
Quartic operator*(const Quadratic &f, const Quadratic &g) {
    constexpr int two[] = {1, 2, 1}, four[] = {1, 4, 6, 4, 1};
    Quartic product{};
    for (size_t i = 0; i < 81; ++i) {
        const size_t a = i / 27, b = i / 9 % 3, c = i / 3 % 3, d = i % 3;
        product[a + c][b + d] +=
            f[a][b] * g[c][d] * two[a] * two[b] * two[c] * two[d] / Real(four[a + c] * four[b + d]);
    }
    return product;
}

// The plane patch of sphere_patches.h is mapped to the sphere, in fifty digits.
TEST(SpherePatches, net_is_the_image_of_four_arcs) {
    const Real r = sqrt(Real(3)), c = (r - 1) / 2, w = (sqrt(Real(6)) + sqrt(Real(2))) / 4,
               m = (2 * r - 3) * w;
    const Quadratic one = {{{1, w, 1}, {w, 1, w}, {1, w, 1}}}, x = {{{-c, -m, -c}, {0, 0, 0}, {c, m, c}}},
                    y = {{{-c, 0, c}, {-m, 0, m}, {-c, 0, c}}};
    const Quartic ww = one * one, xx = x * x, yy = y * y, xw = x * one, yw = y * one;
    const auto faces = faces_of(nullptr, nullptr, nullptr, 1, 0);
    const auto got = read_back(faces[4].g.get());
    ASSERT_EQ(got.counts, (std::vector<int64_t>{5, 5}));
    for (int64_t k = 0; k < 25; ++k) {
        const auto i = static_cast<size_t>(k / 5), j = static_cast<size_t>(k % 5);
        const Real weight = ww[i][j] + xx[i][j] + yy[i][j];
        const Real want[] = {2 * xw[i][j] / weight, 2 * yw[i][j] / weight,
                             (ww[i][j] - xx[i][j] - yy[i][j]) / weight};
        for (int a = 0; a < 3; ++a) {
            EXPECT_LE(abs(want[a] - got.coordinate(k, a)), Real(0x1p-53) * abs(want[a]) + Real(1e-45)) << k;
        }
        EXPECT_LE(abs(weight - got.weight(k)), Real(0x1p-53) * weight) << k;
    }
}

struct RandomPlace {
    double center[3];
    double axis[3];
    double x[3];
};
RandomPlace random_place(Random &random, double size) {
    RandomPlace place;
    for (int c = 0; c < 3; ++c) {
        place.center[c] = size * random.between(-1, 1);
        place.axis[c] = random.between(-1, 1);
        place.x[c] = random.between(-1, 1);
    }
    return place;
}

TEST(SpherePatches, points_lie_on_the_sphere) {
    long double worst = 0;
    for (uint64_t seed = 731000; seed < 731100; ++seed) {
        Random random(seed);
        const double radius = random.magnitude(1e-6, 1e6);
        const RandomPlace place = random_place(random, radius * random.magnitude(1e-3, 10));
        const Vector center = {place.center[0], place.center[1], place.center[2]};
        for (const auto &face :
             faces_of(place.center, place.axis, place.x, radius, random.chance(50) ? NURBS_HEMISPHERE : 0)) {
            double size = 0;
            for (const double x : read_back(face.g.get()).points) {
                size = std::max(size, std::fabs(x));
            }
            std::vector<double> params(1000);
            std::generate(params.begin(), params.end(), [&] { return random.unit(); });
            const auto points = eval(face.g.get(), params);
            for (size_t i = 0; i < 500; ++i) {
                const long double away = std::fabs(norm(minus(vector_at(points, i), center)) - radius);
                worst = std::max(worst, away / (eps * size));
                ASSERT_LE(away, 4 * eps * size) << face.name << ", seed " << seed;
            }
        }
    }
    std::printf("at most %.3Lf eps size\n", worst);
}

// Points and weights of an edge, in the direction in which they come first.
std::vector<double> edge_of(const SplineData &data, int axis, bool end) {
    std::vector<std::array<double, 4>> edge;
    for (int64_t i = 0; i < 5; ++i) {
        const int64_t at = end ? 4 : 0, record = axis == 0 ? at * 5 + i : i * 5 + at;
        edge.push_back({data.coordinate(record, 0), data.coordinate(record, 1), data.coordinate(record, 2),
                        data.weight(record)});
    }
    std::vector<double> forward, backward;
    for (const auto &point : edge) {
        forward.insert(forward.end(), point.begin(), point.end());
    }
    std::reverse(edge.begin(), edge.end());
    for (const auto &point : edge) {
        backward.insert(backward.end(), point.begin(), point.end());
    }
    return std::min(forward, backward);
}

std::map<std::vector<double>, int> edges_of(const std::vector<Face> &faces) {
    std::map<std::vector<double>, int> edges;
    for (const auto &face : faces) {
        const auto data = read_back(face.g.get());
        for (int k = 0; k < 4; ++k) {
            ++edges[edge_of(data, k / 2, k % 2 == 1)];
        }
    }
    return edges;
}

// Every edge belongs to two faces, bit for bit; of a hemisphere's, four to one: those of the equator.
TEST(SpherePatches, neighbours_share_their_edges) {
    for (uint64_t seed = 732000; seed < 732050; ++seed) {
        Random random(seed);
        const RandomPlace place = random_place(random, 2);
        const auto whole = edges_of(faces_of(place.center, place.axis, place.x, 1.3, 0));
        EXPECT_EQ(whole.size(), 12U);
        for (const auto &[edge, times] : whole) {
            EXPECT_EQ(times, 2);
        }
        const auto half = edges_of(faces_of(place.center, place.axis, place.x, 1.3, NURBS_HEMISPHERE));
        EXPECT_EQ(half.size(), 12U);
        EXPECT_EQ(std::count_if(half.begin(), half.end(), [](const auto &edge) { return edge.second == 1; }),
                  4);
    }
}

// Edges lie in the planes |x| = |y|, |y| = |z| or |z| = |x| through the centre, the hemisphere's others in z
// = 0.
TEST(SpherePatches, edges_are_great_circles) {
    for (const uint32_t flags : {0U, NURBS_HEMISPHERE}) {
        for (const auto &[edge, times] : edges_of(faces_of(nullptr, nullptr, nullptr, 1, flags))) {
            bool planes[] = {true, true, true, true};
            for (size_t i = 0; i < edge.size(); i += 4) {
                for (size_t c = 0; c < 3; ++c) {
                    planes[c] = planes[c] && std::fabs(edge[i + c]) == std::fabs(edge[i + (c + 1) % 3]);
                }
                planes[3] = planes[3] && edge[i + 2] == 0;
            }
            EXPECT_TRUE(times == 2 ? planes[0] || planes[1] || planes[2] : planes[3]);
        }
    }
}

TEST(SpherePatches, have_no_singular_point_and_look_outwards) {
    const auto faces = faces_of(nullptr, nullptr, nullptr, 1, 0);
    std::vector<double> steps;
    for (int i = 0; i <= 32; ++i) {
        steps.push_back(i / 32.0);
    }
    const std::map<std::string, Vector> names = {{"+X", {1, 0, 0}},  {"+Y", {0, 1, 0}}, {"-X", {-1, 0, 0}},
                                                 {"-Y", {0, -1, 0}}, {"+Z", {0, 0, 1}}, {"-Z", {0, 0, -1}}};
    ASSERT_EQ(faces.size(), 6U);
    for (const auto &face : faces) {
        const auto values = eval_grid_derivs(face.g.get(), 1, {steps, steps});
        for (size_t i = 0; i < values.size() / 9; ++i) {
            const Vector normal = cross(vector_at(values, i, 9, 3), vector_at(values, i, 9, 6));
            EXPECT_GE(dot(normal, vector_at(values, i, 9)), 1.1L);
            EXPECT_LE(norm(normal), 2.8L);
        }
        const auto middle = eval(face.g.get(), {0.5, 0.5});
        EXPECT_NEAR(static_cast<double>(dot(vector_at(middle, 0), names.at(face.name))), 1, 4e-16);
    }
}

TEST(SpherePatches, areas_add_up) {
    const double center[] = {1, 2, 3}, axis[] = {1, -1, 2};
    for (const uint32_t flags : {0U, NURBS_HEMISPHERE}) {
        long double sum = 0, volume = 0;
        for (const auto &face : faces_of(center, axis, nullptr, 2, flags)) {
            sum += area(face.g.get(), 4);
            volume += volume_below(face.g.get(), {1, 2, 3}, 4);
        }
        const long double whole = (flags == 0 ? 16 : 8) * std::numbers::pi_v<long double>;
        EXPECT_LE(std::fabs(sum / whole - 1), 1e-14L);
        EXPECT_LE(std::fabs(volume / (whole * 2 / 3) - 1), 1e-14L);
    }
}

} // namespace

} // namespace sphere_patches_test
