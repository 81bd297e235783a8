// Splines cut into parts and joined again, ends clamped, seams moved: the shape never moves.
#include "property/same_shape.h"

#include <cstring>
#include <functional>
#include <numeric>

namespace parts_test {

using namespace support;

namespace {

struct DestroyList {
    void operator()(nurbs_list *list) const noexcept { nurbs_list_destroy(list); }
};

std::vector<Handle> handles_of(nurbs_list *owned) {
    const std::unique_ptr<nurbs_list, DestroyList> list(owned);
    int64_t count = 0;
    require_ok(nurbs_list_count(owned, &count));
    std::vector<Handle> handles;
    for (int64_t i = 0; i < count; ++i) {
        nurbs *g = nullptr;
        require_ok(nurbs_list_get(owned, i, &g));
        handles.emplace_back(g);
    }
    return handles;
}

std::vector<Handle> decompose(const nurbs *g) {
    nurbs_list *list = nullptr;
    require_ok(nurbs_decompose(g, &list));
    return handles_of(list);
}

struct PieceArrays {
    int64_t count = 0;
    std::vector<double> points, weights, domains;
    std::vector<int64_t> along;
};

PieceArrays arrays_of(const nurbs *g) {
    PieceArrays all;
    int32_t axes = 0, dim = 0;
    require_ok(nurbs_axes(g, &axes));
    require_ok(nurbs_dimension(g, &dim));
    int64_t points = 1;
    for (int k = 0; k < axes; ++k) {
        int32_t degree = 0;
        require_ok(nurbs_degree(g, k, &degree));
        points *= degree + 1;
    }
    all.along.resize(static_cast<size_t>(axes));
    require_ok(nurbs_bezier_pieces(g, 0, nullptr, nullptr, nullptr, all.along.data(), &all.count));
    all.points.resize(static_cast<size_t>(all.count * points * dim));
    all.weights.resize(static_cast<size_t>(all.count * points));
    all.domains.resize(static_cast<size_t>(all.count * axes * 2));
    require_ok(nurbs_bezier_pieces(g, all.count, all.points.data(), all.weights.data(), all.domains.data(),
                                   nullptr, &all.count));
    EXPECT_EQ(std::accumulate(all.along.begin(), all.along.end(), int64_t{1}, std::multiplies<>()),
              all.count);
    return all;
}

std::pair<std::vector<double>, std::vector<double>> stored_by(const nurbs *g) {
    int64_t count = 0;
    int32_t dim = 0;
    require_ok(nurbs_point_count(g, &count));
    require_ok(nurbs_dimension(g, &dim));
    std::vector<double> points(static_cast<size_t>(count * dim)), weights(static_cast<size_t>(count));
    require_ok(nurbs_points(g, count, points.data(), 0, 0));
    require_ok(nurbs_weights(g, count, weights.data(), 0));
    return {points, weights};
}

// Those of `all` from `at` on, which moves behind them.
void expect_bits(const std::vector<double> &expected, const std::vector<double> &all, size_t &at,
                 const std::string &where) {
    ASSERT_LE(at + expected.size(), all.size()) << where;
    EXPECT_EQ(std::memcmp(expected.data(), all.data() + at, sizeof(double) * expected.size()), 0) << where;
    at += expected.size();
}

std::vector<Handle> split_at_knots(const nurbs *g, int axis, int order) {
    nurbs_list *list = nullptr;
    require_ok(nurbs_split_at_knots(g, axis, order, &list));
    return handles_of(list);
}

std::vector<Handle> split(const nurbs *g, int axis, double t) {
    nurbs *below = nullptr, *above = nullptr;
    require_ok(nurbs_split(g, axis, t, &below, &above));
    std::vector<Handle> parts;
    parts.emplace_back(below);
    parts.emplace_back(above);
    return parts;
}

nurbs_status try_join(const std::vector<Handle> &parts, int axis, double tolerance, uint32_t flags,
                      double &gap, Handle &out) {
    std::vector<const nurbs *> handles;
    for (const Handle &part : parts) {
        handles.push_back(part.get());
    }
    nurbs *joined = nullptr;
    const nurbs_status status = nurbs_join(static_cast<int64_t>(handles.size()), handles.data(), axis,
                                           tolerance, flags, &gap, &joined);
    out.reset(joined);
    return status;
}

// A parameter strictly inside an axis' domain, often a knot; NaN if there is none.
double inner_param(Random &random, const SplineData &data, int axis) {
    for (int i = 0; i < 20; ++i) {
        const double t = random_param(random, data.knots[static_cast<size_t>(axis)],
                                      data.degrees[static_cast<size_t>(axis)]);
        if (t > data.lower(axis) && t < data.upper(axis)) {
            return t;
        }
    }
    return std::nan("");
}

SplineData random_case(Random &random) {
    const int axes = random.whole(1, 3);
    return random_spline(random, random_recipe(random, axes, axes == 1 ? 9 : 5 - axes));
}

// A part against the whole: every control point of a part is a row of at most degree steps on each axis.
void expect_part(const nurbs *whole, const nurbs *part, Random &random, const std::string &place) {
    const auto data = read_back(part);
    long double moved = 0;
    for (const int32_t p : data.degrees) {
        moved += 2 * p;
    }
    expect_same_shape(whole, part, moved + 1, random, place);
}

bool clamped(const nurbs *g, int axis, int32_t end) {
    int32_t form = 0;
    require_ok(nurbs_knot_form(g, axis, &form));
    return (form & end) != 0;
}

TEST(Parts, a_split_keeps_both_sides) {
    for_each_case(200000, 600, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        const int axis = random.whole(0, data.axes() - 1);
        const double t = inner_param(random, data, axis);
        if (std::isnan(t)) {
            return;
        }
        const auto g = create(data);
        const std::vector<Handle> parts = split(g.get(), axis, t);
        const nurbs *const below = parts[0].get(), *const above = parts[1].get();
        const auto l = read_back(below), u = read_back(above);
        const std::string place = where(seed, data) + " split at " + hex(t);
        ASSERT_TRUE(l.upper(axis) == t && u.lower(axis) == t) << place;
        ASSERT_TRUE(l.lower(axis) == data.lower(axis) && u.upper(axis) == data.upper(axis)) << place;
        ASSERT_TRUE(clamped(below, axis, NURBS_FORM_CLAMPED_END) &&
                    clamped(above, axis, NURBS_FORM_CLAMPED_START));
        expect_part(g.get(), below, random, place + " below");
        expect_part(g.get(), above, random, place + " above");
    });
}

TEST(Parts, split_parts_join_again) {
    for_each_case(201000, 600, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        const int axis = random.whole(0, data.axes() - 1);
        const auto k = static_cast<size_t>(axis);
        const double t = inner_param(random, data, axis);
        if (std::isnan(t)) {
            return;
        }
        const auto g = create(data);
        std::vector<Handle> parts = split(g.get(), axis, t);
        Handle joined;
        double gap = -1;
        const bool jump = std::count(data.knots[k].begin(), data.knots[k].end(), t) > data.degrees[k];
        const nurbs_status status = try_join(parts, axis, 0, jump ? NURBS_KEEP_GAPS : 0, gap, joined);
        ASSERT_EQ(status, NURBS_OK) << where(seed, data) << hex(t) << last_error();
        ASSERT_TRUE(jump || gap == 0) << where(seed, data);
        const auto got = read_back(joined.get());
        ASSERT_EQ(got.lower(axis), data.lower(axis));
        ASSERT_EQ(got.upper(axis), data.upper(axis));
        if (data.degrees[k] > 0 && !jump) {
            ASSERT_EQ(std::count(got.knots[k].begin(), got.knots[k].end(), t), data.degrees[k])
                << where(seed, data);
        }
        expect_part(g.get(), joined.get(), random, where(seed, data) + hex(t));
    });
}

