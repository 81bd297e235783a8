// Knot insertion and refinement: the shape, the form and the input stay as they are.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Insertion {
    int32_t axis;
    double knot;
    int32_t times;
    bool sane; // axis, knot and times in their ranges; the multiplicity may still be too high
};

Insertion any_insertion(Input &in, const nurbs *g, int axes) {
    Insertion i{in.below(axes), 0, in.below(4), true};
    if (in.rarely()) {
        i.axis = in.coin() ? in.bad_int() : axes;
        i.sane = false;
        return i;
    }
    i.sane = !in.rarely();
    i.knot = fuzz::any_param(in, g, i.axis, true);
    if (!i.sane) {
        i.times = in.coin() ? in.bad_int() : i.times;
        i.knot = in.coin() ? in.anything() : i.knot;
    }
    return i;
}

int32_t form(const nurbs *g, int32_t axis) {
    int32_t result = -1;
    FUZZ_REQUIRE(nurbs_knot_form(g, axis, &result) == NURBS_OK);
    return result;
}

std::vector<double> knots(const nurbs *g, int32_t axis) {
    int32_t degree = 0;
    int64_t count = 0;
    FUZZ_REQUIRE(nurbs_degree(g, axis, &degree) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_count(g, axis, &count) == NURBS_OK);
    std::vector<double> result(static_cast<size_t>(count + degree + 1));
    FUZZ_REQUIRE(nurbs_knots(g, axis, count + degree + 1, result.data()) == NURBS_OK);
    return result;
}

// Other axes are untouched; this one has `times` more layers, the knot `times` more often, the same domain
// and form.
void check_knots(const nurbs *g, const nurbs *h, const fuzz::Spline &s, const Insertion &i) {
    for (int32_t k = 0; k < s.axes32(); ++k) {
        double before[2], after[2];
        FUZZ_REQUIRE(nurbs_domain(g, k, before) == NURBS_OK && nurbs_domain(h, k, after) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(before, after, 2));
        FUZZ_REQUIRE((form(g, k) & NURBS_FORM_PERIODIC) == (form(h, k) & NURBS_FORM_PERIODIC));
        const std::vector<double> old_knots = knots(g, k), new_knots = knots(h, k);
        FUZZ_REQUIRE(std::is_sorted(new_knots.begin(), new_knots.end()));
        FUZZ_REQUIRE(new_knots.size() == old_knots.size() + static_cast<size_t>(k == i.axis ? i.times : 0));
        FUZZ_REQUIRE(k == i.axis || old_knots == new_knots);
        if (k == i.axis && (form(g, k) & NURBS_FORM_PERIODIC) == 0) {
            const auto is_knot = [&](double t) { return t == i.knot; };
            FUZZ_REQUIRE(std::count_if(new_knots.begin(), new_knots.end(), is_knot) ==
                         std::count_if(old_knots.begin(), old_knots.end(), is_knot) + i.times);
        }
    }
}

// Each step is within 2 eps hull in homogeneous space, each evaluation within c eps hull, each division
// within eps; a ratio of weights carries the homogeneous error to the Cartesian point. On a periodic axis
// every step has at most degree + 1 images, whose errors meet at most there.
void check_shape(Input &in, const nurbs *g, const nurbs *h, const fuzz::Spline &s, const Insertion &i) {
    const double ratio = s.weight_ratio();
    const double steps =
        i.times * (form(g, i.axis) & NURBS_FORM_PERIODIC ? s.degrees[static_cast<size_t>(i.axis)] + 1 : 1);
    const double bound = (4 * steps + 2 * fuzz::accuracy(s.degrees) + 8) * fuzz::eps * ratio * s.size();
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), 8, true);
    std::vector<double> before(static_cast<size_t>(8 * s.dim)), after(before);
    const uint32_t side = in.coin() ? NURBS_ON_ALL_AXES(s.axes(), NURBS_LEFT) : 0;
    FUZZ_REQUIRE(nurbs_eval(g, 8, params.data(), 0, 0, before.data(), 0, 0, side) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_eval(h, 8, params.data(), 0, 0, after.data(), 0, 0, side) == NURBS_OK);
    for (size_t c = 0; ratio > 0 && c < before.size(); ++c) {
        FUZZ_REQUIRE(std::fabs(after[c] - before[c]) <= bound);
    }
}

void check_input(const nurbs *g, const fuzz::Spline &s) {
    std::vector<double> points(s.points.size());
    FUZZ_REQUIRE(nurbs_points(g, s.total, points.data(), 0, 0) == NURBS_OK);
    FUZZ_REQUIRE(fuzz::same_bits(points.data(), s.points.data(), points.size()));
}

// Inserts, and inserts into the result, a few times; every result is a spline like any other.
void insert(Input &in, const nurbs *g, const fuzz::Spline &s, int depth) {
    const Insertion i = any_insertion(in, g, s.axes());
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_insert_knot(g, i.axis, i.knot, i.times, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h || !i.sane || status == NURBS_ERROR_MULTIPLICITY);
    FUZZ_REQUIRE(h || !i.sane || i.times > 0);
    if (!h || i.axis < 0 || i.axis >= s.axes()) {
        FUZZ_REQUIRE(!h);
        return;
    }
    check_knots(g, h.get(), s, i);
    check_shape(in, g, h.get(), s, i);
    if (depth > 0) {
        insert(in, h.get(), s, depth - 1);
    }
}

// A list, mostly of places in the domain; what the matrix has in its rows is what the spline gains in layers.
void refine(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const bool bad = axis < 0 || axis >= s.axes();
    std::vector<double> list(static_cast<size_t>(in.below(12)));
    std::generate(list.begin(), list.end(),
                  [&] { return in.rarely() ? in.anything() : fuzz::any_param(in, g, bad ? 0 : axis, true); });
    const auto n = static_cast<int64_t>(list.size());
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_refine(g, axis, n, list.data(), &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    int64_t entries = -1;
    const bool ok =
        FUZZ_OK(nurbs_refinement_matrix(g, axis, n, list.data(), 0, nullptr, nullptr, nullptr, &entries));
    FUZZ_REQUIRE(ok || !h);
    if (!h) {
        return;
    }
    int64_t before = 0, after = 0;
    FUZZ_REQUIRE(nurbs_count(g, axis, &before) == NURBS_OK && nurbs_count(h.get(), axis, &after) == NURBS_OK);
    FUZZ_REQUIRE(after == before + n);
    std::vector<double> values(static_cast<size_t>(entries));
    std::vector<int64_t> columns(values.size()), rows(static_cast<size_t>(after + 1));
    FUZZ_REQUIRE(nurbs_refinement_matrix(g, axis, n, list.data(), entries, values.data(), columns.data(),
                                         rows.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(rows.front() == 0 && rows.back() == entries);
    FUZZ_REQUIRE(std::all_of(values.begin(), values.end(), [](double x) { return x >= 0 && x <= 1; }));
    FUZZ_REQUIRE(
        std::all_of(columns.begin(), columns.end(), [&](int64_t c) { return c >= 0 && c < before; }));
}

void refine_uniform(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const bool bad = in.rarely();
    const int64_t parts = bad ? in.bad_size() : 1 + in.below(4);
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_refine_uniform(g, in.below(s.axes()), parts, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(!bad || !h);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g) {
        insert(in, g.get(), s, 3);
        refine(in, g.get(), s);
        refine_uniform(in, g.get(), s);
        check_input(g.get(), s);
    }
    return 0;
}
