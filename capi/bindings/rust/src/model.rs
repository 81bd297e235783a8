// SPDX-License-Identifier: MIT
//! Models: the handle. What can be asked of it is in the module `models`.

use crate::call::Call;
use crate::error::{check, Result};
use crate::list::{bytes_of, write_options_pointer, WriteOptions};
use crate::sys;
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// Faces and the edges that they share, in parts: an immutable handle, freed when dropped.
pub struct Model {
    handle: NonNull<sys::nurbs_model>,
}

// A model never changes, its count of references is atomic, and what it keeps is made thread-safely.
unsafe impl Send for Model {}
unsafe impl Sync for Model {}

impl Drop for Model {
    fn drop(&mut self) {
        unsafe { sys::nurbs_model_destroy(self.handle.as_ptr()) }
    }
}

impl Clone for Model {
    /// Another handle on the same model. Panics when memory is exhausted.
    fn clone(&self) -> Model {
        Model::made(|out| unsafe { sys::nurbs_model_clone(self.raw(), out) }).expect("cloning a model")
    }
}

impl fmt::Debug for Model {
    /// How much it holds.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Model").field(&self.counts()).finish()
    }
}

impl Model {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs_model) -> i32) -> Result<Model> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without a model");
        Ok(Model { handle })
    }

    /// The contents of a file that holds the model, the same for the same model.
    pub fn write(&self, format: i32, options: Option<&WriteOptions>) -> Result<Vec<u8>> {
        let settings = write_options_pointer(options);
        bytes_of(|cap, bytes, length| unsafe {
            sys::nurbs_model_write(self.raw(), format, settings, cap, bytes, length)
        })
    }

    /// The same as `write`; it can be watched and stopped, once for the length and once for the contents.
    pub fn write_with(&self, format: i32, options: Option<&WriteOptions>, call: &mut Call) -> Result<Vec<u8>> {
        let settings = write_options_pointer(options);
        bytes_of(|cap, bytes, length| unsafe {
            sys::nurbs_model_write_with(self.raw(), format, settings, cap, bytes, length, call.options())
        })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this model.
    pub fn raw(&self) -> *const sys::nurbs_model {
        self.handle.as_ptr()
    }

    /// To be kept or sent, with all that it holds: the same on every machine for the same model.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        bytes_of(|cap, bytes, length| unsafe { sys::nurbs_model_to_bytes(self.raw(), cap, bytes, length) })
    }
}
