//! Material removed over time: for each operation and tool, and over the whole program.

use std::collections::BTreeMap;

/// Time over which a rate of removal is measured, min: shorter blocks count together.
const WINDOW_MIN: f64 = 1.0 / 60.0;

/// Steps of the whole program: at most. With more the step is doubled.
const MOST_STEPS: usize = 512;

/// First step, min.
const FIRST_STEP_MIN: f64 = 1.0 / 600.0;

/// Removal of an operation with a tool.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Removal {
    pub(crate) volume_mm3: f64,
    /// Time of feed motions in material; 0 where the feed is unknown.
    pub(crate) minutes: f64,
    /// Largest rate over about a second, mm³/min, and the line of the program where it begins.
    pub(crate) largest: Option<(f64, u64)>,
    /// Volume, time and first line of what is measured now.
    window: (f64, f64, u64),
}

impl Removal {
    fn add(&mut self, line: u64, minutes: f64, volume_mm3: f64) {
        self.volume_mm3 += volume_mm3;
        if volume_mm3 > 0.0 {
            self.minutes += minutes;
        }
        let (volume, time, first) = &mut self.window;
        if *time <= 0.0 {
            *first = line;
        }
        *volume += volume_mm3;
        *time += minutes;
        if *time >= WINDOW_MIN {
            let rate = *volume / *time;
            if rate > 0.0 && self.largest.is_none_or(|(largest, _)| rate > largest) {
                self.largest = Some((rate, *first));
            }
            self.window = (0.0, 0.0, 0);
        }
    }
}

/// Removal of a program.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Engagement {
    pub(crate) operations: BTreeMap<(u64, u32), Removal>,
    /// Volume of each step of the feed motions, mm³.
    pub(crate) steps_mm3: Vec<f64>,
    pub(crate) step_min: f64,
    /// Time of all feed motions so far, min.
    time_min: f64,
}

impl Default for Engagement {
    fn default() -> Self {
        let operations = BTreeMap::new();
        Self { operations, steps_mm3: Vec::new(), step_min: FIRST_STEP_MIN, time_min: 0.0 }
    }
}

impl Engagement {
    /// Adds a part of a feed motion.
    pub(super) fn add(&mut self, operation: u64, tool: u32, line: u64, minutes: f64, volume_mm3: f64) {
        self.operations.entry((operation, tool)).or_default().add(line, minutes, volume_mm3);
        // Evenly over its time.
        let end = self.time_min + minutes;
        while end > self.step_min * MOST_STEPS as f64 {
            let pairs = self.steps_mm3.chunks(2).map(|pair| pair.iter().sum());
            self.steps_mm3 = pairs.collect();
            self.step_min *= 2.0;
        }
        let step = |time: f64| ((time / self.step_min) as usize).min(MOST_STEPS - 1);
        let (first, last) = (step(self.time_min), step(end));
        if self.steps_mm3.len() <= last {
            self.steps_mm3.resize(last + 1, 0.0);
        }
        for index in first..=last {
            let (from, to) = (index as f64 * self.step_min, (index + 1) as f64 * self.step_min);
            let share = if minutes > 0.0 {
                ((end.min(to) - self.time_min.max(from)) / minutes).clamp(0.0, 1.0)
            } else {
                f64::from(u8::from(index == first))
            };
            self.steps_mm3[index] += share * volume_mm3;
        }
        self.time_min = end;
    }

    /// Volume of all operations, mm³.
    pub(crate) fn volume_mm3(&self) -> f64 {
        // Not `sum`: that of nothing is -0.
        self.operations.values().fold(0.0, |volume, removal| volume + removal.volume_mm3)
    }

    /// Volume, mm³, and time, min, by tool.
    pub(crate) fn of_tools(&self) -> BTreeMap<u32, (f64, f64)> {
        let mut tools: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
        for ((_, tool), removal) in &self.operations {
            let (volume, minutes) = tools.entry(*tool).or_default();
            *volume += removal.volume_mm3;
            *minutes += removal.minutes;
        }
        tools
    }

    /// Whether nothing has been cut.
    pub(crate) fn is_empty(&self) -> bool {
        self.volume_mm3() <= 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn volumes_stay_in_their_time_while_the_step_grows() {
        let mut engagement = Engagement::default();
        // 30 minutes of air and cuts in turn, in blocks of a tenth of a second.
        for block in 0..18_000_u64 {
            let cuts = block / 3000 % 2 == 1;
            engagement.add(1, 7, block, 1.0 / 600.0, if cuts { 2.0 } else { 0.0 });
        }
        assert!(engagement.steps_mm3.len() <= MOST_STEPS && engagement.steps_mm3.len() > MOST_STEPS / 2);
        let total: f64 = engagement.steps_mm3.iter().sum();
        assert!((total - 18_000.0).abs() < 1e-6, "{total}");
        for (step, volume) in engagement.steps_mm3.iter().enumerate() {
            let rate = volume / engagement.step_min;
            let [from, to] = [step, step + 1].map(|step| (step as f64 * engagement.step_min / 5.0 + 1e-9) as u64);
            if from == to {
                assert!((rate - if from % 2 == 1 { 1200.0 } else { 0.0 }).abs() < 1.0, "{step}: {rate}");
            }
        }
        let removal = engagement.operations[&(1, 7)];
        assert!((removal.minutes - 15.0).abs() < 1e-6, "{removal:?}");
        let (rate, line) = removal.largest.expect("a rate");
        assert!((rate - 1200.0).abs() < 1e-6 && (3000..3020).contains(&line), "{rate} {line}");
        assert_eq!(engagement.of_tools().keys().copied().collect::<Vec<_>>(), [7]);
    }
}
