// SPDX-License-Identifier: MIT
//! Distances, measures, boxes and features in Rust: one known value of each.

mod common;

use common::{close, near, status_of, QUARTERS};
use nurbs::{enclosed_area, enclosed_volume, sys};
use nurbs::{ClosestPointsMut, Meet, Mesh, MeshOptions, Placement, Records, Result, Search, Spline, Turn};
use std::f64::consts::PI;

const CERTIFIED: i32 = sys::NURBS_CLOSEST_CERTIFIED;

/// Along x from 0 to 2, in the plane.
fn base() -> Result<Spline> {
    Spline::line(&[0., 0.], &[2., 0.])
}

/// Closed, with its middle at the origin and sides of 2.
fn square() -> Result<Spline> {
    Spline::polyline(2, &[-1., -1., 1., -1., 1., 1., -1., 1., -1., -1.], None)
}

fn circle(radius: f64) -> Result<Spline> {
    Spline::circle(Placement::default(), radius, QUARTERS)
}

fn sphere(radius: f64) -> Result<Spline> {
    Spline::sphere(Placement::at(&[1., 2., 3.]), radius, QUARTERS)
}

fn floor_plane() -> Result<Spline> {
    Spline::plane(&[0.; 3], &[2., 0., 0.], &[0., 4., 0.])
}

fn within(tolerance: f64) -> Search<'static> {
    Search { tolerance, ..Search::default() }
}

fn closest() -> Result<()> {
    let found = base()?.closest_points(&[0.5, 1., 3., 0.], Search::default())?;
    assert!(near(&found.params, &[0.25, 1.]) && near(&found.points, &[0.5, 0., 2., 0.]));
    assert!(near(&found.distances, &[1., 1.]));
    assert_eq!(found.status, [CERTIFIED, CERTIFIED | sys::NURBS_CLOSEST_BOUNDARY]);
    let part = Search { range: &[0.5, 1.], ..Search::default() };
    assert!(near(&base()?.closest_points(&[0.5, 1.], part)?.params, &[0.5]));
    let (columns, mut distances) = ([0.5, 1., 1., 2.], [0.; 2]);
    let out = ClosestPointsMut { distances: Some((&mut distances).into()), ..ClosestPointsMut::default() };
    base()?.closest_points_into(Records::strided(&columns, 2, 1, 2), out, Search::default())?;
    assert!(near(&distances, &[1., 2.]));
    assert!(near(&floor_plane()?.closest_points(&[0.5, 1., 3.], Search::default())?.params, &[0.25; 2]));
    assert!(near(&base()?.farthest_points(&[0.5, 1.], Search::default())?.params, &[1.]));
    let local = square()?.closest_local(&[0., 0.5, 0., 0.5], &[0.3, 2.3], 0)?;
    assert!(near(&local.points, &[0., -1., 0., 1.]));
    let odd = Search { flags: sys::NURBS_NAN_POINTS, ..Search::default() };
    let odd = base()?.closest_points(&[f64::NAN, 0.], odd)?;
    assert!(odd.status == [sys::NURBS_CLOSEST_INVALID] && odd.distances[0].is_nan());
    let invalid = base()?.closest_points(&[f64::NAN, 0.], Search::default());
    assert_eq!(status_of(invalid), sys::NURBS_ERROR_POINT_NOT_FINITE);
    assert_eq!(status_of(base()?.closest_points(&[1.; 3], Search::default())), sys::NURBS_ERROR_SIZE);
    assert_eq!(status_of(base()?.closest_points(&[1.; 2], within(-1.))), sys::NURBS_ERROR_TOLERANCE);
    Ok(())
}

