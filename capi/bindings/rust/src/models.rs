// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Models: faces with the edges that they share, the vertices at which edges meet, and the parts to which
//! they belong.

use crate::arrays::{exactly, flat, if_given, rows, Records};
use crate::call::Call;
use crate::error::{check, value, Result};
use crate::face::{face_handles, Face};
use crate::list::{
    options_pointer, path_text, write_options_pointer, written, List, ReadOptions, WriteOptions,
};
use crate::measure::{EnclosedVolume, Measured};
use crate::model::Model;
use crate::moments::moments_of;
use crate::spline::{handles, Spline};
use crate::sys;
use std::path::Path;
use std::ptr::null_mut;

/// How much a model holds.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct ModelCounts {
    /// Number of parts.
    pub parts: i64,
    /// Number of uses of parts.
    pub uses: i64,
    /// Number of faces.
    pub faces: i64,
    /// Number of edges.
    pub edges: i64,
    /// Number of vertices.
    pub vertices: i64,
}

/// A face of a model.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ModelFace {
    /// The face.
    pub face: Face,
    /// The part that it belongs to.
    pub part: i64,
    /// The kind of its surface: a shape, that of none for a spline.
    pub shape: i32,
    /// Whether the outer normal is against that of the surface.
    pub against: bool,
    /// Red, green and blue from 0 to 1, NaN where the file gives none.
    pub colour: [f64; 3],
}

/// The solid that a face of a model bounds.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct FaceSolid {
    /// The number of the solid, -1 for none.
    pub solid: i64,
    /// Whether the face belongs to a void of it.
    pub in_void: i32,
}

/// An edge of a model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ModelEdge {
    /// Its curve.
    pub spline: Spline,
    /// The part that it belongs to.
    pub part: i64,
    /// Where its curve begins and ends, -1 for none.
    pub vertices: [i64; 2],
    /// The kind of its curve: a shape, that of none for a spline.
    pub shape: i32,
}

/// How well faces meet at the edges of a model.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct EdgeGaps {
    /// How many uses each edge has, 1 where a face ends.
    pub uses: Vec<i64>,
    /// How far the curves of faces are from the edge, at most.
    pub gaps: Vec<f64>,
    /// 1 if that is a bound, 0 if it is the largest distance seen.
    pub bounded: Vec<i32>,
}

/// A use of a part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ModelUse {
    /// The part in which it is placed, -1 for the whole.
    pub parent: i64,
    /// The part that is placed.
    pub part: i64,
    /// A point x of the part is at M x + t, rows of (M | t).
    pub placement: [[f64; 4]; 3],
}

/// Where the parts of a model stand in the whole.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ModelInstances {
    /// The instance in which each stands, -1 for the whole.
    pub parents: Vec<i64>,
    /// The last use on the way to it.
    pub uses: Vec<i64>,
    /// The part of that use.
    pub parts: Vec<i64>,
    /// `[n][12]`: a point x of the part is at M x + t, the three rows of (M | t).
    pub placements: Vec<[f64; 12]>,
}

/// Where rays meet a model first, at origin + t direction.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ModelRays {
    /// `[n][2]` on the surface of the face, NaN without a hit or touch.
    pub params: Vec<[f64; 2]>,
    /// t, in lengths of the direction; NaN without a hit or touch.
    pub distances: Vec<f64>,
    /// `NURBS_RAY_` bits.
    pub status: Vec<i32>,
    /// `[n][2]`: the face, and the instance of its part.
    pub places: Vec<[i64; 2]>,
}

/// The points of a model that are nearest to given points.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ClosestOnModel {
    /// `[n][2]` on the surface of the face.
    pub params: Vec<[f64; 2]>,
    /// `[n][3]`, in the whole.
    pub points: Vec<[f64; 3]>,
    /// From the points that were given, in the whole.
    pub distances: Vec<f64>,
    /// `NURBS_CLOSEST_` bits.
    pub status: Vec<i32>,
    /// `[n][2]`: the face, and the instance of its part; -1 if there are no faces.
    pub places: Vec<[i64; 2]>,
}

