//! 100 limit cycles along the friction coefficient.

use crate::common::block::block_of_cells;
use faer::c64;
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::steady_sliding;
use judder_cycles::CyclesError;
use judder_cycles::branch::{BranchSettings, cycle_branch};
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::path::PathRule;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use serde_json::json;
use std::error::Error;
use std::time::Instant;

/// A block of quadrilaterals with 50 nodes on the plane, 490 freedoms, all its modes.
const CELLS: [usize; 2] = [49, 4];
const FRICTION: f64 = 0.3;
const CYCLES: usize = 100;
const HARMONICS: usize = 9;

pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let law =
        |friction: f64| InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(friction));
    let case = block_of_cells(law(FRICTION), 1.0, [100.0, 5e-8], CELLS);
    let steady = steady_sliding(&case, &Compliance::new(&case)?)?;
    let about = Linearised::new(&case, &steady, LinearisedTerms::default())?;
    let region = Region { re: [0.0, 1e5], im: [1e5, 2e5] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default())?;
    let value = found.modes.first().ok_or("no mode grows")?.eigenvalue.value;
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(HARMONICS), ..CycleSettings::default() };
    let start = Instant::now();
    let search = limit_cycles(&case, &steady, c64::new(value.re, value.im), &settings, &|| true)?;
    let cycle = search.cycles.first().ok_or("no cycle is found")?;
    let first = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let rule = PathRule { steps: [0.01, 0.01, 1e-6], tolerance: 1e-8, ..PathRule::default() };
    let settings = BranchSettings { rule, range: [0.0, 1.0], unit: FRICTION, rises: false, points: CYCLES };
    let at = |friction: f64| {
        let mut other = case.clone();
        other.interfaces[0].law = law(friction);
        Ok::<_, CyclesError>(other)
    };
    let branch = cycle_branch(&at, &cycle.balance, (FRICTION, &cycle.motion), &settings, &|| true)?;
    let told = json!({
        "case": "branch", "points": branch.cycles.len(), "contact_points": CELLS[0] + 1, "freedoms": case.size(),
        "harmonics": HARMONICS, "unknowns": cycle.balance.unknowns(), "end": format!("{:?}", branch.end),
        "last": branch.cycles.last().map(|own| own.parameter),
        "first_seconds": first, "seconds": start.elapsed().as_secs_f64(),
    });
    println!("{told}");
    Ok(())
}
