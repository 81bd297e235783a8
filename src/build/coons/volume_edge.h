// SPDX-License-Identifier: MIT
// The faces and edges of a volume, counted; two faces meet in each edge.
#pragma once

#include "spline/spline.h"

#include <array>

namespace nrb::build {

inline constexpr size_t face_count = 6;
inline constexpr size_t edges_of_axis = 4;

// The face at an end of an axis, in the order of nurbs_boundaries().
inline size_t face_at(int axis, bool upper) noexcept {
    return static_cast<size_t>(2 * axis) + (upper ? 1 : 0);
}

// The two axes of the volume over which a face runs.
struct FaceAxes {
    int first;
    int second;

    explicit FaceAxes(size_t face) noexcept : first(face < 2 ? 1 : 0), second(face < 4 ? 2 : 1) {}
    [[nodiscard]] bool has(int axis) const noexcept { return axis == first || axis == second; }
    // The axis of the face, 0 or 1, that is `axis` of the volume.
    [[nodiscard]] int place(int axis) const noexcept { return axis == first ? 0 : 1; }
};

// An edge along `axis`: the other two axes are fixed at their ends.
struct VolumeEdge {
    int axis;
    int first;
    int second;
    bool first_upper;
    bool second_upper;

    // Edge i of an axis, i < edges_of_axis.
    VolumeEdge(int along, size_t i) noexcept
        : axis(along), first(along == 0 ? 1 : 0), second(along == 2 ? 1 : 2), first_upper(i / 2 == 1),
          second_upper(i % 2 == 1) {}
    // The two faces that meet in the edge.
    [[nodiscard]] size_t face() const noexcept { return face_at(first, first_upper); }
    [[nodiscard]] size_t other_face() const noexcept { return face_at(second, second_upper); }
    // Throws Status::gap, naming the edge, unless gap <= tolerance.
    void check(double gap, double tolerance) const;
};

// The domains of the axes of a volume, taken from faces 0 and 2.
std::array<Interval, 3> volume_domains(const std::vector<SplinePtr> &faces);

} // namespace nrb::build
