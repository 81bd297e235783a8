// Faces of surfaces that close up or have poles, divided and put together: how many parts there are, what they add up to, and that
// places are where curves leave them, wherever seams and poles lie.
#include "property/regions.h"
#include "property/sections.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <set>

namespace closed_regions_test {

using namespace support;
using namespace support::regions;
using models::Face;

namespace {

constexpr double pi = std::numbers::pi;

Handle sphere() {
    return made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
}
Handle cylinder() {
    return made([](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0.3, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
}
Handle torus() {
    return made([](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0.2, 2 * pi, 0.1, 2 * pi,
                                   NURBS_ARC_QUARTERS, out);
    });
}

// A surface with its domain, in which places are told in shares of its sides.
struct Ground {
    Handle surface;
    Point lower{}, side{};

    explicit Ground(Handle given) : surface(std::move(given)) {
        for (int k = 0; k < 2; ++k) {
            double ends[2];
            require_ok(nurbs_domain(surface.get(), k, ends));
            lower[static_cast<size_t>(k)] = ends[0];
            side[static_cast<size_t>(k)] = ends[1] - ends[0];
        }
    }
    [[nodiscard]] Point at(double u, double v) const {
        return {lower[0] + u * side[0], lower[1] + v * side[1]};
    }
    [[nodiscard]] Handle segment(double u, double v, double to_u, double to_v) const {
        const Point a = at(u, v), b = at(to_u, to_v);
        return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {a[0], a[1], b[0], b[1]}, {}});
    }
    // Closed in the plane that covers the domain, smooth, with its control points on a circle.
    [[nodiscard]] Handle ring(double u, double v, double radius) const {
        SplineData data{{2}, {9}, {{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}}, 2, {}, {}};
        const double far = radius * std::sqrt(2.0);
        for (int i = 0; i < 9; ++i) {
            const double angle = i * pi / 4, own = i % 2 == 0 ? radius : far;
            const Point x =
                at(u + own * std::cos(i == 8 ? 0 : angle), v + own * std::sin(i == 8 ? 0 : angle));
            data.points.insert(data.points.end(), x.begin(), x.end());
        }
        return create(data);
    }
    [[nodiscard]] Face face(const Curves &loops = {}) const {
        std::vector<const nurbs *> curves;
        std::vector<int64_t> sizes(loops.size(), 1);
        for (const Handle &curve : loops) {
            curves.push_back(curve.get());
        }
        nurbs_face *out = nullptr;
        require_ok(nurbs_face_create(surface.get(), std::ssize(sizes), sizes.data(), curves.data(), nullptr,
                                     nullptr, 1e-9, 0, nullptr, &out));
        return Face(out);
    }
};

Model split(const nurbs_face *face, const Curves &curves, double tolerance = 0) {
    std::vector<const nurbs *> given;
    for (const Handle &curve : curves) {
        given.push_back(curve.get());
    }
    nurbs_model *model = nullptr;
    require_ok(nurbs_face_split(face, std::ssize(given), given.data(), tolerance, &model));
    return Model(model);
}

int64_t parts_of(const Model &model) {
    return models::counts_of(model.get()).faces;
}

double area(const nurbs_face *face) {
    double result = 0;
    require_ok(nurbs_face_area(face, 1e-7, &result, nullptr));
    return result;
}
double area(const Model &model) {
    double sum = 0;
    for (const Face &face : faces_of(model.get())) {
        sum += area(face.get());
    }
    return sum;
}

// Places are in one part at most; in one if they are in the face.
void expect_cover(const Ground &ground, const nurbs_face *face, const Model &model, Random &random) {
    Vec places;
    for (int i = 0; i < 200; ++i) {
        const Point x = ground.at(random.between(0, 1), random.between(0, 1));
        places.insert(places.end(), x.begin(), x.end());
    }
    std::vector<int32_t> in_face(200), own(200);
    std::vector<int> inside(200, 0), on(200, 0);
    require_ok(nurbs_face_classify(face, 200, places.data(), 0, 0, 1e-6, in_face.data()));
    for (const Face &part : faces_of(model.get())) {
        require_ok(nurbs_face_classify(part.get(), 200, places.data(), 0, 0, 1e-6, own.data()));
        for (size_t i = 0; i < 200; ++i) {
            inside[i] += own[i] > 0 ? 1 : 0;
            on[i] += own[i] == 0 ? 1 : 0;
        }
    }
    for (size_t i = 0; i < 200; ++i) {
        EXPECT_TRUE(in_face[i] == 0 || on[i] > 0 || inside[i] == (in_face[i] > 0 ? 1 : 0))
            << places[2 * i] << " " << places[2 * i + 1] << ": " << inside[i] << " of " << in_face[i];
    }
}

void expect_parts(const Ground &ground, const nurbs_face *face, const Curves &curves, int64_t count,
                  Random &random) {
    const Model parts = split(face, curves);
    EXPECT_EQ(parts_of(parts), count);
    EXPECT_NEAR(area(parts), area(face), 1e-6 * area(face));
    for (const Face &part : faces_of(parts.get())) {
        EXPECT_GT(area(part.get()), 0);
    }
    expect_cover(ground, face, parts, random);
}

} // namespace

