// SPDX-License-Identifier: MIT
#include "face/trims/trim_piece.h"

#include "base/limits.h"
#include "base/numbers.h"
#include "basis/bspline.h"
#include "bernstein/de_casteljau.h"
#include "numeric/exact_products.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::face {

namespace {

constexpr int max_width = 3;

void set_box(TrimPiece &piece) noexcept {
    for (size_t k = 0; k < 2; ++k) {
        piece.lower[k] = std::min(piece.start[k], piece.end[k]);
        piece.upper[k] = std::max(piece.start[k], piece.end[k]);
    }
}

// Narrows down the part of a piece that contains the column of x.
class ColumnSearch {
public:
    ColumnSearch(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &x) noexcept
        : pieces_(pieces), piece_(piece), x_(x),
          sense_(piece.start[0] < piece.end[0] ? 1 : -1), ends_{piece.start, piece.end} {}

    // False position, with a bisection at every third step, until the part lies above or below x, or rounding
    // hides where it lies.
    int side() noexcept {
        for (int step = 0;; ++step) {
            if (const int known = known_side(); known != 0) {
                return known;
            }
            const double middle = places_[0] + (places_[1] - places_[0]) / 2;
            if (!(places_[0] < middle && middle < places_[1])) {
                return 0;
            }
            const double guess = step % 3 == 2 ? middle : false_position();
            const double t = places_[0] < guess && guess < places_[1] ? guess : middle;
            if (!narrow(t) && !narrow_around(t)) {
                return known_side();
            }
        }
    }

private:
    [[nodiscard]] int known_side() const noexcept {
        const double noise = piece_.noise[1];
        return x_[1] < std::min(ends_[0][1], ends_[1][1]) - noise   ? 1
               : x_[1] > std::max(ends_[0][1], ends_[1][1]) + noise ? -1
                                                                    : 0;
    }
    [[nodiscard]] double false_position() const noexcept {
        const double below = sense_ * (x_[0] - ends_[0][0]), above = sense_ * (ends_[1][0] - x_[0]);
        return places_[0] + (places_[1] - places_[0]) * (below / (below + above));
    }
    // Drops the side of t on which the column certainly is not; false if rounding hides which side that is.
    bool narrow(double t) noexcept {
        const Point2 at = pieces_.point(piece_, t);
        const double ahead = sense_ * (at[0] - x_[0]);
        if (std::abs(ahead) <= piece_.noise[0]) {
            return false;
        }
        const size_t end = ahead > 0 ? 1 : 0;
        places_[end] = t;
        ends_[end] = at;
        return true;
    }
    // Where rounding hides on which side of t the column is: drops what is certainly before and after it.
    // False if there is nothing to drop.
    bool narrow_around(double t) noexcept {
        const double height = std::abs(ends_[1][0] - ends_[0][0]);
        const double share = height > 0 ? 4 * piece_.noise[0] / height : 1;
        bool cut = false;
        for (const int direction : {-1, 1}) {
            const double end = places_[direction < 0 ? 0 : 1];
            for (int k = 0; std::ldexp(share, 2 * k) < 1; ++k) {
                const double before = t + (end - t) * std::ldexp(share, 2 * k);
                if (before != t && before != end && narrow(before)) {
                    cut = true;
                    break;
                }
            }
        }
        return cut;
    }

    const TrimPieces &pieces_;
    const TrimPiece &piece_;
    const Point2 &x_;
    double sense_;
    std::array<double, 2> places_{0, 1};
    std::array<Point2, 2> ends_;
};

} // namespace

// The last step of de Casteljau's algorithm gives both the point and the derivative.
TrimPieces::Jet TrimPieces::jet(const TrimPiece &piece, double place) const noexcept {
    const auto width = static_cast<size_t>(piece.weighted ? 3 : 2);
    std::array<double, max_width *(max_basis + 1)> work;
    const auto values = coefficients(piece);
    std::copy(values.begin(), values.end(), work.begin());
    for (int level = piece.degree; level > 1; --level) {
        casteljau_step(level * static_cast<int64_t>(width), static_cast<int64_t>(width), place, work.data());
    }
    std::array<double, max_width> x{0, 0, 1}, change{};
    for (size_t c = 0; c < width; ++c) {
        const double next = piece.degree > 0 ? work[width + c] : work[c];
        x[c] = (1 - place) * work[c] + place * next;
        change[c] = piece.degree * (next - work[c]);
    }
    Jet result;
    for (size_t k = 0; k < 2; ++k) {
        result.point[k] = x[k] / x[2];
        result.derivative[k] = (change[k] - result.point[k] * change[2]) / x[2];
    }
    return result;
}

Point2 TrimPieces::point(const TrimPiece &piece, double place) const noexcept {
    return jet(piece, place).point;
}

