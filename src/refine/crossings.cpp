#include "refine/crossings.h"

#include "refine/blossom.h"
#include "refine/derivative.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

} // namespace

CurvePiece::CurvePiece(const Spline &curve, int64_t span) : curve_(&curve), span_(span) {
    for (int k = 0; k < curve.dim(); ++k) {
        const Coefficients values = coefficients_between(k, lower(), upper());
        coefficients_.insert(coefficients_.end(), values.begin(), values.begin() + degree() + 1);
        known_.push_back(known_of(k));
    }
}

Coefficients CurvePiece::coefficients_between(int k, double from, double to) const noexcept {
    Coefficients arguments{}, values{};
    arguments.fill(from);
    const auto q = static_cast<size_t>(degree());
    for (size_t j = 0; j <= q; ++j) {
        if (j > 0) {
            arguments[q - j] = to;
        }
        values[j] = polar_value(k, std::span(arguments).first(q));
    }
    return values;
}

double CurvePiece::polar_value(int k, std::span<const double> arguments) const noexcept {
    const PolarRow row = blossom_row(curve_->axis(0), span_, arguments);
    const double *points = curve_->points().data() + row.first * curve_->dim() + k;
    double value = 0;
    for (int i = 0; i < row.size; ++i) {
        value += row.coefficients[i] * points[int64_t{i} * curve_->dim()];
    }
    return value;
}

double CurvePiece::value(int k, double t) const noexcept {
    Coefficients arguments{};
    arguments.fill(t);
    return polar_value(k, std::span(arguments).first(static_cast<size_t>(degree())));
}

// Multiplied by eps before anything can overflow; t / length is at most 1 / eps.
CurvePiece::Known CurvePiece::known_of(int k) const {
    const KnotVector &axis = curve_->axis(0);
    const int q = axis.degree();
    const double t = std::max(std::fabs(lower()), std::fabs(upper()));
    const auto point = [&](int64_t i) {
        return eps * curve_->points()[static_cast<size_t>(i * curve_->dim() + k)];
    };
    double largest = std::fabs(point(span_)), moved = 0;
    for (int64_t i = span_ - q; i < span_; ++i) {
        const double length = axis[i + q + 1] - axis[i + 1];
        largest = std::max(largest, std::fabs(point(i)));
        moved = std::max(moved, q * std::fabs(point(i + 1) - point(i)) * (t / length));
    }
    const Known known{4 * (q + 1) * largest, 4 * (q + 1) * largest + moved};
    if (!std::isfinite(known.uncertainty)) {
        fail(NURBS_ERROR_NOT_REPRESENTABLE,
             "coordinate %d between t = %s and %s is too steep: the uncertainty of its values overflows", k,
             Number(lower()).text, Number(upper()).text);
    }
    return known;
}

double CurvePiece::uncertainty_at(int k, double t) const noexcept {
    const KnotVector &axis = curve_->axis(0);
    const int q = axis.degree();
    const bool stored =
        q == 0 || (t == lower() && axis[span_ - q + 1] == t) || (t == upper() && axis[span_ + q] == t);
    return stored ? rounding(k) : uncertainty(k);
}

namespace {

// Walks through the parts of a piece in the order of their parameters.
class SignWalk {
public:
    SignWalk(const CurvePiece &piece, int k, double c, double uncertainty)
        : piece_(piece), k_(k), c_(c), uncertainty_(uncertainty), degree_(piece.degree()) {}

    // Of the coefficients over an interval.
    SignProfile walk(std::span<const double> values, Interval part) && {
        Coefficients differences{};
        std::transform(values.begin(), values.end(), differences.begin(),
                       [this](double x) { return x - c_; });
        visit(differences, part.lower, part.upper);
        return std::move(profile_);
    }

private:
    [[nodiscard]] int sign(double x) const noexcept {
        return std::fabs(x) <= uncertainty_ ? 0 : x > 0 ? 1 : -1;
    }

