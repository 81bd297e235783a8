// SPDX-License-Identifier: MIT
//! The Rust binding: create, evaluate a batch, insert a knot, and be told what is wrong.

mod common;

use common::{close, EPS};
use nurbs::{sys, List, Records, RecordsMut, Result, Spline};
use std::thread;

const CIRCLE: [f64; 18] = [1., 0., 1., 1., 0., 1., -1., 1., -1., 0., -1., -1., 0., -1., 1., -1., 1., 0.];

/// The unit circle as four rational quadratic quarters.
fn circle() -> Result<Spline> {
    let s = 0.5f64.sqrt();
    let knots = nurbs::knots_bezier(2, 4)?;
    Spline::create(&[2], &[9], &knots, 2, &CIRCLE, Some(&[1., s, 1., s, 1., s, 1., s, 1.]), 0)
}

/// z = u v over the unit square.
fn patch() -> Result<Spline> {
    Spline::bezier(&[1, 1], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)
}

fn params() -> Vec<f64> {
    (0..=1000).map(|i| f64::from(i) / 1000.0).collect()
}

fn known_points() -> Result<()> {
    assert_eq!(circle()?.eval(&[0.0, 0.25, 0.5, 0.75], 0)?, [1., 0., 0., 1., -1., 0., 0., -1.]);
    let derivs = patch()?.eval_derivs(2, &[0.25, 0.5], 0)?;
    let z: Vec<f64> = derivs.chunks(3).map(|d| d[2]).collect();
    assert_eq!(z, [0.125, 0.5, 0.25, 0.0, 1.0, 0.0]);
    assert_eq!(patch()?.iso(0, 0.5, 0)?.eval(&[1.0], 0)?, [0.5, 1.0, 0.5]);
    Ok(())
}

fn grid_equals_points() -> Result<()> {
    let (u, v) = ([0.0, 0.3, 1.0], [0.1, 0.7]);
    let pairs: Vec<f64> = u.iter().flat_map(|&a| v.iter().flat_map(move |&b| [a, b])).collect();
    assert_eq!(patch()?.eval_grid(&[&u, &v], 0)?, patch()?.eval(&pairs, 0)?);
    assert_eq!(patch()?.eval_grid_derivs(1, &[&u, &v], 0)?, patch()?.eval_derivs(1, &pairs, 0)?);
    Ok(())
}

fn single_precision_is_rounded_once() -> Result<()> {
    let rounded = |points: Vec<f64>| points.iter().map(|&x| x as f32).collect::<Vec<f32>>();
    assert_eq!(circle()?.eval_f32(&params(), 0)?, rounded(circle()?.eval(&params(), 0)?));
    let grid: [&[f64]; 2] = [&[0.0, 0.3, 1.0], &[0.1, 0.7]];
    assert_eq!(patch()?.eval_grid_f32(&grid, 0)?, rounded(patch()?.eval_grid(&grid, 0)?));
    Ok(())
}

/// L = x + 2 y of a point of the circle at t = 0, the first control point.
fn data_derivatives() -> Result<()> {
    let c = circle()?;
    let m = c.rational_collocation(&[], &[0.0, 0.25], 0)?;
    assert_eq!((m.columns, m.row_pointers), (vec![0, 1, 2, 2, 3, 4], vec![0, 3, 6]));
    assert_eq!(m.values, [1., 0., 0., 1., 0., 0.]);
    let n = nurbs::collocation(&[1, 1], &[&[0., 0., 1., 1.], &[0., 0., 1., 1.]], &[0, 1], &[0.25, 0.5], 0)?;
    assert_eq!(n.values, [-0.75, 0.75, -0.25, 0.25]);
    let e = c.bezier_extraction(0)?;
    assert_eq!((e.firsts, e.domains[1]), (vec![0, 2, 4, 6], [0.25, 0.5]));
    assert_eq!(e.operators[9..18], [1., 0., 0., 0., 1., 0., 0., 0., 1.]);
    let g = c.eval_adjoint(0, &[0.0], &[1.0, 2.0], 0)?;
    assert!(g.points[..2] == [1.0, 2.0] && g.points[2..].iter().all(|&x| x == 0.0));
    assert!(g.weights == [0.0; 9] && (g.params[0] - 16.0 * 0.5f64.sqrt()).abs() < 1e-14);
    let mut twice = g.points.clone();
    let out = nurbs::GradientsMut { points: Some((&mut twice).into()), ..Default::default() };
    c.eval_adjoint_into(0, &[0.0], &[1.0, 2.0], out, sys::NURBS_ACCUMULATE)?;
    assert_eq!(twice[..2], [2.0, 4.0]);
    Ok(())
}

