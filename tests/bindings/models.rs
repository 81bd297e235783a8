// SPDX-License-Identifier: MIT
//! Models in Rust: bushing.step, the path of which is the argument.

mod common;

use common::{near, status_of};
use nurbs::{sys, Call, Face, List, Meet, Mesh, Model, Result, WriteOptions};
use std::f64::consts::PI;
use std::path::Path;

fn is_the_bushing(model: &Model) -> Result<()> {
    let n = model.counts()?;
    assert_eq!((n.faces, n.edges, n.vertices), (4, 6, 4));
    let bore = model.face(1)?;
    assert_eq!((model.face_name(1)?, bore.shape, bore.against), ("bore".to_string(), sys::NURBS_SHAPE_CYLINDER, true));
    assert!(near(&[bore.face.area(1e-12)?.value], &[24.0 * PI]));
    let seam = model.edge(4)?;
    assert_eq!((seam.shape, seam.vertices), (sys::NURBS_SHAPE_LINE, [0, 1]));
    assert_eq!(model.edge_uses(4)?, [[0, 0, 1], [0, 0, 3]]);
    assert_eq!(model.vertex(1)?, [5.0, 0.0, 4.0]);
    let whole = model.part_use(0)?;
    assert_eq!((whole.parent, whole.part, whole.placement[0]), (-1, 0, [1.0, 0.0, 0.0, 0.0]));
    assert_eq!((model.splines()?.unit()?, model.splines()?.len()), (0.001, 0));
    assert_eq!(status_of(model.face(4)), sys::NURBS_ERROR_INDEX);
    Ok(())
}

/// Its faces know each other again, without their keys.
fn sewn(model: &Model) -> Result<()> {
    let faces = (0..4).map(|i| Ok(model.face(i)?.face)).collect::<Result<Vec<Face>>>()?;
    let given: Vec<&Face> = faces.iter().collect();
    let again = Model::sew(&given, 1e-6, 0.001)?;
    assert_eq!(again.counts()?.edges, Model::sew_with(&given, 1e-6, 0.001, &mut Call::new())?.counts()?.edges);
    let gaps = again.edge_gaps()?;
    assert_eq!((gaps.uses, gaps.bounded), (vec![2; 6], vec![1; 6]));
    assert!(gaps.gaps.iter().all(|gap| *gap < 1e-6));
    assert_eq!(status_of(Model::sew(&given, 0.0, 0.0)), sys::NURBS_ERROR_TOLERANCE);
    assert_eq!(status_of(Model::sew(&[], 1.0, 0.0)), sys::NURBS_ERROR_COUNT);
    Ok(())
}

/// The same again of what is written, to memory and to a file.
fn written(model: &Model) -> Result<()> {
    let bytes = model.write(sys::NURBS_FORMAT_STEP, None)?;
    assert_eq!(bytes, model.write_with(sys::NURBS_FORMAT_STEP, None, &mut Call::new())?);
    is_the_bushing(&Model::read(&bytes, None)?)?;
    model.write_file("models_rust.step", sys::NURBS_FORMAT_STEP, None)?;
    is_the_bushing(&Model::read_file("models_rust.step", None)?)?;
    let metres = WriteOptions::new()?.unit(1.0);
    let splines = model.splines()?;
    assert_eq!(List::read(&splines.write(sys::NURBS_FORMAT_STEP, Some(&metres))?, None)?.unit()?, 1.0);
    assert_eq!(splines.write(sys::NURBS_FORMAT_STEP, None)?, splines.write_with(sys::NURBS_FORMAT_STEP, None, &mut Call::new())?);
    splines.write_file("models_rust.step", sys::NURBS_FORMAT_STEP, Some(&metres))?;
    assert_eq!(List::read_file("models_rust.step", None)?.unit()?, 1.0);
    assert_eq!(status_of(model.write(99, None)), sys::NURBS_ERROR_FORMAT);
    assert_eq!(status_of(model.write_file("/no/such/file", sys::NURBS_FORMAT_STEP, None)), sys::NURBS_ERROR_FILE);
    Ok(())
}

