// SPDX-License-Identifier: MIT
//! Shapes in Rust: one known value of each.

mod common;

use common::{close, status_of, QUARTERS};
use nurbs::{conic_axes, coons_gaps, sys};
use nurbs::{HelixShape, HermiteBoundaries, List, Placement, Result, Spline, Turn};
use std::f64::consts::PI;

fn same(a: &[f64], b: &[f64]) -> bool {
    close(a, b, 1e-14)
}

fn anywhere() -> Placement<'static> {
    Placement::default()
}

fn all(list: &List) -> Result<Vec<Spline>> {
    (0..list.len()).map(|i| list.get(i)).collect()
}

fn lines() -> Result<()> {
    let corners = [0., 0., 1., 0., 1., 1.];
    assert_eq!(Spline::line(&[0., 0.], &[2., 4.])?.eval(&[0.5], 0)?, [1., 2.]);
    assert_eq!(Spline::polyline(2, &corners, None)?.eval(&[1.5], 0)?, [1., 0.5]);
    assert_eq!(Spline::polyline(2, &corners, Some(&[0., 2., 3.]))?.eval(&[1.], 0)?, [0.5, 0.]);
    assert_eq!(Spline::polygon(anywhere(), 2., 4)?.eval(&[0.25], 0)?, [0., 2.]);
    assert_eq!(Spline::rounded_rectangle(anywhere(), 4., 2., 0.)?.eval(&[0.], 0)?, [-2., -1.]);
    let above = Placement::at(&[0., 0., 1.]);
    assert_eq!(Spline::rounded_rectangle(above, 4., 2., 0.5)?.eval(&[0.], 0)?, [-1.5, -1., 1.]);
    assert_eq!(status_of(Spline::line(&[0., 0.], &[1.])), sys::NURBS_ERROR_SIZE);
    Ok(())
}

fn circles() -> Result<()> {
    assert_eq!(Spline::circle(anywhere(), 1., QUARTERS)?.eval(&[0.25, 1.], 0)?, [0., 1., 1., 0.]);
    let turned = Placement { axis: &[1., 0., 0.], x: &[0., 3., 0.], ..anywhere() };
    assert_eq!(Spline::circle(turned, 1., QUARTERS)?.eval(&[0.25], 0)?, [0., 0., 1.]);
    assert_eq!(Spline::circle(anywhere(), 1., sys::NURBS_ARC_SMOOTH)?.count(0)?, 6);
    let quarter = Turn::new(0., PI / 2.);
    assert_eq!(Spline::arc(anywhere(), 1., quarter, QUARTERS)?.eval(&[1.], 0)?, [0., 1.]);
    let (a, b, c) = ([1., 0.], [0., 1.], [-1., 0.]);
    assert_eq!(Spline::arc_through(&a, &b, &c, QUARTERS)?.eval(&[1.], 0)?, c);
    assert!(same(&Spline::arc_tangent(&a, &b, &c, QUARTERS)?.eval(&[0.5], 0)?, &b));
    assert_eq!(status_of(Spline::circle(anywhere(), -1., QUARTERS)), sys::NURBS_ERROR_LENGTH);
    assert_eq!(status_of(Spline::circle(anywhere(), 1., 7)), sys::NURBS_ERROR_FORM);
    assert_eq!(status_of(Spline::arc(anywhere(), 1., Turn::new(0., 7.), QUARTERS)), sys::NURBS_ERROR_ANGLE);
    assert_eq!(status_of(Spline::arc_through(&[0.; 2], &[1.; 2], &[2.; 2], 0)), sys::NURBS_ERROR_COLLINEAR);
    Ok(())
}

