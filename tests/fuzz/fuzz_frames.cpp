// Frames and curvature: vectors have length 1 and are perpendicular unless the status says that they do not
// exist; one parameter gives the same bits alone and in a batch; refused calls write nothing.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Batch {
    int64_t n;
    uint32_t flags;
    std::vector<double> params;
};

using Values = std::vector<double>;
using States = std::vector<int32_t>;

bool untouched(const std::vector<Values> &all, const States &states) {
    return std::all_of(all.begin(), all.end(),
                       [](const Values &values) {
                           return std::all_of(values.begin(), values.end(), [](double v) { return v == -7; });
                       }) &&
           std::all_of(states.begin(), states.end(), [](int32_t v) { return v == -7; });
}

std::vector<Values> arrays(int64_t n, std::initializer_list<int> widths) {
    std::vector<Values> all;
    for (const int width : widths) {
        all.emplace_back(static_cast<size_t>(n * width), -7);
    }
    return all;
}

// Overflow can make anything of a vector, and NaN of everything made from it.
bool ordinary(const fuzz::Spline &s) {
    return s.size() < 1e30 && s.weight_ratio() > 0 && s.weight_ratio() < 1e10;
}

double dot(const double *a, const double *b, int dim) {
    double sum = 0;
    for (int c = 0; c < dim; ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

bool is_unit(const double *a, int dim) {
    return std::fabs(dot(a, a, dim) - 1) < 1e-12;
}

nurbs_status surface_call(const nurbs *g, const Batch &b, std::vector<Values> &v, States &states) {
    return nurbs_surface_eval_frames(g, b.n, b.params.data(), 0, 0, v[0].data(), 0, 0, v[1].data(), 0, 0,
                                     v[2].data(), 0, 0, v[3].data(), 0, 0, states.data(), b.flags);
}

nurbs_status curvature_call(const nurbs *g, const Batch &b, std::vector<Values> &v, States &states) {
    return nurbs_surface_eval_curvatures(g, b.n, b.params.data(), 0, 0, v[0].data(), 0, 0, v[1].data(), 0, 0,
                                         v[2].data(), 0, v[3].data(), 0, states.data(), b.flags);
}

nurbs_status curve_call(const nurbs *g, const Batch &b, std::vector<Values> &v, States &states) {
    const bool plane = v[3].empty() && b.n > 0;
    return nurbs_curve_eval_frames(g, b.n, b.params.data(), 0, v[0].data(), 0, 0, v[1].data(), 0, 0,
                                   v[2].data(), 0, 0, plane ? nullptr : v[3].data(), 0, 0, v[4].data(), 0,
                                   plane ? nullptr : v[5].data(), 0, states.data(), b.flags);
}

// Calls once for all parameters and once for each; returns whether the batch was accepted.
template <class Call>
bool same_alone(const nurbs *g, const Batch &b, int axes, std::initializer_list<int> widths, Call &&call,
                std::vector<Values> &values, States &states) {
    values = arrays(b.n, widths);
    states.assign(static_cast<size_t>(b.n), -7);
    if (!FUZZ_OK(call(g, b, values, states))) {
        FUZZ_REQUIRE(untouched(values, states));
        return false;
    }
    for (int64_t i = 0; i < b.n; ++i) {
        const auto first = b.params.begin() + i * axes;
        const Batch one{1, b.flags, Values(first, first + axes)};
        std::vector<Values> single = arrays(1, widths);
        States state(1, -7);
        FUZZ_REQUIRE(call(g, one, single, state) == NURBS_OK);
        FUZZ_REQUIRE(state[0] == states[static_cast<size_t>(i)]);
        for (size_t k = 0; k < single.size(); ++k) {
            const size_t width = single[k].size();
            FUZZ_REQUIRE(
                fuzz::same_bits(single[k].data(), values[k].data() + static_cast<size_t>(i) * width, width));
        }
    }
    return true;
}

void surfaces(const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    std::vector<Values> v;
    States states;
    if (!same_alone(g, b, 2, {3, 3, 3, 3}, surface_call, v, states)) {
        return;
    }
    for (size_t i = 0; i < states.size() && ordinary(s); ++i) {
        const bool undefined = states[i] == NURBS_FRAME_UNDEFINED;
        FUZZ_REQUIRE(undefined ? std::isnan(v[3][3 * i]) : is_unit(v[3].data() + 3 * i, 3));
        FUZZ_REQUIRE((states[i] & ~(NURBS_FRAME_LIMIT | NURBS_FRAME_UNDEFINED)) == 0);
    }
    FUZZ_REQUIRE(same_alone(g, b, 2, {2, 6, 1, 1}, curvature_call, v, states));
    for (size_t i = 0; i < states.size() && ordinary(s); ++i) {
        FUZZ_REQUIRE(states[i] == NURBS_FRAME_UNDEFINED || states[i] == NURBS_FRAME_RULE || states[i] == 0);
        FUZZ_REQUIRE((states[i] == NURBS_FRAME_UNDEFINED) == std::isnan(v[1][6 * i]));
        FUZZ_REQUIRE(states[i] == NURBS_FRAME_UNDEFINED || is_unit(v[1].data() + 6 * i, 3));
    }
}

void grids(Input &in, const nurbs *g, uint32_t flags) {
    const std::array<int64_t, 2> counts{in.below(4), 1 + in.below(3)};
    Values params;
    for (int32_t k = 0; k < 2; ++k) {
        for (int64_t i = 0; i < counts[static_cast<size_t>(k)]; ++i) {
            params.push_back(fuzz::any_param(in, g, k, in.coin()));
        }
    }
    const int64_t n = counts[0] * counts[1];
    std::vector<Values> v = arrays(n, {3, 3, 3, 3});
    States states(static_cast<size_t>(n), -7);
    if (!FUZZ_OK(nurbs_surface_eval_grid_frames(g, counts.data(), params.data(), v[0].data(), 0, 0,
                                                v[1].data(), 0, 0, v[2].data(), 0, 0, v[3].data(), 0, 0,
                                                states.data(), flags))) {
        FUZZ_REQUIRE(untouched(v, states));
        return;
    }
    for (int64_t i = 0; i < n; ++i) {
        const Batch one{1,
                        flags,
                        {params[static_cast<size_t>(i / counts[1])],
                         params[static_cast<size_t>(counts[0] + i % counts[1])]}};
        std::vector<Values> single = arrays(1, {3, 3, 3, 3});
        States state(1, -7);
        FUZZ_REQUIRE(surface_call(g, one, single, state) == NURBS_OK);
        FUZZ_REQUIRE(state[0] == states[static_cast<size_t>(i)]);
        for (size_t k = 0; k < 4; ++k) {
            FUZZ_REQUIRE(fuzz::same_bits(single[k].data(), v[k].data() + 3 * i, 3));
        }
    }
}

void curves(const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    const int dim = s.dim, space = dim == 3 ? 1 : 0;
    std::vector<Values> v;
    States states;
    if (!same_alone(g, b, 1, {dim, dim, dim, 3 * space, 1, space}, curve_call, v, states)) {
        return;
    }
    for (size_t i = 0; i < states.size() && ordinary(s); ++i) {
        const double *t = v[1].data() + i * static_cast<size_t>(dim);
        const double *n = v[2].data() + i * static_cast<size_t>(dim);
        if ((states[i] & NURBS_FRAME_UNDEFINED) != 0) {
            FUZZ_REQUIRE(std::isnan(t[0]));
        } else {
            FUZZ_REQUIRE(is_unit(t, dim) && is_unit(n, dim) && std::fabs(dot(t, n, dim)) < 1e-12);
        }
    }
}

void sequences(Input &in, const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    const std::array<double, 3> first{in.number(), in.rarely() ? in.anything() : in.number(), in.number()};
    std::vector<Values> v = arrays(b.n, {3, 3, 3, 3});
    States states(static_cast<size_t>(b.n), -7);
    if (!FUZZ_OK(nurbs_curve_rotation_minimizing_frames(
            g, b.n, b.params.data(), 0, in.coin() ? first.data() : nullptr, v[0].data(), 0, 0, v[1].data(), 0,
            0, v[2].data(), 0, 0, v[3].data(), 0, 0, states.data(), b.flags))) {
        FUZZ_REQUIRE(untouched(v, states));
        return;
    }
    for (size_t i = 0; i < states.size() && ordinary(s); ++i) {
        const double *t = v[1].data() + 3 * i, *n = v[2].data() + 3 * i;
        if (states[i] == NURBS_FRAME_UNDEFINED) {
            FUZZ_REQUIRE(std::isnan(t[0]) && std::isnan(n[0]));
        } else {
            FUZZ_REQUIRE(is_unit(t, 3) && is_unit(n, 3) && std::fabs(dot(t, n, 3)) < 1e-12);
        }
    }
}

// Sizes and strides that cannot be served, and splines of the wrong kind.
void refusals(Input &in, const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    std::vector<Values> v = arrays(std::max<int64_t>(b.n, 1), {4, 4, 4, 4, 1, 1});
    States states(static_cast<size_t>(std::max<int64_t>(b.n, 1)), -7);
    const Batch bad{in.bad_size(), b.flags, b.params};
    FUZZ_REQUIRE(!FUZZ_OK(surface_call(g, bad, v, states)));
    FUZZ_REQUIRE(!FUZZ_OK(curvature_call(g, bad, v, states)));
    FUZZ_REQUIRE(!FUZZ_OK(curve_call(g, bad, v, states)));
    FUZZ_REQUIRE(s.axes() == 2 || !FUZZ_OK(surface_call(g, b, v, states)));
    FUZZ_REQUIRE(s.axes() == 1 || !FUZZ_OK(curve_call(g, b, v, states)));
    FUZZ_REQUIRE(untouched(v, states));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const int wanted = 1 + in.below(2);
    fuzz::Spline s = fuzz::any_spline(in);
    if (s.axes() != wanted && !in.rarely()) {
        return 0;
    }
    if (s.dim != 3 && in.below(4) != 0) { // mostly in space
        s.dim = 3;
        if (s.total <= 4096) {
            fuzz::fill_values(in, s, in.coin());
        }
    }
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    Batch b{in.below(6), 0, {}};
    const bool inside = in.coin();
    b.flags = inside ? 0 : fuzz::any_flags(in, s.axes());
    b.params = fuzz::any_params(in, g.get(), s.axes(), b.n, inside);
    refusals(in, g.get(), s, b);
    if (s.axes() == 2 && s.dim == 3) {
        surfaces(g.get(), s, b);
        grids(in, g.get(), b.flags);
    }
    if (s.axes() == 1 && (s.dim == 2 || s.dim == 3)) {
        curves(g.get(), s, b);
    }
    if (s.axes() == 1 && s.dim == 3) {
        sequences(in, g.get(), s, b);
    }
    return 0;
}
