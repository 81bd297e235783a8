// Bicubically blended surfaces: boundaries, cross tangents, twists and joints against exact values.
#include "property/coons_cases.h"

#include <optional>

namespace coons_hermite_test {

using namespace support;
using reference::BoundaryBlend;
using reference::operator*;
using reference::operator+;
using reference::operator-;
using reference::Point;
using reference::Rational;

namespace {

struct Patch {
    std::vector<SplineData> boundaries;
    std::vector<SplineData> cross;

    [[nodiscard]] std::vector<SplineData> all() const {
        std::vector<SplineData> curves = boundaries;
        curves.insert(curves.end(), cross.begin(), cross.end());
        return curves;
    }
};

struct Made {
    SplineData surface;
    double bound = 0;
};

Made hermite(const Patch &patch, int32_t twist, const double *twists = nullptr, double tolerance = 1e-10) {
    const std::vector<Handle> boundaries = handles_of(patch.boundaries), cross = handles_of(patch.cross);
    nurbs *out = nullptr;
    Made made;
    require_ok(nurbs_surface_coons_hermite(pointers(boundaries).data(),
                                           cross.empty() ? nullptr : pointers(cross).data(), twist, twists,
                                           tolerance, &made.bound, &out));
    const Handle handle(out);
    made.surface = read_back(out);
    return made;
}

std::vector<double> rounded(const Point &point) {
    std::vector<double> result;
    for (const Rational &x : point) {
        result.push_back(reference::nearest(reference::fraction(x)));
    }
    return result;
}

// Value and derivative of a clamped curve at an end, by its two control points there.
void set_end(SplineData &curve, bool upper, const std::vector<double> &value,
             const std::vector<double> &slope) {
    const std::vector<double> &t = curve.knots[0];
    const auto p = static_cast<size_t>(curve.degrees[0]), n = static_cast<size_t>(curve.counts[0]);
    const size_t end = upper ? n - 1 : 0, next = upper ? n - 2 : 1;
    const double length = upper ? t[n - 1] - t[n + p - 1] : t[p + 1] - t[1];
    const double ratio = curve.rational() ? curve.weights[end] / curve.weights[next] : 1;
    for (size_t c = 0; c < 3; ++c) {
        curve.points[3 * end + c] = value[c];
        curve.points[3 * next + c] = value[c] + slope[c] * ratio * length / static_cast<double>(p);
    }
}

// The tangent of the boundary that ends where boundary `i` has its end `upper`, to which the cross tangent
// there belongs.
std::vector<double> tangent_at(const Patch &patch, size_t i, bool upper) {
    const SplineData &other = patch.boundaries[(i < 2 ? 2 : 0) + (upper ? 1 : 0)];
    return rounded(reference::exact_slope(other, i % 2 == 0 ? other.lower(0) : other.upper(0)));
}

using Twists = std::array<double, 12>;

Twists random_twists(Random &random) {
    Twists twists{};
    for (double &x : twists) {
        x = random.between(-1, 1) / 8;
    }
    return twists;
}

std::vector<double> twist_of(const Twists &twists, size_t i, bool upper) {
    const size_t corner = i < 2 ? 2 * i + (upper ? 1 : 0) : 2 * (upper ? 1 : 0) + i - 2;
    return {twists.begin() + static_cast<std::ptrdiff_t>(3 * corner),
            twists.begin() + static_cast<std::ptrdiff_t>(3 * corner + 3)};
}

// Cross tangents that agree with the boundaries and with twists.
SplineData random_cross(Random &random, const Patch &patch, size_t i, const Twists &twists, bool rational) {
    SplineData curve = random_boundary(random, random.whole(3, 5), KnotForm::clamped,
                                       rational && random.chance(50) ? Weights::moderate : Weights::none);
    for (const bool upper : {false, true}) {
        set_end(curve, upper, tangent_at(patch, i, upper), twist_of(twists, i, upper));
    }
    return curve;
}

Patch random_patch(Random &random, int max_degree, bool rational, const Twists &twists, bool even = true) {
    Patch patch{random_boundaries(random, max_degree, rational, true).curves, {}};
    for (size_t i = 0; i < 4; ++i) {
        patch.cross.push_back(
            random_cross(random, patch, i, even ? twists : random_twists(random), rational));
    }
    return patch;
}

double largest_extent(const std::vector<SplineData> &curves) {
    double largest = 0;
    for (const SplineData &curve : curves) {
        largest = std::max(largest, extent(curve));
    }
    return largest;
}

// eps times the largest magnitude of what is blended: positions, tangents and twists by lengths of 8.
double unit_of(const Patch &patch) {
    return static_cast<double>(eps) * std::max(largest_extent(patch.boundaries),
                                               patch.cross.empty() ? 0 : 8 * largest_extent(patch.cross));
}

// What the control points of the layer beside an edge may be off by, as the derivative that they give: the
// layer is P_0 + h / p d with P_0, d within 3 eps and rounded, the weights of both layers are products that
// are rounded.
double allowed_slope(const SplineData &surface, size_t i, const Patch &patch) {
    const size_t axis = i < 2 ? 0 : 1;
    const std::vector<double> &t = surface.knots[axis];
    const auto p = static_cast<size_t>(surface.degrees[axis]), n = static_cast<size_t>(surface.counts[axis]);
    const double length = i % 2 == 0 ? t[p + 1] - t[1] : t[n + p - 1] - t[n - 1];
    const auto step = static_cast<int64_t>(axis == 0 ? surface.counts[1] : 1);
    const int64_t end = i % 2 == 0 ? 0 : surface.point_count() - 1;
    const double ratio = surface.weight(end + (i % 2 == 0 ? step : -step)) / surface.weight(end);
    return static_cast<double>(eps) *
           (6 * std::max(1.0, ratio) * static_cast<double>(p) / length * largest_extent(patch.boundaries) +
            6 * largest_extent(patch.cross));
}

long double edge_error(const SplineData &surface, size_t i, const SplineData &curve, bool derivative) {
    const int axis = i < 2 ? 0 : 1;
    const std::vector<double> breaks =
        reference::united(reference::breaks_of(surface, 1 - axis), reference::breaks_of(curve, 0));
    long double largest = 0;
    for (size_t s = 0; s + 1 < breaks.size(); ++s) {
        const auto of_surface = derivative ? reference::edge_derivative : reference::edge;
        largest = std::max(largest, reference::largest_difference(
                                        of_surface(surface, axis, i % 2 == 1, breaks[s], breaks[s + 1]),
                                        reference::piece(curve, breaks[s], breaks[s + 1])));
    }
    return largest;
}

struct Gaps {
    double positions[4];
    double tangents[8];
    double twists[4];
};

Gaps gaps_of(const Patch &patch) {
    Gaps gaps{};
    const std::vector<Handle> boundaries = handles_of(patch.boundaries), cross = handles_of(patch.cross);
    require_ok(nurbs_coons_gaps(pointers(boundaries).data(), cross.empty() ? nullptr : pointers(cross).data(),
                                gaps.positions, gaps.tangents, gaps.twists));
    return gaps;
}

void expect_edges(uint64_t base, int cases, int max_degree, bool rational, long double allowed) {
    WorstErrors points("boundaries of bicubic Coons surfaces, in eps * hull"), slopes("their cross tangents");
    for_each_case(base, cases, [&](Random &random, uint64_t seed) {
        const Patch patch = random_patch(random, max_degree, rational, random_twists(random));
        const Made made = hermite(patch, NURBS_TWIST_COMPATIBLE);
        const Gaps gaps = gaps_of(patch);
        const double turn = *std::max_element(gaps.tangents, gaps.tangents + 8);
        const double bend = *std::max_element(gaps.twists, gaps.twists + 4);
        for (size_t i = 0; i < 4; ++i) {
            const SplineData &curve = patch.boundaries[i];
            const long double unit = eps * extent(curve); // the blend of tangents weighs 8 * 4 / 27 at most
            const long double error = edge_error(made.surface, i, curve, false) - turn;
            points.add(curve.degrees[0], error / (allowed * unit), error / unit);
            ASSERT_LE(error, allowed * unit) << "boundary " << i << where(seed, made.surface);
            const double bound = allowed_slope(made.surface, i, patch);
            const long double slope = edge_error(made.surface, i, patch.cross[i], true) - turn - 2 * bend;
            slopes.add(curve.degrees[0], slope / bound, slope / bound);
            ASSERT_LE(slope, bound) << "cross tangent " << i << where(seed, made.surface);
        }
    });
}

} // namespace

// Half an eps more than where boundaries stay as they are, since tangents at the corners agree to rounding
// only.
TEST(CoonsHermite, polynomial_edges_are_met_everywhere) {
    expect_edges(420000, 14, 7, false, 2.5L);
}
// One more eps for each of three denominators that may be multiplied with.
TEST(CoonsHermite, rational_edges_are_met_everywhere) {
    expect_edges(421000, 3, 2, true, 5.5L);
}

TEST(CoonsHermite, agrees_with_the_matrix_form) {
    WorstErrors worst("bicubic Coons surfaces, in eps * hull");
    for_each_case(422000, 60, [&](Random &random, uint64_t seed) {
        const bool rational = random.chance(30);
        Twists twists = random_twists(random);
        Patch patch = random_patch(random, rational ? 2 : 6, rational, twists, random.chance(50));
        BoundaryBlend formula(patch.all());
        const int32_t rule = random.whole(NURBS_TWIST_AVERAGE, NURBS_TWIST_ZERO);
        twists = random_twists(random);
        for (size_t corner = 0; corner < 4 && rule != NURBS_TWIST_AVERAGE; ++corner) {
            for (size_t c = 0; c < 3; ++c) {
                formula.corner(2 + corner / 2, 2 + corner % 2)[c] =
                    rule == NURBS_TWIST_ZERO ? 0 : reference::exact(twists[3 * corner + c]);
            }
        }
        Patch given = patch;
        for (const size_t i : {1U, 3U}) {
            given.boundaries[i] = mapped(given.boundaries[i], 5);
            given.cross[i] = mapped(given.cross[i], -3);
        }
        const Made made = hermite(given, rule, rule == NURBS_TWIST_GIVEN ? twists.data() : nullptr);
        const double unit = unit_of(patch), error = formula_error(made.surface, formula, random);
        worst.add(made.surface.degrees[0], error / (20 * unit), error / unit);
        ASSERT_LE(error, 20 * unit) << "rule " << rule << where(seed, made.surface);
    });
}

namespace {

// S_uv at a corner, from four control points of a polynomial surface.
Point twist_at(const SplineData &s, bool upper0, bool upper1) {
    const std::vector<double> at{upper0 ? s.upper(0) : s.lower(0), upper1 ? s.upper(1) : s.lower(1)};
    const auto derivatives = reference::exact_derivatives(s, 2, at.data());
    Point point;
    for (const reference::Fraction &x : derivatives[4]) {
        point.emplace_back(x.numerator, x.denominator);
    }
    return point;
}

// The rules as they are defined, from exact values of the boundaries.
Point defined_twist(const Patch &patch, int32_t rule, size_t i, size_t j, const Twists &given) {
    const auto end = [&](size_t curve, size_t upper) {
        const SplineData &c = patch.boundaries[curve];
        return upper == 0 ? c.lower(0) : c.upper(0);
    };
    Point twist;
    for (size_t c = 0; c < 3; ++c) {
        const auto corner = [&](size_t a, size_t b) {
            return reference::exact_value(patch.boundaries[a], {end(a, b)})[c];
        };
        const auto slope = [&](size_t curve, size_t upper) {
            return reference::exact_slope(patch.boundaries[curve], end(curve, upper))[c];
        };
        const Rational bilinear = (corner(0, 0) - corner(0, 1) - corner(1, 0) + corner(1, 1)) / 64;
        twist.push_back(rule == NURBS_TWIST_GIVEN      ? reference::exact(given[6 * i + 3 * j + c])
                        : rule == NURBS_TWIST_BILINEAR ? bilinear
                        : rule == NURBS_TWIST_ADINI
                            ? (slope(1, j) - slope(0, j)) / 8 + (slope(3, i) - slope(2, i)) / 8 - bilinear
                            : Rational(0));
    }
    return twist;
}

} // namespace

// Also that Adini's twist is that of the bilinear surface, which the library makes.
TEST(CoonsHermite, twists_follow_their_rules) {
    for_each_case(423000, 30, [&](Random &random, uint64_t seed) {
        const Twists given = random_twists(random);
        Patch patch = random_patch(random, 5, false, given);
        if (random.chance(50)) {
            patch.cross.clear();
        }
        Handle bilinear;
        require_ok(coons(handles_of(patch.boundaries), 0, bilinear));
        const SplineData simple = read_back(bilinear.get());
        for (int32_t rule = NURBS_TWIST_GIVEN; rule <= NURBS_TWIST_ADINI; ++rule) {
            const Made made = hermite(patch, rule, rule == NURBS_TWIST_GIVEN ? given.data() : nullptr);
            double gap = 0;
            for (size_t corner = 0; corner < 4; ++corner) {
                const size_t i = corner / 2, j = corner % 2;
                const Point want = defined_twist(patch, rule, i, j, given),
                            got = twist_at(made.surface, i == 1, j == 1);
                // Differences of control points that are eps of the size apart, by spans as short as 1/8 with
                // degrees up to 5 on both axes.
                const double allowed = 16 * 40 * 40 * unit_of(patch);
                ASSERT_LE(difference(got, want), allowed) << "rule " << rule << where(seed, made.surface);
                if (rule == NURBS_TWIST_ADINI) {
                    ASSERT_LE(difference(twist_at(simple, i == 1, j == 1), want), allowed);
                }
                const Point own = defined_twist(patch, NURBS_TWIST_GIVEN, i, j, given);
                double square = 0;
                for (size_t c = 0; c < 3; ++c) {
                    square += std::pow(size_of(want[c] - own[c]), 2);
                }
                gap = std::max(gap, std::sqrt(square));
            }
            ASSERT_NEAR(made.bound, patch.cross.empty() ? 0 : gap,
                        1e-9 * unit_of(patch) / static_cast<double>(eps))
                << "rule " << rule << where(seed, made.surface);
        }
    });
}

TEST(CoonsHermite, zero_twists_make_fergusons_patch) {
    for_each_case(424000, 20, [&](Random &random, uint64_t seed) {
        Patch patch{random_boundaries(random, 4, random.chance(40), true).curves, {}};
        const SplineData surface = hermite(patch, NURBS_TWIST_ZERO).surface;
        for (size_t i = 0; i < 4; ++i) { // Hermite's cubics of the tangents at the corners
            SplineData cubic;
            cubic.degrees = {3};
            cubic.counts = {4};
            cubic.knots = {{0, 0, 0, 0, 8, 8, 8, 8}};
            cubic.dim = 3;
            cubic.points.resize(12);
            for (const bool upper : {false, true}) {
                set_end(cubic, upper, tangent_at(patch, i, upper), {0, 0, 0});
            }
            patch.cross.push_back(cubic);
        }
        const SplineData same = hermite(patch, NURBS_TWIST_COMPATIBLE).surface;
        ASSERT_EQ(surface.knots, same.knots);
        for (size_t i = 0; i < surface.points.size(); ++i) {
            ASSERT_NEAR(surface.points[i], same.points[i], 16 * unit_of(patch)) << where(seed, surface);
        }
    });
}

TEST(CoonsHermite, reproduces_bicubic_patches) {
    for_each_case(425000, 30, [&](Random &random, uint64_t seed) {
        SplineData bicubic;
        bicubic.degrees = {3, 3};
        bicubic.counts = {4, 4};
        bicubic.knots = {{0, 0, 0, 0, 8, 8, 8, 8}, {0, 0, 0, 0, 8, 8, 8, 8}};
        bicubic.dim = 3;
        for (int i = 0; i < 48; ++i) {
            bicubic.points.push_back(random.whole(-64, 64) / 8.0);
        }
        const Handle g = create(bicubic);
        Patch patch;
        for (size_t i = 0; i < 4; ++i) {
            const int axis = i < 2 ? 0 : 1;
            nurbs *out = nullptr;
            require_ok(nurbs_derivative(g.get(), axis, 1, &out));
            const Handle derivative(out);
            patch.boundaries.push_back(read_back(iso(g.get(), axis, i % 2 == 0 ? 0 : 8).get()));
            patch.cross.push_back(read_back(iso(derivative.get(), axis, i % 2 == 0 ? 0 : 8).get()));
        }
        const Made made = hermite(patch, NURBS_TWIST_COMPATIBLE, nullptr, 0);
        ASSERT_EQ(made.bound, 0.0);
        ASSERT_EQ(made.surface.knots, bicubic.knots);
        for (size_t i = 0; i < bicubic.points.size(); ++i) {
            ASSERT_NEAR(made.surface.points[i], bicubic.points[i], 4 * unit_of(patch))
                << where(seed, bicubic);
        }
    });
}

namespace {

// Largest triple product of the cross tangents of two surfaces on both sides of an edge, axis 0 at the end of
// the first one and at the start of the second one, with the tangent of the edge: 0 where the planes agree.
long double torn(const SplineData &first, const SplineData &second) {
    const std::vector<double> breaks =
        reference::united(reference::breaks_of(first, 1), reference::breaks_of(second, 1));
    long double largest = 0;
    for (size_t s = 0; s + 1 < breaks.size(); ++s) {
        const double a = breaks[s], b = breaks[s + 1];
        const reference::QuotientPiece before = reference::edge_derivative(first, 0, true, a, b),
                                       behind = reference::edge_derivative(second, 0, false, a, b),
                                       along = reference::edge(first, 0, true, a, b);
        std::array<reference::Polynomial, 3> tangent; // of a polynomial edge
        for (size_t c = 0; c < 3; ++c) {
            const reference::Polynomial &x = along.numerators[c];
            for (size_t k = 0; k + 1 < x.size(); ++k) {
                tangent[c].push_back((x[k + 1] - x[k]) * Rational(static_cast<int64_t>(x.size()) - 1) /
                                     (reference::exact(b) - reference::exact(a)));
            }
        }
        reference::Polynomial product{0};
        for (size_t c = 0; c < 3; ++c) {
            const size_t d = (c + 1) % 3, e = (c + 2) % 3;
            product = product + tangent[c] * (before.numerators[d] * behind.numerators[e] -
                                              before.numerators[e] * behind.numerators[d]);
        }
        for (const Rational &x : product) {
            largest = std::max<long double>(largest, size_of(x));
        }
    }
    return largest;
}

// The patch behind the end of axis 0 of another one: it begins with the same curve, with cross tangents twice
// as long.
Patch neighbour(Random &random, const Patch &patch, const Twists &twists) {
    Patch next{random_boundaries(random, 4, false, true).curves, {}};
    next.boundaries[0] = patch.boundaries[1];
    const auto corner = [&](size_t curve, bool upper) { return end_of(next.boundaries[curve], upper); };
    move_ends(next.boundaries[2], corner(0, false), corner(1, false));
    move_ends(next.boundaries[3], corner(0, true), corner(1, true));
    next.cross.push_back(scaled(patch.cross[1], 2));
    for (const size_t i : {2U, 3U}) { // they leave the common edge in the plane
        SplineData cubic = random_boundary(random, 3, KnotForm::clamped, Weights::none);
        const SplineData &across = next.cross[0];
        const double t = i == 2 ? across.lower(0) : across.upper(0);
        set_end(cubic, false, rounded(reference::exact_value(next.boundaries[i], {0.0})),
                rounded(reference::exact_value(across, {t})));
        set_end(cubic, true, rounded(reference::exact_value(next.boundaries[i], {8.0})), {1, 0, 0});
        next.boundaries[i] = cubic;
    }
    Twists own = random_twists(random);
    for (size_t c = 0; c < 6; ++c) {
        own[c] = 2 * twists[6 + c];
    }
    for (size_t i = 1; i < 4; ++i) {
        next.cross.push_back(random_cross(random, next, i, own, false));
    }
    return next;
}

} // namespace

TEST(CoonsHermite, neighbours_share_tangent_planes) {
    for_each_case(426000, 10, [&](Random &random, uint64_t seed) {
        const Twists twists = random_twists(random);
        const Patch patch = random_patch(random, 4, false, twists), next = neighbour(random, patch, twists);
        const SplineData first = hermite(patch, NURBS_TWIST_COMPATIBLE).surface,
                         second = hermite(next, NURBS_TWIST_COMPATIBLE).surface;
        // The errors of both cross tangents, by the other one and the tangent along the edge; the corners'
        // gaps are of the same order.
        const double slope = static_cast<double>(largest_extent(patch.cross)) * 2 + 1;
        const double along = 40 * largest_extent(patch.boundaries);
        const double allowed =
            6 * slope * along * (4 * allowed_slope(first, 1, patch) + 4 * allowed_slope(second, 0, next));
        EXPECT_LE(torn(first, second), allowed) << where(seed, first);

        Handle made, behind;
        require_ok(coons(handles_of(patch.boundaries), 0, made));
        require_ok(coons(handles_of(next.boundaries), 1e-12, behind));
        EXPECT_GT(torn(read_back(made.get()), read_back(behind.get())), 1e3 * allowed) << where(seed, first);
    });
}

TEST(CoonsHermite, gaps_have_their_sizes) {
    for_each_case(427000, 20, [&](Random &random, uint64_t seed) {
        Patch patch = random_patch(random, 4, random.chance(50), random_twists(random), false);
        for (SplineData &curve : patch.cross) {
            curve.points[0] += 0.25;
        }
        const Gaps gaps = gaps_of(patch);
        const BoundaryBlend formula(patch.all());
        const auto gap = [&](size_t i, size_t j) {
            const Point a = formula.own(i, j, true), b = formula.own(i, j, false);
            double square = 0;
            for (size_t c = 0; c < 3; ++c) {
                square += std::pow(size_of(a[c] - b[c]), 2);
            }
            return std::sqrt(square);
        };
        const double allowed = 1e-12 * unit_of(patch) / static_cast<double>(eps);
        for (size_t corner = 0; corner < 4; ++corner) {
            const size_t i = corner / 2, j = corner % 2;
            ASSERT_NEAR(gaps.positions[corner], gap(i, j), allowed) << where(seed, patch.cross[0]);
            ASSERT_NEAR(gaps.tangents[2 * corner], gap(i + 2, j), allowed);
            ASSERT_NEAR(gaps.tangents[2 * corner + 1], gap(i, j + 2), allowed);
            ASSERT_NEAR(gaps.twists[corner], gap(i + 2, j + 2), allowed);
        }
    });
}

} // namespace coons_hermite_test
