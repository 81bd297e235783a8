/* SPDX-License-Identifier: MIT */
// The same shape with other degrees, directions, domains and speeds, and its image under maps of space.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

void axis_forms(const Subject &s, int32_t k) {
    for (const int32_t times : {0, 1, 3}) {
        nurbs_elevate(s.g, k, times, unread);
    }
    nurbs_reverse(s.g, k, 0, unread);
    nurbs_reverse(s.g, k, NURBS_KEEP_DOMAIN, unread);
    nurbs_reparametrize(s.g, k, 0, 1, unread);
    nurbs_reparametrize(s.g, k, -3.7, 1e3, unread);
    for (const double ratio : {0.5, 1.0, 3.0}) {
        nurbs_reparametrize_moebius(s.g, k, ratio, unread);
    }
    nurbs_equalize_end_weights(s.g, k, unread);
}

void orders_of_axes(const Subject &s) {
    const int32_t orders[][3] = {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}};
    for (const auto &order : orders) {
        nurbs_transpose(s.g, order, unread);
    }
}

// To as many dimensions, fewer and more.
void affine(const Subject &s) {
    for (const int32_t dim : {s.dim, 1, s.dim + 2}) {
        const std::vector<double> matrix = s.numbers(dim * s.dim), shift = s.direction(2, dim);
        nurbs_transform(s.g, dim, matrix.data(), nullptr, unread);
        nurbs_transform(s.g, dim, matrix.data(), shift.data(), unread);
    }
}

// Near to the identity, so that the weights stay positive.
void projective(const Subject &s) {
    const int32_t width = s.dim + 1;
    std::vector<double> matrix = s.numbers(width * width);
    for (int32_t i = 0; i < width * width; ++i) {
        double &entry = matrix[static_cast<size_t>(i)];
        entry = i % (width + 1) == 0 ? 1 + 0.1 * entry : i / width == s.dim ? 0.05 * entry / s.size : entry;
    }
    nurbs_transform_projective(s.g, s.dim, matrix.data(), unread);
}

void reflections_and_projections(const Subject &s) {
    const std::vector<double> normal = s.direction(3), along = s.direction(4);
    std::vector<double> eye = s.center;
    for (size_t c = 0; c < eye.size(); ++c) {
        eye[c] += 3 * s.size * normal[c];
    }
    nurbs_mirror(s.g, s.center.data(), normal.data(), unread);
    nurbs_project_to_plane(s.g, s.center.data(), normal.data(), nullptr, unread);
    nurbs_project_to_plane(s.g, s.center.data(), normal.data(), along.data(), unread);
    nurbs_project_from(s.g, eye.data(), s.center.data(), normal.data(), unread);
}

} // namespace

void call_forms(const Subject &s) {
    for (int32_t k = 0; k < s.axes; ++k) {
        axis_forms(s, k);
    }
    orders_of_axes(s);
    affine(s);
    projective(s);
    reflections_and_projections(s);
}

} // namespace recorded
