// SPDX-License-Identifier: MIT
// The parts into which curves divide a domain.
#pragma once

#include "face/arrange/cuts.h"
#include "face/trims/piece_columns.h"

#include <optional>
#include <span>
#include <vector>

namespace nrb::face {

struct ArrangedLoop {
    PlacedLoop placed;
    int32_t owner = 0; // values are counted for each owner by itself; negative: of curves that do not count
};

// An edge one way or the other.
struct DirectedEdge {
    size_t edge;
    bool back = false;
    friend auto operator<=>(const DirectedEdge &, const DirectedEdge &) = default;
};

// Nodes and edges between them, which meet nowhere else, to what is near; edges that run along each other are one. The value of
// an owner at a place is how often its loops go around it; to the left of an edge it differs from that to the right by as
// many curves of the owner as run that way, less those that run the other way.
class Arrangement {
public:
    // Distances of at most the tolerance in space are none, but those that rounding leaves in any case. Precondition: no axis
    // is closed. Throws Status::not_converged where rounding would have to decide what meets.
    Arrangement(const Covering &covering, std::span<const ArrangedLoop> loops, double tolerance);

    struct Member {
        size_t cut; // of the edges of the cuts
        bool against;
    };
    struct Edge {
        size_t from, to;             // nodes
        std::vector<Member> members; // the first one has the direction of the edge
        PassedSums steps;            // by owners: the value to the left less that to the right
    };
    [[nodiscard]] const std::vector<Edge> &edges() const noexcept { return edges_; }
    [[nodiscard]] const std::vector<Point2> &nodes() const noexcept { return cuts_.nodes(); }
    [[nodiscard]] const Cuts &cuts() const noexcept { return cuts_; }
    [[nodiscard]] const LoopHits &hits() const noexcept { return hits_; }
    [[nodiscard]] size_t from(DirectedEdge edge) const noexcept {
        return edge.back ? edges_[edge.edge].to : edges_[edge.edge].from;
    }
    [[nodiscard]] size_t to(DirectedEdge edge) const noexcept { return from({edge.edge, !edge.back}); }
    // The stored curve that an edge of the cuts is a part of, over the same parameters.
    [[nodiscard]] const PlacedCurve &curve(const CutEdge &cut) const noexcept {
        const Origin &own = origins_[cut.curve];
        return loops_[own.loop].placed.curves[own.index];
    }
    // Which curve of which loop that is.
    struct Origin {
        size_t loop, index;
        friend bool operator==(const Origin &, const Origin &) = default;
    };
    [[nodiscard]] const Origin &origin(const CutEdge &cut) const noexcept { return origins_[cut.curve]; }

    // Pieces by edges, their numbers as loops.
    [[nodiscard]] const PieceColumns &columns() const noexcept { return *columns_; }
    [[nodiscard]] std::span<const TrimPiece> pieces(size_t edge) const noexcept {
        return std::span(columns_->pieces().all())
            .subspan(first_pieces_[edge], first_pieces_[edge + 1] - first_pieces_[edge]);
    }
    // In units of about a period.
    [[nodiscard]] double near() const noexcept { return near_; }
    // In those of the domain: how far from each other rounding alone sets places that are one.
    [[nodiscard]] double rounding() const noexcept;
    [[noreturn]] void fail_undecided(const Point2 &x) const;

private:
    // Loops of the smooth parts of the curves, which fills the origins of these.
    std::vector<ClosedLoop> smooth_parts();
    void set_edges();
    void add_steps(Edge &edge) const;
    void set_pieces(const Covering &covering);

    std::vector<ArrangedLoop> loops_;
    std::vector<Origin> origins_;     // of the curves of the hits
    std::vector<PlacedCurve> smooth_; // these themselves
    double near_;
    LoopHits hits_;
    Cuts cuts_;
    std::vector<Edge> edges_;
    std::vector<size_t> first_pieces_;
    std::optional<PieceColumns> columns_;
};

// Throws Status::weight_sign for a weight that is not positive, gap for a curve that jumps.
void check_border_curves(std::span<const SplinePtr> curves);

// Throws Status::incompatible if an axis is closed.
void check_open(const Covering &covering);

} // namespace nrb::face
