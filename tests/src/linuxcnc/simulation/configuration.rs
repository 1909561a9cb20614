//! Configuration of LinuxCNC for a machine: its INI and HAL files, remapped codes, tool table and offsets.
//!
//! The control starts with joints as axes; M428 switches to the kinematics of the machine, M429 back, as in the
//! documentation of switchable kinematics. Three analog outputs belong to the harness: 0 counts marks, 3 selects the
//! kinematics, 2 is never read. Digital input 0 is on when the joints have settled.
//!
//! A generated module comes with its own configuration. Only its screen, its accelerations and its tool table are
//! replaced.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::Path;

use pp_runtime::transformation::linuxcnc::ModuleFile;

use super::super::module;
use super::component::{self, RotaryTable};

/// Cycle of the servo thread, s: a quarter of the usual one. Each block waits for some cycles, so a program takes a
/// quarter of the time; the task has the same cycle, so that it follows.
pub const SERVO_PERIOD: f64 = 0.25e-3;

/// Speed of every axis, mm/s and deg/s: high, so that a test need not wait.
const SPEED: f64 = 1e5;

/// Cycle of the servo thread, ns.
fn nanoseconds() -> u32 {
    (SERVO_PERIOD * 1e9).round() as u32
}

/// Travel limit of a coordinate without a joint, mm and degrees.
const UNLIMITED: f64 = 1e5;

/// Time from "machine in position" to "joints in position", seconds of the servo thread: the joint interpolator lags by
/// four cycles.
const SETTLING: f64 = 8.0 * SERVO_PERIOD;

/// A separate command for an output that nothing reads: after it, everything before it has been planned.
///
/// The servo thread accepts a command first and plans afterwards. A task that reads the state in between gets the old
/// one: standstill, because the motion before it has not begun, or the previous kinematics. The next command is
/// accepted one cycle later.
const PLANNED: &str = "M68 E2 Q0\n";

/// Blocks that wait until the joints have settled, for 50 seconds at most.
pub(super) fn settled() -> String {
    format!("{PLANNED}M66 P0 L3 Q50\n")
}

/// Name of the file in which the sampler writes.
pub(super) const SAMPLES: &str = "samples.txt";

/// Blocks that change the kinematics: 0 joints as axes, 1 those of the machine. Reading an input makes the interpreter
/// wait and fetch the axis positions again.
pub(super) fn switch(kinematics: u32) -> String {
    format!("M68 E3 Q{kinematics}\n{PLANNED}M66 E0 L0\n")
}

/// How many times faster than commanded the spindle turns, so that a thread is cut while a test waits.
pub const SPINDLE_SCALE: f64 = 16.0;

/// Kinematics of a machine, switched between joints as axes and tip control.
#[derive(Debug, Clone)]
pub enum Kinematics {
    /// A module of LinuxCNC, which must be switchable and have a pin `tool-offset`; its other pins and their values.
    Module(&'static str, Vec<(&'static str, f64)>),
    /// A component compiled for one machine, with joints X Y Z B C.
    Component(RotaryTable),
    /// A generated module with its configuration.
    Generated(Vec<ModuleFile>),
}

/// A tool of the tool table, mm.
#[derive(Debug, Clone, Copy)]
pub struct Tool {
    /// Number of the tool and of its pocket.
    pub number: u32,
    /// Length.
    pub length: f64,
    /// Diameter.
    pub diameter: f64,
}

/// A machine on the simulated control. mm and degrees.
#[derive(Debug, Clone)]
pub struct SimulatedControl {
    /// Its kinematics.
    pub kinematics: Kinematics,
    /// Axis letters in the order of the joints.
    pub letters: &'static str,
    /// X Y Z of G54, G55 and so on, mm.
    pub work_offsets: Vec<[f64; 3]>,
    /// Travel of each joint, lower and upper limit, in the order of the letters.
    pub travel: Vec<[f64; 2]>,
    /// The tool table.
    pub tools: Vec<Tool>,
    /// Acceleration of every axis, mm/s² and deg/s².
    pub acceleration: f64,
    /// Feed override, percent.
    pub feed_override: u32,
}

