// SPDX-License-Identifier: MIT
// Decides what a curve piece and a surface piece have near each other, if that is possible without halving
// them.
#pragma once

#include "closest/pair/pair_bound.h"
#include "intersect/curve_surface/alongside.h"
#include "intersect/curve_surface/meet_cell.h"

namespace nrb::intersect {

// Places are near if they are within `near` of each other; `noise` is the uncertainty of a distance due to
// rounding. Cells may hold places that are farther apart, by up to slack(), because lower bounds are no
// sharper.
class MeetJudge {
public:
    enum class Verdict {
        nothing, // nothing is near
        cell,    // all near places are in cell()
        open,
    };
    Verdict look(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double noise);

    // For pieces that are not halved any more: nothing, or a cell.
    Verdict look_at_tiny(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double noise);

    // After open: whether the curve is too long in comparison with the surface beside it.
    [[nodiscard]] bool curve_is_long() const noexcept { return curve_is_long_; }

    // After open: whether M exists in the middle, and which of both is more in the way of a proof.
    [[nodiscard]] bool has_chart() const noexcept { return chart_.turn() != 0; }
    [[nodiscard]] bool curve_bends_more() const noexcept { return chart_.curve_bends_more(); }

    // In the unit of the pieces; its segments and owners are not set.
    [[nodiscard]] const MeetCell &cell() const noexcept { return cell_; }
    static double slack(double near, double noise) noexcept { return near / 64 + noise; }

private:
    void set(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double noise);
    Verdict by_chart();
    Verdict by_tangents();
    Verdict at_ends(const MeetBox &room);
    Verdict along();
    void approach();
    void descend();
    void descend_from(const MeetBox &room);
    [[nodiscard]] bool is_apart();
    [[nodiscard]] bool separated() const noexcept;
    [[nodiscard]] bool separated_by(const double *normal, double length) const noexcept;
    [[nodiscard]] MeetPlace place() const noexcept { return {place_.a[0], place_.b[0], place_.b[1]}; }
    void set_place(const MeetPlace &z) noexcept;
    [[nodiscard]] MeetBox parameters(const MeetBox &places) const noexcept;
    // The line with a number as in Alongside::line_at().
    [[nodiscard]] MeetCell::Line line(int number) const noexcept;
    void set_cell(MeetCell::Kind kind, const MeetBox &box);
    [[nodiscard]] const pieces::BezierPiece &curve() const noexcept { return *arc_.piece; }
    [[nodiscard]] const pieces::BezierPiece &surface() const noexcept { return *patch_.piece; }

    pieces::SlopedPiece arc_{};
    SlopedPatch patch_{};
    double near_ = 0, noise_ = 0;
    bool curve_is_long_ = false;
    MeetCell cell_{};
    closest::PairPlace place_; // the nearest places found
    std::array<double, 3> difference_{};
    SpaceChart chart_;
    Alongside alongside_;
    PiecePoint arc_point_;
    PatchPoint patch_point_;
    closest::PairDescent descent_;
    closest::PairBound bound_;
};

} // namespace nrb::intersect