fn insertion_keeps_the_circle() -> Result<()> {
    let (before, t) = (circle()?, params());
    let after = before.insert_knot(0, 0.3, 2)?;
    assert_eq!(after.count(0)?, 11);
    assert_eq!(after.knots(0)?.iter().filter(|&&knot| knot == 0.3).count(), 2);
    let points = after.eval(&t, 0)?;
    assert!(close(&points, &before.eval(&t, 0)?, 8.0 * EPS));
    assert!(points.chunks(2).all(|p| (p[0].hypot(p[1]) - 1.0).abs() <= 8.0 * EPS));
    Ok(())
}

fn forms_and_maps() -> Result<()> {
    let g = circle()?;
    assert_eq!(g.elevate(0, 2)?.degree(0)?, 4);
    assert_eq!(g.reverse(0, 0)?.reverse(0, 0)?.points()?, g.points()?);
    assert_eq!(g.reverse(0, nurbs::sys::NURBS_KEEP_DOMAIN)?.eval(&[0.25], 0)?, [0.0, -1.0]);
    assert_eq!(g.reparametrize(0, 1.0, 5.0)?.eval(&[2.0], 0)?, [0.0, 1.0]);
    assert_eq!(g.to_homogeneous()?.from_homogeneous()?.weights()?, g.weights()?);
    assert!(g.make_rational()?.is_rational()? && !g.make_rational()?.is_homogeneous()?);
    let moved = g.transform(2, &[0.0, 1.0, 2.0, 0.0], Some(&[10.0, 20.0]))?;
    assert_eq!(moved.eval(&[0.0], 0)?, [10.0, 22.0]);
    let half = g.transform_projective(2, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0])?;
    assert_eq!(half.eval(&[0.25], 0)?, [0.0, 0.5]);
    assert_eq!(g.transform(1, &[1.0], None).map(|_| ()).unwrap_err().status, nurbs::sys::NURBS_ERROR_SIZE);
    let patch = Spline::bezier(&[1, 1], 1, &[0.0, 1.0, 2.0, 3.0], None)?;
    assert_eq!(patch.transpose(&[1, 0])?.points()?, [0.0, 2.0, 1.0, 3.0]);
    Ok(())
}

fn calculus_and_weights() -> Result<()> {
    let g = circle()?;
    let line = Spline::bezier(&[1], 2, &[0.0, 2.0, 1.0, 4.0], None)?; // (t, 2 + 2 t)
    assert_eq!(line.blossom(&[0.5], &[0.25], 0)?, [0.25, 2.5]);
    assert_eq!(line.derivative(0, 1)?.eval(&[0.3], 0)?, [1.0, 2.0]);
    assert_eq!(line.antiderivative(0)?.eval(&[1.0], 0)?, [0.5, 3.0]);
    assert_eq!(line.product(&line, sys::NURBS_PRODUCT_DOT)?.eval(&[1.0], 0)?, [17.0]);
    let square = Spline::bezier(&[2], 1, &[0.0, 0.0, 1.0], None)?;
    assert_eq!(line.compose(&square)?.eval(&[0.5], 0)?, [0.25, 2.5]);
    assert_eq!(line.sum(2.0, &line, 1.0)?.eval(&[1.0], 0)?, [3.0, 12.0]);
    assert_eq!(g.derivative(0, 1)?.degree(0)?, 4);
    assert!(!line.make_rational()?.normalize_weights()?.is_rational()?);
    let moved = g.reparametrize_moebius(0, 4.0)?;
    assert!((moved.weights()?[8] - 4.0).abs() < 64.0 * EPS);
    assert!((moved.equalize_end_weights(0)?.weights()?[8] - 1.0).abs() < 64.0 * EPS);
    assert_eq!(g.antiderivative(0).err().map(|e| e.status), Some(sys::NURBS_ERROR_RATIONAL));
    Ok(())
}

