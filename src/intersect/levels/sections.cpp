// SPDX-License-Identifier: MIT
#include "intersect/levels/sections.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/level_curve.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// Between which values the function lies on each piece.
std::vector<Interval> ranges_of(LevelField &field) {
    std::vector<Interval> ranges;
    std::vector<double> values(field.coefficients()), weights(field.weighted() ? values.size() : 0);
    for (int64_t piece = 0; piece < field.grid().count(); ++piece) {
        field.net(piece, values, weights);
        count_work(8 * std::ssize(values));
        Interval range{infinity, -infinity};
        for (size_t i = 0; i < values.size(); ++i) {
            const double w = weights.empty() ? 1 : weights[i];
            const bool certain = w > field.least_weight();
            const double room = 5 * field.noise().absolute;
            range.lower = certain ? std::min(range.lower, (values[i] - room) / w) : -infinity;
            range.upper = certain ? std::max(range.upper, (values[i] + room) / w) : infinity;
        }
        ranges.push_back(range);
    }
    return ranges;
}

class Sections {
public:
    Sections(LevelField &field, double tolerance)
        : field_(field), borders_(field.grid()), tolerance_(tolerance), ranges_(ranges_of(field)) {}

    void add(double level, double off, int64_t index) {
        LevelTrace trace(field_, borders_, level, off, tolerance_);
        const double room = trace.room();
        for (int64_t piece = 0; piece < field_.grid().count(); ++piece) {
            const Interval range = ranges_[static_cast<size_t>(piece)];
            if (range.lower - room <= level && level <= range.upper + room) {
                trace.add(piece);
            }
        }
        add_chains(level, index, trace.noise(), trace.take());
    }
    Meet take() noexcept { return std::move(meet_); }

private:
    void add_chains(double level, int64_t index, const Noise &noise, const LevelPieces &found) {
        const LevelChains chains = chains_of(field_.grid(), borders_, found);
        const int64_t first_node = std::ssize(meet_.nodes), first_loop = loops_;
        for (const MeetNode &node : chains.nodes) {
            meet_.nodes.push_back(node);
            meet_.nodes.back().level = index;
            meet_.complete = meet_.complete && node.kind != NodeKind::undecided;
        }
        ArcFitter fitter(field_, level, noise, tolerance_);
        for (const LevelChain &chain : chains.chains) {
            LevelCurve curve = curve_of(fitter, field_.grid(), borders_, found, chain);
            const auto moved = [](int32_t i, int64_t first) { return i < 0 ? int64_t{-1} : first + i; };
            meet_.branches.push_back({index,
                                      std::move(curve.space),
                                      std::move(curve.on),
                                      curve.deviation,
                                      {moved(chain.nodes[0], first_node), moved(chain.nodes[1], first_node)},
                                      moved(chain.loop, first_loop)});
            loops_ = std::max(loops_, meet_.branches.back().loop + 1);
        }
    }

    int64_t loops_ = 0;
    LevelField &field_;
    SurfaceBorders borders_;
    double tolerance_;
    std::vector<Interval> ranges_;
    Meet meet_;
};

// Planes by a unit normal, however long the one that was given.
class Planes {
public:
    explicit Planes(const std::array<double, 3> &normal) : normal_(normal) {
        double largest = 0;
        for (const double x : normal) {
            largest = std::max(largest, std::abs(x));
        }
        exponent_ = std::ilogb(largest);
        for (double &x : normal_) {
            x = std::ldexp(x, -exponent_);
        }
        length_ = norm(normal_.data(), 3);
        for (double &x : normal_) {
            x /= length_;
        }
    }

    [[nodiscard]] const std::array<double, 3> &normal() const noexcept { return normal_; }
    [[nodiscard]] double distance(double offset) const noexcept {
        return std::ldexp(offset / length_, -exponent_);
    }

private:
    std::array<double, 3> normal_;
    int exponent_ = 0;
    double length_ = 1;
};

} // namespace

Meet plane_sections(const Spline &surface, const std::array<double, 3> &normal,
                    std::span<const double> offsets, double tolerance) {
    const UsualLimit usual(usual_work(surface.point_count() + 1000 * std::ssize(offsets)));
    const LimitedSearch limited;
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    const Planes planes(normal);
    PlaneField field(grid, planes.normal());
    Sections sections(field, grid.scaled(tolerance));
    Steps steps(std::ssize(offsets));
    for (size_t i = 0; i < offsets.size(); ++i, steps.next()) {
        double level = planes.distance(offsets[i]), size = std::abs(level);
        for (size_t c = 0; c < 3; ++c) {
            const double part = planes.normal()[c] * grid.frame().centre[c];
            level -= part;
            size += std::abs(part);
        }
        if (std::isfinite(size)) { // else it is farther away than numbers reach
            sections.add(grid.scaled(level), 8 * eps * grid.scaled(size), static_cast<int64_t>(i));
        }
    }
    return sections.take();
}

} // namespace nrb::intersect
