// Control points without influence: those whose basis function vanishes on the domain, as at an unclamped end whose
// knot repeats, and those of weight 0. Whatever they are, every answer is the same.
#include "support/cases.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace support;

namespace {

SplineData curve(int degree, std::vector<double> knots, int dim, std::vector<double> points,
                 std::vector<double> weights = {}) {
    SplineData data;
    data.degrees = {degree};
    data.counts = {static_cast<int64_t>(knots.size()) - degree - 1};
    data.knots = {std::move(knots)};
    data.dim = dim;
    data.points = std::move(points);
    data.weights = std::move(weights);
    return data;
}

// Whether a control point has no influence on axis k, by the support of its function.
bool vanishes(const SplineData &data, int k, int64_t layer) {
    const auto at = static_cast<size_t>(k), i = static_cast<size_t>(layer);
    return data.knots[at][i + static_cast<size_t>(data.degrees[at]) + 1] <= data.lower(k) ||
           data.knots[at][i] >= data.upper(k);
}

bool outside(const SplineData &data, int64_t i) {
    bool result = false;
    for (int k = data.axes(); k-- > 0; i /= data.counts[static_cast<size_t>(k)]) {
        result = result || vanishes(data, k, i % data.counts[static_cast<size_t>(k)]);
    }
    return result;
}

// With every point that has no influence at a place of about that size, and the weights of those outside.
SplineData with_inert(SplineData data, Random random, double size) {
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const bool no_function = outside(data, i);
        if (!no_function && data.weight(i) != 0) {
            continue;
        }
        for (int c = 0; c < data.dim; ++c) {
            data.points[static_cast<size_t>(i * data.dim + c)] = random.between(-1, 1) * size;
        }
        if (no_function && data.rational()) {
            data.weights[static_cast<size_t>(i)] = random.magnitude(1e-6, 1e6);
        }
    }
    return data;
}

Handle create_homogeneous(const SplineData &data) {
    const std::vector<double> knots = data.all_knots(), records = homogeneous_points(create(data).get());
    return made([&](nurbs **out) {
        return nurbs_create_homogeneous(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                                        static_cast<int64_t>(knots.size()), data.dim, records.data(), 0, 0, 0,
                                        out);
    });
}

// What queries answer: statuses and numbers.
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
        const Handle other = segment();
        Values bounds = room(4);
        s = nurbs_distance(g(), other.get(), 1e-6, 400, bounds.data(), bounds.data() + 1, params.data(),
                           nullptr, status.data());
        add("distance", s, {bounds, params, doubles(status)});
        s = nurbs_hausdorff_distance(g(), other.get(), 1e-2, axes_ == 1 ? 0 : 400, bounds.data(),
                                     bounds.data() + 2, params.data(), nullptr, status.data());
        add("hausdorff_distance", s, {bounds, params, doubles(status)});
    }
    [[nodiscard]] Handle segment() const {
        Values ends(2 * static_cast<size_t>(dim_), 2.0);
        ends[0] = -2;
        return create(curve(1, {0, 0, 1, 1}, dim_, ends));
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
        const Handle back = create(curve(1, {0, 0, 1, 1}, 2, {ends[2], ends[3], ends[0], ends[1]}));
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

// Zeros may differ in sign: a weight of 0 times a coordinate keeps it.
bool same(double a, double b) {
    return a == b || same_bits(a, b);
}

void expect_same(const SplineData &data, const SplineData &other, bool homogeneous, uint64_t seed) {
    const Answers answers(data, homogeneous), others(other, homogeneous);
    ASSERT_EQ(answers.list().size(), others.list().size());
    for (size_t i = 0; i < answers.list().size(); ++i) {
        const auto &[name, a] = answers.list()[i];
        const auto &b = others.list()[i].second;
        ASSERT_EQ(a.size(), b.size()) << name;
        for (size_t k = 0; k < a.size(); ++k) {
            EXPECT_TRUE(same(a[k], b[k]))
                << name << "[" << k << "]: " << a[k] << ", " << b[k] << where(seed, other);
        }
    }
}

// Over [0, 1], clamped, or with a point at each end that no parameter sees.
std::vector<double> knots_of(int degree, bool clamped) {
    std::vector<double> head;
    for (int i = degree; i > 0; --i) {
        head.push_back(clamped ? 0 : -i);
    }
    head.push_back(0);
    if (!clamped) {
        head.push_back(0);
    }
    std::vector<double> knots = head;
    knots.insert(knots.end(), {0.4, 0.7});
    std::for_each(head.rbegin(), head.rend(), [&](double t) { knots.push_back(1 - t); });
    return knots;
}

// Control point i of a surface or volume moved near its place in a grid.
void unfold(SplineData &data, int64_t i) {
    int64_t rest = i;
    for (int k = data.axes(); k-- > 0; rest /= data.counts[static_cast<size_t>(k)]) {
        double &x = data.points[static_cast<size_t>(i * data.dim + k)];
        x = 0.1 * x + 0.5 * static_cast<double>(rest % data.counts[static_cast<size_t>(k)]);
    }
}

SplineData random_net(Random &random, const std::vector<std::pair<int, bool>> &axes, int dim, bool rational,
                      bool some_zero) {
    SplineData data;
    data.dim = dim;
    for (const auto &[degree, clamped] : axes) {
        data.degrees.push_back(degree);
        data.knots.push_back(knots_of(degree, clamped));
        data.counts.push_back(static_cast<int64_t>(data.knots.back().size()) - degree - 1);
    }
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (int c = 0; c < dim; ++c) {
            data.points.push_back(random.between(-1, 1));
        }
        if (axes.size() > 1) { // no folds, which are dear to integrate over
            unfold(data, i);
        }
        if (rational) {
            data.weights.push_back(random.magnitude(0.4, 2.5));
        }
    }
    if (some_zero) {
        data.weights[static_cast<size_t>(data.point_count() / 2)] = 0;
    }
    return data;
}

