// Matrices and gradients: rows in order, matrix times points = evaluation, sums of the operators, the
// transpose of evaluation, and nothing written by a refused call.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Batch {
    int64_t n;
    bool inside;
    uint32_t flags;
    std::vector<double> params;
};

Batch any_batch(Input &in, const nurbs *g, int axes) {
    Batch b{in.below(5), in.coin(), 0, {}};
    b.flags = b.inside ? 0 : fuzz::any_flags(in, axes);
    b.params = fuzz::any_params(in, g, axes, b.n, b.inside);
    return b;
}

template <class T>
bool untouched(const std::vector<T> &out) {
    return std::all_of(out.begin(), out.end(), [](T x) { return x == T{-7}; });
}

struct Rows {
    std::vector<double> values;
    std::vector<int64_t> columns, pointers;
    int64_t entries = -7;

    explicit Rows(int64_t n, int64_t width)
        : values(static_cast<size_t>(n * width), -7), columns(values.size(), -7),
          pointers(static_cast<size_t>(n) + 1, -7) {}
    [[nodiscard]] int64_t cap() const { return static_cast<int64_t>(values.size()); }
    [[nodiscard]] bool intact() const {
        return untouched(values) && untouched(columns) && untouched(pointers) && entries == -7;
    }
};

int64_t row_width(const fuzz::Spline &s) {
    int64_t width = 1;
    for (const int32_t p : s.degrees) {
        width *= p + 1;
    }
    return width;
}

void check_rows(const Rows &rows, const fuzz::Spline &s, int64_t n) {
    const auto width = static_cast<size_t>(row_width(s));
    FUZZ_REQUIRE(rows.entries == rows.cap());
    for (size_t i = 0; i <= static_cast<size_t>(n); ++i) {
        FUZZ_REQUIRE(rows.pointers[i] == static_cast<int64_t>(i * width));
    }
    for (size_t e = 0; e < rows.columns.size(); ++e) {
        FUZZ_REQUIRE(rows.columns[e] >= 0 && rows.columns[e] < s.total);
        FUZZ_REQUIRE(e % width == 0 || rows.columns[e] > rows.columns[e - 1]);
    }
}

// Both matrices; the rational one at order 0 has rows that add up to 1.
void matrices(Input &in, const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    std::vector<int32_t> orders;
    for (int k = 0; k < s.axes(); ++k) {
        orders.push_back(in.rarely() ? in.bad_int() : in.below(3));
    }
    const bool sane = std::all_of(orders.begin(), orders.end(), [](int32_t k) { return k >= 0 && k < 3; });
    Rows plain(b.n, row_width(s)), rational(plain), zero(plain);
    const bool ok = FUZZ_OK(nurbs_collocation(s.axes32(), s.degrees.data(), s.counts.data(), s.knots.data(),
                                              s.knot_count(), orders.data(), b.n, b.params.data(), 0, 0,
                                              plain.cap(), plain.values.data(), plain.columns.data(),
                                              plain.pointers.data(), &plain.entries, b.flags));
    FUZZ_REQUIRE(
        ok == FUZZ_OK(nurbs_rational_collocation(g, orders.data(), b.n, b.params.data(), 0, 0, rational.cap(),
                                                 rational.values.data(), rational.columns.data(),
                                                 rational.pointers.data(), &rational.entries, b.flags)));
    FUZZ_REQUIRE(ok || ((!sane || !b.inside) && plain.intact() && rational.intact()));
    if (!ok) {
        return;
    }
    check_rows(plain, s, b.n);
    check_rows(rational, s, b.n);
    FUZZ_REQUIRE(plain.columns == rational.columns);
    FUZZ_REQUIRE(nurbs_rational_collocation(g, nullptr, b.n, b.params.data(), 0, 0, zero.cap(),
                                            zero.values.data(), nullptr, nullptr, nullptr,
                                            b.flags) == NURBS_OK);
    const double bound =
        (3 * fuzz::accuracy(s.degrees) + 2.0 * static_cast<double>(row_width(s))) * fuzz::eps;
    for (size_t i = 0; b.inside && i < static_cast<size_t>(b.n); ++i) {
        const auto row = zero.values.begin() + zero.cap() / b.n * static_cast<int64_t>(i);
        double sum = 0;
        for (int64_t j = 0; j < row_width(s); ++j) {
            FUZZ_REQUIRE(row[j] >= 0);
            sum += row[j];
        }
        FUZZ_REQUIRE(std::fabs(sum - 1) <= 2 * bound);
    }
}

