//! A point of a map as an interrupted run keeps it: what is told of it, without its modes.

use super::point::{MapPoint, PointVerdict};
use serde::{Deserialize, Serialize};

/// A point of a map, or why there is none.
pub(super) type DecidedPoint = Result<MapPoint, String>;

/// A point of a map as it is kept.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct KeptMapPoint {
    /// Why there is none.
    reason: Option<String>,
    verdict: u8,
    growth: Option<f64>,
    frequency: Option<f64>,
    is_beyond_laws: bool,
    doubt: Option<String>,
}

impl KeptMapPoint {
    pub(super) fn new(solved: &DecidedPoint) -> Self {
        let point = solved.as_ref().unwrap_or(&MapPoint::UNKNOWN);
        let number = |value: f64| value.is_finite().then_some(value);
        Self {
            reason: solved.as_ref().err().cloned(),
            verdict: point.verdict.code(),
            growth: number(point.growth),
            frequency: number(point.frequency),
            is_beyond_laws: point.is_beyond_laws,
            doubt: point.doubt.clone(),
        }
    }

    /// The same point, without its modes.
    pub(super) fn solved(&self) -> DecidedPoint {
        if let Some(reason) = &self.reason {
            return Err(reason.clone());
        }
        let verdict = PointVerdict::ALL.get(usize::from(self.verdict)).copied();
        Ok(MapPoint {
            verdict: verdict.unwrap_or(PointVerdict::Unresolved),
            growth: self.growth.unwrap_or(f64::NAN),
            frequency: self.frequency.unwrap_or(f64::NAN),
            is_beyond_laws: self.is_beyond_laws,
            doubt: self.doubt.clone(),
            stability: None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kept_point_is_the_same_but_for_its_modes() {
        let point = MapPoint {
            verdict: PointVerdict::FallingFriction,
            growth: 0.1 + 0.2,
            frequency: f64::NAN,
            is_beyond_laws: true,
            doubt: Some("of its law".to_owned()),
            stability: None,
        };
        let came_back = |solved: &DecidedPoint| {
            let line = serde_json::to_string(&KeptMapPoint::new(solved)).unwrap();
            let kept: KeptMapPoint = serde_json::from_str(&line).unwrap();
            kept.solved()
        };
        let back = came_back(&Ok(point.clone())).unwrap();
        assert_eq!(back.growth.to_bits(), point.growth.to_bits());
        assert!(back.frequency.is_nan());
        assert_eq!((back.verdict, back.is_beyond_laws, back.doubt), (point.verdict, true, point.doubt));
        assert_eq!(came_back(&Err("no steady sliding".to_owned())).unwrap_err(), "no steady sliding");
    }
}
