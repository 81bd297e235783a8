// SPDX-License-Identifier: MIT
#include "io/iges/model/loops.h"

#include "io/iges/types.h"

#include <algorithm>
#include <exception>

namespace nrb::io::iges {
namespace {

// The entity that a pointer of a face refers to. Throws Status::syntax if it does not exist or could not be
// read.
template <class Value>
const Value &entity_at(const std::map<int64_t, Value> &all, int64_t pointer, const char *what) {
    const auto found = all.find(pointer);
    if (found == all.end()) {
        fail(Status::syntax, "directory line %lld is no %s that could be read",
             static_cast<long long>(pointer), what);
    }
    return found->second;
}

} // namespace

SplinePtr LoopReader::spline(const model::CurvePiece &piece) {
    geometry_.entities().spend(Limits::size_of_a_shape + size_of(piece));
    return spline_of(piece);
}

void LoopReader::add_edges(int64_t pointer, bool reversed, std::vector<SpaceCurve> &edges) {
    if (pointer == 0) {
        fail(Status::syntax, "a boundary has no curves in space");
    }
    std::vector<model::CurvePiece> pieces = geometry_.curve_pieces(pointer);
    if (reversed) {
        std::reverse(pieces.begin(), pieces.end());
    }
    for (model::CurvePiece &piece : pieces) {
        piece.forward = piece.forward != reversed;
        edges.push_back({spline(piece), piece.curve});
    }
}

// Throws if there are no curves: a boundary that lacks some of its curves in the domain is not complete
// there.
void LoopReader::add_curves(const std::vector<int64_t> &pointers, std::vector<SplinePtr> &curves) {
    if (pointers.empty() || pointers.front() == 0 || !surface_.parametrized) {
        fail(Status::syntax, "a boundary has no curves in the domain");
    }
    for (const int64_t pointer : pointers) {
        for (const model::CurvePiece &piece : geometry_.parameter_pieces(pointer, surface_.map)) {
            curves.push_back(spline(piece));
        }
    }
}

// Adds null for an edge without curves in the domain, which are then made; if no edge has any, they are
// missing.
void LoopReader::add_curves_of(const std::vector<EdgeReference> &references, std::vector<SplinePtr> &curves) {
    const bool any = std::ranges::any_of(
        references, [](const EdgeReference &edge) { return !edge.vertex && !edge.domain_curves.empty(); });
    for (const EdgeReference &reference : references) {
        if (any && !reference.vertex && reference.domain_curves.empty()) {
            curves.push_back(nullptr);
        } else if (!reference.vertex) {
            add_curves(reference.domain_curves, curves);
        }
    }
}

// Combines what edges() and curves() provide; one of the two may throw, or find nothing.
template <class Edges, class Curves>
LoopSource LoopReader::either(Edges &&edges, Curves &&curves) {
    LoopSource result;
    std::exception_ptr damage;
    try {
        edges(result.edges);
    } catch (const Error &) {
        result.edges.clear();
        damage = std::current_exception();
    }
    try {
        curves(result.curves);
    } catch (const Error &) {
        result.curves.clear();
        damage = damage != nullptr ? damage : std::current_exception();
    }
    if (result.edges.empty() && result.curves.empty()) {
        if (damage == nullptr) {
            fail(Status::syntax, "a boundary has no curves");
        }
        std::rethrow_exception(damage);
    }
    return result;
}

LoopSource LoopReader::curve_on_surface(int64_t pointer) {
    const CurveOnSurface &curve =
        entity_at(topology_.curves_on_surfaces, pointer, "curve on a surface (142)");
    LoopSource result = either([&](auto &edges) { add_edges(curve.space_curve, false, edges); },
                               [&](auto &curves) { add_curves({curve.domain_curve}, curves); });
    result.domain_rules = curve.preference == 1;
    return result;
}

LoopSource LoopReader::boundary(int64_t pointer) {
    const Boundary &boundary = entity_at(topology_.boundaries, pointer, "boundary (141)");
    LoopSource result = either(
        [&](auto &edges) {
            for (const BoundaryCurve &curve : boundary.curves) {
                add_edges(curve.curve, curve.reversed, edges);
            }
        },
        [&](auto &curves) {
            for (const BoundaryCurve &curve : boundary.curves) {
                add_curves(curve.domain_curves, curves);
            }
        });
    result.domain_rules = boundary.preference == 2;
    return result;
}

void LoopReader::add_edge(const EdgeReference &reference, const EdgeLists &lists,
                          std::vector<SpaceCurve> &edges) {
    const auto list = lists.find(reference.list);
    const auto count = list == lists.end() ? 0 : std::ssize(list->second);
    if (reference.index < 1 || reference.index > count) {
        fail(Status::syntax, "the edge list (504) at directory line %lld has no edge %lld",
             static_cast<long long>(reference.list), static_cast<long long>(reference.index));
    }
    const ListedEdge &edge = list->second[static_cast<size_t>(reference.index - 1)];
    if (edge.spline == nullptr) {
        fail(Status::unsupported, "edge %lld of the list (504) at directory line %lld could not be read",
             static_cast<long long>(reference.index), static_cast<long long>(reference.list));
    }
    geometry_.entities().spend(3 * edge.spline->point_count());
    edges.push_back({edge.spline, nullptr, edge.index, reference.against});
}

LoopSource LoopReader::loop(int64_t pointer, const EdgeLists &lists) {
    const std::vector<EdgeReference> &references = entity_at(topology_.loops, pointer, "loop (508)");
    for (const EdgeReference &reference : references) {
        if (reference.vertex) {
            const auto &points = entity_at(topology_.vertex_lists, reference.list, "vertex list (502)");
            if (reference.index >= 1 && reference.index <= std::ssize(points)) {
                const auto &x = points[static_cast<size_t>(reference.index - 1)];
                poles_.push_back({x[0], x[1], x[2]});
            }
        }
    }
    const bool only_poles = std::all_of(references.begin(), references.end(),
                                        [](const EdgeReference &edge) { return edge.vertex; });
    if (only_poles) {
        return {};
    }
    return either(
        [&](auto &edges) {
            for (const EdgeReference &reference : references) {
                if (!reference.vertex) {
                    add_edge(reference, lists, edges);
                }
            }
        },
        [&](auto &curves) { add_curves_of(references, curves); });
}

LoopSource LoopReader::closed_curve(int64_t pointer) {
    LoopSource result;
    add_edges(pointer, false, result.edges);
    return result;
}

} // namespace nrb::io::iges
