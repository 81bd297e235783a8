// A spline as plain arrays: what the tests generate, hand to the library and compare with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace support {

// The arguments of nurbs_create(), apart from strides. Empty weights: polynomial.
struct SplineData {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<std::vector<double>> knots; // one full vector per axis
    int32_t dim = 0;
    std::vector<double> points; // packed, last axis fastest
    std::vector<double> weights;
    uint32_t flags = 0;

    [[nodiscard]] int axes() const { return static_cast<int>(degrees.size()); }
    [[nodiscard]] int64_t point_count() const;
    [[nodiscard]] bool rational() const { return !weights.empty(); }
    [[nodiscard]] bool periodic(int axis) const;
    [[nodiscard]] std::vector<double> all_knots() const; // the axes one after the other
    [[nodiscard]] double lower(int axis) const;
    [[nodiscard]] double upper(int axis) const;
    [[nodiscard]] double weight(int64_t i) const {
        return rational() ? weights[static_cast<size_t>(i)] : 1.0;
    }
    [[nodiscard]] double coordinate(int64_t i, int c) const {
        return points[static_cast<size_t>(i * dim + c)];
    }
};

// The largest magnitude of a stored coordinate.
double extent(const SplineData &data);
// Every coordinate times `size`, all knots times `speed`.
SplineData scaled(SplineData data, double size, double speed = 1);

// Multi-indices of all derivatives up to `order`, in the graded order of nurbs_eval_derivs(), by its
// formulas.
using MultiIndex = std::vector<int>;
std::vector<MultiIndex> graded_indices(int axes, int order);
// Place of a multi-index in that order.
int64_t slot_of(const MultiIndex &index);
// The slots of all b with 0 < b <= a, each with the product of the binomials (a_k over b_k); for the quotient
// rule.
struct LeibnizTerm {
    MultiIndex b;
    MultiIndex rest; // a - b
    int64_t factor;
};
std::vector<LeibnizTerm> leibniz_terms(const MultiIndex &a);
int64_t binomial(int n, int k);

// Every value in hexadecimal, so that a failing case can be typed in again bit for bit.
std::string hex(double x);
std::string hex(const std::vector<double> &values);
std::string describe(const SplineData &data);

} // namespace support
