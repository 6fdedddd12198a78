//! Where the contact is held: at the peaks of the zones that the loci have found.

use super::passage::PassedZone;
use std::fmt::Write as _;

/// How many zones of each locus: those that grow fastest.
const ZONES: usize = 4;
/// How far from the peak of a zone, m: growth may be largest at a corner of the edge, where it jumps and over which the contact would swing.
const BESIDE: f64 = 1e-6;

/// The growth analyses of a method in the zones of its locus, as a case file has them, numbered along the path.
pub(super) fn analyses(method: &str, mut zones: Vec<PassedZone>) -> String {
    zones.retain(|zone| zone.peak.is_finite() && zone.frequency > 0.0);
    zones.sort_by(|a, b| b.growth.total_cmp(&a.growth));
    zones.truncate(ZONES);
    zones.sort_by(|a, b| a.peak.total_cmp(&b.peak));
    let mut text = String::new();
    for (number, zone) in (1..).zip(&zones) {
        let (position, frequency) = (place(zone), zone.frequency);
        // writing to a string does not fail
        let _ = write!(
            text,
            "\n[[analysis]]\nname = \"growth-{method}-{number}\"\nkind = \"growth\"\nmethod = \"{method}\"\n\
             position = \"{position} m\"\nfrequency = \"{frequency} Hz\"\n"
        );
    }
    text
}

/// Beside the peak of a zone, within it.
fn place(zone: &PassedZone) -> f64 {
    let inwards = 0.5 * (zone.from + zone.to) - zone.peak;
    zone.peak + inwards.clamp(-BESIDE, BESIDE)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zone(from: f64, peak: f64, growth: f64) -> PassedZone {
        PassedZone { from, to: from + 1e-3, peak, frequency: 3523.0, growth, nepers: f64::NAN }
    }

    /// The four fastest, in the order of the path, held inside their zones wherever the peak lies.
    #[test]
    fn the_contact_is_held_in_the_fastest_zones() {
        let zones = vec![
            zone(0.09, 0.0905, 130.0),
            zone(0.02, 0.0204, 5.0),
            zone(0.07, 0.07, 90.0),
            zone(0.03, 0.031, 20.0),
            zone(0.08, 0.0806, 80.0),
        ];
        let text = analyses("ensubs", zones.clone());
        let positions: Vec<f64> = text
            .lines()
            .filter_map(|line| line.strip_prefix("position = \"")?.strip_suffix(" m\"")?.parse().ok())
            .collect();
        assert_eq!(positions.len(), 4);
        assert!(positions.is_sorted(), "{positions:?}");
        for (position, zone) in positions.iter().zip([&zones[3], &zones[2], &zones[4], &zones[0]]) {
            assert!(zone.from < *position && *position < zone.to, "{position} {zone:?}");
            assert!((position - zone.peak).abs() <= BESIDE * (1.0 + 1e-9), "{position} {zone:?}");
        }
        let untold = PassedZone { peak: f64::NAN, ..zones[0] };
        assert_eq!(analyses("subs", vec![untold]), "");
    }
}
