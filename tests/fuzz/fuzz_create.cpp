// Construction, knot generators and error texts: a spline that is mostly valid, with one argument spoiled now
// and then.
#include "fuzz/harness.h"

using fuzz::Input;
using fuzz::poison;

namespace {

// All arguments of nurbs_create() after the arrays, so that one of them can be spoiled.
struct Layout {
    int64_t point_stride = 0, component_stride = 0, weight_stride = 0;
};

void spoil(Input &in, fuzz::Spline &s, Layout &layout, int64_t &knot_count, int32_t &axes) {
    const auto k = static_cast<size_t>(in.below(s.axes()));
    const auto any = [&](std::vector<double> &v) {
        if (!v.empty()) {
            v[static_cast<size_t>(in.bits() % v.size())] = in.anything();
        }
    };
    switch (in.below(11)) {
    case 0:
        s.degrees[k] = in.coin() ? in.bad_int() : in.below(64);
        break;
    case 1:
        s.counts[k] = in.bad_size();
        break;
    case 2:
        knot_count = in.coin() ? in.bad_size() : knot_count - 1;
        break;
    case 3:
        s.dim = in.coin() ? in.bad_int() : 0;
        break;
    case 4:
        layout.point_stride = in.bad_size();
        break;
    case 5:
        layout.component_stride = in.bad_size();
        break;
    case 6:
        layout.weight_stride = in.bad_size();
        break;
    case 7:
        s.flags = static_cast<uint32_t>(in.bits());
        break;
    case 8:
        axes = in.coin() ? in.bad_int() : 0;
        break;
    case 9:
        any(s.knots);
        break;
    default:
        any(in.coin() ? s.points : s.weights);
        break;
    }
}

// A degree that was spoiled may still fit the sizes; then the arrays do too.
void check_stored(const nurbs *g, const fuzz::Spline &s) {
    std::vector<double> points(s.points.size()), weights(static_cast<size_t>(s.total));
    FUZZ_REQUIRE(nurbs_points(g, s.total, points.data(), 0, 0) == NURBS_OK);
    FUZZ_REQUIRE(fuzz::same_bits(points.data(), s.points.data(), points.size()));
    FUZZ_REQUIRE(nurbs_weights(g, s.total, weights.data(), 0) == NURBS_OK);
    if (!s.weights.empty()) {
        FUZZ_REQUIRE(fuzz::same_bits(weights.data(), s.weights.data(), weights.size()));
    }
    size_t offset = 0;
    for (int32_t k = 0; k < s.axes32(); ++k) {
        const auto axis = static_cast<size_t>(k);
        std::vector<double> knots(static_cast<size_t>(s.counts[axis] + s.degrees[axis] + 1));
        FUZZ_REQUIRE(nurbs_knots(g, k, static_cast<int64_t>(knots.size()), knots.data()) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(knots.data(), s.knots.data() + offset, knots.size()));
        offset += knots.size();
    }
}

void full(Input &in, fuzz::Spline s) {
    Layout layout;
    int64_t knot_count = s.knot_count();
    int32_t axes = s.axes32();
    const int64_t total = s.total;
    const bool spoiled = in.below(4) == 3;
    if (spoiled) {
        spoil(in, s, layout, knot_count, axes);
    }
    nurbs *g = poison();
    const nurbs_status status = nurbs_create(
        axes, s.degrees.data(), s.counts.data(), s.knots.data(), knot_count, s.dim, s.points.data(),
        layout.point_stride, layout.component_stride, s.weight_data(), layout.weight_stride, s.flags, &g);
    const fuzz::Handle handle(FUZZ_MADE(status, g));
    if (handle && !spoiled) {
        FUZZ_REQUIRE(total == s.total);
        check_stored(handle.get(), s);
    }
}

// Periodic axes of random knots and few control points, one argument of which may be wrong; what is taken comes back.
void periodic(Input &in) {
    const int axes = 1 + in.below(3);
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> knots;
    int64_t total = 1;
    for (int k = 0; k < axes; ++k) {
        degrees.push_back(in.rarely() ? in.below(32) : in.below(6));
        counts.push_back(1 + in.below(axes == 1 ? 20 : 4));
        total *= counts.back();
        double t = in.number();
        for (int64_t i = 0; i <= counts.back(); ++i) {
            knots.push_back(in.rarely() ? in.anything() : t);
            t += 0.25 * in.below(5);
        }
    }
    std::vector<double> points(static_cast<size_t>(total)), weights(points.size());
    std::generate(points.begin(), points.end(), [&] { return in.rarely() ? in.anything() : in.number(); });
    std::generate(weights.begin(), weights.end(), [&] { return fuzz::any_weight(in); });
    const bool bad = in.rarely();
    counts[0] = bad ? in.bad_size() : counts[0];
    nurbs *g = poison();
    const nurbs_status status = nurbs_create_periodic(
        axes, degrees.data(), counts.data(), knots.data(), std::ssize(knots), 1, points.data(), 0, 0,
        in.coin() ? weights.data() : nullptr, 0, NURBS_ON_ALL_AXES(axes, NURBS_PERIODIC), &g);
    const fuzz::Handle handle(FUZZ_MADE(status, g));
    FUZZ_REQUIRE(!(bad && handle));
    if (handle) {
        std::vector<double> found(points.size());
        int64_t count = 0;
        FUZZ_REQUIRE(nurbs_unwrapped_points(handle.get(), total, found.data(), nullptr, &count) == NURBS_OK);
        FUZZ_REQUIRE(count == total && fuzz::same_bits(found.data(), points.data(), points.size()));
        size_t offset = 0;
        for (int32_t k = 0; k < axes; ++k) {
            found.resize(static_cast<size_t>(counts[static_cast<size_t>(k)]) + 1);
            FUZZ_REQUIRE(nurbs_unwrapped_knots(handle.get(), k, std::ssize(found), found.data(), &count) ==
                         NURBS_OK);
            FUZZ_REQUIRE(fuzz::same_bits(found.data(), knots.data() + offset, found.size()));
            offset += found.size();
        }
    }
}

// The records (w x, ..., w) of the spline, now and then with another sign.
void homogeneous(Input &in, const fuzz::Spline &s) {
    std::vector<double> records;
    const auto dim = static_cast<size_t>(s.dim);
    for (int64_t i = 0; i < s.total; ++i) {
        const auto at = static_cast<size_t>(i);
        const double weight = s.weights.empty() ? 1 : s.weights[at];
        for (size_t c = 0; c < dim; ++c) {
            records.push_back(weight * s.points[at * dim + c]);
        }
        records.push_back(s.flags == 0 && in.rarely() ? -weight : weight);
    }
    nurbs *g = poison();
    const nurbs_status status =
        nurbs_create_homogeneous(s.axes32(), s.degrees.data(), s.counts.data(), s.knots.data(),
                                 s.knot_count(), s.dim, records.data(), 0, 0, s.flags, &g);
    const fuzz::Handle handle(FUZZ_MADE(status, g));
    if (handle) {
        std::vector<double> read(records.size());
        FUZZ_REQUIRE(nurbs_homogeneous_points(handle.get(), s.total, read.data(), 0, 0) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(read.data(), records.data(), read.size()));
    }
}

// The same knots without the outer ones.
void without_outer_knots(const fuzz::Spline &s) {
    std::vector<double> knots;
    size_t offset = 0;
    for (size_t k = 0; k < s.degrees.size(); ++k) {
        const auto size = static_cast<size_t>(s.counts[k] + s.degrees[k] + 1);
        for (size_t i = 1; i + 1 < size; ++i) {
            knots.push_back(s.knots[offset + i]);
        }
        offset += size;
    }
    nurbs *g = poison();
    const nurbs_status status = nurbs_create_short(s.axes32(), s.degrees.data(), s.counts.data(),
                                                   knots.data(), static_cast<int64_t>(knots.size()), s.dim,
                                                   s.points.data(), 0, 0, s.weight_data(), 0, s.flags, &g);
    const fuzz::Handle handle(FUZZ_MADE(status, g));
    if (handle) {
        FUZZ_REQUIRE(*std::min_element(s.degrees.begin(), s.degrees.end()) >= 1);
    }
}

// The same knots as groups; they give the same spline.
void grouped(Input &in, const fuzz::Spline &s) {
    std::vector<int64_t> counts;
    std::vector<double> distinct;
    std::vector<int32_t> multiplicities;
    size_t offset = 0;
    for (size_t k = 0; k < s.degrees.size(); ++k) {
        const auto size = static_cast<size_t>(s.counts[k] + s.degrees[k] + 1);
        counts.push_back(0);
        for (size_t i = 0; i < size; ++i) {
            const double t = s.knots[offset + i];
            if (i == 0 || t != distinct.back()) {
                distinct.push_back(t);
                multiplicities.push_back(0);
                ++counts.back();
            }
            ++multiplicities.back();
        }
        offset += size;
    }
    const bool spoiled = in.rarely();
    if (spoiled) {
        multiplicities[static_cast<size_t>(in.bits() % multiplicities.size())] = in.coin() ? in.bad_int() : 0;
    }
    nurbs *g = poison();
    const nurbs_status status = nurbs_create_multiplicities(
        s.axes32(), s.degrees.data(), s.counts.data(), counts.data(), distinct.data(), multiplicities.data(),
        s.dim, s.points.data(), 0, 0, s.weight_data(), 0, s.flags, &g);
    const fuzz::Handle handle(FUZZ_MADE(status, g));
    const fuzz::Handle same(fuzz::create(s));
    FUZZ_REQUIRE(spoiled ? !handle : static_cast<bool>(handle) == static_cast<bool>(same));
    if (handle) {
        check_stored(handle.get(), s);
    }
}

void bezier(Input &in, const fuzz::Spline &s) {
    int64_t total = 1;
    for (const int32_t p : s.degrees) {
        total *= p + 1;
    }
    std::vector<double> points(static_cast<size_t>(total * s.dim));
    std::generate(points.begin(), points.end(), [&] { return in.number(); });
    nurbs *g = poison();
    const nurbs_status status =
        nurbs_create_bezier(s.axes32(), s.degrees.data(), s.dim, points.data(), 0, 0, nullptr, 0, &g);
    const fuzz::Handle handle(FUZZ_MADE(status, g));
    FUZZ_REQUIRE(handle);
    if (in.rarely()) {
        std::vector<int32_t> bad(s.degrees);
        bad.back() = in.coin() ? in.bad_int() : 32;
        nurbs *none = poison();
        FUZZ_REQUIRE(FUZZ_MADE(nurbs_create_bezier(s.axes32(), bad.data(), s.dim, points.data(), 0, 0,
                                                   nullptr, 0, &none),
                               none) == nullptr);
    }
}

void other_points(Input &in, const fuzz::Spline &s) {
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return;
    }
    fuzz::Spline t = s;
    fill_values(in, t, in.coin());
    if (in.rarely()) {
        t.points[static_cast<size_t>(in.bits() % t.points.size())] = in.anything();
    }
    nurbs *out = poison();
    const fuzz::Handle h(
        FUZZ_MADE(nurbs_with_points(g.get(), t.points.data(), 0, 0, t.weight_data(), 0, &out), out));
    out = poison();
    const fuzz::Handle clone(FUZZ_MADE(nurbs_clone(h ? h.get() : g.get(), &out), out));
    FUZZ_REQUIRE(clone);
    check_stored(g.get(), s);
    if (h) {
        t.weights = t.weights.empty() ? s.weights : t.weights;
        check_stored(clone.get(), t);
    }
}

