//! Posted programs with one character wrong, as an edit by hand or a bad line leaves them.

use crate::random::Random;

/// A program with one thing wrong, and what: a digit, a sign, a letter, a line that is lost or stands twice.
///
/// # Panics
/// If there is nothing in the program but comments.
#[must_use]
pub fn damage(program: &[u8], random: &mut Random) -> (Vec<u8>, String) {
    let lines: Vec<&[u8]> = program.split_inclusive(|byte| *byte == b'\n').collect();
    let comment = |line: &[u8]| {
        let text = line.trim_ascii_start();
        text.starts_with(b"(") || text.starts_with(b";") || text.windows(2).any(|two| two == b"; ") || text.is_empty()
    };
    assert!(!lines.iter().all(|line| comment(line)), "nothing to damage");
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
