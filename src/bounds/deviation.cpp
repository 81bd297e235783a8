// SPDX-License-Identifier: MIT
#include "bounds/deviation.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace nrb::bounds {

namespace {

void check_comparable(const Spline &f, const Spline &g) {
    if (f.axes() != g.axes() || f.dim() != g.dim()) {
        fail(Status::incompatible, "g: %d axes in dimension %d, expected %d in %d as in f", g.axes(), g.dim(),
             f.axes(), f.dim());
    }
    for (int k = 0; k < f.axes(); ++k) {
        const Interval a = f.axis(k).domain(), b = g.axis(k).domain();
        if (a.lower != b.lower || a.upper != b.upper) {
            fail(Status::incompatible, "g: domain [%s, %s] of axis %d, expected [%s, %s] as in f",
                 Number(b.lower).text, Number(b.upper).text, k, Number(a.lower).text, Number(a.upper).text);
        }
    }
}

std::span<const double> inner_knots(const KnotVector &axis, Interval part) {
    const auto first = std::upper_bound(axis.knots().begin(), axis.knots().end(), part.lower);
    return {first, std::lower_bound(first, axis.knots().end(), part.upper)};
}

// The knots of both splines inside an interval, and its ends.
std::vector<double> common_breaks(const KnotVector &f, const KnotVector &g, Interval part) {
    const std::span<const double> a = inner_knots(f, part), b = inner_knots(g, part);
    std::vector<double> breaks{part.lower};
    breaks.reserve(a.size() + b.size() + 2);
    count_work(2 * (std::ssize(a) + std::ssize(b)));
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(breaks));
    breaks.push_back(part.upper);
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
}

} // namespace

// What the nets of both splines share.
struct DeviationPieces::Setting {
    pieces::BernsteinNet::Breaks breaks;
    std::array<int, max_axes> degrees{};
    std::vector<double> centre;
    bool weighted = false;
    int f_exponent = 0;
    int g_exponent = 0;

    Setting(const Spline &f, const Spline &g, int axis, Interval part) : centre(pieces::centre_of(f)) {
        check_comparable(f, g);
        for (int k = 0; k < f.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            breaks[at] = common_breaks(f.axis(k), g.axis(k), k == axis ? part : f.axis(k).domain());
            degrees[at] = std::max(f.axis(k).degree(), g.axis(k).degree());
        }
        weighted = f.rational() || g.rational();
        f_exponent = pieces::weight_exponent(f);
        g_exponent = pieces::weight_exponent(g);
        if (std::abs(f_exponent - g_exponent) <= 1) { // so that equal weights stay equal
            g_exponent = f_exponent;
        }
    }

    // Whether the pieces of f are the same.
    [[nodiscard]] bool same_first(const Setting &other) const {
        return weighted == other.weighted && degrees == other.degrees && breaks == other.breaks;
    }
};

DeviationPieces::NetPtr DeviationPieces::first_net(const Spline &f, const Setting &setting) {
    return std::make_shared<const pieces::BernsteinNet>(
        f, pieces::centred_records(f, setting.centre, setting.weighted, setting.f_exponent), setting.breaks,
        setting.degrees);
}

DeviationPieces::DeviationPieces(NetPtr f, const Spline &g, const Setting &setting)
    : breaks_(setting.breaks), f_(std::move(f)),
      g_(g, pieces::centred_records(g, setting.centre, setting.weighted, setting.g_exponent), breaks_,
         setting.degrees) {}

DeviationPieces::DeviationPieces(const Spline &f, const Spline &g)
    : DeviationPieces(DeviationsFrom(f).to(g)) {}

DeviationPieces::DeviationPieces(const Spline &f, const Spline &g, int axis, Interval part)
    : DeviationPieces([&] {
          const Setting setting(f, g, axis, part);
          return DeviationPieces(first_net(f, setting), g, setting);
      }()) {}

DeviationsFrom::DeviationsFrom(const Spline &f) noexcept : f_(f) {}
DeviationsFrom::~DeviationsFrom() = default;

DeviationPieces DeviationsFrom::to(const Spline &g) {
    auto setting = std::make_unique<DeviationPieces::Setting>(f_, g, -1, Interval{});
    if (net_ == nullptr || !setting_->same_first(*setting)) {
        net_ = nullptr; // releases its memory first
        net_ = DeviationPieces::first_net(f_, *setting);
    }
    setting_ = std::move(setting);
    return {net_, g, *setting_};
}

