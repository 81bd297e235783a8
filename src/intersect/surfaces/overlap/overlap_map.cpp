// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_map.h"

#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::intersect {

namespace {

constexpr std::array<double, 4> cubic_places{0, 0.25, 0.75, 1};
constexpr double farthest_beyond = 0.9; // in lengths of the piece of B
constexpr double most_rho = 0.9;
constexpr int most_samples = 16384;
constexpr double least_side = 0x1p-30;

std::array<double, 4> homogeneous(const CrossPiece &piece, const std::array<double, 2> &place) noexcept {
    std::array<std::array<double, max_degree + 1>, 2> b;
    for (size_t k = 0; k < 2; ++k) {
        bernstein_functions(piece.degrees[k], place[k], b[k].data());
    }
    std::array<double, 4> value{};
    const double *record = piece.piece.record(0);
    for (int i = 0; i <= piece.degrees[0]; ++i) {
        std::array<double, 4> row{};
        for (int j = 0; j <= piece.degrees[1]; ++j, record += 4) {
            for (size_t c = 0; c < 4; ++c) {
                row[c] += b[1][static_cast<size_t>(j)] * record[c];
            }
        }
        for (size_t c = 0; c < 4; ++c) {
            value[c] += b[0][static_cast<size_t>(i)] * row[c];
        }
    }
    return value;
}

// The inverse of a matrix [4][4], by elimination without pivoting.
std::array<double, 16> inverse_of(std::array<double, 16> m) noexcept {
    std::array<double, 16> result{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (size_t k = 0; k < 4; ++k) {
        const double pivot = m[4 * k + k];
        for (size_t j = 0; j < 4; ++j) {
            m[4 * k + j] /= pivot;
            result[4 * k + j] /= pivot;
        }
        for (size_t i = 0; i < 4; ++i) {
            const double factor = i == k ? 0 : m[4 * i + k];
            for (size_t j = 0; j < 4; ++j) {
                m[4 * i + j] -= factor * m[4 * k + j];
                result[4 * i + j] -= factor * result[4 * k + j];
            }
        }
    }
    return result;
}

Interval hull_of(const Interval &a, const Interval &b) noexcept {
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

} // namespace

OverlapMap::OverlapMap(double tolerance) : tolerance_(tolerance) {
    std::array<double, 16> functions{};
    for (size_t i = 0; i < 4; ++i) {
        bernstein_functions(3, cubic_places[i], functions.data() + 4 * i);
    }
    inverse_ = inverse_of(functions);
}

std::array<double, 2> OverlapMap::place_on_a(const std::array<double, 2> &at) const noexcept {
    return {part_[0].lower + at[0] * (part_[0].upper - part_[0].lower),
            part_[1].lower + at[1] * (part_[1].upper - part_[1].lower)};
}

// Newton's method for the place on B whose point differs from `of` by a multiple of the normal.
bool OverlapMap::find_foot(const Vector3 &of, const Vector3 &normal, std::array<double, 2> &place) const {
    constexpr int most_steps = 12;
    for (int i = 0; i < most_steps; ++i) {
        count_work(8 * b_->piece.coefficients());
        const CrossPiece::Point at = b_->evaluate(place);
        const Vector3 away = of - at.at;
        const double determinant = dot(cross(at.slope[0], at.slope[1]), normal);
        const std::array<double, 2> by{dot(cross(away, at.slope[1]), normal) / determinant,
                                       dot(cross(at.slope[0], away), normal) / determinant};
        place[0] += by[0];
        place[1] += by[1];
        if (!(std::abs(place[0] - 0.5) <= 1.5 && std::abs(place[1] - 0.5) <= 1.5)) {
            return false;
        }
        if (std::max(std::abs(by[0]), std::abs(by[1])) <= 0x1p-46) {
            return true;
        }
    }
    return false;
}

bool OverlapMap::interpolate(int degree, std::array<double, 2> start) {
    degree_ = degree;
    const auto n = static_cast<size_t>(degree) + 1;
    const CrossPiece::Point near = b_->evaluate(start);
    Vector3 normal = cross(near.slope[0], near.slope[1]);
    if (!find_foot(a_->evaluate(place_on_a({0.5, 0.5})).at, normal, start)) {
        return false;
    }
    const CrossPiece::Point middle = b_->evaluate(start);
    normal = cross(middle.slope[0], middle.slope[1]);
    std::array<std::array<double, 16>, 2> values{};
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            const std::array<double, 2> at = degree == 1
                                                 ? std::array<double, 2>{double(i), double(j)}
                                                 : std::array<double, 2>{cubic_places[i], cubic_places[j]};
            std::array<double, 2> place = start;
            if (!find_foot(a_->evaluate(place_on_a(at)).at, normal, place)) {
                return false;
            }
            values[0][i * n + j] = place[0];
            values[1][i * n + j] = place[1];
        }
    }
    psi_ = values;
    for (size_t k = 0; k < 2 && degree == 3; ++k) {
        for (size_t i = 0; i < 4; ++i) {
            for (size_t j = 0; j < 4; ++j) {
                double sum = 0;
                for (size_t r = 0; r < 16; ++r) {
                    sum += inverse_[4 * i + r / 4] * inverse_[4 * j + r % 4] * values[k][r];
                }
                psi_[k][4 * i + j] = sum;
            }
        }
    }
    for (size_t k = 0; k < 2; ++k) {
        const auto [least, most] = std::minmax_element(psi_[k].begin(), psi_[k].begin() + n * n);
        hull_[k] = {*least, *most};
    }
    return true;
}

