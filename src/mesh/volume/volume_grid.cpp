// SPDX-License-Identifier: MIT
#include "mesh/volume/volume_grid.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::mesh {

namespace {

using Counts = std::array<std::vector<int64_t>, max_axes>; // numbers of cells between breaks, by axis
using pieces::BernsteinNet;

// Blocks are spans, or parts of spans that need many cells: second derivatives vary less over a part.
constexpr int64_t cells_of_part = 4, most_parts = 16;
constexpr int64_t usual_blocks = 8192; // unless there are more spans
constexpr int rounds = 3;
// More cells along a block are more than doubles can separate or memory can hold.
constexpr double most_cells_of_block = 0x1p30;

// The number of cells that a block needs so that a term proportional to its inverse square is at most
// `share`.
double cells_for(double term, double share) noexcept {
    return std::clamp(std::ceil(std::sqrt(term / share) * (1 + 8 * eps)), 1.0, most_cells_of_block);
}

int64_t cells_of(const VolumeGrid &grid) noexcept {
    int64_t cells = 1;
    for (const std::vector<double> &lines : grid.lines) {
        cells *= std::ssize(lines) - 1;
    }
    return cells;
}

// A grid over parts is not always better than one over whole blocks, since each part has a whole number of
// cells.
bool better(const VolumeGrid &a, const VolumeGrid &b) noexcept {
    if (a.reached != b.reached) {
        return a.reached;
    }
    return a.reached ? cells_of(a) < cells_of(b) : a.bound < b.bound;
}

class GridPlan {
public:
    GridPlan(const Spline &volume, const MeshRule &rule, int64_t most)
        : volume_(volume), frame_(pieces::frame_of(volume)), chord_(frame_.scaled(rule.chord)),
          longest_(rule.longest > 0 ? frame_.scaled(rule.longest) : infinity), most_(most) {
        for (int k = 0; k < max_axes; ++k) {
            breaks_[static_cast<size_t>(k)] = refine::breaks_of(volume.axis(k));
        }
    }

    VolumeGrid grid() {
        VolumeGrid best = attempt();
        for (int round = 1; round < rounds && divide(); ++round) {
            const Phase phase;
            VolumeGrid next = attempt();
            if (better(next, best)) {
                best = std::move(next);
            }
        }
        return best;
    }

private:
    [[nodiscard]] int64_t blocks(size_t k) const noexcept { return std::ssize(breaks_[k]) - 1; }
    [[nodiscard]] int64_t blocks() const noexcept { return blocks(0) * blocks(1) * blocks(2); }
    // Calls body(bend, indices of the block along the axes).
    template <class Body>
    void for_each_block(Body &&body) const;
    // Allows for rounding everywhere, and once more where points that differ only by rounding become one.
    [[nodiscard]] double noise(double moved) const noexcept { return moved + 2 * rounding_; }

    VolumeGrid attempt() {
        look();
        counts_ = counts_within_limit();
        return result();
    }
    void look();
    [[nodiscard]] double roundings() const noexcept;
    void set_rounding(const pieces::BezierNet &net) noexcept;
    [[nodiscard]] Counts one_each() const;
    [[nodiscard]] Counts counts(double scale) const;
    void raise(const PieceBend &bend, const std::array<size_t, max_axes> &at, double scale,
               Counts &counts) const;
    [[nodiscard]] Counts lowered(const Counts &counts, double scale) const;
    [[nodiscard]] bool fits(const Counts &counts) const noexcept;
    [[nodiscard]] Counts counts_within_limit() const;
    bool divide();
    [[nodiscard]] std::vector<double> lines(size_t k, std::vector<double> &shares) const;
    [[nodiscard]] VolumeGrid result() const;

