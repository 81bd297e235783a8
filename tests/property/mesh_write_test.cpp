// Files of meshes, read by readers of the tests' own: they show the triangles of the mesh, those of open shapes as they turn, and
// those of closed ones from outside, whichever way their surfaces run.
#include "property/faces.h"
#include "property/solids.h"
#include "support/mesh_files.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#if __has_include(<nlohmann/json.hpp>)
#include "support/glb_files.h"
#endif

namespace mesh_write_test {

using namespace support;
using namespace support::mesh_files;
using faces::pi;

namespace {

struct DestroyMesh {
    void operator()(nurbs_mesh *mesh) const noexcept { nurbs_mesh_destroy(mesh); }
};
using Mesh = std::unique_ptr<nurbs_mesh, DestroyMesh>;

template <class Shape, class Function>
Mesh mesh_of(const Shape *shape, Function make, double relative) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.relative_chord = relative;
    nurbs_mesh *mesh = nullptr;
    require_ok(make(shape, &options, &mesh));
    return Mesh(mesh);
}
Mesh mesh_of(const nurbs *g, double relative = 0.01) {
    return mesh_of(g, nurbs_mesh_surface, relative);
}
Mesh mesh_of(const nurbs_model *model, double relative = 0.01) {
    return mesh_of(model, nurbs_mesh_model, relative);
}

std::string written(const nurbs_mesh *mesh, int32_t format) {
    int64_t size = 0;
    require_ok(nurbs_mesh_write(mesh, format, nullptr, 0, nullptr, &size));
    std::string bytes(static_cast<size_t>(size), ' ');
    require_ok(nurbs_mesh_write(mesh, format, nullptr, size, bytes.data(), nullptr));
    return bytes;
}

#ifdef NLOHMANN_JSON_VERSION_MAJOR
// In the unit of the model, with z upwards: x, y, z were x, z, -y in metres.
Soup read_glb(const std::string &file) {
    const Glb glb(file);
    const double metres = glb.json["nodes"][0]["matrix"][0];
    Soup soup = glb.triangles();
    for (Triangle &t : soup) {
        for (size_t k = 0; k < 3; ++k) {
            for (mesh_files::Point *x : {&t.corners[k], &t.normals[k]}) {
                *x = {(*x)[0] / metres, -(*x)[2] / metres, (*x)[1] / metres};
            }
        }
    }
    return soup;
}
#endif

struct File {
    const char *name;
    Soup soup;
    bool single;
    bool of_facets = false; // without triangles that vanish in single precision
};
// All formats.
std::vector<File> files_of(const nurbs_mesh *mesh) {
    std::vector<File> files;
    files.push_back({"STL", read_stl(written(mesh, NURBS_FORMAT_STL)), true, true});
    files.push_back({"text", read_stl_text(written(mesh, NURBS_FORMAT_STL_TEXT)), true, true});
    files.push_back({"OBJ", read_obj(written(mesh, NURBS_FORMAT_OBJ)).soup, false});
    files.push_back({"PLY", read_ply(written(mesh, NURBS_FORMAT_PLY)), false});
    files.push_back({"VTU", triangles_of(read_vtu(written(mesh, NURBS_FORMAT_VTU))), false});
#ifdef NLOHMANN_JSON_VERSION_MAJOR
    files.push_back({"GLB", read_glb(written(mesh, NURBS_FORMAT_GLB)), true});
#endif
    return files;
}

// As the mesh itself has them, in its order.
Soup triangles_of(const nurbs_mesh *mesh) {
    int64_t points = 0, triangles = 0;
    require_ok(nurbs_mesh_counts(mesh, &points, nullptr, &triangles, nullptr, nullptr, nullptr));
    std::vector<mesh_files::Point> xyz(static_cast<size_t>(points));
    std::vector<std::array<int64_t, 3>> corners(static_cast<size_t>(triangles));
    require_ok(nurbs_mesh_points(mesh, points, xyz[0].data(), nullptr));
    require_ok(nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, triangles, corners[0].data(), nullptr));
    Soup soup;
    for (const auto &corner : corners) {
        Triangle t;
        for (size_t k = 0; k < 3; ++k) {
            t.corners[k] = xyz[static_cast<size_t>(corner[k])];
        }
        soup.push_back(t);
    }
    return soup;
}

double distance(const mesh_files::Point &a, const mesh_files::Point &b) {
    return std::sqrt(dot(minus(a, b), minus(a, b)));
}

