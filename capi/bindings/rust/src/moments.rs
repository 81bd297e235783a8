// SPDX-License-Identifier: MIT
//! Moments of shapes that may have none.

use crate::error::{check, Result};
use crate::sys;
use std::ptr::null_mut;

/// Calls `f(centroid, inertia)`, which refuses what it cannot give if that is asked for: then it is asked for less, and
/// the rest is NaN. A content of 0 has no centroid, and inertia overflows first.
pub(crate) fn moments_of(
    centroid: &mut [f64],
    inertia: &mut [f64],
    mut f: impl FnMut(*mut f64, *mut f64) -> i32,
) -> Result<()> {
    let mut status = f(centroid.as_mut_ptr(), inertia.as_mut_ptr());
    if status == sys::NURBS_ERROR_NOT_REPRESENTABLE {
        inertia.fill(f64::NAN);
        status = f(centroid.as_mut_ptr(), null_mut());
    }
    if status == sys::NURBS_ERROR_LENGTH || status == sys::NURBS_ERROR_NOT_REPRESENTABLE {
        centroid.fill(f64::NAN);
        inertia.fill(f64::NAN);
        status = f(null_mut(), null_mut());
    }
    check(status)
}
