// SPDX-License-Identifier: MIT
#include "closest/patch/patch_proof.h"

#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

PatchProof::PatchProof(const PieceGrid &pieces, const PatchDescent &descent, const PatchItem &item,
                       const PatchGoal &goal, const PatchGap &gap)
    : pieces_(pieces), shape_(pieces.shape()), descent_(descent), item_(item), goal_(goal), gap_(gap) {
    const double size = item.reach * item.reach + goal.rho * goal.rho;
    error_ = 1.05 * pieces.product_error() * size * item.most_weight * item.most_weight;
    face_.fill(-1);
    int64_t step = 1;
    for (int k = shape_.axes; k-- > 0; step *= 2 * shape_.degree(k) + 1) {
        step_[static_cast<size_t>(k)] = step;
    }
}

// A coefficient of |Q|^2 is within product_error() reach^2 times that of w^2, which in turn has a relative
// error of at most product_error().
bool PatchProof::positive() noexcept {
    const double size = item_.reach * item_.reach + goal_.rho * goal_.rho;
    return pieces::gap_coefficients(shape_.products(), gap_.squares, gap_.weights, goal_.sign,
                                    goal_.rho * goal_.rho, 1.1 * pieces_.product_error() * size,
                                    gap_.values) >= 0;
}

bool PatchProof::flat(double by) const noexcept {
    const double bound = goal_.rho * by * item_.least_weight * item_.least_weight;
    const int64_t count = shape_.products();
    return std::all_of(gap_.values, gap_.values + count, [&](double g) { return std::abs(g) <= bound; });
}

// Visits the coefficients on the face, leaving out the last shrink[k] along each axis.
template <class Visit>
void PatchProof::for_face(const std::array<int, max_axes> &shrink, Visit &&visit) const noexcept {
    std::array<int64_t, max_axes> first{}, end{1, 1, 1}, step{};
    for (int k = 0; k < shape_.axes; ++k) { // so that the last axis is innermost
        const auto at = static_cast<size_t>(k), place = at + max_axes - static_cast<size_t>(shape_.axes);
        const int64_t n = 2 * shape_.degree(k);
        step[place] = step_[at];
        first[place] = face_[at] == 1 ? n : 0;
        end[place] = face_[at] == 0 ? 1 : n + 1 - shrink[at];
    }
    for (int64_t i = first[0]; i < end[0]; ++i) {
        for (int64_t j = first[1]; j < end[1]; ++j) {
            const double *row = gap_.values + i * step[0] + j * step[1];
            for (int64_t k = first[2]; k < end[2]; ++k) {
                visit(row + k * step[2]);
            }
        }
    }
}

PatchProof::Range PatchProof::first_differences(int k) const noexcept {
    Range range{infinity, -infinity};
    std::array<int, max_axes> shrink{};
    shrink[static_cast<size_t>(k)] = 1;
    const int64_t s = step_[static_cast<size_t>(k)];
    for_face(shrink, [&](const double *g) {
        const double d = g[s] - g[0];
        range.low = std::min(range.low, d);
        range.high = std::max(range.high, d);
    });
    return range;
}

PatchProof::Range PatchProof::second_differences(int k, int l) const noexcept {
    Range range{infinity, -infinity};
    std::array<int, max_axes> shrink{};
    ++shrink[static_cast<size_t>(k)];
    ++shrink[static_cast<size_t>(l)];
    const int64_t s = step_[static_cast<size_t>(k)], t = step_[static_cast<size_t>(l)];
    for_face(shrink, [&](const double *g) {
        const double d = (g[s + t] - g[s]) - (g[t] - g[0]);
        range.low = std::min(range.low, d);
        range.high = std::max(range.high, d);
    });
    return range;
}

// Along an axis of degree n, F falls below its value on a face by at most n times the largest decrease
// between neighbouring coefficients.
bool PatchProof::drop_axes(double allowed) noexcept {
    bool dropped = false;
    for (int k = 0; k < shape_.axes; ++k) {
        const auto at = static_cast<size_t>(k);
        if (face_[at] >= 0) {
            continue;
        }
        const Range range = first_differences(k);
        const int n = 2 * shape_.degree(k);
        const double rise = std::max(0.0, n * (2 * error_ - range.low));
        const double fall = std::max(0.0, n * (2 * error_ + range.high));
        if (std::min(rise, fall) <= allowed) {
            face_[at] = rise <= fall ? 0 : 1;
            lost_ += std::min(rise, fall);
            strict_ = strict_ && std::min(rise, fall) == 0;
            dropped = true;
        }
    }
    return dropped;
}

