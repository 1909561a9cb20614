//! Solids of machine, fixtures and part, for `simulate` and `view`.
//!
//! A solid of the table side is in the coordinates of the table, from its reference point; one of the head is in the
//! coordinates of the spindle, from the gauge line. Both with all axes at zero: so is `d` of the machine's declaration.
//! Solids of the frame are where they are in that position, in which the spindle nose is at the reference point of the
//! table.

mod keys;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use nalgebra::{Rotation3, Vector3};

use crate::keys::{Bound, Measure, options};

use keys::{Pairs, SolidKind, SolidList};

pub(crate) use keys::SolidTable;

options! {
    /// Solids of the machine, of fixtures on the table, and of the part.
    pub struct Solids {
        /// Least distance between two solids that move against each other; a smaller one is a finding.
        clearance_mm: f64 = 0.0, key("clearance", Measure::length(Bound::NotNegative));
        /// Pairs that may meet, by link or by name of a solid: guideways, a tool and its soft jaws.
        allow: Vec<[String; 2]> = Vec::new(), key("allow", Pairs);
        /// Blank in the coordinates of the CL data; without it the box of `[stock]`.
        stock: Option<Solid> = None, key("stock", SolidKind("stock"), "\"blank.stl\"");
        /// Finished part in the coordinates of the CL data.
        design: Option<Solid> = None, key("design", SolidKind("design"), "{ stl = \"part.stl\", tolerance = 0.01 }");
        /// Solids that stay where they are.
        frame: Vec<Solid> = Vec::new(),
            key("frame", SolidList("frame", "{ box = [[-400.0, 300.0, -500.0], [400.0, 600.0, 900.0]] }"));
        /// Solids that move with the part.
        table: Vec<Solid> = Vec::new(), key("table", SolidList("table", "{ cylinder = [320.0, 60.0], at = [0.0, 0.0, -60.0] }"));
        /// Fixtures and clamps on the table.
        fixtures: Vec<Solid> = Vec::new(),
            key("fixtures", SolidList("fixtures", "{ name = \"vise\", box = [[-90.0, -60.0, 0.0], [90.0, 60.0, 40.0]] }"));
        /// Solids that move with the tool.
        spindle: Vec<Solid> = Vec::new(),
            key("spindle", SolidList("spindle", "{ turned = [[0.0, 0.0], [60.0, 0.0], [90.0, 120.0], [0.0, 120.0]] }"));
        /// Solids that each axis moves, without those of the axes after it.
        axes: BTreeMap<char, Vec<Solid>> = BTreeMap::new();
        /// Folder from which names of files count: that of the configuration.
        folder: PathBuf = PathBuf::new();
    }
}

/// Where a solid is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SolidLink {
    /// The bed.
    Frame,
    /// The part.
    Table,
    /// A fixture on the table.
    Fixture,
    /// What an axis moves.
    Axis(char),
    /// The spindle.
    Spindle,
}

impl SolidLink {
    /// Name, as in configuration files.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Frame => "frame".to_owned(),
            Self::Table => "table".to_owned(),
            Self::Fixture => "fixtures".to_owned(),
            Self::Axis(letter) => letter.to_string(),
            Self::Spindle => "spindle".to_owned(),
        }
    }
}

impl Solids {
    /// All solids of machine and fixtures.
    pub fn of_machine(&self) -> impl Iterator<Item = (SolidLink, &Solid)> {
        let lists = [
            (SolidLink::Frame, &self.frame),
            (SolidLink::Table, &self.table),
            (SolidLink::Fixture, &self.fixtures),
            (SolidLink::Spindle, &self.spindle),
        ];
        let axes = self.axes.iter().map(|(letter, solids)| (SolidLink::Axis(*letter), solids));
        lists.into_iter().chain(axes).flat_map(|(link, solids)| solids.iter().map(move |solid| (link, solid)))
    }

    /// Paths of the files of all solids, of stock and design as well.
    pub fn paths(&self) -> impl Iterator<Item = PathBuf> {
        let all = self.stock.iter().chain(&self.design).chain(self.of_machine().map(|(_, solid)| solid));
        all.filter_map(|solid| match &solid.shape {
            SolidShape::Stl { file, .. } => Some(self.path(file)),
            SolidShape::Box(_) | SolidShape::Cylinder { .. } | SolidShape::Turned(_) => None,
        })
    }

    /// Path of a file of a solid.
    #[must_use]
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}

/// Shape of a solid, mm.
#[derive(Debug, Clone, PartialEq)]
pub enum SolidShape {
    /// Triangles of an STL file.
    Stl {
        /// Name of the file.
        file: String,
        /// Length of its unit.
        unit_mm: f64,
    },
    /// A box: the corners with the smallest and the largest coordinates.
    Box([[f64; 3]; 2]),
    /// A cylinder along Z, from Z0 up.
    Cylinder {
        /// Diameter.
        diameter: f64,
        /// Height.
        height: f64,
    },
    /// A closed outline that is rotated about Z: diameters with their heights.
    Turned(Vec<[f64; 2]>),
}

/// A solid.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// Name for findings and for `allow`.
    pub name: Option<String>,
    /// Its shape.
    pub shape: SolidShape,
    /// The shape is rotated by this,
    pub rotation: Rotation3<f64>,
    /// and then moved by this, mm.
    pub at_mm: [f64; 3],
    /// Largest distance of the triangles of an STL file from the real surface, mm.
    pub tolerance_mm: f64,
    /// Set-ups in which a fixture is on the table; empty: all.
    pub set_ups: Vec<u32>,
}

impl Solid {
    /// Name of the solid: its own, or that of its file.
    #[must_use]
    pub fn own_name(&self) -> Option<String> {
        let stem = |file: &String| Path::new(file).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        self.name.clone().or_else(|| match &self.shape {
            SolidShape::Stl { file, .. } => stem(file),
            SolidShape::Box(_) | SolidShape::Cylinder { .. } | SolidShape::Turned(_) => None,
        })
    }

    /// A point of the shape where the solid is.
    #[must_use]
    pub fn placed(&self, point: [f64; 3]) -> [f64; 3] {
        (self.rotation * Vector3::from(point) + Vector3::from(self.at_mm)).into()
    }
}
