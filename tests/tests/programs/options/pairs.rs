//! Every pair of keys in one job: it is posted and passes its check, or is refused with a message that names both.
//!
//! Ten keys or so are in one job, chosen so that it has pairs that no job has had. A job that is refused is made
//! smaller until every key that is left is needed for the refusal. Each pair is tried on one control of those that have
//! both; another seed tries others: `PP_PAIRS_SEED=7 cargo test -p tests --test programs options::pairs`.

use std::collections::{BTreeMap, BTreeSet};
use std::env;

use tempfile::{TempDir, tempdir};
use tests::by_name;
use tests::random::Random;

use super::{Job, Keys, Outcome, Place, Row, Sees};

/// Most keys of one job.
const TOGETHER: usize = 10;

/// Two rows, the first one first.
type Pair = [usize; 2];

/// Jobs with several keys.
struct Jobs<'k> {
    keys: &'k Keys,
    folder: TempDir,
    runs: usize,
}

impl Jobs<'_> {
    fn rows(&self, chosen: &[usize]) -> Vec<&Row> {
        chosen.iter().map(|index| &self.keys.rows[*index]).collect()
    }

    fn job(&self, control: &'static str, chosen: &[usize]) -> Option<Job> {
        self.keys.job(control, &self.rows(chosen))
    }

    /// The outcome of a job; `None` if two of its keys need different values of a third.
    fn post(&mut self, control: &'static str, chosen: &[usize]) -> Option<Outcome> {
        let job = self.job(control, chosen)?;
        self.runs += 1;
        Some(job.run(&self.folder, Sees::Text))
    }

    /// The fewest of some keys with which the job is refused, and why.
    fn fewest(&mut self, control: &'static str, chosen: &[usize], refused: Outcome) -> (Vec<usize>, String) {
        let (mut left, mut why) = (chosen.to_vec(), refused);
        for index in chosen {
            let fewer: Vec<usize> = left.iter().copied().filter(|other| other != index).collect();
            if let Some(outcome) = self.post(control, &fewer).filter(|outcome| !outcome.posted) {
                (left, why) = (fewer, outcome);
            }
        }
        (left, why.messages)
    }
}

/// Whether a message names a key: by its last part, or that of a table by axis or number.
fn names(message: &str, key: &str) -> bool {
    let parts: Vec<&str> = key.split('.').collect();
    let is_name = |part: &&&str| part.len() > 1 && part.starts_with(|first: char| first.is_ascii_lowercase());
    parts.iter().rev().find(is_name).is_some_and(|part| message.contains(part))
}

/// Whether two keys cannot meet as they are: one is the other's condition, with another value.
fn is_condition(keys: &Keys, control: &'static str, [one, other]: Pair) -> bool {
    let of = |index: usize| keys.settings_of(control, &keys.rows[index]);
    let (first, second) = (of(one), of(other));
    first.iter().any(|(key, value)| second.get(key).is_some_and(|there| there != value))
        || [(one, &second), (other, &first)]
            .iter()
            .any(|(index, settings)| settings.contains_key(&keys.rows[*index].key))
}

#[test]
fn every_pair_of_keys_is_posted_or_named() {
    let keys = Keys::new();
    let mut random = Random::new(env::var("PP_PAIRS_SEED").map_or(1, |seed| seed.parse().expect("a number")));
    let mut jobs = Jobs { keys: &keys, folder: tempdir().expect("a folder"), runs: 0 };
    let controls: Vec<&'static str> = by_name::controls().collect();
    let takes_part = |row: &Row| row.sees != Sees::Elsewhere && row.place != Place::Alone;
    let mut has: BTreeMap<&'static str, Vec<usize>> = BTreeMap::new();
    for control in &controls {
        let rows = keys.rows.iter().enumerate();
        let rows = rows.filter(|(_, row)| takes_part(row) && keys.applies(control, row)).map(|(index, _)| index);
        // A key that the job refuses alone is in no pair; its effect is in another test.
        let own: Vec<usize> = rows.collect();
        let posted =
            own.into_iter().filter(|index| jobs.post(control, &[*index]).is_some_and(|outcome| outcome.posted));
        has.insert(control, posted.collect());
    }
    let of = |rows: &[usize]| -> Vec<Pair> {
        let mut sorted = rows.to_vec();
        sorted.sort_unstable();
        let pairs = (0..sorted.len()).flat_map(|first| (0..first).map(move |second| [second, first]));
        pairs.map(|pair| pair.map(|place| sorted[place])).collect()
    };
    let mut open: BTreeSet<Pair> = has.values().flat_map(|rows| of(rows)).collect();
    let (all, mut refused, mut conditions, mut wrong) = (open.len(), BTreeMap::new(), 0_usize, Vec::new());
    while let Some(first) = open.iter().nth(random.below(open.len().max(1))).copied() {
        let able: Vec<&'static str> =
            controls.iter().copied().filter(|control| first.iter().all(|row| has[control].contains(row))).collect();
        let control = able[random.below(able.len())];
        if is_condition(&keys, control, first) || jobs.job(control, &first).is_none() {
            open.remove(&first);
            conditions += 1;
            continue;
        }
        let mut chosen = first.to_vec();
        let mut others = has[control].clone();
        while chosen.len() < TOGETHER && !others.is_empty() {
            let other = others.swap_remove(random.below(others.len()));
            let meets = |row: &usize| [(*row).min(other), (*row).max(other)];
            let news = chosen.iter().filter(|row| open.contains(&meets(row))).count();
            let known = chosen.iter().any(|row| *row == other || refused.contains_key(&meets(row)));
            let with: Vec<usize> = chosen.iter().copied().chain([other]).collect();
            if !known && 2 * news >= chosen.len() && jobs.job(control, &with).is_some() {
                chosen = with;
            }
        }
        let mut round = chosen;
        while round.len() > 1 {
            let Some(outcome) = jobs.post(control, &round) else { break };
            if outcome.posted {
                of(&round).iter().for_each(|pair| {
                    open.remove(pair);
                });
                break;
            }
            let (fewest, why) = jobs.fewest(control, &round, outcome);
            // By itself, or by what it needs.
            let is_named = |row: &&&Row| {
                let needs = keys.settings_of(control, row);
                needs.keys().chain([&row.key]).any(|key| names(&why, key))
            };
            let named = jobs.rows(&fewest).iter().filter(is_named).count();
            let key: Vec<&str> = jobs.rows(&fewest).iter().map(|row| row.key.as_str()).collect();
            match fewest[..] {
                [one, other] => {
                    if named < 2 {
                        wrong.push(format!("{} on {control}: {why}", key.join(" and ")));
                    }
                    open.remove(&[one.min(other), one.max(other)]);
                    refused.insert([one.min(other), one.max(other)], key.join(" and "));
                }
                // A refusal of three or more says so as well; it is seen once more without one of them.
                _ if named < 2 => wrong.push(format!("{} on {control}: {why}", key.join(" and "))),
                _ => {}
            }
            let without = fewest[random.below(fewest.len())];
            round.retain(|row| *row != without);
        }
    }
    let posted = all - refused.len() - conditions;
    println!(
        "{all} pairs in {} jobs: {posted} posted, {} refused, {conditions} of a key and its condition",
        jobs.runs,
        refused.len()
    );
    refused.values().for_each(|pair| println!("refused: {pair}"));
    assert!(wrong.is_empty(), "refused without naming both:\n{}", wrong.join("\n"));
    assert!(5 * posted >= 4 * all, "{posted} of {all} pairs are posted");
}
