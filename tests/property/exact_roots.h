// Roots of polynomials in exact arithmetic: Sturm's theorem.
#pragma once

#include "exact_polynomials.h"

namespace support {

inline int sign_of(const Integer &x) {
    return x.sign();
}

// Coefficients of a power series, lowest first, without zeros at the end.
inline void trim(Polynomial &a) {
    while (!a.empty() && a.back() == 0) {
        a.pop_back();
    }
}

// -(a mod b), times a positive number, without common factors.
inline Polynomial negative_remainder(Polynomial a, const Polynomial &b) {
    const Integer lead = abs(b.back());
    const int sign = sign_of(b.back());
    while (a.size() >= b.size()) {
        const Integer factor = a.back() * sign;
        const size_t shift = a.size() - b.size();
        for (Integer &x : a) {
            x *= lead;
        }
        for (size_t i = 0; i < b.size(); ++i) {
            a[i + shift] -= factor * b[i];
        }
        trim(a);
    }
    Integer common = 0;
    for (Integer &x : a) {
        common = gcd(common, x);
        x = -x;
    }
    for (Integer &x : a) {
        x /= common;
    }
    return a;
}

inline int changes(const std::vector<int> &signs) {
    int count = 0, last = 0;
    for (const int sign : signs) {
        count += sign != 0 && last == -sign ? 1 : 0;
        last = sign != 0 ? sign : last;
    }
    return count;
}

// The distinct roots u > 0 of a polynomial that is not 0, whose value at 0 is none.
inline int positive_roots(const Polynomial &f) {
    Polynomial slope;
    for (size_t i = 1; i < f.size(); ++i) {
        slope.push_back(f[i] * static_cast<int64_t>(i));
    }
    std::vector<int> at_zero, far_away;
    Polynomial a = f, b = slope;
    while (!a.empty()) {
        at_zero.push_back(sign_of(a.front()));
        far_away.push_back(sign_of(a.back()));
        Polynomial next = b.empty() ? Polynomial{} : negative_remainder(a, b);
        a = std::move(b);
        b = std::move(next);
    }
    return changes(at_zero) - changes(far_away);
}

// Of a polynomial between 0 and 1 whose scaled Bernstein coefficients are given: f / (1 - x)^n is a polynomial of x / (1 - x).
struct ExactRoots {
    bool nothing = false; // f = 0
    int inside = 0;       // distinct roots
    bool at_start = false, at_end = false;
    int after_start = 0, before_end = 0; // signs
};
inline ExactRoots exact_roots(Polynomial f) {
    ExactRoots roots;
    roots.at_start = f.front() == 0;
    roots.at_end = f.back() == 0;
    trim(f);
    f.erase(f.begin(), std::find_if(f.begin(), f.end(), [](const Integer &x) { return x != 0; }));
    roots.nothing = f.empty();
    if (!roots.nothing) {
        roots.inside = positive_roots(f);
        roots.after_start = sign_of(f.front());
        roots.before_end = sign_of(f.back());
    }
    return roots;
}

} // namespace support
