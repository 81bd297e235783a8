#include "refine/elevation_table.h"

#include "base/error.h"
#include "basis/bspline.h"
#include "refine/period.h"

#include <algorithm>
#include <span>

namespace nrb {

namespace {

// A knot of the old vector: its first index, and how often it occurs there.
struct Group {
    double knot;
    int64_t first;
    int multiplicity;
};

std::vector<Group> groups_of(std::span<const double> knots) {
    std::vector<Group> groups;
    groups.reserve(knots.size());
    for (size_t i = 0; i < knots.size(); ++i) {
        if (groups.empty() || groups.back().knot != knots[i]) {
            groups.push_back({knots[i], static_cast<int64_t>(i), 0});
        }
        ++groups.back().multiplicity;
    }
    return groups;
}

// Old knots first, ..., end - 1, all of which a polar form has among its arguments, and the ones it has
// beside them.
struct Arguments {
    int64_t first;
    int64_t end;
    int added;
    double extra[max_basis]; // the first `added` are set
};

// The degree + 1 consecutive raised knots that belong to a control point, by groups.
class Window {
public:
    Window(int degree, std::span<const double> knots, const std::vector<Group> &groups)
        : degree_(degree), knots_(knots), groups_(groups) {}

    // Precondition: raised index `at` is in group `group`.
    void place(int64_t at, int64_t group) noexcept {
        group_ = group;
        at_start_ = at == raised_first(group);
        size_ = 0;
        for (int left = degree_ + 1; left > 0; ++group) {
            const int64_t behind = raised_first(group) + this->group(group).multiplicity + 1 - at;
            copies_[size_] = static_cast<int>(std::min<int64_t>(left, behind));
            at += copies_[size_];
            left -= copies_[size_++];
        }
    }
    [[nodiscard]] int64_t raised_first(int64_t group) const noexcept {
        return this->group(group).first + group; // one more of each group before
    }

    void append_row(int64_t shift, LayerTable &table) const {
        // The lowest old control point that a term reaches.
        const Group &last = group(group_ + size_ - 1);
        const int64_t base = last.first + std::min(copies_[size_ - 1] - 1, last.multiplicity) - 1 - degree_;
        double row[max_basis];
        std::fill_n(row, degree_ + 2, 0.0);
        for (int dropped = 0; dropped < size_; ++dropped) {
            add_term(dropped, base, row);
        }
        table.add_row(base - shift, row, degree_ + 2);
    }

private:
    [[nodiscard]] const Group &group(int64_t i) const noexcept { return groups_[static_cast<size_t>(i)]; }

    // All arguments are the same knot.
    void single(const Group &only, Arguments &arguments) const noexcept {
        // Where the curve is cut the first copies end one part and the last ones begin the next.
        const bool cut = only.multiplicity > degree_;
        const bool behind = cut && (size_ == 1 ? !at_start_ : only.knot == group(group_).knot);
        arguments.first = only.first + (behind ? 1 : 0);
        arguments.end = arguments.first + std::min(only.multiplicity, degree_);
        arguments.added = degree_ - std::min(only.multiplicity, degree_);
        std::fill_n(arguments.extra, arguments.added, only.knot);
    }

    // The window without one copy of its group `dropped`. Old knots strictly inside it are among the
    // arguments as often as they occur; those at its ends are the ones beside them.
    void drop(int dropped, Arguments &arguments) const noexcept {
        const auto copies = [&](int i) { return copies_[i] - (i == dropped ? 1 : 0); };
        const int low = copies(0) == 0 ? 1 : 0;
        const int high = size_ - (copies(size_ - 1) == 0 ? 2 : 1);
        if (low >= high) {
            return single(group(group_ + std::min(low, size_ - 1)), arguments);
        }
        const Group &left = group(group_ + low);
        const Group &right = group(group_ + high);
        arguments.first = left.first + left.multiplicity - std::min(copies(low), left.multiplicity);
        arguments.end = right.first + std::min(copies(high), right.multiplicity);
        arguments.added = 0;
        for (int i = low; i <= high; ++i) {
            if (copies(i) > group(group_ + i).multiplicity) {
                arguments.extra[arguments.added++] = group(group_ + i).knot;
            }
        }
    }

    // Adds the coefficients of the polar form, as often as there are copies to drop. With d further arguments
    // it is a combination of d + 1 control points: Cox-de Boor steps over the knots around those that it has
    // (T. Lyche, K. Morken, "Making the Oslo algorithm more efficient", SIAM J. Numer. Anal. 23 (1986)).
    void add_term(int dropped, int64_t base, double *row) const noexcept {
        Arguments arguments;
        drop(dropped, arguments);
        const double *left = knots_.data() + arguments.first;
        const double *right = knots_.data() + arguments.end;
        const double share = copies_[dropped] / static_cast<double>(degree_ + 1);
        double *target = row + (arguments.first - 1 - arguments.added - base);
        if (arguments.added == 0) {
            target[0] += share;
        } else if (arguments.added == 1) {
            const auto [alpha, beta] = split(share, left[-1], arguments.extra[0], right[0]);
            target[0] += beta;
            target[1] += alpha;
        } else {
            add_steps(arguments, left, right, share, target);
        }
    }

    static void add_steps(const Arguments &arguments, const double *left, const double *right, double share,
                          double *target) noexcept {
        double coefficients[max_basis] = {share};
        for (int d = 1; d <= arguments.added; ++d) {
            append_argument(left, right, d, arguments.extra[d - 1], coefficients);
        }
        for (int i = 0; i <= arguments.added; ++i) {
            target[i] += coefficients[i];
        }
    }

