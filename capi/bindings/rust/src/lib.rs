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

mod analysis;
mod arrays;
mod bounds;
mod calculus;
mod closest;
mod compatible;
mod constrain;
mod continuation;
mod continuity;
mod coons;
mod curves;
mod deform;
mod edit;
mod error;
mod eval;
mod forms;
mod frames;
mod inspect;
mod knots;
mod linear;
mod list;
mod measure;
mod parts;
mod placement;
mod projections;
mod recognize;
mod reduce;
mod segments;
mod shapes;
mod spline;
#[allow(missing_docs, missing_debug_implementations)] // nurbs.h is the manual of these
pub mod sys;

pub use analysis::{
    BoundaryContacts, Feature, Features, Fold, MonotonePieces, Planarity, SingularPoints, Straightness,
};
pub use arrays::{Records, RecordsMut};
pub use bounds::{BoundingBox, DirectionCone, ExtremePoint, OrientedBox};
pub use closest::{
    ClosestAll, ClosestPoints, ClosestPointsMut, CriticalPoints, Distance, HausdorffDistance, Search,
    SignedDistances,
};
pub use compatible::make_compatible;
pub use constrain::{ConstrainOptions, Constrained, Constraints};
pub use continuation::PeriodicForm;
pub use continuity::{continuity_between, Continuity, ContinuityTolerances, KnotContinuity};
pub use coons::{coons_gaps, CoonsGaps, HermiteBoundaries};
pub use curves::{conic_axes, ConicAxes, HelixShape};
pub use deform::{Bend, Deformed, Faired};
pub use edit::{weight_cross_ratio, Influence, LegEdit, WeightPoints};
pub use error::{last_error, status_name, version, Error, Result};
pub use frames::{Curvatures, CurveFrames, MinimalFrames, SurfaceFrames};
pub use knots::{
    basis, bernstein, find_spans, knots_averaged, knots_bezier, knots_bezier_breaks, knots_open_uniform,
    knots_periodic, knots_uniform, Basis,
};
pub use linear::{collocation, Extraction, Gradients, GradientsMut, SparseMatrix};
pub use list::{List, Note, ReadOptions};
pub use measure::{
    enclosed_area, enclosed_volume, Division, EnclosedArea, EnclosedVolume, Measured, Moments,
};
pub use parts::{join, Joined};
pub use placement::{Placement, Turn};
pub use recognize::Recognized;
pub use reduce::{KnotRemoval, Reduced};
pub use segments::{basis_matrix, Hermite, PowerForm};
pub use spline::{derivative_slots, DistinctKnots, Spline};

/// The bits `flags` moved to those of `axis`: the macro `NURBS_ON_AXIS`.
pub const fn on_axis(axis: u32, flags: u32) -> u32 {
    flags << (8 * axis)
}

/// The bits `flags` for the first `axes` axes: the macro `NURBS_ON_ALL_AXES`.
pub const fn on_all_axes(axes: u32, flags: u32) -> u32 {
    flags * (0x010101 >> (8 * (3 - axes)))
}

// Checked by the compiler: threads may share what this crate makes.
const _: fn() = || {
    fn shared<T: Send + Sync>() {}
    shared::<Spline>();
    shared::<List>();
    shared::<Error>();
};
