//! Stock, design and solids of a simulation: from options, `[solids]` and `[stock]`.

use std::fs::{self, File};
use std::io;
use std::path::Path;

use nalgebra::Rotation3;

use crate::program::Units;
use crate::set_up::{SetUp, Solid, SolidShape, Stock};
use crate::simulate::{Design, MachineSolid, MachineToolTable, Mesh, SolidBody, SolidFault, StockFault, TriDexel};

use super::super::args::SimulationArgs;
use super::super::outcome::Failure;
use super::super::text_file::read_text;

/// Lines of a stock along its longest side, if no pitch is given: at most.
const MOST_LINES: f64 = 400.0;

/// Largest distance of a round stock or design from its triangles, mm.
const CHORD_MM: f64 = 1e-3;

/// The bodies of a simulation.
pub(super) struct Bodies {
    pub(super) stock: TriDexel,
    /// Sentence about the stock and its pitch.
    pub(super) stock_text: String,
    pub(super) design: Option<GivenDesign>,
    pub(super) solids: Vec<MachineSolid>,
    /// The tools as the machine knows them.
    pub(super) tool_table: Option<MachineToolTable>,
}

/// A design with its name, and the tolerance with which its triangles were made, mm.
pub(super) struct GivenDesign {
    pub(super) design: Design,
    pub(super) name: String,
    pub(super) tolerance_mm: f64,
}

impl Bodies {
    /// Reads the files. `unit`: of a tool table that states none.
    pub(super) fn read(set_up: &SetUp, args: &SimulationArgs, unit: Units) -> Result<Self, Failure> {
        let design = design(set_up, args)?;
        if design.is_none() && args.fails_on_gouge() {
            let text = "`--fail-on gouge` needs the design: give `--design D.stl`, or `design` in `[solids]`";
            return Err(Failure::Argument(text.to_owned()));
        }
        let without = [args.gouge_tolerance_mm, args.rest_tolerance_mm, args.design_tolerance_mm];
        if design.is_none() && without.iter().any(Option::is_some) {
            let text = "a tolerance of gouges, rest material or design needs the design: give `--design D.stl`";
            return Err(Failure::Argument(text.to_owned()));
        }
        let (stock, stock_text) = stock(set_up, args)?;
        let open = |file: &str| open(&set_up.solids.path(file));
        let solids = MachineSolid::read(set_up, &open).map_err(|fault| in_solids(set_up, fault))?;
        let tool_table = args.tool_table.as_deref().map(|path| tool_table(path, unit)).transpose()?;
        Ok(Self { stock, stock_text, design, solids, tool_table })
    }
}

/// Opens a file that has an end: a device or a pipe may have none, and a pipe cannot be read twice.
fn open(path: &Path) -> io::Result<File> {
    if fs::metadata(path)?.is_file() {
        File::open(path)
    } else {
        Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            "it is no file on a disk, as a folder, a pipe or a device is none",
        ))
    }
}

fn tool_table(path: &Path, unit: Units) -> Result<MachineToolTable, Failure> {
    let text = read_text(path, "tool table")?;
    MachineToolTable::read(&text, unit.in_mm())
        .map_err(|fault| Failure::Argument(format!("{} is no tool table: {fault}", path.display())))
}

/// The failure of a solid of the configuration, with its path.
fn in_solids(set_up: &SetUp, fault: SolidFault) -> Failure {
    match fault {
        SolidFault::Unreadable(file, error) => Failure::unreadable(&set_up.solids.path(&file), error),
        SolidFault::NoBody(file, fault) => {
            Failure::Argument(format!("{} is no solid: {fault}", set_up.solids.path(&file).display()))
        }
    }
}

