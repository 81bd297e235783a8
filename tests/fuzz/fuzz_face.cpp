// Trimmed faces: random loops, edges and mistakes on random surfaces and on those that close up. Sides do not depend on the
// batch, a box contains the places that are inside.
#include "fuzz/harness.h"

#include <memory>
#include <optional>

using fuzz::Input;

namespace {

struct FaceDeleter {
    void operator()(nurbs_face *face) const { nurbs_face_destroy(face); }
};
using Face = std::unique_ptr<nurbs_face, FaceDeleter>;

nurbs_face *poison_face() {
    return reinterpret_cast<nurbs_face *>(fuzz::poison());
}

Face made(nurbs_status status, nurbs_face *const &out, int line) {
    if (fuzz::succeeded(status, line) != (out != nullptr)) {
        fuzz::violated("status and face disagree", line);
    }
    return Face(out);
}
#define FACE_MADE(call, out) made(call, out, __LINE__)

// What takes long ends.
nurbs_call_options limited(int64_t work) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    return call;
}

constexpr double full_turn = 6.283185307179586;

// A patch over the unit square, a surface that closes up, or any spline; bad ones, too.
nurbs *any_surface(Input &in) {
    nurbs *g = nullptr;
    static constexpr double origin[] = {0, 0, 0}, u[] = {2, 0, 0}, v[] = {0, 1, 0.5};
    switch (in.below(6)) {
    case 0:
        FUZZ_REQUIRE(nurbs_surface_plane(3, origin, u, v, &g) == NURBS_OK);
        return g;
    case 1:
        FUZZ_REQUIRE(nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, in.below(3), &g) == NURBS_OK || !g);
        return g;
    case 2:
        FUZZ_OK(nurbs_surface_torus(nullptr, nullptr, nullptr, 2, 0.125 + in.unit() / 2, 0, full_turn, 0,
                                    full_turn, in.below(3), &g));
        return g;
    case 3:
        FUZZ_OK(
            nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, in.unit(), full_turn, in.below(3), &g));
        return g;
    default:
        return fuzz::create(fuzz::any_spline(in));
    }
}

struct Domain {
    double lower[2] = {0, 0}, length[2] = {1, 1};

    explicit Domain(const nurbs *surface) {
        for (int32_t k = 0; k < 2; ++k) {
            double ends[2] = {0, 1};
            if (nurbs_domain(surface, k, ends) == NURBS_OK) {
                lower[k] = ends[0];
                length[k] = ends[1] - ends[0];
            }
        }
    }
    [[nodiscard]] double at(int k, double part) const { return lower[k] + part * length[k]; }
};

// A closed curve, or an open one, or one that was never meant for a domain.
nurbs *any_curve(Input &in, const Domain &domain) {
    if (in.rarely()) {
        return fuzz::create(fuzz::any_spline(in));
    }
    fuzz::Spline s;
    const int32_t degree = 1 + (in.rarely() ? in.below(31) : in.below(4));
    const int64_t count = degree + 1 + in.below(6);
    s.degrees = {degree};
    s.counts = {count};
    s.knots = fuzz::knot_vector(in, degree, count, true);
    s.dim = 2;
    const bool rational = in.below(3) == 0, closed = in.below(8) != 0;
    const double reach = in.below(4) == 0 ? 2 : 0.9;
    for (int64_t i = 0; i < count; ++i) {
        const bool again = closed && i == count - 1;
        for (int k = 0; k < 2; ++k) {
            s.points.push_back(again         ? s.points[static_cast<size_t>(k)]
                               : in.rarely() ? in.anything()
                                             : domain.at(k, in.unit() * reach));
        }
        if (rational) {
            s.weights.push_back(fuzz::any_weight(in));
        }
    }
    s.total = count;
    return fuzz::create(s);
}

