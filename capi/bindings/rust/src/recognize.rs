// SPDX-License-Identifier: MIT
//! Recognition of shapes.

use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

/// A `NURBS_SHAPE_` constant, its placement and sizes as `nurbs_recognize` describes them, and a proven bound of the
/// distance from it.
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

impl Spline {
    /// The first shape of the list from which no point is farther than the tolerance.
    pub fn recognize(&self, tolerance: f64) -> Result<Recognized> {
        let (mut found, mut placement) = (Recognized::default(), [[0.0; 3]; 3]);
        let (place, sizes) = (placement.as_mut_ptr().cast(), found.sizes.as_mut_ptr());
        check(unsafe {
            sys::nurbs_recognize(self.raw(), tolerance, &mut found.shape, place, sizes, &mut found.deviation)
        })?;
        [found.origin, found.axis, found.x] = placement;
        Ok(found)
    }
}
