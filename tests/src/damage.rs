//! Posted programs with one fault, as after a manual edit or a transmission error.

use crate::random::Random;

/// The program with one fault, and a description of it: a wrong digit, sign or letter, a lost or a doubled line.
///
/// # Panics
/// If the program holds only comments.
#[must_use]
pub fn damage(program: &[u8], random: &mut Random) -> (Vec<u8>, String) {
    let lines: Vec<&[u8]> = program.split_inclusive(|byte| *byte == b'\n').collect();
    let comment = |line: &[u8]| {
        let text = line.trim_ascii_start();
        text.starts_with(b"(") || text.starts_with(b";") || text.windows(2).any(|two| two == b"; ") || text.is_empty()
    };
    assert!(!lines.iter().all(|line| comment(line)), "the program holds only comments");
    loop {
        let at = random.below(lines.len());
        if comment(lines[at]) {
            continue;
        }
        let mut damaged: Vec<u8> = lines[..at].concat();
        let mut line = lines[at].to_vec();
        let before = String::from_utf8_lossy(&line).trim_end().to_owned();
        match random.below(10) {
            0 => line.clear(),
            1 => line = [line.clone(), line].concat(),
            2 => {
                let place = random.below(line.len());
                if line[place] == b'\n' {
                    continue;
                }
                line.remove(place);
            }
            _ => {
                let place = random.below(line.len());
                let other = match line[place] {
                    b'0'..=b'9' => b'0' + random.below(10) as u8,
                    b'-' => b'+',
                    b'+' => b'-',
                    b'A'..=b'Z' => b'A' + random.below(26) as u8,
                    b'.' => b"0123456789"[random.below(10)],
                    b' ' => b'-',
                    _ => continue,
                };
                if other == line[place] {
                    continue;
                }
                line[place] = other;
            }
        }
        let after = String::from_utf8_lossy(&line).trim_end().to_owned();
        damaged.extend_from_slice(&line);
        damaged.extend(lines[at + 1..].concat());
        return (damaged, format!("line {} `{before}` became `{after}`", at + 1));
    }
}
