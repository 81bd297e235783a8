// SPDX-License-Identifier: MIT
#include "model/sewing/sew.h"

#include "base/watch.h"
#include "eval/curve_point.h"
#include "model/from_faces.h"
#include "model/sections/shared_borders.h"
#include "model/sewing/side_pieces.h"
#include "model/sewing/twice.h"

#include <algorithm>
#include <map>

namespace nrb::model {

namespace {

using SideCuts = std::vector<std::vector<SideCut>>;

template <class Make>
auto named(size_t face, Make &&make) {
    try {
        return make();
    } catch (const Error &error) {
        fail(error.status(), "faces[%zu]: %s", face, error.what());
    }
}

std::vector<Patch> patches_of(const std::vector<face::FacePtr> &faces, double tolerance) {
    std::vector<Patch> patches;
    for (size_t i = 0; i < faces.size(); ++i) {
        patches.push_back(named(i, [&] { return patch_of(faces[i], tolerance); }));
    }
    return patches;
}

// All sides, in the order of patches, loops and curves.
std::vector<Side> sides_of(const std::vector<Patch> &patches, double tolerance) {
    std::vector<Side> sides;
    for (size_t i = 0; i < patches.size(); ++i) {
        named(i, [&] { append_sides(patches[i], static_cast<int64_t>(i), tolerance, sides); });
    }
    return sides;
}

size_t size_of(const SideCuts &all) {
    size_t sum = 0;
    for (const auto &own : all) {
        sum += own.size();
    }
    return sum;
}

// Without the cuts that are not needed, unless longer pieces cannot be proven to match as the shorter ones
// were: then the sides keep their cuts.
SidePieces pieces_of(const std::vector<Side> &sides, double tolerance) {
    Corners corners(sides, tolerance);
    const SideCuts cuts = cuts_of(sides, corners, tolerance);
    SidePieces pieces(sides, cuts, corners, tolerance);
    SideCuts kept = pieces.needed(cuts);
    while (size_of(kept) < size_of(cuts)) {
        const size_t before = size_of(kept);
        SidePieces longer(sides, kept, corners, tolerance);
        const std::vector<bool> fewer = longer.fewer_than(pieces, sides.size());
        for (size_t i = 0; i < sides.size(); ++i) {
            kept[i] = fewer[i] ? cuts[i] : kept[i];
        }
        if (size_of(kept) == before) {
            return longer;
        }
    }
    return pieces;
}

// Whether a surface closes up in the same way under both coverings.
bool closes_alike(const face::Covering &a, const face::Covering &b) noexcept {
    return std::ranges::all_of(std::array{0, 1}, [&](int k) {
        return a.closed(k) == b.closed(k) && a.collapsed(k, 0) == b.collapsed(k, 0) &&
               a.collapsed(k, 1) == b.collapsed(k, 1);
    });
}

// Makes the edges, vertices and faces of the model from the matched pieces of sides.
class Sewer {
public:
    Sewer(const std::vector<face::FacePtr> &faces, double tolerance, double metres_per_unit)
        : tolerance_(tolerance), patches_(patches_of(faces, tolerance)),
          sides_(sides_of(patches_, tolerance)), pieces_(pieces_of(sides_, tolerance)) {
        model_.metres_per_unit = metres_per_unit;
        model_.parts.emplace_back();
        model_.uses.emplace_back();
    }

    Model sew() {
        keep_pieces();
        for (size_t i = 0; i < patches_.size(); ++i) {
            add_face(i);
        }
        index_uses(model_);
        const SharedBorders borders(model_);
        for (size_t i = 0; i < patches_.size(); ++i) {
            model_.faces[i].against = borders.is_turned(static_cast<int64_t>(i));
        }
        return std::move(model_);
    }

private:
    // Drops collapsed pieces, no larger than the tolerance, unless a loop consists of nothing else.
    void keep_pieces() {
        const std::vector<SidePiece> &all = pieces_.all();
        kept_.assign(all.size(), true);
        for (size_t first = 0, last = 0; first < all.size(); first = last) {
            bool any = false;
            for (last = first; last < all.size() && in_one_loop(all[first], all[last]); ++last) {
                any = any || !all[last].collapsed;
            }
            for (size_t i = first; any && i < last; ++i) {
                kept_[i] = !all[i].collapsed;
            }
        }
    }
    [[nodiscard]] bool in_one_loop(const SidePiece &a, const SidePiece &b) const noexcept {
        const Side &one = sides_[a.side], &other = sides_[b.side];
        return one.patch == other.patch && one.loop == other.loop;
    }

