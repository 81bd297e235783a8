// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Where shapes meet; every answer says whether it is complete.

use crate::arrays::exactly;
use crate::call::Call;
use crate::error::{check, Result};
use crate::sizes::monomials;
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Parameters in rising order, one `NURBS_HIT_` constant each, and ranges `[n][2]` of parameters outside of
/// which there is no solution.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Hits {
    /// In rising order.
    pub params: Vec<f64>,
    /// One of the `NURBS_HIT_` constants each.
    pub kinds: Vec<i32>,
    /// `[n]` of lower and upper ends, outside of which there is no solution.
    pub ranges: Vec<[f64; 2]>,
    /// Whether none of them is undecided.
    pub complete: bool,
}

/// Where shapes meet; every answer says whether it is complete.
impl Spline {
    /// Where a scalar curve has a value: its roots, with proof that there are no others.
    pub fn roots(&self, value: f64, tolerance: f64) -> Result<Hits> {
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_roots(self.raw(), value, tolerance, cap, params, kinds, ranges, count, &mut complete)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// The same as `roots`; it can be watched and stopped.
    pub fn roots_with(&self, value: f64, tolerance: f64, call: &mut Call) -> Result<Hits> {
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_roots_with(
                self.raw(),
                value,
                tolerance,
                cap,
                params,
                kinds,
                ranges,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a
    /// degree is 0; its coefficients are those of products x_i x_j ... with i <= j <= ..., in lexicographic
    /// order, where x_dim stands for 1.
    pub fn curve_level(&self, degree: i32, coefficients: &[f64], tolerance: f64) -> Result<Hits> {
        let coefficients =
            exactly(coefficients, monomials(self.dimension()? as usize, degree), "coefficients")?;
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_curve_level(
                self.raw(),
                degree,
                coefficients,
                tolerance,
                cap,
                params,
                kinds,
                ranges,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// The same as `curve_level`; it can be watched and stopped.
    pub fn curve_level_with(
        &self,
        degree: i32,
        coefficients: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Hits> {
        let coefficients =
            exactly(coefficients, monomials(self.dimension()? as usize, degree), "coefficients")?;
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_curve_level_with(
                self.raw(),
                degree,
                coefficients,
                tolerance,
                cap,
                params,
                kinds,
                ranges,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }
}
