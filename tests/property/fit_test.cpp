// Least squares: splines come back, small fits are those of exact arithmetic, residuals are orthogonal, and nothing depends
// on scale.
#include "property/fits.h"

#include <cstdint>
#include <numbers>

namespace fit_test {

using namespace support;
using namespace support::fits;
using namespace support::products;
using reference::eps;

namespace {

// So many places in each span of an axis that they determine all control points.
std::vector<double> places_for(Random &random, const SplineData &data, int k) {
    const auto at = static_cast<size_t>(k);
    const auto &knots = data.knots[at];
    const auto p = static_cast<size_t>(data.degrees[at]);
    std::vector<double> places;
    for (size_t i = p; i + p + 1 < knots.size(); ++i) {
        for (size_t j = 0; knots[i] < knots[i + 1] && j < p + 2; ++j) {
            // Near Chebyshev's points, at which data determine polynomials of high degrees well.
            const double angle =
                (static_cast<double>(j) + random.between(0.3, 0.7)) / static_cast<double>(p + 2);
            const double part = (1 - std::cos(std::numbers::pi * angle)) / 2;
            places.push_back(std::min(knots[i] + part * (knots[i + 1] - knots[i]), knots[i + 1]));
        }
    }
    return places;
}

Sample sample_of(Random &random, const SplineData &data) {
    std::vector<std::vector<double>> places;
    size_t size = 1;
    for (int k = 0; k < data.axes(); ++k) {
        places.push_back(places_for(random, data, k));
        size *= places.back().size();
    }
    Sample sample{data.axes(), data.dim, {}, {}, {}};
    for (size_t i : permutation(random, size)) {
        std::vector<double> param(places.size());
        for (size_t k = places.size(); k-- > 0;) {
            param[k] = places[k][i % places[k].size()];
            i /= places[k].size();
        }
        sample.params.insert(sample.params.end(), param.begin(), param.end());
    }
    sample.values = eval(create(data).get(), sample.params);
    if (random.chance(40)) {
        for (size_t i = 0; i < size; ++i) {
            sample.weights.push_back(random.between(0.25, 4));
        }
    }
    return sample;
}

Recipe fit_recipe(Random &random, int axes) {
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 12 : axes == 2 ? 5 : 3);
    recipe.weights = Weights::none;
    for (AxisRecipe &axis : recipe.axes) {
        // The rounding of polar forms beyond the domain grows with the degree.
        axis.degree = axis.form == KnotForm::unclamped || axis.form == KnotForm::half_clamped
                          ? std::min(axis.degree, 8)
                          : axis.degree;
        axis.spacing = random.chance(50) ? Spacing::full : Spacing::few_bits;
        axis.spans = axes == 1 ? 6 : axes == 2 ? 4 : 2;
    }
    return recipe;
}

} // namespace

TEST(Fit, gives_splines_back) {
    WorstErrors worst("fitted splines by degree of axis 0, unit eps * largest control point");
    for_each_case(890000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        const SplineData data = random_spline(random, fit_recipe(random, axes));
        const Sample sample = sample_of(random, data);
        Fit fit(data);
        Handle back;
        const nurbs_status status = fit.run(sample, back);
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        constexpr long double bound = 100;
        const long double unit = eps * extent(data);
        const auto g = create(data);
        for (int i = 0; i < 8; ++i) {
            const auto param = random_params(random, data, 1);
            const auto a = eval(g.get(), param), b = eval(back.get(), param);
            for (size_t c = 0; c < a.size(); ++c) {
                const long double error = std::fabs(a[c] - b[c]);
                worst.add(data.degrees[0], error / (unit * bound), error / unit);
                ASSERT_LE(error, bound * unit) << where(seed, data) << hex(param);
            }
        }
        ASSERT_LE(fit.report.largest, static_cast<double>(bound * unit)) << where(seed, data);
        ASSERT_LE(fit.report.residual, 1e-20) << where(seed, data);
    });
}

