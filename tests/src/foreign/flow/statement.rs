//! Lines into statements: what a line does to the order of execution.

use super::super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::expression::{Variables, is_parameter};

/// A line of a program.
#[derive(Debug)]
pub(super) struct FlowLine {
    /// Number, from 1.
    pub(super) number: usize,
    /// Text as it is written.
    pub(super) text: String,
    /// Block number or label to which a jump leads.
    pub(super) label: Option<String>,
    /// Code without label and comments; on ISO and Heidenhain without blanks where it is no block.
    pub(super) code: String,
    pub(super) statement: Statement,
}

/// What a line does. Texts hold values that are computed when the line is executed.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Statement {
    /// A block of the control, or a line of a guard.
    Block,
    /// No effect where it is executed: a label, a declaration of a program.
    Nothing,
    /// One or more variables and their values.
    Set(String),
    /// `DEF REAL A=5, B`.
    Declare(String),
    /// `FN 1: Q1 = +Q2 + +Q3`: the function, the variable, and the values.
    Function(u32, String, String),
    If(String),
    ElseIf(String),
    Else,
    EndIf,
    /// A loop while its condition holds.
    While(String),
    /// A loop without an end, or with its condition at the end.
    Loop,
    /// A loop with a number of runs.
    Repeat(String),
    /// `FOR A=1 TO 5`: the variable, the first and the last value.
    For(String, String, String),
    EndLoop,
    /// The end of a loop that runs again where its condition is as stated.
    EndLoopIf(String, bool),
    Break,
    Continue,
    /// A jump, with its condition.
    Jump(Option<String>, String, Direction),
    /// `IF [..] THEN #1=2`.
    IfThen(String, Box<Statement>),
    /// `CALL LBL 1 REP 2`: runs again from the label.
    RunAgain(String, u32),
    Call(Call),
    /// The beginning of a subprogram, which is passed over.
    Sub,
    EndSub,
    /// To the caller, with the text after the word.
    Return(String),
}

/// A call of a subprogram.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Call {
    /// Program number, block number or name.
    pub(super) name: String,
    /// Within the program: the name is that of a block or a label.
    pub(super) inside: bool,
    /// Number of runs; one without it.
    pub(super) times: Option<String>,
    /// Text of the arguments; `None` where the subprogram shares the variables of its caller.
    pub(super) arguments: Option<String>,
}

/// Where the label of a jump is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    Forward,
    Backward,
    /// Forward, then from the beginning.
    Around,
}

/// The statement of each line.
pub(super) fn lines(control: Control, joined: Vec<(usize, String)>, variables: &mut Variables) -> Vec<FlowLine> {
    let mut lines: Vec<FlowLine> = Vec::new();
    let codes: Vec<(Option<String>, String)> = joined.iter().map(|(_, text)| code(control, text)).collect();
    let programs: Vec<String> = codes.iter().filter_map(|(_, code)| program(control, code)).collect();
    for ((number, text), (label, code)) in joined.into_iter().zip(codes) {
        if control == Siemens
            && let Some(declaration) = code.strip_prefix("DEF ").or_else(|| code.strip_prefix("PROC "))
        {
            declare(declaration, variables);
        }
        let mut statement = match control {
            LinuxCnc => linuxcnc(&code),
            Fanuc | Haas => fanuc(control, &code),
            Siemens => siemens(&code, &programs, variables),
            Heidenhain => heidenhain(&code),
        };
        let mut label = label;
        if control == LinuxCnc {
            label = o_word(&code).map(|(name, _)| name.to_owned());
            if let Statement::While(condition) = &statement
                && is_end_of_do(&lines, &label)
            {
                statement = Statement::EndLoopIf(condition.clone(), true);
            }
        } else if matches!(control, Fanuc | Haas)
            && matches!(statement, Statement::EndLoop | Statement::While(_) | Statement::Loop)
        {
            label = code.rfind(['O', 'D']).map(|place| code[place + 1..].to_owned());
        } else if control == Heidenhain && statement == Statement::Nothing {
            label = code.strip_prefix("LBL").map(str::to_owned);
        }
        let bare = code.is_empty() && label.is_some();
        statement = if bare && statement == Statement::Block { Statement::Nothing } else { statement };
        lines.push(FlowLine { number, text, label, code, statement });
    }
    lines
}

