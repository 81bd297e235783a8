// Shapes that are defined by a few numbers: patches over corners, quadrics, the torus, the sphere without
// poles.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

double any_value(Input &in) {
    return in.rarely() ? in.anything() : in.number();
}

double any_length(Input &in) {
    return in.rarely() ? in.anything() : std::ldexp(0.01 + in.unit(), in.coin() ? 0 : in.below(60) - 30);
}

double any_angle(Input &in) {
    return in.coin() ? (in.below(49) - 24) * std::acos(-1.0) / 12 : any_value(in);
}

int32_t any_form(Input &in) {
    return in.rarely() ? in.bad_int() : in.below(3);
}

uint32_t any_flag(Input &in, uint32_t flag) {
    return in.rarely() ? 1U << in.below(32) : in.coin() ? flag : 0;
}

// Three directions or points, each given or not.
struct Place {
    double values[9];
    bool given[3];

    explicit Place(Input &in) {
        for (bool &part : given) {
            part = in.coin();
        }
        for (double &value : values) {
            value = any_value(in);
        }
    }
    [[nodiscard]] const double *part(int k) const { return given[k] ? values + 3 * k : nullptr; }
};

// A surface that was made can be evaluated, and is in space.
void check_made(nurbs *made) {
    const fuzz::Handle g(made);
    if (g) {
        const double middle[] = {0.5, 0.5};
        double point[3];
        int32_t dim = 0;
        FUZZ_REQUIRE(nurbs_dimension(g.get(), &dim) == NURBS_OK && dim == 3);
        FUZZ_REQUIRE(nurbs_eval(g.get(), 1, middle, 0, 0, point, 0, 0, 0) == NURBS_OK);
    }
}

void round_shapes(Input &in, const Place &place) {
    const double *c = place.part(0), *z = place.part(1), *x = place.part(2);
    nurbs *out = fuzz::poison();
    nurbs_status status = NURBS_OK;
    switch (in.below(8)) {
    case 0:
        status = nurbs_surface_sphere(c, z, x, any_length(in), any_form(in), &out);
        break;
    case 1:
        status = nurbs_surface_spherical_patch(c, z, x, any_length(in), any_angle(in), any_angle(in),
                                               any_angle(in), any_angle(in), any_form(in), &out);
        break;
    case 2:
        status = nurbs_surface_ellipsoid(c, z, x, any_length(in), any_length(in), any_length(in),
                                         any_form(in), &out);
        break;
    case 3:
        status = nurbs_surface_cylinder(c, z, x, any_length(in), any_length(in), any_angle(in), any_angle(in),
                                        any_form(in), &out);
        break;
    case 4:
        status = nurbs_surface_cone(c, z, x, any_length(in), any_length(in), any_length(in), any_angle(in),
                                    any_angle(in), any_form(in), &out);
        break;
    case 5:
        status = nurbs_surface_torus(c, z, x, any_length(in), any_length(in), any_angle(in), any_angle(in),
                                     any_angle(in), any_angle(in), any_form(in), &out);
        break;
    case 6:
        status = nurbs_surface_paraboloid(c, z, x, any_length(in), any_length(in), any_length(in),
                                          any_angle(in), any_angle(in), any_form(in), &out);
        break;
    default:
        status = nurbs_surface_hyperboloid(c, z, x, any_length(in), any_length(in), any_length(in),
                                           any_value(in), any_value(in), any_angle(in), any_angle(in),
                                           any_form(in), any_flag(in, NURBS_TWO_SHEETS), &out);
        break;
    }
    check_made(FUZZ_MADE(status, out));
}

void sphere_patches(Input &in, const Place &place) {
    nurbs_list *list = reinterpret_cast<nurbs_list *>(fuzz::poison());
    const nurbs_status status = nurbs_surface_sphere_patches(
        place.part(0), place.part(1), place.part(2), any_length(in), any_flag(in, NURBS_HEMISPHERE), &list);
    FUZZ_REQUIRE(FUZZ_OK(status) == (list != nullptr));
    nurbs_list_destroy(list);
}

// Arrays of exactly the length that strides and dimension ask for.
void flat_patches(Input &in) {
    const int32_t dim = in.rarely() ? in.bad_int() : 1 + in.below(4);
    const bool valid = dim > 0 && dim < 5;
    const int64_t stride = valid && in.coin() ? dim + in.below(3) : in.rarely() ? in.bad_size() : 0;
    const auto length = static_cast<size_t>(valid ? 8 * std::clamp<int64_t>(stride, dim, 8) : 1);
    std::vector<double> corners(length);
    std::generate(corners.begin(), corners.end(), [&] { return any_value(in); });
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_surface_bilinear(dim, corners.data(), stride, 0, &out);
    nurbs_destroy(FUZZ_MADE(status, out));
    out = fuzz::poison();
    status = nurbs_volume_trilinear(dim, corners.data(), stride, 0, &out);
    nurbs_destroy(FUZZ_MADE(status, out));
    out = fuzz::poison();
    const auto n = static_cast<size_t>(valid ? dim : 0);
    status = nurbs_surface_plane(dim, in.coin() ? corners.data() : nullptr, corners.data() + n,
                                 corners.data() + 2 * n, &out);
    nurbs_destroy(FUZZ_MADE(status, out));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    for (int i = 0; i < 4; ++i) {
        const Place place(in);
        round_shapes(in, place);
        if (in.coin()) {
            nurbs *out = fuzz::poison();
            const nurbs_status status =
                nurbs_surface_saddle(place.part(0), place.part(1), place.part(2), any_length(in),
                                     any_length(in), any_length(in), &out);
            check_made(FUZZ_MADE(status, out));
            sphere_patches(in, place);
        }
    }
    flat_patches(in);
    return 0;
}
