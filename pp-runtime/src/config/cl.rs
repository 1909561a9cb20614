//! `[cl]` and `[frames]`: how the CL data is read.

use crate::cl::record::CycleKind;
use crate::cl::{ClPoint, CycleArg, Dialect, FeedLabel, Frames, Insert, Sense, not_inert};

use super::Config;
use super::control::{TEXTS, work_offset};
use super::read::set;
use super::value::{Reader, Section, Shape, Value};

pub(super) const CL_POINTS: [(&str, ClPoint); 2] = [("tip", ClPoint::Tip), ("centre", ClPoint::Centre)];
const FRAMES: [(&str, Frames); 3] = [("refuse", Frames::Refuse), ("main", Frames::Main), ("offset", Frames::Offset)];
const SENSES: [(&str, Sense); 2] = [("cw", Sense::Clockwise), ("ccw", Sense::CounterClockwise)];
const INSERTS: [(&str, Insert); 3] =
    [("refuse", Insert::Refuse), ("comment", Insert::Comment), ("write", Insert::Write)];
const FEED_LABELS: [(&str, FeedLabel); 3] =
    [("refuse", FeedLabel::Refuse), ("trust", FeedLabel::Trust), ("file-units", FeedLabel::FileUnits)];
const FROMS: [(&str, bool); 2] = [("reference", false), ("move", true)];

/// Columns of a line that may count.
const COLUMNS: std::ops::RangeInclusive<u32> = 8..=4096;

/// Largest number of a code.
const LARGEST_CODE: u32 = 9999;

/// Numbers of codes.
const CODES: &str = r#"{ "type": "array", "items": { "type": "integer", "minimum": 0, "maximum": 9999 } }"#;

impl Config {
    pub(super) fn read_cl(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "cl.dialect") {
            self.cl.dialect = r.choice(value, &Dialect::NAMES);
        }
        if let Some(value) = self.get(section, "cl.columns") {
            self.cl.columns = r.whole(value, COLUMNS);
        }
        if let Some(value) = self.get(section, "cl.inert") {
            r.note(value, || Shape::Schema(TEXTS));
            for word in r.list(value).unwrap_or_default() {
                let Some(name) = r.line(word) else { continue };
                match not_inert(&name) {
                    Some(why) => r.fault(word.span(), why, None),
                    None => self.cl.inert.push(name.to_ascii_uppercase()),
                }
            }
        }
        if let Some(value) = self.get(section, "cl.frames") {
            set(&mut self.cl.frames, r.choice(value, &FRAMES));
        }
        if let Some(value) = self.get(section, "cl.circle_sense") {
            self.cl.circle_sense = r.choice(value, &SENSES);
        }
        if let Some(value) = self.get(section, "cl.insert") {
            set(&mut self.cl.insert, r.choice(value, &INSERTS));
        }
        if let Some(value) = self.get(section, "cl.insert_stop") {
            set(&mut self.cl.insert_stop, r.boolean(value));
        }
        if let Some(value) = self.get(section, "cl.auxfun") {
            self.cl.auxfun = codes(r, value);
        }
        if let Some(value) = self.get(section, "cl.prefun") {
            self.cl.prefun = codes(r, value);
        }
        if let Some(value) = self.get(section, "cl.feed_label") {
            set(&mut self.cl.feed_label, r.choice(value, &FEED_LABELS));
        }
        if let Some(value) = self.get(section, "cl.from") {
            set(&mut self.cl.from_move, r.choice(value, &FROMS));
        }
        if let Some(value) = self.get(section, "cl.allow_lintol") {
            set(&mut self.motion.allow_lintol, r.boolean(value));
        }
        if let Some(cycles) = self.get(section, "cl.cycle") {
            r.note(cycles, || Shape::Names(CycleKind::WORDS.iter().map(|(word, _)| (*word).to_owned()).collect()));
            for (key, span, value) in r.entries(cycles) {
                let Some((_, kind)) = CycleKind::WORDS.iter().find(|(word, _)| *word == key) else {
                    r.fault(span, format!("`{key}` is not a kind of CYCLE"), None);
                    continue;
                };
                let mut section = Section::of(r, format!("cl.cycle.{key}"), Some(value));
                if let Some(args) = section.get("args") {
                    let names = r.list(args).unwrap_or_default();
                    let args = names.into_iter().filter_map(|name| r.choice(name, &CycleArg::NAMES)).collect();
                    self.cl.cycle_args.push((*kind, args));
                }
                section.finish(r);
            }
        }
    }

    /// Work offsets of frames by their numbers.
    pub(super) fn read_frames(&mut self, r: &mut Reader<'_>, frames: Option<Value<'_>>) {
        if let Some(frames) = frames {
            r.note(frames, || Shape::Numbered);
        }
        for (key, span, value) in frames.map_or_else(Vec::new, |frames| r.entries(frames)) {
            match key.parse().ok().filter(|number: &u32| *number > 0 && number.to_string() == key) {
                Some(number) => {
                    self.set_up.frames.extend(work_offset(r, value).map(|word| (number, word)));
                }
                None => {
                    let help = "frames count from 1 in the order of the CL data: 2 = \"G55\"".to_owned();
                    r.fault(span, format!("`{key}` is not the number of a frame"), Some(help));
                }
            }
        }
    }
}

fn codes(r: &mut Reader<'_>, value: Value<'_>) -> Vec<u32> {
    r.note(value, || Shape::Schema(CODES));
    r.list(value).unwrap_or_default().into_iter().filter_map(|code| r.whole(code, 0..=LARGEST_CODE)).collect()
}
