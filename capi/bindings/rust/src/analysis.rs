// SPDX-License-Identifier: MIT
//! Features of curves and surfaces; `complete` tells that nothing was missed.

use crate::arrays::{exactly, if_given};
use crate::error::{check, value, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Where it is, one `NURBS_FEATURE_` constant, and the curvature, turning angle or width there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Feature {
    /// Where it is.
    pub param: f64,
    /// One of the `NURBS_FEATURE_` constants.
    pub kind: u32,
    /// Curvature, turning angle or width there.
    pub value: f64,
}

/// Features in rising order of their parameters.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Features {
    /// In rising order of their parameters.
    pub found: Vec<Feature>,
    /// Whether nothing was missed.
    pub complete: bool,
}

/// Lower ends of pieces, with 1, -1 or 0 where the curve rises, falls or stays.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MonotonePieces {
    /// Lower ends, and 1, -1 or 0 where the curve rises, falls or stays.
    pub pieces: Vec<(f64, i32)>,
    /// Whether nothing was missed.
    pub complete: bool,
}

/// A line, and a proven bound of the distance from it.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Straightness {
    /// A point of the line, `[dim]`.
    pub origin: Vec<f64>,
    /// Its direction, `[dim]`.
    pub direction: Vec<f64>,
    /// A proven bound of the distance from it.
    pub bound: f64,
}

/// A plane, and a proven bound of the distance from it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Planarity {
    /// A point of the plane.
    pub origin: [f64; 3],
    /// Its unit normal.
    pub normal: [f64; 3],
    /// A proven bound of the distance from it.
    pub bound: f64,
}

/// Of each axis whether it closes and a bound of the gap; of each boundary, counted by axis, then by end, whether it
/// collapses and its size.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BoundaryContacts {
    /// Of each axis, whether it closes.
    pub closed: Vec<bool>,
    /// Of each axis, a bound of the gap.
    pub gaps: Vec<f64>,
    /// Of each boundary, by axis, then by end, whether it is a point.
    pub collapsed: Vec<bool>,
    /// Of each boundary, its size.
    pub sizes: Vec<f64>,
}

/// Parameters `[n][axes]`, and the boxes `[n][axes][2]` in which the singular sets lie.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SingularPoints {
    /// `[n][axes]`
    pub params: Vec<f64>,
    /// Boxes in which the singular sets lie, `[n][axes]` of lower and upper ends.
    pub boxes: Vec<[f64; 2]>,
    /// Whether nothing was missed.
    pub complete: bool,
}

/// A `NURBS_FOLD_` constant, and parameters `[axes]` of either sign, NaN if none are known.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Fold {
    /// One of the `NURBS_FOLD_` constants.
    pub result: i32,
    /// Parameters `[axes]` where the sign is positive, NaN if none are known.
    pub positive: Vec<f64>,
    /// Parameters `[axes]` where the sign is negative, NaN if none are known.
    pub negative: Vec<f64>,
}

fn truths(values: Vec<i32>) -> Vec<bool> {
    values.into_iter().map(|value| value != 0).collect()
}

