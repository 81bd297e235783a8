// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Curves where shapes meet, and the nodes where these end; every answer says whether it is complete.

use crate::arrays::{exactly, if_given, rows, Records};
use crate::call::Call;
use crate::error::{check, Result};
use crate::face::Face;
use crate::meet::Meet;
use crate::model::Model;
use crate::sizes::monomials;
use crate::spline::Spline;
use crate::sys;
use std::ptr::{null, null_mut};

/// How much a meet holds.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct MeetCounts {
    /// Number of branches.
    pub branches: i64,
    /// Number of nodes.
    pub nodes: i64,
    /// Whether it is proven that there is nothing else, no node being undecided.
    pub complete: bool,
}

/// What branches belong to, and where they end.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeetBranches {
    /// Which plane, or value, each belongs to.
    pub levels: Vec<i64>,
    /// `[n][2]`: the nodes at which it begins and ends, -1 where it closes.
    pub end_nodes: Vec<[i64; 2]>,
    /// The closed way that it is a part of, counted from 0; -1 for none.
    pub loops: Vec<i64>,
    /// Proven bounds of the distances of its curves from the section.
    pub deviations: Vec<f64>,
}

/// Where branches end, and where there may be more than they tell.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeetNodes {
    /// Which plane, or value, each belongs to.
    pub levels: Vec<i64>,
    /// One of the `NURBS_NODE_` constants each.
    pub kinds: Vec<i32>,
    /// `[n][2]` of the surface; of a part its middle.
    pub params: Vec<[f64; 2]>,
    /// `[n][2][2]` of parameters: the lower and upper end of the part on each axis.
    pub ranges: Vec<[f64; 2]>,
}

/// Where nodes are on the second of two surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeetPlaces {
    /// `[n][2]` of the surface; of a part its middle.
    pub params: Vec<[f64; 2]>,
    /// `[n][2][2]` of parameters: the lower and upper end of the part on each axis.
    pub ranges: Vec<[f64; 2]>,
}

/// Branches one after the other, each of which goes on where the one before ends.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeetWays {
    /// Which plane, or value, each belongs to.
    pub levels: Vec<i64>,
    /// The first branch.
    pub firsts: Vec<i64>,
    /// The number of branches.
    pub sizes: Vec<i64>,
    /// 1 for a way that closes, else 0.
    pub closed: Vec<i32>,
    /// The largest distances in space between ends that go on in each other.
    pub gaps: Vec<f64>,
}

/// The faces of a model on which branches are; -1 in a meet of one surface.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
#[non_exhaustive]
pub struct MeetFaces {
    /// The faces.
    pub faces: Vec<i64>,
    /// The instances of their parts.
    pub instances: Vec<i64>,
}

/// How ways go on at nodes, and the faces of a model on which these are.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeetJoints {
    /// The node of the branch that goes on, or that came here; -1: none.
    pub next_nodes: Vec<i64>,
    /// How far apart in space the ends of both branches are.
    pub gaps: Vec<f64>,
    /// The faces; -1 in a meet of one surface.
    pub faces: Vec<i64>,
    /// The instances of their parts.
    pub instances: Vec<i64>,
}

