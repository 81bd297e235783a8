#include "query/analysis/curve_signs.h"

#include <algorithm>

namespace nrb {

bool exactly_zero(const RoundedPolynomial &f) noexcept {
    for (size_t i = 0; i < f.values.size(); ++i) {
        if (f.values[i] != 0 || f.error(i) != 0) {
            return false;
        }
    }
    return true;
}

void append_runs(const HomogeneousPiece &piece, const SignRuns &signs, CurveSigns &out) {
    for (const SignRun &run : signs.runs) {
        out.runs.push_back({piece.parameter(0, run.from), piece.parameter(0, run.to), run.sign});
        out.complete = out.complete && (run.sign != 0 || run.simple);
    }
}

CurveSigns curve_signs(const std::vector<HomogeneousPiece> &pieces, const Numerator &numerator) {
    CurveSigns result;
    for (const HomogeneousPiece &piece : pieces) {
        const RoundedPolynomial f = numerator(piece);
        if (!piece.positive || exactly_zero(f)) {
            result.runs.push_back({piece.parameter(0, 0), piece.parameter(0, 1), 0});
            result.complete = result.complete && piece.positive;
            continue;
        }
        append_runs(piece, sign_runs(f), result);
    }
    return result;
}

std::vector<SignChange> sign_changes(const std::vector<CurveRun> &runs, bool periodic) {
    std::vector<SignChange> changes;
    const CurveRun *last = nullptr, *first = nullptr;
    for (const CurveRun &run : runs) {
        if (run.sign == 0) {
            continue;
        }
        first = first == nullptr ? &run : first;
        if (last != nullptr && last->sign != run.sign) {
            changes.push_back({last->to, run.from, last->sign, run.sign});
        }
        last = &run;
    }
    if (periodic && last != nullptr && last->sign != first->sign) {
        const double start = runs.front().from;
        changes.insert(changes.begin(), {start, start, last->sign, first->sign});
    }
    return changes;
}

} // namespace nrb
