//! Tests of `simulate`: what the written program does to a stock, and how it is reported.

mod posting;
mod set_ups;
mod solids;

use serde_json::Value as Json;

use super::*;
use crate::kinematics::machines::Cb;
use crate::post::post_for;

/// A groove along X, and a face beside it.
const PART: &str = "UNITS/MM\nTOOL PATH/GROOVE,TOOL,MILL\nTLDATA/MILL,10.0,0.0\nLOADTL/1\nSPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\n\
    RAPID\nGOTO/-10,8,50,0,0,1\nRAPID\nGOTO/-10,8,5\nGOTO/-10,8,-2\nGOTO/50,8,-2\nGOTO/50,24,-2\nGOTO/30,24,-2\nGOTO/30,24,5\n\
    RAPID\nGOTO/30,24,50\nFINI\n";

/// A face over the whole block at Z-2, by four passes.
const FACE: &str = "UNITS/MM\nTOOL PATH/FACE,TOOL,MILL\nTLDATA/MILL,10.0,0.0\nLOADTL/1\nSPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\n\
    RAPID\nGOTO/-10,4,50,0,0,1\nRAPID\nGOTO/-10,4,5\nGOTO/-10,4,-2\nGOTO/50,4,-2\nGOTO/50,12,-2\nGOTO/-10,12,-2\n\
    GOTO/-10,20,-2\nGOTO/50,20,-2\nGOTO/50,28,-2\nGOTO/-10,28,-2\nRAPID\nGOTO/-10,28,50\nFINI\n";

/// The groove with a tool that leans about Y while it cuts.
const TILTING: &str = "UNITS/MM\nTOOL PATH/GROOVE,TOOL,MILL\nTLDATA/MILL,10.0,5.0\nLOADTL/1\nSPINDL/RPM,3000,CLW\n\
    FEDRAT/MMPM,500\nRAPID\nGOTO/-10,16,50,0,0,1\nRAPID\nGOTO/-10,16,5\nGOTO/-10,16,-2,0,0,1\n\
    GOTO/10,16,-2,0.1,0,0.99498743710662\nGOTO/50,16,-2,0.2,0,0.97979589711327\nRAPID\nGOTO/60,16,50\nFINI\n";

const CONFIG: &str = "units = \"mm\"\nmachine_zero = { X = 0.0, Y = 0.0, Z = -420.0 }\n\
    [stock]\nlower = [0.0, 0.0, -10.0]\nupper = [40.0, 32.0, 0.0]\n";

const TOOL: &str =
    "[tools]\n1 = { length = 100.0, flute_length = 8.0, shank_diameter = 10.0, holder = [30.0, 60.0] }\n";

fn simulated_with(shop: &Shop, part: &str, config: &str, more: &[&str]) -> Outcome {
    shop.write("part.cls", part);
    shop.write("shop.toml", config);
    let (cl, config) = (shop.arg("part.cls"), shop.arg("shop.toml"));
    let arguments = [&["simulate", &cl, "--config", &config, "--pitch", "1"], more].concat();
    run_on::<Cb>(&arguments, b"", &|job, source, sink, map| post_for(&Cb::default(), job, source, sink, map))
}

fn simulated(part: &str, tools: &str) -> (Outcome, Json) {
    let outcome = simulated_with(&Shop::new(), part, &format!("{CONFIG}{tools}"), &["--json"]);
    let json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    (outcome, json)
}

fn kinds(json: &Json) -> Vec<&str> {
    let findings = json["findings"].as_array().expect("findings");
    findings.iter().map(|finding| finding["kind"].as_str().expect("a kind")).collect()
}