fn all_points() -> Result<()> {
    let sides = square()?.closest_all(&[0., 0.], within(1e-9))?;
    assert!(near(&sides.params, &[0.5, 1.5, 2.5, 3.5]) && near(&sides.distances, &[1.; 4]));
    assert!(sides.status & CERTIFIED != 0);
    let found = base()?.critical_points(&[0.5, 1.], within(1e-9))?;
    assert!(near(&found.params, &[0., 0.25, 1.]));
    assert!(near(&found.distances, &[1.25f64.sqrt(), 1., 3.25f64.sqrt()]));
    let (low, high) = (sys::NURBS_CRITICAL_MINIMUM, sys::NURBS_CRITICAL_MAXIMUM);
    assert_eq!(found.kinds, [high, low, high]);
    let sided = base()?.signed_distances(&[1., 1., 0.5, -2.], Search::default())?;
    assert!(near(&sided.distances, &[1., -2.]) && near(&sided.params, &[0.5, 0.25]));
    assert_eq!(sided.status, [CERTIFIED; 2]);
    Ok(())
}

fn distances() -> Result<()> {
    let (a, b) = (Spline::line(&[0.; 3], &[2., 0., 0.])?, Spline::line(&[1., -1., 1.], &[1.; 3])?);
    let found = a.distance(&b, 1e-9, 0)?;
    assert!(found.at_least <= 1. && close(&[found.at_least, found.at_most], &[1.; 2], 1e-8));
    assert!(found.params.iter().all(|at| close(at, &[0.5], 1e-4)) && found.status == CERTIFIED);
    let both = base()?.hausdorff_distance(&Spline::line(&[0., 1.], &[1., 1.])?, 1e-9, 0)?;
    let exact = [2f64.sqrt(), 1.];
    assert!(close(&both.at_least, &exact, 1e-8) && close(&both.at_most, &exact, 1e-8));
    assert!(close(&both.params[0], &[1.], 1e-4) && both.params[1].len() == 1);
    assert_eq!(status_of(a.distance(&base()?, 0., 0)), sys::NURBS_ERROR_INCOMPATIBLE);
    Ok(())
}

fn measures() -> Result<()> {
    let length = circle(2.)?.length(0., &[])?;
    assert!(near(&[length.value], &[4. * PI]) && length.error <= 1e-10);
    assert!(close(&[circle(1.)?.length(1e-9, &[0., 0.25])?.value], &[PI / 2.], 1e-8));
    assert!(near(&base()?.lengths(&[0.5, 1.], 0.)?, &[1., 2.]));
    assert!(near(&base()?.params_at_lengths(&[0., 1.], 0., 0)?, &[0., 0.5]));
    assert!(near(&base()?.params_at_lengths(&[5.], 0., sys::NURBS_CLAMP)?, &[1.]));
    assert_eq!(status_of(base()?.params_at_lengths(&[5.], 0., 0)), sys::NURBS_ERROR_LENGTH);
    let quarters = circle(1.)?.divide(4, 0., 0, &[])?;
    assert!(near(&quarters.params, &[0., 0.25, 0.5, 0.75, 1.]) && near(&[quarters.size], &[PI / 2.]));
    let chords = circle(1.)?.divide(4, 0., sys::NURBS_EQUAL_CHORDS, &[])?;
    assert!(near(&[chords.size], &[2f64.sqrt()]));
    assert!(close(&[sphere(2.)?.area(0., &[])?.value], &[16. * PI], 1e-11));
    assert!(near(&[floor_plane()?.area(0., &[0., 0.5, 0., 0.25])?.value], &[1.]));
    let wire = base()?.moments(0.)?;
    assert!(near(&[wire.content], &[2.]) && near(&wire.centroid, &[1., 0.]));
    assert!(near(&wire.inertia, &[0., 0., 0., 2. / 3.]));
    let disc = enclosed_area(&[&Spline::circle(Placement::at(&[1.; 2]), 2., QUARTERS)?], 0., 0.)?;
    assert!(near(&[disc.area], &[4. * PI]) && near(&disc.centroid, &[1.; 2]));
    assert!(close(&disc.inertia[1], &[0., 4. * PI], 1e-11));
    let ball = enclosed_volume(&[&sphere(1.)?], 0.)?;
    assert!(close(&[ball.volume, ball.openness], &[4. * PI / 3., 0.], 1e-11));
    assert!(close(&ball.centroid, &[1., 2., 3.], 1e-11));
    assert!(close(&ball.inertia[2], &[0., 0., 8. * PI / 15.], 1e-10));
    assert_eq!(status_of(enclosed_area(&[&base()?], 0., 0.)), sys::NURBS_ERROR_GAP);
    let eight = Spline::polyline(2, &[0., 0., 2., 2., 2., 0., 0., 2., 0., 0.], None)?;
    let nothing = enclosed_area(&[&eight], 0., 0.)?;
    assert!(nothing.area == 0. && nothing.centroid[0].is_nan() && nothing.inertia[1][1].is_nan());
    assert_eq!(Spline::line(&[1., 1.], &[1., 1.])?.moments(0.)?.content, 0.);
    Ok(())
}