    int degree_;
    std::span<const double> knots_;
    const std::vector<Group> &groups_;
    int64_t group_ = 0;
    bool at_start_ = true;
    int size_ = 0;
    int copies_[max_basis] = {};
};

std::vector<double> raised_knots(const std::vector<Group> &groups) {
    std::vector<double> raised;
    raised.reserve(groups.size() + static_cast<size_t>(groups.back().first + groups.back().multiplicity));
    for (const Group &group : groups) {
        raised.insert(raised.end(), static_cast<size_t>(group.multiplicity) + 1, group.knot);
    }
    return raised;
}

int64_t group_at(const std::vector<Group> &groups, int64_t index) noexcept {
    const auto behind = std::upper_bound(groups.begin(), groups.end(), index,
                                         [](int64_t i, const Group &group) { return i < group.first; });
    return behind - groups.begin() - 1;
}

// Raised knots first, ..., end - 1 are those of the elevated axis.
struct Range {
    int64_t first;
    int64_t end;
};

// `lead` extended knots stand before the stored ones. On a periodic axis the new copy of an end of the domain
// stands behind it on either side, on any other one it stands outside.
Range kept_knots(const KnotVector &axis, const std::vector<Group> &groups, int64_t lead) noexcept {
    const int64_t p = axis.degree();
    const int64_t lower = p + lead + group_at(groups, p + lead) + (axis.periodic() ? 0 : 1);
    const int64_t upper = axis.count() + lead + group_at(groups, axis.count() + lead);
    return {lower - p - 1, upper + p + 2};
}

void check_period(const KnotVector &axis, std::span<const double> knots) {
    const int p = axis.degree() + 1;
    const auto upper = knots[knots.size() - 1 - static_cast<size_t>(p)];
    if (knots[static_cast<size_t>(p)] != axis.domain().lower || upper != axis.domain().upper) {
        fail(NURBS_ERROR_PERIODIC_KNOTS,
             "knots: the ends of the periodic domain [%s, %s] have other multiplicities than their copies",
             Number(axis.domain().lower).text, Number(axis.domain().upper).text);
    }
    check_periodic_knots(p, knots, -1, 0);
}

} // namespace

ElevatedAxis elevated_axis(const KnotVector &axis) {
    const int p = axis.degree();
    const int64_t lead = axis.periodic() ? 2 * int64_t{p} + 2 : 0;
    const std::vector<double> extended = axis.periodic() ? extended_knots(axis, lead) : std::vector<double>();
    const std::span<const double> knots = axis.periodic() ? std::span<const double>(extended) : axis.knots();
    const std::vector<Group> groups = groups_of(knots);
    const std::vector<double> raised = raised_knots(groups);
    const Range kept = kept_knots(axis, groups, lead);
    ElevatedAxis result{{raised.begin() + kept.first, raised.begin() + kept.end}, {}};
    if (axis.periodic()) {
        check_period(axis, result.knots);
    }
    const int64_t rows = kept.end - kept.first - p - 2 - (axis.periodic() ? p + 1 : 0);
    result.rows.reserve(rows, p + 2);
    Window window(p, knots, groups);
    int64_t group = 0;
    for (int64_t at = kept.first + 1; at <= kept.first + rows; ++at) {
        while (group + 1 < std::ssize(groups) && window.raised_first(group + 1) <= at) {
            ++group;
        }
        window.place(at, group);
        window.append_row(lead, result.rows);
    }
    return result;
}

namespace {

// A row of a period of rows, `periods` further on.
struct Shifted {
    const double *coefficients;
    int64_t first;
    int size;
};

Shifted shifted(const LayerTable &table, int64_t layer, int64_t period) noexcept {
    static constexpr double copied = 1;
    const int64_t behind = layer % table.rows();
    const int64_t place = behind < 0 ? behind + table.rows() : behind;
    const LayerTable::Row &row = table.row(place);
    const int64_t first = row.first + (layer - place) / table.rows() * period;
    return row.size == 0 ? Shifted{&copied, first, 1} : Shifted{table.coefficients(row), first, row.size};
}

} // namespace

LayerTable composed(const LayerTable &outer, const LayerTable &inner, int64_t period) {
    LayerTable table;
    table.reserve(outer.rows());
    std::vector<double> sum;
    for (int64_t r = 0; r < outer.rows(); ++r) {
        const Shifted row = shifted(outer, r, 0);
        int64_t first = shifted(inner, row.first, period).first;
        for (int i = 1; i < row.size; ++i) {
            first = std::min(first, shifted(inner, row.first + i, period).first);
        }
        sum.clear();
        for (int i = 0; i < row.size; ++i) {
            const Shifted part = shifted(inner, row.first + i, period);
            const auto offset = static_cast<size_t>(part.first - first);
            sum.resize(std::max(sum.size(), offset + static_cast<size_t>(part.size)));
            for (int k = 0; k < part.size; ++k) {
                sum[offset + static_cast<size_t>(k)] += row.coefficients[i] * part.coefficients[k];
            }
        }
        table.add_row(first, sum.data(), static_cast<int>(sum.size()));
    }
    return table;
}

LayerTable wrapped_rows(const LayerTable &rows, int64_t wrapped, int64_t period) {
    LayerTable table;
    table.reserve(rows.rows() + wrapped);
    for (int64_t i = 0; i < rows.rows() + wrapped; ++i) {
        const Shifted row = shifted(rows, i % rows.rows(), 0);
        const int64_t layer = row.first % period;
        table.add_row(layer < 0 ? layer + period : layer, row.coefficients, row.size);
    }
    return table;
}

} // namespace nrb
