// SPDX-License-Identifier: MIT
#include "mesh/surface_mesh.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "eval/frames/surface_frames.h"
#include "mesh/cells/cell_triangles.h"
#include "mesh/proof/mesh_bound.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <cstdio>
#include <cstdlib>

namespace nrb::mesh {

namespace {

// What is left for the differences of an estimate and a proof.
constexpr double share_of_estimate = 0.97;

class SurfaceMesher {
public:
    SurfaceMesher(const Spline &surface, const MeshRule &rule)
        : surface_(surface), rule_(rule), grid_(pieces::piece_grid_of(surface)), tree_(grid_, cell_rule()) {}

    Mesh mesh();

private:
    [[nodiscard]] CellRule cell_rule() const {
        CellRule rule;
        rule.chord = grid_.scaled(rule_.chord) * share_of_estimate;
        return rule;
    }
    void make_vertices(Mesh &mesh) const;
    void evaluate(std::vector<double> &points, std::vector<double> &normals) const;
    void bound(Mesh &mesh) const;

    const Spline &surface_;
    const MeshRule &rule_;
    const pieces::PieceGrid &grid_;
    CellTree tree_;
    std::optional<LineTwins> twins_;
    std::optional<PlaceTable> table_;
};

void SurfaceMesher::evaluate(std::vector<double> &points, std::vector<double> &normals) const {
    const auto n = static_cast<size_t>(table_->count());
    std::vector<double> params(2 * n);
    for (size_t i = 0; i < n; ++i) {
        const auto lines = table_->place(static_cast<int32_t>(i)).lines;
        params[2 * i] = tree_.lines(0)[static_cast<size_t>(lines[0])].t;
        params[2 * i + 1] = tree_.lines(1)[static_cast<size_t>(lines[1])].t;
    }
    points.resize(3 * n);
    normals.resize(3 * n);
    const auto count = static_cast<int64_t>(n);
    eval::surface_frames(surface_, {}, ConstRecords{params.data(), count, 2, 2, 1},
                         {{points.data(), count, 3, 3, 1}, {}, {}, {normals.data(), count, 3, 3, 1}, nullptr});
}

Mesh SurfaceMesher::mesh() {
  for(int round=0;;++round){
    twins_.emplace(tree_, grid_); table_.emplace(tree_, *twins_);
    std::vector<int32_t> cell_of;
    Mesh mesh;
    std::vector<double> points, normals;
    evaluate(points, normals);
    mesh.points.resize(static_cast<size_t>(table_->count()));
    for (size_t i = 0; i < mesh.points.size(); ++i) {
        mesh.points[i] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    }
    MeshFace face;
    CellTriangles triangles(tree_);
    std::vector<int32_t> border;
    int64_t bad = 0;
    std::vector<TriangleBound> bounds;
    for (const Cell &cell : tree_.cells()) {
        const Rectangle part = tree_.rectangle(cell);
        const CellPart here{&cell.box, part};
        table_->border(cell, border);
        const size_t first = mesh.triangles.size();
        triangles.make(*table_, cell, border, mesh.triangles);
        for (size_t t = first; t < mesh.triangles.size(); ++t) {
            std::array<Corner, 3> corners;
            for (size_t k = 0; k < 3; ++k) {
                const int32_t at = mesh.triangles[t][k];
                const auto lines = table_->place(at).lines;
                corners[k].param = {tree_.lines(0)[static_cast<size_t>(lines[0])].t, tree_.lines(1)[static_cast<size_t>(lines[1])].t};
                double placed[4];
                grid_.place(points.data() + 3 * at, placed);
                corners[k].point = {placed[0], placed[1], placed[2]};
            }
            bounds.push_back(triangle_bound(corners, {&here, 1}));
            cell_of.push_back(int32_t(&cell - tree_.cells().data()));
        }
    }
    MeshBound all(mesh.points.size());
    for (int32_t i = 0; i < table_->count(); ++i) {
        const auto lines = table_->place(i).lines;
        for (size_t k = 0; k < 2; ++k) {
            if (lines[k] == 0 || lines[k] + 1 == std::ssize(tree_.lines(k))) {
                all.set_border(i);
            }
        }
    }
    for (size_t t = 0; t < bounds.size(); ++t) {
        all.add_normal(mesh.triangles[t], bounds[t].normal);
    }
    for (size_t t = 0; t < bounds.size(); ++t) {
        all.add(mesh.triangles[t], bounds[t]);
    }
    double alone = 0;
    for (size_t t = 0; t < bounds.size(); ++t) {
        const Distances d = all.distances(mesh.triangles[t], bounds[t]);
            bad += grid_.unscaled(d.most()) > rule_.chord;
            alone += grid_.unscaled(std::max(bounds[t].from_shape(), bounds[t].from_mesh())) > rule_.chord;
            face.from_shape = std::max(face.from_shape, grid_.unscaled(d.from_shape));
            face.from_mesh = std::max(face.from_mesh, grid_.unscaled(d.from_mesh));
    }
    face.first_triangle = (size_t)alone;
    face.triangles = mesh.triangles.size();
    face.reached = bad == 0;
    face.face = bad;
    mesh.faces.push_back(face);
    if (bad == 0 || round == 8) return mesh;
    if(getenv("DBG")) fprintf(stderr,"round %d: %zu triangles %ld bad\n",round,mesh.triangles.size(),bad);
    std::vector<int32_t> over;
    for (size_t t = 0; t < bounds.size(); ++t) {
        if (grid_.unscaled(all.distances(mesh.triangles[t], bounds[t]).most()) > rule_.chord && (over.empty() || over.back() != cell_of[t])) over.push_back(cell_of[t]);
    }
    tree_.cut(over);
  }
}

} // namespace

MeshPtr mesh_of(const Spline &surface, const MeshRule &rule) {
    return std::make_shared<const Mesh>(SurfaceMesher(surface, rule).mesh());
}

} // namespace nrb::mesh