#[test]
fn a_right_program_has_the_volume_of_its_cuts_and_no_collision() {
    let (outcome, json) = simulated(PART, TOOL);
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert_eq!(kinds(&json), Vec::<&str>::new(), "{}", outcome.errors);
    // The groove, and the face up to a half circle about its end.
    let wanted = 2.0 * (40.0 * 10.0 + 10.0 * 10.0 + std::f64::consts::PI * 25.0 / 2.0);
    let volume = json["removed_mm3"].as_f64().expect("a volume");
    assert!((volume - wanted).abs() < 0.01 * wanted, "{volume} {wanted}");
    let parts = json["taking_part"].as_array().expect("what took part");
    assert_eq!(parts, &["cutting part of tool 1", "shank of tool 1", "holder of tool 1", "stock"]);
    assert!(json["not_checked"].to_string().contains("machine and fixtures: no solids are given"), "{json}");
}

#[test]
fn a_round_blank_is_a_cylinder_about_the_part_zero() {
    let config =
        CONFIG.replace("lower = [0.0, 0.0, -10.0]\nupper = [40.0, 32.0, 0.0]", "diameter = 40\nbottom = -10\ntop = 0");
    let (outcome, round) = simulated(PART, TOOL);
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    let outcome = simulated_with(&Shop::new(), PART, &format!("{config}{TOOL}"), &["--json"]);
    assert!(outcome.errors.contains("cylinder of `[stock]`, "), "{}", outcome.errors);
    let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    // The groove at Y8 lies half in it, and the face is outside.
    let [part, whole] = [&json, &round].map(|json| json["removed_mm3"].as_f64().expect("a volume"));
    assert!(part > 0.2 * whole && part < 0.8 * whole, "{part} {whole}");
}

#[test]
fn all_modes_and_controls_cut_the_same_volume() {
    let mut volumes: Vec<f64> = Vec::new();
    for control in ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"] {
        for mode in ["axes", "tcp"] {
            let more = ["--json", "--control", control, "--mode", mode];
            let config = format!("part_origin = [0.0, 0.0, 0.0]\n{CONFIG}{TOOL}")
                .replace("[stock]", "[retract]\nposition = 0.0\n[stock]");
            let outcome = simulated_with(&Shop::new(), TILTING, &config, &more);
            let Ok(json) = serde_json::from_str::<Json>(&outcome.output) else {
                assert!(mode == "tcp", "{control} {mode}: {}", outcome.errors);
                continue;
            };
            assert_eq!(kinds(&json), Vec::<&str>::new(), "{control} {mode}: {}", outcome.errors);
            volumes.push(json["removed_mm3"].as_f64().expect("a volume"));
        }
    }
    assert!(volumes.len() >= 5, "{volumes:?}");
    let (low, high) =
        volumes.iter().fold((f64::MAX, 0.0_f64), |(low, high), volume| (low.min(*volume), high.max(*volume)));
    // The tip of positions of the axes keeps to the tolerance of 0.01 mm.
    assert!(low > 400.0 && high - low < 1e-3 * high, "{volumes:?}");
}

#[test]
fn planted_faults_are_found_at_their_record() {
    for (from, to, tools, kind, line) in [
        // A rapid 2 mm too low, a retract that is lost, a tool too short for its holder, cutting edges too short.
        ("RAPID\nGOTO/-10,8,5\nGOTO/-10,8,-2\n", "RAPID\nGOTO/10,8,-2\n", TOOL, "rapid_through_stock", 10),
        (
            "GOTO/30,24,5\nRAPID\nGOTO/30,24,50",
            "RAPID\nGOTO/2,8,-1\nRAPID\nGOTO/2,22,-1",
            TOOL,
            "rapid_through_stock",
            16,
        ),
        (
            "",
            "",
            "[tools]\n1 = { length = 100.0, flute_length = 8.0, shank_diameter = 10.0, holder = [60.0, 99.0] }\n",
            "holder",
            11,
        ),
        ("", "", "[tools]\n1 = { length = 100.0, flute_length = 1.0, shank_diameter = 12.0 }\n", "shank", 12),
    ] {
        let (outcome, json) = simulated(&PART.replace(from, to), tools);
        assert!(kinds(&json).contains(&kind), "{to}: {kind}: {json} {}", outcome.errors);
        let findings = json["findings"].as_array().expect("findings");
        let first = findings.iter().find(|finding| finding["kind"] == kind).expect("it was found");
        assert_eq!(first["cl_line"], line, "{json}");
        assert!(first["volume_mm3"].as_f64() > Some(1.0), "{json}");
    }
}

