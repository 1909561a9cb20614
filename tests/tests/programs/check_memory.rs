//! A program is checked in constant memory, for any length and any faults.
//!
//! CL data and program are generated while they are read. A part is posted a few times in succession; the text between
//! two of its beginnings is then repeated as often as needed. One part has every feature (arcs, a tilted plane, every
//! cycle, simultaneous motion with a rewind, a thread); the other has only lines, a million of which are checked
//! quickly.

use std::fs;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write as _};

use machines::SpinnerU5620;
use pp_runtime::check::{Checked, check};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::Control;
use pp_runtime::post::{self, post};
use pp_runtime::program::Units;
use tests::binaries::workspace;
use tests::by_name;
use tests::foreign::{Control as Foreign, lexer};
use tests::heap::{allocations, peak};
use tests::random::Random;

/// Additional memory that a longer program may take, bytes: a name, a number with more digits.
const ALLOWANCE: usize = 16 << 10;

/// Text that is generated while it is read: a head, a piece that is repeated, a tail.
#[derive(Debug, Clone, Default)]
struct Repeated {
    sections: [Vec<u8>; 3],
    times: u64,
    /// Whether lines begin with their number, one more than that of the line before.
    numbered: bool,
    /// Number of sections read.
    sections_read: u64,
    /// Bytes read of the present section.
    at: usize,
    /// Number of the next line.
    number: u64,
    /// The present line.
    line: Vec<u8>,
    /// Bytes of the present line that have been handed out.
    handed_out: usize,
}

impl Repeated {
    /// The rest of the present section; `None` after the last one.
    fn rest(&mut self) -> Option<&[u8]> {
        loop {
            let section = match self.sections_read {
                0 => 0,
                read if read <= self.times => 1,
                read if read == self.times + 1 => 2,
                _ => return None,
            };
            if self.at < self.sections[section].len() {
                return Some(&self.sections[section][self.at..]);
            }
            self.sections_read += 1;
            self.at = 0;
        }
    }

    /// Generates the next line; `false` after the last one.
    fn next_line(&mut self) -> bool {
        let (number, numbered, mut line) = (self.number, self.numbered, std::mem::take(&mut self.line));
        self.handed_out = 0;
        let Some(rest) = self.rest() else { return false };
        let text = rest.split_inclusive(|byte| *byte == b'\n').next().unwrap_or_default();
        let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let has_number = numbered && digits > 0;
        line.clear();
        if has_number {
            write!(line, "{number}").expect("memory can be written");
        }
        line.extend_from_slice(&text[if has_number { digits } else { 0 }..]);
        self.at += text.len();
        self.number += u64::from(has_number);
        self.line = line;
        true
    }

    /// Number of lines of the text.
    fn lines(&self) -> u64 {
        let [head, piece, tail] = [0, 1, 2].map(|index: usize| lines(&self.sections[index]));
        head + piece * self.times + tail
    }

    /// The text with at most `wanted` lines in its repeated pieces.
    fn of_lines(&self, wanted: u64) -> Self {
        Self { times: wanted / lines(&self.sections[1]), ..self.clone() }
    }
}

impl Read for Repeated {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        while count < buffer.len() {
            if self.handed_out == self.line.len() && !self.next_line() {
                break;
            }
            let more = (buffer.len() - count).min(self.line.len() - self.handed_out);
            buffer[count..count + more].copy_from_slice(&self.line[self.handed_out..self.handed_out + more]);
            self.handed_out += more;
            count += more;
        }
        Ok(count)
    }
}

impl Seek for Repeated {
    /// Seeks to the beginning; any other position is an error.
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        match position {
            SeekFrom::Start(0) => (self.sections_read, self.at, self.number, self.handed_out) = (0, 0, 0, 0),
            SeekFrom::Current(0) if (self.sections_read, self.at) == (0, 0) => {}
            _ => return Err(io::Error::other("this text can be read from its beginning only")),
        }
        self.line.clear();
        Ok(0)
    }
}

fn lines(text: &[u8]) -> u64 {
    text.iter().filter(|byte| **byte == b'\n').count() as u64
}

/// CL data of a repeated part, and its program.
struct Long {
    config: Config,
    control: &'static dyn Control,
    data: Repeated,
    program: Repeated,
}

/// Number of times that the part is posted: the second and the third must give the same blocks.
const POSTED: usize = 4;

fn text(name: &str) -> String {
    fs::read_to_string(workspace().join("tests/data/works").join(name)).expect("a file")
}

/// The part with every feature, without its return to the home position.
fn works() -> String {
    let text = text("works.cls");
    text.split_inclusive('\n').filter(|line| !line.starts_with("GOHOME")).collect()
}

