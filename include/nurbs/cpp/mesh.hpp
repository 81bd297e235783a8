/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file mesh.hpp
/// \brief Shapes made of what is straight and flat, within a proven distance.
#ifndef NURBS_CPP_MESH_HPP
#define NURBS_CPP_MESH_HPP

#include <nurbs/cpp/face.hpp>
#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/model.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Flags of meshes.
inline constexpr std::uint32_t mesh_welded = NURBS_MESH_WELDED;

/// How near to a shape its mesh is to be, initialised to the defaults. Later versions of this header may know
/// more of them: where libraries that were compiled with two versions meet in one program, each has to say
/// its own size, and none the other's.
struct MeshOptions : nurbs_mesh_options {
    [[gnu::always_inline]] MeshOptions() : nurbs_mesh_options{} {
        detail::call(nurbs_mesh_options_init, this, static_cast<std::int64_t>(sizeof(nurbs_mesh_options)));
    }
};

/// A polyline in place of a curve: parameters and points of its vertices, and how far it is from the curve,
/// as proven.
struct CurvePolyline {
    std::vector<double> params; ///< Of the vertices, rising; the same one twice where the curve jumps.
    std::vector<double> points; ///< The vertices, packed.
    double bound;               ///< No distance of a segment from its part of the curve is larger.
    bool reached;               ///< Whether all segments keep to the limits, as proven.
};

/// A polyline in place of a curve, every segment within `chord` of its part of the curve, as proven; with an
/// angle between tangents in a segment and a length of segments that are not exceeded either, if they are not
/// 0.
inline Returned<CurvePolyline> mesh_curve(const Spline &g, double chord, double angle = 0,
                                          double longest = 0) {
    CurvePolyline found{};
    std::int32_t reached = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_mesh_curve, g.get(), chord, angle, longest, cap, found.params.data(),
                     found.points.data(), &found.bound, &reached, &count);
    };
    ask(0);
    found.params = detail::room(count);
    found.points = detail::room(count, detail::dimension(g.get()));
    ask(count);
    found.reached = reached != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<CurvePolyline> mesh_curve(const Spline &g, double chord, double angle, double longest,
                                          const CallOptions &call) {
    CurvePolyline found{};
    const detail::Watch watch(call);
    std::int32_t reached = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_mesh_curve_with, g.get(), chord, angle, longest, cap, found.params.data(),
                     found.points.data(), &found.bound, &reached, &count, watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found.points = detail::room(count, detail::dimension(g.get()));
    ask(count);
    found.reached = reached != 0;
    return found;
}

/// How much a mesh holds.
struct MeshCounts {
    std::int64_t points;      ///< Number of points.
    std::int64_t vertices;    ///< Number of vertices.
    std::int64_t triangles;   ///< Number of triangles.
    std::int64_t faces;       ///< Number of faces.
    std::int64_t edges;       ///< Number of polylines of edges.
    std::int64_t edge_points; ///< Number of their vertices, all together.
};

/// How far a mesh and its shape are from each other, as proven.
struct MeshBound {
    double from_shape; ///< No point of the shape is farther from the mesh.
    double from_mesh;  ///< No point of the mesh is farther from the shape.
    bool reached;      ///< Whether all that was asked for is proven.
};

/// The vertices of a mesh, those of each face one after the other.
struct MeshVertices {
    std::vector<std::int64_t> points; ///< The point at which each is.
    std::vector<double> params;       ///< [n][2] of the surface of the face.
    std::vector<double> normals;      ///< [n][3], of length 1; NaN where there is none.
};

/// The vertices of a mesh as programs that draw want them.
struct DrawableVertices {
    std::vector<float> points;  ///< [n][3] in space.
    std::vector<float> params;  ///< [n][2] of the surface of the face.
    std::vector<float> normals; ///< [n][3], of length 1; NaN where there is none.
};

