// SPDX-License-Identifier: MIT
//! Files in Rust: parts.igs, the path of which is the argument, read by name and from memory.

mod common;

use common::{near, status_of};
use nurbs::{bytes_kind, sys, List, ReadOptions, Result, Spline};
use std::path::Path;

fn holds_the_edge(list: &List, scale: f64) -> Result<()> {
    assert_eq!((list.len(), list.is_empty(), list.name(0)?), (1, false, "EDGE(7)".to_string()));
    assert_eq!(list.get(0)?.eval(&[0.0, 1.0], 0)?, [0.0, 0.0, 0.0, scale, 2.0 * scale, 3.0 * scale]);
    assert!(near(&[list.unit()?], &[0.001 / scale]));
    assert_eq!(list.note_count()?, 1);
    let note = list.note(0)?;
    assert_eq!((note.entity_type, note.line, note.reason), (116, 3, sys::NURBS_ERROR_UNSUPPORTED));
    assert!(!note.text.is_empty());
    assert_eq!(status_of(list.get(1)), sys::NURBS_ERROR_INDEX);
    assert_eq!(format!("{:?}", list), "[\"EDGE(7)\"]");
    Ok(())
}

fn read(path: &Path) -> Result<()> {
    holds_the_edge(&List::read_file(path, None)?, 1.0)?;
    let metres = ReadOptions::new()?.unit(1.0).max_bytes(10_000);
    let bytes = std::fs::read(path).expect("the file is there");
    holds_the_edge(&List::read(&bytes, Some(&metres))?, 0.001)?;
    assert_eq!(status_of(List::read(&bytes, Some(&metres.max_bytes(10)))), sys::NURBS_ERROR_TOO_LARGE);
    Ok(())
}

fn errors() {
    assert_eq!(status_of(List::read(b"no file of a known format", None)), sys::NURBS_ERROR_FORMAT);
    assert_eq!(status_of(List::read_file("/no/such/file", None)), sys::NURBS_ERROR_FILE);
}

fn square() -> Result<Spline> {
    let points = [1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0];
    Spline::create_periodic(&[2], &[4], &[2.0, 3.0, 4.0, 5.0, 6.0], 2, &points, None, sys::NURBS_PERIODIC)
}

/// Each control point once, and what is read back.
fn unwrapped() -> Result<()> {
    let square = square()?;
    assert_eq!((square.count(0)?, square.unwrapped_count(0)?), (6, 4));
    assert_eq!(square.unwrapped_knots(0)?, [2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(square.short_knots(0)?, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    let found = square.unwrapped_points()?;
    assert_eq!(found.points, [1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0]);
    assert_eq!(found.weights, [1.0; 4]);
    Ok(())
}

fn bytes() -> Result<()> {
    let square = square()?;
    let mut bytes = square.to_bytes()?;
    let kind = bytes_kind(&bytes)?;
    assert_eq!((kind.kind, kind.major), (sys::NURBS_BYTES_SPLINE, 1));
    assert_eq!(Spline::from_bytes(&bytes)?, square);
    assert_eq!(status_of(List::from_bytes(&bytes)), sys::NURBS_ERROR_FORMAT);
    bytes[100] ^= 1;
    assert_eq!(status_of(Spline::from_bytes(&bytes)), sys::NURBS_ERROR_CHECKSUM);
    Ok(())
}

fn lists() -> Result<()> {
    let square = square()?;
    let list = List::create(&[&square, &square], &["a", "square"], 0.001)?;
    assert_eq!((list.len(), list.name(1)?, list.unit()?), (2, "square".to_string(), 0.001));
    assert_eq!(List::create(&[&square], &[], 0.0)?.name(0)?, "0");
    let again = List::from_bytes(&list.to_bytes()?)?;
    assert_eq!((again.to_bytes()?, again.name(0)?), (list.to_bytes()?, "a".to_string()));
    assert_eq!(again.get(1)?, square);
    assert_eq!(status_of(List::create(&[&square], &["a", "b"], 0.0)), sys::NURBS_ERROR_SIZE);
    assert_eq!(status_of(List::create(&[&square], &["a\0"], 0.0)), sys::NURBS_ERROR_SYNTAX);
    assert_eq!(status_of(List::create(&[&square], &[], -1.0)), sys::NURBS_ERROR_FACTOR);
    Ok(())
}

fn main() -> Result<()> {
    assert_eq!(nurbs::version() / 10000, sys::NURBS_VERSION_MAJOR);
    read(Path::new(&std::env::args_os().nth(1).expect("the path of parts.igs")))?;
    errors();
    unwrapped()?;
    bytes()?;
    lists()?;
    Ok(())
}
