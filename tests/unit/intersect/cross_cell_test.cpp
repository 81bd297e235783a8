// What rounding may do to parts of surfaces, beyond their pieces too.
#include "intersect/surfaces/cross_arc.h"
#include "unit/shapes.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace cross_cell_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

SplinePtr random_patch(std::mt19937 &engine, int degree) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const int count = (degree + 1) * (degree + 1);
    std::vector<double> points, weights;
    for (int i = 0; i < count; ++i) {
        points.insert(points.end(), {unit(engine), unit(engine), unit(engine)});
        weights.push_back(1 + 0x1p-20 * unit(engine));
    }
    const KnotVectorPtr axis = shapes::bezier_axis(degree);
    return make_spline({axis, axis}, 3, Form::rational, std::move(points), std::move(weights));
}

std::vector<long double> bernstein(int degree, double t) {
    std::vector<long double> values{1};
    for (int n = 1; n <= degree; ++n) {
        values.push_back(0);
        for (size_t i = values.size(); i-- > 0;) {
            values[i] = (1 - static_cast<long double>(t)) * values[i] + (i > 0 ? t * values[i - 1] : 0);
        }
    }
    return values;
}

// With eleven more digits.
std::array<long double, 3> point_of(const CrossPiece &piece, const std::array<double, 2> &place) {
    const std::vector<long double> u = bernstein(piece.degrees[0], place[0]),
                                   v = bernstein(piece.degrees[1], place[1]);
    std::array<long double, 4> sum{};
    const double *record = piece.piece.record(0);
    for (const long double f : u) {
        for (const long double g : v) {
            for (size_t c = 0; c < 4; ++c) {
                sum[c] += f * g * *record++;
            }
        }
    }
    return {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
}

class Patch {
public:
    Patch(SplinePtr spline, const pieces::Frame &frame) : spline_(std::move(spline)), frame_(frame) {}
    [[nodiscard]] const CrossPiece &piece() { return *ground_.piece({0, 0}); }

private:
    SplinePtr spline_;
    pieces::Frame frame_;
    SurfaceBorders borders_{pieces::piece_grid_of(*spline_)};
    CrossGround ground_{*spline_, frame_, borders_, side_shifts[0]};
};

} // namespace

TEST(CrossCell, differences_are_right_beyond_pieces) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> in_wide_part(-widening, 1 + widening);
    for (const int degree : {1, 3, 9, 20}) {
        SCOPED_TRACE(degree);
        const SplinePtr first = random_patch(engine, degree), second = random_patch(engine, degree);
        const pieces::Frame frame = pieces::frame_of({{first.get(), second.get()}});
        Patch a(first, frame), b(second, frame);
        CrossCell of_a(a.piece(), {Interval{0, 1}, Interval{0, 1}}),
            of_b(b.piece(), {Interval{0, 0.25}, Interval{0.5, 1}});
        ASSERT_TRUE(of_a.prepare() && of_b.prepare());
        CrossBox box{&of_a, &of_b, {}};
        box.chart.set(of_a, of_b);
        for (int i = 0; i < 200; ++i) {
            CrossPlace z{};
            for (double &x : z) {
                x = i < 16 ? (engine() % 2 == 0 ? -widening : 1 + widening) : in_wide_part(engine);
            }
            const auto exact_a = point_of(a.piece(), of_a.in_piece(z.data())),
                       exact_b = point_of(b.piece(), of_b.in_piece(z.data() + 2));
            const Vector3 found = box.at(z).difference;
            const std::array<double, 3> off{static_cast<double>(found.x - (exact_a[0] - exact_b[0])),
                                            static_cast<double>(found.y - (exact_a[1] - exact_b[1])),
                                            static_cast<double>(found.z - (exact_a[2] - exact_b[2]))};
            EXPECT_LE(std::hypot(off[0], off[1], off[2]), box.chart.near());
        }
    }
}

} // namespace cross_cell_unit_test
