// SPDX-License-Identifier: MIT
// A hash grid that finds all stored points within a fixed radius of a place.
#pragma once

#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nrb::closest {

// The cells are cubes in the first three coordinates. Points have `dim` coordinates and are numbered in the
// order in which they are added.
class NearPoints {
public:
    // near: the search radius.
    NearPoints(int dim, double near) : dim_(dim), near_(near), side_(near > 0 ? near + near / 16 : 1) {}

    void add(const double *point) {
        cubes_[key_of(cube_of(point))].push_back(std::ssize(points_) / dim_);
        points_.insert(points_.end(), point, point + dim_);
    }

    // Calls visit(number) for the points at most `near` from the place until it returns true; returns whether
    // it did.
    template <class Visit>
    bool any_near(const double *place, Visit &&visit) const {
        const Cube middle = cube_of(place);
        const int cubes = dim_ >= 3 ? 27 : dim_ == 2 ? 9 : 3;
        for (int i = 0; i < cubes; ++i) {
            const Cube cube{middle[0] + i % 3 - 1, dim_ > 1 ? middle[1] + i / 3 % 3 - 1 : 0,
                            dim_ > 2 ? middle[2] + i / 9 - 1 : 0};
            if (any_in(cube, place, visit)) {
                return true;
            }
        }
        return false;
    }

private:
    using Cube = std::array<double, 3>;
    static constexpr int64_t work_of_a_cube = 40, work_of_a_point = 8;

    // A point within the radius lies in the cube of the place or in one of its neighbours. Cubes are wider than
    // the radius, so that this holds in spite of the rounding of quotients. Where a cube is smaller than the
    // rounding of a coordinate, the neighbours coincide with the cube itself.
    [[nodiscard]] Cube cube_of(const double *point) const noexcept {
        Cube cube{};
        for (size_t c = 0; c < static_cast<size_t>(std::min(dim_, 3)); ++c) {
            cube[c] = std::floor(point[c] / side_) + 0.0; // no -0
        }
        return cube;
    }
    static uint64_t key_of(const Cube &cube) noexcept {
        uint64_t key = 0;
        for (const double place : cube) {
            constexpr uint64_t spread = 0x9e3779b97f4a7c15U;
            key = (key ^ std::bit_cast<uint64_t>(place + 0.0)) * spread;
            key ^= key >> 29;
        }
        return key;
    }
    template <class Visit>
    bool any_in(const Cube &cube, const double *place, Visit &visit) const {
        count_work(work_of_a_cube);
        const auto found = cubes_.find(key_of(cube));
        if (found == cubes_.end()) {
            return false;
        }
        for (const int64_t number : found->second) {
            count_work(work_of_a_point);
            const bool near = distance(points_.data() + number * dim_, place, dim_) <= near_;
            if (near && visit(number)) {
                return true;
            }
        }
        return false;
    }

    int dim_;
    double near_;
    double side_;
    std::vector<double> points_;
    std::unordered_map<uint64_t, std::vector<int64_t>> cubes_;
};

} // namespace nrb::closest
