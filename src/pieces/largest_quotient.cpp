// SPDX-License-Identifier: MIT
#include "pieces/largest_quotient.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::pieces {

namespace {

constexpr int64_t work_of_a_value = 16; // for bounding and storing the piece

// The denominators with their sign made positive, and the bounds of their exact values.
class Denominators {
public:
    explicit Denominators(const QuotientPiece &piece)
        : piece_(piece), sign_(piece.denominators.empty() || piece.denominators.front() >= 0 ? 1.0 : -1.0) {}

    [[nodiscard]] double sign() const noexcept { return sign_; }
    [[nodiscard]] double value(int64_t i) const noexcept {
        return piece_.denominators.empty() ? 1.0 : sign_ * piece_.denominators[static_cast<size_t>(i)];
    }
    [[nodiscard]] double least(int64_t i) const noexcept {
        return value(i) * (1 - piece_.denominator_factor) - piece_.denominator_error;
    }
    [[nodiscard]] double most(int64_t i) const noexcept {
        return value(i) * (1 + piece_.denominator_factor) + piece_.denominator_error;
    }

private:
    const QuotientPiece &piece_;
    double sign_;
};

double norm_at(const QuotientPiece &piece, int64_t i) noexcept {
    const double length = norm(piece.numerators.data() + i * piece.shape.width, piece.shape.width);
    return std::isnan(length) ? infinity : length;
}

double rounding(const QuotientPiece &piece) noexcept {
    return eps * (piece.shape.width + 8);
}

double upper_bound(const QuotientPiece &piece) noexcept {
    const Denominators denominators(piece);
    double largest = 0;
    for (int64_t i = 0; i < piece.shape.coefficients(); ++i) {
        const double least = denominators.least(i);
        if (!(least > 0)) {
            return infinity;
        }
        const double quotient = (norm_at(piece, i) + piece.numerator_error) / least;
        if (!(quotient <= largest)) {
            largest = quotient;
        }
    }
    const double factor = 1 + 2 * piece.denominator_factor + rounding(piece);
    const double upper = (largest + piece.quotient_error) * factor;
    return std::isnan(upper) ? infinity : upper;
}

// Index of the coefficient at a corner; bit k selects the end of axis k.
int64_t corner_index(const BernsteinShape &shape, int corner) noexcept {
    int64_t i = 0;
    for (int k = 0; k < max_axes; ++k) {
        const int n = shape.degrees[static_cast<size_t>(k)];
        i = i * (n + 1) + ((corner >> k & 1) != 0 ? n : 0);
    }
    return i;
}

double lower_bound(const QuotientPiece &piece) noexcept {
    const Denominators denominators(piece);
    double largest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int64_t i = corner_index(piece.shape, corner);
        const double most = denominators.most(i);
        const double quotient = (norm_at(piece, i) - piece.numerator_error) / most;
        if (most > 0 && quotient > largest && std::isfinite(quotient)) {
            largest = quotient;
        }
    }
    const double factor = 1 + 2 * piece.denominator_factor + rounding(piece);
    return std::max(0.0, largest / factor - piece.quotient_error * factor);
}

int next_axis(const QuotientPiece &piece) noexcept {
    for (int step = 1; step <= max_axes; ++step) {
        const int k = (piece.last_axis + step) % max_axes;
        if (piece.shape.degrees[static_cast<size_t>(k)] > 0) {
            return k;
        }
    }
    return -1;
}

// The largest quotient of coefficients. It bounds the ratio of any mean of numerators to the same mean of
// denominators if these have one sign, and the numerator is 0 wherever the denominator is. Infinite
// otherwise.
double ratio_bound(const QuotientPiece &piece) noexcept {
    const Denominators denominators(piece);
    double largest = 0;
    for (int64_t i = 0; i < piece.shape.coefficients(); ++i) {
        const double size = norm_at(piece, i), w = denominators.value(i);
        if (w < 0 || !(size == 0 || w > 0)) {
            return infinity;
        }
        largest = size == 0 ? largest : std::max(largest, size / w);
    }
    return largest;
}

// Adds the rounding of the means of one subdivision.
void add_rounding(QuotientPiece &piece, int degree) {
    const double error = eps * degree, ratio = ratio_bound(piece);
    if (std::isfinite(ratio)) {
        piece.quotient_error += error * ratio;
        piece.denominator_factor += piece.denominators.empty() ? 0 : error;
        return;
    }
    piece.numerator_error += error * largest_magnitude(piece.numerators) * std::sqrt(piece.shape.width);
    piece.denominator_error += error * largest_magnitude(piece.denominators);
}

