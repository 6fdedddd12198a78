//! Shapes of modes over the undeformed body; on the page they swing.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_numerics::complex::ElementaryComplex;
use judder_report::figure::ValueMap;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Panel, Role, Swing};
use judder_study::pictures::{FRAME, StoredArrays, complexes, reals, wholes};
use num_complex::Complex64;

/// The largest displacement of a picture, over the diagonal of the body.
const DISPLACEMENT: f64 = 0.08;
/// Around the picture, over its size.
const MARGIN: f64 = 0.06;

/// A panel for each of these modes; none where the shapes have no places.
pub(crate) fn panels(
    dataset: &StoredArrays<'_>,
    wanted: impl Iterator<Item = usize>,
    title: &dyn Fn(usize) -> String,
) -> Vec<Panel> {
    let panel = |k: usize| Some(ShapePicture::new(dataset, k)?.panel(Moves::Swings).with_title(title(k)));
    wanted.filter_map(panel).collect()
}

/// A panel with the first shape at rest: how loads move a body.
pub(crate) fn still(dataset: &StoredArrays<'_>, title: &str) -> Option<Panel> {
    Some(ShapePicture::new(dataset, 0)?.panel(Moves::Rests).with_title(title))
}

/// Whether a shape swings on the page.
#[derive(Clone, Copy, PartialEq)]
enum Moves {
    Swings,
    Rests,
}

/// How alike shapes are.
pub(crate) fn mac(dataset: &StoredArrays<'_>) -> Option<Panel> {
    let values = reals(dataset, "mac")?;
    dataset.shaped("mac", &[None, None])?;
    let count = *dataset.variable("mac")?.shape.first()?;
    // one shape is like itself
    if count < 2 || values.len() != count * count {
        return None;
    }
    let places: Vec<f64> = (0..count).map(|k| k as f64).collect();
    let bar = Axis::linear("MAC (−)").with_range(0.0, 1.0);
    let map =
        ValueMap { x: places.clone(), y: places, z: values.to_vec(), bar, colours: ColourMap::Sequential };
    let axis = || Axis::named("Mode", (1..=count).map(|number| number.to_string()));
    Some(Panel::new(axis(), axis(), vec![Layer::Values(map)]).with_title("shapes against each other"))
}

/// A number to four digits.
pub(crate) fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = (3 - libm::log10(value.abs()).floor().clamp(-20.0, 3.0) as i32).max(0) as usize;
    format!("{value:.digits$}").replace('-', "−")
}

/// A shape seen from one side.
struct ShapePicture {
    /// Places at rest, on the paper.
    rest: Vec<[f64; 2]>,
    /// Complex displacements, on the paper, to scale.
    moved: Vec<[Complex64; 2]>,
    /// Pairs of points; where there are none, points are drawn.
    lines: Vec<[usize; 2]>,
    in_plane: bool,
}

impl ShapePicture {
    fn new(dataset: &StoredArrays<'_>, mode: usize) -> Option<Self> {
        dataset.shaped("place", &[None, Some(3)])?;
        dataset.shaped("line", &[None, Some(2)])?;
        let (places, _) = reals(dataset, "place")?.as_chunks::<3>();
        dataset.shaped("shape", &[None, Some(places.len()), Some(3)])?;
        let own = mode * 3 * places.len()..(mode + 1) * 3 * places.len();
        // of complex modes, of which each has its phases, or not
        let is_complex = dataset.attributes().get("kind").is_some_and(|kind| kind == "eigen");
        let shape: Vec<Complex64> = match is_complex {
            true => complexes(dataset, "shape")?.get(own)?.to_vec(),
            false => reals(dataset, "shape")?.get(own)?.iter().map(|value| Complex64::from(*value)).collect(),
        };
        let height = places.first()?[2];
        let in_plane = places.iter().all(|place| place[2] == height);
        let rest: Vec<[f64; 2]> = places.iter().map(|place| on_paper(*place, in_plane)).collect();
        let largest =
            shape.chunks(3).map(|u| u.iter().map(Complex64::norm_sqr).sum::<f64>()).fold(0.0, f64::max);
        let scale = DISPLACEMENT * diagonal(&rest) / largest.sqrt();
        // points in one place, or none that moves, are no picture
        if !(scale.is_finite() && scale > 0.0) {
            return None;
        }
        let moved = shape.as_chunks::<3>().0.iter().map(|u| {
            let part = |pick: fn(&Complex64) -> f64| on_paper(u.map(|u| scale * pick(&u)), in_plane);
            let ([a, b], [c, d]) = (part(|u| u.re), part(|u| u.im));
            [Complex64::new(a, c), Complex64::new(b, d)]
        });
        let moved = moved.collect();
        let point = |end: i64| usize::try_from(end).ok().filter(|end| *end < places.len());
        let ends = wholes(dataset, "line")?.as_chunks::<2>().0.iter();
        let lines = ends.filter_map(|[from, to]| Some([point(*from)?, point(*to)?])).collect();
        Some(Self { rest, moved, lines, in_plane })
    }

