// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_cell.h"

#include "base/numbers.h"
#include "base/scratch.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t width = 4; // x w, y w, z w, w
// Relative to the length of derivatives: parts that bend less are halved along the axis on which they are
// longer.
constexpr double little_bend = 0x1p-9;
constexpr int64_t work_of_halves = 200; // for the memory of both

double dot3(const Vector3 &a, const double *b) noexcept {
    return a.x * b[0] + a.y * b[1] + a.z * b[2];
}

// A net of records as seen along an axis.
AxisLayers layers_along(size_t axis, const std::array<int, 2> &degrees) noexcept {
    constexpr auto record = static_cast<int64_t>(width);
    return axis == 0 ? AxisLayers{1, degrees[0], (degrees[1] + 1) * record}
                     : AxisLayers{degrees[0] + 1, degrees[1], record};
}

// The records of the derivative along an axis of positive degree. factor: the degree over the length of the
// interval.
std::vector<double> derivative(const AxisLayers &layers, double factor, const double *records) {
    std::vector<double> result;
    const auto inner = static_cast<size_t>(layers.inner);
    result.reserve(static_cast<size_t>(layers.outer * layers.degree) * inner);
    for (int64_t o = 0; o < layers.outer; ++o, records += inner) {
        for (int i = 0; i < layers.degree; ++i, records += inner) {
            for (size_t c = 0; c < inner; ++c) {
                result.push_back(factor * (records[inner + c] - records[c]));
            }
        }
    }
    return result;
}

} // namespace

bool are_apart(const CrossCell &a, const CrossCell &b) noexcept {
    const double room = a.error() + b.error();
    for (size_t c = 0; c < 3; ++c) {
        if (a.box()[c].lower - b.box()[c].upper > room || b.box()[c].lower - a.box()[c].upper > room) {
            return true;
        }
    }
    return false;
}

CrossCell::CrossCell(const CrossPiece &piece, std::pmr::memory_resource *memory)
    : piece_(&piece), records_(piece.piece.record(0), piece.piece.record(piece.piece.coefficients()), memory),
      wide_(memory) {
    set_box();
}

CrossCell::CrossCell(const CrossCell &whole, size_t axis, size_t end, std::pmr::vector<double> records)
    : piece_(whole.piece_), lower_(whole.lower_), upper_(whole.upper_), length_(whole.length_),
      depth_(whole.depth_ + 1), records_(std::move(records)), wide_(records_.get_allocator()) {
    const double between = lower_[axis] + place_of_halves * length_[axis];
    (end == 0 ? upper_ : lower_)[axis] = between;
    length_[axis] = upper_[axis] - lower_[axis];
    set_box();
}

CrossCell::CrossCell(const CrossCell &whole, const std::array<Interval, 2> &places,
                     std::pmr::vector<double> records)
    : piece_(whole.piece_), depth_(whole.depth_ + 4), records_(std::move(records)),
      wide_(records_.get_allocator()) {
    for (size_t k = 0; k < 2; ++k) {
        const auto at = [&](double place) {
            return place == 1 ? whole.upper_[k] : whole.lower_[k] + place * whole.length_[k];
        };
        lower_[k] = at(places[k].lower);
        upper_[k] = at(places[k].upper);
        length_[k] = upper_[k] - lower_[k];
    }
    set_box();
}

CrossCell::CrossCell(const CrossPiece &piece, const std::array<Interval, 2> &places)
    : piece_(&piece), records_(static_cast<size_t>(piece.piece.coefficients()) * width) {
    Scratch scratch(records_.size());
    double *const half = scratch.take(records_.size());
    for (size_t k = 0; k < 2; ++k) {
        lower_[k] = places[k].lower;
        upper_[k] = places[k].upper;
        length_[k] = upper_[k] - lower_[k];
        apply_along(part_matrix(piece.degrees[k], lower_[k], upper_[k]), layers_along(k, piece.degrees),
                    k == 0 ? piece.piece.record(0) : half, k == 0 ? half : records_.data());
    }
    set_box();
}

bool CrossCell::is_inside(size_t axis, size_t end) const noexcept {
    return end == 0 ? lower_[axis] > 0 : upper_[axis] < 1;
}

std::array<Interval, 2> CrossCell::ranges() const noexcept {
    std::array<Interval, 2> ranges;
    for (size_t k = 0; k < 2; ++k) {
        const auto [lower, upper] = piece_->range[k];
        const auto parameter = [lower = lower, upper = upper](double place) {
            return place == 1 ? upper : std::clamp(lower * (1 - place) + upper * place, lower, upper);
        };
        ranges[k] = {parameter(lower_[k]), parameter(lower_[k] + length_[k])};
    }
    return ranges;
}

