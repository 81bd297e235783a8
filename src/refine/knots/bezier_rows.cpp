// SPDX-License-Identifier: MIT
#include "refine/knots/bezier_rows.h"

#include "base/watch.h"
#include "refine/knots/blossom_rows.h"

#include <algorithm>

namespace nrb::refine {

namespace {

class BezierRows {
public:
    explicit BezierRows(const KnotVector &axis)
        : degree_(axis.degree()), knots_(axis.knots()), spans_(axis.spans().indices()) {}

    LayerTable make(int64_t first, int64_t end) {
        table_.reserve((end - first) * (degree_ + 1), degree_ + 1);
        first_ = first;
        for (int64_t e = first; e < end;) {
            const int64_t alike = run(e, end);
            if (alike >= row_lanes) {
                e += add_spans(e, alike - alike % row_lanes);
            } else {
                add_span(e++);
            }
        }
        return std::move(table_);
    }

private:
    [[nodiscard]] int64_t span(int64_t e) const noexcept { return spans_[static_cast<size_t>(e)]; }
    // The number of knots equal to the start of span e; after() counts those equal to its end. At most degree
    // + 1 are counted.
    [[nodiscard]] int64_t before(int64_t e) const noexcept {
        const double *at = knots_.data() + span(e);
        int64_t copies = 1;
        while (copies <= degree_ && at[-copies] == *at) {
            ++copies;
        }
        return e > 0 ? span(e) - span(e - 1) : copies;
    }
    [[nodiscard]] int64_t after(int64_t e) const noexcept {
        if (e + 1 < std::ssize(spans_)) {
            return span(e + 1) - span(e);
        }
        const double *at = knots_.data() + span(e) + 1;
        int64_t copies = 1;
        while (copies <= degree_ && at[copies] == *at) {
            ++copies;
        }
        return copies;
    }

    // The number of consecutive inner spans from e on that have equally many knots at both ends.
    [[nodiscard]] int64_t run(int64_t e, int64_t limit) const noexcept {
        if (e == first_) {
            return 0;
        }
        const int64_t multiplicity = span(e) - span(e - 1);
        const int64_t last = std::min(limit, std::ssize(spans_) - 1);
        int64_t end = e;
        while (end < last && span(end + 1) - span(end) == multiplicity) {
            ++end;
        }
        return end - e;
    }

    // The terms for the points of span e, without the first one if it is shared with the span before. Returns
    // their number.
    int terms(int64_t e, BlossomTerm *term) const noexcept {
        const double *start = knots_.data() + span(e), *end = start + 1;
        const auto starts = static_cast<int>(before(e)), ends = static_cast<int>(after(e));
        const int first = shared(e) ? 1 : 0;
        for (int i = first; i <= degree_; ++i, ++term) {
            const int old_starts = std::min(starts, degree_ - i), old_ends = std::min(ends, i);
            *term = {degree_ - old_starts - old_ends, 0, 1, end - old_starts, end + old_ends, 1, {}};
            std::fill_n(std::fill_n(term->arguments, degree_ - i - old_starts, start), i - old_ends, end);
        }
        return degree_ + 1 - first;
    }
    // Whether the first point of span e is the last one of the span before, which has been made too. It is
    // not at a knot of multiplicity degree + 1, where the spline may jump.
    [[nodiscard]] bool shared(int64_t e) const noexcept {
        return e > first_ && span(e) - span(e - 1) <= degree_;
    }

    void add_span(int64_t e) {
        BlossomTerm term[max_basis];
        const int count = terms(e, term);
        if (shared(e)) {
            table_.repeat_row();
        }
        for (int i = 0; i < count; ++i) {
            blossom_row_sum({term + i, 1}, term[i].steps + 1, table_.room(degree_ + 1));
            table_.add_written(layer(term[i]), term[i].steps + 1);
        }
    }

    int64_t add_spans(int64_t e, int64_t spans) {
        BlossomTerm term[max_basis];
        const int count = terms(e, term);
        const int first = degree_ + 1 - count;
        const int64_t stride = span(e) - span(e - 1);
        LayerTable::Row pattern[max_basis];
        int64_t pitch = 0;
        for (int i = 0; i < count; ++i) {
            pattern[first + i] = {layer(term[i]), term[i].steps == 0 ? 0 : term[i].steps + 1,
                                  static_cast<size_t>(pitch)};
            pitch += pattern[first + i].size;
        }
        if (first > 0) { // shared with the span before
            const LayerTable::Row &last = pattern[degree_];
            pattern[0] = {last.first - stride, last.size, last.offset - static_cast<size_t>(pitch)};
        }
        double *rows = table_.room(spans * pitch);
        for (int i = 0; i < count; ++i) {
            if (term[i].steps > 0) {
                blossom_row_sums({term + i, 1}, stride, spans, term[i].steps + 1, pitch,
                                 rows + pattern[first + i].offset);
            }
        }
        table_.add_pattern({pattern, static_cast<size_t>(degree_) + 1}, spans, stride, pitch);
        return spans;
    }
    [[nodiscard]] int64_t layer(const BlossomTerm &term) const noexcept {
        return term.left - knots_.data() - 1 - term.steps;
    }

    int degree_;
    std::span<const double> knots_;
    std::span<const int64_t> spans_;
    int64_t first_ = 0; // the first span that is made
    LayerTable table_;
};

} // namespace

LayerTable bezier_rows(const KnotVector &axis) {
    return bezier_rows(axis, 0, axis.spans().size());
}

LayerTable bezier_rows(const KnotVector &axis, int64_t first, int64_t end) {
    return BezierRows(axis).make(first, end);
}

std::vector<double> breaks_of(const KnotVector &axis) {
    const std::span<const double> breaks = axis.spans().breaks();
    return {breaks.begin(), breaks.end()};
}

KnotVectorPtr bezier_knots(int degree, std::span<const double> breaks) {
    std::vector<double> knots;
    knots.reserve(breaks.size() * (static_cast<size_t>(degree) + 1));
    count_work(static_cast<int64_t>(knots.capacity()));
    for (const double knot : breaks) {
        knots.insert(knots.end(), static_cast<size_t>(degree) + 1, knot);
    }
    return std::make_shared<const KnotVector>(degree, std::move(knots));
}

} // namespace nrb::refine
