// Whatever the constructions make is recognised, however it is written, and no longer when it has been moved.
#include "support/cases.h"
#include "support/handle.h"

#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace recognize_made_test {

using namespace support;

namespace {

constexpr double pi = std::numbers::pi;
using Vec = std::vector<double>;

struct Found {
    int32_t shape = -1;
    std::array<double, 9> placement{};
    std::array<double, 3> sizes{};
    double deviation = -1;
};

Found recognize(const nurbs *g, double tolerance) {
    Found found;
    require_ok(nurbs_recognize(g, tolerance, &found.shape, found.placement.data(), found.sizes.data(),
                               &found.deviation));
    return found;
}

double any_sweep(Random &random) {
    return random.chance(40) ? 2 * pi : random.between(0.4, 6.2);
}

// A shape with the kind and the sizes that it has to be recognised by; sizes of 0 are not compared.
struct Made {
    Handle g;
    int32_t shape;
    std::array<double, 2> sizes;
};

// Where a shape stands: random, as everything is that the tests below ask for.
struct Place {
    std::array<double, 3> origin{}, axis{}, x{};
    int form;
    double r, s, start, sweep;

    explicit Place(Random &random)
        : form(random.whole(0, 2)), r(random.between(1, 2)), s(random.between(0.3, 0.8)),
          start(random.between(-6, 6)), sweep(any_sweep(random)) {
        for (size_t c = 0; c < 3; ++c) {
            origin[c] = random.between(-3, 3);
            axis[c] = random.between(-1, 1);
            x[c] = random.between(-1, 1);
        }
    }
};

using Maker = std::function<Made(const Place &)>;

Handle profile_line(const Place &p, double x0, double z0, double x1, double z1) {
    const std::array<double, 3> a = {x0, 0, z0}, b = {x1, 0, z1};
    const Handle line = made([&](nurbs **out) { return nurbs_curve_line(3, a.data(), b.data(), out); });
    return made(
        [&](nurbs **out) { return nurbs_revolve(line.get(), nullptr, nullptr, p.sweep, p.form, out); });
}

const std::vector<std::pair<const char *, Maker>> curves = {
    {"line",
     [](const Place &p) {
         return Made{
             made([&](nurbs **out) { return nurbs_curve_line(3, p.origin.data(), p.axis.data(), out); }),
             NURBS_SHAPE_LINE,
             {0, 0}};
     }},
    {"arc",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_arc(3, p.origin.data(), p.axis.data(), p.x.data(), p.r, p.start,
                                                p.sweep, p.form, out);
                     }),
                     NURBS_SHAPE_CIRCLE,
                     {p.r, 0}};
     }},
    {"arc through points",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_arc_through(3, p.origin.data(), p.axis.data(), p.x.data(), p.form,
                                                        out);
                     }),
                     NURBS_SHAPE_CIRCLE,
                     {0, 0}};
     }},
    {"ellipse",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_ellipse(3, p.origin.data(), p.axis.data(), p.x.data(), p.s, p.r,
                                                    p.start, p.sweep, p.form, out);
                     }),
                     NURBS_SHAPE_ELLIPSE,
                     {p.r, p.s}};
     }},
    {"parabola",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_parabola(3, p.origin.data(), p.axis.data(), p.x.data(), p.s, -p.r,
                                                     2 * p.r, out);
                     }),
                     NURBS_SHAPE_PARABOLA,
                     {p.s, 0}};
     }},
    {"hyperbola",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_hyperbola(3, p.origin.data(), p.axis.data(), p.x.data(), p.s, p.r,
                                                      -1.2, 0.9, out);
                     }),
                     NURBS_SHAPE_HYPERBOLA,
                     {p.s, p.r}};
     }},
    {"conic through five points",
     [](const Place &p) {
         Vec points;
         for (int i = 0; i < 5; ++i) {
             const double a = p.start + i * 0.9;
             points.insert(points.end(), {2 * p.r * std::cos(a), p.r * std::sin(a)});
         }
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_conic_through(2, points.data(), 0, 0, p.form % 2, out);
                     }),
                     NURBS_SHAPE_ELLIPSE,
                     {2 * p.r, p.r}};
     }},
    {"focal conic",
     [](const Place &p) {
         const std::array<double, 2> focus = {0, 0}, foot = {p.r, p.s};
         return Made{made([&](nurbs **out) {
                         return nurbs_curve_conic_focus(2, focus.data(), nullptr, foot.data(), 1, -1, 2.5,
                                                        p.form % 2, out);
                     }),
                     NURBS_SHAPE_PARABOLA,
                     {std::hypot(p.r, p.s) / 2, 0}};
     }},
};

