// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace ends {

void good(nurbs_status status) {
    if (status != NURBS_OK) {
        std::array<char, 1000> text{};
        nurbs_last_error(text.data(), text.size());
        std::fprintf(stderr, "%s: %s\n", nurbs_status_name(status), text.data());
        std::_Exit(2);
    }
}

namespace {

std::vector<double> open_knots(int degree, int64_t count) {
    std::vector<double> knots(static_cast<size_t>(count + degree + 1));
    good(nurbs_knots_open_uniform(degree, count, 0, 1, count + degree + 1, knots.data()));
    return knots;
}

std::vector<double> greville(const std::vector<double> &knots, int degree) {
    std::vector<double> at(knots.size() - static_cast<size_t>(degree) - 1);
    for (size_t i = 0; i < at.size(); ++i) {
        for (size_t j = 1; j <= static_cast<size_t>(degree); ++j) {
            at[i] += knots[i + j] / degree;
        }
    }
    return at;
}

double sine(double x) {
    return std::sin(x);
}

} // namespace

Shape make(int axes, int degree, int64_t count, int dim, bool rational, const Net &net) {
    const std::vector<double> one = open_knots(degree, count), at = greville(one, degree);
    std::vector<double> knots, points, weights;
    int64_t total = 1;
    for (int k = 0; k < axes; ++k) {
        knots.insert(knots.end(), one.begin(), one.end());
        total *= count;
    }
    points.resize(static_cast<size_t>(total * dim));
    weights.resize(static_cast<size_t>(total), 1.0);
    for (int64_t i = 0; i < total; ++i) {
        std::array<double, 3> place{};
        int64_t rest = i;
        for (int k = axes - 1; k >= 0; --k, rest /= count) {
            place[static_cast<size_t>(k)] = at[static_cast<size_t>(rest % count)];
        }
        net(place.data(), points.data() + i * dim, weights.data() + i);
    }
    const std::array<int32_t, 3> degrees{degree, degree, degree};
    const std::array<int64_t, 3> counts{count, count, count};
    nurbs *g = nullptr;
    good(nurbs_create(axes, degrees.data(), counts.data(), knots.data(), static_cast<int64_t>(knots.size()),
                      dim, points.data(), 0, 0, rational ? weights.data() : nullptr, 0, 0, &g));
    return Shape(g);
}

double random_number() {
    static uint64_t state = 1;
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11) * 0x1p-52 - 1;
}

namespace {

double random_weight(double ratio) {
    return std::pow(ratio, random_number() / 2);
}

} // namespace

Shape noise(int axes, int degree, int64_t count, int dim, double weights) {
    return make(axes, degree, count, dim, weights > 1, [=](const double *, double *point, double *weight) {
        for (int c = 0; c < dim; ++c) {
            point[c] = random_number();
        }
        *weight = random_weight(weights);
    });
}

Shape wave(int degree, int64_t count, double shift) {
    return make(1, degree, count, 3, false, [=](const double *at, double *point, double *) {
        point[0] = at[0];
        point[1] = sine(20 * at[0]);
        point[2] = sine(17 * at[0] + 1) + shift;
    });
}

Shape hill(int degree, int64_t count) {
    return make(2, degree, count, 3, false, [](const double *at, double *point, double *) {
        point[0] = at[0];
        point[1] = at[1];
        point[2] = 0.2 * sine(9 * at[0]) * sine(7 * at[1]);
    });
}

Shape block(int degree, int64_t count, double weights) {
    return make(3, degree, count, 3, weights != 1, [=](const double *at, double *point, double *weight) {
        for (size_t k = 0; k < 3; ++k) {
            point[k] = at[k] + 0.05 * sine(5 * at[(k + 1) % 3]);
        }
        *weight = random_number() > 0 ? 1 : weights;
    });
}

Shape circle(double radius) {
    nurbs *g = nullptr;
    good(nurbs_curve_circle(3, nullptr, nullptr, nullptr, radius, 0, &g));
    return Shape(g);
}

Shape repeated(const nurbs *curve, int64_t times) {
    const std::vector<const nurbs *> parts(static_cast<size_t>(times), curve);
    nurbs *g = nullptr;
    good(nurbs_join(times, parts.data(), 0, 1e-9, 0, nullptr, &g));
    return Shape(g);
}

Shape coils(int64_t turns) {
    constexpr int64_t points_of_a_turn = 20;
    return make(1, 3, turns * points_of_a_turn, 3, false, [=](const double *at, double *point, double *) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(turns) * at[0];
        point[0] = std::cos(angle);
        point[1] = std::sin(angle);
        point[2] = 1e-3 * at[0];
    });
}

Shape sphere(double radius) {
    nurbs *g = nullptr;
    good(nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, 0, &g));
    return Shape(g);
}

Shape refined(const nurbs *g, int64_t parts) {
    int32_t axes = 0;
    good(nurbs_axes(g, &axes));
    nurbs *fine = nullptr;
    good(nurbs_clone(g, &fine));
    Shape result(fine);
    for (int32_t k = 0; k < axes; ++k) {
        good(nurbs_refine_uniform(result.get(), k, parts, &fine));
        result.reset(fine);
    }
    return result;
}

Shape moved(const nurbs *g, double scale, std::array<double, 3> by) {
    const std::array<double, 9> matrix{scale, 0, 0, 0, scale, 0, 0, 0, scale};
    nurbs *out = nullptr;
    good(nurbs_transform(g, 3, matrix.data(), by.data(), &out));
    return Shape(out);
}

} // namespace ends
