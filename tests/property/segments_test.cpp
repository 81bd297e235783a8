// Basis matrices against exact products: inverse of each other, composable, and true to evaluation.
#include "property/same_shape.h"

namespace segments_test {

using namespace support;

namespace {

constexpr int32_t power = NURBS_BASIS_POWER, bernstein = NURBS_BASIS_BERNSTEIN, hermite = NURBS_BASIS_HERMITE;
constexpr int32_t bspline = NURBS_BASIS_BSPLINE;

std::vector<double> matrix(int32_t from, int32_t to, int32_t degree) {
    const int64_t size = (degree + 1) * (degree + 1);
    std::vector<double> m(static_cast<size_t>(size));
    require_ok(nurbs_basis_matrix(from, to, degree, size, m.data()));
    return m;
}

// |A B - expected| against the rounding of both factors.
void expect_product(const std::vector<double> &a, const std::vector<double> &b,
                    const std::vector<double> &expected, int32_t degree) {
    const auto n = static_cast<size_t>(degree) + 1;
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            long double sum = 0, size = 0;
            for (size_t k = 0; k < n; ++k) {
                const long double term = static_cast<long double>(a[i * n + k]) * b[k * n + j];
                sum += term;
                size += std::fabs(term);
            }
            const long double bound = 2 * reference::eps * (size + std::fabs(expected[i * n + j]));
            ASSERT_LE(std::fabs(sum - expected[i * n + j]), bound) << degree << ' ' << i << ' ' << j;
        }
    }
}

TEST(BasisMatrix, changes_compose_and_invert) {
    for (int32_t degree = 0; degree <= 21; ++degree) {
        std::vector<int32_t> bases = {power, bernstein, bspline};
        if (degree % 2 == 1) {
            bases.push_back(hermite);
        }
        for (const int32_t a : bases) {
            for (const int32_t b : bases) {
                for (const int32_t c : bases) {
                    expect_product(matrix(b, c, degree), matrix(a, b, degree), matrix(a, c, degree), degree);
                }
            }
        }
    }
}

// The B-spline segment is the middle span of a uniform spline; its Bezier points are what the pieces have.
TEST(BasisMatrix, of_the_b_spline_segment_is_the_exact_refinement) {
    for (int32_t p = 1; p <= 9; ++p) {
        const auto m = matrix(bspline, bernstein, p);
        for (int32_t j = 0; j <= p; ++j) {
            SplineData data;
            data.degrees = {p};
            data.counts = {p + 1};
            data.knots.resize(1);
            for (int32_t i = -p; i <= p + 1; ++i) {
                data.knots[0].push_back(i);
            }
            data.dim = 1;
            data.points.assign(static_cast<size_t>(p) + 1, 0);
            data.points[static_cast<size_t>(j)] = 1;
            nurbs *out = nullptr;
            require_ok(nurbs_clamp_ends(create(data).get(), 0, 3, &out));
            const SplineData piece = read_back(Handle(out).get());
            for (int32_t i = 0; i <= p; ++i) {
                const double want = m[static_cast<size_t>(i * (p + 1) + j)];
                ASSERT_NEAR(piece.points[static_cast<size_t>(i)], want, 4 * p * 0x1p-52 * want)
                    << p << ' ' << i;
            }
        }
    }
}

TEST(Hermite, curves_pass_through_points_with_their_tangents) {
    for_each_case(340000, 300, [](Random &random, uint64_t seed) {
        const int n = random.whole(2, 8), dim = random.whole(1, 4);
        std::vector<double> params{random.between(-5, 5)}, points, tangents;
        for (int i = 0; i < n * dim; ++i) {
            points.push_back(random.between(-1, 1));
            tangents.push_back(random.between(-1, 1));
        }
        for (int i = 1; i < n; ++i) {
            params.push_back(params.back() + random.magnitude(0.01, 100));
        }
        nurbs *out = nullptr;
        require_ok(
            nurbs_create_hermite(n, params.data(), dim, points.data(), 0, 0, tangents.data(), 0, 0, &out));
        const SplineData data = read_back(Handle(out).get());
        for (int i = 0; i < n; ++i) {
            for (const bool left : {false, true}) {
                const double t = params[static_cast<size_t>(i)];
                const auto derivs = reference::exact_derivatives(data, 1, &t, {left});
                for (int c = 0; c < dim; ++c) {
                    const auto at = static_cast<size_t>(i * dim + c);
                    const double size = 1 + 100.0;
                    ASSERT_LE(reference::distance(points[at], derivs[0][static_cast<size_t>(c)]),
                              8 * 0x1p-52L * size)
                        << seed;
                    const double h = i > 0 ? t - params[static_cast<size_t>(i) - 1] : params[1] - t;
                    const double g = i + 1 < n ? params[static_cast<size_t>(i) + 1] - t : h;
                    ASSERT_LE(reference::distance(tangents[at], derivs[1][static_cast<size_t>(c)]),
                              16 * 0x1p-52L * (1 + 1 / std::min(g, h)) + 16 * 0x1p-52L * size)
                        << seed;
                }
            }
        }
    });
}

} // namespace

} // namespace segments_test
