// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_cell.h"

#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t width = 4; // x w, y w, z w, w
constexpr double least_length = 0x1p-31;
// In parts of the length of derivatives: what bends less is halved where it is longer.
constexpr double little_bend = 0.05;

double dot3(const Vector3 &a, const double *b) noexcept {
    return a.x * b[0] + a.y * b[1] + a.z * b[2];
}

// Of Bernstein coefficients [degree + 1] those over the wide part, by the blossom: [degree + 1][degree + 1].
std::vector<double> widening_matrix(int degree) {
    const auto n = static_cast<size_t>(degree) + 1;
    std::vector<double> matrix(n * n);
    std::array<double, max_degree + 1> unit{};
    for (size_t j = 0; j < n; ++j) {
        for (size_t r = 0; r < n; ++r) {
            unit.fill(0);
            unit[j] = 1;
            for (size_t level = n - 1; level > 0; --level) {
                casteljau_step(static_cast<int64_t>(level), 1, level > r ? -widening : 1 + widening,
                               unit.data());
            }
            matrix[r * n + j] = unit[0];
        }
    }
    return matrix;
}

void apply(const std::vector<double> &matrix, const AxisLayers &layers, const double *from, double *to) {
    const auto n = static_cast<size_t>(layers.degree) + 1, inner = static_cast<size_t>(layers.inner);
    for (int64_t o = 0; o < layers.outer; ++o) {
        for (size_t r = 0; r < n; ++r, to += inner) {
            std::fill_n(to, inner, 0.0);
            for (size_t j = 0; j < n; ++j) {
                const double factor = matrix[r * n + j], *layer = from + j * inner;
                for (size_t c = 0; c < inner; ++c) {
                    to[c] += factor * layer[c];
                }
            }
        }
        from += n * inner;
    }
}

} // namespace

CrossGround::CrossGround(const Spline &surface, const SurfaceBorders &ends, const SideShifts &of_axes)
    : grid(pieces::piece_grid_of(surface)), borders(ends),
      shifts(of_axes), widenings{widening_matrix(surface.axis(0).degree()),
                                 widening_matrix(surface.axis(1).degree())} {}

CrossPiece::CrossPiece(pieces::BezierPiece made, const CrossGround &of)
    : ground(&of), piece(std::move(made)), degrees{piece.degree(0), piece.degree(1)}, shift(of.shifts) {
    const pieces::LocalParam first = piece.parameter({0, 0}), last = piece.parameter({1, 1});
    for (size_t k = 0; k < 2; ++k) {
        range[k] = {first[k], last[k]};
    }
    error = piece.moved() + (2 * (degrees[0] + degrees[1]) + 8) * eps * piece.reach();
    set_sides(of.grid, of.borders);
}

void CrossPiece::set_sides(const pieces::PieceGrid &grid, const SurfaceBorders &borders) {
    for (size_t k = 0; k < 2; ++k) {
        const int axis = static_cast<int>(k);
        const int64_t i = grid.find(axis, range[k].lower / 2 + range[k].upper / 2), n = grid.count(axis);
        const auto length = [&](int64_t at) {
            const int64_t piece_at = (at + n) % n;
            return grid.break_at(axis, piece_at + 1) - grid.break_at(axis, piece_at);
        };
        index[k] = i;
        const double start = grid.break_at(axis, i), whole = length(i),
                     part = range[k].upper - range[k].lower;
        within[k] = {range[k].lower == start ? 0 : (range[k].lower - start) / whole,
                     range[k].upper == grid.break_at(axis, i + 1) ? 1 : (range[k].upper - start) / whole};
        const double of_axis = shift[k];
        shift[k] *= whole / part;
        for (size_t end = 0; end < 2; ++end) {
            const bool up = end == 1, is_break = (up ? within[k].upper : within[k].lower) == (up ? 1 : 0);
            open[k][end] = is_break && !borders.goes_on(k, i, up);
            const double next = is_break && !open[k][end] ? length(up ? i + 1 : i - 1) : whole;
            const double by = of_axis * std::min(next, whole) / part;
            shifts[k][end] = open[k][end] && !up ? -by : by;
        }
    }
}

CrossPiece::Point CrossPiece::evaluate(const std::array<double, 2> &place) const noexcept {
    constexpr size_t stride = max_degree + 1;
    std::array<std::array<double, 2 * stride>, 2> b;
    for (size_t k = 0; k < 2; ++k) {
        bernstein_functions(degrees[k], place[k], 1, stride, b[k].data());
    }
    std::array<double, width> value{}, by_u{}, by_v{};
    const double *record = piece.record(0);
    for (int i = 0; i <= degrees[0]; ++i) {
        std::array<double, width> row{}, row_v{};
        for (int j = 0; j <= degrees[1]; ++j, record += width) {
            const double f = b[1][static_cast<size_t>(j)], g = b[1][stride + static_cast<size_t>(j)];
            for (size_t c = 0; c < width; ++c) {
                row[c] += f * record[c];
                row_v[c] += g * record[c];
            }
        }
        const double f = b[0][static_cast<size_t>(i)], g = b[0][stride + static_cast<size_t>(i)];
        for (size_t c = 0; c < width; ++c) {
            value[c] += f * row[c];
            by_u[c] += g * row[c];
            by_v[c] += f * row_v[c];
        }
    }
    const double inverse = 1 / value[3];
    const Vector3 at{value[0] * inverse, value[1] * inverse, value[2] * inverse};
    const auto quotient = [&](const std::array<double, width> &by) {
        return inverse * (Vector3{by[0], by[1], by[2]} - by[3] * at);
    };
    return {at, {quotient(by_u), quotient(by_v)}, {by_u[3] * inverse, by_v[3] * inverse}};
}

