// Quadrics and the torus: every point against the implicit equation.
#include "reference/magnitudes.h"
#include "support/frames.h"
#include "support/generators.h"
#include "support/handle.h"
#include "surface_integrals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <string>

namespace quadrics_test {

using namespace support;
using reference::eps;

namespace {

constexpr double pi = std::numbers::pi;
constexpr const char *form_names[] = {"quarters", "thirds", "smooth"};

// Where a shape stands; a null pointer in a call stands for an empty vector.
struct Place {
    std::vector<double> center;
    std::vector<double> axis;
    std::vector<double> x;

    static const double *data(const std::vector<double> &v) { return v.empty() ? nullptr : v.data(); }
    [[nodiscard]] const double *c() const { return data(center); }
    [[nodiscard]] const double *z() const { return data(axis); }
    [[nodiscard]] const double *u() const { return data(x); }
};

std::vector<double> random_vector(Random &random, double size) {
    std::vector<double> v(3);
    std::generate(v.begin(), v.end(), [&] { return size * random.between(-1, 1); });
    return v;
}

Place random_place(Random &random, double size) {
    Place place;
    if (random.chance(70)) {
        place.center = random_vector(random, size * random.magnitude(1e-2, 1e3));
    }
    if (random.chance(70)) {
        place.axis = random_vector(random, random.magnitude(1e-6, 1e6));
    }
    if (random.chance(50)) {
        place.x = random_vector(random, random.magnitude(1e-6, 1e6));
    }
    return place;
}

// The frame of the documentation, in long double.
struct Frame {
    Vector center{};
    Vector x{};
    Vector y{};
    Vector z{};

