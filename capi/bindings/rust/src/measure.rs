// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Lengths, areas and moments.

use crate::arrays::{flat, if_given, Records};
use crate::call::Call;
use crate::error::{check, Result};
use crate::moments::moments_of;
use crate::sizes::positive;
use crate::spline::{handles, Spline};
use crate::sys;
use std::ptr::null_mut;

/// An integral, and an estimate of its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Measured {
    /// The integral.
    pub value: f64,
    /// An estimate of its error.
    pub error: f64,
}

/// Parameters `[parts + 1]`, and the length or chord of a part.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Division {
    /// `[parts + 1]`
    pub params: Vec<f64>,
    /// The length or the chord of a part.
    pub size: f64,
}

/// Length, area or volume, centroid `[dim]`, inertia `[dim][dim]` about it, and an estimate of the error of
/// content. Where the content is 0 there is no centroid: it and the inertia are NaN, as is what overflows;
/// the same holds for what curves and surfaces enclose.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Moments {
    /// Length, area or volume.
    pub content: f64,
    /// `[dim]`
    pub centroid: Vec<f64>,
    /// About the centroid, `[dim][dim]`.
    pub inertia: Vec<f64>,
    /// An estimate of the error of the content.
    pub error: f64,
}

/// What curves in the plane enclose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct EnclosedArea {
    /// Positive inside counterclockwise curves.
    pub area: f64,
    /// Of the region.
    pub centroid: [f64; 2],
    /// About the centroid.
    pub inertia: [[f64; 2]; 2],
    /// An estimate of the error of the area.
    pub error: f64,
}

/// What surfaces enclose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct EnclosedVolume {
    /// Positive if the normals point outwards.
    pub volume: f64,
    /// Of the body.
    pub centroid: [f64; 3],
    /// About the centroid.
    pub inertia: [[f64; 3]; 3],
    /// The length of the vector area: 0 of a closed shell.
    pub openness: f64,
    /// An estimate of the error of the volume.
    pub error: f64,
}

/// Points and weights of rules on the spans of a spline.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Quadrature {
    /// Parameters `[axes]` of the points, packed.
    pub params: Vec<f64>,
    /// Weights of the parameters.
    pub weights: Vec<f64>,
    /// Weights of lengths, areas or volumes.
    pub measures: Vec<f64>,
}

/// The area of the region that closed chains of curves enclose; counterclockwise counts positive.
pub fn enclosed_area(curves: &[&Spline], tolerance: f64, relative_tolerance: f64) -> Result<EnclosedArea> {
    let curves = handles(curves);
    let mut area = 0.0;
    let mut centroid = [0.0; 2];
    let mut inertia = [[0.0; 2]; 2];
    let mut error = 0.0;
    moments_of(&mut centroid, flat(&mut inertia), |centroid, inertia| unsafe {
        sys::nurbs_enclosed_area(
            curves.len() as i64,
            curves.as_ptr(),
            tolerance,
            relative_tolerance,
            &mut area,
            centroid,
            inertia,
            &mut error,
        )
    })?;
    Ok(EnclosedArea { area, centroid, inertia, error })
}

/// The same as `enclosed_area`; it can be watched and stopped.
pub fn enclosed_area_with(
    curves: &[&Spline],
    tolerance: f64,
    relative_tolerance: f64,
    call: &mut Call,
) -> Result<EnclosedArea> {
    let curves = handles(curves);
    let mut area = 0.0;
    let mut centroid = [0.0; 2];
    let mut inertia = [[0.0; 2]; 2];
    let mut error = 0.0;
    moments_of(&mut centroid, flat(&mut inertia), |centroid, inertia| unsafe {
        sys::nurbs_enclosed_area_with(
            curves.len() as i64,
            curves.as_ptr(),
            tolerance,
            relative_tolerance,
            &mut area,
            centroid,
            inertia,
            &mut error,
            call.options(),
        )
    })?;
    Ok(EnclosedArea { area, centroid, inertia, error })
}

