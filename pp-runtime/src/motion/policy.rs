//! What planning reads of a job.

use crate::nc::Formats;
use crate::options::MotionOptions;
use crate::set_up::SetUp;

/// All that planning reads of a job.
#[derive(Debug, Clone, Copy)]
pub struct Policy<'a> {
    /// Machine, part, tools and work offsets.
    pub set_up: &'a SetUp,
    /// Options of planning.
    pub options: &'a MotionOptions,
    /// Decimals and digits of the words.
    pub formats: &'a Formats,
}
