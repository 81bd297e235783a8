// Random splines and parameters, most of them close to some degeneracy. Everything follows from one printed
// 64-bit seed.
#pragma once

#include "support/spline_data.h"

#include <cstdint>
#include <random>
#include <vector>

namespace support {

// std::mt19937_64 has the same stream everywhere; the standard distributions have not, so these are written
// out.
class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    uint64_t bits() { return engine_(); }
    int whole(int low, int high); // low <= result <= high
    bool chance(int percent) { return whole(1, 100) <= percent; }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; } // [0, 1), 53 random bits
    double between(double low, double high) { return low + (high - low) * unit(); }
    double magnitude(double low, double high); // random logarithm

private:
    std::mt19937_64 engine_;
};

enum class KnotForm { clamped, half_clamped, unclamped, periodic };
enum class Spacing {
    integers,
    few_bits,
    full,
    ratio,
    tiny
}; // ratio: spans from 1 to 1e8; tiny: some 1e-9 of the rest
enum class Placement { origin, offset, small, large };           // offset 1e6; scales 1e-9 and 1e9
enum class Weights { none, ones, moderate, extreme, some_zero }; // extreme: 1e-6 to 1e6

struct AxisRecipe {
    int degree = 3;
    KnotForm form = KnotForm::clamped;
    Spacing spacing = Spacing::full;
    Placement placement = Placement::origin;
    int spans = 4; // about; repeated knots make fewer
};

struct Recipe {
    std::vector<AxisRecipe> axes;
    Weights weights = Weights::none;
    int dim = 3;
    bool short_numbers = false; // coordinates and weights of few significant bits
};

// A valid full knot vector; knots inside may occur up to degree + 1 times.
std::vector<double> random_knots(Random &random, const AxisRecipe &recipe);
SplineData random_spline(Random &random, const Recipe &recipe);

AxisRecipe random_axis(Random &random, int degree);
// A recipe with every choice at random; degrees in [0, max_degree].
Recipe random_recipe(Random &random, int axes, int max_degree);

// A parameter of the domain of one axis: at random, at a knot, one step beside a knot, at an end or near one.
double random_param(Random &random, const std::vector<double> &knots, int degree);
// Such a parameter as a knot to insert. On a periodic axis one that lies within rounding of a knot becomes
// that knot: one period away the two could not be told apart.
double random_new_knot(Random &random, const SplineData &data, int axis);
// 0 in place of parameters so close to it that products with them underflow, where relative bounds end.
double away_from_underflow(double t);
std::vector<double> away_from_underflow(std::vector<double> params);
// n parameters of a spline, packed.
std::vector<double> random_params(Random &random, const SplineData &data, int n);

} // namespace support
