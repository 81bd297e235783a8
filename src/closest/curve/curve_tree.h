// Bezier pieces of a curve, halved until they are nearly straight, and a tree of bounds over them.
#pragma once

#include "closest/foot.h"

#include <vector>

namespace nrb::closest {

// A leaf is a piece over a part of one span. Its records are about the centre of the curve, in units of
// 2^exponent: coordinates, zeros, and the weight as the last one of `lanes`, a multiple of 4; weights that
// are all negative have changed their sign, with the coordinates. Eight leaves on end are a block, eight
// blocks a node of the first level, eight nodes one of the next level; the curve's own order keeps what is
// near together.
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
    // The largest length of a control point about the centre or of the centre, in the units of the curve.
    [[nodiscard]] double size() const noexcept { return size_; }
    // How far rounding may have moved a leaf, as a multiple of eps, for each unit of size.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Whether squares of all weights are in the range of double precision; without, nothing can be proven.
    [[nodiscard]] bool sound() const noexcept { return sound_; }

    [[nodiscard]] const double *records(int64_t leaf) const noexcept {
        return records_.data() + leaf * (degree_ + 1) * lanes_;
    }
    [[nodiscard]] Interval domain(int64_t leaf) const noexcept { return domains_[static_cast<size_t>(leaf)]; }
    // The leaf that holds a parameter of the domain, the upper one of two.
    [[nodiscard]] int64_t leaf_at(double t) const noexcept;
    // Whether the curve goes on from a leaf to the next one without a jump; false where either is not there.
    [[nodiscard]] bool joined(int64_t leaf) const noexcept;

    // Of block b: starts [dim][fan], chords [dim][fan], inverse squared lengths of the chords [fan] (0 where
    // there is none), and how far the piece may be from its chord [fan] (infinite where weights are not
    // positive). Where there are fewer leaves the chord is that of the last one.
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
