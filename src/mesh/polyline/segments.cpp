// SPDX-License-Identifier: MIT
#include "mesh/polyline/segments.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace nrb::mesh {

namespace {

// The share of the rule that a step aims at, and the share from which it is long enough.
constexpr double aim = 0.98, enough = 0.95;
constexpr int most_tries = 8;
// The number of segments over which a short last one is spread.
constexpr size_t most_spread = 16;

struct Step {
    Vertex to;
    Segment segment;
};

// Finds the longest step that the rule allows, within a few hundredths.
class StepSearch {
public:
    StepSearch(CurveParts &parts, const Vertex &from, const Vertex &end)
        : parts_(parts), from_(from), end_(end) {}

    // Starts with the length `guess`, which becomes the guess for the step after this one.
    Step run(double &guess) {
        for (double length = guess; !work_ended();) {
            Step tried = step(length);
            const Segment segment = tried.segment;
            const bool full = at_end(tried) ? segment.stays() : segment.fits() && segment.need >= enough;
            if (full || !(segment.stays() || best_ || can_divide(tried))) {
                return accepted(std::move(tried), guess);
            }
            length = length_after(tried);
            if (segment.fits() || (segment.hopeless && !(best_ && best_->segment.fits()))) {
                best_ = std::move(tried);
            }
            if (best_ && (++tries_ == most_tries || !brackets())) {
                break;
            }
        }
        return accepted(best_ ? *std::move(best_) : to_end(), guess);
    }

private:
    [[nodiscard]] Step to_end() { return {end_, parts_.segment(from_, end_)}; }
    [[nodiscard]] Step step(double length) {
        const double t = std::max(from_.t + length, std::nextafter(from_.t, infinity));
        if (!(t + length * 0x1p-20 < end_.t)) { // leaves no tiny rest
            return to_end();
        }
        Vertex to = parts_.vertex(t, false);
        const Segment segment = parts_.segment(from_, to);
        return {std::move(to), segment};
    }
    [[nodiscard]] bool at_end(const Step &step) const noexcept { return !(step.to.t < end_.t); }

    // Learns from a step, and predicts a better length: between one that stays and one that does not, if both
    // are known.
    double length_after(const Step &tried) noexcept {
        const double length = tried.to.t - from_.t;
        (tried.segment.stays() ? fitting_ : failing_) = length;
        const double predicted = length * factor_to(tried.segment, 8);
        if (fitting_ == 0) {
            return std::isinf(tried.segment.need) ? length / 4 : std::min(predicted, length / 2);
        }
        const bool inside = fitting_ < predicted && predicted < failing_;
        return std::isinf(failing_) || (inside && tries_ < 3) ? predicted : fitting_ / 2 + failing_ / 2;
    }
    // The factor from the length of a step to the longest that the rule allows.
    static double factor_to(const Segment &segment, double most) noexcept {
        return segment.hopeless ? most : std::clamp(aim / segment.need, 0x1p-20, most);
    }
    // Whether a better step may lie between the longest that stays and the shortest that does not.
    [[nodiscard]] bool brackets() const noexcept { return fitting_ < 0.97 * failing_; }
    [[nodiscard]] bool can_divide(const Step &tried) const noexcept {
        return std::nextafter(from_.t, infinity) < tried.to.t;
    }

    Step accepted(Step step, double &guess) const {
        guess = (step.to.t - from_.t) * std::max(factor_to(step.segment, 4), 0.25);
        return step;
    }

    CurveParts &parts_;
    const Vertex &from_, &end_;
    std::optional<Step> best_; // the best one that stays
    double fitting_ = 0, failing_ = infinity;
    int tries_ = 0; // since the first that stayed
};

// Parameters that divide the total need of the segments of a run into equal parts.
std::vector<double> even_params(const Run &run, double total, int64_t count) {
    std::vector<double> params;
    double before = 0;
    for (size_t i = 0; i < run.segments.size(); ++i) {
        const double need = run.segments[i].need, start = run.vertices[i].t, end = run.vertices[i + 1].t;
        while (std::ssize(params) + 1 < count) {
            const double share =
                (static_cast<double>(params.size() + 1) * total / static_cast<double>(count) - before) / need;
            if (!(share < 1)) {
                break;
            }
            params.push_back(start + std::max(share, 0.0) * (end - start));
        }
        before += need;
    }
    return params;
}

// A run over vertices at these parameters; nothing if one of its segments breaks the rule.
std::optional<Run> fitting_run(CurveParts &parts, const Run &old, const std::vector<double> &params) {
    Run run{{old.vertices.front()}, {}};
    for (size_t i = 0; i <= params.size(); ++i) {
        Vertex to = i < params.size() ? parts.vertex(params[i], false) : old.vertices.back();
        if (!(to.t > run.vertices.back().t)) {
            return std::nullopt;
        }
        run.segments.push_back(parts.segment(run.vertices.back(), to));
        if (!run.segments.back().fits()) {
            return std::nullopt;
        }
        run.vertices.push_back(std::move(to));
    }
    return run;
}

// Takes off the last segments of a run, at most so many.
Run last_of(Run &run, size_t most) {
    const size_t count = std::min(run.segments.size(), most), first = run.segments.size() - count;
    Run last;
    last.vertices.assign(run.vertices.begin() + static_cast<std::ptrdiff_t>(first), run.vertices.end());
    last.segments.assign(run.segments.begin() + static_cast<std::ptrdiff_t>(first), run.segments.end());
    run.vertices.resize(first + 1);
    run.segments.resize(first);
    return last;
}

} // namespace

void append(Run &run, Run more) {
    std::move(more.vertices.begin() + 1, more.vertices.end(), std::back_inserter(run.vertices));
    run.segments.insert(run.segments.end(), more.segments.begin(), more.segments.end());
}

Run greedy(CurveParts &parts, const Vertex &from, const Vertex &to) {
    Run run{{from}, {}};
    double guess = to.t - from.t;
    while (run.vertices.back().t < to.t) {
        const Vertex &start = run.vertices.back();
        Step step = StepSearch(parts, start, to).run(guess);
        run.segments.push_back(step.segment);
        run.vertices.push_back(std::move(step.to));
    }
    return run;
}

Run spread_evenly(CurveParts &parts, Run run) {
    if (run.segments.back().need >= 0.8) {
        return run;
    }
    Run tail = last_of(run, most_spread);
    double total = 0;
    for (const Segment &segment : tail.segments) {
        total += segment.need;
    }
    const int64_t given = std::ssize(tail.segments);
    const auto fewest = static_cast<int64_t>(std::clamp(std::ceil(total), 1.0, static_cast<double>(given)));
    for (int64_t count = fewest; count <= given && given > 1 && !work_ended(); ++count) {
        if (std::optional<Run> found = fitting_run(parts, tail, even_params(tail, total, count))) {
            tail = *std::move(found);
            break;
        }
    }
    append(run, std::move(tail));
    return run;
}

Run divided(CurveParts &parts, const Vertex &from, const Vertex &to, int count) {
    Run run{{from}, {}};
    for (int i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        const Vertex next = i < count ? parts.vertex(from.t * (1 - share) + to.t * share, false) : to;
        if (next.t > run.vertices.back().t && (i == count || next.t < to.t)) {
            append(run, greedy(parts, run.vertices.back(), next));
        }
    }
    return run;
}

} // namespace nrb::mesh
