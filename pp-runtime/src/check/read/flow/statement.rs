//! Statements that are no blocks: assignments, conditions, loops, jumps, subprograms, in the words of each form.

use super::super::facts::LineForm;
use super::super::text::{Cursor, whole};
use super::expression::Expression;
use super::variables::{Value, Variable, Variables};

/// Name of a label, a loop or a subprogram.
pub(super) type Label = Vec<u8>;

/// A statement.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum FlowStatement {
    Assign(Vec<(Variable, Value)>),
    /// The lines up to [`Else`](Self::Else) or [`EndIf`](Self::EndIf) are executed if it holds.
    If(Value, Label),
    Else(Label),
    EndIf(Label),
    /// The lines up to [`EndLoop`](Self::EndLoop) as long as it holds.
    While(Value, Label),
    /// Once, and again as long as it holds at the end.
    Do(Label),
    /// The end of [`Do`](Self::Do): the rounds end where it holds.
    Until(Value, Label),
    /// So many times.
    Repeat(Value, Label),
    /// For each whole step of a variable.
    For(Variable, Value, Value, Label),
    EndLoop(Label),
    /// To a label, if the condition holds.
    Jump(Value, Label),
    Label,
    Sub(Label),
    EndSub(Label),
    /// So many times; with values of local variables, where it has a level of its own.
    Call(Label, u32, Option<Vec<(Variable, Value)>>),
    /// The lines from a label to here so many times more.
    RepeatFrom(Label, u32),
    Return,
}

/// Local variables of the arguments of G65.
const ARGUMENTS: [(u8, u32); 21] = [
    (b'A', 1),
    (b'B', 2),
    (b'C', 3),
    (b'I', 4),
    (b'J', 5),
    (b'K', 6),
    (b'D', 7),
    (b'E', 8),
    (b'F', 9),
    (b'H', 11),
    (b'M', 13),
    (b'Q', 17),
    (b'R', 18),
    (b'S', 19),
    (b'T', 20),
    (b'U', 21),
    (b'V', 22),
    (b'W', 23),
    (b'X', 24),
    (b'Y', 25),
    (b'Z', 26),
];

/// The text of a line without its number, blanks and what follows a comment.
pub(super) fn bare(line: &[u8], form: LineForm) -> &[u8] {
    let line = line.trim_ascii();
    let line = line.strip_prefix(b"/").unwrap_or(line).trim_ascii_start();
    let digits = |text: &[u8]| text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    match (form, line) {
        (LineForm::Statements, _) => line[digits(line)..].trim_ascii_start(),
        (_, [b'N' | b'n', rest @ ..]) if digits(rest) > 0 => rest[digits(rest)..].trim_ascii_start(),
        _ => line,
    }
}

/// The statement that a line is; `None` if it is a block, or no statement that is understood.
pub(super) fn parse(line: &[u8], variables: &Variables) -> Option<FlowStatement> {
    let mut at = Cursor::new(bare(line, variables.form()));
    let statement = match variables.form() {
        LineForm::Letters => letters(&mut at, variables),
        LineForm::Keywords => keywords(&mut at, variables),
        LineForm::Statements => conversational(&mut at, variables),
    }?;
    let ended = at.ended() || matches!(at.peek(), Some(b'(' | b';'));
    ended.then_some(statement)
}

/// Whether a line has a label, which is the number of its block or its name.
pub(super) fn has_label(line: &[u8], label: &[u8], form: LineForm) -> bool {
    let text = line.trim_ascii();
    match form {
        LineForm::Letters => {
            let number = |prefix: u8| {
                let [first, rest @ ..] = text else { return None };
                let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
                let number = &rest[..digits];
                first.eq_ignore_ascii_case(&prefix).then(|| trimmed(number))
            };
            match label {
                [b'O', wanted @ ..] => [b'O', b':'].into_iter().filter_map(number).any(|found| found == wanted),
                _ => number(b'N') == Some(label),
            }
        }
        LineForm::Keywords => bare(text, form).strip_suffix(b":").is_some_and(|name| name.eq_ignore_ascii_case(label)),
        LineForm::Statements => {
            let mut at = Cursor::new(bare(text, form));
            at.word(b"LBL") && label_of(&mut at).is_some_and(|found| found == label)
        }
    }
}