#[test]
fn a_spindle_that_is_off_in_the_cut_is_found_in_an_edited_program() {
    let shop = Shop::new();
    let (cl, nc) = (shop.arg("part.cls"), shop.arg("part.ngc"));
    let config = format!("{CONFIG}{TOOL}");
    shop.write("part.cls", PART);
    shop.write("shop.toml", &config);
    let post: PostFn<'_> = &|job, source, sink, map| post_for(&Cb::default(), job, source, sink, map);
    let posted = run_on::<Cb>(&["post", &cl, "--config", &shop.arg("shop.toml"), "-o", &nc], b"", post);
    assert_eq!(posted.status, Status::Done, "{}", posted.errors);
    let right = simulated_with(&shop, PART, &config, &[&nc, "--json"]);
    assert_eq!(right.status, Status::Done, "{}", right.errors);
    shop.write("part.ngc", &shop.text("part.ngc").replace("M3\n", "M5\n"));
    let edited = simulated_with(&shop, PART, &config, &[&nc, "--json"]);
    assert_eq!(edited.status, Status::Rejected, "the check has its finding, too: {}", edited.errors);
    let json: Json = serde_json::from_str(&edited.output).expect("figures");
    assert!(kinds(&json).contains(&"spindle_off"), "{json}");
    assert!(json["removed_mm3"].as_f64() < Some(1.0), "{json}");
}

#[test]
fn the_box_of_a_rapid_whose_axes_arrive_in_any_order_is_compared() {
    // Straight past the corner of the stock; the box of X and Y covers a part of it.
    let part = PART.replace(
        "GOTO/30,24,5\nRAPID\nGOTO/30,24,50",
        "GOTO/30,24,5\nRAPID\nGOTO/-30,20,5\nGOTO/-30,20,-3\nRAPID\nGOTO/20,-30,-3\nRAPID\nGOTO/20,-30,50",
    );
    for (linear, wanted) in [(true, 0), (false, 1)] {
        let config =
            format!("{CONFIG}{TOOL}").replace("[stock]", &format!("[control]\nlinear_rapids = {linear}\n[stock]"));
        let outcome = simulated_with(&Shop::new(), &part, &config, &["--json", "--control", "fanuc"]);
        let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
        let rapids = kinds(&json).iter().filter(|kind| **kind == "rapid_through_stock").count();
        assert_eq!(rapids, wanted, "{json} {}", outcome.errors);
    }
}

#[test]
fn collisions_are_status_1_only_where_that_is_wanted() {
    let part = PART.replace("GOTO/-10,8,5\nGOTO/-10,8,-2\n", "GOTO/10,8,-2\n");
    let config = format!("{CONFIG}{TOOL}");
    let warned = simulated_with(&Shop::new(), &part, &config, &[]);
    assert_eq!(warned.status, Status::Done, "{}", warned.errors);
    assert!(warned.errors.contains("warning: rapid through the stock: line "), "{}", warned.errors);
    assert!(
        warned.errors.contains("1 collision among cutting part of tool 1, shank of tool 1, holder of tool 1, stock\n")
    );
    assert_eq!(simulated_with(&Shop::new(), &part, &config, &["--fail-on", "collision"]).status, Status::Rejected);
    assert_eq!(simulated_with(&Shop::new(), PART, &config, &["--fail-on", "collision"]).status, Status::Done);
}

