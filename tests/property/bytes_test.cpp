// Splines and lists as bytes: the same values, whatever they are, and any change is found.
#include "property/bytes.h"

namespace bytes_test {

using namespace support;

namespace {

struct DestroyList {
    void operator()(nurbs_list *list) const noexcept { nurbs_list_destroy(list); }
};
using List = std::unique_ptr<nurbs_list, DestroyList>;

Bytes bytes_of(const Handle &g) {
    return written(nurbs_to_bytes, g);
}
Bytes bytes_of(const List &list) {
    return written(nurbs_list_to_bytes, list);
}

nurbs_status read(const Bytes &bytes, Handle &out) {
    return read_bytes(nurbs_from_bytes, bytes, out);
}
nurbs_status read(const Bytes &bytes, List &out) {
    return read_bytes(nurbs_list_from_bytes, bytes, out);
}

// The same spline, stored homogeneous.
Handle homogeneous(const Handle &g) {
    return made([&](nurbs **out) { return nurbs_to_homogeneous(g.get(), out); });
}

Handle random_handle(Random &random) {
    Handle g = create(random_spline(random, random_recipe(random, random.whole(1, 3), 4)));
    int32_t rational = 0;
    require_ok(nurbs_is_rational(g.get(), &rational));
    return rational != 0 && random.chance(30) ? homogeneous(g) : std::move(g);
}

TEST(Bytes, splines_survive) {
    for_each_case(898000, 300, [](Random &random, uint64_t seed) {
        const Handle g = random_handle(random);
        const Bytes bytes = bytes_of(g);
        Handle copy;
        ASSERT_EQ(read(bytes, copy), NURBS_OK) << "seed " << seed << last_error();
        ASSERT_EQ(bytes_of(copy), bytes) << "seed " << seed;
        const SplineData before = read_back(g.get()), after = read_back(copy.get());
        ASSERT_EQ(after.degrees, before.degrees) << where(seed, before);
        ASSERT_EQ(after.counts, before.counts) << where(seed, before);
        ASSERT_EQ(after.flags, before.flags) << where(seed, before);
        ASSERT_TRUE(same_bits(after.all_knots(), before.all_knots())) << where(seed, before);
        ASSERT_TRUE(same_bits(after.points, before.points)) << where(seed, before);
        ASSERT_TRUE(same_bits(after.weights, before.weights)) << where(seed, before);
        ASSERT_TRUE(same_bits(homogeneous_points(copy.get()), homogeneous_points(g.get())))
            << where(seed, before);
        const auto params = random_params(random, before, 10);
        ASSERT_TRUE(same_bits(eval(copy.get(), params), eval(g.get(), params))) << where(seed, before);
        expect_every_change_found<Handle>(nurbs_from_bytes, random, seed, bytes);
    });
}

// 64 bytes and 16 for each axis, 8 for each number, and each part at a multiple of 64.
TEST(Bytes, have_the_size_that_is_promised) {
    for_each_case(899000, 100, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 4));
        const size_t parts = data.rational() ? 3 : 2;
        const size_t numbers = data.all_knots().size() + data.points.size() + data.weights.size();
        const size_t least = 64 + 16 * data.degrees.size() + 8 * numbers;
        const size_t size = bytes_of(create(data)).size();
        ASSERT_GE(size, least) << where(seed, data);
        ASSERT_LT(size, least + 64 * parts) << where(seed, data);
    });
}

// Other values have other bytes: a copy with one more unit in the last place.
TEST(Bytes, tell_splines_apart) {
    for_each_case(899500, 100, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.form = KnotForm::clamped;
        }
        auto data = random_spline(random, recipe);
        const Bytes bytes = bytes_of(create(data));
        double &value = data.points[random.bits() % data.points.size()];
        value = std::nextafter(value, 2 * std::abs(value) + 1);
        ASSERT_NE(bytes_of(create(data)), bytes) << where(seed, data);
    });
}

List random_list(Random &random, std::vector<Handle> &splines, std::vector<std::string> &names) {
    std::vector<const nurbs *> handles;
    std::vector<const char *> texts;
    for (int n = random.whole(0, 6); n > 0; --n) {
        splines.push_back(splines.empty() || random.chance(60)
                              ? random_handle(random)
                              : made([&](nurbs **out) { return nurbs_clone(splines.front().get(), out); }));
        names.push_back(std::string(static_cast<size_t>(random.whole(0, 90)), 'a') + std::to_string(n));
    }
    for (size_t i = 0; i < splines.size(); ++i) {
        handles.push_back(splines[i].get());
        texts.push_back(names[i].c_str());
    }
    nurbs_list *list = nullptr;
    require_ok(nurbs_list_create(std::ssize(handles), handles.data(), texts.data(), random.unit(), &list));
    return List(list);
}

TEST(Bytes, lists_survive) {
    for_each_case(900500, 100, [](Random &random, uint64_t seed) {
        std::vector<Handle> splines;
        std::vector<std::string> names;
        const List list = random_list(random, splines, names);
        const Bytes bytes = bytes_of(list);
        List copy;
        ASSERT_EQ(read(bytes, copy), NURBS_OK) << "seed " << seed << last_error();
        ASSERT_EQ(bytes_of(copy), bytes) << "seed " << seed;
        for (size_t i = 0; i < splines.size(); ++i) {
            const auto index = static_cast<int64_t>(i);
            char text[128];
            require_ok(nurbs_list_name(copy.get(), index, text, sizeof text, nullptr));
            ASSERT_EQ(text, names[i]) << "seed " << seed;
            const Handle g = made([&](nurbs **out) { return nurbs_list_get(copy.get(), index, out); });
            ASSERT_EQ(bytes_of(g), bytes_of(splines[i])) << "seed " << seed;
        }
        expect_every_change_found<List>(nurbs_list_from_bytes, random, seed, bytes);
    });
}

} // namespace
} // namespace bytes_test
