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

CurveSigns curve_signs(CurvePieces &pieces, const Numerator &numerator) {
    CurveSigns result;
    Steps steps(static_cast<int64_t>(pieces.count()));
    for (size_t e = 0; e < pieces.count(); ++e, steps.next()) {
        const bool known = !work_ended() && pieces.piece(e).positive;
        const RoundedPolynomial f = known ? numerator(pieces.piece(e)) : constant(0);
        if (exactly_zero(f)) {
            result.runs.push_back({pieces.start(e), pieces.end(e), 0});
            result.complete = result.complete && known;
        } else {
            append_runs(pieces.piece(e), sign_runs(f), result);
        }
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