std::array<double, 2> OverlapMap::foot(const std::array<double, 2> &at) const {
    const auto n = static_cast<size_t>(degree_) + 1;
    std::array<std::array<double, 4>, 2> b;
    for (size_t k = 0; k < 2; ++k) {
        bernstein_functions(degree_, at[k], b[k].data());
    }
    std::array<double, 2> place{};
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            const double f = b[0][i] * b[1][j];
            place[0] += f * psi_[0][i * n + j];
            place[1] += f * psi_[1][i * n + j];
        }
    }
    return place;
}

// Sets M, n and rho on the box that contains psi and `with`; false: B does not contract there.
bool OverlapMap::set_chart(const PlaceBox *with) {
    PlaceBox box;
    double beyond = 0;
    for (size_t k = 0; k < 2; ++k) {
        box[k] = with == nullptr ? hull_[k] : hull_of(hull_[k], (*with)[k]);
        const double middle = box[k].lower / 2 + box[k].upper / 2;
        box[k] = hull_of(box[k], {middle - least_side, middle + least_side});
        lengths_[k] = box[k].upper - box[k].lower;
        beyond = std::max({beyond, -box[k].lower, box[k].upper - 1});
    }
    if (!(beyond <= farthest_beyond)) {
        return false;
    }
    CrossCell cell(*b_, box);
    count_work(8 * b_->piece.coefficients() * (b_->degrees[0] + b_->degrees[1] + 8));
    if (!cell.prepare()) {
        return false;
    }
    const Vector3 u = cell.slope(0), v = cell.slope(1), across = cross(u, v);
    const double size = dot(across, across);
    if (!(size > 0)) {
        return false;
    }
    rows_ = {(1 / size) * cross(v, across), (1 / size) * cross(across, u)};
    normal_ = (1 / std::sqrt(size)) * across;
    rho_ = 0;
    for (size_t i = 0; i < 2; ++i) {
        const CrossExtents extents = cell.along(rows_[i]);
        double sum = 0;
        for (size_t k = 0; k < 2; ++k) {
            const double one = i == k ? 1 : 0;
            sum += std::max(std::abs(extents.slopes[k].lower - one), std::abs(extents.slopes[k].upper - one));
        }
        rho_ = std::max(rho_, 1.001 * sum);
    }
    const CrossExtents heights = cell.along(normal_);
    for (size_t k = 0; k < 2; ++k) {
        slopes_[k] = std::max(std::abs(heights.slopes[k].lower), std::abs(heights.slopes[k].upper));
    }
    weight_of_b_ = cell.least_weight();
    beyond_ = std::pow(1 + 2 * (beyond + widening), b_->degrees[0] + b_->degrees[1]);
    return rho_ <= most_rho;
}

