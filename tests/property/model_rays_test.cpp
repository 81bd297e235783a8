// Rays and models: what is certified agrees with the rays of each face and with closed forms; nothing slips through edges.
#include "property/solids.h"
#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace model_rays_test {

using namespace support;
using namespace support::solids;

namespace {

using Vec = std::vector<double>;
using Point = std::array<double, 3>;

struct Answer {
    double uv[2] = {0, 0}, t = 0;
    int32_t status = 0;
    int64_t place[2] = {-2, -2}; // face and instance
    [[nodiscard]] bool hit() const { return (status & NURBS_RAY_HIT) != 0; }
    [[nodiscard]] bool touch() const { return (status & NURBS_RAY_TOUCH) != 0; }
    [[nodiscard]] bool certified() const { return (status & NURBS_RAY_CERTIFIED) != 0; }
};

Answer cast(const nurbs_model *model, const Point &from, const Point &along) {
    Answer answer;
    require_ok(nurbs_model_rays(model, 1, from.data(), along.data(), answer.uv, &answer.t, &answer.status,
                                answer.place));
    return answer;
}
Answer cast(const nurbs_face *face, const Point &from, const Point &along) {
    Answer answer;
    require_ok(nurbs_face_rays(face, 1, from.data(), 0, 0, along.data(), 0, 0, answer.uv, &answer.t,
                               &answer.status));
    return answer;
}

struct Hits {
    Vec t;
    std::vector<int32_t> kinds;
    std::vector<int64_t> places;
    int32_t complete = -1;
};
Hits all(const nurbs_model *model, const Point &from, const Point &along) {
    Hits h;
    int64_t count = 0;
    require_ok(nurbs_model_ray_hits(model, from.data(), along.data(), nullptr, 0, nullptr, nullptr, nullptr,
                                    nullptr, &count, &h.complete));
    h.t.resize(static_cast<size_t>(count));
    h.kinds.resize(static_cast<size_t>(count));
    h.places.resize(static_cast<size_t>(2 * count));
    require_ok(nurbs_model_ray_hits(model, from.data(), along.data(), nullptr, count, nullptr, h.t.data(),
                                    h.kinds.data(), h.places.data(), &count, &h.complete));
    EXPECT_TRUE(std::is_sorted(h.t.begin(), h.t.end()));
    return h;
}

int32_t side_of(const nurbs_model *model, const Point &x, double tolerance = 0) {
    int32_t side = -7;
    require_ok(nurbs_model_classify(model, 1, x.data(), 0, 0, tolerance, &side));
    return side;
}

Point random_point(Random &random, double size) {
    return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}
Point minus(const Point &a, const Point &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// A solid, and how far inside of it a point is: negative outside.
struct Solid {
    std::vector<Face> faces;
    Model model;
    std::function<double(const Point &)> depth;
    double size;
};

Solid solid_of(std::vector<Face> faces, double size, std::function<double(const Point &)> depth) {
    Model model = model_of(given(faces));
    return {std::move(faces), std::move(model), std::move(depth), size};
}

Solid box_of(Random &random, double gap = 0) {
    Point size{}, origin{};
    auto sides = box(random, size, origin, gap);
    double largest = 0;
    for (size_t k = 0; k < 3; ++k) {
        largest = std::max({largest, std::abs(origin[k]), std::abs(origin[k] + size[k])});
    }
    return solid_of(std::move(sides), largest, [=](const Point &x) {
        double depth = HUGE_VAL;
        for (size_t k = 0; k < 3; ++k) {
            depth = std::min({depth, x[k] - origin[k], origin[k] + size[k] - x[k]});
        }
        return depth;
    });
}

std::vector<Solid> solids(Random &random) {
    std::vector<Solid> found;
    found.push_back(box_of(random));
    const double radius = random.between(0.5, 2), height = random.between(0.5, 3);
    std::vector<Face> ball;
    ball.push_back(whole(made([&](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    })));
    found.push_back(solid_of(std::move(ball), radius,
                             [=](const Point &x) { return radius - std::hypot(x[0], x[1], x[2]); }));
    found.push_back(solid_of(closed_cylinder(radius, height), std::max(radius, height), [=](const Point &x) {
        return std::min({radius - std::hypot(x[0], x[1]), x[2], height - x[2]});
    }));
    return found;
}

} // namespace

TEST(ModelRays, are_the_first_of_all_faces) {
    int64_t certified = 0, hits = 0, count = 0;
    for_each_case(2920000, 200, [&](Random &random, uint64_t seed) {
        for (const Solid &solid : solids(random)) {
            for (int i = 0; i < 20; ++i) {
                const Point from = random_point(random, 3 * solid.size),
                            along = minus(random_point(random, solid.size), from);
                const Answer answer = cast(solid.model.get(), from, along);
                double first = HUGE_VAL;
                int64_t face = -1;
                for (size_t k = 0; k < solid.faces.size(); ++k) {
                    const Answer own = cast(solid.faces[k].get(), from, along);
                    if (own.hit() && own.t < first) {
                        first = own.t;
                        face = static_cast<int64_t>(k);
                    }
                }
                ++count;
                if (!answer.certified()) {
                    continue;
                }
                ++certified;
                ASSERT_EQ(answer.hit(), first < HUGE_VAL) << seed;
                ASSERT_EQ(answer.place[0], face) << seed;
                ASSERT_EQ(answer.place[1], face < 0 ? -1 : 0) << seed;
                hits += answer.hit() ? 1 : 0;
                if (answer.hit()) {
                    ASSERT_EQ(answer.t, first) << seed;
                }
            }
        }
    });
    EXPECT_GE(certified, of_whole_run(count - count / 100));
    EXPECT_GE(hits, of_whole_run(count / 4));
}

// A ray that begins outside leaves a solid as often as it enters it.
TEST(ModelRays, from_outside_are_even) {
    int64_t complete = 0, met = 0, count = 0;
    for_each_case(2930000, 300, [&](Random &random, uint64_t seed) {
        for (const Solid &solid : solids(random)) {
            for (int i = 0; i < 10; ++i) {
                const Point from = random_point(random, 3 * solid.size),
                            along = minus(random_point(random, solid.size), from);
                const double depth = solid.depth(from);
                const Hits hits = all(solid.model.get(), from, along);
                ++count;
                if (hits.complete == 1 && std::abs(depth) > 1e-6) {
                    ++complete;
                    met += hits.t.empty() ? 0 : 1;
                    ASSERT_EQ(hits.t.size() % 2, depth > 0 ? 1U : 0U) << seed;
                }
            }
        }
    });
    EXPECT_GE(complete, of_whole_run(count - count / 50));
    EXPECT_GE(met, of_whole_run(count / 4));
}

TEST(ModelSides, agree_with_closed_forms) {
    int64_t inside = 0, undecided = 0, count = 0;
    for_each_case(2940000, 200, [&](Random &random, uint64_t seed) {
        for (const Solid &solid : solids(random)) {
            for (int i = 0; i < 20; ++i) {
                const Point x = random_point(random, 1.2 * solid.size);
                const double depth = solid.depth(x), tolerance = random.magnitude(1e-9, 1e-2);
                const int32_t side = side_of(solid.model.get(), x, tolerance);
                ++count;
                undecided += side == NURBS_SIDE_UNDECIDED ? 1 : 0;
                inside += side == NURBS_SIDE_INSIDE ? 1 : 0;
                if (side == NURBS_SIDE_INSIDE) {
                    ASSERT_GT(depth, tolerance * (1 - 1e-9)) << seed;
                } else if (side == NURBS_SIDE_OUTSIDE) {
                    ASSERT_LT(depth, -tolerance * (1 - 1e-9) / 1.7320509) << seed; // beside an edge
                } else if (side == NURBS_SIDE_ON) {
                    ASSERT_LE(std::abs(depth), tolerance * (1 + 1e-9)) << seed;
                }
            }
        }
    });
    EXPECT_LE(undecided, count / 100);
    EXPECT_GE(inside, of_whole_run(count / 10));
}

// By less and less on either side of a face, an edge and a corner, and on them.
TEST(ModelSides, at_the_boundary_are_never_false) {
    Random random(4);
    for (const Solid &solid : solids(random)) {
        for (int trial = 0; trial < 30; ++trial) {
            const Point from = random_point(random, solid.size), to = random_point(random, 3 * solid.size);
            if (solid.depth(from) <= 0 || solid.depth(to) >= 0) {
                continue;
            }
            double lower = 0, upper = 1;
            for (int i = 0; i < 60; ++i) {
                const double t = (lower + upper) / 2;
                Point x{};
                for (size_t k = 0; k < 3; ++k) {
                    x[k] = from[k] + t * (to[k] - from[k]);
                }
                const double depth = solid.depth(x);
                const int32_t side = side_of(solid.model.get(), x);
                ASSERT_TRUE(side != NURBS_SIDE_INSIDE || depth > -1e-13 * solid.size) << depth;
                ASSERT_TRUE(side != NURBS_SIDE_OUTSIDE || depth < 1e-13 * solid.size) << depth;
                ASSERT_TRUE(side != NURBS_SIDE_UNDECIDED || std::abs(depth) < 1e-10 * solid.size) << depth;
                ASSERT_EQ(side_of(solid.model.get(), x, 2 * std::abs(depth) + 1e-6), NURBS_SIDE_ON);
                (depth > 0 ? lower : upper) = t;
            }
        }
    }
}

// Through edges and corners of a box, and beside them by less and less: never a certified miss of what is behind.
TEST(ModelRays, do_not_slip_through_edges) {
    Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        Point size{}, origin{};
        const std::vector<Face> faces = box(random, size, origin);
        const Model model = model_of(given(faces));
        Point middle{};
        for (size_t k = 0; k < 3; ++k) {
            middle[k] = origin[k] + size[k] / 2;
        }
        for (int corner = 0; corner < 27; ++corner) { // corners, middles of edges and of faces
            Point at{};
            int ends = 0;
            for (size_t k = 0, rest = static_cast<size_t>(corner); k < 3; ++k, rest /= 3) {
                at[k] = origin[k] + size[k] * static_cast<double>(rest % 3) / 2;
                ends += rest % 3 != 1 ? 1 : 0;
            }
            if (ends == 0) {
                continue; // the middle itself
            }
            for (double away = 1; away > 1e-20; away /= 8) {
                const Point shifted{at[0] + away * random.between(-1, 1),
                                    at[1] + away * random.between(-1, 1),
                                    at[2] + away * random.between(-1, 1)};
                const Point out = minus(at, middle);
                const Point from{at[0] + 3 * out[0], at[1] + 3 * out[1], at[2] + 3 * out[2]};
                // Towards the middle: it always meets the box.
                const Answer inwards = cast(model.get(), from, minus(away < 1e-3 ? shifted : at, from));
                ASSERT_TRUE(inwards.hit() || inwards.touch()) << corner << ' ' << away;
                if (inwards.certified()) {
                    ASSERT_TRUE(inwards.hit());
                }
            }
        }
    }
}

