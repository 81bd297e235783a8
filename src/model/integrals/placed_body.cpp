// SPDX-License-Identifier: MIT
#include "model/integrals/placed_body.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "model/model.h"
#include "numeric/norm.h"
#include "numeric/sum.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// The least exponent with |x| < 2^exponent; -2000 for 0.
int exponent_of(double x) noexcept {
    int exponent = 0;
    std::frexp(x, &exponent);
    return x == 0 ? -2000 : exponent;
}

// The cofactor matrix det(M) M^-T, which maps vector areas.
Matrix cofactors(const Matrix &m) noexcept {
    Matrix c{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            const size_t a = (i + 1) % 3, b = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
            c[i][j] = m[a][p] * m[b][q] - m[a][q] * m[b][p];
        }
    }
    return c;
}

std::array<double, 3> product(const Matrix &m, const std::array<double, 3> &x) noexcept {
    std::array<double, 3> y{};
    for (size_t i = 0; i < 3; ++i) {
        y[i] = m[i][0] * x[0] + m[i][1] * x[1] + m[i][2] * x[2];
    }
    return y;
}

// M S M^T.
Matrix conjugate(const Matrix &m, const Matrix &s) noexcept {
    Matrix result{};
    for (size_t i = 0; i < 3; ++i) {
        const std::array<double, 3> row = product(s, m[i]);
        result[i] = product(m, row);
    }
    return result;
}

// The same body in units of 2^exponent. Precondition: these are no smaller than its own.
Body in_units(Body body, int exponent) noexcept {
    const int by = body.exponent - exponent;
    for (size_t i = 0; i < 3; ++i) {
        body.centroid[i] = std::ldexp(body.centroid[i], by);
        body.vector_area[i] = std::ldexp(body.vector_area[i], 2 * by);
        for (double &x : body.second[i]) {
            x = std::ldexp(x, 5 * by);
        }
    }
    body.volume = std::ldexp(body.volume, 3 * by);
    body.error = std::ldexp(body.error, 3 * by);
    body.exponent = exponent;
    return body;
}

void add_second(const Body &body, const std::array<double, 3> &centroid, Matrix &sum) noexcept {
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            sum[i][j] += body.second[i][j] +
                         body.volume * (body.centroid[i] - centroid[i]) * (body.centroid[j] - centroid[j]);
        }
    }
}

// The inertia tensor trace(S) E - S, where E is the identity, from second moments S in units of 2^power.
std::vector<double> inertia_of(const Matrix &second, int power) {
    std::vector<double> inertia;
    const double trace = second[0][0] + second[1][1] + second[2][2];
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            inertia.push_back(std::ldexp((i == j ? trace : 0) - second[i][j], power) + 0.0);
        }
    }
    return inertia;
}

void require_finite(const measure::Moments &found) {
    require_representable({&found.content, 1}, "volume");
    require_representable(found.centroid, "centroid");
    require_representable(found.inertia, "inertia");
    require_representable({&found.openness, 1}, "openness");
}

void add_moments(const std::vector<Body> &bodies, double volume, measure::MomentOrder order,
                 measure::Moments &out) {
    if (!(volume > 0)) {
        fail(Status::length, "the volume is %s, expected another than 0 for a centroid", Number(volume).text);
    }
    const int exponent = bodies.front().exponent;
    std::array<double, 3> centroid{};
    for (size_t i = 0; i < 3; ++i) {
        CompensatedSum sum;
        for (const Body &body : bodies) {
            sum.add(body.volume / volume * body.centroid[i]);
        }
        centroid[i] = sum.value();
        out.centroid.push_back(std::ldexp(centroid[i], exponent));
    }
    if (order == measure::MomentOrder::inertia) {
        Matrix second{};
        for (const Body &body : bodies) {
            add_second(body, centroid, second);
        }
        out.inertia = inertia_of(second, 5 * exponent);
    }
}

} // namespace

Body placed(const Body &body, const std::array<double, 12> &placement) {
    if (placement == Use{}.placement) {
        return body;
    }
    int size = -2000, away = -2000;
    for (size_t i = 0; i < 12; ++i) {
        (i % 4 == 3 ? away : size) = std::max(i % 4 == 3 ? away : size, exponent_of(placement[i]));
    }
    Matrix m{};
    for (size_t i = 0; i < 12; ++i) {
        if (i % 4 != 3) {
            m[i / 4][i % 4] = std::ldexp(placement[i], -size);
        }
    }
    const Matrix c = cofactors(m);
    const double factor = std::abs(m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2]);
    Body moved{body.exponent + size, factor * body.volume, factor * (body.error + 32 * eps * body.volume)};
    moved.centroid = product(m, body.centroid);
    moved.vector_area = product(c, body.vector_area);
    moved.second = conjugate(m, body.second);
    for (auto &row : moved.second) {
        for (double &x : row) {
            x *= factor;
        }
    }
    moved = in_units(moved, std::max(moved.exponent, away));
    for (size_t i = 0; i < 3; ++i) {
        moved.centroid[i] += std::ldexp(placement[4 * i + 3], -moved.exponent);
    }
    return moved;
}

measure::Moments moments_of(const std::vector<Body> &bodies, measure::MomentOrder order) {
    int exponent = -5000;
    for (const Body &body : bodies) {
        exponent = std::max(exponent, body.exponent);
    }
    std::vector<Body> all;
    CompensatedSum volume, error, openness;
    for (const Body &body : bodies) {
        all.push_back(in_units(body, exponent));
        volume.add(all.back().volume);
        error.add(all.back().error);
        openness.add(norm(all.back().vector_area.data(), 3));
    }
    measure::Moments found;
    found.content = std::ldexp(volume.value(), 3 * exponent);
    found.error = std::ldexp(error.value(), 3 * exponent);
    found.openness = std::ldexp(openness.value(), 2 * exponent);
    if (order != measure::MomentOrder::content) {
        add_moments(all, volume.value(), order, found);
    }
    require_finite(found);
    return found;
}

} // namespace nrb::model
