// SPDX-License-Identifier: MIT
// Pieces of a curve that run beside a piece of a surface.
#pragma once

#include "intersect/curve_surface/foot_curve.h"
#include "intersect/pairs/chart.h"

#include <vector>

namespace nrb::intersect {

// With a chart of S over its tangent plane, which also holds where S goes on as a polynomial, whatever is near has its place
// on S near p(t). What C(t) - S(p(t)) is along the normal tells then how far apart both are, to an order by which p is off
// and the normal turns.
class Alongside {
public:
    enum class Verdict {
        apart, // farther than near, for certain
        along, // C is no farther than near and the slack from S over core()
        ends,  // what is near is over reach(), but over no range of S
        open,
    };
    Verdict look(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double slack);

    // After open: whether C is long beside S, as p goes.
    [[nodiscard]] bool is_long() const noexcept { return is_long_; }

    // Places on C: where p is on S, and where something may be near.
    [[nodiscard]] Interval core() const noexcept { return core_; }
    [[nodiscard]] Interval reach() const noexcept { return reach_; }
    // The lines on S that the ends of the core are on: 2 axis, and 1 more for the upper one; none: -1.
    [[nodiscard]] int line_at(bool last) const noexcept { return lines_[last ? 1 : 0]; }
    // Of all places on S that may be near, in [0, 1]^2; and p there.
    [[nodiscard]] const Box<2> &room() const noexcept { return room_; }
    [[nodiscard]] Place<2> foot(double t) const { return feet_.at(t); }

private:
    static bool is_level(const pieces::SlopedPiece &arc, const SlopedPatch &patch) noexcept;
    bool set_region(const SlopedPatch &patch);
    void measure(double rounding, double near);
    bool is_apart(double near) const noexcept;
    Verdict cut();
    Verdict cut_at(int line);
    void set_line_at_ends(const std::vector<double> &inside, double room, int line) noexcept;
    void cut_monotone(const std::vector<double> &inside, double room, int line);
    void set_room();

    FootCurve feet_;
    Box<2> region_{}; // of places on S: [0, 1]^2 and p
    pieces::BezierPiece extended_;
    std::optional<PatchSlopes> extended_slopes_;
    SlopedPatch over_region_{};
    Chart chart_; // of S over it
    std::array<double, 3> normal_{};
    bool is_long_ = false;
    double largest_ = 0;      // difference
    double tangential_ = 0;   // M times one
    Interval along_normal_{}; // products of differences with the normal
    double off_ = 0;          // how far what is near may be from p, in the region
    Place<2> rooms_{};        // the same along both axes of S
    Interval core_{}, reach_{};
    std::array<int, 2> lines_{};
    Box<2> room_{};
};

} // namespace nrb::intersect
