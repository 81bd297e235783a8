#include "closest/patch/patch_critical.h"

#include "closest/patch/patch_matrix.h"
#include "closest/patch/patch_place.h"
#include "numeric/norm.h"
#include "pieces/best_first.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr int deepest = 26; // halvings of an axis
constexpr int shallow = 8;  // before a singular matrix is looked at

} // namespace

PatchCritical::PatchCritical(const PatchPieces &pieces, const Query &query)
    : pieces_(pieces), query_(query), x_(memory_.take(pieces.shape().lanes)), items_(pieces, x_, memory_),
      descent_(pieces.shape(), memory_), budget_(query.budget > 0 ? query.budget : pieces::default_budget) {
    pieces.place(query.point, x_);
    noise_ = pieces.allowance() * pieces.weight_ratio() * (pieces.size() + pieces.magnitude(query.point));
    near_ = pieces.scaled(query.tolerance) + 64 * noise_;
    const int64_t count = pieces.shape().coefficients();
    cost_ = std::max<int64_t>(1, count * count / 65536);
}

CriticalSet PatchCritical::run() {
    CriticalSet set;
    if (!(norm(x_, pieces_.shape().dim) < 0x1p100) || pieces_.shape().coefficients() > most_squared) {
        set.status = closest_budget;
        return set;
    }
    find_poles();
    search_faces();
    set.points = std::move(found_);
    std::sort(set.points.begin(), set.points.end(),
              [](const CriticalPoint &a, const CriticalPoint &b) { return a.foot.params < b.foot.params; });
    set.status = incomplete_  ? closest_budget
                 : connected_ ? closest_not_unique
                 : doubtful_  ? 0
                              : closest_certified;
    return set;
}

// The face of which side k is digit k of a number to the base 3, less 1; false if there is none: at a seam.
bool PatchCritical::make_face(int code, Face &face) const {
    const PatchShape &shape = pieces_.shape();
    face.shape = shape;
    face.shape.axes = 0;
    bool exists = true;
    for (int k = 0; k < shape.axes; ++k, code /= 3) {
        const auto at = static_cast<size_t>(k);
        face.side[at] = code % 3 - 1;
        const bool seam = pieces_.periodic(pieces_.spline_axis(k)) && query_.range == nullptr;
        exists = exists && (face.side[at] < 0 || !seam);
        if (face.side[at] < 0) {
            face.axis[static_cast<size_t>(face.shape.axes)] = k;
            face.shape.degrees[static_cast<size_t>(face.shape.axes++)] = shape.degree(k);
        }
    }
    return exists;
}

int PatchCritical::face_count() const noexcept {
    int count = 1;
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        count *= 3;
    }
    return count;
}

// Faces of pieces inside the domain are searched for the sake of creases.
PatchCritical::Spots PatchCritical::minima(const std::vector<int64_t> &pieces, double limit) {
    minima_ = true;
    limit_ = limit;
    find_poles();
    for (int code = 0; code < face_count(); ++code) {
        Face face;
        static_cast<void>(make_face(code, face)); // seams too
        face.squares = std::make_unique<PatchSquares>(face.shape);
        for (const int64_t piece : pieces) {
            const PatchMemory::Hold hold(memory_);
            search_piece(face, piece);
        }
    }
    hear_all();
    return {std::move(spots_), incomplete_, connected_, doubtful_};
}

// Several faces of a piece may have a point, and the one of most dimensions tells most.
void PatchCritical::testify(const std::vector<double> &point, int64_t piece, int32_t kind) {
    const Answer answer = kind == critical_minimum     ? Answer::yes
                          : kind == critical_undecided ? Answer::unknown
                                                       : Answer::no;
    for (Testimony &other : testimonies_) {
        if (other.piece == piece &&
            distance(point.data(), other.point.data(), pieces_.shape().dim) <= near_) {
            const bool agree = other.answer == answer || answer == Answer::unknown;
            other.answer = agree ? other.answer : other.answer == Answer::unknown ? answer : Answer::unknown;
            return;
        }
    }
    testimonies_.push_back({point, piece, answer});
}

// A spot is a minimum where all pieces around say so, and none where one denies it.
void PatchCritical::hear_all() {
    const auto denied = [&](Spot &spot, const std::vector<double> &point) {
        bool no = false;
        spot.certain = true;
        for (const Testimony &one : testimonies_) {
            if (distance(point.data(), one.point.data(), pieces_.shape().dim) <= near_) {
                no = no || one.answer == Answer::no;
                spot.certain = spot.certain && one.answer == Answer::yes;
            }
        }
        return no;
    };
    std::vector<Spot> kept;
    for (size_t i = 0; i < spots_.size(); ++i) {
        if (!denied(spots_[i], points_[i])) {
            kept.push_back(spots_[i]);
        }
    }
    spots_ = std::move(kept);
}

void PatchCritical::search_faces() {
    for (int code = 0; code < face_count(); ++code) {
        Face face;
        if (make_face(code, face) && !is_pole(face)) {
            face.squares = std::make_unique<PatchSquares>(face.shape);
            search_face(face);
        }
    }
}

