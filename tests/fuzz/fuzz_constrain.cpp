// Constraints: what a call says holds, does, and a refused one writes nothing.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Arguments {
    int64_t count = 0;
    std::vector<int32_t> kinds;
    std::vector<int32_t> orders;
    std::vector<int32_t> keep;
    std::vector<double> params;
    std::vector<double> targets;
    std::vector<double> costs;
    std::vector<double> weight_costs;
    double tolerance = 0;
};

std::vector<double> any_costs(Input &in, int64_t n) {
    std::vector<double> costs;
    for (int64_t i = 0; i < n; ++i) {
        costs.push_back(in.rarely() ? in.anything() : in.below(8) == 0 ? HUGE_VAL : in.unit() + 0.01);
    }
    return costs;
}

Arguments any_arguments(Input &in, const nurbs *g, const fuzz::Spline &s) {
    Arguments a;
    a.count = 1 + in.below(4);
    a.params = fuzz::any_params(in, g, s.axes(), a.count, !in.rarely());
    for (int64_t i = 0; i < a.count; ++i) {
        const int32_t kind = in.rarely() ? in.bad_int() : in.coin() ? NURBS_CONSTRAIN_VALUE : in.below(4);
        a.kinds.push_back(kind);
        for (int k = 0; k < s.axes(); ++k) {
            a.orders.push_back(in.rarely() ? in.bad_int()
                               : kind == NURBS_CONSTRAIN_NORMAL || kind == NURBS_CONSTRAIN_CURVATURE
                                   ? 0
                                   : in.below(3));
        }
        for (int32_t c = 0; c < s.dim; ++c) {
            a.targets.push_back(in.rarely() ? in.anything() : in.number());
        }
    }
    for (int i = 0; i < 2 * s.axes(); ++i) {
        a.keep.push_back(in.rarely() ? in.bad_int() : in.below(3) - 1);
    }
    a.costs = any_costs(in, s.total);
    a.weight_costs = any_costs(in, s.total);
    a.tolerance = in.rarely() ? in.anything() : in.coin() ? 0 : in.unit();
    return a;
}

// How far points are missed, as the evaluator sees it.
void check_values(const nurbs *h, const fuzz::Spline &s, const Arguments &a, bool orders) {
    for (int64_t i = 0; i < a.count; ++i) {
        const auto first = a.orders.begin() + i * s.axes();
        const bool point = std::all_of(first, first + s.axes(), [](int32_t order) { return order == 0; });
        if (a.kinds[static_cast<size_t>(i)] != NURBS_CONSTRAIN_VALUE || (orders && !point)) {
            continue;
        }
        std::vector<double> at(static_cast<size_t>(s.dim)), hull(1);
        const double *param = a.params.data() + i * s.axes();
        FUZZ_REQUIRE(nurbs_eval(h, 1, param, 0, 0, at.data(), 0, 0, 0) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_hull_size(h, 1, param, 0, 0, hull.data(), 0, 0) == NURBS_OK);
        double missed = 0, target = 0;
        for (size_t c = 0; c < at.size(); ++c) {
            const double wanted = a.targets[static_cast<size_t>(i * s.dim) + c];
            missed = std::hypot(missed, at[c] - wanted);
            target = std::hypot(target, wanted);
        }
        const double rounding = 4 * (64 + fuzz::accuracy(s.degrees)) * fuzz::eps * (4 * hull[0] + target);
        FUZZ_REQUIRE(missed <= a.tolerance * (1 + 1e-9) + rounding);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    int64_t active = 1;
    for (const int32_t p : s.degrees) {
        active *= p + 1;
    }
    if (!g || s.total > 200 || active > 100) {
        return 0;
    }
    const Arguments a = any_arguments(in, g.get(), s);
    const bool orders = in.coin(), costs = in.coin(), weights = in.below(4) == 0;
    std::vector<double> residuals(static_cast<size_t>(a.count), -7.0);
    int64_t rank = -7;
    double moved = -7, optimality = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_constrain(g.get(), a.count, a.kinds.data(), orders ? a.orders.data() : nullptr, a.params.data(),
                        a.targets.data(), in.coin() ? a.keep.data() : nullptr,
                        costs ? a.costs.data() : nullptr, weights ? a.weight_costs.data() : nullptr,
                        a.tolerance, residuals.data(), &rank, &moved, &optimality, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h) {
        // Equations may have no unknowns: those of weights without effect, or that a derivative of degree 0
        // meets.
        FUZZ_REQUIRE(rank >= 0 && moved >= 0 && optimality <= 1e-6);
        const double ratio = s.weight_ratio();
        if (ratio > 0 && ratio < 1e6) {
            check_values(h.get(), s, a, orders);
        }
    } else {
        FUZZ_REQUIRE(rank == -7 && moved == -7 && residuals[0] == -7);
    }
    return 0;
}
