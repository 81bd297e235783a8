// Surfaces and volumes from boundaries: those of a spline, which fit together, and any curves.
#include "fuzz/harness.h"

#include <memory>

using fuzz::Input;

namespace {

double any_tolerance(Input &in) {
    return in.rarely() ? in.anything() : in.coin() ? std::ldexp(1.0, in.below(60) - 40) : 0;
}

using Handles = std::vector<std::unique_ptr<fuzz::Handle>>;

// The members of a list, which ends with it.
Handles taken(nurbs_list *list) {
    Handles handles;
    int64_t count = 0;
    FUZZ_REQUIRE(nurbs_list_count(list, &count) == NURBS_OK);
    for (int64_t i = 0; i < count; ++i) {
        nurbs *out = fuzz::poison();
        const nurbs_status status = nurbs_list_get(list, i, &out);
        handles.push_back(std::make_unique<fuzz::Handle>(FUZZ_MADE(status, out)));
    }
    nurbs_list_destroy(list);
    return handles;
}

std::vector<const nurbs *> pointers(const Handles &handles) {
    std::vector<const nurbs *> result;
    for (const auto &handle : handles) {
        result.push_back(handle->get());
    }
    return result;
}

void check_domain(const nurbs *a, int32_t axis_of_a, const nurbs *b, int32_t axis_of_b) {
    double one[2], other[2];
    FUZZ_REQUIRE(nurbs_domain(a, axis_of_a, one) == NURBS_OK &&
                 nurbs_domain(b, axis_of_b, other) == NURBS_OK);
    FUZZ_REQUIRE(fuzz::same_bits(one, other, 2));
}

// What a surface made of boundaries has to be.
void check_surface(nurbs_status status, nurbs *const &out, const std::vector<const nurbs *> &boundaries) {
    const fuzz::Handle made(FUZZ_MADE(status, out));
    if (made) {
        check_domain(made.get(), 0, boundaries[2], 0);
        check_domain(made.get(), 1, boundaries[0], 0);
    }
}

void surfaces(Input &in, const std::vector<const nurbs *> &boundaries,
              const std::vector<const nurbs *> &cross) {
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_surface_coons(boundaries.data(), any_tolerance(in), &out);
    check_surface(status, out, boundaries);
    const bool across = in.coin();
    const double twists[16] = {in.number(), in.number(), in.number(), in.rarely() ? in.anything() : 0};
    double bound = -7;
    out = fuzz::poison();
    const int32_t rule = in.rarely() ? in.bad_int() : in.below(6);
    status = nurbs_surface_coons_hermite(boundaries.data(), across ? cross.data() : nullptr, rule,
                                         rule == NURBS_TWIST_GIVEN || in.rarely() ? twists : nullptr,
                                         any_tolerance(in), &bound, &out);
    FUZZ_REQUIRE(status != NURBS_OK ? bound == -7 : !(bound < 0));
    check_surface(status, out, boundaries);
    double positions[4] = {-7, -7, -7, -7}, tangents[8], gaps[4];
    if (FUZZ_OK(nurbs_coons_gaps(boundaries.data(), across ? cross.data() : nullptr, positions, tangents,
                                 in.coin() ? gaps : nullptr))) {
        FUZZ_REQUIRE(positions[0] >= 0 && positions[3] >= 0 && tangents[0] >= 0 && tangents[7] >= 0);
    } else {
        FUZZ_REQUIRE(positions[0] == -7);
    }
}

void volumes(Input &in, const std::vector<const nurbs *> &faces) {
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_volume_coons(faces.data(), any_tolerance(in), &out);
    const fuzz::Handle made(FUZZ_MADE(status, out));
    if (made) {
        check_domain(made.get(), 0, faces[2], 0);
        check_domain(made.get(), 1, faces[0], 0);
        check_domain(made.get(), 2, faces[0], 1);
    }
}

// One that is asked for more than it is, now and then.
std::vector<const nurbs *> with_stranger(Input &in, std::vector<const nurbs *> handles,
                                         const nurbs *stranger) {
    if (in.rarely()) {
        handles[static_cast<size_t>(in.below(static_cast<int>(handles.size())))] =
            in.coin() ? stranger : nullptr;
    }
    return handles;
}

bool small(const fuzz::Spline &s) {
    return std::all_of(s.degrees.begin(), s.degrees.end(),
                       [&](int32_t p) { return p <= (s.axes() == 3 ? 2 : 4); });
}

Handles boundaries_of(const nurbs *g) {
    nurbs_list *list = nullptr;
    return FUZZ_OK(nurbs_boundaries(g, &list)) ? taken(list) : Handles();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in), t = fuzz::any_spline(in);
    if (!small(s) || !small(t)) {
        return 0;
    }
    const fuzz::Handle g(fuzz::create(s)), h(fuzz::create(t));
    if (!g || !h) {
        return 0;
    }
    const Handles own = boundaries_of(g.get()), other = boundaries_of(h.get());
    const auto first = pointers(own);
    if (s.axes() == 2) {
        surfaces(in, with_stranger(in, first, h.get()), t.axes() == 2 ? pointers(other) : first);
    } else if (s.axes() == 3) {
        volumes(in, with_stranger(in, first, h.get()));
    } else if (t.axes() == 1) {
        surfaces(in, {g.get(), h.get(), g.get(), h.get()}, {h.get(), g.get(), h.get(), g.get()});
    }
    return 0;
}
