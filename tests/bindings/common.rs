// SPDX-License-Identifier: MIT
//! What the tests of the Rust binding share: comparison of values, statuses of calls.
#![allow(dead_code)] // not every test needs all of it

use nurbs::{sys, Result};

pub const EPS: f64 = f64::EPSILON;
pub const QUARTERS: i32 = sys::NURBS_ARC_QUARTERS;

pub fn close(a: &[f64], b: &[f64], by: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= by)
}

pub fn near(a: &[f64], b: &[f64]) -> bool {
    close(a, b, 1e-12)
}

pub fn status_of<T>(result: Result<T>) -> i32 {
    result.map_or_else(|error| error.status, |_| sys::NURBS_OK)
}
