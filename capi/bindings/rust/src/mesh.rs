// SPDX-License-Identifier: MIT
//! Triangles in place of shapes: the handle. What can be asked of it is in the module `meshes`.

use crate::call::Call;
use crate::error::{check, Result};
use crate::face::Face;
use crate::list::{bytes_of, write_options_pointer, WriteOptions};
use crate::model::Model;
use crate::spline::Spline;
use crate::sys;
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// How near to a shape its mesh is to be; `MeshOptions::new()` has the defaults.
#[derive(Clone, Copy, Debug)]
pub struct MeshOptions {
    raw: sys::nurbs_mesh_options,
}

impl MeshOptions {
    /// The defaults.
    pub fn new() -> Result<MeshOptions> {
        let size = std::mem::size_of::<sys::nurbs_mesh_options>() as i64;
        let mut raw: sys::nurbs_mesh_options = unsafe { std::mem::zeroed() };
        check(unsafe { sys::nurbs_mesh_options_init(&mut raw, size) })?;
        Ok(MeshOptions { raw })
    }
    /// The largest distance of shape and mesh, both ways; infinite for none.
    pub fn chord(mut self, distance: f64) -> MeshOptions {
        self.raw.chord = distance;
        self
    }
    /// The same as a share of the longest side of the box of all control points; 0 for none.
    pub fn relative_chord(mut self, share: f64) -> MeshOptions {
        self.raw.relative_chord = share;
        self
    }
    /// Length of sides of triangles; 0 for no limit.
    pub fn longest(mut self, length: f64) -> MeshOptions {
        self.raw.longest = length;
        self
    }
    /// The least angle of triangles inside, in radians, at most pi / 6; 0 for no limit.
    pub fn minimum_angle(mut self, radians: f64) -> MeshOptions {
        self.raw.minimum_angle = radians;
        self
    }
    /// Angle between the normals at corners of triangles, in radians, at most pi; 0 for no limit.
    pub fn angle(mut self, radians: f64) -> MeshOptions {
        self.raw.angle = radians;
        self
    }
}

impl Default for MeshOptions {
    /// The defaults.
    fn default() -> MeshOptions {
        MeshOptions::new().expect("a library that knows the settings of its header")
    }
}

/// NULL without settings.
pub(crate) fn mesh_options_pointer(options: Option<&MeshOptions>) -> *const sys::nurbs_mesh_options {
    options.map_or(std::ptr::null(), |o| &o.raw)
}

/// Triangles in place of shapes, and how far they are from these: an immutable handle, freed when dropped.
pub struct Mesh {
    handle: NonNull<sys::nurbs_mesh>,
}

// A mesh never changes, and its count of references is atomic.
unsafe impl Send for Mesh {}
unsafe impl Sync for Mesh {}

impl Drop for Mesh {
    fn drop(&mut self) {
        unsafe { sys::nurbs_mesh_destroy(self.handle.as_ptr()) }
    }
}

impl Clone for Mesh {
    /// Another handle on the same mesh. Panics when memory is exhausted.
    fn clone(&self) -> Mesh {
        Mesh::made(|out| unsafe { sys::nurbs_mesh_clone(self.raw(), out) }).expect("cloning a mesh")
    }
}

impl fmt::Debug for Mesh {
    /// How much it holds.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Mesh").field(&self.counts()).finish()
    }
}

impl Mesh {
    pub(crate) fn made(call: impl FnOnce(*mut *mut sys::nurbs_mesh) -> i32) -> Result<Mesh> {
        let mut out = null_mut();
        check(call(&mut out))?;
        let handle = NonNull::new(out).expect("the library returned success without a mesh");
        Ok(Mesh { handle })
    }

    /// The contents of a file that holds the mesh, the same for the same mesh.
    pub fn write(&self, format: i32, options: Option<&WriteOptions>) -> Result<Vec<u8>> {
        let settings = write_options_pointer(options);
        bytes_of(|cap, bytes, length| unsafe {
            sys::nurbs_mesh_write(self.raw(), format, settings, cap, bytes, length)
        })
    }

