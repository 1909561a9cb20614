//! Each machine posts a sample with its configuration of `examples/config`; the program passes its check.

use std::collections::BTreeSet;
use std::fs;
use std::io::Cursor;

use machine_library::{
    BridgeMill, HaasRotary, HaasTrunnion, HaasUmc, IntegrexI200, Max5, ObliqueYLathe, PocketNcV2, XyzabTdr, XyzacTrt,
    XyzacbTrsrn, XyzbcTrt,
};
use pp_runtime::check::check;
use pp_runtime::config::starting_point;
use pp_runtime::kinematics::{Axis, Machine, Side};
use pp_runtime::post::{Job, post};
use tests::binaries::{example_config, workspace};
use tests::by_name;

/// Posts a sample of `examples/cl` and checks the program.
fn posts<M: Machine>(machine: &str, control_name: &str, part: &str) {
    let control = by_name::control(control_name);
    let keys = fs::read_to_string(workspace().join(example_config(machine, control_name))).expect("a configuration");
    let config = starting_point(control).read_over(&M::default(), &keys);
    let config = config.unwrap_or_else(|faults| panic!("{machine}: {faults:?}"));
    let cl = fs::read_to_string(workspace().join("examples/cl").join(part)).expect("CL data");
    let job = Job { cl_name: part, config: &config, control, units: None };
    let mut program = Vec::new();
    let report =
        post::<M>(&job, &mut Cursor::new(&cl), &mut program).unwrap_or_else(|error| panic!("{machine}: {error}"));
    let text = String::from_utf8(program).expect("ASCII");
    assert!(!report.failed && report.diagnostics.is_empty(), "{machine}: {:#?}\n{text}", report.diagnostics);
    // Nothing of the set-up is assumed and every declared limit is checked.
    let assumed: Vec<&String> = report.assumptions.iter().filter(|line| !line.contains(" rolls over, ")).collect();
    assert!(assumed.is_empty() && report.unchecked.is_empty(), "{machine}: {assumed:#?}\n{:#?}", report.unchecked);
    assert!(text.lines().count() > 60, "{machine}: {text}");
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let outcome = check::<M>(&policy, Cursor::new(&cl), text.as_bytes()).expect("it can be read").outcome;
    let findings: Vec<String> = outcome.findings.iter().map(|found| found.diagnostic().text).collect();
    assert!(findings.is_empty(), "{machine}: {findings:#?}\n{text}");
}

/// A chain as it is declared: the axes of the table, `|`, those of the tool.
fn chain(axes: &[Axis]) -> String {
    let side = |wanted: Side| -> Vec<String> {
        axes.iter().filter(|axis| axis.side == wanted).map(|axis| axis.letter.to_string()).collect()
    };
    format!("{} | {}", side(Side::Workpiece).join(" "), side(Side::Tool).join(" ")).trim().to_owned()
}

/// A test for each machine: its type, its binary, control and sample. [`NAMES`] are the binaries.
macro_rules! samples {
    ($($test:ident: $machine:ty, $name:literal, $control:literal, $part:literal;)*) => {
        $(
            #[test]
            fn $test() {
                posts::<$machine>($name, $control, $part);
            }
        )*

        const NAMES: &[&str] = &[$($name),*];

        /// Chain and sample of each machine.
        fn rows() -> Vec<(&'static str, String, &'static str)> {
            vec![$(($name, chain(&<$machine>::AXES), $part)),*]
        }
    };
}

samples! {
    bridge_mill: BridgeMill, "bridge-mill", "linuxcnc", "two_tools.cls";
    haas_rotary: HaasRotary, "haas-rotary", "haas", "concave_4axis.cls";
    haas_trunnion: HaasTrunnion, "haas-trunnion", "haas", "two_tools.cls";
    haas_umc: HaasUmc, "haas-umc", "haas", "convex.cls";
    integrex_i200: IntegrexI200, "integrex-i200", "fanuc", "two_tools.cls";
    max5: Max5, "max5", "linuxcnc", "two_tools.cls";
    oblique_y_lathe: ObliqueYLathe, "oblique-y-lathe", "siemens", "concave_4axis.cls";
    pocketnc_v2: PocketNcV2, "pocketnc-v2", "linuxcnc", "convex.cls";
    xyzab_tdr: XyzabTdr, "xyzab-tdr", "linuxcnc", "convex.cls";
    xyzac_trt: XyzacTrt, "xyzac-trt", "linuxcnc", "convex.cls";
    xyzacb_trsrn: XyzacbTrsrn, "xyzacb-trsrn", "linuxcnc", "convex.cls";
    xyzbc_trt: XyzbcTrt, "xyzbc-trt", "linuxcnc", "convex.cls";
}

#[test]
fn every_machine_has_its_test_its_binary_and_its_row_in_the_table() {
    let files = |folder: &str| -> BTreeSet<String> {
        let folder = fs::read_dir(workspace().join(folder)).expect("a folder");
        let stems = folder.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_file());
        stems.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
    };
    let mut sources = files("machines/library/src");
    sources.remove("lib");
    let names: BTreeSet<String> = NAMES.iter().map(ToString::to_string).collect();
    assert_eq!(sources.iter().map(|name| name.replace('_', "-")).collect::<BTreeSet<_>>(), names);
    assert_eq!(files("machines/library/src/bin"), names);
    let papers = ["dmu-70e", "lola-xoyzba", "multiprodesk", "spinner-u5-620"];
    for file in files("examples/config") {
        let of = |name: &str| file.strip_prefix(name).is_some_and(|rest| rest.starts_with('-'));
        assert!(papers.into_iter().any(of) || names.iter().any(|name| of(name)), "{file} is for no machine");
    }
    let table = fs::read_to_string(workspace().join("docs/src/machines.md")).expect("docs/src/machines.md");
    for (name, chain, part) in rows() {
        let row = table.lines().find(|line| line.starts_with(&format!("| `{name}` |")));
        let row = row.unwrap_or_else(|| panic!("{name} is not in docs/src/machines.md"));
        for cell in [format!("| `{}` |", chain.replace('|', "\\|")), format!("| `{part}` |")] {
            assert!(row.contains(&cell), "{cell} is not in {row}");
        }
    }
}
