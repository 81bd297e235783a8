// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Shapes made of what is straight and flat, within a proven distance.

use crate::call::Call;
use crate::error::{check, Result};
use crate::face::Face;
use crate::list::{path_text, write_options_pointer, WriteOptions};
use crate::mesh::{mesh_options_pointer, Mesh, MeshOptions};
use crate::model::Model;
use crate::spline::Spline;
use crate::sys;
use std::path::Path;
use std::ptr::null_mut;

/// A polyline in place of a curve: parameters and points of its vertices, and how far it is from the curve,
/// as proven.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CurvePolyline {
    /// Of the vertices, rising; the same one twice where the curve jumps.
    pub params: Vec<f64>,
    /// The vertices, packed.
    pub points: Vec<f64>,
    /// No distance of a segment from its part of the curve is larger.
    pub bound: f64,
    /// Whether all segments keep to the limits, as proven.
    pub reached: bool,
}

/// How much a mesh holds.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct MeshCounts {
    /// Number of points.
    pub points: i64,
    /// Number of vertices.
    pub vertices: i64,
    /// Number of triangles.
    pub triangles: i64,
    /// Number of faces.
    pub faces: i64,
    /// Number of polylines of edges.
    pub edges: i64,
    /// Number of their vertices, all together.
    pub edge_points: i64,
}

/// How far a mesh and its shape are from each other, as proven.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshBound {
    /// No point of the shape is farther from the mesh.
    pub from_shape: f64,
    /// No point of the mesh is farther from the shape.
    pub from_mesh: f64,
    /// Whether all that was asked for is proven.
    pub reached: bool,
}

/// The vertices of a mesh, those of each face one after the other.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshVertices {
    /// The point at which each is.
    pub points: Vec<i64>,
    /// `[n][2]` of the surface of the face.
    pub params: Vec<[f64; 2]>,
    /// `[n][3]`, of length 1; NaN where there is none.
    pub normals: Vec<[f64; 3]>,
}

/// The vertices of a mesh as programs that draw want them.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DrawableVertices {
    /// `[n][3]` in space.
    pub points: Vec<[f32; 3]>,
    /// `[n][2]` of the surface of the face.
    pub params: Vec<[f32; 2]>,
    /// `[n][3]`, of length 1; NaN where there is none.
    pub normals: Vec<[f32; 3]>,
}

/// Pairs of triangles that are all of a cell of the domain.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct MeshQuads {
    /// `[n][4]` vertices, or points, of which 0, 1, 2 and 0, 2, 3 are the triangles.
    pub corners: Vec<[i64; 4]>,
    /// The first of the two triangles of each; the next one is the second.
    pub triangles: Vec<i64>,
}

/// What of a mesh stands for which face.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshFaces {
    /// The first vertex.
    pub first_vertices: Vec<i64>,
    /// The number of vertices.
    pub vertex_counts: Vec<i64>,
    /// The first triangle.
    pub first_triangles: Vec<i64>,
    /// The number of triangles.
    pub triangle_counts: Vec<i64>,
    /// No point of the face is farther from its triangles.
    pub from_shape: Vec<f64>,
    /// No point of its triangles is farther from the face.
    pub from_mesh: Vec<f64>,
    /// 1 where all that was asked for is proven, else 0.
    pub reached: Vec<i32>,
}

/// The polylines that stand for edges in a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshEdges {
    /// The edge of the model; -1 for one that belongs to one face only.
    pub edges: Vec<i64>,
    /// Its first vertex among those of all polylines.
    pub firsts: Vec<i64>,
    /// The number of its vertices.
    pub sizes: Vec<i64>,
    /// No point of the edge is farther from the polyline, and none of that from the edge.
    pub bounds: Vec<f64>,
    /// 1 where all that was asked for is proven, else 0.
    pub reached: Vec<i32>,
}

/// Hexahedra in place of a volume, last axis fastest.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshHexahedra {
    /// `[n][8]` points, in the order of VTK_HEXAHEDRON.
    pub corners: Vec<[i64; 8]>,
    /// `[n][3][2]` ends along each axis of the volume.
    pub domains: Vec<[f64; 2]>,
    /// A `NURBS_FOLD_` constant: whether the volume folds there.
    pub folds: Vec<i32>,
    /// 1 or -1: the sign of the Jacobian of the volume there, if it is proven to be one; else 0.
    pub signs: Vec<i32>,
}

/// A spline as Bezier cells.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct BezierCells {
    /// `[n][M]` control points of each, in the order of VTK.
    pub cells: Vec<i64>,
    /// What VTK calls such cells.
    pub kind: i32,
    /// The number of control points.
    pub point_count: i64,
}

