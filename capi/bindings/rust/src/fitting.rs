// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Splines closest to data, and statistics of data.

use crate::arrays::{counts_of, exactly, if_given, optional, Records};
use crate::call::Call;
use crate::data::{
    cloud_options_pointer, fit_options_pointer, CloudOptions, CloudReport, Data, FitOptions, FitReport,
};
use crate::error::{check, Result};
use crate::sizes::{axes_of, positive};
use crate::spline::Spline;
use crate::statistics::{statistics_handles, Statistics};
use crate::sys;

/// The spline, and what the fit tells.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fitted {
    /// The spline.
    pub spline: Spline,
    /// What the fit tells.
    pub report: FitReport,
}

/// The spline, and what the fit of points without parameters tells.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FittedCloud {
    /// The spline.
    pub spline: Spline,
    /// What the fit tells.
    pub report: CloudReport,
}

/// How much data statistics hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StatisticsSize {
    /// Number of axes.
    pub axes: i32,
    /// Dimension of the values.
    pub dim: i32,
    /// Number of data that count.
    pub count: i64,
    /// Number of cells that hold any of them.
    pub cells: i64,
    /// Sum of the weights.
    pub weight: f64,
}

/// The spline over full knot vectors, all axes one after the other, that is closest to data.
pub fn fit_points(
    data: &Data,
    degrees: &[i32],
    counts: &[usize],
    knots: &[f64],
    options: Option<&FitOptions>,
    flags: u32,
) -> Result<Fitted> {
    let degrees = exactly(degrees, data.axes()? as usize, "degrees")?;
    let counts = counts_of(counts, data.axes()? as usize, "counts")?;
    let mut report = FitReport::empty();
    let spline = Spline::made(|out| unsafe {
        sys::nurbs_fit_points(
            data.raw(),
            degrees,
            counts.as_ptr(),
            knots.as_ptr(),
            knots.len() as i64,
            flags,
            fit_options_pointer(options, data.shape()),
            report.raw_mut(),
            out,
        )
    })?;
    Ok(Fitted { spline, report })
}

/// The same as `fit_points`; it can be watched and stopped.
pub fn fit_points_with(
    data: &Data,
    degrees: &[i32],
    counts: &[usize],
    knots: &[f64],
    options: Option<&FitOptions>,
    flags: u32,
    call: &mut Call,
) -> Result<Fitted> {
    let degrees = exactly(degrees, data.axes()? as usize, "degrees")?;
    let counts = counts_of(counts, data.axes()? as usize, "counts")?;
    let mut report = FitReport::empty();
    let spline = Spline::made(|out| unsafe {
        sys::nurbs_fit_points_with(
            data.raw(),
            degrees,
            counts.as_ptr(),
            knots.as_ptr(),
            knots.len() as i64,
            flags,
            fit_options_pointer(options, data.shape()),
            report.raw_mut(),
            call.options(),
            out,
        )
    })?;
    Ok(Fitted { spline, report })
}

/// A spline with few control points that no datum is farther from than the tolerance.
pub fn fit_tolerance(
    data: &Data,
    degrees: &[i32],
    tolerance: f64,
    domain: &[f64],
    max_count: usize,
    options: Option<&FitOptions>,
    flags: u32,
) -> Result<Fitted> {
    let degrees = exactly(degrees, data.axes()? as usize, "degrees")?;
    let domain = if_given(domain, 2 * data.axes()? as usize, "domain")?;
    let mut report = FitReport::empty();
    let spline = Spline::made(|out| unsafe {
        sys::nurbs_fit_tolerance(
            data.raw(),
            degrees,
            domain,
            tolerance,
            max_count as i64,
            flags,
            fit_options_pointer(options, data.shape()),
            report.raw_mut(),
            out,
        )
    })?;
    Ok(Fitted { spline, report })
}

