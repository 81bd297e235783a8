// SPDX-License-Identifier: MIT
#include "modify/deform/fair.h"

#include "base/finite.h"
#include "base/representable.h"
#include "base/watch.h"
#include "bounds/deviation.h"
#include "modify/deform/energy.h"
#include "modify/edit/kept_layers.h"
#include "modify/edit/net_editor.h"
#include "numeric/norm.h"
#include "numeric/solvers/sparse/grid_order.h"
#include "numeric/solvers/sparse/sparse_system.h"
#include "numeric/sum.h"
#include "pieces/bernstein_net.h"
#include "refine/forms/homogeneous.h"
#include "spline/near_one.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nrb::modify {

namespace {

// w (P - centre) of the originals, 0 for their copies on periodic axes.
std::vector<double> centred(const Spline &spline, const std::vector<double> &centre) {
    const size_t dim = centre.size();
    std::vector<double> x(static_cast<size_t>(spline.point_count()) * dim, 0.0);
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const double *stored = spline.points().data() + i * spline.stored_width();
        const double weight = spline.weight(i);
        for (size_t c = 0; c < dim && original_of(spline, i) == i; ++c) {
            x[static_cast<size_t>(i) * dim + c] = spline.form() == Form::homogeneous
                                                      ? stored[c] - weight * centre[c]
                                                      : weight * (stored[c] - centre[c]);
        }
    }
    return x;
}

// The control points that may move, numbered.
struct Unknowns {
    std::vector<int64_t> number; // for each control point; -1: it stays or is a copy
    std::vector<int64_t> points;
};
Unknowns unknowns_of(const Spline &spline, const int32_t *keep) {
    const std::vector<char> stays = kept_points(spline, keep);
    Unknowns unknowns;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const bool free =
            original_of(spline, i) == i && stays[static_cast<size_t>(i)] == 0 && spline.weight(i) != 0;
        unknowns.number.push_back(free ? std::ssize(unknowns.points) : -1);
        if (free) {
            unknowns.points.push_back(i);
        }
    }
    return unknowns;
}

double compensated_dot(const std::vector<double> &a, const std::vector<double> &b) noexcept {
    CompensatedSum sum;
    for (size_t i = 0; i < a.size(); ++i) {
        sum.add(a[i] * b[i]);
    }
    return sum.value();
}

class Fairing {
public:
    Fairing(SplinePtr spline, int order, const int32_t *keep, double tolerance)
        : spline_(std::move(spline)), dim_(static_cast<size_t>(spline_->dim())), tolerance_(tolerance),
          centre_(pieces::centre_of(*spline_)), entries_(energy_entries(*spline_, order)),
          unknowns_(unknowns_of(*spline_, keep)), best_(spline_) {
        const std::vector<double> x = centred(*spline_, centre_), force = times(entries_, x, spline_->dim());
        energy_ = compensated_dot(x, force);
        require_representable({&energy_, 1}, "energy");
        for (const int64_t point : unknowns_.points) {
            for (size_t c = 0; c < dim_; ++c) {
                right_.push_back(-force[static_cast<size_t>(point) * dim_ + c]);
            }
        }
    }

    Faired run() {
        if (tolerance_ > 0 && !unknowns_.points.empty() && energy_ > 0 && largest_magnitude(right_) > 0) {
            search();
        }
        const std::vector<double> x = centred(*best_, centre_);
        const double after = compensated_dot(x, times(entries_, x, spline_->dim()));
        return after < energy_ ? Faired{best_, energy_, std::max(after, 0.0), bound_}
                               : Faired{spline_, energy_, energy_, 0};
    }

private:
    static constexpr double least = -12, most = 12; // range of log10 of rho, in units of trace K / trace D
    static constexpr int most_places = 40;          // number of values of rho that are tried
    static constexpr double enough = 4e-5;          // log10 of tolerance / distance that suffices
    static constexpr double narrowest = 1.5e-6;     // interval of log10 of rho
    static constexpr int64_t work_of_an_entry = 8;  // of moving an entry

    // The part of the matrix that belongs to unknowns.
    [[nodiscard]] std::vector<Entry> reduced() const {
        std::vector<Entry> entries;
        for (const Entry &entry : entries_) {
            count_work(work_of_an_entry);
            const int64_t i = unknowns_.number[static_cast<size_t>(entry.row)],
                          j = unknowns_.number[static_cast<size_t>(entry.column)];
            if (i >= 0 && j >= 0) {
                entries.push_back({i, j, entry.value});
            }
        }
        return entries;
    }

