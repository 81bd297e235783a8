/* SPDX-License-Identifier: MIT */
#include "random/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace random_calls {

namespace {

constexpr int64_t most_points = 1000;

struct Axis {
    int32_t degree;
    int64_t count;
    std::vector<double> knots;
    bool periodic;
};

int32_t any_degree(Random &random, int axes) {
    const int most = axes == 1 ? 31 : axes == 2 ? 15 : 7;
    return random.one_in(6) ? random.below(most + 1) : random.below(5);
}

// Steps between knots: even, any, some of them 0, close to each other, or each shorter than the one before.
std::vector<double> steps(Random &random, int64_t count, int32_t degree) {
    const int kind = random.below(6);
    std::vector<double> result;
    for (int64_t i = 0, equal = 0; i < count; ++i) {
        double step = kind == 0 ? 1 : random.unit() + 1e-3;
        if (kind == 2 && random.one_in(2) && equal < degree) {
            step = 0;
        } else if (kind == 3 && random.one_in(2)) {
            step = std::ldexp(step, -random.below(50));
        } else if (kind == 4) {
            step = std::ldexp(1, static_cast<int>(-i % 40));
        }
        equal = step == 0 ? equal + 1 : 0;
        result.push_back(step);
    }
    return result;
}

Axis any_axis(Random &random, int axes, int64_t most) {
    Axis axis{any_degree(random, axes), 0, {}, random.one_in(5)};
    const int64_t least = axis.degree + 1;
    most = std::max(most, least + 1);
    axis.count =
        random.one_in(3) ? most : least + random.below(static_cast<int>(std::min<int64_t>(most - least, 20)));
    const int form = axis.periodic ? 1 : random.below(3);
    const std::vector<double> apart = steps(random, axis.count + axis.degree, axis.degree);
    const double start = random.one_in(4) ? random.between(-1e3, 1e3) : 0;
    axis.knots.push_back(start);
    for (int64_t i = 0; i < axis.count + axis.degree; ++i) {
        const bool clamped = form != 1 && (i < axis.degree || i >= axis.count);
        axis.knots.push_back(axis.knots.back() + (clamped ? 0 : apart[static_cast<size_t>(i)]));
    }
    for (int64_t i = 0; axis.periodic && i < axis.degree; ++i) { // the last ones repeat the first ones
        const auto at = static_cast<size_t>(axis.count + 1 + i),
                   from = static_cast<size_t>(axis.degree + 1 + i);
        const double period =
            axis.knots[static_cast<size_t>(axis.count)] - axis.knots[static_cast<size_t>(axis.degree)];
        axis.knots[at] = axis.knots[from] + period;
        axis.knots[static_cast<size_t>(axis.degree - 1 - i)] =
            axis.knots[static_cast<size_t>(axis.count - 1 - i)] - period;
    }
    return axis;
}

// Component c of the point at parts u of the axes.
double coordinate(int kind, const double *u, int c, double turns, Random &random) {
    const double angle = 2 * M_PI * turns * u[0], height = u[1] + u[2];
    switch (kind) {
    case 0: // noise
        return random.between(-1, 1);
    case 1: // a line, a plane
        return c == 0 ? u[0] : c == 1 ? height : 0;
    case 2: // coils over each other
        return c == 0 ? std::cos(angle) : c == 1 ? std::sin(angle) : height;
    case 3: // a helix
        return c == 0 ? std::cos(angle) : c == 1 ? std::sin(angle) : u[0] + height;
    case 4: // steps
        return c == 0 ? u[0] : c == 1 ? std::floor(8 * u[0]) : height;
    case 5: // a sphere with poles
        return c == 0   ? std::cos(angle) * std::sin(M_PI * u[1])
               : c == 1 ? std::sin(angle) * std::sin(M_PI * u[1])
                        : std::cos(M_PI * u[1]);
    case 6: // a fold and a cusp
        return c == 0 ? u[0] * u[0] : c == 1 ? u[0] * u[0] * u[0] + height : height * height;
    case 7: // a point
        return 1;
    default: // a smooth hill
        return c == 0 ? u[0] : c == 1 ? height : std::sin(5 * u[0]) * std::cos(4 * height);
    }
}

class Shape {
public:
    Shape(Random &random, int32_t axes, int32_t dim, bool plain) : random_(random), dim_(dim) {
        int64_t left = most_points;
        for (int32_t k = 0; k < axes; ++k) {
            const auto share = static_cast<int64_t>(std::pow(static_cast<double>(left), 1.0 / (axes - k)));
            axes_.push_back(any_axis(random, axes, share));
            axes_.back().periodic = axes_.back().periodic && !plain;
            left = std::max<int64_t>(left / axes_.back().count, 1);
            total_ *= axes_.back().count;
        }
        set_points(plain);
        set_weights(plain);
    }

