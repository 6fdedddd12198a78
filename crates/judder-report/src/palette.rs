//! Colours by meaning: one role is the same colour, dash and marker in every picture.
//!
//! Area colours are apart in lightness as well as in hue (CIE L* about 96, 88, 75, 67, 58, 36), so that they survive
//! grey printing and the common colour deficiencies; line colours are those of Okabe and Ito, and differ in dash and
//! marker too. Sequential colours are viridis, diverging ones Paul Tol's "BuRd".

use serde::Serialize;
use std::fmt;

/// An opaque sRGB colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(
    /// Red.
    pub u8,
    /// Green.
    pub u8,
    /// Blue.
    pub u8,
);

impl fmt::Display for Colour {
    /// `#rrggbb`, as SVG and CSS read it.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

/// Ink of frames, ticks and texts.
pub const INK: Colour = Colour(0x1a, 0x1a, 0x1a);
/// Ink of what steps back: reference lines, notes.
pub const QUIET: Colour = Colour(0x6b, 0x6b, 0x6b);
/// The ground of a picture, of what is hatched for want of an answer, and of the rims that keep lines and letters apart from areas.
pub const GROUND: Colour = Colour(0xff, 0xff, 0xff);

/// Side of the tile of a pattern, in points.
pub(crate) const PATTERN_TILE: f64 = 4.0;

/// What is drawn over the colour of an area.
pub(crate) struct AreaPattern {
    /// Its name within a document.
    pub(crate) name: &'static str,
    /// An SVG path on a tile of [`PATTERN_TILE`] by as much,
    pub(crate) strokes: &'static str,
    /// turned by so many degrees.
    pub(crate) angle: f64,
}

/// The areas that have one.
pub(crate) const PATTERNED: [Role; 7] = [
    Role::Knock,
    Role::KnockUnknown,
    Role::WithinLaw,
    Role::TurningNormal,
    Role::ConvectedSlip,
    Role::AcrossSlip,
    Role::UnknownGrowth,
];

/// What a colour means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Area: no instability.
    Stable,
    /// Area: instability by mode coupling.
    Flutter,
    /// Area: instability by the falling friction force.
    NegativeDamping,
    /// Area: both of them.
    Both,
    /// Area: instability by a velocity-dependent normal force.
    NormalForceCoupling,
    /// Area: instability by unequal damping.
    DestabilisedByDamping,
    /// Area without an answer; hatched.
    Unresolved,
    /// Area: no instability, but a knock starts a motion; hatched the other way.
    Knock,
    /// Area: no instability, and not known what a knock does; dotted.
    KnockUnknown,
    /// Area: the errors of the contact law decide, and there is no verdict; cross-hatched.
    WithinLaw,
    /// Area: instability by forces that turn with a surface; hatched.
    TurningNormal,
    /// Area: instability by friction that follows what passes; dotted.
    ConvectedSlip,
    /// Area: instability by friction across the slip; cross-hatched.
    AcrossSlip,
    /// Area: an instability whose cause is not known; hatched the other way.
    UnknownGrowth,
    /// Area: where along a parameter a pair is unstable, by whatever mechanism.
    UnstableZone,
    /// Area: the indenter moves with the substrate.
    Stick,
    /// Area: it slides ahead of the substrate.
    SlipAhead,
    /// Area: it has left the substrate.
    LiftOff,
    /// Stability boundary of the full system: black, solid.
    FullBoundary,
    /// Stability boundary of the conservative system: black, dashed.
    ConservativeBoundary,
    /// Stability boundary with the coupling removed (η = 0): red, solid.
    DecoupledBoundary,
    /// The mode of this number, counted from 0; a few distinct colours, repeated.
    Mode(usize),
    /// A curve of an unordered family, counted from 0; a few distinct colours, repeated.
    Series(usize),
    /// A curve of a family ordered by a parameter: `index` of `count`, dark to light.
    Graded {
        /// Number of this curve, from 0.
        index: usize,
        /// Number of curves.
        count: usize,
    },
    /// A guide to the eye: grey, thin.
    Reference,
}

