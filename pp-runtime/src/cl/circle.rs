//! Records of arcs: CIRCLE in its three forms, MOVARC, and CATIA's TLON.

use super::args::{Args, skip_blanks};
use super::fault::{Fault, Span, quoted};
use super::number;
use super::parse::{argument_not_yet, needed, wrong_count};
use super::record::{Circle, CircleForm, Record, TangentArc};

/// Turns of one arc: deeper threads have fewer, and it bounds the chords.
const MOST_TURNS: u32 = 1000;

/// `x,y,z,i,j,k[,r[,t,f,d,e]][,TIMES,n]`.
pub(super) fn circle(name: &'static str, args: &mut Args<'_>) -> Result<Circle, Fault> {
    let at = args.all();
    let mut numbers = [0.0; 11];
    let mut found = 0;
    let mut times = 1;
    while let Some(arg) = args.next()? {
        if arg.is("TIMES") {
            let count = needed(name, args)?;
            times = count.integer()?;
            if !(1..=MOST_TURNS).contains(&times) {
                let text = format!("an arc has 1 to {MOST_TURNS} turns, not {times}");
                return Err(Fault::new("circle", count.at, text, "TIMES,1 is the arc itself"));
            }
            break;
        }
        let value = arg.number()?;
        if let Some(place) = numbers.get_mut(found) {
            *place = value;
        }
        found += 1;
    }
    let form = match found {
        6 => CircleForm::Six,
        7 => CircleForm::Seven,
        11 => CircleForm::Eleven,
        found => {
            return Err(Fault::new(
                "circle",
                at,
                format!("{name} has 6, 7 or 11 numbers, found {found}; the sense of the arc follows from their count"),
                "6 and 7 are counter-clockwise about i, j, k; 11 are clockwise",
            ));
        }
    };
    let [x, y, z, i, j, k, r, ..] = numbers;
    Ok(Circle {
        centre: [x, y, z],
        axis: [i, j, k],
        radius: (form != CircleForm::Six).then_some(r),
        form,
        times,
        angle: None,
        at,
    })
}

/// `x,y,z,i,j,k,r,ANGLE,degrees`.
pub(super) fn move_arc(name: &'static str, args: &mut Args<'_>) -> Result<Circle, Fault> {
    let at = args.all();
    let mut numbers = [0.0; 7];
    for place in &mut numbers {
        *place = needed(name, args)?.number()?;
    }
    let word = needed(name, args)?;
    if !word.is("ANGLE") {
        return Err(argument_not_yet(name, word));
    }
    let angle = needed(name, args)?;
    let degrees = angle.number()?;
    if !(degrees > 0.0 && degrees <= 360.0 * f64::from(MOST_TURNS)) {
        return Err(Fault::new(
            "circle",
            angle.at,
            format!("an arc of {} degrees is not understood", quoted(angle.text)),
            "an arc turns counter-clockwise about i, j, k by more than 0 and at most a thousand turns",
        ));
    }
    let [x, y, z, i, j, k, r] = numbers;
    Ok(Circle {
        centre: [x, y, z],
        axis: [i, j, k],
        radius: Some(r),
        form: CircleForm::Seven,
        times: 1,
        angle: Some(degrees),
        at,
    })
}

/// `,GOFWD/ (CIRCLE/ x,y,z,r),ON,[2,INTOF,](LINE/ x,y,z,x,y,z)`, behind TLON.
pub(super) fn tangent_arc<'a>(text: &[u8], from: usize) -> Result<Record<'a>, Fault> {
    let mut scan = Scan { text, at: from };
    scan.expect(",")?;
    scan.expect("GOFWD")?;
    scan.expect("/")?;
    let start = skip_blanks(text, scan.at);
    scan.expect("(")?;
    scan.expect("CIRCLE")?;
    scan.expect("/")?;
    let [x, y, z, radius] = scan.numbers()?;
    scan.expect(")")?;
    scan.expect(",")?;
    scan.expect("ON")?;
    scan.expect(",")?;
    let second = scan.accept("2");
    if second {
        scan.expect(",")?;
        scan.expect("INTOF")?;
        scan.expect(",")?;
    }
    scan.expect("(")?;
    scan.expect("LINE")?;
    scan.expect("/")?;
    let [a, b, c, d, e, f] = scan.numbers()?;
    scan.expect(")")?;
    if skip_blanks(text, scan.at) < text.len() {
        return Err(scan.unexpected("the end of the record"));
    }
    let at = Span { start, end: text.len() };
    let line = [[a, b, c], [d, e, f]];
    Ok(Record::TangentArc(TangentArc { centre: [x, y, z], radius, line, second, at }))
}

/// Walks over a nested record.
struct Scan<'t> {
    text: &'t [u8],
    at: usize,
}

impl Scan<'_> {
    fn accept(&mut self, token: &str) -> bool {
        let start = skip_blanks(self.text, self.at);
        let end = start + token.len();
        let found = self.text.get(start..end).is_some_and(|found| found.eq_ignore_ascii_case(token.as_bytes()));
        if found {
            self.at = end;
        }
        found
    }

    fn expect(&mut self, token: &str) -> Result<(), Fault> {
        if self.accept(token) { Ok(()) } else { Err(self.unexpected(&format!("`{token}`"))) }
    }

    /// Numbers with commas between them.
    fn numbers<const N: usize>(&mut self) -> Result<[f64; N], Fault> {
        let mut numbers = [0.0; N];
        for (index, place) in numbers.iter_mut().enumerate() {
            if index > 0 {
                self.expect(",")?;
            }
            let start = skip_blanks(self.text, self.at);
            match number::prefix(&self.text[start..]).filter(|(value, _)| value.is_finite()) {
                Some((value, used)) => (*place, self.at) = (value, start + used),
                None => return Err(self.unexpected("a number")),
            }
        }
        Ok(numbers)
    }

    #[cold]
    fn unexpected(&self, wanted: &str) -> Fault {
        let start = skip_blanks(self.text, self.at).min(self.text.len().saturating_sub(1));
        Fault::new(
            "TLON",
            Span { start, end: start + 1 },
            format!("TLON is not understood from here on: {wanted} is expected"),
            "the form known here is TLON,GOFWD/ (CIRCLE/ x,y,z,r),ON,(LINE/ x,y,z,x,y,z)",
        )
    }
}

/// `k,k..`: at least one number, no limit to their count.
pub(super) fn some_numbers(name: &'static str, args: &mut Args<'_>) -> Result<(), Fault> {
    match args.numbers(&mut [])? {
        0 => Err(wrong_count(name, "at least one number", 0, args)),
        _ => Ok(()),
    }
}
