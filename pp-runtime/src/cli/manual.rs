//! `completions` and `man`: completions of shells and manual pages, from the definition of the command line itself.

use std::fs;
use std::path::Path;

use clap_complete::Shell;
use clap_mangen::Man;

use super::args::MessageFormat;
use super::messages::MessageWriter;
use super::outcome::{Failure, Status, Streams, print};

/// Prints the completions of a shell.
pub(crate) fn completions(
    mut definition: clap::Command,
    shell: Shell,
    streams: &mut Streams<'_>,
) -> Result<Status, Failure> {
    let name = definition.get_bin_name().unwrap_or(definition.get_name()).to_owned();
    print(streams, |out| {
        let mut text = Vec::new();
        clap_complete::generate(shell, &mut definition, name, &mut text);
        out.write_all(&text)
    })
}

/// Prints the page of the command line, or writes those of all its commands into a folder.
pub(crate) fn pages(
    definition: clap::Command,
    folder: Option<&Path>,
    streams: &mut Streams<'_>,
) -> Result<Status, Failure> {
    let Some(folder) = folder else { return print(streams, |out| Man::new(definition).render(out)) };
    let failed = |error| Failure::unwritable(folder, error);
    fs::create_dir_all(folder).map_err(failed)?;
    clap_mangen::generate_to(definition, folder).map_err(failed)?;
    MessageWriter::new(streams.errors, MessageFormat::Human).note(&format!("manual pages are in {}", folder.display()));
    Ok(Status::Done)
}