double size_of(const Soup &soup) {
    double most = 0;
    for (const Triangle &t : soup) {
        for (const mesh_files::Point &x : t.corners) {
            most = std::max({most, std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
        }
    }
    return most;
}

// The same, or its mirror image where turning is allowed. GLB has another unit, which may move a point by rounding.
void expect_triangle(const Triangle &found, const Triangle &own, double tolerance, bool may_turn) {
    const bool turned = distance(found.corners[1], own.corners[1]) > tolerance;
    EXPECT_TRUE(may_turn || !turned);
    for (size_t k = 0; k < 3; ++k) {
        EXPECT_LE(distance(found.corners[turned ? (3 - k) % 3 : k], own.corners[k]), tolerance);
    }
}

bool vanishes(const Triangle &t) {
    const auto rounded = [&t](size_t k) {
        return std::array{static_cast<float>(t.corners[k][0]), static_cast<float>(t.corners[k][1]),
                          static_cast<float>(t.corners[k][2])};
    };
    return rounded(0) == rounded(1) || rounded(1) == rounded(2) || rounded(2) == rounded(0);
}

void expect_triangles(const nurbs_mesh *mesh, const std::vector<File> &files, bool may_turn) {
    for (const File &file : files) {
        SCOPED_TRACE(file.name);
        Soup all = triangles_of(mesh);
        if (file.of_facets) {
            all.erase(std::remove_if(all.begin(), all.end(), vanishes), all.end());
        }
        ASSERT_EQ(file.soup.size(), all.size());
        const double tolerance = file.single ? 4e-7 * size_of(all) : 0;
        for (size_t i = 0; i < all.size(); ++i) {
            expect_triangle(file.soup[i], all[i], tolerance, may_turn);
        }
    }
}

// Closed, and with normals on the outside of the triangles, which enclose what they should.
void expect_outside(const std::vector<File> &files, double enclosed, double tolerance) {
    for (const File &file : files) {
        SCOPED_TRACE(file.name);
        EXPECT_NEAR(volume(file.soup), enclosed, tolerance);
        EXPECT_EQ(std::string(file.name) == "GLB" ? 0 : open_sides(file.soup), 0); // products may round apart
        for (const Triangle &t : file.soup) {
            const mesh_files::Point across =
                cross(minus(t.corners[1], t.corners[0]), minus(t.corners[2], t.corners[0]));
            for (const mesh_files::Point &normal : t.normals) {
                EXPECT_GT(dot(normal, across), 0);
                EXPECT_NEAR(dot(normal, normal), 1, 1e-6);
            }
        }
    }
}

TEST(MeshWrite, open_surfaces_turn_as_they_are) {
    Random random(31);
    for (int i = 0; i < 10; ++i) {
        SCOPED_TRACE(i);
        const faces::Ground ground = faces::wavy(random);
        const Mesh mesh = mesh_of(ground.surface.get());
        expect_triangles(mesh.get(), files_of(mesh.get()), false);
    }
}

TEST(MeshWrite, boxes_are_seen_from_outside_whichever_way_their_sides_run) {
    Random random(32);
    for (int i = 0; i < 10; ++i) {
        SCOPED_TRACE(i);
        std::array<double, 3> size{};
        std::vector<solids::Face> sides = solids::box(random, size);
        std::rotate(sides.begin(), sides.begin() + random.whole(0, 5), sides.end());
        const models::Model model = models::model_of(solids::given(sides));
        const Mesh mesh = mesh_of(model.get());
        const std::vector<File> files = files_of(mesh.get());
        expect_outside(files, size[0] * size[1] * size[2], 1e-5);
    }
}

TEST(MeshWrite, closed_surfaces_alone_are_seen_from_outside) {
    const double third = 4 * pi / 3;
    struct Case {
        faces::Ground ground;
        double enclosed;
    };
    for (const Case &own : {Case{faces::sphere(2), 8 * third}, Case{faces::torus(3, 1), 6 * pi * pi}}) {
        for (const bool reversed : {false, true}) {
            const nurbs *g = own.ground.surface.get();
            const Handle surface = made(
                [&](nurbs **out) { return reversed ? nurbs_reverse(g, 0, 0, out) : nurbs_clone(g, out); });
            const Mesh mesh = mesh_of(surface.get(), 1e-3);
            const std::vector<File> files = files_of(mesh.get());
            expect_triangles(mesh.get(), files, true);
            expect_outside(files, own.enclosed, 0.01 * own.enclosed);
        }
    }
}

TEST(MeshWrite, a_cylinder_of_three_faces_is_seen_from_outside) {
    const std::vector<solids::Face> sides = solids::closed_cylinder(2, 3);
    const models::Model model = models::model_of(solids::given(sides));
    const Mesh mesh = mesh_of(model.get(), 1e-3);
    expect_outside(files_of(mesh.get()), 12 * pi, 0.2);
}

TEST(MeshWrite, real_solids_are_seen_from_outside) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const char *const name : {"countersunk_screw.step", "satellite_mainbody.stp"}) {
        SCOPED_TRACE(name);
        nurbs_model *read = nullptr;
        require_ok(nurbs_read_model_file((std::filesystem::path(folder) / name).c_str(), nullptr, &read));
        const models::Model model(read);
        double enclosed = 0;
        require_ok(nurbs_model_volume(model.get(), 1e-6, &enclosed, nullptr, nullptr, nullptr, nullptr));
        const Mesh mesh = mesh_of(model.get(), 1e-3);
        const std::string stl = written(mesh.get(), NURBS_FORMAT_STL),
                          vtu = written(mesh.get(), NURBS_FORMAT_VTU);
        for (const Soup &soup : {read_stl(stl), triangles_of(read_vtu(vtu))}) {
            EXPECT_EQ(open_sides(soup), 0);
            EXPECT_NEAR(volume(soup), enclosed, 0.01 * enclosed);
        }
    }
}

} // namespace

} // namespace mesh_write_test