// Branch and bound for |N| / W.
class LengthProblem {
public:
    using Piece = QuotientPiece;
    LengthProblem(const PieceSource &source, double ratio) : source_(source), ratio_(ratio) {}

    [[nodiscard]] Piece load(int64_t index) const {
        Piece piece;
        source_(index, piece);
        return piece;
    }
    [[nodiscard]] static Enclosure bounds(const Piece &piece) {
        count_work(work_of_a_value * std::ssize(piece.numerators));
        return quotient_bounds(piece);
    }
    [[nodiscard]] static double noise(const Piece &piece) noexcept { return piece.quotient_error; }
    [[nodiscard]] static std::optional<Piece> split(Piece &piece) {
        return next_axis(piece) < 0 ? std::nullopt : std::optional(halve(piece));
    }
    void found(int64_t /*index*/, const Piece & /*piece*/) const noexcept {}
    [[nodiscard]] bool reached(double lower, double upper, double noise) const noexcept {
        return upper - noise <= (1 + ratio_) * (lower + noise);
    }

private:
    const PieceSource &source_;
    double ratio_;
};

// Branch and bound for N / W, where N has one component.
class ValueProblem {
public:
    using Piece = QuotientPiece;
    ValueProblem(const PieceSource &source, double gap) : source_(source), gap_(gap) {}

    [[nodiscard]] Piece load(int64_t index) const {
        Piece piece;
        source_(index, piece);
        return piece;
    }
    [[nodiscard]] static Enclosure bounds(const Piece &piece) {
        count_work(work_of_a_value * std::ssize(piece.numerators));
        return {best_corner(piece).lower, upper(piece)};
    }
    [[nodiscard]] static double noise(const Piece &piece) noexcept { return piece.quotient_error; }
    [[nodiscard]] static std::optional<Piece> split(Piece &piece) {
        const int axis = most_curved_axis(piece);
        return axis < 0 ? std::nullopt : std::optional(halve(piece, axis));
    }
    void found(int64_t index, const Piece &piece) noexcept {
        best_.piece = index;
        const int corner = best_corner(piece).corner;
        for (size_t k = 0; k < best_.place.size(); ++k) {
            const bool end = (corner >> k & 1) != 0;
            best_.place[k] = piece.start[k] + (end ? piece.extent[k] : 0);
        }
    }
    [[nodiscard]] bool reached(double lower, double upper, double noise) const noexcept {
        return std::isfinite(upper - lower) && upper - lower <= gap_ + 4 * noise;
    }
    [[nodiscard]] static double upper(const Piece &piece) noexcept;
    [[nodiscard]] const LargestValue &best() const noexcept { return best_; }

private:
    struct Corner {
        double lower;
        int corner;
    };
    static Corner best_corner(const Piece &piece) noexcept;
    static int most_curved_axis(const Piece &piece) noexcept;

    const PieceSource &source_;
    double gap_;
    LargestValue best_{{-infinity, infinity}, -1, {}};
};

// By the mediant inequality. If W* lies between `least` and `most`, and N* is at most n, then N* / W* is at
// most n divided by one or the other. A coefficient that is exactly 0, with its weight, contributes nothing.
double ValueProblem::upper(const Piece &piece) noexcept {
    const Denominators denominators(piece);
    const double error = piece.quotient_error * (1 + 2 * piece.denominator_factor);
    const bool exact = piece.numerator_error == 0 && piece.denominator_error == 0;
    double largest = -infinity;
    for (int64_t i = 0; i < piece.shape.coefficients(); ++i) {
        const double n = denominators.sign() * piece.numerators[static_cast<size_t>(i)];
        const double least = denominators.least(i), most = denominators.most(i);
        if (exact && n == 0 && denominators.value(i) == 0) {
            continue;
        }
        const double top = n + piece.numerator_error;
        const double quotient = top >= 0 ? top / least : top / most;
        if (!(least > 0) || std::isnan(quotient)) {
            return infinity;
        }
        largest = std::max(largest, quotient + error + 4 * eps * std::abs(quotient));
    }
    return std::isfinite(largest) ? largest : infinity;
}

ValueProblem::Corner ValueProblem::best_corner(const Piece &piece) noexcept {
    const Denominators denominators(piece);
    const double error = piece.quotient_error * (1 + 2 * piece.denominator_factor);
    Corner best{-infinity, 0};
    for (int corner = 0; corner < 8; ++corner) {
        const int64_t i = corner_index(piece.shape, corner);
        const double n = denominators.sign() * piece.numerators[static_cast<size_t>(i)];
        const double least = denominators.least(i), bottom = n - piece.numerator_error;
        const double quotient = bottom >= 0 ? bottom / denominators.most(i) : bottom / least;
        const double lower = quotient - error - 4 * eps * std::abs(quotient);
        if (least > 0 && std::isfinite(lower) && lower > best.lower) {
            best = {lower, corner};
        }
    }
    return best;
}

