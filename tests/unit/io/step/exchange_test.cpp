// The sections of an exchange structure, and the index of its instances.
#include "base/watch.h"
#include "io/step/structure/exchange.h"
#include "support/step_reading.h"

namespace step_exchange_test {

namespace {

using namespace step_test;
using nrb::Status;
using nrb::io::step::Exchange;
using nrb::io::step::Kind;

std::string keyword_of(const Exchange &file, int64_t number) {
    return std::string(file.instances.keyword(file.instances[file.instances.find(number)]));
}

TEST(StepExchange, instances_are_found_by_number_in_any_order) {
    const std::string text =
        StepBuilder::around("#30=CIRCLE('',#7,1.);\n#7 = PLANE('',#1) ;#1000000007=FOO();");
    const Exchange file = nrb::io::step::read_exchange(text);
    ASSERT_EQ(file.instances.size(), 3);
    EXPECT_EQ(keyword_of(file, 30), "CIRCLE");
    EXPECT_EQ(keyword_of(file, 7), "PLANE");
    EXPECT_EQ(keyword_of(file, 1000000007), "FOO");
    EXPECT_EQ(file.instances[0].kind(), Kind::plane);
    EXPECT_EQ(file.instances[1].kind(), Kind::circle);
    EXPECT_EQ(file.instances[2].kind(), Kind::other);
    for (const int64_t missing : {int64_t{1}, int64_t{8}, int64_t{31}, int64_t{2000000000}}) {
        EXPECT_EQ(file.instances.find(missing), -1);
    }
}

TEST(StepExchange, schemas_are_named_without_identifiers) {
    const std::string schema = "CONFIG_CONTROL_DESIGN','AP242_MIM_LF { 1 0 10303 442 }";
    const std::string text = StepBuilder::around("", schema);
    EXPECT_EQ(nrb::io::step::read_exchange(text).schemas,
              (std::vector<std::string>{"CONFIG_CONTROL_DESIGN", "AP242_MIM_LF"}));
}

TEST(StepExchange, the_greatest_kind_of_a_complex_instance_counts) {
    const std::string text = StepBuilder::around(
        "#1=(BOUNDED_CURVE()B_SPLINE_CURVE(1,(#2),.U.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((),(),.U.)CURVE()"
        "RATIONAL_B_SPLINE_CURVE(()));#2=(A((;B'))'));");
    EXPECT_EQ(failure_of(text).status, Status::syntax); // #2 has a semicolon in its list
    const std::string good = StepBuilder::around(
        "#1=(BOUNDED_CURVE()B_SPLINE_CURVE(1,(#2),.U.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((),(),.U.)CURVE()"
        "RATIONAL_B_SPLINE_CURVE(()));#2=(A(('));'))B());");
    const Exchange file = nrb::io::step::read_exchange(good);
    EXPECT_EQ(file.instances[0].kind(), Kind::b_spline_curve_with_knots);
    EXPECT_EQ(keyword_of(file, 1), "B_SPLINE_CURVE_WITH_KNOTS");
    EXPECT_EQ(keyword_of(file, 2), "A");
}

TEST(StepExchange, several_data_sections_and_others_are_passed_through) {
    const std::string text =
        "ISO-10303-21;HEADER;ENDSEC;ANCHOR;<a>=#1;ENDSEC;REFERENCE;#9=<b#c>;ENDSEC;"
        "DATA('one',('S'));#1=A();ENDSEC;DATA;#2=B();ENDSEC;END-ISO-10303-21;SIGNATURE x";
    EXPECT_EQ(nrb::io::step::read_exchange(text).instances.size(), 2);
}

TEST(StepExchange, line_ends_comments_and_a_mark_before_the_text_do_not_matter) {
    StepBuilder builder;
    builder.add("CIRCLE(''," + builder.some_placement() + ",2.)");
    const std::string text = builder.text();
    const nrb::SplinePtr plain = only_spline(read(text));
    std::string changed = "\xef\xbb\xbf\r\n";
    for (const char c : text) {
        changed += c == '\n' ? std::string("\r\n/* comment; #1=' */\r\n") : std::string(1, c);
    }
    const nrb::SplinePtr other = only_spline(read(changed));
    EXPECT_TRUE(std::ranges::equal(plain->points(), other->points()));
}

TEST(StepExchange, a_number_used_twice_is_noted_and_the_first_counts) {
    const nrb::model::Model document =
        read(StepBuilder::around("#2=POLYLINE('',(#1,#3));#1=CARTESIAN_POINT('',(0.,0.,0.));"
                                 "#3=CARTESIAN_POINT('',(1.,0.,0.));#1=CARTESIAN_POINT('',(5.,0.,0.));"));
    ASSERT_EQ(document.splines.size(), 1U);
    expect_near(point_of(*document.splines[0].spline, 0), {0, 0, 0}, 0);
    EXPECT_EQ(only_note(document).line, 1);
    EXPECT_EQ(only_note(document).text, "#1: stands for several instances, of which the first counts");
}

TEST(StepExchange, a_broken_structure_names_its_line) {
    const auto expect = [](const std::string &text, Status status, const std::string &message) {
        const Failure failure = failure_of(text);
        EXPECT_EQ(failure.status, status) << text;
        EXPECT_EQ(failure.text, message);
    };
    expect("ISO-10303-21;\n", Status::truncated, "line 2: the file ends before END-ISO-10303-21");
    expect("ISO-10303-21\nHEADER;", Status::syntax, "line 2: found HEADER, expected ';' after ISO-10303-21");
    expect("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=A();\n", Status::truncated,
           "line 6: the file ends before END-ISO-10303-21");
    expect(StepBuilder::around("#0=A();"), Status::syntax,
           "line 8: found #0, expected # and a number from 1 to 2^48 - 1");
    expect(StepBuilder::around("#1 A();"), Status::syntax,
           "line 8: found A, expected '=' after an instance name");
    expect(StepBuilder::around("#1=3;"), Status::syntax,
           "line 8: found 3, expected the keyword of an entity, or '('");
    expect(StepBuilder::around("A();"), Status::syntax,
           "line 8: found A, expected an instance name such as #1, or ENDSEC");
    expect(StepBuilder::around("#1=(A 3);"), Status::syntax,
           "line 8: found 3, expected '(' after the keyword of a part");
    expect(StepBuilder::around("#1=(A(3)"), Status::syntax,
           "line 8: found ;, expected '(' after the keyword of a part");
}

TEST(StepExchange, reading_can_be_ended_from_outside) {
    std::string data;
    for (int i = 1; i < 20000; ++i) {
        data += "#" + std::to_string(i) + "=LINE('',#1,#2);\n";
    }
    const std::string text = StepBuilder::around(data);
    const auto stop = [](double, void *) -> int32_t { return 1; };
    const nrb::Watch watch({0, stop, nullptr});
    EXPECT_THROW(read(text), nrb::CallEnded);
    for (const int64_t work : {1000, 100000}) { // in the index, and behind it
        const nrb::Watch limited({work, nullptr, nullptr});
        EXPECT_THROW(read(text), nrb::CallEnded);
    }
}

TEST(StepExchange, files_of_buildings_are_refused) {
    const Failure failure = failure_of(StepBuilder::around("", "IFC4"));
    EXPECT_EQ(failure.status, Status::format);
    EXPECT_EQ(failure.text, "FILE_SCHEMA names IFC4, which is not read; AP203, AP214 and AP242 are");
}

TEST(StepExchange, an_index_of_many_instances_is_smaller_than_the_file) {
    static_assert(sizeof(nrb::io::step::Instance) == 16);
}

} // namespace

} // namespace step_exchange_test