/// A floor milled line by line.
fn floor() -> String {
    let mut part = "TOOL PATH/ARCS,TOOL,MILL_10\nLOAD/TOOL,1,ADJUST,1\nSPINDL/RPM,4000,CLW\nCOOLNT/ON\nRAPID\n\
        GOTO/0.0000,0.0000,20.0000,0.0000000,0.0000000,1.0000000\nFEDRAT/MMPM,600.0000\n"
        .to_owned();
    for line in 0..2000 {
        let (x, y) = (if line / 2 % 2 == 0 { -35.0 } else { 35.0 }, 0.05 * f64::from(line % 1000));
        part += &format!("GOTO/{:.4},{:.4},{:.4}\n", x * (-1.0_f64).powi(line), y - 25.0, -0.001 * f64::from(line));
    }
    part + "RAPID\nGOTO/0.0000,0.0000,20.0000\nEND-OF-PATH\n"
}

impl Long {
    fn posted(control: &str, part: &str) -> Self {
        let control = by_name::control(control);
        let config = starting_point(control).read_over(&SpinnerU5620::default(), &text("table.toml"));
        let mut config = Config { output_units: Some(Units::Millimetres), ..config.expect("a configuration") };
        // Each guard has a label of its own.
        config.motion.guards.offset_guard = false;
        let mut program = Vec::new();
        let job = post::Job { cl_name: "works.cls", config: &config, control, units: None };
        let report = post::<SpinnerU5620>(&job, &mut Cursor::new(part.repeat(POSTED)), &mut program)
            .expect("memory can be written");
        assert!(!report.failed, "{:?}", report.diagnostics);
        let begins = beginnings(&program);
        let piece = |index: usize| program[begins[index]..begins[index + 1]].to_vec();
        let name = control.spellings().name;
        let [second, third] = [1, 2].map(|index| without_numbers(name, &piece(index)));
        assert_eq!(second, third, "the repeated part must give the same blocks");
        let sections = [program[..begins[1]].to_vec(), piece(1), program[begins[3]..].to_vec()];
        let data = [(); 3].map(|()| part.as_bytes().to_vec());
        let numbered = name == "heidenhain";
        Self {
            data: Repeated { sections: data, ..Repeated::default() },
            program: Repeated { sections, numbered, ..Repeated::default() },
            config,
            control,
        }
    }

    /// Checks a program of about `wanted` lines. Returns the result, the number of lines, and the largest memory in
    /// use, bytes.
    fn checked(&self, wanted: u64) -> (Checked, u64, usize) {
        let program = self.program.of_lines(wanted);
        self.checked_against(program.times, program)
    }

    /// Checks any program against the CL data with the part repeated `times` times.
    fn checked_against(&self, times: u64, program: Repeated) -> (Checked, u64, usize) {
        let lines = program.lines();
        let data = Repeated { times, ..self.data.clone() };
        let policy = self
            .config
            .check_policy::<SpinnerU5620>(self.control, None)
            .expect("the configuration suits control and machine");
        let (checked, peak) = peak(|| check::<SpinnerU5620>(&policy, data, program).expect("it can be read"));
        (checked, lines, peak)
    }
}

/// Offsets at which the part begins in a program, bytes: at the name of its first operation.
fn beginnings(program: &[u8]) -> Vec<usize> {
    let mut at = 0;
    let mut begins = Vec::new();
    for line in program.split_inclusive(|byte| *byte == b'\n') {
        let text = line.trim_ascii_end();
        if [&b"(OPERATION ARCS)"[..], b"MSG(\"ARCS\")", b"* - ARCS"].iter().any(|name| text.ends_with(name)) {
            begins.push(at);
        }
        at += line.len();
    }
    assert_eq!(begins.len(), POSTED, "{}", String::from_utf8_lossy(program));
    begins
}

/// Blocks without their numbers, and without those of labels, each of which occurs in one place only.
fn without_numbers(control: &str, program: &[u8]) -> Vec<lexer::Content> {
    let control = Foreign::by_name(control).expect("a control");
    let lines = lexer::joined(control, std::str::from_utf8(program).expect("ASCII"));
    let content =
        |(_, text): (usize, String)| lexer::line(control, &text).unwrap_or_else(|why| panic!("{why}: {text}")).content;
    let unlabelled = |content: lexer::Content| match content {
        lexer::Content::Condition(text) if text.contains("LBL \"") => {
            let (before, label) = text.split_once("LBL \"").expect("a label");
            lexer::Content::Condition(format!(
                "{before}LBL {}",
                label.trim_end_matches(|last: char| last == '"' || last.is_ascii_digit())
            ))
        }
        other => other,
    };
    lines.into_iter().map(content).map(unlabelled).collect()
}

/// Checks that a program a hundred times as long passes and takes no more memory.
fn memory_stays_constant(control: &str, part: &str, long: u64) {
    let part = Long::posted(control, part);
    let (few, short, least) = part.checked(long / 100);
    let (many, lines, most) = part.checked(long);
    assert!(few.outcome.passed() && many.outcome.passed(), "{control}: {:?}", many.outcome.findings);
    assert!(lines >= long * 99 / 100 && many.outcome.lines == lines && few.outcome.lines == short, "{lines}");
    assert!(most <= least + ALLOWANCE, "{control}: {least} bytes for {short} lines, {most} for {lines}");
}

