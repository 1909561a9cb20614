//! A program is checked in constant memory, however long it is and whatever is wrong with it.
//!
//! CL data and program are made while they are read. A part is posted a few times over; what stands between two of its
//! beginnings is then repeated as often as it takes. One part has everything in it (arcs, a tilted plane, every cycle,
//! simultaneous motion with a rewind, a thread), the other is lines alone, of which a million are soon checked.

use std::fs;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write as _};

use machines::SpinnerU5620;
use pp_runtime::check::{Checked, Job, check};
use pp_runtime::config::{Config, Units, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::post::{self, post};
use tests::binaries::workspace;
use tests::foreign::{Control as Foreign, lexer};
use tests::heap::{Counting, allocations, peak};
use tests::random::Random;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What a longer program may take besides, bytes: a name, a number with more digits.
const ALLOWANCE: usize = 16 << 10;

/// Text that is made while it is read: a head, a piece as often as it takes, a tail.
#[derive(Debug, Clone, Default)]
struct Repeated {
    sections: [Vec<u8>; 3],
    times: u64,
    /// Lines begin with their number, one more than that of the line before.
    numbered: bool,
    /// Sections that have been read, how much of this one, and lines.
    read: u64,
    at: usize,
    number: u64,
    /// The line that is handed out, and how much of it has been.
    line: Vec<u8>,
    handed: usize,
}

impl Repeated {
    /// The rest of the section that is read; `None` behind the last.
    fn rest(&mut self) -> Option<&[u8]> {
        loop {
            let section = match self.read {
                0 => 0,
                read if read <= self.times => 1,
                read if read == self.times + 1 => 2,
                _ => return None,
            };
            if self.at < self.sections[section].len() {
                return Some(&self.sections[section][self.at..]);
            }
            self.read += 1;
            self.at = 0;
        }
    }

    /// Makes the next line; `false` behind the last.
    fn next_line(&mut self) -> bool {
        let (number, numbered, mut line) = (self.number, self.numbered, std::mem::take(&mut self.line));
        self.handed = 0;
        let Some(rest) = self.rest() else { return false };
        let text = rest.split_inclusive(|byte| *byte == b'\n').next().unwrap_or_default();
        let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let counts = numbered && digits > 0;
        line.clear();
        if counts {
            write!(line, "{number}").expect("memory takes it");
        }
        line.extend_from_slice(&text[if counts { digits } else { 0 }..]);
        self.at += text.len();
        self.number += u64::from(counts);
        self.line = line;
        true
    }

    /// How many lines there are.
    fn lines(&self) -> u64 {
        let [head, piece, tail] = [0, 1, 2].map(|index: usize| lines(&self.sections[index]));
        head + piece * self.times + tail
    }

    /// With about so many lines.
    fn of_lines(&self, wanted: u64) -> Self {
        Self { times: wanted / lines(&self.sections[1]), ..self.clone() }
    }
}

impl Read for Repeated {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        while count < buffer.len() {
            if self.handed == self.line.len() && !self.next_line() {
                break;
            }
            let more = (buffer.len() - count).min(self.line.len() - self.handed);
            buffer[count..count + more].copy_from_slice(&self.line[self.handed..self.handed + more]);
            self.handed += more;
            count += more;
        }
        Ok(count)
    }
}

impl Seek for Repeated {
    /// To the beginning, and nowhere else.
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        match position {
            SeekFrom::Start(0) => (self.read, self.at, self.number, self.handed) = (0, 0, 0, 0),
            SeekFrom::Current(0) if (self.read, self.at) == (0, 0) => {}
            _ => return Err(io::Error::other("this text can be read from its beginning alone")),
        }
        self.line.clear();
        Ok(0)
    }
}

fn lines(text: &[u8]) -> u64 {
    text.iter().filter(|byte| **byte == b'\n').count() as u64
}

/// A part as often as wanted, and its program.
struct Long {
    config: Config,
    control: &'static dyn Control,
    data: Repeated,
    program: Repeated,
}

/// Times that the part is posted: the second and the third time have to give the same blocks.
const POSTED: usize = 4;

fn text(name: &str) -> String {
    fs::read_to_string(workspace().join("tests/data/works").join(name)).expect("a file")
}

