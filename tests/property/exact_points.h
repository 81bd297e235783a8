// Points as rational numbers, and the worst of the errors of a test.
#pragma once

#include "same_shape.h"

#include <cstdio>
#include <vector>

namespace support {

using reference::exact;
using reference::Rational;

using Point = std::vector<Rational>;

inline long double as_long_double(const Rational &x) {
    return reference::quotient(numerator(x), denominator(x));
}

inline Point point_at(const SplineData &data, const std::vector<double> &params) {
    Point point;
    for (const reference::Fraction &x : reference::exact_point(data, params.data())) {
        point.emplace_back(x.numerator, x.denominator);
    }
    return point;
}

// The largest coordinate of a difference over a bound; 0 / 0 is 0.
inline long double ratio(const Point &a, const Point &b, long double bound) {
    long double largest = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        largest = std::max(largest, std::fabs(as_long_double(Rational(a[c] - b[c]))));
    }
    return largest == 0 ? 0 : largest / bound;
}

inline std::vector<double> joined(std::vector<double> a, const std::vector<double> &b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

class WorstRatios {
public:
    explicit WorstRatios(const char *title) : title_(title) {}
    WorstRatios(const WorstRatios &) = delete;
    WorstRatios &operator=(const WorstRatios &) = delete;
    ~WorstRatios() { std::printf("%s: at most %.3Lf of the bound\n", title_, worst_); }
    void add(long double error) { worst_ = std::max(worst_, error); }

private:
    const char *title_;
    long double worst_ = 0;
};

} // namespace support
