// Solids with voids: which shells are whose, and on which side the material is.
#include "face/deviation.h"
#include "face/integrals/face_moments.h"
#include "io/formats.h"
#include "io/writers.h"
#include "support/iges_solids.h"
#include "support/same_model.h"
#include "support/step_solids.h"

#include <set>

namespace written_voids_test {
namespace {

using namespace nrb;

// Out of the material, of a plane face.
Vector3 normal_of(const model::ModelFace &face) {
    const Spline &surface = *face.face->surface();
    const Interval u = surface.axis(0).domain(), v = surface.axis(1).domain();
    const auto at = [&](double s, double t) {
        const std::vector<double> x = face::point_at(surface, {s, t});
        return Vector3{x[0], x[1], x[2]};
    };
    const Vector3 origin = at(u.lower, v.lower);
    const Vector3 way = cross(at(u.upper, v.lower) - origin, at(u.lower, v.upper) - origin);
    return (face.against ? -1 : 1) / length(way) * way;
}

// Of plane faces, by the theorem of Gauss.
double volume_of(const model::Model &model) {
    double volume = 0;
    for (const model::ModelFace &face : model.faces) {
        const measure::Moments moments = face::moments(*face.face, measure::MomentOrder::centroid, 1e-12);
        const Vector3 at{moments.centroid[0], moments.centroid[1], moments.centroid[2]};
        volume += moments.content * dot(at, normal_of(face)) / 3;
    }
    return volume;
}

constexpr double hollow = 64 - 1 - 0.125;

void expect_hollow(const model::Model &model) {
    ASSERT_EQ(model.faces.size(), 18U);
    for (size_t i = 0; i < 18; ++i) {
        EXPECT_EQ(model.faces[i].solid, 0) << i;
        EXPECT_EQ(model.faces[i].in_void, i >= 6) << i;
    }
    EXPECT_NEAR(volume_of(model), hollow, 64 * 1e-11);
}

int64_t count(const std::string &text, const std::string &what) {
    int64_t found = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

TEST(Voids, BelongToTheirSolidAndAreTurnedOutOfTheMaterial) {
    expect_hollow(io::read_model(step_test::step_hollow_cube(), {}));
}

class WrittenVoids : public testing::TestWithParam<int> {};

TEST_P(WrittenVoids, ComeBack) {
    // Once through the format before, for lines have the parameters of that.
    const model::Model hollow_cube = io::read_model(step_test::step_hollow_cube(), {}),
                       model = io::read_model(io::write(hollow_cube, GetParam(), {}), {});
    expect_hollow(model);
    const std::string text = io::write(model, GetParam(), {});
    const model::Model again = io::read_model(text, {});
    EXPECT_TRUE(again.notes.empty());
    expect_hollow(again);
    EXPECT_EQ(step_test::ModelDifferences(model, again).found(), std::vector<std::string>());
    EXPECT_TRUE(io::write(again, GetParam(), {}) == text);
    if (GetParam() == 1) {
        EXPECT_EQ(count(text, "=BREP_WITH_VOIDS("), 1);
        EXPECT_EQ(count(text, "=ORIENTED_CLOSED_SHELL("), 2);
        EXPECT_EQ(count(text, "=MANIFOLD_SOLID_BREP("), 0);
    } else {
        EXPECT_EQ(count(text, "\n     186 "), 2); // two lines of one entry
    }
}

// A void whose solid is not closed, or not there, is a solid of its own, as any closed shell.
TEST_P(WrittenVoids, WithoutTheirSolidAreSolids) {
    model::Model model = io::read_model(step_test::step_hollow_cube(), {});
    for (size_t i = 6; i < 12; ++i) {
        model.faces[i].solid = 1;
    }
    const model::Model again = io::read_model(io::write(model, GetParam(), {}), {});
    ASSERT_EQ(again.faces.size(), 18U);
    std::set<int64_t> solids;
    for (size_t i = 0; i < 18; ++i) {
        solids.insert(again.faces[i].solid);
        EXPECT_EQ(again.faces[i].in_void, i >= 12);
    }
    EXPECT_EQ(solids.size(), 2U);
    EXPECT_NEAR(volume_of(again), volume_of(model), 64 * 1e-11);
}

TEST(Voids, SolidsOfIgesHaveNumbers) {
    iges_test::CubeBuilder builder;
    (void)builder.cube();
    const model::Model cube = iges_test::read_model(builder);
    ASSERT_EQ(cube.faces.size(), 6U);
    for (const model::ModelFace &face : cube.faces) {
        EXPECT_EQ(face.solid, 0);
        EXPECT_FALSE(face.in_void);
    }
    EXPECT_NEAR(volume_of(cube), 1, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(All, WrittenVoids, testing::Values(1, 2));

} // namespace
} // namespace written_voids_test