void PatchCritical::search_face(const Face &face) {
    for (int64_t piece = 0; piece < pieces_.count(); ++piece) {
        if (touches(face, piece)) {
            const PatchMemory::Hold hold(memory_);
            search_piece(face, piece);
        }
    }
}

bool PatchCritical::touches(const Face &face, int64_t piece) const noexcept {
    const PatchPieces::Index index = pieces_.index(piece);
    std::array<int, max_axes> side{};
    side.fill(-1);
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        side[static_cast<size_t>(pieces_.spline_axis(k))] = face.side[static_cast<size_t>(k)];
    }
    for (int axis = 0; axis < pieces_.spline_axes(); ++axis) {
        const auto at = static_cast<size_t>(axis);
        const double first = pieces_.break_at(axis, index[at]), last = pieces_.break_at(axis, index[at] + 1);
        const Interval whole{pieces_.break_at(axis, 0), pieces_.break_at(axis, pieces_.count(axis))};
        const Interval range = query_.range != nullptr ? query_.range[axis] : whole;
        const bool holds_side = side[at] < 0 || (side[at] == 0 ? first <= range.lower : last >= range.upper);
        if (!(first < range.upper && last > range.lower) || !holds_side) {
            return false;
        }
    }
    return true;
}

PatchItem PatchCritical::piece_in_range(int64_t piece) const {
    PatchItem whole = items_.whole(piece);
    items_.measure(whole);
    const PatchBox box = box_in_range(pieces_, piece, query_.range);
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const auto at = static_cast<size_t>(k);
        if (box.lower[at] > 0 || box.upper[at] < 1) {
            whole = items_.part(whole, k, box.lower[at], box.upper[at]);
        }
    }
    return whole;
}

// Of the part in the range, the coefficients on the face.
void PatchCritical::search_piece(const Face &face, int64_t piece) {
    const PatchShape &shape = pieces_.shape();
    PatchItem whole = piece_in_range(piece);
    if (face.shape.axes == 0) {
        AxisValues at{};
        std::copy_n(face.side.begin(), shape.axes, at.begin());
        const bool wanted = minima_ || kind(face, whole, at) != critical_saddle;
        if (wanted && !is_at_pole(whole, at, true)) {
            add(face, whole, at, true);
        }
        return;
    }
    Part part{memory_.take(face.shape.values()), {}, {1, 1, 1}, 0};
    double *out = part.values;
    for (int64_t i = 0; i < shape.coefficients(); ++i) {
        bool on_face = true;
        int64_t rest = i;
        for (int k = shape.axes; k-- > 0; rest /= shape.degree(k) + 1) {
            const int side = face.side[static_cast<size_t>(k)];
            const auto place = static_cast<int>(rest % (shape.degree(k) + 1));
            on_face = on_face && (side < 0 || place == (side == 0 ? 0 : shape.degree(k)));
        }
        if (on_face) {
            out = std::copy_n(whole.values + i * shape.lanes, shape.lanes, out);
        }
    }
    examine(face, whole, part);
}

void PatchCritical::examine(const Face &face, const PatchItem &whole, Part &part) {
    if (spent_ + cost_ > budget_) {
        incomplete_ = true;
        return;
    }
    spent_ += cost_;
    int axis = 0;
    if (!settled(face, whole, part, axis)) {
        split(face, whole, part, axis);
    }
}

void PatchCritical::split(const Face &face, const PatchItem &whole, Part &part, int axis) {
    const PatchMemory::Hold hold(memory_);
    const auto at = static_cast<size_t>(axis);
    BernsteinShape net{{}, face.shape.lanes};
    std::copy_n(face.shape.degrees.begin(), face.shape.axes, net.degrees.begin());
    Part lower = part;
    lower.values = memory_.take(face.shape.values());
    halve(net, axis, part.values, lower.values);
    for (Part *half : {&lower, &part}) {
        half->length[at] /= 2;
        ++half->depth;
    }
    part.lower[at] += part.length[at];
    examine(face, whole, lower);
    examine(face, whole, part);
}

bool PatchCritical::settled(const Face &face, const PatchItem &whole, const Part &part, int &axis) {
    const PatchMemory::Hold hold(memory_);
    for (int k = 0; k < face.shape.axes; ++k) { // the longest, unless something better is known
        axis = part.length[static_cast<size_t>(k)] > part.length[static_cast<size_t>(axis)] ? k : axis;
    }
    const bool too_deep = part.depth > deepest * face.shape.axes;
    const double moved = whole.moved + (part.depth + 1) * face.shape.degree(axis) * eps * whole.reach;
    PatchSlopes slopes(face.shape, *face.squares, part.values, moved, memory_);
    if (!slopes.sound()) {
        incomplete_ = incomplete_ || too_deep;
        return too_deep;
    }
    if (slopes.least() > limit_ || slopes.monotone()) {
        return true;
    }
    const bool flat = slopes.spread() <= 8 * noise_; // one point, or many at one distance
    if ((flat && slopes.slanted()) || at_pole(slopes, flat)) {
        return true;
    }
    if (flat || too_deep) {
        incomplete_ = incomplete_ || !flat;
        add_all(face, whole, part, slopes);
        return true;
    }
    const PatchSlopes::Matrix matrix = slopes.matrix();
    axis = slopes.widest_axis();
    const bool singular = matrix == PatchSlopes::Matrix::singular && part.depth >= shallow * face.shape.axes;
    if ((singular || matrix == PatchSlopes::Matrix::regular) && find(face, whole, part, singular)) {
        connected_ = connected_ || singular;
        return true;
    }
    return false;
}

