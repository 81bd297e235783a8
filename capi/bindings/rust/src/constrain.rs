// SPDX-License-Identifier: MIT
//! The smallest change that makes a shape meet constraints.

use crate::arrays::{exactly, if_given, Records};
use crate::error::Result;
use crate::spline::Spline;
use crate::sys;

/// Constraints at `params` `[n][axes]` with `targets` `[n][dim]`, packed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Constraints<'a> {
    /// `[n][axes]`
    pub params: &'a [f64],
    /// `[n][dim]`
    pub targets: &'a [f64],
    /// `NURBS_CONSTRAIN_` constants; empty: all values.
    pub kinds: &'a [i32],
    /// `[n][axes]`; empty: 0, and 1 for directions of a curve.
    pub orders: &'a [i32],
}

/// What else holds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ConstrainOptions<'a> {
    /// `[axes][2]` highest order of derivatives that stay at the ends, -1 for none; empty: none.
    pub keep: &'a [i32],
    /// Of moving each control point; empty: all 1.
    pub costs: &'a [f64],
    /// Of changing each weight; empty: all stay.
    pub weight_costs: &'a [f64],
    /// Largest residual.
    pub tolerance: f64,
}

/// The spline, how far each constraint is missed, the number of independent equations, the largest distance by which a
/// control point moved, and the gradient of the Lagrangian.
#[derive(Debug)]
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

impl Spline {
    /// The smallest change that meets constraints.
    pub fn constrain(&self, given: Constraints, options: ConstrainOptions) -> Result<Constrained> {
        let (axes, dim, points) = (self.axes()? as usize, self.dimension()? as usize, self.point_count()?);
        let n = Records::from(given.params).count(axes, "params")?;
        let targets = exactly(given.targets, n * dim, "targets")?;
        let kinds = if_given(given.kinds, n, "kinds")?;
        let orders = if_given(given.orders, n * axes, "orders")?;
        let keep = if_given(options.keep, 2 * axes, "keep")?;
        let costs = if_given(options.costs, points, "costs")?;
        let weight_costs = if_given(options.weight_costs, points, "weight_costs")?;
        let (mut residuals, mut rank, mut moved, mut optimality) = (vec![0.0; n], 0, 0.0, 0.0);
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_constrain(
                self.raw(),
                n as i64,
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
}
