//! The command lines of the machines, in this process.

use std::cell::RefCell;
use std::ffi::OsString;
use std::io::{self, Write};
use std::rc::Rc;

use ::machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use examples::house_control::House;
use machine_library::{
    BridgeMill, HaasRotary, HaasTrunnion, HaasUmc, IntegrexI200, Max5, ObliqueYLathe, PocketNcV2, XyzabTdr, XyzacTrt,
    XyzacbTrsrn, XyzbcTrt,
};
use pp_runtime::cli::{App, Status, Streams};
use pp_runtime::kinematics::Machine;

#[allow(dead_code, reason = "its `main` is not called")]
#[path = "../../../examples/src/bin/quickstart.rs"]
mod quickstart;

#[allow(dead_code, reason = "its `main` is not called")]
#[path = "../../../examples/src/bin/house_control.rs"]
mod house_control;

type Entry = fn(&[OsString], Streams<'_>) -> Status;

fn entry<M: Machine>(args: &[OsString], streams: Streams<'_>) -> Status {
    App::new().run_with::<M>(args, streams)
}

fn house(args: &[OsString], streams: Streams<'_>) -> Status {
    App::new().control(&House).run_with::<house_control::HouseTrunnion>(args, streams)
}

const MACHINES: [(&str, Entry); 18] = [
    ("spinner-u5-620", entry::<SpinnerU5620>),
    ("dmu-70e", entry::<Dmu70e>),
    ("lola-xoyzba", entry::<LolaXoyzba>),
    ("multiprodesk", entry::<MultiProDesk>),
    ("bridge-mill", entry::<BridgeMill>),
    ("haas-rotary", entry::<HaasRotary>),
    ("haas-trunnion", entry::<HaasTrunnion>),
    ("haas-umc", entry::<HaasUmc>),
    ("integrex-i200", entry::<IntegrexI200>),
    ("max5", entry::<Max5>),
    ("oblique-y-lathe", entry::<ObliqueYLathe>),
    ("pocketnc-v2", entry::<PocketNcV2>),
    ("xyzab-tdr", entry::<XyzabTdr>),
    ("xyzac-trt", entry::<XyzacTrt>),
    ("xyzacb-trsrn", entry::<XyzacbTrsrn>),
    ("xyzbc-trt", entry::<XyzbcTrt>),
    ("quickstart", entry::<quickstart::Trunnion>),
    ("house_control", house),
];

fn find(name: &str) -> Option<Entry> {
    MACHINES.iter().find(|(machine, _)| *machine == name).map(|(_, entry)| *entry)
}

/// Whether a binary has this name.
pub(crate) fn is_one(name: &str) -> bool {
    find(name).is_some()
}

/// Standard output and messages in one text, as a terminal shows them.
#[derive(Clone, Default)]
struct Terminal(Rc<RefCell<Vec<u8>>>);

impl Terminal {
    fn text(&self) -> String {
        String::from_utf8(self.0.take()).expect("text")
    }
}

impl Write for Terminal {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Runs a machine's command line in the current folder: status and what it prints.
pub(crate) fn run(machine: &str, arguments: &[&str]) -> (Status, String) {
    let terminal = Terminal::default();
    let status = run_on(machine, arguments, &mut terminal.clone(), &mut terminal.clone());
    (status, terminal.text())
}

/// The same with standard output to a file: the messages are printed.
pub(crate) fn run_to(machine: &str, arguments: &[&str], file: &mut dyn Write) -> (Status, String) {
    let terminal = Terminal::default();
    let status = run_on(machine, arguments, file, &mut terminal.clone());
    (status, terminal.text())
}

fn run_on(machine: &str, arguments: &[&str], output: &mut dyn Write, errors: &mut dyn Write) -> Status {
    let entry = find(machine).unwrap_or_else(|| panic!("no machine {machine}"));
    let args: Vec<OsString> = [machine].iter().chain(arguments).map(Into::into).collect();
    entry(&args, Streams { input: &mut &b""[..], output, errors, terminal: false })
}
