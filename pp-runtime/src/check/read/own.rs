//! Lines that the user brings in: their texts, their places, and their effects.
//!
//! A line that the table reads without a fault has the effect of its codes, whoever wrote it. A line or a word that the
//! table does not have is executed by the effect that `[control] effects` declares for it, and only in a line of the
//! configuration; clamp, coolant and tip control codes have the effect of their keys.

use std::collections::HashMap;
use std::sync::Arc;

use super::block::{Effect, OwnLine, OwnPlace, OwnValues, WorkPlane};
use super::facts::{Facts, LineForm};
use super::line::Line;
use super::orders::{Act, ModeOrder, effect};
use super::text::{GOES_ON, shown, take_marks_away};
use super::{InMemory, Reader, Vocabulary};

/// A line of the configuration.
#[derive(Debug, Clone)]
pub(crate) struct OwnText {
    /// The line, with fields in braces.
    pub(crate) text: Vec<u8>,
    pub(crate) place: OwnPlace,
    /// Kinds of a coolant code, and whether it switches them on.
    pub(crate) coolant: Option<(u8, bool)>,
}

/// What is declared for a line: the effect, and its bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Declared {
    effect: Effect,
    bits: u8,
    /// The line is declared as a whole.
    whole: bool,
}

/// Text of a line without its block number and its comments, and buffers for it.
#[derive(Debug, Clone, Default)]
pub(super) struct Bare {
    /// The line, with blanks in the place of number and comments.
    masked: Vec<u8>,
    /// Its words, one blank apart.
    text: Vec<u8>,
    current: bool,
}

impl Bare {
    /// Another line has come.
    pub(super) fn forget(&mut self) {
        self.current = false;
    }

    /// The text of the line; found once for each line.
    pub(super) fn text(&mut self, line: &[u8], facts: &Facts) -> &[u8] {
        if !self.current {
            self.find(line, number_end(line, facts), facts);
        }
        &self.text
    }

    fn find(&mut self, line: &[u8], number: usize, facts: &Facts) {
        self.masked.clear();
        self.masked.extend_from_slice(line);
        self.masked[..number].fill(b' ');
        take_marks_away(&mut self.masked);
        comments(line, facts, &mut self.masked);
        if self.masked.trim_ascii().is_empty() {
            // A comment alone may be a line of the configuration.
            self.masked[number..].copy_from_slice(&line[number..]);
        }
        self.text.clear();
        for word in self.masked.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
            if !self.text.is_empty() {
                self.text.push(b' ');
            }
            self.text.extend_from_slice(word);
        }
        self.current = true;
    }
}

/// End of the block number with which a line begins, 0 if it has none.
fn number_end(line: &[u8], facts: &Facts) -> usize {
    let start = line.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(line.len());
    let statement = facts.form == LineForm::Statements;
    let letter = usize::from(!statement && matches!(line.get(start), Some(b'N' | b'n')));
    let digits = line[start + letter..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let end = start + letter + digits;
    let closed = match line.get(end) {
        None => true,
        Some(next) if statement => next.is_ascii_whitespace(),
        Some(next) => !matches!(next, b'.' | b'=' | b'_'),
    };
    if digits > 0 && (letter == 1 || statement) && closed { end } else { 0 }
}

/// Puts blanks in the place of comments; what is no whole comment stays.
fn comments(line: &[u8], facts: &Facts, masked: &mut [u8]) {
    let brackets = facts.form == LineForm::Letters;
    let (mut at, mut quoted) = (0, false);
    while let Some(byte) = line.get(at) {
        quoted ^= *byte == b'"' && !brackets;
        let rest = &line[at + 1..];
        let length = match byte {
            b'(' if brackets => rest.iter().position(|byte| matches!(byte, b'(' | b')')).map(|end| end + 2),
            b';' if !quoted && (facts.semicolon_comments || rest.trim_ascii().is_empty()) => {
                // The mark of a line that goes on is no part of it.
                Some(rest.iter().position(|byte| *byte == GOES_ON).unwrap_or(rest.len()) + 1)
            }
            _ => None,
        };
        let whole = length.filter(|length| *byte == b';' || line[at + length - 1] == b')');
        if let Some(length) = whole {
            masked[at..at + length].fill(b' ');
        }
        at += whole.unwrap_or(1);
    }
}

/// Where texts are found: those without a field by what they are, those with fields one by one.
#[derive(Debug, Clone, Default)]
struct ByText {
    plain: HashMap<Vec<u8>, Vec<usize>>,
    with_fields: Vec<usize>,
}

impl ByText {
    /// Of a text that comes again for the same, the first place.
    fn of<'a, T: PartialEq>(texts: impl Iterator<Item = (&'a [u8], T)>) -> Self {
        let mut found = Self::default();
        let mut known: HashMap<&[u8], Vec<T>> = HashMap::new();
        for (index, (text, of)) in texts.enumerate() {
            let others = known.entry(text).or_default();
            if others.contains(&of) {
                continue;
            }
            others.push(of);
            match text.contains(&b'{') {
                true => found.with_fields.push(index),
                false => found.plain.entry(text.to_vec()).or_default().push(index),
            }
        }
        found
    }

    /// Places of a text without fields.
    fn same(&self, text: &[u8]) -> impl Iterator<Item = usize> + Clone {
        self.plain.get(text).into_iter().flatten().copied()
    }

    /// Places of the texts that may be a line: the same, and those with fields.
    fn possible(&self, line: &[u8]) -> impl Iterator<Item = usize> + Clone {
        self.same(line).chain(self.with_fields.iter().copied())
    }
}