namespace {

void scale(std::vector<double> &values, const std::vector<double> &factors) noexcept {
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] *= factors[i];
    }
}

void unscale(std::vector<double> &values, const std::vector<double> &factors) noexcept {
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] /= factors[i];
    }
}

} // namespace

// The difference of both splines, one piece after another, and the quantities to which its errors are
// relative.
class DeviationPieces::Difference {
public:
    Difference(const pieces::BernsteinNet &f, const pieces::BernsteinNet &g)
        : f_(f), g_(g), vector_(f.shape()), scalar_(f.shape()) {
        vector_.width -= f.weighted() ? 1 : 0;
        scalar_.width = 1;
        numerator_ = product_shape(vector_, scalar_);
        denominator_ = product_shape(scalar_, scalar_);
        a_.resize(static_cast<size_t>(vector_.values()));
        b_ = a_;
        if (f.weighted()) {
            w_.resize(static_cast<size_t>(scalar_.values()));
            v_ = e_ = w_;
            vector_factors_ = binomial_factors(vector_);
            scalar_factors_ = binomial_factors(scalar_);
            numerator_factors_ = binomial_factors(numerator_);
            denominator_factors_ = binomial_factors(denominator_);
        }
    }

    void fill(int64_t piece, pieces::QuotientPiece &out) {
        count_work(8 * vector_.values());
        out.numerator_error = out.quotient_error = out.denominator_error = out.denominator_factor = 0;
        out.last_axis = -1;
        size_ = std::max(f_.size(piece), g_.size(piece));
        f_.copy(piece, a_.data(), w_.data());
        g_.copy(piece, b_.data(), v_.data());
        for (size_t i = 0; i < a_.size(); ++i) {
            a_[i] -= b_[i];
        }
        const bool relative = f_.positive() && g_.positive();
        if (w_.empty() || (relative && w_ == v_)) {
            return fill_alike(out);
        }
        measure();
        relative &&std::isfinite(ratio_) ? add_relative_errors(out) : add_absolute_errors(out);
        fill_products(out);
    }

private:
    // (A - B) / w; the exact weights w* and v* may still differ by their errors.
    void fill_alike(pieces::QuotientPiece &out) const {
        out.shape = vector_;
        out.numerators = a_;
        out.denominators = w_;
        const double gamma = f_.error() + g_.error();
        out.quotient_error = size_ * gamma * (w_.empty() ? 1.01 : 2.02);
        out.denominator_factor = w_.empty() ? 0 : f_.error() * 1.01;
        double largest = 0;
        for (size_t i = 0; i < a_.size(); ++i) {
            const double w = w_.empty() ? 1 : w_[i / static_cast<size_t>(vector_.width)];
            largest = w > 0 ? std::max(largest, std::abs(a_[i]) / w) : largest;
        }
        out.quotient_error += eps * largest * std::sqrt(vector_.width);
    }

    // The largest |A - B| / w, |w - v| / w and v / w over the coefficients; infinite if a weight is 0 in f
    // only.
    void measure() {
        ratio_ = 1;
        points_apart_ = weights_apart_ = 0;
        const double *step = a_.data();
        for (size_t i = 0; i < w_.size(); ++i, step += vector_.width) {
            e_[i] = w_[i] - v_[i];
            if (w_[i] == 0 && v_[i] == 0) {
                continue;
            }
            double largest = 0;
            for (int c = 0; c < vector_.width; ++c) {
                largest = std::max(largest, std::abs(step[c]));
            }
            ratio_ = std::max(ratio_, v_[i] / w_[i]);
            points_apart_ = std::max(points_apart_, largest * std::sqrt(vector_.width) / w_[i]);
            weights_apart_ = std::max(weights_apart_, std::abs(e_[i]) / w_[i]);
        }
    }

