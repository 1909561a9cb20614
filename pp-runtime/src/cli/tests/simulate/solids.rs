//! Solids of machine and fixtures: what meets, what comes near, and what is not known.

use super::*;

/// The part with a table under the stock, a clamp behind it, and a spindle.
fn with_clamp(clamp: &str, more: &str) -> String {
    format!(
        "{CONFIG}{TOOL}[solids]\n{more}table = {{ box = [[-100, -100, -30], [140, 140, -10]] }}\n\
         fixtures = {{ name = \"clamp\", box = {clamp} }}\nspindle = {{ cylinder = [80, 120] }}\n\
         frame = {{ box = [[-300, 400, -300], [300, 500, 600]] }}\nZ = {{ box = [[-60, 60, 20], [60, 200, 300]] }}\n"
    )
}

fn simulated_on(part: &str, config: &str) -> (Outcome, Json) {
    let outcome = simulated_with(&Shop::new(), part, config, &["--json"]);
    let json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    (outcome, json)
}

fn pairs<'a>(json: &'a Json, list: &str) -> Vec<(String, &'a Json)> {
    let all = json[list].as_array().expect("a list").iter();
    let name =
        |one: &Json| format!("{} {}", one["bodies"][0].as_str().unwrap_or(""), one["bodies"][1].as_str().unwrap_or(""));
    all.filter(|one| one["bodies"].is_array()).map(|one| (name(one), one)).collect()
}

#[test]
fn a_holder_that_meets_a_clamp_is_found_at_its_block() {
    let (right, json) = simulated_on(PART, &with_clamp("[[0, 41, -10], [50, 60, 45]]", ""));
    assert_eq!(right.status, Status::Done, "{}", right.errors);
    assert_eq!(kinds(&json), Vec::<&str>::new(), "{}", right.errors);
    // The holder is 15 mm from Y24, and the smallest clearance is found to a twentieth.
    let clearances = pairs(&json, "clearances");
    let (name, smallest) = clearances.first().expect("a clearance");
    assert_eq!(name, "clamp holder of tool 1");
    let distance = smallest["distance_mm"].as_f64().expect("a distance");
    assert!((1.99..2.15).contains(&distance), "{smallest}");
    assert!(right.errors.contains("smallest clearance: clamp and holder of tool 1 2."), "{}", right.errors);
    let taking_part = json["taking_part"].to_string();
    for name in ["stock", "clamp", "table", "spindle", "frame", "\"Z\""] {
        assert!(taking_part.contains(name), "{name}: {taking_part}");
    }
    assert!(json["not_checked"].to_string().contains("collisions of B, X, Y: no solids are given"), "{json}");

    let (wrong, json) = simulated_on(PART, &with_clamp("[[0, 36, -10], [50, 60, 45]]", ""));
    let found = pairs(&json, "findings");
    let (name, first) = found.first().unwrap_or_else(|| panic!("{}", wrong.errors));
    assert_eq!((name.as_str(), &first["cl_line"]), ("clamp holder of tool 1", &13.into()), "{json}");
    assert_eq!(first["distance_mm"], Json::Null);
    // It has met the clamp at Y21, 38 to 45 mm above the stock; the position of the machine is stated.
    let place = |axis: usize| first["place_mm"][axis].as_f64().expect("a coordinate");
    assert!((place(1) - 36.0).abs() < 4.0 && (30.0..46.0).contains(&place(2)), "{first}");
    let y = first["axes"].as_array().expect("axes").iter().find(|axis| axis[0] == "Y").expect("Y")[1].as_f64();
    assert!((20.9..24.1).contains(&y.expect("a number")), "{first}");
    assert!(wrong.errors.contains("clamp and holder of tool 1 collide: line"), "{}", wrong.errors);
    let failed = simulated_with(
        &Shop::new(),
        PART,
        &with_clamp("[[0, 36, -10], [50, 60, 45]]", ""),
        &["--fail-on", "collision"],
    );
    assert_eq!(failed.status, Status::Rejected);
}

