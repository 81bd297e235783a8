// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Features of curves and surfaces; `complete` tells that nothing was missed.

use crate::arrays::{bits, exactly, if_given, truths};
use crate::call::Call;
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

/// Parameters `[n][axes]`, the values there, a sum of `NURBS_EXTREMUM_` constants each, and the boxes
/// `[n][axes][2]` outside of which there is nothing.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Extrema {
    /// `[n][axes]`, in rising order of the first axis, then the second.
    pub params: Vec<f64>,
    /// Of the spline there.
    pub values: Vec<f64>,
    /// A sum of `NURBS_EXTREMUM_` constants each.
    pub found: Vec<u32>,
    /// Ranges of parameters, `[n][axes]` of lower and upper ends.
    pub boxes: Vec<[f64; 2]>,
    /// Whether nothing is undecided.
    pub complete: bool,
}

/// Lower ends of pieces, and 1, -1 or 0 where the curve rises, falls or stays.
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

/// Of each axis whether it closes and a bound of the gap; of each boundary, counted by axis, then by end,
/// whether it collapses and its size.
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

/// One of the `NURBS_FOLD_` constants, and parameters `[axes]` of either sign, NaN if none are known.
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

/// Which polynomial pieces of a surface or volume fold over.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct FoldPieces {
    /// A `NURBS_FOLD_` constant for each piece.
    pub folds: Vec<i32>,
    /// 1 or -1: the sign of J where it is not 0, if there is no fold; else 0.
    pub signs: Vec<i32>,
}

