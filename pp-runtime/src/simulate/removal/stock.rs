//! The stock: three families of parallel lines, each with the parts that are material.
//!
//! A family has its lines along X, Y or Z, a pitch apart, in tiles of 16 x 16. A span of a line is two coordinates and
//! the names of the pieces that cut there: 16 bytes. Where a line has several spans they are in a list of the tile. A
//! tile whose lines are all alike has one span for all of them, as in a blank that is not cut there, and where nothing
//! is left. Within a tile lines are in blocks of 4 x 4; a block that a piece does not reach is left out as a whole, by
//! the line in its middle and the tool grown by half its diagonal.
//!
//! Every line and piece is independent of the others, so tiles are cut by several threads, and each line is cut by the
//! pieces in their order. The result does not depend on the number of threads.

use std::sync::Mutex;

use super::in_order::InOrder;
use super::profile::Profile;
use super::sweep::{Covered, EightLines, LANES, SweptPiece, SweptSpace};

/// Lines of a tile in each direction.
const TILE: usize = 16;

/// Lines of a block in each direction.
const BLOCK: usize = 4;

/// Blocks of a tile.
const BLOCKS: usize = (TILE / BLOCK) * (TILE / BLOCK);

/// Accuracy with which tiles and blocks are compared with a piece, mm; they are taken larger by it.
const COARSE_MM: f64 = 0.1;

/// Largest number of lines of a stock.
const MOST_LINES: f64 = 4e8;

/// A part of a line that is material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilledPart {
    /// Lower end, mm.
    pub low: f32,
    /// Upper end, mm.
    pub high: f32,
    /// Name of the piece that cut the lower end; 0: the blank.
    pub low_id: u32,
    /// Name of the piece that cut the upper end; 0: the blank.
    pub high_id: u32,
}

const NOTHING: FilledPart = FilledPart { low: f32::INFINITY, high: f32::NEG_INFINITY, low_id: 0, high_id: 0 };

/// The single span of each line of a tile; a line without material, or with several spans, is empty here.
#[derive(Debug, Clone)]
enum Spans {
    /// All lines have the same.
    Alike(FilledPart),
    /// Block by block.
    Each(Box<[FilledPart; TILE * TILE]>),
}

impl Spans {
    fn of(&self, line: usize) -> &FilledPart {
        match self {
            Self::Alike(span) => span,
            Self::Each(spans) => &spans[line],
        }
    }

    fn set(&mut self, line: usize, span: FilledPart) {
        if let Self::Alike(all) = *self {
            *self = Self::Each(Box::new([all; TILE * TILE]));
        }
        if let Self::Each(spans) = self {
            spans[line] = span;
        }
    }

    /// Keeps one span where all lines have the same.
    fn join(&mut self) {
        if let Self::Each(spans) = self
            && spans.iter().all(|span| *span == spans[0])
        {
            *self = Self::Alike(spans[0]);
        }
    }

    fn all_mut(&mut self) -> &mut [FilledPart] {
        match self {
            Self::Alike(span) => std::slice::from_mut(span),
            Self::Each(spans) => &mut spans[..],
        }
    }
}

/// Lines side by side.
#[derive(Debug, Clone)]
struct Tile {
    spans: Spans,
    /// Lines with several spans, ascending.
    several: Vec<(u16, Vec<FilledPart>)>,
    /// Lowest and highest material of each block.
    blocks: [[f32; 2]; BLOCKS],
}

/// Lines in one direction.
#[derive(Debug, Clone)]
struct LineFamily {
    /// Number of lines in both directions across.
    lines: [usize; 2],
    tiles_across: usize,
    tiles: Vec<Tile>,
}

/// What a piece has met.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Contact {
    /// Volume by each family of lines, mm³.
    pub volumes: [f64; 3],
    /// Longest part of a line, mm.
    pub longest: f64,
    /// Its middle.
    pub place: [f64; 3],
}

impl Contact {
    /// Volume: the mean of the three families.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.volumes.iter().sum::<f64>() / 3.0
    }
}

/// Numbers of a removal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effort {
    /// Spans that were compared with a piece.
    pub visits: u64,
    /// Spans that were cut or touched.
    pub cuts: u64,
    /// Lines of a piece that had to be divided.
    pub divided: u64,
    /// Lines of a piece whose ends are not certified.
    pub uncertified: u64,
}

