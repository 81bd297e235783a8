// SPDX-License-Identifier: MIT
//! Curves, surfaces and volumes: the handle. What can be asked of it is in the modules beside this one.

use crate::error::{check, Result};
use crate::list::bytes_of;
use crate::sys;
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// A curve, surface or volume: an immutable handle, freed when dropped.
pub struct Spline {
    handle: NonNull<sys::nurbs>,
}

// A spline never changes, its count of references is atomic, and its tables are built thread-safely.
unsafe impl Send for Spline {}
unsafe impl Sync for Spline {}

impl Drop for Spline {
    fn drop(&mut self) {
        unsafe { sys::nurbs_destroy(self.handle.as_ptr()) }
    }
}

impl Clone for Spline {
    /// Another handle on the same data. Panics when memory is exhausted; `try_clone` does not.
    fn clone(&self) -> Spline {
        self.try_clone().expect("cloning a spline")
    }
}

impl fmt::Debug for Spline {
    /// What it is, without its knots and points.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axes = 0..self.axes().unwrap_or(0);
        f.debug_struct("Spline")
            .field("degrees", &axes.clone().map(|k| self.degree(k).unwrap_or(0)).collect::<Vec<_>>())
            .field("counts", &axes.map(|k| self.count(k).unwrap_or(0)).collect::<Vec<_>>())
            .field("dimension", &self.dimension().unwrap_or(0))
            .field("rational", &self.is_rational().unwrap_or(false))
            .finish()
    }
}

impl PartialEq for Spline {
    /// Whether the values that are stored are equal: degrees, knots, points, weights, and which axes are periodic. The same
    /// shape in another form, as with one knot more, is another spline; a polynomial spline is not equal to a rational one
    /// whose weights are all 1. Panics when memory is exhausted.
    fn eq(&self, other: &Spline) -> bool {
        self.same_values(other).expect("comparing splines")
    }
}

impl Spline {
    /// Takes over a handle.
    ///
    /// # Safety
    ///
    /// It is one of the library's, and nobody else destroys it.
    pub(crate) unsafe fn owned(handle: *mut sys::nurbs) -> Spline {
        let handle = NonNull::new(handle).expect("the library returned success without a handle");
        Spline { handle }
    }

    /// The spline that `call` writes to its argument.
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs) -> i32) -> Result<Spline> {
        let mut out = null_mut();
        check(call(&mut out))?;
        Ok(unsafe { Spline::owned(out) })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this spline.
    pub fn raw(&self) -> *const sys::nurbs {
        self.handle.as_ptr()
    }

    /// To be kept or sent: the same on every machine for the same spline.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        bytes_of(|cap, bytes, length| unsafe { sys::nurbs_to_bytes(self.raw(), cap, bytes, length) })
    }

    fn same_values(&self, other: &Spline) -> Result<bool> {
        if self.handle == other.handle {
            return Ok(true);
        }
        Ok(self.same_kind(other)? && self.same_axes(other)? && self.same_points(other)?)
    }

    fn same_kind(&self, other: &Spline) -> Result<bool> {
        Ok(self.axes()? == other.axes()?
            && self.dimension()? == other.dimension()?
            && self.is_rational()? == other.is_rational()?
            && self.is_homogeneous()? == other.is_homogeneous()?)
    }

    fn same_axes(&self, other: &Spline) -> Result<bool> {
        for axis in 0..self.axes()? {
            let periodic = |spline: &Spline| Ok(spline.knot_form(axis)? & sys::NURBS_FORM_PERIODIC);
            let same = self.degree(axis)? == other.degree(axis)?
                && periodic(self)? == periodic(other)?
                && self.knots(axis)? == other.knots(axis)?;
            if !same {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Homogeneous points where these are stored; then Cartesian ones may not exist.
    fn same_points(&self, other: &Spline) -> Result<bool> {
        if self.is_homogeneous()? {
            return Ok(self.homogeneous_points()? == other.homogeneous_points()?);
        }
        Ok(self.points()? == other.points()?
            && (!self.is_rational()? || self.weights()? == other.weights()?))
    }
}

/// The handles of splines of which some may be missing.
pub(crate) fn some_handles(splines: &[Option<&Spline>]) -> Vec<*const sys::nurbs> {
    splines.iter().map(|spline| spline.map_or(std::ptr::null(), Spline::raw)).collect()
}

/// The handles of splines.
pub(crate) fn handles(splines: &[&Spline]) -> Vec<*const sys::nurbs> {
    splines.iter().map(|spline| spline.raw()).collect()
}
