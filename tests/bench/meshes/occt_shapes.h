// SPDX-License-Identifier: MIT
// Meshes of Open CASCADE, made and as arrays.
#pragma once

#include "bench/meshes/mesh.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <numbers>

namespace bench::meshes {

inline void make_mesh(const TopoDS_Shape &shape, double chord) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = chord;
    parameters.Angle = std::numbers::pi;
    parameters.InParallel = Standard_False;
    BRepMesh_IncrementalMesh(shape, parameters);
}

// Every face once, as often as it may be placed.
inline TopTools_IndexedMapOfShape faces_of(const TopoDS_Shape &shape) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return faces;
}

// Without triangles where it has no mesh.
inline void append(const TopoDS_Face &face, Mesh &mesh) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) made = BRep_Tool::Triangulation(face, place);
    if (made.IsNull()) {
        return;
    }
    const auto first = static_cast<int64_t>(mesh.points.size()) - 1;
    for (int i = 1; i <= made->NbNodes(); ++i) {
        const gp_Pnt x = made->Node(i).Transformed(place.Transformation());
        const gp_Pnt2d at = made->HasUVNodes() ? made->UVNode(i) : gp_Pnt2d();
        mesh.points.push_back({x.X(), x.Y(), x.Z()});
        mesh.params.push_back({at.X(), at.Y()});
    }
    for (int i = 1; i <= made->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        made->Triangle(i).Get(a, b, c);
        mesh.triangles.push_back({first + a, first + b, first + c});
    }
}

inline Mesh mesh_of(const TopoDS_Shape &shape) {
    Mesh mesh;
    const TopTools_IndexedMapOfShape faces = faces_of(shape);
    for (int i = 1; i <= faces.Extent(); ++i) {
        append(TopoDS::Face(faces(i)), mesh);
    }
    return mesh;
}

} // namespace bench::meshes