fn parts_of_the_circle() -> Result<()> {
    let (g, t) = (circle()?, params());
    assert_eq!(g.refine(0, &[0.6, 0.3])?.count(0)?, 11);
    assert_eq!(g.refine_uniform(0, 2)?.count(0)?, 13);
    assert_eq!(g.refinement_matrix(0, &[0.1])?.row_pointers.len(), 11);
    let (lower, upper) = g.split(0, 0.3)?;
    let joined = nurbs::join(&[&lower, &upper], 0, 0.0, 0)?;
    assert_eq!(joined.gap, 0.0);
    assert!(close(&joined.spline.eval(&t, 0)?, &g.eval(&t, 0)?, 8.0 * EPS));
    assert_eq!(g.extract(&[0.1], &[0.2])?.count(0)?, 3);
    assert_eq!((g.decompose()?.len(), g.split_at_knots(0, 0)?.len()), (4, 1));
    assert_eq!(g.clamp(0, 3)?.count(0)?, 9);
    assert_eq!(g.move_seam(0, 0.3).err().map(|e| e.status), Some(sys::NURBS_ERROR_NOT_PERIODIC));
    Ok(())
}

fn circles_made_compatible() -> Result<()> {
    let (g, finer) = (circle()?, circle()?.insert_knot(0, 0.3, 1)?);
    let (list, moved) = nurbs::make_compatible(&[&g, &finer], 0.0, 0)?;
    assert_eq!((list.len(), moved), (2, 0.0));
    let (snapped, moved) = finer.snap_knots(0, 0.06)?;
    assert!(moved > 0.0 && snapped.knots(0)?[5] == 0.25);
    Ok(())
}

fn continuity_of_the_circle() -> Result<()> {
    let rows = circle()?.continuity(0, nurbs::ContinuityTolerances::default())?;
    assert!(rows.len() == 4 && rows[0].knot == 0.25 && rows[0].found.order == 1);
    let (lower, upper) = circle()?.split(0, 0.3)?;
    let (a, b) = ((&lower, sys::NURBS_END), (&upper, sys::NURBS_START));
    assert_eq!(nurbs::continuity_between(a, b, nurbs::ContinuityTolerances::default())?.geometric, 2);
    Ok(())
}

fn beyond_the_ends() -> Result<()> {
    assert_eq!(circle()?.extend(0, sys::NURBS_END, 0.5, 1)?.domain(0)?[1], 1.5);
    assert_eq!(circle()?.unclamp(0, 3)?.count(0)?, 9);
    let looped = circle()?.make_periodic(0, 1e-9)?;
    assert!(looped.order == 0 && looped.deviation < 1e-9 && looped.spline.detect_periodic(0)?);
    Ok(())
}

fn images_in_a_plane() -> Result<()> {
    let (g, origin, up) = (circle()?, [0.0, 0.0], [0.0, 2.0]);
    assert_eq!(g.mirror(&origin, &up)?.eval(&[0.25], 0)?, [0.0, -1.0]);
    assert_eq!(g.project_to_plane(&origin, &up, Some(&[1.0, 1.0]))?.eval(&[0.25], 0)?, [-1.0, 0.0]);
    assert_eq!(g.project_from(&[0.0, -4.0], &origin, &up)?.eval(&[0.0], 0)?, [1.0, 0.0]);
    Ok(())
}

fn segments() -> Result<()> {
    let g = Spline::hermite(&[0.0, 1.0], 1, &[0.0, 2.0], &[3.0, 3.0])?;
    assert_eq!(g.eval(&[1.0], 0)?, [2.0]);
    assert_eq!(g.to_hermite()?.points, [0.0, 2.0]);
    let form = g.to_power()?;
    assert_eq!(form.coefficients, [0.0, 3.0, -3.0, 2.0]);
    assert_eq!(Spline::power(&[3], 1, &form, 0)?.eval(&[1.0], 0)?, [2.0]);
    let matrix = nurbs::basis_matrix(sys::NURBS_BASIS_BERNSTEIN, sys::NURBS_BASIS_POWER, 1)?;
    assert_eq!(matrix, [1.0, 0.0, -1.0, 1.0]);
    Ok(())
}