/// Whether the last loop of this label is a DO that has not ended.
fn is_end_of_do(lines: &[FlowLine], label: &Option<String>) -> bool {
    let of_loop = |line: &&FlowLine| {
        line.label == *label
            && matches!(line.statement, Statement::Loop | Statement::EndLoop | Statement::EndLoopIf(..))
    };
    lines.iter().rev().find(of_loop).is_some_and(|line| line.statement == Statement::Loop)
}

/// Label and code of a line.
fn code(control: Control, text: &str) -> (Option<String>, String) {
    match control {
        LinuxCnc | Fanuc | Haas => {
            let mut code = String::new();
            let mut inside = false;
            for letter in text.chars() {
                match letter {
                    '(' => inside = true,
                    ')' => inside = false,
                    _ if inside || letter.is_whitespace() => {}
                    ';' => break,
                    _ => code.push(letter.to_ascii_uppercase()),
                }
            }
            number(&code)
        }
        Siemens => {
            let mut code = String::new();
            let mut quoted = false;
            for letter in text.chars() {
                quoted ^= letter == '"';
                if letter == ';' && !quoted {
                    break;
                }
                code.push(if quoted { letter } else { letter.to_ascii_uppercase() });
            }
            let (label, code) = number(code.trim());
            let colon = code.split_once(':').filter(|(name, _)| {
                name.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
                    && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
            });
            match colon {
                Some((name, rest)) => (Some(name.to_owned()), rest.trim().to_owned()),
                None => (label.map(|label| format!("N{label}")), code.trim().to_owned()),
            }
        }
        Heidenhain => {
            let rest = text.trim_start().split_once(' ').map_or("", |(_, rest)| rest);
            let rest = rest.split(';').next().unwrap_or_default().trim().to_owned();
            let flow = ["FN ", "LBL ", "CALL LBL ", "CALL PGM "].iter().any(|start| rest.starts_with(start))
                || rest.split(['=', ' ']).next().is_some_and(is_parameter);
            (None, if flow { rest.replace(' ', "") } else { rest })
        }
    }
}

/// Takes a block number off the beginning.
fn number(code: &str) -> (Option<String>, String) {
    let digits = code.strip_prefix('N').unwrap_or_default().bytes().take_while(u8::is_ascii_digit).count();
    if digits == 0 {
        return (None, code.to_owned());
    }
    let label = code[1..=digits].trim_start_matches('0').to_owned();
    (Some(label), code[1 + digits..].to_owned())
}

/// Name of the program that begins here.
pub(super) fn program(control: Control, code: &str) -> Option<String> {
    match control {
        Fanuc | Haas => {
            let digits = code.strip_prefix('O')?;
            let number: u32 = digits.parse().ok()?;
            Some(number.to_string())
        }
        Siemens => {
            let name = code.strip_prefix("PROC ").map(|rest| rest.split('(').next().unwrap_or_default().trim());
            let name = name.map(|name| name.split(' ').next().unwrap_or_default());
            let file = code.strip_prefix("%_N_").and_then(|name| name.strip_suffix("_SPF"));
            name.or(file).map(str::to_owned)
        }
        LinuxCnc | Heidenhain => None,
    }
}

/// Names of `REAL A=5, B` or of the parameters `NAME(REAL A, INT B)`.
fn declare(text: &str, variables: &mut Variables) {
    let mut whole = false;
    for part in text.split(['(', ',', ')']) {
        let mut words = part.split('=').next().unwrap_or_default().split_whitespace().peekable();
        if let Some(kind) = words.next_if(|word| matches!(*word, "REAL" | "INT" | "BOOL")) {
            whole = kind == "INT";
        }
        if let Some(name) = words.next() {
            variables.declared.insert(name.to_owned());
            if whole {
                variables.whole.insert(name.to_owned());
            }
        }
    }
}

/// Label and word of `O100IF[..]`, `O<NAME>CALL[..]`.
fn o_word(code: &str) -> Option<(&str, &str)> {
    let rest = code.strip_prefix('O')?;
    let length = match rest.strip_prefix('<') {
        Some(name) => name.find('>')? + 2,
        None => rest.bytes().take_while(u8::is_ascii_digit).count(),
    };
    (length > 0).then(|| rest.split_at(length))
}

