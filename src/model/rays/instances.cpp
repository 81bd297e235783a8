// SPDX-License-Identifier: MIT
#include "model/rays/instances.h"

#include "base/error.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

constexpr size_t most_instances = 1 << 20;
using Rows = std::array<double, 12>;
using Matrix = std::array<std::array<double, 3>, 3>;

// The composition: first b, then a.
Rows product(const Rows &a, const Rows &b) noexcept {
    Rows c{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 4; ++j) {
            double sum = j == 3 ? a[4 * i + 3] : 0;
            for (size_t k = 0; k < 3; ++k) {
                sum += a[4 * i + k] * b[4 * k + j];
            }
            c[4 * i + j] = sum;
        }
    }
    return c;
}

double largest_of(const Matrix &m) noexcept {
    double largest = 0;
    for (const auto &row : m) {
        for (const double x : row) {
            largest = std::max(largest, std::abs(x));
        }
    }
    return largest;
}

// A bound of the spectral norm of M, the largest factor by which lengths grow: the root of the largest
// absolute row sum of M^T M, which bounds its largest eigenvalue. For a similarity it is the scale, to
// rounding.
double growth_of(const Matrix &m) noexcept {
    const double scale = largest_of(m);
    double most = 0;
    for (size_t i = 0; i < 3; ++i) {
        double sum = 0;
        for (size_t j = 0; j < 3; ++j) {
            double entry = 0;
            for (size_t k = 0; k < 3; ++k) {
                entry += m[k][i] / scale * (m[k][j] / scale);
            }
            sum += std::abs(entry);
        }
        most = std::max(most, sum);
    }
    return (1 + 32 * eps) * scale * std::sqrt(most);
}

Matrix matrix_of(const Rows &rows) noexcept {
    Matrix m{};
    for (size_t i = 0; i < 3; ++i) {
        std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, m[i].begin());
    }
    return m;
}

Matrix times_power(Matrix m, int exponent) noexcept {
    for (auto &row : m) {
        for (double &x : row) {
            x = std::ldexp(x, exponent);
        }
    }
    return m;
}