    // D: the factors 1 / w^2 with which squares of X are squares of lengths.
    [[nodiscard]] std::vector<double> metric() const {
        std::vector<double> diagonal;
        for (const int64_t point : unknowns_.points) {
            diagonal.push_back(1 / (spline_->weight(point) * spline_->weight(point)));
        }
        return diagonal;
    }

    // The elimination order of the unknowns on the grid of control points, which are coupled where their
    // functions overlap.
    [[nodiscard]] std::vector<int64_t> elimination_order() const {
        std::array<GridAxis, max_axes> axes;
        for (int k = 0; k < spline_->axes(); ++k) {
            const KnotVector &axis = spline_->axis(k);
            axes[static_cast<size_t>(k)] = {axis.count(), axis.degree(), axis.periodic()};
        }
        std::vector<int64_t> order;
        for (const int64_t point : grid_order(axes)) {
            if (const int64_t i = unknowns_.number[static_cast<size_t>(point)]; i >= 0) {
                order.push_back(i);
            }
        }
        return order;
    }

    void search() {
        const std::vector<Entry> entries = reduced();
        const std::vector<double> diagonal = metric();
        double trace = 0, sum = 0;
        for (const Entry &entry : entries) {
            trace += entry.row == entry.column ? entry.value : 0;
        }
        for (const double value : diagonal) {
            sum += value;
        }
        std::optional<Phase> order(0.1);
        SparseSystem system(entries, diagonal, elimination_order());
        order.reset();
        const auto distance_at = [&](double at) {
            return distance_of(system, std::pow(10.0, at) * (trace / sum));
        };
        find_root(start(diagonal, trace / sum), distance_at);
        take_part();
    }

    // log10 of a bound over the tolerance; if that is infinite, no bound exceeds it.
    [[nodiscard]] double excess(double bound) const noexcept {
        return std::isinf(tolerance_) ? -HUGE_VAL : std::log10(bound / tolerance_);
    }

    // log10 of the first rho, in units of `unit`. For large rho the solution is -D^-1 K X_0 / rho; this is
    // the rho for which that would be as far away as is allowed.
    double start(const std::vector<double> &diagonal, double unit) {
        std::vector<double> step = right_;
        for (size_t i = 0; i < step.size(); ++i) {
            step[i] /= diagonal[i / dim_] * unit;
        }
        const SplinePtr moved = moved_by(step, 1);
        const double bound = moved == nullptr ? HUGE_VAL : bounds::deviation(*spline_, *moved).upper;
        return std::clamp(excess(bound), least, most);
    }

    // Finds log10 of the rho at which distance_at() just stays within the tolerance, beginning at `first`.
    // The distance falls with rho, at most in proportion to 1 / rho. Both are taken as logarithms. While all
    // places are on one side of the root, steps go towards the other side; then secants between both sides
    // follow, with the rule that halves the value of a side that stays (the Illinois method; Dowell &
    // Jarratt, BIT 11 (1971)).
    template <class Distance>
    void find_root(double first, const Distance &distance_at) {
        struct Side {
            double at, value; // log10 of rho and of the distance over the tolerance
        };
        std::optional<Side> near, far; // within the tolerance and beyond it
        const std::optional<Side> *stayed = nullptr;
        double at = first, slope = 1, longest = most - least;
        Steps steps(most_places);
        for (int i = 0; i < most_places; ++i, steps.next()) {
            const Side side{at, std::clamp(excess(distance_at(at)), -300.0, 300.0)};
            std::optional<Side> &own = side.value <= 0 ? near : far, &other = side.value <= 0 ? far : near;
            if (side.value <= 0 && (side.value > -enough || at <= least)) {
                return;
            }
            if (own && other && stayed == &other) {
                other->value /= 2;
            } else if (own && !other) {
                slope = std::clamp((own->value - side.value) / (at - own->at), 1e-3, 1.0);
                longest = 2 * std::abs(at - own->at); // the distance may fall faster there
            }
            own = side;
            stayed = &other;
            if (other) {
                at = near->at + (far->at - near->at) * (near->value / (near->value - far->value));
                if (near->at - std::max(at, far->at) < narrowest) { // nothing is gained any more
                    return;
                }
            } else {
                const double step = (side.value + (side.value > 0 ? enough : 0)) / slope;
                at = std::clamp(at + std::clamp(step, -longest, longest), least, most);
                if (at == side.at) {
                    return;
                }
            }
        }
    }

