//! A table of fixed keys: whatever is never asked for is unknown.

use std::collections::BTreeMap;

use toml::de::DeTable;

use super::reader::{KeyReader, TomlValue, UnknownKey};

/// The file itself, or a table in it, and the keys that were asked for.
pub(crate) struct KeyTable<'a> {
    /// Empty for the file.
    name: String,
    table: Option<&'a DeTable<'a>>,
    known: Vec<&'static str>,
    sections: BTreeMap<&'static str, KeyTable<'a>>,
}

impl<'a> KeyTable<'a> {
    /// The file itself, `name` empty, or a table in it.
    pub(crate) fn new(name: impl Into<String>, table: Option<&'a DeTable<'a>>) -> Self {
        Self { name: name.into(), table, known: Vec::new(), sections: BTreeMap::new() }
    }

    /// The table in `value`; one without keys if there is none.
    pub(crate) fn of(r: &mut KeyReader<'_>, name: impl Into<String>, value: Option<TomlValue<'a>>) -> Self {
        Self::new(name, value.and_then(|value| r.table(value)))
    }

    /// This is the whole file.
    pub(crate) fn is_file(&self) -> bool {
        self.name.is_empty()
    }

    /// The value at a path: a key, or a section and a key of it.
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

    /// This is all of the table, and all of its sections: any other key is unknown.
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
