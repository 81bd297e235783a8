// Stored values from an exact evaluator written independently in another language: the library keeps its
// bounds against them, and the reference of these tests rounds to them exactly.
#include "reference/magnitudes.h"
#include "support/golden_file.h"
#include "support/handle.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace support;
using reference::eps;

namespace {

#ifdef NURBS_SOURCE_DIR
constexpr const char *source_dir = NURBS_SOURCE_DIR;
#else
constexpr const char *source_dir = nullptr;
#endif

namespace golden_test {

void check_place(const SplineData &data, GoldenWords &words) {
    const int order = words.whole();
    const auto param = words.numbers(data.axes());
    const auto derivs = eval_derivs(create(data).get(), order, param);
    const auto exact = reference::exact_derivatives(data, order, param.data());
    const auto sizes = reference::magnitudes(data, order, param.data());
    const auto indices = graded_indices(data.axes(), order);
    const long double c = reference::c_of(data);
    const double hull = reference::exact_hull(data, param.data());
    for (size_t slot = 0; slot < indices.size(); ++slot) {
        const int k = std::accumulate(indices[slot].begin(), indices[slot].end(), 0);
        const auto want = words.numbers(data.dim);
        for (size_t d = 0; d < want.size(); ++d) {
            const double got = derivs[slot * want.size() + d];
            ASSERT_EQ(reference::nearest(exact[slot][d]), want[d])
                << describe(data) << hex(param) << " slot " << slot;
            // The stored value is itself rounded, by half a unit in its last place.
            const long double bound =
                (k == 0 ? c * hull : 2 * (c + 2 * k) * sizes[slot][d]) * eps + std::fabs(want[d]) * eps / 2;
            ASSERT_LE(std::fabs(static_cast<long double>(got) - want[d]), bound)
                << describe(data) << hex(param) << " slot " << slot << " is " << hex(got);
        }
    }
}

void check_file(const std::string &name, int expected_places) {
    ASSERT_NE(source_dir, nullptr) << "the build must define NURBS_SOURCE_DIR as the project's folder";
    GoldenWords words(std::string(source_dir) + "/tests/golden/" + name);
    SplineData data;
    int places = 0;
    for (std::string word; words.next(word);) {
        ASSERT_TRUE(word == "spline" || word == "at") << word;
        if (word == "spline") {
            data = words.spline();
        } else {
            ASSERT_NO_FATAL_FAILURE(check_place(data, words));
            ++places;
        }
    }
    EXPECT_EQ(places, expected_places);
}

TEST(Golden, curves) {
    check_file("curves.txt", 160);
}

TEST(Golden, surfaces) {
    check_file("surfaces.txt", 42);
}

TEST(Golden, volumes) {
    check_file("volumes.txt", 12);
}

} // namespace golden_test

} // namespace