// The arguments of nurbs_face_create().
struct Loops {
    std::vector<int64_t> sizes, keys;
    std::vector<const nurbs *> curves, edges;
    std::vector<double> gaps;
    std::vector<std::unique_ptr<fuzz::Handle>> made;
    double tolerance = 0;
    uint32_t flags = 0;
};

nurbs *edge_over(const nurbs *surface, const nurbs *curve) {
    nurbs *edge = nullptr;
    const nurbs_call_options call = limited(2'000'000);
    return curve != nullptr && FUZZ_OK(nurbs_compose_with(surface, curve, &call, &edge)) ? edge : nullptr;
}

Loops any_loops(Input &in, const nurbs *surface) {
    Loops loops;
    const Domain domain(surface);
    for (int loop = in.below(4); loop > 0; --loop) {
        loops.sizes.push_back(in.below(4) == 0 ? 1 + in.below(3) : 1);
        for (int64_t i = 0; i < loops.sizes.back(); ++i) {
            nurbs *curve = any_curve(in, domain);
            nurbs *edge = in.below(8) == 0 ? edge_over(surface, curve) : nullptr;
            loops.made.push_back(std::make_unique<fuzz::Handle>(curve));
            loops.made.push_back(std::make_unique<fuzz::Handle>(edge));
            loops.curves.push_back(edge != nullptr && in.coin() ? nullptr : curve);
            loops.edges.push_back(edge);
            loops.keys.push_back(in.rarely() ? in.bad_size() : in.below(9) - 4);
        }
        if (in.rarely()) {
            loops.sizes.back() = in.bad_size();
        }
    }
    loops.gaps.resize(loops.sizes.size());
    loops.tolerance = in.rarely() ? in.anything() : std::ldexp(1.0, -in.below(40));
    loops.flags = (in.coin() ? NURBS_AS_ORIENTED : 0) | (in.below(4) == 0 ? NURBS_KEEP_GAPS : 0) |
                  (in.below(4) == 0 ? NURBS_CHECK_CROSSINGS : 0);
    loops.flags ^= in.rarely() ? 1u << in.below(32) : 0;
    return loops;
}

Face any_face(Input &in, const nurbs *surface) {
    const Loops loops = any_loops(in, surface);
    std::vector<double> gaps = loops.gaps;
    const auto n = std::ssize(loops.sizes);
    const bool edges = in.coin();
    const nurbs_call_options call = limited(3'000'000);
    nurbs_face *face = poison_face();
    if (in.below(16) == 0 && n == 0) {
        return FACE_MADE(nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, loops.tolerance,
                                           loops.flags, nullptr, &face),
                         face);
    }
    return FACE_MADE(nurbs_face_create_with(surface, n, loops.sizes.data(), loops.curves.data(),
                                            edges ? loops.edges.data() : nullptr, loops.keys.data(),
                                            loops.tolerance, loops.flags, gaps.data(), &call, &face),
                     face);
}

std::vector<int64_t> sizes_of(const nurbs_face *face) {
    int64_t count = -1;
    FUZZ_REQUIRE(nurbs_face_loops(face, 0, nullptr, &count) == NURBS_OK && count >= 0);
    std::vector<int64_t> sizes(static_cast<size_t>(count));
    FUZZ_REQUIRE(nurbs_face_loops(face, count, sizes.data(), nullptr) == NURBS_OK);
    return sizes;
}