    explicit Frame(const Place &place) {
        if (!place.center.empty()) {
            center = vector_at(place.center, 0);
        }
        z = place.axis.empty() ? Vector{0, 0, 1} : support::unit(vector_at(place.axis, 0));
        Vector along{1, 0, 0};
        if (!place.x.empty()) {
            along = vector_at(place.x, 0);
        } else if (!place.axis.empty()) {
            const auto least = std::min_element(
                z.begin(), z.end(), [](long double a, long double b) { return std::fabs(a) < std::fabs(b); });
            along = {0, 0, 0};
            along[static_cast<size_t>(least - z.begin())] = 1;
        }
        x = support::unit(minus(along, times(dot(along, z), z)));
        y = cross(z, x);
    }
    [[nodiscard]] Vector local(const Vector &point) const {
        const Vector p = minus(point, center);
        return {dot(p, x), dot(p, y), dot(p, z)};
    }
};

// The distance of a point in the frame from the surface.
using Distance = std::function<long double(const Vector &)>;

// |F| / |grad F| of a x^2 + b y^2 + c z^2 + d z + e, which is the distance but for terms of its second order.
Distance quadric(long double a, long double b, long double c, long double d, long double e) {
    return [=](const Vector &p) {
        const auto &[x, y, z] = p;
        const long double value = a * x * x + b * y * y + c * z * z + d * z + e;
        const Vector gradient = {2 * a * x, 2 * b * y, 2 * c * z + d};
        return std::fabs(value) / std::max(norm(gradient), 1e-4000L);
    };
}

struct Shape {
    Handle g;
    Distance distance;
};

class Worst {
public:
    ~Worst() {
        for (const auto &[name, error] : errors_) {
            std::printf("%-28s %8.3Lf eps size\n", name.c_str(), error);
        }
        std::printf("%lld points\n", static_cast<long long>(points_));
    }
    void add(const std::string &name, long double error) {
        long double &worst = errors_[name];
        worst = std::max(worst, error);
        ++points_;
    }
    [[nodiscard]] int64_t points() const { return points_; }

private:
    std::map<std::string, long double> errors_;
    int64_t points_ = 0;
};

double largest_coordinate(const nurbs *g) {
    double size = 0;
    for (const double x : read_back(g).points) {
        size = std::max(size, std::fabs(x));
    }
    return size;
}

// The largest distance of n points, in eps of the largest coordinate of the control points.
void measure(Random &random, const std::string &name, const Shape &shape, const Place &place, int n,
             Worst &worst) {
    const Frame frame(place);
    const double size = largest_coordinate(shape.g.get());
    std::vector<double> params(static_cast<size_t>(2 * n));
    std::generate(params.begin(), params.end(), [&] { return random.unit(); });
    const std::vector<double> points = eval(shape.g.get(), params);
    for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        const long double error = shape.distance(frame.local(vector_at(points, i))) / (eps * size);
        worst.add(name, error);
        ASSERT_LE(error, 4) << name << " at " << params[2 * i] << ", " << params[2 * i + 1];
    }
}

struct Angles {
    double start;
    double sweep;
};
Angles random_angles(Random &random) {
    if (random.chance(40)) {
        return {0, 2 * pi};
    }
    if (random.chance(50)) {
        return {random.whole(-24, 24) * pi / 12,
                (random.chance(50) ? 1 : -1) * random.whole(1, 24) * pi / 12};
    }
    return {random.between(-7, 7), random.between(-1, 1) * 2 * pi};
}

using Maker = Shape (*)(Random &random, const Place &place, double size, int32_t form);

double length(Random &random, double size) {
    return size * (random.chance(70) ? random.between(0.2, 1) : random.magnitude(1e-3, 1));
}

Shape sphere(Random &random, const Place &place, double size, int32_t form) {
    const double r = size;
    nurbs *g = nullptr;
    if (random.chance(50)) {
        require_ok(nurbs_surface_sphere(place.c(), place.z(), place.u(), r, form, &g));
    } else {
        const Angles a = random_angles(random);
        const double south = random.chance(50) ? -pi / 2 : random.between(-pi / 2, 0.5);
        const double north = random.chance(50) ? pi / 2 : south + (pi / 2 - south) * (1 - random.unit());
        require_ok(nurbs_surface_spherical_patch(place.c(), place.z(), place.u(), r, a.start, a.sweep, south,
                                                 north, form, &g));
    }
    return {Handle(g), [r](const Vector &p) { return std::fabs(norm(p) - r); }};
}

Shape cylinder(Random &random, const Place &place, double size, int32_t form) {
    const double r = length(random, size), h = length(random, size);
    const Angles a = random_angles(random);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_cylinder(place.c(), place.z(), place.u(), r, h, a.start, a.sweep, form, &g));
    return {Handle(g), [r](const Vector &p) { return std::fabs(std::hypot(p[0], p[1]) - r); }};
}

Shape cone(Random &random, const Place &place, double size, int32_t form) {
    const double r = random.chance(20) ? 0 : length(random, size), s = r == 0 ? size : random.unit() * r,
                 h = length(random, size);
    const Angles a = random_angles(random);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_cone(place.c(), place.z(), place.u(), r, s, h, a.start, a.sweep, form, &g));
    const long double rise = (static_cast<long double>(s) - r) / h;
    return {Handle(g), [=](const Vector &p) {
                return std::fabs(std::hypot(p[0], p[1]) - r - rise * p[2]) / std::hypot(1.0L, rise);
            }};
}

Shape torus(Random &random, const Place &place, double size, int32_t form) {
    const double big = length(random, size), small = length(random, size);
    const Angles a = random_angles(random), b = random_angles(random);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_torus(place.c(), place.z(), place.u(), big, small, a.start, a.sweep, b.start,
                                   b.sweep, form, &g));
    return {Handle(g), [=](const Vector &p) {
                const long double out = std::hypot(p[0], p[1]);
                return std::min(std::fabs(std::hypot(out - big, p[2]) - small),
                                std::fabs(std::hypot(out + big, p[2]) - small));
            }};
}

Shape ellipsoid(Random &random, const Place &place, double size, int32_t form) {
    const double a = length(random, size), b = length(random, size), c = length(random, size);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_ellipsoid(place.c(), place.z(), place.u(), a, b, c, form, &g));
    const auto square = [](long double x) { return 1 / (x * x); };
    return {Handle(g), quadric(square(a), square(b), square(c), 0, -1)};
}

