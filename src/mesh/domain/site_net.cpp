// SPDX-License-Identifier: MIT
#include "mesh/domain/site_net.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// A directed side, by the numbers of its ends, and whose it is.
struct Directed {
    std::array<int32_t, 2> ends;
    int32_t triangle;
    int32_t side;
};

} // namespace

int32_t SiteNet::add(const NetTriangle &triangle) {
    triangles_.push_back(triangle);
    return size() - 1;
}

// Joins sides that occur exactly once in each direction.
void SiteNet::join(const std::vector<int32_t> &points) {
    for (const bool by_points : {false, true}) {
        std::vector<Directed> open;
        const auto number = [&](int32_t site) {
            return by_points ? points[static_cast<size_t>(site)] : site;
        };
        for (int32_t t = 0; t < size(); ++t) {
            for (size_t k = 0; k < 3; ++k) {
                const auto &sites = (*this)[t].sites;
                const int32_t from = number(sites[(k + 1) % 3]), to = number(sites[(k + 2) % 3]);
                if ((*this)[t].sides[k].next < 0 && from != to) {
                    open.push_back({{from, to}, t, static_cast<int32_t>(k)});
                }
            }
        }
        std::ranges::sort(open, {}, &Directed::ends);
        const auto find = [&](const std::array<int32_t, 2> &ends) -> const Directed * {
            const auto first = std::ranges::lower_bound(open, ends, {}, &Directed::ends),
                       last = std::ranges::upper_bound(open, ends, {}, &Directed::ends);
            return last - first == 1 ? &*first : nullptr;
        };
        for (const Directed &own : open) {
            const Directed *other = own.ends[0] < own.ends[1] ? find({own.ends[1], own.ends[0]}) : nullptr;
            if (other == nullptr || find(own.ends) == nullptr) {
                continue;
            }
            const NetSide &a = (*this)[own.triangle].sides[static_cast<size_t>(own.side)],
                          &b = (*this)[other->triangle].sides[static_cast<size_t>(other->side)];
            if (a.border < 0 && b.border < 0) {
                link(own.triangle, static_cast<size_t>(own.side), other->triangle,
                     static_cast<size_t>(other->side), {-1, 0, -1, by_points, true});
            }
        }
    }
}

void SiteNet::link(int32_t t, size_t k, int32_t u, size_t j, const NetSide &like) noexcept {
    side(t, k) = side(u, j) = like;
    side(t, k).next = u;
    side(t, k).back = static_cast<int32_t>(j);
    side(u, j).next = t;
    side(u, j).back = static_cast<int32_t>(k);
}

// Sets a side, and makes its neighbour refer back to it.
void SiteNet::set_side(int32_t t, size_t k, const NetSide &own) noexcept {
    side(t, k) = own;
    if (own.next >= 0) {
        NetSide &other = side(own.next, static_cast<size_t>(own.back));
        other.next = t;
        other.back = static_cast<int32_t>(k);
    }
}

bool SiteNet::can_change(int32_t t, size_t k) const noexcept {
    const int32_t across = (*this)[t].sides[k].next;
    int count = 0;
    for (const int32_t own : {t, across}) {
        for (size_t m = 0; m < 3 && own >= 0; ++m) {
            const int32_t next = (*this)[own].sides[m].next;
            count += next >= 0 && (next == t || next == across) ? 1 : 0;
        }
    }
    return count == (across < 0 ? 0 : 2) && across != t;
}

int32_t SiteNet::replace(int32_t t, const std::array<int32_t, 3> &sites) {
    if (t < 0) {
        return add({sites});
    }
    NetTriangle &own = triangles_[static_cast<size_t>(t)];
    if (own.source >= 0) {
        dropped_.push_back(own.source);
    }
    own = {sites};
    return t;
}