impl Effort {
    fn add(&mut self, other: &Self) {
        self.visits += other.visits;
        self.cuts += other.cuts;
        self.divided += other.divided;
        self.uncertified += other.uncertified;
    }
}

/// The material.
#[derive(Debug, Clone)]
pub struct TriDexel {
    low: [f64; 3],
    high: [f64; 3],
    /// Distance of the lines along each axis.
    pitch: [f64; 3],
    families: [LineFamily; 3],
    effort: Effort,
}

/// The reason why there is no such stock.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct StockFault(String);

impl StockFault {
    pub(crate) fn new(text: String) -> Self {
        Self(text)
    }
}

/// A part of a line that a piece covers: piece, line, length, middle.
type Touch = (u32, u16, f64, f64);

/// A part of a line that a piece has met.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Removed {
    /// Index of the piece.
    pub(crate) piece: usize,
    pub(crate) family: usize,
    pub(crate) line: [usize; 2],
    pub(crate) length: f64,
    pub(crate) middle: f64,
}

impl Tile {
    fn measure(&mut self) {
        self.spans.join();
        self.blocks = [[f32::INFINITY, f32::NEG_INFINITY]; BLOCKS];
        let mut take = |line: usize, span: &FilledPart| {
            let [low, high] = &mut self.blocks[line / (BLOCK * BLOCK)];
            (*low, *high) = (low.min(span.low), high.max(span.high));
        };
        (0..TILE * TILE).for_each(|line| take(line, self.spans.of(line)));
        for (line, spans) in &self.several {
            spans.iter().for_each(|span| take(usize::from(*line), span));
        }
    }

    fn set(&mut self, line: usize, spans: &[FilledPart]) {
        self.several.retain(|(other, _)| usize::from(*other) != line);
        self.spans.set(line, if let [span] = spans { *span } else { NOTHING });
        if spans.len() > 1 {
            self.several.push((line as u16, spans.to_vec()));
        }
    }

    fn of(&self, line: usize) -> &[FilledPart] {
        let single = self.spans.of(line);
        if single.low <= single.high {
            return std::slice::from_ref(single);
        }
        let found = self.several.iter().find(|(other, _)| usize::from(*other) == line);
        found.map_or(&[], |(_, spans)| spans)
    }
}

/// Index of a line in its tile, from its two positions.
fn line_of(i: usize, j: usize) -> usize {
    ((j / BLOCK) * (TILE / BLOCK) + i / BLOCK) * BLOCK * BLOCK + (j % BLOCK) * BLOCK + i % BLOCK
}

/// The two positions of a line.
fn position_of(line: usize) -> [usize; 2] {
    let (block, inside) = (line / (BLOCK * BLOCK), line % (BLOCK * BLOCK));
    [block % (TILE / BLOCK) * BLOCK + inside % BLOCK, block / (TILE / BLOCK) * BLOCK + inside / BLOCK]
}

/// The two coordinates of a line across it, mm.
fn across_line(low: &[f64; 3], pitch: &[f64; 3], family: usize, line: [usize; 2]) -> [f64; 2] {
    std::array::from_fn(|index| {
        let axis = (family + 1 + index) % 3;
        low[axis] + (line[index] as f64 + 0.5) * pitch[axis]
    })
}

impl TriDexel {
    /// A stock of nothing in a box.
    ///
    /// # Errors
    /// A sentence about a box that is empty, or a pitch that does not suit it.
    pub fn empty([low, high]: [[f64; 3]; 2], pitch_mm: f64) -> Result<Self, StockFault> {
        if !(pitch_mm > 0.0 && pitch_mm.is_finite()) {
            return Err(StockFault(format!("a pitch of {pitch_mm} mm is none: it must be above 0")));
        }
        let size: [f64; 3] = std::array::from_fn(|index| high[index] - low[index]);
        if !size.iter().all(|size| *size > 0.0 && size.is_finite()) {
            return Err(StockFault(format!("a stock of {} x {} x {} mm is empty", size[0], size[1], size[2])));
        }
        let counts = size.map(|size| (size / pitch_mm - 1e-9).ceil().max(1.0));
        let lines = counts[0] * counts[1] + counts[1] * counts[2] + counts[2] * counts[0];
        if lines > MOST_LINES {
            let text = format!(
                "a pitch of {pitch_mm} mm makes {lines:.0} lines of this stock, {:.1} GB: take a larger pitch",
                lines * 16.0 / 1e9
            );
            return Err(StockFault(text));
        }
        Ok(Self::of_counts([low, high], counts.map(|count| count as usize)))
    }

