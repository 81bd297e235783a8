// SPDX-License-Identifier: MIT
#include "mesh/border/model_edges.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "face/deviation.h"
#include "mesh/border/under_segments.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace nrb::mesh {

namespace {

// Rounds in which vertices are added for the sake of faces, in the middle of segments.
constexpr int most_polyline_rounds = 12;

// Work of placing a vertex on the curve of a face.
constexpr int64_t work_of_a_vertex = 1000;

// A part of a segment has to be closer than this share of the distance of the whole; otherwise the edge
// itself is off the face, and dividing does not help.
constexpr double no_better = 0.9;

// The parameters of a polyline, and how far each segment is from what the faces have under it.
struct Segments {
    std::vector<double> params{}, distances{};

    // The distance of the segment that holds a parameter.
    [[nodiscard]] double distance_at(double t) const noexcept {
        const auto after = std::ranges::upper_bound(params, t);
        return distances.empty() ? infinity : distances[static_cast<size_t>(after - params.begin() - 1)];
    }
};

// The middles of segments that are too far off, except where the division that made them did not bring them
// closer.
std::vector<double> places_to_add(const Segments &now, const Segments &before, double chord) {
    std::vector<double> result;
    for (size_t i = 0; i < now.distances.size(); ++i) {
        const double middle = now.params[i] / 2 + now.params[i + 1] / 2;
        const bool far =
            now.distances[i] > chord && now.distances[i] <= no_better * before.distance_at(middle);
        if (far && middle > now.params[i] && middle < now.params[i + 1]) {
            result.push_back(middle);
        }
    }
    return result;
}

// Whether a parameter is so close to an end of a segment that it stands for the vertex there: two faces may
// ask for the same place of their edge, up to rounding.
bool is_beside(double param, Interval segment) noexcept {
    const double room = 0x1p-20 * (segment.upper - segment.lower);
    return param - segment.lower <= room || segment.upper - param <= room;
}

} // namespace

ModelEdges::ModelEdges(const model::Model &model, const PolylineRule &rule)
    : rule_(rule), uses_(model, rule.chord), lines_(uses_.line_count()), vertices_(uses_.all().size()) {
    Steps steps(std::ssize(lines_));
    for (size_t line = 0; line < lines_.size(); ++line, steps.next()) {
        lines_[line].edge = line < model.edges.size() ? static_cast<int64_t>(line) : -1;
        uses_.align_fixed(line);
        make_line(line);
    }
    for (size_t use = 0; use < vertices_.size(); ++use) {
        set_vertices(use);
    }
}

const std::vector<CurveVertex> &ModelEdges::vertices_behind(int64_t face, int32_t loop,
                                                            int32_t index) const noexcept {
    static const std::vector<CurveVertex> none;
    const std::optional<size_t> use = uses_.behind(face, loop, index);
    return use ? vertices_[*use] : none;
}

int64_t ModelEdges::line_behind(int64_t face, int32_t loop, int32_t index) const noexcept {
    return static_cast<int64_t>(uses_[*uses_.behind(face, loop, index)].line);
}

// How far each segment of a polyline is from what the faces have under it, by samples.
std::vector<double> ModelEdges::distances_of(size_t line, const std::vector<double> &params) const {
    std::vector<double> result(params.size() - 1, 0.0), on_curve(params.size());
    for (const size_t at : uses_.users(line)) {
        const EdgeUse &use = uses_[at];
        std::ranges::transform(params, on_curve.begin(), [&](double t) { return use.pairing->on_curve(t); });
        const std::vector<double> own = distances_under(uses_.face_of(use), uses_.curve_of(use), on_curve);
        std::ranges::transform(result, own, result.begin(),
                               [](double x, double y) { return std::max(x, y); });
        count_work(std::ssize(params) << 10);
    }
    return result;
}

void ModelEdges::make_line(size_t line) {
    std::vector<double> fixed = uses_.fixed_params(line);
    Polyline polyline = polyline_of(uses_.curve(line), rule_, fixed);
    Segments before;
    for (int round = 0; round < most_polyline_rounds && std::isfinite(rule_.chord) && !work_ended();
         ++round) {
        Segments now{polyline.params, distances_of(line, polyline.params)};
        const std::vector<double> more = places_to_add(now, before, rule_.chord);
        if (more.empty()) {
            break;
        }
        before = std::move(now);
        fixed = before.params;
        fixed.insert(fixed.end(), more.begin(), more.end());
        std::ranges::sort(fixed);
        fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
        polyline = polyline_of(uses_.curve(line), rule_, fixed);
    }
    set_points(line, polyline);
}

int32_t ModelEdges::corner(int64_t number, const Vector3 &x) {
    const auto [known, fresh] = corners_.try_emplace(number, static_cast<int32_t>(points_.size()));
    if (fresh) {
        points_.push_back(x);
    }
    return known->second;
}

// The point at an end of a polyline, which is that of a corner. At a gap there are two: one at the end of a
// curve, and one at the start of the next.
int32_t ModelEdges::end_of_line(size_t line, bool upper, const Vector3 &x) {
    const EdgeUse &use = uses_[uses_.users(line).front()];
    const model::SharedBorders &borders = uses_.borders();
    const bool at_end = use.own ? !upper : upper != uses_.is_against(use); // of the curve of the loop
    if (at_end) {
        const int64_t number = borders.number(use.face, use.loop, use.index);
        const bool gap = uses_.behind(use.face, use.loop, use.index).has_value();
        return corner(gap ? -1 - number : borders.coedge(number).end, x);
    }
    const int32_t index = use.own ? uses_.next_index(use.face, use.loop, use.index) : use.index;
    return corner(borders.coedge(borders.number(use.face, use.loop, index)).start, x);
}