void parts(Input &in, const nurbs_face *face) {
    double tolerance = -1;
    FUZZ_REQUIRE(nurbs_face_tolerance(face, &tolerance) == NURBS_OK && tolerance >= 0);
    const std::vector<int64_t> sizes = sizes_of(face);
    const int64_t loop = in.rarely() ? in.bad_size() : in.below(static_cast<int>(sizes.size()) + 1);
    const int64_t index = in.rarely() ? in.bad_size() : in.below(2);
    nurbs *curve = fuzz::poison(), *edge = fuzz::poison(), *surface = fuzz::poison();
    const fuzz::Handle whole(FUZZ_MADE(nurbs_face_surface(face, &surface), surface));
    const fuzz::Handle flat(FUZZ_MADE(nurbs_face_curve(face, loop, index, &curve), curve));
    const bool known = loop >= 0 && loop < std::ssize(sizes) && index >= 0 &&
                       index < sizes[static_cast<size_t>(std::max<int64_t>(loop, 0))];
    FUZZ_REQUIRE(whole && static_cast<bool>(flat) == known);
    if (in.below(4) == 0) {
        int64_t key = 0;
        int32_t proven = 0;
        double distance = -1;
        const fuzz::Handle space(FUZZ_MADE(nurbs_face_edge(face, loop, index, &key, &edge), edge));
        if (FUZZ_OK(nurbs_face_deviation(face, loop, index, &distance, &proven))) {
            FUZZ_REQUIRE(distance >= 0 && (proven == 0 || proven == 1));
        }
    }
}

void sides(Input &in, const nurbs *surface, const nurbs_face *face) {
    const int64_t n = in.below(20);
    const Domain domain(surface);
    std::vector<double> at;
    for (int64_t i = 0; i < 2 * n; ++i) {
        at.push_back(in.rarely() ? in.anything()
                                 : domain.at(static_cast<int>(i % 2), 1.5 * in.unit() - 0.25));
    }
    std::vector<int32_t> found(static_cast<size_t>(n));
    const double tolerance = in.rarely() ? in.anything() : in.coin() ? 0 : in.unit() / 8;
    if (!FUZZ_OK(nurbs_face_classify(face, n, at.data(), 0, 0, tolerance, found.data()))) {
        return;
    }
    double lower[4], upper[4];
    const nurbs_call_options call = limited(3'000'000);
    int32_t dim = 0;
    FUZZ_REQUIRE(nurbs_dimension(surface, &dim) == NURBS_OK && dim <= 4);
    const bool boxed = FUZZ_OK(nurbs_face_box_with(face, 1e-3, lower, upper, nullptr, &call));
    for (size_t i = 0; i < found.size(); ++i) {
        int32_t alone = 7;
        FUZZ_REQUIRE(nurbs_face_classify_with(face, 1, at.data() + 2 * i, 0, 0, tolerance, &alone, &call) ==
                     NURBS_OK);
        FUZZ_REQUIRE(alone == found[i] && -1 <= alone && alone <= 1);
        double point[4];
        if (!boxed || found[i] != 1 ||
            nurbs_eval(surface, 1, at.data() + 2 * i, 0, 0, point, 0, 0, NURBS_ON_ALL_AXES(2, NURBS_WRAP)) !=
                NURBS_OK) {
            continue;
        }
        for (int32_t c = 0; c < dim; ++c) {
            const double size = std::max(std::fabs(lower[c]), std::fabs(upper[c]));
            const double off = 1e-9 * size + 1e-300;
            FUZZ_REQUIRE(!std::isfinite(size) || (lower[c] - off <= point[c] && point[c] <= upper[c] + off));
        }
    }
}

