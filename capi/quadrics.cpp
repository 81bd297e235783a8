// SPDX-License-Identifier: MIT
// Spheres, other quadrics and the torus as NURBS surfaces.
#include "guard.h"
#include "lists.h"

#include "build/surfaces/quadrics.h"
#include "build/surfaces/sphere_patches.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

build::Placement placed(const double *origin, const double *axis, const double *x,
                        const char *name = "center") {
    return build::make_placement(3, origin, axis, x, name);
}

build::Turn tube_turn(double start, double sweep) {
    return build::make_turn(start, sweep, "tube_start", "tube_sweep");
}

void give_faces(std::vector<SplinePtr> faces, nurbs_list **out) {
    constexpr const char *names[] = {"+X", "+Y", "-X", "-Y", "+Z", "-Z"};
    NamedSplines named;
    for (SplinePtr &face : faces) {
        named.push_back({names[named.size()], std::move(face)});
    }
    give_list(std::move(named), out);
}

} // namespace

nurbs_status nurbs_surface_sphere(const double *center, const double *axis, const double *x, double radius,
                                  int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::sphere(placed(center, axis, x), radius, form), out);
    });
}

nurbs_status nurbs_surface_spherical_patch(const double *center, const double *axis, const double *x,
                                           double radius, double start, double sweep, double south,
                                           double north, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::spherical_patch(placed(center, axis, x), radius, build::make_turn(start, sweep), south,
                                    north, form),
             out);
    });
}

nurbs_status nurbs_surface_sphere_patches(const double *center, const double *axis, const double *x,
                                          double radius, uint32_t flags, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        if ((flags & ~NURBS_HEMISPHERE) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_HEMISPHERE or 0", flags);
        }
        give_faces(build::sphere_patches(placed(center, axis, x), radius, flags != 0), out);
    });
}

nurbs_status nurbs_surface_ellipsoid(const double *center, const double *axis, const double *x,
                                     double radius_x, double radius_y, double radius_z, int32_t form,
                                     nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::ellipsoid(placed(center, axis, x), radius_x, radius_y, radius_z, form), out);
    });
}

nurbs_status nurbs_surface_cylinder(const double *origin, const double *axis, const double *x, double radius,
                                    double height, double start, double sweep, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::cylinder(placed(origin, axis, x, "origin"), radius, height,
                             build::make_turn(start, sweep), form),
             out);
    });
}

nurbs_status nurbs_surface_cone(const double *origin, const double *axis, const double *x, double base_radius,
                                double top_radius, double height, double start, double sweep, int32_t form,
                                nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::cone(placed(origin, axis, x, "origin"), base_radius, top_radius, height,
                         build::make_turn(start, sweep), form),
             out);
    });
}

nurbs_status nurbs_surface_torus(const double *center, const double *axis, const double *x,
                                 double major_radius, double minor_radius, double start, double sweep,
                                 double tube_start, double tube_sweep, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::torus(placed(center, axis, x), major_radius, minor_radius, build::make_turn(start, sweep),
                          tube_turn(tube_start, tube_sweep), form),
             out);
    });
}

nurbs_status nurbs_surface_paraboloid(const double *vertex, const double *axis, const double *x,
                                      double radius_x, double radius_y, double height, double start,
                                      double sweep, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::paraboloid(placed(vertex, axis, x, "vertex"), radius_x, radius_y, height,
                               build::make_turn(start, sweep), form),
             out);
    });
}

nurbs_status nurbs_surface_saddle(const double *center, const double *axis, const double *x, double radius_x,
                                  double radius_y, double height, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::saddle(placed(center, axis, x), radius_x, radius_y, height), out);
    });
}

nurbs_status nurbs_surface_hyperboloid(const double *center, const double *axis, const double *x,
                                       double radius_x, double radius_y, double radius_z, double bottom,
                                       double top, double start, double sweep, int32_t form, uint32_t flags,
                                       nurbs **out) {
    return guard([&] {
        require_out(out);
        if ((flags & ~NURBS_TWO_SHEETS) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_TWO_SHEETS or 0", flags);
        }
        give(build::hyperboloid(placed(center, axis, x),
                                {radius_x, radius_y, radius_z, bottom, top, flags != 0},
                                build::make_turn(start, sweep), form),
             out);
    });
}
