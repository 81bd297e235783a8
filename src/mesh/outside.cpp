// SPDX-License-Identifier: MIT
#include "mesh/outside.h"

#include "base/watch.h"
#include "model/sections/shared_borders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nrb::mesh {

namespace {

// A hash with the statistics of a random number ("splitmix64", Steele, Lea and Flood 2014).
uint64_t mixed(uint64_t x) noexcept {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111eb;
    return x ^ (x >> 31U);
}

// A hash of a directed side of a triangle; that of the opposite direction is its negative. So the sum over
// all sides, modulo 2^64, is 0 if each side has a counterpart in the opposite direction, and otherwise with a
// probability of about 2^-64.
uint64_t side_number(int32_t from, int32_t to) noexcept {
    const auto [low, high] = std::minmax(from, to);
    const uint64_t number = mixed((static_cast<uint64_t>(low) << 32U) | static_cast<uint64_t>(high));
    return from < to ? number : 0 - number;
}

// Sums over triangles that tell whether they form a closed surface, and the sign of the volume that it
// encloses.
class Shell {
public:
    Shell(const Mesh &mesh, double factor) : mesh_(mesh), factor_(factor) {}

    void add(const MeshFace &face) {
        for (size_t i = 0; i < face.triangles; ++i) {
            add(mesh_.triangles[face.first_triangle + i], face.turned);
        }
        count_work(static_cast<int64_t>(32 * face.triangles));
    }
    // Whether the triangles are closed, and the volume is negative by more than the rounding of the sum.
    [[nodiscard]] bool is_inside_out() const noexcept { return open_ == 0 && volume_ < -1e-9 * size_; }

private:
    void add(const std::array<int32_t, 3> &triangle, bool turned) {
        std::array<int32_t, 3> points{};
        for (size_t k = 0; k < 3; ++k) {
            points[turned ? 2 - k : k] = mesh_.vertices[static_cast<size_t>(triangle[k])].point;
        }
        for (size_t k = 0; k < 3; ++k) {
            open_ += side_number(points[k], points[(k + 1) % 3]);
        }
        origin_ = origin_ < 0 ? points[0] : origin_;
        const Vector3 a = from_origin(points[0]), b = from_origin(points[1]), c = from_origin(points[2]);
        const double six_times = dot(a, cross(b, c));
        volume_ += six_times;
        size_ += std::fabs(six_times);
    }
    [[nodiscard]] Vector3 from_origin(int32_t point) const noexcept {
        const auto scaled = [this](int32_t i) { return factor_ * mesh_.points[static_cast<size_t>(i)]; };
        return scaled(point) - scaled(origin_);
    }

    const Mesh &mesh_;
    double factor_;                // to units in which cubes of lengths neither overflow nor underflow
    int32_t origin_ = -1;          // a point of the triangles, to which the volume is summed
    uint64_t open_ = 0;            // sum of side numbers; 0: closed
    double volume_ = 0, size_ = 0; // six times the signed volume, and the sum of the magnitudes
};

// A power of two that brings the largest coordinate of all near 1.
double factor_of(const Mesh &mesh) noexcept {
    double most = 0;
    for (const Vector3 &x : mesh.points) {
        most = std::max(most, largest(x));
    }
    return std::ldexp(1, -std::clamp(size_exponent({most, 0, 0}), -1000, 1000));
}

// Turns the faces of each part and solid that are inside out. `solids`: the solid of each face, -1: none.
void turn_outward(const std::vector<int64_t> &solids, Mesh &mesh) {
    const double factor = factor_of(mesh);
    std::map<std::pair<int64_t, int64_t>, Shell> shells;
    const auto shell_of = [&](size_t i) -> Shell & {
        return shells.try_emplace({mesh.faces[i].part, solids[i]}, mesh, factor).first->second;
    };
    for (size_t i = 0; i < mesh.faces.size(); ++i) {
        shell_of(i).add(mesh.faces[i]);
    }
    for (size_t i = 0; i < mesh.faces.size(); ++i) {
        mesh.faces[i].turned = mesh.faces[i].turned != shell_of(i).is_inside_out();
    }
}

} // namespace

void label(const model::Model &model, Mesh &mesh) {
    const model::SharedBorders borders(model);
    std::vector<int64_t> solids;
    for (size_t i = 0; i < mesh.faces.size(); ++i) {
        const model::ModelFace &face = model.faces[i];
        MeshFace &own = mesh.faces[i];
        own.name = face.name;
        own.part = face.part;
        own.colour = face.colour;
        own.turned = face.against != borders.is_turned(static_cast<int64_t>(i));
        solids.push_back(face.solid);
    }
    mesh.metres_per_unit = model.metres_per_unit;
    mesh.parts = model.parts;
    mesh.uses = model.uses;
    turn_outward(solids, mesh);
}

void label_as_one_part(Mesh &mesh) {
    mesh.parts.emplace_back();
    mesh.uses.emplace_back();
    turn_outward(std::vector<int64_t>(mesh.faces.size(), -1), mesh);
}

} // namespace nrb::mesh
