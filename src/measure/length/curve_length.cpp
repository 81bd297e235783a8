// SPDX-License-Identifier: MIT
#include "measure/length/curve_length.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "measure/length/speed_net.h"
#include "measure/tolerance_ladder.h"
#include "numeric/sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace nrb::measure {

namespace {

constexpr int first_level = 2; // 15 nodes
// At tolerances below this, 15 nodes are seldom enough: 31 at once take less time, and their coefficients
// show the decay better. Tables of lengths prefer few nodes.
constexpr double sharp = 1e-8;
constexpr int most_halvings_of_curve = 200;
constexpr int64_t leaves_for_a_piece = 256, leaves_at_least = 20000;

// Quadrature rules of increasing level on one part of a piece.
class Ladder {
public:
    Ladder(const SpeedForm &form, const double *net, int level)
        : form_(form), net_(net), level_(level), decay_(speed_decay(form, net, 0, level, speeds_.data())) {}

    [[nodiscard]] double value() const noexcept { return decay_.integral; }
    [[nodiscard]] double error() const noexcept { return decay_.error(decay_.integral); }
    [[nodiscard]] double last() const noexcept { return decay_.last; }
    [[nodiscard]] int level() const noexcept { return level_; }

    // Raises the level as long as one of the next two levels is likely to be accurate enough; false if
    // neither is.
    bool climb(double tolerance) noexcept {
        while (!(error() <= tolerance)) {
            if (level_ + 1 == rule_levels || !promising(tolerance)) {
                return false;
            }
            const int before = rule_size(level_++);
            decay_ = speed_decay(form_, net_, before, level_, speeds_.data());
        }
        return true;
    }

private:
    [[nodiscard]] bool promising(double tolerance) const noexcept {
        return decay_.one_higher() * value() <= tolerance ||
               (level_ + 2 < rule_levels && decay_.two_higher() * value() <= tolerance);
    }

    const SpeedForm &form_;
    const double *net_;
    alignas(64) std::array<double, rule_capacity> speeds_;
    int level_;
    RuleDecay decay_;
};

constexpr int64_t work_of_a_value = 8; // per value of a net, for the nodes of a rule

// One adaptive search, for a given estimate of the whole length.
class LengthSearch {
public:
    LengthSearch(const SpeedPieces &pieces, double tolerance, std::vector<LengthLeaf> *leaves,
                 std::vector<double> *nets)
        : pieces_(pieces), tolerance_(tolerance), leaves_(leaves), nets_(nets),
          first_level_(leaves == nullptr && tolerance < sharp && pieces.form().size() > pieces.form().dim
                           ? first_level + 1
                           : first_level),
          budget_(leaves_at_least + leaves_for_a_piece * pieces.size()) {}

    // `fraction`: every part, however small, may have an error of this fraction of the whole tolerance.
    Integral run(double length, double fraction) {
        least_ = tolerance_ * length * fraction;
        if (leaves_ != nullptr) {
            leaves_->clear();
            nets_->clear();
            // Most pieces are one leaf each; growing the arrays would copy them all.
            leaves_->reserve(static_cast<size_t>(pieces_.size()));
            nets_->reserve(static_cast<size_t>(pieces_.size() * pieces_.form().size()));
        }
        total_ = error_ = CompensatedSum();
        constexpr int64_t pieces_of_a_step = 16;
        Steps steps(pieces_.size() / pieces_of_a_step + 1);
        for (int64_t e = 0; e < pieces_.size(); ++e) {
            run_piece(e);
            if ((e + 1) % pieces_of_a_step == 0) {
                steps.next();
            }
        }
        return {total_.value(), error_.value()};
    }

    [[nodiscard]] bool spent() const noexcept { return budget_ < 0; }

private:
    struct SpeedPart {
        double lower, upper;
        int halvings;
    };

    void run_piece(int64_t piece) {
        const auto size = static_cast<size_t>(pieces_.form().size());
        stack_.resize(std::max(stack_.size(), size));
        std::copy_n(pieces_.net(piece), size, stack_.data());
        parts_.assign(1, {0, 1, 0});
        while (!parts_.empty()) {
            const SpeedPart part = parts_.back();
            if (finish(piece, part, stack_.data() + (parts_.size() - 1) * size)) {
                parts_.pop_back();
            } else {
                halve_top(part, size);
            }
        }
    }

