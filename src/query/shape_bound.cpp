#include "query/shape_bound.h"

#include "query/shape_forms.h"
#include "query/shape_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Bound {
    double upper = infinite;
    double noise = 0; // what rounding has in it
};

// The largest distance of control points that a function of them gives; it is convex and homogeneous.
template <class Distance>
double hull_bound(const ShapePiece &piece, Distance distance) {
    double largest = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (piece.at(i)[3] != 0) {
            largest = std::max(largest, distance(piece.point(i)));
        }
    }
    return largest * (1 + 8 * eps);
}

double smallest_coordinate(const ShapePiece &piece, double Vector3::*coordinate) noexcept {
    double least = infinite;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (piece.at(i)[3] != 0) {
            least = std::min(least, piece.point(i).*coordinate);
        }
    }
    return least - 4 * eps * std::abs(least);
}

// From one half of a cone, or a torus.
double true_distance(const Shape &shape, const Vector3 &p) noexcept {
    if (shape.kind == NURBS_SHAPE_CONE) {
        const double along = std::hypot(p.x, p.y) * std::sin(shape.sizes[0]) + p.z * std::cos(shape.sizes[0]);
        return along > 0 ? std::abs(signed_distance(shape, p)) : length(p);
    }
    return std::abs(signed_distance(shape, p));
}

// The distance of the middle of the control points and the radius of a ball round it that holds them all. Needed near
// an apex and where a torus meets its axis, where the gradient vanishes.
double ball_bound(const ShapePiece &piece, const Shape &shape) noexcept {
    Vector3 sum;
    double count = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        if (piece.at(i)[3] != 0) {
            sum = sum + piece.point(i);
            ++count;
        }
    }
    const Vector3 middle = (1 / count) * sum;
    const double radius = hull_bound(piece, [&](const Vector3 &p) { return length(p - middle); });
    return true_distance(shape, middle) + radius +
           16 * eps * (piece.size() + shape.sizes[0] + shape.sizes[1]);
}

// From the zeros of a quadric, as Quadric::curvature() has it.
Bound quadric_bound(const ShapeForms &forms, const Quadric &quadric) {
    const FormRange value = forms.quadratic(quadric);
    const double f = std::max(std::abs(value.least), std::abs(value.most));
    const double squared =
        quadric.round() ? -quadric.c * (1 - 4 * eps) - f : forms.squared_gradient(quadric).least;
    const double curved = quadric.curvature() * f * (1 + 8 * eps);
    if (!(squared >= curved)) {
        return {};
    }
    const double divisor = (std::sqrt(squared) + std::sqrt(squared - curved)) * (1 - 4 * eps);
    return divisor > 0 ? Bound{f / divisor, value.error / divisor} : Bound{};
}

// With s the distance from the axis and G = s^2 + z^2 + R^2 - r^2, the product of (s - R)^2 + z^2 - r^2 = G - 2 R s and
// (s + R)^2 + z^2 - r^2 = G + 2 R s is G^2 - 4 R^2 s^2.
Bound torus_bound(const ShapeForms &forms, double major, double minor) {
    const TorusForms torus = forms.torus(major, minor);
    const double twice = 2 * major * std::sqrt(std::max(0.0, torus.squared_radius.least));
    const double factor = (torus.sum.least + twice) - 8 * eps * (std::abs(torus.sum.least) + twice);
    if (!(factor > 0)) {
        return {};
    }
    const double f = std::max(std::abs(torus.product.least), std::abs(torus.product.most)) / factor;
    const double square = minor * minor * (1 - 4 * eps);
    const double divisor = (minor + std::sqrt(std::max(0.0, square - f))) * (1 - 4 * eps);
    return {f / divisor, torus.product.error / factor / divisor};
}

class ShapeDistance {
public:
    explicit ShapeDistance(const Shape &shape) : shape_(shape), straight_(straight(shape.kind)) {
        if (!straight_ && shape.kind != NURBS_SHAPE_TORUS) {
            quadric_ = quadric_of(shape);
        }
    }

