// Closest points: certified ones are nearer than samples, whatever the spline.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

struct Feet {
    Feet(int64_t n, int axes, int dim)
        : params(static_cast<size_t>(n) * static_cast<size_t>(axes)),
          feet(static_cast<size_t>(n) * static_cast<size_t>(dim)), distances(static_cast<size_t>(n)),
          status(static_cast<size_t>(n)) {}
    std::vector<double> params, feet, distances;
    std::vector<int32_t> status;
};

std::vector<double> any_points(Input &in, const fuzz::Spline &s, int n) {
    std::vector<double> points(static_cast<size_t>(n) * static_cast<size_t>(s.dim));
    for (double &x : points) {
        x = in.rarely() ? in.anything() : in.coin() ? in.number() : s.size() * (2 * in.unit() - 1);
    }
    return points;
}

// Parameters of the whole domain, or of the range.
std::vector<double> sample(Input &in, const nurbs *g, const fuzz::Spline &s, const double *range) {
    std::vector<double> param;
    for (int32_t k = 0; k < s.axes32(); ++k) {
        double domain[2];
        FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
        const double lower = range != nullptr ? range[2 * k] : domain[0];
        const double upper = range != nullptr ? range[2 * k + 1] : domain[1];
        param.push_back(std::clamp(lower + in.unit() * (upper - lower), lower, upper));
    }
    return param;
}

double distance(const double *a, const double *b, int n) {
    double sum = 0;
    for (int c = 0; c < n; ++c) {
        sum = std::hypot(sum, a[c] - b[c]);
    }
    return sum;
}

void extremal(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int n = 1 + in.below(4);
    const std::vector<double> points = any_points(in, s, n);
    std::vector<double> range;
    for (int32_t k = 0; k < s.axes32(); ++k) {
        range.push_back(fuzz::any_param(in, g, k, true));
        range.push_back(fuzz::any_param(in, g, k, true));
        if (!in.rarely()) {
            std::sort(range.end() - 2, range.end());
        }
    }
    const double *part = in.coin() ? range.data() : nullptr;
    const bool far = in.coin();
    const double tolerance = in.rarely() ? in.anything() : in.coin() ? 0 : s.size() * 1e-6;
    const int64_t budget = in.rarely() ? in.bad_size() : in.below(3) * 100;
    Feet out(n, s.axes(), s.dim);
    const uint32_t flags = in.coin() ? NURBS_NAN_POINTS : 0;
    const nurbs_status result =
        far ? nurbs_farthest_points(g, n, points.data(), 0, 0, part, tolerance, budget, out.params.data(), 0,
                                    0, out.feet.data(), 0, 0, out.distances.data(), 0, out.status.data(),
                                    flags)
            : nurbs_closest_points(g, n, points.data(), 0, 0, part, tolerance, budget, out.params.data(), 0,
                                   0, out.feet.data(), 0, 0, out.distances.data(), 0, out.status.data(),
                                   flags);
    if (!FUZZ_OK(result)) {
        return;
    }
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<size_t>(i);
        const double *x = points.data() + i * s.dim;
        if ((out.status[at] & NURBS_CLOSEST_CERTIFIED) == 0) {
            continue;
        }
        FUZZ_REQUIRE((out.status[at] & (NURBS_CLOSEST_BUDGET | NURBS_CLOSEST_INVALID)) == 0);
        double reach = s.size();
        for (int c = 0; c < s.dim; ++c) {
            reach = std::max(reach, std::fabs(x[c]));
        }
        const std::vector<double> param = sample(in, g, s, part);
        std::vector<double> point(static_cast<size_t>(s.dim));
        FUZZ_REQUIRE(nurbs_eval(g, 1, param.data(), 0, 0, point.data(), 0, 0, 0) == NURBS_OK);
        const double beside = distance(point.data(), x, s.dim), found = out.distances[at];
        const double allowed = tolerance + 4096 * fuzz::eps * reach * std::max(1.0, s.weight_ratio());
        if (std::isfinite(beside) && reach < 1e140 && reach > 1e-140) {
            FUZZ_REQUIRE((far ? beside - found : found - beside) <= allowed);
        }
    }
}

void local(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> points = any_points(in, s, 1), guess = sample(in, g, s, nullptr);
    Feet out(1, s.axes(), s.dim);
    if (FUZZ_OK(nurbs_closest_local(g, 1, points.data(), 0, 0, guess.data(), 0, 0, out.params.data(), 0, 0,
                                    out.feet.data(), 0, 0, out.distances.data(), 0, out.status.data(), 0))) {
        FUZZ_REQUIRE((out.status[0] & NURBS_CLOSEST_CERTIFIED) == 0);
    }
}

void lists(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> point = any_points(in, s, 1);
    const double tolerance = s.size() * std::ldexp(1, -in.below(40));
    const int64_t budget = 1 + in.below(200);
    int64_t count = 0;
    int32_t status = 0;
    const bool critical = in.coin();
    std::vector<double> params, distances;
    std::vector<int32_t> kinds;
    for (int64_t cap = 0;; cap = count) {
        params.resize(static_cast<size_t>(cap * s.axes()));
        distances.resize(static_cast<size_t>(cap));
        kinds.resize(static_cast<size_t>(cap));
        const nurbs_status result =
            critical ? nurbs_critical_points(g, point.data(), nullptr, tolerance, budget, cap, params.data(),
                                             distances.data(), kinds.data(), &count, &status)
                     : nurbs_closest_all(g, point.data(), nullptr, tolerance, budget, cap, params.data(),
                                         distances.data(), &count, &status);
        if (!FUZZ_OK(result) || cap == count) {
            break;
        }
    }
    for (const int32_t kind : kinds) {
        FUZZ_REQUIRE(!critical || (kind >= NURBS_CRITICAL_MINIMUM && kind <= NURBS_CRITICAL_UNDECIDED));
    }
}

void signed_distance(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const std::vector<double> points = any_points(in, s, 2);
    double distances[2], params[2];
    int32_t status[2];
    if (FUZZ_OK(nurbs_curve_signed_distances(g, 2, points.data(), 0, 0, 0, 0, distances, 0, params, 0, status,
                                             in.coin() ? NURBS_NAN_POINTS : 0))) {
        FUZZ_REQUIRE(s.axes() == 1 && s.dim == 2);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    switch (in.below(4)) {
    case 0:
        extremal(in, g.get(), s);
        break;
    case 1:
        local(in, g.get(), s);
        break;
    case 2:
        lists(in, g.get(), s);
        break;
    default:
        signed_distance(in, g.get(), s);
    }
    return 0;
}
