//! A kinematics module by itself, loaded by a small host program in place of LinuxCNC.

use std::fs;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use pp_runtime::transformation::linuxcnc::ModuleFile;
use tempfile::TempDir;

use super::absent;

/// Folder of LinuxCNC's own modules.
pub const MODULES: &str = "/usr/lib/linuxcnc/modules";

/// Nine numbers: a pose as X Y Z A B C U V W, or joints.
pub type Nine = [f64; 9];

/// Whether modules can be compiled; if not, prints that the test is skipped.
///
/// # Panics
/// If they cannot, and `PP_REQUIRE_LINUXCNC=1` requires it.
#[must_use]
pub fn can_be_compiled() -> bool {
    let runs = Command::new("halcompile").arg("--help").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if runs.is_ok() {
        return true;
    }
    absent("halcompile (Debian: linuxcnc-uspace-dev)");
    false
}

/// Writes the files of a module into a folder and compiles its component as its README has it, without installing it.
///
/// # Errors
/// Messages of `halcompile`.
pub fn compile(files: &[ModuleFile], folder: &Path) -> io::Result<PathBuf> {
    for ModuleFile { name, text } in files {
        fs::write(folder.join(name), text)?;
    }
    let component = files.iter().find(|file| file.name.ends_with(".comp")).ok_or(io::ErrorKind::NotFound)?;
    let output = Command::new("halcompile").arg("--compile").arg(&component.name).current_dir(folder).output()?;
    let messages = String::from_utf8_lossy(&output.stderr);
    // `warning` is a message of the compiler as well.
    if !output.status.success() || messages.contains("warning") {
        return Err(io::Error::other(messages.into_owned()));
    }
    Ok(folder.join(&component.name).with_extension("so"))
}

/// A loaded module.
pub struct Module {
    process: Child,
    questions: ChildStdin,
    answers: BufReader<ChildStdout>,
    _folder: TempDir,
}

impl Module {
    /// Loads a module with its parameters `coordinates` and `sparm`, which may be empty.
    ///
    /// # Panics
    /// If it cannot be loaded, or makes its pins otherwise than LinuxCNC requires.
    #[must_use]
    pub fn load(module: &Path, coordinates: &str, sparm: &str) -> Self {
        let folder = TempDir::new().expect("a folder");
        let (source, host) = (folder.path().join("host.c"), folder.path().join("host"));
        fs::write(&source, include_str!("module_host.c")).expect("written");
        let mut compiler = Command::new("cc");
        // The module finds the functions of HAL in the program.
        compiler.args(["-O2", "-Wall", "-Wextra", "-Werror", "-rdynamic", "-o"]).arg(&host).arg(&source);
        let output = compiler.args(["-ldl", "-lm"]).output().expect("cc");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let mut command = Command::new(&host);
        command.arg(module).args([coordinates, sparm]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = command.spawn().expect("the host starts");
        let (questions, answers) = (process.stdin.take().expect("piped"), process.stdout.take().expect("piped"));
        Self { process, questions, answers: BufReader::new(answers), _folder: folder }
    }

    fn ask(&mut self, question: &str) -> String {
        writeln!(self.questions, "{question}").and_then(|()| self.questions.flush()).expect("the host reads");
        let mut answer = String::new();
        self.answers.read_line(&mut answer).expect("the host answers");
        assert!(!answer.is_empty(), "`{question}` has no answer: {:?}", self.process.try_wait());
        answer.trim().to_owned()
    }

    /// Sets a pin.
    ///
    /// # Panics
    /// If there is no such pin.
    pub fn set(&mut self, pin: &str, value: f64) {
        assert_eq!(self.ask(&format!("pin {pin} {value:?}")), "1", "no pin {pin}");
    }

    /// Whether a pin of kind bit is on.
    pub fn is_on(&mut self, pin: &str) -> bool {
        self.ask(&format!("get {pin}")) == "1"
    }

    /// Whether a second question for its type makes no second pins.
    pub fn makes_its_pins_once(&mut self) -> bool {
        self.ask("again") == "1"
    }

    /// Switches the kinematics; false if they refuse.
    pub fn switch(&mut self, kinematics: i32) -> bool {
        self.ask(&format!("switch {kinematics}")) == "0"
    }

    /// Joints of a pose; `None` where there are none.
    pub fn inverse(&mut self, pose: &Nine) -> Option<Nine> {
        self.nine("inverse", pose)
    }

    /// Pose of joints.
    pub fn forward(&mut self, joints: &Nine) -> Option<Nine> {
        self.nine("forward", joints)
    }

    /// Nanoseconds of one inverse and one forward, the mean of many.
    pub fn nanoseconds(&mut self, count: u32) -> f64 {
        self.ask(&format!("time {count}")).parse().expect("a number")
    }

    fn nine(&mut self, what: &str, numbers: &Nine) -> Option<Nine> {
        let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:.17e}")).collect();
        let answer = self.ask(&format!("{what} {}", numbers.join(" ")));
        let mut words = answer.split_whitespace();
        let done = words.next() == Some("0");
        let values: Vec<f64> = words.map(|word| word.parse().unwrap_or(f64::NAN)).collect();
        done.then(|| values.try_into().expect("nine numbers"))
    }
}

impl Drop for Module {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