/// Where the texts of a vocabulary are found.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lookup {
    own: ByText,
    effects: ByText,
    /// Codes of the shop in the place of the control's own.
    switches: Vec<usize>,
}

impl Vocabulary {
    /// The control's own words and the names of axes and tools, without anything of the shop.
    pub(super) fn without_shop(&self) -> Self {
        Self {
            axes: self.axes.clone(),
            own: Vec::new(),
            effects: Vec::new(),
            lookup: Lookup::default(),
            swivel_data: self.swivel_data.clone(),
            tools: self.tools.clone(),
            ..*self
        }
    }

    /// Lines of the configuration that a line of a program is.
    fn own_of<'a>(&'a self, line: &'a [u8]) -> impl Iterator<Item = &'a OwnText> + Clone {
        self.lookup.own.possible(line).map(|index| &self.own[index]).filter(|own| matches(&own.text, line))
    }

    /// Codes of the shop in the place of the control's own: of clamps, coolant, tip control and spindle.
    pub(super) fn switches(&self) -> impl Iterator<Item = &OwnText> + Clone {
        self.lookup.switches.iter().map(|index| &self.own[*index])
    }

    /// The text with a declared effect that a line is, and its effect.
    fn declared<'a>(&'a self, line: &'a [u8]) -> Option<&'a (Vec<u8>, Effect)> {
        self.lookup.effects.possible(line).map(|index| &self.effects[index]).find(|(key, _)| matches(key, line))
    }
}

/// Brings the lines of the configuration and the declared texts into the form of [`Bare`], where they are found.
pub(super) fn prepare(mut vocabulary: Vocabulary) -> Vocabulary {
    let facts = vocabulary.family.facts();
    let mut bare = Bare::default();
    let texts = vocabulary.own.iter_mut().map(|own| &mut own.text);
    for text in texts.chain(vocabulary.effects.iter_mut().map(|(text, _)| text)) {
        if facts.form == LineForm::Statements {
            // A declared text has one line.
            for mark in memchr::memmem::find_iter(text, b" ~ ").map(|at| at + 1).collect::<Vec<_>>() {
                text[mark] = b' ';
            }
        }
        bare.find(text, 0, &facts);
        text.clone_from(&bare.text);
    }
    vocabulary.own.retain(|own| !own.text.is_empty());
    vocabulary.effects.retain(|(text, _)| !text.is_empty());
    let is_switch = |own: &OwnText| {
        matches!(
            own.place,
            OwnPlace::Clamp { .. }
                | OwnPlace::TipControl { .. }
                | OwnPlace::MillTurn
                | OwnPlace::Spindle { .. }
                | OwnPlace::Coolant
        )
    };
    vocabulary.lookup = Lookup {
        own: ByText::of(vocabulary.own.iter().map(|own| (own.text.as_slice(), (own.place, own.coolant)))),
        effects: ByText::of(vocabulary.effects.iter().map(|(text, effect)| (text.as_slice(), *effect))),
        switches: (0..vocabulary.own.len()).filter(|index| is_switch(&vocabulary.own[*index])).collect(),
    };
    vocabulary
}