#[test]
fn a_million_lines_take_no_more_memory_than_ten_thousand() {
    memory_stays_constant("linuxcnc", &floor(), 1_000_000);
}

#[test]
fn nothing_is_allocated_for_a_motion() {
    let part = Long::posted("linuxcnc", &floor());
    let count = |wanted| {
        let mut lines = 0;
        (allocations(|| lines = part.checked(wanted).1), lines)
    };
    let ((few, short), (many, long)) = (count(20_000), count(60_000));
    // A part of 2000 lines begins with its operation, its tool and its name.
    let parts = (long - short).div_ceil(2000) as usize;
    assert!(many - few <= 20 * parts, "{few} for {short} lines, {many} for {long}");
}

#[test]
fn no_feature_takes_more_memory_when_it_is_repeated() {
    for control in ["linuxcnc", "siemens", "heidenhain", "haas"] {
        memory_stays_constant(control, &works(), 40_000);
    }
}

/// Memory for the faults of a program, bytes: twenty findings of each kind, and a line that is too long.
const FINDINGS: usize = 256 << 10;

#[test]
fn a_program_of_another_part_takes_constant_memory() {
    let part = Long::posted("linuxcnc", &works());
    let other = Long::posted("linuxcnc", &floor());
    let (few, short, least) = part.checked_against(5, other.program.of_lines(50_000));
    let (many, lines, most) = part.checked_against(5, other.program.of_lines(150_000));
    assert!(few.outcome.count > 5 && many.outcome.count > 100, "{} and {}", few.outcome.count, many.outcome.count);
    assert!(most <= least + ALLOWANCE, "{least} bytes for {short} lines, {most} for {lines}");
}

#[test]
fn lines_that_are_no_blocks_take_constant_memory() {
    let mut random = Random::new(8);
    let letters = b"GMXYZABCIJKFSTHDPQRNLO0123456789.-+ ()#=`~;%\"";
    let piece: Vec<u8> = (0..2000)
        .flat_map(|_| {
            let line: Vec<u8> = (0..60).map(|_| letters[random.below(letters.len())]).chain([b'\n']).collect();
            line
        })
        .collect();
    for control in ["linuxcnc", "siemens", "heidenhain"] {
        let part = Long::posted(control, &works());
        let garbage = Repeated { sections: [Vec::new(), piece.clone(), Vec::new()], ..Repeated::default() };
        let (_, short, least) = part.checked_against(5, garbage.of_lines(2_000));
        let (checked, lines, most) = part.checked_against(5, garbage.of_lines(20_000));
        // A fault that comes again is no further finding: the lines differ within a piece.
        let different = lines / garbage.of_lines(20_000).times;
        assert!(checked.outcome.count > different / 2, "{control}: {} of {different}", checked.outcome.count);
        assert!(most <= least + FINDINGS, "{control}: {least} bytes for {short} lines, {most} for {lines}");
    }
}

#[test]
fn a_line_without_end_is_an_error_and_fills_no_memory() {
    for (control, words) in [("linuxcnc", "X1 "), ("siemens", "X=1 "), ("heidenhain", "L X+1 ~\n "), ("fanuc", "(")] {
        let part = Long::posted(control, &works());
        let (_, _, least) = part.checked(1000);
        let [head, _, tail] = part.program.sections.clone();
        let program =
            Repeated { sections: [head, endless(words), [&b"\n"[..], &tail].concat()], ..part.program.clone() };
        let (checked, _, most) = part.checked_against(1, Repeated { times: ENDLESS_REPETITIONS, ..program });
        let findings = &checked.outcome.findings;
        assert!(findings.iter().any(|found| found.text.contains("longer than")), "{control}: {findings:?}");
        assert!(checked.outcome.count < 100, "{control}: {findings:?}");
        assert!(most < least + FINDINGS, "{control}: {least} bytes for the correct program, {most} for this one");
    }
}

#[test]
fn a_record_without_end_is_an_error_and_fills_no_memory() {
    let part = Long::posted("linuxcnc", &works());
    let sections = [part.data.sections[0].clone(), endless("GOTO/1.0,2.0,3.0,"), b"\n".to_vec()];
    let part = Long { data: Repeated { sections, ..Repeated::default() }, ..part };
    let (checked, _, most) = part.checked_against(ENDLESS_REPETITIONS, part.program.of_lines(1000));
    let fault = checked.fault.expect("the record is refused");
    assert!(fault.text.contains("longer than") && most < 4 << 20, "{most} bytes, {fault:?}");
}

/// Repetitions of an endless piece that give a hundred million bytes.
const ENDLESS_REPETITIONS: u64 = 2000;

/// A piece of a line that does not end.
fn endless(words: &str) -> Vec<u8> {
    words.repeat(50_000 / words.len()).into_bytes()
}