/// Pairs of triangles that are all of a cell of the domain.
struct MeshQuads {
    /// [n][4] vertices, or points, of which 0, 1, 2 and 0, 2, 3 are the triangles.
    std::vector<std::int64_t> corners;
    /// The first of the two triangles of each; the next one is the second.
    std::vector<std::int64_t> triangles;
};

/// What of a mesh stands for which face.
struct MeshFaces {
    std::vector<std::int64_t> first_vertices;  ///< The first vertex.
    std::vector<std::int64_t> vertex_counts;   ///< The number of vertices.
    std::vector<std::int64_t> first_triangles; ///< The first triangle.
    std::vector<std::int64_t> triangle_counts; ///< The number of triangles.
    std::vector<double> from_shape;            ///< No point of the face is farther from its triangles.
    std::vector<double> from_mesh;             ///< No point of its triangles is farther from the face.
    std::vector<std::int32_t> reached;         ///< 1 where all that was asked for is proven, else 0.
};

/// The polylines that stand for edges in a mesh.
struct MeshEdges {
    std::vector<std::int64_t> edges;  ///< The edge of the model; -1 for one that belongs to one face only.
    std::vector<std::int64_t> firsts; ///< Its first vertex among those of all polylines.
    std::vector<std::int64_t> sizes;  ///< The number of its vertices.
    /// No point of the edge is farther from the polyline, and none of that from the edge.
    std::vector<double> bounds;
    std::vector<std::int32_t> reached; ///< 1 where all that was asked for is proven, else 0.
};

/// Hexahedra in place of a volume, last axis fastest.
struct MeshHexahedra {
    std::vector<std::int64_t> corners; ///< [n][8] points, in the order of VTK_HEXAHEDRON.
    std::vector<double> domains;       ///< [n][3][2] ends along each axis of the volume.
    std::vector<std::int32_t> folds;   ///< A fold_ constant: whether the volume folds there.
    /// 1 or -1: the sign of the Jacobian of the volume there, if it is proven to be one; else 0.
    std::vector<std::int32_t> signs;
};

/// A spline as Bezier cells.
struct BezierCells {
    std::vector<std::int64_t> cells; ///< [n][M] control points of each, in the order of VTK.
    std::int32_t kind;               ///< What VTK calls such cells.
    std::int64_t point_count;        ///< The number of control points.
};

/// The polynomial pieces as Bezier cells in the order of VTK, by places in bezier_cell_points.
inline Returned<BezierCells> bezier_cells(const Spline &g) {
    BezierCells found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_bezier_cells, g.get(), cap, found.cells.data(), &found.kind, &found.point_count,
                     &count);
    };
    ask(0);
    found.cells = detail::room<std::int64_t>(count, detail::active(g.get()));
    ask(count);
    return found;
}

/// The control points of Bezier cells, each once.
struct BezierCellPoints {
    std::vector<double> points;  ///< [n][dim].
    std::vector<double> weights; ///< Their weights.
};

/// The control points of the Bezier cells, each once, and their weights.
inline Returned<BezierCellPoints> bezier_cell_points(const Spline &g) {
    BezierCellPoints found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_bezier_cell_points, g.get(), cap, found.points.data(), found.weights.data(),
                     &count);
    };
    ask(0);
    found.points = detail::room(count, detail::dimension(g.get()));
    found.weights = detail::room(count);
    ask(count);
    return found;
}

/// Triangles in place of shapes: a handle that is copied in constant time and freed by its destructor.
class Mesh : public detail::MeshHandle {
public:
    using MeshHandle::MeshHandle;

    // Shapes made of what is straight and flat, within a proven distance

