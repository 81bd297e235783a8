// Lengths, divisions, areas and moments: finite where they succeed, additive, in order.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

double any_tolerance(Input &in) {
    static constexpr double usual[] = {1e-2, 1e-2, 1e-3, 1e-4};
    return in.rarely() ? in.anything() : usual[in.below(4)];
}

bool finite(const double *x, int n) {
    return std::all_of(x, x + n, [](double value) { return std::isfinite(value); });
}

std::vector<double> any_range(Input &in, const nurbs *g, int axes) {
    std::vector<double> range;
    for (int k = 0; k < axes; ++k) {
        range.push_back(fuzz::any_param(in, g, k, !in.rarely()));
        range.push_back(fuzz::any_param(in, g, k, !in.rarely()));
        std::sort(range.end() - 2, range.end());
    }
    return range;
}

void lengths(Input &in, const nurbs *g) {
    const double tolerance = any_tolerance(in);
    const std::vector<double> range = any_range(in, g, 1);
    double whole = -1, part = -1, error = -1;
    if (!FUZZ_OK(nurbs_curve_length(g, nullptr, tolerance, &whole, &error))) {
        return;
    }
    FUZZ_REQUIRE(std::isfinite(whole) && whole >= 0 && error >= 0);
    if (FUZZ_OK(nurbs_curve_length(g, range.data(), tolerance, &part, nullptr))) {
        const bool anything = std::isinf(4 * tolerance);
        FUZZ_REQUIRE(part >= 0 && (anything || part <= whole * (1 + 4 * tolerance + 1e-9) + 4 * error));
    }
}

void inverses(Input &in, const nurbs *g) {
    const int n = 1 + in.below(4), stride = 1 + in.below(2);
    std::vector<double> params = fuzz::any_params(in, g, 1, n, !in.rarely());
    std::vector<double> out(static_cast<size_t>(n * stride)), again(static_cast<size_t>(n));
    if (!FUZZ_OK(nurbs_curve_lengths(g, n, params.data(), 1, any_tolerance(in), out.data(), stride))) {
        return;
    }
    for (int i = 0; i < n; ++i) {
        FUZZ_REQUIRE(out[static_cast<size_t>(i * stride)] >= 0);
    }
    double domain[2];
    FUZZ_REQUIRE(nurbs_domain(g, 0, domain) == NURBS_OK);
    if (FUZZ_OK(nurbs_curve_params_at_lengths(g, n, out.data(), stride, 1e-3, again.data(), 1, 0))) {
        for (const double t : again) {
            FUZZ_REQUIRE(t >= domain[0] && t <= domain[1]);
        }
    }
}

void divisions(Input &in, const nurbs *g) {
    const int64_t parts = in.rarely() ? in.bad_size() : 1 + in.below(6);
    const std::vector<double> range = any_range(in, g, 1);
    std::vector<double> params(parts > 0 && parts < 7 ? static_cast<size_t>(parts) + 1 : 0);
    const uint32_t flags = in.coin() ? NURBS_EQUAL_CHORDS : 0;
    double size = -1;
    if (parts < 7 && FUZZ_OK(nurbs_curve_divide(g, in.coin() ? range.data() : nullptr, parts,
                                                any_tolerance(in), flags, params.data(), &size))) {
        FUZZ_REQUIRE(std::is_sorted(params.begin(), params.end()) && size >= 0);
    }
}

void areas(Input &in, const nurbs *g, int axes) {
    const std::vector<double> range = any_range(in, g, axes);
    double area = -1, error = -1;
    if (FUZZ_OK(nurbs_surface_area(g, axes > 1 && in.coin() ? range.data() : nullptr, any_tolerance(in),
                                   &area, &error))) {
        FUZZ_REQUIRE(std::isfinite(area) && area >= 0 && error >= 0);
    }
}

void bodies(Input &in, const nurbs *g, int dim) {
    double content = -1, error = -1, open = -1;
    std::vector<double> centroid(static_cast<size_t>(dim)), inertia(static_cast<size_t>(dim * dim));
    const bool all = in.coin();
    if (FUZZ_OK(nurbs_moments(g, any_tolerance(in), &content, all ? centroid.data() : nullptr,
                              all ? inertia.data() : nullptr, &error))) {
        FUZZ_REQUIRE(content >= 0 && finite(centroid.data(), dim) && finite(inertia.data(), dim * dim));
    }
    const nurbs *list[] = {g, g};
    const int64_t count = 1 + in.below(2);
    if (FUZZ_OK(nurbs_enclosed_area(count, list, in.coin() ? 1e9 : 1e-6, any_tolerance(in), &content, nullptr,
                                    nullptr, &error))) {
        FUZZ_REQUIRE(std::isfinite(content) && error >= 0);
    }
    if (FUZZ_OK(nurbs_enclosed_volume(count, list, any_tolerance(in), &content, nullptr, nullptr, &open,
                                      &error))) {
        FUZZ_REQUIRE(std::isfinite(content) && open >= 0 && error >= 0);
    }
}

// Points lie in the domain, and their weights add up to its size.
void rules(Input &in, const nurbs *g, int axes) {
    const int32_t nodes = in.rarely() ? in.bad_int() : in.below(5);
    int64_t count = -1;
    if (!FUZZ_OK(nurbs_quadrature(g, nodes, 0, nullptr, nullptr, nullptr, &count)) || count > 4000) {
        return;
    }
    FUZZ_REQUIRE(nodes >= 0 && nodes <= 64 && count > 0);
    const auto n = static_cast<size_t>(count);
    std::vector<double> params(n * static_cast<size_t>(axes)), weights(n), measures(n);
    if (!FUZZ_OK(
            nurbs_quadrature(g, nodes, count, params.data(), weights.data(), measures.data(), nullptr))) {
        return;
    }
    double sum = 0, size = 1;
    for (size_t i = 0; i < n; ++i) {
        FUZZ_REQUIRE(weights[i] >= 0 && measures[i] >= 0);
        sum += weights[i];
    }
    for (int k = 0; k < axes; ++k) {
        double domain[2];
        FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
        size *= domain[1] - domain[0];
        for (size_t i = 0; i < n; ++i) {
            const double t = params[i * static_cast<size_t>(axes) + static_cast<size_t>(k)];
            FUZZ_REQUIRE(domain[0] <= t && t < domain[1]);
        }
    }
    FUZZ_REQUIRE(!(size < 1e300 && size > 1e-280) || std::fabs(sum - size) <= 1e-9 * size);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    lengths(in, g.get());
    inverses(in, g.get());
    divisions(in, g.get());
    areas(in, g.get(), s.axes());
    bodies(in, g.get(), s.dim);
    rules(in, g.get(), s.axes());
    return 0;
}
