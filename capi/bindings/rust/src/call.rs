// SPDX-License-Identifier: MIT
//! Calls that can be watched, limited and ended.

use crate::sys;
use std::any::Any;
use std::cell::Cell;
use std::fmt;
use std::mem::size_of;
use std::os::raw::c_void;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr::{null, null_mut};

type Progress<'a> = Box<dyn FnMut(f64) -> bool + 'a>;

/// What a caller wants of a long call: the last argument of the methods that end with `_with`.
///
/// ```
/// # fn main() -> nurbs::Result<()> {
/// let arc = nurbs::Spline::bezier(&[2], 2, &[1.0, 0.0, 1.0, 1.0, 0.0, 1.0], None)?;
/// let mut seen = 0.0;
/// let mut call = nurbs::Call::new().work(1_000_000_000).progress(|done| {
///     seen = done;
///     true // go on
/// });
/// let length = arc.length_with(1e-9, &[], &mut call)?;
/// assert_eq!(length, arc.length(1e-9, &[])?);
/// # Ok(()) }
/// ```
pub struct Call<'a> {
    options: sys::nurbs_call_options,
    progress: Option<Progress<'a>>,
}

impl<'a> Call<'a> {
    /// Without a limit, and without a callback.
    pub fn new() -> Call<'a> {
        let size = size_of::<sys::nurbs_call_options>() as i64;
        let mut options =
            sys::nurbs_call_options { struct_size: size, work: 0, progress: None, user: null_mut() };
        // Of a struct of the header's size nothing can be wrong.
        unsafe { sys::nurbs_call_options_init(&mut options, size) };
        Call { options, progress: None }
    }
    /// Most multiply-adds; 0 sets no limit. At the limit searches answer with what is proven so far; other calls fail
    /// with `NURBS_ERROR_WORK`.
    pub fn work(mut self, most: i64) -> Call<'a> {
        self.options.work = most;
        self
    }
    /// Called at most every 10 ms with an estimate from 0 to 1 of how much is done. Returns whether the call is to go on;
    /// else it fails with `NURBS_ERROR_CANCELLED`. A panic ends the call, and goes on after it.
    pub fn progress(mut self, progress: impl FnMut(f64) -> bool + 'a) -> Call<'a> {
        self.progress = Some(Box::new(progress));
        self
    }

    /// For one call, which begins without a panic; the address of the callback is that of `self`.
    pub(crate) fn options(&mut self) -> *const sys::nurbs_call_options {
        drop(keep(None));
        if let Some(progress) = &mut self.progress {
            self.options.progress = Some(tell);
            self.options.user = (progress as *mut Progress<'a>).cast::<c_void>();
        }
        &self.options
    }
}

impl Default for Call<'_> {
    fn default() -> Self {
        Call::new()
    }
}

impl fmt::Debug for Call<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Call").field("work", &self.options.work).finish_non_exhaustive()
    }
}

type Panic = Box<dyn Any + Send>;

thread_local! {
    /// The panic of a callback, until its call has ended.
    static KEPT: Cell<Option<Panic>> = const { Cell::new(None) };
}

/// Keeps a panic, or none, and returns what was kept. A thread that ends, and has no place for it any more, keeps
/// nothing: its call is only cancelled.
fn keep(panic: Option<Panic>) -> Option<Panic> {
    KEPT.try_with(|kept| kept.replace(panic)).ok().flatten()
}

/// The callback as C sees it, through which no panic goes.
unsafe extern "C" fn tell(done: f64, user: *mut c_void) -> i32 {
    let progress = &mut *user.cast::<Progress<'_>>();
    match catch_unwind(AssertUnwindSafe(|| progress(done))) {
        Ok(more) => i32::from(!more),
        Err(panic) => {
            keep(Some(panic));
            1
        }
    }
}

/// Goes on with the panic that ended a call.
pub(crate) fn resume() {
    if let Some(panic) = keep(None) {
        resume_unwind(panic);
    }
}

// The long calls that take structs, with the arguments of their plain forms.

/// Of no points, and with the defaults.
const QUERY: sys::nurbs_closest_query = sys::nurbs_closest_query {
    struct_size: size_of::<sys::nurbs_closest_query>() as i64,
    n: 0,
    points: null(),
    point_stride: 0,
    point_component_stride: 0,
    guesses: null(),
    guess_stride: 0,
    guess_component_stride: 0,
    range: null(),
    tolerance: 0.0,
    budget: 0,
    flags: 0,
    reserved: 0,
};

/// Of which nothing is wanted.
const ANSWER: sys::nurbs_closest_answer = sys::nurbs_closest_answer {
    struct_size: size_of::<sys::nurbs_closest_answer>() as i64,
    params: null_mut(),
    param_stride: 0,
    param_component_stride: 0,
    feet: null_mut(),
    foot_stride: 0,
    foot_component_stride: 0,
    distances: null_mut(),
    distance_stride: 0,
    status: null_mut(),
};

