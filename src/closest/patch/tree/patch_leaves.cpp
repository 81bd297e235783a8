// SPDX-License-Identifier: MIT
#include "closest/patch/tree/patch_leaves.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double most_byte = 127;
constexpr double largest = 1e36;    // that scales stand for, of patches without bounds too
constexpr double far_centre = 1e30; // products of bytes and scales stay finite
constexpr int64_t read_over = 7;    // numbers after the last disc that are read

float above(double x) noexcept {
    const auto rounded = static_cast<float>(x);
    return rounded < x ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

// The scale of numbers up to a magnitude: 0 if they are.
float scale_of(double magnitude) noexcept {
    return above(std::min(magnitude, largest) / most_byte);
}

int8_t byte_of(double x) noexcept {
    return static_cast<int8_t>(std::clamp(x, -most_byte, most_byte));
}

} // namespace

// As many as the memory allows, which is at most 1.5 (p + 1) (q + 1) times that of the control points with
// all else, and 12 times for a bicubic surface. Fewer leaves for a piece when there are many pieces, which
// are small then.
int PatchLeaves::parts_of(const PatchPieces &pieces, bool normals) noexcept {
    const PatchShape &shape = pieces.shape();
    if (shape.axes == 0 || pieces.count() > 32768) {
        return 1;
    }
    const int wanted = shape.axes == 3 || pieces.count() > 4096 ? 2 : 4;
    const int64_t columns = disc_columns(shape.dim, normals);
    const double most = 1.5 * std::min<double>(static_cast<double>(shape.coefficients()), 8);
    const auto data = static_cast<double>(pieces.control_points() * shape.dim * 8);
    const auto others =
        static_cast<double>((columns + shape.lanes + 2) * 8 + disc_frame(shape.dim, normals) * 4);
    for (int parts = wanted; parts > 1; parts /= 2) {
        const double leaves = std::pow(parts, shape.axes) * static_cast<double>(columns);
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
            part_matrix(shape.degree(k), static_cast<double>(i) / parts_, static_cast<double>(i + 1) / parts_,
                        matrices.data() + i * size);
        }
        count_ *= parts_;
    }
}

