// SPDX-License-Identifier: MIT
// Meshes as all libraries have them, and their files, by which bench_meshes_apart gets them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace bench::meshes {

using Point = std::array<double, 3>;
using Param = std::array<double, 2>;
using Corners = std::array<int64_t, 3>;

inline Point operator+(const Point &a, const Point &b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point &a, const Point &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(double s, const Point &a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point &a) {
    return std::sqrt(dot(a, a));
}

struct Mesh {
    std::vector<Point> points;
    std::vector<Param> params; // of the points, in the surface of the library that made the mesh
    std::vector<Corners> triangles;

    // The place of a triangle with these shares of its corners, which add to 1.
    [[nodiscard]] Point point(size_t triangle, const Point &shares) const {
        const Corners &at = triangles[triangle];
        return shares[0] * points[static_cast<size_t>(at[0])] +
               shares[1] * points[static_cast<size_t>(at[1])] +
               shares[2] * points[static_cast<size_t>(at[2])];
    }
    [[nodiscard]] Param param(size_t triangle, const Point &shares) const {
        Param sum{};
        for (size_t k = 0; k < 3; ++k) {
            const Param &own = params[static_cast<size_t>(triangles[triangle][k])];
            sum = {sum[0] + shares[k] * own[0], sum[1] + shares[k] * own[1]};
        }
        return sum;
    }
    [[nodiscard]] double area(size_t triangle) const {
        const Point a = point(triangle, {1, 0, 0});
        return length(cross(point(triangle, {0, 1, 0}) - a, point(triangle, {0, 0, 1}) - a)) / 2;
    }
};

template <class T>
void write_array(std::ofstream &file, const std::vector<T> &values) {
    const auto count = static_cast<int64_t>(values.size());
    file.write(reinterpret_cast<const char *>(&count), sizeof count);
    file.write(reinterpret_cast<const char *>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(T)));
}
template <class T>
void read_array(std::ifstream &file, std::vector<T> &values) {
    int64_t count = 0;
    file.read(reinterpret_cast<char *>(&count), sizeof count);
    values.resize(static_cast<size_t>(count));
    file.read(reinterpret_cast<char *>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(T)));
}

inline void write(const Mesh &mesh, const char *path) {
    std::ofstream file(path, std::ios::binary);
    write_array(file, mesh.points);
    write_array(file, mesh.params);
    write_array(file, mesh.triangles);
    if (!file.flush()) {
        std::fprintf(stderr, "%s is not written\n", path);
        std::exit(1);
    }
}
inline Mesh read(const char *path) {
    std::ifstream file(path, std::ios::binary);
    Mesh mesh;
    read_array(file, mesh.points);
    read_array(file, mesh.params);
    read_array(file, mesh.triangles);
    if (!file) {
        std::fprintf(stderr, "%s is not read\n", path);
        std::exit(1);
    }
    return mesh;
}

} // namespace bench::meshes
