#include "closest/patch/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double far_away = 1e150;    // of the discs that fill up a family
constexpr double unbounded = 0x1p200; // of patches without bounds

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

    // About the middle of a patch.
    Disc(const PatchShape &shape, const double *patch, bool with_normal);
    void add(const PatchShape &shape, const double *patch, bool positive) noexcept;
    void add_point(int dim, const double *point, double weight) noexcept;
};

PatchTree::Disc::Disc(const PatchShape &shape, const double *patch, bool with_normal) {
    std::vector<double> work(static_cast<size_t>(evaluation_work(shape)) + 1),
        jet(static_cast<size_t>(4 * shape.lanes));
    evaluate_patch(shape, patch, {0.5, 0.5, 0.5}, with_normal ? 1 : 0, work.data(), jet.data());
    const double w = jet[static_cast<size_t>(shape.dim)];
    for (int c = 0; c < shape.dim; ++c) {
        const double x = jet[static_cast<size_t>(c)] / w;
        centre.push_back(std::isfinite(x) ? std::clamp(x, -far_away, far_away) : 0.0);
    }
    if (!with_normal) {
        return;
    }
    double tangents[2][3];
    for (int k = 0; k < 2; ++k) {
        const double *d = jet.data() + static_cast<ptrdiff_t>((k + 1) * shape.lanes);
        for (int c = 0; c < 3; ++c) {
            tangents[k][c] = d[c] - d[3] * centre[static_cast<size_t>(c)];
        }
    }
    double n[3];
    cross_product(tangents[0], tangents[1], n);
    const double length = std::hypot(n[0], n[1], n[2]) * (1 + 4 * eps);
    if (length > 0x1p-400 && std::isfinite(length)) {
        normal = {n[0] / length, n[1] / length, n[2] / length};
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
        std::vector<PatchPieces::Index> grids;
        set_grids(grids);
        std::vector<PatchPieces::Index> nodes{PatchPieces::Index{}};
        tree_.nodes_.push_back(nodes);
        for (size_t level = 1; level < grids.size(); ++level) {
            nodes = children(grids[level], level, nodes);
            tree_.nodes_.push_back(nodes);
        }
        if (tree_.parts_ > 1) {
            add_leaves(nodes);
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
    void set_grids(std::vector<PatchPieces::Index> &grids) {
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

    std::vector<PatchPieces::Index> children(const PatchPieces::Index &grid, size_t level,
                                             const std::vector<PatchPieces::Index> &parents) {
        const PatchPieces::Index &coarse = tree_.blocks_[level - 1], &fine = tree_.blocks_[level];
        std::vector<PatchPieces::Index> nodes;
        std::vector<Family> families;
        for (const PatchPieces::Index &parent : parents) {
            PatchPieces::Index low{}, high{};
            for (size_t k = 0; k < low.size(); ++k) {
                const int64_t side = coarse[k] / fine[k];
                low[k] = parent[k] * side;
                high[k] = std::min(low[k] + side, grid[k]);
            }
            const auto first = std::ssize(nodes);
            PatchPieces::Index i{};
            for (i[0] = low[0]; i[0] < high[0]; ++i[0]) {
                for (i[1] = low[1]; i[1] < high[1]; ++i[1]) {
                    for (i[2] = low[2]; i[2] < high[2]; ++i[2]) {
                        nodes.push_back(i);
                    }
                }
            }
            families.push_back(family(first, std::ssize(nodes) - first));
            for (int64_t j = first; j < std::ssize(nodes); ++j) {
                write(families.back(), j - first, group(nodes[static_cast<size_t>(j)], fine));
            }
        }
        tree_.families_.push_back(std::move(families));
        return nodes;
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
    Disc group(const PatchPieces::Index &node, const PatchPieces::Index &block) const {
        PatchPieces::Index low{}, high{1, 1, 1}, middle{};
        for (int k = 0; k < pieces_.spline_axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            low[at] = node[at] * block[at];
            high[at] = std::min(low[at] + block[at], pieces_.count(k));
            middle[at] = (low[at] + high[at]) / 2;
        }
        Disc disc(pieces_.shape(), pieces_.patch(pieces_.piece(middle)), tree_.normals_);
        PatchPieces::Index i{};
        for (i[0] = low[0]; i[0] < high[0]; ++i[0]) {
            for (i[1] = low[1]; i[1] < high[1]; ++i[1]) {
                for (i[2] = low[2]; i[2] < high[2]; ++i[2]) {
                    disc.add(pieces_.shape(), pieces_.patch(pieces_.piece(i)), pieces_.positive());
                }
            }
        }
        return disc;
    }

    void add_leaves(const std::vector<PatchPieces::Index> &nodes) {
        const PatchShape &shape = pieces_.shape();
        std::vector<double> patch(static_cast<size_t>(shape.values())), other(patch);
        std::vector<Family> families;
        for (size_t node = 0; node < nodes.size(); ++node) {
            const double *whole = pieces_.patch(pieces_.piece(nodes[node]));
            families.push_back(family(static_cast<int64_t>(node) * tree_.leaves_, tree_.leaves_));
            for (int64_t i = 0; i < tree_.leaves_; ++i) {
                int64_t rest = i;
                std::copy_n(whole, patch.size(), patch.data());
                for (int k = shape.axes; k-- > 0; rest /= tree_.parts_) {
                    const auto part = static_cast<int>(rest % tree_.parts_);
                    apply_matrix(shape, k, tree_.matrix(k, part), patch.data(), other.data());
                    std::swap(patch, other);
                }
                Disc disc(shape, patch.data(), tree_.normals_);
                disc.add(shape, patch.data(), pieces_.positive());
                write(families.back(), i, disc);
            }
        }
        tree_.families_.push_back(std::move(families));
    }

    // Rounding of the pieces, of their parts and of the bounds is in the discs.
    void write(const Family &family, int64_t i, const Disc &disc) {
        const int dim = pieces_.shape().dim;
        const double more = pieces_.moved() + 4 * pieces_.value_error() * pieces_.radius();
        double *column = tree_.discs_.data() + family.offset + i;
        const auto put = [&](double value) {
            *column = value;
            column += family.width;
        };
        std::for_each_n(disc.centre.begin(), dim, put);
        put(disc.radius + more);
        if (tree_.normals_) {
            std::for_each(disc.normal.begin(), disc.normal.end(), put);
            put(disc.low - more);
            put(disc.high + more);
        }
    }

    PatchTree &tree_;
    const PatchPieces &pieces_;
};

PatchTree::PatchTree(const PatchPieces &pieces)
    : pieces_(pieces), normals_(pieces.shape().dim == 3 && pieces.shape().axes == 2) {
    Builder(*this).build();
}

PatchTree::Extent PatchTree::extent(int level, int64_t node) const noexcept {
    if (level == levels() - 1 && parts_ > 1) {
        --level;
        node /= leaves_;
    }
    const PatchPieces::Index &block = blocks_[static_cast<size_t>(level)];
    const PatchPieces::Index &at = nodes_[static_cast<size_t>(level)][static_cast<size_t>(node)];
    Extent result{};
    for (int k = 0; k < pieces_.spline_axes(); ++k) {
        const auto i = static_cast<size_t>(k);
        result.lower[i] = at[i] * block[i];
        result.upper[i] = std::min(result.lower[i] + block[i], pieces_.count(k));
    }
    return result;
}

PatchTree::Leaf PatchTree::leaf(int64_t node) const noexcept {
    Leaf result{0, {}};
    int64_t rest = node % leaves_;
    for (int k = pieces_.shape().axes; k-- > 0; rest /= parts_) {
        result.part[static_cast<size_t>(k)] = static_cast<int>(rest % parts_);
    }
    result.piece = pieces_.piece(nodes_.back()[static_cast<size_t>(node / leaves_)]);
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
