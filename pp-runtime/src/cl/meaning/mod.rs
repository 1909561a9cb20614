//! Meaning of records in their context: units, modes, and the events that follow.
//!
//! `interpret` hands each record to the owners of modal state: `units`, `modal_tool`, `axis`,
//! `coordinates` (with `frame` and `change`), `path_state`, and what is open: `arc`, `nurbs_curve`, `cycle` (with `holes`,
//! the habits of the CAM systems). `permitted` lists the records that may come while something is open; `votes` checks the
//! sense of arcs. Events wait in `event_queue`.

mod arc;
mod axis;
mod coordinates;
mod cycle;
mod event_queue;
mod feed;
mod frame;
mod holes;
mod interpret;
mod modal_tool;
mod nurbs_curve;
mod options;
mod path_state;
mod permitted;
mod transform;
mod units;
mod votes;

pub(crate) use self::event_queue::{QueuedEvent, TextUse};
pub use self::frame::StatedFrame;
pub use self::holes::CycleArg;
pub(crate) use self::interpret::RecordInterpreter;
pub use self::options::{ClPoint, FeedLabel, Frames, Insert, ReadingOptions, Sense};
pub use self::votes::ArcVote;
