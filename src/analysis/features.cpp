// SPDX-License-Identifier: MIT
#include "analysis/features.h"

#include "analysis/curve_pieces.h"
#include "analysis/curve_signs.h"
#include "analysis/curve_turns.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/frames/curve_limit.h"
#include "eval/frames/magnitude.h"

#include <algorithm>
#include <cmath>

namespace nrb::analysis {

namespace {

// 2 M' w S + 6 M w' S - 3 M w S' in the plane, or Q' w S + 6 Q w' S - 3 Q w S' for Q = M . M in space. If w
// is constant, the factor w is omitted.
RoundedPolynomial slope_numerator(const pieces::HomogeneousPiece &piece, const RoundedPolynomial &m) {
    const RoundedPolynomial d = pieces::tangent_numerator(piece, 0), s = dot(d, d);
    const bool plane = m.shape.width == 1;
    const RoundedPolynomial q = plane ? m : dot(m, m);
    RoundedPolynomial rise =
        scaled(derivative(q, last_axis) * s, plane ? 2 : 1) - scaled(q * derivative(s, last_axis), 3);
    if (piece.weight.shape.coefficients() == 1) {
        return rise;
    }
    return rise * piece.weight + scaled(q * s * derivative(piece.weight, last_axis), 6);
}

// The sign of the product of two functions, 0 where either is not known.
std::vector<SignRun> product_runs(const std::vector<SignRun> &a, const std::vector<SignRun> &b) {
    std::vector<double> cuts;
    for (const auto *runs : {&a, &b}) {
        for (const SignRun &run : *runs) {
            cuts.insert(cuts.end(), {run.from, run.to});
        }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    const auto sign_on = [](const std::vector<SignRun> &runs, double from, double to) {
        const auto run = std::find_if(runs.begin(), runs.end(),
                                      [&](const SignRun &r) { return r.from <= from && to <= r.to; });
        return run == runs.end() ? 0 : run->sign;
    };
    const auto zero_in = [](const std::vector<SignRun> &runs, double from, double to) {
        const auto run = std::find_if(runs.begin(), runs.end(), [&](const SignRun &r) {
            return r.zero >= 0 && r.from <= from && to <= r.to && from <= r.zero && r.zero <= to;
        });
        return run == runs.end() ? -1 : run->zero;
    };
    std::vector<SignRun> result;
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double from = cuts[i], to = cuts[i + 1];
        result.push_back(
            {from, to, sign_on(a, from, to) * sign_on(b, from, to), false, zero_in(a, from, to)});
    }
    return result;
}

class FeatureFinder {
public:
    FeatureFinder(const Spline &curve, uint32_t kinds) : curve_(curve), kinds_(kinds), pieces_(curve) {}

    Features run() {
        using Search = void (FeatureFinder::*)();
        const std::pair<uint32_t, Search> searches[] = {
            {feature_inflection,
             curve_.dim() == 2 ? &FeatureFinder::plane_inflections : &FeatureFinder::space_inflections},
            {feature_curvature_maximum | feature_curvature_minimum, &FeatureFinder::extrema},
            {feature_cusp, &FeatureFinder::cusps},
            {feature_kink | feature_jump, &FeatureFinder::knots},
            {feature_torsion, &FeatureFinder::torsion}};
        Steps steps(std::ranges::count_if(searches, [&](const auto &search) { return wants(search.first); }));
        for (const auto &[kinds, search] : searches) {
            if (wants(kinds)) {
                (this->*search)();
                steps.next();
            }
        }
        std::stable_sort(found_.list.begin(), found_.list.end(),
                         [](const Feature &a, const Feature &b) { return a.at < b.at; });
        return std::move(found_);
    }

private:
    [[nodiscard]] bool wants(uint32_t kinds) const noexcept { return (kinds_ & kinds) != 0; }
    void add(double at, int32_t kind, double value) { found_.list.push_back({at, kind, value}); }
    [[nodiscard]] double curvature(double t) const {
        double result = 0;
        const eval::AxisRules rules{};
        eval::for_each_magnitude(curve_, rules, {&t, 1}, [&result](const eval::MagnitudeRun &run) {
            eval::Jet::prepare(run.spline);
            result =
                std::ldexp(eval::limit_frame(run.spline, run.rules, run.params(0, 0)).curvature, run.size);
        });
        return result;
    }
    void add_changes(const CurveSigns &signs, int32_t kind) {
        found_.complete = found_.complete && signs.complete;
        for (const SignChange &change : sign_changes(signs.runs, pieces_.periodic())) {
            add(change.at, kind, curvature(change.at));
        }
    }