fn reduction() -> Result<()> {
    let g = circle()?;
    let back = g.insert_knot(0, 0.3, 2)?.remove_knot(0, 0.3, 5, 1e-12)?;
    assert_eq!((back.removed, back.spline.count(0)?), (2, 9));
    assert!(back.bound <= 1e-12 && g.deviation(&back.spline)?.1 <= 1e-12);
    assert_eq!(g.refine_uniform(0, 3)?.reduce_knots(-1, 1e-12)?.spline.count(0)?, 9);
    assert_eq!(g.elevate(0, 1)?.reduce_degree(0, 1)?.spline.count(0)?, 9);
    assert_eq!(g.elevate(0, 1)?.simplify(1e-12)?.spline.degree(0)?, 2);
    assert_eq!(g.remove_knot(0, 0.3, 1, 1.0).err().map(|e| e.status), Some(sys::NURBS_ERROR_NOT_A_KNOT));
    Ok(())
}

fn strided_arrays() -> Result<()> {
    let (t, n) = (params(), 1001);
    let expected = circle()?.eval(&t, 0)?;
    let mut columns = vec![0.0; 2 * n];
    circle()?.eval_into(&t, RecordsMut::strided(&mut columns, n, 1, n), 0)?;
    assert!((0..n).all(|i| columns[i] == expected[2 * i] && columns[n + i] == expected[2 * i + 1]));
    let same = circle()?.with_points(Records::strided(&CIRCLE, 9, 2, 1), None)?;
    assert_eq!(same.points()?, CIRCLE);
    // Where the library takes one stride, that of components counts too.
    let (spread, packed) = ([0.0, 9.0, 0.5, 9.0, 1.0], [0.0, 0.5, 1.0]);
    let apart = || Records::strided(&spread, 3, 0, 2);
    assert_eq!(circle()?.lengths(apart(), 1e-9)?, circle()?.lengths(&packed, 1e-9)?);
    assert_eq!(circle()?.curve_frames(apart(), 0)?, circle()?.curve_frames(&packed, 0)?);
    assert_eq!(nurbs::bernstein(1, 0, apart())?, nurbs::bernstein(1, 0, &packed)?);
    let mut distances = [9.0; 3];
    let out = RecordsMut::strided(&mut distances, 2, 0, 2);
    let out = nurbs::ClosestPointsMut { distances: Some(out), ..Default::default() };
    circle()?.closest_points_into(&[2.0, 0.0, 0.0, 3.0], out, Default::default())?;
    assert_eq!(distances, [1.0, 9.0, 2.0]);
    Ok(())
}

fn inspection() -> Result<()> {
    let c = circle()?.clone();
    assert_eq!((c.axes()?, c.dimension()?, c.degree(0)?, c.point_count()?), (1, 2, 2, 9));
    assert!(c.is_rational()? && c.domain(0)? == [0.0, 1.0] && c.greville(0)?[1] == 0.125);
    assert_eq!(c.knot_form(0)?, sys::NURBS_FORM_CLAMPED_START | sys::NURBS_FORM_CLAMPED_END);
    let distinct = c.distinct_knots(0)?;
    assert_eq!((distinct.knots[1], distinct.multiplicities), (0.25, vec![3, 2, 2, 2, 3]));
    assert_eq!(c.hull_size(&[0.1], 0)?, [1.0]);
    assert_eq!(c.rational_basis(&[0.0], 0)?.values, [1.0, 0.0, 0.0]);
    assert_eq!(format!("{:?}", c), "Spline { degrees: [2], counts: [9], dimension: 2, rational: true }");
    Ok(())
}