void PatchLeaves::build(const PatchPieces &pieces, bool normals, const std::vector<int32_t> &order) {
    const PatchShape &shape = pieces.shape();
    normals_ = normals;
    parts_ = parts_of(pieces, normals);
    set_matrices(shape);
    if (parts_ == 1) {
        return;
    }
    off_ = 0.5 * std::sqrt(static_cast<double>(shape.dim)) * (1 + 16 * eps);
    const auto nodes = std::ssize(order);
    discs_.resize(static_cast<size_t>(nodes * count_ * disc_columns(shape.dim, normals) + read_over));
    frames_.resize(static_cast<size_t>(nodes * disc_frame(shape.dim, normals)));
    // Rounding of the pieces, of their parts and of the bounds.
    const double rounding = pieces.moved() + 4 * pieces.value_error() * pieces.radius();
    std::vector<double> patch(static_cast<size_t>(shape.values())), work(patch);
    std::vector<double> parts(static_cast<size_t>(count_ * shape.values()));
    std::vector<PatchDisc> discs;
    for (int64_t node = 0; node < nodes; ++node) {
        pieces.patch(order[static_cast<size_t>(node)], work.data(), patch.data());
        split(shape, patch, parts);
        discs.clear();
        for (int64_t i = 0; i < count_; ++i) {
            discs.emplace_back(shape, parts.data() + i * shape.values(), normals);
        }
        write(node, shape.dim, rounding, discs, parts, pieces);
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

void PatchLeaves::write(int64_t node, int dim, double rounding, std::vector<PatchDisc> &discs,
                        const std::vector<double> &parts, const PatchPieces &pieces) {
    int8_t *out = discs_.data() + node * count_ * disc_columns(dim, normals_);
    round_centres(dim, discs, frame(node, dim), out);
    if (normals_) {
        round_normals(discs, frame(node, dim) + dim + 3, out + (dim + 1) * count_);
    }
    for (size_t i = 0; i < discs.size(); ++i) {
        const double *part = parts.data() + static_cast<int64_t>(i) * pieces.shape().values();
        discs[i].add(pieces.shape(), part, pieces.positive());
    }
    round_sizes(dim, rounding, discs, frame(node, dim), out + dim * count_);
}

void PatchLeaves::round_centres(int dim, std::vector<PatchDisc> &discs, float *frame, int8_t *out) const {
    double reach = 0;
    for (int c = 0; c < dim; ++c) {
        const auto at = static_cast<size_t>(c);
        double low = far_centre, high = -far_centre;
        for (PatchDisc &disc : discs) {
            disc.centre[at] = std::clamp(disc.centre[at], -far_centre, far_centre);
            low = std::min(low, disc.centre[at]);
            high = std::max(high, disc.centre[at]);
        }
        frame[c] = static_cast<float>(low / 2 + high / 2);
        reach = std::max({reach, high - frame[c], frame[c] - low});
    }
    const double scale = frame[dim] = scale_of(reach);
    for (int c = 0; c < dim; ++c) {
        for (PatchDisc &disc : discs) {
            double &x = disc.centre[static_cast<size_t>(c)];
            *out = byte_of(scale > 0 ? std::round((x - frame[c]) / scale) : 0);
            x = frame[c] + scale * *out++;
        }
    }
}

// Any direction will do, for patches without a normal as well. What is small are the differences of normals.
// They are made a little shorter first, so that none is longer than 1 after rounding.
void PatchLeaves::round_normals(std::vector<PatchDisc> &discs, float *frame, int8_t *out) const {
    std::array<double, 3> any{0, 0, 1}, low{1, 1, 1}, high{-1, -1, -1};
    for (PatchDisc &disc : discs) {
        any = disc.normal != std::array<double, 3>{} ? disc.normal : any;
        disc.normal = any;
        for (size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], any[c]);
            high[c] = std::max(high[c], any[c]);
        }
    }
    double reach = 0;
    for (size_t c = 0; c < 3; ++c) {
        frame[c] = static_cast<float>(low[c] / 2 + high[c] / 2);
        reach = std::max({reach, high[c] - frame[c], frame[c] - low[c]});
    }
    const double scale = frame[3] = scale_of(reach * most_byte / (most_byte - 1));
    const double length = 1 - scale; // rounding adds at most sqrt(3) / 2 of the scale
    for (size_t i = 0; i < discs.size(); ++i) {
        for (size_t c = 0; c < 3; ++c) {
            double &x = discs[i].normal[c];
            const int8_t q = byte_of(scale > 0 ? std::round((length * x - frame[c]) / scale) : 0);
            out[static_cast<int64_t>(c) * count_ + static_cast<int64_t>(i)] = q;
            x = frame[c] + scale * q;
        }
    }
}

// Away from the disc.
void PatchLeaves::round_sizes(int dim, double rounding, const std::vector<PatchDisc> &discs, float *frame,
                              int8_t *out) const {
    double radius = 0, height = 0;
    for (const PatchDisc &disc : discs) {
        radius = std::max(radius, disc.radius + rounding);
        height = std::max({height, disc.high + rounding, rounding - disc.low});
    }
    frame[dim + 1] = scale_of(radius / 2); // bytes from -127 on
    frame[dim + 2] = scale_of(height);
    const auto units = [](double size, float scale) { return scale > 0 ? size / scale * (1 + 2 * eps) : 0; };
    for (size_t i = 0; i < discs.size(); ++i) {
        const PatchDisc &disc = discs[i];
        const auto at = static_cast<int64_t>(i);
        out[at] = byte_of(std::ceil(units(disc.radius + rounding, frame[dim + 1])) - most_byte);
        if (normals_) {
            int8_t *heights = out + (dim + 1) * count_ + at;
            heights[0] = byte_of(std::floor(units(disc.low - rounding, frame[dim + 2])));
            heights[count_] = byte_of(std::ceil(units(disc.high + rounding, frame[dim + 2])));
        }
    }
}

void PatchLeaves::bound(int64_t node, int dim, const double *x, bool farthest,
                        const DiscBounds &out) const noexcept {
    const float *frame = this->frame(node, dim);
    const ByteDiscs discs{discs_.data() + node * count_ * disc_columns(dim, normals_), frame,
                          off_ * double{frame[dim]}};
    bound_discs(discs, count_, dim, normals_, x, farthest, out);
}

} // namespace nrb::closest