    void add_face(size_t number) {
        const Patch &patch = patches_[number];
        const double least = tolerance_ / 1024; // enough for curves to be made within it
        face::FaceParts parts{patch.given->surface(), {}, std::max(patch.given->tolerance(), least), true};
        parts.keep_gaps = patch.given->has_gaps();
        parts.loops.resize(patch.loops.size());
        const bool left_out = add_loops(number, parts);
        set_tolerance(patch, left_out, parts);
        ModelFace made;
        made.name = std::to_string(number);
        made.face = named(number, [&] { return std::make_shared<const face::Face>(parts, nullptr); });
        model_.faces.push_back(std::move(made));
    }

    // Pieces are in the order of faces. Returns whether one was left out.
    bool add_loops(size_t number, face::FaceParts &parts) {
        bool left_out = false;
        const std::vector<SidePiece> &all = pieces_.all();
        for (; next_ < all.size() && sides_[all[next_].side].patch == static_cast<int64_t>(number); ++next_) {
            const SidePiece &piece = all[next_];
            left_out = left_out || !kept_[next_];
            if (kept_[next_]) {
                parts.loops[static_cast<size_t>(sides_[piece.side].loop)].push_back(coedge_of(piece));
                parts.tolerance = std::max(parts.tolerance, piece.gap);
            }
        }
        return left_out;
    }

    // Makes the tolerance so large that the surface closes up as the loops assume, and that the loops close
    // across the pieces left out.
    void set_tolerance(const Patch &patch, bool left_out, face::FaceParts &parts) const {
        const face::Covering wanted(*parts.surface, patch.tolerance);
        const auto closes = [&](double tolerance) {
            return closes_alike(face::Covering(*parts.surface, tolerance), wanted);
        };
        if (!closes(parts.tolerance)) {
            parts.tolerance = std::max(parts.tolerance, patch.natural ? tolerance_ : patch.tolerance);
        }
        const double wide = std::max(parts.tolerance, tolerance_);
        if (left_out && closes(wide)) {
            parts.tolerance = wide;
        } else if (left_out) { // a thin surface, which would close up differently
            parts.keep_gaps = true;
        }
    }

    face::Coedge coedge_of(const SidePiece &piece) {
        const Side &side = sides_[piece.side];
        const int64_t edge = edge_of(piece.leader);
        face::Coedge coedge;
        coedge.curve = piece.whole ? side.curve : curve_part(side, piece.range);
        coedge.edge = model_.edges[static_cast<size_t>(edge)].curve;
        coedge.key = edge + 1;
        coedge.against = piece.against;
        return coedge;
    }

    int64_t edge_of(size_t leader) {
        const auto [found, is_new] = edges_.try_emplace(leader, std::ssize(model_.edges));
        if (is_new) {
            const SidePiece &piece = pieces_.all()[leader];
            Edge edge;
            edge.curve = piece.image;
            edge.vertices = {vertex_of(piece, false), vertex_of(piece, true)};
            model_.edges.push_back(std::move(edge));
        }
        return found->second;
    }

    int64_t vertex_of(const SidePiece &piece, bool upper) {
        const auto [found, is_new] =
            vertices_.try_emplace(piece.vertices[upper ? 1 : 0], std::ssize(model_.vertices));
        if (is_new) {
            const std::vector<double> x = eval::end_point(*piece.image, upper);
            model_.vertices.push_back({x[0], x[1], x[2]});
        }
        return found->second;
    }

    double tolerance_;
    std::vector<Patch> patches_;
    std::vector<Side> sides_;
    SidePieces pieces_;
    std::vector<bool> kept_;
    size_t next_ = 0; // the next piece to be added
    std::map<size_t, int64_t> edges_, vertices_;
    Model model_;
};

} // namespace

Model sew(const std::vector<face::FacePtr> &faces, double tolerance, double metres_per_unit) {
    refuse_twice(faces);
    return Sewer(faces, tolerance, metres_per_unit).sew();
}

} // namespace nrb::model
