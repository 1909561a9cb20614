//! Meaning of records in their context: units, modal state, and the events that follow.
//!
//! `interpret` passes each record to the owners of modal state: `units`, `feed`, `modal_tool` (with `tool_table`),
//! `axis`, `coordinates` (with `frame`, `frame_reading` and `transform`) and `path_state`. `arc`, `nurbs_curve` and
//! `cycle` span several records; `permitted` lists the records that may come meanwhile. `holes` has the conventions of
//! the CAM systems for CYCLE, `tool_numbers` those for LOADTL, `votes` checks the sense of arcs. Events are queued in
//! `event_queue`.

mod arc;
mod axis;
mod coordinates;
mod cycle;
mod event_queue;
mod feed;
mod frame;
mod frame_reading;
mod holes;
mod interpret;
mod modal_tool;
mod nurbs_curve;
mod options;
mod path_state;
mod permitted;
mod tool_numbers;
mod tool_table;
mod transform;
mod units;
mod votes;

pub(crate) use self::event_queue::{KeptForEvents, QueuedEvent, TextUse};
pub(crate) use self::frame::StatedFrame;
pub(crate) use self::frame_reading::FrameVote;
pub use self::holes::CycleArg;
pub(crate) use self::interpret::RecordInterpreter;
pub(crate) use self::options::SetUpBegins;
pub use self::options::{FeedLabel, Frames, Insert, ReadingOptions, Sense, ToolArg};
pub(crate) use self::tool_table::StatedTool;
pub(crate) use self::votes::{ArcVote, Contradictions};
