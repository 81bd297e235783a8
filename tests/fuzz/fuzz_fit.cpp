// Interpolation: points come back, mistakes are told, and nothing is written by a refused call.
#include "fuzz/harness.h"

#include <cmath>
#include <cstddef>

using fuzz::Input;

namespace {

// Points on a grid with parameters that mostly increase, and strides.
struct Grid {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> params, points;
    int32_t dim = 1;
    uint32_t flags = 0;

    [[nodiscard]] int32_t axes() const { return static_cast<int32_t>(counts.size()); }
};

// A layer that repeats the first one ends each periodic axis, if all is well.
void close(Grid &grid, size_t k, Input &in) {
    if (in.rarely()) {
        return;
    }
    size_t inner = static_cast<size_t>(grid.dim), outer = 1;
    for (size_t i = 0; i < grid.counts.size(); ++i) {
        (i < k ? outer : inner) *= i == k ? 1 : static_cast<size_t>(grid.counts[i]);
    }
    const auto count = static_cast<size_t>(grid.counts[k]);
    for (size_t o = 0; o < outer; ++o) {
        double *const first = grid.points.data() + o * count * inner;
        std::copy_n(first, inner, first + (count - 1) * inner);
    }
}

Grid any_grid(Input &in) {
    Grid grid;
    grid.dim = 1 + in.below(3);
    const int axes = 1 + in.below(3) * in.below(2);
    size_t total = static_cast<size_t>(grid.dim);
    for (int k = 0; k < axes; ++k) {
        const int degree = in.below(axes == 1 ? 12 : 5);
        grid.degrees.push_back(degree);
        grid.counts.push_back(1 + in.below(axes == 1 ? 20 : 7));
        total *= static_cast<size_t>(grid.counts.back());
        double t = in.number();
        for (int64_t i = 0; i < grid.counts.back(); ++i) {
            grid.params.push_back(t);
            t += in.rarely() ? in.number() : 0.01 + in.unit();
        }
        grid.flags |= in.below(4) == 0 ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
    }
    for (size_t i = 0; i < total; ++i) {
        grid.points.push_back(in.rarely() ? in.anything() : in.number());
    }
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        if ((grid.flags & NURBS_ON_AXIS(k, NURBS_PERIODIC)) != 0) {
            close(grid, k, in);
        }
    }
    return grid;
}

void parametrize(Input &in, const Grid &grid) {
    std::vector<double> params(grid.params.size(), -7);
    const int32_t rule = in.rarely() ? in.bad_int() : in.below(5);
    const double exponent = in.rarely() ? in.anything() : in.unit();
    if (!FUZZ_OK(nurbs_parametrize(grid.axes(), grid.counts.data(), grid.dim, grid.points.data(), 0, 0, rule,
                                   exponent, grid.flags, params.data()))) {
        FUZZ_REQUIRE(std::all_of(params.begin(), params.end(), [](double t) { return t == -7; }));
        return;
    }
    size_t at = 0;
    for (const int64_t count : grid.counts) {
        FUZZ_REQUIRE(params[at] == 0 && (count == 1 || params[at + static_cast<size_t>(count) - 1] == 1));
        FUZZ_REQUIRE(std::is_sorted(params.begin() + static_cast<std::ptrdiff_t>(at),
                                    params.begin() + static_cast<std::ptrdiff_t>(at) + count));
        at += static_cast<size_t>(count);
    }
}

void universal(Input &in) {
    std::vector<double> params(40, -7);
    const int32_t degree = in.rarely() ? in.bad_int() : in.below(33);
    const int64_t count = in.rarely() ? in.bad_size() : in.below(40);
    if (FUZZ_OK(nurbs_params_universal(degree, count, params.data()))) {
        FUZZ_REQUIRE(std::is_sorted(params.begin(), params.begin() + count));
    } else {
        FUZZ_REQUIRE(std::all_of(params.begin(), params.end(), [](double t) { return t == -7; }));
    }
}

void tangents(Input &in, const Grid &grid) {
    std::vector<double> made(grid.points.size(), -7);
    const int32_t rule = in.rarely() ? in.bad_int() : in.below(4);
    const bool ok = FUZZ_OK(nurbs_tangents(rule, grid.counts[0], grid.params.data(), grid.dim,
                                           grid.points.data(), 0, 0, grid.flags, made.data(), 0, 0));
    FUZZ_REQUIRE(std::all_of(made.begin(), made.end(), [ok](double x) { return ok || x == -7; }));
}

