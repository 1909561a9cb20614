//! `post --simulate`, and tools as the machine knows them.

use super::*;

crate::machine! {
    struct Declared;
    chain: C B | X Y Z;
    d = (0, 0, 50);
}

fn posted(shop: &Shop, part: &str, config: &str, more: &[&str]) -> Outcome {
    shop.write("part.cls", part);
    shop.write("shop.toml", config);
    let (cl, config, out) = (shop.arg("part.cls"), shop.arg("shop.toml"), shop.arg("part.ngc"));
    let arguments = [&["post", &cl, "--config", &config, "-o", &out], more].concat();
    run_on::<Cb>(&arguments, b"", &|job, source, sink, map| post_for(&Cb::default(), job, source, sink, map))
}

#[test]
fn no_file_of_a_simulation_replaces_another_one() {
    let shop = Shop::new();
    let clamp = box_as_stl([[-5.0, -5.0, -30.0], [0.0, 0.0, -25.0]]);
    for name in ["clamp.stl", "blank.stl", "stock.stl", "design.stl"] {
        shop.write(name, &clamp);
    }
    shop.write("table.tbl", "T1 P1 Z100 D10\n");
    let solids = "[solids]\nstock = \"blank.stl\"\nfixtures = { stl = \"clamp.stl\" }\n";
    let config = format!("{CONFIG}{TOOL}{solids}");
    let [stock, design, table, page, map] =
        ["stock.stl", "design.stl", "table.tbl", "page.html", "map.csv"].map(|name| shop.arg(name));
    let files = [
        "--pitch",
        "1",
        "--stock",
        &stock,
        "--design",
        &design,
        "--tool-table",
        &table,
        "--view",
        &page,
        "--map",
        &map,
    ];
    let inputs = [
        ("part.cls", "the CL data"),
        ("shop.toml", "the configuration"),
        ("clamp.stl", "the solid"),
        ("blank.stl", "the solid"),
        ("stock.stl", "the stock"),
        ("design.stl", "the design"),
        ("table.tbl", "the tool table"),
    ];
    let outputs = [
        ("part.ngc", "the program"),
        ("part.ngc.rejected", "the rejected program"),
        ("map.csv", "the map"),
        ("page.html", "the page"),
    ];
    for (name, what) in inputs.into_iter().chain(outputs) {
        let path = shop.arg(name);
        let outcome = posted(&shop, PART, &config, &[&["--simulate", "--save-stock", &path], &files[..]].concat());
        assert_eq!(outcome.status, Status::NotRun, "{name}: {}", outcome.errors);
        assert!(outcome.errors.contains(&format!("would overwrite {what} ")), "{name}: {}", outcome.errors);
        assert!(!shop.path("part.ngc").exists(), "{name}");
    }
    // Solids of the configuration are inputs of every command, and whatever is written.
    for (name, what) in [("clamp.stl", "the solid"), ("stock.stl", "the stock")] {
        let path = shop.arg(name);
        let arguments = ["--simulate", "--stock", &stock, "--view", &path];
        let outcome = posted(&shop, PART, &config, &arguments);
        assert!(outcome.errors.contains(&format!("would overwrite {what} ")), "{name}: {}", outcome.errors);
    }
    let (cl, config, clamp_file) = (shop.arg("part.cls"), shop.arg("shop.toml"), shop.arg("clamp.stl"));
    for arguments in [
        vec!["view", &cl, "--config", &config, "-o", &clamp_file],
        vec!["simulate", &cl, "--config", &config, "--stock", &stock, "--save-stock", &clamp_file],
    ] {
        let outcome =
            run_on::<Cb>(&arguments, b"", &|job, source, sink, map| post_for(&Cb::default(), job, source, sink, map));
        assert!(outcome.errors.contains("would overwrite the solid "), "{arguments:?}: {}", outcome.errors);
    }
    let arguments = ["kinematics", "--c", "--config", &config, "-o", &clamp_file];
    let outcome = run_on::<Declared>(&arguments, b"", &echo);
    assert!(outcome.errors.contains("would overwrite the solid "), "{}", outcome.errors);
    assert_eq!(shop.text("clamp.stl"), clamp);
}