    /// A stock of nothing in a box, with a number of lines along each axis.
    fn of_counts([low, high]: [[f64; 3]; 2], counts: [usize; 3]) -> Self {
        let family = |line: usize| {
            let lines = [counts[(line + 1) % 3], counts[(line + 2) % 3]];
            let tiles = lines.map(|count| count.div_ceil(TILE));
            let tile = Tile {
                spans: Spans::Alike(NOTHING),
                several: Vec::new(),
                blocks: [[f32::INFINITY, f32::NEG_INFINITY]; BLOCKS],
            };
            LineFamily { lines, tiles_across: tiles[0], tiles: vec![tile; tiles[0] * tiles[1]] }
        };
        let pitch = std::array::from_fn(|index| (high[index] - low[index]) / counts[index] as f64);
        Self { low, high, pitch, families: [family(0), family(1), family(2)], effort: Effort::default() }
    }

    /// A stock from a function that gives the material of a line: the family, its two numbers, and its two coordinates
    /// across. The first number runs fastest.
    ///
    /// # Errors
    /// Those of [`empty`](Self::empty).
    pub fn filled(
        corners: [[f64; 3]; 2],
        pitch_mm: f64,
        mut material: impl FnMut(usize, [usize; 2], [f64; 2], &mut Vec<[f64; 2]>),
    ) -> Result<Self, StockFault> {
        let mut stock = Self::empty(corners, pitch_mm)?;
        let (low, pitch) = (stock.low, stock.pitch);
        let mut parts = Vec::new();
        stock.fill(|family, line, spans| {
            parts.clear();
            material(family, line, across_line(&low, &pitch, family, line), &mut parts);
            spans.extend(parts.iter().filter(|part| part[0] < part[1]).map(|part| FilledPart {
                low: part[0] as f32,
                high: part[1] as f32,
                ..NOTHING
            }));
        });
        Ok(stock)
    }

    /// Fills every line with its spans in their order: of a family and its two numbers, the first of which runs
    /// fastest.
    fn fill(&mut self, mut spans_of: impl FnMut(usize, [usize; 2], &mut Vec<FilledPart>)) {
        let mut spans = Vec::new();
        for (family, held) in self.families.iter_mut().enumerate() {
            let [columns, rows] = held.lines;
            for (tiles, first) in held.tiles.chunks_mut(held.tiles_across).zip((0..rows).step_by(TILE)) {
                for j in first..rows.min(first + TILE) {
                    for i in 0..columns {
                        spans.clear();
                        spans_of(family, [i, j], &mut spans);
                        tiles[i / TILE].set(line_of(i % TILE, j % TILE), &spans);
                    }
                }
                // Before the next ones: tiles whose lines are alike are small from here on.
                tiles.iter_mut().for_each(Tile::measure);
            }
        }
    }

    /// A box.
    ///
    /// # Errors
    /// Those of [`empty`](Self::empty).
    pub fn block(corners: [[f64; 3]; 2], pitch_mm: f64) -> Result<Self, StockFault> {
        Self::filled(corners, pitch_mm, |family, _, _, parts| parts.push([corners[0][family], corners[1][family]]))
    }

    /// A cylinder along Z.
    ///
    /// # Errors
    /// Those of [`empty`](Self::empty).
    pub fn cylinder(centre: [f64; 2], radius: f64, [low, high]: [f64; 2], pitch_mm: f64) -> Result<Self, StockFault> {
        let corners = [[centre[0] - radius, centre[1] - radius, low], [centre[0] + radius, centre[1] + radius, high]];
        Self::filled(corners, pitch_mm, |family, _, across, parts| {
            let half = |from: f64| (radius * radius - from * from).max(0.0).sqrt();
            parts.push(match family {
                0 => [centre[0] - half(across[0] - centre[1]), centre[0] + half(across[0] - centre[1])],
                1 => [centre[1] - half(across[1] - centre[0]), centre[1] + half(across[1] - centre[0])],
                _ if (across[0] - centre[0]).hypot(across[1] - centre[1]) <= radius => [low, high],
                _ => return,
            });
        })
    }