void check_law(uint64_t base, const std::vector<std::pair<int, bool>> &axes, int dim) {
    for_each_case(base, axes.size() == 1 ? 3 : 1, [&](Random &random, uint64_t seed) {
        for (const int kind : {0, 1, 2, 3}) { // polynomial, rational, with a weight of 0, homogeneous
            if (kind == 2 && axes.size() == 1 && axes[0].first == 1) {
                continue; // the weight would vanish there
            }
            const SplineData data = random_net(random, axes, dim, kind > 0, kind == 2);
            const SplineData near = with_inert(data, random, 1);
            for (const double size : {1e10, 1e300}) {
                expect_same(near, with_inert(data, random, size), kind == 3, seed);
            }
        }
    });
}

TEST(Influence, law_of_lines) {
    check_law(91000, {{1, false}}, 2);
}
TEST(Influence, law_of_plane_curves) {
    check_law(91010, {{2, false}}, 2);
}
TEST(Influence, law_of_space_curves) {
    check_law(91020, {{3, false}}, 3);
}
TEST(Influence, law_of_clamped_curves) {
    check_law(91030, {{3, true}}, 3);
}
TEST(Influence, law_of_surfaces) {
    check_law(91040, {{2, false}, {1, true}}, 3);
}
TEST(Influence, law_of_plane_surfaces) {
    check_law(91050, {{1, false}, {2, false}}, 2);
}
TEST(Influence, law_of_volumes) {
    check_law(91060, {{1, true}, {1, false}, {2, false}}, 3);
}

// The segment from (0, 0) to (1, 0) over the domain [0, 1], and a point of no influence at each end.
SplineData seen_segment(double size) {
    return curve(1, {-1, 0, 0, 1, 1, 2}, 2, {size, size, 0, 0, 1, 0, -size, -size});
}
// The same between points of weight 1, with one of weight 0 that lies anywhere.
SplineData weightless_middle(double size) {
    return curve(2, {0, 0, 0, 1, 1, 1}, 2, {0, 0, size, 0, 1, 0}, {1, 0, 1});
}

void check_segment(const SplineData &data) {
    const Handle g = create(data);
    double length = -1, lower[2], upper[2], gap = -1;
    require_ok(nurbs_curve_length(g.get(), nullptr, 0, &length, nullptr));
    EXPECT_NEAR(length, 1, 1e-14);
    require_ok(nurbs_box(g.get(), nullptr, 0, lower, upper, &gap));
    EXPECT_LE(gap, 1e-13);
    EXPECT_NEAR(lower[0], 0, 1e-13);
    EXPECT_NEAR(upper[0], 1, 1e-13);
    EXPECT_NEAR(upper[1] - lower[1], 0, 1e-13);
    const double asked[] = {0.25, 1};
    double foot[2], distance = -1;
    int32_t status = -1;
    require_ok(nurbs_closest_points(g.get(), 1, asked, 0, 0, nullptr, 1e-12, 0, nullptr, 0, 0, foot, 0, 0,
                                    &distance, 0, &status, 0));
    EXPECT_NEAR(foot[0], 0.25, 1e-12);
    EXPECT_NEAR(distance, 1, 1e-14);
    EXPECT_EQ(status, NURBS_CLOSEST_CERTIFIED);
    const Handle above = create(curve(1, {0, 0, 1, 1}, 2, {0, 1, 1, 1}));
    double at_least = -1, at_most = -1;
    require_ok(nurbs_distance(g.get(), above.get(), 1e-9, 0, &at_least, &at_most, nullptr, nullptr, &status));
    EXPECT_LE(at_least, 1);
    EXPECT_GE(at_most, 1);
    EXPECT_LE(at_most - at_least, 1e-9 + 1e-13);
    EXPECT_EQ(status, NURBS_CLOSEST_CERTIFIED);
}

TEST(Influence, points_that_no_parameter_sees) {
    for (const double size : {1.0, 1e10, 1e100, 1e200, 1e300}) {
        check_segment(seen_segment(size));
    }
}

TEST(Influence, points_of_weight_0) {
    for (const double size : {0.5, 1e10, 1e100, 1e200, 1e300}) {
        check_segment(weightless_middle(size));
    }
}

// Their stored values stay.
TEST(Influence, is_not_needed_to_be_kept) {
    for (const SplineData &data : {seen_segment(1e200), weightless_middle(1e200)}) {
        const SplineData back = read_back(create(data).get());
        EXPECT_TRUE(same_bits(back.points, data.points));
        EXPECT_TRUE(same_bits(back.weights, data.weights));
    }
}

// A weight that nobody sees scales no other one out of double precision.
TEST(Influence, weights_that_no_parameter_sees) {
    for (const double weight : {1e-300, 1.0, 1e300}) {
        SplineData data = seen_segment(1e-3);
        data.points[2] = 1e-200;
        data.weights = {weight, 1e-10, 3e-10, weight};
        const std::vector<double> found = eval(create(data).get(), {0, 0.5});
        EXPECT_EQ(found[0], 1e-200) << weight;
        EXPECT_NEAR(found[2], 0.75, 1e-15) << weight;
    }
}

} // namespace
