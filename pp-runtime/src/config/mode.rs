//! How multi-axis motion is written: axis values, tip coordinates, or coordinates in a tilted plane.

use super::read::set;
use super::value::{Reader, Section};
use super::{Config, Mode, TcpFrame, TcpWords, ToolPosture};

const FRAMES: [(&str, TcpFrame); 3] = [
    ("table_at_zero", TcpFrame::TableAtZero),
    ("table_at_start", TcpFrame::TableAtStart),
    ("not_turning", TcpFrame::NotTurning),
];
const POSTURES: [(&str, ToolPosture); 2] = [("axes", ToolPosture::Axes), ("plane", ToolPosture::Plane)];

const WORDS: [(&str, TcpWords); 2] = [("angles", TcpWords::Angles), ("vectors", TcpWords::Vectors)];

impl Config {
    pub(super) fn read_mode(&mut self, r: &mut Reader<'_>, top: &mut Section<'_>) {
        if let Some(value) = self.get(top, "mode") {
            set(&mut self.motion.mode, r.choice(value, &Mode::NAMES));
        }
        if let Some(value) = self.get(top, "tcp_frame") {
            self.motion.tip.tcp_frame = r.choice(value, &FRAMES);
        }
        if let Some(value) = self.get(top, "tcp_words") {
            set(&mut self.motion.tip.tcp_words, r.choice(value, &WORDS));
        }
        if let Some(value) = self.get(top, "tool_posture") {
            set(&mut self.motion.tip.tool_posture, r.choice(value, &POSTURES));
        }
        if let Some(value) = self.get(top, "tcp_confirmed") {
            set(&mut self.motion.tip.tcp_confirmed, r.boolean(value));
        }
    }
}
