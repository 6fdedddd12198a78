//! Line contacts: a cylinder on a layer, alone, in an oscillator, in an assembly.

use crate::contact::run_text;
use crate::{case, number, run_into};
use judder_contact::cylinder_on_layer::CylinderOnLayer;
use judder_contact::kernel::layer::BondedLayer;
use judder_models::oscillator::case::OscillatorCase;
use judder_study::Silent;
use judder_study::analyses::run;

/// Of a millimetre of rubber under a bar, and a law that is coarse and quick.
const BAR: &str = r#"
    [substrate]
    rubbery_modulus = "1 MPa"
    glassy_modulus = "10 MPa"
    retardation_time = "1 ms"
    poisson_ratio = 0.5
    thickness = "1 mm"
"#;

/// Pressed in, between the elastic contacts; loaded, the same law; with units, and over the whole length.
#[test]
fn a_bar_on_a_sheet_is_told_per_length_and_whole() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("contact/cylinder.toml", &[]), &["pressed", "loaded"]);
    assert!(report.complete, "{:?}", report.messages);
    let pressed = &report.summary.results["pressed"];
    let told = |key: &str| number(&pressed[key]);
    let layer = BondedLayer::new(0.4, 0.49).unwrap();
    let elastic = CylinderOnLayer::of_indentation(&layer, 0.02).unwrap().force;
    assert!(told("force") > elastic && told("force") < 10.0 * elastic, "{} {elastic}", told("force"));
    assert!(told("friction_difference") < 1e-2 && told("friction") > 0.0);
    let unit = 1e6 / (1.0 - 0.49 * 0.49) * 5e-3;
    assert!((told("force_newton_per_metre") / (told("force") * unit) - 1.0).abs() < 1e-12);
    assert!((told("force_newton") / (0.6 * told("force_newton_per_metre")) - 1.0).abs() < 1e-12);
    assert!((told("area_square_metre") / (0.6 * told("width_metre")) - 1.0).abs() < 1e-12);
    let loaded = &report.summary.results["loaded"];
    assert!((number(&loaded["force_newton_per_metre"]) / 50.0 - 1.0).abs() < 1e-4);
}

#[test]
fn a_depth_of_a_layers_thickness_and_a_contact_far_wider_than_it_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (indentation, said) in
        [("1.5 mm", "the layer is 0.1 R thick"), ("0.3 mm", "strains are of that order")]
    {
        let text = format!(
            "model = \"contact\"\n{BAR}\n[indenter]\nradius = \"10 mm\"\nshape = \"cylinder\"\n[[analysis]]\nkind = \"contact\"\n\
             velocity = 1e-2\nindentation = \"{indentation}\"\naccuracy = 2e-2\n"
        );
        let path = folder.path().join("case.toml");
        std::fs::write(&path, &text).unwrap();
        let file = judder_models::read(&path, &[]).unwrap();
        let told = match file.case.preflight(&file, &|_| true) {
            Err(error) => error.to_string(),
            Ok(_) => run_text(folder.path(), &text).messages.concat(),
        };
        assert!(told.contains(said), "{told}");
    }
}

/// On springs that bear next to nothing of the load.
fn oscillator(length: &str, load: &str) -> OscillatorCase {
    let text = format!(
        "model = \"oscillator\"\n{BAR}\n[indenter]\nradius = \"10 mm\"\nshape = \"cylinder\"\nlength = \"{length}\"\n[contact]\n\
         law = {{ computed = true, accuracy = 0.1 }}\nfriction_load = \"contact-force\"\nshear_strength = 1e-3\n\
         [oscillator]\nstiffness_x = \"1e-4 N/m\"\ncoupling = 0\n\
         [operation]\nvelocity = \"50 mm/s\"\nnormal_load = \"{load}\"\n"
    );
    judder_models::parse("case.toml", &text, &[]).unwrap().case.of::<OscillatorCase>().unwrap().clone()
}

/// Twice the length under twice the load is pressed in as far, and the same block as an assembly is, too.
#[test]
fn an_oscillator_and_an_assembly_take_the_law_per_length() {
    let [one, two] = [("0.1 m", "2 N"), ("0.2 m", "4 N")].map(|(length, load)| {
        judder_models::point::point(&oscillator(length, load)).unwrap().steady.equilibrium
    });
    assert!((two.indentation / one.indentation - 1.0).abs() < 1e-7, "{one:?} {two:?}");
    assert!((two.response.area.value / (2.0 * one.response.area.value) - 1.0).abs() < 1e-7);
    assert!((two.response.friction.value / one.response.friction.value - 1.0).abs() < 1e-7);
    let text = format!(
        r#"
        model = "assembly"
        {BAR}
        [[structure]]
        name = "bar"
        matrices = {{ mass = [[1, 0], [0, 1]], stiffness = [[1e4, 0], [0, 0]], damping = [[1, 0], [0, 1]], freedoms = [["mass", "x"], ["mass", "y"]] }}
        [[contact]]
        name = "edge"
        slider = {{ structure = "bar", set = "mass" }}
        track = {{ plane = {{ normal = [0, 1] }} }}
        sliding = {{ velocity = "50 mm/s", direction = [1, 0] }}
        asperity = {{ radius = "10 mm", shape = "cylinder", length = "0.1 m", law = {{ computed = true, accuracy = 0.1 }}, shear_strength = 1e-3, friction_load = "contact-force" }}
        [[load]]
        structure = "bar"
        set = "mass"
        direction = "y"
        force = "-2 N"
        [[analysis]]
        kind = "steady-sliding"
        "#
    );
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    file.case.preflight(&file, &|_| true).unwrap();
    let outcome = run(&file, 0, &Silent).unwrap();
    let told = serde_json::Value::Object(outcome.scalars.into_iter().collect());
    let edge = &told["contacts"]["edge"];
    let friction = number(&edge["tangential_force"][0]).abs();
    let area = one.response.area.value * 1e-4;
    // μ_visc F + τ0 A, E0* = 4/3 MPa
    let expected = 2.0 * one.response.friction.value + 1e-3 * 4e6 / 3.0 * area;
    assert!((friction / expected - 1.0).abs() < 1e-6, "{edge}: {expected}");
}
