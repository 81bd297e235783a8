// SPDX-License-Identifier: MIT
//! Hermite data, the power basis of pieces, and the matrices between bases of a segment.

use crate::error::{check, value, Error, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Points and tangents, packed, of a piecewise cubic at its breaks.
#[derive(Debug)]
#[non_exhaustive]
pub struct Hermite {
    /// Breaks.
    pub params: Vec<f64>,
    /// Points at them, packed.
    pub points: Vec<f64>,
    /// Derivatives at them, packed.
    pub tangents: Vec<f64>,
}

/// The power basis of all pieces, packed, and the breaks of the axes one after the other.
#[derive(Debug)]
pub struct PowerForm {
    /// Of all pieces, packed.
    pub coefficients: Vec<f64>,
    /// Of the axes one after the other.
    pub breaks: Vec<f64>,
    /// Of each axis.
    pub piece_counts: Vec<i64>,
}

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
        let wanted = params.len().saturating_mul(dim.max(0) as usize);
        for (name, values) in [("points", points), ("tangents", tangents)] {
            if values.len() != wanted {
                return Err(Error::size(name, values.len(), wanted.to_string()));
            }
        }
        let (n, t, p, v) = (params.len() as i64, params.as_ptr(), points.as_ptr(), tangents.as_ptr());
        Spline::made(|out| unsafe { sys::nurbs_create_hermite(n, t, dim, p, 0, 0, v, 0, 0, out) })
    }

    /// The data from which `hermite` makes a C^1 piecewise cubic again.
    pub fn to_hermite(&self) -> Result<Hermite> {
        let (g, no) = (self.raw(), null_mut());
        let n = value(|v: *mut i64| unsafe { sys::nurbs_to_hermite(g, 0, no, no, no, v) })?;
        let mut params = vec![0.0; n as usize];
        let mut points = vec![0.0; n as usize * self.dimension()? as usize];
        let mut tangents = points.clone();
        let (t, p, d) = (params.as_mut_ptr(), points.as_mut_ptr(), tangents.as_mut_ptr());
        check(unsafe { sys::nurbs_to_hermite(g, n, t, p, d, null_mut()) })?;
        Ok(Hermite { params, points, tangents })
    }

    /// The power basis of every piece, of homogeneous points if the spline is rational.
    pub fn to_power(&self) -> Result<PowerForm> {
        let (g, no) = (self.raw(), null_mut());
        let mut piece_counts = vec![0; self.axes()? as usize];
        let pieces = piece_counts.as_mut_ptr();
        let n = value(|v: *mut i64| unsafe { sys::nurbs_to_power(g, 0, no, no, pieces, v) })?;
        let mut coefficients = vec![0.0; n as usize];
        let mut breaks = vec![0.0; piece_counts.iter().map(|n| *n as usize + 1).sum()];
        let (c, b) = (coefficients.as_mut_ptr(), breaks.as_mut_ptr());
        check(unsafe { sys::nurbs_to_power(g, n, c, b, null_mut(), null_mut()) })?;
        Ok(PowerForm { coefficients, breaks, piece_counts })
    }

    /// The spline of pieces in the power basis; flags: `NURBS_HOMOGENEOUS`.
    pub fn power(degrees: &[i32], dim: i32, form: &PowerForm, flags: u32) -> Result<Spline> {
        let width = i64::from(dim) + i64::from(flags & sys::NURBS_HOMOGENEOUS != 0);
        let mut layers =
            degrees.iter().zip(&form.piece_counts).map(|(p, n)| (i64::from(*p) + 1).checked_mul(*n));
        let wanted = layers.try_fold(width, |size, n| size.checked_mul(n?));
        if form.piece_counts.len() != degrees.len() {
            return Err(Error::size("piece_counts", form.piece_counts.len(), degrees.len().to_string()));
        }
        if wanted != Some(form.coefficients.len() as i64) {
            return Err(Error::size(
                "coefficients",
                form.coefficients.len(),
                wanted.map_or("less".into(), |n| n.to_string()),
            ));
        }
        let (p, n, b) = (degrees.as_ptr(), form.piece_counts.as_ptr(), form.breaks.as_ptr());
        let (axes, breaks, c) = (degrees.len() as i32, form.breaks.len() as i64, form.coefficients.as_ptr());
        Spline::made(|out| unsafe {
            sys::nurbs_create_power(axes, p, n, b, breaks, dim, c, 0, 0, flags, out)
        })
    }
}