    // Forms (A - B) v - B (w - v) and w v. Overwrites the factors.
    void fill_products(pieces::QuotientPiece &out) {
        scale(a_, vector_factors_);
        scale(b_, vector_factors_);
        scale(w_, scalar_factors_);
        scale(v_, scalar_factors_);
        scale(e_, scalar_factors_);
        out.shape = numerator_;
        out.numerators.assign(numerator_factors_.size(), 0);
        out.denominators.assign(denominator_factors_.size(), 0);
        rest_.assign(numerator_factors_.size(), 0);
        add_convolution(vector_, a_.data(), scalar_, v_.data(), out.numerators.data());
        add_convolution(vector_, b_.data(), scalar_, e_.data(), rest_.data());
        add_convolution(scalar_, w_.data(), scalar_, v_.data(), out.denominators.data());
        for (size_t i = 0; i < rest_.size(); ++i) {
            out.numerators[i] -= rest_[i];
        }
        unscale(out.numerators, numerator_factors_);
        unscale(out.denominators, denominator_factors_);
    }

    // The errors of A - B and v, of B and w - v, and of the products, each relative to the coefficients of w
    // v.
    void add_relative_errors(pieces::QuotientPiece &out) const {
        const double f = f_.error(), g = g_.error(), product = product_error(vector_, scalar_) + eps;
        const double entering = 2 * size_ * (f + g * ratio_);
        const double forming = (g + eps + product) * (points_apart_ + size_ * weights_apart_);
        out.quotient_error = 1.01 * (entering + forming);
        out.denominator_factor = 1.01 * (f + g + product);
        out.numerator_error = out.denominator_error = 0;
    }

    // The same from the largest of each quantity, for weights of any sign.
    void add_absolute_errors(pieces::QuotientPiece &out) const {
        const double f = f_.error(), g = g_.error(), product = product_error(vector_, scalar_) + eps;
        const double w = f_.largest_weight(), v = g_.largest_weight();
        const double a = largest_record(f_), b = largest_record(g_);
        const double apart = std::sqrt(vector_.width) * largest_magnitude(a_);
        const double tilt = largest_magnitude(e_);
        const double entering = (f * a + g * b) * v + g * b * tilt + b * (f * w + g * v);
        const double forming = (g + eps + product) * (apart * v + b * tilt);
        out.numerator_error = 1.01 * (entering + forming);
        out.denominator_error = 1.01 * (f + g + product) * w * v;
        out.quotient_error = out.denominator_factor = 0;
    }
    double largest_record(const pieces::BernsteinNet &net) const noexcept {
        return std::max(net.largest_record(), size_ * net.largest_weight());
    }

    const pieces::BernsteinNet &f_;
    const pieces::BernsteinNet &g_;
    BernsteinShape vector_, scalar_, numerator_, denominator_;
    std::vector<double> vector_factors_, scalar_factors_, numerator_factors_, denominator_factors_;
    std::vector<double> a_, b_, w_, v_, e_, rest_; // of the current piece
    double size_ = 0;
    double ratio_ = 1;
    double points_apart_ = 0;
    double weights_apart_ = 0;
};

std::vector<double> DeviationPieces::uppers() const {
    return pieces::quotient_uppers(
        pieces(), [difference = Difference(*f_, g_)](int64_t i, pieces::QuotientPiece &out) mutable {
            difference.fill(i, out);
        });
}

pieces::Enclosure DeviationPieces::enclosure(std::span<const double> uppers,
                                             const pieces::SearchLimits &limits) const {
    const pieces::PieceSource source =
        [difference = Difference(*f_, g_)](int64_t i, pieces::QuotientPiece &out) mutable {
            difference.fill(i, out);
        };
    return pieces::largest_quotient(uppers, source, limits);
}

pieces::Enclosure deviation(const Spline &f, const Spline &g) {
    const DeviationPieces pieces(f, g);
    return pieces.enclosure(pieces.uppers());
}

pieces::Enclosure deviation(const Spline &f, const Spline &g, int axis, Interval part) {
    const DeviationPieces pieces(f, g, axis, part);
    return pieces.enclosure(pieces.uppers());
}

double deviation_below(const Spline &f, const Spline &g, double limit) {
    constexpr pieces::SearchLimits close{0x1p-10, 6000};
    const DeviationPieces pieces(f, g);
    const std::vector<double> uppers = pieces.uppers();
    const pieces::Enclosure found = pieces.enclosure(uppers);
    const bool open = found.lower <= limit && found.upper > limit;
    return open ? pieces.enclosure(uppers, close).upper : found.upper;
}

} // namespace nrb::bounds
