//! Lines of a Heidenhain conversational program: a number, then words between blanks.

use super::super::meaning::NumberCounting;
use super::{Content, Line, Mark, Number, Token};

pub(super) fn line(text: &str) -> Result<Line, String> {
    let (number, rest) = text.trim_start().split_once(' ').ok_or("a line without its number")?;
    let number = number.parse().map_err(|_| "a line without its number".to_owned())?;
    let rest = rest.trim_start();
    let content = if let Some(comment) = rest.strip_prefix(';') {
        Content::Comment(comment.strip_prefix(' ').unwrap_or(comment).to_owned())
    } else if rest.starts_with("* ") || rest.starts_with("BLK FORM ") {
        Content::Mark(Mark::Remark)
    } else if rest.starts_with("BEGIN PGM ") {
        Content::Mark(Mark::Begin(inches(rest)?))
    } else if rest.starts_with("END PGM ") {
        inches(rest)?;
        Content::Mark(Mark::End)
    } else if ["FN ", "LBL ", "QL"].iter().any(|start| rest.starts_with(start)) {
        Content::Condition(rest.to_owned())
    } else {
        let block = rest.split(';').next().unwrap_or_default();
        let tokens: Vec<Token> = block.split(' ').filter(|piece| !piece.is_empty()).map(token).collect();
        if tokens.is_empty() {
            return Err("an empty line".to_owned());
        }
        Content::Block(tokens)
    };
    Ok(Line { number: Some(number), content })
}

fn inches(text: &str) -> Result<bool, String> {
    match text.rsplit(' ').next() {
        Some("MM") => Ok(false),
        Some("INCH") => Ok(true),
        _ => Err("a program without its unit".to_owned()),
    }
}

/// `X+12`, `IZ-2.4`, `Q200=+2`, `1`, `FMAX`, `DR+`.
fn token(piece: &str) -> Token {
    if let Some((number, "")) = Number::take(piece) {
        return Token::Number(number);
    }
    if let Some((name, value)) = piece.split_once('=')
        && let Some((number, "")) = Number::take(value)
    {
        return Token::Word { name: name.to_owned(), number, counting: NumberCounting::AsInForce };
    }
    let letters = piece.bytes().take_while(u8::is_ascii_uppercase).count();
    if letters > 0
        && let Some((number, "")) = Number::take(&piece[letters..])
    {
        let (counting, name) = match piece[..letters].strip_prefix('I') {
            Some(name) if !name.is_empty() => (NumberCounting::Incremental, name),
            _ => (NumberCounting::AsInForce, &piece[..letters]),
        };
        return Token::Word { name: name.to_owned(), number, counting };
    }
    Token::Name(piece.to_owned())
}