/// Okabe and Ito's colours in the order in which they are handed out.
pub(crate) const QUALITATIVE: [Colour; 7] = [
    Colour(0x00, 0x72, 0xb2),
    Colour(0xd5, 0x5e, 0x00),
    Colour(0x00, 0x9e, 0x73),
    Colour(0xcc, 0x79, 0xa7),
    Colour(0x56, 0xb4, 0xe9),
    Colour(0xe6, 0x9f, 0x00),
    Colour(0x00, 0x00, 0x00),
];

/// Where families of lines end on viridis, whose last fifth is too pale for a line on white.
pub(crate) const GRADED_END: f64 = 0.82;

pub(crate) const DASH_CYCLE: [Dash; 4] = [Dash::Solid, Dash::Dashed, Dash::DashDotted, Dash::Dotted];
pub(crate) const MARKER_CYCLE: [Marker; 5] =
    [Marker::Circle, Marker::Square, Marker::Diamond, Marker::Triangle, Marker::Cross];

impl Role {
    /// The colour of this meaning.
    pub fn colour(self) -> Colour {
        match self {
            Self::Stable => Colour(0xf3, 0xf3, 0xef),
            Self::NormalForceCoupling => Colour(0xef, 0xdc, 0x8f),
            Self::NegativeDamping => Colour(0xee, 0xab, 0x55),
            Self::DestabilisedByDamping => Colour(0x6f, 0xb0, 0x9a),
            Self::Flutter => Colour(0x5b, 0x90, 0xc4),
            Self::Both => Colour(0x6a, 0x46, 0x82),
            Self::LiftOff => Colour(0xdd, 0xe9, 0xf7),
            Self::TurningNormal => Colour(0xe3, 0xb7, 0xcf),
            Self::ConvectedSlip => Colour(0xb5, 0xdc, 0xf2),
            Self::AcrossSlip => Colour(0xd9, 0xc7, 0xa3),
            Self::UnknownGrowth => Colour(0xc9, 0xc9, 0xc9),
            Self::UnstableZone => Colour(0xf7, 0xdc, 0xcb),
            Self::Stick => Colour(0xb9, 0xd9, 0xb2),
            Self::SlipAhead => Colour(0xd8, 0x9f, 0xc1),
            Self::Unresolved => Colour(0x8c, 0x8c, 0x8c),
            Self::Knock => Colour(0xfb, 0xdc, 0xd4),
            Self::KnockUnknown => Colour(0xf7, 0xec, 0xe9),
            Self::WithinLaw => Colour(0xdf, 0xdf, 0xe6),
            Self::FullBoundary | Self::ConservativeBoundary => Colour(0, 0, 0),
            Self::DecoupledBoundary => Colour(0xc8, 0x10, 0x2e),
            Self::Mode(index) | Self::Series(index) => of_cycle(&QUALITATIVE, index),
            Self::Graded { index, count } => {
                ColourMap::Sequential.at(GRADED_END * index as f64 / count.saturating_sub(1).max(1) as f64)
            }
            Self::Reference => QUIET,
        }
    }

    /// The dash of a line of this meaning.
    fn dash(self) -> Dash {
        match self {
            Self::ConservativeBoundary => Dash::Dashed,
            Self::Series(index) | Self::Mode(index) => of_cycle(&DASH_CYCLE, index),
            Self::Reference => Dash::Dotted,
            _ => Dash::Solid,
        }
    }

    /// The marker of points of this meaning.
    fn marker(self) -> Marker {
        match self {
            Self::Series(index) | Self::Mode(index) | Self::Graded { index, .. } => {
                of_cycle(&MARKER_CYCLE, index)
            }
            _ => Marker::Circle,
        }
    }

    /// The width of a line of this meaning, in units of the figure (points).
    fn width(self) -> f64 {
        match self {
            Self::Reference => 0.7,
            Self::FullBoundary => 1.0,
            _ => 1.35,
        }
    }

