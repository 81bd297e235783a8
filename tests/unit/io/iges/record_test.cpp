// Free-format records: delimiters, strings, blank parameters.
#include "io/iges/record.h"

#include "base/error.h"

#include <gtest/gtest.h>

namespace record_test {

namespace {

using nrb::io::iges::Delimiters;
using nrb::io::iges::Record;

nrb::Status status_of(const std::string &text) {
    try {
        const Record record(text, Delimiters{});
        return record.remaining() > 0 ? nrb::Status::ok : nrb::Status::internal;
    } catch (const nrb::Error &error) {
        return error.status();
    }
}

TEST(IgesRecord, reads_parameters_in_order) {
    Record record("126, 3 ,2.5D0,4Ha,;b;", {});
    EXPECT_EQ(record.remaining(), 4);
    EXPECT_EQ(record.integer("a"), 126);
    EXPECT_EQ(record.integer("b"), 3);
    EXPECT_EQ(record.real("c"), 2.5);
    EXPECT_EQ(record.string("d"), "a,;b");
    EXPECT_EQ(record.remaining(), 0);
}

TEST(IgesRecord, blank_and_absent_parameters_are_defaults) {
    Record record("1,,  ,;", {});
    EXPECT_EQ(record.remaining(), 4);
    record.skip(1);
    EXPECT_TRUE(record.next_is_blank());
    EXPECT_EQ(record.integer("blank"), 0);
    EXPECT_EQ(record.real("blank"), 0.0);
    EXPECT_EQ(record.string("blank"), "");
    EXPECT_EQ(record.remaining(), 0);
    EXPECT_TRUE(record.next_is_blank());
    EXPECT_EQ(record.integer("absent"), 0);
    EXPECT_EQ(record.real("absent"), 0.0);
}

TEST(IgesRecord, what_follows_the_record_delimiter_is_a_comment) {
    Record record("1,2;3,4, 99Hcomment", {});
    EXPECT_EQ(record.remaining(), 2);
}

TEST(IgesRecord, other_delimiters) {
    Record record("1/2,5/3Ha/b#9", {'/', '#'});
    EXPECT_EQ(record.remaining(), 3);
    record.skip(1);
    EXPECT_THROW((void)record.real("comma inside"), nrb::Error);
    EXPECT_EQ(record.string("slash inside"), "a/b");
}

TEST(IgesRecord, strings_keep_their_blanks) {
    Record record("  4H a  ,0H,12H123456789012;", {});
    EXPECT_EQ(record.string("a"), " a  ");
    EXPECT_EQ(record.string("empty"), "");
    EXPECT_EQ(record.string("long"), "123456789012");
}

TEST(IgesRecord, broken_strings_and_missing_ends) {
    EXPECT_EQ(status_of("1,2;"), nrb::Status::ok);
    EXPECT_EQ(status_of(""), nrb::Status::syntax);
    EXPECT_EQ(status_of("1,2"), nrb::Status::syntax);
    EXPECT_EQ(status_of("9Habc;"), nrb::Status::syntax);
    EXPECT_EQ(status_of("4Habc;"), nrb::Status::syntax); // swallows the delimiter
    EXPECT_EQ(status_of("2Habc;"), nrb::Status::syntax); // 'c' is left over
    EXPECT_EQ(status_of("99999999999999999999999H;"), nrb::Status::syntax);
}

TEST(IgesRecord, names_the_wrong_value) {
    Record record("1,2,abc,3Hxyz;", {});
    record.skip(2);
    try {
        (void)record.real("knots", 7);
        FAIL();
    } catch (const nrb::Error &error) {
        EXPECT_EQ(error.status(), nrb::Status::syntax);
        EXPECT_STREQ(error.what(),
                     "knots[7] (parameter 3) is 'abc', expected a number within double precision");
    }
    EXPECT_THROW((void)record.integer("a string"), nrb::Error);
    Record other("1.5;", {});
    EXPECT_THROW((void)other.integer("not whole"), nrb::Error);
    Record number("17;", {});
    EXPECT_THROW((void)number.string("not a string"), nrb::Error);
}

} // namespace

} // namespace record_test
