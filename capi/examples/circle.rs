// SPDX-License-Identifier: MIT
//! A circle is a rational curve: its points and tangents, a knot more, the point that is closest to another, its
//! length, and what a bad call says.

use nurbs::{sys, Placement, Result, Search, Spline};

/// The largest of some numbers.
fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, f64::max)
}

fn report<'a>(curve: &Spline, points: impl Iterator<Item = &'a [f64]>) -> Result<()> {
    let error = largest(points.map(|p| (p[0].hypot(p[1]) - 1.0).abs()));
    println!("{} control points, radius 1 to within {:.1e}", curve.count(0)?, error);
    Ok(())
}

fn main() -> Result<()> {
    let circle = Spline::circle(Placement::default(), 1.0, sys::NURBS_ARC_QUARTERS)?;
    let params: Vec<f64> = (0..1000).map(|i| f64::from(i) / 999.0).collect();
    let derivs = circle.eval_derivs(1, &params, 0)?; // x, y and their derivatives
    report(&circle, derivs.chunks(4))?;
    let slant = largest(derivs.chunks(4).map(|c| (c[0] * c[2] + c[1] * c[3]).abs()));
    println!("tangents at right angles to within {:.1e}", slant);
    let finer = circle.insert_knot(0, 0.3, 2)?;
    let after = finer.eval(&params, 0)?;
    report(&finer, after.chunks(2))?;
    let pairs = derivs.chunks(4).zip(after.chunks(2));
    let moved = largest(pairs.map(|(c, q)| (q[0] - c[0]).abs().max((q[1] - c[1]).abs())));
    println!("the points moved by at most {:.1e}", moved);
    let found = circle.closest_points(&[3.0, 4.0], Search::default())?;
    let (x, y, distance) = (found.points[0], found.points[1], found.distances[0]);
    let word =
        if found.status[0] & sys::NURBS_CLOSEST_CERTIFIED != 0 { "certified" } else { "not certified" };
    println!("closest to (3, 4): ({:.6}, {:.6}), distance {:.6}, {}", x, y, distance, word);
    let length = circle.length(0.0, &[])?;
    println!("length {:.12}, error about {:.1e}", length.value, length.error);
    if let Err(error) = circle.eval(&[2.0], 0) {
        println!("a bad call says: {}", error.message);
    }
    Ok(())
}