    void plane_inflections() {
        add_changes(curve_signs(pieces_, pieces::bend_numerator), feature_inflection);
    }
    void torsion() { add_changes(curve_signs(pieces_, pieces::twist_numerator), feature_torsion); }

    struct CurveZero {
        double from;
        double to;
        bool certain;
    };
    // The zeros of a vector on all pieces. A zero at a knot, found on both sides, counts once.
    std::vector<CurveZero> zeros(const Numerator &numerator) {
        std::vector<CurveZero> result;
        Steps steps(static_cast<int64_t>(pieces_.count()));
        for (size_t e = 0; e < pieces_.count() && !work_ended(); ++e, steps.next()) {
            const pieces::HomogeneousPiece &piece = pieces_.piece(e);
            found_.complete = found_.complete && piece.positive;
            for (const ZeroPlace &place : zero_places(numerator(piece))) {
                const CurveZero zero{piece.parameter(0, place.from), piece.parameter(0, place.to),
                                     place.certain};
                if (!result.empty() && zero.from <= result.back().to) {
                    result.back().certain = result.back().certain && zero.certain;
                    result.back().to = zero.to;
                } else {
                    result.push_back(zero);
                }
                found_.complete = found_.complete && zero.certain;
            }
        }
        found_.complete = found_.complete && !work_ended();
        const Interval domain = curve_.axis(0).domain();
        if (pieces_.periodic() && result.size() > 1 && result.back().to == domain.upper &&
            result.front().from == domain.lower) {
            result.pop_back();
        }
        return result;
    }
    // A zero that is neither certain nor short has no definite place: nothing may be known of the vector
    // there, as where it vanishes everywhere.
    static bool is_place(const CurveZero &zero, Interval domain) noexcept {
        return zero.certain || zero.to - zero.from < 0x1p-20 * (domain.upper - domain.lower);
    }

    void space_inflections() {
        const Interval domain = curve_.axis(0).domain();
        for (const CurveZero &zero : zeros(pieces::bend_numerator)) {
            const double at = zero.from / 2 + zero.to / 2;
            const bool end = at <= domain.lower || at >= domain.upper;
            if (is_place(zero, domain) && !(end && !pieces_.periodic())) {
                add(at, feature_inflection, curvature(at));
            }
        }
    }

    void cusps() {
        const auto tangent = [](const pieces::HomogeneousPiece &piece) {
            return pieces::tangent_numerator(piece, 0);
        };
        for (const CurveZero &zero : zeros(tangent)) {
            const double at = zero.from / 2 + zero.to / 2;
            if (is_place(zero, curve_.axis(0).domain())) {
                const bool knot = multiplicity(curve_.axis(0).knots(), at) > 0;
                const double bend = knot ? curvature(at) : infinity;
                add(at, feature_cusp, std::isnan(bend) ? infinity : bend);
            }
        }
    }

    void knots() {
        Steps steps(static_cast<int64_t>(pieces_.count()));
        for (size_t e = 0; e < pieces_.count() && !work_ended(); ++e, steps.next()) {
            if (pieces_.order(e) < 1) {
                knot(e);
            }
        }
        found_.complete = found_.complete && !work_ended();
    }

    void knot(size_t e) {
        const pieces::HomogeneousPiece *before = pieces_.before(e);
        if (before == nullptr) {
            return;
        }
        const double at = pieces_.start(e), gap = pieces_.jump(e);
        const double angle = turning_angle(end_tangent(*before, true), end_tangent(pieces_.piece(e), false));
        if (wants(feature_kink) && angle != 0) {
            add(at, feature_kink, angle);
        }
        if (wants(feature_jump) && gap > 0) {
            add(at, feature_jump, gap);
        }
    }