#[test]
fn a_clearance_is_kept_and_allowed_pairs_may_meet() {
    let near = with_clamp("[[0, 41, -10], [50, 60, 45]]", "clearance = 3\n");
    let (outcome, json) = simulated_on(PART, &near);
    let found = pairs(&json, "findings");
    assert!(found.iter().all(|(name, _)| name == "clamp holder of tool 1") && !found.is_empty(), "{json}");
    let distance = found[0].1["distance_mm"].as_f64().expect("a distance");
    assert!((1.9..3.0).contains(&distance), "{json}");
    assert!(outcome.errors.contains("clamp and holder of tool 1 come within "), "{}", outcome.errors);
    for pair in ["[\"holder\", \"clamp\"]", "[\"fixtures\", \"tool\"]"] {
        let allowed = near.replace("clearance", &format!("allow = [{pair}]\nclearance"));
        let (outcome, json) = simulated_on(PART, &allowed);
        assert_eq!(kinds(&json), Vec::<&str>::new(), "{pair}: {}", outcome.errors);
    }
    let unknown = simulated_with(
        &Shop::new(),
        PART,
        &near.replace("clearance", "allow = [[\"holder\", \"clmap\"]]\nclearance"),
        &[],
    );
    assert!(unknown.errors.contains("error: \"clmap\" is no solid"), "{}", unknown.errors);
}

#[test]
fn a_spindle_meets_the_stock_that_is_left_not_the_blank() {
    // A short tool: the nose of the spindle is 20 mm above the tip, and the blank is 30 mm high.
    let config = |tools: &str| {
        format!(
            "units = \"mm\"\nmachine_zero = {{ X = 0.0, Y = 0.0, Z = -420.0 }}\n[stock]\nlower = [0, 0, -10]\nupper = [40, 32, 30]\n\
             [tools]\n{tools}2 = {{ length = 20, flute_length = 20 }}\n[solids]\nspindle = {{ cylinder = [80, 120] }}\n"
        )
    };
    let short = PART.replace("LOADTL/1", "LOADTL/2");
    let (outcome, json) = simulated_on(&short, &config(""));
    let found = pairs(&json, "findings");
    assert!(found.iter().any(|(name, _)| name == "stock spindle"), "{json} {}", outcome.errors);
    // Faced before by a longer tool.
    let face = "UNITS/MM\nTOOL PATH/FACE,TOOL,MILL\nTLDATA/MILL,100.0,0.0\nLOADTL/1\nSPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\n\
        RAPID\nGOTO/-80,16,80,0,0,1\nRAPID\nGOTO/-80,16,60\nGOTO/-80,16,0\nGOTO/120,16,0\nRAPID\nGOTO/120,16,80\n";
    let both = format!("{face}{}", short.replace("UNITS/MM\n", ""));
    let (outcome, json) = simulated_on(&both, &config("1 = { length = 150, flute_length = 120 }\n"));
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert_eq!(kinds(&json), Vec::<&str>::new(), "{}", outcome.errors);
}

#[test]
fn motions_without_a_place_are_stated_and_the_start_is_a_key() {
    let config = with_clamp("[[0, 41, -10], [50, 60, 45]]", "");
    let states = |config: &str| {
        let (_, json) = simulated_on(PART, config);
        json["not_checked"].to_string()
    };
    assert!(states(&config).contains("motions whose start or end is unknown"));
    let unknown = states(&config.replace("machine_zero = { X = 0.0, Y = 0.0, Z = -420.0 }\n", ""));
    assert!(unknown.contains("motions whose start or end is unknown"), "{unknown}");
    let started = format!("start_position = {{ X = 0, Y = 0, Z = 0, B = 0, C = 0 }}\n{config}");
    let known = states(&started);
    assert!(!known.contains("unknown"), "{known}");
}

