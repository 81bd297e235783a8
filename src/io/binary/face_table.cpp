// SPDX-License-Identifier: MIT
#include "io/binary/face_table.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/tolerance.h"
#include "face/deviation.h"
#include "io/binary/checked_numbers.h"
#include "refine/forms/parametrization.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {

namespace {

constexpr size_t words_of_face = 4, words_of_loop = 2, words_of_coedge = 5;
constexpr uint64_t with_gaps = 1, was_turned = 1, runs_against = 1, is_proven = 2;

constexpr uint64_t flag(bool set, uint64_t bit) noexcept {
    return set ? bit : 0;
}

const SplinePtr &spline_at(ByteReader &reader, const std::vector<SplinePtr> &splines, const char *what) {
    return splines[static_cast<size_t>(index_from(reader, 0, std::ssize(splines), what))];
}

SplinePtr curve_or_none(ByteReader &reader, const std::vector<SplinePtr> &splines) {
    const int64_t index = index_from(reader, -1, std::ssize(splines), "edge");
    return index < 0 ? nullptr : splines[static_cast<size_t>(index)];
}

int64_t count_from(ByteReader &reader, int64_t least, int64_t left, const char *what) {
    return index_from(reader, least, left + 1, what);
}

int64_t key_from(ByteReader &reader) {
    const int64_t key = reader.take_integer();
    if (key < 0) {
        fail(Status::syntax, "key %lld of an edge, expected one >= 0", static_cast<long long>(key));
    }
    return key;
}

// Proves anew how near a curve that was made is to its edge. The bytes are accepted if the proven distance
// exceeds theirs by no more than the rounding of another machine; else throws Status::syntax.
void check_proof(const face::Face &face, const face::Coedge &made, size_t loop, size_t index) {
    const SplinePtr curve = made.against ? refine::reverse(*made.curve, 0, false) : made.curve;
    const double found = face::proven_distance(face.surface(), face.covering(), curve, *made.edge);
    double magnitude = 0;
    for (const double x : made.edge->points()) {
        magnitude = std::max(magnitude, std::abs(x));
    }
    if (!(found <= made.deviation->distance + 64 * eps * magnitude)) {
        fail(Status::syntax,
             "edge %zu of loop %zu is within %s of the surface by the bytes, but only %s is proven", index,
             loop, Number(made.deviation->distance).text, Number(found).text);
    }
}

// `loops`: those from which the face was made, before it turned any.
void check_proofs(const face::Face &face, const std::vector<face::Loop> &loops) {
    for (size_t i = 0; i < loops.size(); ++i) {
        for (size_t j = 0; j < loops[i].size(); ++j) {
            if (loops[i][j].deviation) {
                check_proof(face, loops[i][j], i, j);
            }
        }
    }
}

void check_turned(const face::Face &face, const std::vector<bool> &turned) {
    const std::vector<bool> &found = face.trims().turned();
    for (size_t i = 0; i < turned.size(); ++i) {
        if (found[i] != turned[i]) {
            fail(Status::orientation, "loop %zu is %s by the bytes, but its face has it otherwise", i,
                 turned[i] ? "turned" : "not turned");
        }
    }
}

} // namespace

void FaceTable::add(const face::Face &face, SplineTable &splines) {
    faces_.push_back({&face, splines.add(face.surface())});
    loops_ += std::ssize(face.loops());
    for (const face::Loop &loop : face.loops()) {
        for (const face::Coedge &coedge : loop) {
            const int64_t curve = splines.add(coedge.curve);
            coedges_.push_back({&coedge, curve, coedge.edge == nullptr ? -1 : splines.add(coedge.edge)});
        }
    }
}

size_t FaceTable::size_in_bytes() const noexcept {
    return aligned(8 * words_of_face * faces_.size()) +
           aligned(8 * words_of_loop * static_cast<size_t>(loops_)) +
           aligned(8 * words_of_coedge * coedges_.size());
}

