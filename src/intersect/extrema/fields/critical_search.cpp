// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/critical_search.h"

#include "base/watch.h"
#include "intersect/extrema/fields/box_groups.h"
#include "intersect/extrema/fields/signature.h"
#include "numeric/power_of_two.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr size_t most_cells = 4096; // of one piece
constexpr double least_length = 0x1p-30;
constexpr int64_t work_of_a_cell = 1000, work_of_a_proof = 20000;

} // namespace

template <size_t N>
CriticalSearch<N>::CriticalSearch(const GradientField &field, const Stratum &stratum)
    : field_(field), stratum_(stratum) {
    size_t n = 0;
    for (int k = 0; k < field.axes(); ++k) {
        if (!stratum.is_fixed(k)) {
            free_[n++] = k;
        }
    }
}

template <size_t N>
void CriticalSearch<N>::run(const PieceIndex &index, CriticalPlaces &out) {
    out_ = &out;
    index_ = index;
    home_ = field_.piece(index);
    if (!home_->piece.positive || work_ended()) {
        leave({{{0, 1}, {0, 1}, {0, 1}}});
    } else if (start()) {
        while (next_ < cells_.size()) {
            Cell cell = std::move(cells_[next_++]);
            look(cell);
        }
    }
    gather();
}

// False where a derivative has a sign all over the piece.
template <size_t N>
bool CriticalSearch<N>::start() {
    cells_.clear();
    next_ = 0;
    unique_.clear();
    divided_ = false;
    Cell whole{{}, {{{0, 1}, {0, 1}, {0, 1}}}};
    const ConstantLayers constants = field_.constants(index_, stratum_.sides());
    for (size_t j = 0; j < N; ++j) {
        const int k = free_[j];
        RoundedPolynomial slope =
            on_stratum(home_->slopes[static_cast<size_t>(k)], home_->piece, stratum_, field_.axes());
        for (const int l : free_) {
            for (const bool upper : {false, true}) {
                const int layers = constants.layers[static_cast<size_t>(l)][upper ? 1 : 0],
                          zeros = ends_there(l, upper) ? std::max(k == l ? layers - 1 : layers, 0) : 0;
                set_zero(slope, home_->piece.axis(l), upper, zeros);
                divided_ = divide_end(slope, home_->piece.axis(l), upper, zeros) != 0 || divided_;
            }
        }
        if (certain_sign(slope) != 0) {
            return false;
        }
        whole.slopes[j] = std::move(slope);
    }
    cells_.push_back(std::move(whole));
    return true;
}

template <size_t N>
void CriticalSearch<N>::look(Cell &cell) {
    count_work(work_of_a_cell);
    const bool none =
        std::ranges::any_of(cell.slopes, [](const RoundedPolynomial &f) { return certain_sign(f) != 0; }) ||
        std::ranges::any_of(unique_,
                            [&](const Part &whole) { return contains(whole, cell.box, field_.axes()); });
    if (none) {
        return;
    }
    if (may_be_single(cell)) {
        CriticalPlace place;
        switch (judge(cell.box, place)) {
        case Verdict::open:
            break;
        case Verdict::one:
            unique_.push_back(place.unique);
            out_->found.push_back(place);
            return;
        case Verdict::at_border:
            leave(place.core);
            return;
        case Verdict::none:
            return;
        }
    }
    double longest = 0;
    for (const int k : free_) {
        const Interval x = cell.box[static_cast<size_t>(k)];
        longest = std::max(longest, x.upper - x.lower);
    }
    if (cells_.size() >= most_cells || longest < least_length || work_ended()) {
        leave(cell.box);
    } else {
        halve(cell);
    }
}

