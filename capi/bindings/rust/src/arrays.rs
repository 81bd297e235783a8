// SPDX-License-Identifier: MIT
//! Slices as arrays of records, with lengths checked before the library sees a pointer.

use crate::error::{Error, Result};
use std::ptr::{null, null_mut};

#[derive(Clone, Copy, Debug)]
struct Layout {
    count: Option<usize>,
    stride: usize,
    component_stride: usize,
}

impl Layout {
    const PACKED: Layout = Layout { count: None, stride: 0, component_stride: 0 };

    fn count(&self, length: usize, width: usize, what: &str) -> Result<usize> {
        match self.count {
            Some(n) => Ok(n),
            None if width == 0 || length % width != 0 => {
                Err(Error::size(what, length, format!("a multiple of {}", width)))
            }
            None => Ok(length / width),
        }
    }

    /// The stride of records of one component, where the library takes only one stride.
    fn step(&self) -> usize {
        if self.stride == 0 {
            self.component_stride
        } else {
            self.stride
        }
    }

    /// One past the last element that n records touch.
    fn extent(&self, n: usize, width: usize) -> usize {
        if n == 0 || width == 0 {
            return 0;
        }
        let component = self.component_stride.max(1);
        let step = if self.stride == 0 { width.saturating_mul(component) } else { self.stride };
        let last = (n - 1).saturating_mul(step).saturating_add((width - 1).saturating_mul(component));
        last.saturating_add(1)
    }

    fn require(&self, length: usize, n: usize, width: usize, what: &str) -> Result<()> {
        if self.extent(n, width) > length || self.count(length, width, what)? != n {
            let expected = format!("{} records of {} components", n, width);
            return Err(Error::size(what, length, expected));
        }
        Ok(())
    }
}

/// An input array of records. A slice, array or vector converts to packed records.
#[derive(Clone, Copy, Debug)]
pub struct Records<'a> {
    values: &'a [f64],
    layout: Layout,
}

impl<'a> Records<'a> {
    /// n records; component c of record i is `values[i * stride + c * component_stride]`, 0 means packed.
    pub fn strided(values: &'a [f64], n: usize, stride: usize, component_stride: usize) -> Self {
        Records { values, layout: Layout { count: Some(n), stride, component_stride } }
    }

    /// The number of records of `width` components, all of which are in the slice.
    pub(crate) fn count(&self, width: usize, what: &str) -> Result<usize> {
        let n = self.layout.count(self.values.len(), width, what)?;
        self.require(n, width, what)?;
        Ok(n)
    }
    pub(crate) fn require(&self, n: usize, width: usize, what: &str) -> Result<()> {
        self.layout.require(self.values.len(), n, width, what)
    }
    pub(crate) fn pointer(&self) -> *const f64 {
        self.values.as_ptr()
    }
    pub(crate) fn step(&self) -> i64 {
        self.layout.step() as i64
    }
    pub(crate) fn stride(&self) -> i64 {
        self.layout.stride as i64
    }
    pub(crate) fn component_stride(&self) -> i64 {
        self.layout.component_stride as i64
    }
}

impl<'a, T: AsRef<[f64]> + ?Sized> From<&'a T> for Records<'a> {
    fn from(values: &'a T) -> Self {
        Records { values: values.as_ref(), layout: Layout::PACKED }
    }
}

/// An output array of records, `f64` or `f32`. A mutable slice, array or vector converts to packed records.
#[derive(Debug)]
pub struct RecordsMut<'a, T = f64> {
    values: &'a mut [T],
    layout: Layout,
}

impl<'a, T> RecordsMut<'a, T> {
    /// n records; component c of record i is `values[i * stride + c * component_stride]`, 0 means packed.
    pub fn strided(values: &'a mut [T], n: usize, stride: usize, component_stride: usize) -> Self {
        RecordsMut { values, layout: Layout { count: Some(n), stride, component_stride } }
    }

    pub(crate) fn require(&self, n: usize, width: usize, what: &str) -> Result<()> {
        self.layout.require(self.values.len(), n, width, what)
    }
    pub(crate) fn pointer(&mut self) -> *mut T {
        self.values.as_mut_ptr()
    }
    pub(crate) fn stride(&self) -> i64 {
        self.layout.stride as i64
    }
    pub(crate) fn component_stride(&self) -> i64 {
        self.layout.component_stride as i64
    }
}

impl<'a, T, A: AsMut<[T]> + ?Sized> From<&'a mut A> for RecordsMut<'a, T> {
    fn from(values: &'a mut A) -> Self {
        RecordsMut { values: values.as_mut(), layout: Layout::PACKED }
    }
}

