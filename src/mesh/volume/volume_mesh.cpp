// SPDX-License-Identifier: MIT
#include "mesh/volume/volume_mesh.h"

#include "analysis/folds.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "mesh/extent.h"
#include "mesh/volume/sides.h"
#include "mesh/volume/volume_grid.h"
#include "refine/parts/cut.h"
#include "refine/parts/piece_arrays.h"

#include <algorithm>
#include <utility>

namespace nrb::mesh {

namespace {

// Cells through which a fold goes show both signs after few halvings; the cells beside them need some to be
// decided at all.
constexpr int64_t halvings_of_cell = 64;

// The grid lines of an axis as layers of a lattice.
class Layers {
public:
    Layers(const Spline &volume, int k, const std::vector<double> &lines)
        : axis_(1, tears(volume.axis(k), lines), closes(volume, k)) {
        for (int64_t layer = 0; layer < axis_.layers(); ++layer) {
            const int64_t source = axis_.source(layer);
            params_.push_back(lines[static_cast<size_t>(source / 2 + source % 2)]);
        }
        if (axis_.closed()) {
            params_.push_back(lines.back());
        }
    }

    [[nodiscard]] const LatticeAxis &axis() const noexcept { return axis_; }
    // The parameters of the layers, and that of the end of a closed axis, which is not a layer of its own.
    [[nodiscard]] const std::vector<double> &params() const noexcept { return params_; }
    // The end of the layers from `first` up to the next tear. A line on a tear has two layers.
    [[nodiscard]] size_t part_end(size_t first) const noexcept {
        size_t end = first + 1;
        while (end < params_.size() && params_[end] != params_[end - 1]) {
            ++end;
        }
        return end;
    }

private:
    // For each cell except the last, whether the volume may jump at its end.
    static std::vector<bool> tears(const KnotVector &axis, const std::vector<double> &lines) {
        const std::vector<bool> jumps = jumps_of(axis);
        const std::span<const double> breaks = axis.spans().breaks();
        std::vector<bool> result(lines.size() - 2);
        for (size_t e = 0; e < jumps.size(); ++e) {
            const auto at = std::ranges::lower_bound(lines, breaks[e + 1]) - lines.begin();
            result[static_cast<size_t>(at - 1)] = jumps[e];
        }
        return result;
    }

    LatticeAxis axis_;
    std::vector<double> params_;
};

class VolumeMesher {
public:
    VolumeMesher(SplinePtr volume, const VolumeGrid &grid, double chord)
        : volume_(std::move(volume)), grid_(grid), chord_(chord) {
        for (int k = 0; k < max_axes; ++k) {
            layers_.emplace_back(*volume_, k, grid.lines[static_cast<size_t>(k)]);
        }
    }

    Mesh mesh() {
        const Lattice lattice({layers_[0].axis(), layers_[1].axis(), layers_[2].axis()},
                              collapses_of(*volume_));
        if (lattice.points() > std::numeric_limits<int32_t>::max()) {
            fail(Status::overflow, "%lld points, expected less than 2^31",
                 static_cast<long long>(lattice.points()));
        }
        Mesh mesh;
        mesh.lines = grid_.lines;
        set_points(lattice, mesh.points);
        set_cells(lattice, mesh.hexahedra);
        set_signs(lattice, mesh.hexahedra);
        MeshFace whole;
        whole.from_shape = whole.from_mesh = grid_.bound + gap_ * (1 + 8 * eps);
        whole.reached = grid_.reached && whole.from_shape <= chord_;
        mesh.faces.push_back(whole);
        return mesh;
    }

private:
    using Range = std::array<std::array<size_t, 2>, max_axes>; // of layers

    void set_points(const Lattice &lattice, std::vector<Vector3> &points);
    void set_nodes(const Range &range);
    static void set_cells(const Lattice &lattice, std::vector<MeshHexahedron> &cells);
    void set_signs(const Lattice &lattice, std::vector<MeshHexahedron> &cells) const;
    [[nodiscard]] std::array<std::vector<size_t>, max_axes> ends_of_pieces() const;
    static void set_sign(const analysis::FoldTest &test, MeshHexahedron &cell);

