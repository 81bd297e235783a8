// Evaluation: points stay in the hull of their control points, and one parameter gives the same bits alone,
// in a batch, with derivatives and on a grid.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Batch {
    int64_t n;
    uint32_t flags;
    bool inside; // all parameters in the domain and no flag but the side: cannot fail
    std::vector<double> params;
};

Batch any_batch(Input &in, const nurbs *g, int axes) {
    Batch b{in.below(6), 0, in.coin(), {}};
    b.flags = b.inside ? (in.coin() ? NURBS_ON_ALL_AXES(axes, NURBS_LEFT) : 0) : fuzz::any_flags(in, axes);
    b.params = fuzz::any_params(in, g, axes, b.n, b.inside);
    return b;
}

bool untouched(const std::vector<double> &values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return v == -7; });
}

// |C(t)| <= hull (1 + c eps): the accuracy contract, and the convex hull property.
void in_the_hull(const nurbs *g, const fuzz::Spline &s, const Batch &b, const std::vector<double> &points) {
    std::vector<double> hull(static_cast<size_t>(b.n));
    FUZZ_REQUIRE(nurbs_hull_size(g, b.n, b.params.data(), 0, 0, hull.data(), 0, b.flags) == NURBS_OK);
    const auto dim = static_cast<size_t>(s.dim);
    for (size_t i = 0; i < points.size(); ++i) {
        FUZZ_REQUIRE(std::isfinite(points[i]));
        FUZZ_REQUIRE(std::fabs(points[i]) <= hull[i / dim] * (1 + fuzz::accuracy(s.degrees) * fuzz::eps));
    }
}

// Checks all ways to one point; returns the points, or nothing if the batch is refused.
std::vector<double> points(const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    const auto dim = static_cast<size_t>(s.dim), axes = static_cast<size_t>(s.axes());
    std::vector<double> batch(static_cast<size_t>(b.n) * dim, -7), single(dim);
    if (!FUZZ_OK(nurbs_eval(g, b.n, b.params.data(), 0, 0, batch.data(), 0, 0, b.flags))) {
        FUZZ_REQUIRE(!b.inside && untouched(batch));
        return {};
    }
    for (size_t i = 0; i < static_cast<size_t>(b.n); ++i) {
        FUZZ_REQUIRE(nurbs_eval(g, 1, b.params.data() + i * axes, 0, 0, single.data(), 0, 0, b.flags) ==
                     NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(single.data(), batch.data() + i * dim, dim));
    }
    if (b.inside) {
        in_the_hull(g, s, b, batch);
    }
    return batch;
}

std::vector<double> derivatives(const nurbs *g, const fuzz::Spline &s, const Batch &b, int32_t order) {
    int64_t slots = 0;
    FUZZ_REQUIRE(nurbs_derivative_slots(s.axes32(), order, &slots) == NURBS_OK);
    std::vector<double> derivs(static_cast<size_t>(b.n * slots * s.dim), -7);
    if (!FUZZ_OK(nurbs_eval_derivs(g, order, b.n, b.params.data(), 0, 0, derivs.data(), 0, 0, b.flags))) {
        FUZZ_REQUIRE(!b.inside && untouched(derivs));
        return {};
    }
    return derivs;
}

void derivative_zero_is_the_point(const fuzz::Spline &s, int64_t n, const std::vector<double> &batch,
                                  const std::vector<double> &derivs) {
    FUZZ_REQUIRE(batch.empty() == derivs.empty() || n == 0);
    const auto dim = static_cast<size_t>(s.dim);
    for (size_t i = 0; !batch.empty() && i < static_cast<size_t>(n); ++i) {
        FUZZ_REQUIRE(fuzz::same_bits(derivs.data() + derivs.size() / static_cast<size_t>(n) * i,
                                     batch.data() + dim * i, dim));
    }
}

struct Grid {
    std::vector<int64_t> counts;
    std::vector<double> params;
    int64_t total = 1;
};

// The same points, rounded.
void single_precision(const nurbs *g, const Batch &b, const std::vector<double> &points, size_t size) {
    std::vector<float> rounded(size, -7);
    const bool ok = FUZZ_OK(nurbs_eval_f32(g, b.n, b.params.data(), 0, 0, rounded.data(), 0, 0, b.flags));
    FUZZ_REQUIRE(size == 0 || ok == !points.empty());
    for (size_t i = 0; i < size; ++i) {
        const auto wanted = ok ? static_cast<float>(points[i]) : -7.0F;
        FUZZ_REQUIRE(rounded[i] == wanted || (std::isnan(rounded[i]) && std::isnan(wanted)));
    }
}

Grid any_grid(Input &in, const nurbs *g, int axes, bool inside) {
    Grid grid;
    for (int32_t k = 0; k < axes; ++k) {
        grid.counts.push_back(in.rarely() ? 0 : 1 + in.below(3));
        grid.total *= grid.counts.back();
        for (int64_t i = 0; i < grid.counts.back(); ++i) {
            grid.params.push_back(fuzz::any_param(in, g, k, inside));
        }
    }
    return grid;
}

std::vector<double> grid_point(const Grid &grid, int64_t index) {
    std::vector<double> param(grid.counts.size());
    auto end = static_cast<int64_t>(grid.params.size());
    for (size_t k = param.size(); k-- > 0;) {
        end -= grid.counts[k];
        param[k] = grid.params[static_cast<size_t>(end + index % grid.counts[k])];
        index /= grid.counts[k];
    }
    return param;
}

