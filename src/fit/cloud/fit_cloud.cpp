// SPDX-License-Identifier: MIT
#include "fit/cloud/fit_cloud.h"

#include "base/finite.h"
#include "base/representable.h"
#include "base/watch.h"
#include "closest/foot.h"
#include "fit/cloud/cloud.h"
#include "fit/cloud/cloud_equations.h"
#include "fit/cloud/cloud_feet.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <optional>

namespace nrb::fit {

namespace {

// A spline in the units of the cloud, with what is known of it.
struct Candidate {
    std::vector<double> x; // distinct control points, [unknowns][dim]
    SplinePtr spline;
    CloudFeet feet;
    double bend; // the penalty without its factor lambda

    [[nodiscard]] double sum(double lambda) const noexcept { return feet.squares + lambda * bend; }
};

// The Levenberg-Marquardt iteration: mu_ is the factor of the squared step, lambda_ that of the penalty.
class CloudDescent {
public:
    CloudDescent(const Spline &start, const Cloud &cloud, const CloudWishes &wishes)
        : axes_(start.knot_vectors()), cloud_(cloud), wishes_(wishes), penalty_(axes_, wishes.penalty_order),
          weight_(cloud.weight()), now_(first_candidate(start)) {}

    // If the limit of work ends the descent, the other half of the work is left for proofs.
    void run() {
        const PartOfWork half;
        converged_ = attempted([&] { descend(); }) && converged_;
        lambda_ = is_met() ? 0 : lambda_; // the sum is the same for any lambda
    }

    // The result, after searching for proofs that the steps did not need.
    [[nodiscard]] const Candidate &found() {
        now_.feet.prove(*now_.spline, cloud_);
        return now_;
    }
    [[nodiscard]] double lambda() const noexcept { return std::ldexp(lambda_, cloud_.weight_exponent); }
    [[nodiscard]] int rounds() const noexcept { return rounds_; }
    [[nodiscard]] bool converged() const noexcept { return converged_; }

private:
    // `ratio`: by which lambda is divided in a round at most. The others are relative to the weight of all
    // points. `smallest`: the smallest lambda that smooths anything. `largest`: the largest lambda that is
    // tried (the penalty of a bend of the whole domain is some 500 times its square). `shapeless`: the
    // quotient of squares and penalty above which a start has no shape (the penalty of an ellipse is 780
    // times the square of its axes).
    static constexpr double ratio = 8, smallest = 0x1p-40, largest = 0x1p-4, shapeless = 0x1p-10;
    // Where lambda times the least penalty of a function of mean square 1 (CloudPenalty::least()) is this
    // many times the weight of all points, all that has a penalty is gone: larger factors only lose digits.
    static constexpr double stiffest = 0x1p26;
    static constexpr double most_freedom = 0.25; // as a part of the number of points
    static constexpr double first_mu = 0x1p-10, least_mu = 0x1p-40, small_mu = 0x1p-10, most_mu = 0x1p60,
                            mu_ratio = 8;

    void descend() {
        lambda_ = first_lambda();
        converged_ = is_met();
        while (rounds_ < wishes_.rounds && !converged_ && mu_ <= most_mu) { // equations overflow beyond it
            const bool settled = take_step();
            const double before = lambda_;
            lambda_ = next_lambda();
            converged_ = is_met() || (settled && lambda_ >= before / 2);
        }
    }

    [[nodiscard]] std::vector<double> unknowns_of(const Spline &start) const {
        std::vector<double> x(static_cast<size_t>(penalty_.size() * cloud_.dim));
        const double *given = start.points().data();
        for_each_point([&](int64_t unknown) {
            for (size_t c = 0; c < static_cast<size_t>(cloud_.dim); ++c) {
                x[static_cast<size_t>(unknown * cloud_.dim) + c] = cloud_.own(*given++, c);
            }
        });
        return x;
    }
    // Calls visit(unknown) for all control points, periodic copies included.
    template <class Visit>
    void for_each_point(Visit &&visit) const {
        Index counts{1, 1, 1};
        for (size_t k = 0; k < axes_.size(); ++k) {
            counts[k] = axes_[k]->count();
        }
        for_each_index({}, counts, [&](const Index &layer) { visit(penalty_.pattern().unknown(layer)); });
    }