TEST(Parts, an_extract_is_a_part) {
    for_each_case(202000, 600, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        std::vector<double> lower, upper;
        for (int k = 0; k < data.axes(); ++k) {
            double a = random_params(random, data, 1)[static_cast<size_t>(k)];
            double b = random_params(random, data, 1)[static_cast<size_t>(k)];
            if (a == b) {
                a = data.lower(k);
                b = data.upper(k);
            }
            lower.push_back(std::min(a, b));
            upper.push_back(std::max(a, b));
        }
        const auto g = create(data);
        nurbs *out = nullptr;
        require_ok(nurbs_extract(g.get(), lower.data(), upper.data(), &out));
        const Handle part(out);
        const auto got = read_back(out);
        for (int k = 0; k < data.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            ASSERT_TRUE(got.lower(k) == lower[at] && got.upper(k) == upper[at]) << where(seed, data);
            const bool whole = lower[at] == data.lower(k) && upper[at] == data.upper(k);
            ASSERT_EQ(got.periodic(k), data.periodic(k) && whole) << where(seed, data);
        }
        expect_part(g.get(), out, random, where(seed, data) + hex(lower) + hex(upper));
    });
}

TEST(Parts, pieces_are_bezier_in_their_order) {
    for_each_case(203000, 400, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        const auto g = create(data);
        const auto pieces = decompose(g.get());
        std::vector<std::vector<double>> breaks;
        size_t total = 1;
        for (int k = 0; k < data.axes(); ++k) {
            breaks.push_back(data.knots[static_cast<size_t>(k)]);
            auto &b = breaks.back();
            b.erase(std::unique(b.begin(), b.end()), b.end());
            std::erase_if(b, [&](double t) { return t < data.lower(k) || t > data.upper(k); });
            total *= b.size() - 1;
        }
        ASSERT_EQ(pieces.size(), total) << where(seed, data);
        for (size_t i = 0; i < total; ++i) {
            const auto piece = read_back(pieces[i].get());
            size_t rest = i;
            for (int k = data.axes(); k-- > 0;) {
                const auto &b = breaks[static_cast<size_t>(k)];
                ASSERT_EQ(piece.counts[static_cast<size_t>(k)], data.degrees[static_cast<size_t>(k)] + 1);
                ASSERT_EQ(piece.lower(k), b[rest % (b.size() - 1)]) << where(seed, data);
                ASSERT_EQ(piece.upper(k), b[rest % (b.size() - 1) + 1]) << where(seed, data);
                rest /= b.size() - 1;
            }
        }
        expect_part(g.get(), pieces[random.bits() % total].get(), random, where(seed, data));
    });
}

