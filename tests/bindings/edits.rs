// SPDX-License-Identifier: MIT
//! Changes of weights and points, constraints and deformations in Rust: one known value of each.

mod common;

use common::{close, near, status_of};
use nurbs::{sys, weight_cross_ratio, Bend, ConstrainOptions, Constraints, Result, Spline};

/// A parabola with its top (1, 1) in the middle, where R = (1/4, 1/2, 1/4).
fn arch() -> Result<Spline> {
    Spline::bezier(&[2], 2, &[0., 0., 1., 2., 2., 0.], None)
}

fn weight_edits() -> Result<()> {
    let (one, weight) = arch()?.pull_weight(1, &[0.5], 0.5)?;
    assert!(near(&[weight], &[3.]) && near(&one.eval(&[0.5], 0)?, &[1., 1.5]));
    let (two, factor) = arch()?.pull_weights(&[0, 2], &[0.5], 0.5)?;
    assert!(near(&[factor], &[3.]) && near(&two.eval(&[0.5], 0)?, &[1., 0.5]));
    let heavy = arch()?.set_weights(&[1, 2], &[3., 1.])?;
    assert!(near(&heavy.weights()?, &[1., 3., 1.]) && near(&heavy.eval(&[0.5], 0)?, &[1., 1.5]));
    let at = heavy.weight_points(1, &[0.5])?;
    assert!(near(&at.at_zero, &[1., 0.]) && near(&at.at_one, &[1., 1.]) && near(&at.at_weight, &[1., 1.5]));
    assert!(near(&[weight_cross_ratio(&[1., 2.], &at.at_zero, &at.at_one, &at.at_weight)?], &[3.]));
    assert!(near(&[arch()?.weight_through(1, &[0.5], &[1., 1.5], 1e-9)?.1], &[3.]));
    assert_eq!(status_of(arch()?.pull_weight(1, &[0.], 0.5)), sys::NURBS_ERROR_INFLUENCE);
    assert_eq!(status_of(arch()?.pull_weight(1, &[0.5], -1.)), sys::NURBS_ERROR_WEIGHT_SIGN);
    assert_eq!(status_of(arch()?.pull_weight(1, &[0.5; 2], 1.)), sys::NURBS_ERROR_SIZE);
    assert_eq!(status_of(arch()?.set_weights(&[1], &[1., 2.])), sys::NURBS_ERROR_SIZE);
    assert_eq!(status_of(weight_cross_ratio(&[0.], &[0.], &[1.], &[2.])), sys::NURBS_ERROR_COLLINEAR);
    Ok(())
}

fn point_edits() -> Result<()> {
    let (pulled, moved) = arch()?.pull_point(1, &[0.5], &[0., 2.], 0.5)?;
    assert!(near(&[moved], &[1.]) && near(&pulled.points()?, &[0., 0., 1., 3., 2., 0.]));
    let most = arch()?.most_influential(&[0.5, 0.])?;
    assert!(most[0].index == 1 && most[1].index == 0);
    assert!(near(&[most[0].influence, most[1].influence], &[0.5, 1.]));
    let leg = arch()?.insert_on_leg(0, 0, 0.5)?;
    assert!(near(&[leg.knot], &[0.5]) && near(&leg.spline.points()?, &[0., 0., 0.5, 1., 1.5, 1., 2., 0.]));
    let found = arch()?.reparametrize(0, 0., 2.)?.insert_at_point(0, &[1.25, 1.5], 1e-9)?;
    assert!(found.index == 1 && near(&[found.ratio, found.knot], &[0.25, 0.5]));
    assert!(near(&found.spline.points()?, &[0., 0., 0.25, 0.5, 1.25, 1.5, 2., 0.]));
    assert_eq!(status_of(arch()?.insert_at_point(0, &[5.; 2], 0.1)), sys::NURBS_ERROR_OFF_POLYGON);
    Ok(())
}