#[test]
fn what_does_not_take_part_is_named() {
    let states = |part: &str, tools: &str, text: &str| {
        let (outcome, json) = simulated(part, tools);
        let stated = format!("{} {}", json["assumed"], json["not_checked"]);
        assert!(stated.contains(text), "{text}: {stated} {}", outcome.errors);
    };
    states(PART, "[tools]\n1 = { length = 100.0 }\n", "tool 1 cuts along 100.0 mm (`flute_length` is not given)");
    states(
        PART,
        "[tools]\n1 = { length = 100.0, flute_length = 8.0 }\n",
        "shank of tool 1: `shank_diameter` is not given",
    );
    states(
        PART,
        "[tools]\n1 = { holder = [30.0, 60.0], length = 40.0 }\n",
        "holder of tool 1: it is higher than the tool is long",
    );
    let bare = PART.replace("TLDATA/MILL,10.0,0.0\n", "");
    states(&bare, "[tools]\n1 = { length = 100.0 }\n", "tool 1: neither the CL data nor `diameter` gives its diameter");
    states(&bare, "[tools]\n1 = { length = 100.0 }\n", "motions of tools without a shape");
    let (outcome, json) = simulated(&bare, "[tools]\n1 = { length = 100.0 }\n");
    assert!(outcome.errors.contains("removed: 0.000 cm"), "{}", outcome.errors);
    assert_eq!(json["removed_mm3"].to_string(), "0.0");
    let wide = PART.replace("10.0,0.0", "10.0,7.0");
    states(&wide, TOOL, "a corner radius of 7 mm does not fit a radius of 5 mm");
}

#[test]
fn a_simulation_without_a_stock_or_with_a_pitch_of_zero_is_refused() {
    let none = simulated_with(&Shop::new(), PART, "units = \"mm\"\n", &[]);
    assert_eq!(none.status, Status::NotRun);
    assert!(
        none.errors.contains("error: no stock: give `--stock S.stl`, `stock` in `[solids]`, or the blank, `[stock]`"),
        "{}",
        none.errors
    );
    let fine = CONFIG.replace("40.0, 32.0", "40000.0, 32000.0");
    let huge = simulated_with(&Shop::new(), PART, &fine, &[]);
    assert!(huge.errors.contains("take a larger pitch"), "{}", huge.errors);
    let zero = run_on::<Cb>(&["simulate", "part.cls", "--pitch", "0"], b"", &echo);
    assert_eq!(zero.status, Status::NotRun);
    assert!(zero.errors.contains("expected a value between 0.001 and 100 mm"), "{}", zero.errors);
}

/// A box as a text STL file.
fn box_as_stl([low, high]: [[f64; 3]; 2]) -> String {
    let mut text = "solid box\n".to_owned();
    for axis in 0..3 {
        for (side, end) in [low, high].iter().enumerate() {
            let at = |one: [f64; 3], two: [f64; 3]| {
                let mut corner = [0.0; 3];
                (corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3]) =
                    (end[axis], one[(axis + 1) % 3], two[(axis + 2) % 3]);
                corner
            };
            let mut corners = [at(low, low), at(high, low), at(high, high), at(low, high)];
            if side == 0 {
                corners.reverse();
            }
            for triangle in [[0, 1, 2], [0, 2, 3]] {
                text += "facet normal 0 0 0\nouter loop\n";
                for corner in triangle.map(|index| corners[index]) {
                    text += &format!("vertex {} {} {}\n", corner[0], corner[1], corner[2]);
                }
                text += "endloop\nendfacet\n";
            }
        }
    }
    text + "endsolid box\n"
}

