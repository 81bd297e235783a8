#include "base/checked.h"
#include "base/lazy.h"
#include "base/scratch.h"

#include <atomic>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

namespace base_test {

namespace {

TEST(Checked, refuses_sizes_beyond_the_address_space) {
    EXPECT_EQ(nrb::checked_product(3, 4, "x"), 12);
    EXPECT_EQ(nrb::checked_product(0, INT64_MAX, "x"), 0);
    EXPECT_EQ(nrb::checked_product(nrb::max_doubles, 1, "x"), nrb::max_doubles);
    EXPECT_THROW(nrb::checked_product(nrb::max_doubles, 2, "x"), nrb::Error);
    EXPECT_THROW(nrb::checked_sum(nrb::max_doubles, 1, "x"), nrb::Error);
    EXPECT_EQ(nrb::checked_sum(nrb::max_doubles, 0, "x"), nrb::max_doubles);
}

TEST(Number, is_the_shortest_text_that_names_the_value) {
    EXPECT_STREQ(nrb::Number(0.1).text, "0.1");
    EXPECT_STREQ(nrb::Number(-1e300).text, "-1e+300");
    EXPECT_EQ(std::stod(nrb::Number(1.0 / 3).text), 1.0 / 3);
}

TEST(Error, cuts_long_messages) {
    const std::string text(1000, 'x');
    try {
        nrb::fail(nrb::Status::syntax, "%s", text.c_str());
    } catch (const nrb::Error &error) {
        EXPECT_EQ(error.status(), nrb::Status::syntax);
        EXPECT_EQ(std::string(error.what()), text.substr(0, nrb::Error::capacity - 1));
    }
}

TEST(Lazy, gives_all_threads_the_same_object) {
    nrb::Lazy<int> lazy;
    std::atomic<int> built{0};
    std::vector<const int *> seen(8);
    std::vector<std::thread> threads;
    for (const int *&result : seen) {
        threads.emplace_back([&] { result = &lazy.get([&] { return ++built; }); });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    for (const int *result : seen) {
        EXPECT_EQ(result, seen[0]);
    }
    EXPECT_EQ(&lazy.get([] { return -1; }), seen[0]);
}

TEST(Lazy, stays_empty_when_building_fails) {
    nrb::Lazy<int> lazy;
    EXPECT_THROW(lazy.get([]() -> int { throw std::bad_alloc(); }), std::bad_alloc);
    EXPECT_EQ(lazy.get([] { return 5; }), 5);
}

TEST(Scratch, hands_out_separate_blocks) {
    for (const size_t size : {16U, 100000U}) {
        nrb::Scratch scratch(2 * size);
        double *a = scratch.take(size);
        double *b = scratch.take(size);
        EXPECT_GE(b, a + size);
        a[size - 1] = b[size - 1] = 1;
    }
}

} // namespace

} // namespace base_test
