// What the queries answer about a spline: statuses and numbers of some forty functions, by name.
#pragma once

#include "support/cases.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace support {

inline Handle create_homogeneous(const SplineData &data) {
    const std::vector<double> knots = data.all_knots(), records = homogeneous_points(create(data).get());
    return made([&](nurbs **out) {
        return nurbs_create_homogeneous(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                                        static_cast<int64_t>(knots.size()), data.dim, records.data(), 0, 0, 0,
                                        out);
    });
}

class Answers {
public:
    Answers(const SplineData &data, bool homogeneous)
        : data_(data), g_(homogeneous ? create_homogeneous(data) : create(data)), axes_(data.axes()),
          dim_(data.dim) {
        for (int k = 0; k < axes_; ++k) {
            const double from = data.lower(k), to = data.upper(k);
            for (const double share : {0.0, 0.21, 0.5, 0.77, 1.0}) {
                params_.push_back(from * (1 - share) + to * share);
            }
        }
        points();
        distances();
        measures();
        bounds();
        features();
        reductions();
        compatibility();
        if (axes_ == 1) {
            curve_only();
        }
        if (axes_ == 2 && dim_ == 3) {
            surface_only();
        }
    }

    [[nodiscard]] const std::vector<std::pair<std::string, std::vector<double>>> &list() const {
        return list_;
    }

private:
    using Values = std::vector<double>;

    [[nodiscard]] const nurbs *g() const { return g_.get(); }
    [[nodiscard]] Values room(int64_t n) const { return Values(static_cast<size_t>(n), -1.25); }

    void add(const char *name, nurbs_status status, std::initializer_list<Values> outputs) {
        Values all{static_cast<double>(status)};
        for (const Values &values : outputs) {
            all.insert(all.end(), values.begin(), values.end());
        }
        list_.emplace_back(name, all);
    }
    template <class T>
    static Values doubles(const std::vector<T> &values) {
        return {values.begin(), values.end()};
    }

    [[nodiscard]] Values diagonal() const {
        Values params;
        for (size_t i = 0; i < 5; ++i) {
            for (int k = 0; k < axes_; ++k) {
                params.push_back(params_[5 * static_cast<size_t>(k) + i]);
            }
        }
        return params;
    }

    void points() {
        add("eval", 0, {eval(g(), diagonal())});
        add("eval_derivs", 0, {eval_derivs(g(), 2, diagonal())});
        add("hull_size", 0, {hull_sizes(g(), diagonal())});
    }