// The same bits as the splines of the list, whatever the form.
TEST(Parts, arrays_hold_the_bits_of_the_pieces) {
    for_each_case(206000, 400, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        const auto g = create(data);
        const auto pieces = decompose(g.get());
        const PieceArrays all = arrays_of(g.get());
        ASSERT_EQ(std::ssize(pieces), all.count) << where(seed, data);
        size_t point = 0, weight = 0, domain = 0;
        for (const Handle &piece : pieces) {
            const auto [points, weights] = stored_by(piece.get());
            expect_bits(points, all.points, point, where(seed, data));
            expect_bits(weights, all.weights, weight, where(seed, data));
            for (int k = 0; k < data.axes(); ++k, domain += 2) {
                double ends[2];
                require_ok(nurbs_domain(piece.get(), k, ends));
                ASSERT_EQ(ends[0], all.domains[domain]) << where(seed, data);
                ASSERT_EQ(ends[1], all.domains[domain + 1]) << where(seed, data);
            }
        }
        ASSERT_EQ(point, all.points.size()) << where(seed, data);
    });
}

// Whatever the degrees to which the parts have been raised, along the axis and across it.
TEST(Parts, of_different_degrees_join_at_the_highest) {
    for_each_case(205000, 300, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const auto data = random_spline(random, open_recipe(random, axes, axes == 1 ? 6 : 2));
        const int axis = random.whole(0, axes - 1);
        const double t = inner_param(random, data, axis);
        if (std::isnan(t)) {
            return;
        }
        const auto g = create(data);
        std::vector<Handle> parts = split(g.get(), axis, t);
        std::vector<int32_t> degrees = data.degrees;
        const bool across = random.chance(50);
        for (int k = 0; k < axes; ++k) {
            int most = 0;
            for (Handle &part : parts) {
                const int times = k == axis || across ? random.whole(0, 2) : 0;
                part = elevate(part.get(), k, times);
                most = std::max(most, times);
            }
            degrees[static_cast<size_t>(k)] += most;
        }
        Handle joined;
        double gap = -1;
        const nurbs_status status = try_join(parts, axis, 0, NURBS_KEEP_GAPS, gap, joined);
        const std::string place = where(seed, data) + hex(t) + std::to_string(axis);
        if (status == NURBS_ERROR_INCOMPATIBLE || status == NURBS_ERROR_MULTIPLICITY) {
            ASSERT_TRUE(across) << place
                                << last_error(); // raised in other ways, knots beyond the ends differ
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << place << last_error();
        const auto got = read_back(joined.get());
        ASSERT_EQ(got.degrees, degrees) << place;
        const auto k = static_cast<size_t>(axis);
        const bool jump = std::count(data.knots[k].begin(), data.knots[k].end(), t) > data.degrees[k];
        ASSERT_TRUE(across || jump || gap == 0) << place;
        ASSERT_TRUE(got.lower(axis) == data.lower(axis) && got.upper(axis) == data.upper(axis)) << place;
        long double moved = 1;
        for (const int32_t p : got.degrees) {
            moved += 2 * p + 8;
        }
        expect_same_shape(g.get(), joined.get(), moved, random, place);
    });
}