void interpolate(Input &in, const Grid &grid) {
    std::vector<int32_t> ends;
    for (int i = 0; i < 2 * grid.axes(); ++i) {
        ends.push_back(in.rarely() ? in.bad_int() : in.below(3));
    }
    double residual = -7;
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(
        FUZZ_MADE(nurbs_interpolate(grid.axes(), grid.degrees.data(), grid.counts.data(), grid.params.data(),
                                    grid.dim, grid.points.data(), 0, 0, in.coin() ? ends.data() : nullptr,
                                    grid.flags, &residual, &out),
                  out));
    FUZZ_REQUIRE(made ? residual >= 0 : residual == -7);
}

// Some layers turned into derivatives, and some values into what may be unknown.
void derivatives(Input &in, Grid grid) {
    std::vector<int32_t> orders(grid.params.size(), 0);
    size_t first = 0;
    for (const int64_t count : grid.counts) {
        const size_t last = first + static_cast<size_t>(count) - 1;
        if (count > 2 && in.coin()) {
            grid.params[first + 1] = grid.params[first];
            orders[first + 1] = in.rarely() ? in.bad_int() : 1 + in.below(3);
        }
        if (count > 3 && in.coin()) {
            grid.params[last] = grid.params[last - 1];
            orders[last] = in.rarely() ? in.bad_int() : 1 + in.below(3);
        }
        first = last + 1;
    }
    for (double &value : grid.points) {
        value = in.rarely() ? std::nan("") : value;
    }
    std::vector<int32_t> ends;
    for (int i = 0; i < 2 * grid.axes(); ++i) {
        ends.push_back(in.rarely() ? in.below(3) : 0);
    }
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(FUZZ_MADE(
        nurbs_interpolate_derivatives(grid.axes(), grid.degrees.data(), grid.counts.data(),
                                      grid.params.data(), in.rarely() ? nullptr : orders.data(), grid.dim,
                                      grid.points.data(), 0, 0, in.coin() ? ends.data() : nullptr,
                                      in.rarely() ? grid.flags : 0, &out),
        out));
}

void over_knots(Input &in, const Grid &grid) {
    std::vector<double> knots;
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        const int64_t total = grid.counts[k] + grid.degrees[k] + 1;
        double t = in.number();
        for (int64_t i = 0; i < total; ++i) {
            knots.push_back(t);
            t += in.below(3) == 0 ? 0 : in.unit();
        }
    }
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(FUZZ_MADE(
        nurbs_interpolate_over_knots(grid.axes(), grid.degrees.data(), grid.counts.data(), grid.params.data(),
                                     knots.data(), static_cast<int64_t>(knots.size()), grid.dim,
                                     grid.points.data(), 0, 0, in.rarely() ? grid.flags : 0, &out),
        out));
}

// Lengths of directions are told, or nothing is written; the curve has no fewer mistakes than they.
void conditions(Input &in, const Grid &grid) {
    const int64_t n = grid.counts[0];
    std::vector<int32_t> orders;
    std::vector<double> params;
    for (int64_t i = 0; i < n; ++i) {
        const bool again = i > 0 && in.coin();
        params.push_back(again ? params.back() : grid.params[static_cast<size_t>(i)]);
        orders.push_back(in.rarely() ? in.bad_int() : again ? std::min(orders.back(), 40) + 1 : in.below(2));
    }
    for (int32_t &order : orders) {
        order = order == 1 && in.coin() ? NURBS_ORDER_DIRECTION : order;
    }
    const int32_t *const given = in.below(4) > 0 ? orders.data() : nullptr;
    const uint32_t flags = in.rarely() ? grid.flags : 0;
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(
        FUZZ_MADE(nurbs_curve_interpolate(grid.degrees[0], n, params.data(), given, grid.dim,
                                          grid.points.data(), 0, 0, nullptr, 0, flags, &out),
                  out));
    std::vector<double> lengths(static_cast<size_t>(n), -7);
    const bool told =
        FUZZ_OK(nurbs_tangent_lengths(grid.degrees[0], n, params.data(), given, grid.dim, grid.points.data(),
                                      0, 0, nullptr, 0, flags, lengths.data()));
    FUZZ_REQUIRE(told || !made);
    FUZZ_REQUIRE(std::all_of(lengths.begin(), lengths.end(),
                             [told](double length) { return told ? std::isfinite(length) : length == -7; }));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const Grid grid = any_grid(in);
    parametrize(in, grid);
    universal(in);
    tangents(in, grid);
    interpolate(in, grid);
    derivatives(in, grid);
    over_knots(in, grid);
    conditions(in, grid);
    return 0;
}