fn conics() -> Result<()> {
    assert_eq!(Spline::ellipse(anywhere(), [2., 1.], Turn::FULL, QUARTERS)?.eval(&[0.25], 0)?, [0., 1.]);
    assert_eq!(Spline::parabola(anywhere(), 1., -2., 2.)?.eval(&[2.], 0)?, [1., 2.]);
    let end = Spline::hyperbola(anywhere(), [1., 2.], 0., 1.)?.eval(&[1.], 0)?;
    assert!(same(&end, &[1f64.cosh(), 2. * 1f64.sinh()]));
    let arc = Spline::conic_shoulder(&[0., 0.], &[1., 1.], &[2., 0.], &[1., -1.], 0.5)?;
    assert!(same(&arc.eval(&[0.5], 0)?, &[1., 0.5]));
    let up = [0., 1.];
    let half = Spline::conic_point(&[-1., 0.], &up, &[1., 0.], &up, &up, QUARTERS)?.eval(&[0.2], 0)?;
    assert!((half[0].hypot(half[1]) - 1.).abs() <= 1e-14);
    let five = Spline::circle(anywhere(), 1., QUARTERS)?.eval(&[0., 0.1, 0.2, 0.3, 0.4], 0)?;
    let point = Spline::conic_through(2, &five, QUARTERS)?.eval(&[0.3], 0)?;
    assert!((point[0].hypot(point[1]) - 1.).abs() <= 1e-12);
    let half_turn = Turn::new(-PI / 2., PI);
    let arc = Spline::conic_focus(&[0., 0.], &[], &[1., 0.], 1., half_turn, QUARTERS)?;
    assert!(same(&arc.eval(&[0.5], 0)?, &[0.5, 0.]));
    let equation = [1., 0., 4., 0., 0., -4.];
    let axes = conic_axes(&equation)?;
    assert!(axes.kind == sys::NURBS_CONIC_ELLIPSE && same(&axes.sizes, &[2., 1.]));
    let top = Spline::conic_implicit(&equation, 0., 2. * PI, QUARTERS)?.eval(&[0.25], 0)?;
    assert!((top[1].abs() - 1.).abs() <= 1e-14);
    assert_eq!(status_of(conic_axes(&[1., 0., 1., 0., 0., 1.])), sys::NURBS_ERROR_CONIC);
    Ok(())
}

fn shape_factors() -> Result<()> {
    let (a, b, c) = ([0., 0.], [1., 1.], [2., 0.]);
    assert_eq!(Spline::conic_triangle(&a, &b, &c, 1.)?.eval(&[0.5], 0)?, [1., 0.5]);
    assert_eq!(Spline::conic_triangle(&a, &b, &c, f64::INFINITY)?.eval(&[0.5], 0)?, [1., 1.]);
    assert_eq!(Spline::conic_triangle(&a, &b, &c, 4.)?.shape_factor()?, (4., sys::NURBS_CONIC_HYPERBOLA));
    Ok(())
}

fn helices() -> Result<()> {
    let shape = HelixShape { pitch: 2., turns: 3., ..HelixShape::default() };
    let (helix, error) = Spline::helix(Placement::at(&[0., 0., 1.]), shape, 1e-6)?;
    assert!(same(&helix.eval(&[0., 3.], 0)?, &[1., 0., 1., 1., 0., 7.]) && error <= 1e-6);
    Ok(())
}

fn from_curves() -> Result<()> {
    let (a, b) = (Spline::line(&[0.; 3], &[1., 0., 0.])?, Spline::line(&[0., 1., 0.], &[1., 1., 2.])?);
    let middle = [0.5, 0.5];
    assert_eq!(a.extrude(&[0., 2., 0.])?.eval(&middle, 0)?, [0.5, 1., 0.]);
    let upright = Spline::line(&[1., 0., 0.], &[1., 0., 1.])?;
    assert_eq!(upright.revolve(&[], &[], 2. * PI, QUARTERS)?.eval(&[0.25, 0.5], 0)?, [0., 1., 0.5]);
    let around = upright.revolve(&[2., 0., 0.], &[0., 0., 2.], PI, QUARTERS)?;
    assert!(same(&around.eval(&[1., 0.5], 0)?, &[3., 0., 0.5]));
    for flags in [0, sys::NURBS_RULED_CARTESIAN] {
        assert_eq!(a.ruled(&b, flags)?.eval(&middle, 0)?, [0.5; 3]);
    }
    assert_eq!(a.tensor_sum(2., &b, 3.)?.eval(&middle, 0)?, [2.5, 3., 3.]);
    let (factor, other) = (Spline::line(&[1.], &[3.])?, Spline::line(&[1., 2.], &[1., 4.])?);
    assert_eq!(factor.tensor_product(&other)?.eval(&middle, 0)?, [2., 6.]);
    let (ring, profile) = (Spline::circle(anywhere(), 1., QUARTERS)?, Spline::line(&[1., 0.], &[2., 1.])?);
    assert_eq!(Spline::swung(&ring, &profile, 2.)?.eval(&[0.25, 0.5], 0)?, [0., 3., 0.5]);
    Ok(())
}

