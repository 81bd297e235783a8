// SPDX-License-Identifier: MIT
#include "implicit_argument.h"

#include "base/error.h"
#include "checks.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace nrb::capi {

namespace {

constexpr int most_degree = 8;
constexpr int64_t most_coefficients = 10000;

} // namespace

intersect::ImplicitForm checked_form(int dim, int32_t degree, const double *coefficients) {
    require(coefficients, "coefficients");
    if (degree < 1 || degree > most_degree) {
        fail(Status::degree, "degree = %d of the polynomial, expected 1 to %d", degree, most_degree);
    }
    const int64_t count = intersect::monomials(dim, degree);
    if (degree > 1 && count > most_coefficients) {
        fail(Status::degree,
             "degree = %d of the polynomial: %lld coefficients in dimension %d, expected at most %lld",
             degree, static_cast<long long>(count), dim, static_cast<long long>(most_coefficients));
    }
    const std::span<const double> all(coefficients, static_cast<size_t>(count));
    for (size_t i = 0; i < all.size(); ++i) {
        if (!std::isfinite(all[i])) {
            fail(Status::point_not_finite, "coefficients[%zu] = %s, expected a finite value", i,
                 Number(all[i]).text);
        }
    }
    if (std::ranges::all_of(all.first(all.size() - 1), [](double c) { return c == 0; })) {
        fail(Status::direction, "coefficients: all but the last of %zu are 0", all.size());
    }
    return {dim, degree, all};
}

} // namespace nrb::capi
