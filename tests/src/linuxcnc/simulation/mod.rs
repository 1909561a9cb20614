//! The whole control, simulated and without a screen: task, interpreter, trajectory planner and kinematics module.
//!
//! The test sends commands to `linuxcncrsh`, which replaces the screen; `halsampler` records joints and axes. A
//! computer runs one LinuxCNC at a time: a second test waits. The control runs in real time, without real-time
//! priority.

mod component;
mod configuration;
mod marks;
mod shell;

use std::fs::{self, File};
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

pub use component::{RotaryTable, Rotation, can_be_loaded};
pub use configuration::{Kinematics, SERVO_PERIOD, SPINDLE_SCALE, SimulatedControl, Tool};
pub use marks::{MarkKinematics, Reached};
use marks::{Samples, marked};
use shell::Shell;

/// Lock file of LinuxCNC: a second LinuxCNC would end the first.
const RUNNING: &str = "/tmp/linuxcnc.lock";

/// Programs of a LinuxCNC that runs, starts or ends, as the kernel names them. The first starts and ends the others.
const PROGRAMS: [&str; 4] = ["linuxcnc", "linuxcncsvr", "milltask", "rtapi_app"];

/// Longest wait for another LinuxCNC to end.
const OTHERS: Duration = Duration::from_secs(360);

/// Longest time for the control to start, and to end.
const START: Duration = Duration::from_secs(40);

/// Seconds after which the control is ended in any case.
const LIFETIME: &str = "600";

/// Longest time without a new mark; after it a program counts as hanging.
const STANDSTILL: Duration = Duration::from_secs(180);

/// A running control. It ends with this value.
pub struct Simulation {
    process: Child,
    shell: Option<Shell>,
    samples: Option<Samples>,
    folder: TempDir,
    joints: usize,
    /// The next mark.
    mark: usize,
    /// Held until the control has ended.
    _alone: File,
}

impl Simulation {
    /// Starts the control, homed and ready to run programs.
    ///
    /// # Errors
    /// Reason why it does not start, with the output of LinuxCNC.
    pub fn start(control: &SimulatedControl) -> Result<Self, String> {
        let alone = alone().map_err(|error| format!("cannot wait for the control: {error}"))?;
        let folder = TempDir::new().map_err(|error| error.to_string())?;
        let port = free_port().map_err(|error| error.to_string())?;
        let own = !matches!(control.kinematics, Kinematics::Module(..));
        let process = control.write(folder.path(), port).and_then(|()| launch(folder.path(), own));
        let process = process.map_err(|error| format!("LinuxCNC cannot be started: {error}"))?;
        let joints = control.letters.len();
        let mut simulation = Self { process, shell: None, samples: None, folder, joints, mark: 1, _alone: alone };
        match simulation.switch_on(port, control.feed_override) {
            Ok(()) => Ok(simulation),
            Err(error) => Err(simulation.report(&error.to_string())),
        }
    }

    fn switch_on(&mut self, port: u16, feed_override: u32) -> io::Result<()> {
        let deadline = Instant::now() + START;
        let mut shell = loop {
            match Shell::connect(port) {
                Ok(shell) => break shell,
                Err(error) if Instant::now() > deadline => return Err(error),
                Err(_) if self.process.try_wait()?.is_some() => return Err(io::Error::other("LinuxCNC has ended")),
                Err(_) => sleep(Duration::from_millis(50)),
            }
        };
        shell.wait_until_done(true)?;
        for command in ["set estop off", "set machine on", "set mode manual", "set home -1"] {
            shell.command(command)?;
        }
        let homed = format!("JOINT_HOMED{}", " YES".repeat(self.joints));
        while !shell.ask("get joint_homed")?.starts_with(&homed) {
            if Instant::now() > deadline {
                return Err(io::Error::other("the joints are not homed"));
            }
            sleep(Duration::from_millis(20));
        }
        shell.command(&format!("set feed_override {feed_override}"))?;
        self.shell = Some(shell);
        self.samples = Some(Samples::open(&self.folder.path().join(configuration::SAMPLES))?);
        Ok(())
    }

    /// Runs a program and returns the position after each of `lines`.
    ///
    /// # Errors
    /// Messages of the control about the program, or that the program makes no progress.
    pub fn run(&mut self, program: &str, lines: &[usize], kinematics: MarkKinematics) -> Result<Vec<Reached>, String> {
        let first = self.mark;
        self.mark += lines.len();
        let path = self.folder.path().join(format!("program{first}.ngc"));
        let written = fs::write(&path, marked(program, lines, first, kinematics));
        if let Err(error) = written.and_then(|()| self.execute(&path, self.mark)) {
            return Err(self.report(&error.to_string()));
        }
        let samples = self.samples.as_ref().ok_or("the control is not on")?;
        (first..).zip(lines).map(|(mark, line)| samples.reached(mark, *line)).collect()
    }

