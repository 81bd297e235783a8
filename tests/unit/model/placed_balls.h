// A ball that is placed in the whole, and in a part that is placed in it, by random maps; its equation under them.
#pragma once

#include "build/surfaces/quadrics.h"
#include "model/from_faces.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace placed_balls {

using namespace nrb;
using namespace nrb::model;

using Rows = std::array<double, 12>;

inline constexpr double radius = 1.25;

// A ball that is placed in the whole once.
inline Model one_ball(const Rows &placement) {
    const SplinePtr ball =
        build::sphere(build::make_placement(3, nullptr, nullptr, nullptr, "centre"), radius, 0);
    Model model =
        model_of_faces({std::make_shared<const face::Face>(face::FaceParts{ball, {}, 1e-9}, nullptr)}, 1);
    model.uses = {{-1, 0, placement, ""}};
    return model;
}

// A ball, and an empty part. The ball is placed in the whole once, and twice in the empty part, which is placed twice.
inline Model balls(const std::array<Rows, 5> &placements) {
    Model model = one_ball(placements[0]);
    model.parts.emplace_back();
    model.uses = {{-1, 0, placements[0], ""},
                  {-1, 1, placements[1], ""},
                  {-1, 1, placements[2], ""},
                  {1, 0, placements[3], ""},
                  {1, 0, placements[4], ""}};
    return model;
}

class Numbers {
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}
    double between(double lower, double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(engine_);
    }
    Vector3 point(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
    // Turned by three angles, scaled, moved; perhaps mirrored, or sheared.
    Rows placement(bool similar) {
        Rows rows{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        for (size_t axis = 0; axis < 3; ++axis) {
            const double angle = between(-3, 3);
            const size_t a = 4 * ((axis + 1) % 3), b = 4 * ((axis + 2) % 3);
            for (size_t k = 0; k < 3; ++k) {
                const double x = rows[a + k], y = rows[b + k];
                rows[a + k] = std::cos(angle) * x - std::sin(angle) * y;
                rows[b + k] = std::sin(angle) * x + std::cos(angle) * y;
            }
        }
        const double scale = between(0.5, 2) * (between(-1, 1) < 0 ? -1 : 1),
                     shear = similar ? 0 : between(-0.5, 0.5);
        for (size_t i = 0; i < 3; ++i) {
            rows[4 * i] += shear * rows[4 * i + 1];
            for (size_t k = 0; k < 3; ++k) {
                rows[4 * i + k] *= scale;
            }
            rows[4 * i + 3] = between(-4, 4);
        }
        return rows;
    }

private:
    std::mt19937 engine_;
};

using Long = std::array<long double, 3>;

// The inverse image, by Cramer's rule.
inline Long inverse(const Rows &p, const Long &x) {
    const auto m = [&](size_t i, size_t j) { return static_cast<long double>(p[4 * i + j]); };
    const auto determinant = [](const Long &a, const Long &b, const Long &c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    const std::array<Long, 3> columns{Long{m(0, 0), m(1, 0), m(2, 0)}, Long{m(0, 1), m(1, 1), m(2, 1)},
                                      Long{m(0, 2), m(1, 2), m(2, 2)}};
    const long double whole = determinant(columns[0], columns[1], columns[2]);
    Long result{};
    for (size_t k = 0; k < 3; ++k) {
        std::array<Long, 3> other = columns;
        other[k] = x;
        result[k] = determinant(other[0], other[1], other[2]) / whole;
    }
    return result;
}

// In the ball, through all uses on the way from the whole.
inline Long in_ball(const std::array<Rows, 5> &placements, const std::vector<size_t> &way, const Vector3 &x,
                    bool direction) {
    Long at{x.x, x.y, x.z};
    for (const size_t use : way) {
        for (size_t k = 0; k < 3 && !direction; ++k) {
            at[k] -= static_cast<long double>(placements[use][4 * k + 3]);
        }
        at = inverse(placements[use], at);
    }
    return at;
}

// In the order of the instances: that of the whole, and those in the empty part, each after it.
inline const std::vector<std::vector<size_t>> &ways() {
    static const std::vector<std::vector<size_t>> all{{0}, {1, 3}, {1, 4}, {2, 3}, {2, 4}};
    return all;
}
inline constexpr std::array<int64_t, 5> numbers_of_instances{0, 2, 3, 5, 6};

inline std::array<Rows, 5> placements(Numbers &random, bool similar) {
    std::array<Rows, 5> all{};
    for (Rows &rows : all) {
        rows = random.placement(similar);
    }
    return all;
}

} // namespace placed_balls