const std::vector<std::pair<const char *, Maker>> surfaces = {
    {"plane",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_surface_plane(3, p.origin.data(), p.axis.data(), p.x.data(), out);
                     }),
                     NURBS_SHAPE_PLANE,
                     {0, 0}};
     }},
    {"sphere",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_surface_sphere(p.origin.data(), p.axis.data(), p.x.data(), p.r, p.form,
                                                     out);
                     }),
                     NURBS_SHAPE_SPHERE,
                     {p.r, 0}};
     }},
    {"spherical patch",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_surface_spherical_patch(p.origin.data(), p.axis.data(), p.x.data(), p.r,
                                                              p.start, p.sweep, -p.s, 1.9 * p.s, p.form, out);
                     }),
                     NURBS_SHAPE_SPHERE,
                     {p.r, 0}};
     }},
    {"patch of the sphere without poles",
     [](const Place &p) {
         nurbs_list *list = nullptr;
         require_ok(nurbs_surface_sphere_patches(p.origin.data(), p.axis.data(), p.x.data(), p.r, 0, &list));
         Handle g = made([&](nurbs **out) { return nurbs_list_get(list, 2 * p.form, out); });
         nurbs_list_destroy(list);
         return Made{std::move(g), NURBS_SHAPE_SPHERE, {p.r, 0}};
     }},
    {"cylinder",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_surface_cylinder(p.origin.data(), p.axis.data(), p.x.data(), p.r,
                                                       2 * p.s, p.start, p.sweep, p.form, out);
                     }),
                     NURBS_SHAPE_CYLINDER,
                     {p.r, 0}};
     }},
    {"cone",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_surface_cone(p.origin.data(), p.axis.data(), p.x.data(), p.r,
                                                   p.form == 0 ? 0 : p.s, 1.5, p.start, p.sweep, p.form, out);
                     }),
                     NURBS_SHAPE_CONE,
                     {std::atan((p.r - (p.form == 0 ? 0 : p.s)) / 1.5), 0}};
     }},
    {"torus",
     [](const Place &p) {
         return Made{made([&](nurbs **out) {
                         return nurbs_surface_torus(p.origin.data(), p.axis.data(), p.x.data(), p.r, p.s,
                                                    p.start, p.sweep, 1, p.form == 1 ? 2 : 2 * pi, p.form,
                                                    out);
                     }),
                     NURBS_SHAPE_TORUS,
                     {p.r, p.s}};
     }},
    {"revolved line, a cylinder",
     [](const Place &p) {
         return Made{profile_line(p, p.r, 0, p.r, 1), NURBS_SHAPE_CYLINDER, {p.r, 0}};
     }},
    {"revolved line, a cone",
     [](const Place &p) {
         return Made{profile_line(p, p.r, 0, p.s, 1), NURBS_SHAPE_CONE, {std::atan(p.r - p.s), 0}};
     }},
    {"revolved line, a plane",
     [](const Place &p) {
         return Made{profile_line(p, p.r, 1, p.s, 1), NURBS_SHAPE_PLANE, {0, 0}};
     }},
    {"extruded circle",
     [](const Place &p) {
         const Handle circle = made([&](nurbs **out) {
             return nurbs_curve_circle(3, p.origin.data(), nullptr, nullptr, p.r, p.form, out);
         });
         const std::array<double, 3> up = {0, 0, 1.2};
         return Made{made([&](nurbs **out) { return nurbs_extrude(circle.get(), up.data(), out); }),
                     NURBS_SHAPE_CYLINDER,
                     {p.r, 0}};
     }},
};

