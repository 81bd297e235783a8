// SPDX-License-Identifier: MIT
#include "analysis/singular.h"

#include "analysis/jacobian_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace nrb::analysis {

namespace {

// |S_u|^2 |S_v|^2 - (S_u . S_v)^2 times a power of the weight: the determinant of Gram's matrix.
RoundedPolynomial gram_numerator(const pieces::HomogeneousPiece &piece) {
    const RoundedPolynomial u = pieces::tangent_numerator(piece, 0), v = pieces::tangent_numerator(piece, 1);
    const RoundedPolynomial mixed = dot(u, v);
    return dot(u, u) * dot(v, v) - mixed * mixed;
}

// The polynomial that vanishes at singular places; empty if every place is singular.
std::optional<RoundedPolynomial> numerator_of(const pieces::HomogeneousPiece &piece, int axes) {
    const int dim = piece.points.shape.width;
    if (axes == 1) {
        return pieces::tangent_numerator(piece, 0);
    }
    if (dim == 1) {
        return std::nullopt;
    }
    return dim <= 3 ? pieces::normal_numerator(piece) : gram_numerator(piece);
}

// Whether a component, or the projection onto the mean of the coefficients, has a certain sign.
bool regular(const RoundedPolynomial &f) {
    const auto n = static_cast<size_t>(f.shape.width);
    std::vector<double> mean(n);
    for (size_t i = 0; i < f.values.size(); ++i) {
        mean[i % n] += f.values[i];
    }
    RoundedPolynomial along = scaled(component(f, 0), mean[0]);
    for (size_t c = 0; c < n; ++c) {
        const RoundedPolynomial one = component(f, static_cast<int>(c));
        if (certain_sign(one) != 0) {
            return true;
        }
        along = c == 0 ? along : sum(along, mean[c], one);
    }
    return certain_sign(along) != 0;
}

// A box in the local parameters of a piece.
struct Box {
    std::array<double, max_axes> from{};
    std::array<double, max_axes> to{};
};

class SingularSearch {
public:
    SingularSearch(const Spline &spline, double tolerance)
        : axes_(spline.axes()), tolerance_(tolerance), maker_(spline, whole_domain(spline)),
          domain_(whole_domain(spline)), parts_(axes_) {}

