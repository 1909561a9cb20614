//! A table with fixed keys; a key that no option has is unknown.

use std::collections::BTreeMap;

use toml::de::DeTable;

use super::reader::{KeyReader, TomlValue, UnknownKey};

/// The file or a table in it, with the keys that are known so far.
pub(crate) struct KeyTable<'a> {
    /// Name of the table; empty for the file.
    name: String,
    table: Option<&'a DeTable<'a>>,
    known: Vec<&'static str>,
    sections: BTreeMap<&'static str, KeyTable<'a>>,
}

impl<'a> KeyTable<'a> {
    /// The file (`name` is empty), or a table in it.
    pub(crate) fn new(name: impl Into<String>, table: Option<&'a DeTable<'a>>) -> Self {
        Self { name: name.into(), table, known: Vec::new(), sections: BTreeMap::new() }
    }

    /// The table in `value`; an empty one if `value` is no table.
    pub(crate) fn of(r: &mut KeyReader<'_>, name: impl Into<String>, value: Option<TomlValue<'a>>) -> Self {
        Self::new(name, value.and_then(|value| r.table(value)))
    }

    /// Whether this is the whole file.
    pub(crate) fn is_file(&self) -> bool {
        self.name.is_empty()
    }

    /// Value at a path: `key`, or `section.key`.
    pub(crate) fn get(&mut self, path: &'static str, r: &mut KeyReader<'_>) -> Option<TomlValue<'a>> {
        let Some((section, key)) = path.split_once('.') else {
            self.known.push(path);
            return self.table?.get(path);
        };
        if !self.sections.contains_key(section) {
            let value = self.get(section, r);
            self.sections.insert(section, Self::of(r, section, value));
        }
        self.sections.get_mut(section).and_then(|section| section.get(key, r))
    }

    /// Ends the reading: any key of the table or its sections that was not read is unknown.
    pub(crate) fn close(&self, r: &mut KeyReader<'_>) {
        for section in self.sections.values() {
            section.close(r);
        }
        #[cfg(test)]
        r.note_known(&self.name, &self.known);
        for (key, _) in self.table.into_iter().flat_map(DeTable::iter) {
            let (name, span) = (key.get_ref().as_ref(), key.span());
            if !self.known.contains(&name) {
                let (table, name, known) = (self.name.clone(), name.to_owned(), self.known.clone());
                r.add_unknown(UnknownKey { table, name, span, known });
            }
        }
        if self.is_file() {
            r.report_unknown(&self.known);
        }
    }
}
