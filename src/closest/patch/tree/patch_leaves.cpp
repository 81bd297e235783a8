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
constexpr int64_t work_of_a_value = 16; // per number of a leaf

// The unit for numbers up to a magnitude; 0 if they are all 0.
float scale_of(double magnitude) noexcept {
    return pieces::above(std::min(magnitude, pieces::unbounded) / most_byte);
}

int8_t byte_of(double x) noexcept {
    return static_cast<int8_t>(std::clamp(x, -most_byte, most_byte));
}

} // namespace

// As many parts per axis as memory allows: everything together takes at most 1.5 min(n, 8) times the memory
// of the control points, where n is the number of coefficients of a piece, (p + 1) (q + 1) for a surface; for
// a bicubic one that is 12 times. If there are many pieces, they are small and get fewer leaves.
int PatchLeaves::parts_of(const PieceGrid &pieces, bool normals) noexcept {
    const PatchShape &shape = pieces.shape();
    if (shape.axes == 0 || pieces.count() > 32768) {
        return 1;
    }
    const int wanted = shape.axes == 3 || pieces.count() > 4096 ? 2 : 4;
    const int64_t columns = pieces::disc_columns(shape.dim, normals);
    const double most = 1.5 * std::min<double>(static_cast<double>(shape.coefficients()), 8);
    const auto data = static_cast<double>(pieces.control_points() * shape.dim * 8);
    // The control points, the discs of the pieces and of groups (a third as many), frames and the rest.
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

PatchLeaves::PatchLeaves(const pieces::PieceTree &tree)
    : tree_(tree), has_normals_(tree.normals()), dim_(tree.grid().shape().dim),
      parts_(parts_of(tree.grid(), has_normals_)) {
    set_matrices(tree.grid().shape());
    if (parts_ == 1) {
        return;
    }
    read_over_ = (8 - count_ % 8) % 8;
    off_ = 0.5 * std::sqrt(static_cast<double>(dim_)) * (1 + 16 * eps);
    const auto nodes = std::ssize(tree.order());
    const auto room = [nodes](int64_t size) { return static_cast<size_t>(nodes * size); };
    states_ = std::make_unique<std::atomic<State>[]>(room(1));
    columns_ = std::make_unique_for_overwrite<int8_t[]>(room(columns_size()));
    normals_ = std::make_unique_for_overwrite<int16_t[]>(room(normals_size()));
    frames_ = std::make_unique_for_overwrite<float[]>(room(frame_size()));
}

// Divides axis by axis; the parts stay in the order of leaves.
void PatchLeaves::split(const std::vector<double> &patch, std::vector<double> &parts) const {
    const PatchShape &shape = tree_.grid().shape();
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

void PatchLeaves::make(int64_t node, const Discs &out) const {
    const PieceGrid &pieces = tree_.grid();
    const PatchShape &shape = pieces.shape();
    const int64_t size = shape.values();
    std::vector<double> patch(static_cast<size_t>(size)), work(patch),
        parts(static_cast<size_t>(count_ * size));
    pieces.patch(tree_.order()[static_cast<size_t>(node)], work.data(), patch.data());
    split(patch, parts);
    std::vector<pieces::Disc> discs;
    discs.reserve(static_cast<size_t>(count_));
    for (int64_t i = 0; i < count_; ++i) {
        discs.emplace_back(shape, parts.data() + i * size, has_normals_);
    }
    round_centres(discs, out);
    if (has_normals_) {
        round_normals(discs, out.normals);
    }
    for (size_t i = 0; i < discs.size(); ++i) {
        discs[i].add(pieces, parts.data() + static_cast<int64_t>(i) * size);
    }
    round_sizes(discs, out);
    const NotCounted by_limit;
    count_work(work_of_a_value * count_ * size);
}

void PatchLeaves::round_centres(std::vector<pieces::Disc> &discs, const Discs &out) const {
    float *frame = out.frame;
    int8_t *column = out.columns;
    double reach = 0;
    for (int c = 0; c < dim_; ++c) {
        const auto at = static_cast<size_t>(c);
        double low = pieces::far_away, high = -pieces::far_away;
        for (const pieces::Disc &disc : discs) {
            low = std::min(low, disc.centre[at]);
            high = std::max(high, disc.centre[at]);
        }
        frame[c] = static_cast<float>(low / 2 + high / 2);
        reach = std::max({reach, high - frame[c], frame[c] - low});
    }
    const double scale = frame[dim_] = scale_of(reach);
    for (int c = 0; c < dim_; ++c) {
        for (pieces::Disc &disc : discs) {
            double &x = disc.centre[static_cast<size_t>(c)];
            *column = byte_of(scale > 0 ? std::round((x - frame[c]) / scale) : 0);
            x = frame[c] + scale * *column++;
        }
    }
}

// The normals are shortened slightly first, so that none is longer than 1 after rounding.
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

// Rounds outwards.
void PatchLeaves::round_sizes(const std::vector<pieces::Disc> &discs, const Discs &out) const {
    const double rounding = tree_.rounding();
    float *scales = out.frame + dim_ + 1;
    int8_t *radii = out.columns + dim_ * count_;
    double radius = 0, height = 0;
    for (const pieces::Disc &disc : discs) {
        radius = std::max(radius, disc.radius + rounding);
        height = std::max({height, disc.high + rounding, rounding - disc.low});
    }
    scales[0] = scale_of(radius / 2); // radii are stored from -127 on
    scales[1] = scale_of(height);
    const auto units = [](double size, float scale) { return scale > 0 ? size / scale * (1 + 2 * eps) : 0; };
    for (size_t i = 0; i < discs.size(); ++i) {
        const pieces::Disc &disc = discs[i];
        const auto at = static_cast<int64_t>(i);
        radii[at] = byte_of(std::ceil(units(disc.radius + rounding, scales[0])) - most_byte);
        if (has_normals_) {
            int8_t *heights = radii + count_ + at;
            heights[0] = byte_of(std::floor(units(disc.low - rounding, scales[1])));
            heights[count_] = byte_of(std::ceil(units(disc.high + rounding, scales[1])));
        }
    }
}

PatchLeaves::Discs PatchLeaves::kept(int64_t node) const noexcept {
    return {columns_.get() + node * columns_size(), normals_.get() + node * normals_size(),
            frames_.get() + node * frame_size()};
}

// No thread waits: one that arrives while another one is writing uses the discs that it has made itself.
void PatchLeaves::keep(int64_t node, const Discs &made) const noexcept {
    std::atomic<State> &state = states_[static_cast<size_t>(node)];
    State missing = State::missing;
    if (state.compare_exchange_strong(missing, State::written, std::memory_order_relaxed)) {
        const Discs place = kept(node);
        std::copy_n(made.columns, columns_size(), place.columns);
        std::copy_n(made.normals, normals_size(), place.normals);
        std::copy_n(made.frame, frame_size(), place.frame);
        state.store(State::ready, std::memory_order_release);
    }
}

void PatchLeaves::bound_made(const Discs &discs, const double *x, bool farthest,
                             const pieces::DiscBounds &out) const noexcept {
    const pieces::ByteDiscs bytes{discs.columns, discs.normals, discs.frame,
                                  off_ * double{discs.frame[dim_]}};
    pieces::bound_discs(bytes, count_, dim_, has_normals_, x, farthest, out);
}

void PatchLeaves::bound(int64_t node, const double *x, bool farthest, const pieces::DiscBounds &out) const {
    if (states_[static_cast<size_t>(node)].load(std::memory_order_acquire) == State::ready) {
        return bound_made(kept(node), x, farthest, out);
    }
    std::vector<int8_t> columns(static_cast<size_t>(columns_size()));
    std::vector<int16_t> normals(static_cast<size_t>(normals_size()));
    std::vector<float> frame(static_cast<size_t>(frame_size()));
    const Discs made{columns.data(), normals.data(), frame.data()};
    make(node, made);
    keep(node, made);
    bound_made(made, x, farthest, out);
}

} // namespace nrb::closest
