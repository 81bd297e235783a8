// Sections of random surfaces: what is told of every branch holds at all its points, and where isoparametric lines of
// the surface cross the plane there is a branch.
#include "sections.h"
#include "support/cases.h"

#include <limits>

namespace sections_random_test {

using namespace surface_sections;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Point3 random_normal(Random &random) {
    if (random.chance(30)) {
        Point3 axis{};
        axis[static_cast<size_t>(random.whole(0, 2))] = random.chance(50) ? 1 : -1;
        return axis;
    }
    return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

SplineData random_surface(Random &random, int most_degree) {
    Recipe recipe = random_recipe(random, 2, most_degree);
    recipe.dim = 3;
    return random_spline(random, recipe);
}

// Of points evaluated by the test: parameters of many digits before the point have few behind it.
double noise_of(const SplineData &data, double size) {
    double share = 1e-12;
    for (size_t k = 0; k < 2; ++k) {
        double shortest = HUGE_VAL, largest = 0;
        for (size_t i = 0; i + 1 < data.knots[k].size(); ++i) {
            const double length = data.knots[k][i + 1] - data.knots[k][i];
            shortest = length > 0 ? std::min(shortest, length) : shortest;
            largest = std::max(largest, std::abs(data.knots[k][i + 1]));
        }
        share += 64 * (data.degrees[k] + 1) * eps * largest / shortest;
    }
    for (const double w : data.weights) {
        share = w < 0.1 || w > 10 ? std::max(share, 1e-9) : share;
    }
    return share * size;
}

struct Case {
    SplineData data;
    Handle g;
    double size;
    Point3 normal;
    double offset, tolerance, noise;

    explicit Case(Random &random, int most_degree)
        : data(random_surface(random, most_degree)), g(create(data)), size(extent(data)),
          normal(random_normal(random)), offset(0), tolerance(size * random.magnitude(1e-8, 1e-2)),
          noise(noise_of(data, size)) {
        const surface_sections::Place at{random.between(data.lower(0), data.upper(0)),
                                         random.between(data.lower(1), data.upper(1))};
        Point3 x{};
        require_ok(nurbs_eval(g.get(), 1, at.data(), 0, 0, x.data(), 0, 0, 0));
        offset = dot(normal, x);
    }
    [[nodiscard]] std::string told(uint64_t seed) const {
        return where(seed, data) + "normal " + hex({normal.begin(), normal.end()}) + " offset " +
               hex(offset) + " tolerance " + hex(tolerance);
    }
    [[nodiscard]] double length() const { return std::sqrt(dot(normal, normal)); }
    [[nodiscard]] double height(const Point3 &x) const { return (dot(normal, x) - offset) / length(); }
};

void expect_on_the_surface(const Case &c, const Ground &ground, const Branch &branch, int points) {
    const std::vector<double> t = branch.params(points);
    const std::vector<Point3> in_space = points_on(branch.space.get(), t);
    const std::vector<surface_sections::Place> on = places_on(branch.on.get(), t);
    for (size_t i = 0; i < t.size(); ++i) {
        ASSERT_LE(std::abs(c.height(in_space[i])), branch.deviation + c.noise) << "at " << t[i];
        ASSERT_LE(ground.gap(on[i], in_space[i]), 2 * branch.deviation + c.noise) << "at " << t[i];
    }
}

// Control points, and so the curve.
void expect_in_the_domain(const Ground &ground, const Branch &branch) {
    const SplineData on = read_back(branch.on.get());
    for (size_t i = 0; i < on.points.size(); i += 2) {
        ASSERT_TRUE(ground.contains({on.points[i], on.points[i + 1]}))
            << on.points[i] << ", " << on.points[i + 1];
    }
    ASSERT_EQ(on.knots, read_back(branch.space.get()).knots);
}

// The gradient of normal . S points to the left, as far as it can be told.
void expect_above_on_the_left(const Case &c, const Ground &ground, const Branch &branch) {
    const std::vector<double> params = branch.params(7);
    for (size_t i = 1; i < 7; ++i) { // at the ends the surface may jump
        const double t = params[i];
        const std::vector<double> along = eval_derivs(branch.on.get(), 1, {t});
        const surface_sections::Place at = ground.inside({along[0], along[1]});
        const std::vector<double> by = eval_derivs(c.g.get(), 1, {at[0], at[1]});
        const double u = along[2] * (c.data.upper(1) - c.data.lower(1)),
                     v = along[3] * (c.data.upper(0) - c.data.lower(0));
        const double f_u = dot(c.normal, {by[3], by[4], by[5]}) * (c.data.upper(0) - c.data.lower(0)),
                     f_v = dot(c.normal, {by[6], by[7], by[8]}) * (c.data.upper(1) - c.data.lower(1));
        const double left = u * f_v - v * f_u, whole = std::hypot(u, v) * std::hypot(f_u, f_v);
        if (branch.deviation <= c.tolerance && c.noise < 1e-6 * c.size && whole > 0 &&
            std::abs(left) > 0.3 * whole) {
            ASSERT_GT(left, 0) << "at " << t;
        }
    }
}

bool is_near(double x, const surface_sections::Place &range, double period) {
    const double room = 1e-9 * period;
    return (x >= range[0] - room && x <= range[1] + room) || x + period <= range[1] + room;
}

// Whether a node covers a place.
bool is_in_node(const Case &c, const Found &found, const surface_sections::Place &at) {
    return std::ranges::any_of(found.nodes, [&](const MeetPart &node) {
        const auto period = [&](int k) { return c.data.upper(k) - c.data.lower(k); };
        return (node.kind == NURBS_NODE_TOUCH || node.kind == NURBS_NODE_UNDECIDED) &&
               is_near(at[0], node.range[0], period(0)) && is_near(at[1], node.range[1], period(1));
    });
}

double distance_to(const Branch &branch, const Point3 &x) {
    double distance = HUGE_VAL;
    require_ok(nurbs_closest_points(branch.space.get(), 1, x.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                    nullptr, 0, 0, &distance, 0, nullptr, 0));
    return distance;
}

// Where an isoparametric line crosses the plane.
void expect_no_miss(const Case &c, const Found &found, int32_t axis, double param, int64_t &crossings) {
    const Handle line = iso(c.g.get(), axis, param);
    const std::vector<double> form{c.normal[0], c.normal[1], c.normal[2], -c.offset};
    int64_t count = 0;
    require_ok(
        nurbs_curve_level(line.get(), 1, form.data(), 0, 0, nullptr, nullptr, nullptr, &count, nullptr));
    std::vector<double> params(static_cast<size_t>(count));
    std::vector<int32_t> kinds(params.size());
    require_ok(nurbs_curve_level(line.get(), 1, form.data(), 0, count, params.data(), kinds.data(), nullptr,
                                 &count, nullptr));
    for (size_t i = 0; i < params.size(); ++i) {
        surface_sections::Place at{};
        at[static_cast<size_t>(axis)] = param;
        at[static_cast<size_t>(1 - axis)] = params[i];
        if (kinds[i] != NURBS_HIT_CROSSING || is_in_node(c, found, at)) {
            continue;
        }
        ++crossings;
        Point3 x{};
        require_ok(nurbs_eval(line.get(), 1, &params[i], 0, 0, x.data(), 0, 0, 0));
        const bool seen = std::ranges::any_of(found.branches, [&](const Branch &branch) {
            return distance_to(branch, x) <= branch.deviation + c.noise;
        });
        ASSERT_TRUE(seen) << "missed at " << at[0] << ", " << at[1];
    }
}

} // namespace

TEST(RandomSections, have_the_deviation_that_they_tell_and_miss_nothing) {
    int64_t complete = 0, branches = 0, exact = 0, crossings = 0;
    for_each_case(3100000, 400, [&](Random &random, uint64_t seed) {
        const Case c(random, 4);
        SCOPED_TRACE(c.told(seed));
        const Found found = sections_of(c.g.get(), c.normal, {c.offset}, c.tolerance);
        const Ground ground(c.g.get(), c.data);
        for (const Branch &branch : found.branches) {
            ASSERT_TRUE(std::isfinite(branch.deviation));
            ASSERT_NO_FATAL_FAILURE(expect_in_the_domain(ground, branch));
            ASSERT_NO_FATAL_FAILURE(expect_on_the_surface(c, ground, branch, 200));
            ASSERT_NO_FATAL_FAILURE(expect_above_on_the_left(c, ground, branch));
            exact += branch.deviation <= c.tolerance ? 1 : 0;
        }
        branches += std::ssize(found.branches);
        complete += found.complete ? 1 : 0;
        for (int i = 0; found.complete && i < 6; ++i) {
            const int32_t axis = random.whole(0, 1);
            const double param = random.between(c.data.lower(axis), c.data.upper(axis));
            ASSERT_NO_FATAL_FAILURE(expect_no_miss(c, found, axis, param, crossings));
        }
    });
    EXPECT_GE(complete, of_whole_run(395));
    EXPECT_GE(branches, of_whole_run(1000));
    EXPECT_GE(5 * exact, 4 * branches);
    EXPECT_GE(crossings, of_whole_run(2000));
}

// What is true of the answer is true of what is known of it at the limit of work.
TEST(RandomSections, claim_nothing_false_at_the_limit_of_work) {
    int64_t cut = 0;
    for_each_case(3110000, 60, [&](Random &random, uint64_t seed) {
        const Case c(random, 4);
        SCOPED_TRACE(c.told(seed));
        const Found whole = sections_of(c.g.get(), c.normal, {c.offset}, c.tolerance);
        const Ground ground(c.g.get(), c.data);
        for (const int64_t work : {1, 10, 100, 1000, 10000, 100000}) {
            nurbs_call_options call;
            require_ok(nurbs_call_options_init(&call, sizeof call));
            call.work = work;
            const Found found = sections_of(c.g.get(), c.normal, {c.offset}, c.tolerance, &call);
            for (const Branch &branch : found.branches) {
                ASSERT_NO_FATAL_FAILURE(expect_on_the_surface(c, ground, branch, 20));
            }
            if (found.complete) {
                ASSERT_EQ(found.branches.size(), whole.branches.size()) << work;
                ASSERT_EQ(found.nodes.size(), whole.nodes.size()) << work;
            }
            cut += found.complete ? 0 : 1;
            int64_t crossings = 0;
            ASSERT_NO_FATAL_FAILURE(
                expect_no_miss(c, found, 0, random.between(c.data.lower(0), c.data.upper(0)), crossings));
        }
    });
    EXPECT_GE(cut, of_whole_run(60));
}

} // namespace sections_random_test
