// SPDX-License-Identifier: MIT
//! Failures: a status and a message.

use crate::sys;
use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;

/// A call that failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// One of the `NURBS_ERROR_` codes of [`sys`], or a code of a newer library.
    pub status: i32,
    /// Which array, which index, which value, and what was expected.
    pub message: String,
}

/// What calls return: a value, or why there is none.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// Name of the status, such as "NURBS_ERROR_NULL".
    pub fn name(&self) -> &'static str {
        status_name(self.status)
    }

    /// An array whose length does not suit, found on this side.
    pub(crate) fn size(what: &str, holds: usize, expected: String) -> Error {
        let message = format!("{} holds {} values, expected {}", what, holds, expected);
        Error { status: sys::NURBS_ERROR_SIZE, message }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name(), self.message)
    }
}

impl std::error::Error for Error {}

/// Version of the library: major * 10000 + minor * 100 + patch.
pub fn version() -> i32 {
    unsafe { sys::nurbs_version() }
}

/// Name of a status; "NURBS_ERROR_UNKNOWN" for values without a name.
pub fn status_name(status: i32) -> &'static str {
    // The library returns static ASCII strings, never NULL.
    let name = unsafe { CStr::from_ptr(sys::nurbs_status_name(status)) };
    name.to_str().unwrap_or("")
}

/// Message of the last failed call in this thread.
pub fn last_error() -> String {
    let length = unsafe { sys::nurbs_last_error(std::ptr::null_mut(), 0) };
    let mut buffer = vec![0u8; length as usize + 1];
    unsafe { sys::nurbs_last_error(buffer.as_mut_ptr().cast::<c_char>(), length + 1) };
    text(buffer)
}

/// The bytes before the terminating zero as a string.
pub(crate) fn text(buffer: Vec<u8>) -> String {
    let length = buffer.iter().position(|&byte| byte == 0).unwrap_or(buffer.len());
    String::from_utf8_lossy(&buffer[..length]).into_owned()
}

pub(crate) fn check(status: i32) -> Result<()> {
    if status == sys::NURBS_ERROR_CANCELLED {
        crate::call::resume();
    }
    match status {
        sys::NURBS_OK => Ok(()),
        _ => Err(Error { status, message: last_error() }),
    }
}

/// The value that `call` writes through its argument.
pub(crate) fn value<T: Default>(call: impl FnOnce(*mut T) -> i32) -> Result<T> {
    let mut result = T::default();
    check(call(&mut result))?;
    Ok(result)
}
