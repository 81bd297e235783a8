// SPDX-License-Identifier: MIT
// The instances of parts and their placements in the whole.
#pragma once

#include "intersect/rays/box_tree.h"
#include "model/model.h"

#include <array>
#include <vector>

namespace nrb::model {

// An instance of a part: a chain of uses from the whole to it. `use` is the last use of the chain, and
// `parent` the instance that contains it.
struct Instance {
    int64_t part, use;
    int64_t parent; // -1: the whole
    std::array<double, 12> placement;
};

// In the order of a depth-first traversal: each instance comes before those in it, and those in one instance
// follow the order of their uses. Throws Status::too_large if there are more than 2^20.
std::vector<Instance> instances_of(size_t parts, const std::vector<Use> &uses);
inline std::vector<Instance> instances_of(const Model &model) {
    return instances_of(model.parts.size(), model.uses);
}

// The affine map x -> M x + t from the coordinates of a part to the whole, with its inverse and bounds of
// rounding.
class Placement {
public:
    // Throws Status::matrix if M is singular to rounding.
    Placement(const std::vector<Instance> &instances, size_t index);

    // From the whole to the part. The t of rays is not changed, and bounds of rounding are added to the
    // query.
    [[nodiscard]] intersect::RayQuery moved(const intersect::RayQuery &query) const noexcept;
    [[nodiscard]] Vector3 moved(const Vector3 &x) const noexcept;
    // A bound of the error of moved(x), in the part.
    [[nodiscard]] double error(const Vector3 &x) const noexcept;
    // From the part to the whole.
    [[nodiscard]] Vector3 in_whole(const Vector3 &x) const noexcept {
        const auto row = [&](size_t i) {
            const double *m = placement_.data() + 4 * i;
            return m[0] * x.x + m[1] * x.y + m[2] * x.z + m[3];
        };
        return identity_ ? x : Vector3{row(0), row(1), row(2)};
    }
    [[nodiscard]] SplinePtr in_whole(const SplinePtr &curve) const;
    // The unit normal in the whole, on the same side of the surface, from a normal in the part.
    [[nodiscard]] Vector3 normal_in_whole(const Vector3 &normal) const noexcept;
    // The plane x . normal = offset. moved() takes one from the whole to the part.
    struct Plane {
        Vector3 normal;
        double offset;
    };
    [[nodiscard]] Plane moved(const Plane &plane) const noexcept;
    // A bound in the whole of the rounding of points and planes that are moved either way, for a part of such
    // a size.
    [[nodiscard]] double rounding(double size) const noexcept;
    // Whether the map is a similarity, to rounding: all distances are multiplied by one factor.
    [[nodiscard]] bool keeps_ratios() const noexcept { return norm_ * inverse_norm_ <= 1 + 1e-12; }
    // Whether the map reverses orientation.
    [[nodiscard]] bool mirrors() const noexcept { return mirrors_; }
    // A box in the whole around a box of the part.
    [[nodiscard]] intersect::Box3 placed(const intersect::Box3 &box) const noexcept;
    // Bounds of the factors by which distances grow on the way to the part, and to the whole.
    [[nodiscard]] double growth_to_part() const noexcept { return inverse_norm_; }
    [[nodiscard]] double growth_to_whole() const noexcept { return norm_; }

private:
    [[nodiscard]] Vector3 turned(const Vector3 &x) const noexcept;

    bool identity_, mirrors_ = false;
    std::array<double, 12> placement_;
    std::array<std::array<double, 3>, 3> inverse_{};
    double norm_ = 1, inverse_norm_ = 1;
    // Relative error of the map, and the sum of the magnitudes of all translations on the chain of uses.
    double error_ = 0, reach_ = 0;
};

} // namespace nrb::model