    /// The same material without the names of the pieces that cut it.
    pub(crate) fn unnamed(mut self) -> Self {
        for tile in self.families.iter_mut().flat_map(|family| &mut family.tiles) {
            let several = tile.several.iter_mut().flat_map(|(_, spans)| spans);
            for span in tile.spans.all_mut().iter_mut().chain(several).filter(|span| span.low <= span.high) {
                (span.low_id, span.high_id) = (u32::MAX, u32::MAX);
            }
        }
        self
    }

    /// The stock rotated by quarter turns and moved, line by line: axis `a` is axis `from[a]` times `signs[a]`, and
    /// `by[a]`.
    pub(crate) fn turned(&self, from: [usize; 3], signs: [f64; 3], by: [f64; 3]) -> Self {
        let ends = |axis: usize| {
            let [one, two] = [self.low, self.high].map(|corner| signs[axis] * corner[from[axis]] + by[axis]);
            [one.min(two), one.max(two)]
        };
        let (low, high) = ([0, 1, 2].map(|axis| ends(axis)[0]), [0, 1, 2].map(|axis| ends(axis)[1]));
        let counts = [0, 1, 2].map(|axis| self.counts()[from[axis]]);
        let mut stock = Self::of_counts([low, high], counts);
        stock.effort = self.effort;
        stock.fill(|family, line, spans| {
            let mut node = [0; 3];
            for (axis, index) in [1, 2].map(|next| (family + next) % 3).into_iter().zip(line) {
                node[from[axis]] = if signs[axis] > 0.0 { index } else { counts[axis] - 1 - index };
            }
            let along = from[family];
            let line = [node[(along + 1) % 3], node[(along + 2) % 3]];
            let moved = |value: f32| (signs[family] * f64::from(value) + by[family]) as f32;
            spans.extend(self.spans(along, line).iter().map(|span| match signs[family] > 0.0 {
                true => FilledPart { low: moved(span.low), high: moved(span.high), ..*span },
                false => FilledPart {
                    low: moved(span.high),
                    high: moved(span.low),
                    low_id: span.high_id,
                    high_id: span.low_id,
                },
            }));
            spans.sort_by(|a, b| a.low.total_cmp(&b.low));
        });
        stock
    }

    /// Every so many lines of each family: `step` is odd, so that those in the middle of as many are kept.
    pub(crate) fn thinned(&self, step: usize) -> Self {
        let steps = self.counts().map(|count| step.min(count - usize::from(count.is_multiple_of(2) && count > 1)));
        let counts: [usize; 3] =
            std::array::from_fn(|axis| (self.counts()[axis] - steps[axis] / 2 - 1) / steps[axis] + 1);
        let high = std::array::from_fn(|axis| self.low[axis] + (counts[axis] * steps[axis]) as f64 * self.pitch[axis]);
        let mut stock = Self::of_counts([self.low, high], counts);
        stock.fill(|family, line, spans| {
            let kept = [1, 2].map(|next| steps[(family + next) % 3]);
            spans
                .extend_from_slice(self.spans(family, [0, 1].map(|index| line[index] * kept[index] + kept[index] / 2)));
        });
        stock
    }

    /// Numbers of all removals.
    #[must_use]
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// Corners of the box of the stock at its beginning.
    #[must_use]
    pub fn corners(&self) -> [[f64; 3]; 2] {
        [self.low, self.high]
    }

    /// Distance of the lines along each axis, mm.
    #[must_use]
    pub fn pitch(&self) -> [f64; 3] {
        self.pitch
    }

    /// Number of lines along each axis.
    pub(crate) fn counts(&self) -> [usize; 3] {
        let [y, z] = self.families[0].lines;
        [self.families[1].lines[1], y, z]
    }

