//! What a simulation adds to the page of its program: machined stock, design, solids of the machine, findings, and the
//! removal of the stock.

use std::io;

use serde::Serialize;

use super::columns::{Column, Columns};

/// Step of coordinates, mm.
const STEP_MM: f64 = 1e-4;

/// Rows of numbers.
#[derive(Debug, Serialize)]
struct NumberTable {
    rows: usize,
    columns: Vec<Column>,
    /// Compressed, in base64.
    data: String,
}

impl NumberTable {
    fn of(rows: usize, columns: Columns) -> io::Result<Self> {
        let (columns, data) = columns.encoded()?;
        Ok(Self { rows, columns, data })
    }
}

/// What a body is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Role {
    /// The machined stock, in the coordinates of the set-up in which it lies.
    Machined,
    /// The design, where the machined stock is.
    Design,
    /// A solid of the machine, in the coordinates of its link.
    Machine,
    /// A fixture on the table.
    Fixture,
}

/// A body as triangles.
#[derive(Debug, Serialize)]
pub(crate) struct PageBody {
    name: String,
    role: Role,
    /// Number of the link: 0 has the part, the last one the tool.
    link: usize,
    /// Indices of the set-ups in which it is there; empty: all.
    set_ups: Vec<usize>,
    vertices: NumberTable,
    faces: NumberTable,
}

/// Vertices and triangles, counter-clockwise from outside.
type ViewTriangles<'t> = (&'t [[f64; 3]], &'t [[u32; 3]]);

impl PageBody {
    pub(crate) fn new(name: &str, role: Role, link: usize, triangles: ViewTriangles<'_>) -> io::Result<Self> {
        Self::marked(name, role, link, triangles, None)
    }

    /// A body in some set-ups only.
    pub(crate) fn within(self, set_ups: Vec<usize>) -> Self {
        Self { set_ups, ..self }
    }

    /// A body with a deviation at each vertex, mm, and the line of the program that has cut it.
    pub(crate) fn marked(
        name: &str,
        role: Role,
        link: usize,
        (vertices, faces): ViewTriangles<'_>,
        marks: Option<(&[f32], &[u32])>,
    ) -> io::Result<Self> {
        let mut columns = Columns::default();
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            columns.quantised(letter, STEP_MM, vertices.iter().map(|vertex| vertex[axis]));
        }
        if let Some((values, lines)) = marks {
            columns.floats("value", values.iter().map(|value| Some(f64::from(*value)).filter(|value| !value.is_nan())));
            columns.quantised(
                "line",
                1.0,
                lines.iter().map(|line| if *line == u32::MAX { -1.0 } else { f64::from(*line) }),
            );
        }
        let vertices = NumberTable::of(vertices.len(), columns)?;
        let mut columns = Columns::default();
        for (corner, letter) in ["a", "b", "c"].into_iter().enumerate() {
            columns.quantised(letter, 1.0, faces.iter().map(|face| f64::from(face[corner])));
        }
        let faces = NumberTable::of(faces.len(), columns)?;
        Ok(Self { name: name.to_owned(), role, link, set_ups: Vec::new(), vertices, faces })
    }
}

/// A part of a tool: convex outlines of radii and heights above the tip, mm.
#[derive(Debug, Serialize)]
pub(crate) struct ToolPart {
    pub(crate) part: &'static str,
    pub(crate) outlines: Vec<Vec<[f64; 2]>>,
}

/// Parts of lines of a stock: number of the line over all families, lower and upper end, and a line of the program.
pub(crate) type SimulatedLinePart = (u32, [f32; 2], u32);

/// The stock as it is cut in one set-up, with few lines.
#[derive(Debug, Serialize)]
pub(crate) struct PageStage {
    /// Index of the set-up.
    set_up: usize,
    corners: [[f64; 3]; 2],
    /// Number of lines along each axis.
    counts: [usize; 3],
    /// Material at the begin.
    material: NumberTable,
    /// What is removed, in the order of the program.
    removed: NumberTable,
}

impl PageStage {
    pub(crate) fn new(
        set_up: usize,
        corners: [[f64; 3]; 2],
        counts: [usize; 3],
        material: impl Iterator<Item = SimulatedLinePart> + Clone,
        removed: impl Iterator<Item = SimulatedLinePart> + Clone,
    ) -> io::Result<Self> {
        Ok(Self { set_up, corners, counts, material: parts(material)?, removed: parts(removed)? })
    }
}

fn parts(parts: impl Iterator<Item = SimulatedLinePart> + Clone) -> io::Result<NumberTable> {
    let mut columns = Columns::default();
    columns.quantised("stock_line", 1.0, parts.clone().map(|part| f64::from(part.0)));
    columns.quantised("low", 1e-3, parts.clone().map(|part| f64::from(part.1[0])));
    columns.quantised("high", 1e-3, parts.clone().map(|part| f64::from(part.1[1])));
    columns.quantised("line", 1.0, parts.clone().map(|part| f64::from(part.2)));
    NumberTable::of(parts.count(), columns)
}

/// A simulation as the page shows it. Lengths in mm.
#[derive(Debug, Serialize)]
pub(crate) struct SimulatedPage {
    /// Version of these data.
    pub(crate) format: u32,
    /// The result in one line.
    pub(crate) line: String,
    /// Lines of the summary.
    #[serde(skip)]
    pub(crate) summary: Vec<String>,
    /// The figures of `--json`.
    pub(crate) figures: serde_json::Value,
    pub(crate) bodies: Vec<PageBody>,
    /// Parts of each tool, by its number.
    pub(crate) tools: Vec<(u32, Vec<ToolPart>)>,
    /// For each placement the place of each link's coordinates in the zero position.
    pub(crate) link_places: Vec<Vec<[f64; 3]>>,
    /// For each set-up of the page the place of the machined stock: a matrix in columns; null: unknown.
    pub(crate) part_places: Vec<Option<Vec<f64>>>,
    /// The stock as it is cut, by set-ups; null: too much to be shown.
    pub(crate) stages: Option<Vec<PageStage>>,
}
