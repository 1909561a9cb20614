//! `post --simulate`: the program is simulated before it gets its final name.

use std::fs::File;
use std::io::{self, Seek as _, Write};

use crate::config::Config;
use crate::kinematics::AnyMachine;

use super::super::args::PostArgs;
use super::super::cl_source::ClSource;
use super::super::inputs::show_simulation;
use super::super::messages::MessageWriter;
use super::super::outcome::Failure;
use super::super::posting::{AfterPosting, Finished, PostRun};
use super::bodies::Bodies;
use super::{SimulatedFiles, SimulationRun, simulate};

/// The bodies of a program that is being posted, and its text.
struct PostedBodies<'a> {
    bodies: Bodies,
    text: File,
    args: &'a PostArgs,
}

/// The simulation that `post` asks for.
pub(crate) fn after_posting<'a>(
    config: &Config,
    args: &'a PostArgs,
) -> Result<Option<Box<dyn AfterPosting + 'a>>, Failure> {
    if !args.simulate {
        return match args.simulation.given() {
            Some(option) => Err(Failure::Argument(format!("`{option}` needs `--simulate`"))),
            None => Ok(None),
        };
    }
    let bodies = Bodies::read(&config.set_up, &args.simulation, config.output_units.unwrap_or_default())?;
    let text = tempfile::tempfile().map_err(|error| Failure::unwritable(&args.output, error))?;
    Ok(Some(Box::new(PostedBodies { bodies, text, args })))
}

impl AfterPosting for PostedBodies<'_> {
    fn writer(&mut self) -> &mut dyn Write {
        &mut self.text
    }

    fn finish(
        self: Box<Self>,
        terminal: bool,
        machine: &dyn AnyMachine,
        run: &PostRun<'_>,
        source: &mut ClSource,
        messages: &mut MessageWriter<'_>,
    ) -> Result<Finished, Failure> {
        let Self { bodies, mut text, args } = *self;
        let again = |error: io::Error| Failure::unwritable(run.output, error);
        text.rewind().map_err(again)?;
        source.rewind().map_err(|error| Failure::Unreadable(source.name().to_owned(), error))?;
        show_simulation(source, terminal, &args.set_up);
        let policy = run.policy(machine)?;
        let keep = args.view.is_some();
        let files = SimulatedFiles { source, program: &mut text, shown: run.output };
        let how = SimulationRun { args: &args.simulation, threads: args.set_up.threads(), keep };
        let simulated = simulate(machine, policy, files, bodies, how)?;
        simulated.findings(messages);
        let line = simulated.line();
        Ok((if simulated.passed { Ok(vec![line]) } else { Err(line) }, Box::new(simulated)))
    }
}
