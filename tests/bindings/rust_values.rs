// SPDX-License-Identifier: MIT
//! Splines compared by their values, and settings with defaults, in Rust.

mod common;

use common::status_of;
use nurbs::{sys, Bend, List, ReadOptions, Result, Spline};

const POINTS: [f64; 6] = [0., 0., 1., 2., 2., 0.];

fn arch() -> Result<Spline> {
    Spline::bezier(&[2], 2, &POINTS, None)
}

fn with_weights(weights: &[f64]) -> Result<Spline> {
    Spline::bezier(&[2], 2, &POINTS, Some(weights))
}

fn equal_values_are_equal() -> Result<()> {
    assert_eq!(arch()?, arch()?);
    assert_eq!(arch()?, arch()?.clone());
    assert_eq!(with_weights(&[1., 2., 1.])?, with_weights(&[1., 2., 1.])?);
    assert_eq!(arch()?.insert_on_leg(0, 0, 0.5)?, arch()?.insert_on_leg(0, 0, 0.5)?);
    let plain = [0., 0., 1., 1., 0., 0.];
    let projective = || Spline::create_homogeneous(&[1], &[2], &[0., 0., 1., 1.], 2, &plain, 0);
    assert_eq!(projective()?, projective()?);
    Ok(())
}

fn each_value_counts() -> Result<()> {
    let curve = arch()?;
    let knots = [0., 1., 2., 3., 4., 5., 0., 1., 2., 3., 4., 5.];
    let surface = |degrees: [i32; 2], counts: [usize; 2]| {
        Spline::create(&degrees, &counts, &knots, 1, &(0..12).map(f64::from).collect::<Vec<_>>(), None, 0)
    };
    assert_ne!(surface([1, 2], [4, 3])?, surface([2, 1], [3, 4])?); // degrees
    assert_ne!(curve, curve.elevate(0, 1)?);
    assert_ne!(curve, curve.reparametrize(0, 0., 2.)?); // knots
    assert_ne!(curve, curve.with_points(&[0., 0., 1., 2., 2., 1.], None)?); // points
    assert_ne!(curve, Spline::bezier(&[2], 3, &[0., 0., 0., 1., 2., 0., 2., 0., 0.], None)?); // dimension
    assert_ne!(with_weights(&[1., 2., 1.])?, with_weights(&[1., 3., 1.])?); // weights
    assert_ne!(curve, with_weights(&[1.; 3])?); // rational or not
    assert_ne!(curve, Spline::bezier(&[1, 1], 2, &[0., 0., 1., 2., 2., 0., 0., 0.], None)?); // axes
    Ok(())
}

fn homogeneous_points_and_periods_count() -> Result<()> {
    let knots = [0., 0., 1., 1.];
    let cartesian = Spline::create(&[1], &[2], &knots, 1, &[1., 2.], Some(&[1., 1.]), 0)?;
    let homogeneous = |x| Spline::create_homogeneous(&[1], &[2], &knots, 1, &[1., 1., x, 1.], 0);
    assert_ne!(cartesian, homogeneous(2.)?);
    assert_ne!(homogeneous(3.)?, homogeneous(2.)?);
    let loose =
        |flags| Spline::create(&[1], &[4], &[-1., 0., 1., 2., 3., 4.], 1, &[5., 6., 7., 5.], None, flags);
    assert_eq!(loose(sys::NURBS_PERIODIC)?, loose(sys::NURBS_PERIODIC)?);
    assert_ne!(loose(sys::NURBS_PERIODIC)?, loose(0)?);
    Ok(())
}

fn settings_have_defaults() -> Result<()> {
    let rod = Spline::line(&[0., 0.], &[4., 0.])?;
    let how =
        Bend { origin: &[0., 0.], along: &[1., 0.], across: &[0., 1.], curvature: 0.5, ..Bend::default() };
    assert!(how.lower == f64::NEG_INFINITY && how.upper == f64::INFINITY);
    let end = rod.bend(how, 1e-6)?.spline.eval(&[1.], 0)?;
    assert!((end[0] - 2. * 2f64.sin()).abs() < 1e-5);
    let plain = ReadOptions::default();
    assert_eq!(format!("{:?}", plain), format!("{:?}", ReadOptions::new()?));
    assert_eq!(status_of(List::read(b"", Some(&plain))), status_of(List::read(b"", None)));
    Ok(())
}

fn main() -> Result<()> {
    equal_values_are_equal()?;
    each_value_counts()?;
    homogeneous_points_and_periods_count()?;
    settings_have_defaults()
}
