// SPDX-License-Identifier: MIT
#include "build/coons/coons_volume.h"

#include "bounds/deviation.h"
#include "build/coons/blend_sum.h"
#include "build/coons/blended_net.h"
#include "build/coons/boundary.h"
#include "build/coons/face_net.h"
#include "build/coons/volume_edge.h"
#include "reduce/layer_deviation.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/weights.h"
#include "spline/kind.h"

#include <algorithm>
#include <numeric>

namespace nrb::build {

namespace {

using Ends = std::array<bool, 3>; // whether at the upper end, for each axis

void check_faces(const std::vector<SplinePtr> &faces) {
    for (size_t i = 0; i < faces.size(); ++i) {
        check_kind(*faces[i], 2, "faces", static_cast<int64_t>(i));
        if (faces[i]->dim() != faces[0]->dim()) {
            fail(Status::dimension, "faces[%zu] has dimension %d, expected %d as faces[0]", i,
                 faces[i]->dim(), faces[0]->dim());
        }
    }
}

// Six faces with Cartesian control points over common knots, and the functions that blend them.
class FaceBlend {
public:
    FaceBlend(const std::vector<SplinePtr> &faces, double tolerance) : dim_(faces[0]->dim()) {
        for (const SplinePtr &face : faces) {
            stored_.push_back(boundaries_of(*face));
        }
        const std::array<Interval, 3> domains = volume_domains(faces);
        for (size_t i = 0; i < face_count; ++i) {
            const FaceAxes axes(i);
            nets_.push_back(make_face_net(
                faces[i],
                {domains[static_cast<size_t>(axes.first)], domains[static_cast<size_t>(axes.second)]}, i));
        }
        for (int k = 0; k < 3; ++k) {
            unify_axis(k);
        }
        agree_on_edges(tolerance);
    }

    [[nodiscard]] SplinePtr volume(Form form) const {
        const auto dim = static_cast<size_t>(dim_);
        std::vector<double> net = net_of_zeros(all_axes(), dim_);
        const std::array<FaceNet, 2> middle = rest_of_middle(), last = rest_of_last();
        const size_t nu = count(0), nv = count(1), nw = count(2);
        for (size_t i = 0; i < nu; ++i) {
            const std::span<double> slice(net.data() + i * nv * nw * dim, nv * nw * dim);
            for (size_t a = 0; a < 2; ++a) {
                add_scaled(blends_[0].blends[a][i], nets_[a].points.data(), slice.size(), slice.data());
            }
            if (blends_[0].in_margin(i)) {
                continue;
            }
            for (size_t b = 0; b < 2; ++b) {
                add_product(blends_[1].blends[b], {middle[b].point(i, 0), nw * dim}, slice);
                add_product_inside(blends_[2].blends[b], last[b].point(i, 0), slice);
            }
            set_borders(i, slice);
        }
        return blended_spline(all_axes(), dim_, form, std::move(net));
    }

private:
    [[nodiscard]] std::vector<const BlendAxis *> all_axes() const {
        std::vector<const BlendAxis *> axes;
        for (const BlendAxis &axis : blends_) {
            axes.push_back(&axis);
        }
        return axes;
    }
    [[nodiscard]] size_t count(int axis) const noexcept {
        return static_cast<size_t>(blends_[static_cast<size_t>(axis)].count());
    }

    // Brings the four faces that run along an axis to common knots there.
    void unify_axis(int k) {
        std::vector<Quotient> functions;
        for (size_t i = 0; i < face_count; ++i) {
            if (FaceAxes(i).has(k)) {
                functions.push_back(along(nets_[i], FaceAxes(i).place(k)));
            }
        }
        blends_.push_back(make_blend_axis(functions, 1));
        BlendAxis &made = blends_.back();
        size_t at = 0;
        for (size_t i = 0; i < face_count; ++i) {
            if (FaceAxes(i).has(k)) {
                replace_axis(nets_[i], FaceAxes(i).place(k), made.axis, made.functions[at++]);
            }
        }
        made.functions.clear();
    }

    // The control point of a face at a corner of the volume.
    [[nodiscard]] const double *corner_point(size_t face, const Ends &ends) const noexcept {
        const FaceAxes axes(face);
        const FaceNet &net = nets_[face];
        return net.point(ends[static_cast<size_t>(axes.first)] ? net.count(0) - 1 : 0,
                         ends[static_cast<size_t>(axes.second)] ? net.count(1) - 1 : 0);
    }
    // The layer of a face at an end of an axis: an edge of the volume.
    [[nodiscard]] std::vector<double> layer(size_t face, int axis, bool upper) const {
        return nets_[face].layer(FaceAxes(face).place(axis), upper);
    }

