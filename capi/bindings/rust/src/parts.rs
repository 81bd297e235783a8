// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Splines taken apart into lists, and joined again.

use crate::error::{check, Result};
use crate::list::List;
use crate::spline::{handles, Spline};
use crate::sys;
use std::ptr::null_mut;

/// The joined spline, and the largest distance of two ends.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Joined {
    /// The joined spline.
    pub spline: Spline,
    /// The largest distance of two ends.
    pub gap: f64,
}

/// The polynomial pieces of a spline as arrays, last axis fastest in pieces and control points.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BezierPieces {
    /// Control points of each piece.
    pub points: Vec<f64>,
    /// Their weights.
    pub weights: Vec<f64>,
    /// The ends of the domain of each piece along each axis.
    pub domains: Vec<[f64; 2]>,
    /// The number of pieces along each axis.
    pub piece_counts: Vec<i64>,
}

/// Splines joined end to end along an axis.
pub fn join(parts: &[&Spline], axis: i32, tolerance: f64, flags: u32) -> Result<Joined> {
    let parts = handles(parts);
    let mut gap = 0.0;
    let spline = Spline::made(|out| unsafe {
        sys::nurbs_join(parts.len() as i64, parts.as_ptr(), axis, tolerance, flags, &mut gap, out)
    })?;
    Ok(Joined { spline, gap })
}

/// Splines taken apart into lists, and joined again.
impl Spline {
    /// The polynomial pieces as Bezier splines over their own domains, last axis fastest.
    pub fn decompose(&self) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_decompose(self.raw(), out) })
    }

    /// The polynomial pieces as arrays: the control points, weights and domains of all in one call.
    pub fn bezier_pieces(&self) -> Result<BezierPieces> {
        let axes = self.axes()? as usize;
        let mut piece_counts = vec![0; axes];
        let mut fill = |cap, points, weights, domains, count| unsafe {
            sys::nurbs_bezier_pieces(
                self.raw(),
                cap,
                points,
                weights,
                domains,
                piece_counts.as_mut_ptr(),
                count,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let active = self.active()?;
        let mut points = vec![0.0; n * active * self.dimension()? as usize];
        let mut weights = vec![0.0; n * active];
        let mut domains = vec![[0.0; 2]; n * axes];
        check(fill(
            count,
            points.as_mut_ptr(),
            weights.as_mut_ptr(),
            domains.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(BezierPieces { points, weights, domains, piece_counts })
    }

    /// The parts between the knots at which the order of continuity is less than `order`.
    pub fn split_at_knots(&self, axis: i32, order: i32) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_split_at_knots(self.raw(), axis, order, out) })
    }
}