/// The same as `fit_tolerance`; it can be watched and stopped.
pub fn fit_tolerance_with(
    data: &Data,
    degrees: &[i32],
    tolerance: f64,
    domain: &[f64],
    max_count: usize,
    options: Option<&FitOptions>,
    flags: u32,
    call: &mut Call,
) -> Result<Fitted> {
    let degrees = exactly(degrees, data.axes()? as usize, "degrees")?;
    let domain = if_given(domain, 2 * data.axes()? as usize, "domain")?;
    let mut report = FitReport::empty();
    let spline = Spline::made(|out| unsafe {
        sys::nurbs_fit_tolerance_with(
            data.raw(),
            degrees,
            domain,
            tolerance,
            max_count as i64,
            flags,
            fit_options_pointer(options, data.shape()),
            report.raw_mut(),
            call.options(),
            out,
        )
    })?;
    Ok(Fitted { spline, report })
}

/// Splines closest to data, and statistics of data.
impl Spline {
    /// A spline over full knot vectors, all axes one after the other, along the principal directions of
    /// points.
    pub fn cloud_start<'a>(
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let n = points.count(positive(dim), "points")?;
        let counts = counts_of(counts, degrees.len(), "counts")?;
        Spline::made(|out| unsafe {
            sys::nurbs_cloud_start(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                n as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
                out,
            )
        })
    }

    /// The spline over the same knots that is closest to points without parameters, found from this one.
    pub fn fit_cloud<'a>(
        &self,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
        options: Option<&CloudOptions>,
    ) -> Result<FittedCloud> {
        let points = points.into();
        let n = points.count(self.dimension()? as usize, "points")?;
        let weights = optional(weights, n, "weights")?;
        let mut report = CloudReport::empty();
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_fit_cloud(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                cloud_options_pointer(options),
                report.raw_mut(),
                out,
            )
        })?;
        Ok(FittedCloud { spline, report })
    }

    /// The same as `fit_cloud`; it can be watched and stopped.
    pub fn fit_cloud_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
        options: Option<&CloudOptions>,
        call: &mut Call,
    ) -> Result<FittedCloud> {
        let points = points.into();
        let n = points.count(self.dimension()? as usize, "points")?;
        let weights = optional(weights, n, "weights")?;
        let mut report = CloudReport::empty();
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_fit_cloud_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                cloud_options_pointer(options),
                report.raw_mut(),
                call.options(),
                out,
            )
        })?;
        Ok(FittedCloud { spline, report })
    }
}

/// Splines closest to data, and statistics of data.
impl Statistics {
    /// Statistics of no data, about cells between breaks and splines of at most the given degrees.
    pub fn create(
        degrees: &[i32],
        break_counts: &[usize],
        breaks: &[f64],
        dim: i32,
        value_scale: f64,
        weight_scale: f64,
    ) -> Result<Statistics> {
        let break_counts = counts_of(break_counts, degrees.len(), "break_counts")?;
        Statistics::made(|out| unsafe {
            sys::nurbs_statistics_create(
                axes_of(degrees),
                degrees.as_ptr(),
                break_counts.as_ptr(),
                breaks.as_ptr(),
                breaks.len() as i64,
                dim,
                value_scale,
                weight_scale,
                out,
            )
        })
    }

    /// Statistics with more data; the sums are exact.
    pub fn add(&self, data: &Data) -> Result<Statistics> {
        Statistics::made(|out| unsafe { sys::nurbs_statistics_add(self.raw(), data.raw(), out) })
    }

    /// The same as `add`; it can be watched and stopped.
    pub fn add_with(&self, data: &Data, call: &mut Call) -> Result<Statistics> {
        Statistics::made(|out| unsafe {
            sys::nurbs_statistics_add_with(self.raw(), data.raw(), call.options(), out)
        })
    }

    /// The sum of statistics, of some of them with the sign -1: the same bits for any order and partition of
    /// the data.
    pub fn merge(parts: &[&Statistics], signs: &[i32]) -> Result<Statistics> {
        let parts = statistics_handles(parts);
        let count = parts.len();
        let signs = if_given(signs, count, "signs")?;
        Statistics::made(|out| unsafe {
            sys::nurbs_statistics_merge(count as i64, parts.as_ptr(), signs, out)
        })
    }

