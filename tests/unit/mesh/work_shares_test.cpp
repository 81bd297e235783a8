// How faces that are meshed one after the other share the work that is left.
#include "mesh/work_shares.h"

#include "base/watch.h"

#include <gtest/gtest.h>

namespace nrb::mesh {

namespace {

// What is left for the body of a face.
int64_t given_to(WorkShares &shares, size_t face, int64_t taken) {
    int64_t given = 0;
    const bool enough = shares.run(face, [&] {
        given = work_left();
        count_work(taken);
    });
    EXPECT_EQ(enough, taken <= given);
    return given;
}

} // namespace

TEST(WorkShares, a_face_has_what_others_are_not_expected_to_need) {
    const Watch watch({1000, nullptr, nullptr});
    const LimitedSearch search;
    WorkShares shares({100, 100, 100});
    shares.begin({true, true, true});
    EXPECT_NEAR(static_cast<double>(given_to(shares, 0, 100)), 800, 1);
    EXPECT_NEAR(static_cast<double>(given_to(shares, 1, 100)), 800, 1);
    EXPECT_NEAR(static_cast<double>(given_to(shares, 2, 300)), 800, 1);
}

TEST(WorkShares, a_face_has_its_share_where_all_want_too_much) {
    const Watch watch({1000, nullptr, nullptr});
    const LimitedSearch search;
    WorkShares shares({1000, 1000, 1000, 1000});
    shares.begin({true, true, true, true});
    EXPECT_NEAR(static_cast<double>(given_to(shares, 0, 500)), 375, 1); // and a half
    EXPECT_DOUBLE_EQ(shares.pressure(), 3.5);                           // 500 and three times 1000, of 1000
}

TEST(WorkShares, what_faces_take_tells_what_others_will) {
    const Watch watch({1000, nullptr, nullptr});
    const LimitedSearch search;
    WorkShares shares({10, 10, 10});
    shares.begin({true, false, true});
    EXPECT_NEAR(static_cast<double>(given_to(shares, 0, 800)), 990, 1);
    EXPECT_DOUBLE_EQ(shares.pressure(), 1.6); // as much again, of 1000
}

TEST(WorkShares, without_expectations_each_has_all_that_is_left) {
    const Watch watch({1000, nullptr, nullptr});
    const LimitedSearch search;
    WorkShares shares({});
    shares.begin({true, true});
    EXPECT_NEAR(static_cast<double>(given_to(shares, 0, 600)), 1000, 1);
    EXPECT_NEAR(static_cast<double>(given_to(shares, 1, 600)), 400, 1);
    EXPECT_EQ(shares.pressure(), 0);
}

} // namespace nrb::mesh