// The solution of the normal equations in rational numbers. What may separate the two is what a perturbation of the data and
// of the basis by a few eps does: B^+ (dy + dB x) + (B^T B)^-1 dB^T r.
TEST(Fit, is_that_of_exact_arithmetic) {
    WorstErrors worst("small fits by degree, unit of the bound, and eps * condition");
    for_each_case(891000, 60, [&](Random &random, uint64_t seed) {
        const int p = random.whole(0, 4);
        const int64_t count = p + random.whole(1, 4);
        SplineData over = even_curve(p, count);
        Sample sample{1, 1, {}, {}, {}};
        const int64_t n = count + random.whole(0, 8);
        for (int64_t i = 0; i < n; ++i) {
            sample.params.push_back((static_cast<double>(i) + random.between(0.2, 0.8)) /
                                    static_cast<double>(n));
            sample.values.push_back(random.between(-1, 1));
        }
        Fit fit(over);
        Handle made;
        if (fit.run(sample, made) == NURBS_ERROR_RANK) {
            return;
        }
        const auto size = static_cast<size_t>(count);
        std::vector<std::vector<Rational>> basis;
        for (const double t : sample.params) {
            const auto &knots = over.knots[0];
            int64_t span = p;
            while (knots[static_cast<size_t>(span) + 1] <= t) {
                ++span;
            }
            basis.emplace_back();
            for (int64_t i = 0; i < count; ++i) {
                basis.back().push_back(reference::defined_basis(knots, span, i, p, reference::exact(t)));
            }
        }
        // [G | r | I] to [I | x | G^-1].
        std::vector<std::vector<Rational>> rows(size, std::vector<Rational>(2 * size + 1, Rational(0)));
        for (size_t i = 0; i < size; ++i) {
            for (size_t d = 0; d < basis.size(); ++d) {
                for (size_t j = 0; j < size; ++j) {
                    rows[i][j] += basis[d][i] * basis[d][j];
                }
                rows[i][size] += basis[d][i] * reference::exact(sample.values[d]);
            }
            rows[i][size + 1 + i] = 1;
        }
        for (size_t i = 0; i < size; ++i) {
            ASSERT_NE(rows[i][i], 0);
            const Rational pivot = rows[i][i];
            for (Rational &x : rows[i]) {
                x /= pivot;
            }
            for (size_t r = 0; r < size; ++r) {
                const Rational factor = rows[r][i];
                for (size_t j = 0; r != i && j < rows[i].size(); ++j) {
                    rows[r][j] -= factor * rows[i][j];
                }
            }
        }
        long double largest = 1, residual = 0, pseudo = 0, inverse = 0;
        for (size_t i = 0; i < size; ++i) {
            largest = std::max(largest, size_of(rows[i][size]));
            long double of_row = 0, of_inverse = 0;
            for (const auto &values : basis) {
                Rational sum = 0;
                for (size_t j = 0; j < size; ++j) {
                    sum += rows[i][size + 1 + j] * values[j];
                }
                of_row += size_of(sum);
            }
            for (size_t j = 0; j < size; ++j) {
                of_inverse += size_of(rows[i][size + 1 + j]);
            }
            pseudo = std::max(pseudo, of_row);
            inverse = std::max(inverse, of_inverse);
        }
        for (size_t d = 0; d < basis.size(); ++d) {
            Rational left = reference::exact(sample.values[d]);
            for (size_t j = 0; j < size; ++j) {
                left -= basis[d][j] * rows[j][size];
            }
            residual += size_of(left);
        }
        const long double condition = pseudo * largest + inverse * residual;
        const long double bound = 4 * eps * condition;
        const SplineData back = read_back(made.get());
        for (size_t i = 0; i < size; ++i) {
            const long double error = size_of(rows[i][size] - reference::exact(back.points[i]));
            worst.add(p, error / bound, error / (eps * condition));
            ASSERT_LE(error, bound) << "seed " << seed << " point " << i;
        }
    });
}

// B^T W (y - s) = 0, by the adjoint of evaluation.
TEST(Fit, leaves_residuals_that_are_orthogonal_to_all_splines) {
    for_each_case(892000, 60, [](Random &random, uint64_t seed) {
        const SplineData over = random_spline(random, fit_recipe(random, random.whole(1, 2)));
        Sample sample = sample_of(random, over);
        std::ranges::generate(sample.values, [&] { return random.between(-1, 1); });
        Fit fit(over);
        Handle made;
        require_ok(fit.run(sample, made));
        std::vector<double> left = eval(made.get(), sample.params);
        double weight = 0;
        for (size_t i = 0; i < left.size(); ++i) {
            const size_t point = i / static_cast<size_t>(sample.dim);
            const double own = sample.weights.empty() ? 1 : sample.weights[point];
            left[i] = own * (sample.values[i] - left[i]);
            weight += own;
        }
        std::vector<double> gradient(static_cast<size_t>(over.point_count() * over.dim));
        require_ok(nurbs_eval_adjoint(made.get(), 0, sample.size(), sample.params.data(), 0, 0, left.data(),
                                      0, 0, gradient.data(), 0, 0, nullptr, 0, nullptr, 0, 0, 0));
        const double size = std::max(1.0, extent(read_back(made.get())));
        for (int64_t i = 0; over.flags == 0 && i < std::ssize(gradient); ++i) {
            ASSERT_LE(std::fabs(gradient[static_cast<size_t>(i)]),
                      static_cast<double>(16 * eps) * weight * size)
                << where(seed, over);
        }
    });
}