void extraction(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const bool sane = axis >= 0 && axis < s.axes();
    int64_t count = -7;
    const bool ok = FUZZ_OK(nurbs_bezier_extraction(g, axis, 0, nullptr, nullptr, nullptr, &count));
    FUZZ_REQUIRE(ok == sane && (ok || count == -7));
    if (!ok) {
        return;
    }
    const auto width = static_cast<size_t>(s.degrees[static_cast<size_t>(axis)]) + 1;
    const auto spans = static_cast<size_t>(count);
    std::vector<double> operators(spans * width * width), domains(2 * spans);
    std::vector<int64_t> firsts(spans);
    FUZZ_REQUIRE(nurbs_bezier_extraction(g, axis, count, operators.data(), firsts.data(), domains.data(),
                                         &count) == NURBS_OK);
    for (size_t e = 0; e < spans; ++e) {
        FUZZ_REQUIRE(domains[2 * e] < domains[2 * e + 1]);
        FUZZ_REQUIRE(firsts[e] >= 0 &&
                     firsts[e] + static_cast<int64_t>(width) <= s.counts[static_cast<size_t>(axis)]);
        for (size_t k = 0; k < width; ++k) {
            double sum = 0;
            for (size_t j = 0; j < width; ++j) {
                const double value = operators[(e * width + j) * width + k];
                FUZZ_REQUIRE(value >= 0);
                sum += value;
            }
            FUZZ_REQUIRE(std::fabs(sum - 1) <= 3 * static_cast<double>(width) * fuzz::eps);
        }
    }
}

struct Gradients {
    std::vector<double> points, weights, params;

    Gradients(const fuzz::Spline &s, int64_t n)
        : points(static_cast<size_t>(s.total * s.dim), -7), weights(static_cast<size_t>(s.total), -7),
          params(static_cast<size_t>(n * s.axes()), -7) {}
};

nurbs_status adjoint(const nurbs *g, int32_t order, const Batch &b, const std::vector<double> &cotangents,
                     Gradients &out, uint32_t flags) {
    return nurbs_eval_adjoint(g, order, b.n, b.params.data(), 0, 0, cotangents.data(), 0, 0,
                              out.points.data(), 0, 0, out.weights.data(), 0, out.params.data(), 0, 0, flags);
}

// Twice into the same outputs doubles what one call gives; at order 0 and inside the domain the columns of
// the points' gradient add up to the sum of the cotangents, as the functions add up to 1.
void gradients(Input &in, const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    const int32_t order = in.below(3);
    int64_t slots = 0;
    FUZZ_REQUIRE(nurbs_derivative_slots(s.axes32(), order, &slots) == NURBS_OK);
    std::vector<double> cotangents(static_cast<size_t>(b.n * slots * s.dim));
    std::generate(cotangents.begin(), cotangents.end(), [&] { return 2 * in.unit() - 1; });
    Gradients once(s, b.n), twice(s, b.n);
    const uint32_t flags = b.flags & ~NURBS_ACCUMULATE;
    if (!FUZZ_OK(adjoint(g, order, b, cotangents, once, flags))) {
        FUZZ_REQUIRE(!b.inside && untouched(once.points) && untouched(once.weights) &&
                     untouched(once.params));
        return;
    }
    std::fill(twice.points.begin(), twice.points.end(), 0.0);
    std::fill(twice.weights.begin(), twice.weights.end(), 0.0);
    std::fill(twice.params.begin(), twice.params.end(), 0.0);
    FUZZ_REQUIRE(adjoint(g, order, b, cotangents, twice, flags | NURBS_ACCUMULATE) == NURBS_OK);
    FUZZ_REQUIRE(fuzz::same_bits(once.points.data(), twice.points.data(), once.points.size()));
    FUZZ_REQUIRE(fuzz::same_bits(once.weights.data(), twice.weights.data(), once.weights.size()));
    FUZZ_REQUIRE(fuzz::same_bits(once.params.data(), twice.params.data(), once.params.size()));
    if (order > 0 || !b.inside) {
        return;
    }
    const auto dim = static_cast<size_t>(s.dim);
    for (size_t c = 0; c < dim; ++c) {
        double gained = 0, given = 0, size = 0;
        for (size_t i = c; i < once.points.size(); i += dim) {
            gained += once.points[i];
            size += std::fabs(once.points[i]);
        }
        for (size_t i = c; i < cotangents.size(); i += dim) {
            given += cotangents[i];
            size += std::fabs(cotangents[i]);
        }
        const double terms = static_cast<double>(s.total + 2 * b.n) + 8 * fuzz::accuracy(s.degrees) +
                             4.0 * static_cast<double>(row_width(s));
        FUZZ_REQUIRE(std::fabs(gained - given) <= terms * fuzz::eps * (size + static_cast<double>(b.n)));
    }
}