/// Features of curves and surfaces; `complete` tells that nothing was missed.
impl Spline {
    /// The features along a curve of these kinds, a sum of `NURBS_FEATURE_` constants.
    pub fn features(&self, kinds: u32) -> Result<Features> {
        let mut complete = 0;
        let mut fill = |cap, params, found, values, count| unsafe {
            sys::nurbs_curve_features(self.raw(), kinds, cap, params, found, values, count, &mut complete)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut found = vec![0; n];
        let mut values = vec![0.0; n];
        check(fill(count, params.as_mut_ptr(), found.as_mut_ptr(), values.as_mut_ptr(), &mut count))?;
        Ok(Features {
            found: (0..n)
                .map(|i| Feature { param: params[i], kind: found[i] as u32, value: values[i] })
                .collect(),
            complete: complete != 0,
        })
    }

    /// The same as `features`; it can be watched and stopped.
    pub fn features_with(&self, kinds: u32, call: &mut Call) -> Result<Features> {
        let mut complete = 0;
        let mut fill = |cap, params, found, values, count| unsafe {
            sys::nurbs_curve_features_with(
                self.raw(),
                kinds,
                cap,
                params,
                found,
                values,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut found = vec![0; n];
        let mut values = vec![0.0; n];
        check(fill(count, params.as_mut_ptr(), found.as_mut_ptr(), values.as_mut_ptr(), &mut count))?;
        Ok(Features {
            found: (0..n)
                .map(|i| Feature { param: params[i], kind: found[i] as u32, value: values[i] })
                .collect(),
            complete: complete != 0,
        })
    }

    /// Local extrema, saddles and plateaus of a scalar spline that have one of these kinds, a sum of
    /// `NURBS_EXTREMUM_` constants.
    pub fn extrema(&self, kinds: u32) -> Result<Extrema> {
        let mut complete = 0;
        let mut fill = |cap, params, values, found, boxes, count| unsafe {
            sys::nurbs_extrema(self.raw(), kinds, cap, params, values, found, boxes, count, &mut complete)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let axes = self.axes()? as usize;
        let mut params = vec![0.0; n * axes];
        let mut values = vec![0.0; n];
        let mut found = vec![0; n];
        let mut boxes = vec![[0.0; 2]; n * axes];
        check(fill(
            count,
            params.as_mut_ptr(),
            values.as_mut_ptr(),
            found.as_mut_ptr(),
            boxes.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(Extrema { params, values, found: bits(found), boxes, complete: complete != 0 })
    }

    /// The same as `extrema`; it can be watched and stopped.
    pub fn extrema_with(&self, kinds: u32, call: &mut Call) -> Result<Extrema> {
        let mut complete = 0;
        let mut fill = |cap, params, values, found, boxes, count| unsafe {
            sys::nurbs_extrema_with(
                self.raw(),
                kinds,
                cap,
                params,
                values,
                found,
                boxes,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let axes = self.axes()? as usize;
        let mut params = vec![0.0; n * axes];
        let mut values = vec![0.0; n];
        let mut found = vec![0; n];
        let mut boxes = vec![[0.0; 2]; n * axes];
        check(fill(
            count,
            params.as_mut_ptr(),
            values.as_mut_ptr(),
            found.as_mut_ptr(),
            boxes.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(Extrema { params, values, found: bits(found), boxes, complete: complete != 0 })
    }

    /// The pieces of a curve on which it runs one way along a direction `[dim]`.
    pub fn monotone_pieces(&self, direction: &[f64]) -> Result<MonotonePieces> {
        let direction = exactly(direction, self.dimension()? as usize, "direction")?;
        let mut complete = 0;
        let mut fill = |cap, starts, signs, count| unsafe {
            sys::nurbs_curve_monotone_pieces(self.raw(), direction, cap, starts, signs, count, &mut complete)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut starts = vec![0.0; n];
        let mut signs = vec![0; n];
        check(fill(count, starts.as_mut_ptr(), signs.as_mut_ptr(), &mut count))?;
        Ok(MonotonePieces {
            pieces: (0..n).map(|i| (starts[i], signs[i])).collect(),
            complete: complete != 0,
        })
    }

    /// One of the `NURBS_CONVEXITY_` constants, of a curve in the plane.
    pub fn convexity(&self) -> Result<i32> {
        value(|convexity| unsafe { sys::nurbs_curve_convexity(self.raw(), convexity) })
    }

    /// How far a spline is from a straight line.
    pub fn straightness(&self) -> Result<Straightness> {
        let dim = self.dimension()? as usize;
        let mut origin = vec![0.0; dim];
        let mut direction = vec![0.0; dim];
        let mut bound = 0.0;
        check(unsafe {
            sys::nurbs_straightness(self.raw(), origin.as_mut_ptr(), direction.as_mut_ptr(), &mut bound)
        })?;
        Ok(Straightness { origin, direction, bound })
    }

    /// How far a spline in space is from a plane.
    pub fn planarity(&self) -> Result<Planarity> {
        let mut origin = [0.0; 3];
        let mut normal = [0.0; 3];
        let mut bound = 0.0;
        check(unsafe {
            sys::nurbs_planarity(self.raw(), origin.as_mut_ptr(), normal.as_mut_ptr(), &mut bound)
        })?;
        Ok(Planarity { origin, normal, bound })
    }

    /// Which axes close, and which boundaries collapse.
    pub fn boundary_contacts(&self, tolerance: f64) -> Result<BoundaryContacts> {
        let axes = self.axes()? as usize;
        let mut closed = vec![0; axes];
        let mut gaps = vec![0.0; axes];
        let mut collapsed = vec![0; 2 * axes];
        let mut sizes = vec![0.0; 2 * axes];
        check(unsafe {
            sys::nurbs_boundary_contacts(
                self.raw(),
                tolerance,
                closed.as_mut_ptr(),
                gaps.as_mut_ptr(),
                collapsed.as_mut_ptr(),
                sizes.as_mut_ptr(),
            )
        })?;
        Ok(BoundaryContacts { closed: truths(closed), gaps, collapsed: truths(collapsed), sizes })
    }

    /// Places where a curve or surface is singular; the tolerance is a part of the domain.
    pub fn singular_points(&self, tolerance: f64) -> Result<SingularPoints> {
        let mut complete = 0;
        let mut fill = |cap, params, boxes, count| unsafe {
            sys::nurbs_singular_points(self.raw(), tolerance, cap, params, boxes, count, &mut complete)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let axes = self.axes()? as usize;
        let mut params = vec![0.0; n * axes];
        let mut boxes = vec![[0.0; 2]; n * axes];
        check(fill(count, params.as_mut_ptr(), boxes.as_mut_ptr().cast(), &mut count))?;
        Ok(SingularPoints { params, boxes, complete: complete != 0 })
    }

    /// Which polynomial pieces fold over, each by itself, in the order of the Bezier pieces; reference as for
    /// fold_test.
    pub fn fold_pieces(&self, reference: &[f64]) -> Result<FoldPieces> {
        let reference = if_given(reference, 3, "reference")?;
        let fill = |cap, folds, signs, count| unsafe {
            sys::nurbs_fold_pieces(self.raw(), reference, cap, folds, signs, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut folds = vec![0; n];
        let mut signs = vec![0; n];
        check(fill(count, folds.as_mut_ptr(), signs.as_mut_ptr(), &mut count))?;
        Ok(FoldPieces { folds, signs })
    }

    /// The same as `fold_pieces`; it can be watched and stopped.
    pub fn fold_pieces_with(&self, reference: &[f64], call: &mut Call) -> Result<FoldPieces> {
        let reference = if_given(reference, 3, "reference")?;
        let mut fill = |cap, folds, signs, count| unsafe {
            sys::nurbs_fold_pieces_with(self.raw(), reference, cap, folds, signs, count, call.options())
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut folds = vec![0; n];
        let mut signs = vec![0; n];
        check(fill(count, folds.as_mut_ptr(), signs.as_mut_ptr(), &mut count))?;
        Ok(FoldPieces { folds, signs })
    }

    /// Whether a surface or volume folds over; `reference` `[3]` is the direction that normals are compared
    /// with, or empty.
    pub fn fold_test(&self, reference: &[f64]) -> Result<Fold> {
        let reference = if_given(reference, 3, "reference")?;
        let mut result = 0;
        let axes = self.axes()? as usize;
        let mut positive = vec![0.0; axes];
        let mut negative = vec![0.0; axes];
        check(unsafe {
            sys::nurbs_fold_test(
                self.raw(),
                reference,
                &mut result,
                positive.as_mut_ptr(),
                negative.as_mut_ptr(),
            )
        })?;
        Ok(Fold { result, positive, negative })
    }

    /// The same as `fold_test`; it can be watched and stopped.
    pub fn fold_test_with(&self, reference: &[f64], call: &mut Call) -> Result<Fold> {
        let reference = if_given(reference, 3, "reference")?;
        let mut result = 0;
        let axes = self.axes()? as usize;
        let mut positive = vec![0.0; axes];
        let mut negative = vec![0.0; axes];
        check(unsafe {
            sys::nurbs_fold_test_with(
                self.raw(),
                reference,
                &mut result,
                positive.as_mut_ptr(),
                negative.as_mut_ptr(),
                call.options(),
            )
        })?;
        Ok(Fold { result, positive, negative })
    }
}
