// SPDX-License-Identifier: MIT
// The faces of files meshed by Open CASCADE.
#include "bench/meshes/job.h"
#include "bench/meshes/occt_shapes.h"
#include "bench/meshes/programs.h"
#include "bench/meshes/verdict.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Surface.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>

namespace {

using namespace bench::meshes;

template <class Reader>
TopoDS_Shape read_by(const std::string &path) {
    Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        std::fprintf(stderr, "%s is not read\n", path.c_str());
        std::exit(1);
    }
    return reader.OneShape();
}

Jet jet_of(const Handle(Geom_Surface) & surface, const Param &at) {
    gp_Pnt x;
    gp_Vec u, v;
    surface->D1(at[0], at[1], x, u, v);
    return {{x.X(), x.Y(), x.Z()}, {u.X(), u.Y(), u.Z()}, {v.X(), v.Y(), v.Z()}};
}

Verdict verdict_of(const TopoDS_Shape &shape) {
    Verdict verdict;
    const TopTools_IndexedMapOfShape faces = faces_of(shape);
    for (int i = 1; i <= faces.Extent(); ++i) {
        const TopoDS_Face &face = TopoDS::Face(faces(i));
        Mesh mesh;
        append(face, mesh);
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties, 1e-4);
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
        Domain domain{};
        surface->Bounds(domain.lower[0], domain.upper[0], domain.lower[1], domain.upper[1]);
        verdict.add(mesh, std::fabs(properties.Mass()), INFINITY, domain,
                    [&](const Param &at) { return jet_of(surface, at); });
    }
    return verdict;
}

} // namespace

void bench::meshes::mesh_file(const std::string &path, double chord) {
    const TopoDS_Shape shape =
        is_iges(path) ? read_by<IGESControl_Reader>(path) : read_by<STEPControl_Reader>(path);
    int64_t triangles = 0;
    Verdict verdict;
    const Cost cost = cost_of({[&] { BRepTools::Clean(shape); }, [&] { make_mesh(shape, chord); },
                               [&] {
                                   triangles = static_cast<int64_t>(mesh_of(shape).triangles.size());
                                   verdict = verdict_of(shape);
                               },
                               [] {}});
    tell(cost, triangles, verdict.told(chord));
}
