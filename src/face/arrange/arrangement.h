// SPDX-License-Identifier: MIT
// The arrangement of curves in the domain of a surface: a planar graph, from which the parts that the curves
// divide the domain into are read.
#pragma once

#include "face/arrange/cuts.h"
#include "face/arrange/seams.h"
#include "face/trims/piece_columns.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace nrb::face {

struct ArrangedLoop {
    PlacedLoop placed;
    int32_t owner = 0;       // values are counted separately for each owner; negative: not counted at all
    bool in_a_point = false; // its image is a single point of space: results have no curve there
};

// A half-edge: an edge run over forwards, or backwards.
struct DirectedEdge {
    size_t edge;
    bool back = false;
    friend auto operator<=>(const DirectedEdge &, const DirectedEdge &) = default;
};

// Nodes, and edges that meet only at nodes. Distances up to near() count as none; curves that run along each
// other within that are the members of one edge. The value of an owner at a place of the domain is the
// winding number of its loops around the place. The value to the left of an edge minus the value to its
// right, the step, is the number of members of the owner that run with the edge minus the number of those
// that run against it. A domain that closes up is cut open along seams between the nodes (seams.h).
class Arrangement {
public:
    // The tolerance is a distance in space. The distance in the domain that counts as none is the same share
    // of about a period as the tolerance is of the extent of the surface, but no less than what rounding
    // leaves in any case. Throws Status::not_converged where rounding would have to decide what meets.
    Arrangement(const Covering &covering, std::span<const ArrangedLoop> loops, double tolerance);
    Arrangement(const Arrangement &) = delete;
    Arrangement &operator=(const Arrangement &) = delete;

    struct Member {
        size_t cut; // index into the edges of cuts()
        bool against;
    };
    struct Edge {
        size_t from, to;             // nodes
        std::vector<Member> members; // the first one has the direction of the edge
        PassedSums steps;            // by owners: the value to the left minus the value to the right
        std::array<int, 2> turns{};  // it ends in the copy of the domain so many periods beyond `to`
        bool in_a_point = false;     // its image is a single point of space
    };
    [[nodiscard]] const std::vector<Edge> &edges() const noexcept { return edges_; }
    [[nodiscard]] const std::vector<Point2> &nodes() const noexcept { return cuts_.nodes(); }
    [[nodiscard]] const Cuts &cuts() const noexcept { return cuts_; }
    [[nodiscard]] const LoopHits &hits() const noexcept { return hits_; }
    [[nodiscard]] size_t from(DirectedEdge edge) const noexcept {
        return edge.back ? edges_[edge.edge].to : edges_[edge.edge].from;
    }
    [[nodiscard]] size_t to(DirectedEdge edge) const noexcept { return from({edge.edge, !edge.back}); }
    // The given curve of which an edge of the cuts is a part, over the same parameters.
    [[nodiscard]] const PlacedCurve &curve(const CutEdge &cut) const noexcept {
        const Origin &own = origins_[cut.curve];
        return loops_[own.loop].placed.curves[own.index];
    }
    // The loop of that curve, and its index there.
    struct Origin {
        size_t loop, index;
        friend bool operator==(const Origin &, const Origin &) = default;
    };
    [[nodiscard]] const Origin &origin(const CutEdge &cut) const noexcept { return origins_[cut.curve]; }
    [[nodiscard]] const ArrangedLoop &loop(const CutEdge &cut) const noexcept {
        return loops_[origin(cut).loop];
    }

    // The copy of a node nearest to a place. Coordinates on closed axes that are at an end of the domain to
    // rounding are at that end bit for bit.
    [[nodiscard]] Point2 node_near(size_t node, const Point2 &x) const noexcept;
    // The covering with its domain cut open along the seams.
    [[nodiscard]] const Covering &covering() const noexcept { return covering_; }
    [[nodiscard]] bool closes() const noexcept { return covering_.closed(0) || covering_.closed(1); }
    // Where edges cross the seam of axis k, sorted along it.
    [[nodiscard]] const std::vector<SeamContact> &contacts(int k) const noexcept {
        return contacts_[static_cast<size_t>(k)];
    }

    // The pieces of all edges in the domain. The number of an edge is the `loop` of its pieces.
    [[nodiscard]] const PieceColumns &columns() const noexcept { return *columns_; }
    [[nodiscard]] std::span<const TrimPiece> pieces(size_t edge) const noexcept {
        return std::span(columns_->pieces().all())
            .subspan(first_pieces_[edge], first_pieces_[edge + 1] - first_pieces_[edge]);
    }
    // All pieces in the plane that covers the domain, and those of one edge, which begins at its node and may
    // end in another copy of the domain.
    [[nodiscard]] const TrimPieces &plane() const noexcept { return plane_ ? *plane_ : columns_->pieces(); }
    [[nodiscard]] std::span<const TrimPiece> plane_pieces(size_t edge) const noexcept {
        return std::span(plane().all())
            .subspan(first_plane_[edge], first_plane_[edge + 1] - first_plane_[edge]);
    }
    // The translation by so many periods, which moves an edge to the copy that begins so many turns away.
    [[nodiscard]] Point2 move_of(const std::array<int, 2> &turns) const noexcept {
        return {turns[0] * covering_.period(0), turns[1] * covering_.period(1)};
    }
    // The distance that counts as none, in units of about a period.
    [[nodiscard]] double near() const noexcept { return near_; }
    // Whether rounding alone may have set two places of the plane apart that are one.
    [[nodiscard]] bool is_rounding(const Point2 &x, const Point2 &y) const noexcept;

private:
    // The loops with their curves cut into smooth parts. Fills origins_ and smooth_.
    std::vector<ClosedLoop> smooth_parts();
    void set_edges();
    void add_steps(Edge &edge) const;
    [[nodiscard]] PlacedCurve placed_part(const CutEdge &cut, Edge &edge) const;
    TrimPieces plane_pieces();
    void set_pieces();
    void set_folded(TrimPieces plane);

    Covering given_;    // of the surface as it is
    Covering covering_; // cut open along the seams
    std::vector<ArrangedLoop> loops_;
    std::vector<Origin> origins_;     // of the curves of hits_
    std::vector<PlacedCurve> smooth_; // these curves, not scaled
    double near_;
    LoopHits hits_;
    Cuts cuts_;
    std::vector<Edge> edges_;
    std::vector<size_t> first_pieces_, first_plane_;
    std::optional<TrimPieces> plane_; // only for a domain that closes up
    std::optional<PieceColumns> columns_;
    std::array<std::vector<SeamContact>, 2> contacts_;
};

// Throws Status::weight_sign for a curve with a weight that is not positive, gap for one that jumps.
void check_border_curves(std::span<const SplinePtr> curves);

// Throws Status::not_converged: at x curves come so near each other that it is undecided whether they meet.
[[noreturn]] void fail_undecided(const Point2 &x);

} // namespace nrb::face