// A quick look at what judge() proves.
template <size_t N>
bool CriticalSearch<N>::may_be_single(const Cell &cell) const {
    if (divided_) {
        return true;
    }
    IntervalMatrix<N> slopes{};
    for (size_t i = 0; i < N; ++i) {
        for (size_t j = 0; j < N; ++j) {
            const RoundedPolynomial second = derivative(cell.slopes[i], home_->piece.axis(free_[j]));
            const auto [lower, upper] = std::ranges::minmax(second.values);
            slopes[i][j] = {lower, upper};
        }
    }
    return Krawczyk<N>{}(slopes);
}

template <size_t N>
typename CriticalSearch<N>::Verdict CriticalSearch<N>::judge(const Part &box, CriticalPlace &place) {
    count_work(work_of_a_proof);
    const Part wide = widened(box);
    const auto parts = covered(field_, stratum_, index_, wide);
    Krawczyk<N> krawczyk;
    if (!parts || !krawczyk(second_derivatives(*parts))) {
        return Verdict::open;
    }
    return verdict_at(krawczyk, box, wide, place);
}

// All zeros in the wide box are in the core, and there is one if z - M F(z) maps what is around z into itself.
template <size_t N>
typename CriticalSearch<N>::Verdict CriticalSearch<N>::verdict_at(const Krawczyk<N> &krawczyk,
                                                                  const Part &box, const Part &wide,
                                                                  CriticalPlace &place) {
    Place<N> z{}, step{};
    double near = 0;
    for (size_t j = 0; j < N; ++j) {
        z[j] = middle(box[static_cast<size_t>(free_[j])]);
    }
    if (!steps_from(krawczyk, wide, z, step, near)) {
        return Verdict::open;
    }
    Box<N> solutions = krawczyk.contraction.solutions(z, step, near);
    const double radius = krawczyk.contraction.radius(step, near) + 64 * eps;
    bool around = true, inside = true, apart = false, outside = false;
    for (size_t j = 0; j < N; ++j) {
        const auto k = static_cast<size_t>(free_[j]);
        Interval &x = solutions[j];
        x = {x.lower - 64 * eps, x.upper + 64 * eps};
        const bool from = goes_on(j, false), to = goes_on(j, true);
        around = around && (!from || z[j] - radius > wide[k].lower) && (!to || z[j] + radius < wide[k].upper);
        inside = inside && (from || x.lower > 0) && (to || x.upper < 1);
        outside = outside || x.upper < wide[k].lower || x.lower > wide[k].upper;
        apart = apart || x.upper < box[k].lower || x.lower > box[k].upper;
    }
    if (outside || apart) {
        return Verdict::none;
    }
    if (!around) {
        return Verdict::open;
    }
    place.home = index_;
    place.core = part_of(solutions);
    place.unique = wide;
    for (size_t j = 0; j < N; ++j) {
        place.at[static_cast<size_t>(free_[j])] = z[j];
    }
    if (!inside) {
        bool small = true;
        for (const int k : free_) {
            Interval &x = place.core[static_cast<size_t>(k)];
            x = {std::max(x.lower, 0.0), std::min(x.upper, 1.0)};
            small = small && x.upper - x.lower < least_length;
        }
        return small ? Verdict::at_border
                     : Verdict::open; // halves may be apart from what lies beyond the border
    }
    return verdict_in(box, place);
}

// What is known of the only zero, which is in the core.
template <size_t N>
typename CriticalSearch<N>::Verdict CriticalSearch<N>::verdict_in(const Part &box, CriticalPlace &place) {
    while (narrow(place)) {
    }
    for (const int k : free_) {
        const Interval x = place.core[static_cast<size_t>(k)], whole = box[static_cast<size_t>(k)];
        if (x.upper < whole.lower || x.lower > whole.upper) {
            return Verdict::none;
        }
        if (x.upper - x.lower > least_length) {
            return Verdict::open;
        }
    }
    const auto parts = covered(field_, stratum_, index_, place.core);
    if (!parts) {
        return Verdict::open;
    }
    const IntervalMatrix<N> second = second_derivatives(*parts);
    place.kinds = signature(second.front().data(), N, true);
    return Verdict::one;
}

