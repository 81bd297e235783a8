// SPDX-License-Identifier: MIT
#include "modify/deform/flatten.h"

#include "base/numbers.h"
#include "base/representable.h"
#include "numeric/direction.h"
#include "numeric/norm.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::modify {

namespace {

// Projects a record x of weight w along d onto the plane with the normal n: x - ((x - w point) . n / (d . n))
// d.
class Projection {
public:
    Projection(const double *point, const double *normal, const double *direction, int dim)
        : point_(point), normal_(unit_vector(normal, dim)),
          along_(unit_vector(direction == nullptr ? normal : direction, dim)) {
        double slope = 0;
        for (size_t c = 0; c < along_.size(); ++c) {
            slope += along_[c] * normal_[c];
        }
        if (!(std::abs(slope) > 4 * dim * eps)) {
            fail(Status::direction, "direction is parallel to the plane, expected one that crosses it");
        }
        for (double &x : along_) {
            x /= slope;
        }
    }
    // Returns the length by which the record moved.
    double operator()(double *record, double weight) const noexcept {
        double height = 0;
        for (size_t c = 0; c < along_.size(); ++c) {
            height += (record[c] - weight * point_[c]) * normal_[c];
        }
        for (size_t c = 0; c < along_.size(); ++c) {
            record[c] -= height * along_[c];
        }
        return std::abs(height) * norm(along_.data(), static_cast<int>(along_.size()));
    }

private:
    const double *point_;
    std::vector<double> normal_;
    std::vector<double> along_; // the step along the direction that gains a height of 1
};

// For each control point, 1 if its basis function vanishes outside the part.
std::vector<char> inner_points(const Spline &spline, const Part &part) {
    std::vector<char> inner(static_cast<size_t>(spline.point_count()), 1);
    for (int k = 0; k < spline.axes(); ++k) {
        const AxisView view = axis_view(spline, k, 1);
        const KnotVector &axis = spline.axis(k);
        std::vector<char> layers(static_cast<size_t>(view.count), 0);
        for (int64_t i = 0; i < view.count;
             ++i) { // a copy of a layer may be inside the part even if the layer itself is not
            if (inside(axis, i, part[static_cast<size_t>(k)])) {
                layers[static_cast<size_t>(i % axis.distinct_layers())] = 1;
            }
        }
        for (int64_t i = 0; i < spline.point_count(); ++i) {
            const int64_t layer = i / view.inner % view.count % axis.distinct_layers();
            inner[static_cast<size_t>(i)] &= layers[static_cast<size_t>(layer)];
        }
    }
    return inner;
}

} // namespace

Flattened flatten(const SplinePtr &spline, const Part &part, const double *point, const double *normal,
                  const double *direction) {
    constexpr int cells_per_degree = 3;
    const Projection project(point, normal, direction, spline->dim());
    const SplinePtr fine = refined_to(spline, part, cells_per_degree);
    const std::vector<char> inner = inner_points(*fine, part);
    std::vector<double> points(fine->points().begin(), fine->points().end());
    double moved = 0;
    for (int64_t i = 0; i < fine->point_count(); ++i) {
        if (inner[static_cast<size_t>(i)] != 0) {
            const double weight = fine->form() == Form::homogeneous ? fine->weight(i) : 1;
            const double distance = project(points.data() + i * fine->stored_width(), weight);
            moved = distance == 0 ? moved : std::max(moved, distance / std::abs(weight)); // may be infinite
        }
    }
    require_representable(points, "control points");
    return {make_result(fine->knot_vectors(), fine->dim(), fine->form(), std::move(points),
                        {fine->weights().begin(), fine->weights().end()}),
            moved};
}

} // namespace nrb::modify