/// The part with everything in it, but for the way home.
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
        let control = control::by_name(control).expect("a control");
        let config = starting_point(control).read_over(&SpinnerU5620::default(), &text("table.toml"));
        let config = Config { output_units: Some(Units::Millimetres), ..config.expect("a configuration") };
        let mut program = Vec::new();
        let job = post::Job { cl_name: "works.cls", config: &config, control, units: None };
        let report = post::<SpinnerU5620>(&job, &mut Cursor::new(part.repeat(POSTED)), &mut program).expect("it can");
        assert!(!report.failed, "{:?}", report.diagnostics);
        let begins = beginnings(&program);
        let piece = |index: usize| program[begins[index]..begins[index + 1]].to_vec();
        let name = control.spellings().name;
        let [second, third] = [1, 2].map(|index| without_numbers(name, &piece(index)));
        assert_eq!(second, third, "the part does not come again as it was");
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

    /// What the check of a program of about so many lines finds, how many there are, and the most memory that it takes.
    fn checked(&self, wanted: u64) -> (Checked, u64, usize) {
        let program = self.program.of_lines(wanted);
        self.beside(program.times, program)
    }

    /// The same for any program beside the part as often as that.
    fn beside(&self, times: u64, program: Repeated) -> (Checked, u64, usize) {
        let lines = program.lines();
        let data = Repeated { times, ..self.data.clone() };
        let job = Job { config: &self.config, control: self.control, units: None };
        let (checked, peak) = peak(|| check::<SpinnerU5620>(&job, data, program).expect("it can be read"));
        (checked, lines, peak)
    }
}

/// Where the part begins in a program: at the name of its first operation.
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

/// Blocks without their numbers.
fn without_numbers(control: &str, program: &[u8]) -> Vec<lexer::Content> {
    let control = Foreign::by_name(control).expect("a control");
    let lines = lexer::joined(control, std::str::from_utf8(program).expect("ASCII"));
    let content =
        |(_, text): (usize, String)| lexer::line(control, &text).unwrap_or_else(|why| panic!("{why}: {text}")).content;
    lines.into_iter().map(content).collect()
}

/// The same figures and no more memory, a hundred times as long.
fn stays(control: &str, part: &str, long: u64) {
    let part = Long::posted(control, part);
    let (few, short, least) = part.checked(long / 100);
    let (many, lines, most) = part.checked(long);
    assert!(few.outcome.passed() && many.outcome.passed(), "{control}: {:?}", many.outcome.findings);
    assert!(lines >= long * 99 / 100 && many.outcome.lines == lines && few.outcome.lines == short, "{lines}");
    assert!(most <= least + ALLOWANCE, "{control}: {least} bytes for {short} lines, {most} for {lines}");
}

#[test]
fn a_million_lines_take_no_more_memory_than_ten_thousand() {
    stays("linuxcnc", &floor(), 1_000_000);
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
fn nothing_that_a_program_may_hold_takes_more_as_it_comes_again() {
    for control in ["linuxcnc", "siemens", "heidenhain", "haas"] {
        stays(control, &works(), 40_000);
    }
}

/// Memory for what is wrong with a program: twenty findings of each of its kinds, and a line that is too long, bytes.
const FINDINGS: usize = 256 << 10;

#[test]
fn a_program_of_something_else_takes_no_more_however_long_it_is() {
    let part = Long::posted("linuxcnc", &works());
    let other = Long::posted("linuxcnc", &floor());
    let (few, short, least) = part.beside(5, other.program.of_lines(5_000));
    let (many, lines, most) = part.beside(5, other.program.of_lines(150_000));
    assert!(few.outcome.count > short / 2 && many.outcome.count > lines / 2, "{}", many.outcome.count);
    assert!(most <= least + ALLOWANCE, "{least} bytes for {short} lines, {most} for {lines}");
}

#[test]
fn lines_that_are_no_blocks_take_no_more_however_many_there_are() {
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
        let (_, short, least) = part.beside(5, garbage.of_lines(2_000));
        let (checked, lines, most) = part.beside(5, garbage.of_lines(20_000));
        assert!(checked.outcome.count > lines / 2, "{control}: {}", checked.outcome.count);
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
        let (checked, _, most) = part.beside(1, Repeated { times: HUNDRED, ..program });
        let findings = &checked.outcome.findings;
        assert!(findings.iter().any(|found| found.text.contains("longer than")), "{control}: {findings:?}");
        assert!(checked.outcome.count < 100, "{control}: {findings:?}");
        assert!(most < least + FINDINGS, "{control}: {least} bytes for what is right, {most}");
    }
}

#[test]
fn a_record_without_end_is_an_error_and_fills_no_memory() {
    let part = Long::posted("linuxcnc", &works());
    let sections = [part.data.sections[0].clone(), endless("GOTO/1.0,2.0,3.0,"), b"\n".to_vec()];
    let part = Long { data: Repeated { sections, ..Repeated::default() }, ..part };
    let (checked, _, most) = part.beside(HUNDRED, part.program.of_lines(1000));
    let fault = checked.fault.expect("it is no record");
    assert!(fault.text.contains("longer than") && most < 4 << 20, "{most} bytes, {fault:?}");
}

/// Pieces that make a hundred million bytes.
const HUNDRED: u64 = 2000;

/// A piece of a line that does not end.
fn endless(words: &str) -> Vec<u8> {
    words.repeat(50_000 / words.len()).into_bytes()
}
