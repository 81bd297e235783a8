// SPDX-License-Identifier: MIT
// Trimmed faces: construction, loops and edges, classification of places, area and moments, boxes.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "watched.h"

#include "base/checked.h"
#include "base/error.h"
#include "base/tolerance.h"
#include "face/deviation.h"
#include "face/face_box.h"
#include "face/integrals/face_moments.h"
#include "spline/kind.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

// The caller's arrays that describe the curves of all loops, loop by loop.
struct LoopArrays {
    const Spline &surface;
    const nurbs *const *curves;
    const nurbs *const *edges;
    const int64_t *keys;

    [[nodiscard]] SplinePtr curve(int64_t i, const nurbs *const *all, const char *name, int dim) const {
        if (all == nullptr || all[i] == nullptr) {
            return nullptr;
        }
        check_kind(*all[i]->spline, 1, name, i);
        check_dimension(*all[i]->spline, dim, dim, name, i);
        return all[i]->spline;
    }
    [[nodiscard]] face::Coedge coedge(int64_t i) const {
        face::Coedge coedge{curve(i, curves, "curves", 2), curve(i, edges, "edges", surface.dim())};
        if (coedge.curve == nullptr && coedge.edge == nullptr) {
            fail(Status::null, "curves[%lld] and edges[%lld] are both NULL", static_cast<long long>(i),
                 static_cast<long long>(i));
        }
        const int64_t key = keys == nullptr ? 0 : keys[i];
        if (key == INT64_MIN) {
            fail(Status::overflow, "keys[%lld] = %lld has no opposite number", static_cast<long long>(i),
                 static_cast<long long>(key));
        }
        coedge.key = key < 0 ? 0 - key : key;
        coedge.against = key < 0;
        return coedge;
    }
};

// The number of curves of all loops.
int64_t curves_of(int64_t loops, const int64_t *sizes) {
    int64_t total = 0;
    for (int64_t i = 0; i < loops; ++i) {
        if (sizes[i] < 1) {
            fail(Status::count, "sizes[%lld] = %lld, expected at least 1", static_cast<long long>(i),
                 static_cast<long long>(sizes[i]));
        }
        total = checked_sum(total, sizes[i], "sizes");
    }
    return checked_array(total, "curves");
}

// Precondition: curves_of() accepts the sizes.
std::vector<face::Loop> loops_of(int64_t loops, const int64_t *sizes, const LoopArrays &arrays) {
    std::vector<face::Loop> result;
    int64_t next = 0;
    for (int64_t i = 0; i < loops; ++i) {
        face::Loop loop;
        for (const int64_t end = next + sizes[i]; next < end; ++next) {
            loop.push_back(arrays.coedge(next));
        }
        result.push_back(std::move(loop));
    }
    return result;
}

const face::Coedge &coedge_of(const nurbs_face *face, int64_t loop, int64_t index) {
    const std::vector<face::Loop> &loops = face_of(face).loops();
    if (loop < 0 || loop >= std::ssize(loops)) {
        fail(Status::index, "loop = %lld, expected one of the %zu loops", static_cast<long long>(loop),
             loops.size());
    }
    const face::Loop &own = loops[static_cast<size_t>(loop)];
    if (index < 0 || index >= std::ssize(own)) {
        fail(Status::index, "index = %lld, expected one of the %zu curves of loop %lld",
             static_cast<long long>(index), own.size(), static_cast<long long>(loop));
    }
    return own[static_cast<size_t>(index)];
}

void check_finite_params(const ConstRecords &params) {
    for (int64_t i = 0; i < params.count; ++i) {
        for (int k = 0; k < 2; ++k) {
            if (!std::isfinite(params(i, k))) {
                fail(Status::parameter_not_finite, "params[%lld] = %s on axis %d is not finite",
                     static_cast<long long>(i), Number(params(i, k)).text, k);
            }
        }
    }
}

struct FaceMoments {
    double *content, *centroid, *inertia, *error;
};

