// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Frames and curvature of curves and surfaces.

use crate::arrays::{by_axis, pointer_mut, Records};
use crate::error::{check, Result};
use crate::sizes::{product, times};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null;

/// Vectors `[n][3]`, and the status of each point.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SurfaceFrames {
    /// Points `[n][3]`.
    pub points: Vec<f64>,
    /// Derivatives along the first axis, `[n][3]`.
    pub du: Vec<f64>,
    /// Derivatives along the second axis, `[n][3]`.
    pub dv: Vec<f64>,
    /// Unit normals `[n][3]`.
    pub normals: Vec<f64>,
    /// Sums of `NURBS_FRAME_` bits, `[n]`.
    pub status: Vec<i32>,
}

/// Curvatures of a surface, and the status of each point.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Curvatures {
    /// The larger first, `[n][2]`.
    pub principal: Vec<f64>,
    /// Their directions, `[n][2][3]`.
    pub directions: Vec<f64>,
    /// `[n]`
    pub mean: Vec<f64>,
    /// `[n]`
    pub gaussian: Vec<f64>,
    /// Sums of `NURBS_FRAME_` bits, `[n]`.
    pub status: Vec<i32>,
}

/// Vectors `[n][dim]`, the others `[n]`; in the plane binormals and torsions are empty.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CurveFrames {
    /// Points `[n][dim]`.
    pub points: Vec<f64>,
    /// Unit tangents `[n][dim]`.
    pub tangents: Vec<f64>,
    /// Principal normals `[n][dim]`.
    pub normals: Vec<f64>,
    /// `[n][3]`, in space only.
    pub binormals: Vec<f64>,
    /// `[n]`
    pub curvatures: Vec<f64>,
    /// `[n]`, in space only.
    pub torsions: Vec<f64>,
    /// Sums of `NURBS_FRAME_` bits, `[n]`.
    pub status: Vec<i32>,
}

/// Vectors `[n][3]`, and the status of each point.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MinimalFrames {
    /// Points `[n][3]`.
    pub points: Vec<f64>,
    /// Unit tangents `[n][3]`.
    pub tangents: Vec<f64>,
    /// `[n][3]`
    pub normals: Vec<f64>,
    /// `[n][3]`
    pub binormals: Vec<f64>,
    /// Sums of `NURBS_FRAME_` bits, `[n]`.
    pub status: Vec<i32>,
}

/// Frames and curvature of curves and surfaces.
impl Spline {
    /// Points, derivatives and unit normals of a surface at parameters `[n][2]`.
    pub fn surface_frames<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<SurfaceFrames> {
        let params = params.into();
        let n = params.count(2, "params")?;
        let mut points = vec![0.0; 3 * n];
        let mut du = vec![0.0; 3 * n];
        let mut dv = vec![0.0; 3 * n];
        let mut normals = vec![0.0; 3 * n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_surface_eval_frames(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                points.as_mut_ptr(),
                0,
                0,
                du.as_mut_ptr(),
                0,
                0,
                dv.as_mut_ptr(),
                0,
                0,
                normals.as_mut_ptr(),
                0,
                0,
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(SurfaceFrames { points, du, dv, normals, status })
    }

    /// The same on the grid of the given parameters, one vector for each axis.
    pub fn surface_grid_frames(&self, params: &[&[f64]], flags: u32) -> Result<SurfaceFrames> {
        let (counts, params) = by_axis(params, 2, "params")?;
        let n = product(&counts);
        let mut points = vec![0.0; times(&[3, n])];
        let mut du = vec![0.0; times(&[3, n])];
        let mut dv = vec![0.0; times(&[3, n])];
        let mut normals = vec![0.0; times(&[3, n])];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_surface_eval_grid_frames(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                points.as_mut_ptr(),
                0,
                0,
                du.as_mut_ptr(),
                0,
                0,
                dv.as_mut_ptr(),
                0,
                0,
                normals.as_mut_ptr(),
                0,
                0,
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(SurfaceFrames { points, du, dv, normals, status })
    }

    /// Principal curvatures and directions, mean and Gaussian curvature of a surface at parameters `[n][2]`.
    pub fn surface_curvatures<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Curvatures> {
        let params = params.into();
        let n = params.count(2, "params")?;
        let mut principal = vec![0.0; 2 * n];
        let mut directions = vec![0.0; 6 * n];
        let mut mean = vec![0.0; n];
        let mut gaussian = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_surface_eval_curvatures(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                principal.as_mut_ptr(),
                0,
                0,
                directions.as_mut_ptr(),
                0,
                0,
                mean.as_mut_ptr(),
                0,
                gaussian.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(Curvatures { principal, directions, mean, gaussian, status })
    }

    /// Frenet frames, curvatures and torsions of a curve at parameters `[n]`.
    pub fn curve_frames<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<CurveFrames> {
        let params = params.into();
        let n = params.count(1, "params")?;
        let dim = self.dimension()? as usize;
        let mut points = vec![0.0; n * dim];
        let mut tangents = vec![0.0; n * dim];
        let mut normals = vec![0.0; n * dim];
        let mut binormals = vec![0.0; if dim == 3 { 3 * n } else { 0 }];
        let mut curvatures = vec![0.0; n];
        let mut torsions = vec![0.0; if dim == 3 { n } else { 0 }];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_curve_eval_frames(
                self.raw(),
                n as i64,
                params.pointer(),
                params.step(),
                points.as_mut_ptr(),
                0,
                0,
                tangents.as_mut_ptr(),
                0,
                0,
                normals.as_mut_ptr(),
                0,
                0,
                pointer_mut(&mut binormals),
                0,
                0,
                curvatures.as_mut_ptr(),
                0,
                pointer_mut(&mut torsions),
                0,
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(CurveFrames { points, tangents, normals, binormals, curvatures, torsions, status })
    }

    /// Frames along a sequence of parameters `[n]` that turn as little as possible.
    pub fn rotation_minimizing_frames<'a>(
        &self,
        params: impl Into<Records<'a>>,
        first_normal: Option<&[f64; 3]>,
        flags: u32,
    ) -> Result<MinimalFrames> {
        let params = params.into();
        let n = params.count(1, "params")?;
        let mut points = vec![0.0; 3 * n];
        let mut tangents = vec![0.0; 3 * n];
        let mut normals = vec![0.0; 3 * n];
        let mut binormals = vec![0.0; 3 * n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_curve_rotation_minimizing_frames(
                self.raw(),
                n as i64,
                params.pointer(),
                params.step(),
                first_normal.map_or(null(), |values| values.as_ptr()),
                points.as_mut_ptr(),
                0,
                0,
                tangents.as_mut_ptr(),
                0,
                0,
                normals.as_mut_ptr(),
                0,
                0,
                binormals.as_mut_ptr(),
                0,
                0,
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(MinimalFrames { points, tangents, normals, binormals, status })
    }
}
