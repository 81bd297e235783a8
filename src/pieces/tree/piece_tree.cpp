// SPDX-License-Identifier: MIT
#include "pieces/tree/piece_tree.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace nrb::pieces {

// Builds the grids of nodes, in which each node is a block of the finer grid, from the root down.
class PieceTree::Builder {
public:
    explicit Builder(PieceTree &tree) : tree_(tree), pieces_(tree.grid_) {}

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
    }

private:
    static constexpr int64_t work_of_a_value = 8; // computing a piece, and measuring its values

    // Sets the number of nodes along each axis, and of the pieces in each node; root first.
    void set_grids() {
        std::vector<PieceGrid::Index> &grids = tree_.grids_;
        PieceGrid::Index grid{1, 1, 1}, block{1, 1, 1};
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
        const PieceGrid::Index &grid = tree_.grids_[level], &coarse = tree_.blocks_[level - 1],
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
            for_each(block, [&](const PieceGrid::Index &i) {
                nodes.push_back(static_cast<int32_t>((i[0] * grid[1] + i[1]) * grid[2] + i[2]));
            });
            families.push_back(family(first, std::ssize(nodes) - first));
            int64_t column = 0;
            for_each(block,
                     [&](const PieceGrid::Index &i) { write(families.back(), column++, group(i, fine)); });
        }
        tree_.families_.push_back(std::move(families));
        return nodes;
    }

    template <class Visit>
    static void for_each(const Extent &block, Visit &&visit) {
        PieceGrid::Index i{};
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

    // The disc of all coefficients of the pieces in a node, about the middle of a piece in its centre.
    Disc group(const PieceGrid::Index &node, const PieceGrid::Index &block) {
        Extent inside{{}, {1, 1, 1}};
        PieceGrid::Index middle{};
        for (int k = 0; k < pieces_.spline_axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            inside.lower[at] = node[at] * block[at];
            inside.upper[at] = std::min(inside.lower[at] + block[at], pieces_.count(k));
            middle[at] = (inside.lower[at] + inside.upper[at]) / 2;
        }
        count_work(block[0] * block[1] * block[2] * pieces_.shape().values() * work_of_a_value);
        Disc disc(pieces_.shape(), load(pieces_.piece(middle)), tree_.normals_);
        disc.make_single();
        for_each(inside, [&](const PieceGrid::Index &i) { disc.add(pieces_, load(pieces_.piece(i))); });
        return disc;
    }

    const double *load(int64_t piece) {
        pieces_.patch(piece, work_.data(), patch_.data());
        return patch_.data();
    }

    void write(const Family &family, int64_t i, const Disc &disc) {
        float *column = tree_.discs_.data() + family.offset + i;
        const auto put = [&](double value) {
            *column = static_cast<float>(value);
            column += family.width;
        };
        std::for_each_n(disc.centre.begin(), pieces_.shape().dim, put);
        tree_.apart_ = std::max(tree_.apart_, 0x1p-24 * norm(disc.centre.data(), pieces_.shape().dim));
        put(above(disc.radius + tree_.rounding()));
        if (tree_.normals_) {
            std::for_each(disc.normal.begin(), disc.normal.end(), put);
            put(-above(tree_.rounding() - disc.low));
            put(above(disc.high + tree_.rounding()));
        }
    }

    PieceTree &tree_;
    const PieceGrid &pieces_;
    std::vector<double> patch_ = std::vector<double>(static_cast<size_t>(pieces_.shape().values()));
    std::vector<double> work_ = patch_;
};

PieceTree::PieceTree(const PieceGrid &grid)
    : grid_(grid), normals_(grid_.shape().dim == 3 && grid_.shape().axes == 2) {
    Builder(*this).build();
}

void PieceTree::bound(int level, int64_t node, const double *x, bool farthest,
                      const DiscBounds &out) const noexcept {
    const Family children = family(level, node);
    bound_discs({discs_.data() + children.offset, apart_}, children.width, grid_.shape().dim, normals_, x,
                farthest, out);
}

