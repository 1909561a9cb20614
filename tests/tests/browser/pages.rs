//! The page in a browser: Debian's Chromium, driven through its WebDriver.
//!
//! The tip and the joints of the machine are read from the matrices of the drawn scene and compared with the CL data
//! and with the axis values of the check's reader (which `view.rs` compares with those of the page). Without Chromium
//! the tests skip. Pictures of the pages are compared with those of the book.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs};

use approx::{abs_diff_eq, assert_abs_diff_eq};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use fantoccini::wd::WebDriverCompatibleCommand;
use fantoccini::{Client, ClientBuilder, Locator};
use hyper_util::client::legacy::connect::HttpConnector;
use nalgebra::Vector3;
use serde_json::{Value, json};
use tempfile::TempDir;
use tests::binaries::{SAMPLES, binary, example_config, workspace};
use tests::by_name;
use tests::environment;
use tests::page::{Page, number};
use url::{ParseError, Url};

/// Largest distance of a drawn tip from the point of the program, mm, and of a drawn joint from its value, mm and
/// degrees.
const SAME: f64 = 1e-3;

/// Largest distance of a drawn tip from the point of the CL data, mm: words are rounded.
const RECORD_MM: f64 = 2e-3;

/// Longest time for the page to be drawn; software rendering on a busy computer is slow.
const PATIENCE: Duration = Duration::from_secs(60);

/// Pictures of the book.
const PICTURES: [&str; 5] = ["lola-xoyzba", "spinner-u5-620", "dmu-70e", "multiprodesk", "simulation"];

/// Largest mean difference of two pictures of one page, of 255: fonts and the rendering of lines differ between
/// versions.
const SAME_PICTURE: f64 = 2.0;

/// Points of a page that are looked at.
const LOOKS: usize = 15;

/// Switches of the browser: no network, no state of another run, and a renderer that needs no graphics card.
const SWITCHES: [&str; 9] = [
    "--headless=new",
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--use-angle=swiftshader",
    "--disable-gpu-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
];

/// Whether Chromium and its driver are installed. Prints that tests are skipped; fails if `PP_REQUIRE_CHROMIUM=1`.
fn is_installed() -> bool {
    let runs = |name: &str| {
        Command::new(name)
            .arg("--version")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
            .is_ok_and(|status| status.success())
    };
    let missing: Vec<&str> = ["chromium", "chromedriver"].into_iter().filter(|name| !runs(name)).collect();
    if missing.is_empty() {
        return true;
    }
    let required = environment::is_one("PP_REQUIRE_CHROMIUM");
    assert!(!required, "PP_REQUIRE_CHROMIUM=1, but there is no {}", missing.join(" and no "));
    println!("skipped: {} not installed", missing.join(" and "));
    false
}

/// A running driver; the browser ends with it.
struct Driver(Child);