    void distances() {
        const auto dim = static_cast<int64_t>(dim_);
        Values asked;
        for (int i = 0; i < 4; ++i) {
            for (int c = 0; c < dim_; ++c) {
                asked.push_back(0.3 * i - 0.2 * c);
            }
        }
        for (const bool far : {false, true}) {
            Values params = room(4 * axes_), feet = room(4 * dim), lengths = room(4);
            std::vector<int32_t> status(4, -7);
            const auto function = far ? nurbs_farthest_points : nurbs_closest_points;
            const nurbs_status s =
                function(g(), 4, asked.data(), 0, 0, nullptr, 1e-9, axes_ == 1 ? 0 : 100, params.data(), 0, 0,
                         feet.data(), 0, 0, lengths.data(), 0, status.data(), 0);
            add(far ? "farthest_points" : "closest_points", s, {params, feet, lengths, doubles(status)});
        }
        Values params = room(4 * axes_), lengths = room(4), guesses;
        for (int i = 0; i < 4; ++i) {
            for (int k = 0; k < axes_; ++k) {
                guesses.push_back(params_[5 * static_cast<size_t>(k) + 2]);
            }
        }
        std::vector<int32_t> status(4, -7);
        nurbs_status s = nurbs_closest_local(g(), 4, asked.data(), 0, 0, guesses.data(), 0, 0, params.data(),
                                             0, 0, nullptr, 0, 0, lengths.data(), 0, status.data(), 0);
        add("closest_local", s, {params, lengths, doubles(status)});
        int64_t count = -1;
        Values many = room(64 * axes_), far = room(64);
        std::vector<int32_t> kinds(64, -7);
        s = nurbs_closest_all(g(), asked.data() + dim, nullptr, 0.1, axes_ == 1 ? 0 : 40, 64, many.data(),
                              far.data(), &count, status.data());
        add("closest_all", s, {many, far, {static_cast<double>(count), static_cast<double>(status[0])}});
        s = nurbs_critical_points(g(), asked.data() + dim, nullptr, 1e-9, axes_ == 1 ? 0 : 40, 64,
                                  many.data(), far.data(), kinds.data(), &count, status.data());
        add("critical_points", s,
            {many, far, doubles(kinds), {static_cast<double>(count), static_cast<double>(status[0])}});
        const Handle other = far_segment();
        Values bounds = room(4);
        s = nurbs_distance(g(), other.get(), 1e-6, 400, bounds.data(), bounds.data() + 1, params.data(),
                           nullptr, status.data());
        add("distance", s, {bounds, params, doubles(status)});
        s = nurbs_hausdorff_distance(g(), other.get(), 1e-2, axes_ == 1 ? 0 : 400, bounds.data(),
                                     bounds.data() + 2, params.data(), nullptr, status.data());
        add("hausdorff_distance", s, {bounds, params, doubles(status)});
    }
    [[nodiscard]] static Handle segment(int dim, const Values &ends) {
        return create(SplineData{{1}, {2}, {{0, 0, 1, 1}}, dim, ends, {}, 0});
    }
    [[nodiscard]] Handle far_segment() const {
        Values ends(2 * static_cast<size_t>(dim_), 2.0);
        ends[0] = -2;
        return segment(dim_, ends);
    }

    void measures() {
        Values content = room(2), centroid = room(dim_), inertia = room(int64_t{dim_} * dim_);
        const nurbs_status s = nurbs_moments(g(), axes_ == 3 ? 0.1 : 1e-9, content.data(), centroid.data(),
                                             inertia.data(), content.data() + 1);
        add("moments", s, {content, centroid, inertia});
    }

    void bounds() {
        Values lower = room(dim_), upper = room(dim_), gap = room(1);
        nurbs_status s = nurbs_box(g(), nullptr, 1e-9, lower.data(), upper.data(), gap.data());
        add("box", s, {lower, upper, gap});
        Values axes = room(int64_t{dim_} * dim_);
        s = nurbs_oriented_box(g(), 1e-9, lower.data(), axes.data(), upper.data());
        add("oriented_box", s, {lower, axes, upper});
        for (int k = 0; k < axes_; ++k) {
            s = nurbs_tangent_cone(g(), k, nullptr, 1e-6, lower.data(), gap.data());
            add("tangent_cone", s, {lower, gap});
        }
        const Values direction(static_cast<size_t>(dim_), 0.7);
        Values params = room(axes_), value = room(2);
        s = nurbs_extreme_point(g(), direction.data(), nullptr, 1e-9, params.data(), value.data(),
                                value.data() + 1);
        add("extreme_point", s, {params, value});
        s = nurbs_straightness(g(), lower.data(), upper.data(), gap.data());
        add("straightness", s, {lower, upper, gap});
        if (dim_ == 3) {
            s = nurbs_planarity(g(), lower.data(), upper.data(), gap.data());
            add("planarity", s, {lower, upper, gap});
        }
        std::vector<int32_t> closed(3, -7), collapsed(6, -7);
        Values gaps = room(3), sizes = room(6);
        s = nurbs_boundary_contacts(g(), 1e-9, closed.data(), gaps.data(), collapsed.data(), sizes.data());
        add("boundary_contacts", s, {doubles(closed), gaps, doubles(collapsed), sizes});
    }

