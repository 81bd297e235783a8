// SPDX-License-Identifier: MIT
#include "closest/patch/critical/minimum_votes.h"

#include "closest/foot.h"

#include <gtest/gtest.h>

namespace minimum_votes_test {

using namespace nrb;
using closest::MinimumVotes;
using Result = MinimumVotes::Result;

namespace {

const std::vector<double> here{1, 2, 3}, near_here{1, 2, 3 + 1e-7}, elsewhere{1, 2, 4};

TEST(MinimumVotes, a_point_is_a_minimum_if_all_pieces_say_so) {
    MinimumVotes votes(3, 1e-6);
    votes.add(here, 0, closest::critical_minimum);
    votes.add(near_here, 1, closest::critical_minimum);
    EXPECT_EQ(votes.result(here), Result::certain);
    votes.add(elsewhere, 2, closest::critical_saddle);
    EXPECT_EQ(votes.result(here), Result::certain);
}

TEST(MinimumVotes, one_piece_can_deny_it) {
    MinimumVotes votes(3, 1e-6);
    votes.add(here, 0, closest::critical_minimum);
    votes.add(near_here, 1, closest::critical_maximum);
    EXPECT_EQ(votes.result(here), Result::denied);
}

TEST(MinimumVotes, undecided_pieces_leave_it_open) {
    MinimumVotes votes(3, 1e-6);
    votes.add(here, 0, closest::critical_minimum);
    votes.add(here, 1, closest::critical_undecided);
    EXPECT_EQ(votes.result(here), Result::open);
}

TEST(MinimumVotes, faces_of_one_piece_that_contradict_each_other_leave_its_vote_open) {
    MinimumVotes votes(3, 1e-6);
    votes.add(here, 0, closest::critical_minimum);
    votes.add(here, 0, closest::critical_saddle);
    EXPECT_EQ(votes.result(here), Result::open);
}

TEST(MinimumVotes, a_face_that_decides_nothing_does_not_count_beside_another_one) {
    for (const bool first : {false, true}) {
        MinimumVotes votes(3, 1e-6);
        votes.add(here, 0, first ? closest::critical_undecided : closest::critical_minimum);
        votes.add(here, 0, first ? closest::critical_minimum : closest::critical_undecided);
        EXPECT_EQ(votes.result(here), Result::certain);
    }
}

} // namespace

} // namespace minimum_votes_test
