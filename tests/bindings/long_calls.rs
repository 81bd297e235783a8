// SPDX-License-Identifier: MIT
//! Long calls of the Rust crate: progress, panics of the callback, limits of work, and the answers of each.

use nurbs::{sys, Bend, Call, ConstrainOptions, Constraints, List, Placement, Result, Search, Spline};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// A curve that runs to and fro, so that its length takes a while.
fn winding(count: usize) -> Result<Spline> {
    let knots = nurbs::knots_open_uniform(3, count, 0.0, 1.0)?;
    let points: Vec<f64> =
        (0..count).flat_map(|i| [((i * i) as f64).sin(), ((3 * i * i) as f64).cos()]).collect();
    Spline::create(&[3], &[count], &knots, 2, &points, None, 0)
}

fn progress(curve: &Spline) -> Result<()> {
    let alone = curve.length(1e-9, &[])?;
    let (mut last, mut calls) = (0.0, 0);
    let mut call = Call::new().progress(|done| {
        assert!(done >= last && done <= 1.0);
        last = done;
        calls += 1;
        true
    });
    assert_eq!(curve.length_with(1e-9, &[], &mut call)?, alone);
    drop(call);
    assert!(calls > 0);
    Ok(())
}

fn ends(curve: &Spline) {
    let mut call = Call::new().progress(|_| false);
    assert_eq!(curve.length_with(1e-9, &[], &mut call).unwrap_err().status, sys::NURBS_ERROR_CANCELLED);
    let mut call = Call::new().progress(|_| panic!("own"));
    let panic = catch_unwind(AssertUnwindSafe(|| curve.length_with(1e-9, &[], &mut call))).unwrap_err();
    assert_eq!(panic.downcast_ref::<&str>(), Some(&"own"));
    let mut call = Call::new().work(1);
    assert_eq!(curve.length_with(1e-9, &[], &mut call).unwrap_err().status, sys::NURBS_ERROR_WORK);
    assert!(curve.length(1e-9, &[]).is_ok());
}

fn curves(call: &mut Call) -> Result<()> {
    let g = winding(40)?;
    let map = Spline::bezier(&[1], 1, &[0.0, 1.0], None)?;
    let dot = sys::NURBS_PRODUCT_DOT;
    assert_eq!(g.product_with(&g, dot, call)?.points()?, g.product(&g, dot)?.points()?);
    assert_eq!(g.compose_with(&map, call)?.points()?, g.compose(&map)?.points()?);
    assert_eq!(g.reduce_knots_with(0, 0.1, call)?.bound, g.reduce_knots(0, 0.1)?.bound);
    assert_eq!(g.reduce_degree_with(0, 1, call)?.bound, g.reduce_degree(0, 1)?.bound);
    assert_eq!(g.simplify_with(0.1, call)?.bound, g.simplify(0.1)?.bound);
    let kinds = sys::NURBS_FEATURE_INFLECTION;
    assert_eq!(g.features_with(kinds, call)?, g.features(kinds)?);
    assert_eq!(g.lengths_with(&[0.3, 0.7], 0.0, call)?, g.lengths(&[0.3, 0.7], 0.0)?);
    assert_eq!(
        g.params_at_lengths_with(&[0.3, 0.7], 0.0, 0, call)?,
        g.params_at_lengths(&[0.3, 0.7], 0.0, 0)?
    );
    assert_eq!(g.divide_with(5, 0.0, 0, &[], call)?, g.divide(5, 0.0, 0, &[])?);
    assert_eq!(g.moments_with(1e-6, call)?, g.moments(1e-6)?);
    assert_eq!(g.fair_with(2, 0.1, &[], call)?.bound, g.fair(2, 0.1, &[])?.bound);
    let wanted = Constraints { params: &[0.5], targets: &[1.0, 2.0], ..Default::default() };
    let options = ConstrainOptions::default();
    assert_eq!(g.constrain_with(wanted, options, call)?.moved, g.constrain(wanted, options)?.moved);
    let how = Bend {
        origin: &[0.0, 0.0],
        along: &[1.0, 0.0],
        across: &[0.0, 1.0],
        curvature: 0.1,
        ..Default::default()
    };
    assert_eq!(g.bend_with(how, 1e-3, call)?.deviation, g.bend(how, 1e-3)?.deviation);
    Ok(())
}

