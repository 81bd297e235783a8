// Features of shapes: lengths and orders of what is returned, and what holds at points.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

bool rising(const std::vector<double> &values) {
    return std::is_sorted(values.begin(), values.end());
}

bool inside(const nurbs *g, int32_t axis, double t) {
    double domain[2];
    FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_OK);
    return t >= domain[0] && t <= domain[1];
}

void features(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const auto kinds = in.rarely() ? static_cast<uint32_t>(in.bits())
                                   : static_cast<uint32_t>(in.below(s.dim == 3 ? 128 : 64));
    int64_t count = -1;
    int32_t complete = -1;
    if (!FUZZ_OK(nurbs_curve_features(g, kinds, 0, nullptr, nullptr, nullptr, &count, &complete))) {
        return;
    }
    FUZZ_REQUIRE(count >= 0 && (complete == 0 || complete == 1));
    const auto n = static_cast<size_t>(count);
    std::vector<double> params(n), values(n);
    std::vector<int32_t> found(n);
    FUZZ_REQUIRE(nurbs_curve_features(g, kinds, count, params.data(), found.data(), values.data(), &count,
                                      nullptr) == NURBS_OK);
    FUZZ_REQUIRE(rising(params));
    for (size_t i = 0; i < n; ++i) {
        FUZZ_REQUIRE(inside(g, 0, params[i]) && (static_cast<uint32_t>(found[i]) & kinds) != 0);
        FUZZ_REQUIRE(found[i] != NURBS_FEATURE_JUMP || values[i] > 0);
    }
    FUZZ_REQUIRE(n < 2 || nurbs_curve_features(g, kinds, count - 1, params.data(), nullptr, nullptr, nullptr,
                                               nullptr) == NURBS_ERROR_SIZE);
}

void pieces(Input &in, const nurbs *g, const fuzz::Spline &s) {
    std::vector<double> direction(static_cast<size_t>(s.dim));
    for (double &x : direction) {
        x = in.rarely() ? in.anything() : in.number();
    }
    int64_t count = -1;
    if (!FUZZ_OK(nurbs_curve_monotone_pieces(g, direction.data(), 0, nullptr, nullptr, &count, nullptr))) {
        return;
    }
    FUZZ_REQUIRE(count >= 1);
    std::vector<double> starts(static_cast<size_t>(count));
    std::vector<int32_t> signs(starts.size());
    FUZZ_REQUIRE(nurbs_curve_monotone_pieces(g, direction.data(), count, starts.data(), signs.data(), nullptr,
                                             nullptr) == NURBS_OK);
    FUZZ_REQUIRE(rising(starts) && inside(g, 0, starts.front()) && inside(g, 0, starts.back()));
    FUZZ_REQUIRE(std::all_of(signs.begin(), signs.end(), [](int32_t x) { return x >= -1 && x <= 1; }));
}

// The distance of points from a line or a plane.
void flatness(const nurbs *g, const fuzz::Spline &s) {
    const auto dim = static_cast<size_t>(s.dim);
    std::vector<double> origin(dim), direction(dim), params, points(5 * dim);
    double bound = -1;
    if (!FUZZ_OK(nurbs_straightness(g, origin.data(), direction.data(), &bound))) {
        return;
    }
    for (int i = 0; i < 5; ++i) {
        for (int32_t k = 0; k < s.axes32(); ++k) {
            double domain[2];
            FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
            params.push_back(std::clamp(domain[0] + (domain[1] - domain[0]) * i / 4, domain[0], domain[1]));
        }
    }
    FUZZ_REQUIRE(nurbs_eval(g, 5, params.data(), 0, 0, points.data(), 0, 0, 0) == NURBS_OK);
    for (size_t i = 0; i < points.size(); i += dim) {
        double along = 0, far = 0;
        for (size_t c = 0; c < dim; ++c) {
            along += (points[i + c] - origin[c]) * direction[c];
        }
        for (size_t c = 0; c < dim; ++c) {
            far = std::hypot(far, points[i + c] - origin[c] - along * direction[c]);
        }
        FUZZ_REQUIRE(!(far > bound + 4096 * fuzz::accuracy(s.degrees) * fuzz::eps * s.size()));
    }
    if (FUZZ_OK(nurbs_planarity(g, nullptr, direction.data(), &bound))) {
        FUZZ_REQUIRE(bound >= 0);
    }
}

void contacts(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const auto axes = static_cast<size_t>(s.axes());
    std::vector<int32_t> closed(axes), collapsed(2 * axes);
    std::vector<double> gaps(axes), sizes(2 * axes);
    const double tolerance = in.rarely() ? in.anything() : in.unit();
    if (FUZZ_OK(nurbs_boundary_contacts(g, tolerance, closed.data(), gaps.data(), collapsed.data(),
                                        sizes.data()))) {
        for (size_t k = 0; k < axes; ++k) {
            FUZZ_REQUIRE((closed[k] == 1) == (gaps[k] <= tolerance) && gaps[k] >= 0);
        }
        for (size_t i = 0; i < 2 * axes; ++i) {
            FUZZ_REQUIRE((collapsed[i] == 1) == (sizes[i] <= tolerance) && sizes[i] >= 0);
        }
    }
}

void singular(const nurbs *g, const fuzz::Spline &s) {
    int64_t count = -1;
    if (!FUZZ_OK(nurbs_singular_points(g, 0.1, 0, nullptr, nullptr, &count, nullptr))) {
        return;
    }
    const auto axes = static_cast<size_t>(s.axes());
    std::vector<double> params(static_cast<size_t>(count) * axes), boxes(2 * params.size());
    FUZZ_REQUIRE(nurbs_singular_points(g, 0.1, count, params.data(), boxes.data(), &count, nullptr) ==
                 NURBS_OK);
    for (size_t i = 0; i < params.size(); ++i) {
        FUZZ_REQUIRE(boxes[2 * i] <= params[i] && params[i] <= boxes[2 * i + 1]);
        FUZZ_REQUIRE(inside(g, static_cast<int32_t>(i % axes), params[i]));
    }
}

void fold(Input &in, const nurbs *g, const fuzz::Spline &s) {
    double reference[3];
    std::generate(reference, reference + 3, [&] { return in.rarely() ? in.anything() : in.number(); });
    int32_t result = -1;
    double at[6];
    const bool given = s.axes() == 2 && s.dim == 3 && in.coin();
    if (FUZZ_OK(nurbs_fold_test(g, given ? reference : nullptr, &result, at, at + 3))) {
        FUZZ_REQUIRE(result >= NURBS_FOLD_NONE && result <= NURBS_FOLD_UNDECIDED);
        FUZZ_REQUIRE((result == NURBS_FOLD_FOUND) == (!std::isnan(at[0]) && !std::isnan(at[3])));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    int64_t degrees = 1;
    for (const int32_t p : s.degrees) {
        degrees *= p + 1;
    }
    if (!g || degrees > 40) { // the time grows with the square of this
        return 0;
    }
    features(in, g.get(), s);
    pieces(in, g.get(), s);
    int32_t convexity = -1;
    if (FUZZ_OK(nurbs_curve_convexity(g.get(), &convexity))) {
        FUZZ_REQUIRE(convexity >= NURBS_CONVEXITY_NONE && convexity <= NURBS_CONVEXITY_UNDECIDED);
    }
    flatness(g.get(), s);
    contacts(in, g.get(), s);
    singular(g.get(), s);
    fold(in, g.get(), s);
    return 0;
}