Handle rewritten_once(Random &random, const nurbs *g, int axis) {
    std::array<double, 2> domain{};
    require_ok(nurbs_domain(g, axis, domain.data()));
    int32_t degree = 0;
    require_ok(nurbs_degree(g, axis, &degree));
    switch (random.whole(0, 3)) {
    case 0:
        return insert(g, axis, random.between(domain[0], domain[1]), random.whole(1, degree));
    case 1:
        return elevate(g, axis, 1);
    case 2:
        return made([&](nurbs **out) { return nurbs_reverse(g, axis, 0, out); });
    default:
        return made(
            [&](nurbs **out) { return nurbs_reparametrize_moebius(g, axis, random.between(0.5, 2), out); });
    }
}

// The same shape after some operations that keep it.
Handle rewritten(Random &random, const nurbs *g) {
    int32_t axes = 0;
    require_ok(nurbs_axes(g, &axes));
    Handle now = made([&](nurbs **out) { return nurbs_clone(g, out); });
    for (int i = 0; i < 4; ++i) {
        now = rewritten_once(random, now.get(), random.whole(0, axes - 1));
    }
    return now;
}

void expect_shape(const Made &want, const nurbs *g, const char *name, uint64_t seed) {
    const Found found = recognize(g, 1e-9);
    ASSERT_EQ(found.shape, want.shape) << name << " seed " << seed;
    ASSERT_LE(found.deviation, 1e-9);
    ASSERT_GE(found.deviation, 0);
    for (size_t i = 0; i < 2; ++i) {
        if (want.sizes[i] != 0) {
            ASSERT_NEAR(found.sizes[i], want.sizes[i], 1e-6 * want.sizes[i]) << name << " seed " << seed;
        }
    }
}

void recognise_all(const std::vector<std::pair<const char *, Maker>> &makers, uint64_t base, int count) {
    for_each_case(base, count, [&](Random &random, uint64_t seed) {
        const Place place(random);
        const auto &[name, maker] = makers[seed % makers.size()];
        const Made shape = maker(place);
        expect_shape(shape, shape.g.get(), name, seed);
        if (!testing::Test::HasFatalFailure()) {
            expect_shape(shape, rewritten(random, shape.g.get()).get(), name, seed);
        }
    });
}

TEST(RecognizeMade, every_curve_however_it_is_written) {
    recognise_all(curves, 41100, 320);
}

TEST(RecognizeMade, every_surface_however_it_is_written) {
    recognise_all(surfaces, 41500, 240);
}

TEST(RecognizeMade, both_parts_of_a_conic_that_is_split) {
    for_each_case(42500, 240, [&](Random &random, uint64_t seed) {
        const Place place(random);
        const auto &[name, maker] = curves[seed % curves.size()];
        const Made shape = maker(place);
        std::array<double, 2> domain{};
        require_ok(nurbs_domain(shape.g.get(), 0, domain.data()));
        const double at = domain[0] + (domain[1] - domain[0]) * random.between(0.2, 0.8);
        nurbs *lower = nullptr, *upper = nullptr;
        require_ok(nurbs_split(shape.g.get(), 0, at, &lower, &upper));
        for (const Handle &part : {Handle(lower), Handle(upper)}) {
            expect_shape(shape, part.get(), name, seed);
        }
    });
}

