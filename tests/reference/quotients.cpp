#include "reference/quotients.h"

#include "reference/definition.h"

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace reference {

namespace {

Rational binomial_of(size_t n, size_t k) {
    return {support::binomial(static_cast<int>(n), static_cast<int>(k))};
}

} // namespace

Polynomial operator*(const Polynomial &a, const Polynomial &b) {
    const size_t m = a.size() - 1, n = b.size() - 1;
    Polynomial result(m + n + 1);
    for (size_t i = 0; i <= m; ++i) {
        for (size_t j = 0; j <= n; ++j) {
            result[i + j] += binomial_of(m, i) * binomial_of(n, j) * a[i] * b[j];
        }
    }
    for (size_t k = 0; k < result.size(); ++k) {
        result[k] /= binomial_of(m + n, k);
    }
    return result;
}

Polynomial raised(Polynomial a, size_t degree) {
    return a.size() > degree ? a : a * Polynomial(degree + 2 - a.size(), Rational(1));
}

Polynomial operator+(const Polynomial &a, const Polynomial &b) {
    Polynomial sum = raised(a, b.size() - 1);
    const Polynomial other = raised(b, a.size() - 1);
    for (size_t i = 0; i < sum.size(); ++i) {
        sum[i] += other[i];
    }
    return sum;
}

Polynomial scaled(const Polynomial &a, const Rational &factor) {
    Polynomial result = a;
    for (Rational &x : result) {
        x *= factor;
    }
    return result;
}

Polynomial operator-(const Polynomial &a, const Polynomial &b) {
    return a + scaled(b, Rational(-1));
}

QuotientPiece sum(const QuotientPiece &a, const Rational &factor, const QuotientPiece &b) {
    const bool shared = a.denominator == b.denominator;
    QuotientPiece result{{}, shared ? a.denominator : a.denominator * b.denominator};
    for (size_t c = 0; c < a.numerators.size(); ++c) {
        const Polynomial second = scaled(b.numerators[c], factor);
        result.numerators.push_back(shared ? a.numerators[c] + second
                                           : a.numerators[c] * b.denominator + second * a.denominator);
    }
    return result;
}

QuotientPiece times(const QuotientPiece &a, const Polynomial &f) {
    QuotientPiece result = a;
    for (Polynomial &numerator : result.numerators) {
        numerator = numerator * f;
    }
    return result;
}

Records exact_records(const support::SplineData &data) {
    Records records;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const Rational weight = exact(data.weight(i));
        records.emplace_back();
        for (int c = 0; c < data.dim; ++c) {
            records.back().push_back(weight * exact(data.coordinate(i, c)));
        }
        records.back().push_back(weight);
    }
    return records;
}

std::vector<double> breaks_of(const support::SplineData &data, int axis) {
    std::vector<double> breaks;
    for (const double t : data.knots[static_cast<size_t>(axis)]) {
        if (t >= data.lower(axis) && t <= data.upper(axis) && (breaks.empty() || breaks.back() < t)) {
            breaks.push_back(t);
        }
    }
    return breaks;
}

std::vector<double> united(const std::vector<double> &a, const std::vector<double> &b) {
    std::vector<double> both;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

namespace {

int64_t span_of(const std::vector<double> &knots, double lower, double upper) {
    for (size_t s = 0; s + 1 < knots.size(); ++s) {
        if (knots[s] < knots[s + 1] && knots[s] <= lower && upper <= knots[s + 1]) {
            return static_cast<int64_t>(s);
        }
    }
    throw std::logic_error("an interval over more than one span");
}

QuotientPiece quotient_piece(std::vector<Polynomial> parts) {
    Polynomial denominator = std::move(parts.back());
    parts.pop_back();
    return {std::move(parts), std::move(denominator)};
}

// Layer `layer` of an axis of a surface, as records along the other one.
Records layer_of(const support::SplineData &surface, int axis, int64_t layer) {
    const Records all = exact_records(surface);
    Records records;
    for (int64_t i = 0; i < surface.counts[axis == 0 ? 1 : 0]; ++i) {
        records.push_back(all[static_cast<size_t>(axis == 0 ? layer * surface.counts[1] + i
                                                            : i * surface.counts[1] + layer)]);
    }
    return records;
}

std::vector<Polynomial> layer_polynomials(const support::SplineData &surface, int axis, int64_t layer,
                                          double lower, double upper) {
    const size_t other = axis == 0 ? 1 : 0;
    return polynomials(surface.knots[other], surface.degrees[other], layer_of(surface, axis, layer), lower,
                       upper);
}

} // namespace

std::vector<Polynomial> polynomials(const std::vector<double> &knots, int degree, const Records &records,
                                    double lower, double upper) {
    const int64_t s = span_of(knots, lower, upper);
    const std::vector<std::vector<Rational>> active(records.begin() + (s - degree), records.begin() + s + 1);
    std::vector<Polynomial> parts(records[0].size());
    for (int k = 0; k <= degree; ++k) {
        std::vector<Rational> arguments(static_cast<size_t>(degree), exact(lower));
        std::fill_n(arguments.begin(), k, exact(upper));
        const std::vector<Rational> point = blossom_at(knots, degree, s, active, arguments);
        for (size_t c = 0; c < point.size(); ++c) {
            parts[c].push_back(point[c]);
        }
    }
    return parts;
}

QuotientPiece piece(const support::SplineData &curve, double lower, double upper) {
    return quotient_piece(polynomials(curve.knots[0], curve.degrees[0], exact_records(curve), lower, upper));
}

QuotientPiece edge(const support::SplineData &surface, int axis, bool upper_end, double lower, double upper) {
    const int64_t end = upper_end ? surface.counts[static_cast<size_t>(axis)] - 1 : 0;
    return quotient_piece(layer_polynomials(surface, axis, end, lower, upper));
}

QuotientPiece edge_derivative(const support::SplineData &surface, int axis, bool upper_end, double lower,
                              double upper) {
    const auto at = static_cast<size_t>(axis);
    const std::vector<double> &t = surface.knots[at];
    const auto p = static_cast<size_t>(surface.degrees[at]), n = static_cast<size_t>(surface.counts[at]);
    const auto end = static_cast<int64_t>(upper_end ? n - 1 : 0),
               next = static_cast<int64_t>(upper_end ? n - 2 : 1);
    const Rational length = upper_end ? exact(t[n - 1]) - exact(t[n + p - 1]) : exact(t[p + 1]) - exact(t[1]);
    const Rational factor = Rational(static_cast<int64_t>(p)) / length;
    const std::vector<Polynomial> own = layer_polynomials(surface, axis, end, lower, upper),
                                  beside = layer_polynomials(surface, axis, next, lower, upper);
    QuotientPiece result{{}, own.back() * own.back()};
    for (size_t c = 0; c + 1 < own.size(); ++c) {
        result.numerators.push_back(scaled(beside[c] * own.back() - own[c] * beside.back(), factor));
    }
    return result;
}

long double largest_difference(const QuotientPiece &a, const QuotientPiece &b) {
    const QuotientPiece difference = sum(a, Rational(-1), b);
    long double largest = 0;
    for (const Polynomial &numerator : difference.numerators) {
        const size_t degree = std::max(numerator.size(), difference.denominator.size()) - 1;
        const Polynomial above = raised(numerator, degree), below = raised(difference.denominator, degree);
        for (size_t i = 0; i < above.size(); ++i) {
            const Rational ratio = above[i] / below[i];
            largest = std::max(largest, std::fabs(quotient(boost::multiprecision::numerator(ratio),
                                                           boost::multiprecision::denominator(ratio))));
        }
    }
    return largest;
}

} // namespace reference
