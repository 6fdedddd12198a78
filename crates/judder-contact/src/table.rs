//! Values against a quantity, as a table: straight between its places, or bent without overshoot.

use judder_numerics::words::plain;
use thiserror::Error;

/// How a table runs between its places.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "interpolation"))]
pub enum TableInterpolation {
    /// Straight: the slope jumps at each place.
    #[default]
    Linear,
    /// Cubic, with continuous slope, and monotone wherever the values are.
    Monotone,
}

/// Why two columns are no table.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TableFault {
    /// None, or columns of different lengths.
    #[error("there are {places} places and {values} values")]
    Lengths {
        /// How many places.
        places: usize,
        /// How many values.
        values: usize,
    },
    /// What is no finite number.
    #[error("{0} is not finite")]
    NotFinite(f64),
    /// Places that do not ascend.
    #[error("{} follows {}", plain(*.place), plain(*.before))]
    NotAscending {
        /// The earlier one.
        before: f64,
        /// The later one.
        place: f64,
    },
}

/// The columns of a table that stand elsewhere: n ≥ 1 ascending places and as many values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableColumns<'a> {
    /// The places.
    pub places: &'a [f64],
    /// The values there.
    pub values: &'a [f64],
    /// How it runs between them.
    pub interpolation: TableInterpolation,
}

/// A table: n ≥ 1 ascending places and as many values, all finite.
///
/// It has n + 1 pieces on which it is smooth: below the first place, between two, above the last. Outside of its places it keeps its first
/// and its last value.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueTable {
    places: Vec<f64>,
    values: Vec<f64>,
    interpolation: TableInterpolation,
}

impl ValueTable {
    /// The table of these columns.
    ///
    /// # Errors
    /// [`TableFault`].
    pub fn new(
        places: Vec<f64>,
        values: Vec<f64>,
        interpolation: TableInterpolation,
    ) -> Result<Self, TableFault> {
        check_places(&places, values.len())?;
        match values.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(TableFault::NotFinite(*value)),
            None => Ok(Self { places, values, interpolation }),
        }
    }

    /// The places.
    #[must_use]
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// The values there.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The same with all values multiplied.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { values: self.values.iter().map(|value| factor * value).collect(), ..self.clone() }
    }

    /// How many pieces it has.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.places.len() + 1
    }

    /// The number of the piece at a place; one of the table's own belongs to the piece above it.
    #[must_use]
    pub fn piece(&self, at: f64) -> usize {
        self.places.partition_point(|place| *place <= at)
    }

    /// Value and slope at a place.
    #[must_use]
    pub fn at(&self, at: f64) -> (f64, f64) {
        self.on_piece(self.piece(at), at)
    }

    /// Value and slope of a piece, beyond its ends too: as it goes on there.
    #[must_use]
    pub fn on_piece(&self, piece: usize, at: f64) -> (f64, f64) {
        let Self { places, values, interpolation } = self;
        TableColumns { places, values, interpolation: *interpolation }.on_piece(piece, at)
    }
}