CrossCell::CrossCell(const CrossPiece &piece)
    : piece_(&piece),
      records_(piece.piece.record(0), piece.piece.record(0) + width * piece.piece.coefficients()) {
    set_box();
}

CrossCell::CrossCell(const CrossCell &whole, size_t axis, size_t end, std::vector<double> records)
    : piece_(whole.piece_), lower_(whole.lower_), length_(whole.length_), depth_(whole.depth_ + 1),
      records_(std::move(records)) {
    length_[axis] /= 2;
    lower_[axis] += end == 1 ? length_[axis] : 0;
    set_box();
}

double CrossCell::side(size_t axis, size_t end) const noexcept {
    const bool inside = end == 0 ? lower_[axis] > 0 : lower_[axis] + length_[axis] < 1;
    const double shift = inside ? piece_->shift[axis] : piece_->shifts[axis][end];
    return static_cast<double>(end) + shift / length_[axis];
}

bool CrossCell::is_open(size_t axis, size_t end) const noexcept {
    const bool inside = end == 0 ? lower_[axis] > 0 : lower_[axis] + length_[axis] < 1;
    return !inside && piece_->open[axis][end];
}

void CrossCell::set_box() {
    box_.fill({infinity, -infinity});
    for (size_t i = 0; i < records_.size(); i += width) {
        const double inverse = 1 / records_[i + 3];
        for (size_t c = 0; c < 3; ++c) {
            const double x = records_[i + c] * inverse;
            box_[c] = {std::min(box_[c].lower, x), std::max(box_[c].upper, x)};
        }
    }
    for (const Interval &side : box_) {
        size_ = std::max(size_, side.upper - side.lower);
    }
    count_work(8 * std::ssize(records_));
}

bool CrossCell::prepare() {
    if (state_ != State::unknown) {
        return state_ == State::positive;
    }
    std::vector<double> wide(records_.size()), half(records_.size());
    const auto &[p, q] = piece_->degrees;
    const auto &widenings = piece_->ground->widenings;
    apply(widenings[0], {1, p, (q + 1) * static_cast<int64_t>(width)}, records_.data(), half.data());
    apply(widenings[1], {p + 1, q, static_cast<int64_t>(width)}, half.data(), wide.data());
    count_work((p + q + 8) * std::ssize(wide));
    weights_ = {infinity, 0};
    for (size_t i = 3; i < wide.size(); i += width) {
        weights_ = {std::min(weights_.lower, wide[i]), std::max(weights_.upper, wide[i])};
    }
    if (p == 0 || q == 0 || !(weights_.lower > 0x1p-10 * weights_.upper)) {
        state_ = State::other;
        return false;
    }
    state_ = State::positive;
    set_wide(wide);
    return true;
}

void CrossCell::set_wide(const std::vector<double> &records) {
    constexpr std::array<double, 2> middle{0.5, 0.5};
    const CrossPiece::Point point = piece_->evaluate(in_piece(middle.data()));
    centre_ = point.at;
    slope_ = {length_[0] * point.slope[0], length_[1] * point.slope[1]};
    const std::array<double, 2> turns{length_[0] * point.turn[0], length_[1] * point.turn[1]};
    std::vector<double> from_centre = records;
    points_.resize(records.size() / width * 3);
    for (size_t i = 0; i < records.size() / width; ++i) {
        double *record = from_centre.data() + width * i;
        const Vector3 a{record[0] - record[3] * centre_.x, record[1] - record[3] * centre_.y,
                        record[2] - record[3] * centre_.z};
        record[0] = a.x;
        record[1] = a.y;
        record[2] = a.z;
        const Vector3 from = (1 / record[3]) * a;
        points_[3 * i] = from.x;
        points_[3 * i + 1] = from.y;
        points_[3 * i + 2] = from.z;
        reach_ = std::max(reach_, numeric::length(from));
    }
    // Each axis makes errors larger by the sum of the magnitudes of its means.
    const auto &[p, q] = piece_->degrees;
    const double ratio = weights_.upper / weights_.lower, amplified = std::pow(1 + 2 * widening, p + q);
    error_ = piece_->error + (depth_ + 1) * std::max(p, q) * eps * piece_->piece.reach();
    slope_error_ = 4 * std::max(p, q) * ratio * amplified * error_;
    for (size_t k = 0; k < 2; ++k) {
        set_slopes(from_centre, k, turns[k]);
    }
}

