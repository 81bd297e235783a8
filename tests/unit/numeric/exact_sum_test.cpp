#include "numeric/exact_sum.h"

#include "reference/number.h"
#include "support/generators.h"

#include <gtest/gtest.h>

namespace exact_sum_test {

using nrb::ExactSum;
using nrb::Int128;
using nrb::TwoLimbs;
using Whole = boost::multiprecision::cpp_int;

namespace {

// Of any size, extreme ones among them.
int64_t any_whole(support::Random &random) {
    if (random.chance(10)) {
        return random.chance(50) ? INT64_MIN : INT64_MAX;
    }
    const auto bits = static_cast<int64_t>(random.bits());
    return bits >> random.whole(0, 63);
}

template <class Number>
Whole whole_of(const Number &value) {
    return Whole(value.high()) * (Whole(1) << 64) + value.low();
}

Whole whole_of(const ExactSum &sum) {
    Whole value = static_cast<int64_t>(sum.limbs()[2]);
    for (const size_t i : {size_t{1}, size_t{0}}) {
        value = value * (Whole(1) << 64) + sum.limbs()[i];
    }
    return value;
}

} // namespace

TEST(TwoLimbs, are_whole_numbers) {
    support::Random random(930000);
    for (int i = 0; i < 20000; ++i) {
        const int64_t a = any_whole(random), b = any_whole(random);
        const TwoLimbs product = TwoLimbs::product(a, b);
        ASSERT_EQ(whole_of(product), Whole(a) * b) << a << " " << b;
        TwoLimbs sum = product;
        const TwoLimbs other(any_whole(random) / 4, random.bits());
        sum += other;
        ASSERT_EQ(whole_of(sum), whole_of(product) + whole_of(other));
        const auto x = static_cast<uint64_t>(a), y = static_cast<uint64_t>(b);
        ASSERT_EQ(TwoLimbs::high_product(x, y), static_cast<uint64_t>(Whole(x) * y >> 64));
        const int bits = random.whole(2, 63); // so that the result fits
        const TwoLimbs shifted(a >> (64 - bits + 1), y);
        ASSERT_EQ(shifted.rounded_shift(bits), (whole_of(shifted) + (Whole(1) << (bits - 1))) >> bits);
    }
}

TEST(ExactSum, is_exact_in_any_order) {
    support::Random random(930001);
    for (int i = 0; i < 2000; ++i) {
        ExactSum sum, less;
        Whole expected = 0;
        for (int j = 0; j < 20; ++j) {
            const int64_t a = any_whole(random), b = any_whole(random);
            const int shift = random.whole(0, 63);
            ExactSum one;
            one.add(Int128::product(a, b), shift);
            sum += one;
            less -= one;
            expected += (Whole(a) * b) << shift;
        }
        ASSERT_EQ(whole_of(sum), expected);
        ASSERT_EQ(whole_of(less), -expected);
        ASSERT_EQ(sum.negative(), expected < 0);
        ASSERT_EQ(sum.zero(), expected == 0);
        const nrb::DoubleDouble rounded = sum.scaled(0);
        const Whole error = expected - Whole(rounded.high) - Whole(rounded.low);
        ASSERT_LE(abs(error) << 104, abs(expected)) << expected;
        sum += less;
        ASSERT_TRUE(sum.zero());
    }
}

} // namespace exact_sum_test
