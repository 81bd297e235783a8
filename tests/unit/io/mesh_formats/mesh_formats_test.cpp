// What files of meshes show: the same triangles where parts stand, seen from outside, with their normals, names and colours; and what
// formats cannot hold.
#include "unit/io/mesh_formats/some_meshes.h"

#include "base/error.h"
#include "io/mesh_formats/write_meshes.h"

#include <clocale>
#include <gtest/gtest.h>
#if __has_include(<nlohmann/json.hpp>)
#include "support/glb_files.h"
#endif

namespace mesh_formats_test {
namespace {

using namespace support::mesh_files;
using io::MeshFormat;

std::string written(const mesh::Mesh &mesh, MeshFormat format, double unit = 0) {
    const io::ByteSource source = io::mesh_source(mesh, static_cast<int32_t>(format), {unit, 0});
    std::string text;
    source([&text](std::string_view block) { text += block; });
    EXPECT_EQ(std::ssize(text), io::size_of(source));
    return text;
}

Status refusal(const mesh::Mesh &mesh, MeshFormat format, double unit = 0) {
    try {
        written(mesh, format, unit);
    } catch (const Error &error) {
        return error.status();
    }
    return Status::ok;
}

double distance(const Point &a, const Point &b) {
    return std::sqrt(dot(minus(a, b), minus(a, b)));
}

// Each corner next to its own, so that triangles turn the same way; normals are across them, on the same side.
bool matches(const Triangle &a, const Triangle &b, double tolerance) {
    const Point across = cross(minus(a.corners[1], a.corners[0]), minus(a.corners[2], a.corners[0]));
    for (size_t shift = 0; shift < 3; ++shift) {
        bool same = true;
        for (size_t k = 0; k < 3; ++k) {
            same = same && distance(a.corners[k], b.corners[(k + shift) % 3]) <= tolerance &&
                   dot(a.normals[k], across) >=
                       0.999 * std::sqrt(dot(across, across) * dot(a.normals[k], a.normals[k])) &&
                   dot(a.normals[k], a.normals[k]) > 0;
        }
        if (same) {
            return true;
        }
    }
    return false;
}

// `scale`: of lengths in the file.
void expect_shown(const Soup &found, const mesh::Mesh &mesh, double scale, double tolerance) {
    const Soup all = wanted(mesh);
    ASSERT_EQ(found.size(), all.size());
    std::vector<bool> used(all.size());
    for (const Triangle &triangle : found) {
        size_t i = 0;
        for (; i < all.size(); ++i) {
            Triangle other = all[i];
            for (Point &corner : other.corners) {
                corner = {scale * corner[0], scale * corner[1], scale * corner[2]};
            }
            if (!used[i] && (triangle.face < 0 || triangle.face == other.face) &&
                matches(triangle, other, tolerance * scale)) {
                break;
            }
        }
        ASSERT_LT(i, all.size()) << "a triangle that the mesh does not have";
        used[i] = true;
    }
}

constexpr double for_floats = 1e-4, for_doubles = 1e-10; // of points of size 100

TEST(MeshFormats, show_the_triangles_from_outside) {
    const mesh::Mesh mesh = two_parts();
    for (const double unit : {0.0, 0.0254}) {
        SCOPED_TRACE(unit);
        const double scale = unit == 0 ? 1 : 0.001 / unit;
        expect_shown(read_stl(written(mesh, MeshFormat::stl, unit)), mesh, scale, for_floats);
        expect_shown(read_stl_text(written(mesh, MeshFormat::stl_text, unit)), mesh, scale, for_floats);
        Soup of_obj = read_obj(written(mesh, MeshFormat::obj, unit)).soup;
        for (Triangle &t : of_obj) {
            t.face = -1; // numbered by groups
        }
        expect_shown(of_obj, mesh, scale, for_doubles);
        expect_shown(read_ply(written(mesh, MeshFormat::ply, unit)), mesh, scale, for_doubles);
        expect_shown(triangles_of(read_vtu(written(mesh, MeshFormat::vtu, unit))), mesh, scale, for_doubles);
    }
}

TEST(MeshFormats, binary_and_text_stl_have_the_same_numbers) {
    const mesh::Mesh mesh = two_parts(2);
    const Soup bytes = read_stl(written(mesh, MeshFormat::stl)),
               text = read_stl_text(written(mesh, MeshFormat::stl_text));
    ASSERT_EQ(bytes.size(), text.size());
    for (size_t i = 0; i < bytes.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) {
            for (size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(bytes[i].corners[k][c], static_cast<float>(text[i].corners[k][c]));
            }
        }
    }
}

TEST(MeshFormats, doubles_are_those_of_the_mesh_bit_for_bit) {
    mesh::Mesh mesh = two_parts();
    mesh.uses = {mesh.uses[3], mesh.uses[3]};
    mesh.uses[0].part = 0;
    mesh.points.front() = {1.0 / 3, -1e-300, 2e17 + 1};
    for (const Soup &soup :
         {read_obj(written(mesh, MeshFormat::obj)).soup, read_ply(written(mesh, MeshFormat::ply)),
          triangles_of(read_vtu(written(mesh, MeshFormat::vtu)))}) {
        const Soup all = wanted(mesh);
        ASSERT_EQ(soup.size(), all.size());
        for (size_t i = 0; i < soup.size(); ++i) {
            EXPECT_EQ(soup[i].corners, all[i].corners) << i;
        }
    }
}

TEST(MeshFormats, obj_has_names_and_common_points) {
    const Obj obj = read_obj(written(two_parts(), MeshFormat::obj));
    EXPECT_EQ(obj.objects, (std::vector<std::string>{"whole", "b\xc3\xa4r", "second", "b\xc3\xa4r"}));
    EXPECT_EQ(obj.points, 4U + 3 * 8);
    ASSERT_EQ(obj.groups.size(), 4U + 3 * 8);
    EXPECT_EQ(obj.groups[2], "face_2");
    ASSERT_EQ(obj.materials.size(), obj.groups.size());
    EXPECT_EQ(obj.materials[0], "colour_cccccc");
    EXPECT_EQ(obj.materials[1], "colour_ff8000");
}

// A line goes on behind a backslash, and ends before a comment; programs stop at bytes that are no text.
TEST(MeshFormats, any_name_is_one_word_of_obj) {
    mesh::Mesh mesh = two_parts();
    mesh.faces[0].name = "bolt #1\\";
    mesh.faces[1].name = "B\xe4r\r\n\x7f";
    mesh.faces[2].name = "b\xc3\xa4r";
    const Obj obj = read_obj(written(mesh, MeshFormat::obj));
    ASSERT_EQ(obj.groups.size(), 4U + 3 * 8);
    EXPECT_EQ(obj.groups[0], "bolt__1_");
    EXPECT_EQ(obj.groups[1], "B_r___");
    EXPECT_EQ(obj.groups[2], "b\xc3\xa4r");
}

TEST(MeshFormats, ply_and_vtu_have_colours_of_faces) {
    const std::array<int, 3> orange{255, 128, 0}, grey{204, 204, 204};
    for (const Soup &soup : {read_ply(written(two_parts(), MeshFormat::ply)),
                             triangles_of(read_vtu(written(two_parts(), MeshFormat::vtu)))}) {
        for (const Triangle &t : soup) {
            EXPECT_EQ(t.colour, t.face == 1 || t.face == 7 ? orange
                                : t.face == 6              ? (std::array{0, 64, 255})
                                                           : grey);
        }
    }
    mesh::Mesh plain = two_parts();
    for (mesh::MeshFace &face : plain.faces) {
        face.colour.reset();
    }
    EXPECT_EQ(read_ply(written(plain, MeshFormat::ply)).front().colour[0], -1);
    EXPECT_EQ(read_vtu(written(plain, MeshFormat::vtu)).arrays.count("colour"), 0U);
}

TEST(MeshFormats, vtu_has_parameters_and_names_its_normals) {
    const Vtu vtu = read_vtu(written(two_parts(), MeshFormat::vtu));
    EXPECT_EQ(vtu.sections.at("PointData").at("Normals"), "normals");
    EXPECT_EQ(vtu.sections.at("VTKFile").at("version"), "1.0");
    EXPECT_EQ(vtu.arrays.at("params").size(), 2 * vtu.points);
    EXPECT_EQ(vtu.arrays.at("params")[2], 1.0); // of corner 2
}

#ifdef NLOHMANN_JSON_VERSION_MAJOR
// In metres, with y upwards.
Soup in_millimetres(Soup soup) {
    for (Triangle &t : soup) {
        for (size_t k = 0; k < 3; ++k) {
            const auto back = [](const Point &x, double scale) {
                return Point{scale * x[0], -scale * x[2], scale * x[1]};
            };
            t.corners[k] = back(t.corners[k], 1000);
            t.normals[k] = back(t.normals[k], 1);
        }
    }
    return soup;
}

TEST(MeshFormats, glb_shows_the_triangles_in_metres) {
    const mesh::Mesh mesh = two_parts();
    for (const double unit : {0.0, 0.0254}) {
        const Glb glb(written(mesh, MeshFormat::glb, unit));
        expect_shown(in_millimetres(glb.triangles()), mesh, 1, for_floats);
    }
}

TEST(MeshFormats, glb_has_nodes_meshes_and_materials) {
    const Glb glb(written(two_parts(), MeshFormat::glb));
    const nlohmann::json &json = glb.json;
    ASSERT_EQ(json["nodes"].size(), 5U);
    EXPECT_EQ(json["nodes"][0]["children"], (std::vector{1, 4}));
    EXPECT_EQ(json["nodes"][1]["children"], (std::vector{2, 3}));
    EXPECT_EQ(json["nodes"][1]["name"], "whole");
    EXPECT_EQ(json["nodes"][2]["name"], "b\xc3\xa4r");
    EXPECT_EQ(json["nodes"][3]["mesh"], 1);
    EXPECT_FALSE(json["nodes"][4].contains("matrix"));
    ASSERT_EQ(json["meshes"].size(), 2U); // of four nodes
    EXPECT_EQ(json["meshes"][0]["name"], "first \"part\"");
    EXPECT_EQ(json["meshes"][0]["primitives"].size(), 2U);
    EXPECT_EQ(json["meshes"][1]["primitives"].size(), 3U);
    ASSERT_EQ(json["materials"].size(), 3U);
    const auto light =
        json["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"].get<std::vector<double>>();
    EXPECT_NEAR(light[1], 0.214041, 1e-6); // of half the signal
    EXPECT_EQ(json["meshes"][0]["primitives"][1]["extras"]["faces"][0]["name"], "face 1");
}
#endif

TEST(MeshFormats, triangles_that_vanish_in_single_precision_are_left_out) {
    mesh::Mesh mesh;
    add_tetrahedron(mesh, 0, {0, 0, 0});
    mesh.parts.emplace_back();
    mesh.uses.emplace_back();
    mesh.points[1] = {0x1p-60, 0, 0}; // next to the first one
    for (Vector3 &x : mesh.points) {
        x = x + Vector3{1, 0, 0};
    }
    const Soup soup = read_stl(written(mesh, MeshFormat::stl));
    EXPECT_EQ(soup.size(), 2U);
    EXPECT_EQ(open_sides(soup), 0);
    EXPECT_EQ(read_stl_text(written(mesh, MeshFormat::stl_text)).size(), 2U);
    EXPECT_EQ(read_ply(written(mesh, MeshFormat::ply)).size(), 4U);
    for (Vector3 &x : mesh.points) {
        x = 0x1p-200 * x;
    }
    EXPECT_EQ(refusal(mesh, MeshFormat::stl), Status::not_representable);
    EXPECT_EQ(refusal(mesh, MeshFormat::stl_text), Status::not_representable);
    EXPECT_EQ(refusal(mesh, MeshFormat::vtu), Status::ok);
}

TEST(MeshFormats, what_formats_cannot_hold_is_refused) {
    mesh::Mesh mesh = two_parts();
    EXPECT_EQ(refusal(mesh, MeshFormat{2}), Status::format);
    EXPECT_EQ(refusal(mesh, MeshFormat{9}), Status::format);
    EXPECT_EQ(refusal(mesh, MeshFormat::stl, 1e-320), Status::options);
    mesh.points[2].y = 1e39;
    for (const MeshFormat format : {MeshFormat::stl, MeshFormat::stl_text, MeshFormat::glb}) {
        EXPECT_EQ(refusal(mesh, format), Status::not_representable);
    }
    EXPECT_EQ(refusal(mesh, MeshFormat::obj), Status::ok);
    EXPECT_EQ(refusal(mesh, MeshFormat::obj, 1e-300), Status::not_representable);
    mesh = two_parts();
    mesh.uses[1].placement[1] = 7;
    EXPECT_EQ(refusal(mesh, MeshFormat::glb), Status::matrix);
    EXPECT_EQ(refusal(mesh, MeshFormat::ply), Status::ok);
    mesh.uses[1].placement.fill(0);
    EXPECT_EQ(refusal(mesh, MeshFormat::ply), Status::matrix);
    mesh = {}; // moved far away and back
    add_tetrahedron(mesh, 1, {0, 0, 0});
    mesh.parts.resize(2);
    mesh.uses = {{-1, 0, model::Use{}.placement, ""}, {0, 1, model::Use{}.placement, ""}};
    mesh.uses[0].placement[3] = 1e305;
    mesh.uses[1].placement[3] = -1e305;
    mesh.metres_per_unit = 1;
    EXPECT_EQ(refusal(mesh, MeshFormat::ply, 1e-4), Status::ok);
    EXPECT_EQ(refusal(mesh, MeshFormat::glb, 1e-4), Status::not_representable);
    mesh = two_parts();
    mesh.triangles.clear();
    for (const auto format : {MeshFormat::stl, MeshFormat::stl_text, MeshFormat::obj, MeshFormat::ply,
                              MeshFormat::glb, MeshFormat::vtu}) {
        EXPECT_EQ(refusal(mesh, format), Status::count);
    }
}

TEST(MeshFormats, a_comma_in_the_locale_changes_nothing) {
    const std::string before = written(two_parts(), MeshFormat::obj),
                      stl = written(two_parts(), MeshFormat::stl_text);
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
        GTEST_SKIP() << "no locale with a decimal comma";
    }
    const bool same =
        written(two_parts(), MeshFormat::obj) == before && written(two_parts(), MeshFormat::stl_text) == stl;
    std::setlocale(LC_ALL, "C");
    EXPECT_TRUE(same);
}

} // namespace
} // namespace mesh_formats_test