// Points of vertices that there were before stay. What points are moved to those of corners and of other edges
// comes on top of the bound.
void ModelEdges::set_points(size_t number, const Polyline &polyline) {
    EdgeLine &line = lines_[number];
    const int dim = uses_.curve(number).dim();
    const std::vector<double> params = std::exchange(line.params, polyline.params);
    const std::vector<int32_t> points = std::exchange(line.points, {});
    double moved = 0;
    for (size_t i = 0, known = 0; i < line.params.size(); ++i) {
        const Vector3 x = vector_of(polyline.points.data() + i * static_cast<size_t>(dim), dim);
        const bool first = i == 0, last = i + 1 == line.params.size();
        if (known < params.size() && params[known] == line.params[i]) {
            line.points.push_back(points[known++]);
        } else if ((first || last) && !uses_.users(number).empty()) {
            line.points.push_back(end_of_line(number, last, x));
        } else {
            line.points.push_back(static_cast<int32_t>(points_.size()));
            points_.push_back(x);
        }
        moved = std::max(moved, length(points_[static_cast<size_t>(line.points.back())] - x));
    }
    const double most = polyline.bounds.empty() ? 0 : std::ranges::max(polyline.bounds);
    line.bound = moved > 0 ? (most + moved) * (1 + 4 * eps) : most;
    line.reached = polyline.reached;
}

// Updates the vertices of all uses of a polyline. Returns the faces that these are of.
std::vector<int64_t> ModelEdges::update_users(size_t line) {
    std::vector<int64_t> faces;
    for (const size_t use : uses_.users(line)) {
        set_vertices(use);
        faces.push_back(uses_[use].face);
    }
    return faces;
}

// A part of the curve may be farther from its part of a divided segment than from the whole, up to twice as
// far where the segment is divided near one end. So the segments are bounded anew, and divided further where
// that takes them off the rule.
std::vector<int64_t> ModelEdges::add_vertices(int64_t number, std::span<const double> params) {
    const auto at = static_cast<size_t>(number);
    const std::vector<double> &known = lines_[at].params;
    std::vector<double> all;
    auto next = params.begin();
    for (size_t i = 0; i < known.size(); ++i) {
        for (; next != params.end() && *next < known[i]; ++next) {
            if (i > 0 && !is_beside(*next, {all.back(), known[i]})) {
                all.push_back(*next);
            }
        }
        all.push_back(known[i]);
    }
    if (all.size() == known.size()) {
        return {};
    }
    set_points(at, polyline_of(uses_.curve(at), rule_, all));
    return update_users(at);
}

// If no vertex of a polyline moves farther than some distance, no point of it does: its bound grows by no
// more than that.
std::vector<int64_t> ModelEdges::unite(const std::vector<std::array<int32_t, 2>> &pairs) {
    std::unordered_map<int32_t, int32_t> stands_for;
    const auto stand_in = [&](int32_t point) {
        for (auto found = stands_for.find(point); found != stands_for.end(); found = stands_for.find(point)) {
            point = found->second;
        }
        return point;
    };
    for (const auto &[first, second] : pairs) {
        if (const int32_t one = stand_in(first), other = stand_in(second); one != other) {
            stands_for[other] = one;
        }
    }
    std::vector<int64_t> faces;
    for (size_t at = 0; at < lines_.size(); ++at) {
        double apart = 0;
        bool any = false;
        for (int32_t &point : lines_[at].points) {
            const int32_t other = stand_in(point);
            any = any || other != point;
            apart = std::max(
                apart, length(points_[static_cast<size_t>(point)] - points_[static_cast<size_t>(other)]));
            point = other;
        }
        if (any) {
            lines_[at].bound += apart * (1 + 4 * eps);
            const std::vector<int64_t> own = update_users(at);
            faces.insert(faces.end(), own.begin(), own.end());
        }
    }
    return faces;
}

// Sets the vertices of a use, in rising order of the parameters of its curve, which may run against the edge.
// Vertices that were there before stay where they were.
void ModelEdges::set_vertices(size_t number) {
    const EdgeLine &line = lines_[uses_[number].line];
    std::vector<CurveVertex> before = std::move(vertices_[number]), &vertices = vertices_[number];
    if (!before.empty() && before.front().edge_param > before.back().edge_param) {
        std::ranges::reverse(before);
    }
    vertices.clear();
    vertices.reserve(line.params.size());
    std::vector<PairedParam> pairs;
    auto known = before.cbegin();
    for (size_t i = 0; i < line.params.size(); ++i) {
        const bool stays = known != before.cend() && known->edge_param == line.params[i];
        if (stays) {
            vertices.push_back(*known++);
            vertices.back().point = line.points[i];
        } else {
            vertices.push_back(vertex_of(number, line.params[i], line.points[i]));
        }
        const bool end = i == 0 || i + 1 == line.params.size();
        pairs.push_back(
            {line.params[i], vertices.back().param, end || stays || vertices.back().place.has_value()});
    }
    put_in_order(pairs);
    for (size_t i = 0; i < pairs.size(); ++i) {
        vertices[i].param = pairs[i].found;
    }
    if (vertices.front().param > vertices.back().param) {
        std::ranges::reverse(vertices);
    }
}

CurveVertex ModelEdges::vertex_of(size_t number, double param, int32_t point) const {
    const EdgeUse &use = uses_[number];
    const auto is_here = [&](const FixedPlace &fixed) { return fixed.edge == param; };
    const auto fixed = std::find_if(use.fixed.rbegin(), use.fixed.rend(), is_here);
    if (fixed != use.fixed.rend()) {
        return {fixed->curve, point, param, fixed->place};
    }
    count_work(work_of_a_vertex);
    return {use.pairing->on_curve(param), point, param};
}

} // namespace nrb::mesh
