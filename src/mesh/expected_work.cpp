// SPDX-License-Identifier: MIT
#include "mesh/expected_work.h"

#include "base/watch.h"
#include "mesh/border/model_edges.h"
#include "mesh/cells/cell_tree.h"
#include "mesh/domain/triangle_pool.h"
#include "mesh/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace nrb::mesh {

namespace {

// Faces are compared by cells for a chord error that is larger than that of the mesh by the factor `coarser`.
// As shares of the extent: from coarse_share on a chord error is coarse, and trials begin there; below
// fine_share it is so fine that trials are made.
constexpr double coarser = 16, coarse_share = 0x1p-11, fine_share = 0x1p-16;
// The ratio of a chord error that is tried to the next one, which is tried only if its mesh is expected to
// take no more than this share of the work that is left.
constexpr double step = 64, share_of_trials = 1.0 / 16;
// Work of a cell and of a segment, from finding them to the last triangle, as measured.
constexpr double work_of_cell = 6 * work_of_triangle, work_of_segment = 16 * work_of_triangle;
// Shares of the work that is left: the chord of the rule is kept if it is expected to take no more than
// `most`, since cells are coarsened where the work ends; otherwise a chord is chosen that is expected to take
// `aim`.
constexpr double most = 0.75, aim = 0.5;

double cells_of(const face::Face &face, const MeshRule &rule) {
    const pieces::PieceGrid &grid = pieces::piece_grid_of(*face.surface());
    CellRule own;
    own.chord = grid.scaled(rule.chord);
    own.longest = grid.scaled(rule.longest);
    own.angle = rule.angle;
    own.least = least_for_angles * grid.size();
    own.side = [&face](const Rectangle &part) {
        return face.trims().cuts(part.lower, part.upper) ? Side::border
               : face.trims().side(part.middle()) > 0    ? Side::inside
                                                         : Side::outside;
    };
    const CellTree tree(grid, own);
    const auto counts = [](const Cell &cell) { return cell.side != Side::outside; };
    return tree.coarsening() * static_cast<double>(std::ranges::count_if(tree.cells(), counts));
}

std::vector<double> cells_of_faces(const model::Model &model, const MeshRule &rule) {
    std::vector<double> result;
    for (const model::ModelFace &face : model.faces) {
        result.push_back(cells_of(*face.face, rule));
    }
    return result;
}

// The number of cells or segments at the chord error tried last, and the power with which it grows as that
// shrinks: from 0 for flat shapes to most_power for shapes that are curved everywhere.
struct Growth {
    double most_power;
    double count = 0, power = most_power;

    void add(double more) noexcept {
        if (count > 0) {
            power = std::clamp(std::log(more / count) / std::log(step), 0.0, most_power);
        }
        count = more;
    }
    [[nodiscard]] double at(double finer) const noexcept { return count * std::pow(finer, power); }
};

class Trials {
public:
    Trials(const model::Model &model, const MeshRule &rule)
        : model_(model), rule_(rule), chord_(rule.chord) {}

    // Tries smaller and smaller chord errors, down to one from which the rest is extrapolated.
    ExpectedWork run(double largest) {
        rule_.chord = largest;
        look();
        while (rule_.chord > step * chord_ && expected(rule_.chord / step) <= share_of_trials * left()) {
            rule_.chord /= step;
            look();
        }
        const double chord = expected(chord_) <= most * left() ? chord_ : fitting();
        for (double &face : faces_) {
            face *= expected(chord) / std::max(cells_.count, 1.0); // surfaces may have no cells inside
        }
        return {chord, std::move(faces_)};
    }

private:
    [[nodiscard]] static double left() { return static_cast<double>(work_left()); }

    void look() {
        faces_ = cells_of_faces(model_, rule_);
        cells_.add(std::accumulate(faces_.begin(), faces_.end(), 0.0));
        segments_.add(static_cast<double>(ModelEdges(model_, {rule_.chord}).points().size()));
    }
    [[nodiscard]] double expected(double chord) const noexcept {
        const double finer = rule_.chord / chord;
        return cells_.at(finer) * work_of_cell + segments_.at(finer) * work_of_segment;
    }
    // The smallest chord expected to take no more than `aim` of the work, by bisection of its logarithm, which
    // ends only between normal numbers: a share of a tiny extent may be 0.
    [[nodiscard]] double fitting() const {
        double low = std::max(chord_, std::numeric_limits<double>::min()), high = rule_.chord;
        while (high > 1.01 * low) {
            const double middle = std::sqrt(low) * std::sqrt(high);
            (expected(middle) <= aim * left() ? high : low) = middle;
        }
        return high;
    }

    const model::Model &model_;
    MeshRule rule_; // with the chord that was tried last
    double chord_;  // that the mesh is asked for
    std::vector<double> faces_{};
    Growth cells_{1}, segments_{0.5};
};

// The expected work of each face, from cells for a larger chord error.
std::vector<double> work_of_faces(const model::Model &model, const MeshRule &rule) {
    std::vector<double> result = cells_of_faces(model, coarsened(rule, coarser));
    for (double &face : result) {
        face *= coarser * work_of_cell;
    }
    return result;
}

} // namespace

ExpectedWork expected_work(const model::Model &model, const MeshRule &rule, double extent) {
    if (!work_is_limited()) {
        return {rule.chord};
    }
    if (rule.chord < fine_share * extent) {
        return Trials(model, rule).run(coarse_share * extent);
    }
    const bool few = model.faces.size() < 2;
    const bool is_coarse = rule.chord >= coarse_share * extent && rule.longest == 0 && rule.angle == 0;
    return {rule.chord, few || is_coarse ? std::vector<double>{} : work_of_faces(model, rule)};
}

} // namespace nrb::mesh
