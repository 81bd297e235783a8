// Bezier splines for tests of pairs of them.
#pragma once

#include "spline/spline.h"
#include "support/generators.h"

namespace random_pieces {

using namespace nrb;
using support::Random;

// A Bezier spline near a place, bent by `size`.
inline SplinePtr random_piece(Random &random, int axes, double height, double size, bool rational) {
    Spline::Axes knots;
    int64_t count = 1;
    for (int k = 0; k < axes; ++k) {
        const int degree = random.whole(1, 3);
        std::vector<double> vector(static_cast<size_t>(degree) + 1, 0.0);
        vector.insert(vector.end(), static_cast<size_t>(degree) + 1, 1.0);
        knots.push_back(make_knot_vector(degree, vector));
        count *= degree + 1;
    }
    std::vector<double> points, weights;
    for (int64_t i = 0; i < count; ++i) {
        int64_t rest = i;
        double place[3] = {0, 0, height + size * random.between(-1, 1)};
        for (int k = axes; k-- > 0;) {
            const int64_t n = knots[static_cast<size_t>(k)]->count();
            place[k] =
                static_cast<double>(rest % n) / static_cast<double>(n - 1) + size * random.between(-1, 1);
            rest /= n;
        }
        points.insert(points.end(), place, place + 3);
        if (rational) {
            weights.push_back(random.between(0.8, 1.25));
        }
    }
    return make_spline(knots, 3, rational ? Form::rational : Form::polynomial, points, weights);
}

} // namespace random_pieces
