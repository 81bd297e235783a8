// SPDX-License-Identifier: MIT
// Decides what two curve pieces have near each other, if that is possible without halving them.
#pragma once

#include "closest/pair/pair_bound.h"
#include "intersect/pairs/beside.h"
#include "intersect/pairs/chart.h"
#include "intersect/pairs/matched_distance.h"
#include "intersect/pairs/near_cells.h"
#include "intersect/pairs/piece_point.h"

namespace nrb::intersect {

// Places are near if they are within `near` of each other; `noise` is the uncertainty of a distance due to
// rounding. Cells may hold places that are farther apart, by up to slack(), because lower bounds are no
// sharper.
class Judge {
public:
    enum class Verdict {
        nothing, // nothing is near
        cell,    // all near places are in cell()
        open,
    };
    Verdict look(const pieces::SlopedPiece &a, const pieces::SlopedPiece &b, double near, double noise);

    // For pieces that are not halved any more: nothing, or a cell.
    Verdict look_at_tiny(const pieces::SlopedPiece &a, const pieces::SlopedPiece &b, double near,
                         double noise);

    // In the unit of the pieces; its segments and owners are not set.
    [[nodiscard]] const NearCell &cell() const noexcept { return cell_; }
    static double slack(double near, double noise) noexcept { return near / 64 + noise; }

private:
    void set(const pieces::SlopedPiece &a, const pieces::SlopedPiece &b, double near, double noise);
    Verdict by_chart();
    Verdict by_tangents();
    Verdict at_ends(const Beside::Places &room);
    Verdict side_by_side(const Beside::Places &room);
    void descend_from(const Beside::Places &room);
    [[nodiscard]] bool is_apart();
    [[nodiscard]] bool separated() const noexcept;
    [[nodiscard]] bool separated_by(const double *normal, double length) const noexcept;
    void approach();
    [[nodiscard]] Place<2> newton_step() const noexcept;
    void descend();
    void set_cell(NearCell::Kind kind, Interval a, Interval b);
    void set_core(Interval a, Interval b);
    [[nodiscard]] const pieces::BezierPiece &piece_a() const noexcept { return *a_.piece; }
    [[nodiscard]] const pieces::BezierPiece &piece_b() const noexcept { return *b_.piece; }

    pieces::SlopedPiece a_{}, b_{};
    int dim_ = 0;
    double near_ = 0, noise_ = 0;
    bool compared_ = false; // matched_ belongs to these pieces
    NearCell cell_{};
    closest::PairPlace place_; // the nearest places found
    std::vector<double> difference_;
    Chart chart_;
    Beside beside_;
    PiecePoint point_a_, point_b_;
    closest::PairDescent descent_;
    closest::PairBound bound_;
    MatchedDistance matched_;
};

} // namespace nrb::intersect