impl SimulatedControl {
    /// Writes all files into a folder. `port`: TCP port of the control's shell.
    pub(super) fn write(&self, folder: &Path, port: u16) -> io::Result<()> {
        let write = |name: &str, text: String| fs::write(folder.join(name), text);
        if let Kinematics::Generated(files) = &self.kinematics {
            component::show(&module::compile(files, folder)?, folder)?;
            let ini = files.iter().find(|file| file.name.ends_with(".ini")).ok_or(io::ErrorKind::NotFound)?;
            write("machine.ini", self.adapted(&ini.text, port))?;
            write("harness.hal", self.harness())?;
            return write("params.var", self.parameters());
        }
        write("machine.ini", self.ini(port))?;
        write("machine.hal", self.hal())?;
        let tool = |tool: &Tool| format!("T{0} P{0} Z{1} D{2}\n", tool.number, tool.length, tool.diameter);
        write("tool.tbl", self.tools.iter().map(tool).collect())?;
        write("params.var", self.parameters())?;
        if let Kinematics::Component(table) = &self.kinematics {
            component::compile(table, folder)?;
        }
        for (name, kinematics) in [("m428", 1), ("m429", 0)] {
            // The joints lag the axes by some servo cycles, and the switch uses their momentary positions. At the
            // accelerations of a real machine the error is negligible; at this one it would be tenths of a degree.
            let lines = format!("o<{name}>sub\n{}{}o<{name}>endsub\nM2\n", settled(), switch(kinematics));
            write(&format!("{name}.ngc"), lines)?;
        }
        Ok(())
    }

    /// The INI file of a generated module without a screen, with accelerations for which a test need not wait.
    fn adapted(&self, ini: &str, port: u16) -> String {
        let line = |line: &str| match line.split_once(" = ") {
            Some(("DISPLAY", _)) => format!("DISPLAY = linuxcncrsh --port {port}\n"),
            // A busy computer delays the control.
            Some(("COMM_TIMEOUT", _)) => "COMM_TIMEOUT = 10\n".to_owned(),
            Some(("MAX_FEED_OVERRIDE", _)) => "MAX_FEED_OVERRIDE = 100\n".to_owned(),
            Some(("SERVO_PERIOD", _)) => format!("SERVO_PERIOD = {}\n", nanoseconds()),
            Some(("CYCLE_TIME", _)) => format!("CYCLE_TIME = {SERVO_PERIOD}\n"),
            Some(("PARAMETER_FILE", _)) => "PARAMETER_FILE = params.var\n".to_owned(),
            Some(("HALFILE", file)) => format!("HALFILE = {file}\nHALFILE = harness.hal\n"),
            Some((key, _)) if key.contains("ACCELERATION") => format!("{key} = {}\n", self.acceleration),
            _ => format!("{line}\n"),
        };
        ini.lines().map(line).collect()
    }

    /// HAL lines of the harness.
    fn harness(&self) -> String {
        let joints = self.letters.len();
        let mut hal = format!(
            "loadrt timedelay\nloadrt sampler depth=16000 cfg=fb{}\n\
             addf timedelay.0 servo-thread\naddf sampler.0 servo-thread\n\
             net still motion.in-position timedelay.0.in\n\
             net settled timedelay.0.out motion.digital-in-00 sampler.0.pin.1\n\
             setp timedelay.0.on-delay {SETTLING}\nsetp timedelay.0.off-delay 0\n\
             net mark motion.analog-out-00 sampler.0.pin.0\n",
            "f".repeat(2 * joints),
        );
        for (joint, letter) in self.letters.to_ascii_lowercase().chars().enumerate() {
            let (here, there) = (joint + 2, joint + 2 + joints);
            let _ = write!(
                hal,
                "net joint-{joint} sampler.0.pin.{here}\nnet axis{letter} axis.{letter}.pos-cmd sampler.0.pin.{there}\n"
            );
        }
        let _ = writeln!(hal, "loadusr halsampler -t {SAMPLES}");
        hal
    }

    /// Work offsets as interpreter parameters: G54 has 5221 to 5229, G55 5241 to 5249, and so on.
    fn parameters(&self) -> String {
        let mut parameters = "5220 1\n".to_owned();
        for (system, offset) in self.work_offsets.iter().enumerate() {
            for (axis, value) in offset.iter().enumerate() {
                let _ = writeln!(parameters, "{} {value}", 5221 + 20 * system + axis);
            }
        }
        parameters
    }