impl Drop for Driver {
    fn drop(&mut self) {
        // It may have ended on its own.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A session of the browser.
struct Browser {
    client: Client,
    folder: TempDir,
    _driver: Driver,
}

/// Messages of the console since the last call.
#[derive(Debug)]
struct ConsoleLog;

impl WebDriverCompatibleCommand for ConsoleLog {
    fn endpoint(&self, base: &Url, session: Option<&str>) -> Result<Url, ParseError> {
        base.join(&format!("session/{}/se/log", session.unwrap_or_default()))
    }

    fn method_and_body(&self, _: &Url) -> (http::Method, Option<String>) {
        (http::Method::POST, Some(json!({ "type": "browser" }).to_string()))
    }
}

impl Browser {
    async fn start() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let mut driver = Command::new("chromedriver");
        driver.arg("--port=0").stdout(Stdio::piped()).stderr(Stdio::null());
        let mut driver = Driver(driver.spawn().expect("chromedriver runs"));
        let mut lines = BufReader::new(driver.0.stdout.take().expect("its output")).lines();
        let port = lines.find_map(|line| {
            let line = line.expect("text");
            line.split_once("successfully on port ").map(|(_, port)| port.trim_end_matches('.').to_owned())
        });
        // The driver must be able to write on.
        std::thread::spawn(move || lines.for_each(drop));
        let mut arguments: Vec<String> = SWITCHES.map(str::to_owned).into();
        arguments.push(format!("--user-data-dir={}", folder.path().join("profile").display()));
        arguments.push("--window-size=1400,900".to_owned());
        let capabilities = json!({
            "goog:chromeOptions": { "args": arguments },
            "goog:loggingPrefs": { "browser": "ALL" },
        });
        let Value::Object(capabilities) = capabilities else { unreachable!("an object") };
        let address = format!("http://localhost:{}", port.expect("chromedriver names its port"));
        let client = ClientBuilder::new(HttpConnector::new()).capabilities(capabilities).connect(&address).await;
        Self { client: client.expect("a session"), folder, _driver: driver }
    }

    async fn script(&self, script: &str) -> Value {
        self.client.execute(script, Vec::new()).await.unwrap_or_else(|error| panic!("{script}: {error}"))
    }

    async fn state(&self) -> Value {
        self.script("return window.ppView.state()").await
    }

    /// Waits until an expression is true.
    async fn wait(&self, condition: &str) {
        let begun = Instant::now();
        while self.script(&format!("return !!({condition})")).await != true {
            assert!(begun.elapsed() < PATIENCE, "{condition} does not become true; {}", self.console().await);
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
    }

    async fn console(&self) -> Value {
        self.client.issue_cmd(ConsoleLog).await.expect("the log of the console")
    }

    /// Writes a page with a command, and opens it.
    async fn open(&self, command: Command, args: &[&str]) -> Page {
        self.open_with_figures(command, args).await.0
    }

    /// The same with what the command writes to standard output.
    async fn open_with_figures(&self, mut command: Command, args: &[&str]) -> (Page, Vec<u8>) {
        let path = self.folder.path().join("page.html");
        let output = command.current_dir(workspace()).args(args).arg("-o").arg(&path).output().expect("it runs");
        assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
        self.client.goto(&format!("file://{}", path.display())).await.expect("the page opens");
        self.wait("window.ppView && window.ppView.ready").await;
        (Page::decoded(&fs::read_to_string(&path).expect("the page")), output.stdout)
    }

    /// The drawn machine at points of the program: tip and joints. Number of points at the end of a record's motion.
    async fn look(&self, name: &str, page: &Page) -> usize {
        let mut records = 0;
        for look in 0..LOOKS {
            let point = look * (page.points() - 1) / (LOOKS - 1);
            self.script(&format!("window.ppView.seek({point})")).await;
            let state = self.state().await;
            let drawn = Vector3::from_fn(|row, _| number(&state["toolTip"][row]));
            let off_mm = (drawn - page.tip(point)).norm();
            assert!(off_mm < SAME, "{name}, point {point}: the tip is drawn {off_mm} mm off");
            for (joint, value) in page.axes(point).into_iter().enumerate() {
                let drawn = number(&state["joints"][joint]);
                assert!(
                    (drawn - value).abs() < SAME,
                    "{name}, point {point}: joint {joint} is drawn at {drawn}, not {value}"
                );
            }
            assert_eq!(state["line"].as_u64(), Some(page.line(point)), "{name}, point {point}");
            if let Some(record) = page.record_of(point) {
                let off_mm = (drawn - record).norm();
                assert!(off_mm < RECORD_MM, "{name}, point {point}: {off_mm} mm off the CL data");
                records += 1;
            }
        }
        let messages = self.console().await;
        let errors: Vec<&Value> =
            messages.as_array().expect("a list").iter().filter(|message| message["level"] == "SEVERE").collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
        records
    }

    /// Plays, scrubs, clicks a block and changes the colours, as a user does.
    async fn use_page(&self, name: &str, page: &Page) {
        self.script("window.ppView.seek(0)").await;
        let play = self.client.find(Locator::Css("#play")).await.expect("a button");
        play.click().await.expect("it can be pressed");
        self.wait("window.ppView.state().playing && window.ppView.state().position > 0").await;
        play.click().await.expect("it can be pressed");
        self.wait("!window.ppView.state().playing").await;
        self.script(
            "const scrub = document.querySelector('#scrub');
             scrub.value = String((Number(scrub.min) + Number(scrub.max)) / 2);
             scrub.dispatchEvent(new Event('input', { bubbles: true }));",
        )
        .await;
        let last = page.points() - 1;
        self.wait(&format!("window.ppView.state().point > 0 && window.ppView.state().point < {last}")).await;
        let middle = page.line(page.points() / 2);
        self.script(&format!("window.ppView.seek({})", page.points() / 2)).await;
        let line = self.script("return window.ppView.state().line").await;
        assert_eq!(line.as_u64(), Some(middle), "{name}");
        // Another block in view, with a point of its own.
        let visible = self
            .script(
                "const box = document.querySelector('#program').getBoundingClientRect();
                 return [...document.querySelectorAll('#program [data-line]')].filter(line => {
                     const at = line.getBoundingClientRect();
                     return at.top >= box.top + 4 && at.bottom <= box.bottom - 4;
                 }).map(line => Number(line.dataset.line))",
            )
            .await;
        let is_visible =
            |line: &u64| visible.as_array().is_some_and(|list| list.iter().any(|seen| seen.as_u64() == Some(*line)));
        let wanted = (0..page.points()).map(|point| page.line(point)).find(|line| *line != middle && is_visible(line));
        let wanted = wanted.unwrap_or_else(|| panic!("{name}: no block to click among {visible}"));
        let row = self.client.find(Locator::Css(&format!("#program [data-line=\"{wanted}\"]"))).await.expect("a line");
        row.click().await.expect("it can be clicked");
        self.wait(&format!("window.ppView.state().line === {wanted}")).await;
        let colourings = self.script("return window.ppView.colourings").await;
        let colourings: Vec<&str> = colourings.as_array().expect("names").iter().filter_map(Value::as_str).collect();
        assert!(colourings.len() >= 5, "{name}: {colourings:?}");
        for colouring in colourings {
            let select = format!(
                "const select = document.querySelector('#colouring');
                 select.value = '{colouring}';
                 select.dispatchEvent(new Event('change', {{ bubbles: true }}));"
            );
            self.script(&select).await;
            self.wait(&format!("window.ppView.state().colouring === '{colouring}'")).await;
        }
        self.script("window.ppView.setColouring('motion')").await;
    }

    /// Compares a picture of the page in the middle of its cuts with that of the book; `PP_BLESS=1` replaces that of
    /// the book. Leaves the page.
    async fn compare_picture(&self, name: &str, page: &Page) {
        let cuts: Vec<usize> = (0..page.points()).filter(|point| page.kind(*point) == "feed").collect();
        self.script(&format!("window.ppView.seek({})", cuts[cuts.len() / 2])).await;
        // A click has moved long lines to their middles.
        self.script("document.querySelectorAll('*').forEach(element => { element.scrollLeft = 0; })").await;
        // Two frames: the picture is that of the point.
        self.client
            .execute_async("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))", Vec::new())
            .await
            .expect("frames are drawn");
        let png = self.client.screenshot().await.expect("a picture");
        let of_book = |name: &str| workspace().join(format!("docs/src/{name}.png"));
        if environment::blesses() {
            return fs::write(of_book(name), png).expect("it can be written");
        }
        self.client.goto("about:blank").await.expect("an empty page");
        for other in PICTURES {
            let difference = self.difference(&png, &fs::read(of_book(other)).expect("a picture of the book")).await;
            let same = difference <= SAME_PICTURE;
            assert_eq!(
                same,
                other == name,
                "{name}.png, {other}.png of docs/src: {difference}; PP_BLESS=1 rewrites the first"
            );
        }
    }

    /// Mean difference of two pictures, reduced to a quarter of their size; of 255 for black and white. The browser
    /// decodes them.
    async fn difference(&self, one: &[u8], other: &[u8]) -> f64 {
        const SCRIPT: &str = "
            const [one, other, done] = arguments;
            const load = text => new Promise((loaded, failed) => {
                const image = new Image();
                [image.onload, image.onerror] = [() => loaded(image), failed];
                image.src = 'data:image/png;base64,' + text;
            });
            Promise.all([one, other].map(load)).then(images => {
                const [width, height] = [images[0].width / 4 | 0, images[0].height / 4 | 0];
                const [a, b] = images.map(image => {
                    const canvas = new OffscreenCanvas(width, height).getContext('2d');
                    canvas.imageSmoothingQuality = 'high';
                    canvas.drawImage(image, 0, 0, width, height);
                    return canvas.getImageData(0, 0, width, height).data;
                });
                done(a.reduce((sum, value, index) => sum + Math.abs(value - b[index]), 0) / (3 * width * height));
            });";
        let texts = [one, other].map(|png| json!(BASE64_STANDARD.encode(png)));
        let difference = self.client.execute_async(SCRIPT, texts.to_vec()).await.expect("two pictures");
        number(&difference)
    }
}

/// Runs a test in a browser, if there is one.
fn in_browser(test: impl AsyncFnOnce(&Browser)) {
    if !is_installed() {
        return;
    }
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime");
    runtime.block_on(async {
        let browser = Browser::start().await;
        test(&browser).await;
        browser.client.clone().close().await.expect("the session ends");
    });
}

#[test]
fn the_page_of_each_sample_is_drawn_as_the_cl_data_says_and_can_be_used() {
    in_browser(async |browser| {
        let mut records = 0;
        for (machine, control, part) in SAMPLES {
            let (cl, config) = (format!("examples/cl/{part}"), example_config(machine, control));
            let page = browser.open(binary(machine), &["view", &cl, "--control", control, "--config", &config]).await;
            records += browser.look(machine, &page).await;
            browser.use_page(machine, &page).await;
            browser.compare_picture(machine, &page).await;
        }
        let inclined = Command::new(env!("CARGO_BIN_EXE_inclined"));
        let page = browser.open(inclined, &["view", "examples/cl/convex.cls"]).await;
        records += browser.look("inclined", &page).await;
        browser.use_page("inclined", &page).await;
        assert!(records > 15, "{records}");
    });
}

#[test]
fn programs_of_each_control_are_drawn_in_each_mode() {
    in_browser(async |browser| {
        for (mode, control, operations) in by_name::works().filter(|(mode, ..)| *mode != "auto") {
            let args = ["view", "tests/data/works/works.cls", "--config", "tests/data/works/table.toml"];
            let more = ["--control", control, "--mode", mode, "--ops", operations];
            let page = browser.open(binary("dmu-70e"), &[&args[..], &more[..]].concat()).await;
            browser.look(&format!("{control}, {mode}"), &page).await;
        }
    });
}

/// A dome that is cut from a block on a riser, with spindle, table and frame as solids.
const SOLIDS: &str = "\
part_origin = [0.0, 0.0, 80.0]
machine_zero = { X = 0.0, Y = 0.0, Z = -450.0 }
start_position = { X = 0.0, Y = 0.0, Z = 0.0, B = 0.0, A = 0.0 }
park = { A = 0.0, B = 0.0 }
retract = { position = 0.0, distance = 60.0 }
[limits]
Z = [-500.0, 0.0]
[tools]
1 = { length = 120.0, diameter = 12.0, corner_radius = 6.0, flute_length = 30.0, shank_diameter = 12.0, holder = [32.0, 30.0] }
[solids]
stock = { box = [[-45.0, -33.0, -40.0], [45.0, 33.0, 0.5]] }
design = { stl = \"convex.stl\", tolerance = 0.02 }
fixtures = { name = \"riser\", box = [[-50.0, -38.0, 0.0], [50.0, 38.0, 40.0]] }
X = { name = \"table\", box = [[-300.0, -200.0, -60.0], [300.0, 200.0, 0.0]] }
frame = { name = \"bed\", box = [[-700.0, -260.0, -200.0], [700.0, 260.0, -70.0]] }
spindle = { name = \"nose\", turned = [[0.0, 0.0], [70.0, 0.0], [120.0, 190.0], [0.0, 190.0]] }
";

/// Length of that tool, mm.
const TOOL_MM: f64 = 120.0;

#[test]
fn the_page_of_a_simulation_shows_stock_machine_and_findings() {
    in_browser(async |browser| {
        let folder = browser.folder.path();
        let config = folder.join("job.toml");
        fs::write(&config, SOLIDS).expect("a configuration");
        let designs = examples::designs::designs();
        let (_, design) = designs.iter().find(|(name, _)| *name == "convex.stl").expect("the dome");
        design.write(&mut fs::File::create(folder.join("convex.stl")).expect("a file")).expect("it is written");
        // One cut is 1 mm too deep.
        let text = fs::read_to_string(workspace().join("examples/cl/convex.cls")).expect("CL data");
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let cuts: Vec<usize> = (0..lines.len()).filter(|line| lines[*line].starts_with("GOTO/")).collect();
        let place = cuts[cuts.len() / 2];
        let words: Vec<f64> =
            lines[place]["GOTO/".len()..].split(',').map(|word| word.trim().parse().expect("a number")).collect();
        lines[place] =
            format!("GOTO/{},{},{},{},{},{}", words[0], words[1], words[2] - 1.0, words[3], words[4], words[5]);
        let cl = folder.join("spoiled.cls");
        fs::write(&cl, lines.join("\n")).expect("CL data");
        let [cl, config] = [&cl, &config].map(|path| path.to_str().expect("a name").to_owned());
        let args = ["simulate", &cl, "--config", &config, "--pitch", "1.5", "--rest-tolerance", "0.15", "--json"];
        let (page, figures) = browser.open_with_figures(binary("lola-xoyzba"), &args).await;
        let figures: Value = serde_json::from_slice(&figures).expect("figures");
        browser.look("simulated", &page).await;

        // The spindle is one tool length from the tip, the table under the part zero.
        for look in 0..LOOKS {
            let point = look * (page.points() - 1) / (LOOKS - 1);
            browser.script(&format!("window.ppView.seek({point})")).await;
            let state = browser.state().await;
            let origin = |name: &str| Vector3::from_fn(|row, _| number(&state["simulation"]["origins"][name][row]));
            let gauge = page.tip(point) + TOOL_MM * page.tool_axis(point);
            assert!(abs_diff_eq!(origin("nose"), gauge, epsilon = 1e-3), "point {point}: {} {gauge}", origin("nose"));
            for name in ["riser", "table"] {
                assert_abs_diff_eq!(origin(name), Vector3::new(0.0, 0.0, -80.0), epsilon = 1e-3);
            }
        }

        // The stock loses what the figures state.
        let block = 90.0 * 66.0 * 40.5;
        let removed = figures["removed_mm3"].as_f64().expect("a volume");
        let mut before = f64::INFINITY;
        for (share, left) in
            [(0.0, Some(block)), (0.3, None), (0.6, None), (1.0, Some(block - removed)), (0.0, Some(block))]
        {
            let point = (share * (page.points() - 1) as f64) as usize;
            browser.script(&format!("window.ppView.seek({point})")).await;
            let volume = number(&browser.state().await["simulation"]["volume"]);
            match left {
                Some(left) => {
                    assert!(abs_diff_eq!(volume, left, epsilon = 0.02 * removed), "at {share}: {volume}, not {left}");
                }
                None => assert!(volume < before && volume > block - removed, "at {share}: {volume}"),
            }
            before = volume;
        }

        // A gouge is a place to jump to.
        let gouges = figures["design"]["gouges"].as_array().expect("a list");
        assert!(!gouges.is_empty(), "{figures}");
        let entry = "[...document.querySelectorAll('#simulation-panel .entry')].find(entry => entry.textContent.includes('gouge:'))";
        browser.wait(&format!("!document.querySelector('#sheet-simulation').hidden && {entry}")).await;
        browser.script(&format!("{entry}.click()")).await;
        let line = gouges[0]["line"].as_u64().expect("a line");
        browser.wait(&format!("window.ppView.state().line === {line}")).await;
        for stock in ["cut", "off", "result"] {
            browser.script(&format!("window.ppView.setStock('{stock}')")).await;
            browser.wait(&format!("window.ppView.state().simulation.stock === '{stock}'")).await;
        }
        browser.compare_picture("simulation", &page).await;
    });
}
