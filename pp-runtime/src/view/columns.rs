//! Columns of numbers in few bytes: quantised, as differences, compressed, in base64.

use std::io::{self, Write as _};

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde::Serialize;

/// Largest quantised value: the difference of two such values is still a number of 32 bits.
const LARGEST: f64 = (1 << 30) as f64;

/// Finest steps of a column are multiplied by this until all values are small enough.
const COARSER: f64 = 10.0;

/// Description of one column, as the page reads it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Column {
    name: String,
    #[serde(rename = "type")]
    form: Form,
    /// Value of one step.
    #[serde(skip_serializing_if = "Option::is_none")]
    scale: Option<f64>,
}

/// Numbers of a column, little endian.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Form {
    F32,
    U16,
    U8,
    /// Differences of quantised values, 32 bits with a sign.
    Q32,
}

/// Columns one after the other.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    list: Vec<Column>,
    bytes: Vec<u8>,
}

impl Columns {
    fn begin(&mut self, name: impl Into<String>, form: Form, scale: Option<f64>) {
        self.list.push(Column { name: name.into(), form, scale });
    }

    /// Values in steps of `finest`, or of a power of ten of it where they are large.
    pub(crate) fn quantised(
        &mut self,
        name: impl Into<String>,
        finest: f64,
        values: impl Iterator<Item = f64> + Clone,
    ) {
        let largest = values.clone().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let mut step = finest;
        while largest / step > LARGEST {
            step *= COARSER;
        }
        self.begin(name, Form::Q32, Some(step));
        let mut before = 0_i32;
        for value in values {
            let steps = (value / step).round() as i32;
            self.bytes.extend((steps - before).to_le_bytes());
            before = steps;
        }
    }

    /// Values of 32 bits; NaN where unknown.
    pub(crate) fn floats(&mut self, name: &str, values: impl Iterator<Item = Option<f64>>) {
        self.begin(name, Form::F32, None);
        values.for_each(|value| self.bytes.extend((value.unwrap_or(f64::NAN) as f32).to_le_bytes()));
    }

    /// Indices of 16 bits; one that does not fit is the largest.
    pub(crate) fn indices(&mut self, name: &str, values: impl Iterator<Item = usize>) {
        self.begin(name, Form::U16, None);
        values.for_each(|value| self.bytes.extend(u16::try_from(value).unwrap_or(u16::MAX).to_le_bytes()));
    }

    /// Bytes.
    pub(crate) fn small(&mut self, name: &str, values: impl Iterator<Item = u8>) {
        self.begin(name, Form::U8, None);
        self.bytes.extend(values);
    }

    /// The descriptions, and all numbers as text.
    pub(crate) fn encoded(self) -> io::Result<(Vec<Column>, String)> {
        Ok((self.list, packed(&self.bytes)?))
    }
}

/// Compressed bytes (DEFLATE, without a header) in base64.
pub(crate) fn packed(bytes: &[u8]) -> io::Result<String> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    Ok(BASE64_STANDARD.encode(encoder.finish()?))
}
