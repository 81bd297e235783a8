// SPDX-License-Identifier: MIT
//! Reflections and projections.

use crate::error::{Error, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null;

impl Spline {
    fn check_dimension(&self, vectors: &[&[f64]]) -> Result<()> {
        let dim = self.dimension()? as usize;
        match vectors.iter().find(|vector| vector.len() != dim) {
            Some(vector) => Err(Error::size("vector", vector.len(), dim.to_string())),
            None => Ok(()),
        }
    }

    /// The mirror image in the plane (line, hyperplane) through a point.
    pub fn mirror(&self, point: &[f64], normal: &[f64]) -> Result<Spline> {
        self.check_dimension(&[point, normal])?;
        Spline::made(|out| unsafe { sys::nurbs_mirror(self.raw(), point.as_ptr(), normal.as_ptr(), out) })
    }
    /// Along a direction, or along the normal.
    pub fn project_to_plane(
        &self,
        point: &[f64],
        normal: &[f64],
        direction: Option<&[f64]>,
    ) -> Result<Spline> {
        self.check_dimension(&[point, normal, direction.unwrap_or(normal)])?;
        let (p, n, d) = (point.as_ptr(), normal.as_ptr(), direction.map_or(null(), |x| x.as_ptr()));
        Spline::made(|out| unsafe { sys::nurbs_project_to_plane(self.raw(), p, n, d, out) })
    }
    /// From an eye.
    pub fn project_from(&self, eye: &[f64], point: &[f64], normal: &[f64]) -> Result<Spline> {
        self.check_dimension(&[eye, point, normal])?;
        let (e, p, n) = (eye.as_ptr(), point.as_ptr(), normal.as_ptr());
        Spline::made(|out| unsafe { sys::nurbs_project_from(self.raw(), e, p, n, out) })
    }
}
