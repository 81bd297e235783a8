// SPDX-License-Identifier: MIT
//! Refinement, splines taken apart, and splines joined.

use crate::error::{value, Error, Result};
use crate::linear::{sparse, SparseMatrix};
use crate::list::List;
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// The joined spline, and the largest distance of two ends.
#[derive(Debug)]
#[non_exhaustive]
pub struct Joined {
    /// The joined spline.
    pub spline: Spline,
    /// The largest distance of two ends.
    pub gap: f64,
}

/// Splines joined end to end along an axis.
pub fn join(parts: &[&Spline], axis: i32, tolerance: f64, flags: u32) -> Result<Joined> {
    let handles: Vec<*const sys::nurbs> = parts.iter().map(|part| part.raw()).collect();
    let (count, first) = (handles.len() as i64, handles.as_ptr());
    let mut gap = 0.0;
    let spline =
        Spline::made(|out| unsafe { sys::nurbs_join(count, first, axis, tolerance, flags, &mut gap, out) })?;
    Ok(Joined { spline, gap })
}

/// Exact refinement and parts.
impl Spline {
    /// The same shape with a list of knots inserted, in any order.
    pub fn refine(&self, axis: i32, knots: &[f64]) -> Result<Spline> {
        let (count, first) = (knots.len() as i64, knots.as_ptr());
        Spline::made(|out| unsafe { sys::nurbs_refine(self.raw(), axis, count, first, out) })
    }
    /// The same shape with every non-empty span divided into equal parts.
    pub fn refine_uniform(&self, axis: i32, parts: i64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_refine_uniform(self.raw(), axis, parts, out) })
    }
    /// The matrix that `refine` applies along the axis.
    pub fn refinement_matrix(&self, axis: i32, knots: &[f64]) -> Result<SparseMatrix> {
        let (g, count, first) = (self.raw(), knots.len() as i64, knots.as_ptr());
        let layers = value(|v: *mut i64| unsafe { sys::nurbs_count(g, axis, v) })?;
        sparse(layers as usize + knots.len(), |cap, values, columns, rows, entries| unsafe {
            sys::nurbs_refinement_matrix(g, axis, count, first, cap, values, columns, rows, entries)
        })
    }

    /// The parts below and above a parameter.
    pub fn split(&self, axis: i32, param: f64) -> Result<(Spline, Spline)> {
        let mut lower = null_mut();
        let upper =
            Spline::made(|out| unsafe { sys::nurbs_split(self.raw(), axis, param, &mut lower, out) })?;
        let lower = Spline::made(|out| {
            unsafe { *out = lower };
            sys::NURBS_OK
        })?;
        Ok((lower, upper))
    }
    /// The part over a box in the domain: the ends on each axis.
    pub fn extract(&self, lower: &[f64], upper: &[f64]) -> Result<Spline> {
        let axes = self.axes()? as usize;
        for (name, ends) in [("lower", lower), ("upper", upper)] {
            if ends.len() != axes {
                return Err(Error::size(name, ends.len(), axes.to_string()));
            }
        }
        Spline::made(|out| unsafe { sys::nurbs_extract(self.raw(), lower.as_ptr(), upper.as_ptr(), out) })
    }
    /// The polynomial pieces as Bezier splines over their own domains, last axis fastest.
    pub fn decompose(&self) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_decompose(self.raw(), out) })
    }
    /// The parts between the knots at which the order of continuity is less than `order`.
    pub fn split_at_knots(&self, axis: i32, order: i32) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_split_at_knots(self.raw(), axis, order, out) })
    }

    /// The same shape with clamped ends; flags 0 only open a periodic axis.
    pub fn clamp(&self, axis: i32, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_clamp_ends(self.raw(), axis, flags, out) })
    }
    /// The same shape on a periodic axis over [param, param + period].
    pub fn move_seam(&self, axis: i32, param: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_move_seam(self.raw(), axis, param, out) })
    }
}
