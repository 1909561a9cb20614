//! Random contours with cutter compensation: what the post refuses, what the check finds, what the exact offset of this
//! test loses, and what the interpreter of LinuxCNC refuses, if it is installed.
//!
//! Each contour is posted for a tool that fits everywhere. The words of that program are the contour; then the same CL
//! data is posted, and the program checked, with a tool that may not fit:
//!
//! - post, check and exact offset agree,
//! - what LinuxCNC refuses the post refuses; it stops at some arcs after corners that it takes as straight on.
//!
//! Contours nearer to a threshold than a thousandth of a micrometre are listed and not judged. `PP_CONTOURS=N` sets the
//! number of contours, `PP_CONTOURS_SEED=S` the first seed.

mod exact;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control;
use pp_runtime::diag::Severity;
use tests::linuxcnc::installed;
use tests::linuxcnc::interpreter::interpret_with_diameter;
use tests::posting::{findings, written};
use tests::random::Random;
use tests::{environment, random};

use exact::{Outcome, contour_of, offset};

/// Number of contours in a test run.
const CONTOURS: u64 = 200;

/// Distance to a threshold below which a contour is not judged, mm.
const AT_THRESHOLD: f64 = 1e-6;

/// A contour as CL data, and the tool for it.
struct Case {
    cl: String,
    /// D holds the wear.
    of_centre: bool,
    /// Radius or largest wear, mm.
    offset_mm: f64,
}

impl Case {
    fn of(seed: u64) -> Self {
        let random = &mut random::Random::new(seed);
        let of_centre = random.chance(0.3);
        let offset_mm = (1000.0 * random.between(0.5, 8.0)).round() / 1000.0;
        let side = if random.chance(0.5) { "LEFT" } else { "RIGHT" };
        let mut cl =
            "UNITS/MM\nLOADTL/1\nSPINDL/RPM,3000,CLW\nFEDRAT/500,MMPM\nRAPID\nGOTO/0,0,20\nGOTO/0,0,-2\n".to_owned();
        let mut path = Path { random, here: [0.0; 2], heading: 0.0 };
        path.heading = path.random.between(0.0, 360.0);
        writeln!(cl, "CUTCOM/{side}").expect("text");
        path.line(&mut cl, [2.0, 20.0]);
        for _ in 0..1 + path.random.below(6) {
            path.turn();
            match path.random.below(5) {
                0 | 1 => path.arc(&mut cl),
                2 => path.line(&mut cl, [0.3, 6.0]),
                _ => path.line(&mut cl, [3.0, 40.0]),
            }
        }
        path.turn();
        cl += "CUTCOM/OFF\n";
        path.line(&mut cl, [2.0, 30.0]);
        let [x, y] = path.here;
        writeln!(cl, "RAPID\nGOTO/{x:.3},{y:.3},50").expect("text");
        Self { cl, of_centre, offset_mm }
    }

    /// A set-up with a tool of this radius, or of this largest wear.
    fn config(&self, offset_mm: f64) -> Config {
        let compensation = match self.of_centre {
            true => format!("path = 'centre'\nlargest_wear = {offset_mm}\n[tools]\n1 = {{ length = 100.0 }}\n"),
            false => format!("path = 'contour'\n[tools]\n1 = {{ length = 100.0, diameter = {} }}\n", 2.0 * offset_mm),
        };
        let text = format!("part_origin = [0.0, 0.0, 60.0]\nmode = 'axes'\n[compensation]\n{compensation}");
        let linuxcnc = control::by_name("linuxcnc").expect("a control");
        starting_point(linuxcnc)
            .read_over(&SpinnerU5620::default(), &text)
            .unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
    }

    /// The program with a tool of this size, or why it is refused.
    fn posted(&self, offset_mm: f64) -> Result<String, String> {
        let linuxcnc = control::by_name("linuxcnc").expect("a control");
        let (program, report) =
            written::<SpinnerU5620>(&self.config(offset_mm), linuxcnc, &self.cl).expect("it can run");
        match report.diagnostics.into_iter().find(|found| found.severity == Severity::Error) {
            Some(error) => Err(format!("line {}: {}", error.location.line, error.text)),
            None => Ok(program),
        }
    }

    /// What the check finds in a program for the tool of the case.
    fn found(&self, program: &str) -> Vec<String> {
        let linuxcnc = control::by_name("linuxcnc").expect("a control");
        findings::<SpinnerU5620>(&self.config(self.offset_mm), linuxcnc, &self.cl, program)
    }

    /// What LinuxCNC refuses with the tools of the case.
    fn refused_by_linuxcnc(&self, program: &str) -> Option<String> {
        let wears = if self.of_centre { &[2.0, -2.0][..] } else { &[2.0] };
        wears.iter().find_map(|wear| interpret_with_diameter(program, wear * self.offset_mm).err())
    }
}

/// A path in the plane that is being written as CL data.
struct Path<'r> {
    random: &'r mut Random,
    here: [f64; 2],
    /// Degrees.
    heading: f64,
}

