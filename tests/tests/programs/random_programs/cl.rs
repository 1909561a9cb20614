//! Random CL data that a CAM system could have written: operations with tools, spindle and coolant, in which the tool
//! approaches from above, cuts lines, arcs, contours, surfaces and holes, and retracts upwards.
//!
//! Points are generated in the frame of an operation, whose third direction is along the tool, and written in the frame
//! of the part. All choices come from one stream of random numbers: the same seed gives the same bytes.

mod between;
mod frames;
mod motions;
mod text;

use nalgebra::{Matrix3, Vector3};
use tests::random::Random;

use frames::Frame;
pub(crate) use frames::{FRAMES, Frames};

/// Range of the tool axes that a machine reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AxisRange {
    /// Vertical only.
    Vertical,
    /// Tilts about X only.
    AboutX,
    /// Tilts up to this angle in any direction, degrees.
    UpTo(u32),
}

/// Properties of the set-up on which the CL data depends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Needs {
    pub(crate) axis_range: AxisRange,
    /// Whether a rotary axis rotates the part.
    pub(crate) table: bool,
    /// Whether the rotary axes must not move in a cut.
    pub(crate) still: bool,
    pub(crate) inches: bool,
    /// Whether CUTCOM may be used.
    pub(crate) compensation: bool,
    /// Whether CYCLE is written as by NX; else as in ISO 4343.
    pub(crate) nx: bool,
    /// Whether INSERT may be used.
    pub(crate) insert: bool,
    /// Whether the control has length registers.
    pub(crate) registers: bool,
    /// Bits of the tools whose register is in the configuration.
    pub(crate) given_offsets: u32,
    /// Whether a GOHOME without a point has a parking position.
    pub(crate) park: bool,
    /// Meaning of the frames after the first.
    pub(crate) frames: Frames,
    /// Whether AUXFUN/77 may be used.
    pub(crate) code: bool,
    /// Whether points are the centre of the corner radius.
    pub(crate) centre: bool,
}

/// Number of tools that may be called.
pub(crate) const TOOLS: usize = 4;

/// CL data that is being generated.
struct Program<'r> {
    random: &'r mut Random,
    needs: Needs,
    text: String,
    /// Decimals of coordinates and of directions.
    decimals: [usize; 2],
    /// Directions across and along the tool, and the origin of the operation, mm.
    frame: Matrix3<f64>,
    origin: Vector3<f64>,
    /// Position of the tool in that frame, mm.
    here: Vector3<f64>,
    /// Tool axis as last written.
    axis: Option<Vector3<f64>>,
    /// Clearance height above all cuts, mm.
    clear: f64,
    /// Whether CLEARP is programmed in this operation.
    cleared: bool,
    /// Frame of the numbers of the file, composed of the four that follow.
    file: Frame,
    frame_of_file: Frame,
    tracut: Frame,
    translation: Vector3<f64>,
    origin_of_file: Vector3<f64>,
    /// Frames of the file, relative to the model and to the part.
    frames: Vec<(Frame, Frame)>,
    /// Whether a frame has been written.
    stated: bool,
    /// Displacement of the tool by each subprogram, mm.
    subprograms: Vec<Vector3<f64>>,
}

/// Random CL data.
pub(crate) fn program(random: &mut Random, needs: Needs) -> String {
    let decimals = [3 + random.below(4), 6 + random.below(4)];
    let mut program = Program {
        random,
        needs,
        text: String::new(),
        decimals,
        frame: Matrix3::identity(),
        origin: Vector3::zeros(),
        here: Vector3::zeros(),
        axis: None,
        clear: 30.0,
        cleared: false,
        file: Frame::none(),
        frame_of_file: Frame::none(),
        tracut: Frame::none(),
        translation: Vector3::zeros(),
        origin_of_file: Vector3::zeros(),
        frames: Vec::new(),
        stated: false,
        subprograms: Vec::new(),
    };
    program.all();
    program.text
}

