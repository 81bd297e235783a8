// SPDX-License-Identifier: MIT
// Splines as Bezier cells: their polynomial or rational pieces, whose common control points are stored once.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "base/checked.h"
#include "mesh/volume/bezier_cells.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_bezier_cells(const nurbs *g, int64_t cap, int64_t *own_points, int32_t *kind,
                                int64_t *points, int64_t *count) {
    return guard([&] {
        const mesh::Lattice lattice = mesh::bezier_lattice(spline_of(g));
        const int64_t filled = checked_cap(cap, lattice.cells());
        check_apart(
            {memory("own_points", own_points, checked_product(filled, lattice.corners(), "control points")),
             memory("kind", kind, 1), memory("points", points, 1), memory("count", count, 1)},
            {});
        for (int64_t i = 0; i < filled && own_points != nullptr; ++i) {
            lattice.copy_cell(i, own_points + i * lattice.corners());
        }
        put(kind, int32_t{mesh::vtk_bezier_cell(g->spline->axes())});
        put(points, lattice.points());
        put(count, lattice.cells());
    });
}

nurbs_status nurbs_bezier_cell_points(const nurbs *g, int64_t cap, double *points, double *weights,
                                      int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        const mesh::Lattice lattice = mesh::bezier_lattice(spline);
        const int64_t filled = checked_cap(cap, lattice.points());
        check_apart({memory("points", points, checked_product(filled, spline.dim(), "points")),
                     memory("weights", weights, filled), memory("count", count, 1)},
                    {});
        if (filled > 0) {
            mesh::write_bezier_points(g->spline, lattice, points, weights);
        }
        put(count, lattice.points());
    });
}