TEST(Parts, pieces_of_a_curve_join_again) {
    for_each_case(204000, 400, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, 1, 9));
        const auto g = create(data);
        const auto pieces = decompose(g.get());
        Handle joined;
        double gap = -1;
        ASSERT_EQ(try_join(pieces, 0, 0, NURBS_KEEP_GAPS, gap, joined), NURBS_OK)
            << where(seed, data) << last_error();
        const auto got = read_back(joined.get());
        ASSERT_TRUE(got.lower(0) == data.lower(0) && got.upper(0) == data.upper(0)) << where(seed, data);
        expect_part(g.get(), joined.get(), random, where(seed, data));
    });
}

// Each part is smooth inside: the knots that were kept have the order asked for.
TEST(Parts, rough_knots_are_ends) {
    for_each_case(205000, 400, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        const int axis = random.whole(0, data.axes() - 1);
        const auto k = static_cast<size_t>(axis);
        const int order = random.whole(0, data.degrees[k]);
        const auto g = create(data);
        const auto parts = split_at_knots(g.get(), axis, order);
        double at = data.lower(axis);
        for (const Handle &handle : parts) {
            const auto part = read_back(handle.get());
            ASSERT_EQ(part.lower(axis), at) << where(seed, data);
            at = part.upper(axis);
            for (const double t : part.knots[k]) {
                const auto times = std::count(part.knots[k].begin(), part.knots[k].end(), t);
                const bool inside = t > part.lower(axis) && t < part.upper(axis);
                ASSERT_TRUE(!inside || data.degrees[k] - times >= order)
                    << where(seed, data) << " order " << order;
            }
        }
        ASSERT_EQ(at, data.upper(axis)) << where(seed, data);
        expect_part(g.get(), parts[random.bits() % parts.size()].get(), random, where(seed, data));
    });
}

TEST(Parts, clamping_keeps_the_shape) {
    for_each_case(206000, 600, [](Random &random, uint64_t seed) {
        const auto data = random_case(random);
        const int axis = random.whole(0, data.axes() - 1);
        const auto flags = static_cast<uint32_t>(random.whole(0, 3));
        const auto g = create(data);
        nurbs *out = nullptr;
        require_ok(nurbs_clamp_ends(g.get(), axis, flags, &out));
        const Handle handle(out);
        const auto got = read_back(out);
        ASSERT_FALSE(got.periodic(axis));
        ASSERT_TRUE(got.lower(axis) == data.lower(axis) && got.upper(axis) == data.upper(axis))
            << where(seed, data);
        for (const int32_t end : {NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END}) {
            const bool asked = (flags & static_cast<uint32_t>(end)) != 0;
            ASSERT_EQ(clamped(out, axis, end), asked || clamped(g.get(), axis, end)) << where(seed, data);
        }
        expect_part(g.get(), out, random, where(seed, data) + " flags " + std::to_string(flags));
    });
}

