// Replicas: curves and surfaces that stand where a transformation puts others.
#include "support/step_reading.h"

#include <cmath>

namespace step_replicas_test {

namespace {

using namespace step_test;
using nrb::SplinePtr;
using nrb::Status;

// x -> (10, 20, 30) + scale (-y, x, +- z).
std::string quarter_turn(StepBuilder &builder, const std::string &scale, bool mirrored = false) {
    const std::string origin = builder.point("10.,20.,30."), x = builder.direction("0.,1.,0."),
                      y = builder.direction(mirrored ? "1.,0.,0." : "-1.,0.,0."),
                      z = builder.direction("0.,0.,1.");
    return builder.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',''," + x + "," + y + "," + origin + "," +
                       scale + "," + z + ")");
}

TEST(StepReplicas, of_a_circle) {
    for (const std::string scale : {"$", "2."}) {
        StepBuilder builder;
        const std::string circle = builder.add("CIRCLE(''," + builder.some_placement() + ",2.)");
        builder.add("CURVE_REPLICA(''," + circle + "," + quarter_turn(builder, scale) + ")");
        const SplinePtr replica = only_spline(builder);
        const double s = scale == "$" ? 1 : 2;
        expect_domain(*replica, 0, 0, 2 * pi);
        for (int i = 0; i <= 8; ++i) { // of (1, 2 + 2 cos t, 3 + 2 sin t)
            const double t = pi * i / 4;
            expect_near(point_of(*replica, t),
                        {10 - s * (2 + 2 * std::cos(t)), 20 + s, 30 + s * (3 + 2 * std::sin(t))}, 2e-14);
        }
    }
}

// (x, y, z) -> (10 + y, 20 + x, 30 + z).
TEST(StepReplicas, may_be_mirrored) {
    StepBuilder builder;
    const std::string ball = builder.add("SPHERICAL_SURFACE(''," + builder.some_placement() + ",2.)");
    builder.add("SURFACE_REPLICA(''," + ball + "," + quarter_turn(builder, "1.", true) + ")");
    const SplinePtr replica = only_spline(builder);
    for (int i = 0; i <= 8; ++i) {
        for (int j = -2; j <= 2; ++j) {
            const double u = pi * i / 4, v = pi * j / 4;
            expect_near(point_of(*replica, u, v),
                        {12 + 2 * std::cos(v) * std::cos(u), 21 + 2 * std::sin(v),
                         33 + 2 * std::cos(v) * std::sin(u)},
                        2e-14);
        }
    }
}

// Parts of a plane that has been scaled are between its own parameters.
TEST(StepReplicas, keep_the_parameters) {
    StepBuilder builder;
    const std::string plane = builder.add("PLANE(''," + builder.some_placement() + ")");
    const std::string replica =
        builder.add("SURFACE_REPLICA(''," + plane + "," + quarter_turn(builder, "2.") + ")");
    builder.add("RECTANGULAR_TRIMMED_SURFACE(''," + replica + ",1.,2.,3.,5.,.T.,.T.)");
    const SplinePtr part = only_spline(builder);
    expect_near(point_of(*part, 1, 3), {10 - 2 * 3, 22, 30 + 2 * 6});
    expect_near(point_of(*part, 2, 5), {10 - 2 * 4, 22, 30 + 2 * 8});
}

// Axes that are missing or parallel are those that placements have then.
TEST(StepReplicas, stand_as_placements_do) {
    for (const std::string z : {"$", "0.,0.,-3.", "1.,0.,0.", "-2.,0.,0.", "0.95,0.2,0.1", "1.,1E-7,0."}) {
        for (const std::string x : {"$", "0.,0.,1.", "1.,0.,0.", "0.95,0.2,0.1", "-1.9,-0.4,-0.2"}) {
            StepBuilder builder;
            const std::string up = z == "$" ? z : builder.direction(z),
                              way = x == "$" ? x : builder.direction(x), origin = builder.point("1.,2.,3.");
            const std::string level = builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.");
            const std::string circle = builder.add("CIRCLE(''," + level + ",2.)");
            builder.add("CURVE_REPLICA(''," + circle + "," +
                        builder.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',''," + way + ",$," + origin +
                                    ",3.," + up + ")") +
                        ")");
            builder.add("CIRCLE(''," +
                        builder.add("AXIS2_PLACEMENT_3D(''," + origin + "," + up + "," + way + ")") + ",6.)");
            const nrb::model::Model found = read(builder);
            ASSERT_EQ(found.splines.size(), 2U) << z << " " << x;
            for (int i = 0; i <= 8; ++i) {
                const double t = pi * i / 4;
                expect_near(point_of(*found.splines[0].spline, t), point_of(*found.splines[1].spline, t),
                            1e-13);
            }
        }
    }
}

TEST(StepReplicas, that_cannot_be_read_are_noted) {
    StepBuilder other;
    const std::string circle = other.add("CIRCLE(''," + other.some_placement() + ",2.)");
    other.add("CURVE_REPLICA(''," + circle + "," + other.point("1.,2.,3.") + ")");
    EXPECT_EQ(only_note(other).reason, Status::syntax);
    StepBuilder none;
    none.add("SURFACE_REPLICA(''," + none.add("PLANE(''," + none.some_placement() + ")") + "," +
             quarter_turn(none, "0.") + ")");
    EXPECT_EQ(only_note(none).reason, Status::factor);
    StepBuilder cycle;
    const std::string turn = quarter_turn(cycle, "1.");
    cycle.add("CURVE_REPLICA(''," + cycle.next() + "," + turn + ")");
    EXPECT_TRUE(read(cycle).splines.empty());
}

} // namespace

} // namespace step_replicas_test
