// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Handles as bytes: the same on every machine for the same contents.

use crate::error::{check, Result};
use crate::list::List;
use crate::spline::Spline;
use crate::sys;

/// What bytes hold, by their header.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct BytesKind {
    /// A `NURBS_BYTES_` constant.
    pub kind: i32,
    /// Version of the form: a library reads those up to its own.
    pub major: i32,
    /// What it has in addition.
    pub minor: i32,
}

/// Of which kind bytes are, and in which version of the form.
pub fn bytes_kind(bytes: &[u8]) -> Result<BytesKind> {
    let mut kind = 0;
    let mut major = 0;
    let mut minor = 0;
    check(unsafe {
        sys::nurbs_bytes_kind(bytes.as_ptr().cast(), bytes.len() as i64, &mut kind, &mut major, &mut minor)
    })?;
    Ok(BytesKind { kind, major, minor })
}

/// Handles as bytes: the same on every machine for the same contents.
impl Spline {
    /// The spline of what to_bytes() made of it, bit for bit.
    pub fn from_bytes(bytes: &[u8]) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out) })
    }
}

/// Handles as bytes: the same on every machine for the same contents.
impl List {
    /// The list of what to_bytes() made of it.
    pub fn from_bytes(bytes: &[u8]) -> Result<List> {
        List::made(|out| unsafe {
            sys::nurbs_list_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out)
        })
    }
}