fn constraints() -> Result<()> {
    let free = ConstrainOptions::default();
    let top = Constraints { params: &[0.5], targets: &[1., 2.], ..Constraints::default() };
    let made = arch()?.constrain(top, free)?;
    assert!(near(&made.spline.points()?, &[0., 2. / 3., 1., 10. / 3., 2., 2. / 3.]));
    assert!(near(&[made.moved, made.residuals[0]], &[4. / 3., 0.]) && made.optimality <= 1e-9);
    let (infinity, held) = (f64::INFINITY, [0., 0., 1., 4., 2., 0.]);
    let kept = arch()?.constrain(top, ConstrainOptions { keep: &[0, 0], ..free })?;
    assert!(near(&kept.spline.points()?, &held));
    let costs = [infinity, 1., infinity];
    let costly = arch()?.constrain(top, ConstrainOptions { costs: &costs, ..free })?;
    assert!(near(&costly.spline.points()?, &held));
    let kinds = [sys::NURBS_CONSTRAIN_VALUE, sys::NURBS_CONSTRAIN_DIRECTION];
    let turn = Constraints { params: &[0.5; 2], targets: &[1.; 4], kinds: &kinds, orders: &[0, 1] };
    let at = arch()?.constrain(turn, free)?.spline.eval_derivs(1, &[0.5], 0)?;
    assert!(near(&[at[0], at[1], at[2] - at[3]], &[1., 1., 0.]));
    let through = Constraints { targets: &[1., 1.5], ..top };
    let only = ConstrainOptions { costs: &[infinity; 3], weight_costs: &costs, tolerance: 1e-9, ..free };
    assert!(close(&arch()?.constrain(through, only)?.spline.weights()?, &[1., 3., 1.], 1e-7));
    let both = Constraints { params: &[0.5; 2], targets: &[1., 1., 1., 2.], ..top };
    assert_eq!(status_of(arch()?.constrain(both, free)), sys::NURBS_ERROR_CONTRADICTION);
    let odd = Constraints { kinds: &[7], ..top };
    assert_eq!(status_of(arch()?.constrain(odd, free)), sys::NURBS_ERROR_CONSTRAINT);
    let short = Constraints { targets: &[1.], ..top };
    assert_eq!(status_of(arch()?.constrain(short, free)), sys::NURBS_ERROR_SIZE);
    Ok(())
}

fn regions() -> Result<()> {
    let up = [0., 1.];
    let warped = arch()?.warp(&up, 0.5, 1, &[])?.eval(&[0., 0.5, 1.], 0)?;
    assert!(near(&warped, &[0., 0., 1., 1.5, 2., 0.]));
    let (before, at) = (arch()?.eval(&[0.25, 0.75], 0)?, [0.25, 0.75]);
    let after = arch()?.warp(&up, 0.5, 0, &[0.5, 1.])?.eval(&at, 0)?;
    assert!(near(&after, &[before[0], before[1], before[2], before[3] + 0.5]));
    assert_eq!(status_of(arch()?.warp(&[0.; 2], 1., 1, &[])), sys::NURBS_ERROR_DIRECTION);
    let (flat, moved) = arch()?.flatten(&up, &up, &[], &[])?;
    assert!(near(&flat.points()?, &[0., 1., 1., 1., 2., 1.]) && near(&[moved], &[1.]));
    let (slanted, _) = arch()?.flatten(&up, &up, &[1., 1.], &[])?;
    assert!(near(&slanted.points()?, &[1., 1., 0., 1., 3., 1.]));
    Ok(())
}

fn deformations() -> Result<()> {
    let bar = Spline::line(&[0., 0.], &[1., 0.])?;
    let (lower, upper) = (f64::NEG_INFINITY, f64::INFINITY);
    let how = Bend { origin: &[0.; 2], along: &[1., 0.], across: &[0., 1.], curvature: 1., lower, upper };
    let bent = bar.bend(how, 1e-6)?;
    assert!(close(&bent.spline.eval(&[1.], 0)?, &[1f64.sin(), 1f64.cos() - 1.], 1e-6));
    assert!(bent.deviation <= 1e-6);
    let doubled = Spline::bilinear(2, &[0., 0., 0., 2., 2., 0., 2., 2.])?;
    let (from, to) = ([0.; 2], [1.; 2]);
    let mapped = Spline::line(&from, &to)?.free_form_deform(&doubled, &from, &to, 1e-9)?;
    assert!(close(&mapped.spline.eval(&[0.5], 0)?, &[1.; 2], 1e-9));
    let wave = Spline::bezier(&[3], 2, &[0., 0., 1., 1., 2., -1., 3., 0.], None)?;
    let smooth = wave.fair(2, 10., &[])?;
    assert!(close(&smooth.spline.eval(&[0., 0.5, 1.], 0)?, &[0., 0., 1.5, 0., 3., 0.], 1e-9));
    assert!(smooth.energies[1] < 1e-9 && smooth.energies[0] > 1e-9 && smooth.bound <= 10.);
    assert!(close(&wave.fair(2, 10., &[1, 1])?.spline.points()?, &wave.points()?, 1e-9));
    assert_eq!(status_of(wave.fair(2, -1., &[])), sys::NURBS_ERROR_TOLERANCE);
    let other = Spline::line(&[2., 2.], &[3., 3.])?;
    let snapped = bar.snap_boundary((0, sys::NURBS_END), (&other, 0, sys::NURBS_START), 0, 0)?;
    assert!(near(&snapped.spline.eval(&[0., 1.], 0)?, &[0., 0., 2., 2.]) && snapped.bound >= 5f64.sqrt());
    Ok(())
}

fn main() -> Result<()> {
    weight_edits()?;
    point_edits()?;
    constraints()?;
    regions()?;
    deformations()
}
