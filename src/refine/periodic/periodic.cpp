// SPDX-License-Identifier: MIT
#include "refine/periodic/periodic.h"

#include "basis/bspline.h"
#include "refine/periodic/period.h"
#include "refine/periodic/period_rows.h"

#include <algorithm>

namespace nrb::refine {

namespace {

// A periodic axis extended by `lead` layers and knots on either side, as an ordinary axis. Layer i of the
// extension is layer i - lead of the endless sequence, and likewise for knots.
struct Extension {
    const KnotVector &axis;
    int64_t distinct;
    int64_t lead;
    double period;
    std::vector<double> knots;

    explicit Extension(const KnotVector &stored);
    // The copy of a new knot that follows stored knot k, for the period in which it follows extended knot
    // `at`. If the knot exists already, so does its copy. Otherwise the copy is clamped between its
    // neighbours, whatever the rounding.
    [[nodiscard]] double copy_of(double knot, int64_t k, int64_t at) const noexcept;
    // Appends the copies of a knot in all periods of the extension. Returns how many of them precede the
    // domain.
    int64_t append_copies(double knot, std::vector<double> &copies) const;
};

// The layers and knots of one period depend on old ones at most degree + 1 places away.
Extension::Extension(const KnotVector &stored)
    : axis(stored), distinct(stored.distinct_layers()), lead(stored.degree() + 1),
      period(stored.domain().upper - stored.domain().lower), knots(extended_knots(stored, lead)) {}

double Extension::copy_of(double knot, int64_t k, int64_t at) const noexcept {
    const auto index = static_cast<size_t>(at);
    if (knot == axis[k]) {
        return knots[index];
    }
    const int64_t periods = (at - lead - k) / distinct; // exact
    return std::clamp(knot + static_cast<double>(periods) * period, knots[index], knots[index + 1]);
}

int64_t Extension::append_copies(double knot, std::vector<double> &copies) const {
    const int p = axis.degree();
    const int64_t k = axis.spans().find(knot, false);
    const int64_t lowest = (k + lead - p) % distinct + p;
    int64_t before = 0;
    for (int64_t at = lowest; at < axis.count() + 2 * lead; at += distinct) {
        copies.push_back(copy_of(knot, k, at));
        before += at < lead + p ? 1 : 0;
    }
    return before;
}

// Knots may be so close that rounding makes their copies a period away equal. Checks that none then has too
// high a multiplicity.
void check_copies(std::span<const double> fine, int degree) {
    const auto limit = static_cast<size_t>(degree) + 1;
    for (size_t i = 0; i + limit < fine.size(); ++i) {
        if (fine[i] == fine[i + limit]) {
            fail(Status::periodic_knots,
                 "knots: copies a multiple of the period away meet at %s, where rounding made more than %zu "
                 "of them equal",
                 Number(fine[i]).text, limit);
        }
    }
}

} // namespace

AxisTable refine_periodic(const KnotVector &axis, std::span<const double> knots) {
    const Extension extension(axis);
    std::vector<double> copies;
    int64_t start = extension.lead;
    for (const double knot : knots) {
        start += extension.append_copies(knot, copies);
    }
    std::sort(copies.begin(), copies.end());
    const std::vector<double> fine = merged(extension.knots, copies);
    check_copies(fine, axis.degree());

    const Refinement refinement(axis.degree(), extension.knots, fine);
    const int64_t distinct = extension.distinct + std::ssize(knots);
    LayerTable table = wrapped_rows(rows_of(refinement, start, start + distinct), -extension.lead,
                                    axis.degree(), extension.distinct);
    const auto first = fine.begin() + start;
    const int64_t length = distinct + 2 * int64_t{axis.degree()} + 1;
    return {
        std::make_shared<const KnotVector>(axis.degree(), std::vector<double>(first, first + length), true),
        std::move(table)};
}

} // namespace nrb::refine