    /// Name of the kinematics module.
    fn module(&self) -> &'static str {
        match self.kinematics {
            Kinematics::Module(module, _) => module,
            Kinematics::Component(_) | Kinematics::Generated(_) => component::MODULE,
        }
    }

    fn ini(&self, port: u16) -> String {
        let arguments = match self.kinematics {
            Kinematics::Module(..) => " sparm=identityfirst",
            Kinematics::Component(_) | Kinematics::Generated(_) => "",
        };
        let mut ini = format!(
            "[EMC]\nVERSION=1.1\nMACHINE=simulated\nDEBUG=0\n\
             [DISPLAY]\nDISPLAY=linuxcncrsh --port {port}\nMAX_FEED_OVERRIDE=100\n\
             [RS274NGC]\nPARAMETER_FILE=params.var\nSUBROUTINE_PATH=.\n\
             REMAP=M428 modalgroup=10 ngc=m428\nREMAP=M429 modalgroup=10 ngc=m429\n\
             [EMCMOT]\nEMCMOT=motmod\nSERVO_PERIOD={period}\nCOMM_TIMEOUT=10\n\
             [TASK]\nTASK=milltask\nCYCLE_TIME={SERVO_PERIOD}\n\
             [HAL]\nHALFILE=machine.hal\n\
             [EMCIO]\nEMCIO=io\nCYCLE_TIME={SERVO_PERIOD}\nTOOL_TABLE=tool.tbl\n\
             [TRAJ]\nCOORDINATES={letters}\nLINEAR_UNITS=mm\nANGULAR_UNITS=degree\n\
             DEFAULT_LINEAR_VELOCITY={SPEED}\nMAX_LINEAR_VELOCITY={SPEED}\n\
             DEFAULT_LINEAR_ACCELERATION={acceleration}\nMAX_LINEAR_ACCELERATION={acceleration}\n\
             DEFAULT_ANGULAR_VELOCITY={SPEED}\nMAX_ANGULAR_VELOCITY={SPEED}\n\
             [KINS]\nKINEMATICS={kinematics}{arguments}\nJOINTS={joints}\n",
            period = nanoseconds(),
            letters = self.letters,
            acceleration = self.acceleration,
            kinematics = self.module(),
            joints = self.letters.len(),
        );
        for (joint, (letter, [least, most])) in self.letters.chars().zip(&self.travel).enumerate() {
            let kind = if "ABC".contains(letter) { "ANGULAR" } else { "LINEAR" };
            let speeds = format!("MAX_VELOCITY={SPEED}\nMAX_ACCELERATION={}\n", self.acceleration);
            let _ = write!(
                ini,
                "[AXIS_{letter}]\nMIN_LIMIT=-{UNLIMITED}\nMAX_LIMIT={UNLIMITED}\n{speeds}\
                 [JOINT_{joint}]\nTYPE={kind}\nHOME=0\nHOME_SEQUENCE=0\nHOME_SEARCH_VEL=0\n{speeds}\
                 MIN_LIMIT={least}\nMAX_LIMIT={most}\nFERROR={UNLIMITED}\nMIN_FERROR={UNLIMITED}\n"
            );
        }
        ini
    }

    fn hal(&self) -> String {
        let joints = self.letters.len();
        let mut hal = format!(
            "loadrt [KINS]KINEMATICS\n\
             loadrt motmod servo_period_nsec={} num_joints={joints} num_dio=1 num_aio=4\n\
             loadrt timedelay\nloadrt sim_spindle\n\
             loadrt sampler depth=16000 cfg=fb{}\n\
             addf motion-command-handler servo-thread\naddf motion-controller servo-thread\n\
             addf sim-spindle.0 servo-thread\naddf timedelay.0 servo-thread\naddf sampler.0 servo-thread\n\
             net still motion.in-position timedelay.0.in\n\
             net settled timedelay.0.out motion.digital-in-00 sampler.0.pin.1\n\
             setp timedelay.0.on-delay {SETTLING}\nsetp timedelay.0.off-delay 0\n\
             net enable iocontrol.0.user-enable-out iocontrol.0.emc-enable-in\n\
             net prepare iocontrol.0.tool-prepare iocontrol.0.tool-prepared\n\
             net change iocontrol.0.tool-change iocontrol.0.tool-changed\n\
             setp sim-spindle.0.scale {SPINDLE_SCALE}\nsetp spindle.0.at-speed 1\n\
             net speed spindle.0.speed-out-rps sim-spindle.0.velocity-cmd\n\
             net turned sim-spindle.0.position-fb spindle.0.revs\n\
             net index sim-spindle.0.index-enable spindle.0.index-enable\n\
             net length motion.tooloffset.z {}.tool-offset\n\
             net wanted motion.analog-out-03 motion.switchkins-type\n\
             net mark motion.analog-out-00 sampler.0.pin.0\n",
            nanoseconds(),
            "f".repeat(2 * joints),
            self.module(),
        );
        for (joint, letter) in self.letters.to_ascii_lowercase().chars().enumerate() {
            let (here, there) = (joint + 2, joint + 2 + joints);
            let _ = write!(
                hal,
                "net joint{joint} joint.{joint}.motor-pos-cmd joint.{joint}.motor-pos-fb sampler.0.pin.{here}\n\
                 net axis{letter} axis.{letter}.pos-cmd sampler.0.pin.{there}\n"
            );
        }
        if let Kinematics::Module(module, pins) = &self.kinematics {
            for (pin, value) in pins {
                let _ = writeln!(hal, "setp {module}.{pin} {value}");
            }
        }
        let _ = writeln!(hal, "loadusr halsampler -t {SAMPLES}");
        hal
    }
}