// Sides of a box that leave gaps between each other, within their tolerance: nothing passes them and is told to be certified.
TEST(ModelRays, do_not_slip_through_gaps) {
    int64_t certified = 0, sides = 0, count = 0;
    for_each_case(2970000, 600, [&](Random &random, uint64_t seed) {
        const double gap = random.magnitude(1e-7, 0.015);
        const Solid solid = box_of(random, gap);
        ASSERT_EQ(counts_of(solid.model.get()).edges, 12);
        for (int i = 0; i < 40; ++i) {
            const Point in = random_point(random, solid.size), out = random_point(random, 3 * solid.size);
            if (solid.depth(in) <= 3 * gap || solid.depth(out) >= -3 * gap) {
                continue;
            }
            ++count;
            double outside = 0, inside = 1; // where the ray enters
            const Point along = minus(in, out);
            while (inside - outside > 1e-15) {
                const double t = (outside + inside) / 2;
                const Point x{out[0] + t * along[0], out[1] + t * along[1], out[2] + t * along[2]};
                (solid.depth(x) < 0 ? outside : inside) = t;
            }
            const Answer answer = cast(solid.model.get(), out, along);
            if (answer.certified()) {
                ++certified;
                ASSERT_TRUE(answer.hit()) << seed;
                ASSERT_LE((answer.t - outside) * std::hypot(along[0], along[1], along[2]), 10 * gap + 1e-12)
                    << seed;
            }
            const int32_t of_in = side_of(solid.model.get(), in), of_out = side_of(solid.model.get(), out);
            ASSERT_NE(of_in, NURBS_SIDE_OUTSIDE) << seed;
            ASSERT_NE(of_out, NURBS_SIDE_INSIDE) << seed;
            sides += (of_in == NURBS_SIDE_INSIDE ? 1 : 0) + (of_out == NURBS_SIDE_OUTSIDE ? 1 : 0);
        }
    });
    EXPECT_GE(certified, of_whole_run(count * 3 / 4));
    EXPECT_GE(sides, of_whole_run(2 * count - count / 20));
    EXPECT_GE(count, of_whole_run(500));
}