fn boxes() -> Result<()> {
    let tight = circle(1.)?.bounding_box(1e-9, &[])?;
    assert!(close(&tight.lower, &[-1.; 2], 1e-8) && close(&tight.upper, &[1.; 2], 1e-8) && tight.gap <= 1e-8);
    assert!(near(&circle(1.)?.bounding_box(f64::INFINITY, &[])?.upper, &[1.; 2]));
    assert!(near(&base()?.bounding_box(0., &[0., 0.5])?.upper, &[1., 0.]));
    let turned = Spline::line(&[0., 0.], &[3., 4.])?.oriented_box(1e-9)?;
    assert!(close(&turned.center, &[1.5, 2.], 1e-8) && close(&turned.half, &[2.5, 0.], 1e-8));
    assert!(close(&[turned.axes[0].abs(), turned.axes[1].abs()], &[0.6, 0.8], 1e-8));
    let tangents = base()?.tangent_cone(0, 1e-3, &[])?;
    assert!(near(&tangents.direction, &[1., 0.]) && tangents.angle <= 1e-6);
    let normals = floor_plane()?.normal_cone(1e-3, &[])?;
    assert!(near(&normals.direction, &[0., 0., 1.]) && normals.angle <= 1e-6);
    let first = floor_plane()?.rays(&[0.5, 1., 3., 9., 9., 9.], &[0., 0., -1., 0., 0., -1.])?;
    assert!(near(&first.params[0], &[0.25, 0.25]) && near(&first.distances[..1], &[3.]));
    assert_eq!(first.status, [sys::NURBS_RAY_HIT | sys::NURBS_RAY_CERTIFIED, sys::NURBS_RAY_CERTIFIED]);
    let through = floor_plane()?.ray_hits(&[0.5, 1., 3.], &[0., 0., -1.], &[])?;
    assert!(near(&through.distances, &[3.]) && through.complete);
    let pierced = Spline::line(&[0.5, 1., 3.], &[0.5, 1., -1.])?.surface_intersections(&floor_plane()?, 0.)?;
    assert!(pierced.complete && near(&pierced.params_curve, &[0.75]) && near(&pierced.params_surface[0], &[0.25; 2]));
    let meet = Meet::sections(&floor_plane()?, &[1., 0., 0.], &[0.5, 1.], 1e-9)?.clone();
    let counts = meet.counts()?;
    assert!(counts.branches == 2 && counts.nodes == 4 && counts.complete);
    let lines = meet.branches()?;
    assert!(lines.levels == [0, 1] && lines.loops == [-1, -1] && lines.deviations[0] <= 1e-9);
    let borders = meet.nodes()?;
    assert_eq!(borders.kinds, [sys::NURBS_NODE_BORDER; 4]);
    let [from, to] = lines.end_nodes[1];
    assert!(near(&borders.params[from as usize], &[0.5, 1.]) && near(&borders.params[to as usize], &[0.5, 0.]));
    let (space, on_surface) = meet.branch(1)?;
    assert!(near(&[space.length(0., &[])?.value], &[4.]) && on_surface.dimension()? == 2);
    assert_eq!(status_of(meet.branch(2)), sys::NURBS_ERROR_INDEX);
    let top = circle(2.)?.extreme_point(&[0., 1.], 1e-9, &[])?;
    assert!(close(&top.params, &[0.25], 1e-4) && close(&[top.value, top.bound], &[2.; 2], 1e-8));
    assert_eq!(status_of(base()?.extreme_point(&[0.; 2], 0., &[])), sys::NURBS_ERROR_DIRECTION);
    Ok(())
}