/// What is declared for a line or for words of it, if it is one of the configuration or declared as a whole. `blanked`
/// receives the line without them.
#[inline]
pub(super) fn declared(
    line: &[u8],
    vocabulary: &Vocabulary,
    facts: &Facts,
    bare: &mut Bare,
    blanked: &mut Vec<u8>,
) -> Option<Declared> {
    if vocabulary.effects.is_empty() {
        return None;
    }
    bare.text(line, facts);
    search(line, vocabulary, bare, blanked)
}

#[inline(never)]
fn search(line: &[u8], vocabulary: &Vocabulary, bare: &Bare, blanked: &mut Vec<u8>) -> Option<Declared> {
    let Bare { masked, text, .. } = bare;
    blanked.clear();
    blanked.extend_from_slice(line);
    if let Some((_, effect)) = vocabulary.declared(text) {
        // Number and comments stay.
        blanked.iter_mut().zip(masked).filter(|(_, byte)| **byte != b' ').for_each(|(byte, _)| *byte = b' ');
        return Some(Declared { effect: *effect, bits: bits(*effect), whole: true });
    }
    let mut found: Option<Declared> = None;
    let mut at = 0;
    for word in masked.split(|byte| *byte == b' ') {
        if let Some(index) = vocabulary.lookup.effects.same(word).next() {
            let (_, effect) = &vocabulary.effects[index];
            blanked[at..at + word.len()].fill(b' ');
            let before = found.unwrap_or(Declared { effect: Effect::None, bits: 0, whole: false });
            let (effect, bits) = (before.effect.max(*effect), before.bits | bits(*effect));
            found = Some(Declared { effect, bits, whole: false });
        }
        at += word.len() + 1;
    }
    found.filter(|_| vocabulary.own_of(text).next().is_some())
}

fn bits(declared: Effect) -> u8 {
    match declared {
        // A tool change is a code of the block, not something that happens to it.
        Effect::None | Effect::ToolChange => 0,
        Effect::Clamp | Effect::Chuck | Effect::Door => effect::STANDSTILL,
        Effect::Pallet => effect::STANDSTILL | effect::POSITION,
        Effect::Coolant => effect::COOLANT,
        Effect::Spindle => effect::SPINDLE,
        Effect::Measures | Effect::PositionLost => effect::POSITION,
        Effect::Stop => effect::STOP,
        Effect::StateLost => effect::STATE,
    }
}

/// Executes a code of clamps, coolant or tip control; whether the line is one.
#[inline]
pub(super) fn switch(text: &[u8], line: &mut Line<'_>) -> bool {
    let vocabulary = line.vocabulary();
    let mut found = false;
    for own in vocabulary.lookup.own.same(text).map(|index| &vocabulary.own[index]) {
        let orders = &mut *line.orders;
        // The machine builder's code takes the place of the control's own of this spelling.
        match own.place {
            OwnPlace::Clamp { .. } | OwnPlace::TipControl { .. } | OwnPlace::MillTurn | OwnPlace::Spindle { .. }
                if !found =>
            {
                orders.forget_codes();
            }
            OwnPlace::Coolant if !found && matches!(own.coolant, Some((_, true))) => {
                orders.remove(|mode| matches!(mode, ModeOrder::CoolantOn(_)));
            }
            _ => {}
        }
        match (own.place, own.coolant) {
            (OwnPlace::Clamp { axis, on }, _) => orders.mode(ModeOrder::Clamp { axis, on }),
            (OwnPlace::Coolant, Some((kinds, true))) => orders.mode(ModeOrder::CoolantOn(kinds)),
            (OwnPlace::Coolant, Some((kinds, false))) => orders.mode(ModeOrder::CoolantOff(kinds)),
            (OwnPlace::TipControl { on }, _) => orders.mode(ModeOrder::TipControl(on)),
            (OwnPlace::Spindle { rotation }, _) => orders.mode(ModeOrder::Spindle(rotation)),
            (OwnPlace::MillTurn, _) => {}
            (OwnPlace::Coolant, None) => {}
            _ => continue,
        }
        found = true;
    }
    line.orders.speaks |= found;
    found
}

