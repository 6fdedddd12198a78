//! Cases put together at random, the same ones each time. What they are made of lies in files of its own and not in the tables of the program: a key
//! that is lost there must not be lost here.

use judder_numerics::counter::uniform;
use std::path::Path;

/// How many there are; some of them are refused, which is frozen too.
pub(super) const COUNT: usize = 240;
/// Numbers that one case may draw.
const DRAWS: u64 = 100;
/// Another seed makes other cases.
const SEED: u64 = 20_230_717;

/// The small cases that are varied, and where what may be appended to them stands.
const BASES: [(&str, &str); 12] = [
    ("oscillator", "oscillator"),
    ("contact", "contact"),
    ("sliding", "sliding"),
    ("beam", "beam"),
    ("two-degrees", "two-degrees"),
    ("belt", "belt"),
    ("matrices", "matrices"),
    ("oscillator-dimensional", "oscillator"),
    ("contact-rough", "contact"),
    ("contact-sphere", "contact"),
    ("sweeps", "oscillator"),
    ("contact-law", "contact"),
];

/// A small case with tables appended and options on top.
pub(super) struct GeneratedCase {
    pub(super) base: &'static str,
    pub(super) appended: Vec<String>,
    pub(super) options: Vec<String>,
}

/// The case of this index.
pub(super) fn generated(index: usize) -> GeneratedCase {
    let (base, model) = BASES[index % BASES.len()];
    let (options, tables) = (ingredients(&format!("{base}.txt")), ingredients(&format!("{model}.toml")));
    let mut draw = Draw { next: index as u64 * DRAWS };
    let wanted = 1 + draw.below(5);
    let keys = draw.some(options.lines(), wanted);
    let option = |key: &str| {
        let alternatives: Vec<&str> = key.split(" | ").collect();
        alternatives[draw.below(alternatives.len())].to_owned()
    };
    let options = keys.into_iter().map(option).collect();
    let wanted = draw.below(3);
    let appended = draw.some(tables.split("\n\n"), wanted);
    GeneratedCase {
        base,
        appended: appended.into_iter().map(|table| format!("{}\n", table.trim())).collect(),
        options,
    }
}

/// `.txt`: a line a key, with alternative options; `.toml`: tables with empty lines between them.
fn ingredients(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/main/golden/ingredients");
    std::fs::read_to_string(folder.join(name)).unwrap()
}

/// Numbers for one case, which depend on its index alone.
struct Draw {
    next: u64,
}

impl Draw {
    fn below(&mut self, count: usize) -> usize {
        let number = uniform(SEED, self.next);
        self.next += 1;
        (number * count as f64) as usize
    }

    /// Some of these, each once, in their order.
    fn some<'a>(&mut self, all: impl Iterator<Item = &'a str>, wanted: usize) -> Vec<&'a str> {
        let all: Vec<&str> = all.collect();
        let mut places: Vec<usize> = (0..all.len()).collect();
        for place in 0..wanted.min(all.len()) {
            let other = place + self.below(all.len() - place);
            places.swap(place, other);
        }
        places.truncate(wanted);
        places.sort_unstable();
        places.into_iter().map(|place| all[place]).collect()
    }
}