    SingularPlaces run() {
        for (int64_t e = 0; e < maker_.count(); ++e) {
            start(maker_.piece(e));
        }
        left_.resize(pieces_.size());
        while (!parts_.empty()) {
            JacobianPart part = parts_.take();
            if (!regular(part.f) && !parts_.halve(part, scales_[part.piece], tolerance_)) {
                left_[part.piece].push_back({part.from, part.to});
            }
        }
        for (size_t e = 0; e < pieces_.size(); ++e) {
            gather(e);
        }
        merge_small();
        sort();
        return std::move(result_);
    }

private:
    void start(const pieces::HomogeneousPiece &piece) {
        const size_t e = pieces_.size();
        pieces_.push_back(piece.part);
        std::array<double, max_axes> scale{};
        for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
            scale[k] = (piece.part[k].upper - piece.part[k].lower) / (domain_[k].upper - domain_[k].lower);
        }
        scales_.push_back(scale);
        result_.complete = result_.complete && piece.positive;
        std::optional<RoundedPolynomial> f = numerator_of(piece, axes_);
        if (!f || vanishes(*f)) {
            add(e, {{0, 0, 0}, {1, 1, 1}}, {0.5, 0.5, 0.5});
            return;
        }
        const BoundaryZeros ends = divide_boundaries(*f, axes_);
        for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
            for (const size_t upper : {size_t{0}, size_t{1}}) {
                if (ends[k][upper]) {
                    Box edge{{0, 0, 0}, {1, 1, 1}};
                    edge.from[k] = edge.to[k] = static_cast<double>(upper);
                    std::array<double, max_axes> at{0.5, 0.5, 0.5};
                    at[k] = edge.from[k];
                    add(e, edge, at);
                }
            }
        }
        parts_.add({std::move(*f), e, {}, {1, 1, 1}});
    }

    void add(size_t piece, const Box &box, const std::array<double, max_axes> &at) {
        SingularPlace place;
        for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
            const Interval range = pieces_[piece][k];
            place.at[k] = parameter_in(range, at[k]);
            place.box[k] = {parameter_in(range, box.from[k]), parameter_in(range, box.to[k])};
        }
        result_.places.push_back(place);
    }

    // Boxes of one piece that touch form one place. Its point is the middle of the box nearest to the middle
    // of their common bounding box.
    void gather(size_t e) {
        std::vector<Box> &boxes = left_[e];
        std::sort(boxes.begin(), boxes.end(),
                  [](const Box &a, const Box &b) { return a.from[0] < b.from[0]; });
        std::vector<size_t> group(boxes.size());
        std::iota(group.begin(), group.end(), size_t{0});
        const auto root = [&group](size_t i) {
            while (group[i] != i) {
                i = group[i] = group[group[i]];
            }
            return i;
        };
        for (size_t i = 0; i < boxes.size(); ++i) {
            for (size_t j = i + 1; j < boxes.size() && boxes[j].from[0] <= boxes[i].to[0]; ++j) {
                if (axes_ == 1 ||
                    (boxes[j].from[1] <= boxes[i].to[1] && boxes[i].from[1] <= boxes[j].to[1])) {
                    group[root(j)] = root(i);
                }
            }
        }
        std::vector<std::vector<size_t>> members(boxes.size());
        for (size_t i = 0; i < boxes.size(); ++i) {
            members[root(i)].push_back(i);
        }
        for (const std::vector<size_t> &list : members) {
            if (!list.empty()) {
                add_group(e, list);
            }
        }
    }

    void add_group(size_t e, const std::vector<size_t> &list) {
        const std::vector<Box> &boxes = left_[e];
        Box all = boxes[list.front()];
        for (const size_t i : list) {
            for (size_t k = 0; k < max_axes; ++k) {
                all.from[k] = std::min(all.from[k], boxes[i].from[k]);
                all.to[k] = std::max(all.to[k], boxes[i].to[k]);
            }
        }
        std::array<double, max_axes> best{};
        double nearest = -1;
        for (const size_t i : list) {
            const std::array<double, max_axes> middle = middle_of(boxes[i]);
            double away = 0;
            for (size_t k = 0; k < max_axes; ++k) {
                away = std::max(away, std::abs(middle[k] - all.from[k] / 2 - all.to[k] / 2));
            }
            if (nearest < 0 || away < nearest) {
                nearest = away;
                best = middle;
            }
        }
        add(e, all, list.size() == 1 || nearest > 0 ? best : middle_of(all));
    }
    static std::array<double, max_axes> middle_of(const Box &box) noexcept {
        std::array<double, max_axes> middle{};
        for (size_t k = 0; k < max_axes; ++k) {
            middle[k] = box.from[k] / 2 + box.to[k] / 2;
        }
        return middle;
    }

    [[nodiscard]] bool joined(const SingularPlace &a, const SingularPlace &b) const noexcept {
        bool same = true, small = true;
        for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
            const Interval p = a.box[k], q = b.box[k];
            if (p.lower > q.upper || q.lower > p.upper) {
                return false;
            }
            const double length = std::max(p.upper, q.upper) - std::min(p.lower, q.lower);
            same = same && p.lower == q.lower && p.upper == q.upper;
            small = small && length <= 8 * tolerance_ * (domain_[k].upper - domain_[k].lower);
        }
        return same || small;
    }

    // Merges places that were found in several pieces because they lie on a common boundary.
    void merge_small() {
        std::vector<SingularPlace> merged;
        for (const SingularPlace &place : result_.places) {
            const auto twin = std::find_if(merged.begin(), merged.end(),
                                           [&](const SingularPlace &other) { return joined(place, other); });
            if (twin == merged.end()) {
                merged.push_back(place);
                continue;
            }
            for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
                Interval &range = twin->box[k];
                range = {std::min(range.lower, place.box[k].lower),
                         std::max(range.upper, place.box[k].upper)};
                twin->at[k] = range.lower / 2 + range.upper / 2;
            }
        }
        result_.places = std::move(merged);
    }

    void sort() {
        std::sort(result_.places.begin(), result_.places.end(),
                  [](const SingularPlace &a, const SingularPlace &b) { return a.at < b.at; });
    }

    int axes_;
    double tolerance_;
    pieces::PieceMaker maker_;
    Part domain_;
    std::vector<Part> pieces_;
    std::vector<std::array<double, max_axes>> scales_; // side lengths of a piece relative to the domain
    PartQueue parts_;
    std::vector<std::vector<Box>> left_; // for each piece, the boxes that could not be proven regular
    SingularPlaces result_;
};

} // namespace

SingularPlaces singular_places(const Spline &spline, double tolerance) {
    return SingularSearch(spline, tolerance).run();
}

} // namespace nrb::analysis
