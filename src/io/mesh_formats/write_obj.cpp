// SPDX-License-Identifier: MIT
#include "io/mesh_formats/single.h"
#include "io/mesh_formats/text.h"
#include "io/mesh_formats/write_meshes.h"

#include <utility>

namespace nrb::io {

namespace {

void write_line(std::string_view word, const std::string &name, Blocks &out) {
    out.text(word);
    out.text(name);
    out.text("\n");
}

// The points of the faces of a part, numbered in the order in which the vertices of the faces first use them.
class PartPoints {
public:
    explicit PartPoints(const Mesh &mesh) : mesh_(mesh), numbers_(mesh.points.size(), -1) {
        all_.reserve(mesh.points.size());
    }

    void find(const std::vector<const MeshFace *> &faces) {
        for (const int32_t point : all_) {
            numbers_[static_cast<size_t>(point)] = -1;
        }
        all_.clear();
        for (const MeshFace *face : faces) {
            for (size_t i = 0; i < face->vertices; ++i) {
                const int32_t point = mesh_.vertices[face->first_vertex + i].point;
                int64_t &number = numbers_[static_cast<size_t>(point)];
                if (number < 0) {
                    number = std::ssize(all_);
                    all_.push_back(point);
                }
            }
        }
    }
    [[nodiscard]] const std::vector<int32_t> &all() const noexcept { return all_; }
    [[nodiscard]] int64_t number_of(size_t vertex) const noexcept {
        return numbers_[static_cast<size_t>(mesh_.vertices[vertex].point)];
    }

private:
    const Mesh &mesh_;
    std::vector<int64_t> numbers_; // -1: not used by the part
    std::vector<int32_t> all_;
};

// OBJ keeps colours in a second file, which is not written. Instead the name of a material tells its colour.
std::string material_of(const MeshFace &face) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string name = "colour_";
    for (const uint8_t value : colour_bytes(face)) {
        name += digits[value / 16];
        name += digits[value % 16];
    }
    return name;
}

// The numbers of points and normals begin at 1 and continue from part to part.
class ObjText {
public:
    ObjText(const PlacedMesh &mesh, Blocks &out)
        : mesh_(mesh), out_(out), points_(mesh.mesh()), coloured_(mesh.has_colours()) {}

    void write() {
        out_.text("# Written by libnurbs\n");
        for (const PlacedPart &part : mesh_.parts()) {
            const std::vector<const MeshFace *> &faces = mesh_.faces_of(part.part);
            points_.find(faces);
            write_line("o ", one_word(name_or(name_of(mesh_.mesh(), part.use), "part_", part.part)), out_);
            write_points(part, faces);
            for (const MeshFace *face : faces) {
                write_face(part, *face);
            }
            first_point_ += std::ssize(points_.all());
        }
    }

private:
    static std::string name_or(const std::string &name, const char *word, int64_t number) {
        return name.empty() ? word + std::to_string(number + 1) : name;
    }

    void write_points(const PlacedPart &part, const std::vector<const MeshFace *> &faces) {
        for (const int32_t point : points_.all()) {
            const Vector3 x = part.point(point);
            out_.text("v ");
            out_.row(x.x, x.y, x.z);
            out_.text("\n");
        }
        for (const MeshFace *face : faces) {
            for (size_t i = 0; i < face->vertices; ++i) {
                const Single3 n = single(part.normal(mesh_.normals(), *face, face->first_vertex + i));
                out_.text("vn ");
                out_.row(n[0], n[1], n[2]);
                out_.text("\n");
            }
        }
    }

    void write_face(const PlacedPart &part, const MeshFace &face) {
        write_line("g ", one_word(name_or(face.name, "face_", mesh_.face_number(face))), out_);
        if (coloured_) {
            write_line("usemtl ", material_of(face), out_);
        }
        for (size_t i = 0; i < face.triangles; ++i) {
            out_.text("f");
            for (const size_t vertex : outer_corners(mesh_.mesh(), face, i, part.mirrors())) {
                out_.text(" ");
                out_.digits(first_point_ + points_.number_of(vertex));
                out_.text("//");
                out_.digits(first_normal_ + static_cast<int64_t>(vertex - face.first_vertex));
            }
            out_.text("\n");
        }
        first_normal_ += static_cast<int64_t>(face.vertices);
    }

    const PlacedMesh &mesh_;
    Blocks &out_;
    PartPoints points_;
    bool coloured_;
    int64_t first_point_ = 1, first_normal_ = 1;
};

} // namespace

ByteSource obj_source(const PlacedMeshPtr &mesh) {
    return source_of([mesh](Blocks &out) { ObjText(*mesh, out).write(); });
}

} // namespace nrb::io