AxisValues PatchCritical::middle(const Face &face, const Part &part) const noexcept {
    AxisValues at{};
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        at[static_cast<size_t>(k)] = std::max(0, face.side[static_cast<size_t>(k)]);
    }
    for (int k = 0; k < face.shape.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        at[static_cast<size_t>(face.axis[i])] = part.lower[i] + part.length[i] / 2;
    }
    return at;
}

// A part whose distances agree, or that is too small to be halved, stands for all of its points.
void PatchCritical::add_all(const Face &face, const PatchItem &whole, const Part &part,
                            const PatchSlopes &slopes) {
    const AxisValues at = middle(face, part);
    double *point = memory_.take(pieces_.shape().dim);
    descent_.point(whole.values, at, point);
    const double extent = slopes.extent(point);
    const bool is_point = extent <= near_;
    if (is_point ? is_real(face, whole, at) : slopes.spread() <= 8 * noise_) {
        open_pole(point);
        add(face, whole, at, is_point);
    }
}

bool PatchCritical::find(const Face &face, const PatchItem &whole, const Part &part, bool singular) {
    const int n = face.shape.axes;
    AxisValues at = middle(face, part);
    bool converged = false;
    for (int step = 0; step < 40 && !converged; ++step) {
        const PatchJet jet = descent_.jet(whole.values, at);
        SmallMatrix hessian(n, n);
        SmallVector gradient(n);
        for (int k = 0; k < n; ++k) {
            const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
            gradient(k) = jet.gradient[i];
            for (int l = 0; l < n; ++l) {
                const auto j = static_cast<size_t>(face.axis[static_cast<size_t>(l)]);
                hessian(k, l) = jet.metric[i][j] + jet.curvature[i][j];
            }
        }
        const SmallVector move = hessian.completeOrthogonalDecomposition().solve(gradient);
        converged = true;
        for (int k = 0; k < n; ++k) {
            const auto i = static_cast<size_t>(k), j = static_cast<size_t>(face.axis[i]);
            const double next = at[j] - move(k);
            converged = converged && std::abs(move(k)) <= 1e-9 * part.length[i];
            at[j] = std::clamp(next, part.lower[i] - part.length[i], part.lower[i] + 2 * part.length[i]);
            if (!std::isfinite(at[j])) {
                return false;
            }
        }
    }
    for (int k = 0; k < n; ++k) {
        const auto i = static_cast<size_t>(k), j = static_cast<size_t>(face.axis[i]);
        const double over = 1e-7 * part.length[i];
        if (at[j] < part.lower[i] - over || at[j] > part.lower[i] + part.length[i] + over) {
            return false;
        }
        at[j] = std::clamp(at[j], part.lower[i], part.lower[i] + part.length[i]);
    }
    if (singular && is_at_pole(whole, at)) {
        return false;
    }
    if (converged && is_real(face, whole, at)) {
        add(face, whole, at, true);
    }
    return converged;
}

void PatchCritical::add(const Face &face, const PatchItem &whole, const AxisValues &at, bool isolated) {
    const int dim = pieces_.shape().dim;
    std::vector<double> point(static_cast<size_t>(dim));
    descent_.point(whole.values, at, point.data());
    const int32_t is = isolated ? kind(face, whole, at) : critical_undecided;
    if (minima_ && !is_at_pole(whole, at, true)) {
        testify(point, whole.piece, is);
    }
    if (minima_ && (is == critical_maximum || is == critical_saddle)) {
        return;
    }
    connected_ = connected_ || !isolated;
    if (at_pole(point)) {
        return;
    }
    for (const std::vector<double> &other : points_) {
        if (distance(point.data(), other.data(), dim) <= near_) {
            return;
        }
    }
    if (found_.size() >= 4096) {
        incomplete_ = true;
        return;
    }
    add_point(whole, at, is);
}

void PatchCritical::add_point(const PatchItem &whole, const AxisValues &at, int32_t kind) {
    std::vector<double> point(static_cast<size_t>(pieces_.shape().dim));
    descent_.point(whole.values, at, point.data());
    AxisValues place{};
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        place[static_cast<size_t>(k)] = std::clamp(whole.to_piece(k, at[static_cast<size_t>(k)]), 0.0, 1.0);
    }
    CriticalPoint critical;
    critical.foot = foot_at(pieces_, whole.piece, place, query_.range);
    critical.foot.distance = pieces_.unscaled(descent_.distance(whole.values, at));
    critical.foot.noise = pieces_.unscaled(noise_);
    critical.kind = kind;
    spots_.push_back({whole.piece, place, descent_.distance(whole.values, at)});
    found_.push_back(critical);
    points_.push_back(std::move(point));
}

} // namespace nrb::closest
