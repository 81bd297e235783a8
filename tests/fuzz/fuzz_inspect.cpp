// Getters: every one of them on a spline, with axes, lengths and strides that are right or wrong.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

void sizes(const nurbs *g, const fuzz::Spline &s) {
    int32_t axes = 0, dim = 0, rational = -1, homogeneous = -1;
    int64_t total = 0;
    FUZZ_REQUIRE(nurbs_axes(g, &axes) == NURBS_OK && axes == s.axes());
    FUZZ_REQUIRE(nurbs_dimension(g, &dim) == NURBS_OK && dim == s.dim);
    FUZZ_REQUIRE(nurbs_point_count(g, &total) == NURBS_OK && total == s.total);
    FUZZ_REQUIRE(nurbs_is_rational(g, &rational) == NURBS_OK && rational == (s.weights.empty() ? 0 : 1));
    FUZZ_REQUIRE(nurbs_is_homogeneous(g, &homogeneous) == NURBS_OK && homogeneous <= rational);
}

// Distinct knots with their multiplicities spell the knot vector.
void distinct_knots(Input &in, const nurbs *g, int32_t axis, const std::vector<double> &knots) {
    int64_t count = 0;
    FUZZ_REQUIRE(nurbs_distinct_knots(g, axis, 0, nullptr, nullptr, &count) == NURBS_OK);
    const int64_t cap = in.rarely() ? in.below(20) : count;
    std::vector<double> distinct(static_cast<size_t>(cap)), spelled;
    std::vector<int32_t> times(distinct.size());
    if (!FUZZ_OK(nurbs_distinct_knots(g, axis, cap, distinct.data(), times.data(), &count))) {
        FUZZ_REQUIRE(cap < count);
        return;
    }
    for (size_t i = 0; i < static_cast<size_t>(count) && cap > 0; ++i) {
        spelled.insert(spelled.end(), static_cast<size_t>(times[i]), distinct[i]);
    }
    FUZZ_REQUIRE(cap == 0 || spelled == knots);
}

// A part of the knots, from number `first` on.
template <class Ask>
void part_of_knots(Input &in, const std::vector<double> &knots, size_t first, int64_t expected, Ask &&ask) {
    int64_t count = 0;
    FUZZ_REQUIRE(ask(0, nullptr, &count) == NURBS_OK && count == expected);
    const int64_t cap = in.rarely() ? in.below(20) : count;
    std::vector<double> found(static_cast<size_t>(cap));
    const bool ok = FUZZ_OK(ask(cap, found.data(), &count));
    FUZZ_REQUIRE(ok == (cap == 0 || cap >= count));
    FUZZ_REQUIRE(!ok || cap == 0 ||
                 fuzz::same_bits(found.data(), knots.data() + first, static_cast<size_t>(count)));
}

void short_and_unwrapped(Input &in, const nurbs *g, int32_t axis, const std::vector<double> &knots,
                         int32_t degree) {
    int32_t form = 0;
    int64_t distinct = 0;
    FUZZ_REQUIRE(nurbs_knot_form(g, axis, &form) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_unwrapped_count(g, axis, &distinct) == NURBS_OK);
    const bool periodic = (form & NURBS_FORM_PERIODIC) != 0;
    const int64_t all = std::ssize(knots);
    FUZZ_REQUIRE(distinct == all - degree - 1 - (periodic ? degree : 0));
    part_of_knots(in, knots, periodic ? static_cast<size_t>(degree) : 0, periodic ? distinct + 1 : all,
                  [&](int64_t cap, double *values, int64_t *count) {
                      return nurbs_unwrapped_knots(g, axis, cap, values, count);
                  });
    if (degree > 0) {
        part_of_knots(in, knots, 1, all - 2, [&](int64_t cap, double *values, int64_t *count) {
            return nurbs_short_knots(g, axis, cap, values, count);
        });
    }
}

void forms(const nurbs *g, int32_t axis, const std::vector<double> &knots, int32_t degree, int64_t count) {
    int32_t form = -1;
    double domain[2] = {0, 0};
    FUZZ_REQUIRE(nurbs_knot_form(g, axis, &form) == NURBS_OK);
    FUZZ_REQUIRE(((form & NURBS_FORM_CLAMPED_START) != 0) ==
                 (knots.front() == knots[static_cast<size_t>(degree)]));
    FUZZ_REQUIRE(((form & NURBS_FORM_CLAMPED_END) != 0) ==
                 (knots.back() == knots[static_cast<size_t>(count)]));
    FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_OK);
    FUZZ_REQUIRE(domain[0] == knots[static_cast<size_t>(degree)] &&
                 domain[1] == knots[static_cast<size_t>(count)]);
}

// A mean lies between its smallest and its largest term; the sites do not decrease.
void greville(Input &in, const nurbs *g, int32_t axis, const std::vector<double> &knots, int32_t degree) {
    const int64_t count = static_cast<int64_t>(knots.size()) - degree - 1;
    const int64_t stated = in.rarely() ? in.bad_size() : count;
    std::vector<double> sites(static_cast<size_t>(count));
    if (!FUZZ_OK(nurbs_greville(g, axis, stated, sites.data()))) {
        FUZZ_REQUIRE(stated != count);
        return;
    }
    for (size_t i = 0; i < sites.size(); ++i) {
        const size_t last = i + static_cast<size_t>(std::max(degree, 1));
        FUZZ_REQUIRE(sites[i] >= knots[degree == 0 ? i : i + 1] && sites[i] <= knots[last]);
    }
}

