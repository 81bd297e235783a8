// SPDX-License-Identifier: MIT
//! Curves, surfaces and volumes.

use crate::arrays::Records;
use crate::error::{check, value, Error, Result};
use crate::sys;
use std::fmt;
use std::ptr::{null, null_mut, NonNull};

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

/// Knots without repetition.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DistinctKnots {
    /// In rising order.
    pub knots: Vec<f64>,
    /// How often each of them occurs.
    pub multiplicities: Vec<i32>,
}

/// Number of partial derivatives of orders 0 to `order`: binomial(order + axes, axes).
pub fn derivative_slots(axes: i32, order: i32) -> Result<usize> {
    let slots = value(|v: *mut i64| unsafe { sys::nurbs_derivative_slots(axes, order, v) })?;
    Ok(slots as usize)
}

/// The arguments that all constructors share, their lengths checked.
struct Net<'a> {
    degrees: &'a [i32],
    counts: Vec<i64>,
    points: Records<'a>,
    weights: *const f64,
}

impl<'a> Net<'a> {
    fn new(
        degrees: &'a [i32],
        counts: &[usize],
        width: usize,
        points: Records<'a>,
        weights: Option<&'a [f64]>,
    ) -> Result<Net<'a>> {
        if counts.len() != degrees.len() {
            return Err(Error::size("counts", counts.len(), degrees.len().to_string()));
        }
        let n = counts.iter().fold(1usize, |product, &count| product.saturating_mul(count));
        // A dimension below 1 is left to the library to name.
        if width > 0 {
            points.require(n, width, "points")?;
        }
        match weights {
            Some(w) if w.len() != n => Err(Error::size("weights", w.len(), n.to_string())),
            _ => Ok(Net {
                degrees,
                counts: counts.iter().map(|&count| count as i64).collect(),
                points,
                weights: weights.map_or(null(), <[f64]>::as_ptr),
            }),
        }
    }
    fn axes(&self) -> i32 {
        // More than the library takes is as good as any number of them.
        self.degrees.len().min(sys::NURBS_MAX_AXES as usize + 1) as i32
    }
}

fn width(dim: i32) -> usize {
    dim.max(0) as usize
}

/// Construction. Without weights a spline is polynomial.
impl Spline {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs) -> i32) -> Result<Spline> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without a handle");
        Ok(Spline { handle })
    }

    /// A spline from full knot vectors, all axes one after the other; the last axis of the points is the fastest.
    pub fn create<'a>(
        degrees: &'a [i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&'a [f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let net = Net::new(degrees, counts, width(dim), points.into(), weights)?;
        let p = &net.points;
        Spline::made(|out| unsafe {
            sys::nurbs_create(
                net.axes(),
                degrees.as_ptr(),
                net.counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                net.weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A rational spline from points (w x, w y, ..., w).
    pub fn create_homogeneous<'a>(
        degrees: &'a [i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<Spline> {
        let records = if dim > 0 { width(dim) + 1 } else { 0 };
        let net = Net::new(degrees, counts, records, points.into(), None)?;
        let p = &net.points;
        Spline::made(|out| unsafe {
            sys::nurbs_create_homogeneous(
                net.axes(),
                degrees.as_ptr(),
                net.counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                flags,
                out,
            )
        })
    }

    /// A spline from knot vectors without their first and last knot.
    pub fn create_short<'a>(
        degrees: &'a [i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&'a [f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let net = Net::new(degrees, counts, width(dim), points.into(), weights)?;
        let p = &net.points;
        Spline::made(|out| unsafe {
            sys::nurbs_create_short(
                net.axes(),
                degrees.as_ptr(),
                net.counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                net.weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A spline from distinct knots with multiplicities, one pair of vectors for each axis.
    pub fn create_multiplicities<'a>(
        degrees: &'a [i32],
        counts: &[usize],
        distinct: &[(&[f64], &[i32])],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&'a [f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let net = Net::new(degrees, counts, width(dim), points.into(), weights)?;
        if distinct.len() != degrees.len() || distinct.iter().any(|(k, m)| k.len() != m.len()) {
            let expected = format!("{} pairs of equally long vectors", degrees.len());
            return Err(Error::size("distinct", distinct.len(), expected));
        }
        let lengths: Vec<i64> = distinct.iter().map(|(k, _)| k.len() as i64).collect();
        let knots: Vec<f64> = distinct.iter().flat_map(|(k, _)| k.iter().copied()).collect();
        let times: Vec<i32> = distinct.iter().flat_map(|(_, m)| m.iter().copied()).collect();
        let p = &net.points;
        Spline::made(|out| unsafe {
            sys::nurbs_create_multiplicities(
                net.axes(),
                degrees.as_ptr(),
                net.counts.as_ptr(),
                lengths.as_ptr(),
                knots.as_ptr(),
                times.as_ptr(),
                dim,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                net.weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A Bezier spline over [0, 1] on every axis.
    pub fn bezier<'a>(
        degrees: &'a [i32],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&'a [f64]>,
    ) -> Result<Spline> {
        let counts: Vec<usize> = degrees.iter().map(|&p| p.max(0) as usize + 1).collect();
        let net = Net::new(degrees, &counts, width(dim), points.into(), weights)?;
        let p = &net.points;
        Spline::made(|out| unsafe {
            sys::nurbs_create_bezier(
                net.axes(),
                degrees.as_ptr(),
                dim,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                net.weights,
                0,
                out,
            )
        })
    }

    /// The same knots with other points, and other weights if any are given.
    pub fn with_points<'a>(&self, points: impl Into<Records<'a>>, weights: Option<&[f64]>) -> Result<Spline> {
        let (p, n) = (points.into(), self.point_count()?);
        p.require(n, width(self.dimension()?), "points")?;
        if let Some(w) = weights.filter(|w| w.len() != n) {
            return Err(Error::size("weights", w.len(), n.to_string()));
        }
        let w = weights.map_or(null(), <[f64]>::as_ptr);
        Spline::made(|out| unsafe {
            let (stride, component_stride) = (p.stride(), p.component_stride());
            sys::nurbs_with_points(self.raw(), p.pointer(), stride, component_stride, w, 0, out)
        })
    }

    /// Another handle on the same data, in constant time.
    pub fn try_clone(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_clone(self.raw(), out) })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this spline.
    pub fn raw(&self) -> *const sys::nurbs {
        self.handle.as_ptr()
    }
}