void FaceTable::write(ByteWriter &writer) const noexcept {
    for (const FaceEntry &entry : faces_) {
        writer.put(entry.surface);
        writer.put(std::ssize(entry.face->loops()));
        writer.put(flag(entry.face->has_gaps(), with_gaps));
        writer.put(entry.face->tolerance() + 0.0); // -0 is the same tolerance
    }
    writer.align();
    write_loops(writer);
    for (const CoedgeEntry &entry : coedges_) {
        const face::Coedge &coedge = *entry.coedge;
        writer.put(entry.curve);
        writer.put(entry.edge);
        writer.put(coedge.key);
        writer.put(flag(coedge.against, runs_against) | flag(coedge.deviation.has_value(), is_proven));
        writer.put(coedge.deviation ? coedge.deviation->distance : 0.0);
    }
    writer.align();
}

void FaceTable::write_loops(ByteWriter &writer) const noexcept {
    for (const FaceEntry &entry : faces_) {
        const std::vector<face::Loop> &loops = entry.face->loops();
        for (size_t i = 0; i < loops.size(); ++i) {
            writer.put(std::ssize(loops[i]));
            writer.put(flag(entry.face->trims().turned()[i], was_turned));
        }
    }
    writer.align();
}

FaceReader::FaceReader(ByteReader &reader, const FaceSizes &sizes)
    : faces_(reader.part(sizes.faces, words_of_face)), loops_(reader.part(sizes.loops, words_of_loop)),
      coedges_(reader.part(sizes.coedges, words_of_coedge)), left_(sizes) {}

face::FacePtr FaceReader::next(const std::vector<SplinePtr> &splines) {
    face::FaceParts parts;
    parts.surface = spline_at(faces_, splines, "surface");
    check_kind(*parts.surface, 2, "the surface of a face");
    const int64_t count = count_from(faces_, 0, left_.loops, "number of loops");
    left_.loops -= count;
    parts.keep_gaps = flags_from(faces_, with_gaps, "flags of a face") != 0;
    parts.tolerance = faces_.take_double();
    check_tolerance(parts.tolerance);
    std::vector<bool> turned;
    for (int64_t i = 0; i < count; ++i) {
        const int64_t size = count_from(loops_, 1, left_.coedges, "number of curves of a loop");
        left_.coedges -= size;
        turned.push_back(flags_from(loops_, was_turned, "flags of a loop") != 0);
        face::Loop loop;
        for (int64_t j = 0; j < size; ++j) {
            loop.push_back(next_coedge(splines, parts.surface->dim()));
        }
        parts.loops.push_back(turned.back() ? face::turned(loop) : std::move(loop));
    }
    parts.as_oriented = std::find(turned.begin(), turned.end(), true) == turned.end();
    const std::vector<face::Loop> loops = parts.loops;
    auto face = std::make_shared<const face::Face>(std::move(parts), nullptr);
    check_turned(*face, turned);
    check_proofs(*face, loops);
    return face;
}

face::Coedge FaceReader::next_coedge(const std::vector<SplinePtr> &splines, int dim) {
    face::Coedge coedge;
    coedge.curve = spline_at(coedges_, splines, "curve");
    check_kind(*coedge.curve, 1, "a curve of a loop");
    check_dimension(*coedge.curve, 2, 2, "a curve of a loop");
    coedge.edge = curve_or_none(coedges_, splines);
    if (coedge.edge != nullptr) {
        check_kind(*coedge.edge, 1, "an edge");
        check_dimension(*coedge.edge, dim, dim, "an edge");
    }
    coedge.key = key_from(coedges_);
    const uint64_t flags = flags_from(coedges_, runs_against | is_proven, "flags of a curve");
    coedge.against = (flags & runs_against) != 0;
    const double distance = finite_from(coedges_, "distance");
    if ((flags & is_proven) == 0 ? distance != 0 : distance < 0 || coedge.edge == nullptr) {
        fail(Status::syntax, "distance = %s of a curve and an edge, which no face has",
             Number(distance).text);
    }
    if ((flags & is_proven) != 0) {
        coedge.deviation = face::Deviation{distance, true};
    }
    return coedge;
}

void FaceReader::end() const {
    if (left_.loops > 0 || left_.coedges > 0) {
        fail(Status::syntax, "%lld loops and %lld curves belong to no face",
             static_cast<long long>(left_.loops), static_cast<long long>(left_.coedges));
    }
}

} // namespace nrb::io
