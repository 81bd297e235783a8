// Sections of random surfaces: what is told of every branch holds at all its points, and isoparametric lines of the
// surface cross the planes on branches only, and wherever a branch crosses them.
#include "sections.h"
#include "support/cases.h"

#include <limits>

namespace sections_random_test {

using namespace support;

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
        const Place at{random.between(data.lower(0), data.upper(0)), random.between(data.lower(1), data.upper(1))};
        Point3 x{};
        require_ok(nurbs_eval(g.get(), 1, at.data(), 0, 0, x.data(), 0, 0, 0));
        offset = dot(normal, x);
    }
    [[nodiscard]] double length() const { return std::sqrt(dot(normal, normal)); }
    [[nodiscard]] double height(const Point3 &x) const { return (dot(normal, x) - offset) / length(); }
};

void expect_branch(const Case &c, const Ground &ground, const Branch &branch, int points) {
    const std::vector<double> t = branch.params(points);
    const std::vector<Point3> in_space = points_on(branch.space.get(), t);
    const std::vector<Place> on = places_on(branch.on.get(), t);
    for (size_t i = 0; i < t.size(); ++i) {
        ASSERT_TRUE(ground.contains(on[i])) << on[i][0] << ", " << on[i][1];
        ASSERT_LE(std::abs(c.height(in_space[i])), branch.deviation + c.noise) << "at " << t[i];
        ASSERT_LE(ground.gap(on[i], in_space[i]), 2 * branch.deviation + c.noise) << "at " << t[i];
    }
}

bool is_near(double x, const Place &range, double room) {
    return x >= range[0] - room && x <= range[1] + room;
}

// Whether a node covers a place.
bool is_in_node(const Case &c, const Found &found, const Place &at) {
    return std::ranges::any_of(found.nodes, [&](const MeetPart &node) {
        const auto room = [&](int k) { return 1e-9 * (c.data.upper(k) - c.data.lower(k)); };
        return (node.kind == NURBS_NODE_TOUCH || node.kind == NURBS_NODE_UNDECIDED) &&
               is_near(at[0], node.range[0], room(0)) && is_near(at[1], node.range[1], room(1));
    });
}

double distance_to(const Branch &branch, const Point3 &x) {
    double distance = HUGE_VAL;
    require_ok(nurbs_closest_points(branch.space.get(), 1, x.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0,
                                    0, &distance, 0, nullptr, 0));
    return distance;
}

// Where an isoparametric line crosses the plane.
void expect_no_miss(const Case &c, const Found &found, int32_t axis, double param) {
    const Handle line = iso(c.g.get(), axis, param);
    const std::vector<double> form{c.normal[0], c.normal[1], c.normal[2], -c.offset};
    int64_t count = 0;
    require_ok(nurbs_curve_level(line.get(), 1, form.data(), 0, 0, nullptr, nullptr, nullptr, &count, nullptr));
    std::vector<double> params(static_cast<size_t>(count));
    std::vector<int32_t> kinds(params.size());
    require_ok(nurbs_curve_level(line.get(), 1, form.data(), 0, count, params.data(), kinds.data(), nullptr, &count,
                                 nullptr));
    for (size_t i = 0; i < params.size(); ++i) {
        Place at{};
        at[static_cast<size_t>(axis)] = param;
        at[static_cast<size_t>(1 - axis)] = params[i];
        if (kinds[i] != NURBS_HIT_CROSSING || is_in_node(c, found, at)) {
            continue;
        }
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
    int64_t complete = 0, branches = 0, exact = 0;
    for_each_case(3100000, 400, [&](Random &random, uint64_t seed) {
        const Case c(random, 4);
        const Found found = sections_of(c.g.get(), c.normal, {c.offset}, c.tolerance);
        const Ground ground(c.g.get(), c.data);
        const std::string told = where(seed, c.data) + "normal " + hex(std::vector<double>(c.normal.begin(), c.normal.end())) + " offset " + hex(c.offset) + " tolerance " + hex(c.tolerance);
        SCOPED_TRACE(told);
        for (const Branch &branch : found.branches) {
            expect_branch(c, ground, branch, 200);
            exact += branch.deviation <= c.tolerance ? 1 : 0;
        }
        branches += std::ssize(found.branches);
        complete += found.complete ? 1 : 0;
        for (int i = 0; found.complete && i < 6 && !testing::Test::HasFatalFailure(); ++i) {
            const int32_t axis = random.whole(0, 1);
            expect_no_miss(c, found, axis, random.between(c.data.lower(axis), c.data.upper(axis)));
        }
    });
    std::printf("complete %lld, branches %lld, to the tolerance %lld\n", static_cast<long long>(complete),
                static_cast<long long>(branches), static_cast<long long>(exact));
}

} // namespace sections_random_test
