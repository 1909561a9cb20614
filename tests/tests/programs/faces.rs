//! Random CL data of two or three faces of a part, in the form of each CAM system, with its points in the frame of each
//! face, in the first frame, or some in the one and some in the other; with tool axes and without.
//!
//! Whatever is read has the poses that were meant, by matrices of this file; what nothing states is refused. `PP_FACES`
//! sets how many files there are.

use nalgebra::{Isometry3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use pp_runtime::cl::{ClReader, Frames, ReadingOptions};
use pp_runtime::program::{Event, ToolMotion, Units};
use tests::environment;
use tests::random::Random;

/// Number of files of the suite.
const FILES: u64 = 400;

/// Largest difference of a tip and of a tool axis: the digits of frames and points.
const SAME_TIP_MM: f64 = 5e-3;
const SAME_AXIS: f64 = 1e-4;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Creo,
    Nx,
    Catia,
    SolidWorks,
}

/// In which coordinates the points of a face are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Convention {
    Own,
    First,
}

/// A point of a face, in its frame.
struct Point {
    tip: Point3<f64>,
    axis: Vector3<f64>,
    rapid: bool,
}

struct Face {
    /// From its frame to the workpiece, and to the model.
    to_first: Isometry3<f64>,
    in_model: Isometry3<f64>,
    convention: Convention,
    with_axes: bool,
    points: Vec<Point>,
}

struct File {
    form: Form,
    faces: Vec<Face>,
    option: Option<Frames>,
    /// One convention holds for all faces after the first.
    consistent: bool,
}

fn rotation(random: &mut Random) -> UnitQuaternion<f64> {
    let quarter = std::f64::consts::FRAC_PI_2;
    let about = |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
    match random.below(5) {
        0 => about(Vector3::y(), quarter * random.sign()),
        1 => about(Vector3::x(), quarter * random.sign()),
        2 => about(Vector3::y(), random.between(-1.5, 1.5)),
        3 => about(Vector3::z(), random.between(-3.0, 3.0)) * about(Vector3::x(), random.between(0.05, 1.5)),
        _ => about(Vector3::z(), random.between(-3.0, 3.0)),
    }
}

fn frame(random: &mut Random) -> Isometry3<f64> {
    let origin = Vector3::from_fn(|_, _| random.between(-100.0, 100.0));
    Isometry3::from_parts(Translation3::from(origin), rotation(random))
}

/// A path to the face, on it and away from it.
fn points(random: &mut Random) -> Vec<Point> {
    let mut points = Vec::new();
    let tilts = random.chance(0.15);
    for _ in 0..=random.below(2) {
        let mut at = [random.between(-50.0, 50.0), random.between(-50.0, 50.0)];
        let depth = random.between(-5.0, 5.0);
        let mut add = |[x, y]: [f64; 2], z: f64, axis: Vector3<f64>, rapid: bool| {
            points.push(Point { tip: Point3::new(x, y, z), axis, rapid });
        };
        add(at, 60.0, Vector3::z(), true);
        if random.chance(0.7) {
            add(at, depth + 2.0, Vector3::z(), true);
        }
        add(at, depth, Vector3::z(), false);
        for _ in 0..=random.below(4) {
            let along_x = random.chance(0.5);
            at[usize::from(!along_x)] += random.between(-20.0, 20.0);
            let axis = if tilts { Vector3::new(random.between(-0.3, 0.3), 0.1, 1.0).normalize() } else { Vector3::z() };
            add(at, depth, axis, false);
        }
        add(at, 60.0, Vector3::z(), true);
    }
    points
}

impl File {
    fn of(seed: u64) -> Self {
        let random = &mut Random::new(seed);
        let form = [Form::Creo, Form::Nx, Form::Catia, Form::SolidWorks][random.below(4)];
        let first = if random.chance(0.6) { Isometry3::identity() } else { frame(random) };
        let usual = if form == Form::SolidWorks || random.chance(0.4) { Convention::First } else { Convention::Own };
        let mixed = form != Form::SolidWorks && random.chance(0.15);
        let mut faces = vec![Face {
            to_first: Isometry3::identity(),
            in_model: first,
            convention: usual,
            with_axes: random.chance(0.5),
            points: points(random),
        }];
        for _ in 0..=random.below(2) {
            let to_first = frame(random);
            let other = if usual == Convention::First { Convention::Own } else { Convention::First };
            faces.push(Face {
                to_first,
                in_model: first * to_first,
                convention: if mixed && random.chance(0.5) { other } else { usual },
                with_axes: random.chance(0.75),
                points: points(random),
            });
        }
        let consistent = faces[1..].iter().all(|face| face.convention == faces[1].convention);
        let right = if faces[1].convention == Convention::Own { Frames::Main } else { Frames::First };
        let option = (consistent && random.chance(0.4)).then_some(right);
        Self { form, faces, option, consistent }
    }