/// A number without leading zeros.
fn trimmed(number: &[u8]) -> &[u8] {
    let zeros = number.iter().take_while(|byte| **byte == b'0').count();
    &number[zeros.min(number.len().saturating_sub(1))..]
}

/// A whole number as a label.
fn numbered(at: &mut Cursor<'_>) -> Option<Label> {
    Some(whole(at.spaced_number()?)?.to_string().into_bytes())
}

/// `IF [..] GOTO 5`, `#1=5`, `M98 P1000 L2`, `o100 while [..]`.
fn letters(at: &mut Cursor<'_>, variables: &Variables) -> Option<FlowStatement> {
    match at.peek()?.to_ascii_uppercase() {
        b'#' => assignments(at, variables),
        b'O' => o_word(at, variables),
        b'I' if at.word(b"IF") => {
            let condition = Expression::new(at, variables).signed()?;
            if jump(at) {
                return Some(FlowStatement::Jump(condition, numbered(at)?));
            }
            at.word(b"THEN").then_some(())?;
            let assigned = assignments(at, variables)?;
            match condition? {
                0.0 => Some(FlowStatement::Assign(Vec::new())),
                _ => Some(assigned),
            }
        }
        b'G' if jump(at) => Some(FlowStatement::Jump(Some(1.0), numbered(at)?)),
        b'W' if at.word(b"WHILE") => {
            let condition = Expression::new(at, variables).signed()?;
            at.literal(b"DO").then_some(())?;
            Some(FlowStatement::While(condition, numbered(at)?))
        }
        b'D' if at.literal(b"DO") => Some(FlowStatement::While(Some(1.0), numbered(at)?)),
        b'E' if at.literal(b"END") => Some(FlowStatement::EndLoop(numbered(at)?)),
        b'M' | b'G' => call(at, variables),
        _ => None,
    }
}

/// `GOTO`, after which a number may follow directly.
fn jump(at: &mut Cursor<'_>) -> bool {
    at.blanks();
    at.rest().len() > 4 && at.rest()[..4].eq_ignore_ascii_case(b"GOTO") && {
        at.skip(4);
        true
    }
}

/// `#1=5 #2=[#1+1]`, each of a variable that a program may set.
fn assignments(at: &mut Cursor<'_>, variables: &Variables) -> Option<FlowStatement> {
    let mut assigned = Vec::new();
    loop {
        at.blanks();
        if at.peek() != Some(b'#') {
            return (!assigned.is_empty()).then_some(FlowStatement::Assign(assigned));
        }
        let variable = variables.read(at).filter(|variable| variables.is_of_program(variable))?;
        at.blanks();
        at.take(b'=').then_some(())?;
        assigned.push((variable, Expression::new(at, variables).condition()?));
    }
}

/// `M98 P1000 L2`, `M97 P100`, `G65 P1000 A5.`, `M99`.
fn call(at: &mut Cursor<'_>, variables: &Variables) -> Option<FlowStatement> {
    let (letter, number) = at.letter_and_number()?;
    let code = (letter.to_ascii_uppercase(), whole(number)?);
    if code == (b'M', 99) {
        return Some(FlowStatement::Return);
    }
    let macro_call = code == (b'G', 65);
    if !macro_call && !matches!(code, (b'M', 97 | 98)) {
        return None;
    }
    let (mut program, mut times, mut arguments) = (None, 1, Vec::new());
    while !at.ended() && !matches!(at.peek(), Some(b'(' | b';')) {
        let letter = at.peek()?.to_ascii_uppercase();
        at.skip(1);
        let bare = is_bare_number(at);
        let value = Expression::new(at, variables).signed()?;
        match letter {
            b'P' => program = Some(value? as u32),
            b'L' => times = value? as u32,
            _ if macro_call => {
                let (_, number) = ARGUMENTS.into_iter().find(|(argument, _)| *argument == letter)?;
                // Without a point it counts least increments of the axis of this letter, or what a setting says.
                let counts = !b"DFHMST".contains(&letter) && variables.by_settings() && bare;
                arguments.push((format!("#{number}").into_bytes(), value.filter(|value| !counts || *value == 0.0)));
            }
            _ => return None,
        }
    }
    let label = if code == (b'M', 97) { format!("{}", program?) } else { format!("O{}", program?) };
    Some(FlowStatement::Call(label.into_bytes(), times, macro_call.then_some(arguments)))
}

