// Euler's relation of the arrangement that meets with other surfaces make in the domain of a surface: as many parts as it says,
// and so on each of the surfaces.
#include "curve_meets.h"
#include "regions.h"
#include "surface_pairs.h"

#include <map>
#include <numeric>

namespace surface_splits_test {

using namespace surface_crossings;
using support::models::Face;
using support::models::Model;

namespace {

// A surface with its meets with others.
struct Cut {
    std::vector<Crossing> meets;
    std::vector<std::vector<Point3>> common; // points of meets i and j > i, by i and j

    [[nodiscard]] bool complete() const {
        return std::ranges::all_of(meets, [](const Crossing &meet) {
            return meet.found.complete && meet.found.count(NURBS_NODE_TOUCH) == 0;
        });
    }
};

// Points of three surfaces, if it is proven that they are all.
bool common_points(const nurbs *a, const nurbs *b, const nurbs *c, std::vector<Point3> &points) {
    int64_t count = 0;
    int32_t complete = 0;
    require_ok(
        nurbs_surfaces_common_points(a, b, c, 0, 0, nullptr, nullptr, nullptr, nullptr, &count, nullptr));
    points.resize(static_cast<size_t>(count));
    require_ok(nurbs_surfaces_common_points(a, b, c, 0, count, nullptr,
                                            count > 0 ? points.front().data() : nullptr, nullptr, nullptr,
                                            &count, &complete));
    return complete == 1;
}

// Branches, and the border of a domain, as a graph: V - E and the number of its connected parts.
class Graph {
public:
    explicit Graph(const Cut &cut, const Ground &ground) {
        for (const Crossing &meet : cut.meets) {
            first_.push_back(own_.size());
            own_.insert(own_.end(), meet.found.branches.size(), {});
        }
        own_.push_back({}); // the border, on which nodes are as many vertices as edges
        of_.resize(own_.size());
        std::iota(of_.begin(), of_.end(), size_t{0});
        add_crossings(cut);
        for (size_t i = 0; i < cut.meets.size(); ++i) {
            add_own_crossings(cut.meets[i].found, first_[i]);
        }
        for (size_t i = 0; i < cut.meets.size(); ++i) {
            for (size_t k = 0; k < cut.meets[i].found.branches.size(); ++k) {
                add_branch(cut.meets[i].found, first_[i] + k, cut.meets[i].found.branches[k], ground);
            }
        }
    }

    // V - E + F = 1 + C, with what is outside of the domain as a face.
    [[nodiscard]] int64_t faces() const {
        int64_t parts = 0;
        for (size_t i = 0; i < of_.size(); ++i) {
            parts += of_[i] == i ? 1 : 0;
        }
        return parts - excess_;
    }

private:
    void add_crossings(const Cut &cut) {
        size_t pair = 0;
        for (size_t i = 0; i < cut.meets.size(); ++i) {
            for (size_t j = i + 1; j < cut.meets.size(); ++j, ++pair) {
                for (const Point3 &point : cut.common[pair]) {
                    const size_t x = first_[i] + nearest_branch(cut.meets[i], point).branch,
                                 y = first_[j] + nearest_branch(cut.meets[j], point).branch;
                    ++own_[x];
                    ++own_[y];
                    ++excess_;
                    join(x, y);
                }
            }
        }
    }
    // Where the other surface meets itself, so do its branches.
    void add_own_crossings(const Found &found, size_t first) {
        const double tolerance = 1e-9;
        for (size_t i = 0; i < found.branches.size(); ++i) {
            const nurbs *const own = found.branches[i].on.get();
            cross(first + i, first + i, curve_meets::own_meets(own, tolerance));
            for (size_t j = 0; j < i; ++j) {
                cross(first + i, first + j, curve_meets::meets(own, found.branches[j].on.get(), tolerance));
            }
        }
    }
    void cross(size_t x, size_t y, const curve_meets::Hits &hits) {
        EXPECT_EQ(hits.complete, 1);
        const int64_t crossings = hits.count(NURBS_HIT_CROSSING);
        own_[x] += crossings;
        own_[y] += crossings;
        excess_ += crossings;
        if (crossings > 0) {
            join(x, y);
        }
    }
    void add_branch(const Found &found, size_t index, const Branch &branch, const Ground &ground) {
        if (branch.closed()) {
            excess_ -= own_[index]; // without a crossing, a vertex with an edge
            return;
        }
        excess_ -= own_[index] + 1;
        for (const int64_t node : branch.nodes) {
            if (is_on_border(found.nodes[static_cast<size_t>(node)].at, ground)) {
                join(index, own_.size() - 1);
            } else {
                ++excess_;
            }
        }
    }
    static bool is_on_border(const Place &at, const Ground &ground) {
        bool on = false;
        for (size_t k = 0; k < 2; ++k) {
            on = on || std::abs(at[k] - ground.domain(k)[0]) <= 1e-12 ||
                 std::abs(at[k] - ground.domain(k)[1]) <= 1e-12;
        }
        return on;
    }
    size_t root(size_t i) {
        while (of_[i] != i) {
            i = of_[i] = of_[of_[i]];
        }
        return i;
    }
    void join(size_t x, size_t y) { of_[root(x)] = root(y); }

