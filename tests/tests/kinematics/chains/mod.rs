//! Every class of chain: all 360 orders of X Y Z and two rotaries with the tool along Z, and special chains by name.
//!
//! The 240 whose rotary nearest the tool is A or B are declared and must conform; the 120 whose last rotary is C cannot
//! tilt the tool with it and must be refused with a helpful message.

/// Declares a machine per line and checks it: `name: [chain] [points of d] [signs];`.
macro_rules! chains {
    ($($name:ident: [$($chain:tt)*] [$($points:tt)*] [$($signs:tt)*];)*) => {
        $(
            mod $name {
                pp_runtime::machine! {
                    pub(super) struct Chain;
                    chain: $($chain)*;
                    d = { $($points)* };
                    signs = { $($signs)* };
                }

                #[test]
                fn conforms() {
                    tests::conformance::check::<Chain>(super::super::POSES);
                }
            }
        )*

        /// The chains that are checked, as written.
        pub(super) const DECLARED: &[&str] = &[$(stringify!($($chain)*)),*];
    };
}

mod accepted;
mod named;
mod refused;

/// Random poses per chain and check.
const POSES: usize = 2_000;

/// All orders of five letters.
fn orders(letters: [char; 5]) -> Vec<[char; 5]> {
    fn extend(rest: &[char], start: &mut Vec<char>, all: &mut Vec<[char; 5]>) {
        if let Ok(order) = <[char; 5]>::try_from(start.as_slice()) {
            all.push(order);
        }
        for (index, &letter) in rest.iter().enumerate() {
            let mut others = rest.to_vec();
            others.remove(index);
            start.push(letter);
            extend(&others, start, all);
            start.pop();
        }
    }
    let mut all = Vec::new();
    extend(&letters, &mut Vec::new(), &mut all);
    all
}

/// All orders of X Y Z with each pair of rotaries, and the rotary nearest the tool.
fn all_orders() -> Vec<([char; 5], char)> {
    [['A', 'B'], ['A', 'C'], ['B', 'C']]
        .iter()
        .flat_map(|pair| {
            let &[one, other] = pair;
            orders(['X', 'Y', 'Z', one, other])
        })
        .map(|order| {
            let last = order.iter().copied().rfind(|letter| matches!(letter, 'A'..='C'));
            (order, last.expect("there are two rotaries"))
        })
        .collect()
}

#[test]
fn every_order_that_can_tilt_the_tool_is_declared_once() {
    let mut declared: Vec<String> =
        accepted::DECLARED.iter().map(|chain| chain.chars().filter(char::is_ascii_uppercase).collect()).collect();
    let mut expected: Vec<String> =
        all_orders().into_iter().filter(|(_, last)| *last != 'C').map(|(order, _)| order.iter().collect()).collect();
    declared.sort();
    expected.sort();
    assert_eq!(expected.len(), 240);
    assert_eq!(declared, expected);
    assert!(accepted::DECLARED.iter().all(|chain| chain.matches('|').count() == 1));
}