fn curve_shapes() -> Result<()> {
    let bend = Spline::bezier(&[3], 2, &[0., 0., 1., 2., 2., -2., 3., 0.], None)?;
    let found = bend.features(sys::NURBS_FEATURE_INFLECTION)?;
    assert!(found.complete && found.found.len() == 1 && near(&[found.found[0].param], &[0.5]));
    let corner = Spline::polyline(2, &[0., 0., 1., 0., 1., 1.], None)?;
    let kink = corner.features(sys::NURBS_FEATURE_KINK | sys::NURBS_FEATURE_CUSP)?.found[0];
    assert_eq!(kink.kind, sys::NURBS_FEATURE_KINK);
    assert!(near(&[kink.param, kink.value], &[1., PI / 2.]));
    let tops = Spline::bezier(&[1, 1], 1, &[0., 1., 1., 0.], None)?.extrema(sys::NURBS_EXTREMUM_SADDLE)?;
    assert!(near(&tops.params, &[0.5, 0.5]) && near(&tops.values, &[0.5]) && tops.complete && tops.boxes.len() == 2);
    assert_eq!(tops.found, [sys::NURBS_EXTREMUM_SADDLE]);
    let line = circle(1.)?.mesh_curve(1e-2, 0., 0.)?;
    assert!(line.reached && line.bound <= 1e-2 && line.points.len() == 2 * line.params.len());
    let limits = MeshOptions::new()?.chord(1e-2).relative_chord(0.);
    let floor = Mesh::of_surface(&floor_plane()?, Some(&limits))?.clone();
    let held = floor.counts()?;
    assert!(held.points == 4 && held.triangles == 2 && held.faces == 1 && floor.bound()?.reached);
    assert!(floor.vertices()?.normals.iter().all(|n| near(n, &[0., 0., 1.])));
    assert_eq!(floor.triangles(sys::NURBS_MESH_WELDED)?.len(), 2);
    assert_eq!(status_of(floor.triangles(1)), sys::NURBS_ERROR_FLAGS);
    let pairs = floor.quads(0)?;
    assert!(pairs.corners.len() == 1 && pairs.triangles == [0]);
    assert_eq!(status_of(Mesh::of_surface(&floor_plane()?, Some(&limits.angle(4.)))), sys::NURBS_ERROR_ANGLE);
    let mut call = nurbs::Call::new();
    let levels = Mesh::of_surface_levels_with(&floor_plane()?, &[1e-1, 1e-3], Some(&limits), &mut call)?;
    assert!(levels.len() == 2 && levels[1].counts()?.triangles == 2);
    assert_eq!(status_of(Mesh::of_surface_levels(&floor_plane()?, &[1., -1.], None)), sys::NURBS_ERROR_TOLERANCE);
    assert_eq!(
        status_of(Mesh::of_surface(&floor_plane()?, Some(&limits.minimum_angle(0.6)))),
        sys::NURBS_ERROR_ANGLE
    );
    let block = floor_plane()?.extrude(&[0., 0., 1.])?;
    let cells = Mesh::of_volume(&block, Some(&limits), 5)?;
    let boxes = cells.hexahedra()?;
    assert!(boxes.corners.len() == 1 && cells.counts()?.points == 8 && boxes.domains == [[0., 1.]; 3]);
    assert!(boxes.folds == [sys::NURBS_FOLD_NONE] && boxes.signs == [1] && cells.bound()?.reached);
    let pieces = block.fold_pieces(&[])?;
    assert!(pieces.folds == boxes.folds && pieces.signs == boxes.signs);
    let exact = circle(1.)?.bezier_cells()?;
    let own = circle(1.)?.bezier_cell_points()?;
    assert!(exact.kind == 75 && exact.point_count == 8 && exact.cells.len() == 12 && exact.cells[10] == 0);
    assert!(own.points.len() == 16 && own.weights.len() == 8);
    let zeros = Spline::bezier(&[2], 1, &[0.75, -1.25, 0.75], None)?.roots(0., 0.)?;
    assert!(near(&zeros.params, &[0.25, 0.75]) && zeros.complete && zeros.ranges.len() == 2);
    assert_eq!(circle(1.)?.curve_level(1, &[1., 2., 0.], 0.)?.kinds, [sys::NURBS_HIT_CROSSING; 2]);
    let own = circle(1.)?.self_intersections(0.)?;
    assert!(own.complete && own.kinds.is_empty());
    let meets = circle(1.)?.curve_intersections(&Spline::line(&[0., 0.5], &[2., 0.5])?, 0.)?;
    assert!(meets.complete && meets.kinds == [sys::NURBS_HIT_CROSSING] && near(&meets.params_b, &[0.75_f64.sqrt() / 2.]));
    let ways = circle(1.)?.monotone_pieces(&[1., 0.])?;
    let (starts, signs): (Vec<f64>, Vec<i32>) = ways.pieces.into_iter().unzip();
    assert!(near(&starts, &[0., 0.5]) && signs == [-1, 1] && ways.complete);
    assert_eq!(circle(1.)?.convexity()?, sys::NURBS_CONVEXITY_LEFT);
    assert_eq!(base()?.convexity()?, sys::NURBS_CONVEXITY_STRAIGHT);
    let straight = base()?.straightness()?;
    assert!(near(&straight.direction, &[1., 0.]) && near(&[straight.bound, straight.origin[1]], &[0.; 2]));
    let flat = Spline::circle(Placement::at(&[0., 0., 1.]), 1., QUARTERS)?.planarity()?;
    assert!(near(&flat.normal, &[0., 0., 1.]) && near(&[flat.bound, flat.origin[2]], &[0., 1.]));
    Ok(())
}

