//! Assembly cases that are refused.

use super::refused;
use judder_models::parse;
use judder_study::StudyError;

/// The block on a plane of `cases/assembly`, as a text to be spoilt.
pub(super) const BLOCK: &str = include_str!("../../../../cases/assembly/block-on-plane.toml");
/// The pad on a strip.
pub(super) const PAD: &str = include_str!("../../../../cases/assembly/pad-on-disc-strip.toml");

/// A case in which one text stands for another, which is there.
pub(super) fn spoilt(case: &str, from: &str, to: &str) -> String {
    assert!(case.contains(from), "{from}");
    case.replacen(from, to, 1)
}

/// What a case is refused for when its bodies are brought together.
pub(super) fn unassembled(text: &str) -> (String, String) {
    let file = parse("case.toml", text, &[]).expect("it reads");
    let refused = file.case.preflight(&file, &|_| true).map(drop).expect_err("it is refused");
    let place = match &refused {
        StudyError::Case(error) => error.place().to_owned(),
        _ => String::new(),
    };
    (refused.to_string(), place)
}

#[test]
fn structures_that_slide_on_themselves_or_are_called_alike() {
    refused(
        &spoilt(PAD, "track = { structure = \"strip\"", "track = { structure = \"pad\""),
        "`pad` cannot slide on itself",
        "{ structure = \"pad\", set = \"y-max\" }",
        "let one structure slide on another, or on track = { plane = { normal = [0, 1] } }",
    );
    refused(
        &spoilt(PAD, "name = \"pad\"", "name = \"strip\""),
        "two structures are called `strip`",
        "[[structure]]",
        "give each structure a `name` of its own",
    );
}

#[test]
fn springs_of_ones_own_that_cannot_be() {
    let spring = |own: &str| spoilt(BLOCK, "normal = \"rigid\"", own);
    let refusals = [
        (
            "normal = { point_table = { closure = [\"-1 mm\", \"0 mm\", \"1 mm\"], force = [\"-1 N\", \"0 N\", \"2 N\"] } }",
            "has no force at closures below zero",
        ),
        (
            "normal = { point_table = { closure = [\"0 mm\", \"1 mm\"], force = [\"1 kN\", \"2 kN\"] } }",
            "the forces of the table must be zero at 0 mm, but are 1 kN",
        ),
        (
            "normal = { point_table = { closure = [\"20 um\", \"1 mm\"], force = [\"1 N\", \"2 N\"] } }",
            "the closures of the table must have zero among them, but the first is 20 um",
        ),
        (
            "normal = { point_table = { closure = [\"0 mm\", \"1 mm\", \"20 um\"], force = [\"0 N\", \"2 N\", \"3 N\"] } }",
            "the closures of the table must ascend, but 20 um follows 1 mm",
        ),
        (
            "normal = { point_table = { closure = [\"0 mm\", \"1 mm\", \"2 mm\"], force = [\"0 N\", \"2 kN\", \"100 N\"] } }",
            "the forces of the table must ascend, but 100 N follows 2 kN",
        ),
        (
            "normal = { table = { closure = [\"0 um\", \"1 um\", \"2 um\"], pressure = [\"0 MPa\", \"2 MPa\", \"90 kPa\"] } }",
            "the pressures of the table must ascend, but 90 kPa follows 2 MPa",
        ),
        (
            "normal = { table = { closure = [\"0 um\", \"1 um\"], pressure = [\"1 kPa\", \"2 MPa\"] } }",
            "the pressures of the table must be zero at 0 um, but are 1 kPa",
        ),
        ("normal = { file = \"nothing.csv\" }", "nothing.csv"),
    ];
    for (own, said) in refusals {
        let refused = parse("case.toml", &spring(own), &[]).expect_err(own).to_string();
        assert!(refused.contains(said), "{refused}");
    }
    let pulling = "normal = { point_table = { closure = [\"-1 mm\", \"0 mm\", \"1 mm\"], force = [\"-1 N\", \"0 N\", \"2 N\"] } }\nall_closed = true";
    assert!(parse("case.toml", &spring(pulling), &[]).is_ok());
}