/// The same parabola from points, and from statistics that were copied, split, sent and put together again.
fn fits() -> Result<()> {
    let t: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
    let y: Vec<f64> = t.iter().map(|t| 1.0 + 2.0 * t * t).collect();
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let none = nurbs::Statistics::create(&[2], &[2], &[0.0, 1.0], 1, 4.0, 1.0)?;
    let first = none.clone().add(&nurbs::Data::new(1, 1, &t[..9], &y[..9])?)?;
    let rest = nurbs::Statistics::from_bytes(&none.add(&nurbs::Data::new(1, 1, &t[9..], &y[9..])?)?.to_bytes()?)?;
    let all = nurbs::Statistics::merge(&[&rest, &first], &[])?;
    assert_eq!((all.size()?.count, all.axes()?), (21, 1));
    let points = nurbs::fit_points(&nurbs::Data::new(1, 1, &t, &y)?, &[2], &[3], &knots, None, 0)?;
    for fitted in [all.fit(&[2], &[3], &knots, None, 0)?, points] {
        assert!(close(&fitted.spline.points()?, &[1.0, 1.0, 3.0], 8.0 * EPS) && fitted.report.data_count == 21);
    }
    let rising = nurbs::FitOptions::new()?.shapes(&[nurbs::sys::NURBS_TREND_FALLING]).lower(&[0.0]).upper(&[2.0]);
    let flat = all.fit(&[2], &[3], &knots, Some(&rising), 0)?.spline.points()?;
    assert!(flat[0] == flat[1] && flat[1] == flat[2]);
    for short in [
        nurbs::FitOptions::new()?.shapes(&[]),
        nurbs::FitOptions::new()?.lower(&[0.0, 0.0]),
        nurbs::FitOptions::new()?.conditions(1, &[0.0], &[], &[]),
        nurbs::FitOptions::new()?.conditions(1, &[0.0], &[0, 0], &[1.0]),
    ] {
        assert!(all.fit(&[2], &[3], &knots, Some(&short), 0).is_err());
    }
    let huber = nurbs::FitOptions::new()?.robust(nurbs::sys::NURBS_ROBUST_HUBER, 0.0);
    let data = nurbs::Data::new(1, 1, &t, &y)?;
    let fitted = nurbs::fit_points(&data, &[2], &[3], &knots, Some(&huber), 0)?;
    let errors = all.fit_errors(&fitted.spline, 1, 0.0, 1.0, &[0.0, 1.0], 0)?;
    assert!(fitted.report.outliers == 0 && errors.len() == 2 && errors[0] > 0.0);
    assert!(all.fit_criteria(&fitted.spline, 1, &[1.0, 2.0])?.len() == 2);
    Ok(())
}

fn constructors_agree() -> Result<()> {
    let c = circle()?;
    let (knots, weights, homogeneous) = (c.knots(0)?, c.weights()?, c.homogeneous_points()?);
    let short = Spline::create_short(&[2], &[9], &knots[1..11], 2, &CIRCLE, Some(&weights), 0)?;
    let d = c.distinct_knots(0)?;
    let pairs = [(&d.knots[..], &d.multiplicities[..])];
    let multiple = Spline::create_multiplicities(&[2], &[9], &pairs, 2, &CIRCLE, Some(&weights), 0)?;
    let projective = Spline::create_homogeneous(&[2], &[9], &knots, 2, &homogeneous, 0)?;
    for other in [short, multiple, projective] {
        assert_eq!(other.knots(0)?, knots);
        assert!(close(&other.eval(&[0.1], 0)?, &c.eval(&[0.1], 0)?, 4.0 * EPS));
    }
    Ok(())
}

fn bases() -> Result<()> {
    let knots = nurbs::knots_open_uniform(2, 4, 0.0, 1.0)?;
    let basis = nurbs::basis(2, &knots, 1, &[0.0, 0.5, 1.0], 0)?;
    assert_eq!(basis.spans, nurbs::find_spans(2, &knots, &[0.0, 0.5, 1.0], 0)?);
    let sums: Vec<f64> = basis.values.chunks(3).map(|row| row.iter().sum()).collect();
    assert_eq!(sums, [1.0, 0.0, 1.0, 0.0, 1.0, 0.0]);
    assert_eq!(nurbs::bernstein(2, 0, &[0.5])?, [0.25, 0.5, 0.25]);
    assert_eq!(nurbs::knots_uniform(1, 3, 0.0, 1.0)?, [-0.5, 0.0, 0.5, 1.0, 1.5]);
    assert_eq!(nurbs::knots_periodic(1, &[0., 1., 2.], None)?, [-1., 0., 1., 2., 3.]);
    assert_eq!(nurbs::knots_averaged(2, &[0., 1., 2., 4.])?, [0., 0., 0., 1.5, 4., 4., 4.]);
    assert_eq!(nurbs::knots_bezier_breaks(1, &[0., 2., 3.])?, [0., 0., 2., 3., 3.]);
    Ok(())
}