/// All places where a ray meets a model, by rising t.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ModelRayHits {
    /// `[n][2]` on the surface of the face.
    pub params: Vec<[f64; 2]>,
    /// t, in lengths of the direction.
    pub distances: Vec<f64>,
    /// `NURBS_RAY_HIT` or `NURBS_RAY_TOUCH` each, and `NURBS_RAY_BACK`.
    pub kinds: Vec<i32>,
    /// `[n][2]`: the face, and the instance of its part.
    pub places: Vec<[i64; 2]>,
    /// Whether there are no others, and none is a touch.
    pub complete: bool,
}

/// Models: faces with the edges that they share, the vertices at which edges meet, and the parts to which
/// they belong.
impl Model {
    /// Reads the faces, edges and vertices of a STEP or an IGES file from memory.
    pub fn read(bytes: &[u8], options: Option<&ReadOptions>) -> Result<Model> {
        Model::made(|out| unsafe {
            sys::nurbs_read_model(bytes.as_ptr().cast(), bytes.len() as i64, options_pointer(options), out)
        })
    }

    /// The same as `read`; it can be watched and stopped.
    pub fn read_with(bytes: &[u8], options: Option<&ReadOptions>, call: &mut Call) -> Result<Model> {
        Model::made(|out| unsafe {
            sys::nurbs_read_model_with(
                bytes.as_ptr().cast(),
                bytes.len() as i64,
                options_pointer(options),
                call.options(),
                out,
            )
        })
    }

    /// Reads a STEP or an IGES file by its path.
    pub fn read_file(path: impl AsRef<Path>, options: Option<&ReadOptions>) -> Result<Model> {
        let path = path_text(path)?;
        Model::made(|out| unsafe { sys::nurbs_read_model_file(path.as_ptr(), options_pointer(options), out) })
    }

    /// The same as `read_file`; it can be watched and stopped.
    pub fn read_file_with(
        path: impl AsRef<Path>,
        options: Option<&ReadOptions>,
        call: &mut Call,
    ) -> Result<Model> {
        let path = path_text(path)?;
        Model::made(|out| unsafe {
            sys::nurbs_read_model_file_with(path.as_ptr(), options_pointer(options), call.options(), out)
        })
    }

    /// A model of faces, with one part and one use of it. Faces with a common key share an edge.
    pub fn create(faces: &[&Face], metres: f64) -> Result<Model> {
        let faces = face_handles(faces);
        Model::made(|out| unsafe { sys::nurbs_model_create(faces.len() as i64, faces.as_ptr(), metres, out) })
    }

    /// A model of faces that do not know each other: pieces of their boundaries within the tolerance become
    /// common edges.
    pub fn sew(faces: &[&Face], tolerance: f64, metres: f64) -> Result<Model> {
        let faces = face_handles(faces);
        Model::made(|out| unsafe {
            sys::nurbs_model_sew(faces.len() as i64, faces.as_ptr(), tolerance, metres, out)
        })
    }

    /// The same as `sew`; it can be watched and stopped.
    pub fn sew_with(faces: &[&Face], tolerance: f64, metres: f64, call: &mut Call) -> Result<Model> {
        let faces = face_handles(faces);
        Model::made(|out| unsafe {
            sys::nurbs_model_sew_with(
                faces.len() as i64,
                faces.as_ptr(),
                tolerance,
                metres,
                call.options(),
                out,
            )
        })
    }

    /// The region that closed curves of the plane enclose, as faces without a common point inside: each curve
    /// begins where the one before it ends, or where that one closes a loop, a loop of its own. rule is one
    /// of the `NURBS_FILL_` constants.
    pub fn region(curves: &[&Spline], rule: i32, tolerance: f64) -> Result<Model> {
        let curves = handles(curves);
        Model::made(|out| unsafe {
            sys::nurbs_region_create(curves.len() as i64, curves.as_ptr(), rule, tolerance, out)
        })
    }