    [[nodiscard]] std::vector<double> mean_corner(const Ends &ends) const {
        std::vector<double> mean(static_cast<size_t>(dim_));
        const double *points[3];
        for (int k = 0; k < 3; ++k) {
            points[k] = corner_point(face_at(k, ends[static_cast<size_t>(k)]), ends);
        }
        for (size_t c = 0; c < mean.size(); ++c) { // nothing is rounded if all agree
            mean[c] = points[0][c] + ((points[1][c] - points[0][c]) + (points[2][c] - points[0][c])) / 3;
        }
        return mean;
    }

    // The curve of control points over the knots and weights of an axis.
    [[nodiscard]] SplinePtr edge_curve(int axis, const std::vector<double> &points) const {
        return blended_spline({&blends_[static_cast<size_t>(axis)]}, dim_, Form::rational, points);
    }
    // A proven bound of the distance between two edges along an axis at equal parameters.
    [[nodiscard]] double gap(int axis, const std::vector<double> &a, const std::vector<double> &b,
                             double tolerance) const {
        if (a == b) {
            return 0;
        }
        const SplinePtr first = edge_curve(axis, a), second = edge_curve(axis, b);
        if (first->form() == second->form()) {
            const double bound = reduce::deviation_bound(first, second);
            return bound <= tolerance ? bound : std::min(bound, bounds::deviation(*first, *second).upper);
        }
        return bounds::deviation(*first, *second).upper;
    }

    // Whether both faces were given with the same bits on the edge. Separating their weights may round them
    // differently, which is not a gap.
    [[nodiscard]] bool stored_alike(const VolumeEdge &edge) const {
        const Spline &a = stored_boundary(edge.face(), edge.second, edge.second_upper);
        const Spline &b = stored_boundary(edge.other_face(), edge.first, edge.first_upper);
        return std::ranges::equal(a.axis(0).knots(), b.axis(0).knots()) &&
               std::ranges::equal(a.points(), b.points()) && refine::same_weights(a, b);
    }
    [[nodiscard]] const Spline &stored_boundary(size_t face, int axis, bool upper) const {
        return *stored_[face][face_at(FaceAxes(face).place(axis), upper)];
    }

    // The mean of the edges of the two faces, with the mean corners as its ends. Throws Status::gap.
    [[nodiscard]] std::vector<double> mean_edge(const VolumeEdge &edge, double tolerance) const {
        std::vector<double> a = layer(edge.face(), edge.second, edge.second_upper);
        const std::vector<double> b = layer(edge.other_face(), edge.first, edge.first_upper);
        if (!stored_alike(edge)) {
            edge.check(gap(edge.axis, a, b, tolerance), tolerance);
        }
        std::ranges::transform(a, b, a.begin(), [](double x, double y) { return std::midpoint(x, y); });
        const BlendAxis &blend = blends_[static_cast<size_t>(edge.axis)];
        for (size_t end = 0; end < 2; ++end) {
            Ends ends{};
            ends[static_cast<size_t>(edge.axis)] = end == 1;
            ends[static_cast<size_t>(edge.first)] = edge.first_upper;
            ends[static_cast<size_t>(edge.second)] = edge.second_upper;
            pull(blend, end, mean_corner(ends), a);
        }
        return a;
    }
    // Adds a multiple of a blending function to a function, so that one of its ends takes a wanted value.
    static void pull(const BlendAxis &blend, size_t end, const std::vector<double> &wanted,
                     std::vector<double> &function) {
        const std::span<double> here =
            std::span(function).subspan(end == 0 ? 0 : function.size() - wanted.size(), wanted.size());
        std::vector<double> change(wanted.size());
        std::ranges::transform(wanted, here, change.begin(), std::minus());
        if (std::ranges::any_of(change, [](double x) { return x != 0; })) {
            add_product(blend.blends[end], change, function);
        }
        std::ranges::copy(wanted, here.begin());
    }

    void agree_on_edges(double tolerance) {
        std::array<std::array<std::vector<double>, edges_of_axis>, 3>
            edges; // of each axis, by the ends of the other two
        for (int k = 0; k < 3; ++k) {
            for (size_t i = 0; i < edges_of_axis; ++i) {
                edges[static_cast<size_t>(k)][i] = mean_edge(VolumeEdge(k, i), tolerance);
            }
        }
        for (int k = 0; k < 3; ++k) {
            for (size_t i = 0; i < edges_of_axis; ++i) {
                const VolumeEdge edge(k, i);
                pull_face(edge.face(), edge.second, edge.second_upper, edges[static_cast<size_t>(k)][i]);
                pull_face(edge.other_face(), edge.first, edge.first_upper, edges[static_cast<size_t>(k)][i]);
            }
        }
    }

