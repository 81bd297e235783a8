// SPDX-License-Identifier: MIT
#include "intersect/rays/ray_solver.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr int most_boxes = 4000; // per ray
constexpr int most_depth = 60;
constexpr size_t lanes = TurnedPatches::lanes;

// The first three coordinates of a record.
Vector3 vector_of(const double *record) noexcept {
    return {record[0], record[1], record[2]};
}

} // namespace

RaySolver::RaySolver(const pieces::PieceGrid &grid)
    : grid_(grid), shape_(grid.shape()), count_(shape_.coefficients()),
      size_(static_cast<size_t>(shape_.values())), patches_(grid) {
    work_.resize(static_cast<size_t>(pieces::evaluation_work(shape_)));
    point_.resize(4 * lanes);
    memory_.resize(8 * size_);
}

void RaySolver::set_ray(const PlacedRay &ray) {
    patches_.set_ray(ray);
    noise_ = ray.room(grid_);
    reach_ = grid_.radius() + length(ray.ray.origin);
    boxes_ = most_boxes;
}

void RaySolver::begin(int64_t piece) {
    piece_ = piece;
    patches_.fill(piece, values(0));
    stack_.assign(1, Part{{0, 0}, {1, 1}, noise_, 0});
    count_work(16 * count_);
}

RaySolver::Ranges RaySolver::ranges(const double *v, double noise) const noexcept {
    Ranges r{infinity, 0, infinity, -infinity, 0, false};
    bool above[2] = {true, true}, below[2] = {true, true};
    for (int64_t i = 0; i < count_; ++i, v += lanes) {
        if (!patches_.has_point(v)) {
            continue;
        }
        const double w = v[3], room = noise * w;
        r.least_weight = std::min(r.least_weight, w);
        r.most_weight = std::max(r.most_weight, w);
        for (size_t k = 0; k < 2; ++k) {
            above[k] = above[k] && v[k] > room;
            below[k] = below[k] && v[k] < -room;
        }
        const double t = v[2] / w;
        r.nearest = std::min(r.nearest, t);
        r.farthest = std::max(r.farthest, t);
        r.size = std::max(r.size, std::max(std::abs(v[0]), std::abs(v[1])) / w);
    }
    r.misses = above[0] || above[1] || below[0] || below[1];
    return r;
}

RaySolver::Verdict RaySolver::look(double lower, double upper) {
    const Part &part = stack_.back();
    --boxes_;
    count_work(40 * count_);
    const double *v = values(stack_.size() - 1);
    const Ranges r = ranges(v, part.moved);
    const int most = shape_.axes > 0 ? most_depth : 0; // a piece that is a single point has no halves
    const bool certain =
        grid_.positive() ? r.least_weight > 0 : r.least_weight > 64 * grid_.rounding().weight;
    if (!certain) {
        if (part.depth < most / 4) {
            return Verdict::open;
        }
        set_touch({1, 1, lower, upper, 0, false});
        return Verdict::meet;
    }
    if (r.misses || r.nearest - part.moved > upper || r.farthest + part.moved < lower) {
        return Verdict::nothing;
    }
    const double error = part.moved * r.most_weight;
    const Chart chart = this->chart(v, error);
    if (chart.contraction.proven()) {
        const Verdict verdict =
            excludes(chart, v, part.moved) ? Verdict::nothing : meet_by(chart, v, error, {lower, upper});
        if (verdict != Verdict::open) {
            return verdict;
        }
    }
    if (r.size <= 4 * part.moved || part.depth >= most) {
        set_touch(r);
        return Verdict::meet;
    }
    return Verdict::open;
}

