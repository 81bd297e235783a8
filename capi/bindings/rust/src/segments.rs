// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Hermite data, the power basis of pieces, and the matrices between bases of a segment.

use crate::arrays::exactly;
use crate::error::{check, Result};
use crate::sizes::{axes_of, bezier_points, homogeneous, matrix_size, positive, product, sum, times};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Points and tangents, packed, of a piecewise cubic at its breaks.
#[derive(Clone, Debug, Default, PartialEq)]
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
#[derive(Clone, Debug, Default, PartialEq)]
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
    let size = matrix_size(degree);
    let mut matrix = vec![0.0; size];
    check(unsafe { sys::nurbs_basis_matrix(from, to, degree, size as i64, matrix.as_mut_ptr()) })?;
    Ok(matrix)
}

/// Hermite data, the power basis of pieces, and the matrices between bases of a segment.
impl Spline {
    /// The piecewise cubic through points with tangents, both packed.
    pub fn hermite(params: &[f64], dim: i32, points: &[f64], tangents: &[f64]) -> Result<Spline> {
        let n = params.len();
        let points = exactly(points, n * positive(dim), "points")?;
        let tangents = exactly(tangents, n * positive(dim), "tangents")?;
        Spline::made(|out| unsafe {
            sys::nurbs_create_hermite(n as i64, params.as_ptr(), dim, points, 0, 0, tangents, 0, 0, out)
        })
    }

    /// The data from which `Spline::hermite` makes a C^1 piecewise cubic again.
    pub fn to_hermite(&self) -> Result<Hermite> {
        let fill = |cap, params, points, tangents, count| unsafe {
            sys::nurbs_to_hermite(self.raw(), cap, params, points, tangents, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let dim = self.dimension()? as usize;
        let mut points = vec![0.0; n * dim];
        let mut tangents = vec![0.0; n * dim];
        check(fill(count, params.as_mut_ptr(), points.as_mut_ptr(), tangents.as_mut_ptr(), &mut count))?;
        Ok(Hermite { params, points, tangents })
    }

    /// The power basis of every piece, of homogeneous points if the spline is rational.
    pub fn to_power(&self) -> Result<PowerForm> {
        let axes = self.axes()? as usize;
        let mut piece_counts = vec![0; axes];
        let piece_counts_pointer = piece_counts.as_mut_ptr();
        let fill = |cap, coefficients, breaks, count| unsafe {
            sys::nurbs_to_power(self.raw(), cap, coefficients, breaks, piece_counts_pointer, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut coefficients = vec![0.0; n];
        let mut breaks = vec![0.0; sum(&piece_counts) + axes];
        check(fill(count, coefficients.as_mut_ptr(), breaks.as_mut_ptr(), &mut count))?;
        Ok(PowerForm { coefficients, breaks, piece_counts })
    }

    /// The spline of pieces in the power basis; flags: `NURBS_HOMOGENEOUS`.
    pub fn power(degrees: &[i32], dim: i32, form: &PowerForm, flags: u32) -> Result<Spline> {
        let piece_counts = exactly(&form.piece_counts, degrees.len(), "piece_counts")?;
        let coefficients = exactly(
            &form.coefficients,
            times(&[product(&form.piece_counts), bezier_points(degrees), positive(dim) + homogeneous(flags)]),
            "coefficients",
        )?;
        Spline::made(|out| unsafe {
            sys::nurbs_create_power(
                axes_of(degrees),
                degrees.as_ptr(),
                piece_counts,
                form.breaks.as_ptr(),
                form.breaks.len() as i64,
                dim,
                coefficients,
                0,
                0,
                flags,
                out,
            )
        })
    }
}
