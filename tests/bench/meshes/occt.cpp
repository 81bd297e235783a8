// SPDX-License-Identifier: MIT
// Meshes by Open CASCADE: BRepMesh_IncrementalMesh, without limits of angles, in one thread.
//   bench_meshes_occt SHAPE CHORD [MESH]    a shape of shapes.h, and where its mesh is written
//   bench_meshes_occt FILE CHORD            all faces of a STEP or IGES file
// Patches, planes and polygons are those of shapes.h; spheres, tori and cylinders are its own.
#include "bench/meshes/job.h"
#include "bench/meshes/occt_shapes.h"
#include "bench/meshes/programs.h"
#include "bench/meshes/shapes.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

namespace {

using namespace bench::meshes;

struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

// The ends occur degree + 1 times, the knots inside once.
Knots knots_of(const std::vector<double> &knots, int degree) {
    const int distinct = static_cast<int>(knots.size()) - 2 * degree;
    Knots made{TColStd_Array1OfReal(1, distinct), TColStd_Array1OfInteger(1, distinct)};
    for (int i = 0; i < distinct; ++i) {
        made.values.SetValue(i + 1, knots[static_cast<size_t>(degree + i)]);
        made.multiplicities.SetValue(i + 1, i == 0 || i == distinct - 1 ? degree + 1 : 1);
    }
    return made;
}

Handle(Geom_BSplineSurface) surface_of(const Net &net) {
    TColgp_Array2OfPnt points(1, net.count, 1, net.count);
    TColStd_Array2OfReal weights(1, net.count, 1, net.count);
    for (int i = 0; i < net.count; ++i) {
        for (int j = 0; j < net.count; ++j) {
            const auto at = static_cast<size_t>(i * net.count + j);
            const Point &x = net.points[at];
            points.SetValue(i + 1, j + 1, {x[0], x[1], x[2]});
            weights.SetValue(i + 1, j + 1, net.weights[at]);
        }
    }
    const Knots u = knots_of(net.u_knots, net.degree), v = knots_of(net.v_knots, net.degree);
    return new Geom_BSplineSurface(points, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                   net.degree, net.degree);
}

// A line from each place to the next one, as one curve.
Handle(Geom2d_BSplineCurve) polyline(const std::vector<Param> &places) {
    const auto count = static_cast<int>(places.size());
    TColgp_Array1OfPnt2d points(1, count);
    TColStd_Array1OfReal knots(1, count);
    TColStd_Array1OfInteger multiplicities(1, count);
    for (int i = 1; i <= count; ++i) {
        const Param &at = places[static_cast<size_t>(i - 1)];
        points.SetValue(i, {at[0], at[1]});
        knots.SetValue(i, i - 1);
        multiplicities.SetValue(i, i == 1 || i == count ? 2 : 1);
    }
    return new Geom2d_BSplineCurve(points, knots, multiplicities, 1);
}

// Neighbours have a vertex in common.
TopoDS_Wire segments(const Handle(Geom_BSplineSurface) & surface, const std::vector<Param> &places) {
    std::vector<TopoDS_Vertex> vertices;
    for (const Param &at : places) {
        vertices.push_back(BRepBuilderAPI_MakeVertex(surface->Value(at[0], at[1])));
    }
    BRepBuilderAPI_MakeWire wire;
    for (size_t i = 0; i < places.size(); ++i) {
        const size_t next = (i + 1) % places.size();
        wire.Add(
            BRepBuilderAPI_MakeEdge(polyline({places[i], places[next]}), surface, vertices[i], vertices[next])
                .Edge());
    }
    return wire.Wire();
}

TopoDS_Wire border(const Handle(Geom_BSplineSurface) & surface, Trim trim) {
    std::vector<Param> places = corners();
    if (trim == Trim::segments) {
        return segments(surface, places);
    }
    places.push_back(places.front());
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(polyline(places), surface).Edge()).Wire();
}

TopoDS_Shape face_of(const Net &net, Trim trim) {
    const Handle(Geom_BSplineSurface) surface = surface_of(net);
    if (trim == Trim::none) {
        return BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Shape();
    }
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(surface, border(surface, trim), Standard_True).Shape();
    BRepLib::BuildCurves3d(face);
    return face;
}

TopoDS_Shape shape_of(const Kind &kind) {
    using enum Kind::Surface;
    switch (kind.surface) {
    case patch:
        return face_of(bench::meshes::patch(), kind.trim);
    case plane:
        return face_of(bench::meshes::plane(), kind.trim);
    case sphere:
        return BRepPrimAPI_MakeSphere(1).Shape();
    case torus:
        return BRepPrimAPI_MakeTorus(major, minor).Shape();
    case cylinder:
        break;
    }
    const Handle(Geom_CylindricalSurface) tube = new Geom_CylindricalSurface(gp_Ax3(), 1);
    return BRepBuilderAPI_MakeFace(tube, 0, 2 * std::numbers::pi, 0, height, Precision::Confusion()).Shape();
}

} // namespace

void bench::meshes::mesh_shape(const std::string &name, double chord, const char *path) {
    const Kind kind = kind_of(name);
    TopoDS_Shape shape;
    int64_t triangles = 0;
    const Cost cost = cost_of({[&] { shape = shape_of(kind); }, [&] { make_mesh(shape, chord); },
                               [&] {
                                   const Mesh mesh = mesh_of(shape);
                                   triangles = static_cast<int64_t>(mesh.triangles.size());
                                   if (path != nullptr) {
                                       write(mesh, path);
                                   }
                               },
                               [&] { BRepTools::Clean(shape); }});
    tell(cost, triangles, "");
}

int main(int count, char **arguments) {
    Message::DefaultMessenger()->ChangePrinters().Clear(); // what it says of each file
    try {
        return run(count, arguments);
    } catch (const Standard_Failure &failure) {
        std::fprintf(stderr, "Open CASCADE: %s\n", failure.GetMessageString());
        return 1;
    }
}
