// SPDX-License-Identifier: MIT
#include "closest/patch/critical/critical_search.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "closest/patch/critical/critical_kind.h"

#include <algorithm>

namespace nrb::closest {

namespace {

constexpr int deepest = 26;             // halvings per axis
constexpr int64_t work_of_a_value = 12; // per value of a product: squares, derivatives, bounds
constexpr int shallow = 8;              // halvings per axis before a singular matrix counts

} // namespace

CriticalSearch::CriticalSearch(const PieceGrid &pieces, const Query &query, bool minima)
    : query_(pieces, query), minima_(minima), points_(query_), poles_(query_, minima, points_, gaps_),
      votes_(pieces.shape().dim, query_.near()), budget_(query.most_pieces()) {
    const int64_t count = pieces.shape().coefficients();
    cost_ = std::max<int64_t>(1, count * count / 65536);
}

void CriticalSearch::search(const PatchFace &face, const std::vector<int64_t> &pieces) {
    const pieces::PatchSquares squares(face.shape);
    Steps steps(std::ssize(pieces));
    for (const int64_t piece : pieces) {
        const PatchMemory::Hold hold(query_.memory());
        search_piece(face, squares, piece);
        steps.next();
    }
}

void CriticalSearch::search_piece(const PatchFace &face, const pieces::PatchSquares &squares, int64_t piece) {
    const PatchItem whole = query_.piece_in_range(piece);
    const Target target{face, squares, whole};
    if (face.shape.axes == 0) {
        examine_corner(target);
        return;
    }
    FacePart part{query_.memory().take(face.shape.values()), {}, {1, 1, 1}, 0};
    copy_face(query_.shape(), face, whole.values, part.values);
    examine(target, part);
}

void CriticalSearch::examine_corner(const Target &target) {
    const AxisValues at = target.face.in_piece({});
    const bool wanted = minima_ || kind_at(query_, target.face, target.whole, at) != critical_saddle;
    if (wanted && !poles_.any_at(query_.point(target.whole, at), target.whole.piece)) {
        add(target, at, true);
    }
}

void CriticalSearch::examine(const Target &target, FacePart &part) {
    if (spent_ + cost_ > budget_ || work_ended()) {
        gaps_.incomplete = true;
        return;
    }
    spent_ += cost_;
    count_work(work_of_a_value * target.face.shape.products() * target.face.shape.lanes);
    int axis = 0;
    if (!finished(target, part, axis)) {
        split(target, part, axis);
    }
}

void CriticalSearch::split(const Target &target, FacePart &part, int axis) {
    const PatchMemory::Hold hold(query_.memory());
    const PatchShape &shape = target.face.shape;
    const auto at = static_cast<size_t>(axis);
    BernsteinShape net{{}, shape.lanes};
    std::copy_n(shape.degrees.begin(), shape.axes, net.degrees.begin());
    FacePart lower = part;
    lower.values = query_.memory().take(shape.values());
    halve(net, axis, part.values, lower.values);
    for (FacePart *half : {&lower, &part}) {
        half->length[at] /= 2;
        ++half->depth;
    }
    part.lower[at] += part.length[at];
    examine(target, lower);
    examine(target, part);
}

// Whether halving a part gives no more information; otherwise `axis` is the one to halve it along.
bool CriticalSearch::finished(const Target &target, const FacePart &part, int &axis) {
    const PatchMemory::Hold hold(query_.memory());
    const PatchShape &shape = target.face.shape;
    axis = part.longest_axis(target.face); // unless the second derivatives suggest a better one
    const bool too_deep = part.depth > deepest * shape.axes;
    const double moved =
        target.whole.moved + (part.depth + 1) * shape.degree(axis) * eps * target.whole.reach;
    PatchSlopes slopes(shape, target.squares, part.values, moved, query_.memory());
    if (!slopes.sound()) {
        gaps_.incomplete = gaps_.incomplete || too_deep;
        return too_deep;
    }
    const bool flat = slopes.spread() <= 8 * query_.noise(); // a single point, or many points at one distance
    if (excluded(slopes, flat, target.whole.piece)) {
        return true;
    }
    if (flat || too_deep) {
        gaps_.incomplete = gaps_.incomplete || !flat;
        add_all(target, part, slopes);
        return true;
    }
    const PatchSlopes::Matrix matrix = slopes.matrix();
    axis = slopes.widest_axis();
    const bool singular = matrix == PatchSlopes::Matrix::singular && part.depth >= shallow * shape.axes;
    if ((singular || matrix == PatchSlopes::Matrix::regular) && find(target, part, singular)) {
        gaps_.connected = gaps_.connected || singular;
        return true;
    }
    return false;
}

// Whether a part has no critical point, or none apart from a pole.
bool CriticalSearch::excluded(PatchSlopes &slopes, bool flat, int64_t piece) {
    return slopes.least() > limit_ || slopes.monotone() || (flat && slopes.slanted()) ||
           poles_.absorbs(slopes, flat, piece);
}

// A part whose distances agree to rounding, or that is too small to be halved, is represented by its middle.
void CriticalSearch::add_all(const Target &target, const FacePart &part, const PatchSlopes &slopes) {
    const AxisValues at = part.middle(target.face);
    const std::vector<double> point = query_.point(target.whole, at);
    const bool is_point = slopes.extent(point.data()) <= query_.near();
    if (is_point ? is_real(target, at) : slopes.spread() <= 8 * query_.noise()) {
        poles_.leave_open(point, target.whole.piece);
        add(target, at, is_point);
    }
}

// Finds a critical point in the part by Newton's method. False if none is found, or if it is a pole, which
// alone explains a singular matrix.
bool CriticalSearch::find(const Target &target, const FacePart &part, bool singular) {
    const std::optional<NewtonResult> found = newton(query_, target.face, target.whole, part);
    if (!found ||
        (singular && poles_.critical_at(query_.point(target.whole, found->at), target.whole.piece))) {
        return false;
    }
    if (found->converged && is_real(target, found->at)) {
        add(target, found->at, true);
    }
    return found->converged;
}

bool CriticalSearch::is_real(const Target &target, const AxisValues &at) {
    const bool real = is_critical(query_, target.face, target.whole, at);
    gaps_.doubtful =
        gaps_.doubtful || (!real && !poles_.any_at(query_.point(target.whole, at), target.whole.piece));
    return real;
}

void CriticalSearch::add(const Target &target, const AxisValues &at, bool isolated) {
    const std::vector<double> point = query_.point(target.whole, at);
    const int32_t kind = isolated ? kind_at(query_, target.face, target.whole, at) : critical_undecided;
    if (minima_ && !query_.query().sheets && !poles_.any_at(point, target.whole.piece)) {
        votes_.add(point, target.whole.piece, kind);
    }
    if (minima_ && (kind == critical_maximum || kind == critical_saddle)) {
        return;
    }
    gaps_.connected = gaps_.connected || !isolated;
    if (poles_.absorbs(point, target.whole.piece) || points_.has(point, target.whole, at)) {
        return;
    }
    if (points_.full()) {
        gaps_.incomplete = true;
        return;
    }
    points_.add(target.whole, at, kind);
}

} // namespace nrb::closest