// m lines that wind a times around axis 0 and b times around axis 1, n of another kind: m n |ad - bc| disks, or as many rings as
// there are lines.
TEST(ClosedRegions, LinesOnATorus) {
    for_each_case(8950, 40, [](Random &random, uint64_t) {
        const Ground ground(torus());
        const Face face = ground.face();
        const int a = random.whole(0, 2),
                  b = a == 0 ? 1 : random.whole(-1, 1) * (a == 2 ? 1 : random.whole(0, 2));
        const int c = random.whole(0, 1), d = c == 0 ? 1 : random.whole(-1, 1);
        const int det = std::abs(a * d - b * c), m = random.whole(1, 3), n = random.whole(1, 3);
        if (det == 0 || (a == 2 && b % 2 == 0)) {
            return;
        }
        Curves curves;
        for (int i = 0; i < m + n; ++i) {
            const double u = random.between(-1, 2), v = random.between(-1, 2);
            curves.push_back(i < m ? ground.segment(u, v, u + a, v + b) : ground.segment(u, v, u + c, v + d));
        }
        expect_parts(ground, face.get(), curves, m * n * det, random);
        Curves first;
        for (int i = 0; i < m; ++i) {
            const double u = random.between(-1, 2), v = random.between(-1, 2);
            first.push_back(ground.segment(u, v, u + a, v + b));
        }
        expect_parts(ground, face.get(), first, m, random);
    });
}

TEST(ClosedRegions, RingsAnywhere) {
    for_each_case(8960, 40, [](Random &random, uint64_t) {
        const bool round = random.chance(50);
        const Ground ground(round ? torus() : cylinder());
        const Face face = ground.face();
        Curves curves;
        const int n = random.whole(1, 4);
        for (int i = 0; i < n; ++i) { // apart, in any copy of the domain
            curves.push_back(
                ground.ring(i * 0.25 + random.whole(-1, 1), round ? random.between(-1, 2) : 0.5, 0.08));
        }
        expect_parts(ground, face.get(), curves, n + 1, random);
        if (!round) { // through all of them
            curves.push_back(ground.segment(0.7, 0.5, 1.7, 0.5));
            expect_parts(ground, face.get(), curves, 2 * n + 2, random);
        }
    });
}

// Lines around a cylinder, and lines up it that wind.
TEST(ClosedRegions, BandsOfACylinder) {
    for_each_case(8970, 40, [](Random &random, uint64_t) {
        const Ground ground(cylinder());
        const Face face = ground.face();
        Curves curves;
        const int around = random.whole(0, 3), up = random.whole(0, 3);
        const double wind = random.between(-2, 2);
        for (int i = 0; i < around; ++i) {
            const double u = random.between(-1, 1), v = (i + random.between(0.2, 0.8)) / around;
            curves.push_back(ground.segment(u, v, u + 1, v));
        }
        for (int i = 0; i < up; ++i) {
            const double u = random.between(-1, 1);
            curves.push_back(ground.segment(u, 0, u + wind, 1));
        }
        expect_parts(ground, face.get(), curves, (around + 1) * std::max(up, 1), random);
    });
}

