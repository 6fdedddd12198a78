//! Numbers of binary files.

use crate::cause::FileCause;
use crate::error::ExchangeError;

/// A walk over the bytes of a file, which knows its place.
#[derive(Clone)]
pub(crate) struct Bytes<'a> {
    whole: &'a [u8],
    at: usize,
    big_endian: bool,
}

impl<'a> Bytes<'a> {
    pub(crate) fn new(whole: &'a [u8], at: usize, big_endian: bool) -> Self {
        Self { whole, at: at.min(whole.len()), big_endian }
    }

    /// The next byte's place.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Bytes that are left.
    pub(crate) fn left(&self) -> usize {
        self.whole.len() - self.at
    }

    /// An error here.
    pub(crate) fn error(&self, cause: FileCause) -> ExchangeError {
        ExchangeError::at_byte(self.at, cause)
    }

    /// The next bytes.
    pub(crate) fn take(&mut self, count: usize, what: &'static str) -> Result<&'a [u8], ExchangeError> {
        let taken = self.whole[self.at..]
            .get(..count)
            .ok_or_else(|| self.error(FileCause::Cut { what, needed: count, left: self.left() }))?;
        self.at += count;
        Ok(taken)
    }

    /// The next bytes of a fixed number, in little-endian order.
    fn ordered<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], ExchangeError> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.take(N, what)?);
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    pub(crate) fn u32(&mut self, what: &'static str) -> Result<u32, ExchangeError> {
        self.ordered(what).map(u32::from_le_bytes)
    }
}

/// How a binary file stores numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StoredNumber {
    Signed(usize),
    Unsigned(usize),
    Float(usize),
}

impl StoredNumber {
    /// Bytes of one.
    pub(crate) fn size(self) -> usize {
        match self {
            Self::Signed(size) | Self::Unsigned(size) | Self::Float(size) => size,
        }
    }

    /// All numbers in some bytes; a rest that makes no number is left out.
    pub(crate) fn floats(self, bytes: &[u8], big_endian: bool) -> Vec<f64> {
        let wide = |chunk: &[u8]| self.wide(chunk, big_endian);
        let float = |chunk: &[u8]| match self {
            Self::Float(4) => f64::from(f32::from_bits(wide(chunk) as u32)),
            Self::Float(_) => f64::from_bits(wide(chunk)),
            Self::Signed(_) => self.extended(wide(chunk)) as f64,
            Self::Unsigned(_) => wide(chunk) as f64,
        };
        bytes.chunks_exact(self.size()).map(float).collect()
    }

    /// All whole numbers in some bytes that are not negative; others are `None`.
    pub(crate) fn counts(self, bytes: &[u8], big_endian: bool) -> Vec<Option<usize>> {
        let wide = |chunk: &[u8]| self.wide(chunk, big_endian);
        let whole = |chunk: &[u8]| match self {
            Self::Float(_) => None,
            Self::Signed(_) => usize::try_from(self.extended(wide(chunk))).ok(),
            Self::Unsigned(_) => usize::try_from(wide(chunk)).ok(),
        };
        bytes.chunks_exact(self.size()).map(whole).collect()
    }

    /// The bits of a number of up to eight bytes.
    fn wide(self, chunk: &[u8], big_endian: bool) -> u64 {
        let shifted = |bits: u64, byte: &u8| bits << 8 | u64::from(*byte);
        if big_endian { chunk.iter().fold(0, shifted) } else { chunk.iter().rev().fold(0, shifted) }
    }

    /// Bits with the sign of a shorter number.
    fn extended(self, bits: u64) -> i64 {
        let unused = 64 - 8 * self.size() as u32;
        (bits << unused).cast_signed() >> unused
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_kind_are_read() {
        assert_eq!(StoredNumber::Signed(2).floats(&[0xff, 0xfe, 0x00, 0x02], true), [-2.0, 2.0]);
        assert_eq!(StoredNumber::Unsigned(1).counts(&[0xff, 0], false), [Some(255), Some(0)]);
        assert_eq!(StoredNumber::Signed(8).counts(&(-1_i64).to_le_bytes(), false), [None]);
        assert_eq!(StoredNumber::Float(4).floats(&1.5_f32.to_be_bytes(), true), [1.5]);
        assert_eq!(StoredNumber::Float(8).floats(&(-0.1_f64).to_le_bytes(), false), [-0.1]);
        let mut bytes = Bytes::new(&[0, 0, 1, 0, 9], 0, true);
        assert_eq!(bytes.u32("a number").unwrap(), 256);
        assert_eq!(
            bytes.take(2, "a pair").unwrap_err().to_string(),
            "byte 4: ends within a pair: 2 bytes are needed, 1 are left; was the file cut?"
        );
    }
}