/// The tool that a value of `{tool}` calls: `5`, `"MILL 10"`, `="MILL 10"`. `None` if it is no tool of the
/// configuration.
fn called_tool(called: &[u8], line: &mut Line<'_>) -> Option<u32> {
    let value = called.strip_prefix(b"=").unwrap_or(called);
    let name = value.strip_prefix(b"\"").and_then(|name| name.strip_suffix(b"\""));
    let number = name.map_or_else(|| whole(called), |name| line.tool_of(name));
    if number.is_none() {
        line.fault(0, format!("`{}` is no tool of the configuration", shown(called)));
    } else {
        line.called(name.is_some(), 0);
    }
    number
}

fn whole(text: &[u8]) -> Option<u32> {
    std::str::from_utf8(text).ok().filter(|text| text.bytes().all(|byte| byte.is_ascii_digit()))?.parse().ok()
}

/// Executes the tool change of the control with the tool that a line calls: the value of its field `{tool}`.
fn change_tool(called: Option<&[u8]>, line: &mut Line<'_>) {
    let Some(called) = called else {
        line.fault(0, "tool change without a tool number: the field {tool} has no value");
        return;
    };
    let Some(number) = called_tool(called, line) else { return };
    let of_table = line.facts().plane_by_tool_call;
    line.orders.mode(ModeOrder::Tool(number));
    line.orders.mode(ModeOrder::Change);
    line.orders.act(Act::ToolChange);
    if of_table {
        // Working plane, length and radius are those of the tool call in it.
        for mode in [ModeOrder::LengthOfTool, ModeOrder::Plane(WorkPlane::Xy), ModeOrder::RadiusDelta(Some(0.0))] {
            line.orders.mode(mode);
        }
    }
}

/// The own line that a line is, and what is wrong with it: an effect that is not declared.
#[cold]
pub(super) fn resolve(text: &[u8], line: &mut Line<'_>, declared: Option<Declared>, switched: bool) -> Option<OwnLine> {
    let mut places: Vec<OwnPlace> = line.vocabulary().own_of(text).map(|own| own.place).collect();
    let effect = declared.map(|declared| declared.effect);
    let unconfirmed = effect == Some(Effect::None) && places.contains(&OwnPlace::Unconfirmed);
    let needs_standstill = unconfirmed || declared.is_some_and(|declared| declared.bits & effect::STANDSTILL != 0);
    let values = values(text, line);
    if let Some(Declared { bits, whole, .. }) = declared {
        let routine = |place: &OwnPlace| matches!(place, OwnPlace::MeasureTool | OwnPlace::CheckTool);
        let modes = if effect == Some(Effect::Measures) && places.iter().any(routine) { effect::MODES } else { 0 };
        line.orders.effects = bits | modes;
        line.orders.speaks = true;
        if bits != 0 && line.orders.moves_axes() {
            let text = "a word of the shop with an effect in a block that moves an axis: whether it acts before or after the motion \
                        is not known, so it needs a block of its own";
            line.lasting_fault(0, text);
        }
        if effect == Some(Effect::ToolChange) {
            let key = line.vocabulary().declared(text);
            let called = key.and_then(|(key, _)| filled(key, text)).and_then(|of| of.tool);
            change_tool(called, line);
        }
        if whole || line.fault_count() == line.orders.frame_faults {
            if places.is_empty() {
                places.push(OwnPlace::Insert);
            }
            return Some(OwnLine { places, effect, needs_standstill, values });
        }
    }
    if places.is_empty() {
        return None;
    }
    if switched {
        line.excuse();
        return Some(OwnLine { places, effect, needs_standstill, values });
    }
    if line.fault_count() > line.orders.frame_faults {
        // What it does is unknown, so nothing of it is executed.
        let reason = line.first_fault().unwrap_or_default().to_owned();
        line.orders.forget_codes();
        line.excuse();
        let own = line.vocabulary().own_of(text).next();
        let key = shown(own.map_or(text, |own| own.text.as_slice()));
        let from = places
            .iter()
            .find_map(|place| place.key())
            .map_or_else(|| "configuration or control".to_owned(), |key| format!("`{key}`"));
        let others: Vec<String> = Effect::NAMES[1..].iter().map(|(name, _)| format!("\"{name}\"")).collect();
        let text = format!(
            "`{}` is a line of {from} that the check cannot execute: {reason}; correct it, or declare its \
             effect in `[control] effects`: `{} = \"none\"`, or {} (a control in Rust: in `Control::effects`)",
            shown(text),
            as_toml_key(&key),
            others.join(", ")
        );
        line.fault(0, text);
    }
    Some(OwnLine { places, effect, needs_standstill, values })
}

