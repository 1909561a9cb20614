//! The stock as it is cut, with few lines: what a page needs to show the removal at every block.

use crate::simulate::removal::{Profile, Removed, SweptPiece, TriDexel};

/// Lines along the longest side: at most.
const MOST_LINES: usize = 90;

/// Parts of lines that are kept: at most.
const MOST_PARTS: usize = 3_000_000;

/// Tolerance of the removal, mm.
const EPS_MM: f64 = 1e-2;

/// A part of a line that a block has removed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RemovedPart {
    /// Number of the line over all families.
    pub(crate) stock_line: u32,
    pub(crate) ends: [f32; 2],
    /// Line of the program.
    pub(crate) line: u32,
}

/// The removal while the part is clamped in one set-up.
#[derive(Debug, Clone)]
pub(crate) struct ClampedStage {
    pub(crate) set_up: u32,
    pub(crate) corners: [[f64; 3]; 2],
    /// Number of lines along each axis.
    pub(crate) counts: [usize; 3],
    /// Material at the begin: number of the line over all families, and both ends.
    pub(crate) material: Vec<(u32, [f32; 2])>,
    /// In the order of the program.
    pub(crate) removed: Vec<RemovedPart>,
}

/// The recorded removal.
#[derive(Debug, Clone)]
pub(crate) struct Recording {
    stock: TriDexel,
    stages: Vec<ClampedStage>,
    parts: usize,
}

/// Number of the first line of a family over all families.
fn first_line(counts: [usize; 3], family: usize) -> usize {
    (0..family).map(|before| counts[(before + 1) % 3] * counts[(before + 2) % 3]).sum()
}

impl ClampedStage {
    fn of(set_up: u32, stock: &TriDexel) -> Self {
        let counts = stock.counts();
        let mut material = Vec::new();
        for family in 0..3 {
            let mut number = first_line(counts, family) as u32;
            stock.each(family, |_, spans| {
                material.extend(spans.iter().map(|span| (number, [span.low, span.high])));
                number += 1;
            });
        }
        Self { set_up, corners: stock.corners(), counts, material, removed: Vec::new() }
    }
}

impl Recording {
    pub(crate) fn of(stock: &TriDexel, set_up: u32) -> Self {
        let longest = stock.counts().into_iter().fold(1, usize::max);
        let step = longest.div_ceil(MOST_LINES);
        let stock = stock.thinned(step + usize::from(step.is_multiple_of(2)));
        Self { stages: vec![ClampedStage::of(set_up, &stock)], stock, parts: 0 }
    }

    /// Cuts by the pieces that remove material.
    pub(super) fn cut(&mut self, pieces: &[SweptPiece], profiles: &[Profile], threads: usize) {
        let Some(stage) = self.stages.last_mut().filter(|_| self.parts <= MOST_PARTS) else { return };
        let cutting: Vec<SweptPiece> = pieces.iter().filter(|piece| piece.removes()).copied().collect();
        let counts = stage.counts;
        let before = stage.removed.len();
        self.stock.cut_and_show(&cutting, profiles, EPS_MM, threads, |removed| {
            let Removed { piece, family, line, length, middle } = *removed;
            let stock_line = first_line(counts, family) + line[1] * counts[(family + 1) % 3] + line[0];
            let ends = [middle - 0.5 * length, middle + 0.5 * length].map(|end| end as f32);
            stage.removed.push(RemovedPart { stock_line: stock_line as u32, ends, line: cutting[piece].name() });
        });
        // Each line has its parts in their order already.
        stage.removed[before..].sort_by_key(|part| part.line);
        self.parts += stage.removed.len() - before;
    }

    /// Moves the stock to another set-up.
    pub(super) fn clamp(&mut self, set_up: u32, moved: impl FnOnce(&TriDexel) -> Option<TriDexel>) {
        if let Some(stock) = moved(&self.stock) {
            self.stages.push(ClampedStage::of(set_up, &stock));
            self.stock = stock;
        }
    }

    /// The removal by set-ups in their order; `None`: it has too many parts to be kept.
    pub(crate) fn stages(self) -> Option<Vec<ClampedStage>> {
        (self.parts <= MOST_PARTS).then_some(self.stages)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::removal::Cutter;
    use crate::simulate::testing::upright;

    #[test]
    fn the_recorded_parts_are_what_the_stock_has_lost() {
        let stock = TriDexel::block([[0.0; 3], [60.0, 40.0, 20.0]], 0.5).expect("a stock");
        let mut recording = Recording::of(&stock, 1);
        let ball = Cutter::Mill { radius: 4.0, corner: 4.0, taper: 0.0, length: 30.0 }.pieces().expect("a tool");
        let row = |y: f64, id: u32| SweptPiece::new(&upright([-5.0, y, 17.0]), &upright([65.0, y, 15.0]), 0, id);
        // The second row overlaps the first one; the third only touches.
        for pieces in [vec![row(10.0, 3), row(13.0, 4)], vec![row(30.0, 6).touching(), row(20.0, 8)]] {
            recording.cut(&pieces, &ball, 1);
        }
        let left = recording.stock.volumes();
        let stages = recording.stages().expect("few parts");
        let [stage] = stages.as_slice() else { panic!("{} stages", stages.len()) };
        assert_eq!(stage.counts, [40, 27, 13]);
        let pitch: [f64; 3] =
            std::array::from_fn(|axis| (stage.corners[1][axis] - stage.corners[0][axis]) / stage.counts[axis] as f64);
        let mut lengths = [0.0; 3];
        let mut add = |line: u32, [low, high]: [f32; 2], sign: f64| {
            let family = (0..3).rfind(|family| first_line(stage.counts, *family) <= line as usize).expect("a family");
            lengths[family] += sign * f64::from(high - low);
        };
        stage.material.iter().for_each(|(line, ends)| add(*line, *ends, 1.0));
        stage.removed.iter().for_each(|part| add(part.stock_line, part.ends, -1.0));
        for family in 0..3 {
            let volume = lengths[family] * pitch[(family + 1) % 3] * pitch[(family + 2) % 3];
            assert!((volume - left[family]).abs() < 1e-3 * left[family], "{family}: {volume}, not {}", left[family]);
        }
        let lines: Vec<u32> = stage.removed.iter().map(|part| part.line).collect();
        assert!(lines.is_sorted() && [3, 4, 8].iter().all(|line| lines.contains(line)) && !lines.contains(&6));
    }
}
