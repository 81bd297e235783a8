// SPDX-License-Identifier: MIT
#include "mesh/volume/bezier_cells.h"

#include "base/watch.h"
#include "mesh/volume/sides.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/cut.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// The index of the control point of a node, in the net of all pieces side by side.
int64_t net_point(const Lattice &lattice, int64_t node) noexcept {
    const std::array<int64_t, max_axes> layers = lattice.layers(node);
    int64_t at = 0;
    for (size_t k = 0; k < lattice.axes(); ++k) {
        const LatticeAxis &axis = lattice.axis(k);
        at = at * axis.cells() * (axis.degree() + 1) + axis.source(layers[k]);
    }
    return at;
}

} // namespace

Lattice bezier_lattice(const Spline &spline) {
    check_cell_degrees(spline);
    std::vector<LatticeAxis> axes;
    axes.reserve(static_cast<size_t>(spline.axes()));
    for (int k = 0; k < spline.axes(); ++k) {
        axes.emplace_back(spline.axis(k).degree(), jumps_of(spline.axis(k)), closes(spline, k));
    }
    return Lattice(std::move(axes));
}

void write_bezier_points(const SplinePtr &spline, const Lattice &lattice, double *points, double *weights) {
    const refine::PartedSpline pieces = refine::bezier_pieces(spline);
    const Spline &net = pieces.whole();
    const bool homogeneous = net.form() == Form::homogeneous;
    const std::vector<double> places = homogeneous ? refine::cartesian_points(net) : std::vector<double>();
    const double *from = homogeneous ? places.data() : net.points().data();
    const int dim = net.dim();
    count_work(lattice.points() * (dim + 8));
    for (int64_t i = 0; i < lattice.points(); ++i) {
        const int64_t at = net_point(lattice, lattice.node(i));
        if (points != nullptr) {
            std::copy_n(from + at * dim, dim, points + i * dim);
        }
        if (weights != nullptr) {
            weights[i] = net.weight(at);
        }
    }
}

} // namespace nrb::mesh