void PatchProof::set_matrix() noexcept {
    for (int k = 0; k < shape_.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        if (face_[i] >= 0) {
            matrix_[i] = {};
            continue;
        }
        const int n = 2 * shape_.degree(k);
        matrix_[i][i] = n * (n - 1) * (second_differences(k, k).low - 4 * error_);
        for (int l = 0; l < k; ++l) {
            const auto j = static_cast<size_t>(l);
            matrix_[i][j] = 0;
            if (face_[j] < 0) {
                const Range range = second_differences(k, l);
                matrix_[i][j] = -n * 2 * shape_.degree(l) *
                                (std::max(std::abs(range.low), std::abs(range.high)) + 4 * error_);
            }
            matrix_[j][i] = matrix_[i][j];
        }
    }
}

PatchProof::Corner PatchProof::least_corner() const noexcept {
    Corner least{infinity, false};
    for (unsigned corner = 0; corner < 1U << static_cast<unsigned>(shape_.axes); ++corner) {
        int64_t place = 0;
        for (int k = 0; k < shape_.axes; ++k) {
            const auto at = static_cast<size_t>(k);
            const bool upper = face_[at] >= 0 ? face_[at] == 1 : (corner >> at & 1U) != 0;
            place += upper ? 2 * shape_.degree(k) * step_[at] : 0;
        }
        if (gap_.values[place] < least.gap) {
            const double w = gap_.weights != nullptr ? gap_.weights[place] : 1;
            const double value = goal_.sign * std::sqrt(std::max(0.0, gap_.squares[place] / w));
            least = {gap_.values[place], least.is_better || value < goal_.worth};
        }
    }
    return least;
}

// The place at which the basis function of the least coefficient has its peak.
AxisValues PatchProof::lowest() const noexcept {
    const double *least = nullptr;
    for_face({}, [&](const double *g) {
        if (least == nullptr || *g < *least) {
            least = g;
        }
    });
    AxisValues at{};
    int64_t rest = least - gap_.values;
    for (int k = 0; k < shape_.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        const int64_t place = rest / step_[i];
        at[i] = static_cast<double>(place) / (2 * shape_.degree(k));
        rest %= step_[i];
    }
    return at;
}

double PatchProof::loss(const AxisValues &gradient, double more) const noexcept {
    std::array<size_t, max_axes> axes{};
    AxisValues x{};
    SmallCholesky<max_axes>::Matrix matrix{};
    size_t n = 0;
    for (size_t k = 0; k < static_cast<size_t>(shape_.axes); ++k) {
        if (face_[k] < 0) {
            axes[n] = k;
            x[n] = gradient[k];
            for (size_t j = 0; j <= n; ++j) {
                matrix[n][j] = matrix_[k][axes[j]] + (j == n ? more : 0);
            }
            ++n;
        }
    }
    SmallCholesky<max_axes> factor;
    if (!factor.factorise(matrix, static_cast<int>(n), 64 * eps)) {
        return -1;
    }
    factor.solve_lower(x);
    return 0.55 * dot(x.data(), x.data(), static_cast<int>(n));
}

// Relative error of an evaluation at a place: at the ends of an axis, the basis functions are exact.
double PatchProof::value_error(const AxisValues &at) const noexcept {
    double error = eps;
    for (int k = 0; k < shape_.axes; ++k) {
        const double t = at[static_cast<size_t>(k)];
        error += t == 0 || t == 1 ? 0 : (2 * shape_.degree(k) + 1) * eps;
    }
    return 1.1 * error;
}