// Newton's method within a bracket. It bisects where a step leaves the bracket, or neither halves it nor is
// shorter than a quarter of it; it ends when steps are lost in rounding.
double TrimPieces::place_of(const TrimPiece &piece, int k, double value) const noexcept {
    const auto at = static_cast<size_t>(k);
    const bool rising = piece.start[at] < piece.end[at];
    double from = 0, to = 1;
    double place = std::clamp((value - piece.start[at]) / (piece.end[at] - piece.start[at]), 0.0, 1.0);
    for (;;) {
        const double middle = from + (to - from) / 2, size = to - from;
        if (!(from < middle && middle < to)) {
            return middle;
        }
        place = from < place && place < to ? place : middle;
        const Jet jet = this->jet(piece, place);
        const double step = (value - jet.point[at]) / jet.derivative[at], next = place + step;
        if (jet.point[at] == value || next == place) {
            return place;
        }
        ((jet.point[at] < value) == rising ? from : to) = place;
        place = to - from <= size / 2 || std::abs(step) < size / 4 ? next : from + (to - from) / 2;
    }
}

int TrimPieces::side(const TrimPiece &piece, const Point2 &x) const noexcept {
    if (piece.start[0] == piece.end[0] || piece.start == x || piece.end == x) {
        return 0;
    }
    if (piece.degree == 1 && !piece.weighted) {
        const int left = side_of_line(piece.start.data(), piece.end.data(), x.data());
        return piece.start[0] < piece.end[0] ? -left : left;
    }
    return ColumnSearch(*this, piece, x).side();
}

int TrimPieces::order(const TrimPiece &a, const TrimPiece &b) const noexcept {
    const double left = std::max(a.lower[0], b.lower[0]), right = std::min(a.upper[0], b.upper[0]);
    for (const double share : {0.5, 1.0, 0.0, 0.75, 0.25, 0.9375, 0.0625}) {
        const double u = share == 1 ? right : left + share * (right - left);
        if (!(left <= u && u <= right) || a.lower[0] == a.upper[0]) {
            return 0;
        }
        const Point2 x{u, u == a.start[0] ? a.start[1]
                          : u == a.end[0] ? a.end[1]
                                          : point(a, place_of(a, 0, u))[1]};
        const int found = x[1] < b.lower[1] ? 1 : x[1] > b.upper[1] ? -1 : side(b, x);
        if (found != 0) {
            return found;
        }
    }
    return 0;
}

bool TrimPieces::meets(const TrimPiece &piece, const Point2 &lower, const Point2 &upper) const noexcept {
    const double left = std::max(lower[0], piece.lower[0]), right = std::min(upper[0], piece.upper[0]);
    const double bottom = std::max(lower[1], piece.lower[1]), top = std::min(upper[1], piece.upper[1]);
    const bool rising = (piece.start[0] < piece.end[0]) == (piece.start[1] < piece.end[1]);
    const Point2 above{rising ? left : right, top}, below{rising ? right : left, bottom};
    return side(piece, above) <= 0 && side(piece, below) >= 0;
}

void TrimPieces::add(TrimPiece piece, std::span<const double> coefficients) {
    set_box(piece);
    piece.first = std::ssize(pool_);
    pool_.insert(pool_.end(), coefficients.begin(), coefficients.end());
    pieces_.push_back(piece);
}

void TrimPieces::add_line(int32_t loop, const Point2 &start, const Point2 &end, int32_t curve, double param) {
    const std::array values{start[0], start[1], end[0], end[1]};
    TrimPiece piece;
    piece.start = start;
    piece.end = end;
    piece.loop = loop;
    piece.curve = curve;
    piece.range = {param, param};
    add(piece, values);
}

void TrimPieces::add_part(const TrimPieces &from, const TrimPiece &piece, Interval part, const Point2 &start,
                          const Point2 &end, const Point2 &move) {
    const int width = piece.weighted ? 3 : 2;
    const auto values = from.coefficients(piece);
    std::array<double, max_width * max_basis> work;
    std::array<double, max_basis> one;
    for (int c = 0; c < width; ++c) {
        for (int i = 0; i <= piece.degree; ++i) {
            one[static_cast<size_t>(i)] = values[static_cast<size_t>(i * width + c)];
        }
        restrict_to(piece.degree, part.lower, part.upper, one.data());
        for (int i = 0; i <= piece.degree; ++i) {
            work[static_cast<size_t>(i * width + c)] = one[static_cast<size_t>(i)];
        }
    }
    for (int i = 0; i <= piece.degree; ++i) {
        double *record = work.data() + i * width;
        const double weight = piece.weighted ? record[2] : 1;
        record[0] += move[0] * weight;
        record[1] += move[1] * weight;
    }
    TrimPiece copy = piece;
    copy.start = start;
    copy.end = end;
    copy.range = {parameter_at(piece, part.lower), parameter_at(piece, part.upper)};
    add(copy, std::span(work).first(static_cast<size_t>((piece.degree + 1) * width)));
}

} // namespace nrb::face