    Candidate first_candidate(const Spline &start) {
        const NeededWork needed; // the answer if there is no better one
        return candidate(unknowns_of(start));
    }
    Candidate candidate(std::vector<double> x) {
        ++rounds_;
        const Phase phase(0.1);
        std::vector<double> points;
        for_each_point([&](int64_t unknown) {
            const auto first = x.begin() + unknown * cloud_.dim;
            points.insert(points.end(), first, first + cloud_.dim);
        });
        SplinePtr spline = make_result(axes_, cloud_.dim, Form::polynomial, std::move(points));
        CloudFeet feet(*spline, cloud_);
        const double bend = penalty_.of(x);
        return {std::move(x), std::move(spline), std::move(feet), bend};
    }

    // A start with next to no penalty relative to its distances, such as a line or a plane, says nothing
    // about the shape that is wanted: lambda then falls from its largest value until the shape shows. Any
    // other start is meant as it is.
    [[nodiscard]] bool is_shapeless() const noexcept {
        return now_.feet.squares >= shapeless * weight_ * now_.bend && !is_exact();
    }
    [[nodiscard]] double first_lambda() const noexcept {
        const double first = wishes_.first_lambda >= 0 ? in_units(wishes_.first_lambda)
                             : is_shapeless()          ? largest * weight_
                                                       : 0;
        return std::max(first, wanted_lambda());
    }
    [[nodiscard]] double next_lambda() const noexcept {
        const double smaller = lambda_ / ratio;
        const bool small = smaller <= smallest * weight_;
        const double wanted = wishes_.lambda < 0 && is_shapeless() && !small ? 0 : wanted_lambda();
        return std::min(lambda_, small ? wanted : std::max(smaller, wanted));
    }
    // If lambda is not given: the quotient of the variance of the distances and that of what is penalised,
    // the latter with as many degrees of freedom as control points have across the spline. This is the fixed
    // point of S. Wood and M. Fasiolo, "A generalized Fellner-Schall method for smoothing parameter
    // optimization", Biometrics 73 (2017), which maximises the likelihood.
    [[nodiscard]] double wanted_lambda() const noexcept {
        if (wishes_.lambda >= 0) {
            return in_units(wishes_.lambda);
        }
        const auto across = static_cast<double>(penalty_.size() * (cloud_.dim - std::ssize(axes_)));
        const double part = std::min(across / static_cast<double>(cloud_.size()), most_freedom);
        const double most = largest * weight_, squares = part * now_.feet.squares;
        return squares < most * now_.bend ? squares / now_.bend : most;
    }
    [[nodiscard]] double in_units(double lambda) const noexcept {
        return std::min(stiffest * weight_ / penalty_.least(), std::ldexp(lambda, -cloud_.weight_exponent));
    }
    // Whether the distances are nothing but rounding errors.
    [[nodiscard]] bool is_exact() const noexcept {
        return std::sqrt(now_.feet.squares / weight_) <= distance_noise(*now_.spline, cloud_);
    }

    // Whether the fit is exact and no penalty was asked for.
    [[nodiscard]] bool is_met() const noexcept { return !(wishes_.lambda > 0) && is_exact(); }

    // Raises mu until a step lowers the sum, or none does. Returns whether the descent has converged.
    bool take_step() {
        CloudEquations equations(axes_, cloud_.dim, penalty_);
        add_models(*now_.spline, cloud_, now_.feet, equations);
        equations.finish(lambda_, now_.x);
        const double before = now_.sum(lambda_);
        while (rounds_ < wishes_.rounds && mu_ <= most_mu) {
            const std::optional<CloudEquations::Step> step = equations.step(mu_);
            if (const std::optional<bool> settled = step ? tried(*step, before) : std::nullopt) {
                return *settled;
            }
            mu_ *= mu_ratio;
        }
        return false;
    }
    // Whether the descent has converged; nothing where the step did not lower the sum and a shorter one may.
    std::optional<bool> tried(const CloudEquations::Step &step, double before) {
        std::optional<Candidate> other = step.promise > 0 ? moved(step.change) : std::nullopt;
        const double gain = other ? before - other->sum(lambda_) : 0;
        if (gain > 0) {
            const bool settled = gain <= wishes_.tolerance * before && mu_ <= small_mu;
            now_ = std::move(*other);
            trust(gain / step.promise);
            return settled;
        }
        return step.promise <= wishes_.tolerance * before ? std::optional(true) : std::nullopt;
    }
    // Nothing where control points overflow.
    std::optional<Candidate> moved(const std::vector<double> &change) {
        std::vector<double> x = now_.x;
        for (size_t i = 0; i < x.size(); ++i) {
            x[i] += change[i];
        }
        if (!all_moderate(x)) {
            ++rounds_;
            return std::nullopt;
        }
        return candidate(std::move(x));
    }
    // Adapts mu to the part of the promised decrease that was achieved.
    void trust(double part) noexcept {
        constexpr double good = 0.75, bad = 0.25;
        if (part > good) {
            mu_ = std::max(mu_ / mu_ratio, least_mu);
        } else if (part < bad) {
            mu_ *= mu_ratio;
        }
    }