// The mean derivative follows from the corners. Coefficients of derivatives are differences of two
// coefficients, each of which is off by the noise.
RaySolver::Chart RaySolver::chart(const double *v, double noise_of_f) const noexcept {
    Chart chart{};
    if (shape_.axes < 2) {
        return chart;
    }
    const int p = shape_.degree(0), q = shape_.degree(1);
    const auto at = [&](int i, int j) { return v + (i * (q + 1) + j) * static_cast<int>(lanes); };
    double mean[2][2];
    for (int k = 0; k < 2; ++k) {
        mean[k][0] = (at(p, 0)[k] + at(p, q)[k] - at(0, 0)[k] - at(0, q)[k]) / 2;
        mean[k][1] = (at(0, q)[k] + at(p, q)[k] - at(0, 0)[k] - at(p, 0)[k]) / 2;
    }
    const double determinant = mean[0][0] * mean[1][1] - mean[0][1] * mean[1][0];
    const double size =
        (std::abs(mean[0][0]) + std::abs(mean[1][0])) * (std::abs(mean[0][1]) + std::abs(mean[1][1]));
    if (!(std::abs(determinant) > 1e-12 * size)) {
        return chart;
    }
    chart.m[0][0] = mean[1][1] / determinant;
    chart.m[0][1] = -mean[0][1] / determinant;
    chart.m[1][0] = -mean[1][0] / determinant;
    chart.m[1][1] = mean[0][0] / determinant;
    double off[2][2] = {};
    const auto add = [&](int axis, int degree, const double *from, const double *to) {
        const double x = degree * (to[0] - from[0]), y = degree * (to[1] - from[1]);
        for (int k = 0; k < 2; ++k) {
            const double entry = chart.m[k][0] * x + chart.m[k][1] * y - (k == axis ? 1 : 0);
            off[k][axis] = std::max(off[k][axis], std::abs(entry));
        }
    };
    for (int i = 0; i <= p; ++i) {
        for (int j = 0; j <= q; ++j) {
            if (i < p) {
                add(0, p, at(i, j), at(i + 1, j));
            }
            if (j < q) {
                add(1, q, at(i, j), at(i, j + 1));
            }
        }
    }
    auto &[rho, norm] = chart.contraction;
    rho = 0;
    for (int k = 0; k < 2; ++k) {
        const double row = std::abs(chart.m[k][0]) + std::abs(chart.m[k][1]);
        norm = std::max(norm, row);
        rho = std::max(rho, off[k][0] + off[k][1] + 2.1 * (p + q) * row * noise_of_f + 64 * eps);
    }
    return chart;
}

// Whether a row of M F has one sign, beyond the noise.
bool RaySolver::excludes(const Chart &chart, const double *v, double noise) const noexcept {
    for (int k = 0; k < 2; ++k) {
        const double a = chart.m[k][0], b = chart.m[k][1], room = 1.01 * noise * (std::abs(a) + std::abs(b));
        bool above = true, below = true;
        const double *record = v;
        for (int64_t i = 0; i < count_; ++i, record += lanes) {
            const double x = a * record[0] + b * record[1];
            above = above && (x > room * record[3] || !patches_.has_point(record));
            below = below && (x < -room * record[3] || !patches_.has_point(record));
        }
        if (above || below) {
            return true;
        }
    }
    return false;
}

// M F, from the first two values of point_.
Place<2> RaySolver::fixed_step(const Chart &chart) const noexcept {
    const double *f = point_.data();
    return {chart.m[0][0] * f[0] + chart.m[0][1] * f[1], chart.m[1][0] * f[0] + chart.m[1][1] * f[1]};
}

// point_ becomes (F, t w, w) and its derivatives at the place returned.
Place<2> RaySolver::approach(const Chart &chart, const double *v) {
    const auto fixed = [&](const Place<2> &at) {
        pieces::evaluate_patch(shape_, v, {at[0], at[1], 0}, 1, work_.data(), point_.data());
        return fixed_step(chart);
    };
    const auto newton = [&]() -> Place<2> {
        const double *f = point_.data(), *by_u = f + lanes, *by_v = by_u + lanes;
        const double determinant = by_u[0] * by_v[1] - by_u[1] * by_v[0];
        if (determinant == 0) {
            return fixed_step(chart);
        }
        return {(f[0] * by_v[1] - f[1] * by_v[0]) / determinant,
                (f[1] * by_u[0] - f[0] * by_u[1]) / determinant};
    };
    return approached<2>(fixed, newton);
}

