// Bilinearly blended surfaces: boundaries and the defining formula against exact values.
#include "property/coons_cases.h"

using namespace support;

namespace {

// How far boundary `i` of a surface is from a curve of the same domain, everywhere.
long double boundary_error(const SplineData &surface, size_t i, const SplineData &curve) {
    const int axis = i < 2 ? 0 : 1;
    const std::vector<double> breaks =
        reference::united(reference::breaks_of(surface, 1 - axis), reference::breaks_of(curve, 0));
    long double largest = 0;
    for (size_t s = 0; s + 1 < breaks.size(); ++s) {
        largest = std::max(largest, reference::largest_difference(
                                        reference::edge(surface, axis, i % 2 == 1, breaks[s], breaks[s + 1]),
                                        reference::piece(curve, breaks[s], breaks[s + 1])));
    }
    return largest;
}

void expect_boundaries(uint64_t base, int cases, int max_degree, bool rational, bool clamped,
                       long double allowed) {
    WorstErrors worst("boundaries of Coons surfaces, in eps * hull");
    for_each_case(base, cases, [&](Random &random, uint64_t seed) {
        const Boundaries given = random_boundaries(random, max_degree, rational, clamped);
        Handle made;
        require_ok(coons(handles_of(given.curves), clamped ? 0 : 1e-12, made));
        const SplineData surface = read_back(made.get());
        for (size_t i = 0; i < 4; ++i) {
            const SplineData &curve = given.curves[i];
            const long double unit = eps * extent(curve);
            const long double error = boundary_error(surface, i, curve) - given.gap / 2;
            worst.add(curve.degrees[0], error / (allowed * unit), error / unit);
            ASSERT_LE(error, allowed * unit) << "boundary " << i << where(seed, curve);
        }
    });
}

} // namespace

TEST(Coons, PolynomialBoundariesAreMetEverywhere) {
    expect_boundaries(410000, 60, 9, false, true, 2);
}
TEST(Coons, RationalBoundariesAreMetEverywhere) {
    expect_boundaries(411000, 30, 5, true, true, 2);
}
TEST(Coons, UnclampedBoundariesAreMetEverywhere) {
    expect_boundaries(412000, 30, 5, true, false, 4);
}