    std::vector<size_t> first_, of_;
    std::vector<int64_t> own_; // crossings on each branch
    int64_t excess_ = 0;       // V - E
};

Model split(const nurbs *surface, const Cut &cut) {
    nurbs_face *whole = nullptr;
    require_ok(nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &whole));
    const Face face(whole);
    std::vector<const nurbs *> curves;
    for (const Crossing &meet : cut.meets) {
        for (const Branch &branch : meet.found.branches) {
            curves.push_back(branch.on.get());
        }
    }
    nurbs_model *parts = nullptr;
    require_ok(nurbs_face_split(face.get(), std::ssize(curves), curves.data(), 1e-8, &parts));
    return Model(parts);
}

// Pieces of the border of a part: loops, but for those that have a point in common.
int64_t borders_of(const nurbs_face *face) {
    int64_t loops = 0;
    require_ok(nurbs_face_loops(face, 0, nullptr, &loops));
    std::vector<int64_t> sizes(static_cast<size_t>(loops));
    require_ok(nurbs_face_loops(face, loops, sizes.data(), nullptr));
    int64_t borders = loops;
    std::vector<size_t> of(sizes.size());
    std::iota(of.begin(), of.end(), size_t{0});
    std::map<Point3, size_t> known; // bit for bit
    for (size_t i = 0; i < sizes.size(); ++i) {
        for (int64_t k = 0; k < sizes[i]; ++k) {
            const Handle edge = made(
                [&](nurbs **out) { return nurbs_face_edge(face, static_cast<int64_t>(i), k, nullptr, out); });
            std::array<double, 2> domain{};
            require_ok(nurbs_domain(edge.get(), 0, domain.data()));
            for (const Point3 &end : points_on(edge.get(), {domain[0], domain[1]})) {
                const size_t other = of[known.try_emplace(end, i).first->second];
                if (other != of[i]) {
                    std::ranges::replace(of, size_t{of[i]}, other);
                    --borders;
                }
            }
        }
    }
    return borders;
}

// Of parts that may have holes: V - E + the sum of (2 - pieces of the border) is that of the domain, a disk.
void check_model(const nurbs *surface, const nurbs_model *parts) {
    const auto counts = support::models::counts_of(parts);
    int64_t sum = counts.vertices - counts.edges;
    double area = 0, whole = 0;
    for (const Face &face : support::regions::faces_of(parts)) {
        sum += 2 - borders_of(face.get());
        area += support::faces::area_of(face.get(), 1e-4);
    }
    EXPECT_EQ(sum, 1);
    require_ok(nurbs_surface_area(surface, nullptr, 1e-6, &whole, nullptr));
    EXPECT_NEAR(area, whole, 1e-4 * whole);
}

struct Totals {
    int64_t compared = 0, parts = 0;
};

void check_surface(const nurbs *surface, const SplineData &data, const Cut &cut, Totals &totals) {
    const Model parts = split(surface, cut);
    const int64_t faces = support::models::counts_of(parts.get()).faces;
    EXPECT_EQ(faces, Graph(cut, Ground(surface, data)).faces());
    check_model(surface, parts.get());
    ++totals.compared;
    totals.parts += faces;
}

TEST(SurfaceSplitsSizes, HaveAsManyPartsAsEulerSays) {
    Random random(0x5e01);
    Totals totals;
    const int64_t cases = scaled(20);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        std::array<SplineData, 3> data;
        std::array<Handle, 3> surfaces;
        for (size_t k = 0; k < 3; ++k) {
            const Pair pair = random_pair(random);
            data[k] = k == 0 ? pair.a : pair.b;
            surfaces[k] = create(data[k]);
        }
        std::vector<Point3> common;
        if (!common_points(surfaces[0].get(), surfaces[1].get(), surfaces[2].get(), common)) {
            continue;
        }
        for (size_t k = 0; k < 3; ++k) {
            SCOPED_TRACE(k);
            Cut cut;
            for (const size_t other : {(k + 1) % 3, (k + 2) % 3}) {
                cut.meets.push_back(crossing_of(surfaces[k].get(), surfaces[other].get(), 1e-8));
            }
            cut.common.push_back(common);
            if (cut.complete()) {
                check_surface(surfaces[k].get(), data[k], cut, totals);
            }
        }
    }
    std::printf("%lld arrangements, %lld parts\n", static_cast<long long>(totals.compared),
                static_cast<long long>(totals.parts));
    EXPECT_GE(totals.compared, 3 * cases * 95 / 100);
    EXPECT_GE(totals.parts, 3 * totals.compared);
}

} // namespace

} // namespace surface_splits_test
