// SPDX-License-Identifier: MIT
#include "face/arrange/node_order.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::face {

namespace {

// The piece by which an edge that leaves the node is compared with others.
struct Lead {
    DirectedEdge edge;
    size_t piece; // index into the set of pieces that are compared
    int sector;   // of eight: even ones are the directions of the axes, odd ones the quadrants between
};

int sign(double x) noexcept {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// Counterclockwise from 0, the direction of axis 0. A step that only rounding sets off an axis is on it.
int sector_of(const Point2 &step, const Point2 &room) noexcept {
    constexpr std::array<std::array<int, 3>, 3> sectors{{{5, 4, 3}, {6, 0, 2}, {7, 0, 1}}};
    const bool upright = std::abs(step[0]) <= room[0] && std::abs(step[1]) > room[1],
               level = std::abs(step[1]) <= room[1] && std::abs(step[0]) > room[0];
    const int u = upright ? 0 : sign(step[0]), v = level ? 0 : sign(step[1]);
    return sectors[static_cast<size_t>(u + 1)][static_cast<size_t>(v + 1)];
}

class Leads {
public:
    explicit Leads(const Arrangement &arrangement) : arrangement_(arrangement) {
        for (size_t k = 0; k < 2; ++k) {
            room_[k] = 4 * arrangement.columns().room()[k];
        }
    }

    // The first piece whose far end is farther from the node than far_enough times the distance that counts
    // as none; else the piece with the farthest end.
    [[nodiscard]] Lead lead(DirectedEdge edge) {
        const auto pieces = arrangement_.plane_pieces(edge.edge);
        const Point2 &node = edge.back ? pieces.back().end : pieces.front().start;
        constexpr double far_enough = 4;
        Lead best{edge, 0, 0};
        const TrimPiece *found = edge.back ? &pieces.back() : &pieces.front();
        double farthest = -1;
        for (size_t i = 0; i < pieces.size(); ++i) {
            const TrimPiece &piece = pieces[edge.back ? pieces.size() - 1 - i : i];
            const Point2 near = edge.back ? piece.end : piece.start,
                         far = edge.back ? piece.start : piece.end;
            const double away = arrangement_.hits().distance(node, far);
            if (away > farthest) {
                found = &piece;
                best.sector = sector_of({far[0] - near[0], far[1] - near[1]}, room_);
                farthest = away;
            }
            if (away > far_enough * arrangement_.near()) {
                break;
            }
        }
        best.piece = compared(*found, edge);
        return best;
    }
    // 1 if b is above a, -1 if it is below, 0 if rounding hides which.
    [[nodiscard]] int order(const Lead &a, const Lead &b) const noexcept {
        const TrimPieces &set = arrangement_.closes() ? moved_ : arrangement_.plane();
        return set.order(set.all()[a.piece], set.all()[b.piece]);
    }

private:
    // The index of a piece in the set of pieces that are compared. An edge run over backwards may leave from
    // another copy of the node; its piece is moved to that of the others.
    size_t compared(const TrimPiece &piece, DirectedEdge edge) {
        const TrimPieces &plane = arrangement_.plane();
        if (!arrangement_.closes()) {
            return static_cast<size_t>(&piece - plane.all().data());
        }
        const Point2 by = arrangement_.move_of(arrangement_.edges()[edge.edge].turns),
                     move = edge.back ? Point2{-by[0], -by[1]} : Point2{0, 0};
        moved_.add_part(plane, piece, {0, 1}, moved(piece.start, move), moved(piece.end, move), move);
        return moved_.all().size() - 1;
    }

    const Arrangement &arrangement_;
    Point2 room_{};
    TrimPieces moved_;
};

} // namespace

void sort_around_node(const Arrangement &arrangement, std::vector<DirectedEdge> &edges) {
    Leads leads(arrangement);
    std::vector<Lead> sorted;
    bool undecided = false;
    // Insertion sort: it compares each pair at most once, so that inconsistent comparisons do no harm.
    const auto before = [&](const Lead &a, const Lead &b) {
        if (a.sector != b.sector) {
            return a.sector < b.sector;
        }
        const int above = a.sector % 2 == 0 ? 0 : leads.order(a, b);
        undecided = undecided || above == 0;
        return (a.sector == 1 || a.sector == 7) == (above > 0) && above != 0;
    };
    for (const DirectedEdge edge : edges) {
        const Lead own = leads.lead(edge);
        auto at = sorted.begin();
        while (at != sorted.end() && before(*at, own)) {
            ++at;
        }
        sorted.insert(at, own);
    }
    if (undecided) {
        fail_undecided(arrangement.nodes()[arrangement.from(edges.front())]);
    }
    std::ranges::transform(sorted, edges.begin(), [](const Lead &lead) { return lead.edge; });
}

} // namespace nrb::face
