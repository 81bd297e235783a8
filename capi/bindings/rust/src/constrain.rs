// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! The smallest change that makes a shape meet constraints.

use crate::arrays::{exactly, if_given, rows};
use crate::call::Call;
use crate::error::Result;
use crate::spline::Spline;
use crate::sys;

/// Constraints at params `[n][axes]` with targets `[n][dim]`, packed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Constraints<'a> {
    /// `[n][axes]`
    pub params: &'a [f64],
    /// `[n][dim]`
    pub targets: &'a [f64],
    /// `NURBS_CONSTRAIN_` constants `[n]`; empty: all values.
    pub kinds: &'a [i32],
    /// Of derivatives, `[n][axes]`; empty: 0, and 1 for directions of a curve.
    pub orders: &'a [i32],
}

/// What else holds; what is empty is the default of nurbs.h.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ConstrainOptions<'a> {
    /// `[axes][2]` highest order of derivatives that stay at the ends, -1 for none; empty: none.
    pub keep: &'a [i32],
    /// `[N]` of moving each control point; empty: all 1.
    pub costs: &'a [f64],
    /// `[N]` of changing each weight; empty: all stay.
    pub weight_costs: &'a [f64],
    /// Largest residual.
    pub tolerance: f64,
}

/// The spline, how far each constraint is missed, the number of independent equations, the largest distance
/// by which a control point moved, and the gradient of the Lagrangian.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Constrained {
    /// The changed spline.
    pub spline: Spline,
    /// How far each constraint is missed.
    pub residuals: Vec<f64>,
    /// The number of independent equations.
    pub rank: i64,
    /// The largest distance by which a control point moved.
    pub moved: f64,
    /// The size of the gradient of the Lagrangian.
    pub optimality: f64,
}

/// The smallest change that makes a shape meet constraints.
impl Spline {
    /// The smallest change that meets constraints.
    pub fn constrain(&self, given: Constraints, options: ConstrainOptions) -> Result<Constrained> {
        let axes = self.axes()? as usize;
        let count = rows(given.params, axes, "params")?;
        let kinds = if_given(given.kinds, count, "kinds")?;
        let orders = if_given(given.orders, count * axes, "orders")?;
        let targets = exactly(given.targets, count * self.dimension()? as usize, "targets")?;
        let keep = if_given(options.keep, 2 * axes, "keep")?;
        let n = self.point_count()?;
        let costs = if_given(options.costs, n, "costs")?;
        let weight_costs = if_given(options.weight_costs, n, "weight_costs")?;
        let mut residuals = vec![0.0; count];
        let mut rank = 0;
        let mut moved = 0.0;
        let mut optimality = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_constrain(
                self.raw(),
                count as i64,
                kinds,
                orders,
                given.params.as_ptr(),
                targets,
                keep,
                costs,
                weight_costs,
                options.tolerance,
                residuals.as_mut_ptr(),
                &mut rank,
                &mut moved,
                &mut optimality,
                out,
            )
        })?;
        Ok(Constrained { spline, residuals, rank, moved, optimality })
    }

    /// The same as `constrain`; it can be watched and stopped.
    pub fn constrain_with(
        &self,
        given: Constraints,
        options: ConstrainOptions,
        call: &mut Call,
    ) -> Result<Constrained> {
        let axes = self.axes()? as usize;
        let count = rows(given.params, axes, "params")?;
        let kinds = if_given(given.kinds, count, "kinds")?;
        let orders = if_given(given.orders, count * axes, "orders")?;
        let targets = exactly(given.targets, count * self.dimension()? as usize, "targets")?;
        let keep = if_given(options.keep, 2 * axes, "keep")?;
        let n = self.point_count()?;
        let costs = if_given(options.costs, n, "costs")?;
        let weight_costs = if_given(options.weight_costs, n, "weight_costs")?;
        let mut residuals = vec![0.0; count];
        let mut rank = 0;
        let mut moved = 0.0;
        let mut optimality = 0.0;
        let spline = Spline::made(|out| unsafe {
            crate::call::nurbs_constrain_with(
                self.raw(),
                count as i64,
                kinds,
                orders,
                given.params.as_ptr(),
                targets,
                keep,
                costs,
                weight_costs,
                options.tolerance,
                residuals.as_mut_ptr(),
                &mut rank,
                &mut moved,
                &mut optimality,
                call.options(),
                out,
            )
        })?;
        Ok(Constrained { spline, residuals, rank, moved, optimality })
    }
}
