//! Exact joint positions at the end of each block.
//!
//! After a block the program waits until the joints have settled and increments an analog output. The sampler records
//! it with joints and axes in every servo cycle: the first sample with a given number holds the positions reached.
//! Settling is counted in servo cycles: a busy computer delays the control, by up to 50 s a block, and changes nothing
//! else.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::configuration::{settled, switch};

/// Kinematics in force while a mark is sampled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkKinematics {
    /// The kinematics in force in the program.
    AsProgrammed,
    /// The kinematics of the machine, in a program that moves joints.
    OfMachine,
}

/// Position at the end of a block.
#[derive(Debug, Clone, PartialEq)]
pub struct Reached {
    /// Line of the program without marks, from 1.
    pub line: usize,
    /// Joints, mm and degrees.
    pub joints: Vec<f64>,
    /// Axes by the control's own kinematics, mm and degrees: tip position, with the tool length added to Z.
    pub axes: Vec<f64>,
    /// Joints in every servo cycle since the position before, mm and degrees.
    pub way: Vec<Vec<f64>>,
    /// Numbers of these servo cycles: a busy computer loses some.
    pub cycles: Vec<u64>,
}

/// The program with a mark after each of `lines`, numbered from `first`.
pub(super) fn marked(program: &str, lines: &[usize], first: usize, kinematics: MarkKinematics) -> String {
    let mut text = String::new();
    let mut mark = first;
    for (index, block) in program.lines().enumerate() {
        let _ = writeln!(text, "{block}");
        if !lines.contains(&(index + 1)) {
            continue;
        }
        let (before, after) = match kinematics {
            MarkKinematics::AsProgrammed => (String::new(), String::new()),
            // The joints have settled: as M428 and M429, without their wait.
            MarkKinematics::OfMachine => (switch(1), switch(0)),
        };
        let _ = write!(text, "{}{before}M68 E0 Q{mark}\n{after}", settled());
        mark += 1;
    }
    text
}

/// One servo cycle, as recorded by the sampler.
#[derive(Debug, Clone, PartialEq)]
struct Sample {
    cycle: u64,
    mark: usize,
    /// Whether the joints have settled.
    settled: bool,
    /// Joints and axes.
    values: Vec<f64>,
}

/// Samples read from the file of the sampler.
pub(super) struct Samples {
    file: File,
    rest: String,
    /// The samples of each mark, by mark.
    seen: Vec<Vec<Sample>>,
}

impl Samples {
    pub(super) fn open(path: &Path) -> io::Result<Self> {
        Ok(Self { file: File::open(path)?, rest: String::new(), seen: Vec::new() })
    }

    /// Marks that have been seen, mark 0 included.
    pub(super) fn marks(&self) -> usize {
        self.seen.len()
    }

    /// Reads the samples written since the last call.
    pub(super) fn read(&mut self) -> io::Result<()> {
        self.file.read_to_string(&mut self.rest)?;
        let whole = self.rest.rfind('\n').map_or(0, |end| end + 1);
        let lines: String = self.rest.drain(..whole).collect();
        for sample in lines.lines().filter_map(sample) {
            if self.seen.len() <= sample.mark {
                self.seen.resize(sample.mark + 1, Vec::new());
            }
            self.seen[sample.mark].push(sample);
        }
        Ok(())
    }

    /// Position reached at a mark after the first, number 0.
    pub(super) fn reached(&self, mark: usize, line: usize) -> Result<Reached, String> {
        let Some(sample) = self.seen.get(mark).and_then(|samples| samples.first()) else {
            return Err(format!("line {line}: the sampler has missed mark {mark}"));
        };
        if !sample.settled {
            return Err(format!("line {line}: the joints have not settled: {sample:?}"));
        }
        let joints = sample.values.len() / 2;
        let way = self.seen[mark - 1].iter().map(|sample| sample.values[..joints].to_vec()).collect();
        let cycles = self.seen[mark - 1].iter().map(|sample| sample.cycle).collect();
        Ok(Reached {
            line,
            joints: sample.values[..joints].to_vec(),
            axes: sample.values[joints..].to_vec(),
            way,
            cycles,
        })
    }
}

/// `3533 1.000000 1 11.000000 ...`: number, mark, settled, joints, axes. A line that reports lost samples is no sample.
fn sample(line: &str) -> Option<Sample> {
    let mut words = line.split_whitespace();
    let cycle = words.next()?.parse().ok()?;
    let mut numbers = words.map(|number| number.parse::<f64>().ok());
    let (mark, settled) = (numbers.next()??, numbers.next()??);
    let values = numbers.collect::<Option<_>>()?;
    Some(Sample { cycle, mark: mark.round() as usize, settled: settled > 0.5, values })
}

#[cfg(test)]
mod tests {
    use std::io::Write as _;

    use super::*;

    #[test]
    fn marks_come_after_the_given_lines() {
        let (settled, on, off) = (settled(), switch(1), switch(0));
        let text = marked("G0 X1\nG0 X2\nM2\n", &[2], 7, MarkKinematics::AsProgrammed);
        assert_eq!(text, format!("G0 X1\nG0 X2\n{settled}M68 E0 Q7\nM2\n"));
        let text = marked("G0 X1\n", &[1], 1, MarkKinematics::OfMachine);
        assert_eq!(text, format!("G0 X1\n{settled}{on}M68 E0 Q1\n{off}"));
    }

    #[test]
    fn the_first_sample_of_a_mark_counts_if_the_joints_have_settled() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("samples.txt");
        let mut file = File::create(&path).expect("a file");
        let mut samples = Samples::open(&path).expect("the file");
        let mut write = |text: &str, samples: &mut Samples| {
            file.write_all(text.as_bytes()).expect("text can be written");
            samples.read().expect("it can be read");
            samples.marks()
        };
        assert_eq!(write("1 0.0 1 5.0 6.0\n2 0.0 0 5.0 6.0\n3 1.0 1 7.0 8.", &mut samples), 1);
        assert_eq!(write("0\noverrun\n4 1.0 1 7.0 9.0\n5 3.0 0 1.0 1.0\n", &mut samples), 4);
        let way = vec![vec![5.0], vec![5.0]];
        assert_eq!(
            samples.reached(1, 12),
            Ok(Reached { line: 12, joints: vec![7.0], axes: vec![8.0], way, cycles: vec![1, 2] })
        );
        assert!(samples.reached(2, 13).is_err_and(|message| message.contains("missed")));
        assert!(samples.reached(3, 14).is_err_and(|message| message.contains("settled")));
    }
}
