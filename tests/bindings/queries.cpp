// SPDX-License-Identifier: MIT
// Distances, measures, boxes and features through the C++ wrapper: one known value of each.
#include "expect.hpp"

using namespace libnurbs;

// Along x from 0 to 2, in the plane.
static Spline base() {
    return line({0, 0}, {2, 0});
}
// Closed, with its middle at the origin and sides of 2.
static Spline square() {
    return polyline(2, {-1, -1, 1, -1, 1, 1, -1, 1, -1, -1});
}
static Spline floor_plane() {
    return plane({2, 0, 0}, {0, 4, 0}, {0, 0, 0});
}

static void closest() {
    const ClosestPoints found = closest_points(base(), {0.5, 1, 3, 0});
    EXPECT(near(found.params, {0.25, 1}) && near(found.points, {0.5, 0, 2, 0}));
    EXPECT(near(found.distances, {1, 1}));
    EXPECT((found.status == std::vector{closest_certified, closest_certified | closest_boundary}));
    EXPECT(near(closest_points(base(), {0.5, 1}, {.range = {0.5, 1}}).params, {0.5}));
    const Values columns = {0.5, 1, 1, 2};
    Values distances(2);
    closest_points(base(), Input(columns, 2, 1, 2), {.distances = distances});
    EXPECT(near(distances, {1, 2}));
    EXPECT(near(closest_points(floor_plane(), {0.5, 1, 3}).params, {0.25, 0.25}));
    EXPECT(near(farthest_points(base(), {0.5, 1}).distances, {std::sqrt(3.25)}));
    farthest_points(base(), {0.5, 1, 2, 1}, {.params = distances});
    EXPECT(near(distances, {1, 0}));
    EXPECT(near(closest_local(square(), {0, 0.5, 0, 0.5}, {0.3, 2.3}).points, {0, -1, 0, 1}));
    closest_local(square(), {0, 0.5, 0, 0.5}, {0.3, 2.3}, {.distances = distances});
    EXPECT(near(distances, {1.5, 0.5}));
    const ClosestPoints odd = closest_points(base(), {nan_value, 0}, {.flags = nan_points});
    EXPECT(odd.status[0] == closest_invalid && std::isnan(odd.distances[0]));
    EXPECT(status_of([&] { (void)closest_points(base(), {nan_value, 0}); }) == Status::point_not_finite);
    EXPECT(status_of([&] { (void)closest_points(base(), {1, 2}, {.range = {0}}); }) == Status::size);
    EXPECT(status_of([&] { (void)closest_points(base(), {1, 2, 3}); }) == Status::size);
    EXPECT(status_of([&] { (void)closest_points(base(), {1, 2}, {.tolerance = -1}); }) == Status::tolerance);
}

static void all_points() {
    const ClosestAll sides = closest_all(square(), {0, 0}, {.tolerance = 1e-9});
    EXPECT(near(sides.params, {0.5, 1.5, 2.5, 3.5}) && near(sides.distances, {1, 1, 1, 1}));
    EXPECT((sides.status & closest_certified) != 0);
    const CriticalPoints found = critical_points(base(), {0.5, 1}, {.tolerance = 1e-9});
    EXPECT(near(found.params, {0, 0.25, 1}));
    EXPECT(near(found.distances, {std::sqrt(1.25), 1, std::sqrt(3.25)}));
    EXPECT((found.kinds == std::vector{critical_maximum, critical_minimum, critical_maximum}));
    const SignedDistances sided = signed_distances(base(), {1, 1, 0.5, -2});
    EXPECT(near(sided.distances, {1, -2}) && near(sided.params, {0.5, 0.25}));
    EXPECT((sided.status == std::vector{closest_certified, closest_certified}));
}

static void distances() {
    const Spline a = line({0, 0, 0}, {2, 0, 0}), b = line({1, -1, 1}, {1, 1, 1});
    const Distance found = distance(a, b, 1e-9);
    EXPECT(found.at_least <= 1 && found.at_least >= 1 - 1e-8 && std::abs(found.at_most - 1) <= 1e-8);
    EXPECT(near(found.params_a, {0.5}, 1e-4) && near(found.params_b, {0.5}, 1e-4));
    EXPECT(found.status == closest_certified);
    const HausdorffDistance both = hausdorff_distance(base(), line({0, 1}, {1, 1}), 1e-9);
    EXPECT(std::abs(both.at_least[0] - std::sqrt(2)) <= 1e-8 && std::abs(both.at_most[1] - 1) <= 1e-8);
    EXPECT(near(both.params_a, {1}, 1e-4) && both.params_b.size() == 1);
    EXPECT(status_of([&] { (void)distance(a, base()); }) == Status::incompatible);
}