    SplinePtr volume_;
    const VolumeGrid &grid_;
    std::vector<Layers> layers_;
    double chord_;
    std::vector<double> nodes_; // [params][params][params][3]
    double gap_ = 0;            // largest distance of a node from the point that it has become
};

void VolumeMesher::set_points(const Lattice &lattice, std::vector<Vector3> &points) {
    const Phase phase;
    nodes_.clear();
    Range range;
    const auto sizes = [&](size_t k) { return layers_[k].params().size(); };
    grow_watched(nodes_, sizes(0) * sizes(1) * sizes(2) * 3);
    for (range[0][0] = 0; range[0][0] < sizes(0); range[0][0] = range[0][1]) {
        range[0][1] = layers_[0].part_end(range[0][0]);
        for (range[1][0] = 0; range[1][0] < sizes(1); range[1][0] = range[1][1]) {
            range[1][1] = layers_[1].part_end(range[1][0]);
            for (range[2][0] = 0; range[2][0] < sizes(2); range[2][0] = range[2][1]) {
                range[2][1] = layers_[2].part_end(range[2][0]);
                set_nodes(range);
            }
        }
    }
    points.resize(static_cast<size_t>(lattice.points()));
    std::vector<bool> known(points.size());
    std::array<int64_t, max_axes> at{};
    const double *x = nodes_.data();
    for (at[0] = 0; std::cmp_less(at[0], sizes(0)); ++at[0]) {
        count_work(4 * static_cast<int64_t>(sizes(1) * sizes(2)));
        for (at[1] = 0; std::cmp_less(at[1], sizes(1)); ++at[1]) {
            for (at[2] = 0; std::cmp_less(at[2], sizes(2)); ++at[2], x += 3) {
                const auto point = static_cast<size_t>(lattice.point_at(at));
                const Vector3 own{x[0], x[1], x[2]};
                if (!known[point]) {
                    points[point] = own;
                    known[point] = true;
                }
                gap_ = std::max(gap_, length(points[point] - own));
            }
        }
    }
}

// Evaluates the nodes between two tears along each axis. The volume is continuous there: values at the ends
// are limits from inside.
void VolumeMesher::set_nodes(const Range &range) {
    SplinePtr part = volume_;
    std::array<ConstRecords, max_axes> params;
    std::array<int64_t, max_axes> counts{};
    for (size_t k = 0; k < range.size(); ++k) {
        const std::vector<double> &own = layers_[k].params();
        const auto [first, end] = range[k];
        const Interval domain = volume_->axis(static_cast<int>(k)).domain();
        const bool torn = first > 0 || end < own.size();
        if (torn) {
            part = refine::restrict_axis(part, static_cast<int>(k), own[first],
                                         end < own.size() ? own[end - 1] : domain.upper);
        }
        counts[k] = static_cast<int64_t>(end - first);
        params[k] = {own.data() + first, counts[k], 1, 1, 1};
    }
    std::vector<double> values(static_cast<size_t>(counts[1] * counts[2] * 3));
    const int64_t rows = std::ssize(layers_[1].params()), row = std::ssize(layers_[2].params());
    constexpr int64_t work_of_a_point = 100;
    Steps steps(counts[0]);
    for (int64_t i = 0; i < counts[0]; ++i, steps.next(work_of_a_point * counts[1] * counts[2])) {
        std::array<ConstRecords, max_axes> slice = params;
        slice[0] = {params[0].data + i, 1, 1, 1, 1};
        eval::evaluate_grid(*part, {}, 0, slice, {values.data(), counts[1] * counts[2], 3, 3, 1});
        for (int64_t j = 0; j < counts[1]; ++j) {
            const int64_t node =
                ((static_cast<int64_t>(range[0][0]) + i) * rows + static_cast<int64_t>(range[1][0]) + j) *
                    row +
                static_cast<int64_t>(range[2][0]);
            std::copy_n(values.data() + j * counts[2] * 3, counts[2] * 3, nodes_.data() + 3 * node);
        }
    }
}

void VolumeMesher::set_cells(const Lattice &lattice, std::vector<MeshHexahedron> &cells) {
    cells.reserve(static_cast<size_t>(lattice.cells()));
    for (int64_t i = 0; i < lattice.cells(); ++i) {
        count_work(32);
        MeshHexahedron &cell = cells.emplace_back();
        lattice.copy_cell(i, cell.corners.data());
    }
}

// If a piece has no fold, neither have its cells. They come piece by piece, so that the determinant of each
// piece is computed once.
void VolumeMesher::set_signs(const Lattice &lattice, std::vector<MeshHexahedron> &cells) const {
    const UsualLimit usual(usual_work(volume_->point_count()));
    const LimitedSearch search;
    analysis::FoldTests tests(*volume_, nullptr);
    const std::array<std::vector<size_t>, max_axes> ends = ends_of_pieces();
    Steps steps(refine::count_pieces(*volume_));
    for (int64_t piece = 0; piece < refine::count_pieces(*volume_); ++piece, steps.next()) {
        tests.set_piece(piece);
        const analysis::FoldTest whole = tests.test(analysis::halvings_of_piece);
        std::array<size_t, max_axes> first{}, end{}, at{};
        int64_t index = piece;
        for (size_t k = max_axes; k-- > 0;) {
            const auto pieces = std::ssize(ends[k]) - 1;
            first[k] = ends[k][static_cast<size_t>(index % pieces)];
            end[k] = ends[k][static_cast<size_t>(index % pieces) + 1];
            index /= pieces;
        }
        for (at[0] = first[0]; at[0] < end[0]; ++at[0]) {
            for (at[1] = first[1]; at[1] < end[1]; ++at[1]) {
                for (at[2] = first[2]; at[2] < end[2]; ++at[2]) {
                    set_sign(whole.result == analysis::fold_none
                                 ? whole
                                 : tests.test(grid_.cell(at), halvings_of_cell),
                             cells[lattice.cell_index(at)]);
                }
            }
        }
    }
}

// For each axis, the indices of the lines at which pieces end.
std::array<std::vector<size_t>, max_axes> VolumeMesher::ends_of_pieces() const {
    std::array<std::vector<size_t>, max_axes> ends;
    for (size_t k = 0; k < ends.size(); ++k) {
        const std::vector<double> &lines = grid_.lines[k];
        for (const double knot : volume_->axis(static_cast<int>(k)).spans().breaks()) {
            ends[k].push_back(static_cast<size_t>(std::ranges::lower_bound(lines, knot) - lines.begin()));
        }
    }
    return ends;
}

void VolumeMesher::set_sign(const analysis::FoldTest &test, MeshHexahedron &cell) {
    count_work(4);
    cell.fold = static_cast<int8_t>(test.result);
    cell.sign = static_cast<int8_t>(analysis::sign_of(test));
}

} // namespace

void check_volume(const Spline &volume) {
    if (volume.axes() != 3) {
        fail(Status::axes, "g has %d %s, expected a volume", volume.axes(),
             volume.axes() == 1 ? "axis" : "axes");
    }
    if (volume.dim() != 3) {
        fail(Status::dimension, "g has dimension %d, expected 3", volume.dim());
    }
    check_cell_degrees(volume);
}

MeshPtr mesh_of_volume(const SplinePtr &volume, const MeshRule &rule, int64_t most) {
    std::vector<Interval> box;
    const MeshRule own = settled(rule, extent_of(volume->effective(), box));
    const VolumeGrid grid = [&] {
        const Phase phase;
        return volume_grid(*volume, own, most);
    }();
    return std::make_shared<const Mesh>(VolumeMesher(volume, grid, own.chord).mesh());
}

} // namespace nrb::mesh
