#include "query/measure/curve_length.h"

#include "base/error.h"
#include "base/sum.h"
#include "basis/binomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr int first_level = 2; // 15 nodes
constexpr int most_halvings = 200;
constexpr int64_t leaves_for_a_piece = 256, leaves_at_least = 20000;

double weighted_sum(int level, const double *values) noexcept {
    const double *weights = rule_weights(level);
    const int size = std::max(16, rule_size(level));
    std::array<double, 8> sums{};
    for (int i = 0; i < size; i += 8) {
        for (size_t k = 0; k < 8; ++k) {
            sums[k] += weights[i + static_cast<int>(k)] * values[i + static_cast<int>(k)];
        }
    }
    return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

// Rules of rising levels on one part of a piece.
class Ladder {
public:
    Ladder(const SpeedForm &form, const double *net) : form_(form), net_(net) {
        speeds(form, net, 0, rule_size(first_level), speeds_.data());
        sums_ = {weighted_sum(0, speeds_.data()), weighted_sum(1, speeds_.data()),
                 weighted_sum(2, speeds_.data())};
    }

    [[nodiscard]] double value() const noexcept { return sums_[2]; }
    [[nodiscard]] double difference() const noexcept { return std::abs(sums_[2] - sums_[1]); }
    [[nodiscard]] int level() const noexcept { return level_; }
    [[nodiscard]] double error() const noexcept {
        return extrapolated_error(sums_[0], sums_[1], sums_[2], value());
    }

    // Climbs as long as the next level but one is likely to be good enough; false if none is.
    bool climb(double tolerance) noexcept {
        while (!(error() <= tolerance)) {
            if (level_ + 1 == rule_levels || !promising(tolerance)) {
                return false;
            }
            raise();
        }
        return true;
    }

private:
    // From level to level errors are squared, so that the estimate becomes the cube of the difference; over two
    // levels its sixth power.
    [[nodiscard]] bool promising(double tolerance) const noexcept {
        const double r = difference() / value();
        const double next = r * r * r;
        return next * value() <= tolerance ||
               (level_ + 2 < rule_levels && next * next * value() <= tolerance);
    }
    void raise() noexcept {
        const int before = rule_size(level_++);
        speeds(form_, net_, before, rule_size(level_) - before, speeds_.data());
        sums_ = {sums_[1], sums_[2], weighted_sum(level_, speeds_.data())};
    }

    const SpeedForm &form_;
    const double *net_;
    int level_ = first_level;
    std::array<double, 3> sums_{};
    alignas(64) std::array<double, rule_capacity> speeds_;
};

// Both halves of a net: the rows of N, and the one of w.
void halve_net(const SpeedForm &form, double *net, double *lower) noexcept {
    halve_rows(form.dim, form.degree, 1, net, lower);
    const int64_t first = int64_t{form.dim} * (form.degree + 1);
    if (form.weight_degree >= 0) {
        halve_rows(1, form.weight_degree, 1, net + first, lower + first);
    }
    std::for_each_n(net, first, [](double &x) { x /= 2; });
    std::for_each_n(lower, first, [](double &x) { x /= 2; });
}

// One search with a given idea of the whole length.
class LengthSearch {
public:
    LengthSearch(const SpeedPieces &pieces, double tolerance, std::vector<LengthLeaf> *leaves,
                 std::vector<double> *nets)
        : pieces_(pieces), tolerance_(tolerance), leaves_(leaves), nets_(nets),
          budget_(leaves_at_least + leaves_for_a_piece * pieces.size()) {}

    // `share`: what is allowed on however small a part, of the whole tolerance.
    Integral run(double length, double share) {
        length_ = length;
        least_ = tolerance_ * length * share;
        if (leaves_ != nullptr) {
            leaves_->clear();
            nets_->clear();
        }
        total_ = error_ = CompensatedSum();
        for (int64_t e = 0; e < pieces_.size(); ++e) {
            run_piece(e);
        }
        return {total_.value(), error_.value()};
    }

private:
    void run_piece(int64_t piece) {
        const auto size = static_cast<size_t>(pieces_.form().size());
        stack_.assign(pieces_.net(piece), pieces_.net(piece) + size);
        parts_.assign(1, {0, 1, 0});
        while (!parts_.empty()) {
            const Part part = parts_.back();
            double *net = stack_.data() + stack_.size() - size;
            Ladder ladder(pieces_.form(), net);
            const bool good = ladder.climb(std::max(least_, tolerance_ / 2 * ladder.value()));
            if (good || part.halvings == most_halvings || --budget_ < 0 || !std::isfinite(ladder.value())) {
                accept(piece, part, ladder, good ? ladder.error() : ladder.difference(), net);
                stack_.resize(stack_.size() - size);
                parts_.pop_back();
                continue;
            }
            stack_.resize(stack_.size() + size);
            net = stack_.data() + stack_.size() - 2 * size;
            halve_net(pieces_.form(), net, net + size);
            const double middle = part.lower / 2 + part.upper / 2;
            parts_.back() = {middle, part.upper, part.halvings + 1};
            parts_.push_back({part.lower, middle, part.halvings + 1});
        }
    }

    struct Part {
        double lower, upper;
        int halvings;
    };

    void accept(int64_t piece, const Part &part, const Ladder &ladder, double error, const double *net) {
        total_.add(ladder.value());
        error_.add(std::isfinite(error) ? error : std::numeric_limits<double>::infinity());
        if (leaves_ != nullptr) {
            leaves_->push_back({piece, part.lower, part.upper, ladder.level(), ladder.value()});
            nets_->insert(nets_->end(), net, net + pieces_.form().size());
        }
    }

    const SpeedPieces &pieces_;
    double tolerance_;
    std::vector<LengthLeaf> *leaves_;
    std::vector<double> *nets_;
    int64_t budget_;
    double length_ = 0;
    double least_ = 0;
    CompensatedSum total_;
    CompensatedSum error_;
    std::vector<double> stack_;
    std::vector<Part> parts_;
};

// By 7 nodes a piece.
double rough_length(const SpeedPieces &pieces) noexcept {
    double total = 0;
    for (int64_t e = 0; e < pieces.size(); ++e) {
        std::array<double, 16> values{};
        speeds(pieces.form(), pieces.net(e), 0, rule_size(1), values.data());
        total += weighted_sum(1, values.data());
    }
    return total;
}

} // namespace