/// Curves where shapes meet, and the nodes where these end; every answer says whether it is complete.
impl Meet {
    /// Where planes normal . x = offset cut a surface: all curves to within a tolerance, proven to be all.
    pub fn sections(g: &Spline, normal: &[f64; 3], offsets: &[f64], tolerance: f64) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_sections(
                g.raw(),
                normal.as_ptr(),
                offsets.len() as i64,
                offsets.as_ptr(),
                tolerance,
                out,
            )
        })
    }

    /// The same as `sections`; it can be watched and stopped.
    pub fn sections_with(
        g: &Spline,
        normal: &[f64; 3],
        offsets: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_sections_with(
                g.raw(),
                normal.as_ptr(),
                offsets.len() as i64,
                offsets.as_ptr(),
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// Silhouettes, isophotes of some angles, and parabolic curves of a surface: all of them, proven to be
    /// all.
    pub fn contours(
        g: &Spline,
        kind: i32,
        d: Option<&[f64; 3]>,
        cosines: &[f64],
        tolerance: f64,
    ) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_contours(
                g.raw(),
                kind,
                d.map_or(null(), |values| values.as_ptr()),
                cosines.len() as i64,
                cosines.as_ptr(),
                tolerance,
                out,
            )
        })
    }

    /// The same as `contours`; it can be watched and stopped.
    pub fn contours_with(
        g: &Spline,
        kind: i32,
        d: Option<&[f64; 3]>,
        cosines: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_contours_with(
                g.raw(),
                kind,
                d.map_or(null(), |values| values.as_ptr()),
                cosines.len() as i64,
                cosines.as_ptr(),
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// Lines of light that a surface mirrors, or that its normals meet: all of them, proven to be all.
    pub fn reflections<'a>(
        g: &Spline,
        kind: i32,
        eye: Option<&[f64; 3]>,
        direction: &[f64; 3],
        points: impl Into<Records<'a>>,
        tolerance: f64,
    ) -> Result<Meet> {
        let points = points.into();
        let n = points.count(3, "points")?;
        Meet::made(|out| unsafe {
            sys::nurbs_surface_reflections(
                g.raw(),
                kind,
                eye.map_or(null(), |values| values.as_ptr()),
                direction.as_ptr(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                out,
            )
        })
    }

    /// The same as `reflections`; it can be watched and stopped.
    pub fn reflections_with<'a>(
        g: &Spline,
        kind: i32,
        eye: Option<&[f64; 3]>,
        direction: &[f64; 3],
        points: impl Into<Records<'a>>,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        let points = points.into();
        let n = points.count(3, "points")?;
        Meet::made(|out| unsafe {
            sys::nurbs_surface_reflections_with(
                g.raw(),
                kind,
                eye.map_or(null(), |values| values.as_ptr()),
                direction.as_ptr(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// Where an implicit polynomial of space vanishes on a surface, proven to be all.
    pub fn level(g: &Spline, degree: i32, coefficients: &[f64], tolerance: f64) -> Result<Meet> {
        let coefficients = exactly(coefficients, monomials(g.dimension()? as usize, degree), "coefficients")?;
        Meet::made(|out| unsafe { sys::nurbs_surface_level(g.raw(), degree, coefficients, tolerance, out) })
    }

    /// The same as `level`; it can be watched and stopped.
    pub fn level_with(
        g: &Spline,
        degree: i32,
        coefficients: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        let coefficients = exactly(coefficients, monomials(g.dimension()? as usize, degree), "coefficients")?;
        Meet::made(|out| unsafe {
            sys::nurbs_surface_level_with(g.raw(), degree, coefficients, tolerance, call.options(), out)
        })
    }

    /// Where a scalar spline over a surface has given values, proven to be all.
    pub fn level_curves(g: &Spline, scalar: &Spline, values: &[f64], tolerance: f64) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_level_curves(
                g.raw(),
                scalar.raw(),
                values.len() as i64,
                values.as_ptr(),
                tolerance,
                out,
            )
        })
    }

    /// The same as `level_curves`; it can be watched and stopped.
    pub fn level_curves_with(
        g: &Spline,
        scalar: &Spline,
        values: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_level_curves_with(
                g.raw(),
                scalar.raw(),
                values.len() as i64,
                values.as_ptr(),
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// Where two surfaces meet in curves, proven to be all.
    pub fn surfaces(a: &Spline, b: &Spline, tolerance: f64) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_surface_intersections(a.raw(), b.raw(), tolerance, out) })
    }

    /// The same as `surfaces`; it can be watched and stopped.
    pub fn surfaces_with(a: &Spline, b: &Spline, tolerance: f64, call: &mut Call) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_intersections_with(a.raw(), b.raw(), tolerance, call.options(), out)
        })
    }

    /// Where a surface meets itself in curves, proven to be all; without any it is proven to be simple.
    pub fn of_itself(g: &Spline, tolerance: f64) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_surface_self_intersections(g.raw(), tolerance, out) })
    }

    /// The same as `of_itself`; it can be watched and stopped.
    pub fn of_itself_with(g: &Spline, tolerance: f64, call: &mut Call) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_surface_self_intersections_with(g.raw(), tolerance, call.options(), out)
        })
    }

    /// Where two faces meet: in the edges that they share, and in curves inside of both.
    pub fn of_faces(a: &Face, b: &Face, tolerance: f64) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_face_intersections(a.raw(), b.raw(), tolerance, out) })
    }

    /// The same as `of_faces`; it can be watched and stopped.
    pub fn of_faces_with(a: &Face, b: &Face, tolerance: f64, call: &mut Call) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_face_intersections_with(a.raw(), b.raw(), tolerance, call.options(), out)
        })
    }

    /// A curve projected onto a surface along a direction, or normally: all curves on it, proven to be all.
    pub fn projection(g: &Spline, curve: &Spline, direction: &[f64], tolerance: f64) -> Result<Meet> {
        let direction = if_given(direction, 3, "direction")?;
        Meet::made(|out| unsafe {
            sys::nurbs_surface_project_curve(g.raw(), curve.raw(), direction, tolerance, out)
        })
    }

    /// The same as `projection`; it can be watched and stopped.
    pub fn projection_with(
        g: &Spline,
        curve: &Spline,
        direction: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        let direction = if_given(direction, 3, "direction")?;
        Meet::made(|out| unsafe {
            sys::nurbs_surface_project_curve_with(
                g.raw(),
                curve.raw(),
                direction,
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// A curve projected onto a face along a direction, or normally: all curves inside of its loops.
    pub fn face_projection(face: &Face, curve: &Spline, direction: &[f64], tolerance: f64) -> Result<Meet> {
        let direction = if_given(direction, 3, "direction")?;
        Meet::made(|out| unsafe {
            sys::nurbs_face_project_curve(face.raw(), curve.raw(), direction, tolerance, out)
        })
    }

    /// The same as `face_projection`; it can be watched and stopped.
    pub fn face_projection_with(
        face: &Face,
        curve: &Spline,
        direction: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        let direction = if_given(direction, 3, "direction")?;
        Meet::made(|out| unsafe {
            sys::nurbs_face_project_curve_with(
                face.raw(),
                curve.raw(),
                direction,
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// How much it holds.
    pub fn counts(&self) -> Result<MeetCounts> {
        let mut branches = 0;
        let mut nodes = 0;
        let mut complete = 0;
        check(unsafe { sys::nurbs_meet_counts(self.raw(), &mut branches, &mut nodes, &mut complete) })?;
        Ok(MeetCounts { branches, nodes, complete: complete != 0 })
    }

    /// What the branches belong to, and where they end.
    pub fn branches(&self) -> Result<MeetBranches> {
        let fill = |cap, levels, end_nodes, loops, deviations, count| unsafe {
            sys::nurbs_meet_branches(self.raw(), cap, levels, end_nodes, loops, deviations, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut levels = vec![0; n];
        let mut end_nodes = vec![[0; 2]; n];
        let mut loops = vec![0; n];
        let mut deviations = vec![0.0; n];
        check(fill(
            count,
            levels.as_mut_ptr(),
            end_nodes.as_mut_ptr().cast(),
            loops.as_mut_ptr(),
            deviations.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(MeetBranches { levels, end_nodes, loops, deviations })
    }

    /// What the branches are, one of the `NURBS_BRANCH_` constants each.
    pub fn kinds(&self) -> Result<Vec<i32>> {
        let fill = |cap, kinds, count| unsafe { sys::nurbs_meet_kinds(self.raw(), cap, kinds, count) };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut kinds = vec![0; n];
        check(fill(count, kinds.as_mut_ptr(), &mut count))?;
        Ok(kinds)
    }

    /// The curves of a branch, with common knots: in space, and in the parameter domain.
    pub fn branch(&self, index: usize) -> Result<(Spline, Spline)> {
        let mut space = null_mut();
        let on_surface =
            Spline::made(|out| unsafe { sys::nurbs_meet_branch(self.raw(), index as i64, &mut space, out) })?;
        Ok((unsafe { Spline::owned(space) }, on_surface))
    }

    /// The curve of a branch in the parameter domain of the second of two surfaces.
    pub fn branch_second(&self, index: usize) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_meet_branch_second(self.raw(), index as i64, out) })
    }

    /// Where branches end, and where there may be more than they tell.
    pub fn nodes(&self) -> Result<MeetNodes> {
        let fill = |cap, levels, kinds, params, ranges, count| unsafe {
            sys::nurbs_meet_nodes(self.raw(), cap, levels, kinds, params, ranges, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut levels = vec![0; n];
        let mut kinds = vec![0; n];
        let mut params = vec![[0.0; 2]; n];
        let mut ranges = vec![[0.0; 2]; 2 * n];
        check(fill(
            count,
            levels.as_mut_ptr(),
            kinds.as_mut_ptr(),
            params.as_mut_ptr().cast(),
            ranges.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(MeetNodes { levels, kinds, params, ranges })
    }

    /// Where the nodes are on the second of two surfaces.
    pub fn nodes_second(&self) -> Result<MeetPlaces> {
        let fill = |cap, params, ranges, count| unsafe {
            sys::nurbs_meet_nodes_second(self.raw(), cap, params, ranges, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 2]; n];
        let mut ranges = vec![[0.0; 2]; 2 * n];
        check(fill(count, params.as_mut_ptr().cast(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(MeetPlaces { params, ranges })
    }

    /// The ways that the branches make, from one to the next.
    pub fn ways(&self) -> Result<MeetWays> {
        let fill = |cap, levels, firsts, sizes, closed, gaps, count| unsafe {
            sys::nurbs_meet_ways(self.raw(), cap, levels, firsts, sizes, closed, gaps, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut levels = vec![0; n];
        let mut firsts = vec![0; n];
        let mut sizes = vec![0; n];
        let mut closed = vec![0; n];
        let mut gaps = vec![0.0; n];
        check(fill(
            count,
            levels.as_mut_ptr(),
            firsts.as_mut_ptr(),
            sizes.as_mut_ptr(),
            closed.as_mut_ptr(),
            gaps.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(MeetWays { levels, firsts, sizes, closed, gaps })
    }

    /// The faces of a model on which the branches are.
    pub fn faces(&self) -> Result<MeetFaces> {
        let fill = |cap, faces, instances, count| unsafe {
            sys::nurbs_meet_faces(self.raw(), cap, faces, instances, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut faces = vec![0; n];
        let mut instances = vec![0; n];
        check(fill(count, faces.as_mut_ptr(), instances.as_mut_ptr(), &mut count))?;
        Ok(MeetFaces { faces, instances })
    }

    /// The faces of the second of two models on which the branches are.
    pub fn faces_second(&self) -> Result<MeetFaces> {
        let fill = |cap, faces, instances, count| unsafe {
            sys::nurbs_meet_faces_second(self.raw(), cap, faces, instances, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut faces = vec![0; n];
        let mut instances = vec![0; n];
        check(fill(count, faces.as_mut_ptr(), instances.as_mut_ptr(), &mut count))?;
        Ok(MeetFaces { faces, instances })
    }

    /// How ways go on at the nodes, and on which faces of a model these are.
    pub fn joints(&self) -> Result<MeetJoints> {
        let fill = |cap, next_nodes, gaps, faces, instances, count| unsafe {
            sys::nurbs_meet_joints(self.raw(), cap, next_nodes, gaps, faces, instances, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut next_nodes = vec![0; n];
        let mut gaps = vec![0.0; n];
        let mut faces = vec![0; n];
        let mut instances = vec![0; n];
        check(fill(
            count,
            next_nodes.as_mut_ptr(),
            gaps.as_mut_ptr(),
            faces.as_mut_ptr(),
            instances.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(MeetJoints { next_nodes, gaps, faces, instances })
    }

    /// The faces of the second of two models on which the nodes are.
    pub fn joints_second(&self) -> Result<MeetFaces> {
        let fill = |cap, faces, instances, count| unsafe {
            sys::nurbs_meet_joints_second(self.raw(), cap, faces, instances, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut faces = vec![0; n];
        let mut instances = vec![0; n];
        check(fill(count, faces.as_mut_ptr(), instances.as_mut_ptr(), &mut count))?;
        Ok(MeetFaces { faces, instances })
    }

    /// Where planes cut the faces of a model, joined to ways over the edges that faces share.
    pub fn model_sections(model: &Model, normals: &[f64], offsets: &[f64], tolerance: f64) -> Result<Meet> {
        let n = rows(normals, 3, "normals")?;
        let offsets = exactly(offsets, n, "offsets")?;
        Meet::made(|out| unsafe {
            sys::nurbs_model_sections(model.raw(), n as i64, normals.as_ptr(), offsets, tolerance, out)
        })
    }

    /// The same as `model_sections`; it can be watched and stopped.
    pub fn model_sections_with(
        model: &Model,
        normals: &[f64],
        offsets: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Meet> {
        let n = rows(normals, 3, "normals")?;
        let offsets = exactly(offsets, n, "offsets")?;
        Meet::made(|out| unsafe {
            sys::nurbs_model_sections_with(
                model.raw(),
                n as i64,
                normals.as_ptr(),
                offsets,
                tolerance,
                call.options(),
                out,
            )
        })
    }

    /// Where the faces of two models meet, joined to ways over the edges that faces share.
    pub fn of_models(a: &Model, b: &Model, tolerance: f64) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_model_intersections(a.raw(), b.raw(), tolerance, out) })
    }

    /// The same as `of_models`; it can be watched and stopped.
    pub fn of_models_with(a: &Model, b: &Model, tolerance: f64, call: &mut Call) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_model_intersections_with(a.raw(), b.raw(), tolerance, call.options(), out)
        })
    }

    /// What of the branches lies in a face of the surface that they are on.
    pub fn trimmed(meet: &Meet, face: &Face) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_meet_trim(meet.raw(), face.raw(), out) })
    }

    /// The same as `trimmed`; it can be watched and stopped.
    pub fn trimmed_with(meet: &Meet, face: &Face, call: &mut Call) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_meet_trim_with(meet.raw(), face.raw(), call.options(), out) })
    }

    /// What of the branches of two surfaces lies in a face of the second one.
    pub fn trimmed_second(meet: &Meet, face: &Face) -> Result<Meet> {
        Meet::made(|out| unsafe { sys::nurbs_meet_trim_second(meet.raw(), face.raw(), out) })
    }

    /// The same as `trimmed_second`; it can be watched and stopped.
    pub fn trimmed_second_with(meet: &Meet, face: &Face, call: &mut Call) -> Result<Meet> {
        Meet::made(|out| unsafe {
            sys::nurbs_meet_trim_second_with(meet.raw(), face.raw(), call.options(), out)
        })
    }
}