TEST(Fit, is_free_of_scale) {
    for_each_case(893000, 100, [](Random &random, uint64_t seed) {
        const SplineData over = random_spline(random, fit_recipe(random, random.whole(1, 2)));
        Sample sample = sample_of(random, over);
        std::ranges::for_each(sample.values, [&](double &y) { y += random.between(-0.1, 0.1); });
        const double size = std::ldexp(1.0, random.whole(-40, 40)),
                     speed = std::ldexp(1.0, random.whole(-30, 30));
        Fit fit(over), other(scaled(over, size, speed));
        fit.options.smoothing = other.options.smoothing = random.whole(0, 3) == 0 ? NURBS_SMOOTHING_NONE
                                                          : random.chance(50)     ? NURBS_SMOOTHING_GCV
                                                                                  : NURBS_SMOOTHING_REML;
        fit.options.penalty_order = other.options.penalty_order = 1;
        if (std::ranges::all_of(over.degrees, [](int p) { return p == 0; })) {
            fit.options.smoothing = other.options.smoothing = NURBS_SMOOTHING_NONE;
        }
        Handle one, two;
        require_ok(fit.run(sample, one));
        std::ranges::for_each(sample.values, [size](double &x) { x *= size; });
        std::ranges::for_each(sample.params, [speed](double &t) { t *= speed; });
        std::ranges::for_each(sample.weights, [](double &w) { w *= 0x1p20; });
        require_ok(other.run(sample, two));
        ASSERT_TRUE(same_bits(scaled(read_back(one.get()), size, speed).points, read_back(two.get()).points))
            << where(seed, over);
    });
}

// P. J. Wampler, "A report on the accuracy of some widely used least squares computer programs" (1970), in the collection of
// the National Institute of Standards and Technology: degree 5, all coefficients 1, and 0.1^k. Values are right relative to
// themselves where they are alike, as those of the second set, 1 to 63; those of the first one, 1 to 3368421, are right
// relative to the largest one, since data are rounded relative to their scale.
TEST(Fit, passes_wampler) {
    for (const double base : {1.0, 0.1}) {
        Sample sample;
        double largest = 0;
        for (int i = 0; i <= 20; ++i) {
            sample.params.push_back(i);
            double y = 0;
            for (int k = 5; k >= 0; --k) {
                y = y * i + std::pow(base, k);
            }
            sample.values.push_back(y);
            largest = std::max(largest, y);
        }
        Fit fit(scaled(even_curve(5, 6), 1, 20));
        const Handle made = fit(sample);
        const auto values = eval(made.get(), sample.params);
        for (size_t i = 0; i < values.size(); ++i) {
            const double size = base == 1 ? largest : sample.values[i];
            EXPECT_LE(std::fabs(values[i] - sample.values[i]), 1e-14 * size) << base << ' ' << i;
        }
    }
}

TEST(Fit, converges_with_the_order_of_the_degree) {
    for (int p = 1; p <= 5; ++p) {
        double before = 0;
        for (const int64_t spans : {8, 16, 32}) {
            Sample sample;
            for (int i = 0; i <= 2000; ++i) {
                sample.params.push_back(i / 2000.0);
                sample.values.push_back(std::sin(7 * sample.params.back()));
            }
            Fit fit(even_curve(p, spans + p));
            (void)fit(sample);
            if (before > 0 && fit.report.largest > 1e-12) {
                EXPECT_GT(before / fit.report.largest, std::exp2(p + 1) * 0.7) << p << ' ' << spans;
            }
            before = fit.report.largest;
        }
    }
}

} // namespace fit_test