// With N = (w (S - centre))_k and w_k raised to the degree of w, D = S_k in the middle and r = w_k / w there, the derivative is
//     S_k = D + (N - D w - r w (S - centre) - (S - centre) (w_k - r w)) / w:
// what is kept are the coefficients of the first three terms of the numerator, and the largest |w_k - r w|.
void CrossCell::set_slopes(const std::vector<double> &records, size_t axis, double turn) {
    const auto &[p, q] = piece_->degrees;
    const int degree = piece_->degrees[axis];
    const double factor = degree / (1 + 2 * widening);
    const size_t step = width * (axis == 0 ? static_cast<size_t>(q) + 1 : 1);
    const std::array<double, width> middle{slope_[axis].x, slope_[axis].y, slope_[axis].z, turn};
    std::vector<double> &off = slopes_[axis];
    off.reserve(records.size() / width * 3);
    double largest_turn = 0;
    bends_[axis] = 0;
    for (size_t at = 0; at < records.size(); at += width) {
        const size_t i = at / step % (static_cast<size_t>(degree) + 1);
        const double share = static_cast<double>(i) / degree, *own = &records[at];
        std::array<double, width> by{};
        for (size_t c = 0; c < width; ++c) {
            by[c] = factor * ((i > 0 ? share * (own[c] - (own - step)[c]) : 0) +
                              (share < 1 ? (1 - share) * ((own + step)[c] - own[c]) : 0));
        }
        for (size_t c = 0; c < 3; ++c) {
            off.push_back(by[c] - middle[c] * own[3] - turn * own[c]);
            bends_[axis] = std::max(bends_[axis], std::abs(off.back()));
        }
        largest_turn = std::max(largest_turn, std::abs(by[3] - turn * own[3]));
    }
    turns_[axis] = 1.0001 * largest_turn;
    bends_[axis] =
        (bends_[axis] + reach_ * turns_[axis]) / weights_.upper + little_bend * numeric::length(slope_[axis]);
}

Interval CrossCell::points_along(const Vector3 &vector) const noexcept {
    Interval range{infinity, -infinity};
    for (size_t i = 0; i < points_.size(); i += 3) {
        const double x = dot3(vector, &points_[i]);
        range = {std::min(range.lower, x), std::max(range.upper, x)};
    }
    return range;
}

CrossExtents CrossCell::along(const Vector3 &vector) const noexcept {
    CrossExtents extents{points_along(vector), {}};
    const double far = std::max(std::abs(extents.points.lower), std::abs(extents.points.upper)),
                 room = numeric::length(vector) * slope_error_;
    const double least = 1 / weights_.upper, most = 1 / weights_.lower;
    for (size_t k = 0; k < 2; ++k) {
        Interval range{infinity, -infinity};
        for (size_t i = 0; i < slopes_[k].size(); i += 3) {
            const double x = dot3(vector, &slopes_[k][i]);
            range = {std::min(range.lower, x), std::max(range.upper, x)};
        }
        range = {range.lower - far * turns_[k], range.upper + far * turns_[k]};
        const double middle = dot(vector, slope_[k]);
        extents.slopes[k] = {middle + range.lower * (range.lower < 0 ? most : least) - room,
                             middle + range.upper * (range.upper < 0 ? least : most) + room};
    }
    return extents;
}

double CrossCell::largest_slope(size_t axis) const noexcept {
    double most = 0;
    for (size_t i = 0; i < slopes_[axis].size(); i += 3) {
        most = std::max(most, norm(&slopes_[axis][i], 3));
    }
    return 1.0001 *
           (numeric::length(slope_[axis]) + (most + reach_ * turns_[axis]) / weights_.lower + slope_error_);
}

size_t CrossCell::axis_of_halves() const noexcept {
    if (piece_->degrees[0] == 0 || piece_->degrees[1] == 0) {
        return piece_->degrees[0] == 0 ? 1 : 0;
    }
    if (state_ == State::positive) {
        return bends_[1] > bends_[0] ? 1 : 0;
    }
    return length_[1] > length_[0] ? 1 : 0;
}

bool CrossCell::split(std::deque<CrossCell> &all) {
    if (halves_[0] != nullptr) {
        return true;
    }
    const size_t axis = axis_of_halves();
    if (piece_->degrees[axis] == 0 || length_[axis] <= least_length) {
        return false;
    }
    const auto &[p, q] = piece_->degrees;
    const AxisLayers layers = axis == 0 ? AxisLayers{1, p, (q + 1) * static_cast<int64_t>(width)}
                                        : AxisLayers{p + 1, q, static_cast<int64_t>(width)};
    std::vector<double> upper = records_, lower(upper.size());
    subdivide(layers, 0.5, upper.data(), lower.data());
    halves_[1] = &all.emplace_back(*this, axis, 1, std::move(upper));
    halves_[0] = &all.emplace_back(*this, axis, 0, std::move(lower));
    return true;
}

} // namespace nrb::intersect