// Twice into the same output doubles nothing; the derivative by a knot has the domain of the spline, and a point.
void knot_gradients(Input &in, const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const bool sane = axis >= 0 && axis < s.axes();
    const size_t size = sane ? static_cast<size_t>(s.counts[static_cast<size_t>(axis)] +
                                                   s.degrees[static_cast<size_t>(axis)] + 1)
                             : 1;
    const std::vector<double> cotangents(static_cast<size_t>(b.n * s.dim), 1.0);
    std::vector<double> once(size, -7), twice(size, 0);
    const auto adjoint_of = [&](std::vector<double> &out, uint32_t flags) {
        return nurbs_eval_adjoint_knots(g, axis, 0, b.n, b.params.data(), 0, 0, cotangents.data(), 0, 0,
                                        out.data(), flags);
    };
    const uint32_t flags = b.flags & ~NURBS_ACCUMULATE;
    if (!FUZZ_OK(adjoint_of(once, flags))) {
        FUZZ_REQUIRE((!sane || !b.inside) && untouched(once));
    } else {
        FUZZ_REQUIRE(adjoint_of(twice, flags | NURBS_ACCUMULATE) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(once.data(), twice.data(), size));
    }
    const int64_t knot = in.rarely() ? in.bad_size() : in.below(static_cast<int32_t>(size));
    nurbs *made = nullptr;
    if (FUZZ_OK(nurbs_eval_knot_derivative(g, axis, knot, &made))) {
        double domain[2];
        std::vector<double> first(static_cast<size_t>(s.axes()));
        for (int k = 0; k < s.axes(); ++k) {
            FUZZ_REQUIRE(nurbs_domain(made, k, domain) == NURBS_OK);
            first[static_cast<size_t>(k)] = domain[0];
        }
        std::vector<double> point(static_cast<size_t>(s.dim));
        FUZZ_REQUIRE(nurbs_eval(made, 1, first.data(), 0, 0, point.data(), 0, 0, 0) == NURBS_OK);
    }
    FUZZ_REQUIRE(sane || made == nullptr);
    nurbs_destroy(made);
}

// Through feet that are none, and of lengths: all is finite or refused, and nothing is written then.
void query_gradients(Input &in, const nurbs *g, const fuzz::Spline &s, const Batch &b) {
    Gradients out(s, b.n);
    std::vector<double> points(static_cast<size_t>(b.n * s.dim)), queries(points.size(), -7);
    std::generate(points.begin(), points.end(), [&] { return 2 * in.unit() - 1; });
    std::vector<int32_t> status(static_cast<size_t>(b.n), -7);
    if (!FUZZ_OK(nurbs_closest_adjoint(g, b.n, points.data(), b.params.data(), b.params.data(), points.data(),
                                       nullptr, out.points.data(), out.weights.data(), queries.data(),
                                       status.data(), in.coin() ? NURBS_NAN_POINTS : 0))) {
        FUZZ_REQUIRE(!b.inside && untouched(out.points) && untouched(out.weights) && untouched(queries) &&
                     untouched(status));
    }
    Gradients lengths(s, 0);
    if (!FUZZ_OK(nurbs_length_adjoint(g, nullptr, in.coin() ? 1e-3 : 1e-6, 1, lengths.points.data(), 0, 0,
                                      lengths.weights.data(), 0, nullptr, 0))) {
        FUZZ_REQUIRE(untouched(lengths.points) && untouched(lengths.weights));
    } else {
        FUZZ_REQUIRE(s.axes() == 1);
    }
}

// Sizes that cannot be served leave the outputs alone.
void bad_sizes(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), 2, true);
    const int64_t bad = in.bad_size();
    Rows rows(2, row_width(s));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_rational_collocation(g, nullptr, bad, params.data(), 0, 0, rows.cap(),
                                                     rows.values.data(), rows.columns.data(),
                                                     rows.pointers.data(), &rows.entries, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_rational_collocation(g, nullptr, 2, params.data(), 0, 0, rows.cap() - 1,
                                                     rows.values.data(), rows.columns.data(),
                                                     rows.pointers.data(), &rows.entries, 0)));
    FUZZ_REQUIRE(rows.intact());
    Gradients out(s, 2);
    const std::vector<double> cotangents(static_cast<size_t>(2 * s.dim), 1.0);
    FUZZ_REQUIRE(!FUZZ_OK(adjoint(g, in.bad_int(), {2, true, 0, params}, cotangents, out, 0)));
    FUZZ_REQUIRE(!FUZZ_OK(adjoint(g, 0, {bad, true, 0, params}, cotangents, out, 0)));
    FUZZ_REQUIRE(untouched(out.points) && untouched(out.weights) && untouched(out.params));
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
    matrices(in, g.get(), s, b);
    extraction(in, g.get(), s);
    gradients(in, g.get(), s, b);
    knot_gradients(in, g.get(), s, b);
    query_gradients(in, g.get(), s, b);
    bad_sizes(in, g.get(), s);
    return 0;
}
