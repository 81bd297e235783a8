// SPDX-License-Identifier: MIT
//! Files in Rust: parts.igs, the path of which is the argument, read by name and from memory.

mod common;

use common::{near, status_of};
use nurbs::{sys, List, ReadOptions, Result};
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

fn main() -> Result<()> {
    assert_eq!(nurbs::version() / 10000, sys::NURBS_VERSION_MAJOR);
    read(Path::new(&std::env::args_os().nth(1).expect("the path of parts.igs")))?;
    errors();
    Ok(())
}