    /// Triangles in place of a whole surface, within a proven distance, both ways.
    [[nodiscard]] static Returned<Mesh> of_surface(const Spline &g, const MeshOptions &options = {}) {
        return detail::made<Mesh>(nurbs_mesh_surface, g.get(), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Mesh> of_surface(const Spline &g, const MeshOptions &options,
                                                   const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Mesh>(nurbs_mesh_surface_with, g.get(), &options, watch.get());
    }
    /// Triangles in place of a trimmed face, within a proven distance, both ways.
    [[nodiscard]] static Returned<Mesh> of_face(const Face &face, const MeshOptions &options = {}) {
        return detail::made<Mesh>(nurbs_mesh_face, face.get(), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Mesh> of_face(const Face &face, const MeshOptions &options,
                                                const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Mesh>(nurbs_mesh_face_with, face.get(), &options, watch.get());
    }
    /// Triangles in place of all faces of a model, with common points along common edges.
    [[nodiscard]] static Returned<Mesh> of_model(const Model &model, const MeshOptions &options = {}) {
        return detail::made<Mesh>(nurbs_mesh_model, model.get(), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Mesh> of_model(const Model &model, const MeshOptions &options,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Mesh>(nurbs_mesh_model_with, model.get(), &options, watch.get());
    }
    /// Hexahedra in place of a volume, within a proven distance, on a grid of lines along its axes; at most so
    /// many if `limit` is not 0.
    [[nodiscard]] static Returned<Mesh> of_volume(const Spline &g, const MeshOptions &options = {},
                                                  std::int64_t limit = 0) {
        return detail::made<Mesh>(nurbs_mesh_volume, g.get(), &options, limit);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Mesh> of_volume(const Spline &g, const MeshOptions &options,
                                                  std::int64_t limit, const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Mesh>(nurbs_mesh_volume_with, g.get(), &options, limit, watch.get());
    }
    /// How much it holds.
    [[nodiscard]] Returned<MeshCounts> counts() const {
        MeshCounts found{};
        detail::call(nurbs_mesh_counts, get(), &found.points, &found.vertices, &found.triangles, &found.faces,
                     &found.edges, &found.edge_points);
        return found;
    }
    /// How far the mesh and its shape are from each other, as proven.
    [[nodiscard]] Returned<MeshBound> bound() const {
        MeshBound found{};
        std::int32_t reached = 0;
        detail::call(nurbs_mesh_bound, get(), &found.from_shape, &found.from_mesh, &reached);
        found.reached = reached != 0;
        return found;
    }
    /// The points, [n][3].
    [[nodiscard]] Returned<std::vector<double>> points() const {
        std::vector<double> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_points, get(), cap, values.data(), &count);
        };
        ask(0);
        values = detail::room(count, 3);
        ask(count);
        return values;
    }
    /// The points, [n][3], in single precision.
    [[nodiscard]] Returned<std::vector<float>> points_f32() const {
        std::vector<float> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_points_f32, get(), cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<float>(count, 3);
        ask(count);
        return values;
    }
    /// The vertices, those of each face one after the other.
    [[nodiscard]] Returned<MeshVertices> vertices() const {
        MeshVertices found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_vertices, get(), cap, found.points.data(), found.params.data(),
                         found.normals.data(), &count);
        };
        ask(0);
        found.points = detail::room<std::int64_t>(count);
        found.params = detail::room(count, 2);
        found.normals = detail::room(count, 3);
        ask(count);
        return found;
    }
    /// The vertices as programs that draw want them, in single precision, with their points.
    [[nodiscard]] Returned<DrawableVertices> vertices_f32() const {
        DrawableVertices found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_vertices_f32, get(), cap, found.points.data(), found.params.data(),
                         found.normals.data(), &count);
        };
        ask(0);
        found.points = detail::room<float>(count, 3);
        found.params = detail::room<float>(count, 2);
        found.normals = detail::room<float>(count, 3);
        ask(count);
        return found;
    }
    /// The corners of triangles, [n][3]: vertices, or with mesh_welded points.
    [[nodiscard]] Returned<std::vector<std::int64_t>> triangles(std::uint32_t flags = 0) const {
        std::vector<std::int64_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_triangles, get(), flags, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int64_t>(count, 3);
        ask(count);
        return values;
    }
    /// The corners of triangles, [n][3], in 32 bits: vertices, or with mesh_welded points.
    [[nodiscard]] Returned<std::vector<std::int32_t>> triangles_i32(std::uint32_t flags = 0) const {
        std::vector<std::int32_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_triangles_i32, get(), flags, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int32_t>(count, 3);
        ask(count);
        return values;
    }
    /// Pairs of triangles that are all of a cell: their corners, vertices or with mesh_welded points.
    [[nodiscard]] Returned<MeshQuads> quads(std::uint32_t flags = 0) const {
        MeshQuads found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_quads, get(), flags, cap, found.corners.data(), found.triangles.data(),
                         &count);
        };
        ask(0);
        found.corners = detail::room<std::int64_t>(count, 4);
        found.triangles = detail::room<std::int64_t>(count);
        ask(count);
        return found;
    }
    /// What of it stands for which face, and how far that is from the face.
    [[nodiscard]] Returned<MeshFaces> faces() const {
        MeshFaces found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_faces, get(), cap, found.first_vertices.data(),
                         found.vertex_counts.data(), found.first_triangles.data(),
                         found.triangle_counts.data(), found.from_shape.data(), found.from_mesh.data(),
                         found.reached.data(), &count);
        };
        ask(0);
        found.first_vertices = detail::room<std::int64_t>(count);
        found.vertex_counts = detail::room<std::int64_t>(count);
        found.first_triangles = detail::room<std::int64_t>(count);
        found.triangle_counts = detail::room<std::int64_t>(count);
        found.from_shape = detail::room(count);
        found.from_mesh = detail::room(count);
        found.reached = detail::room<std::int32_t>(count);
        ask(count);
        return found;
    }
    /// The polylines that stand for edges.
    [[nodiscard]] Returned<MeshEdges> edges() const {
        MeshEdges found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_edges, get(), cap, found.edges.data(), found.firsts.data(),
                         found.sizes.data(), found.bounds.data(), found.reached.data(), &count);
        };
        ask(0);
        found.edges = detail::room<std::int64_t>(count);
        found.firsts = detail::room<std::int64_t>(count);
        found.sizes = detail::room<std::int64_t>(count);
        found.bounds = detail::room(count);
        found.reached = detail::room<std::int32_t>(count);
        ask(count);
        return found;
    }
    /// The points of the mesh that polylines of edges have, one polyline after the other.
    [[nodiscard]] Returned<std::vector<std::int64_t>> edge_points() const {
        std::vector<std::int64_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_edge_points, get(), cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int64_t>(count);
        ask(count);
        return values;
    }
    /// Writes it to a file, which is replaced whole or not at all.
    Returned<void> write_file(const std::string &path, std::int32_t format,
                              const WriteOptions &options = {}) const {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        return detail::call(nurbs_mesh_write_file, get(), path.c_str(), format, &options);
    }
    /// The same; `call` can watch and end it.
    Returned<void> write_file(const std::string &path, std::int32_t format, const WriteOptions &options,
                              const CallOptions &call) const {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        const detail::Watch watch(call);
        return detail::call(nurbs_mesh_write_file_with, get(), path.c_str(), format, &options, watch.get());
    }
    /// The hexahedra of the mesh of a volume.
    [[nodiscard]] Returned<MeshHexahedra> hexahedra() const {
        MeshHexahedra found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_mesh_hexahedra, get(), cap, found.corners.data(), found.domains.data(),
                         found.folds.data(), found.signs.data(), &count);
        };
        ask(0);
        found.corners = detail::room<std::int64_t>(count, 8);
        found.domains = detail::room(count, 3, 2);
        found.folds = detail::room<std::int32_t>(count);
        found.signs = detail::room<std::int32_t>(count);
        ask(count);
        return found;
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MESH_HPP