    void features() {
        int64_t count = -1;
        Values knots = room(64), gaps = room(192);
        std::vector<int32_t> orders(192, -7);
        nurbs_status s =
            nurbs_continuity(g(), 0, 1e-9, 1e-9, 1e-9, 64, knots.data(), orders.data(), orders.data() + 64,
                             orders.data() + 128, gaps.data(), gaps.data() + 64, gaps.data() + 128, &count);
        add("continuity", s, {knots, doubles(orders), gaps});
        int32_t result = -7;
        if (axes_ < 3) {
            Values params = room(64 * axes_), boxes = room(int64_t{128} * axes_);
            s = nurbs_singular_points(g(), 1e-6, 64, params.data(), boxes.data(), &count, &result);
            add("singular_points", s,
                {params, boxes, {static_cast<double>(count), static_cast<double>(result)}});
            Values placement = room(9), sizes = room(3), deviation = room(1);
            s = nurbs_recognize(g(), 1e-6, &result, placement.data(), sizes.data(), deviation.data());
            add("recognize", s, {placement, sizes, deviation, {static_cast<double>(result)}});
        }
        if (axes_ > 1) {
            const double up[] = {0.1, 0.2, 1};
            Values positive = room(axes_), negative = room(axes_);
            s = nurbs_fold_test(g(), axes_ == 2 && dim_ == 3 ? up : nullptr, &result, positive.data(),
                                negative.data());
            add("fold_test", s, {positive, negative, {static_cast<double>(result)}});
        }
    }

    // The bounds, and the shapes of the results.
    void reductions() {
        Values bounds = room(2);
        const Handle finer = insert(g(), 0, params_[1], 1);
        add("deviation", nurbs_deviation(g(), finer.get(), bounds.data(), bounds.data() + 1), {bounds});
        nurbs *out = nullptr;
        nurbs_status s = nurbs_simplify(finer.get(), 1e-3, bounds.data(), &out);
        add_shape("simplify", s, {bounds[0]}, out);
        s = nurbs_reduce_knots(finer.get(), 0, 1e-3, bounds.data(), &out);
        add_shape("reduce_knots", s, {bounds[0]}, out);
        s = nurbs_reduce_degree(g(), 0, 1, bounds.data(), &out);
        add_shape("reduce_degree", s, {bounds[0]}, out);
        int32_t removed = -7;
        s = nurbs_remove_knot(finer.get(), 0, params_[1], 1, 1e-9, &removed, bounds.data(), &out);
        add_shape("remove_knot", s, {bounds[0], static_cast<double>(removed)}, out);
    }
    // With the same spline over a knot that is a little elsewhere.
    void compatibility() {
        SplineData moved = data_;
        for (double &t : moved.knots[0]) {
            t += t == 0.4 ? 1e-7 : 0;
        }
        const Handle other = create(moved);
        const nurbs *both[] = {g(), other.get()};
        double deviation = -1;
        nurbs_list *out = nullptr;
        const nurbs_status s = nurbs_make_compatible(2, both, 1e-5, 0, &deviation, &out);
        nurbs_list_destroy(out);
        add("make_compatible", s, {{deviation}});
    }
    void add_shape(const char *name, nurbs_status status, const Values &numbers, nurbs *out) {
        const Handle made(out);
        add(name, status, {numbers, out == nullptr ? Values{} : eval(out, diagonal())});
    }

