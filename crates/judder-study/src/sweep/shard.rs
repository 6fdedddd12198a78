//! A part of the chunks of every sweep, for the job arrays of a cluster.

use std::fmt;
use std::str::FromStr;

/// The k-th of N parts: every N-th chunk, from the k-th on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// k − 1.
    offset: usize,
    /// N.
    count: usize,
}

impl Shard {
    /// All chunks.
    pub const WHOLE: Self = Self { offset: 0, count: 1 };

    /// Whether a chunk belongs to this part.
    #[must_use]
    pub fn takes(self, chunk: usize) -> bool {
        chunk % self.count == self.offset
    }

    /// Whether it is all chunks.
    #[must_use]
    pub fn is_whole(self) -> bool {
        self.count == 1
    }
}

impl Default for Shard {
    fn default() -> Self {
        Self::WHOLE
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.offset + 1, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    /// Reads `k/N`, k from 1 to N.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let parts =
            text.split_once('/').and_then(|(k, n)| Some((k.trim().parse().ok()?, n.trim().parse().ok()?)));
        match parts {
            Some((number, count)) if (1..=count).contains(&number) => Ok(Self { offset: number - 1, count }),
            Some((number, count)) => Err(format!("part {number} of {count}: parts count from 1 to {count}")),
            None => Err("a part is k/N, such as 3/16: the third of sixteen".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_share_the_chunks_without_rest() {
        let parts: Vec<Shard> = ["1/3", "2/3", " 3 / 3"].iter().map(|text| text.parse().unwrap()).collect();
        for chunk in 0..100 {
            assert_eq!(parts.iter().filter(|part| part.takes(chunk)).count(), 1);
        }
        assert_eq!(parts[1].to_string(), "2/3");
        assert!(Shard::WHOLE.takes(7) && "1/1".parse::<Shard>().unwrap().is_whole());
    }

    #[test]
    fn what_is_no_part_is_refused_with_what_is() {
        for wrong in ["0/3", "4/3", "1/0", "3", "a/b", "", "1/2/3", "-1/3"] {
            let told = wrong.parse::<Shard>().unwrap_err();
            assert!(told.contains("part"), "{wrong}: {told}");
        }
    }
}