// Whether the core is less than half as large as before.
template <size_t N>
bool CriticalSearch<N>::narrow(CriticalPlace &place) {
    count_work(work_of_a_proof);
    const auto parts = covered(field_, stratum_, index_, place.core);
    Krawczyk<N> krawczyk;
    Place<N> z{}, step{};
    double near = 0;
    for (size_t j = 0; j < N; ++j) {
        z[j] = middle(place.core[static_cast<size_t>(free_[j])]);
    }
    if (!parts || !krawczyk(second_derivatives(*parts)) || !steps_from(krawczyk, place.core, z, step, near)) {
        return false;
    }
    const Box<N> solutions = krawczyk.contraction.solutions(z, step, near);
    double before = 0, after = 0;
    for (size_t j = 0; j < N; ++j) {
        Interval &x = place.core[static_cast<size_t>(free_[j])];
        before = std::max(before, x.upper - x.lower);
        x = {std::max(x.lower, solutions[j].lower - 64 * eps),
             std::min(x.upper, solutions[j].upper + 64 * eps)};
        after = std::max(after, x.upper - x.lower);
        place.at[static_cast<size_t>(free_[j])] = z[j];
    }
    return after < before / 2;
}

// Whether what is constant at an end of the piece is a stratum of its own or part of a plateau beyond, so that its zeros need
// not be found here.
template <size_t N>
bool CriticalSearch<N>::ends_there(int k, bool upper) const {
    const int64_t joint = index_[static_cast<size_t>(k)] + (upper ? 1 : 0);
    if (field_.joint(k, joint) != JointKind::smooth) {
        return true;
    }
    PieceIndex beyond = index_;
    beyond[static_cast<size_t>(k)] = field_.beside(k, joint, upper);
    return field_.constants(beyond, stratum_.sides()).all;
}

// Whether smooth pieces follow.
template <size_t N>
bool CriticalSearch<N>::goes_on(size_t j, bool upper) const {
    const int k = free_[j];
    return field_.joint(k, index_[static_cast<size_t>(k)] + (upper ? 1 : 0)) == JointKind::smooth;
}

// By a quarter on either side, but not beyond joints that are not smooth. Inside of a piece it ends nowhere: there the box
// is bounded as if the piece went on.
template <size_t N>
Part CriticalSearch<N>::widened(const Part &box) const {
    Part wide = box;
    for (size_t j = 0; j < N; ++j) {
        Interval &x = wide[static_cast<size_t>(free_[j])];
        const double more = (x.upper - x.lower) / 4;
        x.lower = goes_on(j, false) ? x.lower - more : std::max(x.lower - more, 0.0);
        x.upper = goes_on(j, true) ? x.upper + more : std::min(x.upper + more, 1.0);
    }
    return wide;
}

template <size_t N>
IntervalMatrix<N> CriticalSearch<N>::second_derivatives(const std::vector<CoveredPart> &parts) const {
    IntervalMatrix<N> matrix{};
    for (size_t i = 0; i < N; ++i) {
        for (size_t j = 0; j < N; ++j) {
            matrix[i][j] = nothing;
            for (const CoveredPart &part : parts) {
                const auto k = static_cast<size_t>(free_[i]), l = static_cast<size_t>(free_[j]);
                const RoundedPolynomial slope =
                    on_stratum(part.piece->slopes[k], part.piece->piece, stratum_, field_.axes());
                const Interval range = range_over(derivative(slope, part.piece->piece.axis(free_[j])), part,
                                                  stratum_, field_.axes());
                const double factor = times_power_of_two(part.scale[k] * part.scale[l], part.exponent);
                const auto wide = [&](double x, double sign) {
                    return factor * x + sign * 16 * eps * std::abs(factor * x);
                };
                matrix[i][j] = hull(matrix[i][j], {wide(range.lower, -1), wide(range.upper, 1)});
            }
        }
    }
    return matrix;
}

