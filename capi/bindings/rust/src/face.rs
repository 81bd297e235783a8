// SPDX-License-Identifier: MIT
//! Trimmed faces: the handle. What can be asked of it is in the module `faces`.

use crate::error::{check, Result};
use crate::list::bytes_of;
use crate::sys;
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// A trimmed face: an immutable handle, freed when dropped.
pub struct Face {
    handle: NonNull<sys::nurbs_face>,
}

// A face never changes, its count of references is atomic, and what it keeps is made thread-safely.
unsafe impl Send for Face {}
unsafe impl Sync for Face {}

impl Drop for Face {
    fn drop(&mut self) {
        unsafe { sys::nurbs_face_destroy(self.handle.as_ptr()) }
    }
}

impl Clone for Face {
    /// Another handle on the same face. Panics when memory is exhausted.
    fn clone(&self) -> Face {
        Face::made(|out| unsafe { sys::nurbs_face_clone(self.raw(), out) }).expect("cloning a face")
    }
}

impl fmt::Debug for Face {
    /// Its surface, and how many curves its loops have.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Face").field("surface", &self.surface()).field("loops", &self.loops()).finish()
    }
}

impl Face {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs_face) -> i32) -> Result<Face> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without a face");
        Ok(Face { handle })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this face.
    pub fn raw(&self) -> *const sys::nurbs_face {
        self.handle.as_ptr()
    }

    /// To be kept or sent: the same on every machine for the same face.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        bytes_of(|cap, bytes, length| unsafe { sys::nurbs_face_to_bytes(self.raw(), cap, bytes, length) })
    }

    /// The dimension of its surface.
    pub fn dimension(&self) -> Result<i32> {
        self.surface()?.dimension()
    }
}

/// The handles of faces.
pub(crate) fn face_handles(faces: &[&Face]) -> Vec<*const sys::nurbs_face> {
    faces.iter().map(|face| face.raw()).collect()
}
