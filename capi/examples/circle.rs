// SPDX-License-Identifier: MIT
//! A circle is a rational curve: create it, evaluate a batch, insert a knot, and see that the radius did not change.

use nurbs::{Result, Spline};

/// The largest distance of 1000 points of the curve from the unit circle.
fn radius_error(curve: &Spline) -> Result<f64> {
    let params: Vec<f64> = (0..1000).map(|i| f64::from(i) / 999.0).collect();
    let points = curve.eval(&params, 0)?;
    let errors = points.chunks(2).map(|p| (p[0].hypot(p[1]) - 1.0).abs());
    Ok(errors.fold(0.0, f64::max))
}

fn report(curve: &Spline) -> Result<()> {
    println!("{} control points, radius 1 to within {:.1e}", curve.count(0)?, radius_error(curve)?);
    Ok(())
}

fn main() -> Result<()> {
    let s = 0.5f64.sqrt();
    let knots = [0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
    let points = [1., 0., 1., 1., 0., 1., -1., 1., -1., 0., -1., -1., 0., -1., 1., -1., 1., 0.];
    let weights = [1.0, s, 1.0, s, 1.0, s, 1.0, s, 1.0];
    let circle = Spline::create(&[2], &[9], &knots, 2, &points, Some(&weights), 0)?;
    report(&circle)?;
    report(&circle.insert_knot(0, 0.3, 2)?)
}