// An affine map takes conics and planes to the same kinds, circles to ellipses.
TEST(RecognizeMade, affine_images_of_conics_and_planes) {
    for_each_case(41800, 160, [&](Random &random, uint64_t seed) {
        const Place place(random);
        const size_t i = seed % 5;
        const auto &[name, maker] = i == 4 ? surfaces[0] : curves[i + 2];
        const Made shape = maker(place);
        int32_t dim = 0;
        require_ok(nurbs_dimension(shape.g.get(), &dim));
        Vec matrix;
        for (int k = 0; k < dim * dim; ++k) {
            matrix.push_back(random.between(-0.3, 0.3) + (k % (dim + 1) == 0 ? 1 : 0));
        }
        const Handle image = made([&](nurbs **out) {
            return nurbs_transform(shape.g.get(), dim, matrix.data(), place.origin.data(), out);
        });
        const int32_t found = recognize(image.get(), 1e-9).shape;
        ASSERT_EQ(found, shape.shape == NURBS_SHAPE_CIRCLE ? NURBS_SHAPE_ELLIPSE : shape.shape)
            << name << " seed " << seed;
    });
}

using Point = std::array<long double, 3>;

long double dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Distance of a point from a surface that was found.
long double distance_from(const Found &found, const double *p) {
    Point offset{}, axis{};
    for (size_t c = 0; c < 3; ++c) {
        offset[c] = static_cast<long double>(p[c]) - found.placement[c];
        axis[c] = found.placement[3 + c];
    }
    const long double along = dot(offset, axis), length = std::sqrt(dot(offset, offset));
    const long double across = std::sqrt(std::max(0.0L, length * length - along * along));
    const long double r = found.sizes[0], s = found.sizes[1];
    switch (found.shape) {
    case NURBS_SHAPE_PLANE:
        return std::fabs(along);
    case NURBS_SHAPE_SPHERE:
        return std::fabs(length - r);
    case NURBS_SHAPE_CYLINDER:
        return std::fabs(across - r);
    case NURBS_SHAPE_CONE:
        return std::fabs(across * std::cos(r) - along * std::sin(r));
    default:
        return std::fabs(std::hypot(across - r, along) - s);
    }
}

double largest_distance(const Found &found, const nurbs *g) {
    Vec u;
    for (int i = 0; i <= 60; ++i) {
        u.push_back(i / 60.0);
    }
    const Vec points = eval_grid(g, {u, u});
    long double worst = 0;
    for (size_t i = 0; i < points.size(); i += 3) {
        worst = std::max(worst, distance_from(found, points.data() + i));
    }
    return static_cast<double>(worst);
}

// One control point moved by a vector.
Handle moved(const SplineData &data, size_t i, const Point &way, double size) {
    SplineData other = data;
    for (size_t c = 0; c < 3; ++c) {
        other.points[3 * i + c] += size * static_cast<double>(way[c]);
    }
    return create(other);
}

// A control point of many, moved until the surface has left its shape by ten times the tolerance.
TEST(RecognizeMade, what_was_moved_by_ten_tolerances_is_refused) {
    constexpr double tolerance = 1e-5;
    int cases = 0;
    for_each_case(42100, 240, [&](Random &random, uint64_t seed) {
        const Place place(random);
        const auto &[name, maker] = surfaces[seed % surfaces.size()];
        const Made shape = maker(place);
        Handle fine = made([&](nurbs **out) { return nurbs_refine_uniform(shape.g.get(), 0, 2, out); });
        fine = made([&](nurbs **out) { return nurbs_refine_uniform(fine.get(), 1, 4, out); });
        const Found found = recognize(fine.get(), tolerance);
        ASSERT_EQ(found.shape, shape.shape) << name << " seed " << seed;
        const SplineData data = read_back(fine.get());
        const auto i = static_cast<size_t>(random.whole(0, static_cast<int>(data.points.size() / 3) - 1));
        const Point way = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double probe = largest_distance(found, moved(data, i, way, tolerance).get());
        if (probe < 0.02 * tolerance) {
            return; // it moves along the surface
        }
        const Handle off = moved(data, i, way, 10 * tolerance * tolerance / probe);
        ASSERT_NEAR(largest_distance(found, off.get()), 10 * tolerance, tolerance)
            << name << " seed " << seed;
        ASSERT_EQ(recognize(off.get(), tolerance).shape, NURBS_SHAPE_NONE) << name << " seed " << seed;
        ++cases;
    });
    EXPECT_GT(cases, support::of_whole_run(150));
}

} // namespace

} // namespace recognize_made_test