#[test]
fn solids_are_read_from_files_next_to_the_configuration_and_faults_are_named() {
    let shop = Shop::new();
    shop.write("clamp.stl", &box_as_stl([[0.0, 36.0, -10.0], [50.0, 60.0, 45.0]]));
    let config = |solids: &str| format!("{CONFIG}{TOOL}[solids]\n{solids}");
    let run = |solids: &str| simulated_with(&shop, PART, &config(solids), &["--json"]);
    let outcome = run("fixtures = \"clamp.stl\"\n");
    let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    assert_eq!(pairs(&json, "findings")[0].0, "clamp holder of tool 1", "{}", outcome.errors);
    // In inches it is elsewhere; moved and rotated it is behind the part.
    for solid in
        ["{ stl = \"clamp.stl\", at = [0, 10, 0] }", "[{ stl = \"clamp.stl\", rotate = [0, 0, 90], at = [-40, 0, 0] }]"]
    {
        let outcome = run(&format!("fixtures = {solid}\n"));
        let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
        assert_eq!(kinds(&json), Vec::<&str>::new(), "{solid}: {}", outcome.errors);
    }
    let errors = |solids: &str| run(solids).errors;
    assert!(errors("fixtures = \"none.stl\"\n").contains("cannot read"), "{}", errors("fixtures = \"none.stl\"\n"));
    shop.write("text.stl", "PARTNO A\n");
    assert!(errors("fixtures = \"text.stl\"\n").contains("text.stl is no solid: it is no STL file"));
    shop.write("open.stl", &box_as_stl([[0.0; 3], [1.0; 3]]).replacen("vertex 0 0 0", "vertex 0 0 0.5", 1));
    let open = run("C = \"open.stl\"\n");
    assert!(open.output.contains("what is wholly inside open: it is open"), "{} {}", open.output, open.errors);
    for (solid, fault) in [
        ("{ name = \"x\" }", "a solid has one shape"),
        ("{ box = [[0, 0, 0], [1, 1, 1]], cylinder = [3, 4] }", "a solid has one shape"),
        ("{ box = [[0, 0, 0], [1, 0, 1]] }", "this box is empty"),
        ("{ cylinder = [3] }", "a cylinder has a diameter and a height"),
        ("{ turned = [[0, 0], [10, 0]] }", "an outline has at least three corners"),
        ("{ turned = [[0, 0], [10, 0], [0, 10], [10, 10]] }", "of this outline cross"),
        ("{ stl = \"a.stl\", colour = 3 }", "unknown key `solids.C.colour`"),
    ] {
        let found = errors(&format!("C = {solid}\n"));
        assert!(found.contains(fault), "{solid}: {found}");
    }
    assert!(errors("frame = { cylinder = [3, 4], set_ups = [1] }\n").contains("`set_ups` is for `fixtures` only"));
}

#[test]
fn stock_and_design_come_from_the_configuration() {
    let base = format!("units = \"mm\"\nmachine_zero = {{ X = 0.0, Y = 0.0, Z = -420.0 }}\n{TOOL}[solids]\n");
    let run = |solids: &str| simulated_on(PART, &format!("{base}{solids}"));
    let (_, cylinder) = run("stock = { cylinder = [40, 10], at = [20, 16, -10] }\n");
    let removed = cylinder["removed_mm3"].as_f64().expect("a volume");
    assert!(removed > 500.0, "{cylinder}");
    let text = cylinder["assumed"].to_string();
    assert!(text.contains("cylinder of `stock` in `[solids]`"), "{text}");
    let stock = "stock = { box = [[0, 0, -10], [40, 32, 0]] }\n";
    let (right, json) = run(&format!("{stock}design = {{ box = [[0, 0, -10], [40, 32, -2]], tolerance = 0.02 }}\n"));
    assert_eq!(json["design"]["gouge_count"], 0, "{}", right.errors);
    assert_eq!(json["design"]["design_tolerance_mm"], 0.02, "{json}");
    assert!(json["design"]["rest_count"].as_u64() > Some(0), "{json}");
    let (_, json) = run(&format!("{stock}design = {{ box = [[0, 0, -10], [40, 32, -1.5]] }}\n"));
    // The groove and the face.
    assert_eq!(json["design"]["gouge_count"], 2, "{json}");
}
