//! Steady sliding and what is told of it.

use super::faces::with_faces;
use super::uniqueness::{ToldUniqueness, of_closed_points};
use crate::assembly::AssemblySubject;
use crate::assembly::build::{ShownBodies, SphereState, SubstrateSphere};
use crate::assembly::doubts::IMBALANCE;
use crate::assembly::interface_error::WithInterfaceFreedoms;
use crate::error::ModelError;
use crate::structure::shapes;
use crate::written::written;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::steady::{PointState, SteadySliding};
use judder_exchange::geometry::Geometry;
use judder_exchange::vtu::{FieldValues, VtuField, write_vtu};
use judder_store::{ByName, Results, Variable};
use judder_study::outcome::{CheckRecord, Outcome};
use num_complex::Complex64;
use std::sync::Arc;

/// What is told of steady sliding.
#[derive(Results)]
#[results(arrays(rows), columns(rows))]
pub(super) struct SteadyResults {
    /// whether the equations of all points and the balance of forces on all freedoms are met
    converged: bool,
    /// how far the forces on all freedoms are from balance, over all forces
    #[result(unit = "1")]
    residual: f64,
    /// linear systems that were solved
    iterations: usize,
    /// by what all friction coefficients are multiplied where the equations of the points that are closed become singular, the `factor` of
    /// `closed-points` of `friction_onsets`; none where that is for no friction coefficient, or not known, and of contacts without friction
    #[result(unit = "1")]
    friction_limit: Option<f64>,
    /// whether that is known; not of contacts without friction, of which `friction_onsets` tells coefficients
    friction_limit_known: bool,
    /// what of bodies that turn is left out, in words
    left_out: Vec<String>,
    /// by how much normal forces differ from those with each freedom of the contacts kept, over those: the error of interface modes
    #[result(unit = "1", optional)]
    interface_modes_error: Option<f64>,
    /// each contact
    contacts: ByName<ContactSums>,
    /// each contact point
    #[result(hidden, rows)]
    rows: Vec<PointRow>,
}

/// What is told of contacts that are a sphere.
#[derive(Results)]
pub(super) struct SphereResults {
    /// each contact that is a sphere on the substrate, unless it is in the air
    spheres: ByName<SteadySphere>,
}

/// A sphere in steady sliding.
#[derive(Results)]
pub(super) struct SteadySphere {
    /// the sliding speed v τ/R
    velocity: f64,
    /// the indentation y/R
    indentation: f64,
    /// the contact area
    #[result(unit = "m²")]
    area: f64,
    /// the viscoelastic friction coefficient
    #[result(unit = "1")]
    viscoelastic_friction: f64,
    /// the load that presses it
    #[result(unit = "N")]
    normal_load: f64,
}

/// A contact interface in steady sliding.
#[derive(Results)]
pub(super) struct ContactSums {
    /// the normal forces of all points together
    #[result(unit = "N")]
    normal_force: f64,
    /// the friction forces on the slider, along x, y and z
    #[result(unit = "N")]
    tangential_force: Vec<f64>,
    /// how many contact points there are
    points: usize,
    /// how many are closed
    closed: usize,
    /// how many are open
    open: usize,
    /// the largest pressure
    #[result(unit = "Pa")]
    pressure_max: Option<f64>,
    /// where the normal forces act together; none where there are none
    #[result(unit = "m")]
    centre: Option<Vec<f64>>,
}

/// A contact point in steady sliding.
#[derive(Clone, Results)]
#[results(
    rows = "contact_point",
    arrays(contact, x, y, z, gap, normal_force, friction_force, pressure),
    columns(contact, x, y, z, gap, normal_force, friction_force, pressure, state)
)]
pub(super) struct PointRow {
    /// contact to which the point belongs
    contact: String,
    /// place of the point along x
    #[result(unit = "m", column = "x_m")]
    x: f64,
    /// place of the point along y
    #[result(unit = "m", column = "y_m")]
    y: f64,
    /// place of the point along z
    #[result(unit = "m", column = "z_m")]
    z: f64,
    /// gap; where a compliant contact is closed, below zero
    #[result(unit = "m", column = "gap_m")]
    gap: f64,
    /// normal force
    #[result(unit = "N", column = "normal_force_n")]
    normal_force: f64,
    /// friction force along the slip
    #[result(unit = "N", column = "friction_force_n")]
    friction_force: f64,
    /// pressure: the normal force over the tributary area
    #[result(unit = "Pa", column = "pressure_pa")]
    pressure: f64,
    /// whether it is closed or open
    state: &'static str,
}

