// SPDX-License-Identifier: MIT
//! How long a call lets its callback wait, and how soon it returns when it is cancelled: see cancel.hpp.

use nurbs::{sys, Call, Result};
use std::cell::Cell;
use std::time::Instant;

pub fn measure(name: &str, mut call: impl FnMut(&mut Call) -> Result<()>) {
    let zero = Instant::now();
    let now = || zero.elapsed().as_secs_f64() * 1e3;
    let (gap, back) = (Cell::new(0.0f64), Cell::new(0.0f64));
    let mut run = |moment: f64| {
        let start = now();
        let (last, stopped) = (Cell::new(start), Cell::new(0.0));
        let mut watch = Call::new().progress(|_| {
            let time = now();
            gap.set(gap.get().max(time - last.get()));
            last.set(time);
            if time - start >= moment && stopped.get() == 0.0 {
                stopped.set(time);
            }
            stopped.get() == 0.0
        });
        let result = call(&mut watch);
        let end = now();
        if stopped.get() > 0.0 {
            back.set(back.get().max(end - stopped.get()));
            assert!(result.is_err_and(|error| error.status == sys::NURBS_ERROR_CANCELLED), "{name}");
        }
        gap.set(gap.get().max(end - last.get()));
        end - start
    };
    let whole = run(f64::INFINITY);
    for i in 1..=5 {
        run(whole * (0.618_033_988_749_894_9 * f64::from(i)).fract() * 0.95);
    }
    println!("{name} {whole:.1} {:.1} {:.1}", gap.get(), back.get());
}