fn patches() -> Result<()> {
    let plane = Spline::plane(&[1.; 3], &[2., 0., 0.], &[0., 1., 0.])?;
    assert_eq!(plane.eval(&[0.5, 0.5], 0)?, [2., 1.5, 1.]);
    assert_eq!(Spline::bilinear(1, &[0., 1., 2., 5.])?.eval(&[0.5, 0.5], 0)?, [2.]);
    let corners = [0., 1., 2., 3., 4., 5., 6., 7.];
    assert_eq!(Spline::trilinear(1, &corners)?.eval(&[0.5; 3], 0)?, [3.5]);
    assert_eq!(status_of(Spline::bilinear(3, &corners)), sys::NURBS_ERROR_SIZE);
    Ok(())
}

fn spheres() -> Result<()> {
    let (beside, at) = (Placement::at(&[1., 0., 0.]), [0.25, 0.5]);
    assert!(same(&Spline::sphere(beside, 2., QUARTERS)?.eval(&at, 0)?, &[1., 2., 0.]));
    let patch = Spline::spherical_patch(anywhere(), 1., Turn::new(0., PI / 2.), 0., PI / 2., QUARTERS)?;
    assert!(same(&patch.eval(&[1., 0.], 0)?, &[0., 1., 0.]));
    assert_eq!(Spline::sphere_patches(anywhere(), 1., 0)?.name(4)?, "+Z");
    assert_eq!(Spline::sphere_patches(anywhere(), 1., sys::NURBS_HEMISPHERE)?.len(), 5);
    assert!(same(&Spline::ellipsoid(anywhere(), [1., 2., 3.], QUARTERS)?.eval(&at, 0)?, &[0., 2., 0.]));
    assert_eq!(status_of(Spline::sphere(Placement::at(&[0., 0.]), 1., QUARTERS)), sys::NURBS_ERROR_SIZE);
    Ok(())
}

fn quadrics() -> Result<()> {
    let (at, full) = ([0.25, 0.5], Turn::FULL);
    assert!(same(&Spline::cylinder(anywhere(), 2., 3., full, QUARTERS)?.eval(&at, 0)?, &[0., 2., 1.5]));
    assert!(same(&Spline::cone(anywhere(), [1., 0.], 2., full, QUARTERS)?.eval(&at, 0)?, &[0., 0.5, 1.]));
    let torus = Spline::torus(anywhere(), [2., 0.5], full, full, QUARTERS)?;
    assert!(same(&torus.eval(&at, 0)?, &[0., 1.5, 0.]));
    let bowl = Spline::paraboloid(anywhere(), [1., 1.], 1., full, QUARTERS)?;
    assert!(same(&bowl.eval(&at, 0)?, &[0., 0.5, 0.25]));
    assert!(same(&Spline::saddle(anywhere(), [1., 1.], 1.)?.eval(&[1., 0.5], 0)?, &[1., 0., 1.]));
    for (heights, flags, value) in [([-1., 1.], 0, 1.), ([1., 2.], sys::NURBS_TWO_SHEETS, -1.)] {
        let surface = Spline::hyperboloid(anywhere(), [1.; 3], heights, full, QUARTERS, flags)?;
        let p = surface.eval(&[0.3, 0.7], 0)?;
        assert!(same(&[p[0] * p[0] + p[1] * p[1] - p[2] * p[2]], &[value]));
    }
    Ok(())
}

