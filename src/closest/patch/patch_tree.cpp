// SPDX-License-Identifier: MIT
#include "closest/patch/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double far_away = 1e150; // of the discs that fill up a family
constexpr double far_away_float = 1e30;
constexpr double unbounded = 0x1p200; // of patches without bounds

float below(double x) noexcept {
    const auto rounded = static_cast<float>(x);
    return rounded > x ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

float above(double x) noexcept {
    return -below(-x);
}

void cross_product(const double *a, const double *b, double *out) noexcept {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

} // namespace

// One disc in the making.
struct PatchTree::Disc {
    std::vector<double> centre;
    std::array<double, 3> normal{};
    double radius = 0, low = 0, high = 0;

    // About the middle of a patch; of floats if `rounded`.
    Disc(const PatchShape &shape, const double *patch, bool with_normal, bool rounded);
    void add(const PatchShape &shape, const double *patch, bool positive) noexcept;
    void set_normal(const PatchShape &shape, const double *jet, bool rounded) noexcept;
    void add_point(int dim, const double *point, double weight) noexcept;
};

PatchTree::Disc::Disc(const PatchShape &shape, const double *patch, bool with_normal, bool rounded) {
    std::vector<double> work(static_cast<size_t>(evaluation_work(shape)) + 1),
        jet(static_cast<size_t>(4 * shape.lanes));
    evaluate_patch(shape, patch, {0.5, 0.5, 0.5}, with_normal ? 1 : 0, work.data(), jet.data());
    const double w = jet[static_cast<size_t>(shape.dim)], most = rounded ? far_away_float : far_away;
    for (int c = 0; c < shape.dim; ++c) {
        const double x = jet[static_cast<size_t>(c)] / w;
        const double moderate = std::isfinite(x) ? std::clamp(x, -most, most) : 0.0;
        centre.push_back(rounded ? static_cast<float>(moderate) : moderate);
    }
    if (with_normal) {
        set_normal(shape, jet.data(), rounded);
    }
}

// Any direction will do that is no longer than 1, which floats may be by 2^-24 of it.
void PatchTree::Disc::set_normal(const PatchShape &shape, const double *jet, bool rounded) noexcept {
    double tangents[2][3];
    for (int k = 0; k < 2; ++k) {
        const double *d = jet + static_cast<ptrdiff_t>((k + 1) * shape.lanes);
        for (int c = 0; c < 3; ++c) {
            tangents[k][c] = d[c] - d[3] * centre[static_cast<size_t>(c)];
        }
    }
    double n[3];
    cross_product(tangents[0], tangents[1], n);
    const double length = std::hypot(n[0], n[1], n[2]) * (1 + (rounded ? 0x1p-22 : 4 * eps));
    if (length > 0x1p-400 && std::isfinite(length)) {
        for (size_t c = 0; c < 3; ++c) {
            normal[c] = rounded ? static_cast<float>(n[c] / length) : n[c] / length;
        }
    }
}

// The difference that the radius is the root of may cancel; what it loses is given back.
void PatchTree::Disc::add_point(int dim, const double *point, double weight) noexcept {
    double square = 0, height = 0;
    for (int c = 0; c < dim; ++c) {
        const double delta = point[c] / weight - centre[static_cast<size_t>(c)];
        square += delta * delta;
        height += dim == 3 ? delta * normal[static_cast<size_t>(c)] : 0.0;
    }
    const double across = std::max(0.0, square - height * height) + (dim + 8) * eps * square;
    radius = std::max(radius, std::sqrt(across));
    low = std::min(low, height);
    high = std::max(high, height);
}

void PatchTree::Disc::add(const PatchShape &shape, const double *patch, bool positive) noexcept {
    const int64_t count = shape.coefficients();
    for (int64_t i = 0; i < count; ++i, patch += shape.lanes) {
        const double w = patch[shape.dim];
        if (w > 0) {
            add_point(shape.dim, patch, w);
        } else if (!(positive && w == 0)) {
            radius = unbounded;
        }
    }
    if (!(radius < unbounded)) {
        radius = unbounded;
        low = -unbounded;
        high = unbounded;
    }
}

// Grids of nodes, each of the blocks of the finer one, from the root down.
class PatchTree::Builder {
public:
    explicit Builder(PatchTree &tree) : tree_(tree), pieces_(tree.pieces_) {}

    void build() {
        set_parts();
        set_grids();
        tree_.nodes_.push_back({0});
        for (size_t level = 1; level < tree_.grids_.size(); ++level) {
            tree_.nodes_.push_back(children(level));
        }
        tree_.discs_.shrink_to_fit();
        if (tree_.parts_ > 1) {
            add_leaves();
        }
    }

private:
    // Fewer leaves for a piece when there are many pieces, which are small then.
    void set_parts() {
        const PatchShape &shape = pieces_.shape();
        const int most = shape.axes == 3 ? 2 : 4;
        tree_.parts_ = shape.axes == 0 || pieces_.count() > 32768 ? 1 : pieces_.count() > 4096 ? 2 : most;
        for (int k = 0; k < shape.axes; ++k) {
            auto &matrices = tree_.matrices_[static_cast<size_t>(k)];
            matrices.resize(static_cast<size_t>(tree_.parts_ * tree_.matrix_size(k)));
            for (int i = 0; i < tree_.parts_; ++i) {
                part_matrix(shape.degree(k), static_cast<double>(i) / tree_.parts_,
                            static_cast<double>(i + 1) / tree_.parts_,
                            matrices.data() + i * tree_.matrix_size(k));
            }
            tree_.leaves_ *= tree_.parts_;
        }
    }

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

    std::vector<int64_t> children(size_t level) {
        const PatchPieces::Index &grid = tree_.grids_[level], &coarse = tree_.blocks_[level - 1],
                                 &fine = tree_.blocks_[level];
        std::vector<int64_t> nodes;
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
                nodes.push_back((i[0] * grid[1] + i[1]) * grid[2] + i[2]);
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
            0.0);
        std::fill_n(tree_.discs_.begin() + made.offset, dim * width, far_away);
        return made;
    }

    // All coefficients of the pieces in a node, about the middle of one in its midst.
    Disc group(const PatchPieces::Index &node, const PatchPieces::Index &block) {
        Extent inside{{}, {1, 1, 1}};
        PatchPieces::Index middle{};
        for (int k = 0; k < pieces_.spline_axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            inside.lower[at] = node[at] * block[at];
            inside.upper[at] = std::min(inside.lower[at] + block[at], pieces_.count(k));
            middle[at] = (inside.lower[at] + inside.upper[at]) / 2;
        }
        Disc disc(pieces_.shape(), load(pieces_.piece(middle)), tree_.normals_, false);
        for_each(inside, [&](const PatchPieces::Index &i) {
            disc.add(pieces_.shape(), load(pieces_.piece(i)), pieces_.positive());
        });
        return disc;
    }

    const double *load(int64_t piece) {
        pieces_.patch(piece, work_.data(), patch_.data());
        return patch_.data();
    }

    void add_leaves() {
        tree_.leaf_size_ = tree_.leaves_ * disc_columns(pieces_.shape().dim, tree_.normals_);
        const int64_t over = 7; // that are read after the last family
        tree_.leaf_discs_.resize(static_cast<size_t>(pieces_.count() * tree_.leaf_size_ + over));
        for (int64_t node = 0; node < pieces_.count(); ++node) {
            load(tree_.nodes_.back()[static_cast<size_t>(node)]);
            const std::vector<double> whole = patch_;
            for (int64_t i = 0; i < tree_.leaves_; ++i) {
                write_leaf(node, i, leaf(whole, i));
            }
        }
    }

    Disc leaf(const std::vector<double> &whole, int64_t i) {
        const PatchShape &shape = pieces_.shape();
        std::copy(whole.begin(), whole.end(), patch_.begin());
        for (int k = shape.axes; k-- > 0; i /= tree_.parts_) {
            const auto part = static_cast<int>(i % tree_.parts_);
            apply_matrix(shape, k, tree_.matrix(k, part), patch_.data(), work_.data());
            std::swap(patch_, work_);
        }
        Disc disc(shape, patch_.data(), tree_.normals_, true);
        disc.add(shape, patch_.data(), pieces_.positive());
        return disc;
    }

    // Rounding of the pieces, of their parts and of the bounds is in the discs.
    [[nodiscard]] double rounding() const noexcept {
        return pieces_.moved() + 4 * pieces_.value_error() * pieces_.radius();
    }

    void write(const Family &family, int64_t i, const Disc &disc) {
        double *column = tree_.discs_.data() + family.offset + i;
        const auto put = [&](double value) {
            *column = value;
            column += family.width;
        };
        std::for_each_n(disc.centre.begin(), pieces_.shape().dim, put);
        put(disc.radius + rounding());
        if (tree_.normals_) {
            std::for_each(disc.normal.begin(), disc.normal.end(), put);
            put(disc.low - rounding());
            put(disc.high + rounding());
        }
    }

    void write_leaf(int64_t node, int64_t i, const Disc &disc) {
        float *column = tree_.leaf_discs_.data() + node * tree_.leaf_size_ + i;
        const auto put = [&](float value) {
            *column = value;
            column += tree_.leaves_;
        };
        const auto put_exact = [&](double value) { put(static_cast<float>(value)); };
        std::for_each_n(disc.centre.begin(), pieces_.shape().dim, put_exact);
        put(above(disc.radius + rounding()));
        if (tree_.normals_) {
            std::for_each(disc.normal.begin(), disc.normal.end(), put_exact);
            put(below(disc.low - rounding()));
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

// Centres that are floats are not on the surface, but nearly so.
void PatchTree::bound(int level, int64_t node, const double *x, bool farthest,
                      const DiscBounds &out) const noexcept {
    const Family children = family(level, node);
    const int dim = pieces_.shape().dim;
    if (level < static_cast<int>(families_.size())) {
        bound_discs(discs_.data() + children.offset, children.width, dim, normals_, x, farthest, out);
        return;
    }
    bound_discs(leaf_discs_.data() + children.offset, children.width, dim, normals_, x, farthest, out);
    const double off = 0x1p-23 * pieces_.radius();
    std::for_each_n(out.centres, children.count, [off](double &centre) { centre += off; });
}

PatchPieces::Index PatchTree::place_in_grid(int level, int64_t node) const noexcept {
    const PatchPieces::Index &grid = grids_[static_cast<size_t>(level)];
    const int64_t place = nodes_[static_cast<size_t>(level)][static_cast<size_t>(node)];
    return {place / grid[2] / grid[1], place / grid[2] % grid[1], place % grid[2]};
}

PatchTree::Extent PatchTree::extent(int level, int64_t node) const noexcept {
    if (level == levels() - 1 && parts_ > 1) {
        --level;
        node /= leaves_;
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
    Leaf result{nodes_.back()[static_cast<size_t>(node / leaves_)], {}};
    int64_t rest = node % leaves_;
    for (int k = pieces_.shape().axes; k-- > 0; rest /= parts_) {
        result.part[static_cast<size_t>(k)] = static_cast<int>(rest % parts_);
    }
    return result;
}

PatchTree::Place PatchTree::centre(int level, int64_t node) const noexcept {
    if (level == levels() - 1 && parts_ > 1) {
        const Leaf part = leaf(node);
        Place result{part.piece, {}};
        for (size_t k = 0; k < result.at.size(); ++k) {
            result.at[k] = (part.part[k] + 0.5) / parts_;
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
