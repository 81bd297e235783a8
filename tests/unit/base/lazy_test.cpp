// Tables that are built at need: who pays for them, and threads that meet while one is built.
#include "base/lazy.h"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <latch>
#include <thread>
#include <vector>

namespace lazy_test {

namespace {

// Starts `count` threads at one moment and waits for them.
template <class Body>
void at_once(int count, Body &&body) {
    std::latch start(count);
    std::vector<std::thread> threads;
    for (int i = 0; i < count; ++i) {
        threads.emplace_back([&, i] {
            start.arrive_and_wait();
            body(i);
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
}

TEST(Uses, pay_when_they_add_up_to_the_cost) {
    const nrb::Uses uses;
    EXPECT_FALSE(uses.pay(4, 10));
    EXPECT_FALSE(uses.pay(0, 10));
    EXPECT_FALSE(uses.pay(5, 10));
    EXPECT_TRUE(uses.pay(1, 10)); // the use that completes the cost has the table already
    EXPECT_TRUE(uses.pay(0, 10));
}

TEST(Uses, pay_at_once_when_one_call_is_enough) {
    EXPECT_TRUE(nrb::Uses().pay(10, 10));
    EXPECT_FALSE(nrb::Uses().pay(9, 10));
    EXPECT_TRUE(nrb::Uses().pay(1, 0));
    EXPECT_TRUE(nrb::Uses().pay(INT64_MAX, INT64_MAX));
    EXPECT_FALSE(nrb::Uses().pay(INT64_MAX - 1, INT64_MAX));
}

// No use of any thread is lost: exactly cost - 1 single uses go without.
TEST(Uses, of_several_threads_are_all_counted) {
    const nrb::Uses uses;
    std::atomic<int64_t> unpaid{0};
    at_once(4, [&](int) { // for long enough that the threads meet
        int64_t own = 0;
        for (int i = 0; i < 300000; ++i) {
            own += uses.pay(1, 900000) ? 0 : 1;
        }
        unpaid += own;
    });
    EXPECT_EQ(unpaid, 899999);
}

// Counts its live objects.
class Table {
public:
    explicit Table(std::atomic<int> &live) : live_(&live) { ++live; }
    Table(Table &&other) noexcept : live_(other.live_) { ++*live_; }
    Table(const Table &) = delete;
    Table &operator=(const Table &) = delete;
    ~Table() { --*live_; }

private:
    std::atomic<int> *live_;
};

// Threads that build the same table keep one of them, all see it whole, and the others are freed.
TEST(Lazy, keeps_one_of_the_tables_that_threads_build) {
    std::atomic<int> live{0};
    int raced = 0;
    for (int round = 0; round < 300; ++round) {
        std::atomic<int> built{0};
        const Table *seen[4] = {};
        {
            const nrb::Lazy<Table> lazy;
            EXPECT_EQ(lazy.peek(), nullptr);
            at_once(4, [&](int i) {
                seen[i] = &lazy.get([&] {
                    ++built;
                    return Table(live);
                });
            });
            EXPECT_EQ(live, 1);
            EXPECT_EQ(lazy.peek(), seen[0]);
            EXPECT_TRUE(std::all_of(seen, seen + 4, [&](const Table *table) { return table == seen[0]; }));
        }
        EXPECT_EQ(live, 0);
        raced += built > 1 ? 1 : 0;
    }
    std::printf("%d of 300 rounds had several builders\n", raced);
}

// A builder that asks for its own table, as if another thread had come in between: the inner one stays.
TEST(Lazy, drops_the_table_that_comes_second) {
    std::atomic<int> live{0};
    const nrb::Lazy<Table> lazy;
    const Table *first = nullptr;
    const Table &second = lazy.get([&] {
        first = &lazy.get([&] { return Table(live); });
        return Table(live);
    });
    EXPECT_EQ(first, &second);
    EXPECT_EQ(live, 1);
}

} // namespace

} // namespace lazy_test