double CrossCell::side(size_t axis, size_t end) const noexcept {
    const double shift = is_inside(axis, end) ? piece_->shift[axis] : piece_->shifts[axis][end];
    return static_cast<double>(end) + shift / length_[axis];
}

double CrossCell::room(size_t axis, size_t end) const noexcept {
    constexpr double most = widening / 2;
    return is_inside(axis, end) ? 0 : std::min(piece_->rooms[axis][end] / length_[axis], most);
}

std::optional<CrossCell::Beyond> CrossCell::beyond(size_t axis, size_t end) const {
    pieces::PieceGrid::Index next = piece_->index;
    const int k = static_cast<int>(axis);
    const int64_t n = piece_->ground->grid.count(k);
    next[axis] = (next[axis] + (end == 1 ? 1 : n - 1)) % n;
    const CrossPiece *const other = piece_->ground->piece(next);
    if (other == nullptr) {
        return std::nullopt;
    }
    const auto whole = [&](const CrossPiece &piece) {
        return piece.range[axis].upper - piece.range[axis].lower;
    };
    const double stretch = whole(*piece_) / whole(*other),
                 moved = (end == 1 ? side(axis, 1) - 1 : -side(axis, 0)) + room(axis, end),
                 wide = 1.01 * moved * length_[axis] * stretch;
    std::array<Interval, 2> places;
    places[axis] = end == 1 ? Interval{0, wide} : Interval{1 - wide, 1};
    places[1 - axis] = {lower_[1 - axis], upper_[1 - axis]};
    std::optional<Beyond> result{Beyond{CrossCell(*other, places), axis, 0}};
    result->factor = length_[axis] * stretch / result->cell.length(axis);
    return result->cell.prepare() ? std::move(result) : std::nullopt;
}

bool CrossCell::is_open(size_t axis, size_t end) const noexcept {
    return !is_inside(axis, end) && piece_->open[axis][end];
}

bool CrossCell::has_pole() const noexcept {
    bool any = false;
    for (size_t k = 0; k < 2; ++k) {
        for (size_t end = 0; end < 2; ++end) {
            any = any || (piece_->poles[k][end] && !is_inside(k, end));
        }
    }
    return any;
}

Interval CrossCell::hull_along(const Vector3 &vector) const noexcept {
    Interval hull{infinity, -infinity};
    for (size_t i = 0; i < records_.size(); i += width) {
        const double x =
            dot(vector, Vector3{records_[i], records_[i + 1], records_[i + 2]}) / records_[i + 3];
        hull = {std::min(hull.lower, x), std::max(hull.upper, x)};
    }
    return hull;
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
    const double halving = std::max(piece_->degrees[0], piece_->degrees[1]) * eps * piece_->piece.reach();
    error_ = piece_->error + (depth_ + 1) * halving;
    count_work(8 * std::ssize(records_));
}

void CrossCell::widen(const double *records, double *half, double *wide) const {
    const auto &widenings = piece_->ground->widenings;
    apply_along(widenings[0], layers_along(0, piece_->degrees), records, half);
    apply_along(widenings[1], layers_along(1, piece_->degrees), half, wide);
}

bool CrossCell::prepare() {
    if (state_ != State::unknown) {
        return state_ == State::positive;
    }
    std::vector<double> wide(records_.size());
    Scratch scratch(records_.size());
    double *const half = scratch.take(records_.size());
    const auto &[p, q] = piece_->degrees;
    widen(records_.data(), half, wide.data());
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
    set_errors();
    set_wide(wide);
    return true;
}

// Extrapolation multiplies the rounding of what it adds up by the sum of the magnitudes of its factors, which
// is 1 + 2 x for each degree, where x is how far beyond the ends it leads. In the part itself, polynomials
// with the rounded control points of the wide part are off by that rounding, and by the errors of the part as
// they were. Beyond the piece, Bernstein functions do not all have one sign.
void CrossCell::set_errors() noexcept {
    const auto &degrees = piece_->degrees;
    const int both = degrees[0] + degrees[1];
    const double rounding = 2 * (both + 2) * eps * piece_->piece.reach() * weights_.upper / weights_.lower;
    wide_error_ = std::max(2 * error_, error_ + rounding * std::pow(1 + 2 * widening, both));
    double sum = 1;
    for (size_t k = 0; k < 2; ++k) {
        const double room = widening * length_[k],
                     far = std::max({0.0, room - lower_[k], upper_[k] + room - 1});
        sum *= std::pow(1 + 2 * far, degrees[k]);
    }
    amplified_ = 1 + (sum - 1) * piece_->largest_weight / weights_.lower;
}