/// A pointer and strides for an output that may be absent.
pub(crate) fn layout(
    out: &mut Option<RecordsMut>,
    n: usize,
    width: usize,
    what: &str,
) -> Result<(*mut f64, i64, i64)> {
    match out {
        None => Ok((null_mut(), 0, 0)),
        Some(o) => {
            o.require(n, width, what)?;
            let stride = if width == 1 { o.layout.step() as i64 } else { o.stride() };
            Ok((o.pointer(), stride, o.component_stride()))
        }
    }
}

/// The pointer of an output without strides, or NULL where it is absent.
pub(crate) fn exactly_mut<T>(out: &mut Option<&mut [T]>, size: usize, what: &str) -> Result<*mut T> {
    match out {
        None => Ok(null_mut()),
        Some(values) if values.len() == size => Ok(values.as_mut_ptr()),
        Some(values) => Err(Error::size(what, values.len(), size.to_string())),
    }
}

/// The pointer of an array that has to be of one length.
pub(crate) fn exactly<T>(values: &[T], size: usize, what: &str) -> Result<*const T> {
    if values.len() != size {
        return Err(Error::size(what, values.len(), size.to_string()));
    }
    Ok(values.as_ptr())
}

/// The same, or NULL for an array that is empty because it was left out.
pub(crate) fn if_given<T>(values: &[T], size: usize, what: &str) -> Result<*const T> {
    if values.is_empty() {
        return Ok(null());
    }
    exactly(values, size, what)
}

/// The same, or NULL.
pub(crate) fn optional<T>(values: Option<&[T]>, size: usize, what: &str) -> Result<*const T> {
    values.map_or(Ok(null()), |given| exactly(given, size, what))
}

/// Counts as the library takes them.
pub(crate) fn counts_of(counts: &[usize], size: usize, what: &str) -> Result<Vec<i64>> {
    exactly(counts, size, what)?;
    Ok(counts.iter().map(|&count| i64::try_from(count).unwrap_or(i64::MAX)).collect())
}

/// The number of records of `width` components, packed.
pub(crate) fn rows(values: &[f64], width: usize, what: &str) -> Result<usize> {
    Records::from(values).count(width, what)
}

/// The lengths of the arrays of all axes, and their elements one after the other.
pub(crate) fn by_axis(arrays: &[&[f64]], axes: usize, what: &str) -> Result<(Vec<i64>, Vec<f64>)> {
    if arrays.len() != axes {
        return Err(Error::size(what, arrays.len(), format!("{} vectors", axes)));
    }
    Ok((arrays.iter().map(|values| values.len() as i64).collect(), arrays.concat()))
}

/// The numbers of control points that knot vectors are of, and all knots one after the other.
pub(crate) fn knots_by_axis(arrays: &[&[f64]], degrees: &[i32], what: &str) -> Result<(Vec<i64>, Vec<f64>)> {
    let (lengths, knots) = by_axis(arrays, degrees.len(), what)?;
    Ok((lengths.iter().zip(degrees).map(|(length, &degree)| length - i64::from(degree) - 1).collect(), knots))
}

/// Lengths, numbers and how often each of them occurs.
type Pairs = (Vec<i64>, Vec<f64>, Vec<i32>);

/// The lengths of the pairs of vectors of all axes, and their elements one after the other.
pub(crate) fn pairs_by_axis(pairs: &[(&[f64], &[i32])], axes: usize, what: &str) -> Result<Pairs> {
    if pairs.len() != axes || pairs.iter().any(|(numbers, times)| numbers.len() != times.len()) {
        let expected = format!("{} pairs of equally long vectors", axes);
        return Err(Error::size(what, pairs.len(), expected));
    }
    let lengths = pairs.iter().map(|(numbers, _)| numbers.len() as i64).collect();
    let numbers = pairs.iter().flat_map(|(numbers, _)| numbers.iter().copied()).collect();
    let times = pairs.iter().flat_map(|(_, times)| times.iter().copied()).collect();
    Ok((lengths, numbers, times))
}

/// NULL for an output that is empty because it is not wanted.
pub(crate) fn pointer_mut(values: &mut [f64]) -> *mut f64 {
    if values.is_empty() {
        null_mut()
    } else {
        values.as_mut_ptr()
    }
}

/// The elements of rows.
pub(crate) fn flat<const N: usize>(rows: &mut [[f64; N]]) -> &mut [f64] {
    // Arrays have no gaps.
    unsafe { std::slice::from_raw_parts_mut(rows.as_mut_ptr().cast(), rows.len() * N) }
}

/// Sums of bits, which C passes as signed numbers.
pub(crate) fn bits(values: Vec<i32>) -> Vec<u32> {
    values.into_iter().map(|value| value as u32).collect()
}

pub(crate) fn truths(values: Vec<i32>) -> Vec<bool> {
    values.into_iter().map(|value| value != 0).collect()
}