/// A closed body of an option or of `[solids]`, rotated as the part is clamped: so is the CL data. With its name and
/// its tolerance, mm.
fn closed(
    set_up: &SetUp,
    file: Option<&Path>,
    given: Option<&Solid>,
    what: &str,
) -> Result<Option<(Mesh, String, f64)>, Failure> {
    let (body, name) = match (file, given) {
        (Some(path), _) => {
            let file = path.to_string_lossy().into_owned();
            let shape = SolidShape::Stl { file: file.clone(), unit_mm: 1.0 };
            let (rotation, at_mm) = (Rotation3::identity(), [0.0; 3]);
            let solid = Solid { name: None, shape, rotation, at_mm, tolerance_mm: 0.0, set_ups: Vec::new() };
            (SolidBody::of(&solid, CHORD_MM, &|_: &str| open(path)), file)
        }
        (None, Some(solid)) => {
            let open = |file: &str| open(&set_up.solids.path(file));
            let name = match &solid.shape {
                SolidShape::Stl { file, .. } => set_up.solids.path(file).display().to_string(),
                SolidShape::Box(_) => format!("box of `{what}` in `[solids]`"),
                SolidShape::Cylinder { .. } => format!("cylinder of `{what}` in `[solids]`"),
                SolidShape::Turned(_) => format!("turned `{what}` of `[solids]`"),
            };
            (SolidBody::of(solid, CHORD_MM, &open), name)
        }
        (None, None) => return Ok(None),
    };
    let no_body = |fault: String| Failure::Argument(format!("{name} is no {what}: {fault}"));
    let body = body.map_err(|fault| match fault {
        SolidFault::Unreadable(_, error) => Failure::unreadable(Path::new(&name), error),
        SolidFault::NoBody(_, fault) => no_body(fault.to_string()),
    })?;
    match body.flaw {
        Some(flaw) => Err(no_body(flaw)),
        None => Ok(Some((body.mesh.rotated(&set_up.part_rotation), name, body.tolerance_mm))),
    }
}

fn design(set_up: &SetUp, args: &SimulationArgs) -> Result<Option<GivenDesign>, Failure> {
    let found = closed(set_up, args.design.as_deref(), set_up.solids.design.as_ref(), "design")?;
    Ok(found.map(|(mesh, name, tolerance_mm)| GivenDesign {
        design: Design::new(mesh),
        name,
        tolerance_mm: args.design_tolerance_mm.unwrap_or(tolerance_mm),
    }))
}

/// The triangles of a round blank.
fn round_blank(blank: &Stock) -> Result<Mesh, Failure> {
    let [diameter, height] = [blank.upper[0] - blank.lower[0], blank.upper[2] - blank.lower[2]];
    let solid = Solid {
        name: None,
        shape: SolidShape::Cylinder { diameter, height },
        rotation: Rotation3::identity(),
        at_mm: [0.0, 0.0, blank.lower[2]],
        tolerance_mm: 0.0,
        set_ups: Vec::new(),
    };
    let unread = |file: &str| open(Path::new(file));
    let body = SolidBody::of(&solid, CHORD_MM, &unread);
    Ok(body.map_err(|_| Failure::Argument("the cylinder of `[stock]` has no volume".to_owned()))?.mesh)
}

/// The stock, and a sentence about it and its pitch.
fn stock(set_up: &SetUp, args: &SimulationArgs) -> Result<(TriDexel, String), Failure> {
    let pitch = |[low, high]: [[f64; 3]; 2]| {
        let longest = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        args.pitch_mm.unwrap_or_else(|| rounded_up(longest / MOST_LINES))
    };
    let refused = |fault: StockFault| Failure::Argument(fault.to_string());
    let given = closed(set_up, args.stock.as_deref(), set_up.solids.stock.as_ref(), "stock")?;
    let (stock, pitch, what) = match (given, set_up.stock) {
        (Some((mesh, name, _)), _) => {
            let what = format!("{name}, {} triangles, mm in the coordinates of the CL data", mesh.triangles());
            let pitch = pitch(mesh.corners());
            (mesh.stock(pitch).map_err(refused)?, pitch, what)
        }
        (None, Some(blank)) if blank.round => {
            let mesh = round_blank(&blank)?;
            let pitch = pitch(mesh.corners());
            (mesh.stock(pitch).map_err(refused)?, pitch, "cylinder of `[stock]`".to_owned())
        }
        (None, Some(blank)) => {
            let corners = [blank.lower, blank.upper];
            let pitch = pitch(corners);
            (TriDexel::block(corners, pitch).map_err(refused)?, pitch, "box of `[stock]`".to_owned())
        }
        (None, None) => {
            let text = "no stock: give `--stock S.stl`, `stock` in `[solids]`, or the blank, `[stock]` with `lower` and `upper` or \
                        with `diameter`, `bottom` and `top`";
            return Err(Failure::Argument(text.to_owned()));
        }
    };
    let whence = if args.pitch_mm.is_some() { "given" } else { "chosen from the size" };
    let [low, high] = stock.corners();
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
    let text = format!(
        "stock: {what}, {x:.3} x {y:.3} x {z:.3} mm, pitch {pitch} mm ({whence}): nothing thinner is seen, up to {:.1} MB",
        stock.most_bytes() as f64 / 1e6
    );
    Ok((stock, text))
}

/// The next number of 1, 2, 5 and their tens.
fn rounded_up(length: f64) -> f64 {
    let ten = 10.0_f64.powf(length.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    steps.into_iter().map(|step| step * ten).find(|step| *step >= length * (1.0 - 1e-9)).unwrap_or(10.0 * ten)
}