    // 1 if the curvature jumps up at the start of piece e, -1 if it jumps down.
    [[nodiscard]] int curvature_step(size_t e) {
        const pieces::HomogeneousPiece *before = pieces_.order(e) >= 2 ? nullptr : pieces_.before(e);
        if (before == nullptr) {
            return 0;
        }
        const auto a = end_curvature(*before, true), b = end_curvature(pieces_.piece(e), false);
        if (!a || !b || !(std::abs(b->value - a->value) > a->error + b->error)) {
            return 0;
        }
        return b->value > a->value ? 1 : -1;
    }

    // Whether the curvature vanishes somewhere in [from, to].
    [[nodiscard]] static bool is_flat(const std::vector<CurveRun> &bends, double from, double to) noexcept {
        return std::any_of(bends.begin(), bends.end(), [&](const CurveRun &run) {
            return run.sign == 0 && run.from <= to && from <= run.to;
        });
    }

    // Appends the sign of the derivative of |curvature| on a piece to `rises`, and the places where M
    // vanishes to `bends`.
    static void append_piece(const pieces::HomogeneousPiece &piece, CurveSigns &rises, CurveSigns &bends) {
        const RoundedPolynomial m = pieces::bend_numerator(piece);
        if (exactly_zero(m)) {
            rises.runs.push_back({piece.parameter(0, 0), piece.parameter(0, 1), 0});
            bends.runs.push_back(rises.runs.back());
            return;
        }
        const RoundedPolynomial q = m.shape.width == 1 ? m : dot(m, m);
        SignRuns slope = sign_runs(slope_numerator(piece, m));
        const SignRuns bend = sign_runs(q);
        CurveSigns parts, own;
        append_runs(piece, slope, own);
        append_runs(piece, bend, parts);
        bends.complete = bends.complete && (m.shape.width > 1 || parts.complete);
        bends.runs.insert(bends.runs.end(), parts.runs.begin(), parts.runs.end());
        if (bend.zeros_at_start != 0 || bend.nothing) {
            bends.runs.push_back({piece.parameter(0, 0), piece.parameter(0, 0), 0});
        }
        if (bend.zeros_at_end != 0 || bend.nothing) {
            bends.runs.push_back({piece.parameter(0, 1), piece.parameter(0, 1), 0});
        }
        slope.runs = m.shape.width == 1 ? product_runs(slope.runs, bend.runs) : slope.runs;
        const bool complete = rises.complete && own.complete;
        append_runs(piece, slope, rises);
        rises.complete = complete; // the product's own flag counts intervals on which it is 0 as hidden
    }

    void extrema() {
        CurveSigns rises, bends;
        Steps steps(static_cast<int64_t>(pieces_.count()));
        for (size_t e = 0; e < pieces_.count(); ++e, steps.next()) {
            rises.runs.push_back({pieces_.start(e), pieces_.start(e), work_ended() ? 0 : curvature_step(e)});
            if (!work_ended() && pieces_.piece(e).positive) {
                append_piece(pieces_.piece(e), rises, bends);
            } else {
                rises.complete = false;
            }
        }
        found_.complete = found_.complete && rises.complete && bends.complete;
        for (const SignChange &change : sign_changes(rises.runs, pieces_.periodic())) {
            const bool least = change.after > 0;
            if (wants(least ? feature_curvature_minimum : feature_curvature_maximum) &&
                !(least && is_flat(bends.runs, change.from, change.to))) {
                add(change.at, least ? feature_curvature_minimum : feature_curvature_maximum,
                    curvature(change.at));
            }
        }
    }

    const Spline &curve_;
    uint32_t kinds_;
    CurvePieces pieces_;
    Features found_;
};

} // namespace

Features curve_features(const Spline &curve, uint32_t kinds) {
    const UsualLimit usual(usual_work(curve.point_count()));
    const LimitedSearch search;
    return FeatureFinder(curve, kinds).run();
}

} // namespace nrb::analysis
