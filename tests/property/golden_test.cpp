// Stored values from an exact evaluator written independently in another language: the library keeps its
// bounds against them, and the reference of these tests rounds to them exactly.
#include "reference/magnitudes.h"
#include "support/handle.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>

using namespace support;
using reference::eps;

namespace {

#ifdef NURBS_SOURCE_DIR
constexpr const char *source_dir = NURBS_SOURCE_DIR;
#else
constexpr const char *source_dir = nullptr;
#endif

// Words of a golden file; lines that start with # are comments. Streams do not read hexadecimal floats,
// strtod does.
class Words {
public:
    explicit Words(const std::string &path) {
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with('#')) {
                text_ << line << '\n';
            }
        }
    }
    bool next(std::string &word) { return static_cast<bool>(text_ >> word); }
    double number() {
        std::string word;
        EXPECT_TRUE(next(word)) << "the file ends early";
        char *end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        EXPECT_EQ(*end, '\0') << word;
        return value;
    }
    int whole() { return static_cast<int>(number()); }
    std::vector<double> numbers(int64_t n) {
        std::vector<double> values(static_cast<size_t>(n));
        for (double &x : values) {
            x = number();
        }
        return values;
    }

private:
    std::stringstream text_;
};

SplineData read_spline(Words &words) {
    SplineData data;
    const int axes = words.whole();
    data.dim = words.whole();
    const bool rational = words.whole() != 0;
    for (int k = 0; k < axes; ++k) {
        data.degrees.push_back(words.whole());
    }
    for (int k = 0; k < axes; ++k) {
        data.counts.push_back(words.whole());
    }
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        data.knots.push_back(words.numbers(data.counts[k] + data.degrees[k] + 1));
    }
    data.points = words.numbers(data.point_count() * data.dim);
    data.weights = words.numbers(rational ? data.point_count() : 0);
    return data;
}

void check_place(const SplineData &data, Words &words) {
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
    Words words(std::string(source_dir) + "/tests/golden/" + name);
    SplineData data;
    int places = 0;
    for (std::string word; words.next(word);) {
        ASSERT_TRUE(word == "spline" || word == "at") << word;
        if (word == "spline") {
            data = read_spline(words);
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

} // namespace
