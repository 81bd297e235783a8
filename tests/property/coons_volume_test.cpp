// Volumes blended from six faces: the defining formula, faces and edges against exact values.
#include "property/coons_cases.h"

namespace coons_volume_test {

using namespace support;
using reference::Point;
using reference::Rational;

namespace {

nurbs_status blend(const std::vector<SplineData> &faces, double tolerance, Handle &out) {
    const std::vector<Handle> handles = handles_of(faces);
    nurbs *made = nullptr;
    const nurbs_status status = nurbs_volume_coons(pointers(handles).data(), tolerance, &made);
    out.reset(made);
    return status;
}

SplineData volume_of(const std::vector<SplineData> &faces, double tolerance = 0) {
    Handle made;
    require_ok(blend(faces, tolerance, made));
    return read_back(made.get());
}

std::vector<SplineData> faces_of(const SplineData &volume) {
    const Handle g = create(volume);
    nurbs_list *list = nullptr;
    require_ok(nurbs_boundaries(g.get(), &list));
    std::vector<SplineData> faces;
    for (int64_t i = 0; i < 6; ++i) {
        nurbs *face = nullptr;
        require_ok(nurbs_list_get(list, i, &face));
        faces.push_back(read_back(Handle(face).get()));
    }
    nurbs_list_destroy(list);
    return faces;
}

// A volume over [0, 8]^3, its weights products of one factor for each axis, of which those at the ends are 1
// if they are even.
SplineData random_volume(Random &random, int max_degree, bool rational, KnotForm form,
                         bool even_ends = true) {
    SplineData volume;
    volume.dim = 3;
    std::vector<double> weights{1};
    int64_t total = 1;
    for (int k = 0; k < 3; ++k) {
        const SplineData curve = random_boundary(random, random.whole(1, max_degree), form, Weights::none);
        volume.degrees.push_back(curve.degrees[0]);
        volume.counts.push_back(curve.counts[0]);
        volume.knots.push_back(curve.knots[0]);
        total *= curve.counts[0];
        const bool constant = random.chance(40);
        std::vector<double> next;
        for (const double weight : weights) {
            Random same(static_cast<uint64_t>(k) + 1);
            for (int64_t i = 0; i < curve.counts[0]; ++i) { // of few bits, so that products are exact
                const bool end = even_ends && (i == 0 || i + 1 == curve.counts[0]);
                next.push_back(weight * (constant || end ? 1 : same.whole(8, 40) / 16.0));
            }
        }
        weights = next;
    }
    for (int64_t i = 0; i < 3 * total; ++i) {
        volume.points.push_back(random.between(-1, 1));
    }
    if (rational) {
        volume.weights = weights;
    }
    return volume;
}

void add(Point &sum, const Rational &factor, const Point &x) {
    for (size_t c = 0; c < x.size(); ++c) {
        sum[c] += factor * x[c];
    }
}

// The value of a face where the axes of the volume that it runs over have these parameters.
Point on_face(const std::vector<SplineData> &faces, size_t face, const std::vector<double> &params) {
    std::vector<double> own;
    for (size_t k = 0; k < 3; ++k) {
        if (k != face / 2) {
            own.push_back(params[k]);
        }
    }
    return reference::exact_value(faces[face], own);
}

// The sum over the faces, less that over the edges, plus that over the corners, of faces that agree: for
// every choice of axes that stand at an end, of the first of which the face is taken.
Point defined_volume(const std::vector<SplineData> &faces, const std::vector<double> &params) {
    Point sum(3);
    for (int chosen = 1; chosen < 27; ++chosen) { // of every axis: inside, at the start, at the end
        const std::array<int, 3> place{chosen % 3, chosen / 3 % 3, chosen / 9};
        Rational factor = -1;
        std::vector<double> at = params;
        size_t face = 6;
        for (size_t k = 0; k < 3; ++k) {
            const Rational t = reference::exact(params[k]) / 8;
            if (place[k] != 0) {
                factor *= place[k] == 1 ? Rational(t - 1) : Rational(-t);
                at[k] = place[k] == 1 ? 0 : 8;
                face = face == 6 ? 2 * k + (place[k] == 1 ? 0 : 1) : face;
            }
        }
        add(sum, factor, on_face(faces, face, at));
    }
    return sum;
}

std::vector<double> random_place(Random &random) {
    return {random.whole(0, 64) / 8.0, random.whole(0, 64) / 8.0, random.whole(0, 64) / 8.0};
}

void expect_defined(const SplineData &volume, const std::vector<SplineData> &faces, Random &random,
                    double allowed, const std::string &place) {
    for (int i = 0; i < 3; ++i) {
        const std::vector<double> at = random_place(random);
        ASSERT_LE(difference(reference::exact_value(volume, at), defined_volume(faces, at)), allowed)
            << place;
    }
}

// Of the faces against those of the volume.
double face_error(const SplineData &volume, const std::vector<SplineData> &faces, Random &random) {
    double largest = 0;
    for (size_t face = 0; face < 6; ++face) {
        std::vector<double> at = random_place(random);
        at[face / 2] = face % 2 == 0 ? 0 : 8;
        largest = std::max(largest, difference(reference::exact_value(volume, at), on_face(faces, face, at)));
    }
    return largest;
}

// However the weights of the faces are taken apart.
TEST(CoonsVolume, faces_of_a_volume_meet_at_tolerance0) {
    for_each_case(46900, 40, [&](Random &random, uint64_t seed) {
        SplineData volume = random_volume(random, 3, true, KnotForm::clamped, false);
        for (double &weight : volume.weights) {
            weight *= 0.1; // no more of few bits
        }
        if (seed % 2 == 0) { // nor products any more
            volume.weights[volume.weights.size() / 2] *= 1.5;
        }
        if (volume.weights.size() <= 64) {
            Handle made;
            ASSERT_EQ(blend(faces_of(volume), 0, made), NURBS_OK) << last_error() << " seed " << seed;
        }
    });
    const SplineData block = {{1, 1, 1},
                              {2, 2, 2},
                              {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}},
                              3,
                              {.1,  .2, .3, .1,  .2, 1.3, .1,  1.2, .3, .1,  1.2, 1.3,
                               1.1, .2, .3, 1.1, .2, 1.3, 1.1, 1.2, .3, 1.1, 1.2, 1.3},
                              {3, 1, 3, 1, 3, 1, 3, 1},
                              0};
    Handle made;
    ASSERT_EQ(blend(faces_of(block), 0, made), NURBS_OK) << last_error();
}

} // namespace

