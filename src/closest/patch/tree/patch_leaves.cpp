// SPDX-License-Identifier: MIT
#include "closest/patch/tree/patch_leaves.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double most_byte = 127;
constexpr int64_t work_of_a_value = 16; // of a leaf
constexpr int64_t read_over = 7;        // numbers after the last disc that are read

// The scale of numbers up to a magnitude: 0 if they are.
float scale_of(double magnitude) noexcept {
    return pieces::above(std::min(magnitude, pieces::unbounded) / most_byte);
}

int8_t byte_of(double x) noexcept {
    return static_cast<int8_t>(std::clamp(x, -most_byte, most_byte));
}

} // namespace

// As many as the memory allows, which is at most 1.5 (p + 1) (q + 1) times that of the control points with
// all else, and 12 times for a bicubic surface. Fewer leaves for a piece when there are many pieces, which
// are small then.
int PatchLeaves::parts_of(const PieceGrid &pieces, bool normals) noexcept {
    const PatchShape &shape = pieces.shape();
    if (shape.axes == 0 || pieces.count() > 32768) {
        return 1;
    }
    const int wanted = shape.axes == 3 || pieces.count() > 4096 ? 2 : 4;
    const int64_t columns = pieces::disc_columns(shape.dim, normals);
    const double most = 1.5 * std::min<double>(static_cast<double>(shape.coefficients()), 8);
    const auto data = static_cast<double>(pieces.control_points() * shape.dim * 8);
    // The control points, the discs of the pieces and of a third as many groups, frames, and the rest.
    const auto others = static_cast<double>(shape.lanes * 8 + pieces::disc_frame(shape.dim) * 4 + 8) +
                        1.4 * static_cast<double>(columns * 4);
    for (int parts = wanted; parts > 1; parts /= 2) {
        const double leaves = std::pow(parts, shape.axes) * static_cast<double>(columns + (normals ? 3 : 0));
        if ((leaves + others) * static_cast<double>(pieces.count()) <= most * data) {
            return parts;
        }
    }
    return 1;
}

void PatchLeaves::set_matrices(const PatchShape &shape) {
    for (int k = 0; k < shape.axes; ++k) {
        auto &matrices = matrices_[static_cast<size_t>(k)];
        const int64_t size = int64_t{shape.degree(k) + 1} * (shape.degree(k) + 1);
        matrices.resize(static_cast<size_t>(parts_ * size));
        for (int i = 0; i < parts_; ++i) {
            pieces::part_matrix(shape.degree(k), static_cast<double>(i) / parts_,
                                static_cast<double>(i + 1) / parts_, matrices.data() + i * size);
        }
        count_ *= parts_;
    }
}

PatchLeaves::PatchLeaves(const pieces::PieceTree &tree) : has_normals_(tree.normals()) {
    const PieceGrid &pieces = tree.grid();
    const PatchShape &shape = pieces.shape();
    parts_ = parts_of(pieces, has_normals_);
    set_matrices(shape);
    if (parts_ == 1) {
        return;
    }
    off_ = 0.5 * std::sqrt(static_cast<double>(shape.dim)) * (1 + 16 * eps);
    const auto nodes = std::ssize(tree.order());
    normals_.resize(static_cast<size_t>(has_normals_ ? nodes * count_ * 3 + read_over : 0));
    discs_.resize(static_cast<size_t>(nodes * count_ * byte_columns(shape.dim) + read_over));
    frames_.resize(static_cast<size_t>(nodes * pieces::disc_frame(shape.dim)));
    std::vector<double> patch(static_cast<size_t>(shape.values())), work(patch);
    std::vector<double> parts(static_cast<size_t>(count_ * shape.values()));
    std::vector<pieces::Disc> discs;
    for (int64_t node = 0; node < nodes; ++node) {
        pieces.patch(tree.order()[static_cast<size_t>(node)], work.data(), patch.data());
        count_work(work_of_a_value * count_ * shape.values());
        split(shape, patch, parts);
        discs.clear();
        for (int64_t i = 0; i < count_; ++i) {
            discs.emplace_back(shape, parts.data() + i * shape.values(), has_normals_);
        }
        write(node, shape.dim, tree.rounding(), discs, parts, pieces);
    }
}