/// A function that answers all, with the fields of the query that only some of them have.
macro_rules! closest_with {
    (sys::$name:ident, $($field:ident: $kind:ty),*) => {
        #[allow(clippy::too_many_arguments)]
        pub(crate) unsafe fn $name(
            g: *const sys::nurbs,
            n: i64,
            points: *const f64,
            point_stride: i64,
            point_component_stride: i64,
            $($field: $kind,)*
            params: *mut f64,
            param_stride: i64,
            param_component_stride: i64,
            feet: *mut f64,
            foot_stride: i64,
            foot_component_stride: i64,
            distances: *mut f64,
            distance_stride: i64,
            status: *mut i32,
            flags: u32,
            call: *const sys::nurbs_call_options,
        ) -> i32 {
            let query = sys::nurbs_closest_query {
                n,
                points,
                point_stride,
                point_component_stride,
                flags,
                $($field,)*
                ..QUERY
            };
            let answer = sys::nurbs_closest_answer {
                params,
                param_stride,
                param_component_stride,
                feet,
                foot_stride,
                foot_component_stride,
                distances,
                distance_stride,
                status,
                ..ANSWER
            };
            sys::$name(g, &query, &answer, call)
        }
    };
}
closest_with!(sys::nurbs_closest_points_with, range: *const f64, tolerance: f64, budget: i64);
closest_with!(sys::nurbs_farthest_points_with, range: *const f64, tolerance: f64, budget: i64);
closest_with!(sys::nurbs_closest_local_with, guesses: *const f64, guess_stride: i64, guess_component_stride: i64);

#[allow(clippy::too_many_arguments)]
pub(crate) unsafe fn nurbs_curve_signed_distances_with(
    g: *const sys::nurbs,
    n: i64,
    points: *const f64,
    point_stride: i64,
    point_component_stride: i64,
    tolerance: f64,
    budget: i64,
    distances: *mut f64,
    distance_stride: i64,
    params: *mut f64,
    param_stride: i64,
    status: *mut i32,
    flags: u32,
    call: *const sys::nurbs_call_options,
) -> i32 {
    let query = sys::nurbs_closest_query {
        n,
        points,
        point_stride,
        point_component_stride,
        tolerance,
        budget,
        flags,
        ..QUERY
    };
    let answer =
        sys::nurbs_closest_answer { params, param_stride, distances, distance_stride, status, ..ANSWER };
    sys::nurbs_curve_signed_distances_with(g, &query, &answer, call)
}

#[allow(clippy::too_many_arguments)]
pub(crate) unsafe fn nurbs_constrain_with(
    g: *const sys::nurbs,
    count: i64,
    kinds: *const i32,
    orders: *const i32,
    params: *const f64,
    targets: *const f64,
    keep: *const i32,
    costs: *const f64,
    weight_costs: *const f64,
    tolerance: f64,
    residuals: *mut f64,
    rank: *mut i64,
    moved: *mut f64,
    optimality: *mut f64,
    call: *const sys::nurbs_call_options,
    out: *mut *mut sys::nurbs,
) -> i32 {
    let constraints = sys::nurbs_constraints {
        struct_size: size_of::<sys::nurbs_constraints>() as i64,
        count,
        kinds,
        orders,
        params,
        targets,
        keep,
        costs,
        weight_costs,
        tolerance,
    };
    let mut report = sys::nurbs_constraint_report {
        struct_size: size_of::<sys::nurbs_constraint_report>() as i64,
        residuals,
        rank: 0,
        moved: 0.0,
        optimality: 0.0,
    };
    let status = sys::nurbs_constrain_with(g, &constraints, &mut report, call, out);
    if status == sys::NURBS_OK {
        *rank = report.rank;
        *moved = report.moved;
        *optimality = report.optimality;
    }
    status
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Result, Spline};

    /// A call whose library does not heed that the callback ended it.
    fn unheeded(call: &mut Call) {
        let options = unsafe { &*call.options() };
        assert_eq!(unsafe { options.progress.unwrap()(0.5, options.user) }, 1);
    }

    #[test]
    fn no_call_ends_with_the_panic_of_an_earlier_one() -> Result<()> {
        let segment = Spline::bezier(&[1], 1, &[0.0, 1.0], None)?;
        unheeded(&mut Call::new().progress(|_| panic!("of an earlier call")));
        segment.length_with(1e-9, &[], &mut Call::new())?; // too short to be called back
        assert!(crate::error::check(sys::NURBS_ERROR_CANCELLED).is_err());
        Ok(())
    }
}