    void curve_only() {
        Values length = room(2), params(params_);
        nurbs_status s = nurbs_curve_length(g(), nullptr, 1e-9, length.data(), length.data() + 1);
        add("curve_length", s, {length});
        Values lengths = room(5), places = room(5);
        s = nurbs_curve_lengths(g(), 5, params.data(), 0, 1e-9, lengths.data(), 0);
        add("curve_lengths", s, {lengths});
        s = nurbs_curve_divide(g(), nullptr, 4, 1e-9, NURBS_EQUAL_CHORDS, places.data(), length.data());
        add("curve_divide", s, {places, length});
        std::vector<int32_t> status(64, -7), kinds(64, -7);
        int64_t count = -1;
        int32_t complete = -7;
        Values at = room(64), values = room(64);
        s = nurbs_curve_features(
            g(), NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CURVATURE_MAXIMUM | NURBS_FEATURE_CUSP, 64,
            at.data(), kinds.data(), values.data(), &count, &complete);
        add("curve_features", s,
            {at, doubles(kinds), values, {static_cast<double>(count), static_cast<double>(complete)}});
        const Values direction(static_cast<size_t>(dim_), 0.7);
        s = nurbs_curve_monotone_pieces(g(), direction.data(), 64, at.data(), kinds.data(), &count,
                                        &complete);
        add("curve_monotone_pieces", s,
            {at, doubles(kinds), {static_cast<double>(count), static_cast<double>(complete)}});
        Values tangents = room(15), normals = room(15), curvatures = room(5);
        s = nurbs_curve_eval_frames(g(), 5, params.data(), 0, nullptr, 0, 0, tangents.data(), 0, 0,
                                    normals.data(), 0, 0, nullptr, 0, 0, curvatures.data(), 0, nullptr, 0,
                                    status.data(), 0);
        add("curve_eval_frames", s, {tangents, normals, curvatures, doubles(status)});
        if (dim_ == 3) {
            s = nurbs_curve_rotation_minimizing_frames(g(), 5, params.data(), 0, nullptr, nullptr, 0, 0,
                                                       tangents.data(), 0, 0, normals.data(), 0, 0, nullptr,
                                                       0, 0, status.data(), 0);
            add("curve_rotation_minimizing_frames", s, {tangents, normals, doubles(status)});
            return;
        }
        int32_t convexity = -7;
        s = nurbs_curve_convexity(g(), &convexity);
        add("curve_convexity", s, {{static_cast<double>(convexity)}});
        const double asked[] = {0.2, 0.4, -0.1, 0.3};
        Values signed_ones = room(2), feet = room(2);
        s = nurbs_curve_signed_distances(g(), 2, asked, 0, 0, 1e-9, 0, signed_ones.data(), 0, feet.data(), 0,
                                         status.data(), 0);
        add("curve_signed_distances", s, {signed_ones, feet, doubles(status)});
        add_enclosed();
    }
    // What the curve and the line back from its end enclose.
    void add_enclosed() {
        const Values ends = eval(g(), {data_.lower(0), data_.upper(0)});
        const Handle back = segment(2, {ends[2], ends[3], ends[0], ends[1]});
        const nurbs *both[] = {g(), back.get()};
        Values area = room(2), centroid = room(2), inertia = room(4);
        const nurbs_status s = nurbs_enclosed_area(2, both, 1e-9, 1e-9, area.data(), centroid.data(),
                                                   inertia.data(), area.data() + 1);
        add("enclosed_area", s, {area, centroid, inertia});
    }

    void surface_only() {
        Values area = room(2), direction = room(3), angle = room(1);
        nurbs_status s = nurbs_surface_area(g(), nullptr, 1e-9, area.data(), area.data() + 1);
        add("surface_area", s, {area});
        s = nurbs_normal_cone(g(), nullptr, 1e-6, direction.data(), angle.data());
        add("normal_cone", s, {direction, angle});
        const Values params = diagonal();
        Values normals = room(15), curvatures = room(10);
        std::vector<int32_t> status(5, -7);
        s = nurbs_surface_eval_frames(g(), 5, params.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0,
                                      0, normals.data(), 0, 0, status.data(), 0);
        add("surface_eval_frames", s, {normals, doubles(status)});
        s = nurbs_surface_eval_curvatures(g(), 5, params.data(), 0, 0, curvatures.data(), 0, 0, nullptr, 0, 0,
                                          nullptr, 0, nullptr, 0, status.data(), 0);
        add("surface_eval_curvatures", s, {curvatures, doubles(status)});
        const nurbs *shell[] = {g()};
        Values volume = room(3), centroid = room(3);
        s = nurbs_enclosed_volume(1, shell, 1e-9, volume.data(), centroid.data(), nullptr, volume.data() + 1,
                                  volume.data() + 2);
        add("enclosed_volume", s, {volume, centroid});
    }

    const SplineData &data_;
    Handle g_;
    int axes_, dim_;
    Values params_; // five of each axis
    std::vector<std::pair<std::string, Values>> list_;
};

} // namespace support