static void measures() {
    EXPECT(near({length(circle({}, 2)).value}, {4 * pi}) && length(circle({}, 2)).error <= 1e-10);
    EXPECT(near({length(circle({}, 1), 1e-9, {0, 0.25}).value}, {pi / 2}, 1e-8));
    EXPECT(near(lengths(base(), {0.5, 1}), {1, 2}));
    EXPECT(near(params_at_lengths(base(), {0, 1}), {0, 0.5}));
    EXPECT(near(params_at_lengths(base(), {5}, 0, clamp), {1}));
    EXPECT(status_of([] { (void)params_at_lengths(base(), {5}); }) == Status::length);
    const Division quarters = divide(circle({}, 1), 4);
    EXPECT(near(quarters.params, {0, 0.25, 0.5, 0.75, 1}) && near({quarters.size}, {pi / 2}));
    EXPECT(near({divide(circle({}, 1), 4, 0, equal_chords).size}, {std::sqrt(2)}));
    EXPECT(near({area(sphere({}, 2)).value}, {16 * pi}, 1e-11));
    EXPECT(near({area(floor_plane(), 0, {0, 0.5, 0, 0.25}).value}, {1}));
}

static void contents() {
    const Moments wire = moments(base());
    EXPECT(near({wire.content}, {2}) && near(wire.centroid, {1, 0}));
    EXPECT(near(wire.inertia, {0, 0, 0, 2.0 / 3}));
    const std::vector<Spline> round = {circle({.origin = {1, 1}}, 2)};
    const EnclosedArea disc = enclosed_area(round);
    EXPECT(near({disc.area, disc.centroid[0], disc.centroid[1]}, {4 * pi, 1, 1}));
    EXPECT(near({disc.inertia[0][0], disc.inertia[0][1], disc.inertia[1][1]}, {4 * pi, 0, 4 * pi}, 1e-11));
    const std::vector<Spline> shell = {sphere({.origin = {1, 2, 3}}, 1)};
    const EnclosedVolume ball = enclosed_volume(shell);
    EXPECT(near({ball.volume, ball.openness}, {4 * pi / 3, 0}, 1e-11));
    EXPECT(near({ball.centroid.begin(), ball.centroid.end()}, {1, 2, 3}, 1e-11));
    EXPECT(near({ball.inertia[2][2], ball.inertia[2][0]}, {8 * pi / 15, 0}, 1e-10));
    const std::vector<Spline> open = {base()};
    EXPECT(status_of([&] { (void)enclosed_area(open); }) == Status::gap);
    const std::vector<Spline> eight = {polyline(2, {0, 0, 2, 2, 2, 0, 0, 2, 0, 0})};
    const EnclosedArea nothing = enclosed_area(eight);
    EXPECT(nothing.area == 0 && std::isnan(nothing.centroid[0]) && std::isnan(nothing.inertia[1][1]));
    EXPECT(moments(line({1, 1}, {1, 1})).content == 0);
}