#[test]
fn a_stock_of_triangles_is_cut_as_the_same_box() {
    let shop = Shop::new();
    shop.write("box.stl", &box_as_stl([[0.0, 0.0, -10.0], [40.0, 32.0, 0.0]]));
    let tools = format!("units = \"mm\"\nmachine_zero = {{ X = 0.0, Y = 0.0, Z = -420.0 }}\n{TOOL}");
    let outcome = simulated_with(&shop, PART, &tools, &["--json", "--stock", &shop.arg("box.stl")]);
    let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    let (_, of_box) = simulated(PART, TOOL);
    let volumes = [&json, &of_box].map(|json| json["removed_mm3"].as_f64().expect("a volume"));
    assert!((volumes[0] - volumes[1]).abs() < 1e-3 * volumes[1], "{volumes:?}");
    assert!(
        json["assumed"].to_string().contains("box.stl, 12 triangles, mm in the coordinates of the CL data"),
        "{json}"
    );
    // Elsewhere than the part; open.
    shop.write("box.stl", &box_as_stl([[500.0, 0.0, -10.0], [540.0, 32.0, 0.0]]));
    let away = simulated_with(&shop, PART, &tools, &["--stock", &shop.arg("box.stl")]);
    assert!(away.errors.contains("not checked: no motion meets the stock"), "{}", away.errors);
    let open = box_as_stl([[0.0; 3], [1.0; 3]]).replacen("vertex 0 0 0", "vertex 0 0 0.5", 1);
    shop.write("box.stl", &open);
    let open = simulated_with(&shop, PART, &tools, &["--stock", &shop.arg("box.stl")]);
    assert_eq!(open.status, Status::NotRun);
    assert!(open.errors.contains("is no stock: it is open"), "{}", open.errors);
}

#[test]
fn a_motion_that_is_too_low_is_a_gouge_at_its_block_and_its_cl_line() {
    let shop = Shop::new();
    let part = FACE;
    let config = format!("{CONFIG}{TOOL}");
    shop.write("design.stl", &box_as_stl([[0.0, 0.0, -10.0], [40.0, 32.0, -2.0]]));
    let design = shop.arg("design.stl");
    let more = ["--json", "--fail-on", "collision,gouge", "--design", &design];
    let run = |part: &str| {
        let outcome = simulated_with(&shop, part, &config, &more);
        let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
        (outcome, json)
    };
    let (right, json) = run(part);
    assert_eq!(right.status, Status::Done, "{}", right.errors);
    assert_eq!((&json["design"]["gouge_count"], &json["design"]["rest_count"]), (&0.into(), &0.into()), "{json}");
    // The end of the third pass, CL line 16, is 0.3 mm too low: so are its block and the first of the next pass.
    let (low, json) = run(&part.replace("GOTO/50,20,-2\nGOTO/50,28,-2", "GOTO/50,20,-2.3\nGOTO/50,28,-2"));
    assert_eq!(low.status, Status::Rejected, "{}", low.errors);
    assert_eq!(json["design"]["gouge_count"], 1, "{json}");
    let gouge = &json["design"]["gouges"][0];
    // The mill's rear edge is at X45 at the end, so the deepest line of the block, at X39.5, has 0.3
    // (39.5 + 5 + 10) / 60.
    let depth = gouge["deviation_mm"].as_f64().expect("a depth");
    assert!((depth - 0.3 * 54.5 / 60.0).abs() < 4e-3, "{gouge}");
    assert_eq!((&gouge["cl_line"], &gouge["tool"]), (&16.into(), &1.into()), "{gouge}");
    assert!(gouge["line"].as_u64() > Some(0), "{gouge}");
    // Without the design nothing is compared, and that is stated.
    let none = simulated_with(&shop, part, &config, &[]);
    assert!(none.errors.contains("not checked: gouges and rest material: no design given"), "{}", none.errors);
    let refused = simulated_with(&shop, part, &config, &["--fail-on", "gouge"]);
    assert_eq!(refused.status, Status::NotRun);
}

