//! What the CL data has and a program shows at most as numbers: tools and names of operations.

use std::collections::BTreeMap;
use std::io::{self, Read};

use crate::cl::{ClReader, ReadingOptions};
use crate::program::{Drilling, Event, NewStart, ToolCall, ToolMotion};

/// Tools by number, and operations by the record of their first motion.
#[derive(Debug, Default)]
pub(crate) struct ClFacts {
    pub(crate) tools: BTreeMap<u32, ClTool>,
    /// In the order of the CL data: line of the first motion, and name.
    operations: Vec<(u64, String)>,
    /// Frames of set-ups in the model: origin, mm, and unit vectors of X, Y and Z.
    #[cfg(feature = "simulate")]
    pub(crate) set_up_frames: BTreeMap<u32, ([f64; 3], [[f64; 3]; 3])>,
    /// Number of different frames.
    #[cfg(feature = "simulate")]
    pub(crate) different_frames: usize,
}

/// A tool of the CL data.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ClTool {
    pub(crate) call: ToolCall,
    /// It makes holes.
    pub(crate) drills: bool,
    /// It cuts threads in holes.
    pub(crate) taps: bool,
    /// It moves at feed otherwise.
    pub(crate) mills: bool,
}

impl ClFacts {
    pub(crate) fn read(input: impl Read, options: ReadingOptions) -> io::Result<Self> {
        let mut reader = ClReader::new(input, options);
        let (mut facts, mut name, mut tool) = (Self::default(), None, None);
        while let Some((at, event)) = reader.next_event()? {
            match event {
                Event::NewStart(NewStart::Operation(bytes)) => {
                    name = Some(String::from_utf8_lossy(bytes).trim().to_owned())
                }
                Event::NewStart(NewStart::Tool(call)) if call.number > 0 => {
                    let known = &mut facts.tools.entry(call.number).or_default().call;
                    *known = call.completed_by(known);
                    tool = Some(call.number);
                }
                Event::Motion(motion) => {
                    facts.operations.extend(name.take().map(|name| (at.line, name)));
                    if let Some(tool) = tool.and_then(|tool| facts.tools.get_mut(&tool)) {
                        match motion {
                            ToolMotion::Move(motion) => tool.mills |= !motion.rapid,
                            ToolMotion::Arc(_) | ToolMotion::Spline(_) => tool.mills = true,
                            ToolMotion::Hole(hole) => {
                                tool.drills = true;
                                tool.taps |= matches!(hole.drilling, Drilling::Tap { .. });
                            }
                        }
                    }
                }
                Event::NewStart(_)
                | Event::Interruption(_)
                | Event::Function(_)
                | Event::Reference(_)
                | Event::Text(..) => {}
            }
        }
        #[cfg(feature = "simulate")]
        {
            facts.set_up_frames =
                reader.set_up_frames().map(|(number, frame)| (number, (frame.origin, frame.axes))).collect();
            facts.different_frames = reader.different_frames();
        }
        Ok(facts)
    }

    /// Names of operations, from the lines of their first records; empty where an operation has none.
    pub(crate) fn names(&self, cl_lines: impl Iterator<Item = u64>) -> Vec<String> {
        let mut at = 0;
        let named = cl_lines.map(|line| {
            // Records of a subprogram are where it is defined, so the lines need not ascend.
            let ahead = &self.operations[at..];
            let found = ahead.iter().position(|(first, _)| *first == line);
            let found = found.or_else(|| ahead.iter().rposition(|(first, _)| *first < line));
            found.map_or_else(String::new, |found| {
                at += found + 1;
                self.operations[at - 1].1.clone()
            })
        });
        named.collect()
    }
}
