// SPDX-License-Identifier: MIT
#include "closest/curve/curve_critical.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/sign_runs.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "pieces/derivative_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

// A place where the derivative of the distance may change its sign, with the signs on both sides. At an end
// of the curve, or of one of its arcs between jumps, `before` or `after` is missing.
struct Event {
    static constexpr int missing = 2;

    double t;
    int before;
    int after;
    bool left;      // the limit from below is meant
    bool continuum; // the derivative vanishes on the piece that starts here
    double distance = 0;
    std::vector<double> point = {};

    [[nodiscard]] bool decided() const noexcept { return before != 0 && after != 0 && !continuum; }
    // A missing sign is assumed to be opposite to the other one, as at an extremum.
    [[nodiscard]] int32_t kind() const noexcept {
        if (!decided()) {
            return critical_undecided;
        }
        const int in = before == missing ? -after : before, out = after == missing ? -before : after;
        return in == out ? critical_saddle : in < 0 ? critical_minimum : critical_maximum;
    }
};

// What join() needs of a piece: its end points, and the behaviour of the derivative of the distance at its
// ends.
struct PieceEnds {
    int first_sign = 0;
    int last_sign = 0;
    int zeros_at_start = 0;
    int zeros_at_end = 0;
    bool nothing = false;
    bool examined = false;
    std::vector<double> start;
    std::vector<double> end;
};

std::vector<double> point_of(const pieces::HomogeneousPiece &piece, bool last) {
    const auto dim = piece.centre.size();
    const size_t at = last ? piece.points.values.size() - dim : 0;
    const double w = last ? piece.weight.values.back() : piece.weight.values.front();
    std::vector<double> x(dim);
    for (size_t c = 0; c < dim; ++c) {
        x[c] = piece.centre[c] + std::ldexp(piece.points.values[at + c], piece.exponent) / w;
    }
    return x;
}

// D, the numerator of the piece relative to the query point.
RoundedPolynomial offset_from(const pieces::HomogeneousPiece &piece, const double *x) {
    std::vector<RoundedPolynomial> shift;
    for (size_t c = 0; c < piece.centre.size(); ++c) {
        RoundedPolynomial one = constant(std::ldexp(x[c] - piece.centre[c], -piece.exponent));
        one.errors[0] = eps * std::abs(one.values[0]);
        shift.push_back(std::move(one));
    }
    return piece.points - side_by_side(shift) * piece.weight;
}

// A lower bound on the distance of the query point from a piece: its distance from the box of the control
// points; 0 unless all weights are positive.
double least_distance(const pieces::HomogeneousPiece &piece, const double *x) noexcept {
    const auto dim = piece.centre.size();
    const auto count = static_cast<size_t>(piece.points.shape.coefficients());
    const auto weights = static_cast<size_t>(piece.weight.shape.coefficients());
    return norm_of(static_cast<int>(dim), [&](int c) {
        const auto at = static_cast<size_t>(c);
        double lower = std::numeric_limits<double>::infinity(), upper = -lower;
        for (size_t i = 0; i < count; ++i) {
            const double w = piece.weight.values[weights == 1 ? 0 : i];
            const double y =
                piece.centre[at] + std::ldexp(piece.points.values[i * dim + at], piece.exponent) / w - x[c];
            lower = w > 0 ? std::min(lower, y) : -std::numeric_limits<double>::infinity();
            upper = w > 0 ? std::max(upper, y) : std::numeric_limits<double>::infinity();
        }
        return std::max({lower, -upper, 0.0});
    });
}

constexpr int64_t work_of_an_event = 500; // one evaluation of the curve
constexpr int64_t work_of_a_piece = 2000; // products of polynomials and their signs

class CurveCriticalSearch {
public:
    CurveCriticalSearch(const Spline &curve, const CriticalQuestion &question)
        : curve_(curve), question_(question), maker_(curve, question.part) {}

    CriticalSet run() {
        const int64_t count = maker_.count();
        PieceEnds first, previous;
        Steps steps(count);
        for (int64_t i = 0; i < count; ++i, steps.next()) {
            const PieceEnds ends = look_at(i);
            if (i == 0) {
                first = ends;
            } else {
                join(previous, ends, maker_.breaks(0)[static_cast<size_t>(i)]);
            }
            previous = ends;
        }
        close(previous, first);
        place();
        return take();
    }

private:
    // Records the critical points in the interior of piece i.
    PieceEnds look_at(int64_t i) {
        PieceEnds ends;
        if (++examined_ > question_.budget || work_ended()) {
            out_of_budget_ = true;
            return ends;
        }
        const pieces::HomogeneousPiece piece = maker_.piece(i);
        count_work(work_of_a_piece);
        ends.start = point_of(piece, false);
        ends.end = point_of(piece, true);
        if (least_distance(piece, question_.point) > question_.within) {
            return ends;
        }
        const SignRuns signs =
            sign_runs(dot(offset_from(piece, question_.point), pieces::tangent_numerator(piece, 0)));
        ends.examined = true;
        ends.nothing = signs.nothing;
        ends.first_sign = signs.runs.front().sign;
        ends.last_sign = signs.runs.back().sign;
        ends.zeros_at_start = signs.zeros_at_start;
        ends.zeros_at_end = signs.zeros_at_end;
        if (signs.nothing) {
            events_.push_back({piece.parameter(0, 0), 0, 0, false, true});
        }
        for (size_t k = 1; !signs.nothing && k < signs.runs.size(); ++k) {
            note_between(piece, signs.runs, k);
        }
        return ends;
    }

