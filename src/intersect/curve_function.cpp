// SPDX-License-Identifier: MIT
#include "intersect/curve_function.h"

#include "base/representable.h"
#include "base/watch.h"
#include "numeric/double_double.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// The values of a form of degree 1 at Cartesian control points, each rounded once.
struct ControlValues {
    std::vector<double> values;
    double error = 0; // absolute, from cancellation; the final rounding is relative
};

// Whether the form is one coordinate times a power of two, apart from the constant.
bool is_coordinate(std::span<const double> factors) noexcept {
    const auto used = [](double factor) { return factor != 0; };
    const auto one = std::ranges::find_if(factors, used);
    int exponent = 0;
    return std::ranges::count_if(factors, used) == 1 && std::abs(std::frexp(*one, &exponent)) == 0.5;
}

ControlValues control_values(const Spline &curve, std::span<const double> form) {
    ControlValues result;
    result.values.reserve(static_cast<size_t>(curve.point_count()));
    const auto dim = static_cast<size_t>(curve.dim());
    const bool exact = is_coordinate(form.first(dim)); // then each value is the sum of two doubles
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        count_work(4 * curve.dim());
        const double *point = curve.points().data() + i * curve.stored_width();
        DoubleDouble sum(form[dim]);
        double size = std::abs(form[dim]);
        for (size_t c = 0; c < dim; ++c) {
            const DoubleDouble term = DoubleDouble::product(form[c], point[c]);
            sum = sum + term;
            size += std::abs(term.high);
        }
        result.values.push_back(sum.value());
        result.error = std::max(result.error, exact ? 0 : 0x1p-98 * size);
    }
    require_representable(result.values, "values of the polynomial at control points");
    return result;
}

class LinearFunction : public CurveFunction {
public:
    LinearFunction(const Spline &curve, SplinePtr values, double error)
        : CurveFunction(curve), values_(std::move(values)), error_(error),
          maker_(*values_, whole_domain(*values_), std::vector<double>{0}) {}

    [[nodiscard]] int far(int64_t e, double tolerance) const override {
        const KnotVector &axis = values_->axis(0);
        const int64_t first = axis.find_span(part(e).lower, false) - axis.degree();
        const auto window =
            values_->points().subspan(static_cast<size_t>(first), static_cast<size_t>(axis.degree()) + 1);
        const double far = 1.0001 * tolerance + 2 * error_; // the rounding of values is relative to them
        const bool above = std::ranges::all_of(window, [far](double x) { return x > far; });
        const bool below = std::ranges::all_of(window, [far](double x) { return x < -far; });
        return above ? 1 : below ? -1 : 0;
    }
    [[nodiscard]] FunctionPiece piece(int64_t e) const override {
        const pieces::HomogeneousPiece piece = maker_.piece(e);
        FunctionPiece result{piece.points, piece.weight, piece.positive};
        for (size_t i = 0; i < result.value.values.size(); ++i) {
            result.value.values[i] = std::ldexp(result.value.values[i], piece.exponent);
            double &error = result.value.errors[i];
            error = std::ldexp(error, piece.exponent) + 2 * error_;
        }
        return result;
    }

private:
    SplinePtr values_;
    double error_;
    pieces::PieceMaker maker_;
};

class PolynomialFunction : public CurveFunction {
public:
    PolynomialFunction(const Spline &curve, const ImplicitForm &form) : CurveFunction(curve), form_(form) {}

    [[nodiscard]] int far(int64_t, double) const override { return 0; }
    [[nodiscard]] FunctionPiece piece(int64_t e) const override {
        const pieces::HomogeneousPiece piece = maker().piece(e);
        FunctionPiece result{form_.on(piece), constant(1), piece.positive};
        for (int i = 0; i < form_.degree(); ++i) {
            result.weight = result.weight * piece.weight;
        }
        return result;
    }

private:
    ImplicitForm form_;
};

} // namespace

CurveFunction::CurveFunction(const Spline &curve)
    : CurveFunction(curve, curve.axis(0).domain(), curve.axis(0).periodic()) {}

CurveFunction::CurveFunction(const Spline &curve, Interval part, bool closed)
    : curve_(curve), maker_(curve, {part}), periodic_(closed) {}

int64_t CurveFunction::first_to(double parameter) const noexcept {
    const std::vector<double> &breaks = maker_.breaks(0);
    return std::lower_bound(breaks.begin() + 1, breaks.end(), parameter) - breaks.begin() - 1;
}

double CurveFunction::parameter(int64_t e, double place) const noexcept {
    const Interval range = part(e);
    return place == 1 ? range.upper
                      : std::clamp(range.lower * (1 - place) + range.upper * place, range.lower, range.upper);
}

std::unique_ptr<CurveFunction> function_along(const Spline &curve, const ImplicitForm &form) {
    if (form.degree() > 1 || curve.form() == Form::homogeneous) {
        return std::make_unique<PolynomialFunction>(curve, form);
    }
    ControlValues found = control_values(curve, form.coefficients());
    const std::span<const double> weights = curve.weights();
    auto values =
        std::make_shared<const Spline>(curve.knot_vectors(), 1, curve.form(), std::move(found.values),
                                       std::vector<double>(weights.begin(), weights.end()));
    return std::make_unique<LinearFunction>(curve, std::move(values), found.error);
}

} // namespace nrb::intersect