fn linuxcnc(code: &str) -> Statement {
    if code.starts_with('#') {
        return Statement::Set(code.to_owned());
    }
    let Some((name, word)) = o_word(code) else { return Statement::Block };
    let after = |start: &str| word.strip_prefix(start).map(str::to_owned);
    if let Some(value) = after("IF") {
        Statement::If(value)
    } else if let Some(value) = after("ELSEIF") {
        Statement::ElseIf(value)
    } else if let Some(value) = after("WHILE") {
        Statement::While(value)
    } else if let Some(value) = after("REPEAT") {
        Statement::Repeat(value)
    } else if let Some(value) = after("CALL") {
        Statement::Call(Call { name: name.to_owned(), inside: false, times: None, arguments: Some(value) })
    } else if let Some(value) = after("RETURN") {
        Statement::Return(value)
    } else if word.starts_with("ENDSUB") {
        Statement::EndSub
    } else {
        match word {
            "ELSE" => Statement::Else,
            "ENDIF" => Statement::EndIf,
            "ENDWHILE" | "ENDREPEAT" => Statement::EndLoop,
            "DO" => Statement::Loop,
            "BREAK" => Statement::Break,
            "CONTINUE" => Statement::Continue,
            "SUB" => Statement::Sub,
            _ => Statement::Block,
        }
    }
}