SpeedPieces::SpeedPieces(const Spline &curve, Interval range) {
    const ModelFrame frame = model_frame(curve);
    Ranges ranges{};
    ranges[0] = range;
    const Elements elements(curve, frame, ranges);
    const int p = curve.axis(0).degree();
    exponent_ = frame.exponent;
    form_.dim = curve.dim();
    form_.degree = curve.rational() ? std::max(2 * p - 2, 0) : std::max(p - 1, 0);
    form_.weight_degree = curve.rational() ? p : -1;
    basis_.resize(static_cast<size_t>((form_.degree + 1) * rule_capacity));
    rule_basis(form_.degree, basis_.data());
    form_.basis = basis_.data();
    if (curve.rational()) {
        weight_basis_.resize(static_cast<size_t>((p + 1) * rule_capacity));
        rule_basis(p, weight_basis_.data());
        form_.weight_basis = weight_basis_.data();
    }
    nets_.reserve(static_cast<size_t>(elements.size() * form_.size()));
    Element element;
    for (int64_t e = 0; e < elements.size(); ++e) {
        elements.load(e, element);
        add_piece(element, p);
        intervals_.push_back(elements.interval(e, 0));
    }
}

// Every point of the piece is off by (3 p + 2) eps of the spread, differences count twice.
void SpeedPieces::add_piece(const Element &element, int degree) {
    const int p = degree;
    const size_t start = nets_.size();
    nets_.resize(start + static_cast<size_t>(form_.size()), 0.0);
    double *out = nets_.data() + start;
    const double *w = element.net.data() + form_.dim * (p + 1);
    rounding_ += 2 * (3 * p + 2) * eps * element.spread;
    for (int c = 0; p > 0 && c < form_.dim; ++c, out += form_.degree + 1) {
        const double *a = element.net.data() + c * (p + 1);
        if (form_.weight_degree < 0) {
            for (int i = 0; i < p; ++i) {
                out[i] = p * (a[i + 1] - a[i]);
            }
            continue;
        }
        const double *choose = binomials(p - 1);
        for (int i = 0; i < p; ++i) {
            for (int j = 0; j < p; ++j) {
                out[i + j] += choose[i] * choose[j] * (a[i + 1] * w[j] - a[i] * w[j + 1]);
            }
        }
        const double *whole = binomials(form_.degree);
        for (int i = 0; i <= form_.degree; ++i) {
            out[i] *= p / whole[i];
        }
    }
    if (form_.weight_degree >= 0) {
        std::copy_n(w, p + 1, nets_.data() + start + form_.dim * (form_.degree + 1));
    }
}

Integral integrate(const SpeedPieces &pieces, double relative_tolerance, std::vector<LengthLeaf> *leaves,
                   std::vector<double> *nets) {
    const double tolerance = std::clamp(relative_tolerance, 4 * eps, 0.5);
    LengthSearch search(pieces, tolerance, leaves, nets);
    double length = rough_length(pieces);
    double share = 1.0 / (32.0 * static_cast<double>(pieces.size()));
    Integral result{0, 0};
    for (int attempt = 0; attempt < 4; ++attempt, share /= 64) {
        result = search.run(length, share);
        length = result.value;
        if (!(result.error > std::max(tolerance * result.value, pieces.rounding()))) {
            break;
        }
    }
    result.error += pieces.rounding() + 4 * eps * result.value;
    return result;
}

double rule_length(const SpeedForm &form, const double *net, int level) noexcept {
    alignas(64) std::array<double, rule_capacity> values;
    speeds(form, net, 0, rule_size(level), values.data());
    return weighted_sum(level, values.data());
}

Integral scaled_result(Integral integral, int exponent, double relative_tolerance, const char *what) {
    const double value = std::ldexp(integral.value, exponent), error = std::ldexp(integral.error, exponent);
    if (std::isfinite(integral.value) && !std::isfinite(value)) {
        fail(NURBS_ERROR_NOT_REPRESENTABLE, "the %s overflows double precision", what);
    }
    if (!std::isfinite(integral.value) || !std::isfinite(integral.error)) {
        fail(NURBS_ERROR_NOT_CONVERGED,
             "the %s did not converge to relative_tolerance = %s: the integrand has poles", what,
             Number(relative_tolerance).text);
    }
    return {value, error};
}

Integral curve_length(const Spline &curve, Interval range, double relative_tolerance) {
    const SpeedPieces pieces(curve, range);
    const Integral found = integrate(pieces, relative_tolerance);
    const Integral result = scaled_result(found, pieces.exponent(), relative_tolerance, "length");
    if (found.error > 2 * (std::max(relative_tolerance, 4 * eps) * found.value + pieces.rounding() +
                           4 * eps * found.value)) {
        fail(NURBS_ERROR_NOT_CONVERGED,
             "length = %s: the error reached is %s, expected relative_tolerance = %s",
             Number(result.value).text, Number(result.error).text, Number(relative_tolerance).text);
    }
    return result;
}

} // namespace nrb
