// SPDX-License-Identifier: MIT
#include "analysis/folds.h"

#include "analysis/curve_signs.h"
#include "analysis/jacobian_parts.h"
#include "analysis/steady_sign.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"
#include "refine/parts/piece_arrays.h"

#include <algorithm>
#include <cmath>

namespace nrb::analysis {

namespace {

using Vector = std::array<double, 3>;

// The mean of S_u x S_v over a piece with parameters in the unit square: for polynomials the mean of the
// coefficients, otherwise the mean of N / w^3 at the midpoints of a grid of squares.
Vector mean_normal(const pieces::HomogeneousPiece &piece) {
    const RoundedPolynomial n = pieces::normal_numerator(piece);
    Vector sum{};
    if (piece.weight.shape.coefficients() == 1) {
        for (size_t i = 0; i < n.values.size(); ++i) {
            sum[i % 3] += n.values[i] / static_cast<double>(n.shape.coefficients());
        }
        return sum;
    }
    constexpr int places = 16;
    for (int i = 0; i < places; ++i) {
        const double u = (i + 0.5) / places;
        const RoundedPolynomial row = value_at(n, 1, u), row_w = value_at(piece.weight, 1, u);
        for (int j = 0; j < places; ++j) {
            const double v = (j + 0.5) / places;
            const RoundedPolynomial at = value_at(row, 2, v);
            const double w = value_at(row_w, 2, v).values[0];
            for (size_t c = 0; c < 3; ++c) {
                sum[c] += at.values[c] / (w * w * w) / (places * places);
            }
        }
    }
    return sum;
}

// The vector area, normalized.
Vector area_direction(const pieces::PieceMaker &maker) {
    std::vector<Vector> parts;
    std::vector<int> exponents;
    for (int64_t e = 0; e < maker.count(); ++e) {
        const pieces::HomogeneousPiece piece = maker.piece(e);
        parts.push_back(mean_normal(piece));
        exponents.push_back(2 * piece.exponent); // areas are in units of the square of 2^exponent
    }
    const int unit = *std::max_element(exponents.begin(), exponents.end());
    Vector area{};
    double magnitude = 0;
    for (size_t e = 0; e < parts.size(); ++e) {
        for (size_t c = 0; c < 3; ++c) {
            area[c] += std::ldexp(parts[e][c], exponents[e] - unit);
        }
        magnitude += std::ldexp(norm(parts[e].data(), 3), exponents[e] - unit);
    }
    const double size = norm(area.data(), 3);
    if (!(size > 1e-9 * magnitude) || !std::isfinite(size)) {
        fail(Status::direction, "reference is NULL, and the vector area vanishes: a direction is needed");
    }
    for (double &x : area) {
        x /= size;
    }
    return area;
}

// The direction scaled to a magnitude near 1.
Vector unit_of(const double *reference) {
    Vector unit{reference[0], reference[1], reference[2]};
    const double size = norm(unit.data(), 3);
    const int exponent = std::ilogb(size);
    for (double &x : unit) {
        x = std::ldexp(x, -exponent);
    }
    return unit;
}

// The direction that the normals of a surface in space are compared with; unused for other splines.
Vector reference_of(const Spline &spline, const pieces::PieceMaker &maker, const double *given) {
    if (spline.dim() != 3 || spline.axes() != 2) {
        return {};
    }
    return given != nullptr ? unit_of(given) : area_direction(maker);
}

} // namespace

class FoldSearch {
public:
    FoldSearch(const Spline &spline, const Vector &reference)
        : spline_(spline), reference_(reference), parts_(spline.axes()) {}

    // Sets what is examined: either all pieces, until a fold is found, or one piece.
    void start(const pieces::PieceMaker &maker) {
        const Phase phase;
        Steps steps(maker.count());
        for (int64_t e = 0; e < maker.count() && !found(); ++e, steps.next()) {
            start(maker.piece(e));
        }
    }
    void start(const pieces::HomogeneousPiece &piece);
    // Restricts the examination to a part of the single piece.
    void restrict_to(const Part &part);
    void limit(int64_t halvings) noexcept { parts_.limit(halvings); }

    FoldTest run() {
        SearchSteps steps;
        for (; !parts_.empty() && !found(); steps.next(parts_.size())) {
            JacobianPart part = parts_.take();
            look(part);
            if (certain_sign(part.f) == 0 && !parts_.halve(part, {1, 1, 1}, 0x1p-26)) {
                hidden_ = true;
            }
        }
        test_.result = found() ? fold_found : hidden_ ? fold_undecided : fold_none;
        return test_;
    }

private:
    [[nodiscard]] bool found() const noexcept { return test_.positive && test_.negative; }

    // Whether the determinant, a product of three or four factors of the degrees of the piece, costs too
    // much.
    [[nodiscard]] bool too_large(const pieces::HomogeneousPiece &piece) const noexcept {
        const double n = static_cast<double>(piece.points.shape.coefficients());
        const double factors = spline_.axes() == 3 ? 12 : 4;
        return n * n * factors > 2e7;
    }

