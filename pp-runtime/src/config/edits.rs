//! `[check]`: permitted edits of a posted program.

use serde_json::{Value as Json, json};

use crate::check::policy::{EditPolicy, EditedBlock, MeantEdit};
use crate::diag::code::config;
use crate::keys::{Bound, KeyKind, KeyReader, KeyScope, KeyTable, Measure, Printed, TomlValue, options};

options! {
    /// Permitted edits of a posted program. Permission comes from here, never from the program; F may go down, coolant
    /// may change, waits may be longer, M0 and M1 may be added, the steps of a deep hole may be smaller, and within
    /// these factors F may go up and S may change.
    pub struct EditOptions in "check" {
        /// Edits: `[[check.edits]]` with `block` (its number, "N120") or `line`, `old`, `new` and `reason`.
        edits: Vec<MeantEdit> = Vec::new(), key("check.edits", Edits);
        /// Largest ratio of an edited F to the posted one.
        feed_factor: Option<f64> = None, key("check.feed_factor", Measure::plain(Bound::Positive).unless(below_one), "1.1");
        /// Largest ratio of an edited S to the posted one, and of the posted one to it.
        speed_factor: Option<f64> = None, key("check.speed_factor", Measure::plain(Bound::Positive).unless(below_one), "1.1");
    }
}

fn below_one(factor: f64) -> Option<String> {
    (factor < 1.0).then(|| "a factor is 1 or more: a smaller F needs none".to_owned())
}

impl EditOptions {
    /// The policy of a check.
    pub(super) fn policy(&self) -> EditPolicy {
        EditPolicy { edits: self.edits.clone(), feed_factor: self.feed_factor, speed_factor: self.speed_factor }
    }
}

/// Kind of key: edits.
#[derive(Debug, Clone, Copy)]
struct Edits;

impl Edits {
    fn edit(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<MeantEdit> {
        let mut table = KeyTable::of(r, "check.edits", Some(value));
        let number = table.get("block", r).map(|value| Self::number(r, value));
        let line = table.get("line", r).map(|value| r.whole(value, 1..=u32::MAX));
        let mut text = |key: &'static str, r: &mut KeyReader<'_>| match table.get(key, r) {
            Some(value) => r.line(value),
            None => {
                r.fault(
                    value.span(),
                    format!("`{key}` is missing here"),
                    Some(format!("`{key} = \"\"` says that there is none")),
                );
                None
            }
        };
        let (old, new, reason) = (text("old", r), text("new", r), text("reason", r));
        table.close(r);
        let block = match (number, line) {
            (Some(number), None) => EditedBlock::Number(number?),
            (None, Some(line)) => EditedBlock::Line(u64::from(line?)),
            _ => {
                let text = "an edit has a `block` (\"N120\") or a `line` of the program";
                r.fault(value.span(), text, None);
                return None;
            }
        };
        let edit = MeantEdit { block, old: old?, new: new?, reason: reason? };
        if edit.old == edit.new {
            r.fault(value.span(), "`old` and `new` are the same", None);
            return None;
        }
        if edit.reason.trim().is_empty() {
            r.report(config::MISSING, value.span(), "an edit that is meant has a `reason`", None);
            return None;
        }
        Some(edit)
    }

    /// A block number: `"N120"`, `"120"`.
    fn number(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<u64> {
        let text = r.line(value)?;
        let digits = text.trim().trim_start_matches(['N', 'n']);
        let number = digits.parse().ok().filter(|_| digits.bytes().all(|byte| byte.is_ascii_digit()));
        if number.is_none() {
            r.fault(value.span(), format!("`{text}` is no block number: \"N120\""), None);
        }
        number
    }
}

impl KeyKind for Edits {
    type Value = Vec<MeantEdit>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        Some(r.list(value)?.into_iter().filter_map(|value| Self::edit(r, value)).collect())
    }

    fn print(&self, _value: &Self::Value) -> String {
        "[]".to_owned()
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        let text = json!({ "type": "string" });
        json!({ "type": "array", "items": {
            "type": "object",
            "additionalProperties": false,
            "required": ["old", "new", "reason"],
            "properties": { "block": text, "line": { "type": "integer", "minimum": 1 }, "old": text, "new": text, "reason": text },
        } })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        let example = "[{ block = \"N120\", old = \"F1200.\", new = \"F1100.\", reason = \"chatter\" }]";
        Some(Printed::Example(example.to_owned()))
    }
}
