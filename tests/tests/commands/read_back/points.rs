//! Points of CL data, read by a short reader that shares no code with the product's.

use std::collections::BTreeMap;

use approx::assert_abs_diff_eq;
use pp_runtime::nalgebra::{Point3, Vector3};

/// A GOTO; millimetres.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Goto {
    /// Line of the CL data, from 1.
    pub(crate) line: usize,
    pub(crate) tip: Point3<f64>,
    /// Unit length.
    pub(crate) axis: Vector3<f64>,
    pub(crate) rapid: bool,
    /// 0 before the first FEDRAT.
    pub(crate) feed_mm_per_min: f64,
    /// Number of TOOL PATH records, tool records and stops before it.
    pub(crate) operation: usize,
    pub(crate) tool: u32,
}

/// Points and tool lengths of the CL data.
#[derive(Debug, Clone, Default)]
pub(crate) struct ClData {
    pub(crate) points: Vec<Goto>,
    /// LENGTH of LOADTL by tool, mm.
    pub(crate) lengths: BTreeMap<u32, f64>,
}

/// Records with the line in which each begins; comments are removed, continued lines are joined.
fn records(text: &str) -> Vec<(usize, String)> {
    let mut records = Vec::new();
    let mut open: Option<(usize, String)> = None;
    let mut in_comment = false;
    for (index, line) in text.lines().enumerate() {
        let comment = in_comment || line.starts_with("$$");
        if comment {
            // Creo continues its own comments.
            in_comment = (in_comment || line.starts_with("$$->")) && line.trim_end().ends_with('$');
            continue;
        }
        let (begun, before) = open.take().unwrap_or((index + 1, String::new()));
        match line.trim_end().strip_suffix('$') {
            Some(part) => open = Some((begun, before + part)),
            None => records.push((begun, before + line)),
        }
    }
    records
}

pub(crate) fn read(text: &str) -> ClData {
    let mut cl = ClData::default();
    let (mut unit, mut rapid, mut feed, mut operation, mut tool) = (1.0, false, 0.0, 0, 0);
    let mut axis = Vector3::z();
    for (line, record) in records(text) {
        let (word, rest) = record.split_once('/').unwrap_or((&record, ""));
        let arguments: Vec<&str> = rest.split(',').map(str::trim).collect();
        let numbers: Vec<f64> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
        match word.trim() {
            "UNITS" => unit = if arguments[0].starts_with("INCH") { 25.4 } else { 1.0 },
            "RAPID" => rapid = true,
            "FEDRAT" => {
                assert!(arguments.iter().all(|word| *word != "IPM") || unit > 1.0, "feed in inches of a file in mm");
                feed = numbers[0] * unit;
            }
            "TOOL PATH" => {
                operation += 1;
                axis = Vector3::z();
            }
            "STOP" | "OPSTOP" => operation += 1,
            "LOADTL" | "LOAD" => {
                operation += 1;
                tool = numbers[0] as u32;
                if arguments.get(1) == Some(&"LENGTH") {
                    cl.lengths.insert(tool, numbers[1] * unit);
                }
            }
            "GOTO" => {
                if let [_, _, _, i, j, k] = numbers[..] {
                    axis = Vector3::new(i, j, k).normalize();
                }
                assert!(numbers.len() == 3 || numbers.len() == 6, "line {line}: {record}");
                let tip = Point3::new(numbers[0] * unit, numbers[1] * unit, numbers[2] * unit);
                cl.points.push(Goto { line, tip, axis, rapid, feed_mm_per_min: feed, operation, tool });
                rapid = false;
            }
            _ => {}
        }
    }
    cl
}

#[test]
fn every_goto_of_the_three_dialects_is_found() {
    let nx = read("UNITS/INCH\nRAPID\nGOTO/1.0,2.0,3.0,0.0,0.6,0.8\nFEDRAT/IPM,10.0\nGOTO/1.0,2.0,2.0\n");
    assert_eq!(nx.points.len(), 2);
    assert_abs_diff_eq!(nx.points[1].tip, Point3::new(25.4, 50.8, 50.8), epsilon = 5e-13);
    assert_abs_diff_eq!(nx.points[1].axis, Vector3::new(0.0, 0.6, 0.8), epsilon = 5e-13);
    assert_eq!((nx.points[0].rapid, nx.points[1].rapid), (true, false));
    assert_abs_diff_eq!(nx.points[1].feed_mm_per_min, 254.0, epsilon = 1e-12);
    let catia = read("GOTO  /  1.0, 2.0, 3.0, 0.0, 0.0, 0$\n.5\n$$ GOTO/9,9,9 $\nGOTO/4,5,6\n");
    assert_eq!(catia.points.len(), 2);
    let creo = read("$$-> CSYS / 1.0,  $\nGOTO / 0.0\nGOTO / 1.0, 2.0, 3.0,  $\n0.0, 0.0, 1.0\n");
    assert_eq!((creo.points.len(), creo.points[0].line), (1, 3));
}