void grids(Input &in, const nurbs *g, const fuzz::Spline &s, int32_t order) {
    const bool inside = in.coin();
    const Grid grid = any_grid(in, g, s.axes(), inside);
    const uint32_t flags = inside ? 0 : fuzz::any_flags(in, s.axes());
    int64_t slots = 0;
    FUZZ_REQUIRE(nurbs_derivative_slots(s.axes32(), order, &slots) == NURBS_OK);
    const auto dim = static_cast<size_t>(s.dim), width = static_cast<size_t>(slots) * dim;
    const auto total = static_cast<size_t>(grid.total);
    std::vector<double> values(total * dim, -7), derivs(total * width, -7), one(width);
    const bool ok =
        FUZZ_OK(nurbs_eval_grid(g, grid.counts.data(), grid.params.data(), values.data(), 0, 0, flags));
    FUZZ_REQUIRE(ok == FUZZ_OK(nurbs_eval_grid_derivs(g, order, grid.counts.data(), grid.params.data(),
                                                      derivs.data(), 0, 0, flags)));
    FUZZ_REQUIRE(ok || (!inside && untouched(values) && untouched(derivs)));
    std::vector<float> rounded(values.size(), -7);
    FUZZ_REQUIRE(ok == FUZZ_OK(nurbs_eval_grid_f32(g, grid.counts.data(), grid.params.data(), rounded.data(),
                                                   0, 0, flags)));
    for (size_t i = 0; i < values.size(); ++i) {
        const auto wanted = static_cast<float>(values[i]);
        FUZZ_REQUIRE(rounded[i] == wanted || (std::isnan(rounded[i]) && std::isnan(wanted)));
    }
    for (size_t i = 0; ok && i < total; ++i) {
        const std::vector<double> param = grid_point(grid, static_cast<int64_t>(i));
        FUZZ_REQUIRE(nurbs_eval_derivs(g, order, 1, param.data(), 0, 0, one.data(), 0, 0, flags) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(derivs.data() + i * width, one.data(), width));
        FUZZ_REQUIRE(fuzz::same_bits(values.data() + i * dim, one.data(), dim));
    }
}

// An iso-curve passes through the surface: two evaluations and one contraction, each within c eps of the
// hull. Stored coordinates of a rational result are divided by weights once and multiplied again, a ratio of
// weights at most.
void check_iso(Input &in, const nurbs *g, const fuzz::Spline &s, const nurbs *slice, int axis, double fixed) {
    std::vector<double> param, rest, a(static_cast<size_t>(s.dim)), b(a);
    for (int32_t k = 0; k < s.axes32(); ++k) {
        param.push_back(k == axis ? fixed : fuzz::any_param(in, g, k, true));
        if (k != axis) {
            rest.push_back(param.back());
        }
    }
    FUZZ_REQUIRE(nurbs_eval(g, 1, param.data(), 0, 0, a.data(), 0, 0, 0) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_eval(slice, 1, rest.data(), 0, 0, b.data(), 0, 0, 0) == NURBS_OK);
    const double ratio = s.weight_ratio();
    const double bound = (3 * fuzz::accuracy(s.degrees) + 8) * fuzz::eps * s.size() * ratio;
    for (size_t c = 0; ratio > 0 && c < a.size(); ++c) {
        FUZZ_REQUIRE(std::fabs(a[c] - b[c]) <= bound);
    }
}

void iso(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const bool sane = axis >= 0 && axis < s.axes();
    const bool inside = in.coin();
    const double fixed = sane ? fuzz::any_param(in, g, axis, inside) : in.anything();
    const uint32_t flags = inside ? 0 : fuzz::any_flags(in, 1);
    nurbs *out = fuzz::poison();
    const fuzz::Handle slice(FUZZ_MADE(nurbs_iso(g, axis, fixed, flags, &out), out));
    FUZZ_REQUIRE(!slice || (sane && s.axes() > 1));
    FUZZ_REQUIRE(slice || !inside || !sane || s.axes() == 1);
    if (slice && inside) {
        check_iso(in, g, s, slice.get(), axis, fixed);
    }
}

// Sizes and strides that cannot be served leave the output alone.
void bad_sizes(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), 2, true);
    std::vector<double> out(static_cast<size_t>(2 * s.dim), -7);
    const int64_t bad = in.bad_size();
    std::vector<int64_t> counts(s.degrees.size(), 1);
    counts[static_cast<size_t>(in.below(s.axes()))] = bad;
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_eval(g, bad, params.data(), 0, 0, out.data(), 0, 0, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_eval(g, 2, params.data(), bad, 0, out.data(), 0, 0, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_eval(g, 2, params.data(), 0, 0, out.data(), bad, 0, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_eval_derivs(g, in.bad_int(), 2, params.data(), 0, 0, out.data(), 0, 0, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_eval_grid(g, counts.data(), params.data(), out.data(), 0, 0, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_eval_grid_derivs(g, 0, counts.data(), params.data(), out.data(), 0, 0, 0)));
    FUZZ_REQUIRE(untouched(out));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    const Batch b = any_batch(in, g.get(), s.axes());
    const int32_t order = in.below(s.axes() == 3 ? 3 : 6);
    const std::vector<double> values = points(g.get(), s, b);
    derivative_zero_is_the_point(s, b.n, values, derivatives(g.get(), s, b, order));
    single_precision(g.get(), b, values, static_cast<size_t>(b.n * s.dim));
    grids(in, g.get(), s, order);
    iso(in, g.get(), s);
    bad_sizes(in, g.get(), s);
    return 0;
}