#[test]
fn a_body_is_read_from_a_file_and_a_tool_table_up_to_a_size() {
    let shop = Shop::new();
    let folder = shop.arg("");
    let endless = if cfg!(unix) { "/dev/zero" } else { &folder };
    let refused = |option: &str, path: &str, text: &str| {
        let outcome = posted(&shop, PART, &format!("{CONFIG}{TOOL}"), &["--simulate", option, path]);
        assert_eq!(outcome.status, Status::NotRun, "{option} {path}: {}", outcome.errors);
        assert!(outcome.errors.contains(text), "{option} {path}: {}", outcome.errors);
    };
    for option in ["--stock", "--design"] {
        refused(option, &folder, "it is no file on a disk");
        refused(option, endless, "it is no file on a disk");
    }
    shop.write("long.tbl", &"T1 P1 Z100 D10\n".repeat(100_000));
    refused("--tool-table", &shop.arg("long.tbl"), "it is larger than 1 MiB, the most for a tool table");
}

#[test]
fn a_posted_program_is_simulated_in_one_line() {
    let config = format!("{CONFIG}{TOOL}");
    let shop = Shop::new();
    let plain = posted(&shop, PART, &config, &[]);
    let text = shop.text("part.ngc");
    let right = posted(&shop, PART, &config, &["--simulate", "--pitch", "1"]);
    assert_eq!((plain.status, right.status), (Status::Done, Status::Done), "{}", right.errors);
    assert_eq!(shop.text("part.ngc"), text, "a simulation changes nothing");
    let lines: Vec<&str> = right.errors.lines().filter(|line| line.contains("simulated: ")).collect();
    assert_eq!(
        lines,
        [
            "simulated: 9 motions, 0 collisions among cutting part of tool 1, shank of tool 1, holder of tool 1, stock; 3 things \
          are not checked, see `simulate`"
        ],
        "{}",
        right.errors
    );
    shop.write("design.stl", &box_as_stl([[0.0, 0.0, -10.0], [40.0, 32.0, -2.0]]));
    let design = shop.arg("design.stl");
    let compared = posted(&shop, PART, &config, &["--simulate", "--pitch", "1", "--design", &design]);
    assert!(
        compared.errors.contains("stock; gouge 0.000 mm of 0.01, rest 2.000 mm of 0.01; 2 things"),
        "{}",
        compared.errors
    );
    // To standard output, with a page besides.
    let (cl, toml, page) = (shop.arg("part.cls"), shop.arg("shop.toml"), shop.arg("part.html"));
    let arguments = ["post", &cl, "--config", &toml, "--simulate", "--view", &page];
    let post: PostFn<'_> = &|job, source, sink, map| post_for(&Cb::default(), job, source, sink, map);
    let streamed = run_on::<Cb>(&arguments, b"", post);
    assert_eq!(streamed.output, text);
    assert!(streamed.errors.contains("simulated: ") && streamed.errors.contains("page: "), "{}", streamed.errors);
}

#[test]
fn a_posted_program_that_collides_is_rejected_only_where_that_is_wanted() {
    let part = PART.replace("GOTO/-10,8,5\nGOTO/-10,8,-2\n", "GOTO/10,8,-2\n");
    let config = format!("{CONFIG}{TOOL}");
    let shop = Shop::new();
    let warned = posted(&shop, &part, &config, &["--simulate", "--pitch", "1"]);
    assert_eq!(warned.status, Status::Done, "{}", warned.errors);
    assert!(warned.errors.contains("warning: rapid through the stock: line "), "{}", warned.errors);
    let failed = posted(&shop, &part, &config, &["--simulate", "--pitch", "1", "--fail-on", "collision"]);
    assert_eq!(failed.status, Status::Rejected, "{}", failed.errors);
    assert!(!shop.path("part.ngc").exists() && shop.text("part.ngc.rejected").starts_with("(REJECTED simulated: "));
    let alone = posted(&shop, PART, &config, &["--pitch", "1"]);
    assert_eq!(alone.status, Status::NotRun);
    assert!(alone.errors.contains("`--pitch` needs `--simulate`"), "{}", alone.errors);
    let without = posted(&shop, PART, &format!("units = \"mm\"\n{TOOL}"), &["--simulate"]);
    assert!(without.errors.contains("no stock: give"), "{}", without.errors);
}