// For a point c + v, v = (n . v) n + M M v with M^2 = I - n n^T, where n . v is a height, |M v| is at most
// the radius, and row i of M has the length (1 - n_i^2)^(1/2). All this has rounding errors of a few eps of
// its terms.
void PieceTree::disc_box(int level, int64_t node, int64_t i, double *out) const noexcept {
    const Family children = family(level, node);
    const int dim = grid_.shape().dim;
    const auto column = [&](int c) -> double {
        return discs_[static_cast<size_t>(children.offset + c * children.width + i)];
    };
    const double radius = column(dim), low = normals_ ? column(dim + 4) : 0,
                 high = normals_ ? column(dim + 5) : 0;
    if (radius >= unbounded) {
        std::fill_n(out, dim, -infinity);
        std::fill_n(out + dim, dim, infinity);
        return;
    }
    for (int c = 0; c < dim; ++c) {
        const double n = normals_ ? column(dim + 1 + c) : 0, centre = column(c);
        const double across = radius * std::sqrt(std::max(0.0, 1 - n * n));
        const double rounded = 8 * eps * (std::abs(centre) + across + std::max(-low, high));
        out[c] = centre + std::min(low * n, high * n) - across - rounded;
        out[dim + c] = centre + std::max(low * n, high * n) + across + rounded;
    }
}

// Encloses the control points of pieces, or the boxes of the next level.
void PieceTree::enclose_children(int level, int64_t node, const Boxes &boxes, double *out) const {
    const auto dim = static_cast<size_t>(grid_.shape().dim);
    std::fill_n(out, dim, infinity);
    std::fill_n(out + dim, dim, -infinity);
    const Family children = family(level, node);
    std::vector<double> patch(static_cast<size_t>(grid_.shape().values())), work(patch);
    for (int64_t child = children.first; child < children.first + children.count; ++child) {
        if (level + 2 == levels()) {
            grid_.patch(order()[static_cast<size_t>(child)], work.data(), patch.data());
            add_to_box(grid_, patch.data(), out);
            continue;
        }
        const float *box =
            boxes[static_cast<size_t>(level) + 1].data() + child * static_cast<int64_t>(2 * dim);
        for (size_t c = 0; c < dim; ++c) {
            out[c] = std::min<double>(out[c], box[c]);
            out[dim + c] = std::max<double>(out[dim + c], box[dim + c]);
        }
    }
}

PieceTree::Boxes PieceTree::make_boxes() const {
    const auto dim = static_cast<size_t>(grid_.shape().dim);
    Boxes boxes(families_.size());
    std::vector<double> box(2 * dim);
    for (int level = levels() - 1; level-- > 0;) {
        const double rounded = level + 2 == levels() ? rounding() : 0;
        std::vector<float> &made = boxes[static_cast<size_t>(level)];
        made.reserve(families_[static_cast<size_t>(level)].size() * box.size());
        for (int64_t node = 0; node < std::ssize(families_[static_cast<size_t>(level)]); ++node) {
            enclose_children(level, node, boxes, box.data());
            for (size_t c = 0; c < 2 * dim; ++c) {
                made.push_back(c < dim ? -above(rounded - box[c]) : above(box[c] + rounded));
            }
        }
    }
    return boxes;
}

void PieceTree::box(int level, int64_t node, double *out) const {
    const int64_t dim = grid_.shape().dim;
    const Boxes &boxes = boxes_.get([this] { return make_boxes(); });
    const float *box = boxes[static_cast<size_t>(level)].data() + node * 2 * dim;
    for (int64_t c = 0; c < 2 * dim; ++c) {
        out[c] = std::abs(box[c]) >= unbounded ? (c < dim ? -infinity : infinity) : box[c];
    }
}

PieceGrid::Index PieceTree::place_in_grid(int level, int64_t node) const noexcept {
    const PieceGrid::Index &grid = grids_[static_cast<size_t>(level)];
    const int64_t place = nodes_[static_cast<size_t>(level)][static_cast<size_t>(node)];
    return {place / grid[2] / grid[1], place / grid[2] % grid[1], place % grid[2]};
}

PieceTree::Extent PieceTree::extent(int level, int64_t node) const noexcept {
    const PieceGrid::Index &block = blocks_[static_cast<size_t>(level)];
    const PieceGrid::Index at = place_in_grid(level, node);
    Extent result{};
    for (int k = 0; k < grid_.spline_axes(); ++k) {
        const auto i = static_cast<size_t>(k);
        result.lower[i] = at[i] * block[i];
        result.upper[i] = std::min(result.lower[i] + block[i], grid_.count(k));
    }
    return result;
}

int64_t PieceTree::middle(int level, int64_t node) const noexcept {
    const Extent pieces = extent(level, node);
    PieceGrid::Index middle{};
    for (size_t k = 0; k < middle.size(); ++k) {
        middle[k] = (pieces.lower[k] + pieces.upper[k]) / 2;
    }
    return grid_.piece(middle);
}

const PieceTree &piece_tree_of(const Spline &spline) {
    return spline.kept<PieceTree>(Spline::Cache::pieces,
                                  [&] { return std::make_shared<const PieceTree>(piece_grid_of(spline)); });
}

} // namespace nrb::pieces
