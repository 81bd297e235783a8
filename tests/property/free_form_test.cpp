// Free-form deformations against the exact image and the bound that they state.
#include "property/deform_cases.h"

namespace free_form_test {

using namespace support;
using namespace support::deform;

namespace {

// The corners of a box moved a little, and a volume of higher degree.
SplineData random_volume(Random &random, int axes) {
    SplineData volume;
    volume.dim = axes;
    for (int k = 0; k < axes; ++k) {
        const int p = random.whole(1, 2);
        std::vector<double> knots(static_cast<size_t>(p) + 1, 0.0);
        knots.insert(knots.end(), static_cast<size_t>(p) + 1, 2.0);
        volume.degrees.push_back(p);
        volume.counts.push_back(p + 1);
        volume.knots.push_back(std::move(knots));
    }
    for (int64_t i = 0; i < volume.point_count(); ++i) {
        int64_t rest = i;
        std::vector<double> point(static_cast<size_t>(axes));
        for (int k = axes; k-- > 0;) {
            const auto at = static_cast<size_t>(k);
            point[at] = static_cast<double>(rest % volume.counts[at]) / volume.degrees[at] +
                        random.between(-0.2, 0.2);
            rest /= volume.counts[at];
        }
        volume.points.insert(volume.points.end(), point.begin(), point.end());
    }
    return volume;
}

TEST(FreeForm, is_within_the_bound_of_the_exact_image) {
    int proofs = 0;
    for_each_case(1550000, 60, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(1, 3), axes = random.chance(70) ? 1 : 2;
        Recipe recipe = calm_recipe(random, axes, 3, dim);
        const SplineData data = random_spline(random, recipe), volume = random_volume(random, dim);
        const double size = extent(data), tolerance = axes == 1 ? random.magnitude(1e-8, 1e-3) : 1e-3;
        const std::vector<double> lower(static_cast<size_t>(dim), -size),
            upper(static_cast<size_t>(dim), size);
        const Handle g = create(data), v = create(volume);
        double deviation = -1;
        int32_t proven = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_free_form_deform(g.get(), v.get(), lower.data(), upper.data(), tolerance, &deviation,
                                          &proven, &out));
        const Handle h(out);
        ASSERT_LE(deviation, tolerance);
        proofs += proven;
        const SplineData after = read_back(h.get());
        for (int n = 0; n < 20; ++n) {
            const std::vector<double> param = random_params(random, after, 1);
            std::vector<double> inner;
            for (const Rational &x : point_at(data, param)) {
                inner.push_back(std::clamp(1 + static_cast<double>(as_long_double(x)) / size, 0.0, 2.0));
            }
            const Point image = point_at(volume, inner);
            const long double gap = length(minus(point_at(after, param), image));
            ASSERT_LE(gap, (proven == 1 ? deviation : tolerance) + 64 * eps)
                << where(seed, data) << hex(param);
        }
    });
    std::printf("%d bounds proven\n", proofs);
    ASSERT_GT(proofs, support::of_whole_run(5));
}

} // namespace

} // namespace free_form_test
