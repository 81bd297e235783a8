// Quadrics and the torus: every point against the implicit equation.
#include "reference/magnitudes.h"
#include "support/frames.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <string>

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
        return {random.whole(-24, 24) * pi / 12, (random.chance(50) ? 1 : -1) * random.whole(1, 24) * pi / 12};
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
    require_ok(
        nurbs_surface_cylinder(place.c(), place.z(), place.u(), r, h, a.start, a.sweep, form, &g));
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
    require_ok(
        nurbs_surface_saddle(place.c(), place.z(), place.u(), a, b, static_cast<double>(h), &g));
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

TEST(Quadrics, points_satisfy_the_implicit_equations) {
    static const std::map<std::string, Maker> makers = {
        {"sphere", sphere}, {"cylinder", cylinder},     {"cone", cone},     {"torus", torus},
        {"ellipsoid", ellipsoid}, {"paraboloid", paraboloid}, {"saddle", saddle}, {"hyperboloid", hyperboloid}};
    Worst worst;
    Random random(711000);
    for (const auto &[name, maker] : makers) {
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

} // namespace