#[test]
fn springs_in_files_are_said_in_the_units_of_their_heads() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |content: &str| {
        std::fs::write(folder.path().join("spring.csv"), content).unwrap();
        let path = folder.path().join("case.toml");
        std::fs::write(&path, spoilt(BLOCK, "normal = \"rigid\"", "normal = { file = \"spring.csv\" }"))
            .unwrap();
        judder_models::read(&path, &[]).map(|_| ()).unwrap_err().to_string()
    };
    for (content, said) in [
        (
            "closure [mm],force [kN]\n0,0\n0.3,2\n0.2,3\n",
            "the closures of the table must ascend, but 0.2 mm follows 0.3 mm",
        ),
        (
            "closure [mm],force [kN]\n0,0\n0.3,2\n0.4,2\n",
            "the forces of the table must ascend, but 2 kN follows 2 kN",
        ),
        (
            "closure [um],force [kN]\n-3,0\n3,2\n",
            "the closures of the table must have zero among them, but the first is -3 um",
        ),
        (
            "closure [um],force [kN]\n0,0.7\n3,2\n",
            "the forces of the table must be zero at 0 um, but are 0.7 kN",
        ),
    ] {
        let message = refused(content);
        assert!(message.contains(said), "{message}");
    }
}

#[test]
fn vectors_without_a_direction() {
    refused(
        &spoilt(BLOCK, "normal = [0, 1]", "normal = [0, 0]"),
        "`contact.sole.track.plane.normal` has no direction: all its numbers are zero",
        "{ normal = [0, 0] }",
        "give a vector such as [0, 1] in the plane, [0, 0, 1] in space",
    );
}

#[test]
fn loads_with_a_direction_too_many_and_without_one() {
    let help = "forces and displacements have a direction = \"x\", \"y\" or \"z\"; a pressure acts against the surface";
    refused(
        &spoilt(BLOCK, "direction = \"y\"\n", ""),
        "a load of `displacement` needs a `direction`",
        "[[load]]",
        help,
    );
    refused(
        &spoilt(PAD, "pressure = \"1 MPa\"", "direction = \"y\"\npressure = \"1 MPa\""),
        "a load of `pressure` has no `direction`",
        "\"y\"",
        help,
    );
}

#[test]
fn laws_whose_numbers_make_none() {
    let table = "friction_coefficient = { velocity = [\"0 m/s\", \"1 m/s\"], coefficient = [0.3] }";
    refused(
        &spoilt(BLOCK, "friction_coefficient = 0.5", table),
        "the table of friction has 2 speeds and 1 coefficients",
        "[0.3]",
        "as in { velocity = [\"0 mm/s\", \"10 mm/s\"], coefficient = [0.4, 0.3] }, as many of one as of the other",
    );
}

/// The mass on a belt, whose matrices are arrays and which a spring holds.
pub(super) const MASS: &str = include_str!("../../../../cases/assembly/mass-on-belt.toml");
/// The mass on two springs.
const COUPLED: &str = include_str!("../../../../cases/assembly/mode-coupling.toml");

#[test]
fn arrays_that_are_no_square_matrices() {
    let square = "give as many rows as entries in each, as in [[\"2\", \"1 - mu\"], [1, 2]]";
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[8, 0], [0]]"),
        "`structure.block.matrices.mass` is not square: it has 2 rows, but row 2 has 1 entry",
        "[0]",
        square,
    );
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[8, 0]]"),
        "`structure.block.matrices.mass` is not square: it has 1 row, but row 1 has 2 entries",
        "[8, 0]",
        square,
    );
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[8, 0], [0, 8]]\nstiffness = [[315]]"),
        "`structure.block.matrices.stiffness` has 1 row, but the mass has 2",
        "[[315]]",
        "give 2 rows of 2 entries",
    );
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[8, 0], [0, true]]"),
        "`structure.block.matrices.mass` is a boolean, but must be a number or an expression in quotes",
        "true",
        "",
    );
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "stiffness = [[8, 0], [0, 8]]"),
        "`structure.block.matrices` lacks the key `mass`",
        "[structure.matrices]",
        "give mass = [[1, 0], [0, 1]], a row for each freedom",
    );
}

