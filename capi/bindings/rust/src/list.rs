// SPDX-License-Identifier: MIT
//! Reading files: the splines that a file held, their names, and notes on the rest.

use crate::error::{check, text, value, Error, Result};
use crate::spline::Spline;
use crate::sys;
use std::ffi::CString;
use std::fmt;
use std::os::raw::{c_char, c_void};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr::{null_mut, NonNull};

/// Settings for reading; `ReadOptions::new()` has the defaults.
#[derive(Clone, Copy, Debug)]
pub struct ReadOptions {
    raw: sys::nurbs_read_options,
}

impl ReadOptions {
    /// The defaults.
    pub fn new() -> Result<ReadOptions> {
        let size = std::mem::size_of::<sys::nurbs_read_options>() as i64;
        let mut raw = sys::nurbs_read_options { struct_size: size, unit: 0.0, max_bytes: 0 };
        check(unsafe { sys::nurbs_read_options_init(&mut raw, size) })?;
        Ok(ReadOptions { raw })
    }
    /// Wanted unit of length in metres; 0 keeps the file's own.
    pub fn unit(mut self, metres: f64) -> ReadOptions {
        self.raw.unit = metres;
        self
    }
    /// Largest file accepted.
    pub fn max_bytes(mut self, bytes: i64) -> ReadOptions {
        self.raw.max_bytes = bytes;
        self
    }
}

/// An entity of a file that did not become a spline.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Note {
    /// Its number in the format of the file.
    pub entity_type: i32,
    /// Its line in the directory of the file.
    pub line: i64,
    /// A `NURBS_ERROR_` code.
    pub reason: i32,
    /// The same in words.
    pub text: String,
}

/// Parts of a spline, or what a file held.
pub struct List {
    handle: NonNull<sys::nurbs_list>,
}

// A list never changes, and the library lets any number of threads read it.
unsafe impl Send for List {}
unsafe impl Sync for List {}

impl Drop for List {
    fn drop(&mut self) {
        unsafe { sys::nurbs_list_destroy(self.handle.as_ptr()) }
    }
}

fn pointer(options: Option<&ReadOptions>) -> *const sys::nurbs_read_options {
    options.map_or(std::ptr::null(), |o| &o.raw)
}

/// The text that `call` writes to (buf, cap, length).
fn written(call: impl Fn(*mut c_char, i64, *mut i64) -> i32) -> Result<String> {
    let mut length = 0;
    check(call(null_mut(), 0, &mut length))?;
    let mut buffer = vec![0u8; length as usize + 1];
    check(call(buffer.as_mut_ptr().cast(), length + 1, &mut length))?;
    Ok(text(buffer))
}

impl fmt::Debug for List {
    /// The names of its splines.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries((0..self.len()).map(|i| self.name(i).unwrap_or_default())).finish()
    }
}

impl List {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs_list) -> i32) -> Result<List> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without a list");
        Ok(List { handle })
    }
    fn raw(&self) -> *const sys::nurbs_list {
        self.handle.as_ptr()
    }

    /// Reads the contents of a file from memory.
    pub fn read(bytes: &[u8], options: Option<&ReadOptions>) -> Result<List> {
        let start = bytes.as_ptr().cast::<c_void>();
        List::made(|out| unsafe { sys::nurbs_read(start, bytes.len() as i64, pointer(options), out) })
    }

    /// Reads a file by its path.
    pub fn read_file(path: impl AsRef<Path>, options: Option<&ReadOptions>) -> Result<List> {
        let path = CString::new(path.as_ref().as_os_str().as_bytes()).map_err(|_| Error {
            status: sys::NURBS_ERROR_FILE,
            message: String::from("path contains a zero byte"),
        })?;
        List::made(|out| unsafe { sys::nurbs_read_file(path.as_ptr(), pointer(options), out) })
    }

    /// Number of splines.
    pub fn len(&self) -> usize {
        let count = value(|v: *mut i64| unsafe { sys::nurbs_list_count(self.raw(), v) });
        count.unwrap_or(0) as usize
    }
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Spline `index`; it outlives the list.
    pub fn get(&self, index: usize) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_list_get(self.raw(), index as i64, out) })
    }
    /// The name of a spline.
    pub fn name(&self, index: usize) -> Result<String> {
        written(|buf, cap, length| unsafe {
            sys::nurbs_list_name(self.raw(), index as i64, buf, cap, length)
        })
    }
    /// Number of notes.
    pub fn note_count(&self) -> Result<usize> {
        let count = value(|v: *mut i64| unsafe { sys::nurbs_list_note_count(self.raw(), v) })?;
        Ok(count as usize)
    }
    /// A note.
    pub fn note(&self, index: usize) -> Result<Note> {
        let (mut kind, mut line, mut reason) = (0, 0, 0);
        let (k, l, r): (*mut i32, *mut i64, *mut i32) = (&mut kind, &mut line, &mut reason);
        let text = written(|buf, cap, length| unsafe {
            sys::nurbs_list_note(self.raw(), index as i64, k, l, r, buf, cap, length)
        })?;
        Ok(Note { entity_type: kind, line, reason, text })
    }
    /// Metres per unit of length; 0 if the file does not say.
    pub fn unit(&self) -> Result<f64> {
        value(|v| unsafe { sys::nurbs_list_unit(self.raw(), v) })
    }
}