impl Program<'_> {
    fn all(&mut self) {
        self.line("PARTNO RANDOM");
        self.line(if self.needs.inches { "UNITS/INCHES" } else { "UNITS/MM" });
        if self.random.chance(0.15) {
            self.line("$$ a remark");
        }
        self.state_frames();
        if self.random.chance(0.3) {
            self.define_subprograms();
        }
        if self.random.chance(0.1) {
            self.point("FROM", Vector3::new(0.0, 0.0, 200.0), Some(Vector3::z()));
        }
        for _ in 0..1 + self.random.below(4) {
            self.operation();
        }
        match self.random.below(4) {
            0 if self.needs.park => self.line("GOHOME"),
            1 => self.point("GOHOME", Vector3::new(0.0, 0.0, 150.0), Some(Vector3::z())),
            _ => {}
        }
        if self.random.chance(0.5) {
            self.line("COOLNT/OFF");
        }
        if self.random.chance(0.5) {
            self.line("SPINDL/OFF");
        }
        self.line("END");
        self.line("FINI");
    }

    fn operation(&mut self) {
        let tool = 1 + self.random.below(TOOLS);
        let name = 1 + self.random.below(90);
        if self.needs.nx {
            self.line(&format!("TOOL PATH/OP_{name},TOOL,T{tool}"));
            let corner = if self.needs.centre { 1.5 } else { 0.0 };
            let sizes = self.numbers(Vector3::new(10.0, corner, 50.0), 0);
            self.line(&format!("TLDATA/MILL,{sizes},0.0000,0.0000"));
            self.enter_frame();
        } else if self.needs.centre {
            let sizes = [self.length(10.0), self.length(1.5)];
            self.line(&format!("CUTTER/{}", sizes.join(",")));
        }
        match self.random.below(3) {
            0 if self.needs.registers && self.needs.given_offsets & 1 << tool == 0 => {
                self.line(&format!("LOAD/TOOL,{tool},ADJUST,{tool}"))
            }
            1 => self.line(&format!("LOAD/TOOL,{tool}")),
            _ => self.line(&format!("LOADTL/{tool}")),
        }
        self.spindle();
        self.coolant();
        if self.random.chance(0.1) {
            self.change_frame();
        }
        if self.random.chance(0.1) {
            let senses: &[&str] = if self.needs.table { &["SHORT", "NEXT,CLW", "NEXT,CCLW"] } else { &["SHORT"] };
            let sense = senses[self.random.below(senses.len())];
            self.line(&format!("ROTABL/{sense}"));
        }
        self.cleared = self.random.chance(0.1);
        if self.cleared {
            let height = self.length(150.0);
            self.line(&format!("CLEARP/XYPLAN,{height}"));
        }
        self.begin();
        let still = self.needs.still || self.needs.axis_range == AxisRange::Vertical;
        match self.random.below(10) {
            0..=3 => self.flat(),
            4..=5 => self.holes(),
            6 if self.needs.compensation => self.contour(),
            _ if still => self.flat(),
            _ => self.surface(),
        }
        if self.random.chance(0.2) {
            self.stop();
            self.flat();
        }
        if self.needs.nx {
            self.line("END-OF-PATH");
        }
    }

    /// Chooses the frame of an operation and moves the tool above it.
    fn begin(&mut self) {
        let axis = self.some_axis();
        self.orient(axis);
        self.origin = Vector3::new(self.plus_minus(60.0), self.plus_minus(60.0), self.plus_minus(20.0));
        self.clear = self.random.between(15.0, 60.0);
        self.axis = None;
        if self.random.chance(0.1) {
            self.state_axis();
        }
        self.approach();
    }

    /// Sets the frame to directions across and along a tool axis.
    fn orient(&mut self, axis: Vector3<f64>) {
        let across = if axis.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
        let second = axis.cross(&across).normalize();
        self.frame = Matrix3::from_columns(&[second.cross(&axis), second, axis]);
    }

    /// Rapid to a point at clearance height, then down near the part.
    fn approach(&mut self) {
        self.here = Vector3::new(self.plus_minus(40.0), self.plus_minus(40.0), self.clear);
        self.line("RAPID");
        self.go();
        if self.random.chance(0.6) {
            self.here.z = self.random.between(1.0, 5.0);
            if self.random.chance(0.7) {
                self.line("RAPID");
            } else {
                self.feed();
            }
            self.go();
        }
        self.feed();
    }

    /// A tool axis: vertical, at a round angle, or at any angle.
    fn some_axis(&mut self) -> Vector3<f64> {
        let most = match self.needs.axis_range {
            AxisRange::Vertical => return Vector3::z(),
            AxisRange::AboutX => 80.0,
            AxisRange::UpTo(most) => f64::from(most),
        };
        let tilt = match self.random.below(4) {
            0 => return Vector3::z(),
            1 => 15.0 * self.random.below((most / 15.0) as usize + 1) as f64,
            2 => self.random.between(0.0, 2.0),
            _ => self.random.between(0.0, most),
        };
        let azimuth = match (self.needs.axis_range, self.random.below(2)) {
            (AxisRange::AboutX, _) => 90.0 * self.random.sign(),
            (_, 0) => 45.0 * self.random.below(8) as f64,
            _ => self.random.between(-180.0, 180.0),
        };
        direction(tilt, azimuth)
    }

    // ------------------------------------------------------------------ operations

    /// Cuts lines and arcs at one tool axis.
    fn flat(&mut self) {
        for _ in 0..2 + self.random.below(12) {
            match self.random.below(20) {
                16 => self.curve(),
                17 => self.list(),
                18 => self.call(),
                19 => self.delta_of_file(),
                0..=3 => self.stroke(100.0),
                4 => self.stroke(0.02),
                5 => self.go(),
                6 => self.plunge(),
                7..=9 => self.arc(),
                10 => self.helix(),
                11 => self.vertical_arc(),
                12 => self.over(),
                13 => self.delta(),
                _ => self.other_record(),
            }
        }
        self.leave();
    }

    /// Cuts with a tool axis that changes from point to point, sometimes through the pole.
    fn surface(&mut self) {
        let (mut tilt, mut azimuth) = tilt_and_azimuth(&self.frame.column(2).into_owned());
        if self.needs.axis_range == AxisRange::AboutX && tilt < 1e-9 {
            azimuth = 90.0;
        }
        let pole = self.random.chance(0.3);
        let most = match self.needs.axis_range {
            AxisRange::UpTo(most) => f64::from(most),
            _ => 80.0,
        };
        let azimuth_step = self.random.between(-12.0, 12.0);
        let tilt_step = if pole { -tilt / 5.0 - 0.3 } else { self.random.between(-3.0, 3.0) };
        // The tip does not move while the axis rotates about it: the frames have one origin.
        let mut tip = self.here();
        for step in 0..4 + self.random.below(16) {
            match self.random.below(14) {
                0 => self.other_record(),
                1 => self.repeat(tip),
                _ => {}
            }
            tilt += tilt_step;
            if tilt < 0.0 {
                (tilt, azimuth) = (-tilt, azimuth + 180.0);
            }
            tilt = tilt.min(most);
            if self.needs.axis_range != AxisRange::AboutX {
                azimuth += azimuth_step;
            }
            let axis = if pole && step == 5 { Vector3::z() } else { direction(tilt, azimuth) };
            if self.random.chance(0.9) {
                tip += Vector3::new(self.plus_minus(8.0), self.plus_minus(8.0), self.plus_minus(2.0));
            }
            self.orient(axis);
            self.point("GOTO", tip, Some(axis));
            self.axis = Some(axis);
        }
        self.origin = tip;
        self.here = Vector3::zeros();
        self.leave();
    }

    /// Cuts a contour with cutter compensation.
    fn contour(&mut self) {
        let side = if self.random.chance(0.5) { "LEFT" } else { "RIGHT" };
        self.here.z = -self.random.between(0.5, 4.0);
        self.go();
        self.line(&format!("CUTCOM/{side}"));
        self.stroke_flat(30.0);
        for _ in 0..1 + self.random.below(5) {
            if self.random.chance(0.5) {
                self.stroke_flat(60.0)
            } else {
                self.round(1, 0.0)
            }
            if self.random.chance(0.1) {
                self.feed();
            }
        }
        self.line("CUTCOM/OFF");
        self.stroke_flat(30.0);
        self.leave();
    }

    /// Makes holes at one tool axis, with one cycle or more.
    fn holes(&mut self) {
        // Whether a hole lies below the point before its cycle, and the tool goes back there after it: from random
        // numbers of their own.
        let mut over = Random::new(!self.random.clone().bits());
        self.here.z = self.clear;
        self.line("RAPID");
        self.go();
        for _ in 0..1 + self.random.below(3) {
            let before = self.here;
            self.cycle();
            let mut below = over.chance(0.5);
            for _ in 0..1 + self.random.below(4) {
                let level = if self.random.chance(0.8) { 0.0 } else { self.plus_minus(6.0) };
                self.here = Vector3::new(self.plus_minus(40.0), self.plus_minus(40.0), level);
                if std::mem::take(&mut below) {
                    (self.here.x, self.here.y) = (before.x, before.y);
                }
                self.go();
            }
            self.line("CYCLE/OFF");
            if over.chance(0.3) {
                self.here.z = self.clear;
                self.line("RAPID");
                self.go();
            }
            if self.random.chance(0.2) {
                self.here.z = self.clear;
                self.line("RAPID");
                self.go();
                self.line("CYCLE/ON");
                self.here = Vector3::new(self.plus_minus(40.0), self.plus_minus(40.0), 0.0);
                self.go();
                self.line("CYCLE/OFF");
            }
            if self.random.chance(0.2) {
                self.other_record();
            }
        }
        self.leave();
    }

    fn cycle(&mut self) {
        let kind = ["DRILL", "DRILL", "FACE", "CSINK", "REAM", "BORE", "THRU", "DEEP", "BRKCHP", "TAP"];
        let kind = kind[self.random.below(kind.len())];
        let depth = self.random.between(2.0, 25.0);
        let clear = self.random.between(8.0, 12.0);
        let mut words = vec![format!("CYCLE/{kind}")];
        let step = match kind {
            "DEEP" | "BRKCHP" => format!(",STEP,{}", self.some_length(depth / 6.0, depth / 1.1)),
            _ => String::new(),
        };
        let depth = self.length(depth);
        let clear = self.length(clear);
        let back = self.some_length(12.0, 30.0);
        let (per_revolution, per_minute) = if self.needs.inches { ("IPR", "IPM") } else { ("MMPR", "MMPM") };
        let feed = match kind {
            "TAP" => {
                let pitch = [0.5, 0.8, 1.0, 1.25, 1.5][self.random.below(5)];
                format!(",{per_revolution},{}", self.length(pitch))
            }
            _ if self.random.chance(0.15) => format!(",{per_revolution},{}", self.some_length(0.05, 0.4)),
            _ => format!(",{per_minute},{}", self.some_length(40.0, 400.0)),
        };
        if self.needs.nx {
            words.push(format!("{step},RAPTO,{clear},FEDTO,-{depth}"));
            match self.random.below(3) {
                0 => words.push(",RTRCTO,AUTO".to_owned()),
                1 => words.push(format!(",RTRCTO,{back}")),
                _ => {}
            }
        } else {
            words.push(format!(",DEPTH,{depth}{step},CLEAR,{clear}"));
            if self.random.chance(0.5) {
                words.push(format!(",RETURN,{back}"));
            }
        }
        match self.random.below(5) {
            0 => words.push(",DWELL,0.5".to_owned()),
            1 => words.push(",DWELL,REV,3".to_owned()),
            _ => {}
        }
        words.push(feed);
        self.line(&words.concat());
    }
}

/// Tool axis from tilt and azimuth, degrees.
fn direction(tilt: f64, azimuth: f64) -> Vector3<f64> {
    let (sin, cos) = tilt.to_radians().sin_cos();
    let (across, along) = azimuth.to_radians().sin_cos();
    Vector3::new(sin * along, sin * across, cos)
}

/// Tilt and azimuth of a tool axis, degrees.
fn tilt_and_azimuth(axis: &Vector3<f64>) -> (f64, f64) {
    (axis.x.hypot(axis.y).atan2(axis.z).to_degrees(), axis.y.atan2(axis.x).to_degrees())
}