Shape paraboloid(Random &random, const Place &place, double size, int32_t form) {
    const double a = length(random, size), b = length(random, size);
    const long double h = length(random, size);
    const Angles angles = random_angles(random);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_paraboloid(place.c(), place.z(), place.u(), a, b, static_cast<double>(h),
                                        angles.start, angles.sweep, form, &g));
    return {Handle(g), quadric(h / a / a, h / b / b, 0, -1, 0)};
}

Shape saddle(Random &random, const Place &place, double size, int32_t) {
    const double a = length(random, size), b = length(random, size);
    const long double h = length(random, size);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_saddle(place.c(), place.z(), place.u(), a, b, static_cast<double>(h), &g));
    return {Handle(g), quadric(h / a / a, -h / b / b, 0, -1, 0)};
}

Shape hyperboloid(Random &random, const Place &place, double size, int32_t form) {
    const double a = length(random, size), b = length(random, size), c = length(random, size);
    const bool sheets = random.chance(50);
    double from = random.between(-3, 3) * c, to = from + random.unit() * 3 * c + c * 0x1p-40;
    if (sheets) {
        from = c * (1 + (random.chance(30) ? 0 : random.magnitude(1e-9, 10)));
        to = from + random.magnitude(1e-9, 10) * c;
        if (random.chance(50)) {
            std::tie(from, to) = std::pair(-to, -from);
        }
    }
    const Angles angles = random_angles(random);
    nurbs *g = nullptr;
    require_ok(nurbs_surface_hyperboloid(place.c(), place.z(), place.u(), a, b, c, from, to, angles.start,
                                         angles.sweep, form, sheets ? NURBS_TWO_SHEETS : 0, &g));
    const auto square = [](long double x) { return 1 / (x * x); };
    return {Handle(g), quadric(square(a), square(b), -square(c), 0, sheets ? 1 : -1)};
}

const std::map<std::string, Maker> &makers() {
    static const std::map<std::string, Maker> all = {{"sphere", sphere},       {"cylinder", cylinder},
                                                     {"cone", cone},           {"torus", torus},
                                                     {"ellipsoid", ellipsoid}, {"paraboloid", paraboloid},
                                                     {"saddle", saddle},       {"hyperboloid", hyperboloid}};
    return all;
}

TEST(Quadrics, points_satisfy_the_implicit_equations) {
    Worst worst;
    Random random(711000);
    for (const auto &[name, maker] : makers()) {
        for (int32_t form = NURBS_ARC_QUARTERS; form <= NURBS_ARC_SMOOTH; ++form) {
            for (int i = 0; i < 140; ++i) {
                const double size = random.chance(50) ? 1 : random.magnitude(1e-6, 1e6);
                const Place place = random_place(random, size);
                const Shape shape = maker(random, place, size, form);
                measure(random, name + ", " + form_names[form], shape, place, 300, worst);
            }
        }
    }
    EXPECT_GE(worst.points(), 1000000);
}

// A shape 2^k times as large has the same weights and knots, and its points are 2^k times as large, bit for
// bit.
TEST(Quadrics, are_free_of_scale) {
    for (const auto &[name, of_shape] : makers()) {
        const Maker maker = of_shape;
        for (uint64_t seed = 721000; seed < 721040; ++seed) {
            const auto made = [&](double size) {
                Random random(seed);
                const int32_t form = random.whole(0, 2);
                const Place place = random_place(random, size);
                return read_back(maker(random, place, size, form).g.get());
            };
            const auto one = made(1), large = made(0x1p60), small = made(0x1p-60);
            EXPECT_TRUE(same_bits(one.weights, large.weights) && same_bits(one.weights, small.weights));
            EXPECT_TRUE(same_bits(one.all_knots(), large.all_knots()));
            for (size_t i = 0; i < one.points.size(); ++i) {
                ASSERT_EQ(one.points[i] * 0x1p60, large.points[i]) << name << ", seed " << seed;
                ASSERT_EQ(one.points[i] * 0x1p-60, small.points[i]) << name << ", seed " << seed;
            }
        }
    }
}

