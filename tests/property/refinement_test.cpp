// Lists of knots inserted at once: every control point against its exact value, the matrix that does it, and
// the laws that lists obey.
#include "property/same_shape.h"
#include "reference/definition.h"

#include <iterator>
#include <limits>

namespace refinement_test {

using namespace support;

namespace {

Handle refine(const nurbs *g, int axis, const std::vector<double> &knots) {
    nurbs *out = nullptr;
    require_ok(nurbs_refine(g, axis, static_cast<int64_t>(knots.size()), knots.data(), &out));
    return Handle(out);
}

int64_t copies(const std::vector<double> &knots, double knot) {
    return std::count(knots.begin(), knots.end(), knot);
}

// The knot that stands for all its copies on a periodic axis.
double first_copy(const SplineData &data, int axis, double knot) {
    return data.periodic(axis) && knot == data.upper(axis) ? data.lower(axis) : knot;
}

// Up to `most` knots in no order, some of them several times, as often as there is room for.
std::vector<double> random_list(Random &random, const SplineData &data, int axis, int most) {
    const auto k = static_cast<size_t>(axis);
    std::vector<double> list;
    for (int i = random.whole(1, most); i > 0; --i) {
        const double knot = first_copy(data, axis, random_new_knot(random, data, axis));
        const int64_t room = data.degrees[k] + 1 - copies(data.knots[k], knot) - copies(list, knot);
        const int times = random.chance(70) ? 1 : random.whole(1, data.degrees[k] + 1);
        list.insert(list.end(),
                    static_cast<size_t>(std::clamp<int64_t>(times, 0, std::max<int64_t>(room, 0))), knot);
    }
    for (size_t i = list.size(); i > 1; --i) {
        std::swap(list[i - 1], list[random.bits() % i]);
    }
    return list;
}

// Arguments of new control point j that are not old knots: its steps.
int64_t steps_of(const std::vector<double> &old, const std::vector<double> &fine, int64_t j, int degree) {
    const auto from = fine.begin() + j + 1;
    std::vector<double> rest;
    std::set_difference(from, from + degree, old.begin(), old.end(), std::back_inserter(rest));
    return std::ssize(rest);
}

// 2 eps of the largest old control point that can contribute for each step, and half an eps each for the
// products with the weights and their rounding when rational.
TEST(Refinement, control_points_are_exact_to_two_eps_a_step) {
    WorstErrors worst("refined control points by degree, unit eps * hull * steps");
    for_each_case(190000, 700, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        auto recipe = open_recipe(random, axes, axes == 1 ? 9 : 3);
        recipe.dim = 1;
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, axes - 1);
        const auto k = static_cast<size_t>(axis);
        const auto list = random_list(random, data, axis, 8);
        const auto g = create(data);
        const auto refined = refine(g.get(), axis, list);
        const auto got = read_back(refined.get());
        std::vector<double> fine = data.knots[k];
        fine.insert(fine.end(), list.begin(), list.end());
        std::sort(fine.begin(), fine.end());
        ASSERT_TRUE(same_bits(got.knots[k], fine)) << where(seed, data) << hex(list);
        const auto want = reference::defined_refinement(data, axis, fine);
        const Layers before(data, axis), after(got, axis);
        const auto old_points = homogeneous_points(g.get()), new_points = homogeneous_points(refined.get());
        for (int64_t o = 0; o < after.outer; ++o) {
            for (int64_t j = 0; j < after.count; ++j) {
                const int64_t steps = steps_of(data.knots[k], fine, j, data.degrees[k]);
                for (int64_t i = 0; i < after.inner; ++i) {
                    const int64_t place = after.place(o, j, i);
                    const auto &exact = want[static_cast<size_t>(place)];
                    for (size_t c = 0; c < exact.size(); ++c) {
                        double hull = 0;
                        for (int64_t from = 0; from < before.count; ++from) {
                            const auto f = static_cast<size_t>(from), t = static_cast<size_t>(j);
                            const auto wide = static_cast<size_t>(data.degrees[k]) + 1;
                            if (data.knots[k][f] <= fine[t] && data.knots[k][f + wide] >= fine[t + wide]) {
                                const auto at = static_cast<size_t>(before.place(o, from, i)) * 2 + c;
                                hull = std::max(hull, std::fabs(old_points[at]));
                            }
                        }
                        const double value = new_points[static_cast<size_t>(place) * 2 + c];
                        const long double error =
                            reference::error_ratio(value, reference::fraction(exact[c]), eps * hull);
                        const long double bound = 2 * steps + (data.rational() ? 1 : 0);
                        worst.add(data.degrees[k], bound > 0 ? error / bound : error,
                                  steps > 0 ? error / steps : error);
                        ASSERT_LE(error, bound) << where(seed, data) << hex(list) << " axis " << axis
                                                << " layer " << j << " component " << c;
                    }
                }
            }
        }
    });
}