// The axis along which the coefficients deviate most from a linear function, for which the bounds are
// attained at corners. Parts of 2^-40 are not subdivided any further.
int ValueProblem::most_curved_axis(const Piece &piece) noexcept {
    const double slope = ratio_bound(piece);
    const auto second = [](const std::vector<double> &x, size_t i, size_t step) {
        return x.empty() ? 0 : std::abs(x[i] - 2 * x[i + step] + x[i + 2 * step]);
    };
    int best = -1;
    double most = -1;
    size_t step = 1;
    for (size_t k = piece.shape.degrees.size(); k-- > 0;) {
        const auto n = static_cast<size_t>(piece.shape.degrees[k]);
        double bend = 0;
        for (size_t i = 0; n > 1 && i < piece.numerators.size(); ++i) {
            if (i / step % (n + 1) + 2 <= n) {
                const double w = second(piece.denominators, i, step);
                bend += second(piece.numerators, i, step) + (w == 0 || !std::isfinite(slope) ? w : slope * w);
            }
        }
        bend *= static_cast<double>(n) * static_cast<double>(n);
        if (n > 0 && piece.extent[k] > 0x1p-40 && !(bend <= most)) {
            best = static_cast<int>(k);
            most = bend;
        }
        step *= n + 1;
    }
    return best;
}

} // namespace

Enclosure quotient_bounds(const QuotientPiece &piece) {
    return {lower_bound(piece), upper_bound(piece)};
}

QuotientPiece halve(QuotientPiece &piece) {
    return halve(piece, next_axis(piece));
}

QuotientPiece halve(QuotientPiece &piece, int axis) {
    add_rounding(piece, piece.shape.degrees[static_cast<size_t>(axis)]);
    piece.last_axis = axis;
    double &extent = piece.extent[static_cast<size_t>(axis)];
    extent /= 2;
    count_work(2 * std::ssize(piece.numerators));
    QuotientPiece lower = piece;
    piece.start[static_cast<size_t>(axis)] += extent;
    halve(piece.shape, axis, piece.numerators.data(), lower.numerators.data());
    if (!piece.denominators.empty()) {
        BernsteinShape scalar = piece.shape;
        scalar.width = 1;
        halve(scalar, axis, piece.denominators.data(), lower.denominators.data());
    }
    return lower;
}

Enclosure largest_quotient(std::span<const double> uppers, const PieceSource &source,
                           const SearchLimits &limits) {
    LengthProblem problem(source, limits.ratio);
    return BranchAndBound(problem, uppers, 0).run(limits.steps);
}

std::vector<double> quotient_uppers(int64_t count, const PieceSource &source) {
    constexpr SearchLimits few{.ratio = 1, .steps = 64};
    std::vector<double> uppers;
    uppers.reserve(static_cast<size_t>(count));
    QuotientPiece piece;
    bool bounded = true; // one unbounded piece makes the result infinite
    for (int64_t i = 0; i < count; ++i) {
        source(i, piece);
        double upper = upper_bound(piece);
        if (bounded && std::isinf(upper)) { // a zero coefficient may not make its halves unbounded
            const PieceSource itself = [&piece](int64_t, QuotientPiece &out) { out = piece; };
            upper = largest_quotient({&upper, 1}, itself, few).upper;
            bounded = std::isfinite(upper);
        }
        uppers.push_back(upper);
    }
    return uppers;
}

LargestValue largest_value(int64_t count, const PieceSource &source, double gap, int steps) {
    constexpr int64_t room = int64_t{1} << 26; // in doubles
    ValueProblem problem(source, gap);
    std::vector<double> uppers;
    uppers.reserve(static_cast<size_t>(count));
    QuotientPiece piece;
    for (int64_t i = 0; i < count; ++i) {
        source(i, piece);
        uppers.push_back(ValueProblem::upper(piece));
    }
    const int64_t most = std::max<int64_t>(1, room / piece.shape.coefficients());
    BranchAndBound search(problem, uppers, -infinity);
    const Enclosure found = search.run(static_cast<int>(std::min<int64_t>(steps, most)));
    LargestValue result = problem.best();
    result.bounds = found;
    return result;
}

} // namespace nrb::pieces
