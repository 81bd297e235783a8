// Regions of closed curves that cross, touch and coincide, and faces that curves divide. What a place is in follows from both
// regions; the parts of a face cover it.
#include "fuzz/harness.h"

#include <memory>

using fuzz::Input;

namespace {

struct Deleter {
    void operator()(nurbs_face *face) const { nurbs_face_destroy(face); }
    void operator()(nurbs_model *model) const { nurbs_model_destroy(model); }
};
using Face = std::unique_ptr<nurbs_face, Deleter>;
using Model = std::unique_ptr<nurbs_model, Deleter>;

nurbs_model *poison_model() {
    return reinterpret_cast<nurbs_model *>(fuzz::poison());
}

Model made(nurbs_status status, nurbs_model *const &out, int line) {
    if (fuzz::succeeded(status, line) != (out != nullptr)) {
        fuzz::violated("status and model disagree", line);
    }
    return Model(out);
}
#define MODEL_MADE(call, out) made(call, out, __LINE__)

// What takes long ends.
nurbs_call_options limited(int64_t work) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    return call;
}

// On a coarse grid, which makes much coincide, or anywhere.
double coordinate(Input &in, bool coarse) {
    return in.rarely() ? in.anything() : coarse ? in.below(5) : 5 * in.unit();
}

nurbs *any_curve(Input &in) {
    if (in.rarely()) {
        return fuzz::create(fuzz::any_spline(in));
    }
    fuzz::Spline s;
    const int32_t degree = 1 + in.below(3);
    const int64_t count = degree + 1 + in.below(6);
    const bool coarse = in.coin(), closed = in.below(8) != 0, rational = in.below(3) == 0;
    s.degrees = {degree};
    s.counts = {count};
    s.knots = fuzz::knot_vector(in, degree, count, true);
    s.dim = 2;
    for (int64_t i = 0; i < count; ++i) {
        const bool again = closed && i == count - 1;
        for (size_t k = 0; k < 2; ++k) {
            s.points.push_back(again ? s.points[k] : coordinate(in, coarse));
        }
        if (rational) {
            s.weights.push_back(fuzz::any_weight(in));
        }
    }
    s.total = count;
    return fuzz::create(s);
}

struct Curves {
    std::vector<const nurbs *> given;
    std::vector<std::unique_ptr<fuzz::Handle>> made;

    Curves(Input &in, int count) {
        for (; count > 0; --count) {
            given.push_back(any_curve(in));
            made.push_back(std::make_unique<fuzz::Handle>(const_cast<nurbs *>(given.back())));
        }
    }
};

double any_tolerance(Input &in) {
    return in.rarely() ? in.anything() : in.coin() ? 0 : std::ldexp(1.0, -in.below(40));
}

Model any_region(Input &in) {
    const Curves curves(in, in.below(4));
    const int32_t rule = in.rarely() ? in.below(9) - 3 : 1 + in.below(3);
    const double tolerance = any_tolerance(in);
    const auto count = std::ssize(curves.given);
    nurbs_model *out = poison_model();
    if (in.below(16) == 0 && count == 0) {
        return MODEL_MADE(nurbs_region_create(count, curves.given.data(), rule, tolerance, &out), out);
    }
    const nurbs_call_options call = limited(3'000'000);
    return MODEL_MADE(nurbs_region_create_with(count, curves.given.data(), rule, tolerance, &call, &out),
                      out);
}

struct Faces {
    std::vector<Face> made;
    std::vector<const nurbs_face *> given;

    explicit Faces(const nurbs_model *model) {
        int64_t count = 0;
        FUZZ_REQUIRE(model == nullptr ||
                     nurbs_model_counts(model, nullptr, nullptr, &count, nullptr, nullptr) == NURBS_OK);
        for (int64_t i = 0; i < count; ++i) {
            nurbs_face *face = nullptr;
            FUZZ_REQUIRE(nurbs_model_face(model, i, nullptr, nullptr, nullptr, nullptr, &face) == NURBS_OK);
            made.emplace_back(face);
            given.push_back(face);
        }
    }
    // 1 inside of one of them, 0 on a border, -1 outside of all.
    [[nodiscard]] int32_t side(const double *x, double tolerance) const {
        int32_t result = -1;
        for (const nurbs_face *face : given) {
            int32_t own = 7;
            FUZZ_REQUIRE(nurbs_face_classify(face, 1, x, 0, 0, tolerance, &own) == NURBS_OK);
            result = own == 0 ? 0 : std::max(result, own);
            if (result == 0) {
                break;
            }
        }
        return result;
    }
};

