// Splines in a body: each once, whoever holds them.
#include "io/binary/spline_bytes.h"
#include "io/binary/spline_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spline_table_test {

namespace {

using namespace nrb;
using namespace nrb::io;

SplinePtr line(double end, double weight = 0) {
    Spline::Axes axes{make_knot_vector(1, {0, 0, 1, 1})};
    if (weight == 0) {
        return make_spline(std::move(axes), 1, Form::polynomial, {0, end});
    }
    return make_spline(std::move(axes), 1, Form::rational, {0, end}, {1, weight});
}

// A whole of a kind to come, whose body is a table alone.
std::vector<unsigned char> holder(const SplineTable &table) {
    std::vector<unsigned char> bytes(header_size + table.size_in_bytes());
    ByteWriter writer(Kind{7}, {static_cast<int32_t>(table.count())}, bytes);
    table.write(writer);
    writer.finish();
    return bytes;
}

TEST(SplineTable, counts_what_differs) {
    SplineTable table;
    const SplinePtr a = line(2);
    EXPECT_EQ(table.add(a), 0);
    EXPECT_EQ(table.add(line(3)), 1);
    EXPECT_EQ(table.add(a), 0);
    EXPECT_EQ(table.add(line(2)), 0);
    EXPECT_EQ(table.add(line(0.0)), 2);
    EXPECT_EQ(table.add(line(-0.0)), 3); // another bit
    EXPECT_EQ(table.add(line(2, 1)), 4); // the same points
    EXPECT_EQ(table.add(line(2, 3)), 5);
    EXPECT_EQ(table.count(), 6);
}

TEST(SplineTable, is_read_from_any_holder) {
    SplineTable table;
    for (const double end : {2.0, 5.0, -1.0}) {
        table.add(line(end));
    }
    const std::vector<unsigned char> bytes = holder(table);
    ByteReader reader(bytes, Kind{7});
    const std::vector<SplinePtr> splines = splines_from(reader, reader.numbers()[0]);
    reader.end();
    ASSERT_EQ(splines.size(), 3u);
    EXPECT_TRUE(same_bytes(*splines[1], *line(5)));
    EXPECT_TRUE(same_bytes(*splines[2], *line(-1)));
}

TEST(SplineTable, may_be_empty) {
    const SplineTable table;
    const std::vector<unsigned char> bytes = holder(table);
    EXPECT_EQ(bytes.size(), header_size);
    ByteReader reader(bytes, Kind{7});
    EXPECT_TRUE(splines_from(reader, 0).empty());
    reader.end();
}

// What differs in one value only is another spline.
TEST(SplineTable, same_bytes_looks_at_everything) {
    const auto made = [](int degree, std::vector<double> knots, bool periodic, int dim, Form form,
                         std::vector<double> points, std::vector<double> weights = {}) {
        return make_spline({make_knot_vector(degree, std::move(knots), periodic)}, dim, form,
                           std::move(points), std::move(weights));
    };
    const SplinePtr all[] = {
        made(1, {0, 1, 2, 3, 4}, false, 2, Form::polynomial, {1, 2, 3, 4, 1, 2}),
        made(1, {0, 1, 2, 3, 4}, true, 2, Form::polynomial, {1, 2, 3, 4, 1, 2}),
        made(1, {0, 1, 2, 3, 5}, false, 2, Form::polynomial, {1, 2, 3, 4, 1, 2}),
        made(0, {0, 1, 2, 3}, false, 2, Form::polynomial, {1, 2, 3, 4, 1, 2}),
        made(1, {0, 1, 2, 3, 4}, false, 1, Form::homogeneous, {1, 2, 3, 4, 1, 2}),
        made(1, {0, 1, 2, 3, 4}, false, 2, Form::polynomial, {1, 2, 3, 4, 1, 2.5}),
        made(1, {0, 1, 2, 3, 4}, false, 2, Form::rational, {1, 2, 3, 4, 1, 2}, {1, 1, 1}),
        made(1, {0, 1, 2, 3, 4}, false, 2, Form::rational, {1, 2, 3, 4, 1, 2}, {1, 2, 1})};
    for (const SplinePtr &a : all) {
        for (const SplinePtr &b : all) {
            EXPECT_EQ(same_bytes(*a, *b), a == b);
            std::vector<unsigned char> x(size_in_bytes(*a)), y(size_in_bytes(*b));
            write_bytes(*a, x);
            write_bytes(*b, y);
            EXPECT_EQ(x == y, a == b);
        }
    }
}

} // namespace
} // namespace spline_table_test