TEST(CoonsVolume, agrees_with_its_definition) {
    for_each_case(430000, 40, [&](Random &random, uint64_t seed) {
        const bool rational = random.chance(50);
        const SplineData whole = random_volume(random, rational ? 2 : 4, rational, KnotForm::clamped);
        const std::vector<SplineData> faces = faces_of(whole);
        const SplineData volume = volume_of(faces);
        const double unit = static_cast<double>(eps) * extent(whole);
        ASSERT_LE(face_error(volume, faces, random), 4 * unit) << where(seed, whole);
        expect_defined(volume, faces, random, 24 * unit, where(seed, whole));
    });
}

// Where faces are of one form, their control points are those of the volume to the bit.
TEST(CoonsVolume, keeps_the_control_points_of_its_faces) {
    for_each_case(437000, 20, [&](Random &random, uint64_t seed) {
        const SplineData whole = random_volume(random, 3, false, KnotForm::clamped);
        const std::vector<SplineData> faces = faces_of(whole), found = faces_of(volume_of(faces));
        for (size_t face = 0; face < faces.size(); ++face) {
            ASSERT_EQ(found[face].points, faces[face].points) << "face " << face << where(seed, whole);
        }
    });
}

// Where the weights of faces differ by more than a factor denominators multiply, and edges agree to rounding.
TEST(CoonsVolume, multiplies_denominators_that_differ) {
    for_each_case(435000, 10, [&](Random &random, uint64_t seed) {
        const SplineData whole = random_volume(random, 1, true, KnotForm::clamped, false);
        const std::vector<SplineData> faces = faces_of(whole);
        const SplineData volume = volume_of(faces, 1e-12);
        const double unit = static_cast<double>(eps) * extent(whole);
        ASSERT_LE(face_error(volume, faces, random), 16 * unit) << where(seed, whole);
        expect_defined(volume, faces, random, 48 * unit, where(seed, whole));
    });
}

