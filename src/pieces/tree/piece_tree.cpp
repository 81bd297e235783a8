// SPDX-License-Identifier: MIT
#include "closest/patch/tree/patch_tree.h"

#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace nrb::closest {

// Grids of nodes, each of the blocks of the finer one, from the root down.
class PatchTree::Builder {
public:
    explicit Builder(PatchTree &tree) : tree_(tree), pieces_(tree.pieces_) {}

    void build() {
        if (pieces_.count() > std::numeric_limits<int32_t>::max()) {
            throw std::bad_alloc(); // the tree would take more than 10^11 bytes
        }
        set_grids();
        tree_.nodes_.push_back({0});
        for (size_t level = 1; level < tree_.grids_.size(); ++level) {
            tree_.nodes_.push_back(children(level));
        }
        tree_.discs_.shrink_to_fit();
        tree_.leaves_.build(pieces_, tree_.normals_, tree_.nodes_.back());
    }

private:
    // The number of nodes along each axis, and of the pieces in each of them; root first.
    void set_grids() {
        std::vector<PatchPieces::Index> &grids = tree_.grids_;
        PatchPieces::Index grid{1, 1, 1}, block{1, 1, 1};
        for (int k = 0; k < pieces_.spline_axes(); ++k) {
            grid[static_cast<size_t>(k)] = pieces_.count(k);
        }
        grids.push_back(grid);
        tree_.blocks_.push_back(block);
        const int64_t side = pieces_.spline_axes() == 3 ? 2 : 4;
        for (bool first = true; first || grid[0] * grid[1] * grid[2] > 1; first = false) {
            const bool last = grid[0] * grid[1] * grid[2] <= (first ? 16 : 48);
            for (size_t k = 0; k < grid.size(); ++k) {
                block[k] = last ? block[k] * grid[k] : block[k] * side;
                grid[k] = last ? 1 : (grid[k] + side - 1) / side;
            }
            grids.push_back(grid);
            tree_.blocks_.push_back(block);
        }
        std::reverse(grids.begin(), grids.end());
        std::reverse(tree_.blocks_.begin(), tree_.blocks_.end());
    }

    std::vector<int32_t> children(size_t level) {
        const PatchPieces::Index &grid = tree_.grids_[level], &coarse = tree_.blocks_[level - 1],
                                 &fine = tree_.blocks_[level];
        std::vector<int32_t> nodes;
        std::vector<Family> families;
        nodes.reserve(static_cast<size_t>(grid[0] * grid[1] * grid[2]));
        families.reserve(tree_.nodes_.back().size());
        for (size_t parent = 0; parent < tree_.nodes_.back().size(); ++parent) {
            const auto at = tree_.place_in_grid(static_cast<int>(level) - 1, static_cast<int64_t>(parent));
            Extent block{};
            for (size_t k = 0; k < at.size(); ++k) {
                const int64_t side = coarse[k] / fine[k];
                block.lower[k] = at[k] * side;
                block.upper[k] = std::min(block.lower[k] + side, grid[k]);
            }
            const auto first = std::ssize(nodes);
            for_each(block, [&](const PatchPieces::Index &i) {
                nodes.push_back(static_cast<int32_t>((i[0] * grid[1] + i[1]) * grid[2] + i[2]));
            });
            families.push_back(family(first, std::ssize(nodes) - first));
            int64_t column = 0;
            for_each(block,
                     [&](const PatchPieces::Index &i) { write(families.back(), column++, group(i, fine)); });
        }
        tree_.families_.push_back(std::move(families));
        return nodes;
    }

    template <class Visit>
    static void for_each(const Extent &block, Visit &&visit) {
        PatchPieces::Index i{};
        for (i[0] = block.lower[0]; i[0] < block.upper[0]; ++i[0]) {
            for (i[1] = block.lower[1]; i[1] < block.upper[1]; ++i[1]) {
                for (i[2] = block.lower[2]; i[2] < block.upper[2]; ++i[2]) {
                    visit(i);
                }
            }
        }
    }

    Family family(int64_t first, int64_t count) {
        const int64_t width = (count + 7) / 8 * 8, dim = pieces_.shape().dim;
        const Family made{first, count, width, std::ssize(tree_.discs_)};
        tree_.discs_.resize(
            static_cast<size_t>(made.offset + width * disc_columns(pieces_.shape().dim, tree_.normals_)),
            0.0F);
        std::fill_n(tree_.discs_.begin() + made.offset, dim * width, static_cast<float>(far_away));
        return made;
    }

