// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Reflections and projections.

use crate::arrays::{exactly, optional};
use crate::error::Result;
use crate::spline::Spline;
use crate::sys;

/// Reflections and projections.
impl Spline {
    /// The mirror image in the plane (line, hyperplane) through a point.
    pub fn mirror(&self, point: &[f64], normal: &[f64]) -> Result<Spline> {
        let dim = self.dimension()? as usize;
        let point = exactly(point, dim, "vector")?;
        let normal = exactly(normal, dim, "vector")?;
        Spline::made(|out| unsafe { sys::nurbs_mirror(self.raw(), point, normal, out) })
    }

    /// Projected along a direction, or along the normal.
    pub fn project_to_plane(
        &self,
        point: &[f64],
        normal: &[f64],
        direction: Option<&[f64]>,
    ) -> Result<Spline> {
        let dim = self.dimension()? as usize;
        let point = exactly(point, dim, "vector")?;
        let normal = exactly(normal, dim, "vector")?;
        let direction = optional(direction, dim, "vector")?;
        Spline::made(|out| unsafe { sys::nurbs_project_to_plane(self.raw(), point, normal, direction, out) })
    }

    /// Projected from an eye.
    pub fn project_from(&self, eye: &[f64], point: &[f64], normal: &[f64]) -> Result<Spline> {
        let dim = self.dimension()? as usize;
        let eye = exactly(eye, dim, "vector")?;
        let point = exactly(point, dim, "vector")?;
        let normal = exactly(normal, dim, "vector")?;
        Spline::made(|out| unsafe { sys::nurbs_project_from(self.raw(), eye, point, normal, out) })
    }
}
