// SPDX-License-Identifier: MIT
#include "intersect/implicit_form.h"

#include "base/numbers.h"
#include "base/representable.h"
#include "numeric/double_double.h"

#include <cmath>
#include <limits>

namespace nrb::intersect {

namespace {

// A coefficient in double-double precision, before it is rounded, and the sum of the magnitudes of its terms.
struct Coefficient {
    DoubleDouble value;
    double size = 0;
};
using Coefficients = std::vector<Coefficient>;

// The numbers of coefficients of a form in `count` variables, of which x_first is the first. Those of the
// monomials with the factor x_first come first, then the others.
struct Split {
    int64_t with, without;
};
Split split_of(int count, int degree) noexcept {
    return {monomials(count, degree - 1), monomials(count - 1, degree)};
}

Coefficients sum(Coefficients a, const Coefficients &b, const DoubleDouble &factor) {
    for (size_t i = 0; i < a.size(); ++i) {
        a[i].value = a[i].value + factor * b[i].value;
        a[i].size += std::abs(factor.high) * b[i].size;
    }
    return a;
}

// The same polynomial as a form of degree + 1: multiplied by x_m = 1.
Coefficients raised(const Coefficients &f, int count, int degree) {
    if (count == 0) {
        return f;
    }
    if (degree == 0) { // a constant times x_m
        Coefficients result(static_cast<size_t>(monomials(count, 1)));
        result.back() = f.front();
        return result;
    }
    const auto [with, without] = split_of(count, degree);
    const Coefficients first(f.begin(), f.begin() + with), rest(f.begin() + with, f.end());
    Coefficients result = raised(first, count, degree - 1);
    const Coefficients other = raised(rest, count - 1, degree);
    result.insert(result.end(), other.begin(), other.end());
    return result;
}

// f(x + c), by recursion on f = x_first f_with + f_without.
Coefficients moved(const Coefficients &f, int count, int degree, const double *centre) {
    if (count == 0 || degree == 0) {
        return f;
    }
    const auto [with, without] = split_of(count, degree);
    Coefficients first = moved({f.begin(), f.begin() + with}, count, degree - 1, centre);
    Coefficients rest = moved({f.begin() + with, f.end()}, count - 1, degree, centre + 1);
    // For the constant in the factor x_first + c: c times the moved f_with, raised to the same degree.
    Coefficients times = raised(first, count, degree - 1);
    Coefficients result(f.size());
    for (size_t i = 0; i < first.size(); ++i) {
        result[i] = first[i];
    }
    for (size_t i = 0; i < rest.size(); ++i) {
        result[first.size() + i] = rest[i];
    }
    return sum(std::move(result), times, centre[0]);
}

// Substitutes the homogeneous coordinates of a piece into a form.
class Composer {
public:
    explicit Composer(const pieces::HomogeneousPiece &piece) {
        for (int c = 0; c < piece.points.shape.width; ++c) {
            RoundedPolynomial coordinate = component(piece.points, c);
            for (std::vector<double> *values : {&coordinate.values, &coordinate.errors}) {
                for (double &x : *values) {
                    x = std::ldexp(x, piece.exponent);
                }
            }
            coordinates_.push_back(std::move(coordinate));
        }
        coordinates_.push_back(piece.weight);
    }

    [[nodiscard]] RoundedPolynomial compose(std::span<const Coefficient> f, size_t first, int degree) const {
        if (degree == 0) {
            return rounded(f.front());
        }
        const int count = static_cast<int>(coordinates_.size() - 1 - first);
        if (count == 0) {
            return compose(f, first, degree - 1) * coordinates_[first];
        }
        const auto [with, without] = split_of(count, degree);
        return compose(f.first(static_cast<size_t>(with)), first, degree - 1) * coordinates_[first] +
               compose(f.subspan(static_cast<size_t>(with)), first + 1, degree);
    }

private:
    // The error is the part below double precision, and what double-double arithmetic itself loses.
    static RoundedPolynomial rounded(const Coefficient &c) {
        RoundedPolynomial result = constant(c.value.high);
        result.errors = {std::abs(c.value.low) + 0x1p-96 * c.size};
        return result;
    }

    std::vector<RoundedPolynomial> coordinates_; // the weight is the last one
};

} // namespace

int64_t monomials(int variables, int degree) noexcept {
    int64_t count = 1;
    for (int i = 1; i <= degree; ++i) {
        if (count > std::numeric_limits<int64_t>::max() / (variables + i)) {
            return std::numeric_limits<int64_t>::max();
        }
        count = count * (variables + i) / i;
    }
    return count;
}

ImplicitForm::ImplicitForm(int variables, int degree, std::span<const double> coefficients)
    : variables_(variables), degree_(degree), coefficients_(coefficients.begin(), coefficients.end()) {}

RoundedPolynomial ImplicitForm::on(const pieces::HomogeneousPiece &piece) const {
    Coefficients f;
    for (const double c : coefficients_) {
        f.push_back({c, std::abs(c)});
    }
    f = moved(f, variables_, degree_, piece.centre.data());
    RoundedPolynomial result = Composer(piece).compose(f, 0, degree_);
    require_representable(result.values, "values of the polynomial");
    require_representable(result.errors, "values of the polynomial");
    return result;
}

} // namespace nrb::intersect
