//! Machining times as text, for the summary and the end of the program.

use crate::motion::{OperationTime, Times};

/// Largest number of operations whose times are listed.
const MOST_LISTED: usize = 20;

/// A time in readable units: `1 h 02 min`, `12 min 05 s`, `3.2 s`.
pub(crate) fn duration(minutes: f64) -> String {
    let seconds = minutes * 60.0;
    if seconds < 60.0 {
        return format!("{seconds:.1} s");
    }
    let whole = seconds.round() as u64;
    match (whole / 3600, whole / 60 % 60, whole % 60) {
        (0, minutes, seconds) => format!("{minutes} min {seconds:02} s"),
        (hours, minutes, _) => format!("{hours} h {minutes:02} min"),
    }
}

/// The lines about machining times: total and operations, then those of [`speeds`].
pub(crate) fn lines(times: &Times) -> Vec<String> {
    let mut lines = totals(times);
    lines.append(&mut speeds(times));
    lines
}

fn totals(times: &Times) -> Vec<String> {
    if times.total_min() <= 0.0 {
        return Vec::new();
    }
    let mut total = format!("machining time {}: cutting {}", duration(times.total_min()), duration(times.cutting_min));
    if times.rapid_min > 0.0 {
        total += &format!(", rapids {}", duration(times.rapid_min));
    }
    if times.dwell_min > 0.0 {
        total += &format!(", dwells {}", duration(times.dwell_min));
    }
    if times.rapids_of_unknown_speed > 0 {
        total += "; rapids of axes without a speed in `speeds` are not counted";
    }
    let mut lines = vec![total];
    if times.operations.len() > 1 {
        lines.extend(times.operations.iter().take(MOST_LISTED).map(of_operation));
        let more = times.operations.len().saturating_sub(MOST_LISTED) as u64 + times.unlisted_operations;
        lines.extend((more > 0).then(|| format!("  and {more} more operations")));
    }
    lines
}

/// The lines about fastest rotary axis in a cut, and about blocks slowed down.
pub(crate) fn speeds(times: &Times) -> Vec<String> {
    let mut lines = Vec::new();
    if times.total_min() <= 0.0 {
        return lines;
    }
    if let Some(fastest) = times.fastest {
        lines.push(format!(
            "fastest rotary axis in a cut, as programmed and before it is slowed down: {} at {:.0} degrees/min (CL line {})",
            fastest.letter,
            fastest.rad_per_min.to_degrees(),
            fastest.at.line
        ));
    }
    if times.slowed_blocks > 0 {
        lines.push(format!(
            "slower than programmed because of axis speeds or limits of the control: {} blocks from CL line {} on, \
             by {} in all",
            times.slowed_blocks,
            times.first_slowed.line,
            duration(times.slowed_min)
        ));
    }
    lines
}

fn of_operation(operation: &OperationTime) -> String {
    let name = String::from_utf8_lossy(&operation.name);
    format!("  {}: {} (CL line {})", name.trim(), duration(operation.total_min), operation.at.line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_duration_is_read_at_a_glance() {
        let said = [0.05, 1.5, 59.999, 61.0, 605.0].map(duration);
        assert_eq!(said, ["3.0 s", "1 min 30 s", "1 h 00 min", "1 h 01 min", "10 h 05 min"]);
    }
}
