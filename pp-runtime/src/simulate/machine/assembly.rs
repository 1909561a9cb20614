//! The bodies of a job: solids of machine and fixtures, stock, and the parts of each tool.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, UnitVector3, Vector3};

use super::body::{Body, Shapes};
use super::clearance::{Clearances, STOCK, TOOL};
use super::links::MachineLinks;
use crate::kinematics::AnyMachine;
use crate::set_up::{SetUp, SolidLink};
use crate::simulate::bodies::{CHORD_MM, CentreLine, Mesh, OpenFile, SolidBody, SolidFault, chord_of, turned};
use crate::simulate::removal::{Profile, TriDexel};
use crate::simulate::tools::{ToolBodies, ToolBody};

/// A solid of the machine, or a fixture.
pub(crate) struct MachineSolid {
    pub(crate) link: SolidLink,
    pub(crate) name: String,
    pub(crate) set_ups: Vec<u32>,
    pub(crate) body: SolidBody,
}

impl MachineSolid {
    /// Reads the solids of a set-up.
    ///
    /// # Errors
    /// [`SolidFault`] of the first that cannot be used.
    pub(crate) fn read(set_up: &SetUp, open: OpenFile<'_>) -> Result<Vec<Self>, SolidFault> {
        let mut solids: Vec<Self> = Vec::new();
        for (link, solid) in set_up.solids.of_machine() {
            let own = solid.own_name().unwrap_or_else(|| link.name());
            // Solids of the same name are numbered.
            let same = |name: &str| solids.iter().any(|other| other.name == name);
            let numbered = (2..).map(|number| format!("{own} {number}")).find(|name| !same(name));
            let name = if same(&own) { numbered.unwrap_or_else(|| own.clone()) } else { own };
            solids.push(Self {
                link,
                name,
                set_ups: solid.set_ups.clone(),
                body: SolidBody::of(solid, CHORD_MM, open)?,
            });
        }
        Ok(solids)
    }

    fn groups(&self) -> Vec<String> {
        let mut groups = vec![self.link.name()];
        if self.link == SolidLink::Fixture {
            groups.push(SolidLink::Table.name());
        }
        groups
    }
}

/// Links of a machine that have no solid; without any solid only that.
pub(crate) fn without_solids(machine: &dyn AnyMachine, set_up: &SetUp, solids: &[MachineSolid]) -> Vec<String> {
    if solids.is_empty() {
        return vec!["machine and fixtures".to_owned()];
    }
    let links = MachineLinks::of(machine, set_up);
    let has = |link: SolidLink| {
        let same =
            |solid: &&MachineSolid| links.number(solid.link) == links.number(link) && solid.link != SolidLink::Fixture;
        solids.iter().any(|solid| same(&solid))
    };
    let axes = machine.axes().iter().map(|axis| SolidLink::Axis(axis.letter));
    let mut missing: Vec<String> =
        [SolidLink::Frame].into_iter().chain(axes).filter(|link| !has(*link)).map(SolidLink::name).collect();
    if !solids.iter().any(|solid| solid.link == SolidLink::Fixture) {
        missing.push("fixtures".to_owned());
    }
    missing
}

