// SPDX-License-Identifier: MIT
//! Long calls of the Rust crate: progress, panics of the callback, limits of work, and the answers of each.

use nurbs::{sys, Bend, Call, ConstrainOptions, Constraints, List, Placement, Result, Search, Spline};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};

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

/// A panic of which nothing is printed, so that only those of a failing test are.
fn quiet_panic(text: &'static str) -> bool {
    resume_unwind(Box::new(text))
}

/// A call ends with the panic `text`.
fn panics<T: std::fmt::Debug>(text: &'static str, call: impl FnOnce() -> Result<T>) {
    let panic = catch_unwind(AssertUnwindSafe(call)).expect_err(text);
    assert_eq!(panic.downcast_ref::<&str>(), Some(&text));
}

/// A call ends with the panic of its callback.
fn told_to_panic<T: std::fmt::Debug>(text: &'static str, call: impl FnOnce(&mut Call) -> Result<T>) {
    panics(text, || call(&mut Call::new().progress(|_| quiet_panic(text))));
}

/// A call that its callback ends without a panic returns.
fn only_cancelled(curve: &Spline, call: &mut Call) {
    let ended = curve.length_with(1e-9, &[], call);
    assert_eq!(ended.unwrap_err().status, sys::NURBS_ERROR_CANCELLED);
}

/// Panics come out of the calls that take structs as they do of others, and go no further.
fn panics_of_structs(curve: &Spline) -> Result<()> {
    let (g, points, guesses) = (winding(40)?, vec![0.3; 100_000], vec![0.2; 50_000]);
    let (how, end) = (Search::default(), || Call::new().progress(|_| false));
    told_to_panic("closest", |call| g.closest_points_with(&points, how, call));
    only_cancelled(curve, &mut end());
    told_to_panic("farthest", |call| g.farthest_points_with(&points, how, call));
    only_cancelled(curve, &mut end());
    told_to_panic("local", |call| g.closest_local_with(&points, &guesses, 0, call));
    only_cancelled(curve, &mut end());
    told_to_panic("signed", |call| g.signed_distances_with(&points, how, call));
    only_cancelled(curve, &mut end());
    Ok(())
}

/// A call in a callback has panics of its own: they end the outer call only if the callback lets them through.
fn panics_of_inner_calls(curve: &Spline) -> Result<()> {
    let inner = |call: &mut Call| curve.length_with(1e-9, &[], call);
    let caught = || told_to_panic("caught", inner);
    only_cancelled(
        curve,
        &mut Call::new().progress(|_| {
            caught();
            false
        }),
    );
    let mut first = true;
    let mut goes_on = Call::new().progress(|_| {
        if std::mem::take(&mut first) {
            caught();
        }
        true
    });
    assert_eq!(curve.length_with(1e-9, &[], &mut goes_on)?, curve.length(1e-9, &[])?);
    let through = |_| inner(&mut Call::new().progress(|_| quiet_panic("through both"))).is_ok();
    panics("through both", || curve.length_with(1e-9, &[], &mut Call::new().progress(through)));
    only_cancelled(curve, &mut Call::new().progress(|_| false));
    Ok(())
}

/// The same options serve again after a panic, and a panic of another thread stays there.
fn panics_of_other_calls(curve: &Spline) {
    let mut first = true;
    let mut call = Call::new().progress(|_| {
        if std::mem::take(&mut first) {
            quiet_panic("once");
        }
        false
    });
    panics("once", || curve.length_with(1e-9, &[], &mut call));
    only_cancelled(curve, &mut call);
    let mut elsewhere = Call::new().progress(|_| {
        std::thread::scope(|threads| {
            threads.spawn(|| told_to_panic("of another thread", |call| curve.length_with(1e-9, &[], call)));
        });
        false
    });
    only_cancelled(curve, &mut elsewhere);
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
    panics_of_structs(&curve)?;
    panics_of_inner_calls(&curve)?;
    panics_of_other_calls(&curve);
    let mut call = Call::new().progress(|_| true);
    curves(&mut call)?;
    places(&mut call)?;
    shapes(&mut call)?;
    files(&mut call);
    Ok(())
}