    /// The material of a line.
    pub(super) fn spans(&self, family: usize, [i, j]: [usize; 2]) -> &[FilledPart] {
        let held = &self.families[family];
        held.tiles[j / TILE * held.tiles_across + i / TILE].of(line_of(i % TILE, j % TILE))
    }

    /// Numbers of the lines of a family in both directions across.
    pub(crate) fn lines(&self, family: usize) -> [usize; 2] {
        self.families[family].lines
    }

    pub(crate) fn across(&self, family: usize, line: [usize; 2]) -> [f64; 2] {
        across_line(&self.low, &self.pitch, family, line)
    }

    /// Shows the spans of every line of a family, with its two coordinates across.
    pub fn each(&self, family: usize, mut show: impl FnMut([f64; 2], &[FilledPart])) {
        let held = &self.families[family];
        for j in 0..held.lines[1] {
            for i in 0..held.lines[0] {
                let tile = &held.tiles[j / TILE * held.tiles_across + i / TILE];
                show(self.across(family, [i, j]), tile.of(line_of(i % TILE, j % TILE)));
            }
        }
    }

    /// The material as boxes, in three sets each of which contains it: for each block of lines of a family the parts
    /// along them.
    pub(crate) fn boxes(&self) -> Vec<Vec<[[f64; 3]; 2]>> {
        let family = |family: usize| {
            let held = &self.families[family];
            let (u, v) = ((family + 1) % 3, (family + 2) % 3);
            let mut boxes = Vec::new();
            for (index, tile) in held.tiles.iter().enumerate() {
                let corner = [index % held.tiles_across * TILE, index / held.tiles_across * TILE];
                for block in 0..BLOCKS {
                    let lines = block * BLOCK * BLOCK..(block + 1) * BLOCK * BLOCK;
                    let mut parts: Vec<[f32; 2]> =
                        lines.flat_map(|line| tile.of(line)).map(|span| [span.low, span.high]).collect();
                    parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
                    parts.dedup_by(|next, last| {
                        let joins = next[0] <= last[1];
                        last[1] = if joins { last[1].max(next[1]) } else { last[1] };
                        joins
                    });
                    let at = [corner[0] + block % (TILE / BLOCK) * BLOCK, corner[1] + block / (TILE / BLOCK) * BLOCK];
                    let edge = |axis: usize, line: usize| self.low[axis] + line as f64 * self.pitch[axis];
                    boxes.extend(parts.into_iter().map(|[low, high]| {
                        let mut ends = [[0.0; 3]; 2];
                        [ends[0][family], ends[1][family]] = [low, high].map(f64::from);
                        for (axis, line) in [(u, at[0]), (v, at[1])] {
                            ends[0][axis] = edge(axis, line);
                            ends[1][axis] = edge(axis, line + BLOCK).min(self.high[axis]);
                        }
                        ends
                    }));
                }
            }
            boxes
        };
        (0..3).map(family).collect()
    }

    /// Area that a line of a family has, mm².
    fn area(&self, family: usize) -> f64 {
        self.pitch[(family + 1) % 3] * self.pitch[(family + 2) % 3]
    }

    /// Volume by each family of lines, mm³.
    #[must_use]
    pub fn volumes(&self) -> [f64; 3] {
        std::array::from_fn(|family| {
            let mut length = 0.0;
            self.each(family, |_, spans| {
                length += spans.iter().map(|span| f64::from(span.high) - f64::from(span.low)).sum::<f64>();
            });
            length * self.area(family)
        })
    }

    /// Memory of the lines once no tile has lines that are alike, bytes; lines with several spans take more.
    #[must_use]
    pub fn most_bytes(&self) -> usize {
        let tiles: usize = self.families.iter().map(|family| family.tiles.len()).sum();
        tiles * (size_of::<Tile>() + TILE * TILE * size_of::<FilledPart>())
    }

    /// Cuts the stock by pieces in their order. `eps`: largest distance of a new end from the sweep of its piece, mm.
    pub fn cut(&mut self, pieces: &[SweptPiece], profiles: &[Profile], eps: f64, threads: usize) -> Vec<Contact> {
        let mut contacts = vec![Contact::default(); pieces.len()];
        let areas = [0, 1, 2].map(|family| self.area(family));
        let (low, pitch) = (self.low, self.pitch);
        self.cut_and_show(pieces, profiles, eps, threads, |removed| {
            let contact = &mut contacts[removed.piece];
            contact.volumes[removed.family] += removed.length * areas[removed.family];
            if removed.length > contact.longest {
                contact.longest = removed.length;
                contact.place[removed.family] = removed.middle;
                let [u, v] = [1, 2].map(|next| (removed.family + next) % 3);
                [contact.place[u], contact.place[v]] = across_line(&low, &pitch, removed.family, removed.line);
            }
        });
        contacts
    }