// Generated vectors do not decrease, and suit nurbs_create() and so nurbs_find_spans().
void check_generated(nurbs_status status, int32_t degree, int64_t count, const std::vector<double> &knots) {
    if (!FUZZ_OK(status)) {
        return;
    }
    FUZZ_REQUIRE(std::is_sorted(knots.begin(), knots.end()));
    const double start = knots[static_cast<size_t>(degree)];
    int64_t span = -1;
    const nurbs_status found = nurbs_find_spans(degree, count, knots.data(),
                                                static_cast<int64_t>(knots.size()), 1, &start, 0, &span, 0);
    FUZZ_REQUIRE(found == NURBS_OK || found == NURBS_ERROR_KNOT_NOT_FINITE ||
                 found == NURBS_ERROR_MULTIPLICITY || found == NURBS_ERROR_END_MULTIPLICITY ||
                 found == NURBS_ERROR_EMPTY_DOMAIN);
}

void generators(Input &in) {
    const int32_t degree = in.rarely() ? in.bad_int() : in.below(34) - 1;
    const int64_t count = in.rarely() ? in.bad_size() : in.below(48);
    const bool fits = degree >= 0 && degree < 32 && count > 0 && count < 64;
    const auto size = static_cast<size_t>(fits ? count + degree + 1 : 8);
    const auto stated = static_cast<int64_t>(size);
    std::vector<double> knots(size), sites(fits ? static_cast<size_t>(count) : 0);
    const double a = in.rarely() ? in.anything() : in.number(),
                 b = in.rarely() ? in.anything() : a + in.unit();
    check_generated(nurbs_knots_uniform(degree, count, a, b, stated, knots.data()), degree, count, knots);
    check_generated(nurbs_knots_open_uniform(degree, count, a, b, stated, knots.data()), degree, count,
                    knots);
    double t = in.number();
    for (double &site : sites) {
        site = in.rarely() ? in.anything() : t;
        t += in.below(4) * 0.5;
    }
    if (fits) {
        check_generated(nurbs_knots_averaged(degree, count, sites.data(), stated, knots.data()), degree,
                        count, knots);
        const int64_t pieces = count, points = degree == 0 ? pieces : pieces * degree + 1;
        std::vector<double> breaks(static_cast<size_t>(pieces + 1));
        for (double &value : breaks) {
            value = in.rarely() ? in.anything() : t;
            t += in.unit() + 0.001;
        }
        std::vector<double> more(static_cast<size_t>(points + degree + 1));
        check_generated(nurbs_knots_bezier(degree, pieces, in.coin() ? breaks.data() : nullptr,
                                           static_cast<int64_t>(more.size()), more.data()),
                        degree, points, more);
        std::vector<int32_t> times(breaks.size());
        std::generate(times.begin(), times.end(),
                      [&] { return in.rarely() ? in.bad_int() : 1 + in.below(degree + 1); });
        times.back() = in.rarely() ? times.back() : times.front();
        int64_t layers = 0;
        for (size_t i = 0; i + 1 < times.size(); ++i) {
            layers += times[i];
        }
        const bool sane = layers > 0 && layers < 4096;
        std::vector<double> ring(static_cast<size_t>(sane ? layers + 2 * degree + 1 : 4));
        check_generated(nurbs_knots_periodic(degree, pieces + 1, breaks.data(), times.data(),
                                             static_cast<int64_t>(ring.size()), ring.data()),
                        degree, static_cast<int64_t>(ring.size()) - degree - 1, ring);
    }
}

void texts(Input &in) {
    FUZZ_REQUIRE(nurbs_version() == NURBS_VERSION);
    FUZZ_REQUIRE(nurbs_status_name(static_cast<nurbs_status>(in.bits())) != nullptr);
    const int64_t cap = in.below(64);
    std::vector<char> text(static_cast<size_t>(cap));
    const int64_t length = nurbs_last_error(text.data(), cap);
    FUZZ_REQUIRE(length >= 0);
    FUZZ_REQUIRE(cap == 0 || std::memchr(text.data(), 0, text.size()) != nullptr);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    if (s.total <= 4096) {
        full(in, s);
        homogeneous(in, s);
        without_outer_knots(s);
        grouped(in, s);
        other_points(in, s);
    }
    if (s.axes() < 3) {
        bezier(in, s);
    }
    generators(in);
    periodic(in);
    texts(in);
    return 0;
}
