// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Recognition of shapes.

use crate::call::Call;
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

/// A shape, its placement and sizes as `nurbs_recognize` describes them, and a proven bound of the distance
/// from it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Recognized {
    /// One of the `NURBS_SHAPE_` constants.
    pub shape: i32,
    /// Centre, vertex, apex or another point.
    pub origin: [f64; 3],
    /// Normal or axis.
    pub axis: [f64; 3],
    /// The direction where angles start.
    pub x: [f64; 3],
    /// Radii, semi-axes, a focal length or half an opening angle.
    pub sizes: [f64; 3],
    /// A proven bound of the distance from it.
    pub deviation: f64,
}

/// Recognition of shapes.
impl Spline {
    /// The first shape of the list from which no point is farther than the tolerance.
    pub fn recognize(&self, tolerance: f64) -> Result<Recognized> {
        let mut shape = 0;
        let mut placement = [[0.0; 3]; 3];
        let mut sizes = [0.0; 3];
        let mut deviation = 0.0;
        check(unsafe {
            sys::nurbs_recognize(
                self.raw(),
                tolerance,
                &mut shape,
                placement.as_mut_ptr().cast(),
                sizes.as_mut_ptr(),
                &mut deviation,
            )
        })?;
        Ok(Recognized { shape, origin: placement[0], axis: placement[1], x: placement[2], sizes, deviation })
    }

    /// The same as `recognize`; it can be watched and stopped.
    pub fn recognize_with(&self, tolerance: f64, call: &mut Call) -> Result<Recognized> {
        let mut shape = 0;
        let mut placement = [[0.0; 3]; 3];
        let mut sizes = [0.0; 3];
        let mut deviation = 0.0;
        check(unsafe {
            sys::nurbs_recognize_with(
                self.raw(),
                tolerance,
                &mut shape,
                placement.as_mut_ptr().cast(),
                sizes.as_mut_ptr(),
                &mut deviation,
                call.options(),
            )
        })?;
        Ok(Recognized { shape, origin: placement[0], axis: placement[1], x: placement[2], sizes, deviation })
    }
}