/// A text as a key of a TOML file.
fn as_toml_key(text: &str) -> String {
    match text.contains(['\\', '"']) && !text.contains('\'') {
        true => format!("'{text}'"),
        false => format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"")),
    }
}

/// Values of the fields of a line that is about the tool in the spindle. In a tool change the codes have them.
fn values(text: &[u8], line: &mut Line<'_>) -> OwnValues {
    let is_of_tool = |own: &&OwnText| {
        matches!(
            own.place,
            OwnPlace::MeasureTool
                | OwnPlace::CheckTool
                | OwnPlace::ToolStart { .. }
                | OwnPlace::ToolEnd { .. }
                | OwnPlace::OperationStart
                | OwnPlace::OperationEnd
        )
    };
    let own = line.vocabulary().own_of(text).filter(is_of_tool);
    let found = own.filter_map(|own| Some((&own.text, filled(&own.text, text)?)));
    let Some((template, filled)) = found.min_by_key(|(template, filled)| filled.lacks_value(template)) else {
        return OwnValues::default();
    };
    if line.has_tool() && filled.lacks_value(template) {
        let text = format!("the value of a field is missing: this line of the configuration is `{}`", shown(template));
        line.fault(0, text);
    }
    let (called, number) =
        (filled.tool.and_then(|called| called_tool(called, line)), filled.tool_number.and_then(whole));
    if let (Some(called), Some(number)) = (called, number)
        && called != number
    {
        line.fault(0, format!("this line of the configuration is for T{called}, and has the number {number}"));
    }
    OwnValues { tool: called.or(number), offset: filled.offset.and_then(whole) }
}

/// What has to come before a line that is read by itself.
fn line_number(vocabulary: &Vocabulary) -> &'static [u8] {
    if vocabulary.family.facts().form == LineForm::Statements { b"1 " } else { b"" }
}

/// A line of the configuration as it may come in a program, its fields having some value.
pub(super) fn with_values(line: &[u8], vocabulary: &Vocabulary) -> Vec<u8> {
    let mut text = line_number(vocabulary).to_vec();
    let mut in_field = false;
    for &byte in line {
        match byte {
            b'{' => {
                in_field = true;
                text.push(b'1');
            }
            b'}' => in_field = false,
            _ if in_field => {}
            byte => text.push(byte),
        }
    }
    text
}

/// Whether the table has the codes of a line of the configuration, whatever the values of its fields are.
pub(crate) fn is_read(line: &[u8], vocabulary: &Vocabulary) -> bool {
    let text = with_values(line, vocabulary);
    let mut reader = Reader::new(InMemory(&text), vocabulary.without_shop());
    // What lacks a mode here has it in the program.
    reader.next_block().is_ok() && !reader.orders.unknown
}

/// Whether a line is one of the configuration, with values for its fields; `is_tool`: whether a tool can be that of the
/// line.
pub(crate) fn is_filled(template: &str, line: &[u8], is_tool: impl Fn(&[u8]) -> bool) -> bool {
    filled(template.trim().as_bytes(), line)
        .is_some_and(|filled| [filled.tool, filled.tool_number].into_iter().flatten().all(is_tool))
}

/// Lines of the configuration that have a fixed place in a program, and how often each has come.
#[derive(Clone)]
pub(crate) struct PlacedLines {
    lines: Vec<PlacedLine>,
    by_text: ByText,
    facts: Facts,
    bare: Bare,
    /// How often work of a tool has begun or ended: at its change, and where blocks that may be skipped begin and end.
    tools: usize,
}

