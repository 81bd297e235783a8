// Fits and statistics: mistakes are told, distances are not above what is reported, bytes come back or are refused.
#include "fuzz/harness.h"

#include <cstddef>
#include <memory>

using fuzz::Input;

namespace {

// Data with parameters that are mostly in the unit cube, and a space of splines over it.
struct Case {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts, break_counts;
    std::vector<double> knots, breaks, params, values, weights, domain;
    uint32_t flags = 0;
    nurbs_data data{};
    nurbs_fit_options options{};
    nurbs_call_options call{};
    std::vector<int32_t> shapes;
    double lower[3] = {}, upper[3] = {};

    [[nodiscard]] int32_t axes() const { return static_cast<int32_t>(degrees.size()); }
    [[nodiscard]] int64_t knot_count() const { return std::ssize(knots); }
};

void add_axis(Input &in, Case &c, int most) {
    const int p = in.below(most), spans = 1 + in.below(6);
    c.degrees.push_back(in.rarely() ? in.bad_int() : p);
    c.counts.push_back(in.rarely() ? in.bad_size() : p + spans);
    c.break_counts.push_back(spans + 1);
    for (int i = -p; i <= spans + p; ++i) {
        const double t = in.rarely() ? in.anything() : std::clamp(static_cast<double>(i) / spans, 0.0, 1.0);
        c.knots.push_back(t);
        if (i >= 0 && i <= spans) {
            c.breaks.push_back(t);
        }
    }
    c.domain.insert(c.domain.end(), {0, in.rarely() ? in.anything() : 1});
    if (in.below(4) == 0) {
        c.flags |= NURBS_ON_AXIS(c.axes() - 1, NURBS_PERIODIC);
    }
}

void add_data(Input &in, Case &c) {
    FUZZ_REQUIRE(nurbs_data_init(&c.data, sizeof c.data) == NURBS_OK);
    c.data.axes = in.rarely() ? in.bad_int() : c.axes();
    c.data.dim = 1 + in.below(3);
    c.data.n = in.below(40);
    for (int64_t i = 0; i < c.data.n; ++i) {
        for (int32_t k = 0; k < c.axes(); ++k) {
            c.params.push_back(in.rarely() ? in.anything() : in.unit());
        }
        for (int32_t d = 0; d < c.data.dim; ++d) {
            c.values.push_back(in.rarely() ? in.anything() : in.number());
        }
        c.weights.push_back(in.rarely() ? in.anything() : in.unit());
    }
    c.data.params = c.params.data();
    c.data.values = c.values.data();
    c.data.weights = in.coin() ? c.weights.data() : nullptr;
    c.data.flags = in.below(4) == 0 ? NURBS_ON_ALL_AXES(3, NURBS_WRAP) : 0;
}

void add_options(Input &in, Case &c) {
    FUZZ_REQUIRE(nurbs_fit_options_init(&c.options, sizeof c.options) == NURBS_OK);
    c.options.smoothing = in.rarely() ? in.bad_int() : in.below(5);
    c.options.penalty_order = in.rarely() ? in.bad_int() : 1 + in.below(3);
    c.options.lambda = in.rarely() ? in.anything() : in.unit();
    c.options.target = in.rarely() ? in.anything() : in.unit();
    c.options.regularize = in.coin() ? 1 : 0;
    if (in.below(4) == 0 && c.data.n > 2 && c.data.axes == c.axes()) { // the first data are conditions
        c.options.conditions = 1 + in.below(2);
        c.options.condition_params = c.params.data();
        c.options.condition_targets = c.values.data();
    }
    if (in.below(3) == 0) {
        for (int32_t i = 0; i < 3 * c.data.dim; ++i) {
            c.shapes.push_back(in.rarely() ? in.bad_int() : in.below(3) == 0 ? in.below(16) : 0);
        }
        c.options.shapes = c.shapes.data();
    }
    if (in.below(4) == 0) {
        for (int32_t i = 0; i < 3; ++i) {
            c.lower[i] = in.rarely() ? in.anything() : -in.unit();
            c.upper[i] = in.rarely() ? in.anything() : in.unit();
        }
        c.options.lower = c.lower;
        c.options.upper = c.upper;
    }
    FUZZ_REQUIRE(nurbs_call_options_init(&c.call, sizeof c.call) == NURBS_OK);
    c.call.work = 20000000;
}

class Report {
public:
    Report() { report_.struct_size = sizeof report_; }
    nurbs_fit_report *get() { return &report_; }
    void check(nurbs *out) const {
        FUZZ_REQUIRE(out == nullptr || (report_.data_count >= 0 && report_.squares >= 0));
    }

private:
    nurbs_fit_report report_{};
};

void points(Input &in, Case &c) {
    c.options.robust = in.rarely() ? in.bad_int() : in.coin() ? in.below(3) : 0;
    c.options.robust_width = in.rarely() ? in.anything() : 4 * in.unit();
    Report report;
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(
        FUZZ_MADE(nurbs_fit_points(&c.data, c.degrees.data(), c.counts.data(), c.knots.data(), c.knot_count(),
                                   c.flags, &c.options, report.get(), &out),
                  out));
    report.check(made.get());
    nurbs *same = fuzz::poison();
    const fuzz::Handle again(
        FUZZ_MADE(nurbs_fit_points_with(&c.data, c.degrees.data(), c.counts.data(), c.knots.data(),
                                        c.knot_count(), c.flags, &c.options, nullptr, &c.call, &same),
                  same));
    c.options.robust = in.rarely() ? 1 : 0;
}

void tolerance(Input &in, const Case &c) {
    const double allowed = in.rarely() ? in.anything() : std::ldexp(in.unit(), -in.below(30));
    const int64_t most = in.rarely() ? in.bad_size() : in.below(40);
    Report report;
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(
        FUZZ_MADE(nurbs_fit_tolerance(&c.data, c.degrees.data(), in.coin() ? c.domain.data() : nullptr,
                                      allowed, most, c.flags, &c.options, report.get(), &out),
                  out));
    report.check(made.get());
    FUZZ_REQUIRE(!made ||
                 (report.get()->largest <= allowed) == ((report.get()->bits & NURBS_FIT_TARGET_MISSED) == 0));
    nurbs *same = fuzz::poison();
    const fuzz::Handle again(
        FUZZ_MADE(nurbs_fit_tolerance_with(&c.data, c.degrees.data(), nullptr, allowed, most, c.flags,
                                           &c.options, nullptr, &c.call, &same),
                  same));
}

void approximate(Input &in) {
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g || s.total > 60 || s.degrees.size() > 1) {
        return;
    }
    nurbs_call_options call{};
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = 20000000;
    double bound = -7;
    nurbs *out = fuzz::poison();
    const int32_t degree = in.below(8);
    const fuzz::Handle made(
        FUZZ_MADE(nurbs_approximate_with(g.get(), &degree, 0.1, in.below(60), &bound, &call, &out), out));
    FUZZ_REQUIRE(made ? bound >= 0 : bound == -7);
    if (s.total > 12) {
        return;
    }
    out = fuzz::poison();
    const fuzz::Handle few(FUZZ_MADE(nurbs_approximate(g.get(), nullptr, 1, 12, nullptr, &out), out));
}

