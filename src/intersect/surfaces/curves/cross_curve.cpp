// SPDX-License-Identifier: MIT
#include "intersect/surfaces/curves/cross_curve.h"

#include "base/numbers.h"
#include "intersect/smooth_joint.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

class CrossCurveMaker {
public:
    CrossCurveMaker(const pieces::Frame &frame, const CrossSurface &a, const CrossSurface &b,
                    std::vector<CrossSegment> segments, bool closed)
        : frame_(frame), surfaces_{&a, &b}, segments_(std::move(segments)), closed_(closed) {}

    CrossCurve run() {
        unwrap();
        CrossCurve curve{};
        knots_.assign(4, 0.0);
        add_point(segments_.front(), 0);
        double t = 0;
        for (size_t i = 0; i < segments_.size(); ++i) {
            const CrossSegment &segment = segments_[i];
            curve.deviation = std::max(curve.deviation, segment.deviation);
            add_point(segment, 1);
            add_point(segment, 2);
            t = std::max(t + frame_.unscaled(segment.length), std::nextafter(t, infinity));
            const bool last = i + 1 == segments_.size(), corner = last || !goes_on(segment, segments_[i + 1]);
            if (corner) {
                add_point(segment, 3);
            }
            knots_.insert(knots_.end(), last ? 4 : corner ? 3 : 2, t);
        }
        curve.deviation = frame_.unscaled(curve.deviation) + rounding();
        const Spline::Axes axes{make_knot_vector(3, knots_)};
        curve.space = make_result(axes, 3, Form::polynomial, std::move(space_));
        for (size_t s = 0; s < 2; ++s) {
            curve.on[s] = make_result(axes, 2, Form::polynomial, std::move(on_[s]));
        }
        return curve;
    }

private:
    // The rounding of stored control points, which are no larger than the centre plus the size of both
    // surfaces.
    [[nodiscard]] double rounding() const noexcept {
        double largest = frame_.unscaled(2);
        for (const double x : frame_.centre) {
            largest = std::max(largest, std::abs(x) + frame_.unscaled(2));
        }
        return 8 * eps * largest;
    }
    // Moves segments by periods where the chain crosses the seam of a periodic axis; along other axes, places
    // are clamped to the domain, as arcs along a border may be beyond it. Each segment begins exactly where
    // the one before ends.
    void unwrap() {
        std::array<double, 4> shift{};
        for (size_t i = 0; i < segments_.size(); ++i) {
            for (size_t c = 0; c < 4; ++c) {
                const SurfaceBorders &borders = surfaces_[c / 2]->borders;
                const size_t s = c / 2, k = c % 2;
                if (borders.is_periodic(k) && i > 0) {
                    const double gap = segments_[i - 1].on[s][3][k] - segments_[i].on[s][0][k] - shift[c];
                    shift[c] += borders.period(k) * std::round(gap / borders.period(k));
                }
                for (std::array<double, 2> &place : segments_[i].on[s]) {
                    place[k] = borders.is_periodic(k) ? place[k] + shift[c] : in_domain(place[k], s, k);
                }
            }
            if (i > 0) {
                begin_where_ends(segments_[i - 1], segments_[i]);
            }
        }
        if (closed_) {
            close();
        }
    }
    // Makes the end of a closed curve equal to its beginning bit for bit, or a whole number of periods away.
    void close() noexcept {
        CrossSegment next = segments_.front(), &last = segments_.back();
        for (size_t c = 0; c < 4; ++c) {
            const SurfaceBorders &borders = surfaces_[c / 2]->borders;
            if (borders.is_periodic(c % 2)) {
                const double period = borders.period(c % 2), end = last.on[c / 2][3][c % 2];
                double &begin = next.on[c / 2][0][c % 2];
                begin += period * std::round((end - begin) / period);
            }
        }
        last.deviation += moved_by_joining(last, next);
        last.space[3] = next.space[0];
        for (size_t s = 0; s < 2; ++s) {
            last.on[s][3] = next.on[s][0];
        }
    }
    [[nodiscard]] double in_domain(double at, size_t surface, size_t axis) const noexcept {
        const pieces::PieceGrid &grid = surfaces_[surface]->grid;
        const int k = static_cast<int>(axis);
        return std::clamp(at, grid.break_at(k, 0), grid.break_at(k, grid.count(k)));
    }
    // How far joining moves an end. It is of the order of rounding, except next to the shifted sides of boxes
    // at kinks, and where surfaces nearly touch.
    static double moved_by_joining(const CrossSegment &before, const CrossSegment &after) noexcept {
        double moved = distance(before.space[3].data(), after.space[0].data(), 3);
        for (size_t s = 0; s < 2; ++s) {
            double on = 0;
            for (size_t k = 0; k < 2; ++k) {
                on += after.slopes[2 * s + k] * std::abs(before.on[s][3][k] - after.on[s][0][k]);
            }
            moved = std::max(moved, on);
        }
        return moved;
    }
    static void begin_where_ends(const CrossSegment &before, CrossSegment &after) noexcept {
        after.deviation += moved_by_joining(before, after);
        after.space[0] = before.space[3];
        for (size_t s = 0; s < 2; ++s) {
            after.on[s][0] = before.on[s][3];
        }
    }
    static bool goes_on(const CrossSegment &a, const CrossSegment &b) noexcept {
        return is_smooth_joint(a.on[0], a.length, b.on[0], b.length) &&
               is_smooth_joint(a.on[1], a.length, b.on[1], b.length) &&
               is_smooth_joint(a.space, a.length, b.space, b.length);
    }
    void add_point(const CrossSegment &segment, size_t i) {
        for (size_t s = 0; s < 2; ++s) {
            on_[s].insert(on_[s].end(), segment.on[s][i].begin(), segment.on[s][i].end());
        }
        for (size_t c = 0; c < 3; ++c) {
            space_.push_back(frame_.original(c, segment.space[i][c]));
        }
    }

    const pieces::Frame &frame_;
    std::array<const CrossSurface *, 2> surfaces_;
    std::vector<CrossSegment> segments_;
    bool closed_;
    std::vector<double> knots_, space_;
    std::array<std::vector<double>, 2> on_;
};

} // namespace

CrossCurve cross_curve(const pieces::Frame &frame, const CrossSurface &a, const CrossSurface &b,
                       std::vector<CrossSegment> segments, bool closed) {
    return CrossCurveMaker(frame, a, b, std::move(segments), closed).run();
}

CrossCurve cross_curve(CrossFitter &fitter, const pieces::Frame &frame, const CrossSurface &a,
                       const CrossSurface &b, const CrossParts &found, const CrossChain &chain) {
    std::vector<CrossSegment> segments;
    for (const size_t arc : chain.arcs) {
        fitter.fit(found.arcs[arc], segments);
    }
    return CrossCurveMaker(frame, a, b, std::move(segments), chain.closed).run();
}

MeetBranch branch_along(CrossCurve curve, const std::array<int64_t, 2> &nodes, int64_t loop,
                        BranchKind kind) {
    MeetBranch branch{0, std::move(curve.space), std::move(curve.on[0]), curve.deviation, nodes, loop};
    branch.on_second = std::move(curve.on[1]);
    branch.kind = kind;
    return branch;
}

} // namespace nrb::intersect