double determinant_of(const Matrix &m) noexcept {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// By cofactors; not finite if M is singular.
Matrix inverse_of(const Matrix &m) noexcept {
    Matrix inverse{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            const size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            inverse[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    }
    const double determinant = m[0][0] * inverse[0][0] + m[0][1] * inverse[1][0] + m[0][2] * inverse[2][0];
    for (auto &row : inverse) {
        for (double &x : row) {
            x /= determinant;
        }
    }
    return inverse;
}

} // namespace

// A depth-first traversal. Pending instances wait on a stack, the first use of a part on top.
std::vector<Instance> instances_of(size_t parts, const std::vector<Use> &uses) {
    std::vector<std::vector<int64_t>> below(parts + 1);
    for (size_t i = uses.size(); i-- > 0;) {
        below[static_cast<size_t>(uses[i].parent + 1)].push_back(static_cast<int64_t>(i));
    }
    struct Waiting {
        int64_t use, parent;
    };
    std::vector<Waiting> waiting;
    std::vector<Instance> found;
    const auto open = [&](int64_t part, int64_t instance) {
        for (const int64_t use : below[static_cast<size_t>(part + 1)]) {
            waiting.push_back({use, instance});
        }
    };
    open(-1, -1);
    while (!waiting.empty()) {
        const auto [number, parent] = waiting.back();
        waiting.pop_back();
        if (found.size() == most_instances) {
            fail(Status::too_large, "parts are placed in parts more than %zu times in all", most_instances);
        }
        const Use &use = uses[static_cast<size_t>(number)];
        const Rows placement =
            parent < 0 ? use.placement : product(found[static_cast<size_t>(parent)].placement, use.placement);
        found.push_back({use.part, number, parent, placement});
        open(use.part, std::ssize(found) - 1);
    }
    return found;
}

Placement::Placement(const std::vector<Instance> &instances, size_t index)
    : identity_(instances[index].placement == Use{}.placement), placement_(instances[index].placement) {
    if (identity_) {
        return;
    }
    const Matrix m = matrix_of(placement_);
    int exponent = 0;
    std::frexp(largest_of(m), &exponent);
    const Matrix about_one = times_power(m, -exponent); // with a determinant that is representable
    inverse_ = times_power(inverse_of(about_one), -exponent);
    mirrors_ = determinant_of(about_one) < 0;
    norm_ = growth_of(m);
    inverse_norm_ = growth_of(inverse_);
    const double condition = norm_ * inverse_norm_;
    if (!(condition > 0 && condition < 1e9)) { // 0: the zero matrix, whose inverse is NaN
        fail(Status::matrix, "the placement of use %lld has no inverse to rounding",
             static_cast<long long>(instances[index].use));
    }
    int depth = 0;
    for (int64_t at = static_cast<int64_t>(index); at >= 0; ++depth) {
        const Instance &above = instances[static_cast<size_t>(at)];
        reach_ += std::abs(above.placement[3]) + std::abs(above.placement[7]) + std::abs(above.placement[11]);
        at = above.parent;
    }
    error_ = 32 * depth * eps * condition;
}

Vector3 Placement::turned(const Vector3 &x) const noexcept {
    const auto row = [&](size_t i) {
        return inverse_[i][0] * x.x + inverse_[i][1] * x.y + inverse_[i][2] * x.z;
    };
    return {row(0), row(1), row(2)};
}

Vector3 Placement::moved(const Vector3 &x) const noexcept {
    return identity_ ? x : turned(x - Vector3{placement_[3], placement_[7], placement_[11]});
}

double Placement::error(const Vector3 &x) const noexcept {
    return error_ * inverse_norm_ * (length(x) + reach_);
}

intersect::RayQuery Placement::moved(const intersect::RayQuery &query) const noexcept {
    if (identity_) {
        return query;
    }
    intersect::RayQuery result = query;
    result.origin = moved(query.origin);
    result.direction = turned(query.direction);
    result.off = inverse_norm_ * query.off + error(query.origin);
    result.turned = norm_ * inverse_norm_ * query.turned + error_ * norm_ * inverse_norm_;
    return result;
}

SplinePtr Placement::in_whole(const SplinePtr &curve) const {
    if (identity_) {
        return curve;
    }
    std::array<double, 9> matrix{};
    std::array<double, 3> translation{};
    for (size_t i = 0; i < 3; ++i) {
        std::copy_n(placement_.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                    matrix.begin() + static_cast<std::ptrdiff_t>(3 * i));
        translation[i] = placement_[4 * i + 3];
    }
    return refine::transform(*curve, {3, 3, matrix.data()}, translation.data());
}

// Normals n and tangents d are mapped to n M^-1 and M d, so that n . d remains 0.
Vector3 Placement::normal_in_whole(const Vector3 &normal) const noexcept {
    const auto column = [&](size_t k) {
        return inverse_[0][k] * normal.x + inverse_[1][k] * normal.y + inverse_[2][k] * normal.z;
    };
    return identity_ ? normal : unit({column(0), column(1), column(2)});
}

// x = M y + t satisfies n . x = o if (n M) . y = o - n . t.
Placement::Plane Placement::moved(const Plane &plane) const noexcept {
    if (identity_) {
        return plane;
    }
    const Vector3 &n = plane.normal;
    const auto column = [&](size_t k) {
        return placement_[k] * n.x + placement_[4 + k] * n.y + placement_[8 + k] * n.z;
    };
    const Vector3 t{placement_[3], placement_[7], placement_[11]};
    return {{column(0), column(1), column(2)}, plane.offset - dot(n, t)};
}

double Placement::rounding(double size) const noexcept {
    return identity_ ? 0 : 32 * eps * (norm_ * size + reach_);
}

intersect::Box3 Placement::placed(const intersect::Box3 &box) const noexcept {
    if (identity_) {
        return box;
    }
    intersect::Box3 result;
    for (size_t i = 0; i < 3; ++i) {
        double middle = placement_[4 * i + 3], half = 0, size = std::abs(middle);
        for (size_t k = 0; k < 3; ++k) {
            const double m = placement_[4 * i + k];
            middle += m * (box.lower[k] / 2 + box.upper[k] / 2);
            half += std::abs(m) * (box.upper[k] / 2 - box.lower[k] / 2);
            size += std::abs(m) * std::max(std::abs(box.lower[k]), std::abs(box.upper[k]));
        }
        const double room = error_ * (size + reach_);
        result.lower[i] = middle - half - room;
        result.upper[i] = middle + half + room;
    }
    return result;
}

} // namespace nrb::model
