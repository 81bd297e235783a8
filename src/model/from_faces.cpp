// SPDX-License-Identifier: MIT
#include "model/from_faces.h"

#include "base/finite.h"
#include "eval/curve_point.h"
#include "face/deviation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace nrb::model {

namespace {

using Place = std::array<double, 3>;

Place end_of(const Spline &curve, bool upper) {
    Place x;
    eval::end_point(curve, upper, x.data());
    return x;
}

// Adds faces to a model one after another, and shares their edges by keys.
class Builder {
public:
    explicit Builder(double metres_per_unit) {
        model_.metres_per_unit = metres_per_unit;
        model_.parts.emplace_back();
        model_.uses.emplace_back();
    }
    void add(const face::FacePtr &face) {
        const int64_t number = std::ssize(model_.faces);
        for (int64_t loop = 0; loop < std::ssize(face->loops()); ++loop) {
            const face::Loop &coedges = face->loops()[static_cast<size_t>(loop)];
            for (int64_t i = 0; i < std::ssize(coedges); ++i) {
                const int64_t edge = edge_of(*face, coedges[static_cast<size_t>(i)], {number, loop, i});
                model_.edges[static_cast<size_t>(edge)].uses.push_back({number, loop, i});
            }
        }
        ModelFace made;
        made.name = std::to_string(number);
        made.face = face;
        model_.faces.push_back(std::move(made));
    }
    Model take() { return std::move(model_); }

private:
    // An edge with the tolerance of the face from which it came.
    struct Known {
        int64_t number;
        double tolerance;
    };

    int64_t edge_of(const face::Face &face, const face::Coedge &coedge, const EdgeUse &use) {
        SplinePtr curve = face::edge_of(face, coedge);
        if (coedge.key == 0) {
            return new_edge(std::move(curve));
        }
        std::vector<Known> &known = edges_[coedge.key];
        double least = HUGE_VAL;
        int64_t nearest = -1;
        // Faces of one model follow each other, so that the latest edge is the likeliest.
        for (auto edge = known.rbegin(); edge != known.rend(); ++edge) {
            const double apart = distance_from(*edge, curve, face.tolerance());
            if (apart == 0) {
                return edge->number;
            }
            nearest = apart < least ? edge->number : nearest;
            least = std::min(least, apart);
        }
        if (nearest >= 0) {
            tell(coedge.key, use, model_.edges[static_cast<size_t>(nearest)].uses.front(), least);
        }
        known.push_back({new_edge(std::move(curve)), face.tolerance()});
        return known.back().number;
    }

    // 0 unless the two curves are found to be farther apart than the tolerances of both faces and the
    // rounding of points together.
    [[nodiscard]] double distance_from(const Known &known, const SplinePtr &curve, double tolerance) const {
        constexpr double rounding = 0x1p-44; // relative to the largest coordinate, for any degree
        const SplinePtr &other = model_.edges[static_cast<size_t>(known.number)].curve;
        if (other == curve) {
            return 0;
        }
        const double largest =
            std::max(largest_magnitude(other->points()), largest_magnitude(curve->points()));
        const double within = known.tolerance + tolerance + rounding * largest;
        return within > 0 ? face::distance_beyond(other, curve, within) : 0;
    }

    // Faces from several models may have equal keys by chance.
    void tell(int64_t key, const EdgeUse &use, const EdgeUse &nearest, double apart) {
        model_.notes.push_back({0, 0, Status::gap,
                                "the edge of " + words(use) + " has the key " + std::to_string(key) + " of " +
                                    words(nearest) + " but is " + Number(apart).text +
                                    " from that edge: each has its own"});
    }

    static std::string words(const EdgeUse &use) {
        return "curve " + std::to_string(use.index) + " of loop " + std::to_string(use.loop) + " of face " +
               std::to_string(use.face);
    }

    int64_t new_edge(SplinePtr curve) {
        Edge edge;
        edge.curve = std::move(curve);
        edge.vertices = {vertex_at(end_of(*edge.curve, false)), vertex_at(end_of(*edge.curve, true))};
        model_.edges.push_back(std::move(edge));
        return std::ssize(model_.edges) - 1;
    }
    int64_t vertex_at(const Place &x) {
        const auto [known, fresh] = vertices_.try_emplace(x, std::ssize(model_.vertices));
        if (fresh) {
            model_.vertices.push_back({x[0], x[1], x[2]});
        }
        return known->second;
    }

    Model model_;
    std::map<int64_t, std::vector<Known>> edges_; // by key
    std::map<Place, int64_t> vertices_;
};

} // namespace

Model model_of_faces(const std::vector<face::FacePtr> &faces, double metres_per_unit) {
    Builder builder(metres_per_unit);
    for (const face::FacePtr &face : faces) {
        builder.add(face);
    }
    return builder.take();
}

void index_uses(Model &model) {
    for (int64_t f = 0; f < std::ssize(model.faces); ++f) {
        const std::vector<face::Loop> &loops = model.faces[static_cast<size_t>(f)].face->loops();
        for (int64_t loop = 0; loop < std::ssize(loops); ++loop) {
            const face::Loop &coedges = loops[static_cast<size_t>(loop)];
            for (int64_t i = 0; i < std::ssize(coedges); ++i) {
                if (const int64_t key = coedges[static_cast<size_t>(i)].key; key > 0) {
                    model.edges[static_cast<size_t>(key - 1)].uses.push_back({f, loop, i});
                }
            }
        }
    }
}

} // namespace nrb::model