#[test]
fn a_length_in_the_tool_table_counts_and_is_compared_with_the_posted_one() {
    let shop = Shop::new();
    let config = format!("{CONFIG}{TOOL}");
    // Lengths of two tools swapped in the table: tool 1 is 45 mm long, its holder is in the stock.
    shop.write("tool.tbl", "T1 P1 D10.0 Z+61.5\nT2 P2 D8.0 Z+100.0\n");
    let table = shop.arg("tool.tbl");
    let swapped = simulated_with(&shop, PART, &config, &["--json", "--tool-table", &table]);
    let json: Json = serde_json::from_str(&swapped.output).unwrap_or_else(|_| panic!("{}", swapped.errors));
    assert!(kinds(&json).contains(&"holder"), "{json}");
    assert!(
        json["tool_table"][0].as_str().is_some_and(|text| text
            == "tool 1 is 61.500 mm long in the tool table, posted with 100.000 mm: the simulation has 61.500 mm"),
        "{json}"
    );
    shop.write("tool.tbl", "G10 L10 P1 R100.0\nG10 L12 P1 R9.9\n");
    let right = simulated_with(&shop, PART, &config, &["--json", "--tool-table", &table]);
    let json: Json = serde_json::from_str(&right.output).unwrap_or_else(|_| panic!("{}", right.errors));
    assert_eq!(kinds(&json), Vec::<&str>::new(), "{}", right.errors);
    assert!(json["tool_table"].to_string().contains("a diameter of 9.900 mm in the tool table"), "{json}");
    shop.write("tool.tbl", "T2 Z80\n");
    let other = simulated_with(&shop, PART, &config, &["--tool-table", &table]);
    assert!(other.errors.contains("warning: tool 1 has no length in the tool table"), "{}", other.errors);
    shop.write("tool.tbl", "PARTNO A\n");
    let none = simulated_with(&shop, PART, &config, &["--tool-table", &table]);
    assert_eq!(none.status, Status::NotRun);
    assert!(none.errors.contains("tool.tbl is no tool table: line 1: "), "{}", none.errors);
}

/// The simulation on a page.
fn simulation_of(page: &str) -> Option<Json> {
    let (_, rest) = page.split_once("id=\"simulation\">")?;
    let (json, _) = rest.split_once("</script>").expect("an end");
    Some(serde_json::from_str(json).expect("JSON"))
}

#[test]
fn the_page_of_a_posted_program_shows_its_simulation() {
    let shop = Shop::new();
    let config = format!("{CONFIG}{TOOL}");
    let page = shop.arg("part.html");
    let shown = |part: &str, more: &[&str]| {
        let outcome = posted(&shop, part, &config, &[&["--view", &page], more].concat());
        (outcome.status, simulation_of(&shop.text("part.html")))
    };
    assert_eq!(shown(PART, &[]), (Status::Done, None));
    let (status, json) = shown(PART, &["--simulate", "--pitch", "1"]);
    let json = json.expect("a simulation");
    assert_eq!(status, Status::Done);
    assert!(json["line"].as_str().is_some_and(|line| line.starts_with("simulated: 9 motions, 0 collisions")), "{json}");
    assert!(json["stages"][0]["removed"]["rows"].as_u64() > Some(100), "{}", json["stages"]);
    // That of a program that is rejected as well.
    let low = PART.replace("GOTO/-10,8,5\nGOTO/-10,8,-2\n", "GOTO/10,8,-2\n");
    let (status, json) = shown(&low, &["--simulate", "--pitch", "1", "--fail-on", "collision"]);
    let json = json.expect("a simulation");
    assert_eq!((status, &json["figures"]["passed"]), (Status::Rejected, &false.into()));
    assert!(kinds(&json["figures"]).contains(&"rapid_through_stock"), "{json}");
}

#[test]
fn a_page_has_the_tools_as_long_as_in_the_tool_table() {
    let shop = Shop::new();
    let config = format!("{CONFIG}{TOOL}");
    shop.write("tool.tbl", "T1 P1 D10.0 Z+80.0\n");
    let (table, page) = (shop.arg("tool.tbl"), shop.arg("part.html"));
    // Height of the spindle over the tip with the last placement, as the page draws it.
    let spindle = || {
        let json = simulation_of(&shop.text("part.html")).expect("a simulation");
        let last = |list: &Json| list.as_array().and_then(|all| all.last()).cloned().expect("a place");
        last(&last(&json["link_places"]))[2].as_f64().expect("a height")
    };
    let heights = [&[][..], &["--tool-table", &table]].map(|more| {
        simulated_with(&shop, PART, &config, &[&["-o", &page], more].concat());
        let simulated = spindle();
        posted(&shop, PART, &config, &[&["--simulate", "--pitch", "1", "--view", &page], more].concat());
        [simulated, spindle()]
    });
    for (with_posted_length, with_the_table) in heights[0].iter().zip(&heights[1]) {
        let shorter = with_posted_length - with_the_table;
        assert!((shorter - 20.0).abs() < 1e-9, "{heights:?}");
    }
}
