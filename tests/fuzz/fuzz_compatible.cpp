// Knots snapped together and splines made compatible: domains stay, and a set has one knot vector.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

double any_tolerance(Input &in) {
    return in.rarely() ? in.anything() : in.below(3) * in.unit() * std::ldexp(1.0, -in.below(40));
}

void check_domain(const nurbs *a, const nurbs *b, int32_t axis) {
    double before[2], after[2];
    FUZZ_REQUIRE(nurbs_domain(a, axis, before) == NURBS_OK && nurbs_domain(b, axis, after) == NURBS_OK);
    FUZZ_REQUIRE(before[0] == after[0] && before[1] == after[1]);
}

void snap(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    double deviation = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_snap_knots(g, axis, any_tolerance(in), &deviation, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? deviation >= 0 : deviation == -7);
    if (h) {
        check_domain(g, h.get(), axis);
    }
}

// Two splines and one with more knots; the domains of the first rule.
void compatible(Input &in, const nurbs *g, const nurbs *other, const fuzz::Spline &s) {
    nurbs *out = fuzz::poison();
    const double knot = fuzz::any_param(in, g, 0, true);
    const nurbs_status status = nurbs_insert_knot(g, 0, knot, 1, &out);
    const fuzz::Handle finer(FUZZ_MADE(status, out));
    const nurbs *splines[] = {g, finer ? finer.get() : g, other != nullptr && in.coin() ? other : g};
    nurbs_list *list = nullptr;
    if (!FUZZ_OK(nurbs_make_compatible(in.rarely() ? in.bad_size() < 0 : 3, splines, any_tolerance(in),
                                       in.coin() ? NURBS_MAP_DOMAINS : static_cast<uint32_t>(in.below(2)),
                                       nullptr, &list))) {
        FUZZ_REQUIRE(list == nullptr);
        return;
    }
    int64_t members = 0;
    FUZZ_REQUIRE(nurbs_list_count(list, &members) == NURBS_OK);
    nurbs *first = fuzz::poison(), *last = fuzz::poison();
    const nurbs_status got_first = nurbs_list_get(list, 0, &first);
    const nurbs_status got_last = nurbs_list_get(list, members - 1, &last);
    const fuzz::Handle a(FUZZ_MADE(got_first, first)), b(FUZZ_MADE(got_last, last));
    for (int32_t k = 0; k < s.axes32(); ++k) {
        int64_t left = 0, right = 0;
        FUZZ_REQUIRE(nurbs_count(a.get(), k, &left) == NURBS_OK &&
                     nurbs_count(b.get(), k, &right) == NURBS_OK);
        FUZZ_REQUIRE(left == right);
        check_domain(g, b.get(), k);
    }
    nurbs_list_destroy(list);
}

void smoothness(Input &in, const nurbs *g, const nurbs *other, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    int64_t count = -7;
    if (!FUZZ_OK(nurbs_continuity(g, axis, any_tolerance(in), any_tolerance(in), any_tolerance(in), 0,
                                  nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &count))) {
        FUZZ_REQUIRE(count == -7);
        return;
    }
    std::vector<int32_t> orders(static_cast<size_t>(count)), knot_orders(static_cast<size_t>(count));
    const int64_t cap = in.rarely() ? in.bad_size() : count;
    if (cap >= 0 && cap <= count &&
        FUZZ_OK(nurbs_continuity(g, axis, 0, 0, 0, cap, nullptr, knot_orders.data(), orders.data(), nullptr,
                                 nullptr, nullptr, nullptr, nullptr))) {
        for (const int32_t order : orders) {
            FUZZ_REQUIRE(order >= -1 && order <= NURBS_MAX_DEGREE);
        }
    }
    if (other != nullptr) {
        int32_t order = -7;
        FUZZ_OK(nurbs_continuity_between(g, in.below(3), other, in.below(2), 0, 0, 0, &order, nullptr,
                                         nullptr, nullptr, nullptr));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in), t = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s)), h(fuzz::create(t));
    if (g && s.total <= 200 && t.total <= 200) {
        snap(in, g.get(), s);
        compatible(in, g.get(), h.get(), s);
        smoothness(in, g.get(), h.get(), s);
    }
    return 0;
}
