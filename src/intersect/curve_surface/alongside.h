// SPDX-License-Identifier: MIT
// Curve pieces that run along a surface piece.
#pragma once

#include "intersect/curve_surface/foot_curve.h"
#include "intersect/pairs/chart.h"

#include <vector>

namespace nrb::intersect {

// C is the piece of the curve, S that of the surface, and p(t) the curve of foot points on S (FootCurve).
// With a chart of S over its tangent plane, which also holds where the polynomial of S extends beyond the
// piece, every place on S that is near C(t) is close to p(t). The component of C(t) - S(p(t)) along the
// normal then gives the distance of both, up to how far p is off and the normal turns.
class Alongside {
public:
    enum class Verdict {
        apart, // certainly farther apart than near
        along, // C is within near + slack of S over core()
        ends,  // what is near is over reach(), but over no range of S
        open,
    };
    Verdict look(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double slack);

    // After open: whether C is long in comparison with S, by how far p runs.
    [[nodiscard]] bool is_long() const noexcept { return is_long_; }

    // Ranges on C: where p is on S, and where something may be near.
    [[nodiscard]] Interval core() const noexcept { return core_; }
    [[nodiscard]] Interval reach() const noexcept { return reach_; }
    // The lines on S at which the core begins and ends: 2 axis, plus 1 for the upper one; -1: none.
    [[nodiscard]] int line_at(bool last) const noexcept { return lines_[last ? 1 : 0]; }
    // A box in [0, 1]^2 of all places on S that may be near; and p(t).
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
    Box<2> region_{}; // a box of places on S around [0, 1]^2 and p
    pieces::BezierPiece extended_;
    std::optional<PatchSlopes> extended_slopes_;
    SlopedPatch over_region_{};
    Chart chart_; // of S over the region
    std::array<double, 3> normal_{};
    bool is_long_ = false;
    double largest_ = 0;      // bound on the differences
    double tangential_ = 0;   // the same for M times a difference
    Interval along_normal_{}; // range of normal . difference
    double off_ = 0;          // how far near places may be from p, as a share of the region
    Place<2> rooms_{};        // the same along both axes of S
    Interval core_{}, reach_{};
    std::array<int, 2> lines_{};
    Box<2> room_{};
};

} // namespace nrb::intersect
