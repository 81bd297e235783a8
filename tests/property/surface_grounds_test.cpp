// Meets, splits, trims and regions on surfaces in every form: not clamped, periodic, and constant along an axis.
#include "regions.h"
#include "surface_pairs.h"

#include <numbers>

namespace surface_grounds_test {

using namespace surface_crossings;
using support::models::Face;
using support::models::Model;

namespace {

constexpr double pi = std::numbers::pi, tolerance = 1e-7;

Face whole(const nurbs *surface) {
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &face));
    return Face(face);
}

Model split(const Face &face, const Crossing &crossing) {
    std::vector<const nurbs *> curves;
    for (const Branch &branch : crossing.found.branches) {
        curves.push_back(branch.on.get());
    }
    nurbs_model *parts = nullptr;
    require_ok(nurbs_face_split(face.get(), std::ssize(curves), curves.data(), tolerance, &parts));
    return Model(parts);
}

Model trim(const Face &face, const nurbs *surface, int32_t side) {
    nurbs_model *kept = nullptr;
    require_ok(nurbs_face_trim(face.get(), surface, side, tolerance, &kept));
    return Model(kept);
}

std::vector<double> areas(const Model &model) {
    std::vector<double> result;
    for (const Face &face : support::regions::faces_of(model.get())) {
        result.push_back(support::faces::area_of(face.get(), 1e-6));
    }
    std::ranges::sort(result);
    return result;
}
double sum(const std::vector<double> &values) {
    double all = 0;
    for (const double x : values) {
        all += x;
    }
    return all;
}

// What a surface is divided into by another one, in four ways.
struct Cut {
    int64_t open = 0, closed = 0;
    bool complete = false;
    std::vector<double> parts; // their areas, rising
    double front = 0, back = 0, all = 0;
};
Cut cut_of(const nurbs *a, const nurbs *b) {
    const Crossing crossing = crossing_of(a, b, tolerance);
    Cut cut{crossing.open_ways, crossing.closed_ways, crossing.found.complete, {}, 0, 0, 0};
    if (!cut.complete) {
        return cut;
    }
    const Face face = whole(a);
    const Model parts = split(face, crossing);
    cut.parts = areas(parts);
    cut.front = sum(areas(trim(face, b, NURBS_TRIM_FRONT)));
    cut.back = sum(areas(trim(face, b, NURBS_TRIM_BACK)));
    // Together the parts are all of it again.
    const Model none;
    Model all;
    require_ok(support::regions::try_combine(NURBS_REGION_UNION, parts, none, all));
    cut.all = sum(areas(all));
    EXPECT_EQ(support::models::counts_of(all.get()).faces, 1);
    return cut;
}

void expect_same(const Cut &cut, const Cut &other, const char *form) {
    SCOPED_TRACE(form);
    ASSERT_TRUE(cut.complete && other.complete);
    EXPECT_EQ(other.open, cut.open);
    EXPECT_EQ(other.closed, cut.closed);
    const double size = sum(cut.parts);
    ASSERT_EQ(other.parts.size(), cut.parts.size());
    for (size_t i = 0; i < cut.parts.size(); ++i) {
        EXPECT_NEAR(other.parts[i], cut.parts[i], 1e-5 * size);
    }
    EXPECT_NEAR(other.front, cut.front, 1e-5 * size);
    EXPECT_NEAR(other.back, cut.back, 1e-5 * size);
    EXPECT_NEAR(other.front + other.back, size, 1e-5 * size);
    EXPECT_NEAR(other.all, size, 1e-5 * size);
}

// At both ends of both axes, where weights stay positive.
Handle unclamped(const nurbs *g) {
    Handle result = made([&](nurbs **out) { return nurbs_clone(g, out); });
    for (int32_t axis = 0; axis < 2; ++axis) {
        nurbs *out = nullptr;
        if (nurbs_unclamp(result.get(), axis, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &out) ==
            NURBS_OK) {
            result.reset(out);
        }
    }
    return result;
}
bool is_clamped(const nurbs *g) {
    const SplineData data = read_back(g);
    return data.knots[0][0] == data.knots[0][1] && data.knots[1][0] == data.knots[1][1];
}

TEST(SurfaceGrounds, NotClamped) {
    Random random(0x5e11);
    int64_t compared = 0;
    const int64_t cases = scaled(8);
    // Of some, weights do not stay positive.
    for (int64_t i = 0; i < cases || (compared < cases / 2 && i < 8 * cases); ++i) {
        SCOPED_TRACE(i);
        const Handle a = create(hills(random)), // within the other one, seen from above
            b = create(support::moved(support::scaled(hills(random), 2), {0, 0, random.between(-0.3, 0.3)}));
        const Cut cut = cut_of(a.get(), b.get());
        if (cut.complete && !cut.parts.empty()) {
            const Handle other_a = unclamped(a.get()), other_b = unclamped(b.get());
            expect_same(cut, cut_of(other_a.get(), b.get()), "the ground");
            expect_same(cut, cut_of(a.get(), other_b.get()), "the other one");
            compared += is_clamped(other_a.get()) ? 0 : 1;
        }
    }
    EXPECT_GE(compared, cases / 2);
}

