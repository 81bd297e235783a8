// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/watch.h"
#include "io/mesh_formats/gltf_scene.h"
#include "io/mesh_formats/json_writer.h"
#include "io/written/similarity.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {

namespace {

// Constants of the standard: types of components, and targets of buffer views.
constexpr int float_component = 5126, index_component = 5125, vertex_target = 34962, index_target = 34963;

// From sRGB, as for screens, to the linear amount of light that glTF wants (IEC 61966-2-1), rounded to 1e-6.
double amount_of_light(double value) noexcept {
    const double x = std::clamp(value, 0.0, 1.0);
    const double light = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    return std::round(light * 1e6) / 1e6;
}

class GltfText {
public:
    GltfText(const PlacedMesh &mesh, const GltfScene &scene, double metres)
        : mesh_(mesh), own_(mesh.mesh()), scene_(scene), metres_(metres),
          instances_(model::instances_of(own_.parts.size(), own_.uses)) {}

    std::string text() {
        json_.object([&] {
            json_.key("asset").object([&] { json_.pair("version", "2.0").pair("generator", "libnurbs"); });
            json_.pair("scene", 0);
            json_.key("scenes").array(
                [&] { json_.object([&] { json_.key("nodes").array([&] { json_ << 0; }); }); });
            write_nodes();
            write_meshes();
            json_.key("materials").array([&] {
                for (const auto &colour : scene_.materials) {
                    write_material(colour);
                }
            });
            write_accessors();
            write_views();
        });
        return json_.text();
    }

private:
    // Node 0 is the whole; node i + 1 is instance i.
    void write_nodes() {
        std::vector<std::vector<int64_t>> children(instances_.size() + 1);
        for (size_t i = 0; i < instances_.size(); ++i) {
            children[static_cast<size_t>(instances_[i].parent + 1)].push_back(static_cast<int64_t>(i) + 1);
        }
        json_.key("nodes").array([&] {
            json_.object([&] {
                json_.pair("matrix", whole());
                write_children(children[0]);
            });
            for (size_t i = 0; i < instances_.size(); ++i) {
                write_node(instances_[i], children[i + 1]);
                count_work(64);
            }
        });
    }

    // The matrix that maps (x, y, z) to (x, z, -y) in metres, column by column.
    [[nodiscard]] std::array<double, 16> whole() const noexcept {
        const double m = metres_;
        return {m, 0, 0, 0, 0, 0, -m, 0, 0, m, 0, 0, 0, 0, 0, 1};
    }

    void write_children(const std::vector<int64_t> &children) {
        if (!children.empty()) {
            json_.pair("children", children);
        }
    }

    void write_node(const model::Instance &instance, const std::vector<int64_t> &children) {
        json_.object([&] {
            if (const std::string &name = name_of(own_, instance.use); !name.empty()) {
                json_.pair("name", name);
            }
            if (const auto mesh = mesh_number_[static_cast<size_t>(instance.part)]; mesh >= 0) {
                json_.pair("mesh", mesh);
            }
            const auto &placement = own_.uses[static_cast<size_t>(instance.use)].placement;
            if (!is_identity(placement)) {
                json_.pair("matrix", matrix_of(instance.use, placement));
            }
            write_children(children);
        });
    }

    // The matrix of a placement, column by column, with the translation in the unit of the points.
    [[nodiscard]] std::array<double, 16> matrix_of(int64_t use,
                                                   const std::array<double, 12> &placement) const {
        const Columns m = columns_of(placement);
        if (scale_of(m) == 0) {
            fail(Status::matrix, "the placement of use %lld is no similarity, which glTF cannot hold",
                 static_cast<long long>(use));
        }
        const Vector3 shift = mesh_.factor() * m.shift;
        if (!std::isfinite(largest(shift))) {
            fail(Status::not_representable, "the placement of use %lld overflows in the unit of the file",
                 static_cast<long long>(use));
        }
        return {m.x.x, m.x.y, m.x.z, 0, m.y.x,   m.y.y,   m.y.z,   0,
                m.z.x, m.z.y, m.z.z, 0, shift.x, shift.y, shift.z, 1};
    }

    void write_meshes() {
        json_.key("meshes").array([&] {
            for (size_t part = 0; part < scene_.parts.size(); ++part) {
                if (!scene_.parts[part].empty()) {
                    write_mesh(own_.parts[part].name, scene_.parts[part]);
                }
            }
        });
    }

    void write_mesh(const std::string &name, const std::vector<Primitive> &primitives) {
        json_.object([&] {
            if (!name.empty()) {
                json_.pair("name", name);
            }
            json_.key("primitives").array([&] {
                for (const Primitive &primitive : primitives) {
                    write_primitive(primitive);
                }
            });
        });
    }

