//! Keys of a configuration file: each stage declares its options once, in a table.
//!
//! From the table [`options!`] makes a struct with documentation and defaults, and its [`Keys`]: the function that
//! reads a file into it, and the description of every key, from which `config` makes the commented sample and the JSON
//! schema. The type and range of a value are a [`KeyKind`]; a kind that only one stage needs is in that stage.
//!
//! This module is below the stages: it depends on TOML, diagnostics and the axes of a machine, and contains no option.

mod axes;
mod kinds;
mod list;
mod reader;
mod table;

use serde_json::Value as Json;

pub(crate) use axes::{AxisEntry, AxisSet, PerAxis, along, letters, printed_along, solved};
pub(crate) use kinds::{Assumed, Blocks, LengthPoint, ListOf, Measure, OneLine, OneOf, Whole, YesNo};
pub(crate) use list::{KeyList, KeyRow, Printed, example_entries, printed_degrees, printed_number};
pub(crate) use reader::{Bound, KeyReader, QuantityKind, TomlValue, list, nearest};
pub(crate) use table::KeyTable;

use crate::kinematics::{AnyMachine, Axis, Dimension};

/// Context of the keys: the machine and the controls.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KeyScope {
    /// Name of the machine.
    pub(crate) machine: &'static str,
    /// Axes of the machine in chain order.
    pub(crate) axes: &'static [Axis],
    /// Dimensions of the machine.
    pub(crate) dimensions: &'static [Dimension],
    /// Whether at least one control has this work offset.
    pub(crate) is_work_offset: fn(&str) -> bool,
    /// Examples of the control of a sample, instead of the general ones: key, and value as TOML.
    pub(crate) examples: &'static [(&'static str, &'static str)],
}

impl KeyScope {
    /// Context of the keys for a machine.
    pub(crate) fn of(machine: &dyn AnyMachine, is_work_offset: fn(&str) -> bool) -> Self {
        Self {
            machine: machine.name(),
            axes: machine.axes(),
            dimensions: machine.dimensions(),
            is_work_offset,
            examples: &[],
        }
    }

    /// Examples of the control for a key; a table by axis has one for each axis, in order.
    pub(crate) fn examples_of(&self, key: &str) -> impl Iterator<Item = &'static str> {
        self.examples.iter().filter(move |(of, _)| *of == key).map(|(_, value)| *value)
    }
}

/// Options that a configuration file can set.
pub(crate) trait Keys {
    /// Reads every key that is in the file.
    fn read(&mut self, table: &mut KeyTable<'_>, r: &mut KeyReader<'_>);

    /// Adds every key to the list; the values of `self` are the defaults.
    fn describe(&self, list: &mut KeyList);
}

/// Kind of a key: type and range of its value.
pub(crate) trait KeyKind {
    /// Type of the value.
    type Value;

    /// Reads a value; reports its faults to `r`.
    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value>;

    /// Default as TOML.
    fn print(&self, value: &Self::Value) -> String;

    /// JSON schema of the value.
    fn schema(&self, scope: &KeyScope) -> Json;

    /// Value that is assumed if the key is absent, where there is one.
    fn assumed(&self) -> Option<Self::Value> {
        None
    }

    /// Value in the sample, where it depends on the machine; `None`: the default.
    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let _ = scope;
        None
    }

    /// Whether the key is listed among the keys that are given. Tables by axis, tool or frame are not: their maps hold
    /// only what is given.
    fn counts(&self) -> bool {
        true
    }
}

/// Field of an option: of the type of the value, or an `Option` of it.
pub(crate) trait Slot<V> {
    /// Sets the value.
    fn put(&mut self, value: V);

    /// The value, if there is one.
    fn filled(&self) -> Option<&V>;
}

impl<V> Slot<V> for V {
    fn put(&mut self, value: V) {
        *self = value;
    }

    fn filled(&self) -> Option<&V> {
        Some(self)
    }
}

impl<V> Slot<V> for Option<V> {
    fn put(&mut self, value: V) {
        *self = Some(value);
    }

    fn filled(&self) -> Option<&V> {
        self.as_ref()
    }
}

