// SPDX-License-Identifier: MIT
//! Data for fits, what a fit is to be, and what it tells: the structs of the library. Fits are in the module `fitting`.

use crate::arrays::Records;
use crate::error::{check, Result};
use crate::sys;
use std::marker::PhantomData;

/// Values at parameters, with weights or without.
#[derive(Clone, Copy, Debug)]
pub struct Data<'a> {
    raw: sys::nurbs_data,
    arrays: PhantomData<&'a [f64]>,
}

impl<'a> Data<'a> {
    /// `values`, `[n][dim]`, at `params`, `[n][axes]`.
    pub fn new(
        axes: usize,
        dim: usize,
        params: impl Into<Records<'a>>,
        values: impl Into<Records<'a>>,
    ) -> Result<Data<'a>> {
        let (params, values) = (params.into(), values.into());
        let n = params.count(axes, "params")?;
        values.require(n, dim, "values")?;
        let size = std::mem::size_of::<sys::nurbs_data>() as i64;
        let mut raw: sys::nurbs_data = unsafe { std::mem::zeroed() };
        check(unsafe { sys::nurbs_data_init(&mut raw, size) })?;
        raw.n = n as i64;
        raw.axes = i32::try_from(axes).unwrap_or(-1);
        raw.dim = i32::try_from(dim).unwrap_or(-1);
        raw.params = params.pointer();
        raw.param_stride = params.stride();
        raw.param_component_stride = params.component_stride();
        raw.values = values.pointer();
        raw.value_stride = values.stride();
        raw.value_component_stride = values.component_stride();
        Ok(Data { raw, arrays: PhantomData })
    }
    /// Weights, `[n]`, not negative; a value of weight 0 is left out.
    pub fn weights(mut self, weights: impl Into<Records<'a>>) -> Result<Data<'a>> {
        let weights = weights.into();
        weights.require(self.raw.n as usize, 1, "weights")?;
        self.raw.weights = weights.pointer();
        self.raw.weight_stride = weights.step();
        Ok(self)
    }
    /// Evaluation flags for the parameters.
    pub fn flags(mut self, flags: u32) -> Data<'a> {
        self.raw.flags = flags;
        self
    }
    pub(crate) fn raw(&self) -> *const sys::nurbs_data {
        &self.raw
    }
    pub(crate) fn axes(&self) -> Result<i32> {
        Ok(self.raw.axes)
    }
    /// Numbers of axes and of coordinates.
    pub(crate) fn shape(&self) -> (usize, usize) {
        (self.raw.axes.max(0) as usize, self.raw.dim.max(0) as usize)
    }
}

/// What a fit is to be besides close to the data; `FitOptions::new()` has the defaults. Arrays that are too short for the
/// data are refused as -1 conditions.
#[derive(Clone, Copy, Debug)]
pub struct FitOptions<'a> {
    raw: sys::nurbs_fit_options,
    wrong: sys::nurbs_fit_options,
    lengths: [usize; 6],
    arrays: PhantomData<&'a [f64]>,
}

const PARAMS: usize = 0;
const ORDERS: usize = 1;
const TARGETS: usize = 2;
const SHAPES: usize = 3;
const LOWER: usize = 4;
const UPPER: usize = 5;