impl PointRow {
    fn new(contact: &str, point: &ContactPoint, state: &PointState) -> Self {
        let [x, y, z] = point.place;
        Self {
            contact: contact.to_owned(),
            x,
            y,
            z,
            gap: state.gap,
            normal_force: state.normal_force,
            friction_force: state.friction_force,
            // a node without faces has no area, and no pressure is known of it
            pressure: if point.area > 0.0 { state.normal_force / point.area } else { f64::NAN },
            state: if state.is_closed { "closed" } else { "open" },
        }
    }
}

/// Steady sliding of an assembly.
pub(super) fn run(of: &AssemblySubject<'_>) -> Result<Outcome, ModelError> {
    let compliance = of.compliance()?;
    let steady = of.steady(&compliance)?;
    let (uniqueness, lost) = ToldUniqueness::new(of, &compliance, &steady)?;
    let finer = WithInterfaceFreedoms::of(of)?;
    let results = results(of, &steady, finer.and_then(|finer| finer.of_forces(&steady)));
    let shown = ShownBodies::new(&of.built.bodies);
    let displacement: Vec<Complex64> = steady.displacement.iter().map(|u| Complex64::new(*u, 0.0)).collect();
    let displacement: Vec<f64> = of.built.expanded(&displacement).iter().map(|u| u.re).collect();
    let Outcome { mut scalars, dataset, table, .. } = Outcome::of(&results)?;
    scalars.extend(uniqueness.scalars());
    scalars.extend(spheres(of, &steady).scalars());
    let mut moved = shown.layout.displacements(&displacement);
    for ((point, direction), displacement) in shown.imposed(&of.built.bodies) {
        moved[3 * point + direction as usize] += displacement;
    }
    let points = shown.layout.points.len();
    let dataset = with_faces(shapes::with_layout(dataset, &shown.layout)?, of)?.with(
        Variable::new("shape", &["shown_mode", "point", "direction"], &[1, points, 3], moved.clone())
            .units("m")
            .long_name("displacement in steady sliding"),
    )?;
    let files = vec![(format!("fields/{}.vtu", of.name), field(of, &shown, &steady, &moved)?)];
    let dataset = shown.with_bodies(dataset)?;
    Ok(Outcome {
        scalars,
        dataset,
        table,
        checks: vec![CheckRecord::new(
            "forces are in balance on every freedom",
            format!("K u − f − contact forces over all forces, {} freedoms", of.built.assembly.size()),
            steady.residual.into(),
            IMBALANCE,
        )],
        missing: usize::from(steady.residual > IMBALANCE),
        warnings: [of.doubts(&steady), lost].concat(),
        files,
        ..Outcome::default()
    })
}

/// The spheres of an assembly that has some.
fn spheres(of: &AssemblySubject<'_>, steady: &SteadySliding) -> Option<SphereResults> {
    let told = |(index, _, state): (usize, &Arc<SubstrateSphere>, SphereState)| {
        let own = SteadySphere {
            velocity: state.velocity,
            indentation: state.indentation,
            area: state.area,
            viscoelastic_friction: state.response.friction.value,
            normal_load: state.normal_load,
        };
        (of.built.assembly.interfaces[index].name.clone(), own)
    };
    let has_spheres = of.built.spheres.iter().any(Option::is_some);
    has_spheres.then(|| SphereResults { spheres: of.built.sliding_spheres(steady).map(told).collect() })
}

