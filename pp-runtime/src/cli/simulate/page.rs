//! `simulate -o REPORT.html`: what the page of a simulation shows besides its program.

use std::io;

use nalgebra::Isometry3;

use crate::kinematics::AnyMachine;
use crate::set_up::{SetUp, SolidLink};
use crate::simulate::{
    ClampedStage, Design, EndValues, MachineLinks, MachineSolid, MarkedSurface, PartPlaces, RemovedPart, ToolBodies,
    TriDexel,
};
use crate::view::{PageBody, PageStage, Role, SimulatedLinePart, SimulatedPage, ToolPart, ViewedProgram};

/// Version of the data.
const FORMAT: u32 = 1;

/// Places of the machined surface that are drawn: at most, about.
const MOST_PLACES: f64 = 150_000.0;

/// Largest distance of a drawn tool from its outline, mm.
const CHORD_MM: f64 = 0.02;

/// Bodies of a finished simulation.
pub(super) struct ShownBodies {
    pub(super) stock: TriDexel,
    /// Set-up in which it lies.
    pub(super) set_up: u32,
    pub(super) stages: Option<Vec<ClampedStage>>,
    /// Where the stock is.
    pub(super) design: Option<Design>,
    pub(super) solids: Vec<MachineSolid>,
    pub(super) tools: ToolBodies,
    pub(super) places: PartPlaces,
}

/// The result of a simulation as sentences.
pub(super) struct ResultSentences {
    pub(super) line: String,
    pub(super) summary: Vec<String>,
}

impl ShownBodies {
    /// The part of the page.
    pub(super) fn page(
        &self,
        machine: &dyn AnyMachine,
        set_up: &SetUp,
        program: &ViewedProgram<'_>,
        figures: serde_json::Value,
        ResultSentences { line, summary }: ResultSentences,
    ) -> io::Result<SimulatedPage> {
        let links = MachineLinks::of(machine, set_up);
        let numbers: Vec<u32> = set_up.clampings().map(|(number, _)| number).collect();
        let index = |number: u32| numbers.iter().position(|other| *other == number).unwrap_or(0);
        let mut bodies = vec![self.machined()?];
        if let Some(design) = &self.design {
            let mesh = design.mesh();
            bodies.push(PageBody::new("design", Role::Design, 0, (mesh.vertices(), mesh.faces()))?);
        }
        for solid in &self.solids {
            let Some(link) = links.number(solid.link) else { continue };
            let role = if solid.link == SolidLink::Fixture { Role::Fixture } else { Role::Machine };
            let mesh = &solid.body.mesh;
            let body = PageBody::new(&solid.name, role, link, (mesh.vertices(), mesh.faces()))?;
            bodies.push(body.within(solid.set_ups.iter().map(|number| index(*number)).collect()));
        }
        Ok(SimulatedPage {
            format: FORMAT,
            line,
            summary,
            figures,
            bodies,
            tools: self.tools.bodies.keys().map(|number| (*number, self.tool(*number))).collect(),
            link_places: program
                .placements()
                .map(|(number, offsets_mm)| {
                    let origin = set_up.clamping(number).map_or([0.0; 3], |part| part.part_origin);
                    links.at_zero(origin, offsets_mm)
                })
                .collect(),
            part_places: numbers.iter().map(|number| self.places.between(self.set_up, *number).map(matrix)).collect(),
            stages: self
                .stages
                .as_ref()
                .map(|stages| stages.iter().map(|each| stage(each, index(each.set_up))).collect::<io::Result<_>>())
                .transpose()?,
        })
    }

    /// The machined stock, with fewer lines where it has many.
    fn machined(&self) -> io::Result<PageBody> {
        let lines: usize = (0..3).map(|family| self.stock.lines(family).into_iter().product::<usize>()).sum();
        let step = (2.0 * lines as f64 / MOST_PLACES).sqrt().ceil().max(1.0) as usize;
        let stock = self.stock.thinned(step + usize::from(step.is_multiple_of(2)));
        let ends = self.design.as_ref().map_or_else(EndValues::default, |design| design.deviations(&stock));
        let MarkedSurface { vertices, faces, values, ids } = stock.marked_surface(&ends);
        PageBody::marked("machined stock", Role::Machined, 0, (&vertices, &faces), Some((&values, &ids)))
    }

    fn tool(&self, number: u32) -> Vec<ToolPart> {
        let body = &self.tools.bodies[&number];
        let parts = [("cutter", &body.cutter), ("shank", &body.shank), ("holder", &body.holder)];
        let part = |(part, profiles): (&'static str, &Vec<u32>)| ToolPart {
            part,
            outlines: profiles.iter().map(|index| self.tools.profiles[*index as usize].polygon(CHORD_MM)).collect(),
        };
        parts.into_iter().filter(|(_, profiles)| !profiles.is_empty()).map(part).collect()
    }
}

fn matrix(place: Isometry3<f64>) -> Vec<f64> {
    place.to_homogeneous().iter().copied().collect()
}

fn stage(stage: &ClampedStage, set_up: usize) -> io::Result<PageStage> {
    let material = stage.material.iter().map(|(stock_line, ends)| -> SimulatedLinePart { (*stock_line, *ends, 0) });
    let removed = stage
        .removed
        .iter()
        .map(|RemovedPart { stock_line, ends, line }| -> SimulatedLinePart { (*stock_line, *ends, *line) });
    PageStage::new(set_up, stage.corners, stage.counts, material, removed)
}