    // Moves one edge of a face to wanted control points; the opposite edge stays where it is. An adjacent
    // edge that has been moved already ends at the wanted corner, where the difference is now 0, so it stays
    // too. Whatever the order in which its edges are moved, the face has all of them in the end.
    void pull_face(size_t face, int axis, bool upper, const std::vector<double> &wanted) {
        FaceNet &net = nets_[face];
        const int place = FaceAxes(face).place(axis);
        const BlendAxis &blend = blends_[static_cast<size_t>(axis)];
        const auto dim = static_cast<size_t>(dim_);
        const std::vector<double> own = net.layer(place, upper);
        if (own == wanted) {
            return;
        }
        for (size_t i = 0; i < net.count(place); ++i) {
            for (size_t j = 0; j < net.count(1 - place); ++j) {
                double *point = place == 0 ? net.point(i, j) : net.point(j, i);
                for (size_t c = 0; c < dim; ++c) {
                    const size_t at = j * dim + c;
                    point[c] += blend.blends[upper ? 1 : 0][i] * (wanted[at] - own[at]);
                }
            }
        }
        const size_t end = upper ? net.count(place) - 1 : 0;
        for (size_t j = 0; j < net.count(1 - place); ++j) {
            std::copy_n(wanted.data() + j * dim, dim, place == 0 ? net.point(end, j) : net.point(j, end));
        }
    }

    // Subtracts from a face the blend, along one of its axes, of its own layers at the ends: the result is 0
    // there.
    void take_blend(FaceNet &net, int place, const BlendAxis &blend) const {
        const std::vector<double> lower = net.layer(place, false), upper = net.layer(place, true);
        const auto dim = static_cast<size_t>(dim_);
        for (size_t i = 0; i < net.count(place); ++i) {
            for (size_t j = 0; j < net.count(1 - place); ++j) {
                double *point = place == 0 ? net.point(i, j) : net.point(j, i);
                for (size_t c = 0; c < dim; ++c) {
                    const size_t at = j * dim + c;
                    point[c] = blend.in_margin(i) ? 0
                                                  : point[c] - blend.blends[0][i] * lower[at] -
                                                        blend.blends[1][i] * upper[at];
                }
            }
        }
    }
    // The faces of axis 1 minus the blend along axis 0.
    [[nodiscard]] std::array<FaceNet, 2> rest_of_middle() const {
        std::array<FaceNet, 2> rest{nets_[2], nets_[3]};
        for (FaceNet &net : rest) {
            take_blend(net, 0, blends_[0]);
        }
        return rest;
    }
    // The faces of axis 2 minus the blends along axes 0 and 1.
    [[nodiscard]] std::array<FaceNet, 2> rest_of_last() const {
        std::array<FaceNet, 2> rest{nets_[4], nets_[5]};
        for (FaceNet &net : rest) {
            take_blend(net, 0, blends_[0]);
            take_blend(net, 1, blends_[1]);
        }
        return rest;
    }

    // out[j][k] += f[k] row[j] for points row[j].
    void add_product_inside(const std::vector<double> &f, const double *row, std::span<double> out) const {
        const auto dim = static_cast<size_t>(dim_);
        const size_t inner = f.size() * dim;
        for (size_t j = 0; j * inner < out.size(); ++j) {
            add_product(f, {row + j * dim, dim}, out.subspan(j * inner, inner));
        }
    }
    // Sets the outer layers of a slice, i being an inner layer of axis 0, to those of the faces of axes 1 and
    // 2.
    void set_borders(size_t i, std::span<double> slice) const {
        const auto dim = static_cast<size_t>(dim_);
        const size_t nv = count(1), nw = count(2);
        for (size_t j = 0; j < nv; ++j) {
            for (size_t end = 0; end < 2; ++end) {
                std::copy_n(nets_[4 + end].point(i, j), dim,
                            slice.data() + (j * nw + (end == 0 ? 0 : nw - 1)) * dim);
            }
        }
        for (size_t end = 0; end < 2; ++end) {
            std::copy_n(nets_[2 + end].point(i, 0), nw * dim,
                        slice.data() + (end == 0 ? 0 : nv - 1) * nw * dim);
        }
    }

    int dim_;
    std::vector<std::vector<SplinePtr>> stored_; // the boundaries of the faces as they were given
    std::vector<FaceNet> nets_;
    std::vector<BlendAxis> blends_;
};

} // namespace

SplinePtr volume_coons(const std::vector<SplinePtr> &faces, double tolerance) {
    check_faces(faces);
    const bool separate =
        std::ranges::all_of(faces, [](const SplinePtr &face) { return has_separate_weights(*face); });
    return separate ? FaceBlend(faces, tolerance).volume(refine::common_form(faces))
                    : sum_of_blends(faces, tolerance);
}

} // namespace nrb::build