impl TableColumns<'_> {
    /// Value and slope at a place; beyond the ends it goes on as steep as it is there.
    #[must_use]
    pub fn at_and_beyond(&self, at: f64) -> (f64, f64) {
        let last = self.places.len() - 1;
        let piece = self.places.partition_point(|place| *place <= at);
        if last == 0 || (1..=last).contains(&piece) {
            return self.on_piece(piece, at);
        }
        let (end, piece) = if piece == 0 { (self.places[0], 1) } else { (self.places[last], last) };
        let (value, slope) = self.on_piece(piece, end);
        (value + slope * (at - end), slope)
    }

    /// The largest slope of any piece between the places; zero of one place.
    #[must_use]
    pub fn largest_slope(&self) -> f64 {
        let of_piece = |piece: usize| {
            let (from, to) = (self.places[piece - 1], self.places[piece]);
            let width = to - from;
            let [first, middle, second] = [from, from + 0.5 * width, to].map(|at| self.on_piece(piece, at).1);
            // the slope is a parabola, whose top may lie between the ends
            let curvature = 2.0 * (first - 2.0 * middle + second);
            let rise = 4.0 * middle - 3.0 * first - second;
            let top = -0.5 * rise / curvature;
            let inner =
                if curvature < 0.0 && (0.0..1.0).contains(&top) { first + 0.5 * rise * top } else { first };
            first.max(second).max(inner)
        };
        (1..self.places.len()).map(of_piece).fold(0.0, f64::max)
    }

    /// Value and slope of a piece, beyond its ends too: as it goes on there.
    #[must_use]
    pub fn on_piece(&self, piece: usize, at: f64) -> (f64, f64) {
        let last = self.places.len() - 1;
        if piece == 0 {
            return (self.values[0], 0.0);
        }
        if piece > last {
            return (self.values[last], 0.0);
        }
        let (from, to) = (piece - 1, piece);
        let (width, along) = (self.places[to] - self.places[from], at - self.places[from]);
        let chord = (self.values[to] - self.values[from]) / width;
        match self.interpolation {
            TableInterpolation::Linear => (self.values[from] + chord * along, chord),
            TableInterpolation::Monotone => {
                let [first, second] = [self.slope(from), self.slope(to)];
                let bend = (3.0 * chord - 2.0 * first - second) / width;
                let twist = (first + second - 2.0 * chord) / (width * width);
                let value = self.values[from] + along * (first + along * (bend + along * twist));
                (value, first + along * (2.0 * bend + 3.0 * along * twist))
            }
        }
    }

    /// The slope at a place of a monotone table: Fritsch and Butland's weighted harmonic mean of the chords beside it, none at a turn.
    ///
    /// F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300; at the ends the parabola through three places, held back where
    /// it would overshoot (C. Moler, *Numerical Computing with MATLAB*, 2004, section 3.6).
    fn slope(&self, index: usize) -> f64 {
        let width = |k: usize| self.places[k + 1] - self.places[k];
        let chord = |k: usize| (self.values[k + 1] - self.values[k]) / width(k);
        let last = self.places.len() - 1;
        if last == 1 {
            return chord(0);
        }
        let end = |near: usize, far: usize| {
            let (h, next) = (width(near), width(far));
            let slope = ((2.0 * h + next) * chord(near) - h * chord(far)) / (h + next);
            if slope * chord(near) <= 0.0 {
                0.0
            } else if chord(near) * chord(far) <= 0.0 && slope.abs() > 3.0 * chord(near).abs() {
                3.0 * chord(near)
            } else {
                slope
            }
        };
        match index {
            0 => end(0, 1),
            _ if index == last => end(last - 1, last - 2),
            _ => {
                let (before, after) = (chord(index - 1), chord(index));
                if before * after <= 0.0 {
                    return 0.0;
                }
                let (h, next) = (width(index - 1), width(index));
                let weights = (2.0 * next + h, next + 2.0 * h);
                (weights.0 + weights.1) / (weights.0 / before + weights.1 / after)
            }
        }
    }
}

