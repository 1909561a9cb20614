//! Refusal of untidy text: what a control would run, and no program of ours contains.

use super::super::Control;

/// Longest line of LinuxCNC, bytes.
const LONGEST: usize = 255;

/// Refuses a line that is not in the form in which programs are posted: two blanks, a blank at an end, lower case, an
/// exponent, `-0`, `X.5`, `X01`, `X1.50`.
///
/// `pointed`: whole lengths end in their point on every control, as `X1.`.
///
/// # Errors
/// With the piece that is untidy.
pub fn check(control: Control, text: &str, pointed: bool) -> Result<(), String> {
    let comment = match control {
        Control::LinuxCnc | Control::Fanuc | Control::Haas => text.starts_with('('),
        Control::Siemens => text.starts_with(';') || text.starts_with("MSG("),
        Control::Heidenhain => text.split_once(' ').is_some_and(|(_, rest)| rest.starts_with([';', '*'])),
    };
    if text.bytes().any(|byte| !(0x20..=0x7e).contains(&byte)) {
        return Err("a byte that is not printable ASCII".to_owned());
    }
    if control == Control::LinuxCnc && text.len() > LONGEST {
        return Err("the line is too long".to_owned());
    }
    if comment && control == Control::LinuxCnc && is_order(text) {
        return Err("a comment that is an order to the control".to_owned());
    }
    if comment || text == "%" || free_form(control, text) {
        return Ok(());
    }
    match control {
        Control::LinuxCnc => {
            text.split(' ').try_for_each(|piece| word(piece, if pointed { with_point } else { shortest }))
        }
        Control::Fanuc | Control::Haas => text.split(' ').try_for_each(|piece| word(piece, with_point)),
        Control::Siemens => {
            text.split(' ').try_for_each(|piece| siemens(piece, if pointed { with_point } else { shortest }))
        }
        Control::Heidenhain => heidenhain(text, pointed),
    }
}

/// `(py, ..)`, `(probeopen ..)`, `(logclose)`: orders of LinuxCNC in the form of a comment; `(MSG, ..)` shows its text,
/// and `(abort, ..)` belongs to a guard.
fn is_order(text: &str) -> bool {
    let text = text.trim_start_matches('(').trim_start().to_ascii_lowercase();
    let name: String = text.chars().take_while(char::is_ascii_alphabetic).collect();
    let comma = text[name.len()..].trim_start().starts_with(',');
    comma && !matches!(&*name, "" | "msg" | "abort") || name.starts_with("probe") || name.starts_with("log")
}

/// Lines whose form the guards and the file marks check themselves.
fn free_form(control: Control, text: &str) -> bool {
    match control {
        Control::LinuxCnc => text.starts_with('o'),
        Control::Fanuc | Control::Haas => text.starts_with(['I', 'O']),
        Control::Siemens => text.starts_with("IF ") || text.starts_with("%_N_"),
        Control::Heidenhain => text.split_once(' ').is_some_and(|(_, rest)| {
            ["FN ", "LBL ", "QL3 ", "BEGIN PGM ", "END PGM ", "BLK FORM "].iter().any(|start| rest.starts_with(start))
        }),
    }
}

/// One upper-case letter and a number.
fn word(piece: &str, number: fn(char, &str) -> bool) -> Result<(), String> {
    let mut characters = piece.chars();
    let letter = characters.next().ok_or("an empty line, or a blank too many")?;
    if letter.is_ascii_uppercase() && number(letter, characters.as_str()) {
        Ok(())
    } else {
        Err(format!("`{piece}` is not a letter with a number in its shortest form"))
    }
}

/// A number in its shortest form.
fn shortest(_: char, number: &str) -> bool {
    digits(number, false) && number != "-0"
}

/// A number that may end in its point; codes may have two digits, as on Fanuc and Haas.
fn with_point(letter: char, number: &str) -> bool {
    let number = match number.strip_prefix('0') {
        Some(rest) if matches!(letter, 'G' | 'M') && rest.starts_with(|digit: char| digit.is_ascii_digit()) => rest,
        _ => number,
    };
    digits(number, true) && number != "-0" && number != "-0."
}

