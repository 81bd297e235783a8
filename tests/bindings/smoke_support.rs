// SPDX-License-Identifier: MIT
//! How the smoke test of Rust prints what calls return: see smoke_reference.cpp.

use nurbs::{Face, List, Meet, Mesh, Model, Spline, Statistics};
use std::cell::RefCell;

thread_local!(static CALL: RefCell<&'static str> = const { RefCell::new("") });

pub fn begin(name: &'static str) {
    CALL.with(|call| *call.borrow_mut() = name);
    println!("{name}|done|");
}

pub fn by_hand(name: &str) {
    println!("{name}|by hand|");
}

pub fn written(path: &'static str, text: &str) -> &'static str {
    std::fs::write(path, text).expect(path);
    path
}

/// What is one element, or many.
pub trait Elements {
    fn text(&self) -> String;
}

macro_rules! integers {
    ($($kind:ty),*) => {$(
        impl Elements for $kind {
            fn text(&self) -> String {
                format!("{} ", *self as i64)
            }
        }
    )*};
}
integers!(i32, i64, u32, usize, bool);

impl Elements for f64 {
    fn text(&self) -> String {
        format!("{:016x} ", self.to_bits())
    }
}

impl Elements for f32 {
    fn text(&self) -> String {
        format!("{:08x} ", self.to_bits())
    }
}

impl<T: Elements> Elements for Vec<T> {
    fn text(&self) -> String {
        self.iter().map(Elements::text).collect()
    }
}

impl<T: Elements, const N: usize> Elements for [T; N] {
    fn text(&self) -> String {
        self.iter().map(Elements::text).collect()
    }
}

pub trait Show {
    fn lines(&self, name: &str);
}

pub fn show(name: &str, value: &impl Show) {
    value.lines(name);
}

fn line(name: &str, text: &str) {
    CALL.with(|call| println!("{}|{name}|{text}", call.borrow()));
}

impl<T: Elements> Show for T {
    fn lines(&self, name: &str) {
        line(name, &self.text());
    }
}

impl Show for String {
    fn lines(&self, name: &str) {
        line(name, self);
    }
}

impl Show for Spline {
    fn lines(&self, name: &str) {
        let axes = 0..self.axes().expect(name);
        let degrees: Vec<i32> = axes.clone().map(|axis| self.degree(axis).expect(name)).collect();
        let knots: Vec<Vec<f64>> = axes.map(|axis| self.knots(axis).expect(name)).collect();
        show(&format!("{name}.degrees"), &degrees);
        show(&format!("{name}.knots"), &knots);
        show(&format!("{name}.points"), &self.homogeneous_points().expect(name));
    }
}

impl Show for Statistics {
    fn lines(&self, name: &str) {
        let bytes: Vec<i32> = self.to_bytes().expect(name).into_iter().map(i32::from).collect();
        show(&format!("{name}.bytes"), &bytes);
    }
}

impl Show for Face {
    fn lines(&self, name: &str) {
        let sizes = self.loops().expect(name);
        show(&format!("{name}.sizes"), &sizes);
        for (k, &size) in sizes.iter().enumerate() {
            for i in 0..size as usize {
                show(&format!("{name}.curves"), &self.curve(k, i).expect(name));
            }
        }
    }
}

impl Show for Model {
    fn lines(&self, name: &str) {
        let n = self.counts().expect(name);
        show(&format!("{name}.counts"), &vec![n.parts, n.uses, n.faces, n.edges, n.vertices]);
        for i in 0..n.faces as usize {
            show(&format!("{name}.faces"), &self.face(i).expect(name).face);
        }
        for i in 0..n.edges as usize {
            show(&format!("{name}.edges"), &self.edge(i).expect(name).spline);
        }
    }
}

impl Show for Meet {
    fn lines(&self, name: &str) {
        show(&format!("{name}.nodes"), &self.nodes().expect(name).kinds);
        for i in 0..self.counts().expect(name).branches as usize {
            let (space, on_surface) = self.branch(i).expect(name);
            show(&format!("{name}.branches"), &space);
            show(&format!("{name}.branches"), &on_surface);
        }
    }
}

impl Show for Mesh {
    fn lines(&self, name: &str) {
        show(&format!("{name}.points"), &self.points().expect(name));
        show(&format!("{name}.corners"), &self.triangles(0).expect(name));
    }
}

impl Show for List {
    fn lines(&self, name: &str) {
        show(&format!("{name}.count"), &self.len());
        for i in 0..self.len() {
            show(&format!("{name}[{i}]"), &self.get(i).expect(name));
        }
    }
}
