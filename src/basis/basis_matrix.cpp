// SPDX-License-Identifier: MIT
#include "basis/basis_matrix.h"

#include <cmath>

namespace nrb::inline basis {

namespace {

__extension__ typedef __int128 Integer;
__extension__ typedef unsigned __int128 Natural;

constexpr int size = max_matrix_degree + 1;

// Entry (i, j) is numerators[i][j] / denominators[j].
struct Fractions {
    Integer numerators[size][size] = {};
    Integer denominators[size] = {};
};

Integer binomial(int n, int k) noexcept {
    Integer result = 1;
    for (int i = 1; i <= k; ++i) {
        result = result * (n - k + i) / i;
    }
    return k < 0 || k > n ? 0 : result;
}

// n (n - 1) ... (n - k + 1)
Integer falling(int n, int k) noexcept {
    Integer result = 1;
    for (int i = 0; i < k; ++i) {
        result *= n - i;
    }
    return result;
}

int sign(int k) noexcept {
    return k % 2 == 0 ? 1 : -1;
}

void power_to_bernstein(int p, Fractions &m) noexcept {
    for (int k = 0; k <= p; ++k) {
        m.denominators[k] = binomial(p, k);
        for (int i = k; i <= p; ++i) {
            m.numerators[i][k] = binomial(i, k);
        }
    }
}

void hermite_to_bernstein(int p, Fractions &m) noexcept {
    const int half = (p + 1) / 2;
    for (int k = 0; k < half; ++k) {
        m.denominators[k] = m.denominators[half + k] = falling(p, k);
        for (int i = k; i < half; ++i) {
            m.numerators[i][k] = binomial(i, k);
            m.numerators[p - i][half + k] = sign(k) * binomial(i, k);
        }
    }
}

// Row i is the polar form (blossom) at p - i zeros and i ones. In step d of de Boor's algorithm all
// denominators are d.
void bspline_to_bernstein(int p, Fractions &m) noexcept {
    for (int i = 0; i <= p; ++i) {
        Integer row[size] = {1};
        for (int d = 1; d <= p; ++d) {
            const int t = d <= i ? 1 : 0;
            Integer carried = 0;
            for (int r = 0; r < d; ++r) { // between the knots r + 1 - d and r + 1
                const Integer value = row[r];
                row[r] = carried + value * (r + 1 - t);
                carried = value * (t - (r + 1 - d));
            }
            row[d] = carried;
        }
        for (int j = 0; j <= p; ++j) {
            m.numerators[i][j] = row[j];
            m.denominators[j] = falling(p, p);
        }
    }
}

void bernstein_to_power(int p, Integer (&m)[size][size]) noexcept {
    for (int k = 0; k <= p; ++k) {
        for (int i = 0; i <= k; ++i) {
            m[k][i] = sign(k - i) * binomial(p, k) * binomial(k, i);
        }
    }
}

void bernstein_to_hermite(int p, Integer (&m)[size][size]) noexcept {
    const int half = (p + 1) / 2;
    for (int k = 0; k < half; ++k) {
        for (int i = 0; i <= k; ++i) {
            m[k][i] = m[half + k][p - k + i] = sign(k - i) * falling(p, k) * binomial(k, i);
        }
    }
}

// Row j is the polar form at j + 1 - p, ..., j: the coefficients of the product of the factors (1 - u) + u z
// for these u.
void bernstein_to_bspline(int p, Integer (&m)[size][size]) noexcept {
    for (int j = 0; j <= p; ++j) {
        Integer row[size + 1] = {1};
        for (int d = 1; d <= p; ++d) {
            const int u = j - p + d;
            for (int i = d; i >= 0; --i) {
                row[i] = row[i] * (1 - u) + (i > 0 ? row[i - 1] * u : 0);
            }
        }
        for (int i = 0; i <= p; ++i) {
            m[j][i] = row[i];
        }
    }
}

Fractions to_bernstein(SegmentBasis from, int p) noexcept {
    Fractions m;
    switch (from) {
    case SegmentBasis::power:
        power_to_bernstein(p, m);
        break;
    case SegmentBasis::hermite:
        hermite_to_bernstein(p, m);
        break;
    case SegmentBasis::bspline:
        bspline_to_bernstein(p, m);
        break;
    case SegmentBasis::bernstein:
        for (int i = 0; i <= p; ++i) {
            m.numerators[i][i] = m.denominators[i] = 1;
        }
        break;
    }
    return m;
}

void from_bernstein(SegmentBasis to, int p, Integer (&m)[size][size]) noexcept {
    switch (to) {
    case SegmentBasis::power:
        bernstein_to_power(p, m);
        break;
    case SegmentBasis::hermite:
        bernstein_to_hermite(p, m);
        break;
    case SegmentBasis::bspline:
        bernstein_to_bspline(p, m);
        break;
    case SegmentBasis::bernstein:
        for (int i = 0; i <= p; ++i) {
            m[i][i] = 1;
        }
        break;
    }
}

// The double nearest to n / d, d > 0: computed from at least 55 bits of the quotient, the last of which is a
// sticky bit, set if any of the bits after it is set.
double quotient(Integer n, Integer d) noexcept {
    if (n == 0) {
        return 0;
    }
    const auto divisor = static_cast<Natural>(d);
    const auto magnitude = static_cast<Natural>(n < 0 ? -n : n);
    Natural whole = magnitude / divisor, rest = magnitude % divisor;
    int exponent = 0;
    for (; whole >> 55 == 0; --exponent) {
        rest *= 2;
        whole = 2 * whole + (rest >= divisor ? 1 : 0);
        rest -= rest >= divisor ? divisor : 0;
    }
    bool more = rest != 0;
    for (; whole >> 63 != 0; ++exponent) {
        more = more || (whole & 1) != 0;
        whole >>= 1;
    }
    const double value = static_cast<double>(static_cast<uint64_t>(whole) | (more ? 1U : 0U));
    return std::ldexp(n < 0 ? -value : value, exponent);
}

} // namespace

void basis_matrix(SegmentBasis from, SegmentBasis to, int degree, double *matrix) noexcept {
    const Fractions first = to_bernstein(from, degree);
    Integer second[size][size] = {};
    from_bernstein(to, degree, second);
    for (int i = 0; i <= degree; ++i) {
        for (int j = 0; j <= degree; ++j, ++matrix) {
            Integer sum = 0;
            for (int k = 0; from != to && k <= degree; ++k) { // the product of inverse matrices would not fit
                sum += second[i][k] * first.numerators[k][j];
            }
            *matrix = from == to ? (i == j ? 1 : 0) : quotient(sum, first.denominators[j]);
        }
    }
}

} // namespace nrb::inline basis