    Spline::Axes axes_;
    const Cloud &cloud_;
    CloudWishes wishes_;
    CloudPenalty penalty_;
    double weight_;
    int rounds_ = 0;
    Candidate now_;
    double lambda_ = 0, mu_ = first_mu;
    bool converged_ = false;
};

SplinePtr in_units_of_caller(const Spline &spline, const Cloud &cloud) {
    std::vector<double> points(spline.points().begin(), spline.points().end());
    for (size_t i = 0; i < points.size(); ++i) {
        points[i] = cloud.given(points[i], i % static_cast<size_t>(cloud.dim));
    }
    require_representable(points, "control points");
    return make_result(spline.knot_vectors(), spline.dim(), Form::polynomial, std::move(points));
}

int64_t count_of(const CloudFeet &feet, int32_t bit, int32_t value) noexcept {
    return std::ranges::count_if(feet.status, [&](int32_t status) { return (status & bit) == value; });
}

// sum w d^2 = sum 2^exponent, for the weights of the cloud and given distances, however small the largest
// distance is beside the largest coordinate.
struct Squares {
    double sum;
    int exponent; // even
};
Squares squares_of(const CloudFeet &feet, const Cloud &cloud) {
    struct Term {
        double part;
        int exponent;
    };
    std::vector<Term> terms;
    int largest = INT_MIN + 1;
    for (size_t i = 0; i < feet.distances.size(); ++i) {
        int of_weight = 0, of_distance = 0;
        const double w = std::frexp(cloud.weights[i], &of_weight),
                     d = std::frexp(feet.distances[i], &of_distance);
        terms.push_back({w * d * d, of_weight + 2 * of_distance});
        largest = d > 0 ? std::max(largest, terms.back().exponent) : largest;
    }
    largest += largest & 1; // even, because a root is taken
    DoubleDouble sum;
    for (const Term &term : terms) {
        sum = sum + DoubleDouble(term.part > 0 ? std::ldexp(term.part, term.exponent - largest) : 0);
    }
    return {sum.high, sum.high > 0 ? largest + 2 * feet.exponent : 0};
}

void tell_distances(const CloudFeet &feet, const Cloud &cloud, CloudFit &fit) {
    const Squares squares = squares_of(feet, cloud);
    fit.data_count = cloud.size();
    fit.weight = std::ldexp(cloud.weight(), cloud.weight_exponent);
    fit.squares = std::ldexp(squares.sum, cloud.weight_exponent + squares.exponent);
    fit.rms = std::ldexp(std::sqrt(squares.sum / cloud.weight()), squares.exponent / 2);
    const auto farthest = std::ranges::max_element(feet.distances);
    fit.largest = std::ldexp(*farthest, feet.exponent);
    fit.largest_index = cloud.indices[static_cast<size_t>(farthest - feet.distances.begin())];
    fit.on_boundary = count_of(feet, closest::closest_boundary, closest::closest_boundary);
    fit.uncertified = count_of(feet, closest::closest_certified, 0);
}

} // namespace

CloudFit fit_cloud(const SplinePtr &start, const ConstRecords &points, const ConstRecords &weights,
                   const CloudWishes &wishes) {
    const Cloud cloud = cloud_of(points, weights, start->points());
    const UsualLimit usual(usual_work(cloud.size() + start->point_count(), 1500000));
    CloudDescent descent(*start, cloud, wishes);
    descent.run();
    Candidate found = descent.found();
    CloudFit fit{};
    fit.spline = in_units_of_caller(*found.spline, cloud);
    if (cloud.moved()) {
        found.feet.measure_given(*fit.spline, cloud);
    }
    tell_distances(found.feet, cloud, fit);
    fit.noise = given_noise(*found.spline, cloud);
    fit.lambda = descent.lambda();
    fit.rounds = descent.rounds();
    fit.converged = descent.converged();
    return fit;
}

} // namespace nrb::fit