    /// The same as `write`; it can be watched and stopped, once for the length and once for the contents.
    pub fn write_with(&self, format: i32, options: Option<&WriteOptions>, call: &mut Call) -> Result<Vec<u8>> {
        let settings = write_options_pointer(options);
        bytes_of(|cap, bytes, length| unsafe {
            sys::nurbs_mesh_write_with(self.raw(), format, settings, cap, bytes, length, call.options())
        })
    }

    /// What `call` makes of so many distances.
    fn levels(
        chords: &[f64],
        call: impl FnOnce(i64, *const f64, *mut *mut sys::nurbs_mesh) -> i32,
    ) -> Result<Vec<Mesh>> {
        let mut out = vec![null_mut(); chords.len()];
        check(call(chords.len() as i64, chords.as_ptr(), out.as_mut_ptr()))?;
        let own = |handle| Mesh {
            handle: NonNull::new(handle).expect("the library returned success without a mesh"),
        };
        Ok(out.into_iter().map(own).collect())
    }

    /// Meshes of a whole surface, one for each of the distances, in their order: each as `of_surface` makes it with that
    /// `chord`, and no `relative_chord`.
    pub fn of_surface_levels(g: &Spline, chords: &[f64], options: Option<&MeshOptions>) -> Result<Vec<Mesh>> {
        let settings = mesh_options_pointer(options);
        Mesh::levels(chords, |count, own, out| unsafe {
            sys::nurbs_mesh_surface_levels(g.raw(), count, own, settings, out)
        })
    }

    /// The same as `of_surface_levels`; it can be watched and stopped.
    pub fn of_surface_levels_with(
        g: &Spline,
        chords: &[f64],
        options: Option<&MeshOptions>,
        call: &mut Call,
    ) -> Result<Vec<Mesh>> {
        let settings = mesh_options_pointer(options);
        Mesh::levels(chords, |count, own, out| unsafe {
            sys::nurbs_mesh_surface_levels_with(g.raw(), count, own, settings, call.options(), out)
        })
    }

    /// The same of a trimmed face: `of_face`.
    pub fn of_face_levels(face: &Face, chords: &[f64], options: Option<&MeshOptions>) -> Result<Vec<Mesh>> {
        let settings = mesh_options_pointer(options);
        Mesh::levels(chords, |count, own, out| unsafe {
            sys::nurbs_mesh_face_levels(face.raw(), count, own, settings, out)
        })
    }

    /// The same as `of_face_levels`; it can be watched and stopped.
    pub fn of_face_levels_with(
        face: &Face,
        chords: &[f64],
        options: Option<&MeshOptions>,
        call: &mut Call,
    ) -> Result<Vec<Mesh>> {
        let settings = mesh_options_pointer(options);
        Mesh::levels(chords, |count, own, out| unsafe {
            sys::nurbs_mesh_face_levels_with(face.raw(), count, own, settings, call.options(), out)
        })
    }

    /// The same of all faces of a model: `of_model`.
    pub fn of_model_levels(
        model: &Model,
        chords: &[f64],
        options: Option<&MeshOptions>,
    ) -> Result<Vec<Mesh>> {
        let settings = mesh_options_pointer(options);
        Mesh::levels(chords, |count, own, out| unsafe {
            sys::nurbs_mesh_model_levels(model.raw(), count, own, settings, out)
        })
    }

    /// The same as `of_model_levels`; it can be watched and stopped.
    pub fn of_model_levels_with(
        model: &Model,
        chords: &[f64],
        options: Option<&MeshOptions>,
        call: &mut Call,
    ) -> Result<Vec<Mesh>> {
        let settings = mesh_options_pointer(options);
        Mesh::levels(chords, |count, own, out| unsafe {
            sys::nurbs_mesh_model_levels_with(model.raw(), count, own, settings, call.options(), out)
        })
    }

    /// The handle, for the functions of [`sys`]. It lives as long as this mesh.
    pub fn raw(&self) -> *const sys::nurbs_mesh {
        self.handle.as_ptr()
    }
}