    const Spline &volume_;
    pieces::Frame frame_;
    double chord_, longest_;
    int64_t most_;
    BernsteinNet::Breaks breaks_;
    std::vector<PieceBend> bends_; // of the blocks, last axis fastest
    double rounding_ = 0;          // error of evaluated points
    Counts counts_;
};

template <class Body>
void GridPlan::for_each_block(Body &&body) const {
    size_t e = 0;
    std::array<size_t, max_axes> at{};
    for (at[0] = 0; std::cmp_less(at[0], blocks(0)); ++at[0]) {
        for (at[1] = 0; std::cmp_less(at[1], blocks(1)); ++at[1]) {
            for (at[2] = 0; std::cmp_less(at[2], blocks(2)); ++at[2]) {
                body(bends_[e++], at);
            }
        }
    }
}

// Evaluation rounds each coordinate 7 p + 2 times for each axis, relative to the largest one; each
// counts 2 eps.
double GridPlan::roundings() const noexcept {
    double sum = 8;
    for (int k = 0; k < max_axes; ++k) {
        sum += 14 * volume_.axis(k).degree() + 4;
    }
    return sum;
}

// With weights of both signs, errors are relative to the largest product of a weight and a point, divided by
// the least weight (see look()).
void GridPlan::set_rounding(const pieces::BezierNet &net) noexcept {
    double largest = 0;
    for (const double x : frame_.centre) {
        largest = std::max(largest, std::abs(x));
    }
    double reach = 0;
    for (const double size : net.positive() ? net.sizes() : net.records().values) {
        reach = std::max(reach, std::abs(size));
    }
    rounding_ = roundings() * eps * (frame_.scaled(largest) + frame_.scaled(reach));
}

void GridPlan::look() {
    pieces::BezierNet net(volume_, frame_, breaks_);
    set_rounding(net);
    bends_.clear();
    Steps steps(net.count());
    double least = infinity, reach = 0;
    for (int64_t e = 0; e < net.count(); ++e, steps.next()) {
        const pieces::BezierPiece piece(net, e, max_axes);
        bends_.push_back(bend_of(piece));
        if (!net.positive() && piece.positive()) {
            for (int64_t i = 0; i < piece.coefficients(); ++i) {
                least = std::min(least, piece.weight(i));
            }
            reach = std::max(reach, piece.reach());
        }
    }
    rounding_ = (rounding_ + roundings() * eps * reach) / std::min(least, 1.0);
}

Counts GridPlan::one_each() const {
    Counts counts;
    for (size_t k = 0; k < counts.size(); ++k) {
        counts[k].assign(static_cast<size_t>(blocks(k)), 1);
    }
    return counts;
}

// The error is a sum of terms T_k / n_k^2 for n_k cells along axis k. For a given sum the product of the n_k
// is about the least if all terms are equal. Axes whose term is smaller with one cell already leave the rest
// of the room to the others.
void GridPlan::raise(const PieceBend &bend, const std::array<size_t, max_axes> &at, double scale,
                     Counts &counts) const {
    const double chord = scale * chord_, slack = noise(bend.moved);
    double room = std::max(chord - slack, std::min(chord, slack));
    std::array<bool, max_axes> open{};
    int axes = 0;
    for (size_t k = 0; k < open.size(); ++k) {
        open[k] = bend.second[k] > 0 && std::isfinite(bend.second[k]) && std::isfinite(chord);
        axes += open[k] ? 1 : 0;
    }
    for (bool again = true; again;) {
        again = false;
        for (size_t k = 0; k < open.size(); ++k) {
            if (open[k] && bend.second[k] / 8 < room / axes) {
                open[k] = false;
                room -= bend.second[k] / 8;
                --axes;
                again = true;
            }
        }
    }
    for (size_t k = 0; k < open.size(); ++k) {
        double cells = open[k] ? cells_for(bend.second[k] / 8, room / axes) : 1;
        if (std::isfinite(bend.first[k]) && std::isfinite(longest_)) {
            cells = std::max(cells, std::clamp(std::ceil(bend.first[k] / (scale * longest_) * (1 + 64 * eps)),
                                               1.0, most_cells_of_block));
        }
        counts[k][at[k]] = std::max(counts[k][at[k]], static_cast<int64_t>(cells));
    }
}

// Lines run through all blocks side by side, so along other axes most blocks have more of them than they
// need. One axis after the other, this finds the least numbers that still suffice.
Counts GridPlan::lowered(const Counts &counts, double scale) const {
    Counts result = counts;
    for (size_t k = 0; k < counts.size(); ++k) {
        std::vector<int64_t> least(counts[k].size(), 1);
        for_each_block([&](const PieceBend &bend, const std::array<size_t, max_axes> &at) {
            double room = scale * chord_ - noise(bend.moved);
            for (size_t l = 0; l < counts.size(); ++l) {
                const double n = static_cast<double>(result[l][at[l]]);
                room -= l == k || !(bend.second[l] > 0) ? 0 : bend.second[l] / (8 * n * n) * (1 + 64 * eps);
            }
            const int64_t own = counts[k][at[k]];
            const bool bends = bend.second[k] > 0 && std::isfinite(bend.second[k]);
            double cells = !bends ? 1 : room > 0 ? cells_for(bend.second[k] / 8, room) : most_cells_of_block;
            if (std::isfinite(bend.first[k]) && std::isfinite(longest_)) {
                cells = std::max(cells, std::ceil(bend.first[k] / (scale * longest_) * (1 + 64 * eps)));
            }
            least[at[k]] = std::max(least[at[k]],
                                    static_cast<int64_t>(std::min<double>(cells, static_cast<double>(own))));
        });
        result[k] = std::move(least);
    }
    return result;
}

// The numbers of cells for limits that are `scale` times those of the rule.
Counts GridPlan::counts(double scale) const {
    Counts result = one_each();
    count_work(32 * blocks());
    for_each_block([&](const PieceBend &bend, const std::array<size_t, max_axes> &at) {
        raise(bend, at, scale, result);
    });
    return lowered(result, scale);
}

bool GridPlan::fits(const Counts &counts) const noexcept {
    double cells = 1;
    for (const std::vector<int64_t> &own : counts) {
        double sum = 0;
        for (const int64_t n : own) {
            sum += static_cast<double>(n);
        }
        cells *= sum;
    }
    return cells <= static_cast<double>(most_);
}

// Doubles the scale until the cells fit, then reduces it by bisection as far as they do.
Counts GridPlan::counts_within_limit() const {
    Counts best = counts(1);
    if (fits(best)) {
        return best;
    }
    double low = 1, high = 2;
    constexpr double no_limit = 0x1p200;
    for (best = counts(high); !fits(best) && high < no_limit; best = counts(high)) {
        low = high;
        high *= 2;
    }
    for (int step = 0; step < 8 && high < no_limit; ++step) {
        const double middle = std::sqrt(low * high);
        Counts found = counts(middle);
        if (fits(found)) {
            best = std::move(found);
            high = middle;
        } else {
            low = middle;
        }
    }
    return fits(best) ? best : one_each();
}

// Divides blocks that have many cells, or no bound on their second derivatives, into parts. Returns whether
// there are any.
bool GridPlan::divide() {
    Counts parts = one_each();
    for_each_block([&](const PieceBend &bend, const std::array<size_t, max_axes> &at) {
        for (size_t k = 0; k < parts.size(); ++k) {
            const int64_t cells = counts_[k][at[k]];
            const int64_t wanted =
                std::isfinite(bend.second[k]) ? (cells + cells_of_part - 1) / cells_of_part : 2;
            parts[k][at[k]] = std::max(parts[k][at[k]], std::min(wanted, most_parts));
        }
    });
    int64_t total = 1, longest = 1;
    for (const std::vector<int64_t> &own : parts) {
        int64_t sum = 0;
        for (const int64_t n : own) {
            sum += n;
            longest = std::max(longest, n);
        }
        total *= sum;
    }
    if (longest == 1 || total > std::max(std::min(usual_blocks, most_), blocks())) {
        return false;
    }
    for (size_t k = 0; k < parts.size(); ++k) {
        counts_[k] = parts[k];
        std::vector<double> shares;
        breaks_[k] = lines(k, shares);
    }
    return true;
}

// The ends of the cells; for each block, `shares` gets the largest share of it that a cell has.
std::vector<double> GridPlan::lines(size_t k, std::vector<double> &shares) const {
    const std::vector<double> &breaks = breaks_[k];
    std::vector<double> result{breaks.front()};
    for (size_t e = 0; e + 1 < breaks.size(); ++e) {
        const double a = breaks[e], b = breaks[e + 1], n = static_cast<double>(counts_[k][e]);
        double longest = 0, last = a;
        const auto add = [&](double t) {
            longest = std::max(longest, (t / 2 - last / 2) / (b / 2 - a / 2));
            last = t;
            result.push_back(t);
        };
        for (int64_t i = 1; i < counts_[k][e]; ++i) {
            const double share = static_cast<double>(i) / n, t = a * (1 - share) + b * share;
            if (t > last && t < b) {
                add(t);
            }
        }
        add(b);
        shares.push_back(std::min(longest * (1 + 8 * eps), 1.0));
    }
    return result;
}

VolumeGrid GridPlan::result() const {
    VolumeGrid grid;
    std::array<std::vector<double>, max_axes> shares;
    for (size_t k = 0; k < shares.size(); ++k) {
        grid.lines[k] = lines(k, shares[k]);
    }
    double bound = 0, length = 0;
    for_each_block([&](const PieceBend &bend, const std::array<size_t, max_axes> &at) {
        std::array<double, max_axes> own{};
        for (size_t k = 0; k < own.size(); ++k) {
            own[k] = shares[k][at[k]];
            length = std::max(length, own[k] * bend.first[k]);
        }
        bound = std::max(bound, bend.bound(own) + rounding_);
    });
    grid.bound = frame_.unscaled(bound * (1 + 8 * eps));
    grid.reached = bound * (1 + 8 * eps) <= chord_ && length <= longest_;
    return grid;
}

} // namespace

VolumeGrid volume_grid(const Spline &volume, const MeshRule &rule, int64_t most) {
    return GridPlan(volume, rule, most).grid();
}

} // namespace nrb::mesh
