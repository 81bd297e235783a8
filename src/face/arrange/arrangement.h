// SPDX-License-Identifier: MIT
// The parts into which curves divide a domain.
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
    int32_t owner = 0; // values are counted for each owner by itself; negative: of curves that do not count
    bool in_a_point = false; // of space: it is none of the curves that go out
};

// An edge one way or the other.
struct DirectedEdge {
    size_t edge;
    bool back = false;
    friend auto operator<=>(const DirectedEdge &, const DirectedEdge &) = default;
};

// Nodes and edges between them, which meet nowhere else, to what is near; edges that run along each other are one. The value of
// an owner at a place is how often its loops go around it; to the left of an edge it differs from that to the right by as
// many curves of the owner as run that way, less those that run the other way. Where the domain closes up it is cut open along
// seams that are put where nothing else happens.
class Arrangement {
public:
    // Distances of at most the tolerance in space are none, but those that rounding leaves in any case. Throws Status::not_converged where rounding would have to decide what meets.
    Arrangement(const Covering &covering, std::span<const ArrangedLoop> loops, double tolerance);
    Arrangement(const Arrangement &) = delete;
    Arrangement &operator=(const Arrangement &) = delete;

    struct Member {
        size_t cut; // of the edges of the cuts
        bool against;
    };
    struct Edge {
        size_t from, to;             // nodes
        std::vector<Member> members; // the first one has the direction of the edge
        PassedSums steps;            // by owners: the value to the left less that to the right
        std::array<int, 2> turns{};  // how many copies of the domain farther than its node it ends
        bool in_a_point = false;     // of space
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
    [[nodiscard]] const ArrangedLoop &loop(const CutEdge &cut) const noexcept {
        return loops_[origin(cut).loop];
    }

    // The copy of a node nearest to a place: bit for bit an end of the domain where it is one.
    [[nodiscard]] Point2 node_near(size_t node, const Point2 &x) const noexcept;
    // The domain, cut open where it closes up.
    [[nodiscard]] const Covering &covering() const noexcept { return covering_; }
    [[nodiscard]] bool closes() const noexcept { return covering_.closed(0) || covering_.closed(1); }
    // Of edges with the seam of axis k, sorted along it.
    [[nodiscard]] const std::vector<SeamContact> &contacts(int k) const noexcept {
        return contacts_[static_cast<size_t>(k)];
    }

    // Pieces in the domain by edges, their numbers as loops.
    [[nodiscard]] const PieceColumns &columns() const noexcept { return *columns_; }
    [[nodiscard]] std::span<const TrimPiece> pieces(size_t edge) const noexcept {
        return std::span(columns_->pieces().all())
            .subspan(first_pieces_[edge], first_pieces_[edge + 1] - first_pieces_[edge]);
    }
    // All pieces in the plane that covers the domain, and those of an edge: it begins at its node, and may end in another copy.
    [[nodiscard]] const TrimPieces &plane() const noexcept { return plane_ ? *plane_ : columns_->pieces(); }
    [[nodiscard]] std::span<const TrimPiece> plane_pieces(size_t edge) const noexcept {
        return std::span(plane().all())
            .subspan(first_plane_[edge], first_plane_[edge + 1] - first_plane_[edge]);
    }
    // By which an edge that goes out from a place so many turns away from its first node is moved, and where that leaves it.
    [[nodiscard]] Point2 move_of(const std::array<int, 2> &turns) const noexcept {
        return {turns[0] * covering_.period(0), turns[1] * covering_.period(1)};
    }
    // In units of about a period.
    [[nodiscard]] double near() const noexcept { return near_; }
    // In those of the domain: how far from each other rounding alone sets places that are one.
    [[nodiscard]] double rounding() const noexcept;

private:
    // Loops of the smooth parts of the curves, which fills the origins of these.
    std::vector<ClosedLoop> smooth_parts();
    void set_edges();
    void add_steps(Edge &edge) const;
    [[nodiscard]] PlacedCurve placed_part(const CutEdge &cut, Edge &edge) const;
    TrimPieces plane_pieces();
    void set_pieces();
    void set_folded(TrimPieces plane);

    Covering given_;    // as the surface has it
    Covering covering_; // cut open
    std::vector<ArrangedLoop> loops_;
    std::vector<Origin> origins_;     // of the curves of the hits
    std::vector<PlacedCurve> smooth_; // these themselves
    double near_;
    LoopHits hits_;
    Cuts cuts_;
    std::vector<Edge> edges_;
    std::vector<size_t> first_pieces_, first_plane_;
    std::optional<TrimPieces> plane_; // where that is not the same as the domain
    std::optional<PieceColumns> columns_;
    std::array<std::vector<SeamContact>, 2> contacts_;
};

// Throws Status::weight_sign for a weight that is not positive, gap for a curve that jumps.
void check_border_curves(std::span<const SplinePtr> curves);

// Where curves come so near each other that it is not decided whether they meet.
[[noreturn]] void fail_undecided(const Point2 &x);

} // namespace nrb::face