SplineData plane(const Point3 &at, const Point3 &u, const Point3 &v) {
    return net_of({2, 2}, {1, 1}, false, [&](double s, double t) {
        std::array<double, 4> x{0, 0, 0, 1};
        for (size_t c = 0; c < 3; ++c) {
            x[c] = at[c] + (8 * s - 4) * u[c] + (8 * t - 4) * v[c];
        }
        return x;
    });
}

// Of shapes that close: with seams, and without.
TEST(SurfaceGrounds, Periodic) {
    const SplineData tube = revolved(segment(1, -1, 1, 1), 0, 2 * pi),
                     ring = revolved(ellipse_arc(2, 0, 0.7, 0.7, 0, 2 * pi), 0, 2 * pi);
    const std::vector<SplineData> planes{plane({0.1, 0.2, 0.3}, {1, 0, 0.1}, {0, 1, 0.2}),
                                         plane({0.3, 0.1, 0}, {0.1, 1, 0}, {0.2, 0, 1}),
                                         plane({0.2, 1.6, 0.1}, {1, 0.1, 0}, {0, 0.1, 1})};
    int64_t compared = 0;
    for (const SplineData &shape : {tube, ring}) {
        for (const SplineData &flat : planes) {
            const Handle a = create(shape), b = create(flat),
                         closed = support::periodic_where_closed(create(shape), 2);
            const Cut cut = cut_of(a.get(), b.get());
            expect_same(cut, cut_of(closed.get(), b.get()), "periodic");
            compared += cut.parts.size() > 1 ? 1 : 0;
        }
    }
    EXPECT_GE(compared, 4);
}

// Strands of a parabola, as many as there are spans: each meets the plane z = 0 twice, which is left open in one part each. The
// parameters of such a surface have an area, its points have none: it is divided by curves, but not by surfaces. A single strand is
// the same at both ends of its constant axis, as a surface that closes.
TEST(SurfaceGrounds, ConstantAlongAnAxis) {
    const Handle flat = create(plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
                 line = create({{1}, {2}, {{0, 0, 1, 1}}, 2, {0.3, 0, 0.6, 1}, {}, 0});
    for (const size_t constant : {size_t{0}, size_t{1}}) {
        for (const int64_t strands : {1, 3}) {
            SCOPED_TRACE(testing::Message() << "axis " << constant << ", " << strands);
            SplineData data{{2, 2}, {3, 3}, {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
            data.degrees[constant] = 0;
            data.counts[constant] = strands;
            data.knots[constant].clear();
            for (int64_t i = 0; i <= strands; ++i) {
                data.knots[constant].push_back(static_cast<double>(i) / static_cast<double>(strands));
            }
            for (int64_t i = 0; i < data.counts[0]; ++i) {
                for (int64_t j = 0; j < data.counts[1]; ++j) {
                    const int64_t strand = constant == 0 ? i : j, at = constant == 0 ? j : i;
                    data.points.insert(
                        data.points.end(),
                        {static_cast<double>(at) - 1, 0.3 * static_cast<double>(strand), at == 1 ? 1 : -0.5});
                }
            }
            const Handle g = create(data);
            const Crossing crossing = crossing_of(g.get(), flat.get(), tolerance);
            EXPECT_FALSE(crossing.found.complete);
            EXPECT_EQ(crossing.found.branches.size(), 0U);
            EXPECT_EQ(crossing.found.count(NURBS_NODE_UNDECIDED), 2 * strands);
            for (const MeetPart &node : crossing.found.nodes) {
                EXPECT_NEAR(point_at(g.get(), node.at[0], node.at[1])[2], 0, 1e-4);
            }
            const Face face = whole(g.get());
            const nurbs *curve = line.get();
            nurbs_model *parts = nullptr;
            require_ok(nurbs_face_split(face.get(), 1, &curve, tolerance, &parts));
            EXPECT_EQ(support::models::counts_of(Model(parts).get()).faces, strands == 1 ? 1 : 2);
            nurbs_model *kept = nullptr;
            EXPECT_EQ(nurbs_face_trim(face.get(), flat.get(), NURBS_TRIM_FRONT, tolerance, &kept),
                      NURBS_ERROR_NOT_CONVERGED);
            EXPECT_EQ(kept, nullptr);
        }
    }
}

} // namespace

} // namespace surface_grounds_test
