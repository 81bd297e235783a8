// The global section: delimiters, unit and model scale.
#include "support/iges_reading.h"

namespace global_test {

namespace {

using namespace iges_test;

double metres(IgesBuilder builder) {
    return read(builder).metres_per_unit;
}

double metres(const std::string &flag, const std::string &name, const std::string &scale = "1.0") {
    return metres(IgesBuilder().global(14, flag).global(15, name).global(13, scale));
}

TEST(IgesGlobal, units_by_flag) {
    const double expected[] = {0.0254, 0.001, 0, 0.3048, 1609.344, 1, 1000, 2.54e-5, 1e-6, 0.01, 2.54e-8};
    for (int flag = 1; flag <= 11; ++flag) {
        EXPECT_EQ(metres(std::to_string(flag), ""), expected[flag - 1]) << "flag " << flag;
    }
}

TEST(IgesGlobal, units_by_name) {
    EXPECT_EQ(metres("3", "2HMM"), 0.001);
    EXPECT_EQ(metres("3", "4HINCH"), 0.0254);
    EXPECT_EQ(metres("3", "2HIN"), 0.0254);
    EXPECT_EQ(metres("3", "3H cm"), 0.01);
    EXPECT_EQ(metres("", "1HM"), 1.0);
    EXPECT_EQ(metres("0", "2HKM"), 1000.0);
}

TEST(IgesGlobal, the_flag_rules_over_the_name) {
    EXPECT_EQ(metres("2", "2HIN"), 0.001);
}

TEST(IgesGlobal, inches_where_nothing_is_said) {
    EXPECT_EQ(metres("", ""), 0.0254);
    std::vector<std::string> lines = IgesBuilder().lines();
    lines = {lines.front(), IgesBuilder::section_line(",,;", 'G', 1),
             IgesBuilder::section_line("S0000001G0000001D0000000P0000000", 'T', 1)};
    EXPECT_EQ(read(IgesBuilder::join(lines)).metres_per_unit, 0.0254);
}

TEST(IgesGlobal, unknown_units_stay_unknown_and_cannot_be_converted) {
    for (const auto &[flag, name] : std::vector<std::pair<std::string, std::string>>{
             {"3", ""}, {"3", "5HCUBIT"}, {"12", "2HMM"}, {"-1", "2HMM"}, {"99999999999", ""}}) {
        IgesBuilder builder;
        builder.global(14, flag).global(15, name).add(126, line_126);
        const nrb::model::Model document = read(builder);
        EXPECT_EQ(document.metres_per_unit, 0.0) << flag << name;
        EXPECT_EQ(points_of(*only_spline(document)), (std::vector<double>{1, 2, 3, 4, 6, 8}));
        EXPECT_THROW(read(builder, {.unit = 0.001}), nrb::Error) << flag << name;
    }
}

// 0.125: one unit in the file stands for eight units of the world.
TEST(IgesGlobal, model_scale_is_model_to_world) {
    EXPECT_EQ(metres("2", "2HMM", "0.125"), 0.008);
    EXPECT_EQ(metres("2", "2HMM", ""), 0.001);
    EXPECT_EQ(metres("6", "1HM", "2.D0"), 0.5);
}

TEST(IgesGlobal, scales_to_the_wanted_unit) {
    IgesBuilder builder;
    builder.global(14, "6").global(15, "1HM").global(13, "0.5").add(126, line_126);
    const nrb::model::Model document = read(builder, {.unit = 0.001});
    EXPECT_EQ(document.metres_per_unit, 0.001);
    EXPECT_EQ(points_of(*only_spline(document)), (std::vector<double>{2000, 4000, 6000, 8000, 12000, 16000}));
}

TEST(IgesGlobal, keeps_the_unit_of_the_file) {
    IgesBuilder builder;
    builder.global(14, "1").global(15, "2HIN").add(126, line_126);
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(document.metres_per_unit, 0.0254);
    EXPECT_EQ(points_of(*only_spline(document)), (std::vector<double>{1, 2, 3, 4, 6, 8}));
}

TEST(IgesGlobal, other_delimiters) {
    IgesBuilder builder;
    builder.delimiters('/', '!').add(126, line_126);
    EXPECT_EQ(points_of(*only_spline(read(builder))), (std::vector<double>{1, 2, 3, 4, 6, 8}));
}

// "1H,,1H;,": the first two parameters name the delimiters they are read by.
TEST(IgesGlobal, default_delimiters_spelled_out) {
    IgesBuilder builder;
    builder.delimiters(',', ';').add(126, line_126);
    EXPECT_NE(only_spline(read(builder)), nullptr);
    EXPECT_NE(builder.text().find("1H,,1H;,4Htest"), std::string::npos);
}

TEST(IgesGlobal, only_one_delimiter_named) {
    IgesBuilder builder;
    builder.delimiters('/', ';').global(2, "").add(126, line_126);
    EXPECT_NE(only_spline(read(builder)), nullptr);
}

TEST(IgesGlobal, strings_may_span_lines) {
    IgesBuilder builder;
    builder.global(3, "150H" + std::string(150, ',')).add(126, line_126);
    EXPECT_NE(only_spline(read(builder)), nullptr);
}

nrb::Status status_with(size_t index, const std::string &text) {
    return failure_of(IgesBuilder().global(index, text).text()).status;
}

TEST(IgesGlobal, broken_global_sections) {
    EXPECT_EQ(status_with(1, "1H3"), nrb::Status::syntax); // a digit as delimiter
    EXPECT_EQ(status_with(1, "1H."), nrb::Status::syntax);
    EXPECT_EQ(status_with(2, "1H,"), nrb::Status::syntax); // both the same
    EXPECT_EQ(status_with(1, "abc"), nrb::Status::syntax);
    EXPECT_EQ(status_with(5, "99999H"), nrb::Status::syntax); // a string longer than the section
    EXPECT_EQ(status_with(13, "0.0"), nrb::Status::syntax);
    EXPECT_EQ(status_with(13, "-1.0"), nrb::Status::syntax);
    EXPECT_EQ(status_with(13, "1.D-320"), nrb::Status::syntax);
    EXPECT_EQ(status_with(13, "one"), nrb::Status::syntax);
    EXPECT_EQ(status_with(14, "2HMM"), nrb::Status::syntax);
    EXPECT_EQ(status_with(15, "MM"), nrb::Status::syntax);
    EXPECT_EQ(status_with(13, "1.0"), nrb::Status::ok);
    EXPECT_NE(failure_of(IgesBuilder().global(5, "99999H").text()).text.find("parameter 5"),
              std::string::npos);
    const Failure zero = failure_of(IgesBuilder().global(13, "0.0").global(14, "3").global(15, "").text());
    EXPECT_NE(zero.text.find("scale 0 where a positive number"), std::string::npos); // whatever the unit
}

TEST(IgesGlobal, settings_that_cannot_be) {
    const std::string text = IgesBuilder().text();
    EXPECT_EQ(failure_of(text, {.unit = -1}).status, nrb::Status::options);
    EXPECT_EQ(failure_of(text, {.unit = std::numeric_limits<double>::quiet_NaN()}).status,
              nrb::Status::options);
    EXPECT_EQ(failure_of(text, {.unit = std::numeric_limits<double>::infinity()}).status,
              nrb::Status::options);
    EXPECT_EQ(failure_of(text, {.unit = 1e-320}).status, nrb::Status::options);
}

TEST(IgesGlobal, too_large) {
    const std::string text = IgesBuilder().text();
    const auto size = static_cast<int64_t>(text.size());
    EXPECT_EQ(failure_of(text, {.max_bytes = size}).status, nrb::Status::ok);
    EXPECT_EQ(failure_of(text, {.max_bytes = size - 1}).status, nrb::Status::too_large);
}

} // namespace

} // namespace global_test