    [[nodiscard]] bool small() const { return total_ <= most_points; }
    nurbs *make() const {
        std::vector<int32_t> degrees;
        std::vector<int64_t> counts;
        std::vector<double> knots;
        uint32_t flags = 0;
        for (size_t k = 0; k < axes_.size(); ++k) {
            degrees.push_back(axes_[k].degree);
            counts.push_back(axes_[k].count);
            knots.insert(knots.end(), axes_[k].knots.begin(), axes_[k].knots.end());
            flags |= axes_[k].periodic ? NURBS_ON_AXIS(static_cast<int>(k), NURBS_PERIODIC) : 0;
        }
        nurbs *out = nullptr;
        const auto given = static_cast<int64_t>(knots.size());
        if (homogeneous_) {
            (void)nurbs_create_homogeneous(static_cast<int32_t>(axes_.size()), degrees.data(), counts.data(),
                                           knots.data(), given, dim_, points_.data(), 0, 0, flags, &out);
        } else {
            (void)nurbs_create(static_cast<int32_t>(axes_.size()), degrees.data(), counts.data(),
                               knots.data(), given, dim_, points_.data(), 0, 0,
                               weights_.empty() ? nullptr : weights_.data(), 0, flags, &out);
        }
        return out;
    }

private:
    // The layer that a layer of a periodic axis repeats.
    [[nodiscard]] int64_t place(size_t k, int64_t i) const {
        const Axis &axis = axes_[k];
        return axis.periodic ? i % (axis.count - axis.degree) : i;
    }
    void set_points(bool plain) {
        static constexpr double sizes[] = {1, 1, 1, 1e-3, 1e3, 1e8, 1e-8, 1e-160, 1e160};
        static constexpr double turns[] = {1, 1, 3, 50, 500};
        const int kind = random_.below(9);
        const double turn = random_.any_of(turns), size = plain ? 1 : random_.any_of(sizes);
        homogeneous_ = !plain && random_.one_in(8);
        const int width = dim_ + (homogeneous_ ? 1 : 0);
        for (int64_t i = 0; i < total_; ++i) {
            const auto [u, first] = parts(i);
            for (int c = 0; c < width; ++c) {
                const auto copy = static_cast<size_t>(first * width + c);
                const double x =
                    c == dim_ ? random_.between(0.5, 2) : size * coordinate(kind, u.data(), c, turn, random_);
                points_.push_back(first < i ? points_[copy] : x);
            }
        }
    }
    void set_weights(bool plain) {
        if (homogeneous_ || random_.one_in(2)) {
            return;
        }
        const int kind = plain ? 0 : random_.below(4);
        for (int64_t i = 0; i < total_; ++i) {
            const int64_t first = parts(i).first_like;
            const double mild = random_.between(0.5, 2);
            const double w = kind == 1                        ? std::pow(10, random_.between(-12, 12))
                             : kind == 2 && random_.one_in(8) ? 0
                                                              : mild;
            weights_.push_back(first < i ? weights_[static_cast<size_t>(first)] : w);
        }
    }
    struct Parts {
        std::array<double, 3> u;
        int64_t first_like; // the control point that this one is a copy of, on periodic axes
    };
    [[nodiscard]] Parts parts(int64_t i) const {
        Parts result{{0, 0, 0}, 0};
        int64_t rest = i, stride = 1;
        for (size_t k = axes_.size(); k-- > 0; rest /= axes_[k].count) {
            const int64_t at = place(k, rest % axes_[k].count);
            result.u[k] =
                static_cast<double>(at) / static_cast<double>(std::max<int64_t>(axes_[k].count - 1, 1));
            result.first_like += at * stride;
            stride *= axes_[k].count;
        }
        return result;
    }

    Random &random_;
    int32_t dim_;
    int64_t total_ = 1;
    std::vector<Axis> axes_;
    std::vector<double> points_, weights_;
    bool homogeneous_ = false;
};

} // namespace

nurbs *random_shape(Random &random, int32_t axes, int32_t dim) {
    for (int trial = 0; trial < 1000; ++trial) {
        const Shape shape(random, axes, dim, trial > 20);
        if (nurbs *made = shape.small() ? shape.make() : nullptr) {
            return made;
        }
    }
    std::fprintf(stderr, "no random shape of %d axes in %d dimensions can be made\n", axes, dim);
    std::abort();
}

} // namespace random_calls