fn results(
    of: &AssemblySubject<'_>,
    steady: &SteadySliding,
    interface_modes_error: Option<f64>,
) -> SteadyResults {
    let mut states = steady.points.iter();
    let (mut contacts, mut rows) = (Vec::new(), Vec::new());
    for interface in &of.built.assembly.interfaces {
        let own: Vec<(&ContactPoint, &PointState)> = interface.points.iter().zip(states.by_ref()).collect();
        contacts.push((interface.name.clone(), ContactSums::new(&own)));
        rows.extend(own.iter().map(|(point, state)| PointRow::new(&interface.name, point, state)));
    }
    let (closed_points_begin, is_known) = of_closed_points(steady);
    let factor = closed_points_begin.map(|onset| onset.friction.factor());
    SteadyResults {
        converged: steady.residual <= IMBALANCE,
        residual: steady.residual,
        iterations: steady.iterations,
        friction_limit: factor.flatten(),
        // a coefficient is no factor
        friction_limit_known: is_known && factor != Some(None),
        left_out: of.built.left_out.clone(),
        interface_modes_error,
        contacts: contacts.into_iter().collect(),
        rows,
    }
}

impl ContactSums {
    fn new(points: &[(&ContactPoint, &PointState)]) -> Self {
        let normal_force: f64 = points.iter().map(|(_, state)| state.normal_force).sum();
        let sum = |part: &dyn Fn(&ContactPoint, &PointState) -> [f64; 3]| -> Vec<f64> {
            let parts = points.iter().map(|(point, state)| part(point, state));
            parts.fold([0.0; 3], |sum, own| std::array::from_fn(|k| sum[k] + own[k])).to_vec()
        };
        let friction = |point: &ContactPoint, state: &PointState| {
            let velocity = point.slip_velocity();
            let speed = velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
            velocity.map(|v| state.friction_force * v / speed)
        };
        let moment = sum(&|point, state| point.place.map(|x| state.normal_force * x));
        let pressures = points.iter().filter(|(point, _)| point.area > 0.0);
        let pressures = pressures.map(|(point, state)| state.normal_force / point.area);
        let closed = points.iter().filter(|(_, state)| state.is_closed).count();
        Self {
            normal_force,
            tangential_force: sum(&friction),
            points: points.len(),
            closed,
            open: points.len() - closed,
            pressure_max: pressures.reduce(f64::max),
            centre: (normal_force != 0.0).then(|| moment.iter().map(|m| m / normal_force).collect()),
        }
    }
}

/// The bodies in ParaView: displacements, and on contact nodes pressure, gap and state.
fn field(
    of: &AssemblySubject<'_>,
    shown: &ShownBodies,
    steady: &SteadySliding,
    moved: &[f64],
) -> Result<Vec<u8>, ModelError> {
    let (labels, places) = (shown.layout.names.clone(), shown.layout.points.clone());
    let geometry = Geometry { labels, places, ..Geometry::from(&shown.mesh) };
    let mut on_nodes = [vec![f64::NAN; geometry.places.len()], vec![f64::NAN; geometry.places.len()]];
    let mut states = steady.points.iter();
    for ((interface, nodes), contact) in
        of.built.assembly.interfaces.iter().zip(&of.built.nodes).zip(&of.case.contacts)
    {
        let first = shown.first_point[*contact.slider.structure];
        for ((point, node), state) in interface.points.iter().zip(nodes).zip(states.by_ref()) {
            on_nodes[0][first + node] = PointRow::new(&interface.name, point, state).pressure;
            on_nodes[1][first + node] = state.gap;
        }
    }
    let [pressure, gap] = on_nodes;
    let vectors = moved.chunks_exact(3).map(|u| [u[0], u[1], u[2]]).collect();
    let scalar =
        |name: &str, values| VtuField { name: name.to_owned(), values: FieldValues::Scalars(values) };
    let fields = [
        VtuField { name: "displacement (m)".to_owned(), values: FieldValues::Vectors(vectors) },
        scalar("pressure (Pa)", pressure),
        scalar("gap (m)", gap),
    ];
    written(|to| write_vtu(to, &geometry, &fields))
}
