//! Dimensions: exponents of length, mass, time, angle, temperature and amount, with the words an error needs.

use std::fmt;

/// The dimension of a quantity: exponents of metre, kilogram, second, radian, kelvin and mole.
///
/// Angle is kept apart from pure number so that `"45 deg"` cannot stand where a number is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Dimension {
    /// Exponent of length (m).
    pub length: i8,
    /// Exponent of mass (kg).
    pub mass: i8,
    /// Exponent of time (s).
    pub time: i8,
    /// Exponent of angle (rad).
    pub angle: i8,
    /// Exponent of temperature (K).
    pub temperature: i8,
    /// Exponent of amount of substance (mol).
    pub amount: i8,
}

/// A dimension that case files use: its name with article, an example, its SI unit.
struct NamedDimension(Dimension, &'static str, &'static str, &'static str);

const NAMED: [NamedDimension; 18] = [
    NamedDimension(Dimension::NUMBER, "a plain number", "0.01", "1"),
    NamedDimension(Dimension::LENGTH, "a length", "10 mm", "m"),
    NamedDimension(Dimension::MASS, "a mass", "30 g", "kg"),
    NamedDimension(Dimension::TIME, "a time", "10 ms", "s"),
    NamedDimension(Dimension::ANGLE, "an angle", "45 deg", "rad"),
    NamedDimension(Dimension::SPEED, "a speed", "30 mm/s", "m/s"),
    NamedDimension(Dimension::ACCELERATION, "an acceleration", "1 m/s^2", "m/s^2"),
    NamedDimension(Dimension::FORCE, "a force", "0.2 N", "N"),
    NamedDimension(Dimension::STRESS, "a stress", "1 MPa", "Pa"),
    NamedDimension(Dimension::COMPLIANCE, "a compliance", "1e-7 1/Pa", "1/Pa"),
    NamedDimension(Dimension::COMPLIANCE_RATE, "a compliance per time", "1e-5 1/Pa/s", "1/Pa/s"),
    NamedDimension(Dimension::STIFFNESS, "a stiffness", "50 N/m", "N/m"),
    NamedDimension(Dimension::DAMPING, "a damping", "10 N s/m", "N s/m"),
    NamedDimension(Dimension::ANGULAR_FREQUENCY, "an angular frequency", "40 rad/s\" or \"7 kHz", "rad/s"),
    NamedDimension(Dimension::RATE, "a rate", "5 1/s", "1/s"),
    NamedDimension(Dimension::TEMPERATURE, "a temperature", "25 degC\" or \"298 K", "K"),
    NamedDimension(Dimension::MOLAR_ENERGY, "an energy per amount", "80 kJ/mol", "J/mol"),
    NamedDimension(Dimension::DENSITY, "a density", "7850 kg/m^3", "kg/m^3"),
];

impl Dimension {
    /// No dimension: a pure number.
    pub const NUMBER: Self = Self::new(0, 0, 0, 0);
    /// Length, m.
    pub const LENGTH: Self = Self::new(1, 0, 0, 0);
    /// Mass, kg.
    pub const MASS: Self = Self::new(0, 1, 0, 0);
    /// Time, s.
    pub const TIME: Self = Self::new(0, 0, 1, 0);
    /// Angle, rad.
    pub const ANGLE: Self = Self::new(0, 0, 0, 1);
    /// Speed, m/s.
    pub const SPEED: Self = Self::new(1, 0, -1, 0);
    /// Acceleration, m/s².
    pub const ACCELERATION: Self = Self::new(1, 0, -2, 0);
    /// Force, N.
    pub const FORCE: Self = Self::new(1, 1, -2, 0);
    /// Stress and modulus, Pa.
    pub const STRESS: Self = Self::new(-1, 1, -2, 0);
    /// Compliance, 1/Pa.
    pub const COMPLIANCE: Self = Self::new(1, -1, 2, 0);
    /// Compliance per time, 1/(Pa s).
    pub const COMPLIANCE_RATE: Self = Self::new(1, -1, 1, 0);
    /// Stiffness of a spring, N/m.
    pub const STIFFNESS: Self = Self::new(0, 1, -2, 0);
    /// Damping of a damper.
    pub const DAMPING: Self = Self::new(0, 1, -1, 0);
    /// Angular frequency, rad/s; a frequency in Hz is 2π rad/s.
    pub const ANGULAR_FREQUENCY: Self = Self::new(0, 0, -1, 1);
    /// Rate, 1/s.
    pub const RATE: Self = Self::new(0, 0, -1, 0);

    /// Temperature, K.
    pub const TEMPERATURE: Self = Self { temperature: 1, ..Self::NUMBER };
    /// Mass per volume, kg/m³.
    pub const DENSITY: Self = Self::new(-3, 1, 0, 0);
    /// Amount of substance, mol.
    pub const AMOUNT: Self = Self { amount: 1, ..Self::NUMBER };
    /// Energy per amount, J/mol.
    pub const MOLAR_ENERGY: Self = Self { amount: -1, ..Self::new(2, 1, -2, 0) };

    /// The dimension m^length kg^mass s^time rad^angle.
    pub const fn new(length: i8, mass: i8, time: i8, angle: i8) -> Self {
        Self { length, mass, time, angle, temperature: 0, amount: 0 }
    }

    /// Whether this is the dimension of a pure number.
    pub fn is_number(self) -> bool {
        self.powers().iter().all(|(power, _)| *power == 0)
    }

    /// Each exponent with its SI unit.
    fn powers(self) -> [(i8, &'static str); 6] {
        [
            (self.length, "m"),
            (self.mass, "kg"),
            (self.time, "s"),
            (self.angle, "rad"),
            (self.temperature, "K"),
            (self.amount, "mol"),
        ]
    }

    /// The exponents of `self · other^power`; `None` where one leaves the range of `i8`.
    pub fn times(self, other: Self, power: i8) -> Option<Self> {
        let sum = |left: i8, right: i8| right.checked_mul(power).and_then(|right| left.checked_add(right));
        Some(Self {
            length: sum(self.length, other.length)?,
            mass: sum(self.mass, other.mass)?,
            time: sum(self.time, other.time)?,
            angle: sum(self.angle, other.angle)?,
            temperature: sum(self.temperature, other.temperature)?,
            amount: sum(self.amount, other.amount)?,
        })
    }

    /// The SI unit in which numbers of this dimension are kept, such as `N/m`; `1` for a pure number.
    pub fn unit(self) -> String {
        if let Some(NamedDimension(_, _, _, unit)) = self.named() {
            return (*unit).to_owned();
        }
        let factors =
            self.in_newtons().unwrap_or_else(|| self.powers().map(|(p, u)| (i16::from(p), u)).to_vec());
        let [above, below]: [Vec<String>; 2] = [1, -1].map(|sign| {
            let of_sign = factors.iter().filter(|(power, _)| power.signum() == sign);
            of_sign.map(|(power, unit)| factor(power.abs(), unit)).collect()
        });
        let above = if above.is_empty() { "1".to_owned() } else { above.join(" ") };
        [vec![above], below].concat().join("/")
    }

    /// The powers with forces in place of masses, where something moves: `N`, then all but the kilogram.
    fn in_newtons(self) -> Option<Vec<(i16, &'static str)>> {
        if self.mass == 0 || self.time == 0 || self.mass.signum() == self.time.signum() {
            return None;
        }
        let newtons = i16::from(self.mass);
        let powers = self.powers().map(|(power, unit)| match unit {
            "m" => (i16::from(power) - newtons, unit),
            "kg" => (newtons, "N"),
            "s" => (i16::from(power) + 2 * newtons, unit),
            _ => (i16::from(power), unit),
        });
        let [length, force, rest @ ..] = powers;
        Some([&[force, length], rest.as_slice()].concat())
    }

    /// An example of a quantity of this dimension as it stands in a case file.
    pub fn example(self) -> String {
        match self.named() {
            Some(NamedDimension(_, _, example, _)) => (*example).to_owned(),
            None => format!("1 {}", self.unit()),
        }
    }

    fn named(self) -> Option<&'static NamedDimension> {
        NAMED.iter().find(|named| named.0 == self)
    }
}

/// A unit to a power of one or more.
fn factor(power: i16, unit: &str) -> String {
    if power == 1 { unit.to_owned() } else { format!("{unit}^{power}") }
}

impl fmt::Display for Dimension {
    /// The name with its article, `a speed`; a dimension without a name shows its unit.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.named() {
            Some(NamedDimension(_, name, _, _)) => formatter.write_str(name),
            None => write!(formatter, "a quantity in {}", self.unit()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Quantity;

    #[test]
    fn every_example_and_unit_has_the_dimension_it_stands_for() {
        for NamedDimension(dimension, name, example, unit) in NAMED.iter().skip(1) {
            for example in example.split("\" or \"") {
                assert_eq!(Quantity::parse(example).unwrap().dimension, *dimension, "{name}: {example}");
            }
            assert_eq!(Quantity::parse(&format!("1 {unit}")).unwrap().dimension, *dimension, "{name}");
        }
    }

    #[test]
    fn a_dimension_without_a_name_shows_its_unit() {
        let odd = Quantity::parse("3 kg m^2").unwrap().dimension;
        assert_eq!(odd.to_string(), "a quantity in m^2 kg");
        assert_eq!(odd.unit(), "m^2 kg");
    }

    #[test]
    fn a_unit_without_a_name_counts_in_newtons_and_reads_back() {
        for unit in ["N/m^5", "N s", "N m", "N s/m^3", "1/N", "1/m", "m^2 kg", "1/m/K", "N^2/m"] {
            let dimension = Quantity::parse(&format!("1 {unit}")).unwrap().dimension;
            assert_eq!(dimension.unit(), unit);
        }
    }
}
