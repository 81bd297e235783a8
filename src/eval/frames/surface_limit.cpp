// SPDX-License-Identifier: MIT
#include "eval/frames/surface_limit.h"

#include <algorithm>

namespace nrb::eval {

namespace {

// A vector with a bound of its error.
struct Term {
    Vector3 value;
    double error = 0;

    [[nodiscard]] bool vanishes() const noexcept { return !(length(value) > error); }
};

// N_ij = sum over a + c = i, b + e = j of (a + 1) (e + 1) A_(a+1,b) x A_(c,e+1), where A are the coefficients
// of the jet.
Term normal_term(const Jet &jet, int i, int j) noexcept {
    Term term;
    for (int a = 0; a <= i; ++a) {
        for (int b = 0; b <= j; ++b) {
            const int c = i - a;
            const int e = j - b;
            const double factor = (a + 1) * (e + 1);
            const Vector3 &p = jet.at(a + 1, b);
            const Vector3 &q = jet.at(c, e + 1);
            const double error_p = jet.error(a + 1, b);
            const double error_q = jet.error(c, e + 1);
            term.value = term.value + factor * cross(p, q);
            term.error += factor * (length(p) * error_q + error_p * (length(q) + error_q));
        }
    }
    return term;
}

// Whether two terms that do not vanish may have the same direction, within their errors.
bool same_direction(const Term &a, const Term &b) noexcept {
    const double noise = length(a.value) * b.error + a.error * (length(b.value) + b.error);
    return dot(a.value, b.value) > 0 && length(cross(a.value, b.value)) <= noise;
}

// Examines the terms N_ij with i + j = d. Returns false if all of them vanish. Otherwise `normal` gets the
// direction of the largest one, if all that do not vanish agree with it; if they do not, it stays undefined.
bool leading_term(const Jet &jet, int d, SurfaceNormal &normal) noexcept {
    std::array<Term, max_jet_order> terms;
    const Term *largest_term = nullptr;
    for (int j = 0; j <= d; ++j) {
        Term &term = terms[static_cast<size_t>(j)];
        term = normal_term(jet, d - j, j);
        if (!term.vanishes() &&
            (largest_term == nullptr || length(term.value) > length(largest_term->value))) {
            largest_term = &term;
        }
    }
    if (largest_term == nullptr) {
        return false;
    }
    for (int j = 0; j <= d; ++j) {
        const Term &term = terms[static_cast<size_t>(j)];
        if (!term.vanishes() && &term != largest_term && !same_direction(term, *largest_term)) {
            return true;
        }
    }
    // The orientation of (s, t) differs from that of (u, v) if one of the sides is -1.
    normal.kind = d == 0 ? NormalKind::regular : NormalKind::limit;
    normal.direction = (jet.side(0) * jet.side(1)) * nrb::unit(largest_term->value);
    return true;
}

// The highest order of the jet that can matter. For a polynomial surface of degrees (p, q), S_u x S_v has
// terms up to order 2 p + 2 q - 2.
int highest_normal_order(const Spline &spline) noexcept {
    const int sum = spline.axis(0).degree() + spline.axis(1).degree();
    return spline.rational() ? max_jet_order : std::min(max_jet_order, std::max(2 * sum - 1, 1));
}

} // namespace

SurfaceNormal surface_normal(const Spline &spline, const AxisRules &rules, const double *param) noexcept {
    constexpr int usual = 2; // enough at poles; above it, all orders are evaluated at once
    SurfaceNormal normal;
    Jet jet;
    const int highest = highest_normal_order(spline);
    for (int order = 1, known = 0; order <= highest; ++order) {
        if (order > known) {
            known = order <= usual ? order : highest;
            if (!jet.evaluate(spline, rules, param, known)) {
                break;
            }
        }
        if (leading_term(jet, order - 1, normal)) {
            break;
        }
    }
    return normal;
}

} // namespace nrb::eval
