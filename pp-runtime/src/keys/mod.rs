//! Keys of a configuration file: a stage declares its options once, in a table, and everything else follows.
//!
//! [`options!`] makes of a table the struct with its documentation and defaults and its [`Keys`]: how a file is read
//! into it, and a description of every key, from which `config` prints the commented sample and the schema. What a
//! value has to be is a [`KeyKind`]; those that one stage alone needs are with that stage.
//!
//! This module is below the stages: it knows TOML, diagnostics and the axes of a machine, and no option.

mod axes;
mod kinds;
mod list;
mod reader;
mod table;

use serde_json::Value as Json;

pub(crate) use axes::{AxisEntry, AxisSet, PerAxis, along, letters, printed_along, solved};
pub(crate) use kinds::{Assumed, LengthPoint, ListOf, Measure, OneLine, OneOf, Whole, YesNo};
pub(crate) use list::{KeyList, KeyRow, Printed, example_entries, printed_degrees, printed_number};
pub(crate) use reader::{Bound, KeyReader, Quantity, TomlValue, list, nearest};
pub(crate) use table::KeyTable;

use crate::kinematics::{Axis, Dimension, Machine};

/// What keys depend on besides their own value.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KeyScope {
    /// Name of the machine.
    pub(crate) machine: &'static str,
    /// Its axes in chain order.
    pub(crate) axes: &'static [Axis],
    /// Its dimensions.
    pub(crate) dimensions: &'static [Dimension],
    /// Whether one of the controls has this work offset.
    pub(crate) is_work_offset: fn(&str) -> bool,
}

impl KeyScope {
    /// Keys of the machine `M`.
    pub(crate) fn of<M: Machine>(is_work_offset: fn(&str) -> bool) -> Self {
        Self { machine: M::NAME, axes: M::AXES, dimensions: M::DIMENSIONS, is_work_offset }
    }
}

/// Options that a configuration file can set.
pub(crate) trait Keys {
    /// Reads every key that the file has.
    fn read(&mut self, table: &mut KeyTable<'_>, r: &mut KeyReader<'_>);

    /// Describes every key; the values in here are the defaults.
    fn describe(&self, list: &mut KeyList);
}

/// What the value of a key has to be.
pub(crate) trait KeyKind {
    /// What is read.
    type Value;

    /// Reads a value; what is wrong with it is told.
    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value>;

    /// How a default is printed, as TOML.
    fn print(&self, value: &Self::Value) -> String;

    /// The JSON schema of a value.
    fn schema(&self, scope: &KeyScope) -> Json;

    /// What an absent value is taken for, where that is a value.
    fn assumed(&self) -> Option<Self::Value> {
        None
    }

    /// How it is printed where the machine decides; `None`: by its default.
    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let _ = scope;
        None
    }

    /// A value counts among the keys that were given. Tables whose entries count by themselves do not.
    fn counts(&self) -> bool {
        true
    }
}

/// The field of an option: of the type that is read, or an option of it.
pub(crate) trait Slot<V> {
    /// Takes what was read.
    fn put(&mut self, value: V);

    /// What is in it.
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

/// Reads the value at `path` into a field, if the file has it.
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

/// Declares options as a table: a struct whose fields are public, its defaults, and its [`Keys`].
///
/// ```text
/// options! {
///     /// How to get to the part.
///     pub struct Approach in "approach" {
///         /// The approach point is this far from the first point along the tool axis.
///         distance: f64 = 50.0, key("approach.distance", Measure::length(Bound::Positive));
///     }
/// }
/// ```
///
/// A row is a field, its type and its default, and then
/// - `key(path, kind)` or `key(path, kind, example)`: a key of the file. Its comment, up to an empty line, is its
///   description in the sample and in the schema, and the documentation of the field. The example is shown where there
///   is no default;
/// - `also(..)`: the same, described by the row above;
/// - `keys()`: options of their own;
/// - nothing: no key of a file.
///
/// With `in "section"` the comment of the struct heads that section of the sample; with `const NAME` the defaults are
/// also a constant.
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
