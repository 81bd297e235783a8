// Names of splines: property, label, or type and line.
#include "io/iges/names.h"
#include "support/iges_reading.h"

namespace names_test {

namespace {

using namespace iges_test;

std::string only_name(const IgesBuilder &builder) {
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(document.splines.size(), 1U);
    return document.splines.empty() ? "" : document.splines.front().name;
}

// A line curve followed by its pointers: no associativities, and the given properties.
std::string with_pointers(const std::string &pointers) {
    return std::string(line_126) + "," + pointers;
}

TEST(IgesNames, type_and_line_where_nothing_is_given) {
    IgesBuilder builder;
    builder.add(116, "0,0,0");
    builder.add(126, line_126);
    EXPECT_EQ(only_name(builder), "126#3");
}

TEST(IgesNames, label_and_subscript) {
    IgesBuilder builder;
    builder.add(126, line_126, {.label = "KEEL"});
    EXPECT_EQ(only_name(builder), "KEEL");
    IgesBuilder numbered;
    numbered.add(126, line_126, {.label = "KEEL", .subscript = 12});
    EXPECT_EQ(only_name(numbered), "KEEL(12)");
    IgesBuilder only_number;
    only_number.add(126, line_126, {.subscript = 12});
    EXPECT_EQ(only_name(only_number), "126#1");
}

TEST(IgesNames, the_property_comes_first) {
    IgesBuilder builder;
    builder.add(406, "1,14Hbow, starboard", {.form = 15});
    builder.add(126, with_pointers("0,1,1"), {.label = "KEEL"});
    EXPECT_EQ(only_name(builder), "bow, starboard");
}

TEST(IgesNames, behind_associativities_and_other_properties) {
    IgesBuilder builder;
    builder.add(402, "0", {.form = 1});
    builder.add(406, "2,1,7Hlayer 1", {.form = 3});
    builder.add(406, "1,5Hstern", {.form = 15});
    builder.add(126, with_pointers("2,1,1,3,3,99,5"));
    EXPECT_EQ(only_name(builder), "stern");
}

TEST(IgesNames, other_properties_are_no_names) {
    IgesBuilder builder;
    builder.add(406, "1,5Hlayer", {.form = 3});
    builder.add(402, "1,5Hgroup", {.form = 15});
    builder.add(126, with_pointers("0,2,1,3"), {.label = "KEEL"});
    EXPECT_EQ(only_name(builder), "KEEL");
}

TEST(IgesNames, one_property_for_many) {
    IgesBuilder builder;
    builder.add(126, with_pointers("0,1,5"));
    builder.add(126, with_pointers("0,1,5"));
    builder.add(406, "1,4Hpair", {.form = 15});
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    EXPECT_EQ(document.splines[0].name, "pair");
    EXPECT_EQ(document.splines[1].name, "pair");
}

TEST(IgesNames, a_surface_too) {
    IgesBuilder builder;
    builder.add(406, "1,5Hpatch", {.form = 15});
    builder.add(128, "1,1,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1,0,0,0,1,0,0,0,1,0,1,1,0,0,1,0,1,0,1,1");
    EXPECT_EQ(only_name(builder), "patch");
}

TEST(IgesNames, unreadable_names_fall_back) {
    const struct {
        const char *property;
        const char *pointers;
    } cases[] = {
        {"1,99Hshort", "0,1,1"},    {"1,17", "0,1,1"},          {"1,0H", "0,1,1"},
        {"1,4Hname", "0,1,3"},      {"1,4Hname", "0,1,x"},      {"1,4Hname", "x,1,1"},
        {"1,4Hname", "0,0,1"},      {"1,4Hname", "0,1,-1"},     {"1,4Hname", "-1,-1"},
        {"1,4Hname", "999999,1,1"}, {"1,4Hname", "0,99999999"},
    };
    for (const auto &[property, pointers] : cases) {
        IgesBuilder builder;
        builder.add(406, property, {.form = 15});
        builder.add(126, with_pointers(pointers), {.label = "KEEL"});
        EXPECT_EQ(only_name(builder), "KEEL") << property << " / " << pointers;
    }
}

TEST(IgesNames, control_characters_are_replaced) {
    IgesBuilder builder;
    builder.add(406, std::string("1,5Hab\0cd", 9), {.form = 15});
    builder.add(126, with_pointers("0,1,1"));
    EXPECT_EQ(only_name(builder), "ab?cd");
}

TEST(IgesNames, of_types) {
    EXPECT_STREQ(nrb::io::iges::type_name(126), "rational B-spline curve");
    EXPECT_STREQ(nrb::io::iges::type_name(0), "null");
    EXPECT_STREQ(nrb::io::iges::type_name(514), "shell");
    EXPECT_STREQ(nrb::io::iges::type_name(127), "entity");
    EXPECT_STREQ(nrb::io::iges::type_name(99999), "entity");
}

} // namespace

} // namespace names_test
