//! Entrances of the command line: the process, or streams of the caller; controls besides those of this crate.

use std::ffi::OsString;
use std::fmt;
use std::io::{self, IsTerminal as _};
use std::process::ExitCode;

use crate::control::Control;
use crate::kinematics::{AnyMachine, Machine};
use crate::post::post_data;

use super::outcome::{Status, Streams};
use super::{closed, execute, temporary};

/// Runs the command line of the machine `M`: the whole of a machine's `main`.
#[must_use]
pub fn run<M: Machine>() -> ExitCode {
    App::new().run::<M>()
}

/// [`run`] for a machine whose type is known at run time only.
#[must_use]
pub fn run_for(machine: &dyn AnyMachine) -> ExitCode {
    App::new().run_for(machine)
}

/// Runs the command line of the machine `M` on streams of the caller, in its process. `args`: name of the program,
/// command, options.
///
/// ```
/// # use pp_runtime::cli;
/// pp_runtime::machine! {
///     /// A trunnion table.
///     pub struct Trunnion;
///     chain: C A | X Y Z;
/// }
///
/// let args = ["trunnion", "config", "--control", "fanuc"].map(Into::into);
/// let (mut output, mut errors) = (Vec::new(), Vec::new());
/// let streams = cli::Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
/// assert_eq!(cli::run_with::<Trunnion>(&args, streams), cli::Status::Done);
/// assert!(output.starts_with(b"#"));
/// ```
#[must_use]
pub fn run_with<M: Machine>(args: &[OsString], streams: Streams<'_>) -> Status {
    App::new().run_with::<M>(args, streams)
}

/// The command line, with controls of one's own.
///
/// `fn main() -> ExitCode { cli::App::new().control(&House).run::<MyMachine>() }`
#[derive(Clone, Default)]
pub struct App {
    controls: Vec<&'static dyn Control>,
}

impl fmt::Debug for App {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.controls.iter().map(|control| control.spellings().name)).finish()
    }
}

impl App {
    /// The command line with the controls of this crate.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a control; `--control` takes the name in its table. The first that is added is the default. A control of
    /// this crate that has the same name is replaced.
    #[must_use]
    pub fn control(mut self, control: &'static dyn Control) -> Self {
        self.controls.push(control);
        self
    }

    /// Runs the command line of the machine `M` in this process.
    #[must_use]
    pub fn run<M: Machine>(&self) -> ExitCode {
        self.run_for(&M::default())
    }

    /// [`run`](Self::run) for a machine whose type is known at run time only.
    #[must_use]
    pub fn run_for(&self, machine: &dyn AnyMachine) -> ExitCode {
        let args: Vec<OsString> = std::env::args_os().collect();
        let terminal = io::stderr().is_terminal();
        let (mut input, mut output, mut errors) = (closed::input(), closed::output(), io::stderr());
        let streams = Streams { input: &mut *input, output: &mut *output, errors: &mut errors, terminal };
        // Without it a signal may leave a hidden file beside the program: no reason not to run.
        let _ = temporary::watch_signals();
        self.execute(machine, &args, streams).into()
    }

    /// Runs the command line of the machine `M` on streams of the caller. `args`: name of the program, command,
    /// options.
    #[must_use]
    pub fn run_with<M: Machine>(&self, args: &[OsString], streams: Streams<'_>) -> Status {
        self.execute(&M::default(), args, streams)
    }

    fn execute(&self, machine: &dyn AnyMachine, args: &[OsString], streams: Streams<'_>) -> Status {
        execute(machine, &self.controls, args, streams, &|job, source, sink, line_map| {
            post_data(machine, job, source, sink, line_map)
        })
    }
}
