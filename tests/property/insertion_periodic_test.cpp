// Knot insertion on periodic axes: the result is periodic again, over the same domain, with wrapped points
// equal bit for bit.
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace insertion_periodic_test {

using namespace support;

namespace {

SplineData periodic_spline(Random &random, int axis, int axes) {
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 3);
    recipe.axes[static_cast<size_t>(axis)].form = KnotForm::periodic;
    return random_spline(random, recipe);
}

// The records of a layer of an axis, in their order.
std::vector<double> layer_of(const SplineData &data, const std::vector<double> &values, int width, int axis,
                             int64_t layer) {
    int64_t inner = width;
    int64_t outer = 1;
    for (int k = 0; k < data.axes(); ++k) {
        (k < axis ? outer : inner) *= k == axis ? 1 : data.counts[static_cast<size_t>(k)];
    }
    std::vector<double> records;
    for (int64_t o = 0; o < outer; ++o) {
        const auto from = values.begin() + (o * data.counts[static_cast<size_t>(axis)] + layer) * inner;
        records.insert(records.end(), from, from + inner);
    }
    return records;
}

void expect_wrapped(const SplineData &data, const nurbs *g, int axis, const std::string &place) {
    const auto k = static_cast<size_t>(axis);
    const int64_t distinct = data.counts[k] - data.degrees[k];
    const auto records = homogeneous_points(g);
    for (int64_t layer = 0; layer < data.degrees[k]; ++layer) {
        ASSERT_TRUE(same_bits(layer_of(data, data.points, data.dim, axis, layer),
                              layer_of(data, data.points, data.dim, axis, layer + distinct)))
            << place << " layer " << layer;
        ASSERT_TRUE(same_bits(layer_of(data, records, data.dim + 1, axis, layer),
                              layer_of(data, records, data.dim + 1, axis, layer + distinct)))
            << place << " layer " << layer;
    }
}

// Knots repeat with the period to within the rounding of the largest of them.
void expect_periodic_knots(const SplineData &data, int axis, const std::string &place) {
    const auto &t = data.knots[static_cast<size_t>(axis)];
    const auto k = static_cast<size_t>(axis);
    const auto distinct = static_cast<size_t>(data.counts[k] - data.degrees[k]);
    const long double period = static_cast<long double>(data.upper(axis)) - data.lower(axis);
    const long double size = std::max(std::fabs(t.front()), std::fabs(t.back()));
    for (size_t i = 0; i + distinct < t.size(); ++i) {
        ASSERT_LE(std::fabs(t[i + distinct] - t[i] - period), 4 * 0x1p-52L * size) << place;
    }
}

TEST(PeriodicInsertion, stays_periodic) {
    for_each_case(96000, 1000, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const int axis = random.whole(0, axes - 1);
        const auto data = periodic_spline(random, axis, axes);
        const auto k = static_cast<size_t>(axis);
        const double knot = random_new_knot(random, data, axis);
        const bool end = knot == data.upper(axis); // the end of the domain is its start
        const double place_of = end ? data.lower(axis) : knot;
        const auto present = std::count(data.knots[k].begin(), data.knots[k].end(), place_of);
        const int room = data.degrees[k] + 1 - static_cast<int>(present);
        const int times = random.whole(0, std::max(room, 0));
        const auto g = create(data);
        const auto refined = insert(g.get(), axis, knot, times);
        const auto got = read_back(refined.get());
        const std::string place = where(seed, data) + "axis " + std::to_string(axis) + " knot " + hex(knot) +
                                  " times " + std::to_string(times);
        ASSERT_EQ(got.flags, data.flags) << place;
        ASSERT_EQ(got.counts[k], data.counts[k] + times) << place;
        ASSERT_TRUE(same_bits(got.lower(axis), data.lower(axis))) << place;
        ASSERT_TRUE(same_bits(got.upper(axis), data.upper(axis))) << place;
        ASSERT_EQ(std::count(got.knots[k].begin(), got.knots[k].end(), place_of), present + times) << place;
        expect_wrapped(got, refined.get(), axis, place);
        expect_periodic_knots(got, axis, place);
        Handle again;
        ASSERT_EQ(try_create(got, again), NURBS_OK) << place << describe(got) << last_error();
    });
}

// A new knot within rounding of another one: inserted, or refused because the two fall together one period
// away.
TEST(PeriodicInsertion, next_to_a_knot) {
    for_each_case(98000, 500, [](Random &random, uint64_t seed) {
        const auto data = periodic_spline(random, 0, 1);
        const double knot = data.knots[0][random.bits() % data.knots[0].size()];
        const double beside =
            std::nextafter(std::clamp(knot, data.lower(0), data.upper(0)), random.between(-1, 1));
        if (beside < data.lower(0) || beside > data.upper(0)) {
            return;
        }
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_insert_knot(create(data).get(), 0, beside, 1, &out);
        const Handle refined(out);
        ASSERT_TRUE(status == NURBS_OK || status == NURBS_ERROR_PERIODIC_KNOTS)
            << where(seed, data) << last_error();
        ASSERT_EQ(out != nullptr, status == NURBS_OK);
        if (out != nullptr) {
            expect_wrapped(read_back(out), out, 0, where(seed, data) + hex(beside));
        }
    });
}

// The end of the domain is its start: the same bits whichever is named.
TEST(PeriodicInsertion, both_ends_are_one_knot) {
    for_each_case(97000, 500, [](Random &random, uint64_t seed) {
        const auto data = periodic_spline(random, 0, 1);
        const auto present = std::count(data.knots[0].begin(), data.knots[0].end(), data.lower(0));
        const int times = random.whole(0, data.degrees[0] + 1 - static_cast<int>(present));
        const auto g = create(data);
        const auto start = read_back(insert(g.get(), 0, data.lower(0), times).get());
        const auto end = read_back(insert(g.get(), 0, data.upper(0), times).get());
        ASSERT_TRUE(same_bits(start.knots[0], end.knots[0])) << where(seed, data);
        ASSERT_TRUE(same_bits(start.points, end.points)) << where(seed, data);
        ASSERT_TRUE(same_bits(start.weights, end.weights)) << where(seed, data);
    });
}

} // namespace

} // namespace insertion_periodic_test
