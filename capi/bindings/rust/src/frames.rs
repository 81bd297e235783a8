// SPDX-License-Identifier: MIT
//! Frames and curvature of curves and surfaces. The bits of a status are `sys::NURBS_FRAME_LIMIT` and its neighbours.

use std::ptr::null;

use crate::arrays::Records;
use crate::error::{check, Error, Result};
use crate::spline::Spline;
use crate::sys;

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

/// `principal` is `[n][2]`, `directions` `[n][2][3]`, the others are `[n]`.
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

impl SurfaceFrames {
    fn room(n: usize) -> Self {
        let vectors = vec![0.0; n.saturating_mul(3)];
        SurfaceFrames {
            points: vectors.clone(),
            du: vectors.clone(),
            dv: vectors.clone(),
            normals: vectors,
            status: vec![0; n],
        }
    }
}

// An empty array is one that is not wanted.
fn pointer(values: &mut Vec<f64>) -> *mut f64 {
    if values.is_empty() {
        std::ptr::null_mut()
    } else {
        values.as_mut_ptr()
    }
}

/// Frames and curvature.
impl Spline {
    /// Points, derivatives and unit normals of a surface at parameters `[n][2]`.
    pub fn surface_frames<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<SurfaceFrames> {
        let p = params.into();
        let n = p.count(2, "params")?;
        let mut f = SurfaceFrames::room(n);
        check(unsafe {
            sys::nurbs_surface_eval_frames(
                self.raw(),
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                f.points.as_mut_ptr(),
                0,
                0,
                f.du.as_mut_ptr(),
                0,
                0,
                f.dv.as_mut_ptr(),
                0,
                0,
                f.normals.as_mut_ptr(),
                0,
                0,
                f.status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(f)
    }

    /// The same on the grid of the given parameters, one vector for each axis.
    pub fn surface_grid_frames(&self, params: &[&[f64]], flags: u32) -> Result<SurfaceFrames> {
        if params.len() != 2 {
            return Err(Error::size("params", params.len(), "2 vectors".to_string()));
        }
        let counts = [params[0].len() as i64, params[1].len() as i64];
        let mut f = SurfaceFrames::room(params[0].len().saturating_mul(params[1].len()));
        check(unsafe {
            sys::nurbs_surface_eval_grid_frames(
                self.raw(),
                counts.as_ptr(),
                params.concat().as_ptr(),
                f.points.as_mut_ptr(),
                0,
                0,
                f.du.as_mut_ptr(),
                0,
                0,
                f.dv.as_mut_ptr(),
                0,
                0,
                f.normals.as_mut_ptr(),
                0,
                0,
                f.status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(f)
    }

    /// Principal curvatures and directions, mean and Gaussian curvature of a surface at parameters `[n][2]`.
    pub fn surface_curvatures<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Curvatures> {
        let p = params.into();
        let n = p.count(2, "params")?;
        let mut c = Curvatures {
            principal: vec![0.0; 2 * n],
            directions: vec![0.0; 6 * n],
            mean: vec![0.0; n],
            gaussian: vec![0.0; n],
            status: vec![0; n],
        };
        check(unsafe {
            sys::nurbs_surface_eval_curvatures(
                self.raw(),
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                c.principal.as_mut_ptr(),
                0,
                0,
                c.directions.as_mut_ptr(),
                0,
                0,
                c.mean.as_mut_ptr(),
                0,
                c.gaussian.as_mut_ptr(),
                0,
                c.status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(c)
    }

    /// Frenet frames, curvatures and torsions of a curve at parameters `[n]`.
    pub fn curve_frames<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<CurveFrames> {
        let p = params.into();
        let (n, dim) = (p.count(1, "params")?, self.dimension()? as usize);
        let (vectors, space) = (vec![0.0; n * dim], if dim == 3 { n } else { 0 });
        let mut f = CurveFrames {
            points: vectors.clone(),
            tangents: vectors.clone(),
            normals: vectors,
            binormals: vec![0.0; 3 * space],
            curvatures: vec![0.0; n],
            torsions: vec![0.0; space],
            status: vec![0; n],
        };
        check(unsafe {
            sys::nurbs_curve_eval_frames(
                self.raw(),
                n as i64,
                p.pointer(),
                p.step(),
                f.points.as_mut_ptr(),
                0,
                0,
                f.tangents.as_mut_ptr(),
                0,
                0,
                f.normals.as_mut_ptr(),
                0,
                0,
                pointer(&mut f.binormals),
                0,
                0,
                f.curvatures.as_mut_ptr(),
                0,
                pointer(&mut f.torsions),
                0,
                f.status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(f)
    }

    /// Frames along a sequence of parameters `[n]` that turn as little as possible.
    pub fn rotation_minimizing_frames<'a>(
        &self,
        params: impl Into<Records<'a>>,
        first_normal: Option<&[f64; 3]>,
        flags: u32,
    ) -> Result<MinimalFrames> {
        let p = params.into();
        let n = p.count(1, "params")?;
        let vectors = vec![0.0; n.saturating_mul(3)];
        let mut f = MinimalFrames {
            points: vectors.clone(),
            tangents: vectors.clone(),
            normals: vectors.clone(),
            binormals: vectors,
            status: vec![0; n],
        };
        check(unsafe {
            sys::nurbs_curve_rotation_minimizing_frames(
                self.raw(),
                n as i64,
                p.pointer(),
                p.step(),
                first_normal.map_or(null(), |normal| normal.as_ptr()),
                f.points.as_mut_ptr(),
                0,
                0,
                f.tangents.as_mut_ptr(),
                0,
                0,
                f.normals.as_mut_ptr(),
                0,
                0,
                f.binormals.as_mut_ptr(),
                0,
                0,
                f.status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(f)
    }
}