// The records (w x, w) become (w (x - centre), w).
void CrossCell::set_wide(std::vector<double> &records) {
    constexpr std::array<double, 2> middle{0.5, 0.5};
    const CrossPiece::Point point = piece_->evaluate(in_piece(middle.data()));
    centre_ = point.at;
    slope_ = {length_[0] * point.slope[0], length_[1] * point.slope[1]};
    const std::array<double, 2> turns{length_[0] * point.turn[0], length_[1] * point.turn[1]};
    wide_.resize(records.size() / width * 9);
    for (size_t i = 0; i < records.size() / width; ++i) {
        double *record = records.data() + width * i;
        const Vector3 a{record[0] - record[3] * centre_.x, record[1] - record[3] * centre_.y,
                        record[2] - record[3] * centre_.z};
        record[0] = a.x;
        record[1] = a.y;
        record[2] = a.z;
        const Vector3 from = (1 / record[3]) * a;
        wide_[3 * i] = from.x;
        wide_[3 * i + 1] = from.y;
        wide_[3 * i + 2] = from.z;
        reach_ = std::max(reach_, numeric::length(from));
    }
    for (size_t k = 0; k < 2; ++k) {
        set_slopes(records, k, turns[k]);
    }
}

// The Bernstein coefficients over the wide part of (w (S - centre))_k and w_k by places in the part, where k
// is the axis; along it the degree is one less. In small parts, differences of control points have few
// correct digits; there the derivative of the whole piece is restricted to the part instead. Along each axis,
// extrapolation to the wide part amplifies errors by the largest sum of the magnitudes of its factors,
// (1 + 2 widening)^degree.
std::vector<double> CrossCell::derivatives(const std::vector<double> &records, size_t axis) {
    constexpr double small = 0x1p-4;
    std::array<int, 2> degrees = piece_->degrees;
    const AxisLayers layers = layers_along(axis, degrees);
    const double amplified =
        4 * layers.degree * std::pow(1 + 2 * widening, degrees[0] + degrees[1]) / weights_.lower;
    if (length_[axis] > small) {
        slope_errors_[axis] = amplified * weights_.upper * error_;
        return derivative(layers, layers.degree / (1 + 2 * widening), records.data());
    }
    slope_errors_[axis] = amplified * piece_->largest_weight * piece_->error * length_[axis];
    std::vector<double> values = derivative(layers, layers.degree * length_[axis], piece_->piece.record(0)),
                        part(values.size());
    --degrees[axis];
    for (size_t k = 0; k < 2; ++k) {
        const double room = widening * length_[k];
        apply_along(part_matrix(degrees[k], lower_[k] - room, lower_[k] + length_[k] + room),
                    layers_along(k, degrees), values.data(), part.data());
        std::swap(values, part);
    }
    for (double *by = values.data(); by < values.data() + values.size(); by += width) {
        by[0] -= by[3] * centre_.x;
        by[1] -= by[3] * centre_.y;
        by[2] -= by[3] * centre_.z;
    }
    return values;
}

// Let N = (w (S - centre))_k, with N and w_k raised to the degree of w, D = S_k in the middle, and
// r = w_k / w there. Then
//     S_k = D + (N - D w - r w (S - centre) - (S - centre) (w_k - r w)) / w.
// Kept are the coefficients of the first three terms of the numerator, and the largest |w_k - r w| (turns_).
void CrossCell::set_slopes(const std::vector<double> &records, size_t axis, double turn) {
    const AxisLayers layers = layers_along(axis, piece_->degrees);
    const auto degree = static_cast<size_t>(layers.degree), inner = static_cast<size_t>(layers.inner);
    const std::vector<double> lower = derivatives(records, axis);
    const std::array<double, width> middle{slope_[axis].x, slope_[axis].y, slope_[axis].z, turn};
    double *off = wide_.data() + (1 + axis) * (wide_.size() / 3);
    double largest_turn = 0, largest = 0;
    for (size_t at = 0; at < records.size(); at += width) {
        const size_t i = at / inner % (degree + 1), outer = at / inner / (degree + 1);
        const double *above = lower.data() + (outer * degree + i) * inner + at % inner;
        const double share = static_cast<double>(i) / static_cast<double>(degree), *own = &records[at];
        std::array<double, width> by{};
        for (size_t c = 0; c < width; ++c) {
            by[c] = (i > 0 ? share * (above - inner)[c] : 0) + (i < degree ? (1 - share) * above[c] : 0);
        }
        for (size_t c = 0; c < 3; ++c) {
            *off = by[c] - middle[c] * own[3] - turn * own[c];
            largest = std::max(largest, std::abs(*off++));
        }
        largest_turn = std::max(largest_turn, std::abs(by[3] - turn * own[3]));
    }
    turns_[axis] = 1.0001 * largest_turn;
    const double length = numeric::length(slope_[axis]);
    bends_[axis] = (largest + reach_ * turns_[axis]) / weights_.upper + little_bend * length;
    slope_errors_[axis] +=
        weights_.upper / weights_.lower * (16 * eps * (length + reach_) + std::abs(turn) * error_);
}

