/* SPDX-License-Identifier: MIT */
// Curves and surfaces of known shapes: every form, in several places, with many sizes and angles.
#include "recorded/outputs.h"
#include "recorded/sections.h"
#include "support/generators.h"

#include <string>
#include <vector>

namespace recorded {

namespace {

using support::Random;

constexpr int32_t forms[] = {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS, NURBS_ARC_SMOOTH};

// NULL for what lies at the origin.
struct Place {
    const double *center = nullptr, *axis = nullptr, *x = nullptr;
};

// Sizes and angles, one of many choices.
struct Sizes {
    explicit Sizes(Random &random)
        : a(random.magnitude(1e-3, 1e3)), b(random.magnitude(1e-3, 1e3)), c(random.magnitude(0.1, 10)),
          start(random.between(-7, 7)), sweep(random.between(-6.28, 6.28)) {}
    double a, b, c, start, sweep;
};

void round_curves(int32_t dim, const Place &p, const Sizes &s) {
    for (const int32_t form : forms) {
        nurbs_curve_circle(dim, p.center, p.axis, p.x, s.a, form, unread);
        nurbs_curve_arc(dim, p.center, p.axis, p.x, s.a, s.start, s.sweep, form, unread);
        nurbs_curve_ellipse(dim, p.center, p.axis, p.x, s.a, s.b, s.start, s.sweep, form, unread);
    }
    nurbs_curve_parabola(dim, p.center, p.axis, p.x, s.a, -s.c, s.b, unread);
    nurbs_curve_hyperbola(dim, p.center, p.axis, p.x, s.a, s.b, -s.c, s.c / 2, unread);
    nurbs_curve_polygon(dim, p.center, p.axis, p.x, s.a, 3 + static_cast<int64_t>(s.c), unread);
    nurbs_curve_rounded_rectangle(dim, p.center, p.axis, p.x, s.a, s.b, s.a < s.b ? s.a / 3 : s.b / 3,
                                  unread);
    nurbs_curve_helix(dim, p.center, p.axis, p.x, s.a, 0.1 * s.a, dim == 3 ? s.b : 0, s.start, s.c / 2,
                      1e-6 * s.a, unread, unread);
    nurbs_curve_helix(dim, p.center, p.axis, p.x, s.a, 0, dim == 3 ? s.b : 0, s.start, s.c / 2, 1e-3 * s.a,
                      unread, unread);
}

// From random points and directions.
void conics(int32_t dim, Random &random, const Sizes &s) {
    std::vector<double> all(static_cast<size_t>(5 * dim));
    for (double &x : all) {
        x = random.between(-1, 1);
    }
    const double *const a = all.data(), *const b = a + dim, *const c = b + dim, *const d = c + dim,
                        *const e = d + dim;
    for (const int32_t form : forms) {
        nurbs_curve_arc_through(dim, a, b, c, form, unread);
        nurbs_curve_arc_tangent(dim, a, b, c, form, unread);
        nurbs_curve_conic_point(dim, a, b, c, d, e, form, unread);
        nurbs_curve_conic_through(dim, a, 0, 0, form, unread);
        nurbs_curve_conic_focus(dim, a, dim == 3 ? b : nullptr, c, s.c / 5, s.start, s.sweep / 3, form,
                                unread);
    }
    for (const double factor : {0.0, 0.3, 1.0, s.a}) {
        nurbs_curve_conic_triangle(dim, a, b, c, factor, unread);
        nurbs_curve_conic_shoulder(dim, a, b, c, d, factor / 2, unread);
    }
    nurbs_curve_line(dim, a, b, unread);
    nurbs_curve_polyline(5, dim, a, 0, 0, nullptr, 0, unread);
    nurbs_surface_bilinear(dim, a, 0, 0, unread);
    nurbs_surface_plane(dim, a, b, c, unread);
}

// Ellipses, parabolas, hyperbolas and what is none.
void implicit_conics(Random &random) {
    double k[6];
    for (double &x : k) {
        x = random.whole(-3, 3);
    }
    nurbs_conic_axes(k, unread, unread, unread, unread);
    for (const int32_t form : forms) {
        nurbs_curve_conic_implicit(k, -1, 2.5, form, unread);
    }
}

void surfaces(const Place &p, const Sizes &s, int32_t form) {
    const double south = -0.2 * s.c / 10, north = 1.2;
    nurbs_surface_sphere(p.center, p.axis, p.x, s.a, form, unread);
    nurbs_surface_spherical_patch(p.center, p.axis, p.x, s.a, s.start, s.sweep, south, north, form, unread);
    nurbs_surface_ellipsoid(p.center, p.axis, p.x, s.a, s.b, s.c, form, unread);
    nurbs_surface_cylinder(p.center, p.axis, p.x, s.a, s.b, s.start, s.sweep, form, unread);
    nurbs_surface_cone(p.center, p.axis, p.x, s.a, s.b, s.c, s.start, s.sweep, form, unread);
    nurbs_surface_cone(p.center, p.axis, p.x, s.a, 0, s.c, s.start, s.sweep, form, unread);
    nurbs_surface_torus(p.center, p.axis, p.x, s.a, s.b, s.start, s.sweep, s.sweep, s.start / 2, form,
                        unread);
    nurbs_surface_paraboloid(p.center, p.axis, p.x, s.a, s.b, s.c, s.start, s.sweep, form, unread);
    for (const uint32_t flags : {0u, NURBS_TWO_SHEETS}) {
        nurbs_surface_hyperboloid(p.center, p.axis, p.x, s.a, s.b, s.c, s.c, 3 * s.c, s.start, s.sweep, form,
                                  flags, unread);
    }
}

void surfaces(const Place &p, const Sizes &s) {
    for (const int32_t form : forms) {
        surfaces(p, s, form);
    }
    nurbs_surface_saddle(p.center, p.axis, p.x, s.a, s.b, s.c, unread);
    for (const uint32_t flags : {0u, NURBS_HEMISPHERE}) {
        nurbs_surface_sphere_patches(p.center, p.axis, p.x, s.a, flags, unread);
    }
}

} // namespace

void record_constructors() {
    const double center[] = {1, -20, 0.3}, axis[] = {0.2, 0.7, -0.4}, x[] = {1, 0.1, 0.5};
    const Place places[] = {{}, {center, axis, x}, {center, nullptr, x}, {nullptr, axis, nullptr}};
    for (int i = 0; i < (record.quick() ? 2 : 12); ++i) {
        record.section("construct " + std::to_string(i), [&] {
            Random random(static_cast<uint64_t>(i));
            const Sizes sizes(random);
            for (const Place &place : places) {
                round_curves(2, place, sizes);
                round_curves(3, place, sizes);
                surfaces(place, sizes);
            }
            conics(2, random, sizes);
            conics(3, random, sizes);
            implicit_conics(random);
        });
    }
}

} // namespace recorded