fn places(call: &mut Call) -> Result<()> {
    let g = winding(40)?;
    let other = g.transform(2, &[1.0, 0.0, 0.0, 1.0], Some(&[3.0, 0.0]))?;
    let (points, guesses, how) = ([0.3, 0.7, -0.2, 0.5], [0.2, 0.8], Search::default());
    assert_eq!(g.closest_points_with(&points, how, call)?, g.closest_points(&points, how)?);
    assert_eq!(g.farthest_points_with(&points, how, call)?, g.farthest_points(&points, how)?);
    assert_eq!(g.closest_local_with(&points, &guesses, 0, call)?, g.closest_local(&points, &guesses, 0)?);
    assert_eq!(g.signed_distances_with(&points, how, call)?, g.signed_distances(&points, how)?);
    assert_eq!(g.closest_all_with(&points[..2], how, call)?, g.closest_all(&points[..2], how)?);
    assert_eq!(g.critical_points_with(&points[..2], how, call)?, g.critical_points(&points[..2], how)?);
    assert_eq!(g.distance_with(&other, 0.0, 0, call)?, g.distance(&other, 0.0, 0)?);
    assert_eq!(g.hausdorff_distance_with(&other, 0.1, 0, call)?, g.hausdorff_distance(&other, 0.1, 0)?);
    Ok(())
}

fn shapes(call: &mut Call) -> Result<()> {
    let corners = [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 1.0];
    let sheet = Spline::bezier(&[1, 1], 2, &corners, None)?;
    let ball = Spline::sphere(Placement::default(), 1.0, 0)?;
    let ring = Spline::circle(Placement { origin: &[0.0, 0.0], ..Default::default() }, 1.0, 0)?;
    assert_eq!(ball.area_with(1e-6, &[], call)?, ball.area(1e-6, &[])?);
    assert_eq!(
        nurbs::enclosed_area_with(&[&ring], 0.0, 0.0, call)?,
        nurbs::enclosed_area(&[&ring], 0.0, 0.0)?
    );
    assert_eq!(nurbs::enclosed_volume_with(&[&ball], 0.0, call)?, nurbs::enclosed_volume(&[&ball], 0.0)?);
    assert_eq!(ball.recognize_with(1e-6, call)?, ball.recognize(1e-6)?);
    assert_eq!(sheet.fold_test_with(&[], call)?.result, sheet.fold_test(&[])?.result);
    let (lower, upper) = ([0.0, 0.0], [1.0, 1.0]);
    assert_eq!(
        sheet.free_form_deform_with(&sheet, &lower, &upper, 1e-6, call)?.deviation,
        sheet.free_form_deform(&sheet, &lower, &upper, 1e-6)?.deviation
    );
    Ok(())
}

fn files(call: &mut Call) {
    assert_eq!(List::read_with(b"none", None, call).unwrap_err().status, sys::NURBS_ERROR_FORMAT);
    assert_eq!(List::read_file_with("none", None, call).unwrap_err().status, sys::NURBS_ERROR_FILE);
}

fn main() -> Result<()> {
    std::panic::set_hook(Box::new(|_| ())); // one is wanted
    let curve = winding(200_000)?;
    progress(&curve)?;
    ends(&curve);
    let _ = std::panic::take_hook();
    let mut call = Call::new().progress(|_| true);
    curves(&mut call)?;
    places(&mut call)?;
    shapes(&mut call)?;
    files(&mut call);
    Ok(())
}
