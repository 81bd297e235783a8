// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Operations that move the shape, each with a proven bound.

use crate::arrays::if_given;
use crate::call::Call;
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

/// A spline, how often a knot was removed, and a bound of the distance to what was given.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct KnotRemoval {
    /// The spline.
    pub spline: Spline,
    /// How often the knot was removed.
    pub removed: i32,
    /// A proven bound of how far it is from the one given.
    pub bound: f64,
}

/// A spline within `bound` of the one it was made from.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reduced {
    /// The spline.
    pub spline: Spline,
    /// A proven bound of how far it is from the one given.
    pub bound: f64,
}

/// Operations that move the shape, each with a proven bound.
impl Spline {
    /// Proven bounds (at least, at most) of the largest distance of two splines over the same domain.
    pub fn deviation(&self, other: &Spline) -> Result<(f64, f64)> {
        let mut at_least = 0.0;
        let mut at_most = 0.0;
        check(unsafe { sys::nurbs_deviation(self.raw(), other.raw(), &mut at_least, &mut at_most) })?;
        Ok((at_least, at_most))
    }

    /// Copies of a knot removed, as many as the tolerance allows.
    pub fn remove_knot(&self, axis: i32, knot: f64, times: i32, tolerance: f64) -> Result<KnotRemoval> {
        let mut removed = 0;
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_remove_knot(self.raw(), axis, knot, times, tolerance, &mut removed, &mut bound, out)
        })?;
        Ok(KnotRemoval { spline, removed, bound })
    }

    /// As few knots as the tolerance allows, on one axis or on every one (-1).
    pub fn reduce_knots(&self, axis: i32, tolerance: f64) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_reduce_knots(self.raw(), axis, tolerance, &mut bound, out)
        })?;
        Ok(Reduced { spline, bound })
    }

    /// The same as `reduce_knots`; it can be watched and stopped.
    pub fn reduce_knots_with(&self, axis: i32, tolerance: f64, call: &mut Call) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_reduce_knots_with(self.raw(), axis, tolerance, &mut bound, call.options(), out)
        })?;
        Ok(Reduced { spline, bound })
    }

    /// The closest spline of lower degree.
    pub fn reduce_degree(&self, axis: i32, times: i32) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_reduce_degree(self.raw(), axis, times, &mut bound, out)
        })?;
        Ok(Reduced { spline, bound })
    }

    /// The same as `reduce_degree`; it can be watched and stopped.
    pub fn reduce_degree_with(&self, axis: i32, times: i32, call: &mut Call) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_reduce_degree_with(self.raw(), axis, times, &mut bound, call.options(), out)
        })?;
        Ok(Reduced { spline, bound })
    }

    /// The simplest spline within the tolerance.
    pub fn simplify(&self, tolerance: f64) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_simplify(self.raw(), tolerance, &mut bound, out) })?;
        Ok(Reduced { spline, bound })
    }

    /// The same as `simplify`; it can be watched and stopped.
    pub fn simplify_with(&self, tolerance: f64, call: &mut Call) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_simplify_with(self.raw(), tolerance, &mut bound, call.options(), out)
        })?;
        Ok(Reduced { spline, bound })
    }

    /// A polynomial spline of given degrees with few control points, proven to be within the tolerance.
    pub fn approximate(&self, tolerance: f64, degrees: &[i32], max_count: usize) -> Result<Reduced> {
        let degrees = if_given(degrees, self.axes()? as usize, "degrees")?;
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_approximate(self.raw(), degrees, tolerance, max_count as i64, &mut bound, out)
        })?;
        Ok(Reduced { spline, bound })
    }

    /// The same as `approximate`; it can be watched and stopped.
    pub fn approximate_with(
        &self,
        tolerance: f64,
        degrees: &[i32],
        max_count: usize,
        call: &mut Call,
    ) -> Result<Reduced> {
        let degrees = if_given(degrees, self.axes()? as usize, "degrees")?;
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_approximate_with(
                self.raw(),
                degrees,
                tolerance,
                max_count as i64,
                &mut bound,
                call.options(),
                out,
            )
        })?;
        Ok(Reduced { spline, bound })
    }
}
