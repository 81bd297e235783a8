// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over a curve: Bezier pieces, halved until they are nearly straight, and a tree
// of boxes.
#pragma once

#include "closest/foot.h"

#include <vector>

namespace nrb::closest {

// A leaf is a Bezier piece over a span or a part of one. Its records are relative to the centre of the curve,
// in units of 2^exponent: coordinates, zeros as padding, and the weight as the last of `lanes` numbers, a
// multiple of 4. If all weights of a piece are negative, the signs of its weights and coordinates are
// reversed. Eight consecutive leaves form a block, eight blocks a node of the first level, eight nodes a node
// of the next level. Leaves follow the order of the curve, which keeps neighbours together.
class CurveTree {
public:
    static constexpr int fan = 8;

    explicit CurveTree(const Spline &curve);

    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] int lanes() const noexcept { return lanes_; }
    [[nodiscard]] int64_t leaves() const noexcept { return static_cast<int64_t>(domains_.size()); }
    [[nodiscard]] const std::vector<double> &centre() const noexcept { return centre_; }
    [[nodiscard]] int exponent() const noexcept { return exponent_; }
    // The largest distance of a control point from the centre, or the distance of the centre from the origin,
    // whichever is larger, in the units of the curve.
    [[nodiscard]] double size() const noexcept { return size_; }
    // How far rounding may have moved a leaf, as a multiple of eps times size().
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Whether the squares of all weights are in the range of double precision; if they are not, nothing can
    // be proven.
    [[nodiscard]] bool sound() const noexcept { return sound_; }

    [[nodiscard]] const double *records(int64_t leaf) const noexcept {
        return records_.data() + leaf * (degree_ + 1) * lanes_;
    }
    [[nodiscard]] Interval domain(int64_t leaf) const noexcept { return domains_[static_cast<size_t>(leaf)]; }
    // The leaf that contains a parameter of the domain; the upper one where two meet.
    [[nodiscard]] int64_t leaf_at(double t) const noexcept;
    // Whether the curve continues from a leaf to the next one without a jump. On a periodic curve the first
    // leaf follows the last one; elsewhere none does.
    [[nodiscard]] bool joined(int64_t leaf) const noexcept;
    // The leaf after a leaf, or before it, counted in circles.
    [[nodiscard]] int64_t after(int64_t leaf) const noexcept { return leaf + 1 < leaves() ? leaf + 1 : 0; }
    [[nodiscard]] int64_t before(int64_t leaf) const noexcept { return leaf > 0 ? leaf - 1 : leaves() - 1; }

    // The data of block b: start points [dim][fan], chords [dim][fan], inverse squared lengths of the chords
    // [fan] (0 if a chord vanishes), and how far each piece may be from its chord [fan] (infinite unless its
    // weights are positive). If a block has fewer leaves, its remaining entries repeat the last leaf.
    [[nodiscard]] const double *block(int64_t b) const noexcept { return blocks_.data() + b * block_size(); }
    [[nodiscard]] int64_t block_size() const noexcept { return int64_t{2} * fan * (dim_ + 1); }
    [[nodiscard]] int64_t block_count() const noexcept { return (leaves() + fan - 1) / fan; }

    // The levels above the blocks, the lowest first; the last one has a single node. A node stores the lower
    // ends [dim][fan] and the upper ends [dim][fan] of the boxes of its children.
    [[nodiscard]] int levels() const noexcept { return static_cast<int>(levels_.size()); }
    [[nodiscard]] const double *node(int level, int64_t i) const noexcept {
        return levels_[static_cast<size_t>(level)].data() + i * node_size();
    }
    [[nodiscard]] int64_t node_size() const noexcept { return int64_t{2} * fan * dim_; }
    [[nodiscard]] int64_t node_count(int level) const noexcept {
        return std::ssize(levels_[static_cast<size_t>(level)]) / node_size();
    }

private:
    struct Boxes;
    void add_span(const double *records, Interval span, int halvings);
    [[nodiscard]] double weight_ratio() const noexcept;
    void add_blocks();
    [[nodiscard]] Boxes leaf_boxes() const;
    void add_levels();

    int dim_;
    int degree_;
    int lanes_;
    int exponent_ = 0;
    bool periodic_;
    bool sound_ = true;
    double size_ = 0;
    double rounding_ = 0;
    std::vector<double> centre_;
    std::vector<double> records_;
    std::vector<Interval> domains_;
    std::vector<double> blocks_;
    std::vector<std::vector<double>> levels_;
};

} // namespace nrb::closest
