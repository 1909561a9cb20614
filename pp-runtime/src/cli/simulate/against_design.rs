//! The machined stock against the design, as sentences and as JSON.

use serde::Serialize;

use crate::simulate::{ComparisonLimits, DesignComparison, Deviations, LineRecords, Origin, Region, limits_of};

/// Regions of each kind that are sentences; JSON has all that are kept.
const MOST_SENTENCES: usize = 20;

/// Largest width of a bar of the histogram, characters.
const BAR: f64 = 40.0;

/// Tolerances of a comparison, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct DesignTolerances {
    pub(super) gouge_mm: f64,
    pub(super) rest_mm: f64,
    /// Of the triangles of the design.
    pub(super) design_mm: f64,
    /// Of the ends of the machined stock.
    pub(super) certified_mm: f64,
}

impl DesignTolerances {
    /// Distance from which there is a gouge.
    pub(super) fn gouge_limit_mm(&self) -> f64 {
        self.gouge_mm + self.design_mm + self.certified_mm
    }

    /// Distance from which there is rest material.
    pub(super) fn rest_limit_mm(&self) -> f64 {
        self.rest_mm + self.design_mm + self.certified_mm
    }

    /// Limits of the comparison.
    pub(super) fn limits(&self) -> ComparisonLimits {
        ComparisonLimits {
            gouge_mm: self.gouge_limit_mm(),
            rest_mm: self.rest_limit_mm(),
            thin_mm: 2.0 * self.certified_mm,
        }
    }
}

/// A comparison with the records of its lines.
pub(super) struct AgainstDesign {
    pub(super) comparison: DesignComparison,
    pub(super) records: LineRecords,
    pub(super) tolerances: DesignTolerances,
    /// Name of the design, and number of its triangles.
    pub(super) name: String,
    pub(super) triangles: usize,
}

/// A comparison as JSON.
#[derive(Serialize)]
pub(super) struct DesignFigures {
    gouge_tolerance_mm: f64,
    rest_tolerance_mm: f64,
    design_tolerance_mm: f64,
    certified_mm: f64,
    largest_gouge_mm: f64,
    largest_gouge_place_mm: Option<[f64; 3]>,
    largest_rest_mm: f64,
    largest_rest_place_mm: Option<[f64; 3]>,
    /// Largest distance by which the design exceeds the box of the stock; it is not compared there.
    exceeds_stock_mm: f64,
    gouge_count: u64,
    rest_count: u64,
    gouges: Vec<RegionFigures>,
    rests: Vec<RegionFigures>,
    histogram: Vec<Class>,
}

/// A region; line, CL line, operation and tool are null where they are unknown.
#[derive(Serialize)]
struct RegionFigures {
    text: String,
    deviation_mm: f64,
    place_mm: [f64; 3],
    size_mm: [f64; 3],
    /// No motion has cut there.
    blank: bool,
    line: Option<u32>,
    cl_line: Option<u64>,
    operation: Option<u64>,
    tool: Option<u32>,
}

/// A class of the histogram; an open limit is null.
#[derive(Serialize)]
struct Class {
    from_mm: Option<f64>,
    to_mm: Option<f64>,
    ends: u64,
}

impl AgainstDesign {
    /// Whether there is a gouge beyond the tolerance, or a part of the design outside the stock.
    pub(super) fn gouges(&self) -> bool {
        self.comparison.gouge.count > 0 || self.exceeds()
    }

    fn exceeds(&self) -> bool {
        self.comparison.exceeds_mm > self.tolerances.gouge_limit_mm()
    }

    /// What has not been compared.
    pub(super) fn not_checked(&self) -> Vec<String> {
        let uneven = self.comparison.uneven;
        let lines = format!("{uneven} lines of the stock that enter the design more often than they leave it");
        (uneven > 0).then_some(lines).into_iter().collect()
    }

    fn cause(&self, origin: Origin) -> String {
        match origin {
            Origin::Blank => "as the blank".to_owned(),
            Origin::Unknown => "line of the program unknown".to_owned(),
            Origin::Line(line) => match self.records.get(line) {
                Some(found) => format!(
                    "line {line} of the program (CL line {}), operation {}, tool {}",
                    found.cl_line, found.operation, found.tool
                ),
                None => format!("line {line} of the program"),
            },
        }
    }

    fn sentence(&self, what: &str, region: &Region) -> String {
        let ([x, y, z], [along_x, along_y, along_z]) = (region.place_mm, region.size_mm);
        format!(
            "{what}: {:.3} mm at X{x:.2} Y{y:.2} Z{z:.2}, over {along_x:.2} x {along_y:.2} x {along_z:.2} mm, {}",
            region.deviation_mm,
            self.cause(region.origin)
        )
    }