#[derive(Clone)]
struct PlacedLine {
    /// As in [`Vocabulary::own`].
    text: Vec<u8>,
    /// Its places, and how often it is at each.
    places: Vec<(OwnPlace, usize)>,
    /// All its codes are the control's: a program has them at other places as well.
    common: bool,
    /// How often it has come, for whatever place.
    times: usize,
}

impl PlacedLine {
    /// How often it may come since it has not, at those of its places that are due; `None` where that is not known.
    fn most(&self, tools: usize, due: impl Fn(OwnPlace) -> bool) -> Option<usize> {
        let of_place = |(place, times): &(OwnPlace, usize)| {
            Some(most(*place, tools).filter(|_| !self.common)? * times * usize::from(due(*place)))
        };
        self.places.iter().map(of_place).sum()
    }
}

impl PlacedLines {
    /// The lines of a vocabulary that every program must have. A comment is no block, and where no word of a line is
    /// without a field, or no tool may follow, it may be left out.
    pub(crate) fn of(vocabulary: Vocabulary) -> Self {
        let vocabulary = Arc::new(prepare(vocabulary));
        let facts = vocabulary.family.facts();
        let is_block = |text: &[u8]| {
            let line = [line_number(&vocabulary), text].concat();
            Reader::with(InMemory(&line), Arc::clone(&vocabulary)).next_block().is_ok_and(|block| block.is_some())
        };
        let is_written = |own: &&OwnText| {
            // A tool change has a tool.
            let fields = |word: &[u8]| word.iter().filter(|byte| **byte == b'{').count();
            let of_tool =
                |word: &[u8]| fields(word) == 1 && (has_field(word, "tool") || has_field(word, "tool_number"));
            let is_of_tool = matches!(own.place, OwnPlace::ToolChange | OwnPlace::MeasureTool | OwnPlace::CheckTool);
            let has_value = |word: &[u8]| is_of_tool && of_tool(word);
            let mut words = own.text.split(|byte| *byte == b' ');
            own.place.key().is_some()
                && words.any(|word| fields(word) == 0 || has_value(word))
                && !has_field(&own.text, "next")
                && is_block(&own.text)
        };
        let mut lines: Vec<PlacedLine> = Vec::new();
        let mut known: HashMap<&[u8], usize> = HashMap::new();
        for own in vocabulary.own.iter().filter(is_written) {
            let index = *known.entry(&own.text).or_insert(lines.len());
            if index == lines.len() {
                let common = is_read(&own.text, &vocabulary);
                lines.push(PlacedLine { text: own.text.clone(), places: Vec::new(), common, times: 0 });
            }
            let places = &mut lines[index].places;
            match places.iter_mut().find(|(place, _)| *place == own.place) {
                Some((_, times)) => *times += 1,
                None => places.push((own.place, 1)),
            }
        }
        let by_text = ByText::of(lines.iter().map(|own| (own.text.as_slice(), ())));
        Self { lines, by_text, facts, bare: Bare::default(), tools: 0 }
    }

    /// Whether a line that the program has taken has come more often than the configuration has it. Lines of safety may
    /// come again.
    pub(crate) fn comes_too_often(&mut self, line: &[u8]) -> bool {
        self.bare.forget();
        let text = self.bare.text(line, &self.facts);
        let tools = self.tools;
        let of_text =
            || self.by_text.possible(text).map(|index| &self.lines[index]).filter(|own| matches(&own.text, text));
        let most: Option<usize> = of_text().map(|own| own.most(tools, |_| true)).sum();
        of_text().next().zip(most).is_some_and(|(own, most)| own.times > most)
    }

    /// Lines of several places that have come more often than those of them that are due at one time. A line with
    /// fields may be that of another place.
    pub(crate) fn too_often_for(&self, due: impl Fn(OwnPlace) -> bool) -> Vec<String> {
        let is_single =
            |own: &PlacedLine| self.lines.iter().filter(|other| matches(&other.text, &own.text)).count() == 1;
        let comes_too_often = |own: &&PlacedLine| own.most(self.tools, &due).is_some_and(|most| own.times > most);
        let several = self.lines.iter().filter(|own| own.places.len() > 1 && is_single(own));
        several.filter(comes_too_often).map(|own| shown(&own.text)).collect()
    }