#[test]
fn masses_without_inertia_and_entries_without_a_value() {
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[8, 0], [0, -8]]"),
        "the mass matrix [[8.0, 0.0], [0.0, -8.0]] is not positive definite",
        "[[8, 0], [0, -8]]",
        "mass[0][0] and the determinant must be positive, as in [[2, 1], [1, 2]]",
    );
    let three = spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[1, 0, 1], [0, 1, 0], [1, 0, 1]]");
    refused(
        &spoilt(&three, "[[\"mass\", \"y\"],", "[[\"mass\", \"y\"], [\"mass\", \"x\"],"),
        "the mass matrix [[1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 1.0]] is singular",
        "[[1, 0, 1], [0, 1, 0], [1, 0, 1]]",
        "every motion must have inertia: the determinants of the first rows and columns, one, two and so on, must be positive",
    );
    refused(
        &spoilt(MASS, "mass = [[8, 0], [0, 8]]", "mass = [[8, 1], [0, 8]]"),
        "the mass matrix [[8.0, 1.0], [0.0, 8.0]] is not symmetric",
        "[[8, 1], [0, 8]]",
        "let mass[0][1] and mass[1][0] be equal, as in [[2, 1], [1, 2]]",
    );
    let with = |entry: &str| {
        let with = format!("mass = [[8, 0], [0, 8]]\nstiffness = [[0, {entry}], [0, 0]]");
        format!("[parameters]\nkappa = 0.0\n{}", spoilt(MASS, "mass = [[8, 0], [0, 8]]", &with))
    };
    let title = "title = \"A mass on a moving belt\"\nmodel = \"assembly\"\n";
    let first = |text: String| format!("{title}{}", text.replacen(title, "", 1));
    refused(
        &first(with("\"kapa\"")),
        "unknown symbol `kapa`",
        "kapa",
        "did you mean `kappa`? known symbols: kappa, pi; functions: sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs",
    );
    refused(
        &first(with("\"1/kappa\"")),
        "stiffness[0][1] is inf, at kappa = 0",
        "1/kappa",
        "an entry must be finite: mind division by zero, roots and logarithms of negative numbers",
    );
}

#[test]
fn freedoms_that_are_not_those_of_the_rows() {
    let freedoms = "freedoms = [[\"mass\", \"y\"], [\"mass\", \"z\"]]";
    refused(
        &spoilt(MASS, freedoms, "freedoms = [[\"mass\", \"y\"]]"),
        "`structure.block.matrices.freedoms` names 1 freedom, but the mass has 2 rows",
        "[[\"mass\", \"y\"]]",
        "name 2: one for each row, in their order, as in [[\"mass\", \"x\"], [\"mass\", \"y\"]]",
    );
    refused(
        &spoilt(MASS, freedoms, "freedoms = [[\"mass\", \"y\"], [\"mass\", \"y\"]]"),
        "`structure.block.matrices.freedoms` names node `mass` along y twice",
        "[\"mass\", \"y\"]",
        "a node has one freedom along each of x, y, z; call another node by another name",
    );
    refused(
        &spoilt(MASS, freedoms, "freedoms = [[\"mass\", \"y\"], [\"mass\"]]"),
        "an entry of `structure.block.matrices.freedoms` must be a node and a direction, and has 1 part",
        "[\"mass\"]",
        "as in [\"mass\", \"x\"]",
    );
    refused(
        &spoilt(MASS, freedoms, "freedoms = [[\"mass\", \"y\"], [\"mass\", \"up\"]]"),
        "unknown direction `up`",
        "up",
        "known: x, y, z",
    );
    refused(
        &spoilt(MASS, freedoms, &format!("{freedoms}\nplaces = {{ mas = [\"0 m\", \"1 m\"] }}")),
        "unknown node `mas`",
        "[\"0 m\", \"1 m\"]",
        "did you mean `mass`? known: mass",
    );
    refused(
        &spoilt(MASS, freedoms, &format!("{freedoms}\nplaces = {{ mass = [\"0 m\"] }}")),
        "`structure.block.matrices.places.mass` has 1 entries, but must have two or three lengths",
        "[\"0 m\"]",
        "give two or three lengths",
    );
}

#[test]
fn nodes_that_arrays_do_not_have() {
    refused(
        &spoilt(
            MASS,
            "slider = { structure = \"block\", set = \"mass\" }",
            "slider = { structure = \"block\", set = \"mas\" }",
        ),
        "unknown node `mas`",
        "\"mas\"",
        "did you mean `mass`? known: mass",
    );
    refused(
        &spoilt(
            MASS,
            "slider = { structure = \"block\", set = \"mass\" }",
            "slider = { structure = \"block\", nodes = [1] }",
        ),
        "`contact.belt.slider` of arrays names a node of `matrices.freedoms`, not a number",
        "[1]",
        "as in set = \"mass\"",
    );
}

