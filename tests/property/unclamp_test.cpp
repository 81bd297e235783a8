// Control points continued beyond short end spans, where coefficients are large and cancel: weights and
// homogeneous records against exact polar forms.
#include "property/real_files.h"
#include "reference/definition.h"

namespace unclamp_test {

using namespace support;

namespace {

using reference::Rational;

constexpr uint32_t both = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END;

// Clamped axis of [0, 1] with its first and last spans as short as 1e-9.
std::vector<double> short_ended(Random &random, int p, int inside) {
    std::vector<double> knots(static_cast<size_t>(p) + 1, 0.0);
    for (int i = 0; i < inside; ++i) {
        const double near = random.magnitude(1e-9, 0.5);
        knots.push_back(random.chance(30) ? random.between(0.1, 0.9) : random.chance(50) ? near : 1 - near);
    }
    std::sort(knots.begin(), knots.end());
    knots.insert(knots.end(), static_cast<size_t>(p) + 1, 1.0);
    return knots;
}

SplineData random_short_ended(Random &random, int axes) {
    SplineData data;
    data.dim = random.whole(1, 3);
    for (int k = 0; k < axes; ++k) {
        const int p = random.whole(1, axes == 1 ? 9 : 3), inside = random.whole(0, axes == 1 ? 5 : 2);
        data.degrees.push_back(p);
        data.counts.push_back(p + 1 + inside);
        data.knots.push_back(short_ended(random, p, inside));
    }
    for (int64_t i = 0; i < data.point_count() * data.dim; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return data;
}

SplineData with_weights(SplineData data, Random &random, double low, double high) {
    for (int64_t i = 0; i < data.point_count(); ++i) {
        data.weights.push_back(random.between(low, high));
    }
    return data;
}

Handle created_homogeneous(const SplineData &data) {
    SplineData records = homogeneous(create(data).get());
    return made([&](nurbs **out) {
        const std::vector<double> knots = records.all_knots();
        return nurbs_create_homogeneous(records.axes(), records.degrees.data(), records.counts.data(),
                                        knots.data(), std::ssize(knots), data.dim, records.points.data(), 0,
                                        0, 0, out);
    });
}

// Beyond short spans, to either side, along each axis.
using Continuing = std::function<Handle(const nurbs *, int)>;
const std::vector<Continuing> &continuing() {
    static const std::vector<Continuing> list = {
        [](const nurbs *g, int k) {
            return made([&](nurbs **out) { return nurbs_unclamp(g, k, NURBS_FORM_CLAMPED_START, out); });
        },
        [](const nurbs *g, int k) {
            return made([&](nurbs **out) { return nurbs_unclamp(g, k, both, out); });
        },
        [](const nurbs *g, int k) {
            return made([&](nurbs **out) { return nurbs_extend(g, k, NURBS_START, 1, 31, out); });
        },
        [](const nurbs *g, int k) {
            return made([&](nurbs **out) { return nurbs_extend(g, k, NURBS_END, 2, 2, out); });
        },
        [](const nurbs *g, int k) {
            return made(
                [&](nurbs **out) { return nurbs_make_periodic(g, k, HUGE_VAL, nullptr, nullptr, out); });
        },
    };
    return list;
}

TEST(Continuing, equal_weights_stay_equal_and_points_are_those_without_weights) {
    for_each_case(325000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3), k = random.whole(0, axes - 1);
        SplineData data = random_short_ended(random, axes);
        const Handle plain = create(data);
        const double w = std::vector<double>{1, 0.3, 4, 1e-3}[static_cast<size_t>(random.whole(0, 3))];
        data.weights.assign(static_cast<size_t>(data.point_count()), w);
        const Handle weighted = create(data), records = created_homogeneous(data);
        for (const Continuing &longer : continuing()) {
            const SplineData expected = read_back(longer(plain.get(), k).get());
            const SplineData got = read_back(longer(weighted.get(), k).get());
            for (const double weight : got.weights) {
                ASSERT_EQ(weight, w) << where(seed, data);
            }
            ASSERT_TRUE((w != 1 && w != 4) || same_bits(got.points, expected.points)) << where(seed, data);
            const std::vector<double> homogeneous_ones = homogeneous_points(longer(records.get(), k).get());
            for (size_t i = static_cast<size_t>(data.dim); i < homogeneous_ones.size();
                 i += static_cast<size_t>(data.dim) + 1) {
                ASSERT_EQ(homogeneous_ones[i], w) << where(seed, data);
            }
        }
    });
}

// The homogeneous control points of a spline unclamped at one end: polar forms of its end piece at the new
// knots, and the sums of the magnitudes of their terms.
struct Unclamped {
    std::vector<Rational> points;
    std::vector<Rational> sizes;
};

Unclamped exactly_unclamped(const SplineData &old, int axis, const std::vector<double> &knots, bool start) {
    const auto k = static_cast<size_t>(axis);
    const Layers view(old, axis);
    const int p = old.degrees[k];
    const int64_t span = start ? p : view.count - 1, records = old.point_count();
    Unclamped result{std::vector<Rational>(old.points.size()), std::vector<Rational>(old.points.size())};
    std::vector<std::vector<Rational>> units;
    for (int i = 0; i <= p; ++i) {
        units.emplace_back(static_cast<size_t>(p) + 1)[static_cast<size_t>(i)] = 1;
    }
    for (int64_t layer = 0; layer < view.count; ++layer) {
        const bool kept = start ? layer > span : layer < span - p;
        const auto first = knots.begin() + layer + 1;
        const auto row = kept ? units.front()
                              : reference::defined_blossom(old.knots[k], p, span, units, {first, first + p});
        for (int64_t i = 0; i < records / view.count; ++i) {
            for (int c = 0; c < old.dim; ++c) {
                const auto at = [&](int64_t l) {
                    return static_cast<size_t>(view.place(i / view.inner, l, i % view.inner) * old.dim + c);
                };
                for (int j = 0; j <= (kept ? 0 : p); ++j) {
                    const Rational term = row[static_cast<size_t>(j)] *
                                          reference::exact(old.points[at(kept ? layer : span - p + j)]);
                    result.points[at(layer)] += term;
                    result.sizes[at(layer)] += abs(term);
                }
            }
        }
    }
    return result;
}

void expect_polar_forms(const nurbs *g, const nurbs *open, int axis, bool start, const std::string &place) {
    const SplineData old = homogeneous(g), fresh = homogeneous(open);
    const Unclamped exact = exactly_unclamped(old, axis, fresh.knots[static_cast<size_t>(axis)], start);
    const Rational unit = reference::exact(4 * (old.degrees[static_cast<size_t>(axis)] + 1) * 0x1p-52);
    for (size_t i = 0; i < fresh.points.size(); ++i) {
        ASSERT_LE(abs(reference::exact(fresh.points[i]) - exact.points[i]), unit * exact.sizes[i])
            << place << i;
    }
}

TEST(Unclamping, rational_records_are_polar_forms_or_refused_for_their_weights) {
    int kept = 0, refused = 0;
    for_each_case(326000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3), k = random.whole(0, axes - 1);
        const bool near = random.chance(50), start = random.chance(50);
        const SplineData data =
            with_weights(random_short_ended(random, axes), random, near ? 1 - 1e-9 : 0.5, near ? 1 : 2);
        const Handle g = create(data);
        const uint32_t end = start ? NURBS_FORM_CLAMPED_START : NURBS_FORM_CLAMPED_END;
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_unclamp(g.get(), k, end, &out);
        const Handle open(out);
        const std::string place = where(seed, data) + std::to_string(k);
        if (status == NURBS_OK) {
            ++kept;
            expect_polar_forms(g.get(), out, k, start, place);
        } else {
            ++refused;
            ASSERT_TRUE(status == NURBS_ERROR_WEIGHT_NEGATIVE || status == NURBS_ERROR_WEIGHTS_VANISH)
                << place;
            ASSERT_NE(last_error().find("NURBS_HOMOGENEOUS"), std::string::npos) << last_error();
        }
        const Handle records =
            made([&](nurbs **made) { return nurbs_unclamp(g.get(), k, end | NURBS_HOMOGENEOUS, made); });
        int32_t form = -1;
        require_ok(nurbs_is_homogeneous(records.get(), &form));
        ASSERT_EQ(form, 1) << place;
        expect_polar_forms(g.get(), records.get(), k, start, place);
    });
    std::printf("%d with weights, %d refused\n", kept, refused);
    ASSERT_GT(std::min(kept, refused), of_whole_run(50));
}