// --- Statistics ---

struct Destroy {
    void operator()(nurbs_statistics *s) const { nurbs_statistics_destroy(s); }
};
using Statistics = std::unique_ptr<nurbs_statistics, Destroy>;

template <class Call>
Statistics statistics_by(Call &&call) {
    nurbs_statistics *out = nullptr;
    const bool ok = FUZZ_OK(call(&out));
    FUZZ_REQUIRE(ok == (out != nullptr));
    return Statistics(out);
}

std::vector<unsigned char> bytes_of(const nurbs_statistics *s) {
    int64_t size = 0;
    FUZZ_REQUIRE(nurbs_statistics_to_bytes(s, 0, nullptr, &size) == NURBS_OK);
    std::vector<unsigned char> bytes(static_cast<size_t>(size));
    FUZZ_REQUIRE(nurbs_statistics_to_bytes(s, size, bytes.data(), nullptr) == NURBS_OK);
    return bytes;
}

void send(Input &in, const nurbs_statistics *s) {
    std::vector<unsigned char> bytes = bytes_of(s);
    const auto read = [&](nurbs_statistics **out) {
        return nurbs_statistics_from_bytes(bytes.data(), std::ssize(bytes), out);
    };
    const Statistics same = statistics_by(read);
    FUZZ_REQUIRE(same != nullptr && bytes_of(same.get()) == bytes);
    const size_t place = static_cast<size_t>(in.byte() * 256 + in.byte()) % bytes.size();
    bytes[place] = static_cast<unsigned char>(bytes[place] ^ (1 + in.below(255)));
    FUZZ_REQUIRE(statistics_by(read) == nullptr);
}

void how_sure(Input &in, const Case &c, const nurbs_statistics *s, const nurbs *g) {
    const double lambda = in.rarely() ? in.anything() : in.unit();
    const int32_t order = in.rarely() ? in.bad_int() : 1 + in.below(3);
    double errors[4] = {-7, -7, -7, -7}, found[8] = {-7};
    const int64_t n = std::min<int64_t>(4, c.data.n);
    if (FUZZ_OK(nurbs_fit_errors(s, g, order, lambda, 1, n, c.params.data(), 0, 0, c.data.flags, errors))) {
        FUZZ_REQUIRE(n == 0 || !(errors[0] < 0));
    }
    (void)FUZZ_OK(nurbs_fit_errors_with(s, g, order, lambda, 1, n, c.params.data(), 0, 0, c.data.flags,
                                        errors, &c.call));
    const double lambdas[2] = {lambda, in.rarely() ? in.anything() : 1};
    (void)FUZZ_OK(nurbs_fit_criteria(s, g, order, 2, lambdas, found));
    (void)FUZZ_OK(nurbs_fit_criteria_with(s, g, order, 2, lambdas, found, &c.call));
}