    fn decimals(&self) -> (usize, usize) {
        match self.form {
            Form::Creo => (10, 10),
            Form::Nx | Form::SolidWorks => (4, 7),
            Form::Catia => (5, 6),
        }
    }

    /// From the frame of a face to the coordinates in which its points are written.
    fn written(&self, face: &Face) -> Isometry3<f64> {
        match (self.form, face.convention) {
            // TRNTYP/WORLD: all points are in the model.
            (Form::SolidWorks, _) => face.in_model,
            (_, Convention::First) => face.to_first,
            (_, Convention::Own) => Isometry3::identity(),
        }
    }

    /// From the frame of a face to the coordinates of the program.
    fn meant(&self, face: &Face) -> Isometry3<f64> {
        if self.form == Form::SolidWorks { face.in_model } else { face.to_first }
    }

    fn text(&self) -> String {
        let (digits, axis_digits) = self.decimals();
        let number = |value: f64| format!("{value:.digits$}");
        let mut text = match self.form {
            Form::Creo => "$$* Pro/CLfile  Version 8.0\nUNITS / MM\n",
            Form::Catia => "$$ CATIA APT VERSION 1.0\n",
            Form::SolidWorks => "UNIT/MM\n",
            Form::Nx => "",
        }
        .to_owned();
        for (index, face) in self.faces.iter().enumerate() {
            text += &match self.form {
                Form::Nx => format!("TOOL PATH/FACE_{index},TOOL,MILL\n"),
                Form::Creo | Form::Catia | Form::SolidWorks => String::new(),
            };
            text += &self.frame(face);
            text += "FEDRAT/500.0,MMPM\n";
            let place = self.written(face);
            // Without i, j, k the axis of SolidWorks is that of CSYS; the other forms write one that tilts.
            let tilts = face.points.iter().any(|point| point.axis != Vector3::z());
            let with_axes = face.with_axes || tilts;
            if with_axes && matches!(self.form, Form::Creo | Form::Catia) {
                text += "MULTAX/ON\n";
            }
            let mut before = None;
            for point in &face.points {
                let (tip, axis) = (place * point.tip, place * point.axis);
                if point.rapid {
                    text += "RAPID\n";
                }
                text += &format!("GOTO/{}", [tip.x, tip.y, tip.z].map(number).join(","));
                // NX and CATIA write an axis when it changes.
                let changes = before.replace(axis) != Some(axis);
                if with_axes && (self.form == Form::Creo || changes) {
                    text += ",";
                    text += &[axis.x, axis.y, axis.z].map(|value| format!("{value:.axis_digits$}")).join(",");
                }
                text += "\n";
            }
            if self.form == Form::Nx {
                text += "END-OF-PATH\n";
            }
        }
        text + "FINI\n"
    }

    /// The record of a frame.
    fn frame(&self, face: &Face) -> String {
        let matrix = face.in_model.rotation.to_rotation_matrix();
        let origin = face.in_model.translation.vector;
        let rows = |digits: usize, between: &str| {
            let row = |i: usize| [matrix[(i, 0)], matrix[(i, 1)], matrix[(i, 2)], origin[i]];
            [0, 1, 2].map(|i| row(i).map(|value| format!("{value:.digits$}")).join(between))
        };
        match self.form {
            Form::Creo => format!("$$-> CSYS / {}\n", rows(10, ", ").join(",  $\n")),
            Form::SolidWorks => format!("TRNTYP/WORLD,0,0,0\nCSYS/{}\n", rows(7, ",").join(",")),
            Form::Catia => {
                let rows = rows(5, " ").map(|row| format!("$$ {row}\n"));
                format!("$$*CATIA0\n$$ PART\n{}", rows.concat())
            }
            Form::Nx => {
                let column = |j: usize| [0, 1, 2].map(|i| format!("{:.7}", matrix[(i, j)])).join(",");
                let origin = [origin.x, origin.y, origin.z].map(|value| format!("{value:.4}")).join(",");
                format!("MSYS/{origin},{},{}\n", column(0), column(1))
            }
        }
    }