void give_moments(const nurbs_face *handle, double tolerance, const char *name, const FaceMoments &out) {
    const face::Face &own = face_of(handle);
    const int64_t dim = own.surface()->dim();
    require(out.content, name);
    check_tolerance(tolerance, "relative_tolerance");
    check_apart({memory(name, out.content, 1), memory("centroid", out.centroid, dim),
                 memory("inertia", out.inertia, dim * dim), memory("error", out.error, 1)},
                {});
    const measure::MomentOrder order = out.inertia != nullptr    ? measure::MomentOrder::inertia
                                       : out.centroid != nullptr ? measure::MomentOrder::centroid
                                                                 : measure::MomentOrder::content;
    const measure::Moments found = face::moments(own, order, tolerance);
    put(out.content, found.content);
    put_all(out.centroid, found.centroid);
    put_all(out.inertia, found.inertia);
    put(out.error, found.error);
}

} // namespace

nurbs_status nurbs_face_create(const nurbs *surface, int64_t loops, const int64_t *sizes,
                               const nurbs *const *curves, const nurbs *const *edges, const int64_t *keys,
                               double tolerance, uint32_t flags, double *gaps, nurbs_face **out) {
    std::vector<double> found;
    const nurbs_status status = guard([&] {
        require_out(out);
        require(surface, "surface");
        check_length(loops, "loops");
        if (loops > 0) {
            require(sizes, "sizes");
        }
        check_kind(*surface->spline, 2, "surface");
        check_tolerance(tolerance);
        if ((flags & ~(NURBS_AS_ORIENTED | NURBS_CHECK_CROSSINGS | NURBS_KEEP_GAPS)) != 0) {
            fail(Status::flags,
                 "flags = 0x%x, expected NURBS_AS_ORIENTED, NURBS_CHECK_CROSSINGS or NURBS_KEEP_GAPS", flags);
        }
        checked_array(loops, "sizes");
        check_apart({memory("gaps", gaps, loops)}, {memory("sizes", sizes, loops)});
        const int64_t total = curves_of(loops, sizes);
        check_apart(
            {memory("gaps", gaps, loops)},
            {memory("curves", curves, total), memory("edges", edges, total), memory("keys", keys, total)});
        face::FaceParts parts{surface->spline,
                              loops_of(loops, sizes, {*surface->spline, curves, edges, keys}), tolerance,
                              (flags & NURBS_AS_ORIENTED) != 0, (flags & NURBS_KEEP_GAPS) != 0};
        parts.check_crossings = (flags & NURBS_CHECK_CROSSINGS) != 0;
        *out = new nurbs_face{std::make_shared<const face::Face>(std::move(parts), &found)};
    });
    if (status == NURBS_OK || status == NURBS_ERROR_GAP) {
        put_all(found.size() == static_cast<size_t>(loops) ? gaps : nullptr, found);
    }
    return status;
}

nurbs_status nurbs_face_create_with(const nurbs *surface, int64_t loops, const int64_t *sizes,
                                    const nurbs *const *curves, const nurbs *const *edges,
                                    const int64_t *keys, double tolerance, uint32_t flags, double *gaps,
                                    const nurbs_call_options *call, nurbs_face **out) {
    return watched(call, out, [&] {
        return nurbs_face_create(surface, loops, sizes, curves, edges, keys, tolerance, flags, gaps, out);
    });
}

nurbs_status nurbs_face_clone(const nurbs_face *face, nurbs_face **out) {
    return guard([&] {
        require_out(out);
        require(face, "face");
        *out = new nurbs_face{face->face};
    });
}

void nurbs_face_destroy(nurbs_face *face) {
    delete face;
}

nurbs_status nurbs_face_surface(const nurbs_face *face, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(face_of(face).surface(), out);
    });
}

nurbs_status nurbs_face_loops(const nurbs_face *face, int64_t cap, int64_t *sizes, int64_t *count) {
    return guard([&] {
        const std::vector<face::Loop> &loops = face_of(face).loops();
        if (cap > 0) {
            require(sizes, "sizes");
        }
        check_length(cap, "cap");
        const int64_t used = checked_cap(cap, std::ssize(loops));
        check_apart({memory("sizes", sizes, used), memory("count", count, 1)}, {});
        for (size_t i = 0; i < static_cast<size_t>(used); ++i) {
            sizes[i] = std::ssize(loops[i]);
        }
        put(count, static_cast<int64_t>(std::ssize(loops)));
    });
}