    fn sentences(&self, what: &str, found: &Deviations) -> Vec<String> {
        let shown = found.regions.iter().take(MOST_SENTENCES);
        let mut all: Vec<String> = shown.map(|region| self.sentence(what, region)).collect();
        let more = found.count - all.len() as u64;
        if more > 0 {
            all.push(format!("{what}: {more} more places"));
        }
        all
    }

    /// The largest values in one line.
    pub(super) fn line(&self) -> String {
        let DesignTolerances { gouge_mm, rest_mm, .. } = self.tolerances;
        let DesignComparison { gouge, rest, .. } = &self.comparison;
        format!("gouge {:.3} mm of {gouge_mm}, rest {:.3} mm of {rest_mm}", gouge.largest_mm, rest.largest_mm)
    }

    /// Gouges, the largest first.
    pub(super) fn warnings(&self) -> Vec<String> {
        let mut all = self.sentences("gouge", &self.comparison.gouge);
        if self.exceeds() {
            let exceeds = self.comparison.exceeds_mm;
            all.push(format!(
                "gouge: the design exceeds the box of the stock by {exceeds:.3} mm and is not compared there"
            ));
        }
        all
    }

    /// Rest material, the largest values, and the histogram.
    pub(super) fn notes(&self) -> Vec<String> {
        let Self { name, triangles, .. } = self;
        let DesignTolerances { design_mm, certified_mm, .. } = self.tolerances;
        let DesignComparison { rest, histogram, .. } = &self.comparison;
        let mut all = self.sentences("rest material", rest);
        all.push(format!(
            "{}, against {name}, {triangles} triangles, mm in the coordinates \
             of the CL data; allowed besides: {certified_mm:.4} mm of the machined stock, {design_mm} mm of the design",
            self.line(),
        ));
        let ends: u64 = histogram.iter().sum();
        all.push(format!("distance of {ends} ends of the stock from the design (below 0: inside):"));
        let classes = histogram.iter().enumerate().filter(|(_, count)| **count > 0);
        all.extend(classes.map(|(class, count)| {
            let [from, to] = limits_of(class);
            let limits = match (from.is_finite(), to.is_finite()) {
                (false, _) => format!("below {to} mm"),
                (_, false) => format!("above {from} mm"),
                _ => format!("{from} to {to} mm"),
            };
            let share = *count as f64 / ends as f64;
            let bar = "#".repeat((share * BAR).ceil() as usize);
            format!("{limits:>18} {:6.2} % {bar}", share * 100.0)
        }));
        all
    }

    pub(super) fn figures(&self) -> DesignFigures {
        let DesignTolerances { gouge_mm, rest_mm, design_mm, certified_mm } = self.tolerances;
        let DesignComparison { gouge, rest, histogram, .. } = &self.comparison;
        let regions = |what: &str, found: &Deviations| {
            found.regions.iter().map(|region| self.region(self.sentence(what, region), region)).collect()
        };
        let place = |found: &Deviations| (found.largest_mm > 0.0).then_some(found.place_mm);
        let finite = |limit: f64| limit.is_finite().then_some(limit);
        let classes = histogram.iter().enumerate().map(|(class, ends)| {
            let [from, to] = limits_of(class);
            Class { from_mm: finite(from), to_mm: finite(to), ends: *ends }
        });
        DesignFigures {
            gouge_tolerance_mm: gouge_mm,
            rest_tolerance_mm: rest_mm,
            design_tolerance_mm: design_mm,
            certified_mm,
            largest_gouge_mm: gouge.largest_mm,
            largest_gouge_place_mm: place(gouge),
            largest_rest_mm: rest.largest_mm,
            largest_rest_place_mm: place(rest),
            exceeds_stock_mm: self.comparison.exceeds_mm,
            gouge_count: gouge.count,
            rest_count: rest.count,
            gouges: regions("gouge", gouge),
            rests: regions("rest material", rest),
            histogram: classes.collect(),
        }
    }

    fn region(&self, text: String, region: &Region) -> RegionFigures {
        let line = match region.origin {
            Origin::Line(line) => Some(line),
            Origin::Blank | Origin::Unknown => None,
        };
        let record = line.and_then(|line| self.records.get(line));
        RegionFigures {
            text,
            deviation_mm: region.deviation_mm,
            place_mm: region.place_mm,
            size_mm: region.size_mm,
            blank: region.origin == Origin::Blank,
            line,
            cl_line: record.map(|record| record.cl_line),
            operation: record.map(|record| record.operation),
            tool: record.map(|record| record.tool),
        }
    }
}