static void boxes() {
    const Box tight = box(circle({}, 1), 1e-9);
    EXPECT(near(tight.lower, {-1, -1}, 1e-8) && near(tight.upper, {1, 1}, 1e-8) && tight.gap <= 1e-8);
    EXPECT(near(box(circle({}, 1), infinity).upper, {1, 1}));
    EXPECT(near(box(base(), 0, {0, 0.5}).upper, {1, 0}));
    const OrientedBox turned = oriented_box(line({0, 0}, {3, 4}), 1e-9);
    EXPECT(near(turned.center, {1.5, 2}, 1e-8) && near(turned.half, {2.5, 0}, 1e-8));
    EXPECT(near({std::abs(turned.axes[0]), std::abs(turned.axes[1])}, {0.6, 0.8}, 1e-8));
    const DirectionCone tangents = tangent_cone(base(), 0, 1e-3);
    EXPECT(near(tangents.direction, {1, 0}) && near({tangents.angle}, {0}, 1e-6));
    const DirectionCone normals = normal_cone(floor_plane(), 1e-3);
    EXPECT(near(normals.direction, {0, 0, 1}) && near({normals.angle}, {0}, 1e-6));
    const Rays first = rays(floor_plane(), {0.5, 1, 3, 9, 9, 9}, {0, 0, -1, 0, 0, -1});
    EXPECT(near({first.params[0], first.params[1], first.distances[0]}, {0.25, 0.25, 3}));
    EXPECT(first.status == (std::vector{ray_hit | ray_certified, ray_certified}));
    const RayHits through = ray_hits(sphere({}, 2), {0.5, 0.25, 5}, {0, 0, -1});
    EXPECT(near({through.distances[0] + through.distances[1]}, {10}) && through.complete);
    const SurfaceHits pierced = surface_intersections(line({0.5, 1, 3}, {0.5, 1, -1}), floor_plane());
    EXPECT(near(pierced.params_curve, {0.75}) && near(pierced.params_surface, {0.25, 0.25}) &&
           pierced.complete);
    EXPECT(pierced.kinds == std::vector{hit_crossing} && pierced.ranges_surface.size() == 4);
    const Meet meet = Meet::sections(sphere({}, 2), {0, 0, 2}, {2, 0, 5}, 1e-6), same = meet;
    const MeetCounts counts = same.counts();
    EXPECT(counts.branches == 2 && counts.nodes == 4 && counts.complete);
    const MeetBranches circles = meet.branches();
    EXPECT(circles.levels == (std::vector<std::int64_t>{0, 1}) && circles.loops == circles.levels);
    EXPECT(circles.end_nodes.size() == 4 && circles.deviations[0] <= 1e-6);
    const MeetNodes seams = meet.nodes();
    EXPECT(seams.kinds == std::vector(4, node_seam) && seams.ranges.size() == 16);
    const std::pair<Spline, Spline> equator = meet.branch(1);
    EXPECT(near({length(equator.first).value}, {4 * pi}, 1e-4) && equator.second.dimension() == 2);
    EXPECT(status_of([&] { (void)meet.branch(2); }) == Status::index);
    const ExtremePoint top = extreme_point(circle({}, 2), {0, 1}, 1e-9);
    EXPECT(near(top.params, {0.25}, 1e-4) && near({top.value, top.bound}, {2, 2}, 1e-8) && top.bound >= 2);
    EXPECT(status_of([] { (void)extreme_point(base(), {0, 0}, 0); }) == Status::direction);
}

