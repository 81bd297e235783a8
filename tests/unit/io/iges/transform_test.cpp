// Transformation matrices (124): alone, chained, scaled, and broken.
#include "support/iges_reading.h"

namespace transform_test {

namespace {

using namespace iges_test;

// x -> (-y, x, z) + (10, 20, 30).
constexpr const char *quarter_turn = "0.,-1.,0.,10.,1.,0.,0.,20.,0.,0.,1.,30.";
// x -> x + (100, 0, 0).
constexpr const char *shift = "1.,0.,0.,100.,0.,1.,0.,0.,0.,0.,1.,0.";

TEST(IgesTransform, rotates_then_translates) {
    IgesBuilder builder;
    const int64_t matrix = builder.add(124, quarter_turn);
    builder.add(126, line_126, {.transform = matrix});
    EXPECT_EQ(points_of(*only_spline(read(builder))), (std::vector<double>{8, 21, 33, 4, 24, 38}));
}

TEST(IgesTransform, may_stand_after_its_user) {
    IgesBuilder builder;
    builder.add(126, line_126, {.transform = 3});
    builder.add(124, shift);
    EXPECT_EQ(points_of(*only_spline(read(builder))), (std::vector<double>{101, 2, 3, 104, 6, 8}));
}

// The curve's own matrix applies first, the one it points to after that.
TEST(IgesTransform, chains_from_the_inside_out) {
    IgesBuilder builder;
    const int64_t outer = builder.add(124, quarter_turn);
    const int64_t inner = builder.add(124, shift, {.transform = outer});
    builder.add(126, line_126, {.transform = inner});
    EXPECT_EQ(points_of(*only_spline(read(builder))), (std::vector<double>{8, 121, 33, 4, 124, 38}));
}

TEST(IgesTransform, applies_before_the_unit) {
    IgesBuilder builder;
    builder.global(14, "6");
    const int64_t matrix = builder.add(124, shift);
    builder.add(126, line_126, {.transform = matrix});
    EXPECT_EQ(points_of(*only_spline(read(builder, {.unit = 0.001}))),
              (std::vector<double>{101000, 2000, 3000, 104000, 6000, 8000}));
}

TEST(IgesTransform, one_matrix_for_many) {
    IgesBuilder builder;
    const int64_t matrix = builder.add(124, shift);
    for (int i = 0; i < 3; ++i) {
        builder.add(126, line_126, {.transform = matrix});
    }
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 3U);
    EXPECT_TRUE(document.notes.empty()); // a matrix that was used is not lost
    EXPECT_EQ(document.splines[2].spline->points()[0], 101.0);
}

TEST(IgesTransform, keeps_weights_and_periodicity) {
    IgesBuilder builder;
    const int64_t matrix = builder.add(124, quarter_turn);
    builder.add(126, "3,1,0,1,0,1,0,1,2,3,4,5,1,2,3,1,0.1,0.2,0.3,1,0,0,0,1,0,0.1,0.2,0.3,1,4",
                {.transform = matrix});
    const nrb::SplinePtr spline = only_spline(read(builder));
    ASSERT_NE(spline, nullptr);
    EXPECT_TRUE(spline->axis(0).periodic());
    EXPECT_EQ(std::vector<double>(spline->weights().begin(), spline->weights().end()),
              (std::vector<double>{1, 2, 3, 1}));
}

// What a curve with pointer `transform` leaves in a file whose first entity is `type` with `data`.
nrb::model::Note note_with(int type, const std::string &data, int64_t own_transform, int64_t transform) {
    IgesBuilder builder;
    builder.add(type, data, {.transform = own_transform});
    builder.add(126, line_126, {.transform = transform});
    builder.add(126, line_126);
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(document.splines.size(), 1U); // the untouched one
    EXPECT_EQ(document.notes.size(), 2U);
    return document.notes.back();
}

TEST(IgesTransform, broken_ones_lose_only_their_users) {
    const std::string bad_number = "1.,0.,0.,x,0.,1.,0.,0.,0.,0.,1.,0.";
    const struct {
        nrb::model::Note note;
        const char *words;
    } cases[] = {
        {note_with(124, shift, 0, 7), "directory line 7 is not a transformation matrix"},
        {note_with(124, shift, 0, 2), "directory line 2 is not a transformation matrix"},
        {note_with(124, shift, 0, -1), "directory line -1 is not a transformation matrix"},
        {note_with(124, shift, 0, 3), "directory line 3 is not a transformation matrix"},
        {note_with(212, "1,2,3", 0, 1), "directory line 1 is not a transformation matrix"},
        {note_with(124, bad_number, 0, 1), "directory line 1: translation[0] (parameter 5) is 'x'"},
        {note_with(124, shift, 1, 1), "directory line 1 applies to itself"},
        {note_with(124, shift, 99, 1), "directory line 99 is not a transformation matrix"},
    };
    for (const auto &[note, words] : cases) {
        EXPECT_EQ(note.reason, nrb::Status::syntax);
        EXPECT_EQ(note.line, 3);
        EXPECT_NE(note.text.find(words), std::string::npos) << note.text;
    }
}

TEST(IgesTransform, a_circle_of_matrices_ends) {
    IgesBuilder builder;
    constexpr int64_t links = 2000;
    for (int64_t i = 0; i < links; ++i) {
        builder.add(124, shift, {.transform = i + 1 < links ? builder.next() + 2 : 1});
    }
    builder.add(126, line_126, {.transform = 1});
    builder.add(126, line_126, {.transform = 2001});
    const nrb::model::Model document = read(builder);
    EXPECT_TRUE(document.splines.empty());
    EXPECT_NE(document.notes.back().text.find("applies to itself"), std::string::npos)
        << document.notes.back().text;
}

TEST(IgesTransform, a_long_chain_adds_up) {
    IgesBuilder builder;
    constexpr int64_t links = 20000;
    for (int64_t i = 0; i < links; ++i) {
        builder.add(124, shift, {.transform = i + 1 < links ? builder.next() + 2 : 0});
    }
    builder.add(126, line_126, {.transform = 1});
    EXPECT_EQ(only_spline(read(builder))->points()[0], 1.0 + 100.0 * links);
}

} // namespace

} // namespace transform_test
