// SPDX-License-Identifier: MIT
#include "intersect/levels/curves/level_curve.h"

#include "base/numbers.h"
#include "intersect/smooth_joint.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// Where curves of a chain go on across the seam of a periodic axis, they are moved by periods.
void unwrap(const SurfaceBorders &borders, std::vector<LevelSegment> &segments) {
    std::array<double, 2> shift{};
    for (size_t i = 0; i < segments.size(); ++i) {
        for (size_t k = 0; k < 2; ++k) {
            if (i > 0 && borders.is_periodic(k)) {
                const double gap = segments[i - 1].on[3][k] - segments[i].on[0][k] - shift[k];
                shift[k] += borders.period(k) * std::round(gap / borders.period(k));
            }
            for (std::array<double, 2> &place : segments[i].on) {
                place[k] += shift[k];
            }
        }
    }
}

class CurveMaker {
public:
    CurveMaker(const pieces::PieceGrid &grid, std::vector<LevelSegment> segments, bool closed)
        : grid_(grid), segments_(std::move(segments)), closed_(closed) {}

    LevelCurve run() {
        LevelCurve curve{};
        knots_.assign(4, 0.0);
        add_point(segments_.front().on[0], segments_.front().space[0]);
        double t = 0;
        for (size_t i = 0; i < segments_.size(); ++i) {
            const LevelSegment &segment = segments_[i];
            curve.deviation = std::max(curve.deviation, segment.deviation);
            add_point(segment.on[1], segment.space[1]);
            add_point(segment.on[2], segment.space[2]);
            t = std::max(t + grid_.unscaled(segment.length), std::nextafter(t, infinity));
            const bool last = i + 1 == segments_.size(), corner = last || !goes_on(segment, segments_[i + 1]);
            if (corner) {
                add_point(segment.on[3], last && closed_ ? segments_.front().space[0] : segment.space[3]);
            }
            knots_.insert(knots_.end(), last ? 4 : corner ? 3 : 2, t);
        }
        curve.deviation = grid_.unscaled(curve.deviation);
        const Spline::Axes axes{make_knot_vector(3, knots_)};
        curve.space = make_result(axes, 3, Form::polynomial, std::move(space_));
        curve.on = make_result(axes, 2, Form::polynomial, std::move(on_));
        return curve;
    }

private:
    static bool goes_on(const LevelSegment &a, const LevelSegment &b) noexcept {
        return is_smooth_joint(a.on, a.length, b.on, b.length) &&
               is_smooth_joint(a.space, a.length, b.space, b.length);
    }
    void add_point(const std::array<double, 2> &on, const std::array<double, 3> &space) {
        on_.insert(on_.end(), on.begin(), on.end());
        for (size_t c = 0; c < 3; ++c) {
            space_.push_back(grid_.frame().original(c, space[c]));
        }
    }

    const pieces::PieceGrid &grid_;
    std::vector<LevelSegment> segments_;
    bool closed_;
    std::vector<double> knots_, on_, space_;
};

} // namespace

LevelCurve curve_of(ArcFitter &fitter, const pieces::PieceGrid &grid, const SurfaceBorders &borders,
                    const LevelPieces &found, const LevelChain &chain) {
    std::vector<LevelSegment> segments;
    for (const size_t arc : chain.arcs) {
        fitter.fit(found.arcs[arc], segments);
    }
    unwrap(borders, segments);
    return CurveMaker(grid, std::move(segments), chain.closed).run();
}

} // namespace nrb::intersect
