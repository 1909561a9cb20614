//! Set-ups that follow one another in a program.

use super::*;

/// A groove from above, and one across it from below, as the frame of the second set-up is upside down.
fn two_sides(second_frame: &str, depth: f64) -> String {
    let head = "UNITS/MM\nMSYS/0,0,0,1,0,0,0,1,0\nTOOL PATH/TOP,TOOL,MILL\nTLDATA/MILL,10.0,0.0\nLOADTL/1\n\
        SPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\nRAPID\nGOTO/-10,8,50,0,0,1\nRAPID\nGOTO/-10,8,5\nGOTO/-10,8,-6\nGOTO/50,8,-6\n\
        RAPID\nGOTO/50,8,50\nEND-OF-PATH\n";
    format!(
        "{head}{second_frame}TOOL PATH/BOTTOM,TOOL,MILL\nRAPID\nGOTO/20,-10,50,0,0,1\nRAPID\nGOTO/20,-10,5\nGOTO/20,-10,-{depth}\n\
         GOTO/20,42,-{depth}\nRAPID\nGOTO/20,42,50\nFINI\n"
    )
}

const UPSIDE_DOWN: &str = "MSYS/0,32,-10,1,0,0,0,-1,0\n";

fn config(set_up: &str) -> String {
    let keys = format!("park = {{ C = 0.0 }}\n{CONFIG}");
    format!("{keys}{TOOL}[set_ups.2]\nwork_offset = \"G55\"\npart_origin = [0.0, 0.0, 0.0]\n{set_up}")
}

fn run(part: &str, config: &str) -> (Outcome, Json) {
    let outcome = simulated_with(&Shop::new(), part, config, &["--json"]);
    let json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    (outcome, json)
}

fn removed(json: &Json) -> f64 {
    json["removed_mm3"].as_f64().expect("a volume")
}

#[test]
fn the_stock_of_the_second_set_up_is_what_the_first_has_left() {
    let (outcome, json) = run(&two_sides(UPSIDE_DOWN, 6.0), &config(""));
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert_eq!(kinds(&json), Vec::<&str>::new(), "{}", outcome.errors);
    // Both grooves are 10 mm wide and 6 mm deep in 10 mm: where they cross they meet.
    let wanted = 40.0 * 10.0 * 6.0 + 32.0 * 10.0 * 6.0 - 10.0 * 10.0 * 2.0;
    assert!((removed(&json) - wanted).abs() < 1e-3 * wanted, "{json}");
    // Too deep by 4.5 mm: a rapid that is right over the blank is in the wrong place over the turned part.
    let low = two_sides(UPSIDE_DOWN, 6.0).replace("RAPID\nGOTO/20,42,50", "RAPID\nGOTO/5,16,-2");
    let (_, json) = run(&low, &config(""));
    assert!(kinds(&json).contains(&"rapid_through_stock"), "{json}");
}

#[test]
fn the_place_of_the_part_comes_from_a_key_or_is_not_known() {
    // Frames that differ, of which the first is not stated.
    let part = two_sides("", 6.0);
    let begins = "begins = \"BOTTOM\"\n";
    let (outcome, json) = run(&part, &config(begins));
    assert!(
        json["assumed"].to_string().contains("the CL data of set-up 2 is in the coordinates of the first one"),
        "{}",
        outcome.errors
    );
    let wanted = 40.0 * 10.0 * 6.0 + 32.0 * 10.0 * 6.0 - 10.0 * 10.0 * 6.0;
    assert!((removed(&json) - wanted).abs() < 1e-3 * wanted, "{json}");
    let key = format!("{begins}cl_origin = [0.0, 32.0, -10.0]\ncl_rotation = [180.0, 0.0, 0.0]\n");
    let (outcome, json) = run(&part, &config(&key));
    let wanted = 40.0 * 10.0 * 6.0 + 32.0 * 10.0 * 6.0 - 10.0 * 10.0 * 2.0;
    assert!((removed(&json) - wanted).abs() < 1e-3 * wanted, "{json} {}", outcome.errors);
    // By another angle the stock is made of its surface.
    let turned = format!("{begins}cl_origin = [0.0, 0.0, 0.0]\ncl_rotation = [0.0, 0.0, 30.0]\n");
    let (outcome, json) = run(&part.replace("GOTO/20,42,-6", "GOTO/20,12,-6"), &config(&turned));
    assert!(removed(&json) > 40.0 * 10.0 * 6.0 + 500.0, "{json} {}", outcome.errors);
}