/// Reads the value at `path` into a field, if the file has that key.
pub(crate) fn read_into<K: KeyKind>(
    field: &mut impl Slot<K::Value>,
    kind: &K,
    path: &'static str,
    table: &mut KeyTable<'_>,
    r: &mut KeyReader<'_>,
) {
    let Some(value) = table.get(path, r) else { return };
    if table.is_file() && kind.counts() {
        r.mark_given(path);
    }
    if let Some(read) = kind.read(r, value) {
        field.put(read);
    }
}

/// Declares options as a table: a struct with public fields, its defaults, and its [`Keys`].
///
/// ```text
/// options! {
///     /// Approach to the part.
///     pub struct Approach in "approach" {
///         /// Distance of the approach point from the first point, along the tool axis.
///         distance: f64 = 50.0, key("approach.distance", Measure::length(Bound::Positive));
///     }
/// }
/// ```
///
/// A row has a field, its type and its default, followed by one of
/// - `key(path, kind)` or `key(path, kind, example)`: a key of the file. Its comment up to an empty line is its
///   description in the sample and in the schema, and the documentation of the field. The example is shown if there is
///   no default;
/// - `also(..)`: a key that the comment of the row before describes, too;
/// - `keys()`: the field is a table of options itself;
/// - nothing: the field is not a key of the file.
///
/// `in "section"`: the comment of the struct is the description of that section. `const NAME`: the defaults are also a
/// constant.
macro_rules! options {
    (
        $(#[doc = $about:literal])*
        pub struct $name:ident $(in $section:literal)? {
            $(
                $(#[doc = $doc:literal])*
                $field:ident: $type:ty = $default:expr $(, $how:ident($($what:tt)*))?;
            )*
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name {
            $(
                $(#[doc = $doc])*
                #[doc = ""]
                #[doc = concat!(
                    "Default `", stringify!($default), "`", $($crate::keys::options!(@key $how $($what)*),)? "."
                )]
                pub $field: $type,
            )*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)* }
            }
        }

        impl $crate::keys::Keys for $name {
            fn read(&mut self, table: &mut $crate::keys::KeyTable<'_>, r: &mut $crate::keys::KeyReader<'_>) {
                $($($crate::keys::options!(@read $how (&mut self.$field, table, r) $($what)*);)?)*
            }

            fn describe(&self, list: &mut $crate::keys::KeyList) {
                let about: &[&str] = &[$($about),*];
                list.begin(about, None $(.or(Some($section)))?);
                $(
                    let doc: &[&str] = &[$($doc),*];
                    $($crate::keys::options!(@describe $how (&self.$field, doc, list) $($what)*);)?
                    let _ = doc;
                )*
            }
        }
    };

    (
        $(#[doc = $about:literal])*
        pub struct $name:ident $(in $section:literal)?, const $constant:ident { $($rows:tt)* }
    ) => {
        $crate::keys::options! { $(#[doc = $about])* pub struct $name $(in $section)? { $($rows)* } }
        $crate::keys::options! { @constant $name $constant $($rows)* }
    };

    (
        @constant $name:ident $constant:ident
        $($(#[doc = $doc:literal])* $field:ident: $type:ty = $default:expr $(, $how:ident($($what:tt)*))?;)*
    ) => {
        impl $name {
            /// The defaults.
            pub const $constant: Self = Self { $($field: $default,)* };
        }
    };

    (@key keys) => { "" };
    (@key $how:ident $path:literal, $kind:expr $(, $example:literal)?) => {
        concat!("; key `", $path, "` as `", stringify!($kind), "`")
    };

    (@read keys ($field:expr, $table:ident, $r:ident)) => { $crate::keys::Keys::read($field, $table, $r) };
    (@read $how:ident ($field:expr, $table:ident, $r:ident) $path:literal, $kind:expr $(, $example:literal)?) => {
        $crate::keys::read_into($field, &$kind, $path, $table, $r)
    };

    (@describe keys ($field:expr, $doc:ident, $list:ident)) => {
        $crate::keys::Keys::describe($field, $list);
        $list.end()
    };
    (@describe key ($field:expr, $doc:ident, $list:ident) $path:literal, $kind:expr $(, $example:literal)?) => {
        $list.row($path, $doc, $field, &$kind, None $(.or(Some($example)))?)
    };
    (@describe also ($field:expr, $doc:ident, $list:ident) $path:literal, $kind:expr $(, $example:literal)?) => {
        $list.row($path, &[], $field, &$kind, None $(.or(Some($example)))?)
    };
}
pub(crate) use options;
