// Splitting, extraction, decomposition, clamping, seams and joining: parts have the ends asked for, and join
// again.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

class List {
public:
    explicit List(nurbs_list *list) : list_(list) {}
    List(const List &) = delete;
    List &operator=(const List &) = delete;
    ~List() { nurbs_list_destroy(list_); }

    [[nodiscard]] int64_t count() const {
        int64_t n = 0;
        FUZZ_REQUIRE(nurbs_list_count(list_, &n) == NURBS_OK && n > 0);
        return n;
    }
    [[nodiscard]] nurbs *at(int64_t i) const {
        nurbs *g = fuzz::poison();
        return FUZZ_MADE(nurbs_list_get(list_, i, &g), g);
    }

private:
    nurbs_list *list_;
};

int32_t any_axis(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.bad_int() : in.below(s.axes());
}

bool exists(int32_t axis, const fuzz::Spline &s) {
    return axis >= 0 && axis < s.axes();
}

void check_domain(const nurbs *g, int32_t axis, double lower, double upper) {
    double domain[2];
    FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_OK && domain[0] == lower && domain[1] == upper);
}

// What was split joins again, with jumps where there were any, over the same domain.
void split(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s);
    const double t = in.rarely() ? in.anything() : fuzz::any_param(in, g, exists(axis, s) ? axis : 0, true);
    nurbs *below = fuzz::poison(), *above = fuzz::poison();
    const nurbs_status status = nurbs_split(g, axis, t, &below, &above);
    const fuzz::Handle lower(FUZZ_MADE(status, below)), upper(FUZZ_MADE(status, above));
    if (!lower) {
        return;
    }
    double domain[2];
    FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_OK);
    check_domain(lower.get(), axis, domain[0], t);
    check_domain(upper.get(), axis, t, domain[1]);
    const nurbs *parts[] = {lower.get(), upper.get()};
    nurbs *out = fuzz::poison();
    const nurbs_status joining = nurbs_join(2, parts, axis, 0, NURBS_KEEP_GAPS, nullptr, &out);
    const fuzz::Handle joined(FUZZ_MADE(joining, out));
    FUZZ_REQUIRE(joined || joining >= NURBS_ERROR_OUTSIDE_DOMAIN || joining == NURBS_ERROR_WEIGHTS_VANISH);
    if (joined) {
        check_domain(joined.get(), axis, domain[0], domain[1]);
    }
}

void extract(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> a = fuzz::any_params(in, g, s.axes(), 1, !in.rarely());
    const std::vector<double> b = fuzz::any_params(in, g, s.axes(), 1, true);
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_extract(g, a.data(), b.data(), &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    for (int32_t k = 0; h && k < s.axes32(); ++k) {
        check_domain(h.get(), k, a[static_cast<size_t>(k)], b[static_cast<size_t>(k)]);
    }
}

void arrays(const nurbs *g, const fuzz::Spline &s) {
    int64_t count = -7, along[3] = {-7, -7, -7};
    FUZZ_REQUIRE(nurbs_bezier_pieces(g, 0, nullptr, nullptr, nullptr, along, &count) == NURBS_OK);
    int64_t pieces = 1, points = 1;
    for (size_t k = 0; k < static_cast<size_t>(s.axes()); ++k) {
        pieces *= along[k];
        points *= s.degrees[k] + 1;
    }
    FUZZ_REQUIRE(count == pieces);
    const auto total = static_cast<size_t>(pieces * points);
    std::vector<double> nets(total * static_cast<size_t>(s.dim)), weights(total, -1);
    std::vector<double> domains(static_cast<size_t>(2 * s.axes() * pieces));
    if (!FUZZ_OK(
            nurbs_bezier_pieces(g, count, nets.data(), weights.data(), domains.data(), nullptr, &count))) {
        return;
    }
    for (size_t i = 0; i < domains.size(); i += 2) {
        FUZZ_REQUIRE(domains[i] < domains[i + 1]);
    }
    double domain[2];
    FUZZ_REQUIRE(nurbs_domain(g, 0, domain) == NURBS_OK && domain[0] == domains[0]);
}

void lists(Input &in, const nurbs *g, const fuzz::Spline &s) {
    nurbs_list *made = nullptr;
    if (FUZZ_OK(nurbs_decompose(g, &made))) {
        const List pieces(made);
        const fuzz::Handle piece(
            pieces.at(in.below(static_cast<int>(std::min<int64_t>(pieces.count(), 99)))));
        for (int32_t k = 0; k < s.axes32(); ++k) {
            int64_t count = 0;
            FUZZ_REQUIRE(nurbs_count(piece.get(), k, &count) == NURBS_OK);
            FUZZ_REQUIRE(count == s.degrees[static_cast<size_t>(k)] + 1);
        }
    }
    made = nullptr;
    const int32_t axis = any_axis(in, s), order = in.rarely() ? in.bad_int() : in.below(4);
    if (FUZZ_OK(nurbs_split_at_knots(g, axis, order, &made))) {
        const List parts(made);
        double domain[2], part[2];
        FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_OK);
        const fuzz::Handle last(parts.at(parts.count() - 1));
        FUZZ_REQUIRE(nurbs_domain(last.get(), axis, part) == NURBS_OK && part[1] == domain[1]);
    }
}

void ends(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s);
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_clamp_ends(g, axis, static_cast<uint32_t>(in.below(5)), &out);
    const fuzz::Handle clamped(FUZZ_MADE(status, out));
    nurbs *moved = fuzz::poison();
    const double t = in.rarely() ? in.anything() : fuzz::any_param(in, g, exists(axis, s) ? axis : 0, true);
    const nurbs_status moving = nurbs_move_seam(g, axis, t, &moved);
    const fuzz::Handle seam(FUZZ_MADE(moving, moved));
    if (seam) {
        int32_t form = 0;
        FUZZ_REQUIRE(nurbs_knot_form(seam.get(), axis, &form) == NURBS_OK &&
                     (form & NURBS_FORM_PERIODIC) != 0);
    }
}

// A spline behind itself, or behind a part of itself that may not suit.
void join(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const nurbs *parts[] = {g, g, in.rarely() ? nullptr : g};
    const double tolerance = in.rarely() ? in.anything() : in.below(3) * in.unit();
    double gap = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_join(in.below(4), parts, any_axis(in, s), tolerance,
                                           in.coin() ? NURBS_KEEP_GAPS : 0, &gap, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? gap >= 0 : gap == -7);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g && s.total <= 400) {
        split(in, g.get(), s);
        extract(in, g.get(), s);
        lists(in, g.get(), s);
        arrays(g.get(), s);
        ends(in, g.get(), s);
        join(in, g.get(), s);
    }
    return 0;
}
