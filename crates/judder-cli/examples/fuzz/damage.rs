//! How a sample is damaged.

use judder_numerics::counter::uniform;

use crate::Sample;

/// Words that stand where others should.
const WORDS: [&str; 22] = [
    "0",
    "-1",
    "1",
    "7",
    "255",
    "65536",
    "2147483647",
    "4294967296",
    "9223372036854775807",
    "18446744073709551615",
    "99999999999999999999999",
    "1e308",
    "-1e-308",
    "nan",
    "inf",
    "-inf",
    "",
    "x",
    "\"",
    "[[",
    "{}",
    "\u{fffd}\u{200b}µ²",
];

/// A random number by its place.
struct Random {
    seed: u64,
    place: u64,
}

impl Random {
    fn share(&mut self) -> f64 {
        self.place += 1;
        uniform(self.seed, self.place)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.share() * count as f64) as usize
    }
}

/// A sample, damaged at one to six places; the same for the same seed and number.
pub(crate) fn damaged(samples: &[Sample], seed: u64, number: u64) -> Sample {
    // the first place of each input lies far from those of others
    let mut random = Random { seed: seed.wrapping_mul(0x1_0000_0001).wrapping_add(number), place: 0 };
    let (name, content) = &samples[random.below(samples.len())];
    let other = &samples[random.below(samples.len())].1;
    let mut content = content.clone();
    for _ in 0..=random.below(6) {
        damage(&mut content, other, &mut random);
    }
    (name.clone(), content)
}

fn damage(content: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let length = content.len();
    let (mut from, mut to) = (random.below(length + 1), random.below(length + 1));
    if from > to {
        (from, to) = (to, from);
    }
    let near = (from + 1 + random.below(8)).min(length).max(from);
    let bytes =
        |random: &mut Random| (0..=random.below(8)).map(|_| random.below(256) as u8).collect::<Vec<u8>>();
    match random.below(10) {
        0 => content.truncate(from),
        1 if from < length => content[from] ^= 1 << random.below(8),
        2 => drop(content.splice(from..near, bytes(random))),
        3 => drop(content.splice(from..from, bytes(random))),
        4 => drop(content.drain(from..near)),
        5 => {
            let part = content[from..to.min(from + 4096)].to_vec();
            content.splice(to..to, part);
        }
        6 => {
            let start = random.below(other.len() + 1);
            let end = (start + random.below(512)).min(other.len());
            content.splice(from..near, other[start..end].iter().copied());
        }
        _ => {
            let ends_word = |byte: &u8| byte.is_ascii_whitespace() || b",=\"[]{}:".contains(byte);
            let start = content[..from].iter().rposition(ends_word).map_or(0, |end| end + 1);
            let end = content[from..].iter().position(ends_word).map_or(length, |count| from + count);
            content.splice(start..end, WORDS[random.below(WORDS.len())].bytes());
        }
    }
}