impl Path<'_> {
    fn turn(&mut self) {
        self.heading += match self.random.below(5) {
            0 if self.random.chance(0.3) => self.random.between(-2.8, 2.8),
            0 => 0.0,
            1 => self.random.between(-20.0, 20.0),
            2 => 90.0 * self.random.sign(),
            _ => self.random.between(-150.0, 150.0),
        };
    }

    fn line(&mut self, cl: &mut String, [least, most]: [f64; 2]) {
        let (sine, cosine) = self.heading.to_radians().sin_cos();
        let length = self.random.between(least, most);
        self.here = [self.here[0] + length * cosine, self.here[1] + length * sine];
        writeln!(cl, "GOTO/{:.3},{:.3},-2", self.here[0], self.here[1]).expect("text");
    }

    fn arc(&mut self, cl: &mut String) {
        let (radius, degrees) = (self.random.between(0.5, 20.0), self.random.between(15.0, 200.0));
        let sense = self.random.sign();
        let across = |heading: f64| (heading + 90.0 * sense).to_radians().sin_cos();
        let (sine, cosine) = across(self.heading);
        let centre = [self.here[0] + radius * cosine, self.here[1] + radius * sine];
        writeln!(cl, "MOVARC/{:.6},{:.6},-2,0,0,{sense},{radius:.6},ANGLE,{degrees:.6}", centre[0], centre[1])
            .expect("text");
        self.heading += sense * degrees;
        let (sine, cosine) = across(self.heading);
        self.here = [centre[0] - radius * cosine, centre[1] - radius * sine];
        writeln!(cl, "GOTO/{:.6},{:.6},-2", self.here[0], self.here[1]).expect("text");
    }
}

/// What became of the contours.
#[derive(Debug, Default)]
struct Tally {
    posted: u32,
    refused: u32,
    refused_by_linuxcnc: u32,
    unfit: u32,
    at_threshold: Vec<u64>,
    /// Reasons of the post, without numbers.
    reasons: BTreeMap<String, u32>,
    wrong: Vec<String>,
}

impl Tally {
    fn add(&mut self, seed: u64, with_linuxcnc: bool) {
        let case = Case::of(seed);
        let Ok(program) = case.posted(1e-4) else { return self.unfit += 1 };
        let (side, contour) = contour_of(&program);
        let signs = if case.of_centre { &[1.0, -1.0][..] } else { &[1.0] };
        let outcomes = signs.iter().map(|sign| offset(&contour, sign * side * case.offset_mm));
        let Outcome { fits, margin_mm } = outcomes.fold(Outcome::FITS, Outcome::and);
        if margin_mm < AT_THRESHOLD {
            return self.at_threshold.push(seed);
        }
        let (posted, found) = (case.posted(case.offset_mm), case.found(&program));
        let linuxcnc = if with_linuxcnc { case.refused_by_linuxcnc(&program) } else { None };
        // The exact offset fits, and LinuxCNC stops all the same.
        let straight = posted.as_ref().is_err_and(|why| why.contains("as straight on"));
        let refused = !fits || straight && (linuxcnc.is_some() || !with_linuxcnc);
        let agree =
            posted.is_err() == refused && found.is_empty() != refused && (linuxcnc.is_none() || posted.is_err());
        if !agree {
            self.wrong.push(format!(
                "seed {seed}, {} {} mm, exact offset {} by {margin_mm:.6} mm\npost: {:?}\ncheck: {found:?}\nLinuxCNC: \
                 {linuxcnc:?}\n{}\n{program}",
                if case.of_centre { "wear" } else { "radius" },
                case.offset_mm,
                if fits { "fits" } else { "is trimmed" },
                posted.as_ref().err(),
                case.cl
            ));
        }
        self.refused_by_linuxcnc += u32::from(linuxcnc.is_some());
        match posted {
            Ok(_) => self.posted += 1,
            Err(why) => {
                self.refused += 1;
                let words: Vec<&str> =
                    why.split(' ').filter(|word| !word.contains(|c: char| c.is_ascii_digit())).collect();
                *self.reasons.entry(words.join(" ")).or_default() += 1;
            }
        }
    }
}

#[test]
fn what_the_tool_does_not_fit_into_is_refused_and_nothing_else() {
    let count = environment::number("PP_CONTOURS").unwrap_or(CONTOURS);
    let first = environment::number("PP_CONTOURS_SEED").unwrap_or(1);
    let with_linuxcnc = installed();
    let mut tally = Tally::default();
    (first..first + count).for_each(|seed| tally.add(seed, with_linuxcnc));
    let Tally { posted, refused, refused_by_linuxcnc, unfit, at_threshold, reasons, wrong } = &tally;
    println!("{count} contours: {posted} posted, {refused} refused, {refused_by_linuxcnc} refused by LinuxCNC");
    println!("no tool fits: {unfit}; at a threshold, not judged: {at_threshold:?}; reasons: {reasons:#?}");
    assert!(wrong.is_empty(), "{} of {count}\n{}", wrong.len(), wrong[..wrong.len().min(3)].join("\n\n"));
    let least = u32::try_from(count / 10).expect("a small number");
    assert!(*posted >= least && *refused >= least, "{tally:?}");
    assert!(!with_linuxcnc || *refused_by_linuxcnc >= least, "{tally:?}");
}
