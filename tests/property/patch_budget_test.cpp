// Nearest and farthest points of surfaces and volumes that are asked for with few pieces to look at: the
// answer is a sensible one all the same, and a better one the more may be spent.
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>

namespace patch_budget_test {

using namespace support;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Question {
    std::vector<double> x;
    const double *range;
    bool farthest;
};

struct Answer {
    double distance;
    int32_t status;
};

Answer ask(const nurbs *g, const Question &question, int64_t budget) {
    Answer answer{};
    const auto function = question.farthest ? nurbs_farthest_points : nurbs_closest_points;
    require_ok(function(g, 1, question.x.data(), 0, 0, question.range, 0, budget, nullptr, 0, 0, nullptr, 0,
                        0, &answer.distance, 0, &answer.status, 0));
    return answer;
}

double largest(const std::vector<double> &x) {
    double size = 0;
    for (const double c : x) {
        size = std::max(size, std::fabs(c));
    }
    return size;
}

// What the header allows for rounding.
double noise(const SplineData &data, const std::vector<double> &x) {
    int n = 0;
    for (const int32_t p : data.degrees) {
        n += p + 1;
    }
    return (64 * n + 2 * data.dim) * eps * std::sqrt(data.dim) * (largest(data.points) + largest(x));
}

// The middles of `parts` equal parts of every span along each axis, of those in the range.
std::vector<std::vector<double>> middles(const SplineData &data, int parts, const double *range) {
    std::vector<std::vector<double>> places;
    for (int k = 0; k < data.axes(); ++k) {
        std::vector<double> breaks;
        for (const double t : data.knots[static_cast<size_t>(k)]) {
            if (t >= data.lower(k) && t <= data.upper(k) && (breaks.empty() || t > breaks.back())) {
                breaks.push_back(t);
            }
        }
        places.emplace_back();
        for (size_t i = 0; i + 1 < breaks.size(); ++i) {
            for (int j = 0; j < parts; ++j) {
                const double t = breaks[i] + (breaks[i + 1] - breaks[i]) * (j + 0.5) / parts;
                if (range == nullptr || (t >= range[2 * k] && t <= range[2 * k + 1])) {
                    places.back().push_back(t);
                }
            }
        }
    }
    return places;
}

// The best distance to the points of a grid, infinite without any.
double best_of(const nurbs *g, const std::vector<std::vector<double>> &places, const Question &question) {
    double best = question.farthest ? 0 : INFINITY;
    if (std::any_of(places.begin(), places.end(), [](const auto &axis) { return axis.empty(); })) {
        return best;
    }
    const std::vector<double> points = eval_grid(g, places);
    const size_t dim = question.x.size();
    for (size_t i = 0; i < points.size(); i += dim) {
        double square = 0;
        for (size_t c = 0; c < dim; ++c) {
            square += (points[i + c] - question.x[c]) * (points[i + c] - question.x[c]);
        }
        const double d = std::sqrt(square);
        best = question.farthest ? std::max(best, d) : std::min(best, d);
    }
    return best;
}

// A net with hills, of high degrees or many pieces, about which nothing is simple.
SplineData rough_shape(Random &random) {
    Recipe recipe;
    const int axes = random.chance(75) ? 2 : 3;
    for (int k = 0; k < axes; ++k) {
        const int most = axes == 2 ? 8 : 4;
        recipe.axes.push_back({random.whole(1, most), KnotForm::clamped, Spacing::integers, Placement::origin,
                               random.whole(1, axes == 2 ? 8 : 3)});
    }
    recipe.weights = random.chance(50) ? Weights::moderate : Weights::none;
    return random_spline(random, recipe);
}

Question random_question(Random &random, const SplineData &data, std::vector<double> &range) {
    Question question{{}, nullptr, random.chance(25)};
    const double reach = largest(data.points) * random.magnitude(0.1, 3);
    for (int c = 0; c < data.dim; ++c) {
        question.x.push_back(reach * random.between(-1, 1));
    }
    range.clear();
    for (int k = 0; k < data.axes(); ++k) {
        const double a = random.between(data.lower(k), data.upper(k)),
                     b = random.between(data.lower(k), data.upper(k));
        range.insert(range.end(), {std::min(a, b), std::max(a, b)});
    }
    question.range = random.chance(30) ? range.data() : nullptr;
    return question;
}

constexpr int64_t budgets[] = {1, 2, 5, 12, 30, 100, 400, 2000, 20000};

// Points that the search looks at in any case: of spans cut into four, those of volumes into two.
TEST(PatchBudget, no_answer_is_worse_than_the_middles_of_the_parts_of_spans) {
    int ended = 0;
    for (uint64_t seed = 2400000; seed < 2400150; ++seed) {
        Random random(seed);
        const SplineData data = rough_shape(random);
        const Handle g = create(data);
        std::vector<double> range;
        for (int i = 0; i < 12; ++i) {
            const Question question = random_question(random, data, range);
            const double best =
                best_of(g.get(), middles(data, data.axes() == 2 ? 4 : 2, question.range), question);
            for (const int64_t budget : {1, 2, 5}) {
                const Answer answer = ask(g.get(), question, budget);
                ended += (answer.status & NURBS_CLOSEST_BUDGET) != 0 ? 1 : 0;
                const double worse = question.farthest ? best - answer.distance : answer.distance - best;
                EXPECT_LE(worse, noise(data, question.x))
                    << "seed " << seed << ", query " << i << ", budget " << budget;
            }
        }
    }
    EXPECT_GE(ended, 1000);
}

TEST(PatchBudget, answers_are_no_worse_for_a_larger_budget) {
    for (uint64_t seed = 2410000; seed < 2410150; ++seed) {
        Random random(seed);
        const SplineData data = rough_shape(random);
        const Handle g = create(data);
        std::vector<double> range;
        for (int i = 0; i < 6; ++i) {
            const Question question = random_question(random, data, range);
            double last = question.farthest ? 0 : INFINITY;
            for (const int64_t budget : budgets) {
                const Answer answer = ask(g.get(), question, budget);
                const double worse = question.farthest ? last - answer.distance : answer.distance - last;
                ASSERT_LE(worse, noise(data, question.x))
                    << "seed " << seed << ", query " << i << ", budget " << budget;
                last = answer.distance;
                if ((answer.status & NURBS_CLOSEST_BUDGET) == 0) {
                    break;
                }
            }
        }
    }
}

// `cells` equal parts of the domain along each axis.
std::vector<std::vector<double>> grid(const SplineData &data, int cells) {
    std::vector<std::vector<double>> places;
    for (int k = 0; k < data.axes(); ++k) {
        places.emplace_back();
        for (int j = 0; j <= cells; ++j) {
            const double t = data.lower(k) + (data.upper(k) - data.lower(k)) * j / cells;
            places.back().push_back(std::min(data.upper(k), t));
        }
    }
    return places;
}

// With the nearest pieces first, a budget goes as far as a grid of more cells: always for a hundred of them,
// nearly so for a few.
TEST(PatchBudget, what_is_spent_is_worth_a_grid_of_as_many_points) {
    int ended = 0, worse = 0;
    for (uint64_t seed = 2420000; seed < 2420200; ++seed) {
        Random random(seed);
        const SplineData data = rough_shape(random);
        const Handle g = create(data);
        std::vector<double> range;
        for (int i = 0; i < 6; ++i) {
            Question question = random_question(random, data, range);
            question.range = nullptr;
            for (const int64_t budget : budgets) {
                const Answer answer = ask(g.get(), question, budget);
                if ((answer.status & NURBS_CLOSEST_BUDGET) == 0) {
                    break;
                }
                const double side = std::pow(static_cast<double>(budget), 1.0 / data.axes());
                const double best = best_of(g.get(), grid(data, static_cast<int>(side + 1e-9) + 1), question);
                const double by = question.farthest ? best - answer.distance : answer.distance - best;
                const bool is_worse = by > noise(data, question.x);
                ++ended;
                worse += is_worse ? 1 : 0;
                EXPECT_FALSE(is_worse && budget >= 100)
                    << "seed " << seed << ", query " << i << ", budget " << budget;
            }
        }
    }
    std::printf("%d of %d worse\n", worse, ended);
    EXPECT_LE(worse * 25, ended);
}

} // namespace

} // namespace patch_budget_test
