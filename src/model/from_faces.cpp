// SPDX-License-Identifier: MIT
#include "model/from_faces.h"

#include "eval/curve_point.h"
#include "face/deviation.h"

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
                const int64_t edge = edge_of(*face, coedges[static_cast<size_t>(i)]);
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
    int64_t edge_of(const face::Face &face, const face::Coedge &coedge) {
        const auto next = std::ssize(model_.edges);
        if (coedge.key != 0) {
            const auto [known, fresh] = edges_.try_emplace(coedge.key, next);
            if (!fresh) {
                return known->second;
            }
        }
        Edge edge;
        edge.curve = face::edge_of(face, coedge);
        edge.vertices = {vertex_at(end_of(*edge.curve, false)), vertex_at(end_of(*edge.curve, true))};
        model_.edges.push_back(std::move(edge));
        return next;
    }
    int64_t vertex_at(const Place &x) {
        const auto [known, fresh] = vertices_.try_emplace(x, std::ssize(model_.vertices));
        if (fresh) {
            model_.vertices.push_back({x[0], x[1], x[2]});
        }
        return known->second;
    }

    Model model_;
    std::map<int64_t, int64_t> edges_; // by their keys
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