    // A bound of the distance of the solution for a rho. If it is within the tolerance, the solution is
    // taken; if not, it is kept for take_part().
    double distance_of(SparseSystem &system, double rho) {
        const Phase phase(0.1);
        std::vector<double> step;
        if (!system.solve(rho, right_, spline_->dim(), step)) {
            return HUGE_VAL;
        }
        const SplinePtr moved = moved_by(step, 1);
        const double bound = moved == nullptr ? HUGE_VAL : bounds::deviation(*spline_, *moved).upper;
        if (moved != nullptr && bound <= tolerance_) {
            take(moved, bound);
        } else if (std::isfinite(bound)) {
            far_step_ = std::move(step);
            far_bound_ = bound;
        }
        return bound;
    }

    // Takes as much of the last solution that is too far as the tolerance allows.
    void take_part() {
        if (far_step_.empty()) {
            return;
        }
        if (const SplinePtr part = moved_by(far_step_, 0.99 * tolerance_ / far_bound_); part != nullptr) {
            if (const double bound = bounds::deviation(*spline_, *part).upper; bound <= tolerance_) {
                take(part, bound);
            }
        }
    }

    // Keeps the candidate if it has the least energy so far.
    void take(const SplinePtr &candidate, double bound) {
        const std::vector<double> x = centred(*candidate, centre_);
        const double energy = compensated_dot(x, times(entries_, x, spline_->dim()));
        if (best_ == spline_ || energy < best_energy_) {
            best_ = candidate;
            best_energy_ = energy;
            bound_ = bound;
        }
    }

    // The spline with the unknowns moved by a part of a step; null if a value overflows.
    [[nodiscard]] SplinePtr moved_by(const std::vector<double> &step, double part) const {
        if (!std::isfinite(largest_magnitude(step)) || !std::isfinite(part)) {
            return nullptr;
        }
        NetEditor editor(*spline_);
        for (size_t i = 0; i < unknowns_.points.size(); ++i) {
            const int64_t point = unknowns_.points[i];
            editor.move(point, step.data() + i * dim_, part / spline_->weight(point));
        }
        return editor.finish();
    }

    SplinePtr spline_;
    size_t dim_;
    double tolerance_;
    std::vector<double> centre_;
    std::vector<Entry> entries_;
    Unknowns unknowns_;
    std::vector<double> right_; // -K X_0 of the unknowns
    double energy_ = 0;
    SplinePtr best_;
    double best_energy_ = 0;
    double bound_ = 0;
    std::vector<double> far_step_; // the last solution beyond the tolerance
    double far_bound_ = 0;
};

// x 2^exponent, rounded up.
double rounded_up(double x, int exponent) noexcept {
    const double scaled = std::ldexp(x, exponent);
    return std::ldexp(scaled, -exponent) < x ? std::nextafter(scaled, HUGE_VAL) : scaled;
}

} // namespace

Faired fair(const SplinePtr &spline, int order, const int32_t *keep, double tolerance) {
    bool enough = false;
    for (int k = 0; k < spline->axes(); ++k) {
        enough = enough || spline->axis(k).degree() >= order;
    }
    if (!enough) {
        fail(Status::degree, "order = %d, expected at most the degree of an axis of g", order);
    }
    if (spline->point_count() > std::numeric_limits<int32_t>::max()) {
        fail(Status::overflow, "g has %lld control points, expected fewer than 2^31",
             static_cast<long long>(spline->point_count()));
    }
    std::vector<int32_t> usual;
    for (int k = 0; k < spline->axes(); ++k) {
        usual.insert(usual.end(), 2, spline->axis(k).periodic() ? -1 : 0);
    }
    keep = keep == nullptr ? usual.data() : keep;
    const Powers powers = powers_near_one(*spline, order);
    if (powers == Powers{}) {
        return Fairing(spline, order, keep, tolerance).run();
    }
    const int size = powers.size(*spline);
    const SplinePtr near = near_one(*spline, powers);
    Faired made = Fairing(near, order, keep, std::ldexp(tolerance, size)).run();
    made.spline = made.spline == near ? spline : scaled_back(*made.spline, *near, *spline, powers);
    const int energy = -2 * (size + powers.weights) - (spline->axes() - 2 * order) * powers.knots[0];
    made.energy_before = std::ldexp(made.energy_before, energy);
    made.energy_after = std::ldexp(made.energy_after, energy);
    made.bound = rounded_up(made.bound, -size);
    return made;
}

} // namespace nrb::modify