/// Whether there are as many places as values, and these are finite and ascend.
///
/// # Errors
/// [`TableFault`].
pub fn check_places(places: &[f64], values: usize) -> Result<(), TableFault> {
    if places.is_empty() || places.len() != values {
        return Err(TableFault::Lengths { places: places.len(), values });
    }
    if let Some(place) = places.iter().find(|place| !place.is_finite()) {
        return Err(TableFault::NotFinite(*place));
    }
    match places.windows(2).find(|pair| pair[1] <= pair[0]) {
        Some(pair) => Err(TableFault::NotAscending { before: pair[0], place: pair[1] }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn table(places: &[f64], values: &[f64], interpolation: TableInterpolation) -> ValueTable {
        ValueTable::new(places.to_vec(), values.to_vec(), interpolation).unwrap()
    }

    #[test]
    fn a_straight_table_has_the_slope_of_the_piece_above_a_corner() {
        let own = table(&[0.0, 1.0, 3.0], &[1.0, 2.0, 0.0], TableInterpolation::Linear);
        for (at, expected) in
            [(-1.0, (1.0, 0.0)), (0.5, (1.5, 1.0)), (1.0, (2.0, -1.0)), (2.0, (1.0, -1.0)), (3.0, (0.0, 0.0))]
        {
            assert_eq!(own.at(at), expected, "{at}");
        }
        assert_eq!(own.on_piece(1, 2.0), (3.0, 1.0), "it goes on beyond its end");
        assert_eq!((own.pieces(), own.piece(-0.1), own.piece(1.0), own.piece(3.0)), (4, 0, 2, 3));
        assert_eq!(table(&[2.0], &[0.3], TableInterpolation::Monotone).at(5.0), (0.3, 0.0));
    }

    #[test]
    fn columns_go_on_as_steep_as_they_end_and_know_their_steepest_slope() {
        let (places, values) = ([-1.0, 0.0, 2.0], [-3.0, 0.0, 1.0]);
        for interpolation in [TableInterpolation::Linear, TableInterpolation::Monotone] {
            let own = TableColumns { places: &places, values: &values, interpolation };
            for (end, beyond) in [(-1.0, -1.5), (2.0, 4.0)] {
                let ((value, slope), (further, same)) = (own.at_and_beyond(end), own.at_and_beyond(beyond));
                assert!((further - value - slope * (beyond - end)).abs() < 1e-14 && slope == same);
            }
            let slopes = (0..=3000).map(|k| own.at_and_beyond(-1.0 + 1e-3 * f64::from(k)).1);
            let found = slopes.fold(0.0, f64::max);
            assert!((own.largest_slope() / found - 1.0).abs() < 1e-3, "{} {found}", own.largest_slope());
        }
    }

    #[test]
    fn a_monotone_table_has_the_slopes_of_the_source() {
        // of chords 1 and 3 over equal widths the harmonic mean 2/(1 + 1/3)
        let own = table(&[0.0, 1.0, 2.0], &[0.0, 1.0, 4.0], TableInterpolation::Monotone);
        assert!((own.at(1.0).1 - 1.5).abs() < 1e-15);
        assert_eq!([0.0, 1.0, 2.0].map(|at| own.at(at).0), [0.0, 1.0, 4.0]);
        // the parabola through all three has no slope at zero
        assert!(own.on_piece(1, 0.0).1.abs() < 1e-15);
        let turning = table(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0], TableInterpolation::Monotone);
        assert_eq!(turning.at(1.0), (1.0, 0.0));
    }

    #[test]
    fn columns_that_are_no_table_are_refused() {
        let made = |places: &[f64], values: &[f64]| {
            ValueTable::new(places.to_vec(), values.to_vec(), TableInterpolation::Linear).unwrap_err()
        };
        assert_eq!(made(&[], &[]), TableFault::Lengths { places: 0, values: 0 });
        assert_eq!(made(&[0.0, 1.0], &[1.0]), TableFault::Lengths { places: 2, values: 1 });
        assert_eq!(made(&[1.0, 1.0], &[1.0; 2]), TableFault::NotAscending { before: 1.0, place: 1.0 });
        assert!(matches!(made(&[0.0, f64::NAN], &[1.0; 2]), TableFault::NotFinite(_)));
        assert!(matches!(made(&[0.0, 1.0], &[1.0, f64::INFINITY]), TableFault::NotFinite(_)));
    }

    proptest! {
        #[test]
        fn slopes_are_those_of_differences_and_nothing_overshoots(
            widths in prop::collection::vec(0.1..3.0_f64, 1..7),
            values in prop::collection::vec(-2.0..2.0_f64, 8),
            share in 0.05..0.95_f64,
            monotone: bool,
        ) {
            let places: Vec<f64> =
                std::iter::once(0.0).chain(widths.iter().scan(0.0, |sum, w| { *sum += w; Some(*sum) })).collect();
            let interpolation =
                if monotone { TableInterpolation::Monotone } else { TableInterpolation::Linear };
            let own = table(&places, &values[..places.len()], interpolation);
            for (k, pair) in places.windows(2).enumerate() {
                let at = pair[0] + share * (pair[1] - pair[0]);
                let h = 1e-5 * (pair[1] - pair[0]);
                let difference = (own.at(at + h).0 - own.at(at - h).0) / (2.0 * h);
                let (value, slope) = own.at(at);
                prop_assert!((slope - difference).abs() < 1e-6 * (1.0 + slope.abs()), "{} {}", slope, difference);
                let (low, high) = (values[k].min(values[k + 1]), values[k].max(values[k + 1]));
                prop_assert!(value >= low - 1e-12 && value <= high + 1e-12);
            }
        }
    }
}