    // Precondition: the piece is certified.
    [[nodiscard]] Bound upper(const ShapePiece &piece) const {
        Bound bound = straight_                          ? Bound{straight_bound(piece), 0}
                      : shape_.kind == NURBS_SHAPE_TORUS ? torus_or_ball(piece)
                                                         : curved_bound(piece);
        bound.upper = bound.upper * (1 + 16 * eps) + piece.moved();
        bound.noise += piece.moved() + 4 * eps * piece.size();
        return std::isnan(bound.upper) ? Bound{} : bound;
    }
    // Of the corners.
    [[nodiscard]] double lower(const ShapePiece &piece, double noise) const {
        double largest = 0;
        const auto &degrees = piece.shape.degrees;
        for (int corner = 0; corner < 8; ++corner) {
            int64_t i = 0;
            for (size_t k = 0; k < degrees.size(); ++k) {
                i = i * (degrees[k] + 1) + ((corner >> k & 1) != 0 ? degrees[k] : 0);
            }
            if (piece.at(i)[3] != 0) {
                largest = std::max(largest, least_distance(shape_, piece.point(i)));
            }
        }
        return std::max(0.0, largest * (1 - 64 * eps) - 64 * eps * piece.size() - noise);
    }

private:
    static bool straight(int32_t kind) noexcept {
        return kind == NURBS_SHAPE_POINT || kind == NURBS_SHAPE_LINE || kind == NURBS_SHAPE_PLANE;
    }
    [[nodiscard]] double straight_bound(const ShapePiece &piece) const {
        return hull_bound(piece, [this](const Vector3 &p) { return std::abs(signed_distance(shape_, p)); });
    }
    [[nodiscard]] Bound torus_or_ball(const ShapePiece &piece) const {
        const Bound bound = torus_bound(ShapeForms(piece), shape_.sizes[0], shape_.sizes[1]);
        const double ball = ball_bound(piece, shape_);
        return ball < bound.upper ? Bound{ball, 0} : bound;
    }
    [[nodiscard]] Bound curved_bound(const ShapePiece &piece) const {
        Bound bound = quadric_bound(ShapeForms(piece), quadric_);
        if (shape_.kind == NURBS_SHAPE_CONE) {
            const double ball = ball_bound(piece, shape_);
            if (ball < bound.upper || smallest_coordinate(piece, &Vector3::z) < bound.upper) {
                bound = {ball, 0}; // the zero may be one of the other half of the cone
            }
        }
        if (shape_.kind == NURBS_SHAPE_HYPERBOLA && smallest_coordinate(piece, &Vector3::x) < bound.upper) {
            bound = {}; // or of the other branch
        }
        if (shape_.planar()) {
            const double height = hull_bound(piece, [](const Vector3 &p) { return std::abs(p.z); });
            bound.upper = std::hypot(bound.upper, height);
        }
        return bound;
    }

    const Shape &shape_;
    bool straight_;
    Quadric quadric_;
};

struct Candidate {
    Bound bound;
    int depth = 0;
    ShapePiece piece;

    [[nodiscard]] bool operator<(const Candidate &other) const noexcept {
        return bound.upper < other.bound.upper;
    }
};

class Search {
public:
    Search(const Shape &shape, double tolerance) : distance_(shape), tolerance_(tolerance) {}

    Enclosure run(std::vector<ShapePiece> pieces) {
        const auto steps = 400 + 60 * std::ssize(pieces);
        for (ShapePiece &piece : pieces) {
            push(std::move(piece), infinite, 0);
        }
        for (int64_t step = 0; step < steps && !done(); ++step) {
            if (!refine()) {
                break;
            }
        }
        return {lower_, heap_.front().bound.upper};
    }

private:
    // Rounding much above that of the points comes from a gradient that is bounded badly, which halving cures.
    [[nodiscard]] bool done() const noexcept {
        const Candidate &top = heap_.front();
        const bool final = top.depth >= 6 || top.bound.noise <= 8 * top.piece.moved();
        const double noise = final ? top.bound.noise : 8 * top.piece.moved();
        return lower_ > tolerance_ || top.bound.upper - noise <= 1.25 * (lower_ + noise);
    }

    bool refine() {
        std::pop_heap(heap_.begin(), heap_.end());
        Candidate top = std::move(heap_.back());
        heap_.pop_back();
        const double whole = top.bound.upper;
        const int depth = top.depth + 1;
        ShapePiece lower;
        if (!top.piece.halve_into(lower)) {
            heap_.push_back(std::move(top));
            std::push_heap(heap_.begin(), heap_.end());
            return false;
        }
        push(std::move(lower), whole, depth);
        push(std::move(top.piece), whole, depth);
        return true;
    }

    // A part has no larger distances than the whole.
    void push(ShapePiece &&piece, double whole, int depth) {
        Candidate candidate;
        candidate.depth = depth;
        const bool certified = piece.certify();
        if (certified) {
            candidate.bound = distance_.upper(piece);
            lower_ = std::max(lower_, distance_.lower(piece, candidate.bound.noise));
        }
        candidate.bound.upper = std::min(candidate.bound.upper, whole);
        candidate.piece = std::move(piece);
        heap_.push_back(std::move(candidate));
        std::push_heap(heap_.begin(), heap_.end());
    }

    ShapeDistance distance_;
    double tolerance_;
    std::vector<Candidate> heap_;
    double lower_ = 0;
};

} // namespace

Enclosure distance_from(const Spline &spline, const Shape &shape, double tolerance) {
    return Search(shape, tolerance).run(shape_pieces(spline, shape));
}

} // namespace nrb