// So many control points that they are made in parts: refined, elevated and in pieces.
TEST(Refinement, long_curves_keep_their_shape) {
    for_each_case(196000, 6, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 4);
        recipe.axes[0].degree = random.whole(1, 4);
        recipe.axes[0].spans = 5000;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].placement = Placement::origin;
        recipe.dim = random.whole(1, 4);
        recipe.weights = seed % 2 == 0 ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const long double steps = 2 * (data.degrees[0] + 1);
        nurbs *made = nullptr;
        require_ok(nurbs_refine_uniform(g.get(), 0, 2, &made));
        expect_same_shape(g.get(), Handle(made).get(), steps, random, where(seed, data));
        require_ok(nurbs_elevate(g.get(), 0, 1, &made));
        expect_same_shape(g.get(), Handle(made).get(), steps, random, where(seed, data));
        nurbs_list *list = nullptr;
        require_ok(nurbs_decompose(g.get(), &list));
        const std::unique_ptr<nurbs_list, decltype(&nurbs_list_destroy)> pieces(list, nurbs_list_destroy);
        int64_t count = 0;
        require_ok(nurbs_list_count(list, &count));
        const int64_t parted = 4096 / (data.degrees[0] + 1); // pieces made at once
        for (const int64_t i : {int64_t{0}, parted - 1, parted, parted + 1, count - 1}) {
            require_ok(nurbs_list_get(list, i, &made));
            expect_same_shape(g.get(), Handle(made).get(), steps, random, where(seed, data));
        }
    });
}

// Clamped, unclamped and periodic alike; on a short period every knot has several copies.
TEST(Refinement, the_shape_does_not_move) {
    for_each_case(191000, 700, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 5 - axes);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = Spacing::few_bits;
            axis.placement = Placement::origin;
        }
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, axes - 1);
        const auto k = static_cast<size_t>(axis);
        std::vector<double> list;
        for (const double t : random_list(random, data, axis, 12)) {
            const double rounded = std::ldexp(std::floor(std::ldexp(t, 10)), -10);
            const double knot = rounded >= data.lower(axis) ? rounded : t;
            if (copies(data.knots[k], knot) + copies(list, knot) <= data.degrees[k] &&
                knot < data.upper(axis)) {
                list.push_back(knot);
            }
        }
        long double moved = 2 * (data.degrees[k] + 1);
        for (const double knot : list) {
            moved = std::max(moved, moved + wrapping(data, axis, knot));
        }
        const auto g = create(data);
        const auto refined = refine(g.get(), axis, list);
        expect_same_shape(g.get(), refined.get(), moved, random, where(seed, data) + hex(list));
        const auto got = read_back(refined.get());
        ASSERT_EQ(got.flags, data.flags) << where(seed, data);
        ASSERT_EQ(got.counts[k], data.counts[k] + std::ssize(list)) << where(seed, data) << hex(list);
        Handle again; // wrapped layers and knots pass every check of the constructor
        ASSERT_EQ(try_create(got, again), NURBS_OK) << where(seed, data) << hex(list) << last_error();
    });
}

TEST(Refinement, the_order_of_the_list_does_not_matter) {
    for_each_case(192000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, open_recipe(random, random.whole(1, 2), 5));
        auto list = random_list(random, data, 0, 10);
        const auto g = create(data);
        const auto mixed = read_back(refine(g.get(), 0, list).get());
        std::sort(list.begin(), list.end(), std::greater<>());
        const auto falling = read_back(refine(g.get(), 0, list).get());
        ASSERT_TRUE(same_bits(mixed.points, falling.points)) << where(seed, data) << hex(list);
        ASSERT_TRUE(same_bits(mixed.weights, falling.weights)) << where(seed, data) << hex(list);
    });
}

struct Matrix {
    std::vector<double> values;
    std::vector<int64_t> columns, rows;
};

Matrix matrix_of(const nurbs *g, int axis, const std::vector<double> &list, int64_t rows) {
    const auto count = static_cast<int64_t>(list.size());
    int64_t entries = 0;
    require_ok(nurbs_refinement_matrix(g, axis, count, list.data(), 0, nullptr, nullptr, nullptr, &entries));
    Matrix m{std::vector<double>(static_cast<size_t>(entries)),
             std::vector<int64_t>(static_cast<size_t>(entries)),
             std::vector<int64_t>(static_cast<size_t>(rows + 1))};
    require_ok(nurbs_refinement_matrix(g, axis, count, list.data(), entries, m.values.data(),
                                       m.columns.data(), m.rows.data(), nullptr));
    return m;
}

