#include "spline/contract.h"
#include "spline/layer_table.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace layer_table_test {

namespace {

using nrb::Form;
using nrb::LayerTable;
using nrb::make_knot_vector;
using nrb::make_spline;
using nrb::Net;
using nrb::SplinePtr;

SplinePtr bilinear(std::vector<double> points) {
    const auto axis = make_knot_vector(1, {0, 0, 1, 1});
    return make_spline({axis, axis}, 1, Form::polynomial, std::move(points));
}

TEST(LayerTable, trims_zeros_and_turns_a_single_one_into_a_copy) {
    LayerTable table;
    const double row[4] = {0, 0.5, 0.5, 0};
    const double unit[3] = {0, 1, 0};
    table.add_row(7, row, 4);
    table.add_row(3, unit, 3);
    EXPECT_EQ(table.row(0).first, 8);
    EXPECT_EQ(table.row(0).size, 2);
    EXPECT_EQ(table.row(1).first, 4);
    EXPECT_EQ(table.row(1).size, 0);
}

TEST(ApplyAlong, acts_on_each_axis_alike) {
    const SplinePtr spline = bilinear({0, 1, 2, 4});
    LayerTable table;
    const double half[2] = {0.5, 0.5};
    table.add_row(0, half, 2);
    EXPECT_EQ(nrb::apply_along(*spline, 0, table).points, (std::vector<double>{1, 2.5}));
    EXPECT_EQ(nrb::apply_along(*spline, 1, table).points, (std::vector<double>{0.5, 3}));
}

TEST(ApplyAlong, keeps_a_position_where_all_weights_are_zero) {
    const SplinePtr curve =
        make_spline({make_knot_vector(2, {0, 0, 0, 1, 1, 1})}, 1, Form::rational, {5, 7, 9}, {1, 0, 1});
    LayerTable copy;
    copy.add_copy(1);
    EXPECT_EQ(nrb::apply_along(*curve, 0, copy).points, (std::vector<double>{7}));
    // Over weights (1, 0, 0, 1) a cubic stays positive, and the two middle points combine without a weight.
    const SplinePtr cubic = make_spline({make_knot_vector(3, {0, 0, 0, 0, 1, 1, 1, 1})}, 1, Form::rational,
                                        {5, 7, 9, 11}, {1, 0, 0, 1});
    LayerTable half;
    const double halves[2] = {0.5, 0.5};
    half.add_row(1, halves, 2);
    EXPECT_EQ(nrb::apply_along(*cubic, 0, half).points, (std::vector<double>{8}));
    EXPECT_EQ(nrb::apply_along(*cubic, 0, half).weights, (std::vector<double>{0}));
    LayerTable quarter;
    const double row[2] = {0.25, 0.75};
    quarter.add_row(1, row, 2);
    const Net net = nrb::apply_along(*curve, 0, quarter);
    EXPECT_EQ(net.points, (std::vector<double>{9}));
    EXPECT_EQ(net.weights, (std::vector<double>{0.75}));
}

TEST(ApplyAlong, reports_overflow) {
    const SplinePtr spline = bilinear({1e308, 0, 1e308, 0});
    LayerTable table;
    const double row[2] = {10, 10};
    table.add_row(0, row, 2);
    EXPECT_THROW(nrb::apply_along(*spline, 0, table), nrb::Error);
}

// All forms and widths, with copies, repeated rows and a layer whose weights are all 0.
TEST(LayerMaker, makes_in_parts_what_one_table_makes) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0.5, 2);
    const int64_t count = 12;
    const auto axis = make_knot_vector(3, {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 9});
    ASSERT_EQ(axis->count(), count);
    const double halves[2] = {0.25, 0.75};
    const auto table_of = [&](int64_t first, int64_t end) {
        LayerTable table;
        for (int64_t r = first; r < end; ++r) {
            if (r % 4 == 3) {
                table.add_copy(r % (count - 1));
            } else if (r % 4 == 2 && r > first) {
                table.repeat_row();
            } else {
                table.add_row((r % 4 == 2 ? r - 1 : r) % (count - 1), halves, 2);
            }
        }
        return table;
    };
    for (const Form form : {Form::polynomial, Form::rational, Form::homogeneous}) {
        for (int dim = 1; dim <= 5; ++dim) {
            const auto width = static_cast<size_t>(dim + (form == Form::homogeneous ? 1 : 0));
            std::vector<double> points(static_cast<size_t>(count) * width), weights;
            std::generate(points.begin(), points.end(), [&] { return uniform(random); });
            if (form == Form::rational) {
                weights.resize(static_cast<size_t>(count));
                std::generate(weights.begin(), weights.end(), [&] { return uniform(random); });
                weights[5] = weights[6] = 0;
            }
            const SplinePtr curve = make_spline({axis}, dim, form, points, weights);
            nrb::LayerMaker maker(*curve, 0, 30);
            ASSERT_TRUE(maker.in_parts());
            for (const auto &[first, end] : {std::pair<int64_t, int64_t>{0, 7}, {7, 8}, {8, 30}}) {
                maker.append(table_of(first, end));
            }
            const Net parts = maker.finish(), whole = nrb::apply_along(*curve, 0, table_of(0, 30));
            EXPECT_EQ(parts.points, whole.points);
            EXPECT_EQ(parts.weights, whole.weights);
        }
    }
}

// Every length takes another way through the blocks; all must add in the same order.
TEST(Contract, has_the_bits_of_the_definition_for_every_length) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> rows(40 * 6);
    for (double &x : rows) {
        x = uniform(random);
    }
    const double coefficients[6] = {0.1, -0.7, 0.3, 0.9, -0.2, 0.6};
    for (int64_t length = 1; length <= 40; ++length) {
        std::vector<double> out(static_cast<size_t>(length) + 1, 42.0);
        nrb::contract(coefficients, 6, rows.data(), 40, length, out.data());
        for (int64_t l = 0; l < length; ++l) {
            double sum = coefficients[0] * rows[static_cast<size_t>(l)];
            for (int64_t i = 1; i < 6; ++i) {
                sum += coefficients[i] * rows[static_cast<size_t>(i * 40 + l)];
            }
            EXPECT_EQ(out[static_cast<size_t>(l)], sum);
        }
        EXPECT_EQ(out.back(), 42.0);
    }
}

} // namespace

} // namespace layer_table_test