    // Each primitive has three consecutive accessors: points, normals and indices.
    void write_primitive(const Primitive &primitive) {
        json_.object([&] {
            json_.key("attributes").object([&] {
                json_.pair("POSITION", accessor_).pair("NORMAL", accessor_ + 1);
            });
            json_.pair("indices", accessor_ + 2).pair("material", primitive.material);
            json_.key("extras").object([&] { write_faces(primitive); });
        });
        accessor_ += 3;
    }

    // Writes which triangles belong to which face.
    void write_faces(const Primitive &primitive) {
        int64_t first = 0;
        json_.key("faces").array([&] {
            for (const MeshFace *face : primitive.faces) {
                const auto triangles = static_cast<int64_t>(face->triangles);
                json_.object([&] {
                    json_.pair("face", mesh_.face_number(*face)).pair("name", face->name);
                    json_.pair("first", first).pair("triangles", triangles);
                });
                first += triangles;
            }
        });
    }

    void write_material(const std::optional<std::array<double, 3>> &colour) {
        std::array<double, 4> factor{0.6, 0.6, 0.6, 1};
        for (size_t k = 0; colour && k < 3; ++k) {
            factor[k] = amount_of_light((*colour)[k]);
        }
        json_.object([&] {
            json_.key("pbrMetallicRoughness").object([&] {
                json_.pair("baseColorFactor", factor);
                json_.pair("metallicFactor", 0).pair("roughnessFactor", 0.5);
            });
            json_.pair("doubleSided", true); // open shells are seen from both sides
        });
    }

    void write_accessors() {
        json_.key("accessors").array([&] {
            for (const std::vector<Primitive> &part : scene_.parts) {
                for (const Primitive &primitive : part) {
                    write_accessors(primitive);
                }
            }
        });
    }

    void write_accessors(const Primitive &primitive) {
        const int64_t place = bytes_of_vector * primitive.first_vertex;
        json_.object([&] {
            write_accessor(0, place, float_component, primitive.vertices, "VEC3");
            json_.pair("min", exact(primitive.least)).pair("max", exact(primitive.most));
        });
        json_.object([&] { write_accessor(1, place, float_component, primitive.vertices, "VEC3"); });
        json_.object([&] {
            write_accessor(2, bytes_of_index * primitive.first_index, index_component, primitive.indices,
                           "SCALAR");
        });
    }

    void write_accessor(int view, int64_t place, int component, int64_t count, const char *type) {
        json_.pair("bufferView", view).pair("byteOffset", place).pair("componentType", component);
        json_.pair("count", count).pair("type", type);
    }

    // Converts to double, since the shortest digits of a float identify another double.
    static std::array<double, 3> exact(const std::array<float, 3> &x) noexcept { return {x[0], x[1], x[2]}; }

    void write_views() {
        const int64_t vectors = bytes_of_vector * scene_.vertices, indices = bytes_of_index * scene_.indices;
        json_.key("bufferViews").array([&] {
            write_view(0, vectors, vertex_target);
            write_view(vectors, vectors, vertex_target);
            write_view(2 * vectors, indices, index_target);
        });
        json_.key("buffers").array(
            [&] { json_.object([&] { json_.pair("byteLength", 2 * vectors + indices); }); });
    }

    void write_view(int64_t place, int64_t length, int target) {
        json_.object([&] {
            json_.pair("buffer", 0).pair("byteOffset", place).pair("byteLength", length);
            if (target == vertex_target) {
                json_.pair("byteStride", bytes_of_vector);
            }
            json_.pair("target", target);
        });
    }

    // The number of the mesh of each part; -1 for a part without triangles.
    static std::vector<int64_t> numbers_of_meshes(const GltfScene &scene) {
        std::vector<int64_t> numbers;
        int64_t next = 0;
        for (const std::vector<Primitive> &part : scene.parts) {
            numbers.push_back(part.empty() ? -1 : next++);
        }
        return numbers;
    }

    const PlacedMesh &mesh_;
    const Mesh &own_;
    const GltfScene &scene_;
    double metres_;
    std::vector<model::Instance> instances_;
    std::vector<int64_t> mesh_number_ = numbers_of_meshes(scene_);
    JsonWriter json_;
    int64_t accessor_ = 0;
};

} // namespace

std::string gltf_text(const PlacedMesh &mesh, const GltfScene &scene, double metres) {
    return GltfText(mesh, scene, metres).text();
}

} // namespace nrb::io