#[test]
fn a_stock_that_cannot_be_clamped_is_stated_once() {
    // A mill of 100 mm leaves nothing of it, and the second set-up is turned by 30 degrees.
    let part = two_sides("", 6.0).replace("TLDATA/MILL,10.0,0.0", "TLDATA/MILL,100.0,0.0").replace(",8,-6", ",8,-10.5");
    let tool = TOOL.replace("diameter = 10.0", "diameter = 100.0").replace("flute_length = 8.0", "flute_length = 30.0");
    let turned = "begins = \"BOTTOM\"\ncl_origin = [0.0, 0.0, 0.0]\ncl_rotation = [0.0, 0.0, 30.0]\n";
    let (outcome, json) = run(&part, &config(turned).replace(TOOL, &tool));
    let stated = |text: &str| json["not_checked"].to_string().matches(text).count();
    assert_eq!(stated("set-up 2: the machined stock: it has no triangle"), 1, "{json} {}", outcome.errors);
    assert_eq!(stated("in set-ups in which the place of the part is unknown"), 1, "{json}");
}

#[test]
fn the_design_is_compared_where_the_part_lies_at_the_end() {
    let shop = Shop::new();
    let stock = "[solids]\ndesign = { box = [[0, 0, -10], [40, 32, 0]] }\n";
    let outcome = simulated_with(&shop, &two_sides(UPSIDE_DOWN, 0.3), &format!("{}{stock}", config("")), &["--json"]);
    let json: Json = serde_json::from_str(&outcome.output).unwrap_or_else(|_| panic!("{}", outcome.errors));
    let gouges: Vec<f64> = json["design"]["gouges"]
        .as_array()
        .expect("gouges")
        .iter()
        .map(|gouge| gouge["deviation_mm"].as_f64().expect("a depth"))
        .collect();
    // The middle of the first groove between its pitch, and the depth of the second one, which is on top.
    assert!(gouges.len() == 2 && (gouges[0] - 4.5).abs() < 0.6 && (gouges[1] - 0.3).abs() < 0.01, "{json}");
    assert!(json["design"]["exceeds_stock_mm"].as_f64() < Some(1e-9), "{json}");
    let saved = shop.arg("saved.stl");
    let first = simulated_with(&shop, &two_sides(UPSIDE_DOWN, 0.3), &config(""), &["--save-stock", &saved]);
    assert_eq!(first.status, Status::Done, "{}", first.errors);
}

/// All six sides of a block by two set-ups: the face and the four sides from above, and the face from below.
fn six_sides(second_frame: &str) -> String {
    let face = "RAPID\nGOTO/-12,3,50,0,0,1\nRAPID\nGOTO/-12,3,5\nGOTO/-12,3,0\nGOTO/52,3,0\nGOTO/52,11,0\nGOTO/-12,11,0\n\
        GOTO/-12,19,0\nGOTO/52,19,0\nGOTO/52,27,0\nGOTO/-12,27,0\nGOTO/-12,32,0\nGOTO/52,32,0\nRAPID\nGOTO/52,32,50\n";
    let sides = "RAPID\nGOTO/-15,-5,50\nRAPID\nGOTO/-15,-5,5\nGOTO/-15,-5,-10.5\nGOTO/45,-5,-10.5\nGOTO/45,37,-10.5\n\
        GOTO/-5,37,-10.5\nGOTO/-5,-15,-10.5\nRAPID\nGOTO/-5,-15,50\n";
    format!(
        "UNITS/MM\nMSYS/0,0,0,1,0,0,0,1,0\nTOOL PATH/TOP,TOOL,MILL\nTLDATA/MILL,10.0,0.0\nLOADTL/1\n\
         SPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\n{face}{sides}END-OF-PATH\n{second_frame}TOOL PATH/BOTTOM,TOOL,MILL\n{face}FINI\n"
    )
}

#[test]
fn six_sides_of_a_block_are_the_finished_part_after_two_set_ups() {
    let tool = TOOL.replace("flute_length = 8.0", "flute_length = 30.0");
    let config = config("")
        .replace(TOOL, &tool)
        .replace("lower = [0.0, 0.0, -10.0]\nupper = [40.0, 32.0, 0.0]", "lower = [-1, -1, -11]\nupper = [41, 33, 1]");
    let config = format!("{config}[solids]\ndesign = {{ box = [[0, 0, -10], [40, 32, 0]] }}\n");
    let (outcome, json) = run(&six_sides(UPSIDE_DOWN), &config);
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert_eq!(kinds(&json), Vec::<&str>::new(), "{}", outcome.errors);
    let wanted = 42.0 * 34.0 * 12.0 - 40.0 * 32.0 * 10.0;
    assert!((removed(&json) - wanted).abs() < 2e-3 * wanted, "{json}");
    let design = &json["design"];
    for side in ["gouge", "rest"] {
        assert_eq!(design[format!("{side}_count")], 0, "{design}");
        let largest = design[format!("largest_{side}_mm")].as_f64().expect("a distance");
        assert!(largest < 2e-3, "{side}: {largest}");
    }
    // The part lies 0.03 mm too high or too low in the second set-up.
    for (origin, count) in [("-9.97", "gouge_count"), ("-10.03", "rest_count")] {
        let frame = UPSIDE_DOWN.replace("-10,", &format!("{origin},"));
        let (outcome, json) = run(&six_sides(&frame), &config);
        assert_eq!(json["design"][count], 1, "{origin}: {json} {}", outcome.errors);
    }
}