// Meridians, which do not cross between the poles, and circles of latitude.
TEST(ClosedRegions, SectorsOfASphere) {
    for_each_case(8980, 40, [](Random &random, uint64_t) {
        const Ground ground(sphere());
        const Face face = ground.face();
        Curves curves;
        const int around = random.whole(0, 3), up = random.whole(0, 4);
        for (int i = 0; i < around; ++i) {
            const double u = random.between(-1, 1), v = (i + random.between(0.2, 0.8)) / around;
            curves.push_back(ground.segment(u, v, u + 1, v));
        }
        for (int i = 0; i < up; ++i) { // some from pole to pole, some that begin and end beyond the poles
            const double u = i * 0.25 + random.whole(-1, 1), wind = random.between(-0.05, 0.05);
            curves.push_back(random.chance(50) ? ground.segment(u, 0, u + wind, 1)
                                               : ground.segment(u, -0.5, u + wind, 1.5));
        }
        expect_parts(ground, face.get(), curves, (around + 1) * std::max(up, 1), random);
    });
}

// Both curves come to a pole at one parameter, so that between them there is nothing of it, or all.
TEST(ClosedRegions, WedgesWithAnApexOnAPole) {
    for_each_case(9010, 20, [](Random &random, uint64_t seed) {
        const Ground ground(sphere());
        const Face face = ground.face();
        const double apex = seed % 4 == 0 ? 0 : random.unit(), foot = random.unit(),
                     pole = static_cast<double>(seed % 2);
        Curves curves;
        curves.push_back(ground.segment(apex, 0, apex, 1));
        curves.push_back(ground.segment(apex, pole, foot, 1 - pole));
        expect_parts(ground, face.get(), curves, 2, random);
    });
}

// What runs once around has its inside to its left, however little of the domain that is.
TEST(ClosedRegions, CapsOfAnySize) {
    for_each_case(8996, 24, [](Random &random, uint64_t seed) {
        const Ground ground(seed % 2 == 0 ? sphere() : cylinder());
        const Face face = ground.face();
        const double size = std::pow(10, random.between(-8, -0.5)), v = random.chance(50) ? size : 1 - size,
                     from = random.unit();
        Curves curves;
        curves.push_back(ground.segment(from, v, random.chance(50) ? from + 1 : from - 1, v));
        const Model parts = split(face.get(), curves);
        ASSERT_EQ(parts_of(parts), 2);
        for (const double side : {0.0, 1.0}) {
            const Point place = ground.at(random.unit(), side + (v - side) * 0.5);
            int inside = 0;
            for (const Face &part : faces_of(parts.get())) {
                int32_t own = 0;
                require_ok(nurbs_face_classify(part.get(), 1, place.data(), 0, 0, 0, &own));
                inside += own > 0 ? 1 : 0;
            }
            EXPECT_EQ(inside, 1) << v << " " << side;
        }
    });
}

// A curve that ends no farther beside the border, or another curve, than the tolerance divides as one that ends on it; farther away it
// ends in the face.
TEST(ClosedRegions, CurvesThatEndNearOthers) {
    for_each_case(8998, 40, [](Random &random, uint64_t seed) {
        const Ground ground(seed % 2 == 0 ? cylinder() : made([](nurbs **out) {
            const double u[] = {4, 0, 0}, v[] = {0, 4, 0};
            return nurbs_surface_plane(3, nullptr, u, v, out);
        }));
        const Face face = ground.face();
        const double tolerance = std::pow(10, random.between(-9, -4)), share = tolerance / 4; // of the side
        const auto gap = [&] { return share * std::pow(10, random.between(-6, -0.5)); };
        Curves curves;
        curves.push_back(ground.segment(0.1, 0, 0.2, 1));
        curves.push_back(ground.segment(0.5, gap(), 0.6, 1 - gap()));
        EXPECT_EQ(parts_of(split(face.get(), curves, tolerance)), seed % 2 == 0 ? 2 : 3);
        curves.push_back(ground.segment(0.15 + gap(), 0.5, 0.55 - gap(), 0.5));
        EXPECT_EQ(parts_of(split(face.get(), curves, tolerance)), seed % 2 == 0 ? 3 : 4);
        curves.pop_back();
        curves.push_back(ground.segment(0.15 + 64 * share, 0.5, 0.55, 0.5));
        EXPECT_EQ(parts_of(split(face.get(), curves, tolerance)), seed % 2 == 0 ? 2 : 3);
    });
}