// The nearest point is on the face, and nearer than a place that is known to be on it.
void nearest(Input &in, const nurbs *surface, const nurbs_face *face) {
    const Domain domain(surface);
    const double uv[] = {domain.at(0, in.unit()), domain.at(1, in.unit())};
    double at[4] = {0, 0, 0, 0}, from[4], found[2], feet[4], distance = 0;
    int32_t dim = 0, status = 0, side = 0;
    FUZZ_REQUIRE(nurbs_dimension(surface, &dim) == NURBS_OK);
    if (dim > 4 || !FUZZ_OK(nurbs_eval(surface, 1, uv, 0, 0, at, 0, 0, 0)) ||
        !FUZZ_OK(nurbs_face_classify(face, 1, uv, 0, 0, 0, &side))) {
        return;
    }
    double known = 0, size = 0;
    for (int32_t c = 0; c < dim; ++c) {
        from[c] = in.rarely() ? in.anything() : 4 * in.unit() - 2;
        known = std::hypot(known, from[c] - at[c]);
        size = std::max({size, std::fabs(from[c]), std::fabs(at[c])});
    }
    const nurbs_call_options call = limited(3'000'000);
    if (!FUZZ_OK(nurbs_face_closest_points_with(face, 1, from, 0, 0, 1e-6, found, feet, &distance, &status,
                                                &call))) {
        return;
    }
    if ((status & NURBS_CLOSEST_CERTIFIED) != 0 && side == 1) {
        FUZZ_REQUIRE(distance <= known + 2e-6 + 1e-9 * size);
    }
    if (in.below(8) == 0) {
        FUZZ_OK(nurbs_face_closest_points(face, 1, from, 0, 0, 1e-3, nullptr, nullptr, &distance, nullptr));
    }
}

// What a ray meets first lies inside, and rays to places inside are not certified to miss.
void rays(Input &in, const nurbs *surface, const nurbs_face *face) {
    const Domain domain(surface);
    const double uv[] = {domain.at(0, in.unit()), domain.at(1, in.unit())};
    double at[4] = {0, 0, 0, 0}, from[3], along[3], found[2], t = 0;
    int32_t dim = 0, status = 0, side = 0;
    FUZZ_REQUIRE(nurbs_dimension(surface, &dim) == NURBS_OK);
    if (dim > 4 || !FUZZ_OK(nurbs_eval(surface, 1, uv, 0, 0, at, 0, 0, 0))) {
        return;
    }
    for (int c = 0; c < 3; ++c) {
        from[c] = in.rarely() ? in.anything() : 4 * in.unit() - 2;
        along[c] = at[c] - from[c];
    }
    if (!FUZZ_OK(nurbs_face_rays(face, 1, from, 0, 0, along, 0, 0, found, &t, &status))) {
        return;
    }
    const bool hit = (status & NURBS_RAY_HIT) != 0, touch = (status & NURBS_RAY_TOUCH) != 0;
    FUZZ_REQUIRE((hit || touch) == !std::isnan(t) && !(hit && touch));
    if (hit) {
        FUZZ_REQUIRE(nurbs_face_classify(face, 1, found, 0, 0, 0, &side) == NURBS_OK && side >= 0);
    }
    const nurbs_call_options call = limited(in.below(1000) + 1);
    FUZZ_OK(nurbs_face_rays_with(face, 1, from, 0, 0, along, 0, 0, nullptr, nullptr, &status, &call));
}

void areas(const nurbs_face *face) {
    const nurbs_call_options call = limited(3'000'000);
    double area = 0, content = 0, error = -1, centroid[4], inertia[16];
    if (!FUZZ_OK(nurbs_face_area_with(face, 1e-6, &area, &error, &call))) {
        return;
    }
    FUZZ_REQUIRE(error >= 0 && std::isfinite(area));
    FUZZ_OK(nurbs_face_moments_with(face, 1e-3, &content, centroid, inertia, nullptr, &call));
}

// Weights are not negative, and points lie in the domain.
void rules(const nurbs_face *face) {
    const nurbs_call_options call = limited(3'000'000);
    int64_t count = -1;
    if (!FUZZ_OK(nurbs_face_quadrature_with(face, 2, 0, nullptr, nullptr, nullptr, &count, &call)) ||
        count > 4000) {
        return;
    }
    const auto n = static_cast<size_t>(count);
    std::vector<double> params(2 * n), weights(n), measures(n);
    if (FUZZ_OK(
            nurbs_face_quadrature(face, 2, count, params.data(), weights.data(), measures.data(), nullptr))) {
        for (size_t i = 0; i < n; ++i) {
            FUZZ_REQUIRE(weights[i] >= 0 && measures[i] >= 0);
            FUZZ_REQUIRE(std::isfinite(params[2 * i]) && std::isfinite(params[2 * i + 1]));
        }
    }
}

