/* SPDX-License-Identifier: MIT */
// A spline whose answers are recorded, and arguments that suit it: parameters, points near it, other splines.
// All follow from the spline and a seed.
#ifndef NURBS_TESTS_CAPI_RECORDED_SUBJECT_H
#define NURBS_TESTS_CAPI_RECORDED_SUBJECT_H

#include "support/generators.h"

#include <nurbs/nurbs.h>

#include <cstdint>
#include <vector>

namespace recorded {

// What is free again at the end, NULL if it could not be made.
class Owned {
public:
    Owned() = default;
    Owned(const Owned &) = delete;
    Owned &operator=(const Owned &) = delete;
    Owned(Owned &&other) noexcept : g_(other.g_) { other.g_ = nullptr; }
    ~Owned() { nurbs_destroy(g_); }
    [[nodiscard]] nurbs **place() { return &g_; }
    operator const nurbs *() const { return g_; }

private:
    nurbs *g_ = nullptr;
};

struct AxisFacts {
    int32_t degree = 0;
    int64_t count = 0;
    std::vector<double> knots;
    double lower = 0, upper = 0; // of the domain
};

class Subject {
public:
    Subject(const nurbs *spline, uint64_t seed);

    const nurbs *g;
    int32_t axes = 0, dim = 0;
    int64_t points = 0;
    bool rational = false;
    bool even = true;   // weights that differ by no more than a small factor
    bool large = false; // so many points that some calls take tenths of a second
    std::vector<AxisFacts> axis;
    std::vector<double> control; // Cartesian control points
    std::vector<double> center;  // of their box
    double size = 1;             // of its longest side
    Owned image, part;           // moved and turned, the whole and a part

    // At a fraction of the domain.
    [[nodiscard]] double at(int32_t k, double fraction) const;
    [[nodiscard]] std::vector<double> middle(double fraction) const; // on every axis
    // Records of a parameter for each axis: ends, knots and beside them, and any others.
    [[nodiscard]] std::vector<double> params(int n) const;
    // The same, some of them outside the domain.
    [[nodiscard]] std::vector<double> outside(int n) const;
    // Parameters of each axis for a grid.
    [[nodiscard]] std::vector<double> grid(const int64_t *counts) const;
    // The part of the domain between two fractions: [axes][2].
    [[nodiscard]] std::vector<double> range(double from, double to) const;
    // Points in and about the box.
    [[nodiscard]] std::vector<double> near(int n) const;
    // Numbers in (-1, 1).
    [[nodiscard]] std::vector<double> numbers(int64_t n) const;
    // A direction, one of many, of a component for each dimension or a given number of them.
    [[nodiscard]] std::vector<double> direction(int which, int32_t components = 0) const;

private:
    void ask();
    void measure();
    void make_others();

    uint64_t seed_;
};

} // namespace recorded

#endif