// Whether what counts as near is so little that places tell anything.
bool is_small(const Faces &faces) {
    for (const nurbs_face *face : faces.given) {
        nurbs *surface = nullptr;
        double ends[2] = {0, 0}, tolerance = 1;
        FUZZ_REQUIRE(nurbs_face_surface(face, &surface) == NURBS_OK);
        const fuzz::Handle own(surface);
        FUZZ_REQUIRE(nurbs_domain(surface, 0, ends) == NURBS_OK &&
                     nurbs_face_tolerance(face, &tolerance) == NURBS_OK);
        if (ends[1] - ends[0] > 1e6 || tolerance > 1e-6) {
            return false;
        }
    }
    return true;
}

bool holds(int32_t rule, bool in_a, bool in_b) {
    return rule == NURBS_REGION_UNION          ? in_a || in_b
           : rule == NURBS_REGION_INTERSECTION ? in_a && in_b
           : rule == NURBS_REGION_DIFFERENCE   ? in_a && !in_b
                                               : in_a != in_b;
}

void combine(Input &in, const Faces &a, const Faces &b) {
    const int32_t rule = in.rarely() ? in.below(9) - 3 : 1 + in.below(4);
    const double tolerance = in.coin() ? 0 : any_tolerance(in);
    const nurbs_call_options call = limited(3'000'000);
    nurbs_model *out = poison_model();
    const bool plain = a.given.size() + b.given.size() < 2 && in.coin();
    const Model model = MODEL_MADE(
        plain ? nurbs_region_combine(rule, std::ssize(a.given), a.given.data(), std::ssize(b.given),
                                     b.given.data(), tolerance, &out)
              : nurbs_region_combine_with(rule, std::ssize(a.given), a.given.data(), std::ssize(b.given),
                                          b.given.data(), tolerance, &call, &out),
        out);
    if (!model || tolerance > 0 || !is_small(a) || !is_small(b)) {
        return;
    }
    const Faces found(model.get());
    for (int i = in.below(8); i > 0; --i) {
        const double x[] = {6 * in.unit() - 0.5, 6 * in.unit() - 0.5};
        const int32_t in_a = a.side(x, 1e-2), in_b = b.side(x, 1e-2), in_both = found.side(x, 0);
        FUZZ_REQUIRE(in_a == 0 || in_b == 0 || in_both == (holds(rule, in_a > 0, in_b > 0) ? 1 : -1));
    }
}

// A cylinder, a sphere or a torus: the domain closes up, and has poles or none.
Model any_round_face(Input &in) {
    const double u[] = {0, 0, 1}, x[] = {1, 0, 0}, origin[] = {0, 0, 0}, turn = 6.283185307179586;
    nurbs *surface = nullptr;
    switch (in.below(3)) {
    case 0:
        FUZZ_REQUIRE(nurbs_surface_cylinder(origin, u, x, 1, 2, 0, turn, NURBS_ARC_QUARTERS, &surface) ==
                     NURBS_OK);
        break;
    case 1:
        FUZZ_REQUIRE(nurbs_surface_sphere(origin, u, x, 1, NURBS_ARC_QUARTERS, &surface) == NURBS_OK);
        break;
    default:
        FUZZ_REQUIRE(nurbs_surface_torus(origin, u, x, 3, 1, 0, turn, 0, turn, NURBS_ARC_QUARTERS,
                                         &surface) == NURBS_OK);
    }
    const fuzz::Handle own(surface);
    nurbs_face *face = nullptr;
    FUZZ_REQUIRE(nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &face) ==
                 NURBS_OK);
    const Face given(face);
    nurbs_model *model = nullptr;
    FUZZ_REQUIRE(nurbs_model_create(1, &face, 1, &model) == NURBS_OK);
    return Model(model);
}