// Axis after axis, the parts so far in the order of leaves.
void PatchLeaves::split(const PatchShape &shape, const std::vector<double> &patch,
                        std::vector<double> &parts) const {
    const int64_t size = shape.values();
    std::copy(patch.begin(), patch.end(), parts.begin());
    std::vector<double> from(static_cast<size_t>(size));
    int64_t made = 1;
    for (int k = 0; k < shape.axes; ++k, made *= parts_) {
        for (int64_t i = made; i-- > 0;) {
            std::copy_n(parts.begin() + i * size, size, from.begin());
            for (int part = 0; part < parts_; ++part) {
                apply_matrix(shape, k, matrix(k, part), from.data(),
                             parts.data() + (i * parts_ + part) * size);
            }
        }
    }
}

void PatchLeaves::write(int64_t node, int dim, double rounding, std::vector<pieces::Disc> &discs,
                        const std::vector<double> &parts, const PieceGrid &pieces) {
    int8_t *out = discs_.data() + node * count_ * byte_columns(dim);
    round_centres(dim, discs, frame(node, dim), out);
    if (has_normals_) {
        round_normals(discs, normals_.data() + node * count_ * 3);
    }
    for (size_t i = 0; i < discs.size(); ++i) {
        const double *part = parts.data() + static_cast<int64_t>(i) * pieces.shape().values();
        discs[i].add(pieces, part);
    }
    round_sizes(dim, rounding, discs, frame(node, dim), out + dim * count_);
}

void PatchLeaves::round_centres(int dim, std::vector<pieces::Disc> &discs, float *frame, int8_t *out) {
    double reach = 0;
    for (int c = 0; c < dim; ++c) {
        const auto at = static_cast<size_t>(c);
        double low = pieces::far_away, high = -pieces::far_away;
        for (const pieces::Disc &disc : discs) {
            low = std::min(low, disc.centre[at]);
            high = std::max(high, disc.centre[at]);
        }
        frame[c] = static_cast<float>(low / 2 + high / 2);
        reach = std::max({reach, high - frame[c], frame[c] - low});
    }
    const double scale = frame[dim] = scale_of(reach);
    for (int c = 0; c < dim; ++c) {
        for (pieces::Disc &disc : discs) {
            double &x = disc.centre[static_cast<size_t>(c)];
            *out = byte_of(scale > 0 ? std::round((x - frame[c]) / scale) : 0);
            x = frame[c] + scale * *out++;
        }
    }
}

// They are made a little shorter first, so that none is longer than 1 after rounding.
void PatchLeaves::round_normals(std::vector<pieces::Disc> &discs, int16_t *out) const {
    for (size_t i = 0; i < discs.size(); ++i) {
        for (size_t c = 0; c < 3; ++c) {
            double &x = discs[i].normal[c];
            const auto q =
                static_cast<int16_t>(std::round((1 - pieces::normal_unit) * x / pieces::normal_unit));
            out[static_cast<int64_t>(c) * count_ + static_cast<int64_t>(i)] = q;
            x = pieces::normal_unit * q;
        }
    }
}

// Away from the disc.
void PatchLeaves::round_sizes(int dim, double rounding, const std::vector<pieces::Disc> &discs, float *frame,
                              int8_t *out) const {
    double radius = 0, height = 0;
    for (const pieces::Disc &disc : discs) {
        radius = std::max(radius, disc.radius + rounding);
        height = std::max({height, disc.high + rounding, rounding - disc.low});
    }
    frame[dim + 1] = scale_of(radius / 2); // bytes from -127 on
    frame[dim + 2] = scale_of(height);
    const auto units = [](double size, float scale) { return scale > 0 ? size / scale * (1 + 2 * eps) : 0; };
    for (size_t i = 0; i < discs.size(); ++i) {
        const pieces::Disc &disc = discs[i];
        const auto at = static_cast<int64_t>(i);
        out[at] = byte_of(std::ceil(units(disc.radius + rounding, frame[dim + 1])) - most_byte);
        if (has_normals_) {
            int8_t *heights = out + count_ + at;
            heights[0] = byte_of(std::floor(units(disc.low - rounding, frame[dim + 2])));
            heights[count_] = byte_of(std::ceil(units(disc.high + rounding, frame[dim + 2])));
        }
    }
}

void PatchLeaves::bound(int64_t node, int dim, const double *x, bool farthest,
                        const pieces::DiscBounds &out) const noexcept {
    const float *frame = this->frame(node, dim);
    const pieces::ByteDiscs discs{discs_.data() + node * count_ * byte_columns(dim),
                                  has_normals_ ? normals_.data() + node * count_ * 3 : nullptr, frame,
                                  off_ * double{frame[dim]}};
    pieces::bound_discs(discs, count_, dim, has_normals_, x, farthest, out);
}

} // namespace nrb::closest
