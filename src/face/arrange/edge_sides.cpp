// SPDX-License-Identifier: MIT
#include "face/arrange/edge_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace nrb::face {

namespace {

// How many places of an edge are tried before it counts as hidden by others.
constexpr int most_probes = 16;

void add_steps(const Arrangement &arrangement, PassedSums &sums, size_t edge, int times) {
    for (const PassedSum &step : arrangement.edges()[edge].steps) {
        const auto own = std::ranges::find(sums, step.loop, &PassedSum::loop); // owners are few
        if (own == sums.end()) {
            sums.push_back({step.loop, step.value * times});
        } else {
            own->value += step.value * times;
        }
    }
}

PassedSums without_zeros(PassedSums sums) {
    PassedSums result = summed(std::move(sums));
    std::erase_if(result, [](const PassedSum &sum) { return sum.value == 0; });
    return result;
}

// Finds the values on both sides of one edge.
class Beside {
public:
    Beside(const Arrangement &arrangement, const PassedSums &at_corner, size_t edge)
        : arrangement_(arrangement), at_corner_(at_corner), edge_(edge) {}

    [[nodiscard]] std::optional<SideValues> find() const {
        const std::vector<const TrimPiece *> own = largest_first();
        for (int probe = 0; probe < most_probes; ++probe) {
            const TrimPiece &piece = *own[static_cast<size_t>(probe) % own.size()];
            const double share = (probe + 1) * 0.381966 - std::floor((probe + 1) * 0.381966);
            if (auto found = is_upright(piece) ? beside_upright(piece, share) : beside(piece, share)) {
                return found;
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] const PieceColumns &columns() const noexcept { return arrangement_.columns(); }
    [[nodiscard]] double room(size_t k) const noexcept { return 4 * columns().room()[k]; }
    [[nodiscard]] bool is_upright(const TrimPiece &piece) const noexcept {
        return piece.upper[0] - piece.lower[0] <= room(0);
    }
    [[nodiscard]] std::vector<const TrimPiece *> largest_first() const {
        std::vector<const TrimPiece *> own;
        for (const TrimPiece &piece : arrangement_.pieces(edge_)) {
            own.push_back(&piece);
        }
        const auto size = [&](const TrimPiece *piece) {
            return arrangement_.hits().distance(piece->start, piece->end);
        };
        std::ranges::stable_sort(own, std::ranges::greater{}, size);
        return own;
    }
    // The values at a place as if the piece `except` were not there; none if the place is on another piece.
    [[nodiscard]] std::optional<PassedSums> values(const Point2 &x, const TrimPiece &except) const {
        PassedSums sums = at_corner_;
        const auto number = static_cast<size_t>(&except - columns().pieces().all().data());
        const bool on = columns().walk(x, number, [&](int32_t edge, int passed) {
            add_steps(arrangement_, sums, static_cast<size_t>(edge), passed);
        });
        return on ? std::nullopt : std::optional(without_zeros(std::move(sums)));
    }
    // The values after a step over the edge: from its right to its left for times = 1, back for -1.
    [[nodiscard]] PassedSums stepped(PassedSums from, int times) const {
        add_steps(arrangement_, from, edge_, times);
        return without_zeros(std::move(from));
    }
    [[nodiscard]] SideValues sides_of(const PassedSums &found, bool is_left) const {
        return is_left ? SideValues{found, stepped(found, -1)} : SideValues{stepped(found, 1), found};
    }
    // At a place on the piece, with the piece left out, the values are those above it. The same values at
    // four places around it show that no other piece is as near as rounding may move both.
    [[nodiscard]] std::optional<SideValues> beside(const TrimPiece &piece, double share) const {
        const double u = piece.lower[0] + share * (piece.upper[0] - piece.lower[0]);
        const double v = columns().pieces().point(piece, columns().pieces().place_of(piece, 0, u))[1];
        const Point2 x{u, std::clamp(v, piece.lower[1], piece.upper[1])};
        const auto found = values(x, piece);
        constexpr std::array<Point2, 4> around{{{0, -1}, {0, 1}, {-1, 0}, {1, 0}}};
        const bool alone =
            found && std::ranges::all_of(around, [&](const Point2 &step) {
                return values({x[0] + step[0] * room(0), x[1] + step[1] * room(1)}, piece) == found;
            });
        return alone ? std::optional(sides_of(*found, piece.start[0] < piece.end[0])) : std::nullopt;
    }
    // At places to the right of an upright piece and to its left, which have to differ by its step alone.
    [[nodiscard]] std::optional<SideValues> beside_upright(const TrimPiece &piece, double share) const {
        const double v = piece.lower[1] + share * (piece.upper[1] - piece.lower[1]);
        const bool up = piece.start[1] < piece.end[1];
        const auto found = values({piece.upper[0] + room(0), v}, piece),
                   other = values({piece.lower[0] - room(0), v}, piece);
        const bool alone = found && other && *other == stepped(*found, up ? 1 : -1);
        return alone ? std::optional(sides_of(*found, !up)) : std::nullopt;
    }

    const Arrangement &arrangement_;
    const PassedSums &at_corner_;
    size_t edge_;
};

// Passes values on along chains of edges, as long as no other edge comes to the node between two of them: a
// loop along the first edge continues along the second in the same direction, and curves that do not count
// have the same values on both sides.
class EdgeChains {
public:
    EdgeChains(const Arrangement &arrangement, const PassedSums &at_corner)
        : arrangement_(arrangement), at_corner_(at_corner), outs_(arrangement.nodes().size()),
          known_(arrangement.edges().size()) {
        for (size_t i = 0; i < arrangement.edges().size(); ++i) {
            for (const DirectedEdge edge : {DirectedEdge{i, false}, DirectedEdge{i, true}}) {
                outs_[arrangement.from(edge)].push_back(edge);
            }
        }
    }

    [[nodiscard]] std::vector<SideValues> all() {
        for (size_t i = 0; i < known_.size(); ++i) {
            if (!known_[i]) {
                known_[i] = Beside(arrangement_, at_corner_, i).find();
                if (!known_[i]) {
                    fail_undecided(arrangement_.nodes()[arrangement_.edges()[i].from]);
                }
                go_on({i, false});
                go_on({i, true});
            }
        }
        std::vector<SideValues> result;
        for (std::optional<SideValues> &values : known_) {
            result.push_back(*std::move(values));
        }
        return result;
    }

private:
    void go_on(DirectedEdge edge) {
        for (;;) {
            const std::vector<DirectedEdge> &outs = outs_[arrangement_.to(edge)];
            if (outs.size() != 2) {
                return;
            }
            const DirectedEdge next = outs[outs[0] == DirectedEdge{edge.edge, !edge.back} ? 1 : 0];
            if (known_[next.edge]) {
                return;
            }
            known_[next.edge] = known_[edge.edge];
            if (next.back != edge.back) { // one of the edges runs against the other
                std::swap(known_[next.edge]->left, known_[next.edge]->right);
            }
            edge = next;
        }
    }

    const Arrangement &arrangement_;
    const PassedSums &at_corner_;
    std::vector<std::vector<DirectedEdge>> outs_; // half-edges that leave each node
    std::vector<std::optional<SideValues>> known_;
};

} // namespace

std::vector<SideValues> values_beside(const Arrangement &arrangement, const PassedSums &at_corner) {
    return EdgeChains(arrangement, at_corner).all();
}

PassedSums values_at_top(const Arrangement &arrangement, const PassedSums &at_corner, double u) {
    PassedSums sums = at_corner;
    for (const SeamPassage &passage : arrangement.columns().passages()) {
        if (passage.at > u) {
            add_steps(arrangement, sums, static_cast<size_t>(passage.loop), passage.upwards);
        }
    }
    return without_zeros(std::move(sums));
}

} // namespace nrb::face
