// A reader of glTF in one binary file, for tests. It needs nlohmann-json.
#pragma once

#include "support/mesh_files.h"

#include <limits>
#include <nlohmann/json.hpp>

namespace support::mesh_files {

using Matrix = std::array<double, 16>; // column by column

inline Matrix product(const Matrix &a, const Matrix &b) {
    Matrix c{};
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = 0; j < 4; ++j) {
            for (size_t k = 0; k < 4; ++k) {
                c[4 * j + i] += a[4 * k + i] * b[4 * j + k];
            }
        }
    }
    return c;
}

inline Point times(const Matrix &m, const Point &x, double one) {
    Point y{};
    for (size_t i = 0; i < 3; ++i) {
        y[i] = m[i] * x[0] + m[4 + i] * x[1] + m[8 + i] * x[2] + m[12 + i] * one;
    }
    return y;
}

class Glb {
public:
    explicit Glb(const std::string &file) {
        Bytes in(file);
        require(in.take<uint32_t>() == 0x46546C67 && in.take<uint32_t>() == 2, "the mark of GLB");
        require(in.take<uint32_t>() == file.size(), "the length of the file");
        const auto json_size = in.take<uint32_t>();
        require(in.take<uint32_t>() == 0x4E4F534A && json_size % 4 == 0, "the chunk of JSON");
        json = nlohmann::json::parse(file.substr(in.place(), json_size));
        Bytes chunk(file, in.place() + json_size);
        const auto size = chunk.take<uint32_t>();
        require(chunk.take<uint32_t>() == 0x004E4942 && size % 4 == 0, "the chunk of bytes");
        require(chunk.place() + size == file.size(), "the end of the file");
        require(json["buffers"][0]["byteLength"] == size, "the length of the buffer");
        buffer_ = file.substr(chunk.place());
    }

    // Of all nodes below those of the scene, as they stand there; part: the node.
    [[nodiscard]] Soup triangles() const {
        Soup soup;
        const Matrix one{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        for (const size_t node : json["scenes"][json["scene"].get<size_t>()]["nodes"]) {
            add(node, one, soup);
        }
        return soup;
    }

    nlohmann::json json;

private:
    void add(size_t number, const Matrix &above, Soup &soup) const {
        const nlohmann::json &node = json["nodes"][number];
        const Matrix place = node.contains("matrix") ? product(above, node["matrix"].get<Matrix>()) : above;
        if (node.contains("mesh")) {
            for (const nlohmann::json &primitive : json["meshes"][node["mesh"].get<size_t>()]["primitives"]) {
                add_primitive(primitive, place, static_cast<int64_t>(number), soup);
            }
        }
        for (const size_t child : node.value("children", std::vector<size_t>())) {
            add(child, place, soup);
        }
    }

    void add_primitive(const nlohmann::json &primitive, const Matrix &place, int64_t node, Soup &soup) const {
        const std::vector<Point> points = vectors(primitive["attributes"]["POSITION"]),
                                 normals = vectors(primitive["attributes"]["NORMAL"]);
        const nlohmann::json &accessor = json["accessors"][primitive["indices"].get<size_t>()];
        check_bounds(json["accessors"][primitive["attributes"]["POSITION"].get<size_t>()], points);
        Bytes in = bytes(accessor, 5125, "SCALAR");
        const Point x = times(place, {1, 0, 0}, 0), y = times(place, {0, 1, 0}, 0),
                    z = times(place, {0, 0, 1}, 0);
        const bool mirrors = dot(cross(x, y), z) < 0; // then triangles are clockwise
        const size_t first = soup.size();
        for (size_t i = 0; i < accessor["count"].get<size_t>() / 3; ++i) {
            Triangle t;
            for (size_t k = 0; k < 3; ++k) {
                const auto vertex = in.take<uint32_t>();
                t.corners[mirrors ? 2 - k : k] = times(place, points.at(vertex), 1);
                t.normals[mirrors ? 2 - k : k] = times(place, normals.at(vertex), 0); // of a similarity
            }
            t.part = node;
            soup.push_back(t);
        }
        for (const nlohmann::json &face : primitive["extras"]["faces"]) {
            for (size_t i = 0; i < face["triangles"].get<size_t>(); ++i) {
                soup.at(first + face["first"].get<size_t>() + i).face = face["face"];
            }
        }
    }

    static void check_bounds(const nlohmann::json &accessor, const std::vector<Point> &points) {
        Point least, most;
        least.fill(std::numeric_limits<double>::infinity());
        most.fill(-least[0]);
        for (const Point &x : points) {
            for (size_t k = 0; k < 3; ++k) {
                least[k] = std::min(least[k], x[k]);
                most[k] = std::max(most[k], x[k]);
            }
        }
        require(accessor["min"].get<Point>() == least && accessor["max"].get<Point>() == most, "min and max");
    }

    [[nodiscard]] Bytes bytes(const nlohmann::json &accessor, int type, const char *shape) const {
        require(accessor["componentType"] == type && accessor["type"] == shape, "the type of an accessor");
        const nlohmann::json &view = json["bufferViews"][accessor["bufferView"].get<size_t>()];
        const size_t size = accessor["count"].get<size_t>() * (type == 5126 ? 12 : 4);
        require(accessor["byteOffset"].get<size_t>() + size <= view["byteLength"].get<size_t>(), "a view");
        return Bytes(buffer_, view["byteOffset"].get<size_t>() + accessor["byteOffset"].get<size_t>());
    }

    [[nodiscard]] std::vector<Point> vectors(size_t number) const {
        Bytes in = bytes(json["accessors"][number], 5126, "VEC3");
        std::vector<Point> points(json["accessors"][number]["count"].get<size_t>());
        for (Point &x : points) {
            x = in.point<float>();
        }
        return points;
    }

    std::string buffer_;
};

} // namespace support::mesh_files