/// Features.
impl Spline {
    /// The features along a curve of these kinds, a sum of `NURBS_FEATURE_` constants.
    pub fn features(&self, kinds: u32) -> Result<Features> {
        let (g, none, mut n, mut complete) = (self.raw(), null_mut(), 0i64, 0);
        check(unsafe {
            sys::nurbs_curve_features(g, kinds, 0, none, null_mut(), none, &mut n, &mut complete)
        })?;
        let size = n as usize;
        let (mut params, mut found, mut values) = (vec![0.0; size], vec![0; size], vec![0.0; size]);
        let (p, f, v) = (params.as_mut_ptr(), found.as_mut_ptr(), values.as_mut_ptr());
        check(unsafe { sys::nurbs_curve_features(g, kinds, n, p, f, v, &mut n, &mut complete) })?;
        let one = |i: usize| Feature { param: params[i], kind: found[i] as u32, value: values[i] };
        Ok(Features { found: (0..size).map(one).collect(), complete: complete != 0 })
    }
    /// The pieces of a curve on which it runs one way along a direction.
    pub fn monotone_pieces(&self, direction: &[f64]) -> Result<MonotonePieces> {
        let along = exactly(direction, self.dimension()? as usize, "direction")?;
        let (g, mut n, mut complete) = (self.raw(), 0i64, 0);
        check(unsafe {
            sys::nurbs_curve_monotone_pieces(g, along, 0, null_mut(), null_mut(), &mut n, &mut complete)
        })?;
        let (mut starts, mut signs) = (vec![0.0; n as usize], vec![0; n as usize]);
        let (at, sign) = (starts.as_mut_ptr(), signs.as_mut_ptr());
        check(unsafe { sys::nurbs_curve_monotone_pieces(g, along, n, at, sign, &mut n, &mut complete) })?;
        Ok(MonotonePieces { pieces: starts.into_iter().zip(signs).collect(), complete: complete != 0 })
    }
    /// A `NURBS_CONVEXITY_` constant of a curve in the plane.
    pub fn convexity(&self) -> Result<i32> {
        value(|v| unsafe { sys::nurbs_curve_convexity(self.raw(), v) })
    }
    /// How far a spline is from a straight line.
    pub fn straightness(&self) -> Result<Straightness> {
        let dim = self.dimension()? as usize;
        let (mut origin, mut direction) = (vec![0.0; dim], vec![0.0; dim]);
        let (o, d) = (origin.as_mut_ptr(), direction.as_mut_ptr());
        let bound = value(|v| unsafe { sys::nurbs_straightness(self.raw(), o, d, v) })?;
        Ok(Straightness { origin, direction, bound })
    }
    /// How far a spline in space is from a plane.
    pub fn planarity(&self) -> Result<Planarity> {
        let mut found = Planarity::default();
        let (o, n) = (found.origin.as_mut_ptr(), found.normal.as_mut_ptr());
        check(unsafe { sys::nurbs_planarity(self.raw(), o, n, &mut found.bound) })?;
        Ok(found)
    }
    /// Which axes close, and which boundaries collapse.
    pub fn boundary_contacts(&self, tolerance: f64) -> Result<BoundaryContacts> {
        let axes = self.axes()? as usize;
        let (mut closed, mut collapsed) = (vec![0; axes], vec![0; 2 * axes]);
        let (mut gaps, mut sizes) = (vec![0.0; axes], vec![0.0; 2 * axes]);
        let (c, b) = (closed.as_mut_ptr(), collapsed.as_mut_ptr());
        let (g, s) = (gaps.as_mut_ptr(), sizes.as_mut_ptr());
        check(unsafe { sys::nurbs_boundary_contacts(self.raw(), tolerance, c, g, b, s) })?;
        Ok(BoundaryContacts { closed: truths(closed), gaps, collapsed: truths(collapsed), sizes })
    }
    /// Places where a curve or surface is singular; the tolerance is a part of the domain.
    pub fn singular_points(&self, tolerance: f64) -> Result<SingularPoints> {
        let (g, axes, none) = (self.raw(), self.axes()? as usize, null_mut());
        let (mut n, mut complete) = (0i64, 0);
        check(unsafe { sys::nurbs_singular_points(g, tolerance, 0, none, none, &mut n, &mut complete) })?;
        let size = n as usize * axes;
        let (mut params, mut boxes) = (vec![0.0; size], vec![[0.0; 2]; size]);
        let (p, b) = (params.as_mut_ptr(), boxes.as_mut_ptr().cast());
        check(unsafe { sys::nurbs_singular_points(g, tolerance, n, p, b, &mut n, &mut complete) })?;
        Ok(SingularPoints { params, boxes, complete: complete != 0 })
    }
    /// Whether a surface or volume folds over; `reference` `[3]` is the direction that normals are compared with, or
    /// empty.
    pub fn fold_test(&self, reference: &[f64]) -> Result<Fold> {
        let (axes, toward) = (self.axes()? as usize, if_given(reference, 3, "reference")?);
        let mut fold = Fold { positive: vec![0.0; axes], negative: vec![0.0; axes], ..Fold::default() };
        let (result, p, n) = (&mut fold.result, fold.positive.as_mut_ptr(), fold.negative.as_mut_ptr());
        check(unsafe { sys::nurbs_fold_test(self.raw(), toward, result, p, n) })?;
        Ok(fold)
    }
}
