// SPDX-License-Identifier: MIT
#include "face/trims/monotone.h"

#include "base/numbers.h"
#include "bernstein/sign_runs.h"
#include "pieces/derivative_pieces.h"
#include "refine/compose/crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::face {

namespace {

bool runs_one_way(std::span<const double> values) noexcept {
    return std::is_sorted(values.begin(), values.end()) || std::is_sorted(values.rbegin(), values.rend());
}

// Appends the places where the derivative of a coordinate changes its sign.
void append_turns(const RoundedPolynomial &derivative, std::vector<double> &places) {
    int before = 0;
    double hidden = 0;
    for (const SignRun &run : sign_runs(derivative).runs) {
        if (run.sign == 0) {
            hidden = run.zero >= 0 ? run.zero : run.from / 2 + run.to / 2;
            continue;
        }
        if (before * run.sign < 0) {
            places.push_back(hidden);
        }
        before = run.sign;
        hidden = run.to;
    }
}

// Finds where the coordinates of a curve turn. The pieces that this takes cost time that is linear in the
// number of knots; they are made when a span needs them for the first time.
class Turns {
public:
    explicit Turns(const Spline &curve) noexcept : curve_(curve) {}

    // The places of a span, with 0 and 1, between which both coordinates are monotone. number: of the span,
    // among those that are not empty.
    std::vector<double> places(const refine::CurvePiece &span, int64_t number) {
        std::vector<double> places{0};
        std::optional<RoundedPolynomial> derivatives;
        for (const int k : {0, 1}) {
            if (!runs_one_way(span.coefficients(k))) {
                if (!derivatives) {
                    derivatives = pieces::tangent_numerator(maker().piece(number), 0);
                }
                append_turns(component(*derivatives, k), places);
            }
        }
        places.push_back(1);
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        return places;
    }

private:
    const pieces::PieceMaker &maker() {
        if (!maker_) {
            maker_.emplace(curve_, whole_domain(curve_));
        }
        return *maker_;
    }

    const Spline &curve_;
    std::optional<pieces::PieceMaker> maker_;
};

// Appends the monotone pieces of curves one after the other, and segments in the gaps between them.
class LoopPieces {
public:
    LoopPieces(int32_t number, TrimPieces &out) noexcept : number_(number), out_(out) {}
    LoopPieces(int32_t number, const Point2 &start, const Point2 &end, TrimPieces &out) noexcept
        : number_(number), out_(out), begun_(true), first_(start), last_(start), goal_(end) {}

    void add(const PlacedCurve &placed) {
        const KnotVector &axis = placed.curve->axis(0);
        Turns turns(*placed.curve);
        int64_t number = 0;
        for (int64_t span = axis.degree(); span < axis.count(); ++span) {
            if (axis[span] < axis[span + 1]) {
                const refine::CurvePiece piece(*placed.curve, span);
                const bool last = axis[span + 1] == axis.domain().upper;
                add_span(placed, piece, {axis[span], axis[span + 1]}, turns.places(piece, number++), last);
            }
        }
        ++curve_;
    }
    std::vector<Joint> close(const Point2 &turn) {
        if (goal_) {
            join(*goal_);
        } else if (begun_) {
            join({first_[0] + turn[0], first_[1] + turn[1]});
        }
        return std::move(joints_);
    }

private:
    void add_span(const PlacedCurve &placed, const refine::CurvePiece &span, const Interval &range,
                  const std::vector<double> &places, bool last) {
        TrimPieces whole;
        whole.add(piece_of(placed, span, range), coefficients_of(placed, span));
        const TrimPiece &piece = whole.all().front();
        step_to(piece);
        const Point2 own_end = last && goal_ && is_one_place(*goal_, piece.end, piece) ? *goal_ : piece.end;
        for (size_t i = 0; i + 1 < places.size(); ++i) {
            const Point2 end = places[i + 1] == 1 ? own_end : whole.point(piece, places[i + 1]);
            out_.add_part(whole, piece, {places[i], places[i + 1]}, last_, end, {0, 0});
            last_ = end;
        }
        behind_ = {curve_, range.upper};
    }
    // Whether rounding may account for the distance of two places.
    static bool is_one_place(const Point2 &x, const Point2 &y, const TrimPiece &piece) noexcept {
        return std::abs(x[0] - y[0]) <= 2 * piece.noise[0] && std::abs(x[1] - y[1]) <= 2 * piece.noise[1];
    }
    void step_to(const TrimPiece &piece) {
        if (!begun_) {
            first_ = last_ = piece.start;
            begun_ = true;
        }
        if (!is_one_place(last_, piece.start, piece)) {
            join(piece.start);
        }
    }
    void join(const Point2 &next) {
        if (last_ != next) {
            joints_.push_back({last_, next});
            out_.add_line(number_, last_, next, behind_.curve, behind_.param);
            last_ = next;
        }
    }
    [[nodiscard]] TrimPiece piece_of(const PlacedCurve &placed, const refine::CurvePiece &span,
                                     const Interval &range) const {
        TrimPiece piece;
        piece.loop = number_;
        piece.curve = curve_;
        piece.range = range;
        piece.degree = span.degree();
        piece.weighted = !span.weights().empty();
        for (size_t k = 0; k < 2; ++k) {
            const auto values = span.coefficients(static_cast<int>(k));
            piece.start[k] = values.front() + placed.shift[k];
            piece.end[k] = values.back() + placed.shift[k];
            double largest = std::abs(placed.shift[k]);
            for (const double x : values) {
                largest = std::max(largest, std::abs(x + placed.shift[k]));
            }
            piece.noise[k] = span.rounding(static_cast<int>(k)) + 2 * (span.degree() + 2) * eps * largest;
        }
        return piece;
    }
    static std::vector<double> coefficients_of(const PlacedCurve &placed, const refine::CurvePiece &span) {
        std::vector<double> result;
        for (size_t i = 0; i <= static_cast<size_t>(span.degree()); ++i) {
            const double weight = span.weights().empty() ? 1 : span.weights()[i];
            for (size_t k = 0; k < 2; ++k) {
                result.push_back((span.coefficients(static_cast<int>(k))[i] + placed.shift[k]) * weight);
            }
            if (!span.weights().empty()) {
                result.push_back(weight);
            }
        }
        return result;
    }

    struct CurvePlace {
        int32_t curve = 0;
        double param = 0;
    };

    int32_t number_;
    TrimPieces &out_;
    int32_t curve_ = 0;
    CurvePlace behind_; // the end of what was added last
    bool begun_ = false;
    Point2 first_{}, last_{};
    std::optional<Point2> goal_; // the end of a single curve
    std::vector<Joint> joints_;
};

} // namespace

std::vector<Joint> append_monotone(const std::vector<PlacedCurve> &loop, int32_t number, const Point2 &turn,
                                   TrimPieces &out) {
    LoopPieces pieces(number, out);
    for (const PlacedCurve &placed : loop) {
        pieces.add(placed);
    }
    return pieces.close(turn);
}

void append_between(const PlacedCurve &placed, int32_t number, const Point2 &start, const Point2 &end,
                    TrimPieces &out) {
    LoopPieces pieces(number, start, end, out);
    pieces.add(placed);
    pieces.close({0, 0});
}

} // namespace nrb::face