// Circles in general position divide a sphere into crossings + connected sets of circles + 1 parts.
TEST(ClosedRegions, PlanesDivideASphere) {
    for_each_case(8990, 40, [](Random &random, uint64_t) {
        const Ground ground(sphere());
        const Face face = ground.face();
        Curves curves;
        std::vector<std::array<double, 4>> planes;
        for (int i = random.whole(1, 4); i > 0; --i) {
            std::array<double, 4> plane{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1),
                                        0};
            const double size = std::hypot(plane[0], plane[1], plane[2]);
            for (int k = 0; k < 3; ++k) {
                plane[static_cast<size_t>(k)] /= size;
            }
            plane[3] = random.between(-0.9, 0.9);
            planes.push_back(plane);
            nurbs_meet *made_meet = nullptr;
            require_ok(
                nurbs_surface_sections(ground.surface.get(), plane.data(), 1, &plane[3], 1e-9, &made_meet));
            const surface_sections::MeetHandle meet(made_meet);
            int64_t branches = 0;
            require_ok(nurbs_meet_counts(made_meet, &branches, nullptr, nullptr));
            for (int64_t j = 0; j < branches; ++j) {
                curves.push_back(made([&](nurbs **out) {
                    nurbs *space = nullptr;
                    const nurbs_status status = nurbs_meet_branch(made_meet, j, &space, out);
                    nurbs_destroy(space);
                    return status;
                }));
            }
        }
        std::vector<size_t> sets(planes.size());
        int64_t crossings = 0;
        for (size_t i = 0; i < planes.size(); ++i) {
            sets[i] = i;
            for (size_t j = 0; j < i; ++j) {
                const auto &p = planes[i], &q = planes[j];
                const double cosine = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
                // Of the line that both have in common, the place nearest to the centre.
                const double off =
                    (p[3] * p[3] + q[3] * q[3] - 2 * p[3] * q[3] * cosine) / (1 - cosine * cosine);
                if (off < 1) {
                    crossings += 2;
                    const size_t from = sets[i], to = sets[j];
                    std::ranges::replace(sets, from, to);
                }
            }
        }
        const auto connected = static_cast<int64_t>(std::set<size_t>(sets.begin(), sets.end()).size());
        expect_parts(ground, face.get(), curves, crossings + connected + 1, random);
    });
}

namespace {

Model combined(int32_t rule, const Model &a, const Model &b) {
    return combine(rule, a, b);
}

// A part of the surface that rings, and lines around it or up it, bound.
Model random_part(const Ground &ground, const nurbs_face *face, bool round, Random &random) {
    Curves curves;
    for (int i = random.whole(0, 2); i > 0; --i) {
        curves.push_back(
            ground.ring(random.between(-1, 1), random.between(0.3, 0.7), random.between(0.1, 0.24)));
    }
    for (int i = 0; i < 2; ++i) {
        const double u = random.between(-1, 1), v = i * 0.5 + random.between(0.05, 0.45);
        curves.push_back(round ? ground.segment(u, v, u + 1, v + random.whole(0, 1))
                               : ground.segment(u, v, u + 1, v));
    }
    const Model parts = split(face, curves);
    std::vector<const nurbs_face *> some;
    const std::vector<Face> all = faces_of(parts.get());
    for (const Face &part : all) {
        if (random.chance(50)) {
            some.push_back(part.get());
        }
    }
    nurbs_model *out = nullptr;
    require_ok(nurbs_region_combine(NURBS_REGION_UNION, std::ssize(some), some.data(), 0, nullptr, 0, &out));
    return Model(out);
}

} // namespace

