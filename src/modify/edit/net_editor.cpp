// SPDX-License-Identifier: MIT
#include "modify/edit/net_editor.h"

#include "base/representable.h"

namespace nrb::modify {

namespace {

bool has_periodic_axis(const Spline &spline) noexcept {
    return std::any_of(spline.knot_vectors().begin(), spline.knot_vectors().end(),
                       [](const KnotVectorPtr &axis) { return axis->periodic(); });
}

// Copies the values of originals to their copies; there are `width` values for each control point.
void copy_originals(const Spline &spline, int width, std::vector<double> &values) noexcept {
    for (int64_t i = 0; i < spline.point_count() && !values.empty(); ++i) {
        const int64_t from = original_of(spline, i);
        if (from != i) {
            std::copy_n(values.data() + from * width, width, values.data() + i * width);
        }
    }
}

} // namespace

int64_t original_of(const Spline &spline, int64_t point) noexcept {
    int64_t original = 0, scale = 1;
    for (int k = spline.axes(); k-- > 0;) {
        const KnotVector &axis = spline.axis(k);
        original += point % axis.count() % axis.distinct_layers() * scale;
        point /= axis.count();
        scale *= axis.count();
    }
    return original;
}

NetEditor::NetEditor(const Spline &spline)
    : spline_(spline), points_(spline.points().begin(), spline.points().end()),
      weights_(spline.weights().begin(), spline.weights().end()) {}

void NetEditor::set_weight(int64_t point, double weight) {
    if (spline_.form() != Form::homogeneous) {
        weights_.resize(static_cast<size_t>(spline_.point_count()), 1.0);
        weights_[static_cast<size_t>(point)] = weight;
        return;
    }
    const double old = spline_.weight(point);
    if (old == 0) {
        fail(Status::point_not_finite,
             "g: control point %lld is at infinity, where another weight would move it",
             static_cast<long long>(point));
    }
    double *const values = record(point);
    for (int c = 0; c < spline_.dim(); ++c) {
        values[c] = spline_.coordinate(point, c) * weight;
    }
    values[spline_.dim()] = weight;
}

void NetEditor::move(int64_t point, const double *offset, double scale) noexcept {
    const double factor = spline_.form() == Form::homogeneous ? scale * spline_.weight(point) : scale;
    double *const values = record(point);
    for (int c = 0; c < spline_.dim(); ++c) {
        values[c] += factor * offset[c];
    }
}

SplinePtr NetEditor::finish() {
    if (has_periodic_axis(spline_)) {
        copy_originals(spline_, spline_.stored_width(), points_);
        copy_originals(spline_, 1, weights_);
    }
    require_representable(points_, "control points");
    const Form form = !weights_.empty() ? Form::rational : spline_.form();
    return make_result(spline_.knot_vectors(), spline_.dim(), form, std::move(points_), std::move(weights_));
}

} // namespace nrb::modify