// Weights that are no products: every face and edge has a denominator of its own.
TEST(CoonsVolume, blends_faces_of_any_weights) {
    for_each_case(436000, 4, [&](Random &random, uint64_t seed) {
        SplineData whole = random_volume(random, 1, true, KnotForm::clamped);
        for (double &weight : whole.weights) {
            weight = random.between(0.5, 2);
        }
        const std::vector<SplineData> faces = faces_of(whole);
        const SplineData volume = volume_of(faces);
        const double unit = static_cast<double>(eps) * extent(whole);
        ASSERT_LE(face_error(volume, faces, random), 256 * unit) << where(seed, whole);
        expect_defined(volume, faces, random, 256 * unit, where(seed, whole));
    });
}

// What the blend makes has faces of which it makes the same.
TEST(CoonsVolume, reproduces_what_it_blended) {
    for_each_case(431000, 15, [&](Random &random, uint64_t seed) {
        const SplineData whole = random_volume(random, 3, false, KnotForm::clamped);
        const SplineData volume = volume_of(faces_of(whole)), again = volume_of(faces_of(volume));
        ASSERT_EQ(volume.knots, again.knots);
        for (size_t i = 0; i < volume.points.size(); ++i) {
            ASSERT_NEAR(volume.points[i], again.points[i], 24 * static_cast<double>(eps) * extent(volume))
                << where(seed, whole);
        }
    });
}

TEST(CoonsVolume, reproduces_trilinear_volumes) {
    for_each_case(432000, 10, [&](Random &random, uint64_t seed) {
        SplineData cube;
        cube.dim = 3;
        cube.degrees = {1, 1, 1};
        cube.counts = {2, 2, 2};
        cube.knots.assign(3, {0, 0, 8, 8});
        for (int i = 0; i < 24; ++i) {
            cube.points.push_back(random.between(-1, 1));
        }
        const SplineData volume = volume_of(faces_of(cube));
        ASSERT_EQ(volume.knots, cube.knots);
        ASSERT_EQ(volume.points, cube.points) << where(seed, cube);
    });
}

TEST(CoonsVolume, takes_unclamped_and_mapped_faces) {
    for_each_case(433000, 20, [&](Random &random, uint64_t seed) {
        const SplineData whole = random_volume(random, 3, false, KnotForm::unclamped);
        const std::vector<SplineData> faces = faces_of(whole);
        std::vector<SplineData> moved = faces;
        for (const size_t i : {1U, 3U, 4U, 5U}) {
            for (double &t : moved[i].knots[0]) {
                t = t / 4 + 2;
            }
        }
        const SplineData volume = volume_of(moved, 1e-12);
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(volume.lower(k), 0.0);
            ASSERT_EQ(volume.upper(k), 8.0);
        }
        expect_defined(volume, faces, random, 64 * static_cast<double>(eps) * extent(whole),
                       where(seed, whole));
    });
}

// Edges that differ are met half way; inside the faces three corrections add up, each less than the gap.
TEST(CoonsVolume, gaps_are_found_and_split) {
    for_each_case(434000, 30, [&](Random &random, uint64_t seed) {
        const SplineData whole = random_volume(random, 2, random.chance(30), KnotForm::clamped);
        std::vector<SplineData> faces = faces_of(whole);
        const double size = 1e-3;
        for (double &x : faces[3].points) {
            x += size;
        }
        const double gap = size * std::sqrt(3);
        Handle none;
        ASSERT_EQ(blend(faces, gap * 0.999, none), NURBS_ERROR_GAP);
        ASSERT_NE(last_error().find("faces[3]"), std::string::npos) << last_error();
        const SplineData volume = volume_of(faces, gap * 1.001);
        ASSERT_LE(face_error(volume, faces, random), 3 * gap) << where(seed, whole);
        ASSERT_GE(face_error(volume, faces, random), gap / 8) << where(seed, whole);
    });
}

} // namespace coons_volume_test