    // Records signs of J. A corner coefficient has the sign of J, unless the corner is on a boundary where J
    // vanishes. On a part with one certain sign, J has that sign in the middle.
    void look(const JacobianPart &part) {
        const int sign = certain_sign(part.f);
        if (sign != 0) {
            std::array<double, max_axes> middle{};
            for (size_t k = 0; k < middle.size(); ++k) {
                middle[k] = part.from[k] / 2 + part.to[k] / 2;
            }
            return note(part.piece, sign, middle);
        }
        const int axes = spline_.axes();
        for (int corner = 0; corner < 1 << axes; ++corner) {
            std::array<double, max_axes> at{};
            bool zero = false;
            for (int k = 0; k < axes; ++k) {
                const auto a = static_cast<size_t>(k);
                const bool upper = (corner >> k & 1) != 0;
                at[a] = upper ? part.to[a] : part.from[a];
                zero = zero || (at[a] == 0 && ends_[part.piece][a][0]) ||
                       (at[a] == 1 && ends_[part.piece][a][1]);
            }
            const int sign_here =
                part.f.sign(static_cast<size_t>(part.f.shape.corner(corner << (max_axes - axes))));
            if (!zero && sign_here != 0) {
                note(part.piece, sign_here, at);
            }
        }
    }

    void note(size_t piece, int sign, const std::array<double, max_axes> &place) {
        auto &where = sign > 0 ? test_.positive : test_.negative;
        if (where) {
            return;
        }
        where.emplace();
        for (size_t k = 0; k < static_cast<size_t>(spline_.axes()); ++k) {
            (*where)[k] = parameter_in(pieces_[piece][k], place[k]);
        }
    }

    const Spline &spline_;
    Vector reference_;
    std::vector<Part> pieces_;
    std::vector<BoundaryZeros> ends_;
    PartQueue parts_;
    bool hidden_ = false;
    FoldTest test_;
};

void FoldSearch::start(const pieces::HomogeneousPiece &piece) {
    const size_t e = pieces_.size();
    pieces_.push_back(piece.part);
    constexpr int64_t work_of_a_point = 400; // per coefficient of a piece, to make and to examine it
    count_work(work_of_a_point * piece.points.shape.coefficients());
    if (!piece.positive || work_ended()) {
        hidden_ = true;
        return;
    }
    if (const int sign = steady_sign(piece, spline_.axes(), reference_); sign != 0) {
        note(e, sign, {0.5, 0.5, 0.5});
        return;
    }
    if (too_large(piece)) {
        hidden_ = true;
        return;
    }
    RoundedPolynomial f =
        spline_.axes() == 3 ? pieces::volume_numerator(piece) : pieces::normal_numerator(piece);
    if (f.shape.width == 3) {
        RoundedPolynomial along = scaled(component(f, 0), reference_[0]);
        along = sum(along, reference_[1], component(f, 1));
        f = sum(along, reference_[2], component(f, 2));
    }
    if (exactly_zero(f)) {
        return;
    }
    ends_.resize(e + 1);
    ends_[e] = divide_boundaries(f, spline_.axes());
    if (vanishes(f)) {
        hidden_ = true;
        return;
    }
    parts_.add({std::move(f), e, {}, {1, 1, 1}});
}

// The part is enlarged slightly, so that rounding leaves nothing out.
void FoldSearch::restrict_to(const Part &part) {
    if (parts_.empty()) { // the sign on the whole piece is known, or it cannot be determined
        return;
    }
    JacobianPart rest = parts_.take();
    const int axes = spline_.axes();
    for (int k = 0; k < axes; ++k) {
        const auto at = static_cast<size_t>(k);
        const Interval whole = pieces_.front()[at];
        const double length = whole.upper - whole.lower, out = 8 * eps;
        const double lower = (part[at].lower - whole.lower) / length - out,
                     upper = (part[at].upper - whole.lower) / length + out;
        if (upper < 1) {
            rest.f = split(rest.f, max_axes - axes + k, upper);
            rest.to[at] = upper;
        }
        if (lower > 0) {
            split(rest.f, max_axes - axes + k, lower / rest.to[at]);
            rest.from[at] = lower;
        }
    }
    parts_.add(std::move(rest));
}

FoldTest fold_test(const Spline &spline, const double *reference) {
    const UsualLimit usual(usual_work(spline.point_count()));
    const LimitedSearch limited;
    const pieces::PieceMaker maker(spline, whole_domain(spline));
    FoldSearch search(spline, reference_of(spline, maker, reference));
    search.start(maker);
    return search.run();
}

FoldTests::FoldTests(const Spline &spline, const double *reference)
    : spline_(spline), maker_(spline, whole_domain(spline)),
      reference_(reference_of(spline, maker_, reference)) {}

FoldTests::~FoldTests() = default;

void FoldTests::set_piece(int64_t index) {
    auto search = std::make_unique<FoldSearch>(spline_, reference_);
    search->start(maker_.piece(index));
    piece_ = std::move(search);
}

FoldTest FoldTests::test(int64_t halvings) const {
    FoldSearch search = *piece_;
    search.limit(halvings);
    return search.run();
}

FoldTest FoldTests::test(const Part &part, int64_t halvings) const {
    FoldSearch search = *piece_;
    search.limit(halvings);
    search.restrict_to(part);
    return search.run();
}

std::vector<FoldTest> fold_tests(const Spline &spline, const double *reference) {
    const UsualLimit usual(usual_work(spline.point_count()));
    const LimitedSearch limited;
    FoldTests tests(spline, reference);
    const int64_t pieces = refine::count_pieces(spline);
    std::vector<FoldTest> found;
    Steps steps(pieces);
    for (int64_t i = 0; i < pieces; ++i, steps.next()) {
        tests.set_piece(i);
        found.push_back(tests.test(halvings_of_piece));
    }
    return found;
}

} // namespace nrb::analysis
