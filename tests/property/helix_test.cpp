// Helices: their proven error, and how their pieces join.
#include "property/made_curves.h"

namespace helix_test {

using namespace support;
using namespace support::curves;

namespace {

struct HelixCase {
    double radius, growth, pitch, start, turns;
};

// The largest distance between a point and the true one at the same angle.
double helix_error(const nurbs *g, const HelixCase &h, int n) {
    Vec params;
    for (int i = 0; i <= n; ++i) {
        params.push_back(h.turns * i / n);
    }
    const Vec points = eval(g, params);
    long double worst = 0;
    for (size_t i = 0; i < params.size(); ++i) {
        const long double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
        // The whole turns are those that the parameter, which goes nearly evenly, comes closest to.
        const long double near = 2 * std::numbers::pi_v<long double> * params[i];
        const long double seen = std::atan2(y, x) - h.start;
        const long double turn = 2 * std::numbers::pi_v<long double>;
        const long double angle = seen + turn * std::round((near - seen) / turn);
        const long double radius = h.radius + h.growth * angle / turn, rise = h.pitch * angle / turn;
        const long double off = std::hypot(std::hypot(x, y) - radius, z - rise);
        worst = std::max(worst, off);
    }
    return static_cast<double>(worst);
}

TEST(Curves, helices_keep_their_proven_error) {
    const std::array<HelixCase, 4> cases = {
        {{2, 0, 3, 0.5, 3}, {0.5, 1, 0, -1, 2.5}, {2, -0.3, 0.7, 0, 5}, {1, 0, -1, 2, 0.1}}};
    for (const HelixCase &h : cases) {
        for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
            double error = -1;
            const Handle g = made([&](nurbs **out) {
                return nurbs_curve_helix(3, nullptr, nullptr, nullptr, h.radius, h.growth, h.pitch, h.start,
                                         h.turns, tolerance, &error, out);
            });
            const double size = h.radius + std::fabs(h.growth * h.turns) + std::fabs(h.pitch * h.turns);
            const double worst = helix_error(g.get(), h, 20000);
            ASSERT_GT(error, 0);
            ASSERT_LE(error, tolerance);
            ASSERT_LE(worst, error + 8 * double_eps * size);
            ASSERT_GE(worst + 8 * double_eps * size, 0.8 * error); // the bound is a close one
        }
    }
}

// C' x C'' of a point and its derivatives.
Vec binormal(const Vec &d) {
    return {d[4] * d[8] - d[5] * d[7], d[5] * d[6] - d[3] * d[8], d[3] * d[7] - d[4] * d[6]};
}

TEST(Curves, pieces_of_a_helix_join_with_their_curvature) {
    const Handle g = made([](nurbs **out) {
        return nurbs_curve_helix(3, nullptr, nullptr, nullptr, 2, -0.3, 0.7, 0, 3, 1e-4, nullptr, out);
    });
    int64_t n = 0;
    require_ok(nurbs_distinct_knots(g.get(), 0, 0, nullptr, nullptr, &n));
    Vec knots(static_cast<size_t>(n));
    require_ok(nurbs_distinct_knots(g.get(), 0, n, knots.data(), nullptr, &n));
    ASSERT_GT(n, 10);
    for (size_t i = 1; i + 1 < knots.size(); ++i) {
        const Vec right = eval_derivs(g.get(), 2, {knots[i]}),
                  left = eval_derivs(g.get(), 2, {knots[i]}, NURBS_LEFT);
        for (size_t c = 0; c < 3; ++c) { // equal pieces: not only directions agree
            ASSERT_NEAR(left[3 + c], right[3 + c], 1e-12 * largest(right)) << "knot " << i;
            ASSERT_NEAR(binormal(left)[c], binormal(right)[c], 1e-10 * largest(binormal(right)))
                << "knot " << i;
        }
    }
}

} // namespace

} // namespace helix_test