/// The volume of the body that surfaces enclose whose normals point outwards.
pub fn enclosed_volume(surfaces: &[&Spline], relative_tolerance: f64) -> Result<EnclosedVolume> {
    let surfaces = handles(surfaces);
    let mut volume = 0.0;
    let mut centroid = [0.0; 3];
    let mut inertia = [[0.0; 3]; 3];
    let mut openness = 0.0;
    let mut error = 0.0;
    moments_of(&mut centroid, flat(&mut inertia), |centroid, inertia| unsafe {
        sys::nurbs_enclosed_volume(
            surfaces.len() as i64,
            surfaces.as_ptr(),
            relative_tolerance,
            &mut volume,
            centroid,
            inertia,
            &mut openness,
            &mut error,
        )
    })?;
    Ok(EnclosedVolume { volume, centroid, inertia, openness, error })
}

/// The same as `enclosed_volume`; it can be watched and stopped.
pub fn enclosed_volume_with(
    surfaces: &[&Spline],
    relative_tolerance: f64,
    call: &mut Call,
) -> Result<EnclosedVolume> {
    let surfaces = handles(surfaces);
    let mut volume = 0.0;
    let mut centroid = [0.0; 3];
    let mut inertia = [[0.0; 3]; 3];
    let mut openness = 0.0;
    let mut error = 0.0;
    moments_of(&mut centroid, flat(&mut inertia), |centroid, inertia| unsafe {
        sys::nurbs_enclosed_volume_with(
            surfaces.len() as i64,
            surfaces.as_ptr(),
            relative_tolerance,
            &mut volume,
            centroid,
            inertia,
            &mut openness,
            &mut error,
            call.options(),
        )
    })?;
    Ok(EnclosedVolume { volume, centroid, inertia, openness, error })
}

