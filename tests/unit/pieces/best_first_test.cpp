// SPDX-License-Identifier: MIT
#include "pieces/best_first.h"

#include <gtest/gtest.h>

namespace best_first_test {

using nrb::pieces::BestFirst;

TEST(BestFirst, looks_at_the_best_first_within_the_budget) {
    BestFirst<char> search;
    search.push(1, 'a');
    search.push(3, 'c');
    search.push(2, 'b');
    int64_t budget = 2;
    std::vector<char> seen;
    search.run(
        budget, [](const auto &) { return true; }, [&](auto entry) { seen.push_back(entry.item); });
    EXPECT_EQ(seen, (std::vector<char>{'c', 'b'}));
    EXPECT_EQ(search.bound(), 1);
}

TEST(BestFirst, bounds_what_is_left_and_what_was_left_out) {
    BestFirst<int> search({{1.0, 0}, {2.0, 1}});
    EXPECT_EQ(search.bound(), 2);
    search.leave_out(5);
    EXPECT_EQ(search.bound(), 5);
    search.pop();
    search.pop();
    EXPECT_TRUE(search.empty());
    EXPECT_EQ(search.bound(), 5);
}

// What look() takes itself counts, and what does not count ends the search.
TEST(BestFirst, ends_where_nothing_counts) {
    BestFirst<int> search({{4.0, 0}, {3.0, 0}, {1.0, 0}});
    int64_t budget = 10, looked = 0;
    search.run(
        budget, [](const auto &entry) { return entry.bound > 2; },
        [&](auto) {
            ++looked;
            budget -= 3;
        });
    EXPECT_EQ(looked, 2);
    EXPECT_EQ(budget, 2);
}

} // namespace best_first_test
