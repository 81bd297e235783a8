// SPDX-License-Identifier: MIT
//! Where shapes stand, and how far they turn.

use crate::error::{Error, Result};
use std::f64::consts::PI;
use std::ptr::null;

/// Origin (centre, vertex), axis and direction x of a shape, all of one length: its dimension. What is left empty is
/// the default of `nurbs.h`; if all is, surfaces and helices stand in space and other curves in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placement<'a> {
    /// Centre or vertex.
    pub origin: &'a [f64],
    /// The axis, in space.
    pub axis: &'a [f64],
    /// The direction where angles start.
    pub x: &'a [f64],
}

impl<'a> Placement<'a> {
    /// At a point, with the default axis and direction x.
    pub fn at(origin: &'a [f64]) -> Self {
        Placement { origin, axis: &[], x: &[] }
    }

    /// The dimension, and the pointers origin, axis and x.
    pub(crate) fn place(&self, otherwise: i32) -> Result<(i32, [*const f64; 3])> {
        let vectors = [self.origin, self.axis, self.x];
        Ok((dimension_of(&vectors, otherwise)?, vectors.map(pointer)))
    }
    /// The pointers origin, axis and x of a shape in space.
    pub(crate) fn space(&self) -> Result<[*const f64; 3]> {
        match self.place(3)? {
            (3, pointers) => Ok(pointers),
            (dim, _) => Err(Error::size("placement", dim as usize, String::from("3"))),
        }
    }
}

/// Angles from `start` to `start + sweep`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// The first angle in radians.
    pub start: f64,
    /// How far it goes on.
    pub sweep: f64,
}

impl Turn {
    /// All around, from the angle 0.
    pub const FULL: Turn = Turn { start: 0.0, sweep: 2.0 * PI };

    /// From an angle, and how far.
    pub const fn new(start: f64, sweep: f64) -> Turn {
        Turn { start, sweep }
    }
}

/// NULL for an empty slice.
pub(crate) fn pointer(values: &[f64]) -> *const f64 {
    if values.is_empty() {
        null()
    } else {
        values.as_ptr()
    }
}

/// The length of the first vector that is not empty, which the others must have too, or another dimension.
pub(crate) fn dimension_of(vectors: &[&[f64]], otherwise: i32) -> Result<i32> {
    let mut known = vectors.iter().filter(|vector| !vector.is_empty());
    let dim = known.next().map_or(otherwise, |vector| vector.len() as i32);
    require_length(dim, known)?;
    Ok(dim)
}

/// All vectors have `dim` components.
pub(crate) fn require_length<'a>(dim: i32, vectors: impl IntoIterator<Item = &'a &'a [f64]>) -> Result<()> {
    match vectors.into_iter().find(|vector| vector.len() != dim as usize) {
        Some(vector) => Err(Error::size("vector", vector.len(), dim.to_string())),
        None => Ok(()),
    }
}