/// The distances of all bodies of a job. `None`: there is no solid of machine or fixture. `sentences`: what is not
/// checked.
pub(crate) fn clearances(
    machine: &dyn AnyMachine,
    set_up: &SetUp,
    solids: &[MachineSolid],
    tools: &ToolBodies,
    stock: &TriDexel,
    sentences: &mut Vec<String>,
) -> Option<Clearances> {
    if solids.is_empty() {
        return None;
    }
    let links = MachineLinks::of(machine, set_up);
    let mut bodies: Vec<(Body, Option<u32>)> = Vec::new();
    for solid in solids {
        let Some(link) = links.number(solid.link) else { continue };
        if let Some(flaw) = &solid.body.flaw {
            sentences.push(format!("what is wholly inside {}: {flaw}", solid.name));
        }
        match Shapes::of(solid.body.mesh.clone()) {
            Some((shapes, ball)) => {
                let body = Body {
                    name: solid.name.clone(),
                    groups: solid.groups(),
                    link,
                    set_ups: solid.set_ups.clone(),
                    ball,
                    axis: solid.body.axis,
                    tolerance_mm: solid.body.tolerance_mm,
                    shapes,
                };
                bodies.push((body, None));
            }
            None => sentences.push(format!("{}: it has no volume", solid.name)),
        }
    }
    let stock_number = stock_body(set_up, stock).map(|body| {
        bodies.push((body, None));
        bodies.len() - 1
    });
    for (number, tool) in &tools.bodies {
        let Some(length_mm) = tool.length_mm else {
            sentences.push(format!("tool {number} against machine and fixtures: its length is unknown"));
            continue;
        };
        let parts = tool_bodies(&links, tools, *number, tool, length_mm);
        bodies.extend(parts.into_iter().map(|body| (body, Some(*number))));
    }
    let solids = &set_up.solids;
    Some(Clearances::new(links, bodies, stock_number, &solids.allow, solids.clearance_mm))
}

/// The material left of a stock as boxes in table coordinates, where it is clamped in a set-up.
pub(crate) fn stock_boxes(set_up: &SetUp, number: u32, stock: &TriDexel) -> Vec<Vec<[[f64; 3]; 2]>> {
    let origin = set_up.clamping(number).map_or([0.0; 3], |part| part.part_origin);
    let moved = |ends: [[f64; 3]; 2]| ends.map(|end| std::array::from_fn(|axis| end[axis] + origin[axis]));
    stock.boxes().into_iter().map(|boxes| boxes.into_iter().map(moved).collect()).collect()
}

fn stock_body(set_up: &SetUp, stock: &TriDexel) -> Option<Body> {
    let (shapes, ball) = Shapes::of_boxes(stock_boxes(set_up, 1, stock))?;
    Some(Body {
        name: STOCK.to_owned(),
        groups: vec![STOCK.to_owned()],
        link: 0,
        set_ups: vec![1],
        ball,
        axis: None,
        tolerance_mm: 0.0,
        shapes,
    })
}

/// Cutting part, shank and holder of a tool at the spindle.
fn tool_bodies(links: &MachineLinks, tools: &ToolBodies, number: u32, tool: &ToolBody, length_mm: f64) -> Vec<Body> {
    let axis = UnitVector3::new_normalize(links.tool_axis);
    let rotation = UnitQuaternion::rotation_between_axis(&Vector3::z_axis(), &axis)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
    let place = Isometry3::from_parts(Translation3::from(axis.into_inner() * -length_mm), rotation);
    let mut bodies = Vec::new();
    for (part, profiles) in [("cutter", &tool.cutter), ("shank", &tool.shank), ("holder", &tool.holder)] {
        let profiles: Vec<&Profile> = profiles.iter().map(|index| &tools.profiles[*index as usize]).collect();
        let chord = profiles.iter().map(|profile| chord_of(profile.radius(), CHORD_MM)).fold(0.0, f64::max);
        let pieces: Vec<Mesh> = profiles.into_iter().map(|profile| revolved(profile, &place)).collect();
        let Some((shapes, ball)) = Shapes::of_pieces(pieces) else { continue };
        bodies.push(Body {
            name: format!("{part} of tool {number}"),
            groups: vec![part.to_owned(), TOOL.to_owned()],
            link: links.spindle(),
            set_ups: Vec::new(),
            ball,
            axis: Some(CentreLine::z().placed(&place)),
            tolerance_mm: chord + CHORD_MM,
            shapes,
        });
    }
    bodies
}

/// A convex piece of a tool as triangles.
fn revolved(profile: &Profile, place: &Isometry3<f64>) -> Mesh {
    let (vertices, faces) = turned(&profile.polygon(CHORD_MM), CHORD_MM);
    Mesh::of_checked(vertices, faces).placed(place)
}