    /// Cuts the stock and shows each part of a line that a piece meets; those of a line in the order of the pieces.
    pub(crate) fn cut_and_show(
        &mut self,
        pieces: &[SweptPiece],
        profiles: &[Profile],
        eps: f64,
        threads: usize,
        mut show: impl FnMut(&Removed) + Send,
    ) {
        let boxes: Vec<[[f64; 3]; 2]> =
            pieces.iter().map(|piece| piece.bounds(&profiles[piece.profile as usize])).collect();
        for line in 0..3 {
            let (u, v) = ((line + 1) % 3, (line + 2) % 3);
            let (tile_u, tile_v) = (TILE as f64 * self.pitch[u], TILE as f64 * self.pitch[v]);
            let (low, high, pitch) = (self.low, self.high, [self.pitch[u], self.pitch[v]]);
            let family = &mut self.families[line];
            let across = family.tiles_across;
            let along = family.tiles.len() / across;
            let mut lists: Vec<Vec<u32>> = vec![Vec::new(); family.tiles.len()];
            for (index, [from, to]) in boxes.iter().enumerate() {
                if (0..3).any(|axis| from[axis] > high[axis] || to[axis] < low[axis]) {
                    continue;
                }
                let tile = |at: f64, count: usize| at.floor().clamp(0.0, count as f64 - 1.0) as usize;
                let columns = tile((from[u] - low[u]) / tile_u, across)..=tile((to[u] - low[u]) / tile_u, across);
                let rows = tile((from[v] - low[v]) / tile_v, along)..=tile((to[v] - low[v]) / tile_v, along);
                for row in rows {
                    for column in columns.clone() {
                        lists[row * across + column].push(index as u32);
                    }
                }
            }
            let permuted: Vec<SweptPiece> = pieces.iter().map(|piece| piece.permuted(line)).collect();
            let work: Vec<(usize, &mut Tile, &Vec<u32>)> = family
                .tiles
                .iter_mut()
                .zip(&lists)
                .enumerate()
                .filter(|(_, (_, list))| !list.is_empty())
                .map(|(index, (tile, list))| (index, tile, list))
                .collect();
            let queue = Mutex::new(work.into_iter().enumerate());
            let total = &mut self.effort;
            let in_order = Mutex::new(InOrder::new(|(index, cut): (usize, TileCut)| {
                total.add(&cut.effort);
                let corner = [index % across * TILE, index / across * TILE];
                for (piece, at, length, middle) in cut.touches {
                    let [i, j] = position_of(usize::from(at));
                    let at = [corner[0] + i, corner[1] + j];
                    show(&Removed { piece: piece as usize, family: line, line: at, length, middle });
                }
            }));
            let run = || {
                while let Some((turn, (index, tile, list))) = queue.lock().ok().and_then(|mut queue| queue.next()) {
                    let corner = [low[u] + (index % across) as f64 * tile_u, low[v] + (index / across) as f64 * tile_v];
                    let mut cut = TileCut { corner, pitch, eps, touches: Vec::new(), effort: Effort::default() };
                    for &piece in list {
                        let moved = &permuted[piece as usize];
                        cut.cut(tile, moved, &profiles[moved.profile as usize], piece);
                    }
                    if let Ok(mut in_order) = in_order.lock() {
                        in_order.give(turn, (index, cut));
                    }
                }
            };
            if threads > 1 {
                // A thread that panics makes the scope panic.
                std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(run))));
            } else {
                run();
            }
        }
    }
}

/// The removal in one tile.
struct TileCut {
    /// Coordinates of its corner across the lines.
    corner: [f64; 2],
    pitch: [f64; 2],
    eps: f64,
    touches: Vec<Touch>,
    effort: Effort,
}