Interval CrossCell::points_along(const Vector3 &vector) const noexcept {
    Interval range{infinity, -infinity};
    const std::span<const double> points = this->points();
    for (size_t i = 0; i < points.size(); i += 3) {
        const double x = dot3(vector, &points[i]);
        range = {std::min(range.lower, x), std::max(range.upper, x)};
    }
    return range;
}

CrossExtents CrossCell::along(const Vector3 &vector) const noexcept {
    CrossExtents extents{points_along(vector), {}};
    const double far = std::max(std::abs(extents.points.lower), std::abs(extents.points.upper)),
                 size = numeric::length(vector);
    const double least = 1 / weights_.upper, most = 1 / weights_.lower;
    for (size_t k = 0; k < 2; ++k) {
        Interval range{infinity, -infinity};
        const std::span<const double> slopes = this->slopes(k);
        for (size_t i = 0; i < slopes.size(); i += 3) {
            const double x = dot3(vector, &slopes[i]);
            range = {std::min(range.lower, x), std::max(range.upper, x)};
        }
        range = {range.lower - far * turns_[k], range.upper + far * turns_[k]};
        const double middle = dot(vector, slope_[k]), room = size * slope_errors_[k];
        extents.slopes[k] = {middle + range.lower * (range.lower < 0 ? most : least) - room,
                             middle + range.upper * (range.upper < 0 ? least : most) + room};
    }
    return extents;
}

double CrossCell::largest_slope(size_t axis) const noexcept {
    double most = 0;
    const std::span<const double> slopes = this->slopes(axis);
    for (size_t i = 0; i < slopes.size(); i += 3) {
        most = std::max(most, norm(&slopes[i], 3));
    }
    return 1.0001 * (numeric::length(slope_[axis]) + (most + reach_ * turns_[axis]) / weights_.lower +
                     slope_errors_[axis]);
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

CrossCell::Halves CrossCell::halves(std::deque<CrossCell> &all, std::optional<size_t> along) {
    if (!along && !usual_axis_) {
        usual_axis_ = axis_of_halves();
    }
    const size_t axis = along ? *along : *usual_axis_;
    Halves &halves = halves_[axis];
    if (halves[0] != nullptr || piece_->degrees[axis] == 0 || length_[axis] <= least_length_of_parts) {
        return halves;
    }
    const AxisLayers layers = layers_along(axis, piece_->degrees);
    count_work(work_of_halves);
    std::pmr::vector<double> upper(records_, records_.get_allocator()),
        lower(records_.size(), records_.get_allocator());
    subdivide(layers, place_of_halves, upper.data(), lower.data());
    halves[1] = &all.emplace_back(*this, axis, 1, std::move(upper));
    halves[0] = &all.emplace_back(*this, axis, 0, std::move(lower));
    return halves;
}

CrossCell *CrossCell::part(std::deque<CrossCell> &all, const std::array<Interval, 2> &places) const {
    constexpr double largest_shift = 0x1p-14; // far less than the empty margins at the sides
    std::pmr::vector<double> records(records_, records_.get_allocator());
    std::vector<double> whole(records_.size());
    for (size_t k = 0; k < 2; ++k) {
        const auto [lower, upper] = places[k];
        if (!((upper - lower) * length_[k] > least_length_of_parts) ||
            !(piece_->shift[k] <= largest_shift * length_[k])) {
            return nullptr;
        }
        if (lower > 0 || upper < 1) {
            std::ranges::copy(records, whole.begin());
            apply_along(part_matrix(piece_->degrees[k], lower, upper), layers_along(k, piece_->degrees),
                        whole.data(), records.data());
        }
    }
    return &all.emplace_back(*this, places, std::move(records));
}

} // namespace nrb::intersect