void split(Input &in, const Faces &faces) {
    const Curves curves(in, in.below(3));
    const double tolerance = any_tolerance(in);
    const nurbs_call_options call = limited(3'000'000);
    for (const nurbs_face *face : faces.given) {
        nurbs_model *out = poison_model();
        const auto count = std::ssize(curves.given);
        const Model model =
            MODEL_MADE(count == 0 && in.coin()
                           ? nurbs_face_split(face, count, curves.given.data(), tolerance, &out)
                           : nurbs_face_split_with(face, count, curves.given.data(), tolerance, &call, &out),
                       out);
        if (!model || tolerance > 1e-6 || !is_small(faces)) {
            continue;
        }
        const Faces parts(model.get());
        for (int i = in.below(8); i > 0; --i) {
            const double x[] = {6 * in.unit() - 0.5, 6 * in.unit() - 0.5};
            int32_t whole = 7;
            FUZZ_REQUIRE(nurbs_face_classify(face, 1, x, 0, 0, 1e-2, &whole) == NURBS_OK);
            const int32_t in_parts = parts.side(x, 0);
            FUZZ_REQUIRE(whole == 0 || in_parts == 0 || in_parts == whole);
        }
    }
}

// Over [0, 1]^2, flat or bent, so that it meets the plane of regions in lines or other curves, or touches it.
nurbs *any_cutter(Input &in) {
    if (in.rarely()) {
        return fuzz::create(fuzz::any_spline(in));
    }
    fuzz::Spline s;
    const int32_t degree = 1 + in.below(2);
    const bool coarse = in.coin();
    s.degrees = {degree, 1};
    s.counts = {degree + 1, 2};
    for (const int32_t p : {degree, 1}) {
        s.knots.insert(s.knots.end(), static_cast<size_t>(p) + 1, 0.0);
        s.knots.insert(s.knots.end(), static_cast<size_t>(p) + 1, 1.0);
    }
    s.dim = 3;
    s.total = 2 * (degree + 1);
    for (int64_t i = 0; i < s.total; ++i) {
        for (const double z : {0.0, 0.0, 1.0}) {
            s.points.push_back(3 * coordinate(in, coarse) - 5 - z);
        }
    }
    return fuzz::create(s);
}

// A place that both sides tell is in one of them if it is in the face.
void trim(Input &in, const Faces &faces) {
    const fuzz::Handle cutter(any_cutter(in));
    const double tolerance = in.rarely() ? in.anything() : std::ldexp(1.0, -10 - in.below(30));
    const nurbs_call_options call = limited(3'000'000);
    for (const nurbs_face *face : faces.given) {
        std::vector<Model> kept;
        const int32_t other = in.rarely() ? in.below(5) - 2 : NURBS_TRIM_BACK;
        for (const int32_t side : {NURBS_TRIM_FRONT, other}) {
            nurbs_model *out = poison_model();
            kept.push_back(
                MODEL_MADE(tolerance > 1 && in.rarely()
                               ? nurbs_face_trim(face, cutter.get(), side, tolerance, &out)
                               : nurbs_face_trim_with(face, cutter.get(), side, tolerance, &call, &out),
                           out));
        }
        if (!kept[0] || !kept[1] || other != NURBS_TRIM_BACK || tolerance > 1e-6 || !is_small(faces)) {
            continue;
        }
        const Faces front(kept[0].get()), back(kept[1].get());
        for (int i = in.below(8); i > 0; --i) {
            const double x[] = {6 * in.unit() - 0.5, 6 * in.unit() - 0.5};
            int32_t whole = 7;
            FUZZ_REQUIRE(nurbs_face_classify(face, 1, x, 0, 0, 1e-2, &whole) == NURBS_OK);
            const int32_t ahead = front.side(x, 0), behind = back.side(x, 0);
            FUZZ_REQUIRE(whole == 0 || ahead == 0 || behind == 0 ||
                         (ahead > 0) + (behind > 0) == (whole > 0 ? 1 : 0));
            FUZZ_REQUIRE(whole >= 0 || (ahead <= 0 && behind <= 0));
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const Model a = any_region(in), b = any_region(in);
    const Faces of_a(a.get()), of_b(b.get());
    if (a && b) {
        combine(in, of_a, of_b);
    }
    if (in.coin()) {
        split(in, of_a);
    }
    if (in.below(4) == 0) {
        const Model round = any_round_face(in);
        split(in, Faces(round.get()));
    }
    if (in.coin()) {
        trim(in, of_b);
    }
    return 0;
}