void axes(Input &in, const nurbs *g, const fuzz::Spline &s) {
    size_t offset = 0;
    for (int32_t k = 0; k < s.axes32(); ++k) {
        int32_t degree = -1;
        int64_t count = 0;
        FUZZ_REQUIRE(nurbs_degree(g, k, &degree) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_count(g, k, &count) == NURBS_OK);
        const int64_t length = count + degree + 1, stated = in.rarely() ? in.bad_size() : length;
        std::vector<double> knots(static_cast<size_t>(length));
        FUZZ_REQUIRE((nurbs_knots(g, k, stated, knots.data()) == NURBS_OK) == (stated == length));
        if (stated == length) {
            FUZZ_REQUIRE(fuzz::same_bits(knots.data(), s.knots.data() + offset, knots.size()));
            distinct_knots(in, g, k, knots);
            short_and_unwrapped(in, g, k, knots, degree);
            forms(g, k, knots, degree, count);
            greville(in, g, k, knots, degree);
        }
        offset += static_cast<size_t>(length);
    }
}

void wrong_axis(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.coin() ? in.bad_int() : s.axes32();
    int32_t small = -7;
    int64_t large = -7;
    double domain[2] = {-7, -7};
    FUZZ_REQUIRE(nurbs_degree(g, axis, &small) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_count(g, axis, &large) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_knots(g, axis, 2, domain) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_distinct_knots(g, axis, 2, domain, nullptr, &large) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_knot_form(g, axis, &small) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_unwrapped_count(g, axis, &large) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_unwrapped_knots(g, axis, 2, domain, &large) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_short_knots(g, axis, 2, domain, &large) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(nurbs_greville(g, axis, 2, domain) == NURBS_ERROR_AXIS);
    FUZZ_REQUIRE(small == -7 && large == -7 && domain[0] == -7 && domain[1] == -7);
}

// Packed, padded or transposed; the values are the same.
void records(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const auto dim = static_cast<size_t>(s.dim), total = static_cast<size_t>(s.total);
    const int layout = in.below(3);
    const int64_t gap = in.below(3);
    const int64_t stride = layout == 0 ? 0 : layout == 1 ? s.dim + 1 + gap : 1;
    const int64_t component = layout == 2 ? s.total + gap : 0;
    const auto room = [&](size_t width) {
        return layout == 0   ? total * width
               : layout == 1 ? (total - 1) * static_cast<size_t>(stride) + width
                             : (width - 1) * static_cast<size_t>(component) + total;
    };
    const auto place = [&](size_t i, size_t c, size_t width) {
        return layout == 2 ? i + c * static_cast<size_t>(component)
                           : i * (layout == 0 ? width : static_cast<size_t>(stride)) + c;
    };
    std::vector<double> points(room(dim)), homogeneous(room(dim + 1)), weights(total);
    FUZZ_REQUIRE(nurbs_points(g, s.total, points.data(), stride, component) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_homogeneous_points(g, s.total, homogeneous.data(), stride, component) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_weights(g, s.total, weights.data(), 0) == NURBS_OK);
    for (size_t i = 0; i < total; ++i) {
        FUZZ_REQUIRE(weights[i] == (s.weights.empty() ? 1 : s.weights[i]));
        FUZZ_REQUIRE(homogeneous[place(i, dim, dim + 1)] == weights[i]);
        for (size_t c = 0; c < dim; ++c) {
            FUZZ_REQUIRE(points[place(i, c, dim)] == s.points[i * dim + c]);
            FUZZ_REQUIRE(homogeneous[place(i, c, dim + 1)] == weights[i] * s.points[i * dim + c]);
        }
    }
}

void wrong_layouts(Input &in, const nurbs *g, const fuzz::Spline &s) {
    double value = -7;
    const int64_t bad = in.bad_size();
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_points(g, bad, &value, 0, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_weights(g, bad, &value, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_homogeneous_points(g, bad, &value, 0, 0)));
    if (s.total > 1) {
        FUZZ_REQUIRE(!FUZZ_OK(nurbs_points(g, s.total, &value, bad, 0)));
        FUZZ_REQUIRE(!FUZZ_OK(nurbs_weights(g, s.total, &value, bad)));
        FUZZ_REQUIRE(!FUZZ_OK(nurbs_homogeneous_points(g, s.total, &value, 0, bad)));
    }
    FUZZ_REQUIRE(value == -7);
}

// The hull is that of active points: never more than the largest coordinate of all.
void hulls(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int64_t n = in.below(9);
    const bool inside = in.coin();
    const uint32_t flags = inside ? 0 : fuzz::any_flags(in, s.axes());
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), n, inside);
    std::vector<double> hull(static_cast<size_t>(n), -7);
    if (!FUZZ_OK(nurbs_hull_size(g, n, params.data(), 0, 0, hull.data(), 0, flags))) {
        FUZZ_REQUIRE(!inside);
        FUZZ_REQUIRE(std::all_of(hull.begin(), hull.end(), [](double h) { return h == -7; }));
        return;
    }
    const double most = s.size();
    for (const double h : hull) {
        FUZZ_REQUIRE(std::isnan(h) ? !inside : h >= 0 && h <= most);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g) {
        sizes(g.get(), s);
        axes(in, g.get(), s);
        wrong_axis(in, g.get(), s);
        records(in, g.get(), s);
        wrong_layouts(in, g.get(), s);
        hulls(in, g.get(), s);
    }
    return 0;
}
