//! The connection to `linuxcncrsh`: one line sent, one line received.

use std::io::{self, BufRead, BufReader, Write};
use std::net::{Ipv4Addr, TcpStream};
use std::time::Duration;

/// Longest time for an answer.
const ANSWER_TIMEOUT: Duration = Duration::from_secs(20);

/// An open connection.
pub(super) struct Shell {
    answers: BufReader<TcpStream>,
}

impl Shell {
    /// Connects to the control and takes command of it.
    pub(super) fn connect(port: u16) -> io::Result<Self> {
        let stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port))?;
        stream.set_read_timeout(Some(ANSWER_TIMEOUT))?;
        stream.set_nodelay(true)?;
        let mut shell = Self { answers: BufReader::new(stream) };
        for line in ["hello EMC tests 1.0", "set echo off", "set verbose on", "set enable EMCTOO"] {
            shell.ask(line)?;
        }
        Ok(shell)
    }

    /// Sends a line and returns the answer of the control.
    pub(super) fn ask(&mut self, line: &str) -> io::Result<String> {
        self.answers.get_mut().write_all(format!("{line}\r\n").as_bytes())?;
        let mut answer = String::new();
        if self.answers.read_line(&mut answer)? == 0 {
            return Err(io::Error::new(io::ErrorKind::UnexpectedEof, format!("no answer to `{line}`")));
        }
        Ok(answer.trim().to_owned())
    }

    /// Sends a command; a refusal is an error.
    pub(super) fn command(&mut self, line: &str) -> io::Result<()> {
        let answer = self.ask(line)?;
        if answer.ends_with("NAK") { Err(io::Error::other(format!("`{line}` is refused"))) } else { Ok(()) }
    }

    /// Sets whether `command` waits until a command has been executed, or only until it has been received.
    pub(super) fn wait_until_done(&mut self, done: bool) -> io::Result<()> {
        self.command(if done { "set set_wait done" } else { "set set_wait received" })
    }

    /// Messages of the control that have not been read yet.
    pub(super) fn messages(&mut self) -> io::Result<Vec<String>> {
        let mut messages = Vec::new();
        loop {
            let answer = self.ask("get error")?;
            match answer.strip_prefix("ERROR ").unwrap_or(&answer) {
                "OK" => return Ok(messages),
                message => messages.push(message.to_owned()),
            }
        }
    }

    /// Shuts the control down; it sends no answer.
    pub(super) fn shut_down(&mut self) -> io::Result<()> {
        self.answers.get_mut().write_all(b"shutdown\r\n")
    }
}