// Degree, length of the first span: where the sums of equal weights came out as 0.
TEST(Unclamping, equal_weights_of_curves_that_lost_their_start) {
    for (const auto &[p, span] :
         std::vector<std::pair<int, double>>{{3, 1e-8}, {4, 3e-6}, {5, 1e-4}, {6, 1e-4}, {8, 1e-2}}) {
        for (const double w : {1.0, 0.3}) {
            SplineData data{{p}, {p + 2}, {std::vector<double>(static_cast<size_t>(p) + 1, 0.0)}, 1, {},
                            {},  0};
            data.knots[0].push_back(span);
            data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(p) + 1, 1.0);
            for (int i = 0; i < p + 2; ++i) {
                data.points.push_back(i % 2);
                data.weights.push_back(w);
            }
            const Handle g = create(data);
            const Handle open =
                made([&](nurbs **out) { return nurbs_unclamp(g.get(), 0, NURBS_FORM_CLAMPED_START, out); });
            ASSERT_TRUE(read_back(open.get()).weights == data.weights) << p;
            expect_polar_forms(g.get(), open.get(), 0, true, std::to_string(p));
        }
    }
}

TEST_F(RealFiles, unclamped_with_weights_as_without) {
    for (const RealSpline &spline : iges()) {
        if (spline.data.rational()) {
            continue;
        }
        const Handle weighted =
            made([&](nurbs **out) { return nurbs_make_rational(spline.handle.get(), out); });
        for (int k = 0; k < spline.data.axes(); ++k) {
            nurbs *plain = nullptr, *rational = nullptr;
            const nurbs_status status = nurbs_unclamp(spline.handle.get(), k, both, &plain);
            const Handle a(plain);
            ASSERT_EQ(nurbs_unclamp(weighted.get(), k, both, &rational), status)
                << spline.name << last_error();
            const Handle b(rational);
            ASSERT_TRUE(status != NURBS_OK || same_bits(read_back(plain).points, read_back(rational).points))
                << spline.name;
        }
    }
}

} // namespace

} // namespace unclamp_test