    /// What is drawn over the colour of a patterned area; `None` for a plain one.
    pub(crate) fn pattern(self) -> Option<AreaPattern> {
        const STRIPES: &str = "M0 0H0.9V4H0z";
        const DOTS: &str = "M1 1h1.1v1.1h-1.1z";
        const CROSSES: &str = "M0 0H0.7V4H0z M0 0V0.7H4V0z";
        let (name, strokes, angle) = match self {
            Self::Knock => ("knock", STRIPES, -45.0),
            Self::KnockUnknown => ("knock-unknown", DOTS, 45.0),
            Self::WithinLaw => ("within-law", CROSSES, 45.0),
            Self::TurningNormal => ("turning-normal", STRIPES, -45.0),
            Self::ConvectedSlip => ("convected-slip", DOTS, 45.0),
            Self::AcrossSlip => ("across-slip", CROSSES, 45.0),
            Self::UnknownGrowth => ("unknown-growth", STRIPES, 45.0),
            _ => return None,
        };
        Some(AreaPattern { name, strokes, angle })
    }

    /// The same role drawn solid.
    pub fn solid(self) -> Style {
        Style::from(self).with_dash(Dash::Solid)
    }

    /// The same role drawn dashed.
    pub fn dashed(self) -> Style {
        Style::from(self).with_dash(Dash::Dashed)
    }

    /// The same role drawn in dashes and dots.
    pub fn dash_dotted(self) -> Style {
        Style::from(self).with_dash(Dash::DashDotted)
    }

    /// The same role drawn dotted.
    pub fn dotted(self) -> Style {
        Style::from(self).with_dash(Dash::Dotted)
    }

    /// The same role with points that crowd: small markers without the light rims that would hide each other.
    pub fn crowded(self) -> Style {
        Style { crowded: true, ..Style::from(self) }
    }
}

/// How a line or a set of points is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Style {
    /// What the colour means.
    pub role: Role,
    /// How the line is interrupted.
    pub dash: Dash,
    /// The shape of points.
    pub marker: Marker,
    /// Whether points crowd: their markers are small and have no light rims.
    pub crowded: bool,
    /// Width of the line in points (1/72 inch).
    pub width: f64,
}

impl From<Role> for Style {
    fn from(role: Role) -> Self {
        Self { role, dash: role.dash(), marker: role.marker(), crowded: false, width: role.width() }
    }
}

impl Style {
    /// The same style with another dash.
    #[must_use]
    pub fn with_dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The same style with another width, in points.
    #[must_use]
    pub fn with_width(self, width: f64) -> Self {
        Self { width, ..self }
    }
}

/// How a line is interrupted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[allow(missing_docs)]
#[serde(rename_all = "kebab-case")]
pub enum Dash {
    Solid,
    Dashed,
    DashDotted,
    Dotted,
}

impl Dash {
    /// Lengths of strokes and gaps in widths of the line; empty for a solid line.
    pub(crate) fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[4.5, 2.5],
            Self::DashDotted => &[6.0, 2.2, 1.2, 2.2],
            Self::Dotted => &[1.2, 2.0],
        }
    }
}

/// The shape of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[allow(missing_docs)]
#[serde(rename_all = "kebab-case")]
pub enum Marker {
    Circle,
    Square,
    Diamond,
    Triangle,
    Cross,
}

/// Colours of a map of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ColourMap {
    /// Dark to light (viridis).
    #[default]
    Sequential,
    /// Blue over white to red (Paul Tol's BuRd); the range is made symmetric about zero unless it is given.
    Diverging,
}

const VIRIDIS: [Colour; 9] = [
    Colour(0x44, 0x01, 0x54),
    Colour(0x47, 0x2d, 0x7b),
    Colour(0x3b, 0x52, 0x8b),
    Colour(0x2c, 0x72, 0x8e),
    Colour(0x21, 0x91, 0x8c),
    Colour(0x28, 0xae, 0x80),
    Colour(0x5e, 0xc9, 0x62),
    Colour(0xad, 0xdc, 0x30),
    Colour(0xfd, 0xe7, 0x25),
];

