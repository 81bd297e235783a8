// SPDX-License-Identifier: MIT
// Bezier pieces of a curve, halved until they are nearly straight, and a tree of bounds over them.
#pragma once

#include "closest/foot.h"

#include <vector>

namespace nrb::closest {

// A leaf is a piece over a part of one span. Its records are relative to the centre of the curve, in units of
// 2^exponent: coordinates, zeros, and the weight as the last one of `lanes`, a multiple of 4. If all weights
// are negative, their signs are changed, and those of the coordinates with them. Eight consecutive leaves are
// a block, eight blocks a node of the first level, eight nodes a node of the next level. The order of the
// curve keeps leaves together that are near each other.
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
    // The largest distance of a control point from the centre, or of the centre from the origin, in the units
    // of the curve.
    [[nodiscard]] double size() const noexcept { return size_; }
    // How far rounding may have moved a leaf, as a multiple of eps, for each unit of size.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Whether squares of all weights are in the range of double precision; if not, nothing can be proven.
    [[nodiscard]] bool sound() const noexcept { return sound_; }

    [[nodiscard]] const double *records(int64_t leaf) const noexcept {
        return records_.data() + leaf * (degree_ + 1) * lanes_;
    }
    [[nodiscard]] Interval domain(int64_t leaf) const noexcept { return domains_[static_cast<size_t>(leaf)]; }
    // The leaf that contains a parameter of the domain; where two meet, the upper one.
    [[nodiscard]] int64_t leaf_at(double t) const noexcept;
    // Whether the curve continues from a leaf to the next one without a jump; false if either does not exist.
    [[nodiscard]] bool joined(int64_t leaf) const noexcept;

    // Data of block b: starts [dim][fan], chords [dim][fan], inverse squared lengths of the chords [fan] (0
    // if there is no chord), and how far the piece may be from its chord [fan] (infinite unless weights are
    // positive). If there are fewer leaves, the remaining chords are that of the last one.
    [[nodiscard]] const double *block(int64_t b) const noexcept { return blocks_.data() + b * block_size(); }
    [[nodiscard]] int64_t block_size() const noexcept { return int64_t{2} * fan * (dim_ + 1); }
    [[nodiscard]] int64_t block_count() const noexcept { return (leaves() + fan - 1) / fan; }

    // Levels above the blocks, the lowest first; the last one has one node. Of a node: lower ends [dim][fan]
    // and upper ends [dim][fan] of the boxes of its children.
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