    bool finish(int64_t piece, const SpeedPart &part, const double *net) {
        count_work(work_of_a_value * pieces_.form().size());
        const NetShape shape = net_shape(pieces_.form(), net);
        return shape.even ? finish_even(piece, part, net, shape)
                          : finish_uneven(piece, part, net, shape.bound());
    }

    // Handles a part on which the error estimates of the rules are reliable; returns whether it is accepted.
    bool finish_even(int64_t piece, const SpeedPart &part, const double *net, const NetShape &shape) {
        Ladder ladder(pieces_.form(), net, first_level_);
        const bool good = ladder.climb(std::max(least_, tolerance_ / 2 * ladder.value()));
        if (!good && ladder.value() < infinity && shape.bound() > least_ && may_halve(part)) {
            return false;
        }
        accept(piece, part, ladder, good ? ladder.error() : shape.bound(), net);
        return true;
    }

    // On any other part, the net alone decides that it has to be halved, unless the part is too small to
    // matter. If nothing bounds its length, a value at a node may still show that the length is infinite.
    bool finish_uneven(int64_t piece, const SpeedPart &part, const double *net, double bound) {
        if (bound > least_ && bound < infinity && may_halve(part)) {
            return false;
        }
        const Ladder ladder(pieces_.form(), net, first_level_);
        if (bound == infinity && ladder.value() < infinity && may_halve(part)) {
            return false;
        }
        accept(piece, part, ladder, bound, net);
        return true;
    }

    bool may_halve(const SpeedPart &part) noexcept {
        return part.halvings < most_halvings_of_curve && --budget_ >= 0;
    }

    // The lower half ends up on top of the stack.
    void halve_top(const SpeedPart &part, size_t size) {
        const size_t end = parts_.size() * size;
        stack_.resize(std::max(stack_.size(), end + size));
        double *net = stack_.data() + end - size;
        halve_net(pieces_.form(), net, net + size);
        const double middle = part.lower / 2 + part.upper / 2;
        parts_.back() = {middle, part.upper, part.halvings + 1};
        parts_.push_back({part.lower, middle, part.halvings + 1});
    }

    void accept(int64_t piece, const SpeedPart &part, const Ladder &ladder, double error, const double *net) {
        total_.add(ladder.value());
        error_.add(std::isfinite(error) ? error : infinity);
        if (leaves_ != nullptr) {
            count_work(work_of_a_value * pieces_.form().size()); // for memory
            leaves_->push_back({piece, part.lower, part.upper, ladder.level(), ladder.value()});
            nets_->insert(nets_->end(), net, net + pieces_.form().size());
        }
    }

    const SpeedPieces &pieces_;
    double tolerance_;
    std::vector<LengthLeaf> *leaves_;
    std::vector<double> *nets_;
    int first_level_;
    int64_t budget_;
    double least_ = 0;
    CompensatedSum total_;
    CompensatedSum error_;
    std::vector<double> stack_;
    std::vector<SpeedPart> parts_;
};

// The length by 7 nodes per piece.
double rough_length(const SpeedPieces &pieces) {
    constexpr int64_t most = 4096; // pieces per call
    double length = 0;
    for (int64_t first = 0; first < pieces.size(); first += most) {
        const int64_t count = std::min(most, pieces.size() - first);
        length += sum_of_speeds(pieces.form(), pieces.net(first), count, rule_weights(1));
        count_work(work_of_a_value * pieces.form().size() * count);
    }
    return length;
}

// How much weights may increase the rounding of the length: the ratio of the largest to the smallest one, at
// most 64. The rounding of weighted coefficients changes the speed by a multiple of w_0 w_1 / w^2. Because
// w = (1 - t) w_0 + t w_1, that is at most 1 / (4 t (1 - t)), so that its integral grows no faster than the
// logarithm of the ratio.
double weight_ratio(const double *weights, int degree) noexcept {
    double least = degree < 0 ? 1 : std::abs(weights[0]), most = least;
    for (int i = 1; i <= degree; ++i) {
        least = std::min(least, std::abs(weights[i]));
        most = std::max(most, std::abs(weights[i]));
    }
    return least > 0 ? std::min(most / least, 64.0) : 64;
}

} // namespace

SpeedPieces::SpeedPieces(const Spline &curve, Interval range) {
    const pieces::Frame frame = integral_frame(curve);
    const Elements elements(curve, frame, Part{range});
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
    intervals_.reserve(static_cast<size_t>(elements.size()));
    nets_.reserve(static_cast<size_t>(elements.size() * form_.size()));
    Element element;
    for (int64_t e = 0; e < elements.size(); ++e) {
        count_work(work_of_a_value * form_.size());
        elements.load(e, element);
        add_piece(element, p);
        intervals_.push_back(elements.interval(e, 0));
    }
}