TEST(Refinement, the_matrix_is_convex_and_makes_the_points) {
    for_each_case(193000, 700, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 9);
        recipe.weights = Weights::none;
        recipe.dim = 1;
        const auto data = random_spline(random, recipe);
        const auto list = random_list(random, data, 0, 8);
        const auto g = create(data);
        nurbs *out = nullptr;
        const nurbs_status status =
            nurbs_refine(g.get(), 0, static_cast<int64_t>(list.size()), list.data(), &out);
        const Handle refined(out);
        ASSERT_TRUE(status == NURBS_OK || (data.periodic(0) && status == NURBS_ERROR_PERIODIC_KNOTS));
        if (status != NURBS_OK) {
            return;
        }
        const auto got = read_back(refined.get());
        const Matrix m = matrix_of(g.get(), 0, list, got.counts[0]);
        ASSERT_EQ(m.rows.back(), std::ssize(m.values));
        for (int64_t r = 0; r < got.counts[0]; ++r) {
            const auto first = static_cast<size_t>(m.rows[static_cast<size_t>(r)]);
            const auto end = static_cast<size_t>(m.rows[static_cast<size_t>(r) + 1]);
            ASSERT_TRUE(end > first && end - first <= static_cast<size_t>(data.degrees[0]) + 1);
            double sum = 0, point = 0, size = 0;
            for (size_t e = first; e < end; ++e) {
                const auto column = static_cast<size_t>(m.columns[e]);
                ASSERT_TRUE(m.values[e] >= 0 && m.values[e] <= 1) << where(seed, data) << hex(list);
                ASSERT_TRUE(e == first || m.columns[e] == m.columns[e - 1] + 1);
                sum += m.values[e];
                point += m.values[e] * data.points[column];
                size = std::max(size, std::fabs(data.points[column]));
            }
            ASSERT_LE(std::fabs(sum - 1), static_cast<double>(end - first) * 0x1p-52)
                << where(seed, data) << hex(list);
            ASSERT_LE(std::fabs(point - got.points[static_cast<size_t>(r)]), 0x1p-52 * size * 4)
                << where(seed, data);
        }
    });
}

TEST(Refinement, uniform_parts_are_equal) {
    for_each_case(194000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, random.whole(1, 2), 4);
        recipe.axes[0].spacing = Spacing::few_bits;
        recipe.axes[0].placement = Placement::origin;
        const auto data = random_spline(random, recipe);
        const int64_t parts = int64_t{1} << random.whole(0, 3);
        nurbs *out = nullptr;
        require_ok(nurbs_refine_uniform(create(data).get(), 0, parts, &out));
        const Handle refined(out);
        const auto got = read_back(out);
        std::vector<double> want = data.knots[0];
        for (size_t i = static_cast<size_t>(data.degrees[0]); i < static_cast<size_t>(data.counts[0]); ++i) {
            const double a = data.knots[0][i], b = data.knots[0][i + 1];
            for (int64_t part = 1; a < b && part < parts; ++part) { // exact, by powers of two
                want.push_back(a + (b - a) * static_cast<double>(part) / static_cast<double>(parts));
            }
        }
        std::sort(want.begin(), want.end());
        ASSERT_TRUE(same_bits(got.knots[0], want)) << where(seed, data) << parts;
        expect_same_shape(create(data).get(), out, 2 * (data.degrees[0] + 1), random, where(seed, data));
    });
}

// The entry that is one too many is named, whatever the order.
TEST(Refinement, a_knot_too_many_is_named) {
    for_each_case(195000, 100, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, 1, 5));
        const double knot = first_copy(data, 0, random_new_knot(random, data, 0));
        const int64_t room = data.degrees[0] + 1 - copies(data.knots[0], knot);
        const std::vector<double> list(static_cast<size_t>(room + 1), knot);
        const auto g = create(data);
        nurbs *out = g.get();
        ASSERT_EQ(nurbs_refine(g.get(), 0, room + 1, list.data(), &out), NURBS_ERROR_MULTIPLICITY)
            << where(seed, data);
        ASSERT_EQ(out, nullptr);
        ASSERT_NE(last_error().find("knots[" + std::to_string(room) + "]"), std::string::npos)
            << last_error();
    });
}

} // namespace

} // namespace refinement_test