/// Spans to be compared with a piece.
struct SpanBatch {
    count: usize,
    lines: [u16; LANES],
    spans: [FilledPart; LANES],
    /// The part of each span that the piece may reach.
    low: [f64; LANES],
    high: [f64; LANES],
}

impl SpanBatch {
    const EMPTY: Self =
        Self { count: 0, lines: [0; LANES], spans: [NOTHING; LANES], low: [0.0; LANES], high: [0.0; LANES] };

    fn add(&mut self, line: u16, span: FilledPart, [bottom, top]: [f64; 2]) {
        self.lines[self.count] = line;
        self.spans[self.count] = span;
        self.low[self.count] = f64::from(span.low).max(bottom);
        self.high[self.count] = f64::from(span.high).min(top);
        self.count += 1;
    }
}

impl TileCut {
    fn place(&self, line: usize) -> [f64; 2] {
        let at = position_of(line);
        std::array::from_fn(|index| self.corner[index] + (at[index] as f64 + 0.5) * self.pitch[index])
    }

    fn cut(&mut self, tile: &mut Tile, piece: &SweptPiece, profile: &Profile, index: u32) {
        let [lowest, highest] = tile
            .blocks
            .iter()
            .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], block| [low.min(block[0]), high.max(block[1])]);
        if lowest > highest {
            return;
        }
        // The tile at once, as the line in its middle.
        let diagonal = |lines: usize| 0.5 * lines as f64 * self.pitch[0].hypot(self.pitch[1]);
        let grown = |lines: usize| SweptPiece { grow: piece.grow + diagonal(lines) + 1.5 * COARSE_MM, ..*piece };
        let whole = grown(TILE);
        let coarse = SweptSpace::new(&whole, profile, COARSE_MM);
        let middle: [f64; 2] = std::array::from_fn(|index| self.corner[index] + 0.5 * TILE as f64 * self.pitch[index]);
        let (u, v) = ([middle[0]; LANES], [middle[1]; LANES]);
        let (mut from, mut to) = ([f64::from(highest); LANES], [f64::from(lowest); LANES]);
        (from[1], to[1]) = (to[1], from[1]);
        let mut live = [false; LANES];
        (live[0], live[1]) = (true, true);
        let ends = coarse.entries(&u, &v, &from, &to, live);
        let missed = |lane: usize| ends.z[lane].is_nan() && !ends.open[lane];
        if missed(0) || missed(1) {
            return;
        }
        let or = |lane: usize, other: f32| if ends.z[lane].is_nan() { f64::from(other) } else { ends.z[lane] };
        let (top, bottom) = (or(0, highest), or(1, lowest));
        // Then block by block.
        let blocks = grown(BLOCK);
        let coarse = SweptSpace::new(&blocks, profile, COARSE_MM);
        let mut tops = [f64::NEG_INFINITY; BLOCKS];
        for half in 0..BLOCKS / LANES {
            let (mut u, mut v, mut from, mut to) = ([0.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES]);
            let mut live = [false; LANES];
            for lane in 0..LANES {
                let block = half * LANES + lane;
                let [low, high] = tile.blocks[block];
                let [i, j] = [block % (TILE / BLOCK), block / (TILE / BLOCK)];
                u[lane] = self.corner[0] + (i as f64 + 0.5) * BLOCK as f64 * self.pitch[0];
                v[lane] = self.corner[1] + (j as f64 + 0.5) * BLOCK as f64 * self.pitch[1];
                from[lane] = f64::from(high).min(top);
                to[lane] = f64::from(low).max(bottom);
                live[lane] = low < high && from[lane] > to[lane];
                if !live[lane] {
                    (from[lane], to[lane]) = (0.0, 0.0);
                }
            }
            if !live.contains(&true) {
                continue;
            }
            let found = coarse.entries(&u, &v, &from, &to, live);
            for lane in 0..LANES {
                if live[lane] && (found.open[lane] || !found.z[lane].is_nan()) {
                    tops[half * LANES + lane] = if found.open[lane] { from[lane] } else { found.z[lane] };
                }
            }
        }
        let sweep = SweptSpace::new(piece, profile, self.eps);
        let mut changed = false;
        let mut batch = SpanBatch::EMPTY;
        // Lines with several spans come last: a line that gets its second span must not be seen twice.
        let several: Vec<(u16, FilledPart)> =
            tile.several.iter().flat_map(|(line, spans)| spans.iter().map(|span| (*line, *span))).collect();
        for (block, top) in tops.iter().enumerate() {
            if *top == f64::NEG_INFINITY {
                continue;
            }
            for line in block * BLOCK * BLOCK..(block + 1) * BLOCK * BLOCK {
                let span = *tile.spans.of(line);
                if span.low < span.high && f64::from(span.high) >= bottom && f64::from(span.low) <= *top {
                    batch.add(line as u16, span, [bottom, *top]);
                    if batch.count == LANES {
                        changed |= self.cut_batch(tile, &sweep, &batch, index);
                        batch = SpanBatch::EMPTY;
                    }
                }
            }
        }
        for (line, span) in several {
            let top = tops[usize::from(line) / (BLOCK * BLOCK)];
            if f64::from(span.high) >= bottom && f64::from(span.low) <= top {
                batch.add(line, span, [bottom, top]);
                if batch.count == LANES {
                    changed |= self.cut_batch(tile, &sweep, &batch, index);
                    batch = SpanBatch::EMPTY;
                }
            }
        }
        if batch.count > 0 {
            changed |= self.cut_batch(tile, &sweep, &batch, index);
        }
        if changed {
            tile.measure();
        }
    }

    /// Cuts spans; returns whether the tile has changed.
    fn cut_batch(&mut self, tile: &mut Tile, sweep: &SweptSpace<'_>, batch: &SpanBatch, index: u32) -> bool {
        let mut lines =
            EightLines { u: [0.0; LANES], v: [0.0; LANES], low: batch.low, high: batch.high, live: [false; LANES] };
        for lane in 0..LANES {
            [lines.u[lane], lines.v[lane]] = self.place(usize::from(batch.lines[lane]));
            lines.live[lane] = lane < batch.count && batch.high[lane] > batch.low[lane];
        }
        self.effort.visits += batch.count as u64;
        let mut covered = Covered::default();
        sweep.covered(&lines, &mut covered);
        self.effort.divided += covered.divided;
        self.effort.uncertified += covered.uncertified;
        if covered.divided > 0 {
            covered.join(self.eps);
        }
        let mut changed = false;
        for (lane, part) in covered.parts.into_iter().filter(|(_, part)| part[1] - part[0] > self.eps) {
            let middle = f64::midpoint(part[0], part[1]);
            self.touches.push((index, batch.lines[lane], part[1] - part[0], middle));
            self.effort.cuts += 1;
            if !sweep.piece.test_only {
                changed = true;
                self.remove(tile, batch.lines[lane], &batch.spans[lane], part, sweep.piece.id);
            }
        }
        changed
    }

    /// Removes a part from the spans of a line that are within one of its earlier spans.
    fn remove(&self, tile: &mut Tile, line: u16, within: &FilledPart, [low, high]: [f64; 2], id: u32) {
        let line = usize::from(line);
        let kept = |span: &FilledPart| {
            let below = (low - f64::from(span.low) > self.eps).then_some(FilledPart {
                high: (low as f32).min(span.high),
                high_id: if (low as f32) < span.high { id } else { span.high_id },
                ..*span
            });
            let above = (f64::from(span.high) - high > self.eps).then_some(FilledPart {
                low: (high as f32).max(span.low),
                low_id: if (high as f32) > span.low { id } else { span.low_id },
                ..*span
            });
            [below, above]
        };
        let single = *tile.spans.of(line);
        if single.low <= single.high {
            match kept(&single) {
                [Some(below), Some(above)] if below.high < above.low => tile.set(line, &[below, above]),
                [Some(one), _] | [None, Some(one)] => tile.spans.set(line, one),
                [None, None] => tile.spans.set(line, NOTHING),
            }
            return;
        }
        let mut spans = Vec::new();
        for span in tile.of(line) {
            if span.high < within.low
                || span.low > within.high
                || f64::from(span.high) <= low
                || f64::from(span.low) >= high
            {
                spans.push(*span);
            } else {
                spans.extend(kept(span).into_iter().flatten());
            }
        }
        tile.set(line, &spans);
    }
}