TEST(ClosedRegions, LawsOfSets) {
    for_each_case(9040, 40, [](Random &random, uint64_t number) {
        const bool round = number % 3 == 2;
        const Ground ground(round ? torus() : number % 3 == 1 ? cylinder() : sphere());
        const Face face = ground.face();
        const Model all = models::model_of({face.get()});
        const Model a = random_part(ground, face.get(), round, random),
                    b = random_part(ground, face.get(), round, random);
        const double of_a = area(a), of_b = area(b), whole = area(face.get());
        const Model common = combined(NURBS_REGION_INTERSECTION, a, b),
                    either = combined(NURBS_REGION_UNION, a, b);
        EXPECT_NEAR(of_a + of_b, area(common) + area(either), 1e-5 * whole);
        EXPECT_NEAR(of_a - area(common), area(combined(NURBS_REGION_DIFFERENCE, a, b)), 1e-5 * whole);
        EXPECT_NEAR(area(either) - area(common), area(combined(NURBS_REGION_EITHER, a, b)), 1e-5 * whole);
        const Model rest = combined(NURBS_REGION_DIFFERENCE, all, a);
        EXPECT_NEAR(area(rest) + of_a, whole, 1e-5 * whole);
        const Model again = combined(NURBS_REGION_UNION, rest, a);
        ASSERT_EQ(parts_of(again), 1); // all of it, with the natural border
        EXPECT_NEAR(area(again), whole, 1e-5 * whole);
        expect_cover(ground, face.get(), again, random);
        EXPECT_EQ(parts_of(combined(NURBS_REGION_INTERSECTION, rest, a)), 0);
    });
}

// What one curve divides is put together again, and keeps the keys of its border.
TEST(ClosedRegions, FacesWithoutAnOuterLoop) {
    const Ground ground(sphere());
    Curves hole;
    hole.push_back(ground.ring(0.98, 0.4, 0.1));
    const Face cap = ground.face(hole); // what the ring encloses, or leaves
    const double inside = area(cap.get());
    Random random(1);
    Curves across;
    across.push_back(ground.segment(0.98, -0.2, 0.98, 1.2));
    expect_parts(ground, cap.get(), across, inside < 6 ? 2 : 1, random);
    const Model all = models::model_of({ground.face().get()}), own = models::model_of({cap.get()});
    const Model rest = combined(NURBS_REGION_DIFFERENCE, all, own);
    ASSERT_EQ(parts_of(rest), 1);
    EXPECT_NEAR(area(rest) + inside, 4 * pi, 1e-5);
    across.push_back(ground.segment(0.5, -0.2, 0.5, 1.2));
    const Face outer = models::face_of(rest.get(), 0);
    expect_parts(ground, outer.get(), across, 2, random);
}

namespace {

std::vector<Use> uses_in(const Model &parts) {
    std::vector<Use> uses;
    for (const Face &part : faces_of(parts.get())) {
        for (std::vector<Use> &loop : loops_of(part.get())) {
            std::ranges::move(loop, std::back_inserter(uses));
        }
    }
    return uses;
}

} // namespace

// Of a loop that runs up a seam and down again both sides get one edge with one number, whether it had one
// before or not.
TEST(ClosedRegions, SidesOfASeamHaveOneEdge) {
    const Ground ground(cylinder());
    const auto image = [&](const Vec &place) {
        return eval(ground.surface.get(), place, NURBS_ON_AXIS(0, NURBS_WRAP));
    };
    const auto side = [&](double from, double to) {
        const Point a = ground.at(0, from), b = ground.at(0, to);
        const Vec x = eval(ground.surface.get(), {a[0], a[1], b[0], b[1]});
        return create({{1}, {2}, {{0, 0, 1, 1}}, 3, x, {}});
    };
    const Handle curves[] = {ground.segment(0, 0, 1, 0), ground.segment(1, 0, 1, 1),
                             ground.segment(1, 1, 0, 1), ground.segment(0, 1, 0, 0)};
    const nurbs *loop[] = {curves[0].get(), curves[1].get(), curves[2].get(), curves[3].get()};
    const Handle up = side(0, 1), down = side(1, 0);
    const nurbs *alike[] = {nullptr, up.get(), nullptr, down.get()},
                *rises[] = {nullptr, up.get(), nullptr, up.get()},
                *falls[] = {nullptr, down.get(), nullptr, down.get()};
    Curves halves;
    halves.push_back(ground.segment(0.5, -0.1, 0.5, 1.1));
    struct Given {
        const nurbs *const *edges;
        std::array<int64_t, 4> keys;
    };
    for (const Given &given : {Given{alike, {}},
                               {rises, {0, 7, 0, -7}},
                               {falls, {0, -7, 0, 7}},
                               {nullptr, {}},
                               {nullptr, {0, 7, 0, -7}},
                               {nullptr, {0, -7, 0, 7}}}) {
        const int64_t size = 4;
        nurbs_face *out = nullptr;
        require_ok(nurbs_face_create(ground.surface.get(), 1, &size, loop, given.edges, given.keys.data(),
                                     1e-9, 0, nullptr, &out));
        const Model parts = split(Face(out).get(), halves);
        EXPECT_EQ(parts_of(parts), 2);
        std::map<int64_t, int> found;
        for (const Use &use : uses_in(parts)) {
            ++found[use.key];
            const bool upwards = end_of(use.curve.get(), true)[1] > end_of(use.curve.get(), false)[1];
            EXPECT_TRUE(std::abs(use.key) != 7 || use.key == given.keys[upwards ? 1 : 3]);
            const Vec start = image(end_of(use.curve.get(), false)),
                      end = end_of(use.edge.get(), use.key < 0);
            for (size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(start[c], end[c], 1e-9) << use.key;
            }
        }
        int shared = 0;
        for (const auto &[key, times] : found) {
            EXPECT_NE(key, 0);
            EXPECT_EQ(times, 1) << key;
            shared += found.contains(-key) ? 1 : 0;
        }
        EXPECT_EQ(shared, 4); // the sides of the seam and of the cut
        EXPECT_EQ(found.contains(7), given.keys[1] != 0);
    }
}

