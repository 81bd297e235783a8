// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Shapes made of what is straight and flat, within a proven distance.

use crate::call::Call;
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// A polyline in place of a curve: parameters and points of its vertices, and how far it is from the curve,
/// as proven.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CurvePolyline {
    /// Of the vertices, rising; the same one twice where the curve jumps.
    pub params: Vec<f64>,
    /// The vertices, packed.
    pub points: Vec<f64>,
    /// No distance of a segment from its part of the curve is larger.
    pub bound: f64,
    /// Whether all segments keep to the limits, as proven.
    pub reached: bool,
}

/// Shapes made of what is straight and flat, within a proven distance.
impl Spline {
    /// A polyline in place of a curve, every segment within `chord` of its part of the curve, as proven; with
    /// an angle between tangents in a segment and a length of segments that are not exceeded either, if they
    /// are not 0.
    pub fn mesh_curve(&self, chord: f64, angle: f64, longest: f64) -> Result<CurvePolyline> {
        let mut bound = 0.0;
        let mut reached = 0;
        let mut fill = |cap, params, points, count| unsafe {
            sys::nurbs_mesh_curve(
                self.raw(),
                chord,
                angle,
                longest,
                cap,
                params,
                points,
                &mut bound,
                &mut reached,
                count,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut points = vec![0.0; n * self.dimension()? as usize];
        check(fill(count, params.as_mut_ptr(), points.as_mut_ptr(), &mut count))?;
        Ok(CurvePolyline { params, points, bound, reached: reached != 0 })
    }

    /// The same as `mesh_curve`; it can be watched and stopped.
    pub fn mesh_curve_with(
        &self,
        chord: f64,
        angle: f64,
        longest: f64,
        call: &mut Call,
    ) -> Result<CurvePolyline> {
        let mut bound = 0.0;
        let mut reached = 0;
        let mut fill = |cap, params, points, count| unsafe {
            sys::nurbs_mesh_curve_with(
                self.raw(),
                chord,
                angle,
                longest,
                cap,
                params,
                points,
                &mut bound,
                &mut reached,
                count,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut points = vec![0.0; n * self.dimension()? as usize];
        check(fill(count, params.as_mut_ptr(), points.as_mut_ptr(), &mut count))?;
        Ok(CurvePolyline { params, points, bound, reached: reached != 0 })
    }
}
