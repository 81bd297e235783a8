// Lists of splines as files, curves of dimension 2 among them: those are in parameters, which no unit scales.
#include "io/formats.h"
#include "io/writers.h"
#include "spline/same_numbers.h"
#include "support/written_models.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace written_lists_test {
namespace {

using namespace write_test;

class WrittenLists : public testing::TestWithParam<int> {
protected:
    static model::Model through(const model::Model &list, const io::WriteSettings &settings = {}) {
        return io::read(io::write(list, GetParam(), settings), {});
    }
};

SplinePtr flat_curve() {
    return spline_of(2, Form::rational, {0, 0, 0, 0.5, 1, 1, 1}, 2, {0, 0, 1, 0.25, 1, 1, -7e9, 1},
                     {1, 2, 1, 1});
}

SplinePtr segment() {
    return spline_of(3, Form::polynomial, {0, 0, 1, 1}, 1, {0, 0, 0, 1, 2, 3});
}

void expect_same_lists(const model::Model &a, const model::Model &b) {
    ASSERT_EQ(a.splines.size(), b.splines.size());
    for (size_t i = 0; i < a.splines.size(); ++i) {
        EXPECT_TRUE(same_numbers(*a.splines[i].spline, *b.splines[i].spline)) << i;
        EXPECT_EQ(a.splines[i].spline->dim(), b.splines[i].spline->dim()) << i;
        EXPECT_EQ(a.splines[i].name, b.splines[i].name) << i;
    }
}

TEST_P(WrittenLists, CurvesOfThePlaneComeBackAmongOthers) {
    for (const std::vector<SplinePtr> &splines :
         {std::vector{flat_curve()}, {segment(), flat_curve(), segment(), flat_curve()}}) {
        model::Model list = list_of(splines);
        list.metres_per_unit = 0.001;
        const model::Model again = through(list);
        EXPECT_TRUE(again.notes.empty());
        expect_same_lists(list, again);
        EXPECT_EQ(io::write(again, GetParam(), {}), io::write(list, GetParam(), {}));
    }
}

TEST_P(WrittenLists, CurvesOfThePlaneHaveNoUnit) {
    model::Model list = list_of({flat_curve(), segment()});
    list.metres_per_unit = 0.001;
    const std::string metres = io::write(list, GetParam(), {1, 0});
    for (const io::ReadSettings &settings : {io::ReadSettings{}, io::ReadSettings{0.001}}) {
        const model::Model again = io::read(metres, settings);
        ASSERT_EQ(again.splines.size(), 2U);
        EXPECT_TRUE(same_numbers(*again.splines[0].spline, *flat_curve()));
        EXPECT_NEAR(again.splines[1].spline->coordinate(1, 2), settings.unit > 0 ? 3 : 0.003, 1e-15);
    }
}

TEST_P(WrittenLists, CurvesOfThePlaneStandBesideFaces) {
    model::Model model = list_of({flat_curve()});
    model.metres_per_unit = 0.001;
    const model::Model again = io::read_model(io::write(model, GetParam(), {}), {});
    expect_same_lists(model, again);
}

// What nurbs_read() gives of any file can be written, and is read again as it was.
TEST_P(WrittenLists, OfRealFiles) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set: no real files to read";
    }
    int flat = 0;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        const std::string suffix = entry.path().extension().string();
        if (suffix != ".igs" && suffix != ".iges" && suffix != ".stp" && suffix != ".step") {
            continue;
        }
        SCOPED_TRACE(entry.path());
        std::ifstream in(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        const model::Model list = io::read(text, {}), again = through(list);
        ASSERT_EQ(again.splines.size(), list.splines.size());
        for (size_t i = 0; i < list.splines.size(); ++i) {
            EXPECT_TRUE(same_numbers(*list.splines[i].spline, *again.splines[i].spline)) << i;
            flat += list.splines[i].spline->dim() == 2 ? 1 : 0;
        }
        EXPECT_NO_THROW((void)io::read_model(io::write(io::read_model(text, {}), GetParam(), {}), {}));
    }
    EXPECT_GT(flat, 0);
}

INSTANTIATE_TEST_SUITE_P(All, WrittenLists, testing::Values(1, 2));

} // namespace
} // namespace written_lists_test