// Evaluated at `at`, |Q| and Q_k have errors of at most value_error() times the means of the magnitudes,
// which are at most reach w and 2 p reach w_max.
bool PatchProof::holds_at(const AxisValues &at) {
    const PatchValues v = descent_.values(item_.values, at);
    const double rho = goal_.rho, w = v.weight, reach = item_.reach, kappa = value_error(at);
    const double sum = v.length + rho * w;
    const double gap = goal_.sign * (v.length - rho * w) * sum;
    distance_ = v.length / w;
    const double gap_error = 2 * sum * kappa * (reach + rho) * w + 8 * eps * sum * sum;
    const double rest = gap - gap_error - lost_;
    if (!(rest > 0)) {
        return false;
    }
    AxisValues gradient{};
    double more = 0;
    int free = 0;
    for (int k = 0; k < shape_.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        if (face_[i] >= 0) {
            continue;
        }
        ++free;
        const double g = 2 * goal_.sign * (v.products[i] - rho * rho * w * v.weights[i]);
        const double differences = 4 * shape_.degree(k) * kappa * item_.most_weight;
        const double error =
            2 * (kappa * reach * w * v.derivatives[i] + (v.length + kappa * reach * w) * differences * reach +
                 rho * rho * (kappa * w * std::abs(v.weights[i]) + w * (1 + kappa) * differences)) +
            16 * eps * (v.length * v.derivatives[i] + rho * rho * w * std::abs(v.weights[i]));
        const bool inwards = (at[i] <= 0 && g >= error) || (at[i] >= 1 && -g >= error);
        gradient[i] = inwards ? 0.0 : std::abs(g) + error;
    }
    if (free == 0) {
        return true;
    }
    const double certain = loss(gradient, 0);
    if (certain >= 0 && certain <= 0.9 * rest) {
        return true;
    }
    strict_ = false;
    more = 0.9 * rest / free; // adds at most 0.5 `more` |y|^2 <= 0.45 rest in the unit box
    const double lost = loss(gradient, more);
    return lost >= 0 && lost <= 0.5 * rest;
}

// First drops only the axes that cost nothing, so that a unique minimum can be recognized as unique.
bool PatchProof::convex(const AxisValues *guess) {
    while (drop_axes(0)) {
    }
    if (convex_on_face(guess)) {
        return true;
    }
    const double allowed = 0.3 * goal_.margin * item_.least_weight * item_.least_weight;
    if (!drop_axes(allowed)) {
        return false;
    }
    while (drop_axes(allowed)) {
    }
    return convex_on_face(guess);
}

bool PatchProof::convex_on_face(const AxisValues *guess) {
    set_matrix();
    const Corner corner = least_corner();
    int free = 0;
    for (int k = 0; k < shape_.axes; ++k) {
        free += face_[static_cast<size_t>(k)] < 0 ? 1 : 0;
    }
    const double most = free > 0 ? std::max(0.0, corner.gap) / free : 0;
    if (free > 0 && !corner.is_better && loss({}, most) < 0) {
        return false;
    }
    PatchBox box;
    const bool strict = strict_;
    at_ = guess != nullptr ? *guess : lowest();
    for (size_t k = 0; k < static_cast<size_t>(shape_.axes); ++k) {
        if (face_[k] >= 0) {
            box.lower[k] = box.upper[k] = face_[k];
        }
        at_[k] = std::clamp(at_[k], box.lower[k], box.upper[k]);
    }
    found_ = true;
    if (guess != nullptr && holds_at(at_)) {
        return true;
    }
    strict_ = strict;
    const double floor = 16 * eps * item_.reach;
    distance_ = descent_.descend(item_.values, box, goal_.sign, floor, at_).distance;
    return holds_at(at_);
}

int PatchProof::widest_axis() noexcept {
    if (std::find(face_.begin(), face_.begin() + shape_.axes, -1) == face_.begin() + shape_.axes) {
        face_.fill(-1);
    }
    int widest = -1;
    double most = -1;
    for (int k = 0; k < shape_.axes; ++k) {
        if (face_[static_cast<size_t>(k)] < 0) {
            const int n = 2 * shape_.degree(k);
            const Range range = second_differences(k, k);
            const double bend = n * (n - 1) * std::max(std::abs(range.low), std::abs(range.high));
            if (bend > most) {
                most = bend;
                widest = k;
            }
        }
    }
    return widest;
}

} // namespace nrb::closest