    /// Tip and tool axis of all motions, in the coordinates of the program.
    fn poses(&self) -> Vec<Pose> {
        let of_face = |face: &Face| {
            let place = self.meant(face);
            face.points.iter().map(move |point| (place * point.tip, place * point.axis)).collect::<Vec<_>>()
        };
        self.faces.iter().flat_map(of_face).collect()
    }
}

/// Tip and tool axis of a motion.
type Pose = (Point3<f64>, Vector3<f64>);

/// The poses as read, or the first error.
fn read(file: &File, option: Option<Frames>) -> Result<Vec<Pose>, String> {
    let options = ReadingOptions { units: Some(Units::Millimetres), frames: option, ..ReadingOptions::default() };
    let text = file.text();
    let mut reader = ClReader::new(text.as_bytes(), options);
    let mut poses = Vec::new();
    while let Some((_, event)) = reader.next_event().expect("memory") {
        if let Event::Motion(ToolMotion::Move(motion)) = event {
            poses.push((motion.pose.tip, motion.pose.axis.into_inner()));
        }
    }
    match reader.diagnostics().iter().find(|_| reader.failed()) {
        Some(first) => Err(first.text.clone()),
        None => Ok(poses),
    }
}

#[test]
fn faces_are_read_as_meant_or_refused() {
    let files = environment::number("PP_FACES").unwrap_or(FILES);
    let (mut done, mut by_form) = (0, std::collections::BTreeMap::new());
    for seed in 0..files {
        let file = File::of(seed);
        let meant = file.poses();
        let found = read(&file, file.option);
        let count: &mut [u64; 2] = by_form.entry(format!("{:?} {}", file.form, file.consistent)).or_default();
        match found {
            Ok(poses) => {
                assert_eq!(poses.len(), meant.len(), "seed {seed}\n{}", file.text());
                for (index, (found, meant)) in poses.iter().zip(&meant).enumerate() {
                    let apart = ((found.0 - meant.0).norm(), (found.1 - meant.1).norm());
                    assert!(
                        apart.0 < SAME_TIP_MM && apart.1 < SAME_AXIS,
                        "seed {seed}, point {index}: {found:?}, meant {meant:?}\n{}",
                        file.text()
                    );
                }
                done += 1;
                count[0] += 1;
            }
            Err(why) => {
                assert!(!why.is_empty(), "seed {seed}");
                count[1] += 1;
            }
        }
    }
    println!("read and refused: {by_form:?}");
    assert!(2 * done >= files, "{done} of {files} are read: {by_form:?}");
}

/// The option that is not meant is refused wherever a tool axis of a tilted frame contradicts it.
#[test]
fn an_option_against_the_tool_axes_is_refused() {
    let mut tried = 0;
    for seed in 0..400 {
        let mut file = File::of(seed);
        let tilted = |face: &Face| (face.to_first * Vector3::z() - Vector3::z()).norm() > 0.01;
        if file.form == Form::SolidWorks || !file.faces[1..].iter().all(tilted) {
            continue;
        }
        for face in &mut file.faces {
            face.with_axes = true;
            for point in &mut face.points {
                point.axis = Vector3::z();
            }
        }
        let wrong = if file.faces[1].convention == Convention::Own { Frames::First } else { Frames::Main };
        let why = read(&file, Some(wrong)).expect_err("it contradicts");
        assert!(why.contains("is contradicted by the tool axis"), "seed {seed}: {why}");
        tried += 1;
    }
    assert!(tried > 50);
}

/// A rotation of the test is what its matrix is.
#[test]
fn the_third_column_is_where_z_points() {
    let turned = UnitQuaternion::from_scaled_axis(Vector3::y() * std::f64::consts::FRAC_PI_2);
    let matrix: Rotation3<f64> = turned.to_rotation_matrix();
    assert!((matrix * Vector3::z() - Vector3::x()).norm() < 1e-12);
}
