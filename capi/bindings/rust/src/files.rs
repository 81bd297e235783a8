// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Files: the splines that one held, their names, and notes on the rest; and writing them.

use crate::call::Call;
use crate::error::{check, value, Result};
use crate::list::{
    options_pointer, path_text, write_options_pointer, written, List, ReadOptions, Texts, WriteOptions,
};
use crate::spline::{handles, Spline};
use crate::sys;
use std::path::Path;

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

/// An entity of a file that did not become a spline.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct Note {
    /// Its number in the format of the file.
    pub entity_type: i32,
    /// Its line in the directory of the file.
    pub line: i64,
    /// Why not: a status.
    pub reason: i32,
    /// The same in words.
    pub text: String,
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

/// Files: the splines that one held, their names, and notes on the rest; and writing them.
impl List {
    /// Reads the contents of a file from memory.
    pub fn read(bytes: &[u8], options: Option<&ReadOptions>) -> Result<List> {
        List::made(|out| unsafe {
            sys::nurbs_read(bytes.as_ptr().cast(), bytes.len() as i64, options_pointer(options), out)
        })
    }

    /// The same as `read`; it can be watched and stopped.
    pub fn read_with(bytes: &[u8], options: Option<&ReadOptions>, call: &mut Call) -> Result<List> {
        List::made(|out| unsafe {
            sys::nurbs_read_with(
                bytes.as_ptr().cast(),
                bytes.len() as i64,
                options_pointer(options),
                call.options(),
                out,
            )
        })
    }

    /// Reads a file by its path.
    pub fn read_file(path: impl AsRef<Path>, options: Option<&ReadOptions>) -> Result<List> {
        let path = path_text(path)?;
        List::made(|out| unsafe { sys::nurbs_read_file(path.as_ptr(), options_pointer(options), out) })
    }

    /// The same as `read_file`; it can be watched and stopped.
    pub fn read_file_with(
        path: impl AsRef<Path>,
        options: Option<&ReadOptions>,
        call: &mut Call,
    ) -> Result<List> {
        let path = path_text(path)?;
        List::made(|out| unsafe {
            sys::nurbs_read_file_with(path.as_ptr(), options_pointer(options), call.options(), out)
        })
    }

    /// A list of splines, with their names, none for "0", "1", ..., and the metres per unit of length, 0 if
    /// that is not known.
    pub fn create(splines: &[&Spline], names: &[&str], metres: f64) -> Result<List> {
        let splines = handles(splines);
        let count = splines.len();
        let names = Texts::new(names, count, "names")?;
        List::made(|out| unsafe {
            sys::nurbs_list_create(count as i64, splines.as_ptr(), names.as_ptr(), metres, out)
        })
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
        let mut count = 0;
        check(unsafe { sys::nurbs_list_note_count(self.raw(), &mut count) })?;
        Ok(count as usize)
    }

    /// A note.
    pub fn note(&self, index: usize) -> Result<Note> {
        let mut entity_type = 0;
        let mut line = 0;
        let mut reason = 0;
        let text = written(|buf, cap, length| unsafe {
            sys::nurbs_list_note(
                self.raw(),
                index as i64,
                &mut entity_type,
                &mut line,
                &mut reason,
                buf,
                cap,
                length,
            )
        })?;
        Ok(Note { entity_type, line, reason, text })
    }

    /// Metres per unit of length; 0 if the file does not say.
    pub fn unit(&self) -> Result<f64> {
        value(|metres| unsafe { sys::nurbs_list_unit(self.raw(), metres) })
    }

    /// The list of what to_bytes() made of it.
    pub fn from_bytes(bytes: &[u8]) -> Result<List> {
        List::made(|out| unsafe {
            sys::nurbs_list_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out)
        })
    }

    /// Writes the curves and surfaces to a file, which is replaced whole or not at all.
    pub fn write_file(
        &self,
        path: impl AsRef<Path>,
        format: i32,
        options: Option<&WriteOptions>,
    ) -> Result<()> {
        let path = path_text(path)?;
        check(unsafe {
            sys::nurbs_list_write_file(self.raw(), path.as_ptr(), format, write_options_pointer(options))
        })
    }

    /// The same as `write_file`; it can be watched and stopped.
    pub fn write_file_with(
        &self,
        path: impl AsRef<Path>,
        format: i32,
        options: Option<&WriteOptions>,
        call: &mut Call,
    ) -> Result<()> {
        let path = path_text(path)?;
        check(unsafe {
            sys::nurbs_list_write_file_with(
                self.raw(),
                path.as_ptr(),
                format,
                write_options_pointer(options),
                call.options(),
            )
        })
    }
}