/// Lengths, areas and moments.
impl Spline {
    /// Length of a curve over a range `[2]` of its domain, or all of it.
    pub fn length(&self, relative_tolerance: f64, range: &[f64]) -> Result<Measured> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_curve_length(self.raw(), range, relative_tolerance, &mut value, &mut error)
        })?;
        Ok(Measured { value, error })
    }

    /// The same as `length`; it can be watched and stopped.
    pub fn length_with(&self, relative_tolerance: f64, range: &[f64], call: &mut Call) -> Result<Measured> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_curve_length_with(
                self.raw(),
                range,
                relative_tolerance,
                &mut value,
                &mut error,
                call.options(),
            )
        })?;
        Ok(Measured { value, error })
    }

    /// Lengths from the start of the domain to parameters.
    pub fn lengths<'a>(&self, params: impl Into<Records<'a>>, relative_tolerance: f64) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(1, "params")?;
        let mut lengths = vec![0.0; n];
        check(unsafe {
            sys::nurbs_curve_lengths(
                self.raw(),
                n as i64,
                params.pointer(),
                params.step(),
                relative_tolerance,
                lengths.as_mut_ptr(),
                0,
            )
        })?;
        Ok(lengths)
    }

    /// The same as `lengths`; it can be watched and stopped.
    pub fn lengths_with<'a>(
        &self,
        params: impl Into<Records<'a>>,
        relative_tolerance: f64,
        call: &mut Call,
    ) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(1, "params")?;
        let mut lengths = vec![0.0; n];
        check(unsafe {
            sys::nurbs_curve_lengths_with(
                self.raw(),
                n as i64,
                params.pointer(),
                params.step(),
                relative_tolerance,
                lengths.as_mut_ptr(),
                0,
                call.options(),
            )
        })?;
        Ok(lengths)
    }

    /// Parameters at lengths from the start of the domain; flags: 0 or `NURBS_CLAMP`.
    pub fn params_at_lengths<'a>(
        &self,
        lengths: impl Into<Records<'a>>,
        relative_tolerance: f64,
        flags: u32,
    ) -> Result<Vec<f64>> {
        let lengths = lengths.into();
        let n = lengths.count(1, "lengths")?;
        let mut params = vec![0.0; n];
        check(unsafe {
            sys::nurbs_curve_params_at_lengths(
                self.raw(),
                n as i64,
                lengths.pointer(),
                lengths.step(),
                relative_tolerance,
                params.as_mut_ptr(),
                0,
                flags,
            )
        })?;
        Ok(params)
    }

    /// The same as `params_at_lengths`; it can be watched and stopped.
    pub fn params_at_lengths_with<'a>(
        &self,
        lengths: impl Into<Records<'a>>,
        relative_tolerance: f64,
        flags: u32,
        call: &mut Call,
    ) -> Result<Vec<f64>> {
        let lengths = lengths.into();
        let n = lengths.count(1, "lengths")?;
        let mut params = vec![0.0; n];
        check(unsafe {
            sys::nurbs_curve_params_at_lengths_with(
                self.raw(),
                n as i64,
                lengths.pointer(),
                lengths.step(),
                relative_tolerance,
                params.as_mut_ptr(),
                0,
                flags,
                call.options(),
            )
        })?;
        Ok(params)
    }

    /// A curve in parts of equal length, or with `NURBS_EQUAL_CHORDS` with points at equal distances.
    pub fn divide(&self, parts: i64, relative_tolerance: f64, flags: u32, range: &[f64]) -> Result<Division> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut params = vec![0.0; positive(parts) + 1];
        let mut size = 0.0;
        check(unsafe {
            sys::nurbs_curve_divide(
                self.raw(),
                range,
                parts,
                relative_tolerance,
                flags,
                params.as_mut_ptr(),
                &mut size,
            )
        })?;
        Ok(Division { params, size })
    }

    /// The same as `divide`; it can be watched and stopped.
    pub fn divide_with(
        &self,
        parts: i64,
        relative_tolerance: f64,
        flags: u32,
        range: &[f64],
        call: &mut Call,
    ) -> Result<Division> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut params = vec![0.0; positive(parts) + 1];
        let mut size = 0.0;
        check(unsafe {
            sys::nurbs_curve_divide_with(
                self.raw(),
                range,
                parts,
                relative_tolerance,
                flags,
                params.as_mut_ptr(),
                &mut size,
                call.options(),
            )
        })?;
        Ok(Division { params, size })
    }

    /// Area of a surface over a range `[2][2]` of its domain, or all of it.
    pub fn area(&self, relative_tolerance: f64, range: &[f64]) -> Result<Measured> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_surface_area(self.raw(), range, relative_tolerance, &mut value, &mut error)
        })?;
        Ok(Measured { value, error })
    }

    /// The same as `area`; it can be watched and stopped.
    pub fn area_with(&self, relative_tolerance: f64, range: &[f64], call: &mut Call) -> Result<Measured> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_surface_area_with(
                self.raw(),
                range,
                relative_tolerance,
                &mut value,
                &mut error,
                call.options(),
            )
        })?;
        Ok(Measured { value, error })
    }

    /// The moments of the spline itself: a wire, a sheet or a body.
    pub fn moments(&self, relative_tolerance: f64) -> Result<Moments> {
        let mut content = 0.0;
        let dim = self.dimension()? as usize;
        let mut centroid = vec![0.0; dim];
        let mut inertia = vec![0.0; dim * dim];
        let mut error = 0.0;
        moments_of(&mut centroid, &mut inertia, |centroid, inertia| unsafe {
            sys::nurbs_moments(self.raw(), relative_tolerance, &mut content, centroid, inertia, &mut error)
        })?;
        Ok(Moments { content, centroid, inertia, error })
    }

    /// The same as `moments`; it can be watched and stopped.
    pub fn moments_with(&self, relative_tolerance: f64, call: &mut Call) -> Result<Moments> {
        let mut content = 0.0;
        let dim = self.dimension()? as usize;
        let mut centroid = vec![0.0; dim];
        let mut inertia = vec![0.0; dim * dim];
        let mut error = 0.0;
        moments_of(&mut centroid, &mut inertia, |centroid, inertia| unsafe {
            sys::nurbs_moments_with(
                self.raw(),
                relative_tolerance,
                &mut content,
                centroid,
                inertia,
                &mut error,
                call.options(),
            )
        })?;
        Ok(Moments { content, centroid, inertia, error })
    }

    /// Points and weights for integrals of any function: so many nodes along each axis of a span, 0 for one
    /// more than the degree.
    pub fn quadrature(&self, nodes: i32) -> Result<Quadrature> {
        let fill = |cap, params, weights, measures, count| unsafe {
            sys::nurbs_quadrature(self.raw(), nodes, cap, params, weights, measures, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n * self.axes()? as usize];
        let mut weights = vec![0.0; n];
        let mut measures = vec![0.0; n];
        check(fill(count, params.as_mut_ptr(), weights.as_mut_ptr(), measures.as_mut_ptr(), &mut count))?;
        Ok(Quadrature { params, weights, measures })
    }
}
