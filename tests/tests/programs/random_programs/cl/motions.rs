//! Motions of the tool: lines, arcs, curves, rapids.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::Program;

impl Program<'_> {
    /// Cuts a line across, of at most `most` mm along each direction.
    pub(super) fn stroke(&mut self, most: f64) {
        let [x, y] = [self.plus_minus(most), self.plus_minus(most)];
        self.here += Vector3::new(x, y, 0.0);
        self.bound();
        if self.random.chance(0.3) {
            self.here.z = self.plus_minus(5.0);
        }
        self.go();
    }

    /// Cuts a line that is long enough for cutter compensation to begin.
    pub(super) fn stroke_flat(&mut self, most: f64) {
        let length = self.random.between(5.0, most);
        let angle = self.random.between(0.0, TAU);
        self.here += Vector3::new(length * angle.cos(), length * angle.sin(), 0.0);
        self.go();
    }

    pub(super) fn plunge(&mut self) {
        self.here.z = self.plus_minus(5.0);
        self.go();
    }

    pub(super) fn delta(&mut self) {
        let step = self.random.between(0.5, 6.0);
        let step_text = self.length(step);
        self.line(&format!("GODLTA/{step_text}"));
        self.here.z += step;
    }

    pub(super) fn arc(&mut self) {
        match self.random.below(8) {
            0 => self.round(1, 1.0),
            1 => {
                let turns = 2 + self.random.below(3);
                self.round(turns, 0.0);
            }
            _ => self.round(1, 0.0),
        }
    }

    /// Cuts an arc about the tool axis with `turns` revolutions begun; a full circle with the probability
    /// `full_circle`.
    pub(super) fn round(&mut self, turns: usize, full_circle: f64) {
        let radius = if self.random.chance(0.1) { 0.3 } else { self.random.between(1.0, 40.0) };
        let start = self.random.between(0.0, TAU);
        let sweep = if self.random.chance(full_circle) { 0.0 } else { self.random.between(0.1, 6.2) };
        let centre = self.here - Vector3::new(start.cos(), start.sin(), 0.0) * radius;
        let end = centre + Vector3::new((start + sweep).cos(), (start + sweep).sin(), 0.0) * radius;
        if self.random.chance(0.1) {
            self.movarc(centre, radius, turns, sweep);
        } else {
            self.circle(centre, Vector3::z(), radius, turns);
        }
        self.here = if sweep > 0.0 { end } else { self.here };
        self.go();
    }

    /// Writes an arc with its angle: about the tool axis by `sweep`, rad, or in the other sense by the rest of a
    /// revolution; 0 is a full circle.
    fn movarc(&mut self, centre: Vector3<f64>, radius: f64, turns: usize, sweep: f64) {
        let sense = self.random.sign();
        let angle = if sense > 0.0 { sweep } else { TAU - sweep };
        let angle = if sweep > 0.0 { angle } else { TAU } + TAU * (turns - 1) as f64;
        let centre = self.coordinates(self.origin + self.frame * centre);
        let normal = self.directions(self.frame * Vector3::z() * sense);
        let (radius, degrees) = (self.length(radius), angle.to_degrees());
        self.line(&format!("MOVARC/{centre},{normal},{radius},ANGLE,{degrees:.6}"));
    }

    /// Cuts a cubic curve of a few pieces from the present position.
    pub(super) fn curve(&mut self) {
        let pieces = 1 + self.random.below(4);
        let mut knots: Vec<f64> = (1..=pieces).map(|piece| piece as f64 / pieces as f64).collect();
        if pieces > 1 && self.random.chance(0.1) {
            // Two equal knots: the curvature jumps there.
            knots.insert(0, knots[0]);
        }
        self.line("NURBS/");
        knots.iter().for_each(|knot| self.line(&format!("KNOT/{knot:.8}")));
        let step = self.random.between(1.0, 15.0);
        for _ in 0..knots.len() + 2 {
            let [x, y, z] = [self.random.between(0.1, step), self.plus_minus(step), self.plus_minus(step / 8.0)];
            self.here += Vector3::new(x, y, z);
            self.point("CNTRL", self.here(), None);
        }
        if self.random.chance(0.7) {
            self.go();
        }
    }

    /// Writes several points in one record.
    pub(super) fn list(&mut self) {
        let points: Vec<String> = (0..2 + self.random.below(4))
            .map(|_| {
                let [x, y] = [self.plus_minus(20.0), self.plus_minus(20.0)];
                self.here += Vector3::new(x, y, 0.0);
                self.bound();
                self.coordinates(self.here())
            })
            .collect();
        self.line(&format!("GOTO/{}", points.join(" / ")));
    }

    /// Writes an incremental move along the axes of the file.
    pub(super) fn delta_of_file(&mut self) {
        let step = Vector3::new(self.plus_minus(8.0), self.plus_minus(8.0), self.plus_minus(2.0));
        let numbers = self.numbers(step, 0);
        self.line(&format!("GODLTA/{numbers}"));
        self.step_in_file(step);
    }

    fn step_in_file(&mut self, step: Vector3<f64>) {
        self.here += self.frame.transpose() * self.file.outside(step);
    }

    /// Writes subprograms: small incremental moves, with other records between them.
    pub(super) fn define_subprograms(&mut self) {
        for number in 1..=self.random.below(3) {
            self.line(&format!("DEFSUB/{number}"));
            let mut whole = Vector3::zeros();
            for _ in 0..1 + self.random.below(4) {
                let step = Vector3::new(self.plus_minus(8.0), self.plus_minus(8.0), self.plus_minus(2.0));
                let numbers = self.numbers(step, 0);
                self.line(&format!("GODLTA/{numbers}"));
                whole += step;
                if self.random.chance(0.3) {
                    self.other_record();
                }
            }
            self.line("ENDSUB");
            self.subprograms.push(whole);
        }
    }

    pub(super) fn call(&mut self) {
        let Some(number) = self.random.below(self.subprograms.len() + 1).checked_sub(1) else { return };
        self.line(&format!("CALSUB/{}", number + 1));
        self.step_in_file(self.subprograms[number]);
        self.bound();
        self.go();
    }

    pub(super) fn helix(&mut self) {
        let radius = self.random.between(1.0, 20.0);
        let start = self.random.between(0.0, TAU);
        let sweep = self.random.between(0.0, 6.2);
        let mut centre = self.here - Vector3::new(start.cos(), start.sin(), 0.0) * radius;
        let drop = self.random.between(-4.0, 4.0);
        let turns = 1 + self.random.below(4);
        let end = centre + Vector3::new((start + sweep).cos() * radius, (start + sweep).sin() * radius, drop);
        centre.z = end.z;
        self.circle(centre, Vector3::z(), radius, turns);
        self.here = end;
        self.go();
    }

    /// Cuts an arc in a plane that contains the tool axis.
    pub(super) fn vertical_arc(&mut self) {
        let radius = self.random.between(1.0, 15.0);
        let start = self.random.between(0.0, TAU);
        let sweep = self.random.between(0.2, 3.0);
        let [normal, first] = match self.random.below(2) {
            0 => [Vector3::x(), Vector3::y()],
            _ => [Vector3::y(), Vector3::x()],
        };
        let on = |angle: f64| (first * angle.cos() + Vector3::z() * angle.sin()) * radius;
        let centre = self.here - on(start);
        self.circle(centre, normal, radius, 1);
        self.here = centre + on(start + sweep);
        self.go();
    }

    pub(super) fn circle(&mut self, centre: Vector3<f64>, normal: Vector3<f64>, radius: f64, turns: usize) {
        let centre = self.coordinates(self.origin + self.frame * centre);
        let sense = self.random.sign();
        let normal = self.directions(self.frame * normal * sense);
        let radius = self.length(radius);
        let tail = if self.needs.nx { ",0.0600,0.5000,10.0000,0.0000" } else { "" };
        let times = if turns > 1 { format!(",TIMES,{turns}") } else { String::new() };
        self.line(&format!("CIRCLE/{centre},{normal},{radius}{tail}{times}"));
    }

    /// Moves up, across and down again at rapid.
    pub(super) fn over(&mut self) {
        self.here.z = self.clear;
        self.line("RAPID");
        self.go();
        if self.random.chance(0.8) {
            self.here.x += self.plus_minus(30.0);
            self.here.y += self.plus_minus(30.0);
            self.bound();
            self.line("RAPID");
            self.go();
            self.here.z = self.random.between(1.0, 4.0);
            self.line("RAPID");
            self.go();
        }
    }

    pub(super) fn leave(&mut self) {
        if self.cleared && self.random.chance(0.5) {
            return self.line("RETRCT");
        }
        self.here.z = self.clear + self.random.between(0.0, 20.0);
        if self.random.chance(0.6) {
            self.line("RAPID");
        }
        self.go();
    }
}
