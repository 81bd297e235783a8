// SPDX-License-Identifier: MIT
#include "analysis/curve_signs.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::analysis {

bool exactly_zero(const RoundedPolynomial &f) noexcept {
    for (size_t i = 0; i < f.values.size(); ++i) {
        if (f.values[i] != 0 || f.error(i) != 0) {
            return false;
        }
    }
    return true;
}

void append_runs(const pieces::HomogeneousPiece &piece, const SignRuns &signs, CurveSigns &out) {
    for (const SignRun &run : signs.runs) {
        out.runs.push_back({piece.parameter(0, run.from), piece.parameter(0, run.to), run.sign, run.zero >= 0,
                            piece.parameter(0, run.zero)});
        out.complete = out.complete && (run.sign != 0 || run.simple) && !signs.doubtful;
    }
}

CurveSigns curve_signs(const std::vector<pieces::HomogeneousPiece> &pieces, const Numerator &numerator) {
    CurveSigns result;
    for (const pieces::HomogeneousPiece &piece : pieces) {
        const bool known = piece.positive && !work_ended();
        const RoundedPolynomial f = known ? numerator(piece) : constant(0);
        if (exactly_zero(f)) {
            result.runs.push_back({piece.parameter(0, 0), piece.parameter(0, 1), 0});
            result.complete = result.complete && known;
            continue;
        }
        append_runs(piece, sign_runs(f), result);
    }
    return result;
}

std::vector<SignChange> sign_changes(const std::vector<CurveRun> &runs, bool periodic) {
    std::vector<SignChange> changes;
    const CurveRun *last = nullptr, *first = nullptr, *estimate = nullptr;
    for (const CurveRun &run : runs) {
        if (run.sign == 0) {
            estimate = run.estimated ? &run : estimate;
            continue;
        }
        first = first == nullptr ? &run : first;
        if (last != nullptr && last->sign != run.sign) {
            const double middle = last->to == run.from ? run.from : last->to / 2 + run.from / 2;
            changes.push_back(
                {last->to, run.from, last->sign, run.sign, estimate != nullptr ? estimate->zero : middle});
        }
        last = &run;
        estimate = nullptr;
    }
    if (periodic && last != nullptr && last->sign != first->sign) {
        const double start = runs.front().from;
        changes.insert(changes.begin(), {start, start, last->sign, first->sign, start});
    }
    return changes;
}

} // namespace nrb::analysis