    // Records run k if it is a zero; consecutive runs with signs have a zero between them.
    void note_between(const pieces::HomogeneousPiece &piece, const std::vector<SignRun> &runs, size_t k) {
        const SignRun &run = runs[k];
        const double middle = run.from + (run.to - run.from) / 2;
        if (run.sign == 0 && k + 1 < runs.size()) {
            const int hidden = run.simple || runs[k - 1].sign != runs[k + 1].sign ? 1 : 0;
            events_.push_back({piece.parameter(0, middle), runs[k - 1].sign * hidden,
                               runs[k + 1].sign * hidden, false, false});
        }
    }

    // Records an event at t, where two consecutive pieces meet.
    void join(const PieceEnds &below, const PieceEnds &above, double t) {
        if (below.end.empty() || above.start.empty()) {
            return; // one of them is beyond the budget
        }
        if (!meet(below, above)) { // the curve jumps
            end_arc(below, t);
            start_arc(above, t);
            return;
        }
        if (!below.examined || !above.examined || below.nothing || above.nothing) {
            return; // too far away, or part of a continuum
        }
        const bool zero = below.zeros_at_end > 0 || above.zeros_at_start > 0;
        if (below.last_sign != above.first_sign || zero || below.last_sign == 0) {
            events_.push_back({t, below.last_sign, above.first_sign, false, false});
        }
    }
    void end_arc(const PieceEnds &ends, double t) {
        if (ends.examined && !ends.nothing) {
            events_.push_back({t, ends.last_sign, Event::missing, true, false});
        }
    }
    void start_arc(const PieceEnds &ends, double t) {
        if (ends.examined && !ends.nothing) {
            events_.push_back({t, Event::missing, ends.first_sign, false, false});
        }
    }

    // Records the ends of the part, or the seam of a closed curve.
    void close(const PieceEnds &last, const PieceEnds &first) {
        const Interval part = question_.part[0];
        const auto inside = std::ssize(events_);
        closes_ = same(part, curve_.axis(0).domain()) && !last.end.empty() && !first.start.empty() &&
                  meet(last, first);
        closes_ ? join(last, first, part.lower) : start_arc(first, part.lower);
        std::rotate(events_.begin(), events_.begin() + inside, events_.end());
        if (!closes_) {
            end_arc(last, part.upper);
        }
        std::stable_sort(events_.begin(), events_.end(),
                         [](const Event &a, const Event &b) { return a.t < b.t; });
    }
    [[nodiscard]] bool meet(const PieceEnds &below, const PieceEnds &above) const noexcept {
        const int dim = curve_.dim();
        const double size = norm(below.end.data(), dim) + norm(question_.point, dim);
        return distance(below.end.data(), above.start.data(), dim) <=
               64 * (curve_.axis(0).degree() + 1) * eps * size;
    }

    // Computes the points and distances of the events.
    void place() {
        const int dim = curve_.dim();
        for (Event &event : events_) {
            count_work(work_of_an_event);
            eval::AxisRules rules;
            rules[0].left = event.left;
            event.point.resize(static_cast<size_t>(dim));
            eval::evaluate_points(curve_, rules, 0, {&event.t, 1, 1, 1, 1},
                                  {event.point.data(), 1, dim, dim, 1});
            event.distance = distance(event.point.data(), question_.point, dim);
        }
    }

    // Moves the events of a closed curve round until the first and the last one are not near to each other.
    void start_apart() {
        for (size_t i = 0; closes_ && i < events_.size(); ++i) {
            if (!near(i > 0 ? events_[i - 1] : events_.back(), events_[i])) {
                std::rotate(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(i), events_.end());
                return;
            }
        }
    }

    // Merges events that are too near to each other and makes the result.
    CriticalSet take() {
        start_apart();
        CriticalSet set;
        bool certain = !out_of_budget_;
        for (size_t i = 0; i < events_.size(); ++i) {
            Event event = events_[i];
            while (i + 1 < events_.size() && near(event, events_[i + 1])) {
                event.after = events_[++i].after;
            }
            certain = certain && event.decided();
            set.status |= event.continuum ? closest_not_unique : 0;
            const bool end = event.before == Event::missing || event.after == Event::missing;
            Foot foot{{event.t}, event.distance, end ? closest_boundary : 0, 0, event.left ? 1u : 0u};
            set.points.push_back({foot, event.kind()});
        }
        std::ranges::stable_sort(set.points, {}, [](const CriticalPoint &c) { return c.foot.params[0]; });
        set.status |= certain ? closest_certified : 0;
        set.status |= out_of_budget_ ? closest_budget : 0;
        return set;
    }
    [[nodiscard]] bool near(const Event &a, const Event &b) const noexcept {
        const bool arc = a.after != Event::missing && b.before != Event::missing;
        return arc && !a.continuum && !b.continuum &&
               distance(a.point.data(), b.point.data(), curve_.dim()) <= question_.apart;
    }

    const Spline &curve_;
    const CriticalQuestion &question_;
    pieces::PieceMaker maker_;
    int64_t examined_ = 0;
    bool out_of_budget_ = false;
    bool closes_ = false; // the last piece continues in the first one
    std::vector<Event> events_;
};

} // namespace

CriticalSet critical_points(const Spline &curve, const CriticalQuestion &question) {
    return CurveCriticalSearch(curve, question).run();
}

} // namespace nrb::closest
