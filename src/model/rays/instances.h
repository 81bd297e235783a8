// SPDX-License-Identifier: MIT
// Parts where they stand in the whole.
#pragma once

#include "intersect/rays/box_tree.h"
#include "model/model.h"

#include <array>
#include <vector>

namespace nrb::model {

// A way from the whole to a part, through uses of parts in parts. Its last use, and the instance that has it.
struct Instance {
    int64_t part, use;
    int64_t parent; // -1: the whole
    std::array<double, 12> placement;
};

// Each instance before those in it, those of one by their uses. Throws Status::too_large if there are more than a million.
std::vector<Instance> instances_of(size_t parts, const std::vector<Use> &uses);
inline std::vector<Instance> instances_of(const Model &model) {
    return instances_of(model.parts.size(), model.uses);
}

// From the whole to the coordinates of a part.
class Placement {
public:
    // Throws Status::matrix if it cannot be inverted.
    Placement(const std::vector<Instance> &instances, size_t index);

    // t stays that of the whole. What rounding moves is in the query.
    [[nodiscard]] intersect::RayQuery moved(const intersect::RayQuery &query) const noexcept;
    [[nodiscard]] Vector3 moved(const Vector3 &x) const noexcept;
    // How far off a point moved that way may be.
    [[nodiscard]] double error(const Vector3 &x) const noexcept;
    // Of the whole, moved the other way.
    [[nodiscard]] Vector3 in_whole(const Vector3 &x) const noexcept {
        const auto row = [&](size_t i) {
            const double *m = placement_.data() + 4 * i;
            return m[0] * x.x + m[1] * x.y + m[2] * x.z + m[3];
        };
        return identity_ ? x : Vector3{row(0), row(1), row(2)};
    }
    [[nodiscard]] SplinePtr in_whole(const SplinePtr &curve) const;
    // A normal of a surface moved that way: of length 1, on the same side of it.
    [[nodiscard]] Vector3 normal_in_whole(const Vector3 &normal) const noexcept;
    // A plane x . normal = offset of the whole, in the part.
    struct Plane {
        Vector3 normal;
        double offset;
    };
    [[nodiscard]] Plane moved(const Plane &plane) const noexcept;
    // How far rounding may move points and planes on these ways, in the whole: of a part of such a size.
    [[nodiscard]] double rounding(double size) const noexcept;
    // Whether all distances grow by one factor, to rounding.
    [[nodiscard]] bool keeps_ratios() const noexcept { return norm_ * inverse_norm_ <= 1 + 1e-12; }
    // Whether it turns right hands into left ones.
    [[nodiscard]] bool mirrors() const noexcept { return mirrors_; }
    // In the whole.
    [[nodiscard]] intersect::Box3 placed(const intersect::Box3 &box) const noexcept;
    // Distances grow by no more than these factors, to the part and to the whole.
    [[nodiscard]] double growth_to_part() const noexcept { return inverse_norm_; }
    [[nodiscard]] double growth_to_whole() const noexcept { return norm_; }

private:
    [[nodiscard]] Vector3 turned(const Vector3 &x) const noexcept;

    bool identity_, mirrors_ = false;
    std::array<double, 12> placement_;
    std::array<std::array<double, 3>, 3> inverse_{};
    double norm_ = 1, inverse_norm_ = 1;
    double error_ = 0, reach_ = 0; // relative, and how far the part is moved
};

} // namespace nrb::model
