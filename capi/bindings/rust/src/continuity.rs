// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Continuity at knots and between ends.

use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// What counts as no gap: a distance, a part of a derivative, an angle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContinuityTolerances {
    /// Of points.
    pub position: f64,
    /// Of derivatives, relative to their size.
    pub derivative: f64,
    /// Of directions, in radians.
    pub angle: f64,
}

/// How two pieces meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    let mut order = 0;
    let mut geometric = 0;
    let mut position_gap = 0.0;
    let mut angle = 0.0;
    let mut curvature_gap = 0.0;
    check(unsafe {
        sys::nurbs_continuity_between(
            a.0.raw(),
            a.1,
            b.0.raw(),
            b.1,
            allowed.position,
            allowed.derivative,
            allowed.angle,
            &mut order,
            &mut geometric,
            &mut position_gap,
            &mut angle,
            &mut curvature_gap,
        )
    })?;
    Ok(Continuity { order, geometric, position_gap, angle, curvature_gap })
}

/// Continuity at knots and between ends.
impl Spline {
    /// Continuity at the knots of an axis and at its seam.
    pub fn continuity(&self, axis: i32, allowed: ContinuityTolerances) -> Result<Vec<KnotContinuity>> {
        let fill = |cap,
                    knots,
                    knot_orders,
                    orders,
                    geometric_orders,
                    position_gaps,
                    angles,
                    curvature_gaps,
                    count| unsafe {
            sys::nurbs_continuity(
                self.raw(),
                axis,
                allowed.position,
                allowed.derivative,
                allowed.angle,
                cap,
                knots,
                knot_orders,
                orders,
                geometric_orders,
                position_gaps,
                angles,
                curvature_gaps,
                count,
            )
        };
        let mut count = 0;
        check(fill(
            0,
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            &mut count,
        ))?;
        let n = count as usize;
        let mut knots = vec![0.0; n];
        let mut knot_orders = vec![0; n];
        let mut orders = vec![0; n];
        let mut geometric_orders = vec![0; n];
        let mut position_gaps = vec![0.0; n];
        let mut angles = vec![0.0; n];
        let mut curvature_gaps = vec![0.0; n];
        check(fill(
            count,
            knots.as_mut_ptr(),
            knot_orders.as_mut_ptr(),
            orders.as_mut_ptr(),
            geometric_orders.as_mut_ptr(),
            position_gaps.as_mut_ptr(),
            angles.as_mut_ptr(),
            curvature_gaps.as_mut_ptr(),
            &mut count,
        ))?;
        Ok((0..n)
            .map(|i| KnotContinuity {
                knot: knots[i],
                knot_order: knot_orders[i],
                found: Continuity {
                    order: orders[i],
                    geometric: geometric_orders[i],
                    position_gap: position_gaps[i],
                    angle: angles[i],
                    curvature_gap: curvature_gaps[i],
                },
            })
            .collect())
    }
}