nurbs_status nurbs_face_curve(const nurbs_face *face, int64_t loop, int64_t index, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(coedge_of(face, loop, index).curve, out);
    });
}

nurbs_status nurbs_face_edge(const nurbs_face *face, int64_t loop, int64_t index, int64_t *key, nurbs **out) {
    return guard([&] {
        require_out(out);
        const face::Coedge &coedge = coedge_of(face, loop, index);
        give(face::edge_of(face_of(face), coedge), out);
        put(key, coedge.against ? -coedge.key : coedge.key);
    });
}

nurbs_status nurbs_face_deviation(const nurbs_face *face, int64_t loop, int64_t index, double *distance,
                                  int32_t *proven) {
    return guard([&] {
        require(face, "face");
        require(distance, "distance");
        const face::Coedge &coedge = coedge_of(face, loop, index);
        check_apart({memory("distance", distance, 1), memory("proven", proven, 1)}, {});
        const face::Deviation found = face::deviation_of(face_of(face), coedge);
        *distance = found.distance;
        put(proven, found.proven ? 1 : 0);
    });
}

nurbs_status nurbs_face_tolerance(const nurbs_face *face, double *tolerance) {
    return guard([&] {
        const face::Face &own = face_of(face);
        require(tolerance, "tolerance");
        *tolerance = own.tolerance();
    });
}

nurbs_status nurbs_face_classify(const nurbs_face *face, int64_t n, const double *params,
                                 int64_t param_stride, int64_t param_component_stride, double tolerance,
                                 int32_t *sides) {
    return guard([&] {
        const face::Face &own = face_of(face);
        check_length(n, "n");
        const ConstRecords places = input("params", params, n, 2, param_stride, param_component_stride);
        if (n > 0) {
            require(sides, "sides");
        }
        check_tolerance(tolerance);
        check_apart({memory("sides", sides, n)}, {memory("params", places.data, places.extent())});
        check_finite_params(places);
        StagedStatus staged(sides, n);
        face::classify(own, places, tolerance, staged.data());
        staged.commit();
    });
}

nurbs_status nurbs_face_classify_with(const nurbs_face *face, int64_t n, const double *params,
                                      int64_t param_stride, int64_t param_component_stride, double tolerance,
                                      int32_t *sides, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_face_classify(face, n, params, param_stride, param_component_stride, tolerance, sides);
    });
}

nurbs_status nurbs_face_area(const nurbs_face *face, double relative_tolerance, double *area, double *error) {
    return guard([&] { give_moments(face, relative_tolerance, "area", {area, nullptr, nullptr, error}); });
}

nurbs_status nurbs_face_area_with(const nurbs_face *face, double relative_tolerance, double *area,
                                  double *error, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_face_area(face, relative_tolerance, area, error); });
}

nurbs_status nurbs_face_moments(const nurbs_face *face, double relative_tolerance, double *content,
                                double *centroid, double *inertia, double *error) {
    return guard([&] {
        give_moments(face, relative_tolerance, "content", {content, centroid, inertia, error});
    });
}

nurbs_status nurbs_face_moments_with(const nurbs_face *face, double relative_tolerance, double *content,
                                     double *centroid, double *inertia, double *error,
                                     const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_face_moments(face, relative_tolerance, content, centroid, inertia, error);
    });
}

nurbs_status nurbs_face_box(const nurbs_face *face, double tolerance, double *lower, double *upper,
                            double *gap) {
    return guard([&] {
        const face::Face &own = face_of(face);
        const int64_t dim = own.surface()->dim();
        require(lower, "lower");
        require(upper, "upper");
        check_tolerance(tolerance);
        check_apart({memory("lower", lower, dim), memory("upper", upper, dim), memory("gap", gap, 1)}, {});
        const bounds::Box found = face::bounding_box(own, tolerance);
        put_all(lower, found.lower);
        put_all(upper, found.upper);
        put(gap, found.gap);
    });
}

nurbs_status nurbs_face_box_with(const nurbs_face *face, double tolerance, double *lower, double *upper,
                                 double *gap, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_face_box(face, tolerance, lower, upper, gap); });
}
