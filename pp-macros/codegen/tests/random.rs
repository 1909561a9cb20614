//! Any input gives a machine or messages: random words, random declarations, random chains.
//!
//! Times are printed (`--nocapture`), never asserted.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use pp_codegen::{Options, generate};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{select, subsequence};
use proptest::strategy::{BoxedStrategy, ValueTree};
use proptest::test_runner::TestRunner;

const WORD_CASES: u32 = 8000;
const DECLARATION_CASES: u32 = 4000;
const CHAINS: usize = 800;

/// Smallest number of chains that must be proven; the others are refused with reason.
const PROVEN: usize = 500;

/// The expansion is a Rust file, or consists of `compile_error!` only.
fn expands_to_rust(text: &str) -> Result<(), TestCaseError> {
    let Ok(tokens) = text.parse() else { return Ok(()) };
    let file = syn::parse2::<syn::File>(pp_codegen::expand(tokens));
    let file = file.map_err(|error| TestCaseError::fail(format!("{error}: no Rust comes from\n{text}")))?;
    let is_error =
        |item: &&syn::Item| matches!(item, syn::Item::Macro(item) if item.mac.path.is_ident("compile_error"));
    let errors = file.items.iter().filter(is_error).count();
    prop_assert!(errors == 0 || errors == file.items.len(), "a machine with errors comes from\n{}", text);
    prop_assert!(!file.items.is_empty(), "nothing comes from\n{}", text);
    Ok(())
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn one_of(words: &'static str) -> BoxedStrategy<String> {
    select(words.split('~').map(|word| word.trim().to_string()).collect::<Vec<_>>()).boxed()
}

/// Words that declarations are made of, right and wrong.
fn word() -> BoxedStrategy<String> {
    one_of(
        "pub~struct~M~;~chain~:~|~||~X~Y~Z~U~W~A~B~C~d~=~(~)~{~}~,~0~1.5~-~+~*~/~^~45 deg~45deg~mm~Rx~free~..~dims
         ~signs~axes~hold~limits~speeds~tool_axis~verify~\"eq. (7)\"~where~sin~atan2~sqrt~i~k~gauge~0x1~.~#~r#type
         ~up~crate~required~50 rpm~5.9 in~==~[~]~sin B~cB~sin^2
         ~99999999999999999999~1e400~'a'~'x~_~verify \"s\" {~chain: C B | X Y Z;~dims = { d: 150 };~i = sin(B);~::~=>~travel = { B: 0..1 };",
    )
}

proptest! {
    #![proptest_config(config(WORD_CASES))]

    #[test]
    fn random_words_expand_to_rust_or_to_messages(words in vec(word(), 0..40), named in prop::bool::weighted(0.9)) {
        let name = if named { "pub struct M; " } else { "" };
        expands_to_rust(&format!("{name}{}", words.join(" ")))?;
    }
}

proptest! {
    #![proptest_config(config(DECLARATION_CASES))]

    #[test]
    fn random_declarations_expand_to_rust_or_to_messages(text in declaration()) {
        expands_to_rust(&text)?;
    }
}

/// A declaration that is nearly right: fields in any order, in half of the cases with a few words changed.
fn declaration() -> impl Strategy<Value = String> {
    let chain = one_of(
        "chain: C B | X Y Z;~chain: C B | X Y Z;~chain: X | Y Z B A;~chain: A Y | X Z;~chain: X C Y | A Z;~chain: X Y | Z;
         ~chain: C | X Y Z B W;~chain: C A B | X Y Z;~chain: B C | X Y Z;~chain: C B X Y Z;~chain: C B | X Z;~chain: | X Y Z B A",
    );
    let fields = vec![
        one_of("d = (0, 0, d);~d = { C: (0, 0, d), B: (1, -2.5, 2 * d + 1) };~d = (alpha, 0, 1/3);~d = { A: (d, d * d, 0) };"),
        one_of("dims = { d: 150.0, alpha: -45 deg };~dims = { d: 150.0 };~dims = { alpha: -45 deg };~dims = { d: required };
               ~dims = { d: 1/3, x: 2 };~dims = {};"),
        one_of("signs = { C: -, Y: - };~signs = { B: -, A: +, };~signs = { Q: - };"),
        one_of("axes = { B: Rx(-45 deg) * Y };~axes = { B: Rx(alpha) * Y };~axes = { Y: (0, 1, -0.5), C: -Z };
               ~axes = { A: Rz(30 deg) * Ry(2 * alpha - 7.5deg) * X };~axes = { B: (0, 0, 0) };~axes = { B: Rx(45) * Y };"),
        one_of("tool_axis = (0, 0, 1);~tool_axis = -Z;~tool_axis = (1, 2, 2);~tool_axis = Ry(alpha) * Z;~tool_axis = (1, 2);"),
        one_of("hold = { W: 0 };~hold = { A: 0 };~hold = { A: 22.5, W: -100 };~hold = { B: 10 };~hold = { C: 5mm };"),
        one_of("limits = { B: -5..110, C: free };~limits = { X: -310..310mm };~limits = { A: 5..1 };~limits = { Z: 0..=1 };"),
        one_of("speeds = { B: 3600, X: 30000 };~speeds = { Y: 0 };~speeds = { C: 10 / 3 };~speeds = { C: 50 rpm, X: 30 m/min };"),
        one_of("up = Y;~up = -Z;~up = B;"),
        one_of("crate = ::pp_runtime;~crate = crate::a::b;~crate = 5;"),
        verify(),
        verify(),
    ];
    let fields = subsequence(fields, 0..=12).prop_flat_map(|fields| fields).prop_shuffle();
    let edits = prop::option::of(vec((any::<prop::sample::Index>(), prop::option::of(word()), any::<bool>()), 1..4));
    (chain, fields, edits).prop_map(|(chain, mut fields, edits)| {
        fields.push(chain);
        let mut words: Vec<String> = fields.join(" ").split(' ').map(String::from).collect();
        for (place, word, replaces) in edits.into_iter().flatten() {
            let place = place.index(words.len());
            match (word, replaces) {
                (Some(word), true) => words[place] = word,
                (Some(word), false) => words.insert(place, word),
                (None, _) => words[place].clear(),
            }
        }
        format!("/// Text.\npub struct M; {}", words.join(" "))
    })
}

/// A block of random equations.
fn verify() -> BoxedStrategy<String> {
    let names = || one_of("x~y~z~i~j~k~X~Y~Z~A~B~C~d~alpha~gauge~part_x~lost");
    let atom = prop_oneof![names(), one_of("0~1~2~0.25~1/2~45 deg~30deg~150mm")];
    let expression = atom.prop_recursive(3, 12, 3, move |inner| {
        prop_oneof![
            (inner.clone(), one_of("+~-~*~/"), inner.clone())
                .prop_map(|(a, operator, b)| format!("{a} {operator} {b}")),
            (one_of("sin~cos~asin~acos~sqrt~tan"), inner.clone()).prop_map(|(name, a)| format!("{name}({a})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("atan2({a}, {b})")),
            (one_of("sin~cos"), one_of("A~B~C~alpha")).prop_map(|(name, a)| format!("{name}({a})")),
            inner.clone().prop_map(|a| format!("-({a})")),
            (inner, 0_u32..4).prop_map(|(a, power)| format!("({a})^{power}")),
        ]
    });
    let equation = (names(), expression).prop_map(|(left, right)| format!("{left} = {right};"));
    let known = one_of(
        "k = cos(B);~j = sin(B) * sin(C);~B = acos(k);~C = atan2(j, i);~where alpha = -45 deg;~where gauge = 0;
         ~B = atan2(sqrt(i^2 + j^2), k);~Z = z * cos(B) - (z - d) * sin(B);~where beta = alpha;~X = x * cos(C) + y * sin(C);",
    );
    vec(prop_oneof![equation, known], 0..6)
        .prop_map(|lines| format!("verify \"a paper, eqs. (1)-(7)\" {{ {} }}", lines.join(" ")))
        .boxed()
}

/// Directions of up to three digits, a few of nine; rotated coordinate axes; the letter's own.
fn direction() -> BoxedStrategy<String> {
    let vector = |part: fn() -> BoxedStrategy<String>| {
        (part(), part(), part()).prop_map(|(x, y, z)| format!("({x}, {y}, {z})")).boxed()
    };
    let few = || one_of("0~1~-1~0.5~2~-3~0.25~-0.7~7");
    let many = || one_of("0.123456789~-0.987654321~0.577350269~1~0.5~sqrt(2)/2");
    let angle = || one_of("30 deg~-45 deg~10 deg~22.5 deg~e");
    let turned =
        (one_of("Rx~Ry~Rz"), angle(), one_of("X~Y~Z")).prop_map(|(turn, angle, of)| format!("{turn}({angle}) * {of}"));
    prop_oneof![
        10 => vector(few),
        1 => vector(many),
        6 => turned,
        4 => one_of("X~Y~Z"),
    ]
    .boxed()
}

/// A chain with two, one or no solved rotary, perhaps a held axis, in any order and direction.
fn chain() -> impl Strategy<Value = String> {
    let letters = prop_oneof![
        6 => one_of("X Y Z A C~X Y Z B C~U V W A B~X Y Z A B"),
        2 => one_of("X Y Z A~X Y Z B~X Y Z C"),
        1 => Just("X Y Z".to_string()),
        2 => one_of("X Y Z B C W!~X Y Z A W!~X Y Z A C B!~X Y Z B A!"),
    ];
    letters
        .prop_map(|letters| letters.split(' ').map(String::from).collect::<Vec<_>>())
        .prop_shuffle()
        .prop_flat_map(|letters| {
            let count = letters.len();
            let axes = vec((prop::option::weighted(0.55, direction()), any::<bool>()), count);
            (Just(letters), 0..=count, axes, prop::option::weighted(0.3, direction()))
        })
        .prop_map(|(letters, bar, axes, tool)| {
            let mut held = String::new();
            let mut chain = Vec::new();
            let (mut directions, mut signs, mut offsets) = (String::new(), String::new(), String::new());
            for (letter, (direction, minus)) in letters.iter().zip(axes) {
                if letter.ends_with('!') {
                    held = format!("hold = {{ {}: 20 }};", letter.trim_end_matches('!'));
                }
                let letter = letter.trim_end_matches('!');
                chain.push(letter);
                directions += &direction.map(|v| format!("{letter}: {v}, ")).unwrap_or_default();
                signs += &format!("{letter}: {}, ", if minus { '-' } else { '+' });
                if ["A", "B", "C"].contains(&letter) {
                    offsets += &format!("{letter}: (p, q - 2, 0.5 * q), ");
                }
            }
            chain.insert(bar, "|");
            let tool = tool.map(|v| format!("tool_axis = {v};")).unwrap_or_default();
            // Only dimensions that something depends on.
            let mut dimensions = String::new();
            if !offsets.is_empty() {
                dimensions += "p: 10, q: required, ";
            }
            if directions.contains("(e)") || tool.contains("(e)") {
                dimensions += "e: 0.7 deg";
            }
            let field = |name: &str, entries: String| match entries.as_str() {
                "" => entries,
                _ => format!("{name} = {{ {entries} }};"),
            };
            let (directions, signs) = (field("axes", directions), field("signs", signs));
            let (offsets, dimensions) = (field("d", offsets), field("dims", dimensions));
            format!(
                "pub struct M; chain: {}; {directions} {signs} {offsets} {held} {tool} {dimensions}",
                chain.join(" "),
            )
        })
}

/// Refusals that a random chain may get.
const EXPECTED_REFUSALS: [&str; 4] = [
    "cannot move the tip in every direction",
    "rotates about the tool axis",
    "rotate about the same direction",
    "the vector (0, 0, 0) has no direction",
];

#[test]
fn random_chains_are_proven_or_refused_by_name() {
    let mut runner = TestRunner::new(config(1));
    let texts: Vec<String> =
        (0..CHAINS).map(|_| chain().new_tree(&mut runner).expect("no filters").current()).collect();
    let next = AtomicUsize::new(0);
    let outcomes: Mutex<BTreeMap<&str, usize>> = Mutex::default();
    let times: Mutex<Vec<(Duration, usize)>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, Into::into) {
            scope.spawn(|| {
                while let index = next.fetch_add(1, Ordering::Relaxed)
                    && let Some(text) = texts.get(index)
                {
                    let start = Instant::now();
                    let result = std::panic::catch_unwind(|| {
                        generate(text.parse().expect("tokens"), Options::default()).map_err(|refused| refused.0)
                    });
                    times.lock().expect("no panic").push((start.elapsed(), index));
                    let outcome = match result.unwrap_or_else(|_| panic!("a panic comes from\n{text}")) {
                        Ok(_) => "proven",
                        Err(errors) => {
                            let named = |error: &syn::Error| {
                                let error = error.to_string();
                                EXPECTED_REFUSALS.into_iter().find(|text| error.contains(text))
                            };
                            let names: Option<Vec<&str>> = errors.iter().map(named).collect();
                            names.unwrap_or_else(|| panic!("{errors:?}\n{text}"))[0]
                        }
                    };
                    *outcomes.lock().expect("no panic").entry(outcome).or_default() += 1;
                }
            });
        }
    });
    let (outcomes, mut times) = (outcomes.into_inner().expect("no panic"), times.into_inner().expect("no panic"));
    times.sort();
    let (slowest, index) = times[times.len() - 1];
    println!(
        "{outcomes:#?}\nhalf within {:?}, 95 % within {:?}, all within {slowest:?}:\n{}",
        times[CHAINS / 2].0,
        times[CHAINS * 19 / 20].0,
        texts[index]
    );
    assert!(outcomes["proven"] >= PROVEN, "{outcomes:?}");
}
