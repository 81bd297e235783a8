#include "eval/kernels/triple_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace triple_stream_test {

using namespace nrb;

namespace {

constexpr double untouched = -1;

double component(int64_t point, int64_t c) {
    return static_cast<double>(3 * point + c);
}

std::array<double, 3 * eval::block_size> rows_of(int64_t first, int64_t count) {
    std::array<double, 3 * eval::block_size> rows{};
    for (int64_t i = 0; i < count; ++i) {
        for (int64_t c = 0; c < 3; ++c) {
            rows[static_cast<size_t>(c * eval::block_size + i)] = component(first + i, c);
        }
    }
    return rows;
}

// An array that begins `shift` doubles behind the start of a cache line, with guards on both sides.
class Target {
public:
    Target(int64_t points, size_t shift)
        : points_(points), storage_(static_cast<size_t>(3 * points) + 32, untouched) {
        const size_t over = reinterpret_cast<uintptr_t>(storage_.data()) / sizeof(double) % 8;
        start_ = 8 + (8 - over) % 8 + shift;
    }
    [[nodiscard]] Records records() { return {storage_.data() + start_, points_, 3, 3, 1}; }
    void expect(int64_t begin, int64_t end) const {
        for (size_t i = 0; i < storage_.size(); ++i) {
            const int64_t at = static_cast<int64_t>(i) - static_cast<int64_t>(start_);
            const bool written = at >= 3 * begin && at < 3 * end;
            ASSERT_EQ(storage_[i], written ? static_cast<double>(at) : untouched) << at;
        }
    }

private:
    int64_t points_;
    size_t start_ = 0;
    std::vector<double> storage_;
};

} // namespace

TEST(TripleStream, writes_blocks_that_follow_each_other_at_any_alignment) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int64_t> length(1, eval::block_size);
    for (size_t shift = 0; shift < 8; ++shift) {
        Target target(1000, shift);
        const Records out = target.records();
        int64_t first = 0;
        {
            eval::TripleStream stream(out, true);
            while (first < 900) {
                const int64_t count = length(random);
                stream.write(rows_of(first, count).data(), first, count);
                first += count;
            }
        }
        target.expect(0, first);
    }
}

TEST(TripleStream, writes_blocks_shorter_than_a_line_at_any_alignment) {
    for (const int64_t count : {1, 2}) {
        for (size_t shift = 0; shift < 8; ++shift) {
            Target target(100, shift);
            const Records out = target.records();
            {
                eval::TripleStream stream(out, true);
                for (int64_t first = 40; first < 60; first += count) {
                    stream.write(rows_of(first, count).data(), first, count);
                }
            }
            target.expect(40, 60);
        }
    }
}

TEST(TripleStream, writes_blocks_in_any_order) {
    for (size_t shift = 0; shift < 8; ++shift) {
        Target target(200, shift);
        const Records out = target.records();
        {
            eval::TripleStream stream(out, true);
            for (const int64_t first : {100, 1, 37, 73, 130, 64, 163}) {
                const int64_t count = first == 1     ? 36
                                      : first == 37  ? 27
                                      : first == 64  ? 9
                                      : first == 73  ? 27
                                      : first == 100 ? 30
                                                     : 33;
                stream.write(rows_of(first, count).data(), first, count);
            }
        }
        target.expect(1, 196);
    }
}

TEST(TripleStream, leaves_other_layouts_to_ordinary_stores) {
    std::vector<double> separate(3 * 100, untouched);
    const Records out{separate.data(), 100, 3, 1, 100};
    eval::TripleStream(out, true).write(rows_of(0, eval::block_size).data(), 0, eval::block_size);
    for (int64_t i = 0; i < 100; ++i) {
        for (int64_t c = 0; c < 3; ++c) {
            EXPECT_EQ(out(i, c), i < nrb::eval::block_size ? component(i, c) : untouched);
        }
    }
}

} // namespace triple_stream_test
