//! A postprocessor that does only the core of the job, for one table C on B, as fast as portable code does it: reads
//! GOTO, solves, rounds the angles first, writes. No diagnostics, limits, planning, tolerance or feed. It is frozen:
//! the product is compared with it, so it must not change.

/// Degrees in whole units of four decimals.
const UNITS_PER_RAD: f64 = 1e4 * 180.0 / std::f64::consts::PI;
const UNITS_PER_TURN: i64 = 3_600_000;

/// Height of both centre lines above the table, mm.
const HEIGHT: f64 = 150.0;

/// The program of the points of a file.
pub(crate) fn post(cl: &[u8]) -> Vec<u8> {
    let (mut out, mut at, mut last_c) = (Vec::with_capacity(cl.len()), 0, 0_i64);
    while at < cl.len() {
        if !cl[at..].starts_with(b"GOTO/") {
            while at < cl.len() && cl[at] != b'\n' {
                at += 1;
            }
            at += 1;
            continue;
        }
        at += 5;
        let mut numbers = [0.0; 6];
        for number in &mut numbers {
            (*number, at) = number_at(cl, at);
            at += 1;
        }
        let [x, y, z, i, j, k] = numbers;
        let c = (j.atan2(i) * UNITS_PER_RAD).round() as i64;
        let b = ((i * i + j * j).sqrt().atan2(k) * UNITS_PER_RAD).round() as i64;
        let turns = (last_c - c + UNITS_PER_TURN / 2).div_euclid(UNITS_PER_TURN);
        last_c = c + turns * UNITS_PER_TURN;
        let ((sc, cc), (sb, cb)) = ((c as f64 / UNITS_PER_RAD).sin_cos(), (b as f64 / UNITS_PER_RAD).sin_cos());
        let (across, above) = (x * cc + y * sc, z - HEIGHT);
        let linear = [across * cb - above * sb, y * cc - x * sc, across * sb + above * cb + HEIGHT];
        for (letter, value) in b"XYZ".iter().zip(linear) {
            word(&mut out, *letter, (value * 1e3).round() as i64, 3);
        }
        word(&mut out, b'B', b, 4);
        word(&mut out, b'C', last_c, 4);
        out.push(b'\n');
    }
    out
}

/// A decimal number, and the index of the byte after it.
#[inline]
fn number_at(text: &[u8], mut at: usize) -> (f64, usize) {
    const SCALE: [f64; 10] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];
    let negative = text[at] == b'-';
    at += usize::from(negative);
    let (mut mantissa, mut point) = (0_i64, usize::MAX);
    loop {
        match text[at] {
            digit @ b'0'..=b'9' => mantissa = 10 * mantissa + i64::from(digit - b'0'),
            b'.' => point = at + 1,
            _ => break,
        }
        at += 1;
    }
    let value = mantissa as f64 / SCALE[at.saturating_sub(point)];
    (if negative { -value } else { value }, at)
}

/// A word with its decimals, without zeros at their end.
#[inline]
fn word(out: &mut Vec<u8>, letter: u8, units: i64, mut decimals: u32) {
    let mut rest = units.unsigned_abs();
    while decimals > 0 && rest.is_multiple_of(10) {
        rest /= 10;
        decimals -= 1;
    }
    let (mut text, mut at) = ([0_u8; 24], 24);
    let mut written = 0;
    while rest > 0 || written <= decimals {
        if written == decimals && decimals > 0 {
            at -= 1;
            text[at] = b'.';
        }
        at -= 1;
        text[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
        written += 1;
    }
    if units < 0 {
        at -= 1;
        text[at] = b'-';
    }
    out.push(letter);
    out.extend_from_slice(&text[at..]);
    out.push(b' ');
}
