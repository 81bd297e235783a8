// SPDX-License-Identifier: MIT
//! Continuity at knots and between ends.

use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// What counts as no gap: a distance, a part of a derivative, an angle.
#[derive(Clone, Copy, Debug, Default)]
pub struct ContinuityTolerances {
    /// Of points.
    pub position: f64,
    /// Of derivatives, relative to their size.
    pub derivative: f64,
    /// Of directions, in radians.
    pub angle: f64,
}

/// How two pieces meet.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct Continuity {
    /// Of the derivatives.
    pub order: i32,
    /// Of the shape.
    pub geometric: i32,
    /// The distance of the points.
    pub position_gap: f64,
    /// The angle between the tangents or normals.
    pub angle: f64,
    /// The difference of the curvatures.
    pub curvature_gap: f64,
}

/// How they meet at a knot, and the order that the knots guarantee.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct KnotContinuity {
    /// A knot inside the domain.
    pub knot: f64,
    /// The order that its multiplicity promises.
    pub knot_order: i32,
    /// What is there.
    pub found: Continuity,
}

/// Continuity of two curves at one end of each.
pub fn continuity_between(
    a: (&Spline, i32),
    b: (&Spline, i32),
    allowed: ContinuityTolerances,
) -> Result<Continuity> {
    let mut r = Continuity::default();
    let t = allowed;
    check(unsafe {
        sys::nurbs_continuity_between(
            a.0.raw(),
            a.1,
            b.0.raw(),
            b.1,
            t.position,
            t.derivative,
            t.angle,
            &mut r.order,
            &mut r.geometric,
            &mut r.position_gap,
            &mut r.angle,
            &mut r.curvature_gap,
        )
    })?;
    Ok(r)
}

impl Spline {
    /// Continuity at the knots of an axis and at its seam.
    pub fn continuity(&self, axis: i32, allowed: ContinuityTolerances) -> Result<Vec<KnotContinuity>> {
        let (g, t) = (self.raw(), allowed);
        let mut n = 0i64;
        let none = null_mut::<i32>();
        let skip = null_mut::<f64>();
        check(unsafe {
            sys::nurbs_continuity(
                g,
                axis,
                t.position,
                t.derivative,
                t.angle,
                0,
                skip,
                none,
                none,
                none,
                skip,
                skip,
                skip,
                &mut n,
            )
        })?;
        let size = n as usize;
        let mut values = vec![vec![0.0f64; size]; 4];
        let mut orders = vec![vec![0i32; size]; 3];
        let v: Vec<*mut f64> = values.iter_mut().map(|x| x.as_mut_ptr()).collect();
        let o: Vec<*mut i32> = orders.iter_mut().map(|x| x.as_mut_ptr()).collect();
        check(unsafe {
            sys::nurbs_continuity(
                g,
                axis,
                t.position,
                t.derivative,
                t.angle,
                n,
                v[0],
                o[0],
                o[1],
                o[2],
                v[1],
                v[2],
                v[3],
                null_mut(),
            )
        })?;
        let row = |i: usize| Continuity {
            order: orders[1][i],
            geometric: orders[2][i],
            position_gap: values[1][i],
            angle: values[2][i],
            curvature_gap: values[3][i],
        };
        Ok((0..size)
            .map(|i| KnotContinuity { knot: values[0][i], knot_order: orders[0][i], found: row(i) })
            .collect())
    }
}
