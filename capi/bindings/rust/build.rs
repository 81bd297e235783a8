// SPDX-License-Identifier: MIT
//! Finds libnurbs: the folder in NURBS_LIBRARY_DIR, else what pkg-config says, else the linker's own folders.

use std::env;
use std::process::Command;

fn pkg_config() -> Option<String> {
    let mut command = Command::new("pkg-config");
    let output = command.args(["--libs-only-L", "nurbs"]).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    text.split_whitespace().find_map(|word| word.strip_prefix("-L")).map(String::from)
}

fn main() {
    println!("cargo:rerun-if-env-changed=NURBS_LIBRARY_DIR");
    if let Some(folder) = env::var("NURBS_LIBRARY_DIR").ok().or_else(pkg_config) {
        println!("cargo:rustc-link-search=native={}", folder);
    }
}