/// Whether a number without a point comes next, which is no part of an expression.
fn is_bare_number(at: &Cursor<'_>) -> bool {
    let text = at.rest();
    let digits = text
        .iter()
        .skip_while(|byte| matches!(byte, b' ' | b'+' | b'-'))
        .take_while(|byte| !byte.is_ascii_alphabetic());
    let mut digits = digits.copied().take_while(|byte| *byte != b' ').peekable();
    digits.peek().is_some_and(u8::is_ascii_digit) && digits.all(|byte| byte.is_ascii_digit())
}

/// `o100 sub`, `o<part> call [5]`, `o5 if [..]`.
fn o_word(at: &mut Cursor<'_>, variables: &Variables) -> Option<FlowStatement> {
    at.skip(1);
    let label = if at.peek() == Some(b'<') {
        let end = at.rest().iter().position(|byte| *byte == b'>')?;
        let name = at.rest()[..end].to_ascii_lowercase();
        at.skip(end + 1);
        name
    } else {
        numbered(at)?
    };
    at.blanks();
    let word = at.letters().to_ascii_lowercase();
    let mut condition = || Expression::new(at, variables).signed();
    Some(match &word[..] {
        b"sub" => FlowStatement::Sub(label),
        b"endsub" => FlowStatement::EndSub(label),
        b"return" => FlowStatement::Return,
        b"if" => FlowStatement::If(condition()?, label),
        b"else" => FlowStatement::Else(label),
        b"endif" => FlowStatement::EndIf(label),
        b"do" => FlowStatement::Do(label),
        b"while" => FlowStatement::While(condition()?, label),
        b"repeat" => FlowStatement::Repeat(condition()?, label),
        b"endwhile" | b"endrepeat" => FlowStatement::EndLoop(label),
        b"call" => {
            let mut arguments = Vec::new();
            loop {
                at.blanks();
                if at.peek() != Some(b'[') {
                    break;
                }
                let value = Expression::new(at, variables).signed()?;
                arguments.push((format!("#{}", arguments.len() + 1).into_bytes(), value));
            }
            FlowStatement::Call(label, 1, Some(arguments))
        }
        _ => return None,
    })
}