// Layers of one axis of a surface, points and weights.
std::vector<double> layer(const SplineData &data, int axis, int64_t at) {
    std::vector<double> values;
    for (int64_t i = 0; i < data.counts[static_cast<size_t>(1 - axis)]; ++i) {
        const int64_t record = axis == 0 ? at * data.counts[1] + i : i * data.counts[1] + at;
        for (int c = 0; c < 3; ++c) {
            values.push_back(data.coordinate(record, c));
        }
        values.push_back(data.weight(record));
    }
    return values;
}

void expect_one_point(const SplineData &data, int64_t at) {
    const auto pole = layer(data, 1, at);
    for (size_t i = 4; i < pole.size(); ++i) {
        EXPECT_TRUE(i % 4 == 3 || same_bits(pole[i], pole[i - 4]));
    }
}

TEST(Quadrics, seams_close_and_poles_are_points) {
    Random random(722000);
    for (int i = 0; i < 60; ++i) {
        const Place place = random_place(random, 1);
        const int32_t form = i % 3;
        nurbs *g = nullptr;
        require_ok(nurbs_surface_ellipsoid(place.c(), place.z(), place.u(), 1, 2, 0.7, form, &g));
        const auto whole = read_back(Handle(g).get());
        EXPECT_TRUE(same_bits(layer(whole, 0, 0), layer(whole, 0, whole.counts[0] - 1)));
        expect_one_point(whole, 0);
        expect_one_point(whole, whole.counts[1] - 1);
        const double turn = 2 * pi, start = random.between(-9, 9), tube = random.between(-9, 9);
        require_ok(
            nurbs_surface_torus(place.c(), place.z(), place.u(), 2, 1, start, turn, tube, -turn, form, &g));
        const auto ring = read_back(Handle(g).get());
        EXPECT_TRUE(same_bits(layer(ring, 0, 0), layer(ring, 0, ring.counts[0] - 1)));
        EXPECT_TRUE(same_bits(layer(ring, 1, 0), layer(ring, 1, ring.counts[1] - 1)));
        require_ok(nurbs_surface_cone(place.c(), place.z(), place.u(), 1, 0, 3, start, turn, form, &g));
        const auto cap = read_back(Handle(g).get());
        EXPECT_TRUE(same_bits(layer(cap, 0, 0), layer(cap, 0, cap.counts[0] - 1)));
        expect_one_point(cap, 1);
        require_ok(nurbs_surface_paraboloid(place.c(), place.z(), place.u(), 1, 2, 3, start, turn, form, &g));
        expect_one_point(read_back(Handle(g).get()), 0);
        require_ok(nurbs_surface_hyperboloid(place.c(), place.z(), place.u(), 1, 2, 3, 3, 30, start, turn,
                                             form, NURBS_TWO_SHEETS, &g));
        expect_one_point(read_back(Handle(g).get()), 0);
    }
}

// Between parallels and meridians at multiples of 15 degrees, at the knots: no rounding but that of the
// coordinates.
TEST(Quadrics, points_at_knots_are_exact) {
    const double center[] = {0.1, -7, 1e3}, r = 0.3;
    nurbs *g = nullptr;
    require_ok(nurbs_surface_sphere(center, nullptr, nullptr, r, NURBS_ARC_QUARTERS, &g));
    const Handle ball(g);
    const auto points = eval(ball.get(), {0, 0.5, 0.25, 0.5, 0.5, 0.5, 0.75, 0.5, 0.25, 0, 0.75, 1});
    EXPECT_EQ(points, (std::vector<double>{0.1 + r, -7, 1e3, 0.1, -7 + r, 1e3, 0.1 - r, -7, 1e3, 0.1, -7 - r,
                                           1e3, 0.1, -7, 1e3 - r, 0.1, -7, 1e3 + r}));
    require_ok(nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 2, pi / 6, pi / 3, 0, pi / 6,
                                             NURBS_ARC_THIRDS, &g));
    const Handle patch(g);
    const double half_root = 0.86602540378443864676; // of 3
    EXPECT_EQ(eval(patch.get(), {0, 0, 1, 0, 1, 1}),
              (std::vector<double>{2 * half_root, 1, 0, 0, 2, 0, 0, 2 * half_root, 1}));
    require_ok(nurbs_surface_hyperboloid(nullptr, nullptr, nullptr, 1, 2, 0.3, -7.7, 0.1, 0, 2 * pi,
                                         NURBS_ARC_QUARTERS, 0, &g));
    const Handle band(g);
    const auto ends = eval(band.get(), {0.25, 0, 0.5, 1});
    EXPECT_EQ(ends[2], -7.7);
    EXPECT_EQ(ends[5], 0.1);
}