#[test]
fn springs_that_join_nothing() {
    let direction = "direction = [0, 0, 1]\n";
    refused(
        &spoilt(MASS, direction, ""),
        "a spring to the ground has no second place that would give its direction",
        "[[spring]]",
        "give direction = [0, 1], or another vector",
    );
    refused(
        &spoilt(MASS, direction, "direction = [0, 0, 0]\n"),
        "`spring.across.direction` has no direction: all its numbers are zero",
        "[0, 0, 0]",
        "give a vector such as [0, 1] in the plane, [0, 0, 1] in space",
    );
    refused(
        &spoilt(MASS, "stiffness = \"315 N/m\"\n", ""),
        "a spring of neither stiffness nor damping does nothing",
        "[[spring]]",
        "give stiffness = \"1e6 N/m\" or damping = \"10 N s/m\"",
    );
    refused(
        &spoilt(MASS, "stiffness = \"315 N/m\"", "stiffness = \"-315 N/m\""),
        "`spring.across.stiffness` must be zero or positive, but is -315 N/m",
        "\"-315 N/m\"",
        "",
    );
    refused(
        &spoilt(MASS, "to = \"ground\"", "to = \"floor\""),
        "unknown end of a spring `floor`",
        "floor",
        "known: ground",
    );
    refused(
        &spoilt(COUPLED, "name = \"stiff\"", "name = \"soft\""),
        "two springs are called `soft`",
        "[[spring]]",
        "give each spring a `name` of its own",
    );
    let second = "[[structure]]\nname = \"other\"\n[structure.matrices]\nmass = [[1]]\nfreedoms = [[\"end\", \"z\"]]\n\n[[spring]]";
    let joined = spoilt(MASS, "[[spring]]", second);
    let joined = spoilt(&joined, "to = \"ground\"", "to = { structure = \"other\", set = \"end\" }");
    let (message, place) = unassembled(&spoilt(&joined, direction, ""));
    assert_eq!(
        message,
        "both ends of the spring lie at one place: there is no line along which it would act"
    );
    assert_eq!(place, "[[spring]]");
    let (message, _) = unassembled(&spoilt(MASS, direction, "direction = [1, 0]\n"));
    assert_eq!(message, "neither end of the spring can move along it: supports hold both");
}

#[test]
fn steady_sliding_of_bodies_that_touch_nowhere() {
    let start = MASS.find("[[contact]]").unwrap();
    let end = MASS.find("[[load]]").unwrap();
    let (message, place) = unassembled(&format!("{}{}", &MASS[..start], &MASS[end..]));
    assert_eq!(message, "nothing touches: the case has no `[[contact]]`, so nothing slides");
    assert_eq!(place, "[[analysis]]");
}

#[test]
fn ties_that_bond_nothing_or_twice() {
    let tie = |to: &str| {
        format!(
            "[[tie]]\nname = \"bond\"\nfrom = {{ structure = \"pad\", set = \"y-max\" }}\nto = {{ structure = \"{to}\", set = \"y-min\" }}\n\n[[contact]]"
        )
    };
    refused(
        &spoilt(PAD, "[[contact]]", &tie("pad")),
        "`pad` cannot be tied to itself",
        "{ structure = \"pad\", set = \"y-min\" }",
        "let one structure be tied to another",
    );
    let (message, place) = unassembled(&spoilt(PAD, "[[contact]]", &tie("strip")));
    assert!(message.starts_with("no node of `pad.y-max` lies opposite `strip.y-min`"), "{message}");
    assert_eq!(place, "{ structure = \"strip\", set = \"y-min\" }");
}

#[test]
fn maps_of_one_key_and_maps_without_end() {
    let map = |x: &str, points: usize| {
        let axis = |key: &str| {
            format!("{{ key = \"contact.sole.{key}\", from = 0.1, to = 0.6, points = {points} }}")
        };
        let y = axis("friction_coefficient");
        let text = format!(
            "{BLOCK}\n[[analysis]]\nname = \"map\"\nkind = \"stability-map\"\nx = {}\ny = {y}\nband = [\"1 kHz\", \"9 kHz\"]\n",
            axis(x)
        );
        parse("case.toml", &text, &[]).expect_err("it is refused").to_string()
    };
    let one = map("friction_coefficient", 3);
    assert!(one.contains("`x` and `y` both vary `contact.sole.friction_coefficient`"), "{one}");
    let many = map("normal.stiffness", 100_000);
    assert!(many.contains("10000000000 points, and 1000000 are allowed"), "{many}");
}

/// A rigid contact holds each of its points, a body that touches nowhere has none.
#[test]
fn interface_modes_where_there_is_no_compliant_contact() {
    let (message, place) = unassembled(&spoilt(
        BLOCK,
        "[[contact]]",
        "reduction = { count = 10, interface_modes = 4 }\n\n[[contact]]",
    ));
    assert!(
        message.contains("`block` touches at the rigid contact `sole`, which holds each of its points"),
        "{message}"
    );
    assert_eq!(place, "4");
    let alone = "\n[[structure]]\nname = \"alone\"\nreduction = { count = 1, interface_modes = 1 }\n\
        matrices = { mass = [[1]], stiffness = [[1]], freedoms = [[\"a\", \"x\"]] }\n";
    let (message, _) = unassembled(&format!("{BLOCK}{alone}"));
    assert!(message.contains("`alone` touches nowhere"), "{message}");
}
