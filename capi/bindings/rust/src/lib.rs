// SPDX-License-Identifier: MIT
//! libnurbs for Rust: NURBS curves, surfaces and volumes.
//!
//! The manual is the header `nurbs.h`; this crate keeps its names, its indices from 0 and its flags. [`sys`] is the C
//! interface as it stands, everything else is safe: a failure is an [`Error`] with the status and the message, arrays
//! are slices whose lengths are checked, a [`Spline`] is freed when dropped and may be used by many threads at once.
//! Structs that are returned may have more fields in later versions; patterns end with `..`.
//!
//! ```
//! # fn main() -> nurbs::Result<()> {
//! let arc = nurbs::Spline::bezier(&[2], 2, &[1.0, 0.0, 1.0, 1.0, 0.0, 1.0], Some(&[1.0, 0.5f64.sqrt(), 1.0]))?;
//! let points = arc.eval(&[0.0, 0.5, 1.0], 0)?;
//! assert!((points[2].hypot(points[3]) - 1.0).abs() < 1e-15);
//! let outside = arc.eval(&[2.0], 0).unwrap_err();
//! assert_eq!(outside.to_string(), "NURBS_ERROR_OUTSIDE_DOMAIN: params[0] = 2 outside [0, 1]");
//! # Ok(()) }
//! ```
//!
//! Cargo links the library from the folder in NURBS_LIBRARY_DIR, else from where pkg-config knows it.

#![deny(missing_docs, missing_debug_implementations)]

// By hand.
mod arrays;
mod call;
mod data;
mod error;
mod face;
mod list;
mod meet;
mod mesh;
mod model;
mod moments;
mod placement;
mod sizes;
mod spline;
mod statistics;
#[allow(missing_docs, missing_debug_implementations)] // nurbs.h is the manual of these
pub mod sys;

// Generated from the header and the table of the bindings.
mod analysis;
mod bounds;
mod calculus;
mod closest;
mod compatible;
mod constrain;
mod continuation;
mod continuity;
mod coons;
mod create;
mod curves;
mod deform;
mod edit;
mod eval;
mod faces;
mod files;
mod fit;
mod fitting;
mod forms;
mod frames;
mod inspect;
mod intersections;
mod knots;
mod linear;
mod measure;
mod meets;
mod meshes;
mod models;
mod parts;
mod projections;
mod recognize;
mod reduce;
mod refine;
mod segments;
mod shapes;

pub use arrays::{Records, RecordsMut};
pub use call::Call;
pub use data::{CloudOptions, CloudReport, Data, FitOptions, FitReport};
pub use error::{last_error, status_name, version, Error, Result};
pub use face::Face;
pub use list::{List, ReadOptions, WriteOptions};
pub use meet::Meet;
pub use mesh::{Mesh, MeshOptions};
pub use model::Model;
pub use placement::{Placement, Turn};
pub use spline::Spline;
pub use statistics::Statistics;

pub use analysis::*;
pub use bounds::*;
pub use closest::*;
pub use compatible::*;
pub use constrain::*;
pub use continuation::*;
pub use continuity::*;
pub use coons::*;
pub use curves::*;
pub use deform::*;
pub use edit::*;
pub use eval::*;
pub use faces::*;
pub use files::*;
pub use fit::*;
pub use fitting::*;
pub use frames::*;
pub use intersections::*;
pub use inspect::*;
pub use knots::*;
pub use linear::*;
pub use measure::*;
pub use meets::*;
pub use meshes::*;
pub use models::*;
pub use parts::*;
pub use recognize::*;
pub use reduce::*;
pub use segments::*;

/// The bits `flags` moved to those of `axis`: the macro `NURBS_ON_AXIS`.
pub const fn on_axis(axis: u32, flags: u32) -> u32 {
    flags << (8 * axis)
}

/// The bits `flags` for the first `axes` axes: the macro `NURBS_ON_ALL_AXES`.
pub const fn on_all_axes(axes: u32, flags: u32) -> u32 {
    flags * (0x010101 >> (8 * (3 - axes)))
}

// The examples of README.md run with those of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

// Checked by the compiler: threads may share what this crate makes.
const _: fn() = || {
    fn shared<T: Send + Sync>() {}
    shared::<Spline>();
    shared::<List>();
    shared::<Error>();
};