// Updates the largest components of F = A - B(psi) times both weights with those at one place of A.
void OverlapMap::add_gap(const Homogeneous &a, const std::array<double, 2> &foot, Gap &gap) const {
    const Homogeneous b = homogeneous(*b_, foot);
    const Vector3 away{b[3] * a[0] - a[3] * b[0], b[3] * a[1] - a[3] * b[1], b[3] * a[2] - a[3] * b[2]};
    gap.across[0] = std::max(gap.across[0], std::abs(dot(rows_[0], away)));
    gap.across[1] = std::max(gap.across[1], std::abs(dot(rows_[1], away)));
    gap.height = std::max(gap.height, std::abs(dot(normal_, away)));
    count_work(4 * b_->piece.coefficients() + 20);
}

// A lower estimate from a few places, which saves most samplings that would fail.
OverlapMap::Gap OverlapMap::estimate() const {
    Gap gap;
    for (const double u : {0.13, 0.5, 0.81}) {
        for (const double v : {0.17, 0.5, 0.85}) {
            add_gap(homogeneous(*a_, place_on_a({u, v})), foot({u, v}), gap);
        }
    }
    return gap;
}

std::array<int, 2> OverlapMap::degrees_of_gap() const noexcept {
    const int of_b = degree_ * (b_->degrees[0] + b_->degrees[1]);
    return {a_->degrees[0] + of_b, a_->degrees[1] + of_b};
}

bool OverlapMap::can_be_sampled() const noexcept {
    const auto [m, n] = degrees_of_gap();
    return (2 * m + 1) * (2 * n + 1) <= most_samples;
}

// Bounds from the largest values at samples. factor: by how much values may be larger elsewhere, divided by
// the weights.
void OverlapMap::set_bounds(const Gap &gap, double factor, double noise) {
    double across = 0;
    for (size_t i = 0; i < 2; ++i) {
        across = std::max(across, factor * gap.across[i] + length(rows_[i]) * noise);
    }
    off_ = across / (1 - rho_);
    height_ = 1.01 * (factor * gap.height + noise + off_ * (slopes_[0] + slopes_[1]));
    for (size_t k = 0; k < 2; ++k) {
        const double room = off_ * lengths_[k] + 64 * eps;
        feet_[k] = {hull_[k].lower - room, hull_[k].upper + room};
    }
}

OverlapMap::Verdict OverlapMap::verdict(const PlaceBox *with) {
    if (!(off_ <= widening / 2)) {
        return Verdict::open;
    }
    if (with != nullptr && !have_common(feet_, *with)) {
        return Verdict::beside;
    }
    if (height_ <= tolerance_) {
        return Verdict::along;
    }
    return with != nullptr && set_side(*with) ? Verdict::touching : Verdict::open;
}

namespace {

// Bernstein functions [2 n + 1][degree + 1] at the Chebyshev points of a range.
std::vector<double> functions_at_samples(int n, int degree, const Interval &range) {
    const auto order = static_cast<size_t>(degree) + 1;
    std::vector<double> functions(static_cast<size_t>(2 * n + 1) * order);
    for (int i = 0; i <= 2 * n; ++i) {
        const double at = (1 - std::cos(std::numbers::pi * i / (2 * n))) / 2;
        bernstein_functions(degree, range.lower + at * (range.upper - range.lower),
                            functions.data() + static_cast<size_t>(i) * order);
    }
    return functions;
}

// The sum of layers of `inner` values each, times functions.
void add_layers(const double *functions, size_t order, const double *layers, size_t inner,
                double *sum) noexcept {
    std::fill_n(sum, inner, 0.0);
    for (size_t i = 0; i < order; ++i) {
        for (size_t c = 0; c < inner; ++c) {
            sum[c] += functions[i] * layers[i * inner + c];
        }
    }
}

} // namespace