fn digits(number: &str, ends_in_point: bool) -> bool {
    let digits = number.strip_prefix('-').unwrap_or(number);
    let (whole, fraction) = digits.split_once('.').map_or((digits, None), |(whole, fraction)| (whole, Some(fraction)));
    !whole.is_empty()
        && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.')
        && (whole == "0" || !whole.starts_with('0'))
        && fraction.is_none_or(|fraction| {
            (ends_in_point || !fraction.is_empty()) && !fraction.ends_with('0') && !fraction.contains('.')
        })
}

/// A word, `NAME=value`, a name, or a call.
fn siemens(piece: &str, shortest: fn(char, &str) -> bool) -> Result<(), String> {
    let untidy = || format!("`{piece}` is not a word, a name or a call in its shortest form");
    if let Some((name, arguments)) = piece.split_once('(')
        && !name.contains('=')
    {
        let inside = arguments.strip_suffix(')').ok_or_else(untidy)?;
        let tidy = |argument: &str| argument.is_empty() || argument.starts_with('"') || shortest(' ', argument);
        return if inside.split(',').all(tidy) { Ok(()) } else { Err(untidy()) };
    }
    let number = piece.split_once('=').map(|(_, value)| value).or_else(|| {
        let letters = piece.bytes().take_while(u8::is_ascii_uppercase).count();
        (letters == 1).then(|| &piece[1..])
    });
    let number = number.map(|number| {
        let inside = ["AC(", "DC(", "IC("].iter().find_map(|counts| number.strip_prefix(counts));
        inside.and_then(|inside| inside.strip_suffix(')')).unwrap_or(number)
    });
    let name = !piece.is_empty() && piece.bytes().all(|byte| byte.is_ascii_uppercase());
    if number.map_or(name, |number| shortest(' ', number)) { Ok(()) } else { Err(untidy()) }
}

/// A number, then words and names with one blank between two; parameters of a cycle on lines of their own.
fn heidenhain(text: &str, pointed: bool) -> Result<(), String> {
    let parameter = text.starts_with("  Q");
    let text = if parameter { &text[2..] } else { text };
    if parameter && text.split(" ;").next().is_some_and(|block| block.contains(' ')) || text.contains("~ ") {
        return Err("a line with more than one parameter".to_owned());
    }
    let block = text.split(';').next().unwrap_or_default();
    let block = if block.len() < text.len() { block.strip_suffix(' ').unwrap_or(block) } else { block };
    let piece = |piece: &str| {
        let value = piece.split_once('=').map_or(piece, |(_, value)| value);
        let number = value.trim_start_matches(|letter: char| letter.is_ascii_uppercase());
        let signed = number.strip_prefix(['+', '-']).unwrap_or(number);
        let name = number.is_empty() || piece.len() > number.len() && signed.is_empty();
        let zero = signed == "0" && number.starts_with('-');
        // The parts of an old cycle: `CYCL DEF 9.0`, `CYCL DEF 32.2 HSC-MODE:0`.
        let part = piece.strip_suffix(".0").is_some_and(|cycle| cycle.parse::<u32>().is_ok())
            || piece.strip_prefix("HSC-MODE:").is_some_and(|mode| matches!(mode, "0" | "1"));
        let symbol = !number.starts_with(['+', '-']) && !number.starts_with(|digit: char| digit.is_ascii_digit());
        let tidy = !piece.is_empty()
            && (name || symbol || part || digits(signed, pointed) && !signed.starts_with('-') && !zero);
        if tidy { Ok(()) } else { Err(format!("`{piece}` is not a word in its shortest form")) }
    };
    let mut pieces: Vec<&str> = block.split(' ').collect();
    pieces.iter().try_for_each(|text| piece(text))?;
    pieces.sort_unstable();
    let twice = pieces
        .windows(2)
        .any(|pair| pair[0] == pair[1] && pair[0].starts_with(|letter: char| letter.is_ascii_uppercase()));
    if twice && !block.contains(" FUNCTION ") && !block.starts_with("FUNCTION ") {
        Err("a word twice".to_owned())
    } else {
        Ok(())
    }
}