    // All coefficients of the pieces in a node, about the middle of one in its midst.
    PatchDisc group(const PatchPieces::Index &node, const PatchPieces::Index &block) {
        Extent inside{{}, {1, 1, 1}};
        PatchPieces::Index middle{};
        for (int k = 0; k < pieces_.spline_axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            inside.lower[at] = node[at] * block[at];
            inside.upper[at] = std::min(inside.lower[at] + block[at], pieces_.count(k));
            middle[at] = (inside.lower[at] + inside.upper[at]) / 2;
        }
        PatchDisc disc(pieces_.shape(), load(pieces_.piece(middle)), tree_.normals_);
        disc.make_single();
        for_each(inside, [&](const PatchPieces::Index &i) {
            disc.add(pieces_.shape(), load(pieces_.piece(i)), pieces_.rounding());
        });
        return disc;
    }

    const double *load(int64_t piece) {
        pieces_.patch(piece, work_.data(), patch_.data());
        return patch_.data();
    }

    // Rounding of the pieces, of their parts and of the bounds is in the discs.
    [[nodiscard]] double rounding() const noexcept {
        return pieces_.moved() + 4 * pieces_.value_error() * pieces_.radius();
    }

    void write(const Family &family, int64_t i, const PatchDisc &disc) {
        float *column = tree_.discs_.data() + family.offset + i;
        const auto put = [&](double value) {
            *column = static_cast<float>(value);
            column += family.width;
        };
        std::for_each_n(disc.centre.begin(), pieces_.shape().dim, put);
        tree_.apart_ = std::max(tree_.apart_, 0x1p-24 * norm(disc.centre.data(), pieces_.shape().dim));
        put(above(disc.radius + rounding()));
        if (tree_.normals_) {
            std::for_each(disc.normal.begin(), disc.normal.end(), put);
            put(-above(rounding() - disc.low));
            put(above(disc.high + rounding()));
        }
    }

    PatchTree &tree_;
    const PatchPieces &pieces_;
    std::vector<double> patch_ = std::vector<double>(static_cast<size_t>(pieces_.shape().values()));
    std::vector<double> work_ = patch_;
};

PatchTree::PatchTree(const PatchPieces &pieces)
    : pieces_(pieces), normals_(pieces.shape().dim == 3 && pieces.shape().axes == 2) {
    Builder(*this).build();
}

void PatchTree::bound(int level, int64_t node, const double *x, bool farthest,
                      const DiscBounds &out) const noexcept {
    const int dim = pieces_.shape().dim;
    if (level < static_cast<int>(families_.size())) {
        const Family children = family(level, node);
        bound_discs({discs_.data() + children.offset, apart_}, children.width, dim, normals_, x, farthest,
                    out);
    } else {
        leaves_.bound(node, dim, x, farthest, out);
    }
}

PatchPieces::Index PatchTree::place_in_grid(int level, int64_t node) const noexcept {
    const PatchPieces::Index &grid = grids_[static_cast<size_t>(level)];
    const int64_t place = nodes_[static_cast<size_t>(level)][static_cast<size_t>(node)];
    return {place / grid[2] / grid[1], place / grid[2] % grid[1], place % grid[2]};
}

PatchTree::Extent PatchTree::extent(int level, int64_t node) const noexcept {
    if (level == levels() - 1 && parts() > 1) {
        --level;
        node /= leaves_.count();
    }
    const PatchPieces::Index &block = blocks_[static_cast<size_t>(level)];
    const PatchPieces::Index at = place_in_grid(level, node);
    Extent result{};
    for (int k = 0; k < pieces_.spline_axes(); ++k) {
        const auto i = static_cast<size_t>(k);
        result.lower[i] = at[i] * block[i];
        result.upper[i] = std::min(result.lower[i] + block[i], pieces_.count(k));
    }
    return result;
}

PatchTree::Leaf PatchTree::leaf(int64_t node) const noexcept {
    Leaf result{nodes_.back()[static_cast<size_t>(node / leaves_.count())], {}};
    int64_t rest = node % leaves_.count();
    for (int k = pieces_.shape().axes; k-- > 0; rest /= parts()) {
        result.part[static_cast<size_t>(k)] = static_cast<int>(rest % parts());
    }
    return result;
}

PatchTree::Centre PatchTree::centre(int level, int64_t node) const noexcept {
    if (level == levels() - 1 && parts() > 1) {
        const Leaf part = leaf(node);
        Centre result{part.piece, {}};
        for (size_t k = 0; k < result.at.size(); ++k) {
            result.at[k] = (part.part[k] + 0.5) / parts();
        }
        return result;
    }
    const Extent pieces = extent(level, node);
    PatchPieces::Index middle{};
    for (size_t k = 0; k < middle.size(); ++k) {
        middle[k] = (pieces.lower[k] + pieces.upper[k]) / 2;
    }
    return {pieces_.piece(middle), {0.5, 0.5, 0.5}};
}

} // namespace nrb::closest