    /// How often work of a tool has begun or ended since none has come.
    pub(crate) fn tools(&self) -> usize {
        self.tools
    }

    /// Those that have come for one of these places and no other.
    pub(crate) fn come_for(&self, places: impl Fn(OwnPlace) -> bool) -> Vec<(OwnPlace, String)> {
        let only = |own: &&PlacedLine| own.places.iter().all(|(place, _)| places(*place));
        let come = self.lines.iter().filter(|own| own.times > 0 && !own.common).filter(only);
        come.flat_map(|own| own.places.iter().map(|(place, _)| (*place, shown(&own.text)))).collect()
    }

    /// The work of a tool begins or ends.
    pub(crate) fn next_tool(&mut self) {
        self.tools += 1;
    }

    /// Takes a line of the program that comes with this tool in the spindle. Returns whether it is one of other tools
    /// alone.
    pub(crate) fn note(&mut self, line: &[u8], tool: Option<u32>) -> bool {
        if self.lines.is_empty() {
            return false;
        }
        self.bare.forget();
        let text = self.bare.text(line, &self.facts);
        let (mut is_of_others, mut may_come) = (false, false);
        for index in self.by_text.possible(text) {
            let own = &mut self.lines[index];
            if !matches(&own.text, text) {
                continue;
            }
            own.times += 1;
            for (place, _) in &own.places {
                let of_other = match place {
                    OwnPlace::ToolStart { tool: of } | OwnPlace::ToolEnd { tool: of } => {
                        tool.is_some_and(|tool| tool != *of)
                    }
                    _ => false,
                };
                is_of_others |= of_other;
                may_come |= !of_other;
            }
        }
        is_of_others && !may_come
    }

    /// Whether a line of the program is one of them.
    pub(crate) fn has(&mut self, line: &[u8]) -> bool {
        self.bare.forget();
        let text = self.bare.text(line, &self.facts);
        self.by_text.possible(text).any(|index| matches(&self.lines[index].text, text))
    }

    /// From now on none has come.
    pub(crate) fn forget(&mut self) {
        self.lines.iter_mut().for_each(|own| own.times = 0);
        self.tools = 0;
    }

    /// Those of the needed places that have not come. A text that is needed several times must come as often.
    pub(crate) fn missing(&self, needed: impl Fn(OwnPlace) -> bool) -> Vec<(OwnPlace, String)> {
        let of_line = |own: &PlacedLine| {
            let needed = own.places.iter().filter(|(place, _)| needed(*place));
            let each = needed.flat_map(|(place, times)| std::iter::repeat_n(*place, *times));
            each.skip(own.times).map(|place| (place, shown(&own.text))).collect::<Vec<_>>()
        };
        self.lines.iter().flat_map(of_line).collect()
    }
}

/// How often the lines of a place may come since none has come, where that is known. `tools`: how often work of a tool
/// has begun or ended.
fn most(place: OwnPlace, tools: usize) -> Option<usize> {
    match place {
        OwnPlace::Start | OwnPlace::End | OwnPlace::OperationStart | OwnPlace::OperationEnd => Some(1),
        // After the change, and before the next one.
        OwnPlace::MeasureTool | OwnPlace::ToolStart { .. } => Some(tools.max(1)),
        OwnPlace::ToolChange | OwnPlace::CheckTool | OwnPlace::ToolEnd { .. } => Some(tools + 1),
        _ => None,
    }
}

/// Whether a template has a field.
fn has_field(template: &[u8], field: &str) -> bool {
    memchr::memmem::find_iter(template, field)
        .any(|at| at > 0 && template[at - 1] == b'{' && template.get(at + field.len()) == Some(&b'}'))
}

/// Whether a line is a template with values for its fields. A word whose field has no value is left out.
fn matches(template: &[u8], line: &[u8]) -> bool {
    filled(template, line).is_some()
}

/// Values of fields in a line, as written.
#[derive(Debug, Clone, Copy, Default)]
struct Filled<'a> {
    tool: Option<&'a [u8]>,
    tool_number: Option<&'a [u8]>,
    offset: Option<&'a [u8]>,
}

