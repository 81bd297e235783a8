// SPDX-License-Identifier: MIT
// Watched calls: what the callback is told and when, and what ends them.
#include "base/watch.h"

#include "base/error.h"
#include "base/lazy.h"

#include <chrono>
#include <functional>
#include <gtest/gtest.h>

#include <limits>
#include <thread>
#include <vector>

namespace watch_test {

using namespace nrb;

namespace {

constexpr int64_t look = 1 << 14; // work after which the clock is looked at

struct Told {
    std::vector<double> shares;
    int32_t answer = 0;
    Watch *inside = nullptr;
    bool throws = false;
};

int32_t tell(double done, void *user) {
    Told &told = *static_cast<Told *>(user);
    told.shares.push_back(done);
    told.inside = Watch::current();
    if (told.throws) {
        throw std::runtime_error("no");
    }
    return told.answer;
}

void pause() {
    std::this_thread::sleep_for(std::chrono::milliseconds(11));
}

Status end_of(const Watch::Wishes &wishes, const std::function<void()> &body) {
    try {
        const Watch watch(wishes);
        body();
        return Status::ok;
    } catch (const CallEnded &end) {
        return end.why.status();
    }
}

// What ends the body, where nobody watches.
Status unwatched_end_of(const std::function<void()> &body) {
    try {
        body();
    } catch (const CallEnded &end) {
        return end.why.status();
    }
    return Status::ok;
}

} // namespace

TEST(Watch, is_that_of_the_thread_until_it_ends) {
    EXPECT_EQ(Watch::current(), nullptr);
    {
        const Watch outer({});
        EXPECT_EQ(Watch::current(), &outer);
        {
            const Watch inner({});
            EXPECT_EQ(Watch::current(), &inner);
        }
        EXPECT_EQ(Watch::current(), &outer);
        std::thread([] { EXPECT_EQ(Watch::current(), nullptr); }).join();
    }
    EXPECT_EQ(Watch::current(), nullptr);
}

TEST(Watch, calls_back_at_most_every_ten_milliseconds_with_an_empty_slot) {
    Told told;
    const Watch watch({0, tell, &told});
    count_work(look);
    EXPECT_TRUE(told.shares.empty());
    pause();
    count_work(look - 1);
    EXPECT_TRUE(told.shares.empty()) << "not before there was work";
    count_work(1);
    count_work(look);
    ASSERT_EQ(told.shares.size(), 1U);
    EXPECT_EQ(told.inside, nullptr);
    EXPECT_EQ(Watch::current(), &watch);
}

TEST(Watch, shares_of_nested_loops_rise) {
    Told told;
    const Watch watch({0, tell, &told});
    Steps outer(2);
    for (int i = 0; i < 2; ++i, outer.next()) {
        Steps inner(4);
        for (int k = 0; k < 4; ++k) {
            pause();
            inner.next(look);
        }
    }
    const std::vector<double> wanted{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1};
    EXPECT_EQ(told.shares, wanted);
}

TEST(Watch, what_the_callback_returns_ends_the_call) {
    static Told told;
    told = {{}, 3, nullptr, false};
    const auto body = [] {
        pause();
        count_work(look);
    };
    EXPECT_EQ(end_of({0, tell, &told}, body), Status::cancelled);
    told = {{}, 0, nullptr, true};
    EXPECT_EQ(end_of({0, tell, &told}, body), Status::cancelled);
    EXPECT_EQ(Watch::current(), nullptr);
}

TEST(Watch, the_limit_ends_a_call_but_not_a_search) {
    EXPECT_EQ(end_of({100, nullptr, nullptr}, [] { count_work(100); }), Status::ok);
    EXPECT_EQ(end_of({100, nullptr, nullptr}, [] { count_work(101); }), Status::work);
    EXPECT_EQ(end_of({100, nullptr, nullptr},
                     [] {
                         const LimitedSearch search;
                         EXPECT_FALSE(work_ended());
                         count_work(101);
                         EXPECT_TRUE(work_ended());
                         count_work(1000);
                     }),
              Status::ok);
    EXPECT_FALSE(work_ended());
}

TEST(Watch, the_usual_limit_holds_without_one_of_the_caller) {
    const auto work = [](int64_t done) {
        return [done] {
            const UsualLimit usual(100);
            count_work(done);
        };
    };
    EXPECT_EQ(unwatched_end_of(work(100)), Status::ok);
    EXPECT_EQ(unwatched_end_of(work(101)), Status::not_converged);
    EXPECT_EQ(end_of({0, nullptr, nullptr}, work(101)), Status::not_converged);
    EXPECT_EQ(end_of({50, nullptr, nullptr}, work(51)), Status::work);
    EXPECT_EQ(end_of({1000, nullptr, nullptr}, work(1000)), Status::ok);
    EXPECT_EQ(Watch::current(), nullptr);
}

TEST(Watch, the_usual_limit_ends_a_search_and_then_no_more) {
    const auto body = [] {
        count_work(500); // before the search
        {
            const UsualLimit usual(100);
            const UsualLimit inner(10); // has no say
            const LimitedSearch search;
            count_work(100);
            EXPECT_FALSE(work_ended());
            count_work(1);
            EXPECT_TRUE(work_ended());
            count_work(1000);
        }
        EXPECT_FALSE(work_ended());
        count_work(1000000);
    };
    EXPECT_EQ(unwatched_end_of(body), Status::ok);
    EXPECT_EQ(end_of({0, nullptr, nullptr}, body), Status::ok);
}

TEST(Watch, an_attempt_ends_at_the_limit_and_nothing_after_it) {
    EXPECT_EQ(end_of({100, nullptr, nullptr},
                     [] {
                         EXPECT_TRUE(attempted([] { count_work(100); }));
                         bool went_on = false;
                         EXPECT_FALSE(attempted([&] {
                             count_work(1);
                             went_on = true;
                         }));
                         EXPECT_FALSE(went_on);
                         EXPECT_TRUE(work_ended());
                         count_work(1000);
                         EXPECT_FALSE(attempted([&] { went_on = true; }));
                         EXPECT_FALSE(went_on);
                     }),
              Status::ok);
    static Told told;
    told = {{}, 1, nullptr, false};
    EXPECT_EQ(end_of({0, tell, &told},
                     [] {
                         (void)attempted([] {
                             pause();
                             count_work(look);
                         });
                     }),
              Status::cancelled);
}

TEST(Watch, a_part_of_the_work_leaves_the_rest) {
    const auto body = [](int64_t more) {
        return [more] {
            count_work(20);
            {
                const PartOfWork half;
                EXPECT_TRUE(attempted([] { count_work(40); }));
                EXPECT_FALSE(attempted([] { count_work(1); }));
            }
            EXPECT_FALSE(work_ended());
            count_work(more);
        };
    };
    EXPECT_EQ(end_of({100, nullptr, nullptr}, body(39)), Status::ok);
    EXPECT_EQ(end_of({100, nullptr, nullptr}, body(40)), Status::work);
    EXPECT_EQ(end_of({100, nullptr, nullptr},
                     [] {
                         const PartOfWork tenth(0.1);
                         EXPECT_TRUE(attempted([] { count_work(10); }));
                         EXPECT_FALSE(attempted([] { count_work(1); }));
                     }),
              Status::ok);
    EXPECT_EQ(end_of({0, nullptr, nullptr},
                     [] {
                         const PartOfWork half; // of no limit
                         EXPECT_FALSE(work_is_limited());
                         count_work(1000000);
                     }),
              Status::ok);
}

// The limit that is told is that of the caller, or the usual one, whatever is left of it.
TEST(Watch, limits_are_told_as_they_were_given) {
    const auto text_of = [](int64_t work, const std::function<void()> &body) {
        try {
            const Watch watch({work, nullptr, nullptr});
            body();
        } catch (const CallEnded &end) {
            return std::string(end.why.what());
        }
        return std::string();
    };
    const auto body = [] {
        count_work(20);
        const UsualLimit usual(300);
        const PartOfWork half;
        count_work(1000);
    };
    EXPECT_EQ(text_of(100, body), "call.work = 100 multiply-adds were not enough");
    EXPECT_EQ(text_of(0, body), "no result within the usual limit of work, 300 multiply-adds");
}

TEST(Watch, what_is_left_of_the_work_is_known) {
    static constexpr int64_t any_work = int64_t{1} << 60;
    EXPECT_GT(work_left(), any_work); // nobody watches
    EXPECT_EQ(end_of({0, nullptr, nullptr},
                     [] {
                         const PartOfWork half;
                         count_work(1000);
                         EXPECT_GT(work_left(), any_work);
                     }),
              Status::ok);
    EXPECT_EQ(end_of({100, nullptr, nullptr},
                     [] {
                         EXPECT_EQ(work_left(), 100);
                         const LimitedSearch search;
                         const PartOfWork half;
                         EXPECT_EQ(work_left(), 50);
                         count_work(30);
                         EXPECT_EQ(work_left(), 20);
                         count_work(1000);
                         EXPECT_EQ(work_left(), 0);
                     }),
              Status::ok);
}

TEST(Watch, needed_work_counts_for_a_limit_of_the_caller_alone) {
    const auto body = [] {
        const UsualLimit usual(100);
        {
            const NeededWork needed;
            count_work(1000);
        }
        count_work(100);
    };
    EXPECT_EQ(unwatched_end_of(body), Status::ok);
    EXPECT_EQ(end_of({0, nullptr, nullptr}, body), Status::ok);
    EXPECT_EQ(end_of({1000, nullptr, nullptr}, body), Status::work);
    EXPECT_EQ(end_of({1100, nullptr, nullptr}, body), Status::ok);
}

TEST(Watch, tables_that_are_kept_do_not_count) {
    EXPECT_EQ(end_of({100, nullptr, nullptr},
                     [] {
                         const Lazy<int> table;
                         EXPECT_EQ(table.get([] {
                             count_work(1000);
                             return 7;
                         }),
                                   7);
                         count_work(100);
                     }),
              Status::ok);
}

TEST(Watch, a_table_whose_building_is_ended_is_built_by_the_next_call) {
    static Lazy<int> table;
    static Told told;
    told = {{}, 1, nullptr, false};
    const auto build = [] {
        table.get([] {
            pause();
            count_work(look);
            return 7;
        });
    };
    EXPECT_EQ(end_of({0, tell, &told}, build), Status::cancelled);
    EXPECT_EQ(table.peek(), nullptr);
    build();
    ASSERT_NE(table.peek(), nullptr);
    EXPECT_EQ(*table.peek(), 7);
}

TEST(Watch, memory_in_parts_is_the_same_memory) {
    const Watch watch({});
    std::vector<double> values{1, 2};
    grow_watched(values, 100000);
    EXPECT_EQ(values.size(), 100000U);
    EXPECT_EQ(values[1], 2);
    EXPECT_EQ(values.back(), 0);
}

} // namespace watch_test
