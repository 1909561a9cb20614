//! The tools of a program as bodies: cutting part, shank and holder, from the CL data and `[tools]`.
//!
//! What neither of them gives is assumed or left out, and stated.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use crate::set_up::{GivenTool, SetUp, ToolShape};
use crate::simulate::removal::{Cutter, Profile};
use crate::view::{ClFacts, ClTool};

/// Point of a drill whose angle is not given, rad.
const POINT_RAD: f64 = 118.0 * PI / 180.0;

/// Length of a tool that nothing gives, mm.
const LENGTH_MM: f64 = 100.0;

/// A tool as indices of profiles.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ToolBody {
    /// From the gauge line to the tip, mm.
    pub(crate) length_mm: Option<f64>,
    pub(crate) cutter: Vec<u32>,
    pub(crate) shank: Vec<u32>,
    pub(crate) holder: Vec<u32>,
}

impl ToolBody {
    /// Whether no part of it has a shape.
    pub(crate) fn is_empty(&self) -> bool {
        self.cutter.is_empty() && self.shank.is_empty() && self.holder.is_empty()
    }
}

/// All tools.
#[derive(Debug, Clone, Default)]
pub(crate) struct ToolBodies {
    pub(crate) profiles: Vec<Profile>,
    pub(crate) bodies: BTreeMap<u32, ToolBody>,
    /// Sentences about what is assumed.
    pub(crate) assumed: Vec<String>,
    /// Sentences about what does not take part.
    pub(crate) not_checked: Vec<String>,
}

impl ToolBodies {
    pub(crate) fn of(facts: &ClFacts, set_up: &SetUp) -> Self {
        let mut all = Self::default();
        for (number, tool) in &facts.tools {
            let none = GivenTool::default();
            let given = set_up.tools.get(number).unwrap_or(&none);
            let body = all.body(*number, tool, given);
            all.bodies.insert(*number, body);
        }
        all
    }

    fn add(&mut self, profiles: Vec<Profile>) -> Vec<u32> {
        let first = self.profiles.len() as u32;
        self.profiles.extend(profiles);
        (first..self.profiles.len() as u32).collect()
    }

    fn body(&mut self, number: u32, tool: &ClTool, given: &GivenTool) -> ToolBody {
        // That of the tool table of the machine, where there is one.
        let length = given.length_mm.or(tool.call.length_mm);
        let holder_height: f64 = given.holder_mm.chunks(2).filter_map(|part| part.get(1)).sum();
        let nose = length.map(|length| length - holder_height);
        let mut body = ToolBody { length_mm: length, ..ToolBody::default() };
        if !given.holder_mm.is_empty() {
            match nose {
                _ if !given.holder_mm.len().is_multiple_of(2) => {
                    self.not_checked
                        .push(format!("holder of tool {number}: `holder` needs a height for each diameter"));
                }
                Some(nose) if nose > 0.0 => {
                    let mut at = nose;
                    let cylinders = given.holder_mm.chunks_exact(2).map(|part| {
                        let low = at;
                        at += part[1];
                        Profile::cylinder(part[0] / 2.0, [low, at])
                    });
                    body.holder = self.add(cylinders.collect());
                }
                Some(_) => {
                    self.not_checked.push(format!("holder of tool {number}: it is higher than the tool is long"));
                }
                None => self.not_checked.push(format!("holder of tool {number}: the length of the tool is unknown")),
            }
        }
        let top = match nose {
            Some(nose) if nose > 0.0 => nose,
            _ => length.unwrap_or(LENGTH_MM),
        };
        let flutes = given.flute_length_mm.unwrap_or(top);
        if given.flute_length_mm.is_none() {
            self.assumed.push(format!("tool {number} cuts along {flutes:.1} mm (`flute_length` is not given)"));
        }
        match self.cutter(number, tool, given, flutes) {
            Ok(Some(cutter)) => match cutter.pieces() {
                Ok(pieces) => body.cutter = self.add(pieces),
                Err(fault) => self.not_checked.push(format!("tool {number}: {fault}")),
            },
            Ok(None) => {}
            Err(reason) => self.not_checked.push(format!("tool {number}: {reason}")),
        }
        match given.shank_diameter_mm {
            Some(diameter) if flutes < top => {
                let profile = Profile::cylinder(diameter / 2.0, [flutes, top]);
                body.shank = self.add(vec![profile]);
            }
            Some(_) => {}
            None if given.flute_length_mm.is_some() => {
                self.not_checked.push(format!("shank of tool {number}: `shank_diameter` is not given"));
            }
            None => {}
        }
        body
    }

    /// The cutting part; `None` where it is left out, which is stated.
    fn cutter(&mut self, number: u32, tool: &ClTool, given: &GivenTool, length: f64) -> Result<Option<Cutter>, String> {
        if tool.taps {
            self.not_checked.push(format!("thread of tool {number}: a tap removes nothing here"));
            return Ok(None);
        }
        let radius = tool.call.diameter_mm.filter(|diameter| *diameter > 0.0).or(given.diameter_mm);
        let radius = radius.ok_or("neither the CL data nor `diameter` gives its diameter")? / 2.0;
        let corner = tool.call.corner_radius_mm.or(given.corner_radius_mm);
        let holes_only = tool.drills && !tool.mills;
        let shape = given.shape.unwrap_or(if holes_only { ToolShape::Drill } else { ToolShape::Mill });
        let mut or_flat = |corner: Option<f64>| {
            corner.unwrap_or_else(|| {
                self.assumed.push(format!("tool {number} has no corner radius (none is given)"));
                0.0
            })
        };
        Ok(Some(match shape {
            ToolShape::Mill => {
                Cutter::Mill { radius, corner: or_flat(corner), taper: given.taper_rad.unwrap_or(0.0), length }
            }
            ToolShape::Disc => Cutter::Disc { radius, corner: or_flat(corner), length },
            ToolShape::Lollipop => Cutter::Lollipop { radius },
            ToolShape::Barrel => Cutter::Barrel {
                radius,
                corner: or_flat(corner),
                side: given.side_radius_mm.ok_or("a barrel needs `side_radius`")?,
                length,
            },
            ToolShape::Drill => {
                let point = given.point_angle_rad.unwrap_or_else(|| {
                    self.assumed.push(format!("tool {number} has a point of 118 degrees (`point_angle` is not given)"));
                    POINT_RAD
                });
                Cutter::Drill { radius, point, length }
            }
        }))
    }
}
