// SPDX-License-Identifier: MIT
//! Lists of splines, and settings for reading and writing files: the handle and the structs. Reading is in the module `files`.

use crate::call::Call;
use crate::error::{check, text, value, Error, Result};
use crate::sys;
use std::ffi::CString;
use std::fmt;
use std::os::raw::{c_char, c_void};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr::{null, null_mut, NonNull};

/// Settings for reading; `ReadOptions::new()` has the defaults.
#[derive(Clone, Copy, Debug)]
pub struct ReadOptions {
    raw: sys::nurbs_read_options,
}

impl ReadOptions {
    /// The defaults.
    pub fn new() -> Result<ReadOptions> {
        let size = std::mem::size_of::<sys::nurbs_read_options>() as i64;
        let mut raw = sys::nurbs_read_options {
            struct_size: size,
            unit: 0.0,
            max_bytes: 0,
            tolerance: 0.0,
            kinds: 0,
            reserved: 0,
        };
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
    /// Distances in the unit of the result that count as none; 0 takes what the file states.
    pub fn tolerance(mut self, distance: f64) -> ReadOptions {
        self.raw.tolerance = distance;
        self
    }
    /// A sum of `NURBS_READ_` constants; 0 reads all kinds.
    pub fn kinds(mut self, bits: u32) -> ReadOptions {
        self.raw.kinds = bits;
        self
    }
}

/// Settings for writing; `WriteOptions::new()` has the defaults.
#[derive(Clone, Copy, Debug)]
pub struct WriteOptions {
    raw: sys::nurbs_write_options,
}

impl WriteOptions {
    /// The defaults.
    pub fn new() -> Result<WriteOptions> {
        let size = std::mem::size_of::<sys::nurbs_write_options>() as i64;
        let mut raw = sys::nurbs_write_options { struct_size: size, unit: 0.0, tolerance: 0.0 };
        check(unsafe { sys::nurbs_write_options_init(&mut raw, size) })?;
        Ok(WriteOptions { raw })
    }
    /// Unit of the file in metres; 0 keeps that of the model or list.
    pub fn unit(mut self, metres: f64) -> WriteOptions {
        self.raw.unit = metres;
        self
    }
    /// Distance that counts as none, in units of the file; 0 takes that of the faces.
    pub fn tolerance(mut self, distance: f64) -> WriteOptions {
        self.raw.tolerance = distance;
        self
    }
}

impl Default for WriteOptions {
    /// The defaults.
    fn default() -> WriteOptions {
        WriteOptions::new().expect("a library that knows the settings of its header")
    }
}

/// NULL without settings.
pub(crate) fn write_options_pointer(options: Option<&WriteOptions>) -> *const sys::nurbs_write_options {
    options.map_or(std::ptr::null(), |o| &o.raw)
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

impl Default for ReadOptions {
    /// The defaults.
    fn default() -> ReadOptions {
        ReadOptions::new().expect("a library that knows the settings of its header")
    }
}

/// NULL without settings.
pub(crate) fn options_pointer(options: Option<&ReadOptions>) -> *const sys::nurbs_read_options {
    options.map_or(std::ptr::null(), |o| &o.raw)
}

/// The text that `call` writes to (buf, cap, length).
pub(crate) fn written(mut call: impl FnMut(*mut c_char, i64, *mut i64) -> i32) -> Result<String> {
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

    pub(crate) fn raw(&self) -> *const sys::nurbs_list {
        self.handle.as_ptr()
    }

    /// To be kept or sent, with names, notes and unit: the same on every machine for the same list.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        bytes_of(|cap, bytes, length| unsafe { sys::nurbs_list_to_bytes(self.raw(), cap, bytes, length) })
    }

    /// The contents of a file that holds the splines, the same for the same list.
    pub fn write(&self, format: i32, options: Option<&WriteOptions>) -> Result<Vec<u8>> {
        let settings = write_options_pointer(options);
        bytes_of(|cap, bytes, length| unsafe {
            sys::nurbs_list_write(self.raw(), format, settings, cap, bytes, length)
        })
    }

    /// The same as `write`; it can be watched and stopped, once for the length and once for the contents.
    pub fn write_with(&self, format: i32, options: Option<&WriteOptions>, call: &mut Call) -> Result<Vec<u8>> {
        let settings = write_options_pointer(options);
        bytes_of(|cap, bytes, length| unsafe {
            sys::nurbs_list_write_with(self.raw(), format, settings, cap, bytes, length, call.options())
        })
    }

    /// Number of splines.
    pub fn len(&self) -> usize {
        let count = value(|count: *mut i64| unsafe { sys::nurbs_list_count(self.raw(), count) });
        count.unwrap_or(0) as usize
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Texts as the library takes an array of them.
pub(crate) struct Texts {
    _owned: Vec<CString>,
    pointers: Vec<*const c_char>,
}

impl Texts {
    /// None, or as many as there have to be.
    pub(crate) fn new(texts: &[&str], size: usize, what: &str) -> Result<Texts> {
        if !texts.is_empty() && texts.len() != size {
            return Err(Error::size(what, texts.len(), size.to_string()));
        }
        let owned: Vec<CString> = texts.iter().enumerate().map(|(i, text)| Texts::one(text, i, what)).collect::<Result<_>>()?;
        let pointers = owned.iter().map(|text| text.as_ptr()).collect();
        Ok(Texts { _owned: owned, pointers })
    }

    fn one(text: &str, index: usize, what: &str) -> Result<CString> {
        CString::new(text).map_err(|_| Error {
            status: sys::NURBS_ERROR_SYNTAX,
            message: format!("{}[{}] contains a zero byte", what, index),
        })
    }

    /// NULL for none.
    pub(crate) fn as_ptr(&self) -> *const *const c_char {
        if self.pointers.is_empty() {
            null()
        } else {
            self.pointers.as_ptr()
        }
    }
}

/// What `write` says of a handle, written to (cap, bytes, length).
pub(crate) fn bytes_of(mut write: impl FnMut(i64, *mut c_void, *mut i64) -> i32) -> Result<Vec<u8>> {
    let mut length = 0;
    check(write(0, null_mut(), &mut length))?;
    let mut bytes = vec![0u8; length as usize];
    check(write(length, bytes.as_mut_ptr().cast(), &mut length))?;
    Ok(bytes)
}

/// A path as the library takes it.
pub(crate) fn path_text(path: impl AsRef<Path>) -> Result<CString> {
    CString::new(path.as_ref().as_os_str().as_bytes()).map_err(|_| Error {
        status: sys::NURBS_ERROR_FILE,
        message: String::from("path contains a zero byte"),
    })
}