static void curve_shapes() {
    const Spline bend = Spline::create_bezier({3}, 2, {0, 0, 1, 2, 2, -2, 3, 0});
    const CurveFeatures found = features(bend, feature_inflection);
    EXPECT(near(found.params, {0.5}) && found.found == std::vector{feature_inflection} && found.complete);
    const CurveFeatures kink = features(polyline(2, {0, 0, 1, 0, 1, 1}), feature_kink | feature_cusp);
    EXPECT(near(kink.params, {1}) && kink.found == std::vector{feature_kink});
    EXPECT(near(kink.values, {pi / 2}));
    const Extrema tops =
        extrema(Spline::create_bezier({1, 1}, 1, {0, 1, 1, 0}), extremum_maximum | extremum_saddle);
    EXPECT(near(tops.params, {0, 1, 0.5, 0.5, 1, 0}) && near(tops.values, {1, 0.5, 1}) && tops.complete);
    EXPECT(tops.found == (std::vector{extremum_maximum, extremum_saddle, extremum_maximum}));
    const CurvePolyline chain = mesh_curve(circle({}, 1), 1e-2);
    EXPECT(chain.reached && chain.bound <= 1e-2 && chain.points.size() == 2 * chain.params.size());
    MeshOptions limits;
    limits.chord = 1e-2;
    limits.relative_chord = 0;
    const Mesh ball = Mesh::of_surface(sphere({}, 1), limits), same_ball = ball;
    const MeshCounts held = same_ball.counts();
    const MeshBound far = ball.bound();
    EXPECT(held.faces == 1 && held.triangles == 2 * held.points - 4 && held.vertices > held.points);
    EXPECT(far.reached && far.from_shape <= 1e-2 && far.from_mesh <= 1e-2);
    const MeshVertices corners = ball.vertices();
    EXPECT(std::cmp_equal(3 * corners.points.size(), corners.normals.size()));
    EXPECT(status_of([&] { (void)ball.triangles(1); }) == Status::flags);
    const MeshQuads pairs = ball.quads();
    EXPECT(!pairs.triangles.empty() && pairs.corners.size() == 4 * pairs.triangles.size());
    MeshOptions turns = limits;
    turns.angle = 0.1;
    EXPECT(Mesh(Mesh::of_surface(sphere({}, 1), turns)).counts().triangles > held.triangles);
    const std::vector<Mesh> levels = mesh_levels(sphere({}, 1), {1e-1, 1e-2});
    EXPECT(levels.size() == 2 && levels[0].counts().triangles < held.triangles &&
           levels[1].counts().triangles == held.triangles);
    EXPECT(status_of([] { (void)mesh_levels(sphere({}, 1), {1e-1, 0}); }) == Status::tolerance);
    MeshOptions fat = limits;
    fat.minimum_angle = 0.4;
    EXPECT(Mesh(Mesh::of_surface(sphere({}, 1), fat)).bound().reached);
    const Spline block = extrude(floor_plane(), {0, 0, 1});
    const Mesh cells = Mesh::of_volume(block, limits, 5);
    const MeshHexahedra boxes = cells.hexahedra();
    EXPECT(boxes.corners.size() == 8 && cells.counts().points == 8 &&
           near(boxes.domains, {0, 1, 0, 1, 0, 1}));
    EXPECT(boxes.folds == std::vector{fold_none} && boxes.signs == std::vector{1} && cells.bound().reached);
    const FoldPieces pieces_of_block = fold_pieces(block);
    EXPECT(pieces_of_block.folds == boxes.folds && pieces_of_block.signs == boxes.signs);
    const BezierCells exact = bezier_cells(circle({}, 1));
    const BezierCellPoints own = bezier_cell_points(circle({}, 1));
    EXPECT(exact.kind == 75 && exact.point_count == 8 && exact.cells.size() == 12 && exact.cells[10] == 0);
    EXPECT(own.points.size() == 16 && own.weights.size() == 8);
    const Hits zeros = roots(Spline::create_bezier({2}, 1, {0.75, -1.25, 0.75}));
    EXPECT(near(zeros.params, {0.25, 0.75}) && zeros.kinds == (std::vector{hit_crossing, hit_crossing}) &&
           zeros.complete);
    const Hits level = curve_level(circle({}, 1), 1, {1, 2, 0});
    EXPECT(level.kinds == (std::vector{hit_crossing, hit_crossing}) && level.complete);
    EXPECT(self_intersections(circle({}, 1)).complete);
    const PairHits meets = curve_intersections(line({0, 0}, {1, 1}), line({0, 1}, {1, 0}));
    EXPECT(near(meets.params_a, {0.5}) && near(meets.params_b, {0.5}) && meets.complete);
    const MonotonePieces pieces = monotone_pieces(circle({}, 1), {1, 0});
    EXPECT(near(pieces.starts, {0, 0.5}) && pieces.signs == (std::vector{-1, 1}) && pieces.complete);
    EXPECT(convexity(circle({}, 1)) == convexity_left && convexity(base()) == convexity_straight);
    const Straightness straight = straightness(base());
    EXPECT(near(straight.direction, {1, 0}) && near({straight.bound, straight.origin[1]}, {0, 0}));
    const Planarity flat = planarity(circle({.origin = {0, 0, 1}}, 1));
    EXPECT(near({flat.normal.begin(), flat.normal.end()}, {0, 0, 1}));
    EXPECT(near({flat.bound, flat.origin[2]}, {0, 1}));
}

static void surface_shapes() {
    const BoundaryContacts contacts = boundary_contacts(sphere({}, 1), 1e-9);
    EXPECT((contacts.closed == std::vector{1, 0}) && (contacts.collapsed == std::vector{0, 0, 1, 1}));
    EXPECT(near({contacts.gaps[0], contacts.sizes[2], contacts.sizes[3]}, {0, 0, 0}));
    const SingularPoints cusp =
        singular_points(Spline::create_bezier({3}, 2, {3, -1, -1, 1, -1, -1, 3, 1}), 1e-3);
    EXPECT(near(cusp.params, {0.5}, 1e-3) && cusp.boxes.size() == 2 && cusp.complete);
    EXPECT(singular_points(base(), 1e-3).params.empty());
    EXPECT(fold_test(bilinear(2, {0, 0, 0, 1, 1, 0, 1, 1})).result == fold_none);
    const Fold crossed = fold_test(bilinear(2, {0, 0, 0, 1, 1, 1, 1, 0}));
    EXPECT(crossed.result == fold_found && std::isfinite(crossed.positive[0]));
    EXPECT(std::isfinite(crossed.negative[1]));
    EXPECT(fold_test(floor_plane(), {0, 0, 1}).result == fold_none);
}

int main() {
    closest();
    all_points();
    distances();
    measures();
    contents();
    boxes();
    curve_shapes();
    surface_shapes();
    return failures == 0 ? 0 : 1;
}