/// Its triangles as files.
fn triangles(model: &Model) -> Result<()> {
    let (wall, mut call) = (model.face(0)?.face, Call::new());
    let (all, same) =
        (Mesh::of_model_levels(model, &[1e-1, 1e-2], None)?, Mesh::of_model_levels_with(model, &[1e-2], None, &mut call)?);
    assert_eq!(all[1].counts()?.triangles, same[0].counts()?.triangles);
    let (one, again) =
        (Mesh::of_face_levels(&wall, &[1e-1], None)?, Mesh::of_face_levels_with(&wall, &[1e-1], None, &mut call)?);
    assert_eq!(one[0].counts()?.triangles, again[0].counts()?.triangles);
    let mesh = Mesh::of_model(model, None)?;
    let facets = mesh.counts()?.triangles as usize;
    assert_eq!(mesh.write(sys::NURBS_FORMAT_STL, None)?.len(), 84 + 50 * facets);
    let scene = mesh.write(sys::NURBS_FORMAT_GLB, None)?;
    assert_eq!(scene, mesh.write_with(sys::NURBS_FORMAT_GLB, None, &mut Call::new())?);
    let inches = WriteOptions::new()?.unit(0.0254);
    assert_ne!(mesh.write(sys::NURBS_FORMAT_OBJ, None)?, mesh.write(sys::NURBS_FORMAT_OBJ, Some(&inches))?);
    mesh.write_file("models_rust.ply", sys::NURBS_FORMAT_PLY, None)?;
    assert_eq!(status_of(mesh.write(sys::NURBS_FORMAT_STEP, None)), sys::NURBS_ERROR_FORMAT);
    assert_eq!(status_of(mesh.write_file("/no/such/file", sys::NURBS_FORMAT_VTU, None)), sys::NURBS_ERROR_FILE);
    Ok(())
}

fn bytes(model: &Model) -> Result<()> {
    let (whole, one) = (model.to_bytes()?, model.face(1)?.face.to_bytes()?);
    is_the_bushing(&Model::from_bytes(&whole)?)?;
    assert_eq!(Face::from_bytes(&one)?.to_bytes()?, one);
    assert_eq!(status_of(Model::from_bytes(&one)), sys::NURBS_ERROR_FORMAT);
    assert_eq!(status_of(Face::from_bytes(&whole)), sys::NURBS_ERROR_FORMAT);
    Ok(())
}

fn rays(model: &Model) -> Result<()> {
    let first = model.rays(&[9., 0.1, 2., 0., 0.1, 9.], &[-1., 0., 0., 0., 0., -1.])?;
    assert!(near(&first.distances[..1], &[9. - 24.99f64.sqrt()]) && first.distances[1].is_nan());
    assert_eq!(first.status, [sys::NURBS_RAY_HIT | sys::NURBS_RAY_CERTIFIED, sys::NURBS_RAY_CERTIFIED]);
    assert_eq!(first.places, [[0, 0], [-1, -1]]);
    let through = model.ray_hits(&[9., 0.1, 2.], &[-1., 0., 0.], &[])?;
    assert!(through.complete && through.distances.len() == 4 && through.places[1][0] == 1);
    assert_eq!(model.classify(&[4., 0.1, 2., 0., 0.1, 2.], 0.)?, [sys::NURBS_SIDE_INSIDE, sys::NURBS_SIDE_OUTSIDE]);
    let whole = model.instances()?;
    assert_eq!((whole.uses, whole.parents, whole.placements[0][5]), (vec![0], vec![-1], 1.));
    let foot = model.face(0)?.face.closest_points(&[9., 0., 2.], 1e-9)?;
    assert!((foot.distances[0] - 4.).abs() < 1e-8 && foot.status[0] & sys::NURBS_CLOSEST_CERTIFIED != 0);
    let outside = model.face(0)?.face.rays(&[9., 0.1, 2.], &[-1., 0., 0.])?;
    assert!(near(&outside.distances, &[9. - 24.99f64.sqrt()]));
    Ok(())
}

fn sections(model: &Model) -> Result<()> {
    let meet = Meet::model_sections(model, &[0., 0., 1., 0., 0., 1.], &[2., 9.], 1e-6)?;
    let ways = meet.ways()?;
    assert_eq!((ways.levels, ways.closed), (vec![0, 0], vec![1, 1]));
    assert_eq!((ways.firsts[0], ways.firsts[1]), (0, ways.sizes[0]));
    let faces = meet.faces()?;
    assert_eq!((faces.faces[0], faces.faces.last(), faces.instances[0]), (0, Some(&1), 0));
    let joints = meet.joints()?;
    assert_eq!(joints.faces.len(), joints.next_nodes.len());
    Ok(())
}

fn main() -> Result<()> {
    let path = std::env::args_os().nth(1).expect("the path of bushing.step");
    let model = Model::read_file(Path::new(&path), None)?;
    is_the_bushing(&model)?;
    is_the_bushing(&model.clone())?;
    sections(&model)?;
    sewn(&model)?;
    written(&model)?;
    triangles(&model)?;
    bytes(&model)?;
    rays(&model)?;
    let faces = [model.face(0)?.face, model.face(1)?.face.clone()];
    let two = Model::create(&[&faces[0], &faces[1]], 0.001)?;
    assert_eq!((two.counts()?.faces, two.face_name(1)?, two.part(0)?), (2, "1".to_string(), String::new()));
    assert_eq!(status_of(Model::create(&[], -1.0)), sys::NURBS_ERROR_FACTOR);
    assert_eq!(status_of(Model::read_file("/no/such/file", None)), sys::NURBS_ERROR_FILE);
    assert!(format!("{two:?}").contains("faces: 2"));
    Ok(())
}