impl<'a> Filled<'a> {
    /// Both together; `None` if a field has two values.
    fn and(self, other: Self) -> Option<Self> {
        let one = |first: Option<&'a [u8]>, second: Option<&'a [u8]>| match (first, second) {
            (Some(first), Some(second)) => (first == second).then_some(Some(first)),
            (first, second) => Some(first.or(second)),
        };
        Some(Self {
            tool: one(self.tool, other.tool)?,
            tool_number: one(self.tool_number, other.tool_number)?,
            offset: one(self.offset, other.offset)?,
        })
    }

    /// Whether a field that has a value for every tool has none in a line.
    fn lacks_value(&self, template: &[u8]) -> bool {
        let lacks = |value: Option<&[u8]>, field| value.is_none() && has_field(template, field);
        lacks(self.tool, "tool") || lacks(self.tool_number, "tool_number") || lacks(self.offset, "offset")
    }
}

/// The values of fields in a line; `None` if the line is not the template with values for its fields.
fn filled<'a>(template: &[u8], line: &'a [u8]) -> Option<Filled<'a>> {
    if !template.contains(&b'{') {
        return (template == line).then(Filled::default);
    }
    let split = |text: &[u8]| text.iter().position(|byte| *byte == b' ').unwrap_or(text.len());
    let (end, word_end) = (split(template), split(line));
    let (word, rest) = (&template[..end], template.get(end + 1..));
    let after = line.get(word_end + 1..);
    let goes_on = match (rest, after) {
        (None, None) => Some(Filled::default()),
        (Some(rest), Some(after)) => filled(rest, after),
        // The words that are left have no value.
        (Some(rest), None) => rest.split(|byte| *byte == b' ').all(|word| word.contains(&b'{')).then(Filled::default),
        (None, Some(_)) => None,
    };
    if let Some(others) = goes_on
        && let Some(own) = filled_word(word, &line[..word_end])
        && let Some(both) = own.and(others)
    {
        return Some(both);
    }
    // A value with a blank in it: `G54.1 P3`, a name.
    if word.contains(&b'{') {
        if let Some(rest) = rest
            && let Some(others) = filled(rest, line)
        {
            return Some(others);
        }
        return line.iter().enumerate().filter(|(_, byte)| **byte == b' ').find_map(|(blank, _)| {
            let next = line[blank + 1..].iter().position(|byte| *byte == b' ').map(|at| blank + 1 + at);
            let own = filled_word(word, &line[..next.unwrap_or(line.len())])?;
            let others = match (rest, next) {
                (Some(rest), Some(next)) => filled(rest, &line[next + 1..])?,
                (None, None) => Filled::default(),
                (Some(_), None) | (None, Some(_)) => return None,
            };
            own.and(others)
        });
    }
    None
}

/// The values of fields in a word; `None` if it is not that of the template.
fn filled_word<'a>(word: &[u8], text: &'a [u8]) -> Option<Filled<'a>> {
    let Some(open) = word.iter().position(|byte| *byte == b'{') else {
        return (word == text).then(Filled::default);
    };
    let close = word.iter().position(|byte| *byte == b'}')?;
    if !text.starts_with(&word[..open]) {
        return None;
    }
    let (field, rest, value) = (&word[open + 1..close], &word[close + 1..], &text[open..]);
    (1..=value.len()).find_map(|length| {
        let (value, after) = value.split_at(length);
        let others = is_value(field, value).then(|| filled_word(rest, after)).flatten()?;
        let own = match field {
            b"tool_number" => Filled { tool_number: Some(value), ..Filled::default() },
            b"tool" => Filled { tool: Some(value), ..Filled::default() },
            b"offset" => Filled { offset: Some(value), ..Filled::default() },
            _ => Filled::default(),
        };
        own.and(others)
    })
}

/// Whether a text can be the value of a field.
fn is_value(field: &[u8], value: &[u8]) -> bool {
    match field {
        // A tool may be called by its name.
        b"tool" | b"next" => value.iter().all(|byte| byte.is_ascii_graphic() || *byte == b' '),
        b"offset" | b"number" | b"tool_number" => value.iter().all(u8::is_ascii_digit),
        b"speed" | b"path_tolerance" => value.iter().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-')),
        b"units" | b"work_offset" => {
            value.iter().all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b' '))
        }
        _ => true,
    }
}
