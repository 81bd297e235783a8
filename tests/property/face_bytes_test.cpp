// Faces as bytes: the same face comes back, which answers with the same bits, and any change is found.
#include "property/bytes.h"
#include "property/faces.h"

namespace face_bytes_test {

using namespace support;
using namespace support::faces;

namespace {

Bytes bytes_of(const Face &face) {
    return written(nurbs_face_to_bytes, face);
}

Face face_from(const Bytes &bytes) {
    Face face;
    EXPECT_EQ(read_bytes(nurbs_face_from_bytes, bytes, face), NURBS_OK) << last_error();
    return face;
}

Vec random_places(Random &random, const Ground &ground, int n) {
    Vec places;
    for (int i = 0; i < n; ++i) {
        const Place x = ground.at(random.unit(), random.unit());
        places.insert(places.end(), x.begin(), x.end());
    }
    return places;
}

Vec deviation_of(const nurbs_face *face, int64_t loop, int64_t index) {
    double distance = -1;
    int32_t proven = -1;
    require_ok(nurbs_face_deviation(face, loop, index, &distance, &proven));
    return {distance, static_cast<double>(proven)};
}

std::vector<int64_t> loops_of(const nurbs_face *face) {
    int64_t count = 0;
    require_ok(nurbs_face_loops(face, 0, nullptr, &count));
    std::vector<int64_t> sizes(static_cast<size_t>(count));
    require_ok(nurbs_face_loops(face, count, sizes.data(), nullptr));
    return sizes;
}

// Curves and edges of two faces are the same, bit for bit.
void expect_same_loops(const nurbs_face *a, const nurbs_face *b) {
    const std::vector<int64_t> sizes = loops_of(a);
    ASSERT_EQ(loops_of(b), sizes);
    for (int64_t loop = 0; loop < std::ssize(sizes); ++loop) {
        for (int64_t i = 0; i < sizes[static_cast<size_t>(loop)]; ++i) {
            int64_t keys[2] = {-1, -2};
            std::array<Handle, 2> curves, edges;
            for (const size_t k : {size_t{0}, size_t{1}}) {
                const nurbs_face *face = k == 0 ? a : b;
                curves[k] = made([&](nurbs **out) { return nurbs_face_curve(face, loop, i, out); });
                edges[k] = made([&](nurbs **out) { return nurbs_face_edge(face, loop, i, &keys[k], out); });
            }
            EXPECT_EQ(written(nurbs_to_bytes, curves[0]), written(nurbs_to_bytes, curves[1]));
            EXPECT_EQ(written(nurbs_to_bytes, edges[0]), written(nurbs_to_bytes, edges[1]));
            EXPECT_EQ(keys[0], keys[1]);
            EXPECT_TRUE(same_bits(deviation_of(a, loop, i), deviation_of(b, loop, i)));
        }
    }
}

void expect_same_answers(Random &random, const Ground &ground, const Face &a, const Face &b) {
    const Vec places = random_places(random, ground, 200);
    EXPECT_EQ(sides(a.get(), places), sides(b.get(), places));
    EXPECT_EQ(sides(a.get(), places, 0.05), sides(b.get(), places, 0.05));
    EXPECT_EQ(area_of(a.get(), 1e-6), area_of(b.get(), 1e-6));
    const Box box = box_of(a.get(), 1e-3), other = box_of(b.get(), 1e-3);
    EXPECT_TRUE(same_bits(box.lower, other.lower) && same_bits(box.upper, other.upper));
}

Face expect_survives(Random &random, uint64_t seed, const Ground &ground, const Face &face) {
    const Bytes bytes = bytes_of(face);
    Face again = face_from(bytes);
    EXPECT_EQ(bytes_of(again), bytes) << "seed " << seed;
    expect_same_loops(face.get(), again.get());
    expect_same_answers(random, ground, face, again);
    expect_every_change_found<Face>(nurbs_face_from_bytes, random, seed, bytes);
    return again;
}

Ground any_ground(Random &random) {
    switch (random.whole(0, 4)) {
    case 0:
        return plane(random.magnitude(1e-3, 1e3));
    case 1:
        return wavy(random);
    case 2:
        return cylinder(2, 3);
    case 3:
        return sphere(1.5);
    default:
        return torus(3, 1);
    }
}

// Constant between knots along one axis or both.
Ground stepped(Random &random) {
    SplineData data{{0, random.whole(0, 1)}, {}, {}, 3, {}, {}, 0};
    if (random.chance(50)) {
        std::swap(data.degrees[0], data.degrees[1]);
    }
    for (const int degree : data.degrees) {
        const int count = random.whole(2, 4);
        data.counts.push_back(count);
        data.knots.emplace_back();
        for (int i = 0; i <= count + degree; ++i) {
            data.knots.back().push_back(std::clamp(i - degree, 0, count - degree));
        }
    }
    for (int64_t i = 0; i < 3 * data.counts[0] * data.counts[1]; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return ground_of(create(data), false, false);
}

Handle any_star(Random &random, const Ground &ground, double radius) {
    Star kind;
    kind.degree = random.whole(1, 7);
    kind.rational = random.chance(50);
    kind.periodic = kind.degree > 1 && random.chance(50);
    kind.radius = radius;
    Handle curve = create(star(random, ground, ground.at(0.5, 0.5), kind));
    return random.chance(50) ? std::move(curve)
                             : made([&](nurbs **out) { return nurbs_reverse(curve.get(), 0, 0, out); });
}

// An outer loop and a hole, each in any direction, so that some are turned.
TEST(FaceBytes, faces_survive_whichever_of_their_loops_are_turned) {
    for_each_case(1200000, 60, [](Random &random, uint64_t seed) {
        const Ground ground = any_ground(random);
        const Handle outer = any_star(random, ground, 0.4), inner = any_star(random, ground, 0.1);
        const Face face = face_of(ground.surface.get(), {{inner.get()}, {outer.get()}});
        expect_survives(random, seed, ground, face);
    });
}

TEST(FaceBytes, whole_surfaces_survive) {
    for_each_case(1200100, 20, [](Random &random, uint64_t seed) {
        const Ground ground = any_ground(random);
        expect_survives(random, seed, ground, face_of(ground.surface.get(), {}));
    });
}

// Such faces have no area, but places in them.
TEST(FaceBytes, faces_of_steps_survive) {
    for_each_case(1200400, 10, [](Random &random, uint64_t seed) {
        const Ground ground = stepped(random);
        expect_survives(random, seed, ground, face_of(ground.surface.get(), {}));
        const Handle curve = any_star(random, ground, 0.4);
        expect_survives(random, seed, ground, face_of(ground.surface.get(), {{curve.get()}}));
    });
}

// Two triangles of a square that does not close, with edges and keys. Curves are made under them, with what is proven of them;
// the loop is turned, so that edges without keys are turned, too.
TEST(FaceBytes, made_curves_and_their_proofs_survive) {
    for_each_case(1200200, 30, [](Random &random, uint64_t seed) {
        const Ground ground = random.chance(50) ? plane(2, 3) : wavy(random);
        const std::vector<Place> corners{ground.at(0.2, 0.2), ground.at(0.4, 0.8), ground.at(0.9, 0.3)};
        std::vector<Handle> edges;
        std::vector<const nurbs *> handles;
        for (size_t i = 0; i < 3; ++i) {
            const Handle curve = segment(corners[i], corners[(i + 1) % 3]);
            edges.push_back(
                made([&](nurbs **out) { return nurbs_compose(ground.surface.get(), curve.get(), out); }));
            handles.push_back(edges.back().get());
        }
        const int64_t size = 3, keys[] = {7, 0, random.chance(50) ? int64_t{0} : int64_t{9}};
        nurbs_face *out = nullptr;
        require_ok(nurbs_face_create(ground.surface.get(), 1, &size, nullptr, handles.data(), keys, 1e-5, 0,
                                     nullptr, &out));
        const Face face(out);
        EXPECT_EQ(deviation_of(out, 0, 0)[1], 1) << "seed " << seed;
        expect_survives(random, seed, ground, face);
    });
}

TEST(FaceBytes, gaps_that_were_kept_survive) {
    for_each_case(1200300, 20, [](Random &random, uint64_t seed) {
        const Ground ground = plane();
        const double gap = random.magnitude(1e-6, 0.1);
        const Handle way = segment(ground.at(0.25, 0.25), ground.at(0.75, 0.25)),
                     back = segment(ground.at(0.75, 0.75), ground.at(0.25, 0.25 + gap));
        const Face face = face_of(ground.surface.get(), {{way.get(), back.get()}}, 1e-9, NURBS_KEEP_GAPS);
        expect_survives(random, seed, ground, face);
    });
}

} // namespace
} // namespace face_bytes_test