    void visit(Coefficients &values, double lower, double upper) {
        int first = 0, last = 0, changes = 0;
        for (int j = 0; j <= degree_; ++j) {
            const int own = sign(values[static_cast<size_t>(j)]);
            changes += own * last < 0 ? 1 : 0;
            last = own != 0 ? own : last;
            first = first != 0 ? first : own;
        }
        const double middle = lower + (upper - lower) / 2;
        if (changes > 1 && lower < middle && middle < upper) {
            Coefficients left = values;
            halve(left, values);
            visit(left, lower, middle);
            visit(values, middle, upper);
        } else if (first != 0) {
            add(first, last, lower, upper);
        }
    }

    // de Casteljau in the middle: `left` becomes the lower half, `values` the upper one.
    void halve(Coefficients &left, Coefficients &values) const noexcept {
        for (int r = 0; r <= degree_; ++r) {
            left[static_cast<size_t>(r)] = values[0];
            for (int j = 0; j < degree_ - r; ++j) {
                const auto at = static_cast<size_t>(j);
                values[at] = values[at] / 2 + values[at + 1] / 2;
            }
            // The upper half stays behind, from its end backwards.
        }
    }

    // A part that begins with one sign and ends with another one, or the same.
    void add(int first, int last, double lower, double upper) {
        if (before_ * first < 0) {
            profile_.crossings.push_back(lower);
        }
        if (first != last) {
            profile_.crossings.push_back(root(lower, upper, last));
        }
        before_ = last;
        profile_.below = profile_.below || first < 0 || last < 0;
        profile_.above = profile_.above || first > 0 || last > 0;
    }

    [[nodiscard]] double root(double lower, double upper, int last) const noexcept {
        for (;;) {
            const double middle = lower + (upper - lower) / 2;
            const double value = piece_.value(k_, middle) - c_;
            if (value == 0 || middle == lower || middle == upper) {
                return middle;
            }
            ((value > 0) == (last > 0) ? upper : lower) = middle;
        }
    }

    const CurvePiece &piece_;
    int k_;
    double c_;
    double uncertainty_;
    int degree_;
    int before_ = 0; // the last sign met
    SignProfile profile_;
};

// Whether no jump leads back.
bool continues(const CurvePiece &before, const CurvePiece &piece, bool rising) noexcept {
    const double from = before.coefficients(0).back(), to = piece.coefficients(0).front();
    const double slack = std::max(before.uncertainty(0), piece.uncertainty(0));
    return rising ? to >= from - slack : to <= from + slack;
}

} // namespace

SignProfile sign_profile(const CurvePiece &piece, int k, double c) {
    return SignWalk(piece, k, c, piece.uncertainty(k))
        .walk(piece.coefficients(k), {piece.lower(), piece.upper()});
}

bool lies_above(const CurvePiece &piece, int k, double c, Interval part) {
    const double middle = piece.value(k, part.lower + (part.upper - part.lower) / 2);
    if (std::fabs(middle - c) > piece.uncertainty(k)) {
        return middle > c;
    }
    const Coefficients values = piece.coefficients_between(k, part.lower, part.upper);
    for (const double uncertainty : {piece.uncertainty(k), piece.rounding(k)}) {
        const SignProfile profile =
            SignWalk(piece, k, c, uncertainty)
                .walk(std::span(values).first(static_cast<size_t>(piece.degree()) + 1), part);
        if (profile.below || profile.above) {
            return profile.below && profile.above ? middle >= c : profile.above;
        }
    }
    return true;
}

bool strictly_monotone(const SplinePtr &curve) {
    const SplinePtr slope = polynomial_derivative(curve, 0, 1);
    bool below = false, above = false;
    for (const int64_t span : slope->axis(0).spans().indices()) {
        const SignProfile profile = sign_profile(CurvePiece(*slope, span), 0, 0);
        below = below || profile.below;
        above = above || profile.above;
        if (profile.below == profile.above) {
            return false;
        }
    }
    const std::span<const int64_t> spans = curve->axis(0).spans().indices();
    for (size_t i = 1; i < spans.size(); ++i) {
        if (!continues(CurvePiece(*curve, spans[i - 1]), CurvePiece(*curve, spans[i]), above)) {
            return false;
        }
    }
    return below != above;
}

} // namespace nrb