    /// How much data they hold.
    pub fn size(&self) -> Result<StatisticsSize> {
        let mut axes = 0;
        let mut dim = 0;
        let mut count = 0;
        let mut cells = 0;
        let mut weight = 0.0;
        check(unsafe {
            sys::nurbs_statistics_size(self.raw(), &mut axes, &mut dim, &mut count, &mut cells, &mut weight)
        })?;
        Ok(StatisticsSize { axes, dim, count, cells, weight })
    }

    /// Statistics from what to_bytes() made of them.
    pub fn from_bytes(bytes: &[u8]) -> Result<Statistics> {
        Statistics::made(|out| unsafe {
            sys::nurbs_statistics_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out)
        })
    }

    /// The spline over full knot vectors, all axes one after the other, that is closest to the data.
    pub fn fit(
        &self,
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        options: Option<&FitOptions>,
        flags: u32,
    ) -> Result<Fitted> {
        let axes = self.axes()? as usize;
        let degrees = exactly(degrees, axes, "degrees")?;
        let counts = counts_of(counts, axes, "counts")?;
        let mut report = FitReport::empty();
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_fit(
                self.raw(),
                degrees,
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                flags,
                fit_options_pointer(options, self.shape()),
                report.raw_mut(),
                out,
            )
        })?;
        Ok(Fitted { spline, report })
    }

    /// The same as `fit`; it can be watched and stopped.
    pub fn fit_with(
        &self,
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        options: Option<&FitOptions>,
        flags: u32,
        call: &mut Call,
    ) -> Result<Fitted> {
        let axes = self.axes()? as usize;
        let degrees = exactly(degrees, axes, "degrees")?;
        let counts = counts_of(counts, axes, "counts")?;
        let mut report = FitReport::empty();
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_fit_with(
                self.raw(),
                degrees,
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                flags,
                fit_options_pointer(options, self.shape()),
                report.raw_mut(),
                call.options(),
                out,
            )
        })?;
        Ok(Fitted { spline, report })
    }

    /// Pointwise standard errors of a fit over the knots of g.
    pub fn fit_errors<'a>(
        &self,
        g: &Spline,
        penalty_order: i32,
        lambda: f64,
        sigma: f64,
        params: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut errors = vec![0.0; n];
        check(unsafe {
            sys::nurbs_fit_errors(
                self.raw(),
                g.raw(),
                penalty_order,
                lambda,
                sigma,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                flags,
                errors.as_mut_ptr(),
            )
        })?;
        Ok(errors)
    }

    /// The same as `fit_errors`; it can be watched and stopped.
    pub fn fit_errors_with<'a>(
        &self,
        g: &Spline,
        penalty_order: i32,
        lambda: f64,
        sigma: f64,
        params: impl Into<Records<'a>>,
        flags: u32,
        call: &mut Call,
    ) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut errors = vec![0.0; n];
        check(unsafe {
            sys::nurbs_fit_errors_with(
                self.raw(),
                g.raw(),
                penalty_order,
                lambda,
                sigma,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                flags,
                errors.as_mut_ptr(),
                call.options(),
            )
        })?;
        Ok(errors)
    }

    /// Squares, freedom, GCV and REML, four numbers for each factor of the penalty.
    pub fn fit_criteria(&self, g: &Spline, penalty_order: i32, lambdas: &[f64]) -> Result<Vec<[f64; 4]>> {
        let n = lambdas.len();
        let mut values = vec![[0.0; 4]; n];
        check(unsafe {
            sys::nurbs_fit_criteria(
                self.raw(),
                g.raw(),
                penalty_order,
                n as i64,
                lambdas.as_ptr(),
                values.as_mut_ptr().cast(),
            )
        })?;
        Ok(values)
    }

    /// The same as `fit_criteria`; it can be watched and stopped.
    pub fn fit_criteria_with(
        &self,
        g: &Spline,
        penalty_order: i32,
        lambdas: &[f64],
        call: &mut Call,
    ) -> Result<Vec<[f64; 4]>> {
        let n = lambdas.len();
        let mut values = vec![[0.0; 4]; n];
        check(unsafe {
            sys::nurbs_fit_criteria_with(
                self.raw(),
                g.raw(),
                penalty_order,
                n as i64,
                lambdas.as_ptr(),
                values.as_mut_ptr().cast(),
                call.options(),
            )
        })?;
        Ok(values)
    }
}