    /// The same as `region`; it can be watched and stopped.
    pub fn region_with(curves: &[&Spline], rule: i32, tolerance: f64, call: &mut Call) -> Result<Model> {
        let curves = handles(curves);
        Model::made(|out| unsafe {
            sys::nurbs_region_create_with(
                curves.len() as i64,
                curves.as_ptr(),
                rule,
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// The union, intersection or difference of two regions, each of which is what its faces cover. rule is
    /// one of the `NURBS_REGION_` constants.
    pub fn combine(rule: i32, a: &[&Face], b: &[&Face], tolerance: f64) -> Result<Model> {
        let a = face_handles(a);
        let b = face_handles(b);
        Model::made(|out| unsafe {
            sys::nurbs_region_combine(
                rule,
                a.len() as i64,
                a.as_ptr(),
                b.len() as i64,
                b.as_ptr(),
                tolerance,
                out,
            )
        })
    }

    /// The same as `combine`; it can be watched and stopped.
    pub fn combine_with(
        rule: i32,
        a: &[&Face],
        b: &[&Face],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Model> {
        let a = face_handles(a);
        let b = face_handles(b);
        Model::made(|out| unsafe {
            sys::nurbs_region_combine_with(
                rule,
                a.len() as i64,
                a.as_ptr(),
                b.len() as i64,
                b.as_ptr(),
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// The parts of a face that curves in the domain of its surface divide it into; they share edges.
    pub fn split(face: &Face, curves: &[&Spline], tolerance: f64) -> Result<Model> {
        let curves = handles(curves);
        Model::made(|out| unsafe {
            sys::nurbs_face_split(face.raw(), curves.len() as i64, curves.as_ptr(), tolerance, out)
        })
    }

    /// The same as `split`; it can be watched and stopped.
    pub fn split_with(face: &Face, curves: &[&Spline], tolerance: f64, call: &mut Call) -> Result<Model> {
        let curves = handles(curves);
        Model::made(|out| unsafe {
            sys::nurbs_face_split_with(
                face.raw(),
                curves.len() as i64,
                curves.as_ptr(),
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// What of a face lies on one side of a surface, which divides it where both meet. side is one of the
    /// `NURBS_TRIM_` constants.
    pub fn trim(face: &Face, surface: &Spline, side: i32, tolerance: f64) -> Result<Model> {
        Model::made(|out| unsafe { sys::nurbs_face_trim(face.raw(), surface.raw(), side, tolerance, out) })
    }

    /// The same as `trim`; it can be watched and stopped.
    pub fn trim_with(
        face: &Face,
        surface: &Spline,
        side: i32,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Model> {
        Model::made(|out| unsafe {
            sys::nurbs_face_trim_with(face.raw(), surface.raw(), side, tolerance, call.options(), out)
        })
    }

    /// How much it holds.
    pub fn counts(&self) -> Result<ModelCounts> {
        let mut parts = 0;
        let mut uses = 0;
        let mut faces = 0;
        let mut edges = 0;
        let mut vertices = 0;
        check(unsafe {
            sys::nurbs_model_counts(self.raw(), &mut parts, &mut uses, &mut faces, &mut edges, &mut vertices)
        })?;
        Ok(ModelCounts { parts, uses, faces, edges, vertices })
    }

    /// A face.
    pub fn face(&self, index: usize) -> Result<ModelFace> {
        let mut part = 0;
        let mut shape = 0;
        let mut against = 0;
        let mut colour = [0.0; 3];
        let face = Face::made(|out| unsafe {
            sys::nurbs_model_face(
                self.raw(),
                index as i64,
                &mut part,
                &mut shape,
                &mut against,
                colour.as_mut_ptr(),
                out,
            )
        })?;
        Ok(ModelFace { face, part, shape, against: against != 0, colour })
    }

    /// The name of a face.
    pub fn face_name(&self, index: usize) -> Result<String> {
        written(|buf, cap, length| unsafe {
            sys::nurbs_model_face_name(self.raw(), index as i64, buf, cap, length)
        })
    }

    /// The solid that a face bounds, -1 for none, and whether the face belongs to a void of it.
    pub fn face_solid(&self, index: usize) -> Result<FaceSolid> {
        let mut solid = 0;
        let mut in_void = 0;
        check(unsafe { sys::nurbs_model_face_solid(self.raw(), index as i64, &mut solid, &mut in_void) })?;
        Ok(FaceSolid { solid, in_void })
    }

    /// The layers that a face is in.
    pub fn face_layers(&self, index: usize) -> Result<Vec<i64>> {
        let fill = |cap, layers, count| unsafe {
            sys::nurbs_model_face_layers(self.raw(), index as i64, cap, layers, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut layers = vec![0; n];
        check(fill(count, layers.as_mut_ptr(), &mut count))?;
        Ok(layers)
    }

    /// An edge.
    pub fn edge(&self, index: usize) -> Result<ModelEdge> {
        let mut part = 0;
        let mut vertices = [0; 2];
        let mut shape = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_model_edge(self.raw(), index as i64, &mut part, vertices.as_mut_ptr(), &mut shape, out)
        })?;
        Ok(ModelEdge { spline, part, vertices, shape })
    }

    /// Where faces use an edge: face, loop, and place in the loop; once at a free boundary, twice inside a
    /// shell.
    pub fn edge_uses(&self, index: usize) -> Result<Vec<[i64; 3]>> {
        let fill = |cap, places, count| unsafe {
            sys::nurbs_model_edge_uses(self.raw(), index as i64, cap, places, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut places = vec![[0; 3]; n];
        check(fill(count, places.as_mut_ptr().cast(), &mut count))?;
        Ok(places)
    }

    /// How well faces meet at its edges: the number of uses of each, and how far the curves of faces are from
    /// it.
    pub fn edge_gaps(&self) -> Result<EdgeGaps> {
        let fill = |cap, uses, gaps, bounded, count| unsafe {
            sys::nurbs_model_edge_gaps(self.raw(), cap, uses, gaps, bounded, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut uses = vec![0; n];
        let mut gaps = vec![0.0; n];
        let mut bounded = vec![0; n];
        check(fill(count, uses.as_mut_ptr(), gaps.as_mut_ptr(), bounded.as_mut_ptr(), &mut count))?;
        Ok(EdgeGaps { uses, gaps, bounded })
    }

    /// The point of a vertex.
    pub fn vertex(&self, index: usize) -> Result<[f64; 3]> {
        let mut point = [0.0; 3];
        check(unsafe { sys::nurbs_model_vertex(self.raw(), index as i64, point.as_mut_ptr()) })?;
        Ok(point)
    }

    /// The name of a part.
    pub fn part(&self, index: usize) -> Result<String> {
        written(|buf, cap, length| unsafe {
            sys::nurbs_model_part(self.raw(), index as i64, buf, cap, length)
        })
    }

    /// A use of a part: where it is placed.
    pub fn part_use(&self, index: usize) -> Result<ModelUse> {
        let mut parent = 0;
        let mut part = 0;
        let mut placement = [[0.0; 4]; 3];
        check(unsafe {
            sys::nurbs_model_use(
                self.raw(),
                index as i64,
                &mut parent,
                &mut part,
                placement.as_mut_ptr().cast(),
            )
        })?;
        Ok(ModelUse { parent, part, placement })
    }

    /// Where the parts stand in the whole: each way through uses of parts in parts.
    pub fn instances(&self) -> Result<ModelInstances> {
        let fill = |cap, parents, uses, parts, placements, count| unsafe {
            sys::nurbs_model_instances(self.raw(), cap, parents, uses, parts, placements, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut parents = vec![0; n];
        let mut uses = vec![0; n];
        let mut parts = vec![0; n];
        let mut placements = vec![[0.0; 12]; n];
        check(fill(
            count,
            parents.as_mut_ptr(),
            uses.as_mut_ptr(),
            parts.as_mut_ptr(),
            placements.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(ModelInstances { parents, uses, parts, placements })
    }

    /// Where rays meet its faces first, with proof.
    pub fn rays(&self, origins: &[f64], directions: &[f64]) -> Result<ModelRays> {
        let n = rows(origins, 3, "origins")?;
        let directions = exactly(directions, 3 * n, "directions")?;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        let mut places = vec![[0; 2]; n];
        check(unsafe {
            sys::nurbs_model_rays(
                self.raw(),
                n as i64,
                origins.as_ptr(),
                directions,
                params.as_mut_ptr().cast(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
                places.as_mut_ptr().cast(),
            )
        })?;
        Ok(ModelRays { params, distances, status, places })
    }

    /// The same as `rays`; it can be watched and stopped.
    pub fn rays_with(&self, origins: &[f64], directions: &[f64], call: &mut Call) -> Result<ModelRays> {
        let n = rows(origins, 3, "origins")?;
        let directions = exactly(directions, 3 * n, "directions")?;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        let mut places = vec![[0; 2]; n];
        check(unsafe {
            sys::nurbs_model_rays_with(
                self.raw(),
                n as i64,
                origins.as_ptr(),
                directions,
                params.as_mut_ptr().cast(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
                places.as_mut_ptr().cast(),
                call.options(),
            )
        })?;
        Ok(ModelRays { params, distances, status, places })
    }

    /// All places where a ray meets its faces, by rising t.
    pub fn ray_hits(&self, origin: &[f64; 3], direction: &[f64; 3], range: &[f64]) -> Result<ModelRayHits> {
        let range = if_given(range, 2, "range")?;
        let mut complete = 0;
        let mut fill = |cap, params, distances, kinds, places, count| unsafe {
            sys::nurbs_model_ray_hits(
                self.raw(),
                origin.as_ptr(),
                direction.as_ptr(),
                range,
                cap,
                params,
                distances,
                kinds,
                places,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut places = vec![[0; 2]; n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            distances.as_mut_ptr(),
            kinds.as_mut_ptr(),
            places.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(ModelRayHits { params, distances, kinds, places, complete: complete != 0 })
    }

    /// The same as `ray_hits`; it can be watched and stopped.
    pub fn ray_hits_with(
        &self,
        origin: &[f64; 3],
        direction: &[f64; 3],
        range: &[f64],
        call: &mut Call,
    ) -> Result<ModelRayHits> {
        let range = if_given(range, 2, "range")?;
        let mut complete = 0;
        let mut fill = |cap, params, distances, kinds, places, count| unsafe {
            sys::nurbs_model_ray_hits_with(
                self.raw(),
                origin.as_ptr(),
                direction.as_ptr(),
                range,
                cap,
                params,
                distances,
                kinds,
                places,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut places = vec![[0; 2]; n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            distances.as_mut_ptr(),
            kinds.as_mut_ptr(),
            places.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(ModelRayHits { params, distances, kinds, places, complete: complete != 0 })
    }

    /// The points of its faces that are nearest to given points, with proof.
    pub fn closest_points<'a>(
        &self,
        points: impl Into<Records<'a>>,
        tolerance: f64,
    ) -> Result<ClosestOnModel> {
        let points = points.into();
        let n = points.count(3, "points")?;
        let mut params = vec![[0.0; 2]; n];
        let mut feet = vec![[0.0; 3]; n];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        let mut places = vec![[0; 2]; n];
        check(unsafe {
            sys::nurbs_model_closest_points(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                params.as_mut_ptr().cast(),
                feet.as_mut_ptr().cast(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
                places.as_mut_ptr().cast(),
            )
        })?;
        Ok(ClosestOnModel { params, points: feet, distances, status, places })
    }

    /// The same as `closest_points`; it can be watched and stopped.
    pub fn closest_points_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<ClosestOnModel> {
        let points = points.into();
        let n = points.count(3, "points")?;
        let mut params = vec![[0.0; 2]; n];
        let mut feet = vec![[0.0; 3]; n];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        let mut places = vec![[0; 2]; n];
        check(unsafe {
            sys::nurbs_model_closest_points_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                params.as_mut_ptr().cast(),
                feet.as_mut_ptr().cast(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
                places.as_mut_ptr().cast(),
                call.options(),
            )
        })?;
        Ok(ClosestOnModel { params, points: feet, distances, status, places })
    }

    /// Whether points are inside its solids: a `NURBS_SIDE_` constant each.
    pub fn classify<'a>(&self, points: impl Into<Records<'a>>, tolerance: f64) -> Result<Vec<i32>> {
        let points = points.into();
        let n = points.count(3, "points")?;
        let mut sides = vec![0; n];
        check(unsafe {
            sys::nurbs_model_classify(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                sides.as_mut_ptr(),
            )
        })?;
        Ok(sides)
    }

    /// The same as `classify`; it can be watched and stopped.
    pub fn classify_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Vec<i32>> {
        let points = points.into();
        let n = points.count(3, "points")?;
        let mut sides = vec![0; n];
        check(unsafe {
            sys::nurbs_model_classify_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                sides.as_mut_ptr(),
                call.options(),
            )
        })?;
        Ok(sides)
    }

    /// The area of all its faces where they stand.
    pub fn area(&self, relative_tolerance: f64) -> Result<Measured> {
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe { sys::nurbs_model_area(self.raw(), relative_tolerance, &mut value, &mut error) })?;
        Ok(Measured { value, error })
    }

    /// The same as `area`; it can be watched and stopped.
    pub fn area_with(&self, relative_tolerance: f64, call: &mut Call) -> Result<Measured> {
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_model_area_with(self.raw(), relative_tolerance, &mut value, &mut error, call.options())
        })?;
        Ok(Measured { value, error })
    }

    /// The volume that its solids hold where they stand, with centroid and inertia.
    pub fn volume(&self, relative_tolerance: f64) -> Result<EnclosedVolume> {
        let mut volume = 0.0;
        let mut centroid = [0.0; 3];
        let mut inertia = [[0.0; 3]; 3];
        let mut openness = 0.0;
        let mut error = 0.0;
        moments_of(&mut centroid, flat(&mut inertia), |centroid, inertia| unsafe {
            sys::nurbs_model_volume(
                self.raw(),
                relative_tolerance,
                &mut volume,
                centroid,
                inertia,
                &mut openness,
                &mut error,
            )
        })?;
        Ok(EnclosedVolume { volume, centroid, inertia, openness, error })
    }

    /// The same as `volume`; it can be watched and stopped.
    pub fn volume_with(&self, relative_tolerance: f64, call: &mut Call) -> Result<EnclosedVolume> {
        let mut volume = 0.0;
        let mut centroid = [0.0; 3];
        let mut inertia = [[0.0; 3]; 3];
        let mut openness = 0.0;
        let mut error = 0.0;
        moments_of(&mut centroid, flat(&mut inertia), |centroid, inertia| unsafe {
            sys::nurbs_model_volume_with(
                self.raw(),
                relative_tolerance,
                &mut volume,
                centroid,
                inertia,
                &mut openness,
                &mut error,
                call.options(),
            )
        })?;
        Ok(EnclosedVolume { volume, centroid, inertia, openness, error })
    }

    /// The curves and surfaces of a file that no face or edge consists of, with its unit and the notes on
    /// what was not read.
    pub fn splines(&self) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_model_splines(self.raw(), out) })
    }

    /// The layers that a curve or a surface is in which no face or edge consists of.
    pub fn spline_layers(&self, index: usize) -> Result<Vec<i64>> {
        let fill = |cap, layers, count| unsafe {
            sys::nurbs_model_spline_layers(self.raw(), index as i64, cap, layers, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut layers = vec![0; n];
        check(fill(count, layers.as_mut_ptr(), &mut count))?;
        Ok(layers)
    }

    /// How many layers faces and splines are in.
    pub fn layer_count(&self) -> Result<i64> {
        value(|count| unsafe { sys::nurbs_model_layer_count(self.raw(), count) })
    }

    /// The name of a layer.
    pub fn layer(&self, index: usize) -> Result<String> {
        written(|buf, cap, length| unsafe {
            sys::nurbs_model_layer(self.raw(), index as i64, buf, cap, length)
        })
    }

    /// Writes it to a file, which is replaced whole or not at all.
    pub fn write_file(
        &self,
        path: impl AsRef<Path>,
        format: i32,
        options: Option<&WriteOptions>,
    ) -> Result<()> {
        let path = path_text(path)?;
        check(unsafe {
            sys::nurbs_model_write_file(self.raw(), path.as_ptr(), format, write_options_pointer(options))
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
            sys::nurbs_model_write_file_with(
                self.raw(),
                path.as_ptr(),
                format,
                write_options_pointer(options),
                call.options(),
            )
        })
    }

    /// The model of what to_bytes() made of it.
    pub fn from_bytes(bytes: &[u8]) -> Result<Model> {
        Model::made(|out| unsafe {
            sys::nurbs_model_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out)
        })
    }
}
