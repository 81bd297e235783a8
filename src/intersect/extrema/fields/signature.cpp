// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/signature.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// What follows rounds outwards by as much as one operation can lose.
Interval rounded(double lower, double upper) noexcept {
    constexpr double tiny = 0x1p-1060;
    return {lower - eps * std::abs(lower) - tiny, upper + eps * std::abs(upper) + tiny};
}
Interval product(Interval a, Interval b) noexcept {
    const auto [lower, upper] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return rounded(lower, upper);
}
Interval difference(Interval a, Interval b) noexcept {
    return rounded(a.lower - b.upper, a.upper - b.lower);
}
Interval sum(Interval a, Interval b) noexcept {
    return rounded(a.lower + b.lower, a.upper + b.upper);
}
int sign(Interval x) noexcept {
    return x.lower > 0 ? 1 : x.upper < 0 ? -1 : 0;
}

class SymmetricMatrix {
public:
    SymmetricMatrix(const Interval *entries, size_t size) : entries_(entries), size_(size) {}

    [[nodiscard]] Interval at(size_t i, size_t j) const noexcept {
        return entries_[std::min(i, j) * size_ + std::max(i, j)];
    }
    // Of rows i, k and columns j, l.
    [[nodiscard]] Interval minor(size_t i, size_t k, size_t j, size_t l) const noexcept {
        return difference(product(at(i, j), at(k, l)), product(at(i, l), at(k, j)));
    }
    [[nodiscard]] Interval determinant() const noexcept {
        return sum(difference(product(at(0, 0), minor(1, 2, 1, 2)), product(at(0, 1), minor(1, 2, 0, 2))),
                   product(at(0, 2), minor(1, 2, 0, 1)));
    }

private:
    const Interval *entries_;
    size_t size_;
};

} // namespace

// Sylvester's criterion. A regular matrix that is not definite has eigenvalues of both signs.
uint32_t signature(const Interval *matrix, size_t size, bool regular) {
    using namespace extremum_kind;
    const SymmetricMatrix m(matrix, size);
    bool positive = true, negative = true; // may be definite
    const auto look = [&](int of_positive, int of_negative, int found) {
        positive = positive && found != -of_positive;
        negative = negative && found != -of_negative;
        return found;
    };
    bool sure = true;
    for (size_t i = 0; i < size; ++i) {
        sure = look(1, -1, sign(m.at(i, i))) != 0 && sure;
        for (size_t k = i + 1; k < size; ++k) {
            sure = look(1, 1, sign(m.minor(i, k, i, k))) != 0 && sure;
        }
    }
    if (size == 3) {
        sure = look(1, -1, sign(m.determinant())) != 0 && sure;
    }
    if (!positive && !negative) {
        return regular ? saddle : undecided;
    }
    return !sure ? undecided : positive ? minimum : maximum;
}

} // namespace nrb::intersect