const BLUE_RED: [Colour; 9] = [
    Colour(0x21, 0x66, 0xac),
    Colour(0x43, 0x93, 0xc3),
    Colour(0x92, 0xc5, 0xde),
    Colour(0xd1, 0xe5, 0xf0),
    Colour(0xf7, 0xf7, 0xf7),
    Colour(0xfd, 0xdb, 0xc7),
    Colour(0xf4, 0xa5, 0x82),
    Colour(0xd6, 0x60, 0x4d),
    Colour(0xb2, 0x18, 0x2b),
];

/// The entry of a cycle that comes at this place.
#[expect(clippy::indexing_slicing, reason = "a remainder is a place")]
fn of_cycle<T: Copy, const COUNT: usize>(cycle: &[T; COUNT], index: usize) -> T {
    const { assert!(COUNT > 0) };
    cycle[index % COUNT]
}

impl ColourMap {
    /// Its nine equally spaced stops.
    pub(crate) fn stops(self) -> &'static [Colour; 9] {
        match self {
            Self::Sequential => &VIRIDIS,
            Self::Diverging => &BLUE_RED,
        }
    }

    /// The colour at `fraction` of the range, 0..1; outside it the end colours, for NaN the lower one.
    pub fn at(self, fraction: f64) -> Colour {
        let stops = self.stops();
        let fraction = if fraction.is_nan() { 0.0 } else { fraction.clamp(0.0, 1.0) };
        let place = fraction * (stops.len() - 1) as f64;
        let below = (place as usize).min(stops.len() - 2);
        match stops.get(below..) {
            Some([from, to, ..]) => mix(*from, *to, place - below as f64),
            _ => QUIET,
        }
    }
}

/// The colour `share` of the way from `from` to `to`.
fn mix(from: Colour, to: Colour, share: f64) -> Colour {
    let channel = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share).round() as u8;
    Colour(channel(from.0, to.0), channel(from.1, to.1), channel(from.2, to.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE lightness L* of an sRGB colour.
    fn lightness(colour: Colour) -> f64 {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        let luminance = 0.2126 * linear(colour.0) + 0.7152 * linear(colour.1) + 0.0722 * linear(colour.2);
        116.0 * luminance.cbrt() - 16.0
    }

    #[test]
    fn area_colours_are_apart_in_grey() {
        let areas = [
            Role::Stable,
            Role::NormalForceCoupling,
            Role::NegativeDamping,
            Role::DestabilisedByDamping,
            Role::Flutter,
            Role::Both,
        ];
        for pair in areas.windows(2) {
            let step = lightness(pair[0].colour()) - lightness(pair[1].colour());
            assert!(step > 7.0, "{pair:?} are only {step:.1} apart");
        }
    }

    /// What is patterned is told by its pattern, and light enough for that to be seen.
    #[test]
    fn patterned_areas_bear_their_pattern() {
        for role in PATTERNED {
            assert!(role.pattern().is_some());
            assert!(lightness(role.colour()) - lightness(QUIET) > 30.0, "{role:?}");
        }
    }

    #[test]
    fn contact_states_are_apart_in_grey() {
        let grounds = [Role::LiftOff, Role::Stick, Role::SlipAhead].map(|role| lightness(role.colour()));
        let steps = [100.0 - grounds[0], grounds[0] - grounds[1], grounds[1] - grounds[2]];
        assert!(steps.iter().all(|step| *step > 7.0), "{steps:?}");
    }

    #[test]
    fn colour_maps_end_at_their_stops() {
        assert_eq!(ColourMap::Sequential.at(-1.0), VIRIDIS[0]);
        assert_eq!(ColourMap::Diverging.at(2.0), BLUE_RED[8]);
        assert_eq!(ColourMap::Diverging.at(0.5), BLUE_RED[4]);
        assert_eq!(ColourMap::Sequential.at(f64::NAN), VIRIDIS[0]);
    }

    #[test]
    fn graded_families_of_one_and_none_have_a_colour() {
        assert_eq!(Role::Graded { index: 0, count: 1 }.colour(), VIRIDIS[0]);
        assert_eq!(Role::Graded { index: 0, count: 0 }.colour(), VIRIDIS[0]);
    }
}
