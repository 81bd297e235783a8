// SPDX-License-Identifier: MIT
//! Lengths, areas and moments.

use crate::arrays::Records;
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

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

/// Length, area or volume, centroid `[dim]`, inertia `[dim][dim]` about it, and an estimate of the error of `content`.
/// Where the content is 0 there is no centroid: it and the inertia are NaN, as is what overflows; the same holds for what
/// curves and surfaces enclose.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Moments {
    /// Length, area or volume.
    pub content: f64,
    /// `[dim]`
    pub centroid: Vec<f64>,
    /// About the centroid, `[dim][dim]`.
    pub inertia: Vec<f64>,
    /// An estimate of the error of `content`.
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
    /// An estimate of the error of `area`.
    pub error: f64,
}

/// What surfaces enclose; `openness` is the length of the vector area, 0 of a closed shell.
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
    /// An estimate of the error of `volume`.
    pub error: f64,
}

/// Calls `f(centroid, inertia)`, which refuses what it cannot give if that is asked for: then it is asked for less, and
/// the rest is NaN. A content of 0 has no centroid, and inertia overflows first.
fn moments_of(
    centroid: &mut [f64],
    inertia: &mut [f64],
    mut f: impl FnMut(*mut f64, *mut f64) -> i32,
) -> Result<()> {
    let none = std::ptr::null_mut();
    let mut status = f(centroid.as_mut_ptr(), inertia.as_mut_ptr());
    if status == sys::NURBS_ERROR_NOT_REPRESENTABLE {
        inertia.fill(f64::NAN);
        status = f(centroid.as_mut_ptr(), none);
    }
    if status == sys::NURBS_ERROR_LENGTH || status == sys::NURBS_ERROR_NOT_REPRESENTABLE {
        centroid.fill(f64::NAN);
        inertia.fill(f64::NAN);
        status = f(none, none);
    }
    check(status)
}

fn handles(splines: &[&Spline]) -> Vec<*const sys::nurbs> {
    splines.iter().map(|spline| spline.raw()).collect()
}

/// The area of the region that closed chains of curves enclose; counterclockwise counts positive.
pub fn enclosed_area(curves: &[&Spline], tolerance: f64, relative_tolerance: f64) -> Result<EnclosedArea> {
    let (curves, mut found, mut inertia) = (handles(curves), EnclosedArea::default(), [0.0; 4]);
    let (area, error) = (&mut found.area, &mut found.error);
    moments_of(&mut found.centroid, &mut inertia, |centroid, inertia| unsafe {
        sys::nurbs_enclosed_area(
            curves.len() as i64,
            curves.as_ptr(),
            tolerance,
            relative_tolerance,
            area,
            centroid,
            inertia,
            error,
        )
    })?;
    for (i, value) in inertia.iter().enumerate() {
        found.inertia[i / 2][i % 2] = *value;
    }
    Ok(found)
}

/// The volume of the body that surfaces enclose whose normals point outwards.
pub fn enclosed_volume(surfaces: &[&Spline], relative_tolerance: f64) -> Result<EnclosedVolume> {
    let (surfaces, mut found, mut inertia) = (handles(surfaces), EnclosedVolume::default(), [0.0; 9]);
    let (volume, openness, error) = (&mut found.volume, &mut found.openness, &mut found.error);
    moments_of(&mut found.centroid, &mut inertia, |centroid, inertia| unsafe {
        sys::nurbs_enclosed_volume(
            surfaces.len() as i64,
            surfaces.as_ptr(),
            relative_tolerance,
            volume,
            centroid,
            inertia,
            openness,
            error,
        )
    })?;
    for (i, value) in inertia.iter().enumerate() {
        found.inertia[i / 3][i % 3] = *value;
    }
    Ok(found)
}

/// Measures. A range is a part `[axes][2]` of the domain, empty for all of it.
impl Spline {
    /// Length of a curve.
    pub fn length(&self, relative_tolerance: f64, range: &[f64]) -> Result<Measured> {
        let (part, mut found) = (self.range(range)?, Measured::default());
        let (value, error) = (&mut found.value, &mut found.error);
        check(unsafe { sys::nurbs_curve_length(self.raw(), part, relative_tolerance, value, error) })?;
        Ok(found)
    }
    /// Lengths from the start of the domain to parameters.
    pub fn lengths<'a>(&self, params: impl Into<Records<'a>>, relative_tolerance: f64) -> Result<Vec<f64>> {
        let p = params.into();
        let n = p.count(1, "params")?;
        let mut found = vec![0.0; n];
        let (first, stride, out) = (p.pointer(), p.step(), found.as_mut_ptr());
        check(unsafe {
            sys::nurbs_curve_lengths(self.raw(), n as i64, first, stride, relative_tolerance, out, 0)
        })?;
        Ok(found)
    }
    /// Parameters at lengths from the start of the domain; flags: 0 or `NURBS_CLAMP`.
    pub fn params_at_lengths<'a>(
        &self,
        lengths: impl Into<Records<'a>>,
        relative_tolerance: f64,
        flags: u32,
    ) -> Result<Vec<f64>> {
        let l = lengths.into();
        let n = l.count(1, "lengths")?;
        let mut found = vec![0.0; n];
        let (g, first, stride, out) = (self.raw(), l.pointer(), l.step(), found.as_mut_ptr());
        check(unsafe {
            sys::nurbs_curve_params_at_lengths(g, n as i64, first, stride, relative_tolerance, out, 0, flags)
        })?;
        Ok(found)
    }
    /// A curve in parts of equal length, or with `NURBS_EQUAL_CHORDS` with points at equal distances.
    pub fn divide(&self, parts: i64, relative_tolerance: f64, flags: u32, range: &[f64]) -> Result<Division> {
        let (g, part, mut size) = (self.raw(), self.range(range)?, 0.0);
        let mut params = vec![0.0; parts.max(0) as usize + 1];
        let out = params.as_mut_ptr();
        check(unsafe { sys::nurbs_curve_divide(g, part, parts, relative_tolerance, flags, out, &mut size) })?;
        Ok(Division { params, size })
    }
    /// Area of a surface.
    pub fn area(&self, relative_tolerance: f64, range: &[f64]) -> Result<Measured> {
        let (part, mut found) = (self.range(range)?, Measured::default());
        let (value, error) = (&mut found.value, &mut found.error);
        check(unsafe { sys::nurbs_surface_area(self.raw(), part, relative_tolerance, value, error) })?;
        Ok(found)
    }
    /// Of the spline itself: a wire, a sheet or a body.
    pub fn moments(&self, relative_tolerance: f64) -> Result<Moments> {
        let dim = self.dimension()? as usize;
        let mut found =
            Moments { centroid: vec![0.0; dim], inertia: vec![0.0; dim * dim], ..Moments::default() };
        let (content, error) = (&mut found.content, &mut found.error);
        moments_of(&mut found.centroid, &mut found.inertia, |centroid, inertia| unsafe {
            sys::nurbs_moments(self.raw(), relative_tolerance, content, centroid, inertia, error)
        })?;
        Ok(found)
    }
}