fn coons_surfaces() -> Result<()> {
    // z = u v over the unit square
    let patch = Spline::bilinear(3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.])?;
    let (at, expected) = ([0.25, 0.5], [0.25, 0.5, 0.125]);
    let around = all(&patch.boundaries()?)?;
    let curves = [&around[0], &around[1], &around[2], &around[3]];
    let (u, v) = (patch.derivative(0, 1)?, patch.derivative(1, 1)?);
    let across = [u.iso(0, 0., 0)?, u.iso(0, 1., 0)?, v.iso(1, 0., 0)?, v.iso(1, 1., 0)?];
    let cross = Some([&across[0], &across[1], &across[2], &across[3]]);
    assert_eq!(patch.boundaries()?.name(3)?, "1+");
    assert_eq!(Spline::coons(curves, 0.)?.eval(&at, 0)?, expected);
    let plain = HermiteBoundaries { curves, cross: None, twist: sys::NURBS_TWIST_BILINEAR, twists: None };
    let twists = [0., 0., 1., 0., 0., 1., 0., 0., 1., 0., 0., 1.];
    let given = HermiteBoundaries { twist: sys::NURBS_TWIST_GIVEN, twists: Some(&twists), ..plain };
    let full = HermiteBoundaries { cross, twist: sys::NURBS_TWIST_COMPATIBLE, ..plain };
    for boundaries in [plain, given, full] {
        let (made, bound) = Spline::coons_hermite(boundaries, 0.)?;
        assert!(same(&made.eval(&at, 0)?, &expected) && bound == 0.);
    }
    let (odd, high) = (Spline::line(&[2., 0., 0.], &[2., 0., 1.])?, Spline::line(&[0., 1., 3.], &[1.; 3])?);
    let cross = Some([&odd, &across[1], &across[2], &across[3]]);
    assert_eq!(coons_gaps(curves, cross)?.tangents[0], [1., 0.]);
    assert_eq!(
        status_of(Spline::coons_hermite(HermiteBoundaries { cross, ..full }, 0.)),
        sys::NURBS_ERROR_TANGENT
    );
    let curves = [&around[0], &around[1], &around[2], &high];
    assert_eq!(coons_gaps(curves, None)?.positions, [0., 3., 0., 0.]);
    assert_eq!(status_of(Spline::coons(curves, 1.)), sys::NURBS_ERROR_GAP);
    Ok(())
}

fn coons_volumes() -> Result<()> {
    let corners: Vec<f64> = (0..24).map(|i| f64::from(i / 3 >> (2 - i % 3) & 1)).collect();
    let faces = all(&Spline::trilinear(3, &corners)?.boundaries()?)?;
    let six = [&faces[0], &faces[1], &faces[2], &faces[3], &faces[4], &faces[5]];
    assert_eq!(Spline::coons_volume(six, 0.)?.eval(&[0.25, 0.5, 0.75], 0)?, [0.25, 0.5, 0.75]);
    Ok(())
}

fn recognition() -> Result<()> {
    let found = Spline::circle(Placement::at(&[1., 1.]), 2., QUARTERS)?.recognize(1e-9)?;
    assert!(found.shape == sys::NURBS_SHAPE_CIRCLE && found.axis == [0., 0., 1.] && found.deviation <= 1e-9);
    assert!(same(&found.origin, &[1., 1., 0.]) && same(&found.sizes, &[2., 0., 0.]));
    let curve = Spline::bezier(&[3], 2, &[0., 0., 1., 2., 2., -2., 3., 0.], None)?;
    assert_eq!(curve.recognize(1e-3)?.shape, sys::NURBS_SHAPE_NONE);
    Ok(())
}

fn main() -> Result<()> {
    lines()?;
    circles()?;
    conics()?;
    shape_factors()?;
    helices()?;
    from_curves()?;
    patches()?;
    spheres()?;
    quadrics()?;
    coons_surfaces()?;
    coons_volumes()?;
    recognition()
}
