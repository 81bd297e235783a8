// SPDX-License-Identifier: MIT
//! Hermite data, and the matrices between bases of a segment.

use crate::error::{check, Error, Result};
use crate::spline::Spline;
use crate::sys;

/// The matrix, row by row, that takes coefficients of one basis to those of another.
pub fn basis_matrix(from: i32, to: i32, degree: i32) -> Result<Vec<f64>> {
    let n = if (0..=sys::NURBS_MAX_DEGREE).contains(&degree) { degree as usize + 1 } else { 0 };
    let mut matrix = vec![0.0; n * n];
    let size = matrix.len() as i64;
    check(unsafe { sys::nurbs_basis_matrix(from, to, degree, size, matrix.as_mut_ptr()) })?;
    Ok(matrix)
}

impl Spline {
    /// The piecewise cubic through points with tangents, both packed.
    pub fn hermite(params: &[f64], dim: i32, points: &[f64], tangents: &[f64]) -> Result<Spline> {
        let wanted = params.len() * dim.max(0) as usize;
        for (name, values) in [("points", points), ("tangents", tangents)] {
            if values.len() != wanted {
                return Err(Error::size(name, values.len(), wanted.to_string()));
            }
        }
        let (n, t, p, v) = (params.len() as i64, params.as_ptr(), points.as_ptr(), tangents.as_ptr());
        Spline::made(|out| unsafe { sys::nurbs_create_hermite(n, t, dim, p, 0, 0, v, 0, 0, out) })
    }
}