// By steps M F from z until rounding stops them or they leave the wide box.
template <size_t N>
bool CriticalSearch<N>::steps_from(const Krawczyk<N> &krawczyk, const Part &wide, Place<N> &z, Place<N> &step,
                                   double &near) const {
    double last = infinity;
    for (int i = 0; i < 60; ++i) {
        if (!step_at(krawczyk, z, step, near)) {
            return false;
        }
        const double size = largest<N>(step);
        Place<N> next = z;
        for (size_t j = 0; j < N; ++j) {
            const Interval x = wide[static_cast<size_t>(free_[j])];
            next[j] = std::clamp(z[j] - step[j], x.lower, x.upper);
        }
        if (size <= 2 * eps || !(size < 0.95 * last) || next == z) {
            return true;
        }
        last = size;
        z = next;
    }
    return step_at(krawczyk, z, step, near);
}

template <size_t N>
bool CriticalSearch<N>::step_at(const Krawczyk<N> &krawczyk, const Place<N> &z, Place<N> &step,
                                double &near) const {
    Box<N> point{};
    for (size_t j = 0; j < N; ++j) {
        point[j] = {z[j], z[j]};
    }
    const auto parts = covered(field_, stratum_, index_, part_of(point));
    if (!parts) {
        return false;
    }
    const CoveredPart &part = parts->front();
    Place<N> f{};
    near = 0;
    for (size_t i = 0; i < N; ++i) {
        const auto k = static_cast<size_t>(free_[i]);
        RoundedPolynomial slope =
            on_stratum(part.piece->slopes[k], part.piece->piece, stratum_, field_.axes());
        for (const int l : free_) {
            slope = value_at(std::move(slope), part.piece->piece.axis(l),
                             middle(part.box[static_cast<size_t>(l)]));
        }
        const double factor = times_power_of_two(part.scale[k], part.exponent);
        f[i] = factor * slope.values[0];
        near = std::max(near, std::abs(factor) * slope.error(0) + 16 * eps * std::abs(f[i]));
    }
    for (size_t i = 0; i < N; ++i) {
        step[i] = 0;
        for (size_t j = 0; j < N; ++j) {
            step[i] += krawczyk.inverse[i][j] * f[j];
        }
    }
    return std::isfinite(largest<N>(step));
}

template <size_t N>
Part CriticalSearch<N>::part_of(const Box<N> &box) const {
    Part part{};
    for (size_t j = 0; j < N; ++j) {
        part[static_cast<size_t>(free_[j])] = box[j];
    }
    return part;
}

// Along the longest axis.
template <size_t N>
void CriticalSearch<N>::halve(Cell &cell) {
    const auto longer = [&](int k, int l) {
        const Interval x = cell.box[static_cast<size_t>(k)], y = cell.box[static_cast<size_t>(l)];
        return x.upper - x.lower < y.upper - y.lower;
    };
    const int k = *std::ranges::max_element(free_, longer);
    Interval &x = cell.box[static_cast<size_t>(k)];
    Cell lower{{}, cell.box};
    lower.box[static_cast<size_t>(k)].upper = x.lower = middle(x);
    for (size_t j = 0; j < N; ++j) {
        lower.slopes[j] = split(cell.slopes[j], home_->piece.axis(k));
    }
    cells_.push_back(std::move(lower));
    cells_.push_back(std::move(cell));
}

// A part of the piece, in its own coordinates, is left open.
template <size_t N>
void CriticalSearch<N>::leave(const Part &box) {
    left_.push_back(range_of(field_, stratum_, index_, box));
}

template <size_t N>
void CriticalSearch<N>::gather() {
    const std::vector<Part> groups = grouped(std::move(left_), field_.axes());
    out_->open.insert(out_->open.end(), groups.begin(), groups.end());
    left_.clear();
}

template class CriticalSearch<1>;
template class CriticalSearch<2>;
template class CriticalSearch<3>;

} // namespace nrb::intersect