// Open if the approach ends at a side of the part without a proof that ray and part are disjoint: the bound
// is sharper for the halves. The same holds near weights that almost vanish.
RaySolver::Verdict RaySolver::meet_by(const Chart &chart, const double *v, double error, Interval range) {
    const Place<2> z = approach(chart, v);
    const double *f = point_.data();
    const Place<2> step = fixed_step(chart);
    const Box<2> exact = chart.contraction.solutions(z, step, 1.01 * error);
    if (outside(exact)) {
        return Verdict::nothing;
    }
    const double away = std::hypot(f[0], f[1]) / f[3], t = f[2] / f[3];
    if (largest(step) > 4.04 * chart.contraction.norm * error + 64 * eps || !(away <= 8 * noise_)) {
        return Verdict::open;
    }
    if (t < range.lower - noise_ || t > range.upper + noise_) {
        return Verdict::nothing;
    }
    set_meet(z, exact);
    return Verdict::meet;
}

void RaySolver::set_meet(const Place<2> &z, const Box<2> &exact) {
    const double *f = point_.data(), *by_u = f + lanes, *by_v = by_u + lanes;
    const double t = f[2] / f[3];
    const Vector3 x = (1 / f[3]) * vector_of(f);
    const Vector3 normal = cross(vector_of(by_u) - by_u[3] * x, vector_of(by_v) - by_v[3] * x);
    const Part &part = stack_.back();
    Box<2> around{};
    for (size_t k = 0; k < 2; ++k) {
        around[k] = {part.lower[k] + part.length[k] * exact[k].lower,
                     part.lower[k] + part.length[k] * exact[k].upper};
    }
    meet_ = {{part.lower[0] + part.length[0] * z[0], part.lower[1] + part.length[1] * z[1]},
             around,
             t,
             {t, t},
             piece_,
             true,
             strictly_inside(exact),
             normal.z / length(normal)};
}

void RaySolver::set_touch(const Ranges &ranges) {
    const Part &part = stack_.back();
    const double middle = ranges.nearest / 2 + ranges.farthest / 2;
    meet_ = {{part.lower[0] + part.length[0] / 2, part.lower[1] + part.length[1] / 2},
             {Interval{part.lower[0], part.lower[0] + part.length[0]},
              Interval{part.lower[1], part.lower[1] + part.length[1]}},
             std::isfinite(middle) ? middle : ranges.nearest,
             {ranges.nearest, ranges.farthest},
             piece_,
             false,
             false,
             0};
}

int RaySolver::longest_axis(const double *v) const noexcept {
    if (shape_.axes < 2) {
        return 0;
    }
    const int p = shape_.degree(0), q = shape_.degree(1);
    double along[2] = {0, 0};
    for (int i = 0; i <= p; ++i) {
        for (int j = 0; j <= q; ++j) {
            const double *here = v + (i * (q + 1) + j) * static_cast<int>(lanes);
            for (int k = 0; k < 2; ++k) {
                const double *next = here + (k == 0 ? q + 1 : 1) * static_cast<int>(lanes);
                if (k == 0 ? i < p : j < q) {
                    along[k] = std::max(along[k], (k == 0 ? p : q) * (std::abs(next[0] - here[0]) +
                                                                      std::abs(next[1] - here[1])));
                }
            }
        }
    }
    return along[1] > along[0] ? 1 : 0;
}

// The lower half goes on top of the stack, so that it is looked at first.
void RaySolver::halve() {
    if ((stack_.size() + 1) * size_ > memory_.size()) {
        memory_.resize(2 * memory_.size());
    }
    double *upper = values(stack_.size() - 1), *lower = values(stack_.size());
    const int axis = longest_axis(upper);
    BernsteinShape net{{}, static_cast<int>(lanes)};
    std::copy_n(shape_.degrees.begin(), shape_.axes, net.degrees.begin());
    bernstein::halve(net, axis, upper, lower);
    Part &part = stack_.back();
    const auto k = static_cast<size_t>(axis);
    part.length[k] /= 2;
    part.moved += 1.02 * shape_.degree(axis) * eps * reach_;
    ++part.depth;
    Part first = part;
    part.lower[k] += part.length[k];
    stack_.push_back(first);
}

} // namespace nrb::intersect