// The verdict after each row of samples. Bounds only grow from row to row, so that the first open one is
// final.
OverlapMap::Verdict OverlapMap::verdict_of_samples(const PlaceBox *with) {
    const auto [m, n] = degrees_of_gap();
    const auto p = static_cast<size_t>(a_->degrees[0]) + 1, q = static_cast<size_t>(a_->degrees[1]) + 1,
               r = static_cast<size_t>(degree_) + 1;
    const Interval unit{0, 1};
    const std::vector<double> of_a_u = functions_at_samples(m, a_->degrees[0], part_[0]),
                              of_a_v = functions_at_samples(n, a_->degrees[1], part_[1]),
                              of_foot_u = functions_at_samples(m, degree_, unit),
                              of_foot_v = functions_at_samples(n, degree_, unit);
    const double weights = weight_of_a_ * weight_of_b_,
                 noise = 8 * (a_->error + beyond_ * b_->error + 32 * eps) *
                         (a_->largest_weight * b_->largest_weight * beyond_) / weights;
    std::array<double, 4 * (max_degree + 1)> row;
    std::array<std::array<double, 4>, 2> foot_row;
    Gap gap;
    Verdict result = Verdict::open;
    for (size_t i = 0; i <= 2 * static_cast<size_t>(m); ++i) {
        add_layers(&of_a_u[i * p], p, a_->piece.record(0), 4 * q, row.data());
        for (size_t k = 0; k < 2; ++k) {
            add_layers(&of_foot_u[i * r], r, psi_[k].data(), r, foot_row[k].data());
        }
        for (size_t j = 0; j <= 2 * static_cast<size_t>(n); ++j) {
            Homogeneous a;
            std::array<double, 2> foot;
            add_layers(&of_a_v[j * q], q, row.data(), 4, a.data());
            for (size_t k = 0; k < 2; ++k) {
                add_layers(&of_foot_v[j * r], r, foot_row[k].data(), 1, &foot[k]);
            }
            add_gap(a, foot, gap);
        }
        set_bounds(gap, 2.02 / weights, noise);
        result = verdict(with);
        if (result == Verdict::open) {
            break;
        }
    }
    return result;
}

// Bounds over small parts of the piece are far closer than those over all of it.
const std::array<double, 2> &OverlapMap::speeds_of(const CrossPiece &piece) {
    constexpr int parts = 4;
    const auto [known, made] = speeds_.try_emplace(&piece);
    const auto range = [](int i) { return Interval{double(i) / parts, double(i + 1) / parts}; };
    for (int i = 0; i < parts * parts && made; ++i) {
        CrossCell cell(piece, {range(i / parts), range(i % parts)});
        count_work(8 * piece.piece.coefficients() * (piece.degrees[0] + piece.degrees[1] + 8));
        const bool bounded = cell.prepare();
        for (size_t k = 0; k < 2; ++k) {
            const double own = bounded ? cell.largest_slope(k) / cell.length(k) : infinity;
            known->second[k] = std::max(known->second[k], own);
        }
    }
    return known->second;
}

double OverlapMap::room_on(const CrossPiece &piece, size_t axis, double near) {
    constexpr double most = 0x1p-8; // the speeds hold for more, 1/32
    return std::min(near / (8 * std::max(speeds_of(piece)[axis], eps)), most);
}

bool OverlapMap::set_side(const PlaceBox &with) {
    for (size_t k = 0; k < 2; ++k) {
        const double room = room_on(*b_, k, 4 * tolerance_);
        for (size_t end = 0; end < 2; ++end) {
            if (end == 0 ? feet_[k].upper <= with[k].lower + room : feet_[k].lower >= with[k].upper - room) {
                side_ = {k, end};
                return true;
            }
        }
    }
    return false;
}

OverlapMap::Verdict OverlapMap::look(const CrossPiece &a, const PlaceBox &part, const CrossPiece &b,
                                     const std::array<double, 2> &start, const PlaceBox *with) {
    a_ = &a;
    b_ = &b;
    part_ = part;
    CrossCell cell(a, part);
    count_work(8 * a.piece.coefficients() * (a.degrees[0] + a.degrees[1] + 8));
    if (!cell.prepare() || b.degrees[0] == 0 || b.degrees[1] == 0) {
        return Verdict::open;
    }
    weight_of_a_ = cell.least_weight();
    for (const int degree : {1, 3}) {
        if (!interpolate(degree, start) || !set_chart(with)) {
            return Verdict::open;
        }
        set_bounds(estimate(), 1 / (a.largest_weight * b.largest_weight), 0);
        if (!can_be_sampled() || verdict(with) == Verdict::open) {
            continue;
        }
        const Verdict result = verdict_of_samples(with);
        if (result != Verdict::open) {
            return result;
        }
    }
    return Verdict::open;
}

} // namespace nrb::intersect