fn frames() -> Result<()> {
    let f = patch()?.surface_frames(&[0.0, 0.0, 0.5, 0.25], 0)?;
    assert_eq!((&f.normals[..3], &f.status[..]), (&[0.0, 0.0, 1.0][..], &[0, 0][..]));
    assert_eq!(patch()?.surface_grid_frames(&[&[0.5], &[0.25]], 0)?.normals, f.normals[3..]);
    let c = patch()?.surface_curvatures(&[0.0, 0.0], 0)?;
    assert!((c.principal[0] - 1.0).abs() <= 4.0 * EPS && (c.gaussian[0] + 1.0).abs() <= 4.0 * EPS);
    let flat = circle()?.curve_frames(&[0.0], 0)?;
    assert!(flat.normals == [-1.0, 0.0] && flat.torsions.is_empty());
    let line = Spline::bezier(&[1], 3, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], None)?;
    assert_eq!(line.curve_frames(&[0.5], 0)?.status, [sys::NURBS_FRAME_RULE]);
    let minimal = line.rotation_minimizing_frames(&[0.0, 1.0], Some(&[0.0, 0.0, 2.0]), 0)?;
    assert_eq!(minimal.normals, [0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let error = line.rotation_minimizing_frames(&[0.0], Some(&[1.0, 0.0, 0.0]), 0).unwrap_err();
    assert_eq!(error.status, sys::NURBS_ERROR_DIRECTION);
    Ok(())
}

fn errors() -> Result<()> {
    let mut t = vec![0.5; 20];
    t[17] = 1.25;
    let mut out = vec![7.0; 40];
    let error = circle()?.eval_into(&t, &mut out, 0).unwrap_err();
    println!("{}", error);
    assert_eq!((error.status, error.name()), (sys::NURBS_ERROR_OUTSIDE_DOMAIN, "NURBS_ERROR_OUTSIDE_DOMAIN"));
    assert!(error.message.contains("params[17]") && error.message.contains("1.25"));
    assert!(out.iter().all(|&x| x == 7.0), "a failing call writes nothing");
    assert_eq!(circle()?.eval(&[1.25], sys::NURBS_CLAMP)?, [1.0, 0.0]);
    let short = circle()?.eval_into(&[0.5, 0.6], &mut [0.0; 3], 0).unwrap_err();
    assert_eq!(short.status, sys::NURBS_ERROR_SIZE);
    let strided = circle()?.eval(Records::strided(&[0.5; 4], 3, 2, 0), 0);
    assert!(strided.is_err(), "the last of three parameters at distance 2 lies outside an array of 4");
    let file = List::read(b"no file of a known format", None).err().map(|e| e.status / 100);
    assert_eq!(file, Some(4));
    Ok(())
}

fn threads() -> Result<()> {
    let (shared, t) = (circle()?, params());
    let expected = shared.eval(&t, 0)?;
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| assert_eq!(shared.clone().eval(&t, 0).as_ref(), Ok(&expected)));
        }
    });
    Ok(())
}

fn main() -> Result<()> {
    known_points()?;
    grid_equals_points()?;
    single_precision_is_rounded_once()?;
    data_derivatives()?;
    insertion_keeps_the_circle()?;
    forms_and_maps()?;
    calculus_and_weights()?;
    parts_of_the_circle()?;
    circles_made_compatible()?;
    continuity_of_the_circle()?;
    beyond_the_ends()?;
    images_in_a_plane()?;
    segments()?;
    reduction()?;
    strided_arrays()?;
    inspection()?;
    fits()?;
    constructors_agree()?;
    bases()?;
    frames()?;
    errors()?;
    threads()
}
