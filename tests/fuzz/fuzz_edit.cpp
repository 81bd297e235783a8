// Weights and control points: what a result says of itself holds when it is evaluated.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

int64_t any_index(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.bad_size() : in.below(static_cast<int>(std::min<int64_t>(s.total, 255)));
}

std::vector<double> any_vector(Input &in, int32_t dim) {
    std::vector<double> x;
    for (int32_t c = 0; c < dim; ++c) {
        x.push_back(in.rarely() ? in.anything() : in.number());
    }
    return x;
}

double any_distance(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.anything() : s.size() * (2 * in.unit() - 1) * (in.coin() ? 1 : 1e-3);
}

std::vector<double> point_of(const nurbs *g, const std::vector<double> &param, int32_t dim) {
    std::vector<double> point(static_cast<size_t>(dim));
    FUZZ_REQUIRE(nurbs_eval(g, 1, param.data(), 0, 0, point.data(), 0, 0, 0) == NURBS_OK);
    return point;
}

double distance(const std::vector<double> &a, const std::vector<double> &b) {
    double sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum = std::hypot(sum, a[c] - b[c]);
    }
    return sum;
}

// Whether rounding is far below what is compared.
bool calm(const fuzz::Spline &s) {
    const double ratio = s.weight_ratio();
    return ratio > 0 && ratio < 1e3 && s.size() < 1e6;
}

void pull_weight(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int64_t index = any_index(in, s);
    const std::vector<double> param = fuzz::any_params(in, g, s.axes(), 1, false);
    const double length = any_distance(in, s);
    double weight = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_pull_weight(g, index, param.data(), length, &weight, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? weight > 0 && std::isfinite(weight) : weight == -7);
    if (h && calm(s) && weight < 1e3 && weight > 1e-3) {
        const double moved = distance(point_of(g, param, s.dim), point_of(h.get(), param, s.dim));
        const double rounding = fuzz::eps * fuzz::accuracy(s.degrees) * s.size();
        FUZZ_REQUIRE(std::fabs(moved - std::fabs(length)) <= 1e4 * static_cast<double>(s.total) * rounding);
    }
}

void many_weights(Input &in, const nurbs *g, const fuzz::Spline &s) {
    std::vector<int64_t> indices(static_cast<size_t>(in.below(4)));
    std::generate(indices.begin(), indices.end(), [&] { return any_index(in, s); });
    const std::vector<double> param = fuzz::any_params(in, g, s.axes(), 1, false);
    const auto count = static_cast<int64_t>(indices.size());
    double factor = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status pulled =
        nurbs_pull_weights(g, count, indices.data(), param.data(), any_distance(in, s), &factor, &out);
    const fuzz::Handle h(FUZZ_MADE(pulled, out));
    FUZZ_REQUIRE(h ? factor > 0 : factor == -7);
    const std::vector<double> given = any_vector(in, static_cast<int32_t>(count));
    out = fuzz::poison();
    const nurbs_status set = nurbs_set_weights(g, count, indices.data(), given.data(), &out);
    const fuzz::Handle i(FUZZ_MADE(set, out));
}

void weight_points(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int64_t index = any_index(in, s);
    const std::vector<double> param = fuzz::any_params(in, g, s.axes(), 1, false);
    const auto dim = static_cast<size_t>(s.dim);
    std::vector<double> zero(dim, -7.0), one(dim, -7.0), present(dim, -7.0);
    if (!FUZZ_OK(nurbs_weight_points(g, index, param.data(), zero.data(), one.data(), present.data()))) {
        FUZZ_REQUIRE(zero[0] == -7 && one[0] == -7 && present[0] == -7);
        return;
    }
    double ratio = 0;
    const double *p = s.points.data() + static_cast<size_t>(index) * dim;
    static_cast<void>(
        FUZZ_OK(nurbs_weight_cross_ratio(s.dim, p, zero.data(), one.data(), present.data(), &ratio)));
    const double tolerance = in.rarely() ? in.anything() : in.unit() * s.size();
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_weight_through(g, index, param.data(), one.data(), tolerance, &ratio, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
}

void pull_point(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int64_t index = any_index(in, s);
    const std::vector<double> param = fuzz::any_params(in, g, s.axes(), 1, false);
    const std::vector<double> direction = any_vector(in, s.dim);
    const double length = any_distance(in, s);
    double moved = 0;
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_pull_point(g, index, param.data(), direction.data(), length, &moved, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h && calm(s) && std::fabs(moved) < 1e6) {
        const double got = distance(point_of(g, param, s.dim), point_of(h.get(), param, s.dim));
        FUZZ_REQUIRE(std::fabs(got - std::fabs(length)) <=
                     1e6 * fuzz::eps * fuzz::accuracy(s.degrees) * (s.size() + std::fabs(moved)));
    }
}

void influential(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int64_t n = in.below(4);
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), n, false);
    std::vector<int64_t> indices(static_cast<size_t>(n), -7);
    std::vector<double> influences(static_cast<size_t>(n));
    const bool ok =
        FUZZ_OK(nurbs_most_influential(g, n, params.data(), 0, 0, indices.data(), influences.data()));
    for (size_t i = 0; i < indices.size(); ++i) {
        FUZZ_REQUIRE(ok ? indices[i] >= 0 && indices[i] < s.total && influences[i] > 0 : indices[i] == -7);
    }
}

void insertion(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const double share = in.rarely() ? in.anything() : in.unit();
    double knot = 0, ratio = 0;
    int64_t index = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_insert_on_leg(g, axis, any_index(in, s), share, &knot, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h) {
        double before[2], after[2];
        FUZZ_REQUIRE(nurbs_domain(g, axis, before) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_domain(h.get(), axis, after) == NURBS_OK);
        FUZZ_REQUIRE(before[0] == after[0] && before[1] == after[1]);
    }
    const std::vector<double> point = any_vector(in, s.dim);
    const double tolerance = in.coin() ? HUGE_VAL : in.number();
    out = fuzz::poison();
    const nurbs_status found =
        nurbs_insert_at_point(g, axis, point.data(), tolerance, &index, &ratio, &knot, &out);
    const fuzz::Handle i(FUZZ_MADE(found, out));
    FUZZ_REQUIRE(i ? ratio >= 0 && ratio <= 1 && index >= 0 : index == -7);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g && s.total <= 400) {
        pull_weight(in, g.get(), s);
        many_weights(in, g.get(), s);
        weight_points(in, g.get(), s);
        pull_point(in, g.get(), s);
        influential(in, g.get(), s);
        insertion(in, g.get(), s);
    }
    return 0;
}