// Whatever the unit of length, and the length of the direction.
TEST(ModelRays, do_not_depend_on_units) {
    for (const double scale : {1e-150, 1e-6, 1.0, 1e6, 1e150}) {
        const Handle ball = made([&](nurbs **out) {
            return nurbs_surface_sphere(nullptr, nullptr, nullptr, scale, NURBS_ARC_QUARTERS, out);
        });
        nurbs_face *given = nullptr;
        require_ok(nurbs_face_create(ball.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9 * scale, 0,
                                     nullptr, &given));
        const Face face(given);
        const Model model = model_of({given});
        const Point from{0.25 * scale, 0.5 * scale, 4 * scale};
        const double expected = 4 - std::sqrt(1 - 0.25 * 0.25 - 0.5 * 0.5);
        for (const double length : {1e-100, 1.0, 1e100}) {
            const Point along{0.001 * length, 0.002 * length, -length};
            const Answer answer = cast(model.get(), from, along);
            ASSERT_EQ(answer.status, NURBS_RAY_HIT | NURBS_RAY_CERTIFIED) << scale << ' ' << length;
            ASSERT_NEAR(answer.t * length / scale, expected, 1e-2);
            const Hits hits = all(model.get(), from, along);
            ASSERT_EQ(hits.t.size(), 2U) << scale << ' ' << length;
            ASSERT_EQ(hits.complete, 1) << scale << ' ' << length;
            ASSERT_NEAR(hits.t[0] / answer.t, 1, 1e-12);
        }
        EXPECT_EQ(side_of(model.get(), {0.3 * scale, 0.2 * scale, 0.1 * scale}), NURBS_SIDE_INSIDE) << scale;
        EXPECT_EQ(side_of(model.get(), {0.9 * scale, 0.9 * scale, 0.1 * scale}), NURBS_SIDE_OUTSIDE) << scale;
        EXPECT_EQ(side_of(model.get(), {0.6 * scale, 0.8 * scale, 0}, 1e-6 * scale), NURBS_SIDE_ON) << scale;
    }
    const Handle ball = made([&](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 2, NURBS_ARC_QUARTERS, out);
    });
    const Face face = whole(ball);
    const Hits tiny = all(model_of({face.get()}).get(), {0.3, 0.2, 5}, {0, 0, -5e-324}); // no t is a number
    EXPECT_EQ(tiny.complete, 0);
}