void SiteNet::flip(int32_t t, size_t k) {
    const NetTriangle one = (*this)[t];
    const int32_t u = one.sides[k].next;
    const auto j = static_cast<size_t>(one.sides[k].back);
    const NetTriangle other = (*this)[u];
    const int32_t p = one.sites[k], a = one.sites[(k + 1) % 3], b = one.sites[(k + 2) % 3],
                  q = other.sites[j];
    replace(t, {p, a, q});
    replace(u, {p, q, b});
    set_side(t, 0, other.sides[(j + 1) % 3]);
    set_side(t, 2, one.sides[(k + 2) % 3]);
    set_side(u, 0, other.sides[(j + 2) % 3]);
    set_side(u, 1, one.sides[(k + 1) % 3]);
    link(t, 1, u, 2, one.sides[k]);
}

void SiteNet::erase(int32_t t) {
    if ((*this)[t].source >= 0) {
        dropped_.push_back((*this)[t].source);
    }
    const int32_t last = size() - 1;
    if (t != last) {
        triangles_[static_cast<size_t>(t)] = (*this)[last];
        for (size_t k = 0; k < 3; ++k) {
            set_side(t, k, (*this)[t].sides[k]);
        }
    }
    triangles_.pop_back();
}

bool SiteNet::remove_fin(int32_t t, size_t k) {
    const NetSide own = (*this)[t].sides[k];
    if (own.stays || beyond(t, k) != (*this)[t].sites[k] || !can_change(t, k)) {
        return false;
    }
    const auto j = static_cast<size_t>(own.back);
    for (const size_t m : {size_t{1}, size_t{2}}) {
        const NetSide one = (*this)[t].sides[(k + m) % 3], other = (*this)[own.next].sides[(j + 3 - m) % 3];
        if (one.next < 0 || other.next < 0 || one.stays || other.stays || one.next == other.next) {
            return false;
        }
    }
    for (const size_t m : {size_t{1}, size_t{2}}) {
        const NetSide one = (*this)[t].sides[(k + m) % 3], other = (*this)[own.next].sides[(j + 3 - m) % 3];
        link(one.next, static_cast<size_t>(one.back), other.next, static_cast<size_t>(other.back), own);
    }
    erase(std::max(t, own.next));
    erase(std::min(t, own.next));
    return true;
}

void SiteNet::split_triangle(int32_t t, int32_t v) {
    const NetTriangle old = (*this)[t];
    const auto &s = old.sites;
    const std::array<int32_t, 3> made{replace(t, {v, s[1], s[2]}), replace(-1, {v, s[2], s[0]}),
                                      replace(-1, {v, s[0], s[1]})};
    const NetSide inner{-1, 0, -1, false, true};
    for (size_t k = 0; k < 3; ++k) {
        set_side(made[k], 0, old.sides[k]);
        link(made[k], 1, made[(k + 1) % 3], 2, inner);
    }
}

void SiteNet::split_side(int32_t t, size_t k, int32_t v, int32_t w) {
    const NetTriangle one = (*this)[t];
    const NetSide inner{-1, 0, -1, false, true};
    NetSide old = one.sides[k];
    ++old.halvings;
    const int32_t p = one.sites[k], a = one.sites[(k + 1) % 3], b = one.sites[(k + 2) % 3];
    const int32_t first = replace(t, {p, a, v}), second = replace(-1, {p, v, b});
    set_side(first, 2, one.sides[(k + 2) % 3]);
    set_side(second, 1, one.sides[(k + 1) % 3]);
    link(first, 1, second, 2, inner);
    side(first, 0) = side(second, 0) = old;
    if (old.next < 0) {
        return;
    }
    const auto j = static_cast<size_t>(old.back);
    const NetTriangle other = (*this)[old.next];
    const int32_t q = other.sites[j], c = other.sites[(j + 1) % 3], d = other.sites[(j + 2) % 3]; // at b, a
    const int32_t third = replace(old.next, {q, c, w}), fourth = replace(-1, {q, w, d});
    set_side(third, 2, other.sides[(j + 2) % 3]);
    set_side(fourth, 1, other.sides[(j + 1) % 3]);
    link(third, 1, fourth, 2, inner);
    link(second, 0, third, 0, old);
    link(first, 0, fourth, 0, old);
}

} // namespace nrb::mesh
