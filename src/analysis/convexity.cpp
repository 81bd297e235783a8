// SPDX-License-Identifier: MIT
#include "analysis/convexity.h"

#include "analysis/curve_pieces.h"
#include "analysis/curve_turns.h"
#include "base/numbers.h"
#include "bernstein/sign_runs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::analysis {

namespace {

// An angle with a bound on its rounding error; infinite if the angle is not known.
struct Turn {
    double angle = 0;
    double error = 0;
};

// The angle by which a vector polynomial turns. If it certainly stays in an open half-plane, that is the
// angle between its values at the ends; otherwise the sum of the angles of its halves.
Turn turn_of(RoundedPolynomial d, int depth) {
    const size_t end = d.values.size() - 2;
    const double ax = d.values[0], ay = d.values[1], bx = d.values[end], by = d.values[end + 1];
    const double a = std::hypot(ax, ay), b = std::hypot(bx, by);
    const RoundedPolynomial half =
        sum(scaled(component(d, 0), ax / a + bx / b), ay / a + by / b, component(d, 1));
    if (certain_sign(half) > 0) {
        const double error =
            std::hypot(d.error(0), d.error(1)) / a + std::hypot(d.error(end), d.error(end + 1)) / b;
        return {std::atan2(ax * by - ay * bx, ax * bx + ay * by), 1.01 * error + 8 * eps};
    }
    if (depth == 0) {
        return {0, infinity};
    }
    const RoundedPolynomial lower = split(d, last_axis);
    const Turn first = turn_of(lower, depth - 1);
    if (std::isinf(first.error)) {
        return first;
    }
    const Turn second = turn_of(d, depth - 1);
    return {first.angle + second.angle, first.error + second.error};
}

class ConvexityTest {
public:
    explicit ConvexityTest(const Spline &curve) : pieces_(curve) {}

    int32_t run() {
        for (size_t e = 0; e < pieces_.count(); ++e) {
            knot(e);
            piece(e);
        }
        if (both_ || broken_) {
            return convexity_none;
        }
        if (unknown_ || std::isinf(total_.error)) {
            return convexity_undecided;
        }
        if (sign_ == 0) {
            return convexity_straight;
        }
        const double full = 2 * std::numbers::pi;
        if (std::abs(total_.angle) > full + total_.error + 4 * full * eps) {
            return convexity_none;
        }
        return sign_ > 0 ? convexity_left : convexity_right;
    }

private:
    void note(int sign) noexcept {
        both_ = both_ || sign * sign_ < 0;
        sign_ = sign != 0 ? sign : sign_;
    }

    void knot(size_t e) {
        const pieces::HomogeneousPiece *before = pieces_.before(e);
        if (before == nullptr) {
            return;
        }
        const EndTangent a = end_tangent(*before, true), b = end_tangent(pieces_.piece(e), false);
        const double angle = turning_angle(a, b);
        broken_ = broken_ || pieces_.jump(e) > 0 ||
                  std::abs(angle) > std::numbers::pi - a.turned - b.turned - 4 * eps;
        total_.angle += angle;
        total_.error += a.turned + b.turned;
        note(angle > 0 ? 1 : angle < 0 ? -1 : 0);
    }

    // A zero of the tangent inside a piece is a cusp or a place where the curve stands still. At the ends of
    // a piece zeros are divided out; knot() tests whether the curve turns back there.
    void piece(size_t e) {
        const pieces::HomogeneousPiece &piece = pieces_.piece(e);
        unknown_ = unknown_ || !piece.positive;
        RoundedPolynomial d = pieces::tangent_numerator(piece, 0);
        if (divide_end(d, last_axis, false) < 0) {
            unknown_ = true;
            return;
        }
        divide_end(d, last_axis, true);
        for (const ZeroPlace &zero : zero_places(d)) {
            (zero.certain ? broken_ : unknown_) = true;
        }
        for (const SignRun &run : sign_runs(pieces::bend_numerator(piece)).runs) {
            note(run.sign);
        }
        if (!broken_ && !unknown_) {
            const Turn turn = turn_of(std::move(d), 40);
            total_ = {total_.angle + turn.angle, total_.error + turn.error};
        }
    }

    CurvePieces pieces_;
    int sign_ = 0;
    bool both_ = false;
    bool broken_ = false;
    bool unknown_ = false;
    Turn total_;
};

} // namespace

int32_t convexity(const Spline &curve) {
    return ConvexityTest(curve).run();
}

} // namespace nrb::analysis
