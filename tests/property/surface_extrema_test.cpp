// SPDX-License-Identifier: MIT
// Extrema of scalar surfaces and volumes: Morse's law, sums of curves, and what must not change them.
#include "extrema.h"
#include "support/cases.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <numeric>

namespace surface_extrema_test {

using namespace support;

namespace {

constexpr int32_t minimum = NURBS_EXTREMUM_MINIMUM, maximum = NURBS_EXTREMUM_MAXIMUM,
                  saddle = NURBS_EXTREMUM_SADDLE, plateau = NURBS_EXTREMUM_PLATEAU;

// Multiples of 1/16, so that sums of a few are exact.
double short_number(Random &random) {
    return random.whole(-160, 160) / 16.0;
}

// Knots with steps of 1/4 to 2, which occur up to `most` times inside; the period of a periodic axis is exact.
std::vector<double> plain_knots(Random &random, int degree, KnotForm form, int spans, int most) {
    std::vector<double> inside;
    double at = 0;
    for (int i = 0; i < spans; ++i) {
        inside.insert(inside.end(),
                      i == 0 && form != KnotForm::periodic ? 1U : static_cast<size_t>(random.whole(1, most)),
                      at);
        at += random.whole(1, 8) / 4.0;
    }
    if (form == KnotForm::periodic) {
        std::vector<double> knots;
        while (inside.size() < static_cast<size_t>(degree)) {
            inside.push_back(at);
            at += 1;
        }
        const auto n = static_cast<int>(inside.size());
        for (int i = -degree; i <= n + degree; ++i) {
            const int turn = (i + 4 * n) / n - 4;
            knots.push_back(inside[static_cast<size_t>(i - turn * n)] + turn * at);
        }
        return knots;
    }
    inside.push_back(at);
    const double step = form == KnotForm::clamped ? 0 : 0.5;
    for (int i = 1; i <= degree; ++i) {
        inside.insert(inside.begin(), -i * step);
        inside.push_back(at + i * step);
    }
    return inside;
}

SplineData plain_axes(Random &random, const std::vector<KnotForm> &forms, int most_degree, int more_copies) {
    SplineData data;
    data.dim = 1;
    for (const KnotForm form : forms) {
        const int p = random.whole(1, most_degree);
        data.degrees.push_back(p);
        data.knots.push_back(plain_knots(random, p, form, random.whole(form == KnotForm::periodic ? 3 : 1, 4),
                                         std::max(p + more_copies, 1)));
        data.counts.push_back(static_cast<int64_t>(data.knots.back().size()) - p - 1);
        data.flags |= form == KnotForm::periodic
                          ? NURBS_ON_AXIS(static_cast<int>(data.degrees.size()) - 1, NURBS_PERIODIC)
                          : 0;
    }
    return data;
}

// The control point that one equals on periodic axes.
int64_t original(const SplineData &data, int64_t index) {
    int64_t result = 0, scale = 1;
    for (int k = data.axes(); k-- > 0;) {
        const auto at = static_cast<size_t>(k);
        int64_t i = index % data.counts[at];
        index /= data.counts[at];
        i = data.periodic(k) ? i % (data.counts[at] - data.degrees[at]) : i;
        result += i * scale;
        scale *= data.counts[at];
    }
    return result;
}

SplineData with_values(Random &random, SplineData data, bool rational) {
    const auto n = static_cast<size_t>(data.point_count());
    data.points.resize(n);
    data.weights.resize(rational ? n : 0);
    for (size_t i = 0; i < n; ++i) {
        const auto from = static_cast<size_t>(original(data, static_cast<int64_t>(i)));
        data.points[i] = from < i ? data.points[from] : random.between(-1, 1);
        if (rational) {
            data.weights[i] = from < i ? data.weights[from] : random.between(0.5, 2);
        }
    }
    return data;
}

KnotForm any_form(Random &random) {
    return static_cast<KnotForm>(random.chance(40) ? 0 : random.chance(50) ? 2 : 3);
}

// Kinds and places, in order.
std::vector<std::pair<std::vector<double>, int32_t>> places(const Extrema &extrema) {
    std::vector<std::pair<std::vector<double>, int32_t>> list;
    for (const Extremum &x : extrema.list) {
        list.emplace_back(x.at, x.kinds);
    }
    std::ranges::sort(list);
    return list;
}

void expect_same(const Extrema &a, const Extrema &b, double tolerance, const std::string &text) {
    const auto left = places(a), right = places(b);
    ASSERT_EQ(left.size(), right.size()) << text;
    for (size_t i = 0; i < left.size(); ++i) {
        const bool found = std::ranges::any_of(right, [&](const auto &other) {
            bool near = other.second == left[i].second;
            for (size_t k = 0; k < other.first.size(); ++k) {
                near = near && std::abs(other.first[k] - left[i].first[k]) <= tolerance;
            }
            return near;
        });
        ASSERT_TRUE(found) << i << text;
    }
}

// What stands where curves of a sum do, seen along one axis each.
struct Turn {
    double at, value;
    int32_t kind;
    bool end;
};
std::vector<Turn> turns_of(const SplineData &curve, bool &complete) {
    const Extrema extrema = extrema_of(create(curve).get());
    complete = complete && extrema.complete == 1 && !extrema.has(plateau) && !extrema.has(saddle);
    std::vector<Turn> turns;
    for (const Extremum &x : extrema.list) {
        const bool end = !curve.periodic(0) && (x.at[0] == curve.lower(0) || x.at[0] == curve.upper(0));
        turns.push_back({x.at[0], x.value, x.kinds, end});
    }
    return turns;
}

// Extrema of a(u) + b(v) + ...: all turn one way, or the ends among them do.
Extrema sum_of(const std::vector<std::vector<Turn>> &turns) {
    Extrema result;
    std::vector<size_t> i(turns.size());
    while (true) {
        Extremum x;
        int32_t all = 0, ends = 0;
        for (size_t k = 0; k < turns.size(); ++k) {
            const Turn &turn = turns[k][i[k]];
            x.at.push_back(turn.at);
            all |= turn.kind;
            ends |= turn.end ? turn.kind : 0;
        }
        x.kinds = all == minimum || all == maximum ? all : saddle;
        if (ends != (minimum | maximum)) {
            result.list.push_back(x);
        }
        size_t k = 0;
        while (k < turns.size() && ++i[k] == turns[k].size()) {
            i[k++] = 0;
        }
        if (k == turns.size()) {
            return result;
        }
    }
}

SplineData curve_along(const SplineData &data, size_t k, std::vector<double> points) {
    SplineData curve;
    curve.degrees = {data.degrees[k]};
    curve.counts = {data.counts[k]};
    curve.knots = {data.knots[k]};
    curve.dim = 1;
    curve.points = std::move(points);
    curve.flags = data.periodic(static_cast<int>(k)) ? NURBS_PERIODIC : 0;
    return curve;
}

} // namespace

// M. Morse 1925: on a torus minima less saddles plus maxima are none; with kinks too.
TEST(SurfaceExtrema, obey_morse_on_a_torus) {
    int64_t complete = 0, all = 0, found = 0;
    for_each_case(2730000, 400, [&](Random &random, uint64_t seed) {
        const SplineData data = with_values(
            random, plain_axes(random, {KnotForm::periodic, KnotForm::periodic}, 4, random.whole(-1, 0)),
            random.chance(50));
        const Extrema extrema = extrema_of(create(data).get());
        ++all;
        complete += extrema.complete;
        if (extrema.complete == 1) {
            ASSERT_EQ(extrema.alternating(), 0) << where(seed, data);
            found += std::ssize(extrema.list);
        }
    });
    std::cout << "complete " << complete << " of " << all << ", " << found << " extrema\n";
    EXPECT_GE(complete, of_whole_run(396));
    EXPECT_GE(found, of_whole_run(3000));
}

// The same with jumps along the first axis, where rows stand at heights that keep the signs of these.
TEST(SurfaceExtrema, obey_morse_where_there_are_jumps) {
    int64_t complete = 0, jumps = 0;
    for_each_case(2740000, 400, [&](Random &random, uint64_t seed) {
        SplineData data = plain_axes(random, {KnotForm::periodic, KnotForm::periodic}, 3, 0);
        data.knots[0] = plain_knots(random, data.degrees[0], KnotForm::periodic, 3, data.degrees[0] + 1);
        data.counts[0] = static_cast<int64_t>(data.knots[0].size()) - data.degrees[0] - 1;
        data = with_values(random, data, random.chance(30));
        for (int64_t i = 0; i < data.point_count(); ++i) {
            data.points[static_cast<size_t>(i)] +=
                1.5 * static_cast<double>(original(data, i) / data.counts[1]);
        }
        const Extrema extrema = extrema_of(create(data).get());
        complete += extrema.complete;
        const auto is_beside = [](const Extremum &x, const Extremum &y) {
            return x.at == y.at && x.value != y.value;
        };
        jumps += std::ranges::adjacent_find(extrema.list, is_beside) == extrema.list.end() ? 0 : 1;
        if (extrema.complete == 1) {
            ASSERT_EQ(extrema.alternating(), 0) << where(seed, data);
        }
    });
    std::cout << "complete " << complete << ", two limits in " << jumps << "\n";
    EXPECT_GE(complete, of_whole_run(200));
    EXPECT_GE(jumps, of_whole_run(5));
}

// A square is no torus: what counts for the parts below a height are minima, saddles that rise inwards on sides, and
// maxima inside.
TEST(SurfaceExtrema, obey_morse_on_a_square) {
    int64_t complete = 0;
    for_each_case(2750000, 400, [&](Random &random, uint64_t seed) {
        const std::vector<KnotForm> forms{random.chance(50) ? KnotForm::clamped : KnotForm::unclamped,
                                          random.chance(50) ? KnotForm::clamped : KnotForm::unclamped};
        const SplineData data = with_values(random, plain_axes(random, forms, 4, 0), random.chance(50));
        const Handle g = create(data);
        const Extrema extrema = extrema_of(g.get());
        complete += extrema.complete;
        int64_t sum = 0;
        for (const Extremum &x : extrema.list) {
            std::vector<double> inwards = x.at, beside = x.at;
            int ends = 0;
            for (int k = 0; k < 2; ++k) {
                const auto at = static_cast<size_t>(k);
                const double way = x.at[at] == data.lower(k) ? 1 : x.at[at] == data.upper(k) ? -1 : 0;
                beside[at] += way * 1e-7 * (data.upper(k) - data.lower(k));
                ends += way != 0 ? 1 : 0;
            }
            const bool rises = ends == 0 || eval(g.get(), beside)[0] > eval(g.get(), inwards)[0];
            sum += rises ? (x.kinds == saddle ? -1 : 1) : 0;
        }
        if (extrema.complete == 1) {
            ASSERT_EQ(sum, 1) << where(seed, data);
        }
    });
    EXPECT_GE(complete, of_whole_run(396));
}

// The signs of the determinants of second derivatives, on a torus of three axes.
TEST(VolumeExtrema, obey_morse_on_a_torus) {
    int64_t complete = 0, found = 0;
    for_each_case(2760000, 40, [&](Random &random, uint64_t seed) {
        SplineData data =
            plain_axes(random, {KnotForm::periodic, KnotForm::periodic, KnotForm::periodic}, 1, 0);
        for (size_t k = 0; k < 3; ++k) {
            data.degrees[k] = random.whole(3, 4);
            data.knots[k] = plain_knots(random, data.degrees[k], KnotForm::periodic, 3, 1);
            data.counts[k] = static_cast<int64_t>(data.knots[k].size()) - data.degrees[k] - 1;
        }
        data = with_values(random, data, random.chance(50));
        const Handle g = create(data);
        const Extrema extrema = extrema_of(g.get());
        complete += extrema.complete;
        int sum = 0;
        for (const Extremum &x : extrema.list) {
            if (x.kinds == NURBS_EXTREMUM_UNDECIDED) {
                continue;
            }
            // 1; u, v, w; uu, uv, uw, vv, vw, ww
            const std::vector<double> d = eval_derivs(g.get(), 2, x.at);
            const double determinant = d[4] * (d[7] * d[9] - d[8] * d[8]) -
                                       d[5] * (d[5] * d[9] - d[8] * d[6]) +
                                       d[6] * (d[5] * d[8] - d[7] * d[6]);
            EXPECT_LT(std::max({std::abs(d[1]), std::abs(d[2]), std::abs(d[3])}), 1e-10);
            EXPECT_TRUE(x.kinds != minimum || determinant > 0);
            EXPECT_TRUE(x.kinds != maximum || determinant < 0);
            sum += determinant > 0 ? 1 : -1;
        }
        found += std::ssize(extrema.list);
        if (extrema.complete == 1) {
            ASSERT_EQ(sum, 0) << where(seed, data);
        }
    });
    std::cout << "complete " << complete << " of 40, " << found << " extrema\n";
    EXPECT_GE(complete, of_whole_run(38));
}

// Curves along the axes, with kinks and jumps, of which nurbs_extrema() knows each: sums have those of all of them.
TEST(SurfaceExtrema, of_sums_are_those_of_the_curves) {
    int64_t compared = 0, found = 0;
    for_each_case(2770000, 400, [&](Random &random, uint64_t seed) {
        std::vector<KnotForm> forms(random.chance(20) ? 3 : 2);
        std::ranges::generate(forms, [&] { return any_form(random); });
        SplineData data = plain_axes(random, forms, forms.size() == 2 ? 4 : 2, 1);
        std::vector<std::vector<Turn>> turns;
        std::vector<std::vector<double>> values;
        bool complete = true;
        for (size_t k = 0; k < forms.size(); ++k) {
            const int64_t n = data.counts[k],
                          distinct = data.periodic(static_cast<int>(k)) ? n - data.degrees[k] : n;
            std::vector<double> points;
            for (int64_t i = 0; i < n; ++i) {
                points.push_back(i < distinct ? short_number(random)
                                              : points[static_cast<size_t>(i % distinct)]);
            }
            turns.push_back(turns_of(curve_along(data, k, points), complete));
            values.push_back(points);
        }
        for (int64_t i = 0; i < data.point_count(); ++i) {
            double sum = 0;
            int64_t rest = i;
            for (size_t k = forms.size(); k-- > 0; rest /= data.counts[k]) {
                sum += values[k][static_cast<size_t>(rest % data.counts[k])];
            }
            data.points.push_back(sum);
        }
        const Extrema extrema = extrema_of(create(data).get());
        if (!complete || extrema.complete != 1) {
            return;
        }
        ++compared;
        const Extrema wanted = sum_of(turns);
        found += std::ssize(wanted.list);
        expect_same(extrema, wanted, 1e-9, where(seed, data));
        expect_same(wanted, extrema, 1e-9, where(seed, data));
    });
    std::cout << "compared " << compared << " of 400, " << found << " extrema\n";
    EXPECT_GE(compared, of_whole_run(300));
}

// Other knots, degrees, scales, sides and weights of the same function.
TEST(SurfaceExtrema, do_not_depend_on_how_the_function_is_given) {
    int64_t compared = 0;
    for_each_case(2780000, 150, [&](Random &random, uint64_t seed) {
        const SplineData data = with_values(
            random, plain_axes(random, {any_form(random), any_form(random)}, 3, 0), random.chance(50));
        const Handle g = create(data);
        const Extrema extrema = extrema_of(g.get());
        if (extrema.complete != 1) {
            return;
        }
        ++compared;
        const std::string text = where(seed, data);
        const int axis = random.whole(0, 1);
        const double at = random.between(data.lower(axis), data.upper(axis));
        expect_same(extrema, extrema_of(insert(g.get(), axis, at, 1).get()), 1e-9, "insert" + text);
        expect_same(extrema, extrema_of(elevate(g.get(), axis, 1).get()), 1e-7, "elevate" + text);
        SplineData other = data;
        for (double &x : other.points) {
            x = std::ldexp(x, 500);
        }
        expect_same(extrema, extrema_of(create(other).get()), 0, "size" + text);
        for (double &x : other.points) {
            x = std::ldexp(x, -1000);
        }
        expect_same(extrema, extrema_of(create(other).get()), 0, "small" + text);
        other = data;
        for (double &w : other.weights) {
            w = std::ldexp(w, 200);
        }
        expect_same(extrema, extrema_of(create(other).get()), 0, "weights" + text);
        std::vector<double> records = homogeneous_points(g.get());
        for (double &x : records) {
            x = -std::ldexp(x, -7);
        }
        const std::vector<double> knots = data.all_knots();
        const Handle homogeneous = made([&](nurbs **out) {
            return nurbs_create_homogeneous(2, data.degrees.data(), data.counts.data(), knots.data(),
                                            static_cast<int64_t>(knots.size()), 1, records.data(), 0, 0,
                                            data.flags, out);
        });
        expect_same(extrema, extrema_of(homogeneous.get()), 1e-9, "homogeneous" + text);
        const int32_t order[] = {1, 0};
        const Handle turned = made([&](nurbs **out) { return nurbs_transpose(g.get(), order, out); });
        Extrema swapped = extrema_of(turned.get());
        for (Extremum &x : swapped.list) {
            std::swap(x.at[0], x.at[1]);
        }
        expect_same(extrema, swapped, 1e-12, "swap" + text);
    });
    std::cout << "compared " << compared << " of 150\n";
    EXPECT_GE(compared, of_whole_run(145));
}

// At a knot line and where two of them cross, where pieces are of one size and of sizes far apart.
TEST(SurfaceExtrema, between_smooth_pieces_are_found_once) {
    const std::vector<double> knots{-3, -2, -1, 0, 1, 2, 3, 4, 5, 6};
    for (const double size : {0.0, 4096.0}) {
        const std::vector<double> along{0, 0, 1, 0, size, 9}, across{2, 0, 1, 2, 0, 3};
        for (const bool both : {false, true}) {
            SplineData data{{3, 3}, {6, 6}, {knots, knots}, 1, {}, {}, 0};
            for (const double a : along) {
                for (size_t j = 0; j < 6; ++j) {
                    data.points.push_back(a + (both ? along[j] : across[j]));
                }
            }
            const Extrema extrema = extrema_of(create(data).get());
            EXPECT_EQ(extrema.complete, 1);
            const auto is_at_knots = [=](const Extremum &x) {
                return std::abs(x.at[0] - 1) < 1e-9 && (!both || std::abs(x.at[1] - 1) < 1e-9);
            };
            EXPECT_EQ(std::ranges::count_if(extrema.list, is_at_knots), both ? 1 : 5) << size;
        }
    }
}

TEST(SurfaceExtrema, know_sides_of_one_height) {
    const SplineData ramp{{1, 1}, {3, 2}, {{0, 0, 1, 2, 2}, {0, 0, 1, 1}}, 1, {0, 0, 1, 1, 3, 3}, {}, 0};
    const Extrema of_ramp = extrema_of(create(ramp).get());
    ASSERT_EQ(of_ramp.list.size(), 2U);
    EXPECT_EQ(of_ramp.complete, 1);
    EXPECT_EQ(of_ramp.list[0].kinds, plateau | minimum);
    EXPECT_EQ(of_ramp.list[0].range, (std::vector<double>{0, 0, 0, 1}));
    EXPECT_EQ(of_ramp.list[1].kinds, plateau | maximum);
    SplineData roof = ramp;
    roof.points = {0, 0, 1, 1, 0, 0};
    const Extrema of_roof = extrema_of(create(roof).get());
    ASSERT_EQ(of_roof.list.size(), 3U);
    EXPECT_EQ(of_roof.list[1].kinds, plateau | maximum);
    EXPECT_EQ(of_roof.list[1].range, (std::vector<double>{1, 1, 0, 1}));
    SplineData level = ramp;
    level.points.assign(6, 0.1);
    const Extrema of_level = extrema_of(create(level).get());
    ASSERT_EQ(of_level.list.size(), 1U);
    EXPECT_EQ(of_level.list[0].kinds, plateau);
    EXPECT_EQ(of_level.list[0].range, (std::vector<double>{0, 2, 0, 1}));
}

// A valley of one depth along a knot line where f is smooth: control points are level on both sides of it.
TEST(SurfaceExtrema, leave_ridges_and_valleys_open) {
    const std::vector<double> heights{1, 0, 0, 1};
    SplineData valley{{2, 1}, {4, 2}, {{-2, -1, 0, 1, 2, 3, 4}, {0, 0, 1, 1}}, 1, {}, {}, 0};
    for (const double height : heights) {
        valley.points.insert(valley.points.end(), {height, 2 * height});
    }
    const Extrema extrema = extrema_of(create(valley).get());
    EXPECT_EQ(extrema.complete, 0);
    EXPECT_TRUE(std::ranges::any_of(extrema.list, [](const Extremum &x) {
        return (x.kinds & NURBS_EXTREMUM_UNDECIDED) != 0 && x.range[0] <= 1 && x.range[1] >= 1 &&
               x.range[2] == 0 && x.range[3] == 1;
    }));
}

// What is found without a limit lies in a range that is told with one.
TEST(SurfaceExtrema, at_the_limit_of_work_claim_nothing_false) {
    for_each_case(2790000, 60, [&](Random &random, uint64_t seed) {
        const SplineData data = with_values(
            random, plain_axes(random, {KnotForm::clamped, any_form(random)}, 3, 0), random.chance(50));
        const Handle g = create(data);
        const Extrema all = extrema_of(g.get());
        for (const int64_t work : {1, 10, 100, 10000, 300000}) {
            const Extrema some = extrema_of(g.get(), work);
            for (const Extremum &x : all.list) {
                const bool told = std::ranges::any_of(some.list, [&](const Extremum &other) {
                    bool inside = true;
                    for (size_t k = 0; k < 2; ++k) {
                        inside = inside && x.at[k] >= other.range[2 * k] - 1e-9 &&
                                 x.at[k] <= other.range[2 * k + 1] + 1e-9;
                    }
                    return inside;
                });
                ASSERT_TRUE(told) << work << where(seed, data);
            }
            ASSERT_TRUE(work > 100 || some.complete == 0) << work << where(seed, data);
        }
    });
}

} // namespace surface_extrema_test