/// `R1=5`, `IF R1<5`, `WHILE`, `FOR R1=0 TO 5`, `GOTOF NAME`, `NAME:`.
fn keywords(at: &mut Cursor<'_>, variables: &Variables) -> Option<FlowStatement> {
    let start = *at;
    let name = at.name().to_ascii_uppercase();
    let target = |at: &mut Cursor<'_>| {
        at.blanks();
        Some(at.name().to_ascii_uppercase()).filter(|name| !name.is_empty())
    };
    match &name[..] {
        b"IF" => {
            let condition = Expression::new(at, variables).condition()?;
            at.blanks();
            let jumps = [&b"GOTOF"[..], b"GOTOB", b"GOTO"].into_iter().any(|word| at.word(word));
            return Some(match jumps {
                true => FlowStatement::Jump(condition, target(at)?),
                false => FlowStatement::If(condition, Label::new()),
            });
        }
        b"ELSE" => return Some(FlowStatement::Else(Label::new())),
        b"ENDIF" => return Some(FlowStatement::EndIf(Label::new())),
        b"WHILE" => return Some(FlowStatement::While(Expression::new(at, variables).condition()?, Label::new())),
        b"LOOP" => return Some(FlowStatement::While(Some(1.0), Label::new())),
        b"REPEAT" => {
            at.blanks();
            return at.rest().is_empty().then(|| FlowStatement::Do(Label::new()));
        }
        b"UNTIL" => return Some(FlowStatement::Until(Expression::new(at, variables).condition()?, Label::new())),
        b"ENDWHILE" | b"ENDLOOP" | b"ENDFOR" => return Some(FlowStatement::EndLoop(Label::new())),
        b"FOR" => {
            at.blanks();
            let variable = variables.read(at)?;
            at.blanks();
            at.take(b'=').then_some(())?;
            let from = Expression::new(at, variables).condition()?;
            at.word(b"TO").then_some(())?;
            let to = Expression::new(at, variables).condition()?;
            return Some(FlowStatement::For(variable, from, to, Label::new()));
        }
        b"GOTOF" | b"GOTOB" | b"GOTO" => return Some(FlowStatement::Jump(Some(1.0), target(at)?)),
        b"DEF" => {
            at.blanks();
            matches!(&at.name().to_ascii_uppercase()[..], b"REAL" | b"INT").then_some(())?;
            let mut defined = Vec::new();
            loop {
                let name = target(at)?;
                let value = if at.take(b'=') { Expression::new(at, variables).condition()? } else { Some(0.0) };
                defined.push((name, value));
                at.blanks();
                if !at.take(b',') {
                    return Some(FlowStatement::Assign(defined));
                }
            }
        }
        _ => {}
    }
    if !name.is_empty() && at.take(b':') {
        return Some(FlowStatement::Label);
    }
    *at = start;
    let variable = variables.read(at)?;
    at.blanks();
    at.take(b'=').then_some(())?;
    Some(FlowStatement::Assign(vec![(variable, Expression::new(at, variables).condition()?)]))
}

/// `5`, `"NAME"` after LBL.
fn label_of(at: &mut Cursor<'_>) -> Option<Label> {
    at.blanks();
    if at.take(b'"') {
        let end = at.rest().iter().position(|byte| *byte == b'"')?;
        let name = [b"\"", &at.rest()[..end]].concat();
        at.skip(end + 1);
        return Some(name);
    }
    numbered(at)
}

/// `Q1 = Q2 + 5`, `FN 0: Q1 = +5`, `FN 9: IF +Q1 EQU +5 GOTO LBL 1`, `LBL 1`, `CALL LBL 1 REP 2`.
fn conversational(at: &mut Cursor<'_>, variables: &Variables) -> Option<FlowStatement> {
    if at.word(b"LBL") {
        let label = label_of(at)?;
        return Some(if label == b"0" { FlowStatement::Return } else { FlowStatement::Label });
    }
    if at.words("CALL LBL") {
        let label = label_of(at)?;
        at.blanks();
        if !at.literal(b"REP") {
            return Some(FlowStatement::Call(label, 1, None));
        }
        return Some(FlowStatement::RepeatFrom(label, whole(at.spaced_number()?)?));
    }
    if at.word(b"FN") {
        let function = whole(at.spaced_number()?)?;
        at.blanks();
        at.take(b':').then_some(())?;
        at.blanks();
        if let 9..=12 = function {
            at.word(b"IF").then_some(())?;
            let condition = Expression::new(at, variables).condition()?;
            at.words("GOTO LBL").then_some(())?;
            return Some(FlowStatement::Jump(condition, label_of(at)?));
        }
        (function <= 5).then_some(())?;
    }
    let variable = variables.read(at).filter(|variable| variables.is_of_program(variable))?;
    at.blanks();
    at.take(b'=').then_some(())?;
    // After a sum or a product its second operand has a sign of its own: `+Q1 + +5`.
    Some(FlowStatement::Assign(vec![(variable, Expression::new(at, variables).condition()?)]))
}