// With less work less is known, and nothing else.
TEST(ModelRays, with_small_budgets_claim_nothing_false) {
    int64_t less = 0;
    for_each_case(2960000, 30, [&](Random &random, uint64_t seed) {
        for (const Solid &solid : solids(random)) {
            Vec from, along;
            constexpr int n = 8;
            for (int i = 0; i < n; ++i) {
                const Point start = random_point(random, 1.5 * solid.size),
                            way = minus(random_point(random, solid.size), start);
                from.insert(from.end(), start.begin(), start.end());
                along.insert(along.end(), way.begin(), way.end());
            }
            std::vector<int32_t> status(n), sides(n), some_status(n), some_sides(n);
            Vec t(n), some_t(n);
            require_ok(nurbs_model_rays(solid.model.get(), n, from.data(), along.data(), nullptr, t.data(),
                                        status.data(), nullptr));
            require_ok(nurbs_model_classify(solid.model.get(), n, from.data(), 0, 0, 1e-6, sides.data()));
            nurbs_call_options call;
            require_ok(nurbs_call_options_init(&call, sizeof call));
            for (const int64_t work : {1, 10, 100, 1000, 10000, 100000}) {
                call.work = work;
                require_ok(nurbs_model_rays_with(solid.model.get(), n, from.data(), along.data(), nullptr,
                                                 some_t.data(), some_status.data(), nullptr, &call));
                require_ok(nurbs_model_classify_with(solid.model.get(), n, from.data(), 0, 0, 1e-6,
                                                     some_sides.data(), &call));
                for (size_t i = 0; i < n; ++i) {
                    less += some_status[i] == status[i] ? 0 : 1;
                    if ((some_status[i] & NURBS_RAY_CERTIFIED) != 0) {
                        ASSERT_EQ(some_status[i], status[i]) << seed << ' ' << work;
                        ASSERT_TRUE(same_bits(some_t[i], t[i])) << seed << ' ' << work;
                    }
                    if (some_sides[i] != NURBS_SIDE_UNDECIDED) {
                        ASSERT_EQ(some_sides[i], sides[i]) << seed << ' ' << work;
                    }
                }
            }
        }
    });
    EXPECT_GE(less, of_whole_run(100));
}