// Edges end in nodes, bit for bit, wherever the surface lies.
TEST(ClosedRegions, EdgesEndInNodesFarFromTheOrigin) {
    const Handle round = cylinder();
    for (const double far : {0.0, 1e3, 5e6}) {
        const double same[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, move[] = {far, -far, far / 2};
        const Ground ground(
            made([&](nurbs **out) { return nurbs_transform(round.get(), 3, same, move, out); }));
        Random random(11);
        Curves lines;
        for (int i = 0; i < 6; ++i) {
            const double u = random.between(0, 1), v = random.between(0.1, 0.9);
            lines.push_back(ground.segment(u, -0.1, u + random.between(-0.3, 0.3), 1.1));
            lines.push_back(ground.segment(u, v, u + 1, v));
        }
        const Model parts = split(ground.face().get(), lines);
        EXPECT_GT(parts_of(parts), 6);
        for (const Face &part : faces_of(parts.get())) {
            for (const std::vector<Use> &loop : loops_of(part.get())) {
                for (size_t i = 0; i < loop.size(); ++i) {
                    const Use &use = loop[i], &next = loop[(i + 1) % loop.size()];
                    EXPECT_EQ(end_of(use.edge.get(), use.key > 0), end_of(next.edge.get(), next.key < 0));
                }
            }
        }
    }
}

// Places that are at an end of a closed domain to rounding are that end, bit for bit, also if the other end
// is farther from 0.
TEST(ClosedRegions, EndsOfDomainsNearZero) {
    const Handle round = cylinder();
    const double upper = 1e-3, period = 3 + upper;
    const Ground ground(
        made([&](nurbs **out) { return nurbs_reparametrize(round.get(), 0, -3, upper, out); }));
    for (int i = 1; i < 40; ++i) {
        const double from = -3 + period * i / 40;
        const auto line = [&](double a, double v, double b, double w) {
            return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {a, v, b, w}, {}});
        };
        const double low = ground.at(0, 0)[1], high = ground.at(0, 1)[1];
        const Handle bottom = line(from, low, from + period, low),
                     top = line(from + period, high, from, high);
        const nurbs *loops[] = {bottom.get(), top.get()};
        const int64_t sizes[] = {1, 1};
        nurbs_face *out = nullptr;
        require_ok(nurbs_face_create(ground.surface.get(), 2, sizes, loops, nullptr, nullptr, 1e-9, 0,
                                     nullptr, &out));
        const Face face(out);
        Curves cuts;
        cuts.push_back(line(-3, low - 0.1, -3, high + 0.1));
        cuts.push_back(line(from, low - 0.1, from, high + 0.1));
        const Model parts = split(face.get(), cuts);
        EXPECT_EQ(parts_of(parts), 2);
        for (const Use &use : uses_in(parts)) {
            for (const bool end : {false, true}) {
                const double x = end_of(use.curve.get(), end)[0];
                EXPECT_TRUE(std::abs(x - upper) > 1e-12 || x == upper) << x - upper;
                EXPECT_TRUE(std::abs(x + 3) > 1e-12 || x == -3) << x + 3;
            }
        }
    }
}

} // namespace closed_regions_test