#[test]
fn the_tolerance_of_the_triangles_of_the_design_is_added() {
    let shop = Shop::new();
    // The face is 0.03 mm below the design, or above it; 0.01 mm are allowed.
    for (top, option, count) in [(-1.97, "--gouge-tolerance", "gouge_count"), (-2.03, "--rest-tolerance", "rest_count")]
    {
        shop.write("design.stl", &box_as_stl([[0.0, 0.0, -10.0], [40.0, 32.0, top]]));
        let design = shop.arg("design.stl");
        let found = |design_mm: &str| {
            let more = ["--json", "--design", &design, option, "0.01", "--design-tolerance", design_mm];
            let outcome = simulated_with(&shop, FACE, &format!("{CONFIG}{TOOL}"), &more);
            let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
            json["design"][count].as_u64().expect("a number") > 0
        };
        assert_eq!(["0", "0.01", "0.025"].map(found), [true, true, false], "{count}");
    }
}

#[test]
fn the_machined_stock_is_the_stock_of_the_next_program() {
    let shop = Shop::new();
    let config = format!("{CONFIG}{TOOL}");
    let saved = shop.arg("saved.stl");
    let first = simulated_with(&shop, PART, &config, &["--json", "--save-stock", &saved]);
    assert_eq!(first.status, Status::Done, "{}", first.errors);
    assert!(first.errors.contains("saved.stl, "), "{}", first.errors);
    // The same program again cuts nothing but the edges that the triangles have rounded.
    let again = simulated_with(&shop, PART, &config, &["--json", "--stock", &saved]);
    let json: Json = serde_json::from_str(&again.output).unwrap_or_else(|_| panic!("{}", again.errors));
    let volumes = [&first, &again].map(|outcome| {
        let json: Json = serde_json::from_str(&outcome.output).expect("figures");
        json["removed_mm3"].as_f64().expect("a volume")
    });
    assert!(volumes[1] < 0.03 * volumes[0], "{volumes:?}");
    let size = json["stock_mm"][1].as_array().expect("a corner");
    assert!((size[0].as_f64().expect("a size") - 40.0).abs() < 1e-3, "{json}");
    // An input is never replaced.
    let over = simulated_with(&shop, PART, &config, &["--stock", &saved, "--save-stock", &saved]);
    assert_eq!(over.status, Status::NotRun);
    assert!(over.errors.contains("would overwrite the stock"), "{}", over.errors);
}

#[test]
fn what_an_operation_leaves_on_purpose_is_no_rest() {
    let base = format!("{CONFIG}{TOOL}[solids]\ndesign = {{ box = [[0, 0, -10], [40, 32, -2.3]] }}\n");
    let rests = |config: &str| {
        let outcome = simulated_with(&Shop::new(), FACE, config, &["--json"]);
        let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
        json["design"]["rest_count"].as_u64().expect("a number")
    };
    assert_eq!(rests(&base), 1);
    assert_eq!(rests(&format!("{base}[operations.1]\nallowance = 0.3\n")), 0);
    assert_eq!(rests(&format!("{base}[operations.\"FACE*\"]\nallowance = 0.3\n")), 0);
    assert!(rests(&format!("{base}[operations.1]\nallowance = 0.2\n")) > 0);
}

#[test]
fn removal_is_stated_for_each_operation_and_tool_and_over_time() {
    let (outcome, json) = simulated(PART, TOOL);
    let operation = &json["operations"][0];
    // 40 mm at 500 mm/min, and 20 mm across and along.
    let minutes = operation["cutting_min"].as_f64().expect("a time");
    assert!((0.14..0.22).contains(&minutes), "{operation}");
    // A full groove, 10 x 2 mm at 500 mm/min, in one block with 20 mm beside the stock.
    let largest = operation["largest_mm3_per_min"].as_f64().expect("a rate");
    assert!((6e3..1.05e4).contains(&largest), "{operation}");
    assert_eq!(json["tools"][0]["removed_mm3"], operation["removed_mm3"]);
    let steps = json["engagement"]["removed_mm3"].as_array().expect("steps");
    let total: f64 = steps.iter().map(|step| step.as_f64().expect("a volume")).sum();
    assert!((total - json["removed_mm3"].as_f64().expect("a volume")).abs() < 1e-6, "{json}");
    assert!(outcome.errors.contains("cm\u{b3}/min (line "), "{}", outcome.errors);
}