impl<'a> FitOptions<'a> {
    /// The defaults.
    pub fn new() -> Result<FitOptions<'a>> {
        let size = std::mem::size_of::<sys::nurbs_fit_options>() as i64;
        let mut raw: sys::nurbs_fit_options = unsafe { std::mem::zeroed() };
        check(unsafe { sys::nurbs_fit_options_init(&mut raw, size) })?;
        let wrong = sys::nurbs_fit_options { conditions: -1, ..raw };
        Ok(FitOptions { raw, wrong, lengths: [0; 6], arrays: PhantomData })
    }
    /// How smooth, with a NURBS_SMOOTHING_ constant and, for those that need one, lambda or the target.
    pub fn smoothing(mut self, rule: i32, value: f64) -> FitOptions<'a> {
        self.raw.smoothing = rule;
        self.raw.lambda = if rule == sys::NURBS_SMOOTHING_LAMBDA { value } else { 0.0 };
        self.raw.target = if rule == sys::NURBS_SMOOTHING_DISCREPANCY { value } else { 0.0 };
        self
    }
    /// The derivative that is penalised.
    pub fn penalty_order(mut self, order: i32) -> FitOptions<'a> {
        self.raw.penalty_order = order;
        self
    }
    /// Of several fits take that of the smallest penalty.
    pub fn regularize(mut self) -> FitOptions<'a> {
        self.raw.regularize = 1;
        self
    }
    /// What outliers are worth, with a NURBS_ROBUST_ constant, and where they begin, in standard deviations; 0: as usual.
    pub fn robust(mut self, rule: i32, width: f64) -> FitOptions<'a> {
        self.raw.robust = rule;
        self.raw.robust_width = width;
        self
    }
    /// Sums of NURBS_TREND_ constants, `[axes][dim]`.
    pub fn shapes(mut self, shapes: &'a [i32]) -> FitOptions<'a> {
        self.raw.shapes = shapes.as_ptr();
        self.lengths[SHAPES] = shapes.len();
        self
    }
    /// Lower bounds, `[dim]`.
    pub fn lower(mut self, bounds: &'a [f64]) -> FitOptions<'a> {
        self.raw.lower = bounds.as_ptr();
        self.lengths[LOWER] = bounds.len();
        self
    }
    /// Upper bounds, `[dim]`.
    pub fn upper(mut self, bounds: &'a [f64]) -> FitOptions<'a> {
        self.raw.upper = bounds.as_ptr();
        self.lengths[UPPER] = bounds.len();
        self
    }
    /// Equations that have to hold: derivative `orders[i]` (empty: 0) at `params[i]` is `targets[i]`, packed.
    pub fn conditions(
        mut self,
        axes: usize,
        params: &'a [f64],
        orders: &'a [i32],
        targets: &'a [f64],
    ) -> FitOptions<'a> {
        self.raw.conditions = (params.len() / axes.max(1)) as i64;
        self.raw.condition_params = params.as_ptr();
        self.raw.condition_orders = if orders.is_empty() { std::ptr::null() } else { orders.as_ptr() };
        self.raw.condition_targets = targets.as_ptr();
        self.lengths[PARAMS] = params.len();
        self.lengths[ORDERS] = orders.len();
        self.lengths[TARGETS] = targets.len();
        self
    }
    /// Whether all arrays are as long as numbers of axes and coordinates ask for.
    fn suits(&self, axes: usize, dim: usize) -> bool {
        let count = self.raw.conditions.max(0) as usize;
        let given = |pointer: bool, array: usize, length: usize| !pointer || self.lengths[array] == length;
        given(count > 0 || self.lengths[PARAMS] > 0, PARAMS, count * axes)
            && given(!self.raw.condition_orders.is_null(), ORDERS, count * axes)
            && given(count > 0, TARGETS, count * dim)
            && given(!self.raw.shapes.is_null(), SHAPES, axes * dim)
            && given(!self.raw.lower.is_null(), LOWER, dim)
            && given(!self.raw.upper.is_null(), UPPER, dim)
    }
}

/// NULL without settings.
pub(crate) fn fit_options_pointer(
    options: Option<&FitOptions>,
    shape: (usize, usize),
) -> *const sys::nurbs_fit_options {
    options.map_or(std::ptr::null(), |o| if o.suits(shape.0, shape.1) { &o.raw } else { &o.wrong })
}

/// What a fit tells: the fields of `nurbs_fit_report`.
#[derive(Clone, Copy, Debug)]
pub struct FitReport {
    raw: sys::nurbs_fit_report,
}

impl FitReport {
    pub(crate) fn empty() -> FitReport {
        let mut raw: sys::nurbs_fit_report = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::nurbs_fit_report>() as i64;
        FitReport { raw }
    }
    pub(crate) fn raw_mut(&mut self) -> *mut sys::nurbs_fit_report {
        &mut self.raw
    }
}

impl std::ops::Deref for FitReport {
    type Target = sys::nurbs_fit_report;
    fn deref(&self) -> &sys::nurbs_fit_report {
        &self.raw
    }
}

impl PartialEq for FitReport {
    fn eq(&self, other: &FitReport) -> bool {
        format!("{:?}", self.raw) == format!("{:?}", other.raw)
    }
}

/// How a fit of points without parameters goes on; `CloudOptions::new()` has the defaults.
#[derive(Clone, Copy, Debug)]
pub struct CloudOptions {
    raw: sys::nurbs_cloud_options,
}

impl CloudOptions {
    /// The defaults.
    pub fn new() -> Result<CloudOptions> {
        let size = std::mem::size_of::<sys::nurbs_cloud_options>() as i64;
        let mut raw: sys::nurbs_cloud_options = unsafe { std::mem::zeroed() };
        check(unsafe { sys::nurbs_cloud_options_init(&mut raw, size) })?;
        Ok(CloudOptions { raw })
    }
    /// The derivative that is penalised.
    pub fn penalty_order(mut self, order: i32) -> CloudOptions {
        self.raw.penalty_order = order;
        self
    }
    /// Most searches for the nearest points of all points.
    pub fn rounds(mut self, rounds: i32) -> CloudOptions {
        self.raw.rounds = rounds;
        self
    }
    /// The factor of the penalty; below 0 it is found.
    pub fn lambda(mut self, lambda: f64) -> CloudOptions {
        self.raw.lambda = lambda;
        self
    }
    /// The factor to begin with; below 0 it is found.
    pub fn first_lambda(mut self, lambda: f64) -> CloudOptions {
        self.raw.first_lambda = lambda;
        self
    }
    /// The smallest part of the sum whose loss is worth a step.
    pub fn tolerance(mut self, tolerance: f64) -> CloudOptions {
        self.raw.tolerance = tolerance;
        self
    }
}

/// NULL without settings.
pub(crate) fn cloud_options_pointer(options: Option<&CloudOptions>) -> *const sys::nurbs_cloud_options {
    options.map_or(std::ptr::null(), |o| &o.raw)
}

/// What a fit of points without parameters tells: the fields of `nurbs_cloud_report`.
#[derive(Clone, Copy, Debug)]
pub struct CloudReport {
    raw: sys::nurbs_cloud_report,
}

impl CloudReport {
    pub(crate) fn empty() -> CloudReport {
        let mut raw: sys::nurbs_cloud_report = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::nurbs_cloud_report>() as i64;
        CloudReport { raw }
    }
    pub(crate) fn raw_mut(&mut self) -> *mut sys::nurbs_cloud_report {
        &mut self.raw
    }
}

impl std::ops::Deref for CloudReport {
    type Target = sys::nurbs_cloud_report;
    fn deref(&self) -> &sys::nurbs_cloud_report {
        &self.raw
    }
}

impl PartialEq for CloudReport {
    fn eq(&self, other: &CloudReport) -> bool {
        format!("{:?}", self.raw) == format!("{:?}", other.raw)
    }
}