    /// Runs a file until mark `end - 1` has been seen and the interpreter is idle.
    fn execute(&mut self, path: &Path, end: usize) -> io::Result<()> {
        let (Some(shell), Some(samples)) = (&mut self.shell, &mut self.samples) else {
            return Err(io::Error::other("the control is not on"));
        };
        shell.wait_until_done(true)?;
        shell.command("set mode auto")?;
        shell.command(&format!("set open {}", path.display()))?;
        shell.wait_until_done(false)?;
        let started = shell.ask("set run")?;
        let mut marks = samples.marks();
        let mut deadline = Instant::now() + STANDSTILL;
        loop {
            sleep(Duration::from_millis(20));
            let messages = shell.messages()?;
            if !messages.is_empty() || started.ends_with("NAK") {
                return Err(io::Error::other(format!("the control reports: {}", messages.join("; "))));
            }
            samples.read()?;
            if samples.marks() > marks {
                marks = samples.marks();
                deadline = Instant::now() + STANDSTILL;
            }
            match shell.ask("get program_status")?.as_str() {
                "PROGRAM_STATUS IDLE" if marks >= end => return Ok(()),
                // M0: the operator presses the button.
                "PROGRAM_STATUS PAUSED" => shell.command("set resume")?,
                _ => {}
            }
            if Instant::now() > deadline {
                let seconds = STANDSTILL.as_secs();
                return Err(io::Error::other(format!("{marks} of {end} marks, no new one for {seconds} s")));
            }
        }
    }

    /// The error, with the output of the control.
    fn report(&self, what: &str) -> String {
        let read = |name: &str| fs::read_to_string(self.folder.path().join(name)).unwrap_or_default();
        format!("{what}\n--- output of LinuxCNC\n{}{}", read("log"), read("linuxcnc_print.txt"))
    }

    /// Whether the control has ended, after waiting for it.
    fn has_ended(&mut self) -> bool {
        let deadline = Instant::now() + START;
        while Instant::now() < deadline {
            if self.process.try_wait().is_ok_and(|status| status.is_some()) {
                return true;
            }
            sleep(Duration::from_millis(50));
        }
        false
    }
}

impl Drop for Simulation {
    fn drop(&mut self) {
        let asked = self.shell.as_mut().is_some_and(|shell| shell.shut_down().is_ok());
        if asked && self.has_ended() {
            return;
        }
        // `timeout` passes the signal on to all processes that it has started.
        let _ = Command::new("kill").arg(self.process.id().to_string()).status();
        if self.has_ended() {
            return;
        }
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Waits until no other LinuxCNC runs, and takes the lock that keeps other tests from starting one.
///
/// One that was killed leaves its lock file and shared memory. By the file the next one knows that it has to remove
/// both.
fn alone() -> io::Result<File> {
    let path = std::env::temp_dir().join("linuxcnc-simulation.lock");
    // Another user may have created it.
    let file = File::open(&path).or_else(|_| File::create(&path))?;
    file.lock()?;
    let deadline = Instant::now() + OTHERS;
    while Path::new(RUNNING).exists() && is_running()? {
        if Instant::now() > deadline {
            return Err(io::Error::other("another LinuxCNC runs"));
        }
        sleep(Duration::from_millis(200));
    }
    Ok(file)
}

/// Whether a LinuxCNC runs on this computer.
fn is_running() -> io::Result<bool> {
    for process in fs::read_dir("/proc")? {
        // A process may end meanwhile, and not every entry is a process.
        let state = fs::read_to_string(process?.path().join("stat")).unwrap_or_default();
        // Z: it has ended, and nobody has asked how.
        if PROGRAMS.iter().any(|name| state.contains(&format!("({name}) "))) && !state.contains(") Z ") {
            return Ok(true);
        }
    }
    Ok(false)
}

fn free_port() -> io::Result<u16> {
    Ok(TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?.local_addr()?.port())
}

/// Starts LinuxCNC in a folder that holds its configuration. `own`: and its kinematics.
fn launch(folder: &Path, own: bool) -> io::Result<Child> {
    let log = File::create(folder.join("log"))?;
    // As root the real-time part runs as the user `nobody`, which must be able to create its socket.
    Command::new("chmod").arg("a+rwx").arg(folder).status()?;
    let mut command = Command::new("timeout");
    command.args(["--kill-after=20", LIFETIME]);
    if own {
        component::in_place(&mut command, folder);
    }
    command.args(["linuxcnc", "-r"]).arg(folder.join("machine.ini"));
    command.current_dir(folder).env("HOME", folder).env_remove("DISPLAY");
    if is_root()? {
        command.env("RTAPI_UID", "65534").env("RTAPI_FIFO_PATH", folder.join("rtapi_fifo"));
    }
    command.stdin(Stdio::null()).stdout(log.try_clone()?).stderr(log).spawn()
}

fn is_root() -> io::Result<bool> {
    Ok(Command::new("id").arg("-u").output()?.stdout.trim_ascii() == b"0")
}