/// Letters and their values; values may be in brackets.
pub(super) fn letters(code: &str) -> Vec<(char, String)> {
    let mut letters: Vec<(char, String)> = Vec::new();
    let mut depth = 0;
    for letter in code.chars() {
        match letter {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        match letters.last_mut() {
            Some((_, value)) if depth > 0 || !letter.is_ascii_alphabetic() => value.push(letter),
            _ => letters.push((letter, String::new())),
        }
    }
    letters
}

/// End of the bracket with which a text begins.
fn bracket(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    for (place, letter) in text.char_indices() {
        match letter {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (place > 0).then(|| text.split_at(place + 1));
        }
    }
    None
}

fn fanuc(control: Control, code: &str) -> Statement {
    if code.starts_with('#') {
        return Statement::Set(code.to_owned());
    }
    if let Some((condition, rest)) = code.strip_prefix("IF").and_then(bracket) {
        let condition = condition.to_owned();
        return match (rest.strip_prefix("GOTO"), rest.strip_prefix("THEN")) {
            (Some(label), _) => Statement::Jump(Some(condition), label.to_owned(), Direction::Around),
            (_, Some(set)) if set.starts_with('#') => {
                Statement::IfThen(condition, Box::new(Statement::Set(set.to_owned())))
            }
            _ => Statement::Block,
        };
    }
    if let Some((condition, rest)) = code.strip_prefix("WHILE").and_then(bracket)
        && rest.starts_with("DO")
    {
        return Statement::While(condition.to_owned());
    }
    if let Some(label) = code.strip_prefix("GOTO") {
        return Statement::Jump(None, label.to_owned(), Direction::Around);
    }
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if code.strip_prefix("END").is_some_and(is_number) {
        return Statement::EndLoop;
    }
    if code.strip_prefix("DO").is_some_and(is_number) {
        return Statement::Loop;
    }
    if let Some(rest) = code.strip_prefix("M99")
        && (rest.is_empty() || rest.starts_with('P'))
    {
        return Statement::Return(rest.trim_start_matches('P').to_owned());
    }
    fanuc_call(control, code).map_or(Statement::Block, Statement::Call)
}

/// `M98 P1000 L2`, `M97 P100 L2` (Haas), `G65 P1000 L2 A1.5 B2.`.
fn fanuc_call(control: Control, code: &str) -> Option<Call> {
    let macro_call = code.strip_prefix("G65");
    let inside = code.strip_prefix("M97").filter(|_| control == Haas);
    let rest = macro_call.or(inside).or_else(|| code.strip_prefix("M98"))?;
    let rest = rest.strip_prefix('P')?;
    let words = letters(&format!("P{rest}"));
    let (_, name) = words.first()?;
    let times = words.iter().find(|(letter, _)| *letter == 'L').map(|(_, value)| value.clone());
    let others = words.iter().skip(1).filter(|(letter, _)| *letter != 'L');
    let others: String = others.map(|(letter, value)| format!("{letter}{value}")).collect();
    (macro_call.is_some() || others.is_empty()).then(|| Call {
        name: name.clone(),
        inside: inside.is_some(),
        times,
        arguments: macro_call.map(|_| others),
    })
}

fn siemens(code: &str, programs: &[String], variables: &Variables) -> Statement {
    let after = |start: &str| code.strip_prefix(start).map(|rest| rest.trim().to_owned());
    let jump = |text: &str, condition: Option<String>| {
        let (word, label) = text.trim().split_once(' ')?;
        let direction = match word {
            "GOTOF" => Direction::Forward,
            "GOTOB" => Direction::Backward,
            "GOTO" => Direction::Around,
            _ => return None,
        };
        Some(Statement::Jump(condition, label.trim().to_owned(), direction))
    };
    let name = code.split(['=', '(', '[', ' ']).next().unwrap_or_default();
    let is_call = |name: &str| programs.iter().any(|program| program == name);
    if let Some(condition) = after("IF ").or_else(|| after("IF(").map(|rest| format!("({rest}"))) {
        return match condition.find(" GOTO") {
            Some(place) => jump(&condition[place..], Some(condition[..place].to_owned())).unwrap_or(Statement::Block),
            None => Statement::If(condition),
        };
    }
    if let Some(condition) = after("WHILE ").or_else(|| after("WHILE(").map(|rest| format!("({rest}"))) {
        return Statement::While(condition);
    }
    if let Some(condition) = after("UNTIL ").or_else(|| after("UNTIL(").map(|rest| format!("({rest}"))) {
        return Statement::EndLoopIf(condition, false);
    }
    if let Some(rest) = after("FOR ")
        && let Some((from, to)) = rest.split_once(" TO ")
        && let Some((variable, from)) = from.split_once('=')
    {
        return Statement::For(variable.trim().to_owned(), from.to_owned(), to.to_owned());
    }
    if let Some(jump) = jump(code, None) {
        return jump;
    }
    if let Some(rest) = after("DEF ") {
        return Statement::Declare(rest);
    }
    if code.starts_with("EXTERN ") {
        return Statement::Nothing;
    }
    match code {
        "ELSE" => return Statement::Else,
        "ENDIF" => return Statement::EndIf,
        "ENDWHILE" | "ENDFOR" | "ENDLOOP" => return Statement::EndLoop,
        "REPEAT" | "LOOP" => return Statement::Loop,
        "RET" | "M17" => return Statement::Return(String::new()),
        _ => {}
    }
    let parameter = name.strip_prefix('R').is_some_and(|digits| digits.bytes().all(|digit| digit.is_ascii_digit()));
    if (parameter || variables.declared.contains(name)) && code.contains('=') && !name.is_empty() {
        return Statement::Set(code.to_owned());
    }
    if is_call(name) {
        let rest = code[name.len()..].trim();
        let (times, arguments) = match rest.strip_prefix('P') {
            Some(times) => (Some(times.trim_start_matches('=').to_owned()), String::new()),
            None => (None, rest.to_owned()),
        };
        return Statement::Call(Call { name: name.to_owned(), inside: false, times, arguments: Some(arguments) });
    }
    Statement::Block
}

/// Functions of Heidenhain that jump, with their words and the operators that mean the same here.
const JUMPS: [(u32, &str); 4] = [(9, "EQU"), (10, "NE"), (11, "GT"), (12, "LT")];

fn heidenhain(code: &str) -> Statement {
    if let Some(rest) = code.strip_prefix("FN") {
        let Some((function, rest)) = rest.split_once(':') else { return Statement::Block };
        let Ok(function) = function.parse::<u32>() else { return Statement::Block };
        if JUMPS.iter().any(|(number, _)| *number == function) {
            let jump = rest.strip_prefix("IF").and_then(|rest| rest.split_once("GOTOLBL"));
            return match jump {
                Some((condition, label)) => {
                    Statement::Jump(Some(format!("{function}:{condition}")), label.to_owned(), Direction::Around)
                }
                None => Statement::Block,
            };
        }
        return match rest.split_once('=') {
            Some((name, values)) if function <= 8 => Statement::Function(function, name.to_owned(), values.to_owned()),
            _ => Statement::Block,
        };
    }
    if let Some(call) = code.strip_prefix("CALLLBL") {
        if let Some((label, times)) = call.split_once("REP") {
            let times = times.split('/').next().unwrap_or_default();
            return times.parse().map_or(Statement::Block, |times| Statement::RunAgain(label.to_owned(), times));
        }
        return Statement::Call(Call { name: call.to_owned(), inside: true, times: None, arguments: None });
    }
    if code == "LBL0" {
        return Statement::Return(String::new());
    }
    if code.starts_with("LBL") {
        return Statement::Nothing;
    }
    match code.split_once('=') {
        Some((name, _)) if is_parameter(name) => Statement::Set(code.to_owned()),
        _ => Statement::Block,
    }
}