    fn panel(&self, moves: Moves) -> Panel {
        // a gap after each line
        let order: Vec<Option<usize>> = if self.lines.is_empty() {
            (0..self.rest.len()).map(Some).collect()
        } else {
            self.lines.iter().flat_map(|[a, b]| [Some(*a), Some(*b), None]).collect()
        };
        let along = |axis: usize, pick: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            order.iter().map(|point| point.map_or(f64::NAN, |point| pick(point, axis))).collect()
        };
        let place = |point: usize, axis: usize| {
            self.rest.get(point).and_then(|own| own.get(axis)).copied().unwrap_or(f64::NAN)
        };
        let by = |point: usize, axis: usize| {
            self.moved.get(point).and_then(|own| own.get(axis)).copied().unwrap_or_default()
        };
        let rest = |axis| along(axis, &place);
        let drawn = |axis| along(axis, &|point, axis| place(point, axis) + by(point, axis).re);
        let swing = |axis| {
            [along(axis, &|point, axis| by(point, axis).re), along(axis, &|point, axis| by(point, axis).im)]
        };
        let swing = Swing { x: swing(0), y: swing(1) };
        let body = Role::Reference.solid();
        let shape = Role::Series(0).solid();
        let layers = if self.lines.is_empty() {
            vec![
                Layer::points("", rest(0), rest(1), Role::Reference.crowded()),
                Layer::points("", drawn(0), drawn(1), Role::Series(0).crowded()),
            ]
        } else {
            let moved = match moves {
                Moves::Swings => Layer::swinging("", drawn(0), drawn(1), swing, shape),
                Moves::Rests => Layer::line("", drawn(0), drawn(1), shape),
            };
            vec![Layer::line("", rest(0), rest(1), body), moved]
        };
        let [x, y] = self.axes();
        Panel::new(x, y, layers)
    }

    /// Axes over which lengths along both look alike.
    fn axes(&self) -> [Axis; 2] {
        let ends = |place: fn(&[f64; 2]) -> f64, by: fn(&[Complex64; 2]) -> Complex64| {
            let reach = self.rest.iter().zip(&self.moved).map(|(p, u)| (place(p), by(u).modulus()));
            reach.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (place, by)| {
                (low.min(place - by), high.max(place + by))
            })
        };
        let (across, up) = (ends(|own| own[0], |own| own[0]), ends(|own| own[1], |own| own[1]));
        let size = (1.0 + 2.0 * MARGIN) * (across.1 - across.0).max(FRAME * (up.1 - up.0));
        let range =
            |(low, high): (f64, f64), size: f64| (0.5 * (low + high - size), 0.5 * (low + high + size));
        let (x, y) = (range(across, size), range(up, size / FRAME));
        let names =
            if self.in_plane { ["Position $x$ (m)", "Position $y$ (m)"] } else { ["Across (m)", "Up (m)"] };
        [Axis::linear(names[0]).over(x.0, x.1), Axis::linear(names[1]).over(y.0, y.1)]
    }
}

/// A vector on the paper: as it is in the plane; of space an axonometry with z upwards, x to the right and y into the distance.
fn on_paper([x, y, z]: [f64; 3], in_plane: bool) -> [f64; 2] {
    /// cos and sin of the angles at which x and y are drawn: 12° down, 42° up, y shortened.
    const X: [f64; 2] = [0.978, -0.208];
    const Y: [f64; 2] = [0.446, 0.401];
    if in_plane { [x, y] } else { [X[0] * x + Y[0] * y, X[1] * x + Y[1] * y + z] }
}

fn diagonal(points: &[[f64; 2]]) -> f64 {
    let width = |pick: fn(&[f64; 2]) -> f64| {
        let values = points.iter().map(pick);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    };
    libm::hypot(width(|point| point[0]), width(|point| point[1]))
}