// To the rounding of derivatives, which the sums carry on.
void expect_close(long double value, long double expected) {
    EXPECT_LE(std::fabs(value - expected), 1e-13L * std::fabs(expected));
}

TEST(Quadrics, areas_and_volumes) {
    constexpr long double exact_pi = std::numbers::pi_v<long double>;
    const Place place{{0.5, -1, 2}, {1, 2, 3}, {1, 0, 0}};
    const Vector center = vector_at(place.center, 0);
    for (int32_t form = 0; form < 3; ++form) {
        nurbs *g = nullptr;
        require_ok(nurbs_surface_sphere(place.c(), place.z(), place.u(), 2, form, &g));
        const Handle ball(g);
        expect_close(area(ball.get()), 16 * exact_pi);
        expect_close(volume_below(ball.get()), 32 * exact_pi / 3);
        require_ok(nurbs_surface_ellipsoid(place.c(), place.z(), place.u(), 1, 2, 3, form, &g));
        expect_close(volume_below(Handle(g).get()), 8 * exact_pi);
        require_ok(
            nurbs_surface_torus(place.c(), place.z(), place.u(), 3, 1, 1, 2 * pi, 2, 2 * pi, form, &g));
        const Handle ring(g);
        expect_close(area(ring.get()), 12 * exact_pi * exact_pi);
        expect_close(volume_below(ring.get()), 6 * exact_pi * exact_pi);
        require_ok(nurbs_surface_cylinder(place.c(), place.z(), place.u(), 2, 5, 1, 3, form, &g));
        const Handle wall(g);
        expect_close(area(wall.get()), 30);
        expect_close(volume_below(wall.get(), center), 20);
        require_ok(nurbs_surface_cone(place.c(), place.z(), place.u(), 4, 1, 4, 0, 2 * pi, form, &g));
        expect_close(area(Handle(g).get()), 25 * exact_pi);
        // The bowl's volume, 3 pi, less that of the cone from its vertex over its rim.
        require_ok(nurbs_surface_paraboloid(place.c(), place.z(), place.u(), 2, 1, 3, 0, 2 * pi, form, &g));
        expect_close(volume_below(Handle(g).get(), center), exact_pi);
    }
}

// Between two planes, less the cone from the centre over the circle on top.
TEST(Quadrics, hyperboloids_bound_their_volume) {
    constexpr long double exact_pi = std::numbers::pi_v<long double>;
    nurbs *g = nullptr; // with radii 1 and c = 2: pi (h + h^3 / (3 c^2)) below the height h
    require_ok(nurbs_surface_hyperboloid(nullptr, nullptr, nullptr, 1, 1, 2, 0, 30, 0, 2 * pi,
                                         NURBS_ARC_QUARTERS, 0, &g));
    expect_close(volume_below(Handle(g).get()), exact_pi * (30 + 2250 - 226 * 10));
    // pi (h^3 / (3 c^2) - h + 2 c / 3) from the vertex up
    require_ok(nurbs_surface_hyperboloid(nullptr, nullptr, nullptr, 1, 1, 2, 2, 30, 0, 2 * pi,
                                         NURBS_ARC_SMOOTH, NURBS_TWO_SHEETS, &g));
    expect_close(volume_below(Handle(g).get()), exact_pi * (2250 - 30 + 4 / 3.0L - 224 * 10));
}

} // namespace

} // namespace quadrics_test
