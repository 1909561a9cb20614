//! The exact offset of a contour of the words of a program, by points: walk back along the offset of an element until
//! the tool no longer cuts the element after it, and forth until it no longer cuts the one before it. What is in
//! between is left.

/// A line or an arc of a program.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    from: [f64; 2],
    to: [f64; 2],
    /// Centre, and angle, + counter-clockwise.
    round: Option<([f64; 2], f64)>,
}

/// Whether an offset keeps a part of every element, and by how much it does, or does not.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outcome {
    pub(super) fits: bool,
    pub(super) margin_mm: f64,
}

impl Outcome {
    pub(super) const FITS: Self = Self { fits: true, margin_mm: f64::INFINITY };

    fn of(left_mm: f64) -> Self {
        Self { fits: left_mm > 0.0, margin_mm: left_mm.abs() }
    }

    /// Both offsets fit; the smallest margin of all counts.
    pub(super) fn and(self, other: Self) -> Self {
        Self { fits: self.fits && other.fits, margin_mm: self.margin_mm.min(other.margin_mm) }
    }
}

/// Parts into which an offset is divided where the tool is looked for that no longer cuts.
const PARTS: u32 = 4000;

/// Angle that is no corner, rad.
const NO_CORNER: f64 = 1e-6;

impl Piece {
    /// Point, and unit vector along the piece, at a share of it.
    fn at(&self, share: f64) -> ([f64; 2], [f64; 2]) {
        match self.round {
            None => {
                let step = [self.to[0] - self.from[0], self.to[1] - self.from[1]];
                let length = step[0].hypot(step[1]);
                ([self.from[0] + share * step[0], self.from[1] + share * step[1]], step.map(|part| part / length))
            }
            Some((centre, angle)) => {
                let out = |point: [f64; 2]| [point[0] - centre[0], point[1] - centre[1]];
                // The distances of both ends from the centre differ by the rounding of the words.
                let [start, end] = [self.from, self.to].map(|point| out(point)[0].hypot(out(point)[1]));
                let radius = start + share * (end - start);
                let direction = out(self.from)[1].atan2(out(self.from)[0]) + share * angle;
                let (sine, cosine) = direction.sin_cos();
                let sense = angle.signum();
                let point = [centre[0] + radius * cosine, centre[1] + radius * sine];
                (point, [-sine * sense, cosine * sense])
            }
        }
    }

    /// Centre of a tool at a distance to the left of a share of the piece.
    fn tool(&self, share: f64, left: f64) -> [f64; 2] {
        let (point, along) = self.at(share);
        [point[0] - along[1] * left, point[1] + along[0] * left]
    }

    fn length(&self) -> f64 {
        match self.round {
            None => (self.to[0] - self.from[0]).hypot(self.to[1] - self.from[1]),
            Some((centre, angle)) => angle.abs() * (self.to[0] - centre[0]).hypot(self.to[1] - centre[1]),
        }
    }

    /// Distance of a point, + on the side of a tool on the `left`, from the whole line, or from the circle with the
    /// radius at that end.
    fn distance(&self, point: [f64; 2], left: f64, at_end: bool) -> f64 {
        match self.round {
            None => {
                let (_, along) = self.at(0.0);
                let off = along[0] * (point[1] - self.from[1]) - along[1] * (point[0] - self.from[0]);
                off * left.signum()
            }
            Some((centre, angle)) => {
                let end = if at_end { self.to } else { self.from };
                let radius = (end[0] - centre[0]).hypot(end[1] - centre[1]);
                (radius - (point[0] - centre[0]).hypot(point[1] - centre[1])) * angle.signum() * left.signum()
            }
        }
    }

    /// Smallest radius of an arc around a tool on the left, less the radius of the tool.
    fn room(&self, left: f64) -> f64 {
        match self.round {
            Some((centre, angle)) if angle * left > 0.0 => {
                let radii = [self.from, self.to].map(|point| (point[0] - centre[0]).hypot(point[1] - centre[1]));
                radii[0].min(radii[1]) - left.abs()
            }
            _ => f64::INFINITY,
        }
    }

