// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Derivatives, integrals, sums and products of splines, and changes of their weights.

use crate::arrays::exactly;
use crate::call::Call;
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

/// Derivatives, integrals, sums and products of splines, and changes of their weights.
impl Spline {
    /// The polar form of the piece at params `[axes]` at args `[sum of the degrees]`: `[dim]`, or `[dim + 1]`
    /// if rational.
    pub fn blossom(&self, params: &[f64], args: &[f64], flags: u32) -> Result<Vec<f64>> {
        let params = exactly(params, self.axes()? as usize, "params")?;
        let mut values = vec![0.0; self.dimension()? as usize + usize::from(self.is_rational()?)];
        check(unsafe {
            sys::nurbs_blossom(
                self.raw(),
                params,
                args.len() as i64,
                args.as_ptr(),
                values.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(values)
    }

    /// The partial derivative along an axis.
    pub fn derivative(&self, axis: i32, order: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_derivative(self.raw(), axis, order, out) })
    }

    /// The derivative with respect to a knot of the full vector of an axis, as a spline.
    pub fn knot_derivative(&self, axis: i32, knot: i64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_eval_knot_derivative(self.raw(), axis, knot, out) })
    }

    /// The integral along an axis from the start of its domain.
    pub fn antiderivative(&self, axis: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_antiderivative(self.raw(), axis, out) })
    }

    /// The product at each parameter; `flags` is 0, `NURBS_PRODUCT_DOT` or `NURBS_PRODUCT_CROSS`.
    pub fn product(&self, other: &Spline, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_product(self.raw(), other.raw(), flags, out) })
    }

    /// The same as `product`; it can be watched and stopped.
    pub fn product_with(&self, other: &Spline, flags: u32, call: &mut Call) -> Result<Spline> {
        Spline::made(|out| unsafe {
            sys::nurbs_product_with(self.raw(), other.raw(), flags, call.options(), out)
        })
    }

    /// This spline at f(t), for a curve f in its parameter space.
    pub fn compose(&self, f: &Spline) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_compose(self.raw(), f.raw(), out) })
    }

    /// The same as `compose`; it can be watched and stopped.
    pub fn compose_with(&self, f: &Spline, call: &mut Call) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_compose_with(self.raw(), f.raw(), call.options(), out) })
    }

    /// alpha times this spline and beta times the other one.
    pub fn sum(&self, alpha: f64, other: &Spline, beta: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_sum(self.raw(), alpha, other.raw(), beta, out) })
    }

    /// The same shape with the largest weight 1; equal weights are dropped.
    pub fn normalize_weights(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_normalize_weights(self.raw(), out) })
    }

    /// The same shape with the ratio of the end weights, last over first, multiplied.
    pub fn reparametrize_moebius(&self, axis: i32, ratio: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_reparametrize_moebius(self.raw(), axis, ratio, out) })
    }

    /// The same shape with equal weights at the ends of an axis.
    pub fn equalize_end_weights(&self, axis: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_equalize_end_weights(self.raw(), axis, out) })
    }
}