void statistics(Input &in, const Case &c) {
    const double scale = in.rarely() ? in.anything() : std::ldexp(1, in.below(30));
    const Statistics none = statistics_by([&](nurbs_statistics **out) {
        return nurbs_statistics_create(c.axes(), c.degrees.data(), c.break_counts.data(), c.breaks.data(),
                                       std::ssize(c.breaks), c.data.dim, scale, 1, out);
    });
    if (!none) {
        return;
    }
    const Statistics one =
        statistics_by([&](nurbs_statistics **out) { return nurbs_statistics_add(none.get(), &c.data, out); });
    const Statistics again = statistics_by(
        [&](nurbs_statistics **out) { return nurbs_statistics_add_with(none.get(), &c.data, &c.call, out); });
    const Statistics copy =
        statistics_by([&](nurbs_statistics **out) { return nurbs_statistics_clone(none.get(), out); });
    if (!one || !copy) {
        return;
    }
    const nurbs_statistics *const parts[] = {one.get(), copy.get(), one.get()};
    const int32_t signs[] = {1, 1, in.coin() ? 1 : -1};
    const Statistics all = statistics_by(
        [&](nurbs_statistics **out) { return nurbs_statistics_merge(1 + in.below(3), parts, signs, out); });
    const Statistics &used = all ? all : one;
    int64_t count = -7;
    FUZZ_REQUIRE(nurbs_statistics_size(used.get(), nullptr, nullptr, &count, nullptr, nullptr) == NURBS_OK);
    send(in, used.get());
    Report report;
    nurbs *out = fuzz::poison();
    const fuzz::Handle g(FUZZ_MADE(nurbs_fit(used.get(), c.degrees.data(), c.counts.data(), c.knots.data(),
                                             c.knot_count(), c.flags, &c.options, report.get(), &out),
                                   out));
    report.check(g.get());
    how_sure(in, c, used.get(), g.get());
    out = fuzz::poison();
    const fuzz::Handle same(
        FUZZ_MADE(nurbs_fit_with(used.get(), c.degrees.data(), c.counts.data(), c.knots.data(),
                                 c.knot_count(), c.flags, &c.options, nullptr, &c.call, &out),
                  out));
}

// --- Points without parameters: the values as a cloud ---

nurbs_cloud_options cloud_options(Input &in) {
    nurbs_cloud_options options{};
    FUZZ_REQUIRE(nurbs_cloud_options_init(&options, sizeof options) == NURBS_OK);
    options.penalty_order = in.rarely() ? in.bad_int() : 1 + in.below(3);
    options.rounds = in.rarely() ? in.bad_int() % 30 : 1 + in.below(6);
    options.lambda = in.rarely() ? in.anything() : in.unit() - 0.5;
    options.first_lambda = in.rarely() ? in.anything() : in.unit() - 0.5;
    options.tolerance = in.rarely() ? in.anything() : std::ldexp(in.unit(), -in.below(30));
    return options;
}

void fit_cloud(const nurbs *g, const Case &c, const nurbs_cloud_options &options) {
    nurbs_cloud_report report{};
    report.struct_size = sizeof report;
    nurbs *out = fuzz::poison();
    const fuzz::Handle made(FUZZ_MADE(nurbs_fit_cloud_with(g, c.data.n, c.values.data(), 0, 0, c.data.weights,
                                                           0, &options, &report, &c.call, &out),
                                      out));
    FUZZ_REQUIRE(!made || (report.rms <= report.largest * (1 + 1e-9) && report.rounds <= options.rounds));
    out = fuzz::poison();
    if (made) {
        const fuzz::Handle same(FUZZ_MADE(
            nurbs_fit_cloud(g, c.data.n, c.values.data(), 0, 0, c.data.weights, 0, &options, nullptr, &out),
            out));
        FUZZ_REQUIRE(same.get() != nullptr);
    }
}

void cloud(Input &in, const Case &c) {
    nurbs *out = fuzz::poison();
    const fuzz::Handle start(FUZZ_MADE(nurbs_cloud_start(c.axes(), c.degrees.data(), c.counts.data(),
                                                         c.knots.data(), c.knot_count(), c.data.n, c.data.dim,
                                                         c.values.data(), 0, 0, c.flags, &out),
                                       out));
    const nurbs_cloud_options options = cloud_options(in);
    if (start) {
        fit_cloud(start.get(), c, options);
    }
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g && s.total <= 30 && s.dim <= c.data.dim) { // as many values as points need
        Case other = c;
        other.data.n = std::min<int64_t>(c.data.n, 10);
        fit_cloud(g.get(), other, options);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    Case c;
    const int axes = in.below(4) == 0 ? 1 + in.below(3) : 1;
    for (int k = 0; k < axes; ++k) {
        add_axis(in, c, axes == 1 ? 9 : 4);
    }
    add_data(in, c);
    add_options(in, c);
    statistics(in, c);
    points(in, c);
    tolerance(in, c);
    approximate(in);
    cloud(in, c);
    return 0;
}
