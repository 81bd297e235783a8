// SPDX-License-Identifier: MIT
//! Where shapes meet: the handle. What can be asked of it is in the module `meets`.

use crate::error::{check, Result};
use crate::sys;
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// Curves where shapes meet, and the nodes where these end: an immutable handle, freed when dropped.
pub struct Meet {
    handle: NonNull<sys::nurbs_meet>,
}

// A meet never changes, and its count of references is atomic.
unsafe impl Send for Meet {}
unsafe impl Sync for Meet {}

impl Drop for Meet {
    fn drop(&mut self) {
        unsafe { sys::nurbs_meet_destroy(self.handle.as_ptr()) }
    }
}

impl Clone for Meet {
    /// Another handle on the same meet. Panics when memory is exhausted.
    fn clone(&self) -> Meet {
        Meet::made(|out| unsafe { sys::nurbs_meet_clone(self.raw(), out) }).expect("cloning a meet")
    }
}

impl fmt::Debug for Meet {
    /// How much it holds.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Meet").field(&self.counts()).finish()
    }
}

impl Meet {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs_meet) -> i32) -> Result<Meet> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without a meet");
        Ok(Meet { handle })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this meet.
    pub fn raw(&self) -> *const sys::nurbs_meet {
        self.handle.as_ptr()
    }
}
