// Units of STEP files: those of a context hold for its representations.
#include "support/step_reading.h"

#include <numbers>

namespace step_units_test {

namespace {

using namespace step_test;
using nrb::Status;

std::string circle(StepBuilder &builder) {
    return builder.add("CIRCLE(''," + builder.placement("1.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",2.)");
}

nrb::model::Model read_in(const std::string &unit, double wanted) {
    StepBuilder builder;
    const std::string item = circle(builder);
    const std::string length =
        unit == "inch" ? builder.inch() : (unit == "metre" ? builder.metre() : builder.add(unit));
    builder.shape(item, builder.context(length, builder.radian()));
    return read(builder, {.unit = wanted});
}

TEST(StepUnits, lengths_have_the_unit_of_the_file) {
    EXPECT_EQ(read_in("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))", 0).metres_per_unit, 0.001);
    EXPECT_EQ(read_in("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.))", 0).metres_per_unit, 0.01);
    EXPECT_EQ(read_in("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.METRE.))", 0).metres_per_unit, 1000);
    EXPECT_EQ(read_in("SI_UNIT(*,.MICRO.,.METRE.)", 0).metres_per_unit, 1e-6);
    EXPECT_EQ(read_in("metre", 0).metres_per_unit, 1);
    EXPECT_EQ(read_in("inch", 0).metres_per_unit, 0.0254);
    expect_near(point_of(*only_spline(read_in("inch", 0)), 0), {3, 0, 0}, 0);
}

TEST(StepUnits, a_wanted_unit_scales) {
    const nrb::model::Model document = read_in("inch", 0.001);
    EXPECT_EQ(document.metres_per_unit, 0.001);
    expect_near(point_of(*only_spline(document), 0), {3 * 25.4, 0, 0}, 3e-14);
}

TEST(StepUnits, an_unknown_unit_cannot_be_converted) {
    StepBuilder builder;
    circle(builder);
    EXPECT_EQ(read(builder).metres_per_unit, 0);
    const Failure failure = failure_of(builder.text(), {.unit = 0.001});
    EXPECT_EQ(failure.status, Status::options);
    EXPECT_EQ(failure.text, "unit = 0.001 cannot be reached: the unit of the file is not known");
}

TEST(StepUnits, each_context_has_its_own) {
    StepBuilder builder;
    const std::string first = circle(builder), second = circle(builder);
    const std::string arc = builder.add("TRIMMED_CURVE(''," + second +
                                        ",(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(90.)),.T.,.PARAMETER.)");
    builder.shape(first, builder.context(builder.millimetre(), builder.radian()));
    builder.shape(arc, builder.context(builder.inch(), builder.degree()));
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(document.metres_per_unit, 0.001);
    ASSERT_EQ(document.splines.size(), 2U);
    expect_near(point_of(*document.splines[0].spline, 0), {3, 0, 0}, 0);
    expect_near(point_of(*document.splines[1].spline, 0), {76.2, 0, 0}, 3e-14);
    expect_domain(*document.splines[1].spline, 0, 0, std::numbers::pi / 2);
}

// The unit of a context that states none, whichever comes first, is that of another one, and that is told.
TEST(StepUnits, unstated_ones_are_those_of_others) {
    StepBuilder builder;
    const std::string angle = builder.radian();
    builder.context(angle, angle); // nothing uses it
    const std::string bare = builder.context(builder.degree(), angle);
    builder.shape(circle(builder), bare);
    builder.shape(circle(builder), bare);
    builder.shape(circle(builder), builder.context(builder.inch(), angle));
    builder.shape(circle(builder), builder.context(builder.millimetre(), angle));
    for (const double wanted : {0.0, 0.001}) {
        const nrb::model::Model document = read(builder, {.unit = wanted});
        const double unit = wanted > 0 ? wanted : 0.0254;
        EXPECT_EQ(document.metres_per_unit, unit);
        EXPECT_EQ(only_note(document).text,
                  bare + ": states no unit of length; that of another context is taken");
        ASSERT_EQ(document.splines.size(), 4U);
        for (size_t i = 0; i < 4; ++i) {
            const double x = 3 * (i < 3 ? 0.0254 : 0.001) / unit;
            expect_near(point_of(*document.splines[i].spline, 0), {x, 0, 0}, 0x1p-50 * x);
        }
    }
}

TEST(StepUnits, faces_have_those_of_the_solid_that_they_are_in) {
    StepBuilder builder;
    const auto ball = [&](const std::string &unit) {
        const std::string at = builder.placement("1.,0.,0.", "0.,0.,1.", "1.,0.,0.");
        const std::string face = builder.face(builder.add("SPHERICAL_SURFACE(''," + at + ",1.)"), {});
        const std::string shell = builder.add("CLOSED_SHELL('',(" + face + "))");
        const std::string solid = builder.add("MANIFOLD_SOLID_BREP(''," + shell + ")");
        builder.shape(solid, builder.context(unit, builder.radian()));
    };
    ball(builder.metre());
    ball(builder.inch());
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    expect_near(point_of(*document.splines[0].spline, 0, 0), {2, 0, 0}, 1e-15);
    expect_near(point_of(*document.splines[1].spline, 0, 0), {0.0508, 0, 0}, 1e-17);
}

TEST(StepUnits, a_broken_unit_is_noted) {
    StepBuilder builder;
    const std::string item = circle(builder),
                      unit = builder.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MYRIA.,.METRE.))");
    builder.shape(item, builder.context(unit, builder.radian()));
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(only_note(document).text, unit + " SI_UNIT: prefix: found .MYRIA., expected one of SI");
    EXPECT_EQ(document.splines.size(), 1U);
    EXPECT_EQ(document.metres_per_unit, 0);
}

TEST(StepUnits, units_that_name_each_other_are_noted) {
    StepBuilder builder;
    const std::string item = circle(builder);
    const std::string measure = builder.next();
    builder.add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.),#" +
                std::to_string(std::stoi(measure.substr(1)) + 1) + ")");
    const std::string unit =
        builder.add("(CONVERSION_BASED_UNIT('x'," + measure + ")LENGTH_UNIT()NAMED_UNIT(*))");
    builder.shape(item, builder.context(unit, builder.radian()));
    const nrb::model::Note note = only_note(builder);
    EXPECT_EQ(note.reason, Status::syntax);
    EXPECT_EQ(note.text, unit + ": names itself by way of " + unit);
}

} // namespace

} // namespace step_units_test
