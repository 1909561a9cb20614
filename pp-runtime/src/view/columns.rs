//! Columns of numbers in few bytes: quantised, as differences, compressed, in base64.

use std::io::{self, Write as _};

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde::Serialize;

/// Largest quantised value: the difference of two such values is still a number of 32 bits.
const LARGEST: f64 = ((1 << 30) - 1) as f64;

/// Finest steps of a column are multiplied by this until all values are small enough.
const COARSER: f64 = 10.0;

/// Level of compression, 1 to 9: 4 takes half as long again for a twentieth of the length, 6 five times as long for a
/// tenth.
const LEVEL: u32 = 2;

/// Bits of a number of 32 bits: its sign, infinity, and those that are kept.
const SIGN: u32 = 1 << 31;
const INFINITY: u32 = f32::INFINITY.to_bits();
const KEPT: u32 = !0 << 9;

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

/// Columns one after the other. A column has the lowest bytes of all its values, then their next bytes, and so on:
/// equal bytes are neighbours, which makes the text shorter by a quarter and its compression three times as fast.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    list: Vec<Column>,
    bytes: Vec<u8>,
}

impl Columns {
    /// Adds a column of values of `N` bytes, little endian.
    fn add<const N: usize>(&mut self, column: Column, values: impl Iterator<Item = [u8; N]>) {
        let values: Vec<[u8; N]> = values.collect();
        self.list.push(column);
        for place in 0..N {
            self.bytes.extend(values.iter().map(|value| value[place]));
        }
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
        let mut before = 0_i32;
        let differences = values.map(|value| {
            let steps = (value / step).round() as i32;
            let difference = steps - before;
            before = steps;
            difference.to_le_bytes()
        });
        self.add(Column { name: name.into(), form: Form::Q32, scale: Some(step) }, differences);
    }

    /// Values of 32 bits, rounded to four significant digits; NaN where unknown.
    pub(crate) fn floats(&mut self, name: &str, values: impl Iterator<Item = Option<f64>>) {
        let rounded = values.map(|value| {
            let bits = value.map_or(f32::NAN, |value| value as f32).to_bits();
            if bits & !SIGN < INFINITY { (bits + (!KEPT >> 1)) & KEPT } else { bits }.to_le_bytes()
        });
        self.add(Column { name: name.into(), form: Form::F32, scale: None }, rounded);
    }

    /// Indices of 16 bits; one that does not fit is the largest.
    pub(crate) fn indices(&mut self, name: &str, values: impl Iterator<Item = usize>) {
        let indices = values.map(|value| u16::try_from(value).unwrap_or(u16::MAX).to_le_bytes());
        self.add(Column { name: name.into(), form: Form::U16, scale: None }, indices);
    }

    /// Bytes.
    pub(crate) fn small(&mut self, name: &str, values: impl Iterator<Item = u8>) {
        self.add(Column { name: name.into(), form: Form::U8, scale: None }, values.map(|value| [value]));
    }

    /// The descriptions, and all numbers as text.
    pub(crate) fn encoded(self) -> io::Result<(Vec<Column>, String)> {
        Ok((self.list, packed(&self.bytes)?))
    }
}

/// Compressed bytes (DEFLATE, without a header) in base64.
pub(crate) fn packed(bytes: &[u8]) -> io::Result<String> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::new(LEVEL));
    encoder.write_all(bytes)?;
    Ok(BASE64_STANDARD.encode(encoder.finish()?))
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use flate2::read::DeflateDecoder;

    use super::*;

    /// Bytes of columns, and their descriptions.
    fn decoded(columns: Columns) -> (Vec<Column>, Vec<u8>) {
        let (list, text) = columns.encoded().expect("memory");
        let packed = BASE64_STANDARD.decode(text).expect("base64");
        let mut bytes = Vec::new();
        DeflateDecoder::new(&*packed).read_to_end(&mut bytes).expect("DEFLATE");
        (list, bytes)
    }

    /// Values of four bytes of a column.
    fn value_by_value(bytes: &[u8]) -> Vec<[u8; 4]> {
        let count = bytes.len() / 4;
        (0..count).map(|index| std::array::from_fn(|place| bytes[place * count + index])).collect()
    }

    fn quantised(values: &[f64]) -> (f64, Vec<f64>) {
        let mut columns = Columns::default();
        columns.quantised("axis.X", 1e-5, values.iter().copied());
        let (list, bytes) = decoded(columns);
        let step = list[0].scale.expect("a step");
        let mut sum = 0;
        let read = value_by_value(&bytes).into_iter().map(|value| {
            sum += i32::from_le_bytes(value);
            f64::from(sum) * step
        });
        (step, read.collect())
    }

    #[test]
    fn quantised_values_are_off_by_half_a_step_however_many_come_before() {
        let values: Vec<f64> = (0..5000).map(|index| 900.0 * (f64::from(index) * 0.37).sin()).collect();
        let (step, read) = quantised(&values);
        assert!((step - 1e-5).abs() < 1e-18);
        for (value, read) in values.iter().zip(&read) {
            assert!((value - read).abs() <= 0.5001 * step, "{value} {read}");
        }
    }

    #[test]
    fn large_values_have_coarser_steps() {
        let values = [-2.4e6, 2.4e6, -2.4e6];
        let (step, read) = quantised(&values);
        assert!((step - 1e-2).abs() < 1e-12, "{step}");
        assert!(values.iter().zip(&read).all(|(value, read)| (value - read).abs() <= step), "{read:?}");
    }

    #[test]
    fn a_step_between_the_largest_values_is_a_difference_of_32_bits() {
        let largest = LARGEST * 1e-5;
        let (step, read) = quantised(&[-largest, largest]);
        assert!((step - 1e-5).abs() < 1e-18 && (read[1] - largest).abs() < 1e-5, "{step} {read:?}");
    }

    #[test]
    fn floats_keep_four_digits_and_unknown_is_not_a_number() {
        let values = [Some(0.0), Some(1800.0), Some(-799.968_3), Some(1.234_567e-7), None];
        let mut columns = Columns::default();
        columns.floats("feed", values.into_iter());
        let (_, bytes) = decoded(columns);
        let read: Vec<f32> = value_by_value(&bytes).into_iter().map(f32::from_le_bytes).collect();
        for (value, read) in values.iter().zip(&read) {
            match value {
                Some(value) => assert!((f64::from(*read) - value).abs() <= 1e-4 * value.abs(), "{value} {read}"),
                None => assert!(read.is_nan()),
            }
        }
        assert!(read[1].to_bits() == 1800_f32.to_bits());
    }

    #[test]
    fn columns_follow_each_other_and_an_index_that_does_not_fit_is_the_largest() {
        let mut columns = Columns::default();
        columns.small("kind", [1, 2].into_iter());
        columns.indices("operation", [3, 70_000].into_iter());
        let (list, bytes) = decoded(columns);
        assert_eq!(bytes, [1, 2, 3, 255, 0, 255]);
        let described = serde_json::to_string(&list).expect("JSON");
        assert_eq!(described, r#"[{"name":"kind","type":"u8"},{"name":"operation","type":"u16"}]"#);
    }
}