    /// Share of the offset from one end, the `end` or the start, that cuts a neighbour there; and if all of it does, by
    /// how much it cuts at least.
    fn lost(&self, left: f64, neighbour: &Piece, end: bool) -> Result<f64, f64> {
        let deep = |lost: f64| {
            let share = if end { 1.0 - lost } else { lost };
            left.abs() - neighbour.distance(self.tool(share, left), left, !end)
        };
        // In small steps near the corner: at one that is nearly straight on the tool is clear for a moment only.
        let near = std::iter::successors(Some(1e-10), |share| Some(share * 1.006)).take_while(|share| *share < 1.0);
        let mut shares: Vec<f64> = near.chain((1..=PARTS).map(|part| f64::from(part) / f64::from(PARTS))).collect();
        shares.sort_by(f64::total_cmp);
        let Some(index) = shares.iter().position(|lost| deep(*lost) <= 0.0) else {
            return Err(shares.into_iter().map(deep).fold(f64::INFINITY, f64::min));
        };
        let (mut cuts, mut clear) = (if index == 0 { 0.0 } else { shares[index - 1] }, shares[index]);
        for _ in 0..60 {
            let middle = 0.5 * (cuts + clear);
            if deep(middle) > 0.0 { cuts = middle } else { clear = middle }
        }
        Ok(clear)
    }
}

/// Angle at the corner between two pieces, + towards a tool on the left.
fn corner(before: &Piece, after: &Piece, left: f64) -> f64 {
    let ((_, from), (_, to)) = (before.at(1.0), after.at(0.0));
    (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1]) * left.signum()
}

/// Whether every piece of a contour keeps a part of its offset to the left. The first piece is the lead-in, the last
/// the lead-out, which loses nothing for the contour.
pub(super) fn offset(contour: &[Piece], left: f64) -> Outcome {
    let [first, .., last] = contour else { panic!("a contour has two leads") };
    let mut outcome = Outcome::of(first.length() - left.abs()).and(Outcome::of(last.length() - left.abs()));
    for (index, piece) in contour.iter().enumerate() {
        outcome = outcome.and(Outcome::of(piece.room(left)));
        if piece.room(left) <= 0.0 {
            continue;
        }
        let concave = |before: &Piece, after: &Piece| {
            let turn = corner(before, after, left);
            turn > NO_CORNER && turn < std::f64::consts::PI - NO_CORNER
        };
        let mut keeps = 1.0;
        if let Some(before) = index.checked_sub(1).map(|before| &contour[before])
            && concave(before, piece)
            && before.room(left) > 0.0
        {
            match piece.lost(left, before, false) {
                Ok(lost) => keeps -= lost,
                Err(deep) => outcome = outcome.and(Outcome { fits: false, margin_mm: deep }),
            }
        }
        if let Some(after) = contour.get(index + 1).filter(|_| index + 2 < contour.len())
            && concave(piece, after)
            && after.room(left) > 0.0
        {
            match piece.lost(left, after, true) {
                Ok(lost) => keeps -= lost,
                Err(deep) => outcome = outcome.and(Outcome { fits: false, margin_mm: deep }),
            }
        }
        outcome = outcome.and(Outcome::of(keeps * piece.length()));
    }
    outcome
}

/// The contour of a program for LinuxCNC, and its side: 1 for left, -1 for right. The first piece is the lead-in, the
/// last the lead-out.
pub(super) fn contour_of(program: &str) -> (f64, Vec<Piece>) {
    let (mut here, mut side, mut motion) = ([0.0; 2], 0.0, 0);
    let mut contour = Vec::new();
    for line in program.lines() {
        let number = |letter: char| {
            let word = line.split(' ').find(|word| word.starts_with(letter))?;
            word[1..].parse::<f64>().ok()
        };
        if line.starts_with(['(', 'o', ';']) || line.contains("G53") {
            continue;
        }
        let codes: Vec<&str> = line.split(' ').filter(|word| word.starts_with('G')).collect();
        for code in &codes {
            match *code {
                "G41" => side = 1.0,
                "G42" => side = -1.0,
                "G0" => motion = 0,
                "G1" => motion = 1,
                "G2" => motion = 2,
                "G3" => motion = 3,
                _ => {}
            }
        }
        let to = [number('X').unwrap_or(here[0]), number('Y').unwrap_or(here[1])];
        let moves = number('X').is_some() || number('Y').is_some() || number('I').is_some() || number('J').is_some();
        if side != 0.0 && moves {
            let round = (motion >= 2).then(|| {
                let centre = [here[0] + number('I').unwrap_or(0.0), here[1] + number('J').unwrap_or(0.0)];
                let [from, until] = [here, to].map(|point| (point[1] - centre[1]).atan2(point[0] - centre[0]));
                let turn = if motion == 3 {
                    (until - from).rem_euclid(std::f64::consts::TAU)
                } else {
                    -(from - until).rem_euclid(std::f64::consts::TAU)
                };
                (centre, turn)
            });
            contour.push(Piece { from: here, to, round });
            if codes.contains(&"G40") {
                break;
            }
        }
        here = to;
    }
    assert!(contour.len() >= 2, "{program}");
    (side, contour)
}