// From all of the same surface, or of one that is moved. What is inside is no nearer than the bound from below.
void distances(Input &in, const nurbs *surface, const nurbs_face *face) {
    int32_t dim = 0;
    FUZZ_REQUIRE(nurbs_dimension(surface, &dim) == NURBS_OK);
    if (dim > 4) {
        return;
    }
    const double shift[] = {in.unit(), 2 * in.unit(), in.unit(), in.rarely() ? in.anything() : 0};
    double matrix[16] = {};
    for (int32_t c = 0; c < dim; ++c) {
        matrix[c * (dim + 1)] = 1;
    }
    nurbs *moved = nullptr;
    nurbs_face *whole = nullptr;
    if (!FUZZ_OK(nurbs_transform(surface, dim, matrix, shift, &moved))) {
        return;
    }
    const fuzz::Handle owner(moved);
    if (!FUZZ_OK(nurbs_face_create(moved, 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &whole))) {
        return;
    }
    const Face other(whole);
    const nurbs_call_options call = limited(3'000'000);
    double low = -1, high = -1, lows[2], highs[2], at[2], to[2];
    int32_t status = 0;
    if (FUZZ_OK(nurbs_face_distance_with(face, whole, 1e-6, &low, &high, at, to, &status, &call))) {
        FUZZ_REQUIRE(0 <= low && low <= high && std::isfinite(high));
    }
    if (FUZZ_OK(nurbs_face_hausdorff_distance_with(face, whole, 1e-3, lows, highs, at, to, &status, &call))) {
        FUZZ_REQUIRE(0 <= lows[0] && lows[0] <= highs[0] && 0 <= lows[1] && lows[1] <= highs[1]);
    }
}

// The forms without options, on a face that is quickly done with.
void plainly() {
    nurbs *surface = nullptr;
    static constexpr double origin[] = {0, 0, 0}, u[] = {2, 0, 0}, v[] = {0, 1, 0.5};
    FUZZ_REQUIRE(nurbs_surface_plane(3, origin, u, v, &surface) == NURBS_OK);
    const fuzz::Handle owner(surface);
    nurbs_face *face = nullptr, *clone = nullptr;
    FUZZ_REQUIRE(nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, 0, 0, nullptr, &face) ==
                 NURBS_OK);
    FUZZ_REQUIRE(nurbs_face_clone(face, &clone) == NURBS_OK);
    nurbs_face_destroy(face);
    const Face kept(clone);
    double area = 0, content = 0, lower[3], upper[3];
    FUZZ_REQUIRE(nurbs_face_area(clone, 1e-9, &area, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_face_moments(clone, 1e-9, &content, nullptr, nullptr, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(area == content);
    FUZZ_REQUIRE(nurbs_face_box(clone, 1e-9, lower, upper, nullptr) == NURBS_OK);
    double low = 1, high = 1, lows[2], highs[2];
    FUZZ_REQUIRE(nurbs_face_distance(clone, clone, 0, &low, &high, nullptr, nullptr, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(low == 0 && high < 1e-9);
    FUZZ_REQUIRE(nurbs_face_hausdorff_distance(clone, clone, 0, lows, highs, nullptr, nullptr, nullptr) ==
                 NURBS_OK);
    FUZZ_REQUIRE(highs[0] == 0 && highs[1] == 0);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Handle surface(any_surface(in));
    if (!surface) {
        return 0;
    }
    const Face face = any_face(in, surface.get());
    if (face) {
        parts(in, face.get());
        sides(in, surface.get(), face.get());
        rays(in, surface.get(), face.get());
        nearest(in, surface.get(), face.get());
        distances(in, surface.get(), face.get());
        areas(face.get());
        rules(face.get());
    }
    plainly();
    return 0;
}
