//! Records between motions.

use nalgebra::Vector3;

use super::Program;

impl Program<'_> {
    /// Writes a record that is no motion.
    pub(super) fn other_record(&mut self) {
        match self.random.below(14) {
            0 => self.spindle(),
            1 | 2 => self.coolant(),
            3 => self.line("DELAY/0.75"),
            4 => self.line("DELAY/2,REV"),
            5..=7 => self.feed(),
            8 => {
                let tolerance = self.some_length(0.002, 0.009);
                self.line(&format!("LINTOL/{tolerance}"));
            }
            10 => self.line(if self.needs.inches { "UNITS/INCHES" } else { "UNITS/MM" }),
            11 => self.line("MULTAX/ON"),
            12 => self.line("FEDRAT/INVERS,AUTO"),
            9 if self.needs.insert => self.line("INSERT CHECK THE PART"),
            _ => self.line("PPRINT NOTE"),
        }
    }

    /// Writes a stop or an auxiliary function; then the tool approaches again from above.
    pub(super) fn stop(&mut self) {
        let words: &[&str] = if self.needs.code { &["OPSTOP", "STOP", "AUXFUN/77"] } else { &["OPSTOP", "STOP"] };
        let word = words[self.random.below(words.len())];
        self.line(word);
        if self.random.chance(0.3) {
            self.spindle();
        }
        self.axis = None;
        self.approach();
    }

    /// Writes a GOTO to the same point once more.
    pub(super) fn repeat(&mut self, tip: Vector3<f64>) {
        let axis = self.axis;
        self.point("GOTO", tip, axis);
    }

    pub(super) fn spindle(&mut self) {
        let speed = 500 + self.random.below(9000);
        let sense = if self.random.chance(0.1) { "CCLW" } else { "CLW" };
        match self.random.below(4) {
            0 => self.line(&format!("SPINDL/{speed},{sense}")),
            _ => self.line(&format!("SPINDL/RPM,{speed},{sense}")),
        }
    }

    pub(super) fn coolant(&mut self) {
        let kinds = ["ON", "ON", "FLOOD", "MIST", "OFF", "THRU", "AIR"];
        let kind = kinds[self.random.below(kinds.len())];
        self.line(&format!("COOLNT/{kind}"));
    }

    pub(super) fn feed(&mut self) {
        let (per_revolution, per_minute) = if self.needs.inches { ("IPR", "IPM") } else { ("MMPR", "MMPM") };
        let text = match self.random.below(8) {
            0 => format!("FEDRAT/{per_revolution},{}", self.some_length(0.02, 0.5)),
            _ => format!("FEDRAT/{per_minute},{}", self.some_length(50.0, 3000.0)),
        };
        self.line(&text);
    }
}
