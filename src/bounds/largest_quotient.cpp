#include "bounds/largest_quotient.h"

#include "base/finite.h"
#include "base/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double infinite = std::numeric_limits<double>::infinity();

// The denominators with one sign, and what they are at least and at most.
class Denominators {
public:
    explicit Denominators(const QuotientPiece &piece)
        : piece_(piece), sign_(piece.denominators.empty() || piece.denominators.front() >= 0 ? 1.0 : -1.0) {}

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
    return std::isnan(length) ? infinite : length;
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
            return infinite;
        }
        const double quotient = (norm_at(piece, i) + piece.numerator_error) / least;
        if (!(quotient <= largest)) {
            largest = quotient;
        }
    }
    const double factor = 1 + 2 * piece.denominator_factor + rounding(piece);
    const double upper = (largest + piece.quotient_error) * factor;
    return std::isnan(upper) ? infinite : upper;
}

double lower_bound(const QuotientPiece &piece) noexcept {
    const auto &degrees = piece.shape.degrees;
    const Denominators denominators(piece);
    double largest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        int64_t i = 0;
        for (int k = 0; k < max_axes; ++k) {
            const int n = degrees[static_cast<size_t>(k)];
            i = i * (n + 1) + ((corner >> k & 1) != 0 ? n : 0);
        }
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

// The largest quotient of coefficients, which no mean of numerators exceeds relative to that of the
// denominators: those have one sign, and where one is 0 so is the numerator. Infinite where that is not so.
double ratio_bound(const QuotientPiece &piece) noexcept {
    const Denominators denominators(piece);
    double largest = 0;
    for (int64_t i = 0; i < piece.shape.coefficients(); ++i) {
        const double size = norm_at(piece, i), w = denominators.value(i);
        if (w < 0 || !(size == 0 || w > 0)) {
            return infinite;
        }
        largest = size == 0 ? largest : std::max(largest, size / w);
    }
    return largest;
}

// What the means of a subdivision add.
void add_rounding(QuotientPiece &piece, int degree) {
    const double share = eps * degree, ratio = ratio_bound(piece);
    if (std::isfinite(ratio)) {
        piece.quotient_error += share * ratio;
        piece.denominator_factor += piece.denominators.empty() ? 0 : share;
        return;
    }
    piece.numerator_error += share * largest_magnitude(piece.numerators) * std::sqrt(piece.shape.width);
    piece.denominator_error += share * largest_magnitude(piece.denominators);
}

// A piece in the heap: one of the source, or a part of it.
struct Candidate {
    double upper;
    double noise;
    int64_t index;
    QuotientPiece part; // empty: the piece of the source, not looked at yet

    [[nodiscard]] bool operator<(const Candidate &other) const noexcept { return upper < other.upper; }
};

class Search {
public:
    Search(std::span<const double> uppers, const PieceSource &source, const SearchLimits &limits)
        : source_(source), limits_(limits) {
        heap_.reserve(uppers.size());
        for (size_t i = 0; i < uppers.size(); ++i) {
            heap_.push_back({uppers[i], 0, static_cast<int64_t>(i), {}});
        }
        std::make_heap(heap_.begin(), heap_.end());
    }

    Enclosure run() {
        for (int step = 0; step < limits_.steps && !done(); ++step) {
            if (!refine()) {
                break;
            }
        }
        return {lower_, heap_.empty() ? 0.0 : heap_.front().upper};
    }

private:
    [[nodiscard]] bool done() const noexcept {
        if (heap_.empty()) {
            return true;
        }
        const Candidate &top = heap_.front();
        return top.upper - top.noise <= (1 + limits_.ratio) * (lower_ + top.noise);
    }

    // Halves the piece with the largest upper bound, of which at first no more than that is known; false if it
    // has no degree.
    bool refine() {
        std::pop_heap(heap_.begin(), heap_.end());
        Candidate top = std::move(heap_.back());
        heap_.pop_back();
        QuotientPiece piece = std::move(top.part);
        const bool known = !piece.numerators.empty();
        if (!known) {
            source_(top.index, piece);
        }
        if (!known || next_axis(piece) < 0) {
            push(std::move(piece), top);
            return !known;
        }
        QuotientPiece lower = halve(piece);
        push(std::move(lower), top);
        push(std::move(piece), top);
        return true;
    }

    // A part has no larger values than the whole.
    void push(QuotientPiece &&piece, const Candidate &whole) {
        const Enclosure bounds = quotient_bounds(piece);
        lower_ = std::max(lower_, bounds.lower);
        heap_.push_back(
            {std::min(bounds.upper, whole.upper), piece.quotient_error, whole.index, std::move(piece)});
        std::push_heap(heap_.begin(), heap_.end());
    }

    const PieceSource &source_;
    const SearchLimits &limits_;
    std::vector<Candidate> heap_;
    double lower_ = 0;
};

} // namespace

Enclosure quotient_bounds(const QuotientPiece &piece) {
    return {lower_bound(piece), upper_bound(piece)};
}

QuotientPiece halve(QuotientPiece &piece) {
    const int axis = next_axis(piece);
    add_rounding(piece, piece.shape.degrees[static_cast<size_t>(axis)]);
    piece.last_axis = axis;
    QuotientPiece lower = piece;
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
    return Search(uppers, source, limits).run();
}

std::vector<double> quotient_uppers(int64_t count, const PieceSource &source) {
    constexpr SearchLimits few{.ratio = 1, .steps = 64};
    std::vector<double> uppers;
    uppers.reserve(static_cast<size_t>(count));
    QuotientPiece piece;
    bool bounded = true; // one that is not is enough
    for (int64_t i = 0; i < count; ++i) {
        source(i, piece);
        double upper = upper_bound(piece);
        if (bounded && std::isinf(upper)) { // a coefficient of 0 is none of the parts
            const PieceSource itself = [&piece](int64_t, QuotientPiece &out) { out = piece; };
            upper = largest_quotient({&upper, 1}, itself, few).upper;
            bounded = std::isfinite(upper);
        }
        uppers.push_back(upper);
    }
    return uppers;
}

} // namespace nrb