fn surface_shapes() -> Result<()> {
    let contacts = sphere(1.)?.boundary_contacts(1e-9)?;
    assert!(contacts.closed == [true, false] && contacts.collapsed == [false, false, true, true]);
    assert!(near(&[contacts.gaps[0], contacts.sizes[2], contacts.sizes[3]], &[0.; 3]));
    let half = Spline::cylinder(Placement::default(), 1., 1., Turn::new(0., PI), QUARTERS)?;
    assert_eq!(half.boundary_contacts(1e-9)?.closed, [false, false]);
    let cusp = Spline::bezier(&[3], 2, &[3., -1., -1., 1., -1., -1., 3., 1.], None)?.singular_points(1e-3)?;
    assert!(cusp.complete && close(&cusp.params, &[0.5], 1e-3) && cusp.boxes.len() == 1);
    assert!(cusp.boxes[0][0] <= 0.5 && 0.5 <= cusp.boxes[0][1]);
    assert!(base()?.singular_points(1e-3)?.params.is_empty());
    let flat = Spline::bilinear(2, &[0., 0., 0., 1., 1., 0., 1., 1.])?;
    assert_eq!(flat.fold_test(&[])?.result, sys::NURBS_FOLD_NONE);
    let crossed = Spline::bilinear(2, &[0., 0., 0., 1., 1., 1., 1., 0.])?.fold_test(&[])?;
    assert_eq!(crossed.result, sys::NURBS_FOLD_FOUND);
    assert!(crossed.positive.iter().chain(&crossed.negative).all(|x| x.is_finite()));
    assert_eq!(floor_plane()?.fold_test(&[0., 0., 1.])?.result, sys::NURBS_FOLD_NONE);
    Ok(())
}

fn main() -> Result<()> {
    closest()?;
    all_points()?;
    distances()?;
    measures()?;
    boxes()?;
    curve_shapes()?;
    surface_shapes()
}
