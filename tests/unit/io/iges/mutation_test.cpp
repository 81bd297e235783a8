// No file makes the reader crash: every byte of a small file changed to telling values, and every byte left
// out or doubled.
#include "support/iges_reading.h"

namespace mutation_test {

namespace {

using namespace iges_test;

// One of everything that the reader looks into.
std::string everything() {
    IgesBuilder builder;
    builder.add(124, "1.,0.,0.,1.D1,0.,1.,0.,2.,0.,0.,1.,3.");
    builder.add(406, "1,4Hname", {.form = 15});
    builder.add(126, std::string(line_126) + ",0,1,3", {.transform = 1, .label = "LABEL", .subscript = 3});
    builder.add(126, "2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,.5,1.,0.,0.,0.,1.,1.,0.,2.,0.,0.,.25,.75");
    builder.add(128, "1,1,1,1,0,0,0,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,2.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,"
                     "0.,0.,1.,0.,1.");
    builder.add(102, "1,7");
    builder.add(142, "0,9,11,5,2");
    builder.add(141, "1,3,9,1,5,1,1,7");
    return builder.text();
}

// The same of curves and surfaces that are made of others.
std::string all_geometry() {
    IgesBuilder builder;
    builder.add(116, "1.,2.,3.,0");           // 1
    builder.add(123, "0.,0.,1.");             // 3
    builder.add(110, "0.,0.,0.,0.,0.,1.");    // 5
    builder.add(100, "0.,5.,0.,7.,0.,5.,2."); // 7
    builder.add(104, "4.,0.,9.,0.,0.,-36.,7.,3.,0.,0.,2.", {.form = 1});
    builder.add(106, "1,3,5.,0.,0.,1.,0.,1.,2.", {.form = 11});
    builder.add(108, "0.,0.,1.,5.,11,0.,0.,0.,0.", {.form = 1});
    builder.add(112, "3,2,3,1,0.,1.,0.,1.,0.,1.,0.,0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.");
    builder.add(118, "5,7,0,0");
    builder.add(120, "5,11,0.,3.");
    builder.add(122, "7,3.,1.,5.");
    builder.add(102, "1,7");
    builder.add(140, "0.,0.,1.,.5,27"); // of the sphere: others are approximated, which takes long
    builder.add(196, "1,2.,3,3");
    builder.add(198, "1,3,5.,2.");
    return builder.text();
}

// Whatever happens is a model or an Error; the notes and splines are those of the entities.
bool reads_or_throws(const std::string &text) {
    try {
        const nrb::model::Model document = read(text, {.unit = 0.001});
        return document.splines.size() + document.notes.size() <= 17; // two of a ruled surface with a remark
    } catch (const nrb::Error &error) {
        return error.status() >= nrb::Status::format && error.status() <= nrb::Status::syntax &&
               error.what()[0] != '\0';
    }
}

TEST(IgesMutation, the_file_itself_is_good) {
    const nrb::model::Model document = read(everything());
    EXPECT_EQ(document.splines.size(), 4U);
    EXPECT_EQ(document.notes.size(), 2U); // the matrix and the name have been used
    EXPECT_EQ(document.splines[0].name, "name");
    EXPECT_EQ(document.splines[1].spline->dim(), 2);
}

TEST(IgesMutation, the_geometry_itself_is_good) {
    const nrb::model::Model document = read(all_geometry());
    EXPECT_EQ(document.splines.size(), 9U);
    EXPECT_EQ(document.notes.size(), 1U); // a remark on rulings
}

TEST(IgesMutation, every_byte_changed) {
    for (const std::string &original : {everything(), all_geometry()}) {
        const std::string values("\0\xff\n\r,;H09-+. D", 14);
        for (size_t at = 0; at < original.size(); ++at) {
            std::string text = original;
            for (const char value : values) {
                text[at] = value;
                ASSERT_TRUE(reads_or_throws(text)) << "byte " << at << " = " << static_cast<int>(value);
            }
        }
    }
}

TEST(IgesMutation, every_bit_flipped) {
    for (const std::string &original : {everything(), all_geometry()}) {
        for (size_t at = 0; at < original.size(); ++at) {
            std::string text = original;
            for (int bit = 0; bit < 8; ++bit) {
                text[at] = static_cast<char>(original[at] ^ (1 << bit));
                ASSERT_TRUE(reads_or_throws(text)) << "byte " << at << " bit " << bit;
            }
        }
    }
}

TEST(IgesMutation, every_byte_left_out_or_doubled) {
    for (const std::string &original : {everything(), all_geometry()}) {
        for (size_t at = 0; at < original.size(); ++at) {
            ASSERT_TRUE(reads_or_throws(original.substr(0, at) + original.substr(at + 1)))
                << "byte " << at << " left out";
            ASSERT_TRUE(reads_or_throws(original.substr(0, at) + original.substr(at == 0 ? 0 : at - 1)))
                << "byte " << at << " doubled";
        }
    }
}

TEST(IgesMutation, every_truncation) {
    for (const std::string &original : {everything(), all_geometry()}) {
        for (size_t length = 0; length < original.size(); ++length) {
            ASSERT_TRUE(reads_or_throws(original.substr(0, length))) << "cut at " << length;
        }
    }
}

} // namespace

} // namespace mutation_test