// Every point of the piece has an error within (3 p + 2) eps of the spread, and a difference twice that. Most
// errors are far smaller, so that their sum over the piece is taken to be no larger.
void SpeedPieces::add_piece(const Element &element, int degree) {
    const int p = degree;
    const size_t start = nets_.size();
    nets_.resize(start + static_cast<size_t>(form_.size()), 0.0);
    double *out = nets_.data() + start;
    const double *w = element.net.data() + int64_t{form_.dim} * (p + 1);
    rounding_ += 2 * (3 * p + 2) * eps * element.spread * weight_ratio(w, form_.weight_degree);
    for (int c = 0; p > 0 && c < form_.dim; ++c, out += form_.degree + 1) {
        const double *a = element.net.data() + int64_t{c} * (p + 1);
        if (form_.weight_degree < 0) {
            for (int i = 0; i < p; ++i) {
                out[i] = p * (a[i + 1] - a[i]);
            }
            continue;
        }
        wronskian(p, a, w, out);
    }
    if (form_.weight_degree >= 0) {
        std::copy_n(w, p + 1, nets_.data() + start + int64_t{form_.dim} * (form_.degree + 1));
    }
}

namespace {

// Whether the error of a whole length is as small as requested, with an allowance for rounding.
bool good_enough(const SpeedPieces &pieces, Integral found, double tolerance) noexcept {
    return !(found.error > 2 * ((tolerance + 4 * eps) * found.value + pieces.rounding()));
}

Integral integrate_to(const SpeedPieces &pieces, double tolerance, std::vector<LengthLeaf> *leaves,
                      std::vector<double> *nets) {
    LengthSearch search(pieces, tolerance, leaves, nets);
    double length = rough_length(pieces);
    double fraction = 1.0 / (32.0 * static_cast<double>(pieces.size()));
    Integral result{0, 0};
    for (int attempt = 0; attempt < 4; ++attempt) {
        const Phase phase(0.75);
        result = search.run(length, fraction);
        fraction /= 64;
        length = result.value;
        if (search.spent() || !(result.error > std::max(tolerance * result.value, pieces.rounding()))) {
            break;
        }
    }
    result.error += pieces.rounding() + 4 * eps * result.value;
    return result;
}

} // namespace

Integral integrate(const SpeedPieces &pieces, double relative_tolerance, std::vector<LengthLeaf> *leaves,
                   std::vector<double> *nets) {
    ToleranceLadder ladder(relative_tolerance);
    Integral result;
    do {
        result = integrate_to(pieces, ladder.tolerance(), leaves, nets);
        result.good = good_enough(pieces, result, std::max(ladder.tolerance(), relative_tolerance));
    } while (!result.good && ladder.loosen());
    return result;
}

double rule_length(const SpeedForm &form, const double *net, int level) noexcept {
    alignas(64) std::array<double, rule_capacity> values;
    speeds(form, net, 0, rule_size(level), values.data());
    return std::inner_product(values.begin(), values.begin() + rule_size(level), rule_weights(level), 0.0);
}

Integral scaled_result(Integral integral, int exponent, double relative_tolerance, const char *what) {
    const double value = std::ldexp(integral.value, exponent), error = std::ldexp(integral.error, exponent);
    if (std::isfinite(integral.value) && !std::isfinite(value)) {
        fail(Status::not_representable, "the %s overflows double precision", what);
    }
    if (!std::isfinite(integral.value) || !std::isfinite(integral.error)) {
        fail(Status::not_converged,
             "the %s did not converge to relative_tolerance = %s: the integrand has poles", what,
             Number(relative_tolerance).text);
    }
    return {value, error};
}

Integral curve_length(const Spline &curve, Interval range, double relative_tolerance) {
    const SpeedPieces pieces(curve, range);
    const Integral found = integrate(pieces, relative_tolerance);
    const Integral result = scaled_result(found, pieces.exponent(), relative_tolerance, "length");
    if (!found.good) {
        fail(Status::not_converged, "length = %s: the error reached is %s, expected relative_tolerance = %s",
             Number(result.value).text, Number(result.error).text, Number(relative_tolerance).text);
    }
    return result;
}

} // namespace nrb::measure
