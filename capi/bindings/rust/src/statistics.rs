// SPDX-License-Identifier: MIT
//! Statistics of data: the handle. What fits make of it is in the module `fitting`.

use crate::error::{check, Result};
use crate::list::bytes_of;
use crate::sys;
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// What fits need to know of data: an immutable handle, freed when dropped.
pub struct Statistics {
    handle: NonNull<sys::nurbs_statistics>,
}

// Statistics never change, and their count of references is atomic.
unsafe impl Send for Statistics {}
unsafe impl Sync for Statistics {}

impl Drop for Statistics {
    fn drop(&mut self) {
        unsafe { sys::nurbs_statistics_destroy(self.handle.as_ptr()) }
    }
}

impl Clone for Statistics {
    /// Another handle on the same sums. Panics when memory is exhausted.
    fn clone(&self) -> Statistics {
        Statistics::made(|out| unsafe { sys::nurbs_statistics_clone(self.raw(), out) }).expect("cloning statistics")
    }
}

impl fmt::Debug for Statistics {
    /// How much data they hold.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Statistics").field("size", &self.size()).finish()
    }
}

impl Statistics {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs_statistics) -> i32) -> Result<Statistics> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without statistics");
        Ok(Statistics { handle })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this value.
    pub fn raw(&self) -> *const sys::nurbs_statistics {
        self.handle.as_ptr()
    }

    /// Number of axes.
    pub fn axes(&self) -> Result<i32> {
        Ok(self.size()?.axes)
    }
    /// Numbers of axes and of coordinates.
    pub(crate) fn shape(&self) -> (usize, usize) {
        self.size().map_or((0, 0), |size| (size.axes as usize, size.dim as usize))
    }

    /// To be kept or sent: the same on every machine for the same data, whatever their order.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        bytes_of(|cap, bytes, length| unsafe { sys::nurbs_statistics_to_bytes(self.raw(), cap, bytes, length) })
    }
}

/// As the library takes an array of them.
pub(crate) fn statistics_handles(statistics: &[&Statistics]) -> Vec<*const sys::nurbs_statistics> {
    statistics.iter().map(|one| one.raw()).collect()
}