/// The control points of Bezier cells, each once.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BezierCellPoints {
    /// `[n][dim]`.
    pub points: Vec<f64>,
    /// Their weights.
    pub weights: Vec<f64>,
}

/// Shapes made of what is straight and flat, within a proven distance.
impl Spline {
    /// A polyline in place of a curve, every segment within `chord` of its part of the curve, as proven; with
    /// an angle between tangents in a segment and a length of segments that are not exceeded either, if they
    /// are not 0.
    pub fn mesh_curve(&self, chord: f64, angle: f64, longest: f64) -> Result<CurvePolyline> {
        let mut bound = 0.0;
        let mut reached = 0;
        let mut fill = |cap, params, points, count| unsafe {
            sys::nurbs_mesh_curve(
                self.raw(),
                chord,
                angle,
                longest,
                cap,
                params,
                points,
                &mut bound,
                &mut reached,
                count,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut points = vec![0.0; n * self.dimension()? as usize];
        check(fill(count, params.as_mut_ptr(), points.as_mut_ptr(), &mut count))?;
        Ok(CurvePolyline { params, points, bound, reached: reached != 0 })
    }

    /// The same as `mesh_curve`; it can be watched and stopped.
    pub fn mesh_curve_with(
        &self,
        chord: f64,
        angle: f64,
        longest: f64,
        call: &mut Call,
    ) -> Result<CurvePolyline> {
        let mut bound = 0.0;
        let mut reached = 0;
        let mut fill = |cap, params, points, count| unsafe {
            sys::nurbs_mesh_curve_with(
                self.raw(),
                chord,
                angle,
                longest,
                cap,
                params,
                points,
                &mut bound,
                &mut reached,
                count,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut points = vec![0.0; n * self.dimension()? as usize];
        check(fill(count, params.as_mut_ptr(), points.as_mut_ptr(), &mut count))?;
        Ok(CurvePolyline { params, points, bound, reached: reached != 0 })
    }

    /// The polynomial pieces as Bezier cells in the order of VTK, by places in bezier_cell_points.
    pub fn bezier_cells(&self) -> Result<BezierCells> {
        let mut kind = 0;
        let mut point_count = 0;
        let mut fill = |cap, cells, count| unsafe {
            sys::nurbs_bezier_cells(self.raw(), cap, cells, &mut kind, &mut point_count, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut cells = vec![0; n * self.active()?];
        check(fill(count, cells.as_mut_ptr(), &mut count))?;
        Ok(BezierCells { cells, kind, point_count })
    }

    /// The control points of the Bezier cells, each once, and their weights.
    pub fn bezier_cell_points(&self) -> Result<BezierCellPoints> {
        let fill = |cap, points, weights, count| unsafe {
            sys::nurbs_bezier_cell_points(self.raw(), cap, points, weights, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut points = vec![0.0; n * self.dimension()? as usize];
        let mut weights = vec![0.0; n];
        check(fill(count, points.as_mut_ptr(), weights.as_mut_ptr(), &mut count))?;
        Ok(BezierCellPoints { points, weights })
    }
}

/// Shapes made of what is straight and flat, within a proven distance.
impl Mesh {
    /// Triangles in place of a whole surface, within a proven distance, both ways.
    pub fn of_surface(g: &Spline, options: Option<&MeshOptions>) -> Result<Mesh> {
        Mesh::made(|out| unsafe { sys::nurbs_mesh_surface(g.raw(), mesh_options_pointer(options), out) })
    }

    /// The same as `of_surface`; it can be watched and stopped.
    pub fn of_surface_with(g: &Spline, options: Option<&MeshOptions>, call: &mut Call) -> Result<Mesh> {
        Mesh::made(|out| unsafe {
            sys::nurbs_mesh_surface_with(g.raw(), mesh_options_pointer(options), call.options(), out)
        })
    }

    /// Triangles in place of a trimmed face, within a proven distance, both ways.
    pub fn of_face(face: &Face, options: Option<&MeshOptions>) -> Result<Mesh> {
        Mesh::made(|out| unsafe { sys::nurbs_mesh_face(face.raw(), mesh_options_pointer(options), out) })
    }

    /// The same as `of_face`; it can be watched and stopped.
    pub fn of_face_with(face: &Face, options: Option<&MeshOptions>, call: &mut Call) -> Result<Mesh> {
        Mesh::made(|out| unsafe {
            sys::nurbs_mesh_face_with(face.raw(), mesh_options_pointer(options), call.options(), out)
        })
    }

    /// Triangles in place of all faces of a model, with common points along common edges.
    pub fn of_model(model: &Model, options: Option<&MeshOptions>) -> Result<Mesh> {
        Mesh::made(|out| unsafe { sys::nurbs_mesh_model(model.raw(), mesh_options_pointer(options), out) })
    }

    /// The same as `of_model`; it can be watched and stopped.
    pub fn of_model_with(model: &Model, options: Option<&MeshOptions>, call: &mut Call) -> Result<Mesh> {
        Mesh::made(|out| unsafe {
            sys::nurbs_mesh_model_with(model.raw(), mesh_options_pointer(options), call.options(), out)
        })
    }

    /// Hexahedra in place of a volume, within a proven distance, on a grid of lines along its axes; at most
    /// so many if `limit` is not 0.
    pub fn of_volume(g: &Spline, options: Option<&MeshOptions>, limit: i64) -> Result<Mesh> {
        Mesh::made(|out| unsafe {
            sys::nurbs_mesh_volume(g.raw(), mesh_options_pointer(options), limit, out)
        })
    }

    /// The same as `of_volume`; it can be watched and stopped.
    pub fn of_volume_with(
        g: &Spline,
        options: Option<&MeshOptions>,
        limit: i64,
        call: &mut Call,
    ) -> Result<Mesh> {
        Mesh::made(|out| unsafe {
            sys::nurbs_mesh_volume_with(g.raw(), mesh_options_pointer(options), limit, call.options(), out)
        })
    }

    /// How much it holds.
    pub fn counts(&self) -> Result<MeshCounts> {
        let mut points = 0;
        let mut vertices = 0;
        let mut triangles = 0;
        let mut faces = 0;
        let mut edges = 0;
        let mut edge_points = 0;
        check(unsafe {
            sys::nurbs_mesh_counts(
                self.raw(),
                &mut points,
                &mut vertices,
                &mut triangles,
                &mut faces,
                &mut edges,
                &mut edge_points,
            )
        })?;
        Ok(MeshCounts { points, vertices, triangles, faces, edges, edge_points })
    }

    /// How far the mesh and its shape are from each other, as proven.
    pub fn bound(&self) -> Result<MeshBound> {
        let mut from_shape = 0.0;
        let mut from_mesh = 0.0;
        let mut reached = 0;
        check(unsafe { sys::nurbs_mesh_bound(self.raw(), &mut from_shape, &mut from_mesh, &mut reached) })?;
        Ok(MeshBound { from_shape, from_mesh, reached: reached != 0 })
    }

    /// The points, `[n][3]`.
    pub fn points(&self) -> Result<Vec<[f64; 3]>> {
        let fill = |cap, points, count| unsafe { sys::nurbs_mesh_points(self.raw(), cap, points, count) };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut points = vec![[0.0; 3]; n];
        check(fill(count, points.as_mut_ptr().cast(), &mut count))?;
        Ok(points)
    }

    /// The points, `[n][3]`, in single precision.
    pub fn points_f32(&self) -> Result<Vec<[f32; 3]>> {
        let fill = |cap, points, count| unsafe { sys::nurbs_mesh_points_f32(self.raw(), cap, points, count) };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut points = vec![[0.0; 3]; n];
        check(fill(count, points.as_mut_ptr().cast(), &mut count))?;
        Ok(points)
    }

    /// The vertices, those of each face one after the other.
    pub fn vertices(&self) -> Result<MeshVertices> {
        let fill = |cap, points, params, normals, count| unsafe {
            sys::nurbs_mesh_vertices(self.raw(), cap, points, params, normals, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut points = vec![0; n];
        let mut params = vec![[0.0; 2]; n];
        let mut normals = vec![[0.0; 3]; n];
        check(fill(
            count,
            points.as_mut_ptr(),
            params.as_mut_ptr().cast(),
            normals.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(MeshVertices { points, params, normals })
    }

    /// The vertices as programs that draw want them, in single precision, with their points.
    pub fn vertices_f32(&self) -> Result<DrawableVertices> {
        let fill = |cap, points, params, normals, count| unsafe {
            sys::nurbs_mesh_vertices_f32(self.raw(), cap, points, params, normals, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut points = vec![[0.0; 3]; n];
        let mut params = vec![[0.0; 2]; n];
        let mut normals = vec![[0.0; 3]; n];
        check(fill(
            count,
            points.as_mut_ptr().cast(),
            params.as_mut_ptr().cast(),
            normals.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(DrawableVertices { points, params, normals })
    }

    /// The corners of triangles, `[n][3]`: vertices, or with `NURBS_MESH_WELDED` points.
    pub fn triangles(&self, flags: u32) -> Result<Vec<[i64; 3]>> {
        let fill = |cap, corners, count| unsafe {
            sys::nurbs_mesh_triangles(self.raw(), flags, cap, corners, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut corners = vec![[0; 3]; n];
        check(fill(count, corners.as_mut_ptr().cast(), &mut count))?;
        Ok(corners)
    }

    /// The corners of triangles, `[n][3]`, in 32 bits: vertices, or with `NURBS_MESH_WELDED` points.
    pub fn triangles_i32(&self, flags: u32) -> Result<Vec<[i32; 3]>> {
        let fill = |cap, corners, count| unsafe {
            sys::nurbs_mesh_triangles_i32(self.raw(), flags, cap, corners, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut corners = vec![[0; 3]; n];
        check(fill(count, corners.as_mut_ptr().cast(), &mut count))?;
        Ok(corners)
    }

    /// Pairs of triangles that are all of a cell: their corners, vertices or with `NURBS_MESH_WELDED` points.
    pub fn quads(&self, flags: u32) -> Result<MeshQuads> {
        let fill = |cap, corners, triangles, count| unsafe {
            sys::nurbs_mesh_quads(self.raw(), flags, cap, corners, triangles, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut corners = vec![[0; 4]; n];
        let mut triangles = vec![0; n];
        check(fill(count, corners.as_mut_ptr().cast(), triangles.as_mut_ptr(), &mut count))?;
        Ok(MeshQuads { corners, triangles })
    }

    /// What of it stands for which face, and how far that is from the face.
    pub fn faces(&self) -> Result<MeshFaces> {
        let fill = |cap,
                    first_vertices,
                    vertex_counts,
                    first_triangles,
                    triangle_counts,
                    from_shape,
                    from_mesh,
                    reached,
                    count| unsafe {
            sys::nurbs_mesh_faces(
                self.raw(),
                cap,
                first_vertices,
                vertex_counts,
                first_triangles,
                triangle_counts,
                from_shape,
                from_mesh,
                reached,
                count,
            )
        };
        let mut count = 0;
        check(fill(
            0,
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            null_mut(),
            &mut count,
        ))?;
        let n = count as usize;
        let mut first_vertices = vec![0; n];
        let mut vertex_counts = vec![0; n];
        let mut first_triangles = vec![0; n];
        let mut triangle_counts = vec![0; n];
        let mut from_shape = vec![0.0; n];
        let mut from_mesh = vec![0.0; n];
        let mut reached = vec![0; n];
        check(fill(
            count,
            first_vertices.as_mut_ptr(),
            vertex_counts.as_mut_ptr(),
            first_triangles.as_mut_ptr(),
            triangle_counts.as_mut_ptr(),
            from_shape.as_mut_ptr(),
            from_mesh.as_mut_ptr(),
            reached.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(MeshFaces {
            first_vertices,
            vertex_counts,
            first_triangles,
            triangle_counts,
            from_shape,
            from_mesh,
            reached,
        })
    }

    /// The polylines that stand for edges.
    pub fn edges(&self) -> Result<MeshEdges> {
        let fill = |cap, edges, firsts, sizes, bounds, reached, count| unsafe {
            sys::nurbs_mesh_edges(self.raw(), cap, edges, firsts, sizes, bounds, reached, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut edges = vec![0; n];
        let mut firsts = vec![0; n];
        let mut sizes = vec![0; n];
        let mut bounds = vec![0.0; n];
        let mut reached = vec![0; n];
        check(fill(
            count,
            edges.as_mut_ptr(),
            firsts.as_mut_ptr(),
            sizes.as_mut_ptr(),
            bounds.as_mut_ptr(),
            reached.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(MeshEdges { edges, firsts, sizes, bounds, reached })
    }

    /// The points of the mesh that polylines of edges have, one polyline after the other.
    pub fn edge_points(&self) -> Result<Vec<i64>> {
        let fill = |cap, own_points, count| unsafe {
            sys::nurbs_mesh_edge_points(self.raw(), cap, own_points, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut own_points = vec![0; n];
        check(fill(count, own_points.as_mut_ptr(), &mut count))?;
        Ok(own_points)
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
            sys::nurbs_mesh_write_file(self.raw(), path.as_ptr(), format, write_options_pointer(options))
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
            sys::nurbs_mesh_write_file_with(
                self.raw(),
                path.as_ptr(),
                format,
                write_options_pointer(options),
                call.options(),
            )
        })
    }

    /// The hexahedra of the mesh of a volume.
    pub fn hexahedra(&self) -> Result<MeshHexahedra> {
        let fill = |cap, corners, domains, folds, signs, count| unsafe {
            sys::nurbs_mesh_hexahedra(self.raw(), cap, corners, domains, folds, signs, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut corners = vec![[0; 8]; n];
        let mut domains = vec![[0.0; 2]; 3 * n];
        let mut folds = vec![0; n];
        let mut signs = vec![0; n];
        check(fill(
            count,
            corners.as_mut_ptr().cast(),
            domains.as_mut_ptr().cast(),
            folds.as_mut_ptr(),
            signs.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(MeshHexahedra { corners, domains, folds, signs })
    }
}