// The old points and the new ones agree a period away.
TEST(Parts, a_moved_seam_keeps_the_shape) {
    for_each_case(207000, 600, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = random_recipe(random, axes, 5);
        recipe.weights = Weights::none;
        recipe.axes[0] = {recipe.axes[0].degree, KnotForm::periodic, Spacing::few_bits, Placement::origin, 5};
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const double t = std::max(
            data.lower(0), std::ldexp(std::floor(std::ldexp(random_new_knot(random, data, 0), 10)), -10));
        nurbs *out = nullptr;
        require_ok(nurbs_move_seam(g.get(), 0, t, &out));
        const Handle moved(out);
        const auto got = read_back(out);
        const std::string place = where(seed, data) + " seam " + hex(t);
        const bool same = t == data.lower(0) || t == data.upper(0);
        ASSERT_TRUE(got.periodic(0)) << place;
        ASSERT_EQ(got.lower(0), same ? data.lower(0) : t) << place;
        ASSERT_EQ(got.upper(0) - got.lower(0), data.upper(0) - data.lower(0)) << place;
        auto params = random_params(random, data, 8);
        for (size_t i = 0; i < params.size(); i += static_cast<size_t>(axes)) { // away from jumps
            params[i] = random.between(data.lower(0), data.upper(0));
        }
        const auto before = eval(g.get(), params), after = eval(out, params, NURBS_WRAP);
        const auto hulls = hull_sizes(g.get(), params);
        for (size_t i = 0; i < before.size(); ++i) { // knots of few bits: the parameter alone is rounded
            ASSERT_NEAR(before[i], after[i], 1e4 * 0x1p-52 * (hulls[i / static_cast<size_t>(data.dim)] + 1))
                << place << " at " << hex(params);
        }
    });
}

// Parts moved in space and weight: the gap is what it is, and weights agree after scaling.
TEST(Parts, a_gap_is_measured_and_closed_or_kept) {
    for_each_case(208000, 400, [](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, 1, 5);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.dim = 2;
        recipe.axes[0] = {std::max(1, recipe.axes[0].degree), KnotForm::clamped, Spacing::few_bits,
                          Placement::origin, 4};
        const auto first = random_spline(random, recipe);
        auto second = first;
        const auto end = first.points.end() - 2;
        const double dx = 0.5, scale = random.between(0.1, 10);
        for (size_t i = 0; i < second.points.size(); ++i) { // begins dx from where the first ends
            second.points[i] +=
                end[static_cast<int64_t>(i % 2)] - first.points[i % 2] + (i % 2 == 0 ? dx : 0);
        }
        for (double &w : second.weights) {
            w *= scale;
        }
        std::vector<Handle> parts;
        parts.push_back(create(first));
        parts.push_back(create(second));
        Handle joined;
        double gap = -1;
        ASSERT_EQ(try_join(parts, 0, 0.25, 0, gap, joined), NURBS_ERROR_GAP) << where(seed, first);
        ASSERT_TRUE(gap == -1 && joined == nullptr);
        ASSERT_EQ(try_join(parts, 0, 0.75, 0, gap, joined), NURBS_OK) << where(seed, first) << last_error();
        ASSERT_NEAR(gap, dx, 1e-9) << where(seed, first);
        const double middle = first.upper(0), length = first.upper(0) - first.lower(0);
        const auto meeting = eval(joined.get(), {middle, middle + length});
        ASSERT_TRUE(same_bits(meeting[0], end[0]) && same_bits(meeting[1], end[1])) << where(seed, first);
        ASSERT_NEAR(meeting[2], second.points.end()[-2], 1e-9 * (1 + std::fabs(meeting[2])))
            << where(seed, first);
        ASSERT_EQ(try_join(parts, 0, 0.25, NURBS_KEEP_GAPS, gap, joined), NURBS_OK) << last_error();
        const auto right = eval(joined.get(), {middle});
        ASSERT_TRUE(same_bits(right[0], second.points[0]) && same_bits(right[1], second.points[1]));
        ASSERT_EQ(read_back(joined.get()).counts[0], first.counts[0] + second.counts[0]);
    });
}

} // namespace

} // namespace parts_test