TEST(ModelSides, need_closed_models) {
    Random random(6);
    Point size{};
    std::vector<Face> faces = box(random, size);
    faces.pop_back();
    const Model open = model_of(given(faces));
    const double x[] = {0, 0, 0};
    int32_t side = 0;
    EXPECT_EQ(nurbs_model_classify(open.get(), 1, x, 0, 0, 0, &side), NURBS_ERROR_GAP);
    EXPECT_EQ(nurbs_model_classify(open.get(), 0, nullptr, 0, 0, 0, nullptr), NURBS_ERROR_GAP);
    const Model none = model_of({});
    EXPECT_EQ(side_of(none.get(), {0, 0, 0}), NURBS_SIDE_OUTSIDE);
    EXPECT_EQ(cast(none.get(), {0, 0, 0}, {1, 0, 0}).status, NURBS_RAY_CERTIFIED);
}

// Two solids, one in the other or apart, are each for itself: a point in both is inside. Faces of one part that bound no solid
// are taken together: a ball in a ball is a shell.
TEST(ModelSides, of_faces_without_a_solid_are_those_of_one) {
    std::vector<Face> balls;
    for (const double radius : {2.0, 1.0}) {
        balls.push_back(whole(made([&](nurbs **out) {
            return nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
        })));
    }
    const Model shell = model_of(given(balls));
    EXPECT_EQ(side_of(shell.get(), {0, 0, 0}), NURBS_SIDE_OUTSIDE);
    EXPECT_EQ(side_of(shell.get(), {1.5, 0.1, 0.2}), NURBS_SIDE_INSIDE);
    EXPECT_EQ(side_of(shell.get(), {2.5, 0.1, 0.2}), NURBS_SIDE_OUTSIDE);
}

} // namespace model_rays_test
