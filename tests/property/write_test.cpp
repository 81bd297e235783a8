// Models of random faces as files: they read back with the same shapes, and are written again as the same bytes.
#include "property/faces.h"
#include "property/models.h"
#include "support/generators.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace write_test {

using namespace support;
using namespace support::models;
using support::faces::Ground;
using support::faces::Place;

namespace {

constexpr int32_t formats[] = {NURBS_FORMAT_STEP, NURBS_FORMAT_IGES};

std::string written(const nurbs_model *model, int32_t format) {
    int64_t size = 0;
    require_ok(nurbs_model_write(model, format, nullptr, 0, nullptr, &size));
    std::string text(static_cast<size_t>(size), ' ');
    require_ok(nurbs_model_write(model, format, nullptr, size, text.data(), nullptr));
    return text;
}

struct Splines {
    Handle surface;
    std::vector<Handle> curves, edges;
};

Splines splines_of(const nurbs_model *model, int64_t index) {
    const Face face = face_of(model, index);
    Splines found;
    found.surface = made([&](nurbs **out) { return nurbs_face_surface(face.get(), out); });
    int64_t loops = 0;
    require_ok(nurbs_face_loops(face.get(), 0, nullptr, &loops));
    std::vector<int64_t> sizes(static_cast<size_t>(loops));
    require_ok(nurbs_face_loops(face.get(), loops, sizes.data(), nullptr));
    for (int64_t i = 0; i < loops; ++i) {
        for (int64_t j = 0; j < sizes[static_cast<size_t>(i)]; ++j) {
            found.curves.push_back(
                made([&](nurbs **out) { return nurbs_face_curve(face.get(), i, j, out); }));
            found.edges.push_back(
                made([&](nurbs **out) { return nurbs_face_edge(face.get(), i, j, nullptr, out); }));
        }
    }
    return found;
}

bool same(const Handle &a, const Handle &b) {
    return same_bits(homogeneous_points(a.get()), homogeneous_points(b.get()));
}

// Surfaces, edges and curves in domains, and all of it again.
void expect_again(const nurbs_model *model, int32_t format) {
    const std::string text = written(model, format);
    const Model again = read_model(text);
    EXPECT_EQ(notes_of(again.get()), std::vector<std::string>());
    ASSERT_EQ(counts_of(again.get()).faces, counts_of(model).faces);
    EXPECT_EQ(counts_of(again.get()).edges, counts_of(model).edges);
    for (int64_t i = 0; i < counts_of(model).faces; ++i) {
        const Splines before = splines_of(model, i), after = splines_of(again.get(), i);
        EXPECT_TRUE(same(before.surface, after.surface));
        ASSERT_EQ(before.curves.size(), after.curves.size());
        for (size_t k = 0; k < before.curves.size(); ++k) {
            EXPECT_TRUE(same(before.edges[k], after.edges[k])) << k;
            EXPECT_TRUE(same(before.curves[k], after.curves[k])) << k;
        }
    }
    EXPECT_TRUE(written(again.get(), format) == text);
}

Model model_of_one(const support::faces::Face &face) {
    return model_of({face.get()});
}

// A hole, or a few of them, in a patch; clamped, periodic and rational curves.
TEST(Write, patches_with_holes) {
    Random random(20);
    for (int i = 0; i < 20; ++i) {
        const Ground ground = support::faces::wavy(random);
        const Handle outer =
            support::faces::polygon({{0.02, 0.02}, {0.98, 0.02}, {0.98, 0.98}, {0.02, 0.98}});
        std::vector<Handle> holes;
        support::faces::Curves loops{{outer.get()}};
        for (int k = random.whole(0, 2); k >= 0; --k) {
            const support::faces::Star shape{random.whole(1, 4), random.chance(50), random.chance(30), 0.12};
            holes.push_back(create(star(random, ground, {0.2 + 0.3 * k, random.between(0.2, 0.8)}, shape)));
            loops.push_back({holes.back().get()});
        }
        SCOPED_TRACE(i);
        const support::faces::Face face = support::faces::face_of(ground.surface.get(), loops, 1e-7);
        const Model model = model_of_one(face);
        for (const int32_t format : formats) {
            const Model once = read_model(written(model.get(), format));
            EXPECT_EQ(counts_of(once.get()).faces, 1);
            EXPECT_NEAR(area_of(once.get(), 1e-9), area_of(model.get(), 1e-9), 1e-6);
            expect_again(once.get(), format);
        }
    }
}

// All of surfaces that close up, once or twice, with poles and without.
TEST(Write, whole_closed_surfaces) {
    const Ground grounds[] = {support::faces::sphere(2), support::faces::torus(3, 1),
                              support::faces::cylinder(1, 2), support::faces::plane(3)};
    for (const Ground &ground : grounds) {
        const support::faces::Face face = support::faces::face_of(ground.surface.get(), {});
        const Model model = model_of_one(face);
        const double area = area_of(model.get(), 1e-9);
        for (const int32_t format : formats) {
            const Model once = read_model(written(model.get(), format));
            EXPECT_NEAR(area_of(once.get(), 1e-9), area, 1e-8 * area);
            expect_again(once.get(), format);
        }
    }
}

// Knots, points and weights; equal weights, which cancel, are left out.
void expect_same_spline(const nurbs *a, const nurbs *b) {
    int32_t axes = 0, rational = 0;
    int64_t n = 0;
    require_ok(nurbs_axes(a, &axes));
    require_ok(nurbs_point_count(a, &n));
    require_ok(nurbs_is_rational(b, &rational));
    std::vector<double> values[2];
    size_t i = 0;
    for (const nurbs *g : {a, b}) {
        std::vector<double> &all = values[i++];
        for (int32_t k = 0; k < axes; ++k) {
            int64_t count = 0;
            require_ok(nurbs_count(g, k, &count));
            int32_t degree = 0;
            require_ok(nurbs_degree(g, k, &degree));
            std::vector<double> knots(static_cast<size_t>(count + degree + 1));
            require_ok(nurbs_knots(g, k, std::ssize(knots), knots.data()));
            all.insert(all.end(), knots.begin(), knots.end());
        }
        const size_t used = all.size();
        all.resize(used + static_cast<size_t>(3 * n));
        require_ok(nurbs_points(g, n, all.data() + used, 0, 0));
        std::vector<double> weights(static_cast<size_t>(n), 1.0);
        require_ok(nurbs_weights(g, n, weights.data(), 0));
        if (rational == 0) {
            EXPECT_EQ(std::count(weights.begin(), weights.end(), weights.front()), n);
        } else {
            all.insert(all.end(), weights.begin(), weights.end());
        }
    }
    EXPECT_TRUE(values[0] == values[1]);
}

// Random splines of a list, of any form that the formats have.
TEST(Write, lists_read_back_bit_for_bit) {
    Random random(21);
    for (int i = 0; i < 200; ++i) {
        std::vector<Handle> splines;
        std::vector<const nurbs *> given;
        for (int k = random.whole(0, 4); k >= 0; --k) {
            Recipe recipe = random_recipe(random, random.whole(1, 2), 4);
            recipe.dim = 3;
            for (AxisRecipe &axis : recipe.axes) {
                axis.degree = std::max(axis.degree, 1); // files have no steps
            }
            splines.push_back(create(random_spline(random, recipe)));
            given.push_back(splines.back().get());
        }
        nurbs_list *made_list = nullptr, *read_list = nullptr;
        require_ok(nurbs_list_create(std::ssize(given), given.data(), nullptr, 1, &made_list));
        const std::unique_ptr<nurbs_list, DestroyModel> list(made_list);
        int64_t size = 0;
        const int32_t format = formats[i % 2];
        require_ok(nurbs_list_write(made_list, format, nullptr, 0, nullptr, &size));
        std::string text(static_cast<size_t>(size), ' ');
        require_ok(nurbs_list_write(made_list, format, nullptr, size, text.data(), nullptr));
        require_ok(nurbs_read(text.data(), size, nullptr, &read_list));
        const std::unique_ptr<nurbs_list, DestroyModel> again(read_list);
        int64_t count = 0;
        require_ok(nurbs_list_count(read_list, &count));
        ASSERT_EQ(count, std::ssize(given));
        for (int64_t k = 0; k < count; ++k) {
            const Handle g = made([&](nurbs **out) { return nurbs_list_get(read_list, k, out); });
            SCOPED_TRACE(i);
            expect_same_spline(given[static_cast<size_t>(k)], g.get());
        }
    }
}

} // namespace

} // namespace write_test
